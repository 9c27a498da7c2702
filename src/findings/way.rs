//! What is wrong with a way whose places are no centres of cells, as robots are sent them.

use serde::Serialize;

use super::{FORMAT, blocked_at, wrong_ends};
use crate::map::{Grid, Point};
use crate::metrics::{Place, WayMetrics, entered_blocked};
use crate::scenario::{Scenario, ScenarioSpec};

/// What is wrong with a way, and its measures.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WayFindings {
    format: &'static str,
    kind: &'static str,
    /// Whether nothing is wrong.
    pub ok: bool,
    /// Where it does not begin, end or come by as asked, in words.
    pub wrong_ends: Vec<String>,
    /// Obstacles that it comes into, in its order.
    pub collisions: Vec<Point>,
    /// Free cells that it comes into and in which the robot does not fit.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub narrow: Vec<Point>,
    /// Its measures.
    pub metrics: WayMetrics,
}

impl WayFindings {
    /// Audits a way on a plane; `cells` are those in which its places lie, one for each. None on a terrain. Its ends count only where
    /// `has_ends`: the map's file names them.
    pub fn of(drawn: &Grid, spec: &ScenarioSpec, has_ends: bool, places: &[Place], cells: &[Point]) -> Option<Self> {
        if spec.terrain.is_some() {
            return None;
        }
        let ground = Scenario::unvalidated(drawn.clone(), spec.clone(), 0, 0);
        // Places lie on the map, and so does every line between two of them.
        let entered = entered_blocked(&ground, places).map(|(x, y)| Point::new(x as u32, y as u32));
        let (collisions, narrow): (Vec<_>, Vec<_>) = entered.partition(|&at| blocked_at(drawn, at));
        let wrong_ends = wrong_ends(spec, has_ends, cells);
        let metrics = WayMetrics::of(&ground, places);
        let open = collisions.is_empty() && narrow.is_empty();
        let metrics = WayMetrics { cost: metrics.cost.filter(|_| open), ..metrics };
        Some(Self { format: FORMAT, kind: "places", ok: open && wrong_ends.is_empty(), wrong_ends, collisions, narrow, metrics })
    }
}
