//! What an ant weighs at a cell, and the next move of one ant, as the page shows them: by the walk's own weights and rule.

use super::tables::Tables;
use super::{Colony, walked};
use crate::aco::on_demand;
use crate::aco::selection::without;
use crate::aco::trails::Trails;
use crate::aco::variant::{Standing, Variant};
use crate::aco::weights::weigh;
use crate::planner::{Fate, MoveOdds, Turn, stand_ready};

impl<V: Variant + 'static> Colony<V> {
    /// The variant as the ants of the iteration at work have it or, between two, those of the next; of the last once the budget is spent.
    pub(super) fn variant_now(&self) -> V {
        let mut variant = self.variant.clone();
        if self.tables.is_none() {
            variant.prepare(&self.scenario);
        }
        if !self.constructing {
            variant.begin_iteration((self.progress.effort.iterations + 1).min(self.settings.iterations));
        }
        variant
    }

    /// [`Planner::moves_from`] for an ant on the map, without the steps whose bit is set; the weights and the rule are those of the walk.
    pub(super) fn odds_at(&self, variant: &V, trails: &Trails, ant: Standing, visited: u8) -> Vec<MoveOdds> {
        let cell = ant.at;
        let (scenario, settings) = (&*self.scenario, &self.settings);
        let eta = |d, to| variant.heuristic(scenario, cell, d, to);
        let seen = if V::TIMED {
            on_demand::visibility(scenario, variant, settings.beta, cell)
        } else {
            super::sight(scenario, variant, settings.beta, &|_, d, to| eta(d, to)).row(cell)
        };
        let mut weights = without(&weigh(&trails.relative(cell), settings.alpha, &seen), visited);
        if V::HEEDS {
            variant.heed(scenario, &mut weights, ant);
        }
        let odds = variant.odds(&weights);
        let step = |d| {
            let (to, trail) = (scenario.moves.step(cell, d), trails.get(cell, d));
            let (weight, probability) = (f64::from(weights[d as usize]), odds[d as usize]);
            MoveOdds { colony: 0, to, trail, heuristic: eta(d, to), weight, probability }
        };
        scenario.moves.directions(cell).map(step).collect()
    }

    /// [`Planner::turn_of`], taken: the ants before it move, then this one.
    pub(super) fn take_turn(mut self, number: usize) -> Option<Turn> {
        if stand_ready(&mut self).is_finished() {
            return None;
        }
        self.move_ants(0..number);
        let Tables { trails, ants, .. } = self.tables.as_ref()?;
        let (ant, from) = (&ants[number], ants[number].cell());
        let walked = walked(&self.scenario, ant);
        if ant.fate() != Fate::Walking {
            return Some(Turn::over(walked));
        }
        let odds = self.odds_at(&self.variant, trails, Standing::of(ant), ant.visited());
        self.move_ants(number..number + 1);
        let to = self.tables.as_ref()?.ants[number].cell();
        Some(Turn { walked, odds, next: (to != from).then_some(to) })
    }
}
