//! One ant: where it is, how it came there, which cells it has visited, and its own random stream.

use crate::map::{Cell, Direction, MoveSet, counted_length, is_diagonal, opposite};
use crate::planner::{Fate, held};
use crate::rng::Stream;

use super::dead_end::DeadEnd;
use super::tabu::{Place, SEEN, Seen, Tabu};

/// An ant of a colony.
#[derive(Debug, Clone)]
pub struct Ant {
    pub(super) fate: Fate,
    /// It walks, but waits for weights that somebody else has to learn.
    pub(super) waits: bool,
    pub(super) cell: Cell,
    pub(super) place: Place,
    moves: u32,
    pub(super) steps: Vec<Direction>,
    /// How many of the steps are diagonal.
    diagonals: u32,
    /// What its way has cost on a terrain or on weighted ground, in cells; 0 on plain ground, where steps are counted.
    over_ground: f64,
    /// Places that were left by backtracking and are still on the tabu list.
    abandoned: Vec<Place>,
    pub(super) tabu: Tabu,
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
            waits: false,
            cell: 0,
            place: tabu.place(width, 0),
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
        self.place = self.tabu.place(width, start);
        self.cell = start;
        self.moves = 0;
        self.diagonals = 0;
        self.over_ground = 0.0;
        self.steps.clear();
        self.stream = stream;
        self.fate = Fate::Walking;
    }

    /// Undoes the marks of the last walk, of a short one beside the map one by one.
    #[inline(never)]
    fn clear_tabu(&mut self) {
        if self.tabu.is_small_beside(self.steps.len() + self.abandoned.len()) {
            self.tabu.clear();
        } else {
            let mut place = self.place;
            self.tabu.remove(place);
            for &d in self.steps.iter().rev() {
                place = self.tabu.step(place, opposite(d));
                self.tabu.remove(place);
            }
            self.abandoned.iter().for_each(|&place| self.tabu.remove(place));
        }
        self.abandoned.clear();
    }

    /// What became of it.
    #[inline(always)]
    pub fn fate(&self) -> Fate {
        self.fate
    }

    /// Whether it can make a move.
    #[inline(always)]
    pub(super) fn is_ready(&self) -> bool {
        self.fate == Fate::Walking && !self.waits
    }

    /// It need not wait any longer.
    pub(super) fn go_on(&mut self) {
        self.waits = false;
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

    /// Length of its way so far in cells, without what it took back; on weighted ground its cost.
    pub fn walked(&self) -> f64 {
        if self.over_ground > 0.0 {
            self.over_ground
        } else {
            counted_length(self.steps.len() as u32 - self.diagonals, self.diagonals)
        }
    }

    /// The same once it has arrived.
    pub fn length(&self) -> Option<f64> {
        (self.fate == Fate::Arrived).then(|| self.walked())
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.steps) + held(&self.abandoned) + self.tabu.bytes()
    }

    /// Which of the eight neighbours it has visited. Its own cell is marked here, before it is left, and not when it is entered: by the time
    /// it is read again the mark has long been written.
    #[inline(always)]
    pub(super) fn look_around(&mut self) -> Seen {
        self.tabu.insert(self.place)
    }

    /// The neighbours that it has visited, as bits by direction.
    pub fn visited(&self) -> u8 {
        let seen = self.tabu.around(self.place);
        (0..).zip(SEEN).fold(0, |bits, (d, bit)| bits | u8::from(seen & bit != 0) << d)
    }

    /// One move: the chosen step, or what the colony does at a dead end.
    #[inline(always)]
    pub fn go(&mut self, walk: &Walk, step: Option<Direction>) {
        self.moves += 1;
        match step {
            Some(d) => self.step(walk, d),
            None => self.go_back(walk),
        }
        if self.moves >= walk.max_moves && self.fate == Fate::Walking {
            self.fate = Fate::Lost;
        }
    }

    /// Stands here after so many moves side by side with others; [`Ant::count`] is to follow.
    #[inline(never)]
    pub(super) fn stand(&mut self, walk: &Walk, cell: Cell, place: Place, made: u32) {
        (self.cell, self.place) = (cell, place);
        self.moves += made;
        // Under a cap below one move an ant still makes one.
        if self.moves >= walk.max_moves.max(1) {
            self.fate = Fate::Lost;
        }
    }

    /// Counts its diagonal steps, and where the ground is not plain what it has cost, which it does not while it walks beside others.
    #[inline(never)]
    pub(super) fn count(&mut self, walk: &Walk) {
        // 255 fit into a byte.
        let diagonals = |steps: &[Direction]| steps.iter().map(|&d| u8::from(is_diagonal(d))).sum::<u8>();
        self.diagonals = self.steps.chunks(255).map(|steps| u32::from(diagonals(steps))).sum();
        if !walk.moves.is_plain() {
            self.over_ground = self.summed(walk.moves);
        }
    }

    #[inline(always)]
    fn step(&mut self, walk: &Walk, d: Direction) {
        self.steps.push(d);
        self.diagonals += u32::from(is_diagonal(d));
        if !walk.moves.is_plain() {
            self.over_ground += walk.moves.length(self.cell, d);
        }
        self.cell = walk.moves.step(self.cell, d);
        self.place = self.tabu.step(self.place, d);
        if self.cell == walk.goal {
            self.fate = Fate::Arrived;
            if !walk.moves.is_plain() {
                self.over_ground = self.summed(walk.moves);
            }
        }
    }

    /// What its way has cost from the start on: what steps taken back have left behind by rounding is gone.
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

    /// Takes its last step back, or ends. The step that was taken back is not counted off.
    #[inline(always)]
    pub(super) fn at_dead_end(&mut self, walk: &Walk) -> Option<Direction> {
        match (walk.dead_end, self.steps.pop()) {
            (DeadEnd::Backtrack, Some(d)) => {
                self.abandoned.push(self.place);
                let back = opposite(d);
                self.cell = walk.moves.step(self.cell, back);
                self.place = self.tabu.step(self.place, back);
                return Some(d);
            }
            (DeadEnd::Die, Some(d)) => {
                self.steps.push(d);
                self.fate = Fate::Lost;
            }
            (_, None) => self.fate = Fate::Lost,
        }
        None
    }

    fn go_back(&mut self, walk: &Walk) {
        let Some(d) = self.at_dead_end(walk) else { return };
        self.diagonals -= u32::from(is_diagonal(d));
        if !walk.moves.is_plain() {
            self.over_ground -= walk.moves.length(self.cell, d);
        }
    }
}
