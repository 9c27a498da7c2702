//! What a colony works with: trails, weights, ants.

use crate::aco::ant::Ant;
use crate::aco::on_demand::OnDemand;
use crate::aco::trails::Trails;
use crate::aco::variant::{Settings, Variant};
use crate::aco::weights::WeightTable;
use crate::planner::held;
use crate::rng::Streams;
use crate::scenario::Scenario;

/// What a colony needs while it works; allocated at its first step, so that a colony that is only shown costs nothing.
#[derive(Clone)]
pub(super) struct Tables {
    pub(super) trails: Trails,
    /// The weights of every step; empty with [`Variant::TIMED`].
    pub(super) weights: WeightTable,
    /// The same where η changes with time; empty without [`Variant::TIMED`].
    pub(super) on_demand: OnDemand,
    pub(super) ants: Vec<Ant>,
}

/// What becomes of the weights that a walk has worked out.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// They are kept until the trails change: between iterations.
    Kept,
    /// Nothing: in lock step nearly every row has changed when it is read again.
    Passing,
    /// They are kept until time changes η.
    Timed,
}

impl Kind {
    pub(super) fn of<V: Variant>() -> Self {
        match (V::TIMED, V::LOCK_STEP) {
            (true, _) => Self::Timed,
            (false, true) => Self::Passing,
            (false, false) => Self::Kept,
        }
    }
}

impl Tables {
    #[inline(never)]
    pub(super) fn new(scenario: &Scenario, settings: &Settings, trails: Trails, kind: Kind, streams: Streams) -> Self {
        let (cells, alpha, beta) = (scenario.grid.len(), settings.alpha, settings.beta);
        let (width, height) = (scenario.grid.width(), scenario.grid.height());
        let ant = |k| Ant::new(width, height, streams.ant(0, k));
        Self {
            trails,
            weights: match kind {
                Kind::Kept => WeightTable::new(cells, alpha),
                Kind::Passing => WeightTable::passing(cells, alpha),
                Kind::Timed => WeightTable::new(0, alpha),
            },
            on_demand: OnDemand::new(if kind == Kind::Timed { cells } else { 0 }, alpha, beta),
            ants: (0..settings.ants).map(ant).collect(),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        let ants = held(&self.ants) + self.ants.iter().map(Ant::bytes).sum::<usize>();
        self.trails.bytes() + self.weights.bytes() + self.on_demand.bytes() + ants
    }

    /// Has the weights follow the trails before an iteration, and η where that has changed.
    #[inline(always)]
    pub(super) fn take_in(&mut self, kind: Kind, heuristic_changes: bool) {
        let Self { trails, weights, on_demand, .. } = self;
        match (kind, heuristic_changes) {
            (Kind::Timed, true) => on_demand.another_time(),
            (_, true) => {
                weights.forget_all();
                trails.all_changed();
            }
            (_, false) => {}
        }
        match kind {
            Kind::Kept => weights.refresh(trails),
            Kind::Passing => {}
            Kind::Timed => on_demand.outdate(trails),
        }
    }

    /// Every ant at the start, with its stream of an iteration.
    #[inline(never)]
    pub(super) fn place_ants(&mut self, scenario: &Scenario, streams: Streams, iteration: u32) {
        for (k, ant) in self.ants.iter_mut().enumerate() {
            ant.begin(scenario.grid.width(), scenario.start, streams.ant(iteration, k as u32));
        }
    }
}
