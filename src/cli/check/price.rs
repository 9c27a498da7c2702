//! What a path costs on weighted ground, and how far that is from the least there is between its ends.
//!
//! Asked for by the name of a planner of Nav2, the count is that planner's own:
//!
//! - `nav2-smac-2d`: every step costs its length times 1 + m·cost / 252 of the cell that it enters (`Node2D::getTraversalCost`,
//!   nav2_smac_planner/src/node_2d.cpp); the planner looks at no cell beside a diagonal step. So the least is that of an exact search with 8
//!   moves, and no path of steps can cost less.
//!   A way whose places are no centres of cells has no steps that enter cells: it is charged for what it crosses.
//! - `nav2-navfn`: a cell costs (50 + 0.8·cost) / 50 (`COST_NEUTRAL`, `COST_FACTOR`; navfn.cpp of nav2_navfn_planner), charged along the
//!   path. NavFn itself solves the eikonal equation to first order and follows the gradient, so the least by steps is a yardstick for its
//!   path and not what it searches for.

use std::sync::Arc;

use serde::Serialize;

use crate::cli::text::{self, row};
use crate::comparison::gap::relative_gap;
use crate::exact::{self, Reference};
use crate::findings::{Findings, WayFindings};
use crate::formats::Imported;
use crate::map::{Charge, Point};
use crate::metrics::Place;
use crate::path::PathKind;
use crate::planner::Objective;
use crate::scenario::{CostRule, Goal, Scenario, ScenarioSpec};

/// What a path costs, in cells.
#[derive(Debug, Serialize)]
pub(super) struct Price {
    /// The planner whose count it is; absent by the scenario's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    by: Option<CostRule>,
    /// `entered` or `crossed`: which of a step's cells are charged.
    charge: &'static str,
    /// What it costs; null where it leads through what cannot be entered.
    value: Option<f64>,
    /// The least between its ends.
    reference: Reference,
    /// How far the value lies above the reference, as a part of that.
    gap: Option<f64>,
    /// How far the ends of a way lie from the centres between which the reference leads, in cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    ends_off_centre: Option<[f64; 2]>,
    /// Why there is nothing to compare with.
    #[serde(skip_serializing_if = "Option::is_none")]
    unknown: Option<String>,
}

impl Price {
    /// Of a path that has been looked at; none on plain ground that nobody asks about, and of a path that has no length.
    pub(super) fn of(map: &Imported, path: &[Point], findings: &Findings, by: Option<CostRule>) -> Option<Self> {
        findings.metrics.filter(|metrics| by.is_some() || metrics.cost.is_some())?;
        let charge = match (by, findings.kind) {
            (Some(CostRule::Nav2Smac2d), PathKind::Steps) => Charge::Entered,
            _ => Charge::Crossed,
        };
        let objective = if findings.kind == PathKind::Steps { Objective::Length } else { Objective::PolylineLength };
        let cost = |scenario: &Scenario| {
            let cells: Vec<_> = path.iter().map(|&at| scenario.grid.cell(at)).collect();
            is_open(findings).then(|| scenario.path_length(&cells))
        };
        Self::between(map, path, by, charge, objective, cost)
    }

    /// Of a way whose places are no centres of cells: the integral of the factors along it, beside the least of a polyline between the
    /// cells of its ends. On plain ground its length where somebody asks.
    pub(super) fn of_way(
        map: &Imported,
        places: &[Place],
        cells: &[Point],
        findings: &WayFindings,
        by: Option<CostRule>,
    ) -> Option<Self> {
        if by.is_none() && findings.metrics.cost.is_none() {
            return None;
        }
        let open = findings.collisions.is_empty() && findings.narrow.is_empty();
        let value = open.then(|| findings.metrics.cost.unwrap_or(findings.metrics.length));
        let off = |end: (&Place, &Point)| {
            let ([x, y], at) = (*end.0, *end.1);
            let (dx, dy) = (x - f64::from(at.x), y - f64::from(at.y));
            libm::sqrt(dx * dx + dy * dy)
        };
        let ends = [places.first().zip(cells.first())?, places.last().zip(cells.last())?].map(off);
        let price = Self::between(map, cells, by, Charge::Crossed, Objective::PolylineLength, |_| value)?;
        Some(Self { ends_off_centre: Some(ends), ..price })
    }

    /// Of what costs so much on the map, between the first and the last of these cells.
    fn between(
        map: &Imported,
        path: &[Point],
        by: Option<CostRule>,
        charge: Charge,
        objective: Objective,
        cost: impl FnOnce(&Scenario) -> Option<f64>,
    ) -> Option<Self> {
        let (first, last) = path.first().zip(path.last())?;
        let priced = Self {
            by,
            charge: name_of(charge),
            value: None,
            reference: Reference::Unknown,
            gap: None,
            ends_off_centre: None,
            unknown: None,
        };
        let spec = ScenarioSpec { start: *first, goals: vec![Goal::new(*last, "")], changes: Vec::new(), ..map.spec.clone() };
        let scenario = match Scenario::new(map.grid.clone(), spec) {
            Ok(scenario) => Arc::new(scenario.charging(charge)),
            Err(error) => return Some(Self { unknown: Some(error.to_string()), ..priced }),
        };
        let (value, reference) = (cost(&scenario), exact::reference(&scenario, objective));
        let gap = value.zip(reference.value()).map(|(value, best)| relative_gap(value, best));
        Some(Self { value, reference, gap, ..priced })
    }

    /// Its lines.
    pub(super) fn text(&self, out: &mut String) {
        let whose = self.by.map_or_else(String::new, |rule| format!(", as {} counts", rule.id()));
        match self.value {
            Some(value) => row(out, "cost", format!("{value:.4} cells{whose}: {} are charged", self.charged())),
            None => row(out, "cost", "none: the path leads through cells that cannot be entered"),
        }
        match (&self.unknown, self.reference) {
            (Some(why), _) => row(out, "optimum", format!("unknown: {why}")),
            (None, Reference::Proven { value }) => {
                row(out, "optimum", format!("{value:.4} cells between the path's ends, proven"))
            }
            (None, Reference::Unproven { value }) => {
                row(out, "reference", format!("{value:.4} cells, by theta-star, not proven"))
            }
            (None, Reference::NoPath) => row(out, "optimum", "none: no path leads from its start to its goal"),
            (None, Reference::Unknown) => row(out, "optimum", "unknown: the map is too large"),
        }
        if let Some(gap) = self.gap {
            row(out, "gap", format!("{} by cost", text::percent(gap)));
        }
        if let Some([first, last]) = self.ends_off_centre {
            let between = "between the centres of its ends' cells, from which its ends are";
            row(out, "", format!("{between} {first:.2} and {last:.2} cells away"));
        }
        if self.by == Some(CostRule::Nav2Navfn) {
            row(out, "", "NavFn follows the gradient of a first-order solution of the eikonal equation, not steps");
        }
    }

    fn charged(&self) -> &'static str {
        if self.charge == name_of(Charge::Entered) { "the cells that its steps enter" } else { "all cells that it crosses" }
    }
}

fn name_of(charge: Charge) -> &'static str {
    match charge {
        Charge::Crossed => "crossed",
        Charge::Entered => "entered",
    }
}

/// Whether no part of a path lies where nothing can go.
fn is_open(findings: &Findings) -> bool {
    findings.collisions.is_empty() && findings.narrow.is_empty() && findings.out_of_sight.is_empty()
}
