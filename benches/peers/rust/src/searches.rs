//! The peers, each used as its documentation shows.

use grid_pathfinding::PathingGrid;
use grid_util::grid::ValueGrid;
use grid_util::point::Point;
use pathfinding::prelude::astar;

use crate::map::Map;

/// Finds the length of the shortest path between two cells.
pub trait Search {
    fn length(&mut self, line: [i32; 4]) -> f64;
}

/// A*, eight moves, a diagonal one only where both cells beside it are free.
pub struct Astar {
    map: Map,
}

/// Costs have to be ordered, so lengths are counted in whole parts of a cell.
const CELL: f64 = (1u64 << 32) as f64;
const STRAIGHT: u64 = 1 << 32;
const DIAGONAL: u64 = (CELL * std::f64::consts::SQRT_2) as u64;

impl Astar {
    pub fn new(map: Map) -> Self {
        Self { map }
    }

    fn steps(&self, (x, y): (i32, i32)) -> impl Iterator<Item = ((i32, i32), u64)> + '_ {
        const STEPS: [(i32, i32); 8] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
        let free = move |dx, dy| self.map.is_free(x + dx, y + dy);
        let allowed = move |&(dx, dy): &(i32, i32)| free(dx, dy) && (dx == 0 || dy == 0 || (free(dx, 0) && free(0, dy)));
        STEPS.into_iter().filter(allowed).map(move |(dx, dy)| {
            let cost = if dx == 0 || dy == 0 { STRAIGHT } else { DIAGONAL };
            ((x + dx, y + dy), cost)
        })
    }
}

/// The length on an open map.
fn octile((x, y): (i32, i32), (to_x, to_y): (i32, i32)) -> u64 {
    let (dx, dy) = (x.abs_diff(to_x), y.abs_diff(to_y));
    u64::from(dx.min(dy)) * DIAGONAL + u64::from(dx.abs_diff(dy)) * STRAIGHT
}

impl Search for Astar {
    fn length(&mut self, [x, y, to_x, to_y]: [i32; 4]) -> f64 {
        let goal = (to_x, to_y);
        let found = astar(&(x, y), |&at| self.steps(at), |&at| octile(at, goal), |&at| at == goal);
        found.map_or(f64::INFINITY, |(_, cost)| cost as f64 / CELL)
    }
}

/// Jump point search; diagonal steps pass corners.
pub struct JumpPoints {
    grid: PathingGrid,
}

impl JumpPoints {
    /// Its preparations are made once a map and are not timed.
    pub fn new(map: &Map) -> Self {
        let mut grid = PathingGrid::new(map.width as usize, map.height as usize, false);
        for (x, y) in (0..map.height).flat_map(|y| (0..map.width).map(move |x| (x, y))) {
            if !map.is_free(x, y) {
                grid.set(x, y, true);
            }
        }
        grid.generate_components();
        Self { grid }
    }
}

impl Search for JumpPoints {
    fn length(&mut self, [x, y, to_x, to_y]: [i32; 4]) -> f64 {
        let way = self.grid.get_waypoints_single_goal(Point::new(x, y), Point::new(to_x, to_y), false);
        let leg = |from: &Point, to: &Point| octile((from.x, from.y), (to.x, to.y)) as f64 / CELL;
        way.map_or(f64::INFINITY, |way| way.windows(2).map(|pair| leg(&pair[0], &pair[1])).sum())
    }
}
