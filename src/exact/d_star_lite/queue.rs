//! A priority queue in which each cell stands at most once, and whose keys may change.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::map::Cell;
use crate::planner::held;

/// k of the paper: compared by f, then by g.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(super) struct Key {
    /// k₁ = min(g, rhs) + h + k_m, in cells.
    pub(super) f: f64,
    /// k₂ = min(g, rhs), in cells.
    pub(super) g: f64,
}

/// Ticket of a cell that does not wait.
const NONE: u32 = 0;

/// A cell that waits, or has waited under a key that it no longer has.
#[derive(Clone, Copy)]
struct Waiting {
    key: Key,
    cell: Cell,
    ticket: u32,
}

impl Ord for Waiting {
    /// Least key first, of equals the first cell.
    fn cmp(&self, other: &Self) -> Ordering {
        other.key.f.total_cmp(&self.key.f).then(other.key.g.total_cmp(&self.key.g)).then(other.cell.cmp(&self.cell))
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

/// The cells that wait. What is outdated stays in the heap until it comes up: a cell's ticket tells which of its places counts.
#[derive(Clone, Default)]
pub(super) struct Queue {
    heap: BinaryHeap<Waiting>,
    /// By cell.
    tickets: Vec<u32>,
    /// The last ticket given.
    last: u32,
}

impl Queue {
    /// Without any of so many cells.
    pub(super) fn new(cells: usize) -> Self {
        Self { heap: BinaryHeap::new(), tickets: vec![NONE; cells], last: NONE }
    }

    /// Has a cell wait under a key, in place of the one it had.
    pub(super) fn set(&mut self, cell: Cell, key: Key) {
        if self.last == u32::MAX {
            self.number_anew();
        }
        self.last += 1;
        self.tickets[cell as usize] = self.last;
        self.heap.push(Waiting { key, cell, ticket: self.last });
    }

    /// Lets a cell wait no longer, if it does.
    pub(super) fn remove(&mut self, cell: Cell) {
        self.tickets[cell as usize] = NONE;
    }

    /// The cell with the least key.
    pub(super) fn top(&mut self) -> Option<(Cell, Key)> {
        while let Some(&Waiting { key, cell, ticket }) = self.heap.peek() {
            if self.tickets[cell as usize] == ticket {
                return Some((cell, key));
            }
            self.heap.pop();
        }
        None
    }

    /// Tickets from 1 on, once all are given: a robot may drive for long.
    #[cold]
    fn number_anew(&mut self) {
        let mut waiting = std::mem::take(&mut self.heap).into_vec();
        waiting.retain(|w| self.tickets[w.cell as usize] == w.ticket);
        self.last = NONE;
        for w in &mut waiting {
            self.last += 1;
            (w.ticket, self.tickets[w.cell as usize]) = (self.last, self.last);
        }
        self.heap = waiting.into();
    }

    /// What it holds, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.heap.capacity() * size_of::<Waiting>() + held(&self.tickets)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(f: f64, g: f64) -> Key {
        Key { f, g }
    }

    fn cells(mut queue: Queue) -> Vec<Cell> {
        std::iter::from_fn(|| {
            let (cell, _) = queue.top()?;
            queue.remove(cell);
            Some(cell)
        })
        .collect()
    }

    #[test]
    fn the_least_key_comes_first_and_each_cell_once() {
        let mut queue = Queue::new(5);
        for (cell, f, g) in [(3, 2.0, 1.0), (1, 2.0, 0.0), (4, 1.0, 9.0), (0, 2.0, 1.0), (2, 5.0, 0.0)] {
            queue.set(cell, key(f, g));
        }
        assert_eq!(cells(queue.clone()), [4, 1, 0, 3, 2]);
        queue.set(4, key(7.0, 0.0));
        queue.set(2, key(0.5, 0.0));
        queue.remove(1);
        queue.remove(1);
        assert_eq!((queue.top(), cells(queue.clone())), (Some((2, key(0.5, 0.0))), vec![2, 0, 3, 4]));
        queue.last = u32::MAX;
        queue.set(1, key(0.0, 0.0));
        assert_eq!((queue.last, cells(queue)), (5, vec![1, 2, 0, 3, 4]));
    }
}
