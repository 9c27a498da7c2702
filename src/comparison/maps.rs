//! The maps of a comparison, and the best there is on each.

use std::sync::{Arc, OnceLock};

use serde::Serialize;

use super::measure::RunMeasure;
use super::question::Question;
use super::run::build;
use crate::error::QuestionError;
use crate::exact::{self, Reference};
use crate::metrics::WeightedSum;
use crate::planner::{Objective, Planner};
use crate::scenario::Scenario;

/// The map of an instance.
#[derive(Debug)]
pub struct Map {
    /// Map, start, goal, movement.
    pub scenario: Arc<Scenario>,
    /// For each entry of the question what counts for it here; none where nothing can be run.
    aims: Vec<Option<Aim>>,
    /// The best there is, by each objective of an entry: searched for when first asked for, because it can take long.
    references: OnceLock<Vec<Yardstick>>,
    /// What counts where nobody says otherwise: by steps, by slices, or of a tour.
    own: Objective,
    /// The best there is by that.
    own_reference: OnceLock<Reference>,
}

/// What counts for an entry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Aim {
    pub objective: Objective,
    /// The weights, where that is the weighted sum.
    pub sum: Option<WeightedSum>,
}

/// What results are measured by, and the best that there is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Yardstick {
    /// What counts.
    pub objective: Objective,
    /// The measure that its value belongs to: two objectives can share one, over different paths.
    pub measure: RunMeasure,
    /// The weights, where what counts is the weighted sum: two entries may weigh differently.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sum: Option<WeightedSum>,
    /// Its best value, in cells.
    pub reference: Reference,
}

impl Aim {
    fn of(planner: &dyn Planner) -> Self {
        Self { objective: planner.objective(), sum: planner.weighed().map(|weighed| weighed.sum) }
    }
}

impl Yardstick {
    pub(super) fn is_of(&self, aim: Aim) -> bool {
        (self.objective, self.sum) == (aim.objective, aim.sum)
    }
}

impl Map {
    pub(super) fn new(scenario: Arc<Scenario>, question: &Question) -> Result<Self, QuestionError> {
        let by_map = match scenario.by_slices() {
            Some(_) => Objective::SliceCost,
            None if scenario.goals.len() > 1 => Objective::TourLength,
            None => Objective::Length,
        };
        let aim = |entry| match build(&scenario, entry, 0)? {
            Some(planner) => Ok(Some(Aim::of(&*planner))),
            None => Ok(entry.results.as_ref().map(|_| Aim { objective: by_map, sum: None })),
        };
        let aims = question.entries.iter().map(aim).collect::<Result<_, _>>()?;
        Ok(Self { scenario, aims, references: OnceLock::new(), own: by_map, own_reference: OnceLock::new() })
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
        self.aim(entry).map(|aim| aim.objective)
    }

    /// The same with the weights of a weighted sum.
    pub(super) fn aim(&self, entry: usize) -> Option<Aim> {
        self.aims.get(entry).copied().flatten()
    }

    /// The best there is, by each objective of an entry, in the order of the entries.
    pub fn yardsticks(&self) -> &[Yardstick] {
        self.references.get_or_init(|| {
            let mut all: Vec<Yardstick> = Vec::new();
            for aim in self.aims.iter().flatten().copied() {
                if all.iter().all(|y| !y.is_of(aim)) {
                    let Aim { objective, sum } = aim;
                    let reference = exact::reference_of(&self.scenario, objective, sum);
                    all.push(Yardstick { objective, measure: self.measure_of(objective), sum, reference });
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
        let aim = self.aim(entry);
        let yardstick = self.yardsticks().iter().find(|y| aim.is_some_and(|aim| y.is_of(aim)));
        yardstick.map_or(Reference::Unknown, |y| y.reference)
    }
}
