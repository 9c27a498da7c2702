//! The maps of a comparison, and the best there is on each.

use std::sync::{Arc, OnceLock};

use serde::Serialize;

use super::measure::RunMeasure;
use super::question::Question;
use super::run::build;
use crate::error::QuestionError;
use crate::exact::{self, Reference};
use crate::planner::Objective;
use crate::scenario::Scenario;

/// The map of an instance.
#[derive(Debug)]
pub struct Map {
    /// Map, start, goal, movement.
    pub scenario: Arc<Scenario>,
    /// For each entry of the question what counts for it here; none where nothing can be run.
    objectives: Vec<Option<Objective>>,
    /// The best there is, by each objective of an entry: searched for when first asked for, because it can take long.
    references: OnceLock<Vec<Yardstick>>,
    /// What counts where nobody says otherwise: by steps, by slices, or of a tour.
    own: Objective,
    /// The best there is by that.
    own_reference: OnceLock<Reference>,
}

/// What results are measured by, and the best that there is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Yardstick {
    /// What counts.
    pub objective: Objective,
    /// The measure that its value belongs to: two objectives can share one, over different paths.
    pub measure: RunMeasure,
    /// Its best value, in cells.
    pub reference: Reference,
}

impl Map {
    pub(super) fn new(scenario: Arc<Scenario>, question: &Question) -> Result<Self, QuestionError> {
        let by_map = match scenario.by_slices() {
            Some(_) => Objective::SliceCost,
            None if scenario.goals.len() > 1 => Objective::TourLength,
            None => Objective::Length,
        };
        let objective = |entry| match build(&scenario, entry, 0)? {
            Some(planner) => Ok(Some(planner.objective())),
            None => Ok(entry.results.as_ref().map(|_| by_map)),
        };
        let objectives = question.entries.iter().map(objective).collect::<Result<_, _>>()?;
        Ok(Self { scenario, objectives, references: OnceLock::new(), own: by_map, own_reference: OnceLock::new() })
    }

    /// Whether the same is asked on both: equal cells, heights, factors, ends and rules.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.scenario.spec == other.scenario.spec && self.scenario.drawn == other.scenario.drawn
    }

    /// What paths on it are compared by: by slices and on weighted ground their cost, elsewhere their length.
    pub fn measure(&self) -> RunMeasure {
        self.measure_of(self.own)
    }

    /// The measure that the value of an objective belongs to here.
    pub fn measure_of(&self, objective: Objective) -> RunMeasure {
        RunMeasure::of(objective, self.scenario.moves.weights().is_some())
    }

    /// What counts for an entry here.
    pub fn objective(&self, entry: usize) -> Option<Objective> {
        self.objectives.get(entry).copied().flatten()
    }

    /// The best there is, by each objective of an entry, in the order of the entries.
    pub fn yardsticks(&self) -> &[Yardstick] {
        self.references.get_or_init(|| {
            let mut all: Vec<Yardstick> = Vec::new();
            for objective in self.objectives.iter().flatten().copied() {
                if all.iter().all(|y| y.objective != objective) {
                    let reference = exact::reference(&self.scenario, objective);
                    all.push(Yardstick { objective, measure: self.measure_of(objective), reference });
                }
            }
            all
        })
    }

    /// The best path by steps, by slices, or of a tour, as the map is, whatever the entries make small.
    pub fn own_reference(&self) -> Reference {
        *self.own_reference.get_or_init(|| {
            let yardstick = self.yardsticks().iter().find(|y| y.objective == self.own);
            yardstick.map_or_else(|| exact::reference(&self.scenario, self.own), |y| y.reference)
        })
    }

    /// What an entry is to achieve here.
    pub fn reference(&self, entry: usize) -> Reference {
        let objective = self.objective(entry);
        let yardstick = self.yardsticks().iter().find(|y| Some(y.objective) == objective);
        yardstick.map_or(Reference::Unknown, |y| y.reference)
    }
}
