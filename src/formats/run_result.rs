//! One finished run as JSON: `formicarium/result@1`, as `plan --format json` prints it and docs/schema/result.schema.json describes it.

use std::sync::Arc;

use serde::Serialize;

use crate::comparison::gap::relative_gap;
use crate::exact::{self, Reference};
use crate::map::Point;
use crate::metrics::Metrics;
use crate::path::points;
use crate::planner::{Certificate, Effort, Objective, Planner, Record, Status, Tour};
use crate::scenario::Scenario;
use crate::smoothing::Smoothed;

/// One finished run, measured and compared with the best there is. Lengths and values in cells.
#[derive(Debug, Serialize)]
pub struct RunResult<'a> {
    format: &'static str,
    planner: &'a str,
    seed: u32,
    /// How it ended.
    pub status: Status,
    length: Option<f64>,
    turns: Option<u32>,
    /// What its path comes to; none without a path.
    pub metrics: Option<Metrics>,
    objective: Objective,
    /// Its value by the planner's own objective.
    pub value: Option<f64>,
    unrefined_length: Option<f64>,
    iteration_of_best: Option<u32>,
    history: &'a [Record],
    /// What it is compared with.
    pub reference: Reference,
    /// The same where it is proven.
    pub optimum: Option<f64>,
    /// How far its value lies above the reference, as a part of that.
    pub gap: Option<f64>,
    /// What the planner has proven of its result, where it tells how far a proof has come.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Certificate>,
    tour: Option<&'a Tour>,
    effort: Effort,
    /// Where walls changed: how often.
    #[serde(skip_serializing_if = "Option::is_none")]
    changes: Option<u32>,
    digest: String,
    /// Its path; empty without one.
    pub path: Vec<Point>,
    /// By slices: the level of each place of the path.
    #[serde(skip_serializing_if = "Option::is_none")]
    levels: Option<Vec<u32>>,
    /// On a terrain: metres of each place of the path.
    #[serde(skip_serializing_if = "Option::is_none")]
    altitudes: Option<Vec<f64>>,
    /// Its path as a smooth curve, where the vehicle has a rule of smoothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smoothed: Option<Smoothed>,
}

/// The map as the last of its changes has left it: the one that results belong to.
pub fn last(scenario: &Arc<Scenario>, planner: &dyn Planner) -> Arc<Scenario> {
    Arc::clone(planner.changing().map_or(scenario, |changing| changing.scenario()))
}

impl<'a> RunResult<'a> {
    /// Measures a planner that has ended. `planner_id` and `seed` are what it was built from, `scenario` too.
    pub fn of(planner_id: &'a str, seed: u32, scenario: &Arc<Scenario>, planner: &'a dyn Planner) -> Self {
        let (scenario, status, best) = (last(scenario, planner), planner.status(), planner.best());
        let path = best.map_or(&[][..], |b| b.result().0);
        let metrics = best.map(|_| Metrics::of(&scenario, path));
        let value = metrics.as_ref().and_then(|m| planner.value(m));
        let reference = reference(&scenario, planner, status, value);
        Self {
            format: "formicarium/result@1",
            planner: planner_id,
            seed,
            status,
            length: metrics.map(|m| m.length),
            turns: metrics.map(|m| m.turns),
            metrics,
            objective: planner.objective(),
            value,
            unrefined_length: best.filter(|b| b.refined.is_some()).map(|b| b.length),
            iteration_of_best: best.map(|b| b.iteration),
            history: planner.history(),
            reference,
            optimum: reference.value().filter(|_| reference.is_proven()),
            gap: value.zip(reference.value()).map(|(value, best)| relative_gap(value, best)),
            certificate: planner.certificate(),
            tour: planner.tour(),
            effort: planner.effort(),
            changes: planner.changing().map(|changing| changing.made()),
            digest: planner.digest().hex(),
            path: points(&scenario, path),
            levels: scenario.by_slices().map(|slices| path.iter().map(|&place| slices.at(place).2).collect()),
            altitudes: scenario.spec.terrain.map(|_| scenario.altitudes(path)),
            smoothed: Smoothed::of(&scenario, path),
        }
    }
}

/// The yardstick of the planner's objective: what was just proven, or a run of the exact planner.
fn reference(scenario: &Arc<Scenario>, planner: &dyn Planner, status: Status, value: Option<f64>) -> Reference {
    match (status, value) {
        (Status::Optimal, Some(value)) => Reference::Proven { value },
        (Status::NoPath, _) => Reference::NoPath,
        _ => exact::reference_of(scenario, planner.objective(), planner.weighed().map(|weighed| weighed.sum)),
    }
}
