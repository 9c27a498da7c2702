//! What is measured on a path: length, turns, V(d, r), clearance, arrival time; on a terrain what it climbs; what driving along it takes.

#[cfg(feature = "whole")]
mod driving;
#[cfg(feature = "whole")]
mod way;
mod weighted_sum;

use serde::Serialize;

use crate::map::{Cell, Grid, OFFSETS, PlaneLength, displacement};
use crate::path::{crossed, turns};
use crate::scenario::Scenario;

#[cfg(feature = "whole")]
pub use driving::Driving;
#[cfg(feature = "whole")]
pub use way::{Place, WayMetrics, entered_blocked};
pub use weighted_sum::{Terms, WeightedSum, angle, energy_rates};

/// Weight of a turning step in V(d, r): equation (10) of the fire-fighting paper.
pub const TURN_WEIGHT: f64 = 1.2;

/// Lengths in cells that differ by less are the same: what is left of rounding when they were added in different orders.
pub const SAME_LENGTH: f64 = 1e-9;

/// The metrics of one path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Metrics {
    /// Length in cells: straight steps + √2 · diagonal steps + oblique segments; on a terrain along its ground; by slices
    /// Σ √(1 + Δy² + Δh²).
    pub length: f64,
    /// Length in metres; by slices with the levels' true distance.
    pub length_metres: f64,
    /// Number of steps.
    pub steps: u32,
    /// Number of steps whose direction differs from the step before.
    pub turns: u32,
    /// V(d, r) = Σ dᵢ·rᵢ in cells, rᵢ = 1.2 if step i turns, else 1; dᵢ on weighted ground what step i costs. The steps of a polyline are
    /// its segments.
    pub turn_index: f64,
    /// Smallest distance in cells from the centre of a cell that the path crosses to the nearest obstacle's centre; the world beyond the
    /// border is an obstacle. A polyline crosses the cells that its segments pass through, so straight stretches may be merged.
    pub min_clearance: f64,
    /// Mean of the same distance over the cells that the path crosses.
    pub mean_clearance: f64,
    /// Arrival time in seconds: metres / speed + turns · seconds per turn.
    pub travel_time: f64,
    /// On weighted ground alone: what it costs, in cells; each stretch counts its length times the factor of its cell.
    #[cfg(feature = "whole")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<f64>,
    /// On a terrain alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub terrain: Option<TerrainMetrics>,
    /// How it is to drive; none by slices. The opening build does not measure it.
    #[cfg(feature = "whole")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub driving: Option<Driving>,
}

/// What a path does on a terrain.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct TerrainMetrics {
    /// Metres up.
    pub climb: f64,
    /// Metres down.
    pub descent: f64,
    /// Steepest stretch in degrees, up or down.
    pub steepest: f64,
    /// By slices: Σ √(1 + Δy² + Δh²) + |h|, the textbook program's cost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub level_cost: Option<f64>,
}

impl Metrics {
    /// Measures a valid path of either kind.
    ///
    /// ```
    /// use formicarium::map::{Grid, Movement, Point};
    /// use formicarium::{metrics::Metrics, scenario::Scenario};
    ///
    /// let scenario = Scenario::on(Grid::open(3, 3)?, Movement::default(), Point::new(0, 0), Point::new(2, 2))?;
    /// // East, east, south, south.
    /// let measured = Metrics::of(&scenario, &[0, 1, 2, 5, 8]);
    /// assert_eq!((measured.length, measured.turns, measured.steps), (4.0, 1, 4));
    /// # Ok::<(), formicarium::error::ScenarioError>(())
    /// ```
    pub fn of(scenario: &Scenario, path: &[Cell]) -> Self {
        let length = scenario.ground_length(path);
        let cells = scenario.cells_of(path);
        let (turns, turning) = turning(scenario, path, &cells);
        let (min_clearance, mean_clearance) = clearance(scenario.obstacles(), &cells);
        let metres =
            if scenario.by_slices().is_some() { metres_by_slices(scenario, path) } else { length * scenario.spec.resolution };
        let vehicle = scenario.spec.vehicle;
        let terrain = terrain(scenario, path);
        Self {
            length,
            length_metres: metres,
            steps: path.len().saturating_sub(1) as u32,
            turns,
            turn_index: weighed(scenario.path_length(path), turning),
            min_clearance,
            mean_clearance,
            travel_time: vehicle.travel_time(metres, turns),
            #[cfg(feature = "whole")]
            cost: scenario.moves.weights().map(|_| scenario.path_length(path)),
            terrain,
            #[cfg(feature = "whole")]
            driving: Driving::of(scenario, path, metres, terrain.map_or(0.0, |t| t.climb)),
        }
    }
}

