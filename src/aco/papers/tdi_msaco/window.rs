//! Where an ant may go in one move: the cells within a step of its own that it sees.

use crate::map::{Cell, Point};
use crate::path::line_of_sight;
use crate::planner::held;
use crate::scenario::Scenario;

/// Set once a cell's sight is known; 48 cells at most lie below it.
const KNOWN: u64 = 1 << 63;

/// The cells up to so many columns and rows away from a cell, row by row without the cell itself, each with a bit by its place in that order.
#[derive(Debug, Clone)]
pub struct Window {
    offsets: Vec<(i32, i32)>,
    /// Which of them each cell sees, found when an ant first stands there.
    seen: Vec<u64>,
}

impl Window {
    /// Of a reach of 1 to 3 columns and rows on a map of so many cells.
    pub fn new(reach: u32, cells: usize) -> Self {
        let side = -(reach as i32)..=reach as i32;
        let all = side.clone().flat_map(|dy| side.clone().map(move |dx| (dx, dy)));
        Self { offsets: all.filter(|&offset| offset != (0, 0)).collect(), seen: vec![0; cells] }
    }

    /// Which of its cells one sees from a cell, by bits.
    pub fn look(&self, scenario: &Scenario, from: Cell) -> u64 {
        let at = scenario.grid.point(from);
        let sees = |&(dx, dy): &(i32, i32)| {
            let to = Point::new(at.x.wrapping_add_signed(dx), at.y.wrapping_add_signed(dy));
            scenario.grid.is_free_at(i64::from(at.x) + i64::from(dx), i64::from(at.y) + i64::from(dy))
                && line_of_sight(scenario, at, to)
        };
        (0..).zip(&self.offsets).fold(0, |bits, (bit, offset)| bits | u64::from(sees(offset)) << bit)
    }

    /// The same, looked up only once for each cell.
    pub fn seen_from(&mut self, scenario: &Scenario, from: Cell) -> u64 {
        if self.seen[from as usize] == 0 {
            self.seen[from as usize] = self.look(scenario, from) | KNOWN;
        }
        self.seen[from as usize] & !KNOWN
    }

    /// The cells whose bits are set, in the window's order.
    pub fn cells(&self, width: u32, from: Cell, mut bits: u64) -> impl Iterator<Item = Cell> + use<'_> {
        std::iter::from_fn(move || {
            let (dx, dy) = *self.offsets.get(bits.trailing_zeros() as usize)?;
            bits &= bits - 1;
            Some(from.wrapping_add_signed(dy * width as i32 + dx))
        })
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.offsets) + held(&self.seen)
    }
}
