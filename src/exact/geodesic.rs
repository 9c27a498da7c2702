//! Lengths of the shortest ways of a point among the obstacles from one cell to many: Dijkstra or A* over the corners at which such a way may
//! bend, found by looking on from each corner round its obstacle only (the taut successors of Oh and Leong, "Edge N-Level Sparse Visibility
//! Graphs", SoCS 2017, <https://arxiv.org/abs/1702.01524>, here without a graph that is kept).
//!
//! It is enough to look on from the one way that first reaches a corner with the least length. A cell that lies outside its cone has a way
//! that leaves that corner out and is shorter still; that cell is told of from elsewhere.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::glance::{Glance, Seen};
use super::obstacles::{Cone, Obstacles, Place, centre, distance};
use crate::map::{Cell, Grid};

/// What is asked of ways from one cell.
pub(super) trait Question {
    /// A lower bound of what a way that bends at this corner has still to go, in cells.
    fn rest(&self, corner: usize, at: Place) -> f64;
    /// Spread of this length or longer are of no interest.
    fn limit(&self) -> f64;
    /// There is a way of this length to a cell: the shortest one is told of, others may be.
    fn reach(&mut self, cell: Cell, length: f64);
}

/// What a spreading search holds.
#[derive(Debug)]
pub(super) struct Spread {
    /// Length of the shortest way to each corner, infinite where none of interest leads.
    pub(super) corners: Vec<f64>,
    /// The place before each corner.
    before: Vec<Place>,
    /// Cells that were looked at.
    pub(super) looked: u64,
}

/// A corner that waits, by the length of the way on which it lies.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    whole: f64,
    length: f64,
    corner: u32,
}

impl Ord for Waiting {
    /// The shortest first, of equals the first corner.
    fn cmp(&self, other: &Self) -> Ordering {
        other.whole.total_cmp(&self.whole).then(other.length.total_cmp(&self.length)).then(other.corner.cmp(&self.corner))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

/// One place from which is looked around.
struct Lookout<'a, Q> {
    place: Place,
    length: f64,
    question: &'a mut Q,
    found: &'a mut Spread,
    open: &'a mut BinaryHeap<Waiting>,
}

impl<Q: Question> Seen for Lookout<'_, Q> {
    #[inline]
    fn cell(&mut self, cell: Cell, at: Place) {
        self.question.reach(cell, self.length + distance(self.place, at));
    }

    #[inline]
    fn corner(&mut self, corner: usize, at: Place) {
        let length = self.length + distance(self.place, at);
        if length >= self.found.corners[corner] {
            return;
        }
        let whole = length + self.question.rest(corner, at);
        if whole < self.question.limit() {
            (self.found.corners[corner], self.found.before[corner]) = (length, self.place);
            self.open.push(Waiting { whole, length, corner: corner as u32 });
        }
    }
}

/// Asks a question about ways from the centre of a cell.
pub(super) fn spread(map: &Obstacles, grid: &Grid, from: Cell, question: &mut impl Question) -> Spread {
    let mut found = Spread { corners: vec![f64::INFINITY; map.corners()], before: vec![(0, 0); map.corners()], looked: 0 };
    let (mut glance, mut open) = (Glance::default(), BinaryHeap::new());
    let place = centre(grid.point(from));
    question.reach(from, 0.0);
    for quadrant in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
        let mut all = Lookout { place, length: 0.0, question: &mut *question, found: &mut found, open: &mut open };
        glance.into_cone(map, place, Cone::quadrant(quadrant), &mut all);
    }
    while let Some(Waiting { whole, length, corner }) = open.pop() {
        let number = corner as usize;
        if whole >= question.limit() {
            break;
        }
        if length > found.corners[number] {
            continue;
        }
        let (place, before) = (map.place(number), found.before[number]);
        if let Some(cone) = map.beyond(number, (place.0 - before.0, place.1 - before.1)) {
            let mut on = Lookout { place, length, question: &mut *question, found: &mut found, open: &mut open };
            glance.into_cone(map, place, cone, &mut on);
        }
    }
    found.looked = glance.looked;
    found
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
    fn rest(&self, _corner: usize, at: Place) -> f64 {
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
}

/// How far it is to every cell, as far as that is of interest: by a way that is shorter than the limit with what is left to go.
pub(super) struct Field<'a> {
    /// Length of the shortest way to each cell, infinite where none of interest leads.
    pub(super) lengths: Vec<f64>,
    /// What is left to go from each corner; nothing where it is not known.
    pub(super) rest: &'a [f64],
    pub(super) limit: f64,
}

impl Question for Field<'_> {
    fn rest(&self, corner: usize, _at: Place) -> f64 {
        self.rest.get(corner).copied().unwrap_or(0.0)
    }

    fn limit(&self) -> f64 {
        self.limit
    }

    #[inline]
    fn reach(&mut self, cell: Cell, length: f64) {
        let least = &mut self.lengths[cell as usize];
        if length < *least {
            *least = length;
        }
    }
}
