//! One ant: where it is, how it came there, which cells it has visited, and its own random stream.

use crate::map::{Cell, DIRECTIONS, Direction, MoveSet, counted_length, is_diagonal, opposite};
use crate::planner::{Fate, held};
use crate::rng::Stream;

use super::dead_end::DeadEnd;

/// The tabu list as one bit a cell, on a map with a border of one cell, so that the eight neighbours of any cell are three loads.
#[derive(Debug, Clone)]
pub struct Tabu {
    bits: Vec<u8>,
    /// Bits per row.
    stride: u32,
    /// What to add to a bit position for each direction.
    delta: [i32; DIRECTIONS],
}

impl Tabu {
    fn new(width: u32, height: u32) -> Self {
        let stride = width + 2;
        // Three spare bytes: the last row is read two bytes at a time.
        let bytes = (u64::from(stride) * u64::from(height + 2)).div_ceil(8) as usize + 3;
        let delta = crate::map::OFFSETS.map(|(dx, dy)| dy * stride as i32 + dx);
        Self { bits: vec![0; bytes], stride, delta }
    }

    /// Bit position of a cell.
    fn position(&self, width: u32, c: Cell) -> u32 {
        (c / width + 1) * self.stride + c % width + 1
    }

    #[inline(always)]
    fn insert(&mut self, position: u32) {
        self.bits[(position >> 3) as usize] |= 1 << (position & 7);
    }

    #[inline(always)]
    fn three(&self, position: u32) -> u32 {
        let byte = (position >> 3) as usize;
        let pair = u32::from(self.bits[byte]) | u32::from(self.bits[byte + 1]) << 8;
        pair >> (position & 7) & 0b111
    }

    /// Which of the eight neighbours are on the list, as bits by direction.
    #[inline(always)]
    fn around(&self, position: u32) -> u8 {
        let above = self.three(position - self.stride - 1);
        let beside = self.three(position - 1);
        let below = self.three(position + self.stride - 1);
        (above | (beside & 1) << 3 | (beside >> 2) << 4 | below << 5) as u8
    }
}

/// An ant of a colony.
#[derive(Debug, Clone)]
pub struct Ant {
    fate: Fate,
    cell: Cell,
    position: u32,
    moves: u32,
    steps: Vec<Direction>,
    /// How many of the steps are diagonal.
    diagonals: u32,
    /// Length of its way over the ground of a terrain, in cells; 0 on a plane, where steps are counted.
    over_ground: f64,
    /// Bit positions that were left by backtracking and are still on the tabu list.
    abandoned: Vec<u32>,
    tabu: Tabu,
    /// Its random stream.
    pub stream: Stream,
}

/// What limits every walk of a colony.
#[derive(Debug, Clone, Copy)]
pub struct Walk<'a> {
    /// The allowed steps.
    pub moves: &'a MoveSet,
    /// Where ants are to arrive.
    pub goal: Cell,
    /// What to do when no step is left.
    pub dead_end: DeadEnd,
    /// Cap on an ant's moves.
    pub max_moves: u32,
}

impl Ant {
    /// An ant of a colony on a map of this size; it begins to walk by [`Ant::begin`].
    pub fn new(width: u32, height: u32, stream: Stream) -> Self {
        let tabu = Tabu::new(width, height);
        Self {
            fate: Fate::Lost,
            cell: 0,
            position: 0,
            moves: 0,
            steps: Vec::new(),
            diagonals: 0,
            over_ground: 0.0,
            abandoned: Vec::new(),
            tabu,
            stream,
        }
    }

    /// Puts the ant on the start with an empty tabu list.
    pub fn begin(&mut self, width: u32, start: Cell, stream: Stream) {
        self.clear_tabu();
        self.position = self.tabu.position(width, start);
        self.tabu.insert(self.position);
        self.cell = start;
        self.moves = 0;
        self.diagonals = 0;
        self.over_ground = 0.0;
        self.steps.clear();
        self.stream = stream;
        self.fate = Fate::Walking;
    }

