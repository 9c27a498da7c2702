//! What moves in the tests: worked out anew from its description, without the engine's timetables.

use std::sync::Arc;

use formicarium::map::{CornerRule, Grid, Movement, Moves, Point};
use formicarium::scenario::{AtEnd, DriveChange, DriveSpec, Scenario, ScenarioSpec, Track};

use super::common;

/// Numbers below a bound, one after the other.
pub struct Draws(pub u64);

impl Draws {
    pub fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as u32) % bound
    }

    pub fn one_of<T: Clone>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u32) as usize].clone()
    }
}

/// The same scenario with what moves in it.
pub fn with(scenario: &Scenario, drive: DriveSpec) -> Arc<Scenario> {
    let spec = ScenarioSpec { drive: Some(drive), ..scenario.spec.clone() };
    Arc::new(Scenario::new(scenario.grid.clone(), spec).expect("a drive that can be"))
}

/// A track through these cells.
pub fn track(cells: &[(u32, u32)], from_step: u32, steps_per_cell: u32, at_end: AtEnd) -> Track {
    Track { cells: cells.iter().map(|&(x, y)| Point::new(x, y)).collect(), size: 1, from_step, steps_per_cell, at_end }
}

/// Where an obstacle was by its timetable at each step so far, the last one at the end.
fn timetable(track: &Track, step: u32) -> Vec<Option<Point>> {
    let cells = track.cells.len();
    let mut way: Vec<usize> = (0..cells).collect();
    if track.at_end == AtEnd::BackAndForth {
        way.extend((1..cells.saturating_sub(1)).rev());
    }
    let place = |step: u32| {
        let k = (step.checked_sub(track.from_step)? / track.steps_per_cell) as usize;
        match track.at_end {
            AtEnd::Stay => Some(track.cells[k.min(cells - 1)]),
            AtEnd::Leave => track.cells.get(k).copied(),
            AtEnd::Loop | AtEnd::BackAndForth => Some(track.cells[way[k % way.len()]]),
        }
    };
    (0..=step).map(place).collect()
}

/// The cells of an obstacle around its centre.
fn square(track: &Track, centre: Point, grid: &Grid) -> Vec<Point> {
    let (before, behind) = (i64::from(track.size - 1) / 2, i64::from(track.size) / 2);
    let mut cells = Vec::new();
    for dy in -before..=behind {
        for dx in -before..=behind {
            let (x, y) = (i64::from(centre.x) + dx, i64::from(centre.y) + dy);
            if (0..i64::from(grid.width())).contains(&x) && (0..i64::from(grid.height())).contains(&y) {
                cells.push(Point::new(x as u32, y as u32));
            }
        }
    }
    cells
}

/// The map at a step with the robot on a cell.
pub fn map_at(scenario: &Scenario, step: u32, robot: Point) -> Grid {
    let (nothing, mut grid) = (DriveSpec::default(), scenario.drawn.clone());
    let drive = scenario.spec.drive.as_ref().unwrap_or(&nothing);
    for change in drive.changes.iter().filter(|change| change.at_step <= step) {
        change.blocked.iter().for_each(|&p| grid.set_blocked(grid.cell(p), true));
        change.freed.iter().for_each(|&p| grid.set_blocked(grid.cell(p), false));
    }
    for track in &drive.tracks {
        let before = timetable(track, step);
        let touches = |at: &Point| at == &robot || scenario.spec.robot.is_some_and(|one| at.distance(robot) <= one.radius);
        let touched = |place: &Option<Point>| place.is_some_and(|centre| square(track, centre, &grid).iter().any(touches));
        let place = before.iter().rev().find(|place| !touched(place)).copied().flatten();
        let cells = place.map_or_else(Vec::new, |centre| square(track, centre, &grid));
        cells.into_iter().for_each(|p| grid.set_blocked(grid.cell(p), true));
    }
    grid.set_blocked(grid.cell(robot), false);
    grid
}

/// Any movement.
fn movement(draws: &mut Draws) -> Movement {
    let moves = draws.one_of(&[Moves::Four, Moves::Eight, Moves::Eight, Moves::Sixteen]);
    Movement { moves, corner_rule: draws.one_of(&CornerRule::ALL) }
}

/// A track that wanders over a map, now and then through its walls.
fn wandering(draws: &mut Draws, grid: &Grid) -> Track {
    let mut at = Point::new(draws.below(grid.width()), draws.below(grid.height()));
    let mut cells = vec![at];
    for _ in 0..draws.below(9) {
        let along = |v: u32, size: u32, draws: &mut Draws| (v + draws.below(3)).saturating_sub(1).min(size - 1);
        at = Point::new(along(at.x, grid.width(), draws), along(at.y, grid.height(), draws));
        cells.push(at);
    }
    let size = draws.one_of(&[1, 1, 2, 3]);
    let at_end = draws.one_of(&[AtEnd::Stay, AtEnd::BackAndForth, AtEnd::Loop, AtEnd::Leave]);
    Track { cells, size, from_step: draws.below(8), steps_per_cell: 1 + draws.below(3), at_end }
}

/// A random map of this side on which walls change and obstacles wander.
pub fn random(side: u32, seed: u32) -> Arc<Scenario> {
    let mut draws = Draws(u64::from(seed));
    let movement = movement(&mut draws);
    let scenario = common::random(side, draws.one_of(&[0.0, 0.15, 0.3]), seed, movement);
    let (mut grid, mut changes, mut at_step) = (scenario.grid.clone(), Vec::new(), 0);
    for _ in 0..draws.below(4) {
        at_step += draws.below(6);
        let cell = Point::new(draws.below(side), draws.below(side));
        let was = grid.is_blocked(grid.cell(cell));
        grid.set_blocked(grid.cell(cell), !was);
        let (blocked, freed) = if was { (vec![], vec![cell]) } else { (vec![cell], vec![]) };
        changes.push(DriveChange { at_step, blocked, freed });
    }
    let tracks: Vec<Track> = (0..1 + draws.below(3)).map(|_| wandering(&mut draws, &scenario.grid)).collect();
    let sight = draws.one_of(&[None, None, Some(0.0), Some(2.5), Some(6.0)]);
    // What rests on the goal, or jumps from its last cell to the first, is left out.
    let fits = |drive: &DriveSpec| drive.check(&scenario.grid, &scenario.spec).is_ok();
    let only = |tracks: Vec<Track>, changes: Vec<DriveChange>| DriveSpec { changes, tracks, sight };
    let tracks = tracks.into_iter().filter(|track| fits(&only(vec![track.clone()], Vec::new()))).collect();
    let changes = if fits(&only(Vec::new(), changes.clone())) { changes } else { Vec::new() };
    with(&scenario, only(tracks, changes))
}
