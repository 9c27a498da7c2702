//! A path on its map, with everything that its formats tell.

use crate::error::{FormatError, Notice};
use crate::map::{Cell, Grid, Point};
use crate::metrics::Metrics;
use crate::path::{Flaw, PathKind, audit, audit_slices};
use crate::scenario::{Scenario, ScenarioSpec, World};
use crate::smoothing::Smoothed;

use super::CURVE;

/// A path that can be written.
#[derive(Debug, Clone)]
pub struct PlannedPath<'a> {
    pub(super) grid: &'a Grid,
    pub(super) spec: &'a ScenarioSpec,
    /// `steps`, `polyline`, `slices` or `curve`.
    pub(super) kind: &'static str,
    pub(super) cells: Vec<Point>,
    /// By slices alone.
    pub(super) levels: Option<Vec<u32>>,
    /// Where the vehicle has a rule of smoothing, the curve in place of the cells.
    pub(super) curve: Option<Smoothed>,
    /// Of each cell, or of each point of the curve, x and y, on a terrain z: in the world, or from the lower left corner of a map whose place
    /// is not known.
    pub(super) metres: Vec<Vec<f64>>,
    /// In cells, and in metres.
    pub(super) length: f64,
    pub(super) length_metres: f64,
}

impl<'a> PlannedPath<'a> {
    /// A valid path of a planner, as [`crate::planner::Best::result`] gives it; none where it has no place.
    ///
    /// ```
    /// use formicarium::formats::{PathFormat, PlannedPath};
    /// use formicarium::map::{Grid, Movement, Point};
    /// use formicarium::{path::PathKind, scenario::Scenario};
    ///
    /// let scenario = Scenario::on(Grid::open(3, 2)?, Movement::default(), Point::new(0, 0), Point::new(2, 0))?;
    /// let path = PlannedPath::new(&scenario, &[0, 1, 2], PathKind::Steps).expect("it has places");
    /// let file = PathFormat::PathCsv.write(&path)?;
    /// assert_eq!(file.text, "x,y,x_m,y_m\n0,0,0.5,1.5\n1,0,1.5,1.5\n2,0,2.5,1.5\n");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(scenario: &'a Scenario, path: &[Cell], kind: PathKind) -> Option<Self> {
        let kind = match kind {
            _ if scenario.by_slices().is_some() => "slices",
            PathKind::Steps => "steps",
            PathKind::Polyline => "polyline",
        };
        let Metrics { length, length_metres, .. } = if path.is_empty() { return None } else { Metrics::of(scenario, path) };
        Some(Self::measured(scenario, path, kind, [length, length_metres]).smoothed(scenario, path))
    }

    /// The way of a robot by steps, of this length in cells. Where walls change and obstacles move it may pass over cells that are blocked on
    /// the scenario's own map.
    pub fn driven(scenario: &'a Scenario, way: &[Cell], length: f64) -> Self {
        Self::measured(scenario, way, "steps", [length, length * scenario.spec.resolution])
    }

    fn measured(scenario: &'a Scenario, path: &[Cell], kind: &'static str, [length, length_metres]: [f64; 2]) -> Self {
        let (grid, spec) = (&scenario.grid, &scenario.spec);
        let levels = scenario.by_slices().map(|slices| path.iter().map(|&place| slices.at(place).2).collect());
        let cells: Vec<Point> = scenario.cells_of(path).into_iter().map(|cell| grid.point(cell)).collect();
        let centres: Vec<[f64; 2]> = cells.iter().map(|at| [f64::from(at.x), f64::from(at.y)]).collect();
        let metres = in_metres(spec, &centres, &scenario.altitudes(path));
        Self { grid, spec, kind, cells, levels, curve: None, metres, length, length_metres }
    }

    /// The same as the curve that the vehicle drives, where it has a rule of smoothing and a curve is free.
    fn smoothed(self, scenario: &Scenario, path: &[Cell]) -> Self {
        let Some(curve) = Smoothed::of(scenario, path).filter(|curve| curve.is_curve) else { return self };
        let metres = in_metres(self.spec, &curve.points, &curve.altitudes(scenario));
        let (length, length_metres) = (curve.length, curve.length * self.spec.resolution);
        Self { kind: CURVE, metres, length, length_metres, curve: Some(curve), ..self }
    }

    /// That it is written as its curve, and whether that is as wide as was asked for; that there is none where one was.
    pub(super) fn notices(&self) -> Vec<Notice> {
        let Some(rule) = self.spec.vehicle.smoothing else { return Vec::new() };
        let Some(curve) = &self.curve else {
            return vec![Notice::new("path-no-curve", "no smooth curve is free: the path is written as it was planned")];
        };
        let written = Notice::new("path-curve", "the path is written as its smooth curve, in metres");
        let message = || format!("the curve is tighter than {} per metre: no wider turn is free", rule.max_curvature);
        let tight = (!curve.meets_bound).then(|| Notice::new("path-tight", message()).with("bound", rule.max_curvature));
        [written].into_iter().chain(tight).collect()
    }

    /// A path as the page holds it: points, and on a terrain their altitudes in metres, which by slices tell the levels.
    ///
    /// # Errors
    /// [`FormatError::Field`] for what is no path on this map, with its first flaw.
    pub fn of_points(scenario: &'a Scenario, points: &[Point], altitudes: &[f32], kind: PathKind) -> Result<Self, FormatError> {
        let expected = "a path on this map, from its start by every goal";
        let flawed = |flaw: Flaw| FormatError::field("path", flaw.to_string(), expected);
        let cells: Vec<Cell> = match scenario.by_slices() {
            Some(slices) => {
                let level = |altitude: f32| libm::round(f64::from(altitude) / slices.rules().level) as u32;
                let places: Vec<(Point, u32)> = points.iter().copied().zip(altitudes.iter().copied().map(level)).collect();
                audit_slices(scenario, &places).map_err(flawed)?;
                places.iter().map(|&(at, level)| slices.place(at.x, at.y, level)).collect()
            }
            None => {
                audit(scenario, points, kind).map_err(flawed)?;
                points.iter().map(|&at| scenario.grid.cell(at)).collect()
            }
        };
        Self::new(scenario, &cells, kind).ok_or_else(|| flawed(Flaw::Empty))
    }

    /// Cells so small, so far from zero, that their middles are not told apart would not be read back.
    ///
    /// # Errors
    /// [`FormatError::Field`].
    pub(super) fn check_metres(&self) -> Result<(), FormatError> {
        let placed = placed(self.spec);
        let same = |at: &Point| placed.to_world(*at).and_then(|metres| placed.to_cell(metres)) == Some(*at);
        if self.cells.iter().all(same) {
            return Ok(());
        }
        let what = format!("cells of {} m are not told apart so far from zero", self.spec.resolution);
        Err(FormatError::field("world", what, "a place of the map nearer to zero"))
    }
}

/// Places in cells as metres, with the altitudes that there are.
fn in_metres(spec: &ScenarioSpec, places: &[[f64; 2]], altitudes: &[f64]) -> Vec<Vec<f64>> {
    let placed = placed(spec);
    let metres = |(index, &at): (usize, &[f64; 2])| {
        let flat = placed.place_to_world(at).unwrap_or_default();
        flat.into_iter().chain(altitudes.get(index).copied()).collect()
    };
    places.iter().enumerate().map(metres).collect()
}

/// The scenario with a place: the lower left corner of a map whose place is not known is (0, 0), as it is in a ROS map that is written.
pub(in crate::formats) fn placed(spec: &ScenarioSpec) -> ScenarioSpec {
    let world = spec.world.clone().or_else(|| Some(World::at(0.0, 0.0)));
    ScenarioSpec { world, ..spec.clone() }
}
