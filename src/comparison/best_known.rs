//! Best known values, and claims to have a better one. Nothing is believed: a run is repeated, a path is walked.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::gap::{is_below, relative_gap};
use crate::catalog;
use crate::error::BestKnownError;
use crate::exact::Reference;
use crate::map::{Cell, Measure, Point};
use crate::metrics::Metrics;
use crate::params::Values;
use crate::path::{Flaw, PathKind, audit, audit_slices};
use crate::planner::{Granularity, Objective, Planner, Status};
use crate::scenario::Scenario;

/// Most iterations of a run that is repeated for somebody else.
pub const MOST_ITERATIONS: u32 = 100_000;

/// What decides a run on a scenario.
#[derive(Debug, Clone, Copy)]
pub struct Recipe<'a> {
    /// The planner's id in the catalog.
    pub planner: &'a str,
    /// All values that differ from its defaults.
    pub params: &'a Values,
    /// The seed.
    pub seed: u32,
}

/// What a run had come to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecordedRun {
    /// Iterations that were finished.
    pub iterations: u32,
    /// Whether and how it had ended.
    pub status: Status,
    /// Length of the best path in cells; none without a path.
    pub length: Option<f64>,
    /// 16 hexadecimal digits.
    pub digest: String,
}

/// A value by the objective that measures it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// What is measured.
    pub objective: Objective,
    /// In cells; less is better.
    pub value: f64,
}

/// How a value stands beside the best one known so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Standing {
    /// None was known.
    First,
    /// It is better, by this part of the value known.
    Better(f64),
    /// It is the same within a rounding.
    Equal,
    /// It is worse, by this part of the value known.
    Worse(f64),
}

impl Standing {
    /// Of a value beside what is known.
    ///
    /// ```
    /// use formicarium::comparison::best_known::Standing;
    ///
    /// assert_eq!(Standing::of(30.0, Some(40.0)), Standing::Better(0.25));
    /// assert_eq!(Standing::of(40.0 + 1e-12, Some(40.0)), Standing::Equal);
    /// ```
    pub fn of(value: f64, known: Option<f64>) -> Self {
        match known.map(|known| relative_gap(value, known)) {
            None => Self::First,
            Some(0.0) => Self::Equal,
            Some(gap) if gap < 0.0 => Self::Better(-gap),
            Some(gap) => Self::Worse(gap),
        }
    }

    /// Whether the value takes the place of what is known.
    pub fn wins(self) -> bool {
        matches!(self, Self::First | Self::Better(_))
    }
}

/// Does a run up to the end of an iteration, or to its own end, and tells what it has come to.
///
/// # Errors
/// [`BestKnownError::Planner`] where the catalog refuses the recipe.
pub fn run(
    scenario: &Arc<Scenario>,
    recipe: Recipe<'_>,
    iterations: Option<u32>,
) -> Result<(RecordedRun, Option<Measured>), BestKnownError> {
    Ok(outcome(scenario, advanced(scenario, recipe, iterations)?.as_ref()))
}

fn outcome(scenario: &Scenario, planner: &dyn Planner) -> (RecordedRun, Option<Measured>) {
    let metrics = planner.best().map(|best| Metrics::of(scenario, best.result().0));
    let value = metrics.as_ref().and_then(|metrics| planner.value(metrics));
    let recorded = RecordedRun {
        iterations: planner.effort().iterations,
        status: planner.status(),
        length: metrics.map(|metrics| metrics.length),
        digest: planner.digest().hex(),
    };
    (recorded, value.map(|value| Measured { objective: planner.objective(), value }))
}

/// The shortest run that has the value of the whole one: as far as the iteration that found it.
///
/// # Errors
/// As [`run`].
pub fn shortest_run(scenario: &Arc<Scenario>, recipe: Recipe<'_>) -> Result<(RecordedRun, Option<Measured>), BestKnownError> {
    let planner = advanced(scenario, recipe, None)?;
    let whole = outcome(scenario, planner.as_ref());
    // A search that has ended says so; a colony's iterations after the best one add nothing.
    let found = planner.budget().and(planner.best()).map(|best| best.iteration);
    let Some(found) = found.filter(|&found| found > 0) else { return Ok(whole) };
    let short = run(scenario, recipe, Some(found))?;
    Ok(if short.1 == whole.1 { short } else { whole })
}

fn advanced(
    scenario: &Arc<Scenario>,
    Recipe { planner, params, seed }: Recipe<'_>,
    iterations: Option<u32>,
) -> Result<Box<dyn Planner>, BestKnownError> {
    let mut planner = catalog::build(scenario, planner, None, params, seed)?;
    let is_enough = |planner: &dyn Planner| iterations.is_some_and(|most| planner.effort().iterations >= most);
    while !is_enough(planner.as_ref()) && !planner.advance(Granularity::Iteration).is_finished() {}
    Ok(planner)
}

/// Repeats a run and compares all that was recorded of it.
///
/// # Errors
/// [`BestKnownError`] names the first number that is not what came out; the digest is compared first.
pub fn repeat(scenario: &Arc<Scenario>, recipe: Recipe<'_>, recorded: &RecordedRun) -> Result<Measured, BestKnownError> {
    if recorded.iterations > MOST_ITERATIONS {
        return Err(BestKnownError::TooLong { iterations: recorded.iterations, most: MOST_ITERATIONS });
    }
    let (now, measured) = run(scenario, recipe, Some(recorded.iterations))?;
    if now.digest != recorded.digest {
        return Err(BestKnownError::Digest { recorded: recorded.digest.clone(), now: now.digest });
    }
    same("iterations", &recorded.iterations, &now.iterations)?;
    same("status", &recorded.status, &now.status)?;
    same("length", &recorded.length, &now.length)?;
    measured.ok_or(BestKnownError::NoPath)
}