impl Metrics {
    /// What planners of lengths make small: the length in cells, on weighted ground the cost.
    pub fn made_small(&self) -> f64 {
        #[cfg(feature = "whole")]
        return self.cost.unwrap_or(self.length);
        #[cfg(not(feature = "whole"))]
        self.length
    }
}

/// V(d, r) of a path of either kind, in cells: what [`Metrics::turn_index`] is, without the rest.
pub fn turn_index(scenario: &Scenario, path: &[Cell]) -> f64 {
    let (_, turning) = turning(scenario, path, &scenario.cells_of(path));
    weighed(scenario.path_length(path), turning)
}

/// V(d, r) of a length and of the part of it that turns.
fn weighed(length: f64, turning: f64) -> f64 {
    length + (TURN_WEIGHT - 1.0) * turning
}

/// Number of turns, and the length of the steps or segments that turn. By slices the levels count as a third axis.
fn turning(scenario: &Scenario, path: &[Cell], cells: &[Cell]) -> (u32, f64) {
    let (width, area) = (scenario.grid.width(), scenario.grid.len() as Cell);
    let climbs = |a: usize, b: usize| (path[b] / area) as i32 - (path[a] / area) as i32;
    let on_plane = scenario.by_slices().is_none() && scenario.moves.is_plain();
    let (mut turns, mut tally, mut sum) = (0u32, PlaneLength::default(), 0.0);
    for k in 2..path.len() {
        let (before, after) = (displacement(width, cells[k - 2], cells[k - 1]), displacement(width, cells[k - 1], cells[k]));
        if !self::turns(before, after) && climbs(k - 2, k - 1) == climbs(k - 1, k) {
            continue;
        }
        turns += 1;
        if on_plane {
            tally.add(after);
        } else {
            sum += scenario.path_length(&path[k - 1..=k]);
        }
    }
    (turns, if on_plane { tally.length() } else { sum })
}

/// Metres of a path by slices: cells by the resolution, levels by their height.
fn metres_by_slices(scenario: &Scenario, path: &[Cell]) -> f64 {
    stretches(scenario, path).map(|(run, rise)| libm::sqrt(run * run + rise * rise)).sum()
}

/// Run and rise in metres of each step or segment of a path by slices.
fn stretches<'a>(scenario: &'a Scenario, path: &'a [Cell]) -> impl Iterator<Item = (f64, f64)> + 'a {
    let (width, resolution) = (scenario.grid.width(), scenario.spec.resolution);
    let altitudes = scenario.altitudes(path);
    let cells = scenario.cells_of(path);
    (1..path.len()).map(move |k| {
        let (dx, dy) = displacement(width, cells[k - 1], cells[k]);
        let run = libm::sqrt(f64::from(dx * dx + dy * dy)) * resolution;
        (run, altitudes[k] - altitudes[k - 1])
    })
}

/// What a path climbs; none on a plane.
fn terrain(scenario: &Scenario, path: &[Cell]) -> Option<TerrainMetrics> {
    let relief = scenario.moves.relief()?;
    let (mut climb, mut descent, mut steepness) = (0.0, 0.0, 0.0f64);
    if scenario.by_slices().is_some() {
        for (run, rise) in stretches(scenario, path) {
            climb += rise.max(0.0);
            descent += (-rise).max(0.0);
            steepness = steepness.max(rise.abs() / run);
        }
    } else {
        for s in path.windows(2).map(|s| relief.segment(s[0], s[1])) {
            climb += s.climb * scenario.spec.resolution;
            descent += s.descent * scenario.spec.resolution;
            steepness = steepness.max(s.steepness);
        }
    }
    let steepest = libm::atan(steepness).to_degrees();
    let level_cost = |slices: &crate::map::Slices| {
        let levels: f64 = path.iter().skip(1).map(|&p| f64::from(slices.at(p).2)).sum();
        scenario.path_length(path) + levels
    };
    Some(TerrainMetrics { climb, descent, steepest, level_cost: scenario.by_slices().map(level_cost) })
}

