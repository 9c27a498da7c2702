//! Smoothing: a curve that a vehicle can drive in place of a path with corners. It is a step after any planner: no search knows of it.
//!
//! The curve is a clamped uniform cubic B-spline (de Boor, A Practical Guide to Splines, 1978; Piegl and Tiller, The NURBS Book, 1997). Its
//! control points are the path's corners, straight stretches being one. Where it would touch an obstacle, points are put between them on the
//! path, so that it comes closer to it. Where it is tighter than the vehicle turns, its control points are pulled towards the middle of their
//! neighbours, as far as nothing is touched then. Of several goals it comes through each one's cell.
//!
//! What is free is the scenario's to say. By `both-free`, and with 4 moves, the curve touches no blocked cell. By the other rules it may touch
//! its sides, and by `always` pass between two blocked cells that meet at a corner; it never comes into one. That holds for the whole curve,
//! not at its samples alone: between two of them it is within a known distance of a straight line, and every cell that close is looked at. On
//! a terrain with a limit of slope the ground between the samples, a quarter of a cell apart at most, is not steeper. Stretches of the path
//! that stay straight are as free as the path is.

mod polygon;
mod room;
mod spline;

use serde::Serialize;

use crate::map::{Cell, Point};
use crate::metrics::WayMetrics;
use crate::path::corners;
use crate::scenario::{Scenario, SmoothingRule};
use polygon::Polygon;
use room::Room;

/// A path as a smooth curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Smoothed {
    /// Points of the curve as column and row, the centres of cells being whole numbers: from the start's centre to that of the last goal. At
    /// most a quarter of a cell apart where it bends; straight stretches of the path are their two ends.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub points: Vec<[f64; 2]>,
    /// Length in cells through these points; on a terrain along the ground, whose heights are bilinear between the centres of cells.
    pub length: f64,
    /// By how many cells that is shorter than the path, measured in the same way; below 0 if it is longer.
    pub saved: f64,
    /// Largest curvature of the whole curve per metre, at least 0, from its derivatives. Absent where it turns on the spot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub largest_curvature: Option<f64>,
    /// Whether that is within the vehicle's bound; always where there is none.
    pub meets_bound: bool,
    /// What driving along it comes to on a plane; none on a terrain.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub metrics: Option<WayMetrics>,
    /// False where no curve is free, as may be on steep ground: the points are the path's corners then.
    pub is_curve: bool,
}

impl Smoothed {
    /// Smooths a valid path of either kind by the vehicle's rule, and measures the curve; none where the vehicle has none, by slices, and
    /// without a path.
    pub fn of(scenario: &Scenario, path: &[Cell]) -> Option<Self> {
        let curve = smooth(scenario, path, scenario.spec.vehicle.smoothing?)?;
        let metrics = scenario.spec.terrain.is_none().then(|| WayMetrics::of(scenario, &curve.points));
        Some(Self { metrics, ..curve })
    }

    /// Altitudes of its points in metres, on the ground of a terrain; empty on a plane.
    pub fn altitudes(&self, scenario: &Scenario) -> Vec<f64> {
        let Some(relief) = scenario.moves.relief() else { return Vec::new() };
        let room = Room::new(scenario);
        self.points.iter().map(|&at| room.height(relief, at) * scenario.spec.resolution).collect()
    }
}

/// Smooths a valid path of either kind; none by slices, and without a path.
///
/// ```
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::scenario::{Scenario, SmoothingRule};
/// use formicarium::smoothing::smooth;
///
/// let scenario = Scenario::on(Grid::open(8, 8)?, Movement::default(), Point::new(0, 0), Point::new(7, 7))?;
/// // Seven cells east, then seven south; no turn with a radius below two metres.
/// let curve = smooth(&scenario, &[0, 7, 63], SmoothingRule { max_curvature: 0.5 }).expect("a curve on a plane");
/// assert!(curve.meets_bound && curve.largest_curvature <= Some(0.5) && curve.length < 14.0);
/// assert_eq!((curve.points[0], curve.points.last()), ([0.0, 0.0], Some(&[7.0, 7.0])));
/// # Ok::<(), formicarium::error::ScenarioError>(())
/// ```
pub fn smooth(scenario: &Scenario, path: &[Cell], rule: SmoothingRule) -> Option<Smoothed> {
    if scenario.by_slices().is_some() || path.is_empty() {
        return None;
    }
    let (corners, stops) = corners_and_stops(scenario, path);
    let room = Room::new(scenario);
    if corners.len() < 3 {
        return Some(Smoothed::through(corners.clone(), &corners, room, Some(0.0), rule));
    }
    let mut polygon = Polygon::on(&corners, |k| stops.contains(&k), room);
    if !polygon.settle() {
        return Some(Smoothed { is_curve: false, ..Smoothed::through(corners.clone(), &corners, room, None, rule) });
    }
    let (bound, resolution) = (rule.max_curvature * scenario.spec.resolution, scenario.spec.resolution);
    if bound > 0.0 {
        polygon.relax(bound);
    }
    let curvature = Some(polygon.largest_curvature() / resolution).filter(|c| c.is_finite());
    let meets_bound = bound == 0.0 || polygon.meets(bound);
    Some(Smoothed { meets_bound, ..Smoothed::through(polygon.points(), &corners, room, curvature, rule) })
}

impl Smoothed {
    fn through(points: Vec<[f64; 2]>, path: &[[f64; 2]], room: Room, curvature: Option<f64>, rule: SmoothingRule) -> Self {
        let measure = |points: &[[f64; 2]]| points.windows(2).fold(0.0, |sum, ends| sum + room.length(ends[0], ends[1]));
        let length = measure(&points);
        Self {
            saved: measure(path) - length,
            length,
            points,
            largest_curvature: curvature,
            meets_bound: rule.max_curvature == 0.0 || curvature.is_some_and(|c| c <= rule.max_curvature),
            metrics: None,
            is_curve: true,
        }
    }
}

/// The path's ends, its corners, and the goals on its way; and which of them are goals on its way.
fn corners_and_stops(scenario: &Scenario, path: &[Cell]) -> (Vec<[f64; 2]>, Vec<usize>) {
    let is_goal = |i: &usize| (1..path.len() - 1).contains(i) && scenario.goals.contains(&path[*i]);
    let (mut all, mut stops, mut from) = (Vec::new(), Vec::new(), 0);
    for to in (0..path.len()).filter(is_goal).chain([path.len() - 1]) {
        let leg = corners(scenario, &path[from..=to]);
        all.extend(leg.into_iter().skip(usize::from(from > 0)).map(|Point { x, y }| [f64::from(x), f64::from(y)]));
        stops.push(all.len() - 1);
        from = to;
    }
    stops.pop();
    (all, stops)
}
