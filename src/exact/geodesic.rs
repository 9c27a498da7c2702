//! Lengths of the shortest ways of a point among the obstacles from one cell to many: Dijkstra or A* over the corners at which such a way may
//! bend, found by looking on from each corner round its obstacle only (the taut successors of Oh and Leong, "Edge N-Level Sparse Visibility
//! Graphs", SoCS 2017, <https://arxiv.org/abs/1702.01524>, here without a graph that is kept).
//!
//! It is enough to look on from the one way that first reaches a corner with the least length. A cell that lies outside its cone has a way
//! that leaves that corner out and is shorter still; that cell is told of from elsewhere.

use std::collections::BinaryHeap;

use super::best_first::Open;
use super::glance::{Glance, Seen};
use super::obstacles::{Cone, Obstacles, Place, centre, distance};
use crate::map::{Cell, Grid};

/// From where a ray crosses a cell to its centre and back at most, and some rounding. Along a ray the length by it less the least one never
/// falls; so what exceeds a known length at a crossed cell's centre by this much does so everywhere behind it.
pub(super) const ASIDE: f64 = std::f64::consts::SQRT_2 + 1e-6;

/// What is asked of ways from one cell.
pub(super) trait Question {
    /// A lower bound of what a way that bends at this corner has still to go, in cells.
    fn rest(&self, at: Place) -> f64;
    /// Spread of this length or longer are of no interest.
    fn limit(&self) -> f64;
    /// There is a way of this length to a cell: the shortest one is told of, others may be.
    fn reach(&mut self, cell: Cell, length: f64);
    /// Whether the shortest way to a place behind a cell can come by the cell, to whose centre it would be so far by the corner that is looked
    /// from: true where that is not known.
    fn leads_on(&self, cell: Cell, at: Place, length: f64) -> bool;
}

/// The corners that ways have come to.
struct Corners {
    /// Length of the shortest way to each, infinite where none of interest is known.
    lengths: Vec<f64>,
    /// The place before each on that way.
    before: Vec<Place>,
    /// Those from which is still to be looked on.
    open: BinaryHeap<Open>,
}

impl Corners {
    fn new(corners: usize) -> Self {
        Self { lengths: vec![f64::INFINITY; corners], before: vec![(0, 0); corners], open: BinaryHeap::new() }
    }

    /// The next corner to look on from, with the length of the way to it, where that is of interest.
    fn next(&mut self, limit: f64) -> Option<(usize, f64)> {
        let lengths = &self.lengths;
        let is_up_to_date = |open: &Open| open.g <= lengths[open.state as usize];
        let next = std::iter::from_fn(|| self.open.pop()).find(is_up_to_date)?;
        (next.f < limit).then_some((next.state as usize, next.g))
    }
}

/// A place from which is looked around.
struct Lookout<'a, Q> {
    place: Place,
    /// Length of the way that leads to it.
    length: f64,
    question: &'a mut Q,
    corners: &'a mut Corners,
}

impl<Q: Question> Seen for Lookout<'_, Q> {
    #[inline]
    fn cell(&mut self, cell: Cell, at: Place, is_seen: bool) -> bool {
        let length = self.length + distance(self.place, at);
        if is_seen {
            self.question.reach(cell, length);
        }
        self.question.leads_on(cell, at, length)
    }

    #[inline]
    fn corner(&mut self, corner: usize, at: Place) {
        let g = self.length + distance(self.place, at);
        let f = g + self.question.rest(at);
        if g < self.corners.lengths[corner] && f < self.question.limit() {
            (self.corners.lengths[corner], self.corners.before[corner]) = (g, self.place);
            self.corners.open.push(Open { state: corner as u32, g, f });
        }
    }
}

/// Asks a question about ways from the centre of a cell. Returns how many cells were looked at.
pub(super) fn spread(map: &Obstacles, grid: &Grid, from: Cell, question: &mut impl Question) -> u64 {
    let (mut corners, mut glance) = (Corners::new(map.corners()), Glance::default());
    let place = centre(grid.point(from));
    question.reach(from, 0.0);
    let mut around = Lookout { place, length: 0.0, question: &mut *question, corners: &mut corners };
    for quadrant in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
        glance.look(map, place, Cone::quadrant(quadrant), &mut around);
    }
    while let Some((corner, length)) = corners.next(question.limit()) {
        let (place, before) = (map.place(corner), corners.before[corner]);
        if let Some(cone) = map.beyond(corner, (place.0 - before.0, place.1 - before.1)) {
            let mut on = Lookout { place, length, question: &mut *question, corners: &mut corners };
            glance.look(map, place, cone, &mut on);
        }
    }
    glance.looked
}

/// How far it is to one cell.
pub(super) struct To {
    goal: Cell,
    at: Place,
    /// Length of the shortest way there, infinite where there is none.
    pub(super) length: f64,
}

impl To {
    pub(super) fn new(grid: &Grid, goal: Cell) -> Self {
        Self { goal, at: centre(grid.point(goal)), length: f64::INFINITY }
    }
}

impl Question for To {
    fn rest(&self, at: Place) -> f64 {
        distance(at, self.at)
    }

    fn limit(&self) -> f64 {
        self.length
    }

    fn reach(&mut self, cell: Cell, length: f64) {
        if cell == self.goal {
            self.length = self.length.min(length);
        }
    }

    fn leads_on(&self, _cell: Cell, at: Place, length: f64) -> bool {
        length + distance(at, self.at) < self.length + ASIDE
    }
}

/// How far it is to every cell.
pub(super) struct Field {
    /// Length of the shortest way to each cell, infinite where there is none.
    pub(super) lengths: Vec<f64>,
}

impl Field {
    pub(super) fn new(cells: usize) -> Self {
        Self { lengths: vec![f64::INFINITY; cells] }
    }
}

impl Question for Field {
    fn rest(&self, _at: Place) -> f64 {
        0.0
    }

    fn limit(&self) -> f64 {
        f64::INFINITY
    }

    #[inline]
    fn reach(&mut self, cell: Cell, length: f64) {
        let least = &mut self.lengths[cell as usize];
        if length < *least {
            *least = length;
        }
    }

    #[inline]
    fn leads_on(&self, cell: Cell, _at: Place, length: f64) -> bool {
        length < self.lengths[cell as usize] + ASIDE
    }
}
