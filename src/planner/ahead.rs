//! A look ahead: ants of a run some moves further on, while the run itself stands where it is.
//!
//! No ant of a run can really go on alone: where ants change trails as they go, the others would meet trails that are not theirs, and the run
//! would be another one. So the look goes ahead on a copy ([`Snapshot`](super::Snapshot)), with all ants, and shows one of them. What
//! it shows is what the run does later, bit for bit.

use super::{Fate, Granularity, Planner, Turn, Walked};
use crate::map::Cell;

/// A copy of a run that stood at the end of an iteration, some moves into the next one.
pub struct Ahead {
    planner: Box<dyn Planner>,
    /// The iteration at whose end the copy was made.
    from: u32,
    moves: u32,
}

impl Ahead {
    /// Looks ahead from a planner that stands between two iterations; it stays as it is.
    pub fn of(planner: &dyn Planner) -> Self {
        Self { from: planner.effort().iterations, planner: planner.snapshot(), moves: 0 }
    }

    /// On until so many moves are made of the iteration, or it is over; the moves made. It never goes back.
    pub fn go_to(&mut self, moves: u32) -> u32 {
        while self.moves < moves && !self.is_over() {
            self.planner.advance(Granularity::Move);
            self.moves += 1;
        }
        self.moves
    }

    /// The iteration at whose end it began.
    pub fn from(&self) -> u32 {
        self.from
    }

    /// Moves made.
    pub fn moves(&self) -> u32 {
        self.moves
    }

    /// Whether the iteration has ended, and with it the walks of all its ants.
    pub fn is_over(&self) -> bool {
        self.planner.effort().iterations > self.from || self.planner.status().is_finished()
    }

    /// An ant where it stands, with its next move; none where there is no such ant.
    pub fn turn(&self, ant: u32) -> Option<Turn> {
        if self.is_over() { self.planner.ant(ant).map(Turn::over) } else { self.planner.turn_of(ant) }
    }

    /// Where each ant stands, by number; none for lost ones. Empty before the first move, when all are still to set out.
    pub fn ants(&self) -> Vec<Option<Cell>> {
        if self.moves == 0 {
            return Vec::new();
        }
        let stands = |Walked { way, fate }: Walked| way.last().copied().filter(|_| fate != Fate::Lost);
        (0..).map_while(|number| self.planner.ant(number).map(stands)).collect()
    }
}