/// Share of blocked cells among the eight around a cell, 0 to 1; beyond the border is blocked.
pub fn obstacle_density(scenario: &Scenario, cell: Cell) -> f64 {
    f64::from(obstacles_around(scenario, cell).count() as u32) / OFFSETS.len() as f64
}

/// The offsets (dx, dy) of the blocked cells among the eight around a cell; beyond the border is blocked.
pub fn obstacles_around(scenario: &Scenario, cell: Cell) -> impl Iterator<Item = (i32, i32)> + use<'_> {
    let at = scenario.grid.point(cell);
    let (x, y) = (i64::from(at.x), i64::from(at.y));
    OFFSETS.into_iter().filter(move |&(dx, dy)| !scenario.grid.is_free_at(x + i64::from(dx), y + i64::from(dy)))
}

/// Smallest and mean clearance of the cells that a path crosses.
fn clearance(grid: &Grid, path: &[Cell]) -> (f64, f64) {
    clearance_of(grid, crossed(grid.width(), path))
}

/// The same of these cells; 0 of none.
fn clearance_of(grid: &Grid, path: impl Iterator<Item = Cell>) -> (f64, f64) {
    let gaps = gaps_in_rows(grid);
    let (mut min, mut sum, mut cells) = (f64::INFINITY, 0.0, 0u32);
    for c in path {
        let d = libm::sqrt(f64::from(squared_distance(grid, &gaps, c)));
        min = min.min(d);
        sum += d;
        cells += 1;
    }
    if cells == 0 { (0.0, 0.0) } else { (min, sum / f64::from(cells)) }
}

/// Distance of every cell to the nearest blocked cell of its own row; the columns −1 and width count as blocked.
fn gaps_in_rows(grid: &Grid) -> Vec<u32> {
    let (w, h) = (grid.width() as usize, grid.height() as usize);
    let mut gaps = vec![0u32; w * h];
    for y in 0..h {
        let row = &mut gaps[y * w..(y + 1) * w];
        let mut gap = 0;
        for (x, cell) in row.iter_mut().enumerate() {
            gap = if grid.is_blocked((y * w + x) as Cell) { 0 } else { gap + 1 };
            *cell = gap;
        }
        gap = 0;
        for (x, cell) in row.iter_mut().enumerate().rev() {
            gap = if grid.is_blocked((y * w + x) as Cell) { 0 } else { gap + 1 };
            *cell = gap.min(*cell);
        }
    }
    gaps
}

/// Squared Euclidean distance of a cell to the nearest blocked cell or to the ring of cells just outside the map, exact:
/// min over rows y' of (y − y')² + gap², looking outwards until no farther row can be nearer.
fn squared_distance(grid: &Grid, gaps: &[u32], cell: Cell) -> u32 {
    let (width, p) = (grid.width(), grid.point(cell));
    let border = (p.y + 1).min(grid.height() - p.y);
    let gap_in = |y: u32| gaps[(y * width + p.x) as usize];
    let mut best = border.min(gap_in(p.y)).pow(2);
    let mut away = 1u32;
    while away * away < best {
        // Both rows lie on the map: the border is farther than what is looked at.
        let gap = gap_in(p.y - away).min(gap_in(p.y + away));
        best = best.min(away * away + gap.pow(2));
        away += 1;
    }
    best
}

#[cfg(test)]
mod tests {
    use std::f64::consts::SQRT_2;

    use super::*;
    use crate::map::{Movement, Point};

    fn scenario(rows: &[&str]) -> Scenario {
        let cells: Vec<u8> = rows.iter().flat_map(|r| r.bytes().map(|b| u8::from(b == b'#'))).collect();
        let grid = Grid::from_bytes(rows[0].len() as u32, rows.len() as u32, &cells).unwrap();
        let end = Point::new(grid.width() - 1, grid.height() - 1);
        Scenario::on(grid, Movement::default(), Point::new(0, 0), end).unwrap()
    }

