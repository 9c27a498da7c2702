//! A colony by slices as it is shown: the moves of an ant with their probabilities, an ant's turn, and fields over the map.

use super::colony::{Rules, SliceColony};
use super::tables::{Tables, deltas, first_trails, seen, slot, weigh};
use super::trails::RowTrails;
use crate::aco::odds;
use crate::aco::terrain::walk::Walker;
use crate::map::{Cell, Way};
use crate::planner::{Layer, MoveOdds, Turn, stand_ready};

impl<R: Rules> SliceColony<R> {
    /// [`Planner::moves_from`](crate::planner::Planner::moves_from).
    pub(super) fn odds_at(&self, place: Cell) -> Vec<MoveOdds> {
        if place as usize >= self.slices.places() || place == self.slices.goal() || !self.slices.is_free(place) {
            return Vec::new();
        }
        let mut ant = Walker::new(self.slices.places(), self.stream());
        ant.begin(place, self.stream());
        self.odds_of(&ant)
    }

    /// [`Planner::turn_of`](crate::planner::Planner::turn_of), taken: the ants before it move, then this one.
    pub(super) fn take_turn(mut self, number: usize) -> Option<Turn> {
        if stand_ready(&mut self).is_finished() {
            return None;
        }
        self.move_ants(0..number);
        let ant = &self.tables.as_ref()?.ants[number];
        let walked = ant.walked();
        if !ant.is_walking() {
            return Some(Turn::over(walked));
        }
        let (from, odds) = (ant.place(), self.odds_of(ant));
        self.move_ants(number..number + 1);
        let to = self.tables.as_ref()?.ants[number].place();
        Some(Turn { walked, odds, next: (to != from).then_some(to) })
    }

    fn odds_of(&self, ant: &Walker) -> Vec<MoveOdds> {
        let first;
        let trails = match &self.tables {
            Some(tables) => &tables.trails,
            None => {
                first = first_trails(&self.rules, &self.slices);
                &first
            }
        };
        let (slices, from, selection) = (&*self.slices, ant.place(), &self.numbers.selection);
        let mut weights = vec![0.0; slices.directions()];
        let seen = seen(&self.rules, selection.beta, slices, from);
        weigh::<R>(ant, &seen, &deltas(slices), trails, selection.alpha, &mut weights);
        let odds = odds::pseudo_random_proportional(&weights, self.numbers.q0);
        let step = |k: usize| {
            let to = slices.step(from, k, Way::Forward)?;
            let (place, step) = slot::<R>(from, k, to);
            Some(MoveOdds {
                colony: 0,
                to,
                trail: f64::from(trails.get(place, step)),
                heuristic: self.rules.eta(slices, from, to),
                weight: f64::from(weights[k]),
                probability: odds[k],
            })
        };
        (0..slices.directions()).filter_map(step).collect()
    }

    /// Writes a layer; false when there is no such layer.
    pub(super) fn show(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        out.resize(self.slices.area() as usize, 0.0);
        match (kind, &self.tables) {
            (Layer::Heuristic, _) => self.mean_heuristic(out),
            (Layer::Trail, Some(tables)) => self.strongest(&tables.trails, out),
            (Layer::Visits, Some(Tables { ants, .. })) => {
                let visited = ants.iter().flat_map(Walker::list);
                visited.for_each(|&place| out[self.slices.cell(place) as usize] += 1.0);
            }
            (Layer::Trail | Layer::Visits, None) => {}
            _ => return self.rules.show(&self.slices, kind, out),
        }
        true
    }

    /// Of each cell the strongest trail of its places, or of the steps that leave them.
    fn strongest(&self, trails: &RowTrails, out: &mut [f32]) {
        for place in 0..self.slices.places() as Cell {
            let most = &mut out[self.slices.cell(place) as usize];
            *most = most.max(trails.strongest(place));
        }
    }

    /// Mean η of the steps that lead into each cell, over all of its places.
    fn mean_heuristic(&self, out: &mut [f32]) {
        let slices = &*self.slices;
        let mut ways = vec![0.0f32; out.len()];
        for from in (0..slices.places() as Cell).filter(|&from| slices.is_free(from)) {
            for to in (0..slices.directions()).filter_map(|k| slices.step(from, k, Way::Forward)) {
                let cell = slices.cell(to) as usize;
                out[cell] += self.rules.eta(slices, from, to) as f32;
                ways[cell] += 1.0;
            }
        }
        out.iter_mut().zip(ways).for_each(|(sum, n)| *sum /= n.max(1.0));
    }
}