/// Refuses a recorded number that is not the one that came out.
///
/// # Errors
/// [`BestKnownError::Number`].
pub fn same<T: PartialEq + std::fmt::Debug>(field: &'static str, recorded: &T, now: &T) -> Result<(), BestKnownError> {
    if recorded == now {
        return Ok(());
    }
    Err(BestKnownError::Number { field, recorded: format!("{recorded:?}"), now: format!("{now:?}") })
}

/// A path that a planner from elsewhere has found.
#[derive(Debug, Clone, PartialEq)]
pub struct ClaimedPath {
    /// How its places follow each other.
    pub kind: PathKind,
    /// Its places from start to goal; by slices each with its level.
    pub places: Vec<(Point, Option<u32>)>,
}

impl ClaimedPath {
    /// What measures it where nothing else is asked for.
    pub fn usual_objective(&self, scenario: &Scenario) -> Objective {
        *objectives(scenario, self.kind).first().unwrap_or(&Objective::Length)
    }

    /// Walks the path and measures it.
    ///
    /// # Errors
    /// [`BestKnownError::Flaw`] with the first thing that is wrong; [`BestKnownError::Objective`] where it cannot be measured so.
    pub fn measure(&self, scenario: &Scenario, objective: Objective) -> Result<Measured, BestKnownError> {
        let allowed = objectives(scenario, self.kind);
        if !allowed.contains(&objective) {
            let allowed = allowed.iter().map(|one| one.id()).collect::<Vec<_>>().join(" or ");
            return Err(BestKnownError::Objective { objective: objective.id().into(), allowed });
        }
        let path = self.walk(scenario).map_err(|flaw| BestKnownError::Flaw { flaw: flaw.to_string() })?;
        let metrics = Metrics::of(scenario, &path);
        let by_slices = metrics.terrain.and_then(|terrain| terrain.level_cost);
        let value = match objective {
            Objective::SliceCost if scenario.by_slices().is_some_and(|slices| slices.rules().measure == Measure::Cost) => {
                by_slices
            }
            Objective::SliceCost => Some(metrics.length),
            _ => objective.of_steps(&metrics),
        };
        value.map(|value| Measured { objective, value }).ok_or(BestKnownError::NoPath)
    }

    /// The path as cells, by slices as places, if it is one.
    fn walk(&self, scenario: &Scenario) -> Result<Vec<Cell>, Flaw> {
        let points: Vec<Point> = self.places.iter().map(|&(at, _)| at).collect();
        let Some(slices) = scenario.by_slices() else {
            audit(scenario, &points, self.kind)?;
            return Ok(points.iter().map(|&at| scenario.grid.cell(at)).collect());
        };
        let places: Vec<(Point, u32)> = self.places.iter().map(|&(at, level)| (at, level.unwrap_or(0))).collect();
        audit_slices(scenario, &places)?;
        Ok(places.iter().map(|&(at, level)| slices.place(at.x, at.y, level)).collect())
    }
}

/// What may measure a path of this kind on a scenario, the usual one first.
fn objectives(scenario: &Scenario, kind: PathKind) -> Vec<Objective> {
    let by_slices = scenario.by_slices().is_some();
    match (kind, by_slices, scenario.goals.len() > 1) {
        (PathKind::Steps, true, _) => vec![Objective::SliceCost],
        (PathKind::Steps, false, true) => vec![Objective::TourLength],
        (PathKind::Steps, false, false) => vec![Objective::Length, Objective::TurnIndex],
        (PathKind::Polyline, false, false) => vec![Objective::PolylineLength],
        (PathKind::Polyline, ..) => Vec::new(),
    }
}

/// Refuses a value that cannot be.
///
/// # Errors
/// [`BestKnownError::Impossible`] below the proven optimum, [`BestKnownError::NoPath`] where there is none.
pub fn check_bound(value: f64, reference: Reference) -> Result<(), BestKnownError> {
    match reference {
        Reference::NoPath => Err(BestKnownError::NoPath),
        Reference::Proven { value: optimum } if is_below(value, optimum) => Err(BestKnownError::Impossible { value, optimum }),
        _ => Ok(()),
    }
}

/// How one scenario differs from another in what its runs depend on, in words; none where they are the same question. Names and the place in the world
/// do not count.
pub fn difference(one: &Scenario, other: &Scenario) -> Option<&'static str> {
    let (a, b) = (&one.spec, &other.spec);
    let goals = |scenario: &Scenario| {
        let number = |goal: &crate::scenario::Goal| (goal.at, goal.area, goal.strength, goal.danger);
        scenario.spec.goals.iter().map(number).collect::<Vec<_>>()
    };
    let parts = [
        ("its size differs", (a.width, a.height) == (b.width, b.height)),
        ("its cells differ", one.drawn == other.drawn),
        ("its start differs", a.start == b.start),
        ("its goals differ", goals(one) == goals(other)),
        ("its moves differ", a.movement == b.movement),
        ("its terrain differs", a.terrain == b.terrain),
        ("its metres a cell differ", a.resolution == b.resolution),
        ("its robot differs", a.robot == b.robot),
        ("its changes differ", a.changes == b.changes),
    ];
    parts.into_iter().find(|(_, is_same)| !is_same).map(|(name, _)| name)
}

#[cfg(test)]
mod tests;