    #[test]
    fn measures_by_hand() {
        let mut s = scenario(&["....", "....", "...."]);
        s.spec.resolution = 0.5;
        s.spec.vehicle = crate::scenario::Vehicle { speed: 0.25, seconds_per_turn: 2.0, ..Default::default() };
        // E, E, SE, S: turns at the SE and at the S step.
        let path = [0, 1, 2, 7, 11];
        let m = Metrics::of(&s, &path);
        assert_eq!(m.steps, 4);
        assert_eq!(m.turns, 2);
        assert_eq!(m.length, 3.0 + SQRT_2);
        assert!((m.turn_index - (1.0 + 1.0 + 1.2 * SQRT_2 + 1.2)).abs() < 1e-12);
        assert_eq!(m.length_metres, 0.5 * m.length);
        assert_eq!(m.travel_time, 2.0 * m.length + 4.0);
        assert_eq!(m.min_clearance, 1.0);
    }

    #[test]
    fn a_map_two_cells_wide_has_diagonal_steps() {
        let s = scenario(&["..", "..", ".."]);
        // SW, S: the first step adds 1 to the index, as a step east does.
        let m = Metrics::of(&s, &[1, 2, 4]);
        assert_eq!((m.length, m.turns), (1.0 + SQRT_2, 1));
        // E, SW: two steps that add 1 each, and yet a turn.
        let m = Metrics::of(&s, &[0, 1, 2]);
        assert_eq!((m.length, m.turns), (1.0 + SQRT_2, 1));
        assert!((m.turn_index - (1.0 + 1.2 * SQRT_2)).abs() < 1e-12);
    }

    #[test]
    fn a_polyline_is_measured_by_its_segments_and_the_cells_they_cross() {
        let mut s = scenario(&["......", "......", "..#...", "......", "......"]);
        s.spec.vehicle = crate::scenario::Vehicle { speed: 0.5, seconds_per_turn: 3.0, ..Default::default() };
        // (0,0) → (1,3) crosses (0,0), (0,1), (1,2), (1,3); then → (5,3): (2,3), (3,3), (4,3), (5,3).
        let m = Metrics::of(&s, &[0, 19, 23]);
        assert_eq!((m.steps, m.turns), (2, 1));
        assert!((m.length - (10f64.sqrt() + 4.0)).abs() < 1e-12 && (m.turn_index - (10f64.sqrt() + 4.8)).abs() < 1e-12);
        assert!((m.travel_time - (2.0 * m.length + 3.0)).abs() < 1e-12);
        // Distances to the border or to (2,2): 1, 1, 1, √2, 1, √2, 2, 1; neither end of the second segment is that near.
        assert!((m.mean_clearance - (7.0 + 2.0 * SQRT_2) / 8.0).abs() < 1e-12, "{}", m.mean_clearance);
        // Merging a straight stretch changes nothing but the number of steps.
        let (merged, steps) = (Metrics::of(&s, &[0, 5, 29]), Metrics::of(&s, &[0, 1, 2, 3, 4, 5, 11, 17, 23, 29]));
        assert_eq!(Metrics { steps: 9, turn_index: steps.turn_index, ..merged }, steps);
    }

    #[test]
    fn clearance_agrees_with_brute_force() {
        let s = scenario(&["......#", ".......", "..#....", ".......", ".......", "#......", "......."]);
        let gaps = gaps_in_rows(&s.grid);
        for y in 0..7i64 {
            for x in 0..7i64 {
                let mut best = i64::MAX;
                for by in -1..8 {
                    for bx in -1..8 {
                        if !s.grid.is_free_at(bx, by) {
                            best = best.min((x - bx).pow(2) + (y - by).pow(2));
                        }
                    }
                }
                let found = squared_distance(&s.grid, &gaps, (y * 7 + x) as Cell);
                assert_eq!(i64::from(found), best, "at ({x}, {y})");
            }
        }
    }
}
