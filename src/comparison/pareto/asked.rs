//! What is asked of fronts: over which measures, and against which reference.

use serde::{Deserialize, Serialize};

use crate::comparison::measure::RunMeasure;
use crate::comparison::{Comparison, Map};
use crate::error::QuestionError;

/// Over which measures runs are compared, and with which reference point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FrontQuestion {
    /// Two or three different ones, each of [`FrontQuestion::MEASURES`].
    pub measures: Vec<RunMeasure>,
    /// For each measure a value in its unit, worse than what is to count. Absent: the worst value over all points of the map, and a tenth of
    /// the way from the best to the worst more.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number[] | null"))]
    pub reference: Option<Vec<f64>>,
}

impl Default for FrontQuestion {
    /// Length against turns.
    fn default() -> Self {
        Self { measures: vec![RunMeasure::Length, RunMeasure::Turns], reference: None }
    }
}

impl FrontQuestion {
    /// The measures that a single run has a value of, by which one may be better than another.
    pub const MEASURES: [RunMeasure; 10] = [
        RunMeasure::Length,
        RunMeasure::Cost,
        RunMeasure::Turns,
        RunMeasure::TurnIndex,
        RunMeasure::MinClearance,
        RunMeasure::MeanClearance,
        RunMeasure::Weight,
        RunMeasure::IterationOfBest,
        RunMeasure::PathsToBest,
        RunMeasure::AntMoves,
    ];

    /// Those of [`FrontQuestion::MEASURES`] that runs of a comparison can differ by: a cost only where an entry makes one small, a weight only
    /// of tours by several goals.
    pub fn measures_of(comparison: &Comparison) -> Vec<RunMeasure> {
        let entries = 0..comparison.question.entries.len();
        let minimised = |measure| {
            let by = |map: &Map| entries.clone().any(|e| map.objective(e).is_some_and(|o| map.measure_of(o) == measure));
            comparison.maps.iter().any(by)
        };
        let has_tours = comparison.maps.iter().any(|map| map.scenario.goals.len() > 1);
        let is_known = |measure: &RunMeasure| match measure {
            RunMeasure::Cost => minimised(RunMeasure::Cost),
            RunMeasure::Weight => has_tours,
            _ => true,
        };
        Self::MEASURES.into_iter().filter(is_known).collect()
    }

    /// Whether it can be asked.
    ///
    /// # Errors
    /// [`QuestionError`] for fewer than two or more than three measures, one twice, one that no run has, or a reference of another size.
    pub fn check(&self) -> Result<(), QuestionError> {
        let all = &self.measures;
        if !(2..=3).contains(&all.len()) {
            return Err(QuestionError::field("measures", all.len(), "two or three measures"));
        }
        let ids = || Self::MEASURES.map(RunMeasure::id).join(", ");
        if let Some(other) = all.iter().find(|measure| !Self::MEASURES.contains(measure)) {
            return Err(QuestionError::field("measures", other.id(), format!("of {}", ids())));
        }
        if let Some(twice) = (1..all.len()).find(|&i| all[..i].contains(&all[i])) {
            return Err(QuestionError::field("measures", all[twice].id(), "named once"));
        }
        let fits = |point: &Vec<f64>| point.len() == all.len() && point.iter().all(|value| value.is_finite());
        match self.reference.as_ref().filter(|point| !fits(point)) {
            Some(point) => {
                let said: Vec<String> = point.iter().map(f64::to_string).collect();
                Err(QuestionError::field("reference", said.join(","), format!("{} finite numbers, one a measure", all.len())))
            }
            None => Ok(()),
        }
    }
}
