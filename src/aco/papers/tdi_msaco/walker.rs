//! One ant that goes several cells at a time: its way, where it has been, its random stream.

use rand::Rng;

use crate::aco::dead_end::DeadEnd;
use crate::map::Cell;
use crate::planner::{Fate, Walked, held};
use crate::rng::{Stream, unit_f32};

/// An ant of the colony.
#[derive(Debug, Clone)]
pub struct Walker {
    /// The cells at which it has stood, the start first, without those that it took back.
    way: Vec<Cell>,
    /// One bit a cell: where it has stood, what it took back included.
    been: Vec<u64>,
    moves: u32,
    fate: Fate,
    stream: Stream,
}

impl Walker {
    /// At the start of a map of so many cells.
    pub fn new(cells: usize, start: Cell, stream: Stream) -> Self {
        let mut ant = Self { way: Vec::new(), been: vec![0; cells.div_ceil(64)], moves: 0, fate: Fate::Lost, stream };
        let stream = ant.stream.clone();
        ant.begin(start, stream);
        ant
    }

    /// Puts it on the start with another stream.
    pub fn begin(&mut self, start: Cell, stream: Stream) {
        self.been.fill(0);
        self.way.clear();
        (self.moves, self.fate, self.stream) = (0, Fate::Walking, stream);
        self.stand(start);
    }

    fn stand(&mut self, cell: Cell) {
        self.been[cell as usize / 64] |= 1 << (cell % 64);
        self.way.push(cell);
    }

    /// What became of it.
    pub fn fate(&self) -> Fate {
        self.fate
    }

    /// Where it stands; it has stood at the start at least.
    pub fn cell(&self) -> Cell {
        self.way[self.way.len() - 1]
    }

    /// The cells at which it has stood, the start first, without those that it took back.
    pub fn way(&self) -> &[Cell] {
        &self.way
    }

    /// Moves so far, steps back included.
    pub fn moves(&self) -> u32 {
        self.moves
    }

    /// How far it has come.
    pub fn walked(&self) -> Walked {
        Walked { way: self.way.clone(), fate: self.fate }
    }

    /// Whether it has stood at a cell.
    pub fn has_been_at(&self, cell: Cell) -> bool {
        self.been[cell as usize / 64] >> (cell % 64) & 1 == 1
    }

    /// One of the cells that it weighs, each with the probability of its share of all weights; none of none. Weights are above 0.
    pub fn draw(&mut self, options: &[(Cell, f64)]) -> Option<Cell> {
        let &(last, _) = options.last()?;
        let total: f64 = options.iter().map(|&(_, weight)| weight).sum();
        let threshold = f64::from(unit_f32(self.stream.next_u32())) * total;
        let mut sum = 0.0;
        let drawn = options.iter().find(|&&(_, weight)| {
            sum += weight;
            sum > threshold
        });
        Some(drawn.map_or(last, |&(cell, _)| cell))
    }

    /// One move: to a cell, or what is done at a dead end; lost after `most` moves.
    pub fn go(&mut self, to: Option<Cell>, goal: Cell, dead_end: DeadEnd, most: u32) {
        self.moves += 1;
        match to {
            Some(cell) => self.stand(cell),
            None if dead_end == DeadEnd::Backtrack && self.way.len() > 1 => _ = self.way.pop(),
            None => self.fate = Fate::Lost,
        }
        if self.cell() == goal {
            self.fate = Fate::Arrived;
        } else if self.moves >= most {
            self.fate = Fate::Lost;
        }
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.way) + held(&self.been)
    }
}