    /// Undoes the marks of the last walk only: a walk is short beside the map.
    fn clear_tabu(&mut self) {
        let mut position = self.position;
        self.tabu.bits[(position >> 3) as usize] = 0;
        for &d in self.steps.iter().rev() {
            position = position.wrapping_add_signed(self.tabu.delta[opposite(d) as usize]);
            self.tabu.bits[(position >> 3) as usize] = 0;
        }
        for &position in &self.abandoned {
            self.tabu.bits[(position >> 3) as usize] = 0;
        }
        self.abandoned.clear();
    }

    /// What became of it.
    #[inline(always)]
    pub fn fate(&self) -> Fate {
        self.fate
    }

    /// Where it is.
    #[inline(always)]
    pub fn cell(&self) -> Cell {
        self.cell
    }

    /// Its way from the start, without what it took back.
    pub fn steps(&self) -> &[Direction] {
        &self.steps
    }

    /// Moves so far, steps back included.
    pub fn moves(&self) -> u32 {
        self.moves
    }

    /// Length of its way so far in cells, without what it took back.
    pub fn walked(&self) -> f64 {
        if self.over_ground > 0.0 {
            self.over_ground
        } else {
            counted_length(self.steps.len() as u32 - self.diagonals, self.diagonals)
        }
    }

    /// Length of its way in cells, once it has arrived.
    pub fn length(&self) -> Option<f64> {
        (self.fate == Fate::Arrived).then(|| self.walked())
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.steps) + held(&self.abandoned) + held(&self.tabu.bits)
    }

    /// Which of the eight neighbours it has visited, as bits by direction.
    #[inline(always)]
    pub fn visited(&self) -> u8 {
        self.tabu.around(self.position)
    }

    /// One move: the chosen step, or what the colony does at a dead end.
    #[inline(always)]
    pub fn go(&mut self, walk: &Walk, step: Option<Direction>) {
        self.moves += 1;
        match step {
            Some(d) => self.step(walk, d),
            None => self.at_dead_end(walk),
        }
        if self.moves >= walk.max_moves && self.fate == Fate::Walking {
            self.fate = Fate::Lost;
        }
    }

    #[inline(always)]
    fn step(&mut self, walk: &Walk, d: Direction) {
        self.steps.push(d);
        self.diagonals += u32::from(is_diagonal(d));
        if walk.moves.relief().is_some() {
            self.over_ground += walk.moves.length(self.cell, d);
        }
        self.cell = walk.moves.step(self.cell, d);
        self.position = self.position.wrapping_add_signed(self.tabu.delta[d as usize]);
        self.tabu.insert(self.position);
        if self.cell == walk.goal {
            self.fate = Fate::Arrived;
            if walk.moves.relief().is_some() {
                self.over_ground = self.summed(walk.moves);
            }
        }
    }

    /// Length of its way over the ground, from the start on: what steps taken back have left behind by rounding is gone.
    #[inline(never)]
    fn summed(&self, moves: &MoveSet) -> f64 {
        let mut at = self.cell;
        for &d in self.steps.iter().rev() {
            at = moves.step(at, opposite(d));
        }
        let mut sum = 0.0;
        for &d in &self.steps {
            sum += moves.length(at, d);
            at = moves.step(at, d);
        }
        sum
    }

    #[inline(always)]
    fn at_dead_end(&mut self, walk: &Walk) {
        match (walk.dead_end, self.steps.pop()) {
            (DeadEnd::Backtrack, Some(d)) => {
                self.abandoned.push(self.position);
                self.diagonals -= u32::from(is_diagonal(d));
                let back = opposite(d);
                self.cell = walk.moves.step(self.cell, back);
                if walk.moves.relief().is_some() {
                    self.over_ground -= walk.moves.length(self.cell, d);
                }
                self.position = self.position.wrapping_add_signed(self.tabu.delta[back as usize]);
            }
            (DeadEnd::Die, Some(d)) => {
                self.steps.push(d);
                self.fate = Fate::Lost;
            }
            (_, None) => self.fate = Fate::Lost,
        }
    }
}
