//! The search inside a part of the map that merges and proves: by steps, or by polylines.

use std::sync::Arc;

use crate::aco::criterion::Judge;
use crate::exact::{PolylinesWithin, Within};
use crate::map::Cell;
use crate::path::Path;
use crate::scenario::Scenario;

use super::params::Paths;

/// One of the searches; what each method means, theirs tell.
#[derive(Clone)]
pub(super) enum Inside {
    Steps(Box<Within>),
    Polylines(Box<PolylinesWithin>),
}

/// The same question to whichever search it is.
macro_rules! ask {
    ($inside:expr, $search:ident => $question:expr) => {
        match $inside {
            Self::Steps($search) => $question,
            Self::Polylines($search) => $question,
        }
    };
}

impl Inside {
    pub(super) fn new(scenario: &Arc<Scenario>, paths: Paths, criterion: Judge) -> Self {
        let by_steps = |search| Self::Steps(Box::new(search));
        match (paths, criterion) {
            (Paths::Polylines, _) => Self::Polylines(Box::new(PolylinesWithin::new(scenario))),
            (Paths::Steps, Judge::Length) => by_steps(Within::new(scenario)),
            (Paths::Steps, Judge::TurnIndex) => by_steps(Within::by_turn_index(scenario)),
            (Paths::Steps, Judge::Weighted(sum)) => by_steps(Within::by_sum(scenario, sum)),
        }
    }

    pub(super) fn widen(&mut self, cell: Cell, radius: u8) {
        ask!(self, search => search.widen(cell, radius));
    }

    pub(super) fn widen_to_all(&mut self) {
        ask!(self, search => search.widen_to_all());
    }

    pub(super) fn bound_by(&mut self, length: f64) {
        ask!(self, search => search.bound_by(length));
    }

    pub(super) fn go_on(&mut self, most: u64) -> bool {
        ask!(self, search => search.go_on(most))
    }

    pub(super) fn best(&self) -> Option<(Path, f64)> {
        ask!(self, search => search.best())
    }

    pub(super) fn lower_bound(&self) -> f64 {
        ask!(self, search => search.lower_bound())
    }

    pub(super) fn is_proven(&self) -> bool {
        ask!(self, search => search.is_proven())
    }

    pub(super) fn expansions(&self) -> u64 {
        ask!(self, search => search.expansions())
    }

    pub(super) fn part(&self) -> &[bool] {
        ask!(self, search => search.part())
    }

    pub(super) fn bytes(&self) -> usize {
        ask!(self, search => size_of_val(&**search) + search.bytes())
    }
}
