//! Ants side by side: while one waits for memory, the others move. By the rules of [`super::lane_rules`] four share 128-bit lanes, and two
//! such groups go in turns; with the very same numbers as one ant at a time.
//!
//! Every lane sums its weights in the same order, draws from its own ant's stream and compares in the same way as a lone ant; so which lane
//! an ant walks in, and beside whom, changes nothing. An ant that has ended is replaced by the next one that waits; the last ones finish
//! alone.

use wide::{bytemuck::cast, f32x4, i16x8, u8x16, u32x4};

use super::ant::{Ant, Walk};
use super::draws::Draws;
use super::lane_rules::{Rule, Sums};
use super::selection::left;
use super::tabu::Place;
use super::trails::Row;
use super::weights::Weights;
use crate::map::{Cell, DIRECTIONS, Direction};
use crate::planner::Fate;

/// Ants in a group.
const LANES: usize = 4;

/// Ants under way at once: two groups.
const ABREAST: usize = 2 * LANES;

/// Steps of a group that are written down together.
const TRACE: usize = 64;

/// Lets all walking ants walk to their end, or to where they have to wait. One copy for all variants that select by the same rule.
#[inline(never)]
pub(super) fn walk_all<W: Weights, R: Rule>(weights: &mut W, walk: &Walk, ants: &mut [Ant], rule: R) {
    // The opening build must stay small.
    if !cfg!(feature = "whole") {
        return walk_all_by(weights, walk, ants, |row, ant| rule.choose_one(row, &mut ant.stream));
    }
    let mut waiting = ants.iter_mut().filter(|a| a.is_ready());
    let mut lanes: Vec<&mut Ant> = Vec::with_capacity(ABREAST);
    loop {
        lanes.extend(waiting.by_ref().take(ABREAST - lanes.len()));
        match lanes.len() {
            0 => break,
            ABREAST => walk_abreast::<W, R, 2>(weights, walk, &mut lanes, rule),
            count if count >= LANES => walk_abreast::<W, R, 1>(weights, walk, &mut lanes, rule),
            _ => lanes.iter_mut().for_each(|ant| {
                ant.count(walk);
                to_the_end(weights, walk, ant, |row, ant| rule.choose_one(row, &mut ant.stream));
            }),
        }
        lanes.iter_mut().filter(|a| a.fate() != Fate::Walking).for_each(|ant| ant.count(walk));
        lanes.retain(|a| a.is_ready());
    }
}

/// The same by another rule: four ants in turns, each by itself.
pub(super) fn walk_all_by<W: Weights>(
    weights: &mut W,
    walk: &Walk,
    ants: &mut [Ant],
    choose: impl Fn(&Row, &mut Ant) -> Option<Direction> + Copy,
) {
    let mut waiting = ants.iter_mut().filter(|a| a.is_ready());
    let mut lanes: Vec<&mut Ant> = waiting.by_ref().take(LANES).collect();
    while let Ok(abreast) = <&mut [&mut Ant; LANES]>::try_from(lanes.as_mut_slice()) {
        while abreast.iter().all(|a| a.is_ready()) {
            for ant in abreast.iter_mut() {
                move_one(weights, walk, ant, choose);
            }
        }
        lanes.retain(|a| a.is_ready());
        lanes.extend(waiting.by_ref().take(LANES - lanes.len()));
    }
    lanes.iter_mut().for_each(|ant| to_the_end(weights, walk, ant, choose));
}

fn to_the_end<W: Weights>(weights: &mut W, walk: &Walk, ant: &mut Ant, choose: impl Fn(&Row, &mut Ant) -> Option<Direction>) {
    while ant.is_ready() {
        move_one(weights, walk, ant, &choose);
    }
}

/// One move of one ant; the step it took, if it was one forward.
#[inline(always)]
pub(super) fn move_one<W: Weights>(
    weights: &mut W,
    walk: &Walk,
    ant: &mut Ant,
    choose: impl Fn(&Row, &mut Ant) -> Option<Direction>,
) -> Option<Direction> {
    let seen = ant.look_around();
    loop {
        let step = choose(&cast(left(weights.row(ant.cell()), seen)), ant);
        if step.is_none() && weights.learn(ant.cell()) {
            continue;
        }
        ant.waits = step.is_none() && !weights.knows(ant.cell());
        if !ant.waits {
            ant.go(walk, step);
        }
        return step;
    }
}

/// Moves the first four or eight of these ants until one of them has ended.
#[inline(always)]
fn walk_abreast<W: Weights, R: Rule, const GROUPS: usize>(weights: &mut W, walk: &Walk, lanes: &mut [&mut Ant], rule: R) {
    let (fours, _) = lanes.as_chunks_mut::<LANES>();
    let Some(Ok(fours)) = fours.get_mut(..GROUPS).map(<&mut [_; GROUPS]>::try_from) else { return };
    // Whoever walks makes a move, under any cap.
    let left = |ant: &&mut Ant| walk.max_moves.saturating_sub(ant.moves()).max(1);
    let most = fours.iter().flatten().map(left).min().unwrap_or(0);
    let mut groups: [Group; GROUPS] = std::array::from_fn(|g| Group::of(&fours[g]));
    let (mut made, mut ended) = (0, false);
    while made < most && !ended {
        made += 1;
        for (group, ants) in groups.iter_mut().zip(fours.iter_mut()) {
            ended |= group.go(weights, walk, ants, rule);
        }
    }
    for (group, ants) in groups.into_iter().zip(fours) {
        group.leave(walk, ants, made);
    }
}

/// Four ants under way: where they are, and their streams.
struct Group {
    cells: [Cell; LANES],
    places: [Place; LANES],
    draws: Draws,
    /// Who has stepped onto the goal.
    arrived: [bool; LANES],
    /// The last steps of all lanes, a byte each, which the ants do not have yet.
    trace: [u32; TRACE],
    traced: usize,
    /// From where on the trace is a lane's own.
    from: [usize; LANES],
    /// Turns in which a lane has not moved, for its weights had not been learnt.
    waited: [u32; LANES],
}

impl Group {
    fn of(ants: &[&mut Ant; LANES]) -> Self {
        let (cells, places) = (each(|k| ants[k].cell), each(|k| ants[k].place));
        let draws = Draws::of(each(|k| &ants[k].stream));
        Self { cells, places, draws, arrived: [false; LANES], trace: [0; TRACE], traced: 0, from: [0; LANES], waited: [0; LANES] }
    }

    /// One move of each; true when one of them has ended. A lane whose weights are all 0 is at a dead end and draws nothing.
    #[inline(always)]
    fn go<W: Weights, R: Rule>(&mut self, weights: &mut W, walk: &Walk, ants: &mut [&mut Ant; LANES], rule: R) -> bool {
        let rows = self.weights(weights, ants);
        let sums = Sums::of(&rows);
        let chosen = rule.choose(&rows, &sums, &mut self.draws);
        if self.traced == TRACE {
            self.hand_over(ants);
        }
        self.trace[self.traced % TRACE] = packed(chosen);
        self.traced += 1;
        let steps = chosen.to_array();
        let mut ended = false;
        if sums.all_alive {
            for k in 0..LANES {
                ended |= self.step(walk, ants[k], k, steps[k]);
            }
            return ended;
        }
        let alive = sums.alive.to_array();
        for k in 0..LANES {
            ended |=
                if alive[k] != 0 { self.step(walk, ants[k], k, steps[k]) } else { self.turn_back(weights, walk, ants[k], k) };
        }
        ended
    }

    /// The weights of the steps that are left, by direction, for all lanes. The cells are marked, as by [`Ant::look_around`].
    #[inline(always)]
    fn weights<W: Weights>(&mut self, weights: &mut W, ants: &mut [&mut Ant; LANES]) -> [f32x4; DIRECTIONS] {
        let (mut low, mut high) = ([f32x4::ZERO; LANES], [f32x4::ZERO; LANES]);
        for k in 0..LANES {
            let seen = ants[k].tabu.insert(self.places[k]);
            [low[k], high[k]] = left(weights.row(self.cells[k]), seen);
        }
        let ([a, b, c, d], [e, f, g, h]) = (f32x4::transpose(low), f32x4::transpose(high));
        [a, b, c, d, e, f, g, h]
    }

    /// True on the goal.
    #[inline(always)]
    fn step(&mut self, walk: &Walk, ant: &Ant, k: usize, step: u32) -> bool {
        let d = step as Direction & 7;
        self.cells[k] = walk.moves.step(self.cells[k], d);
        self.places[k] = ant.tabu.step(self.places[k], d);
        let is_there = self.cells[k] == walk.goal;
        if is_there {
            self.arrived[k] = true;
        }
        is_there
    }

    /// In place of the step that was traced last, where no weight was found: what the colony does at a dead end; or nothing yet, where the
    /// weights had not been learnt. True when that is the end.
    #[inline(never)]
    fn turn_back<W: Weights>(&mut self, weights: &mut W, walk: &Walk, ant: &mut Ant, k: usize) -> bool {
        take_over(ant, &self.trace[self.from[k]..self.traced - 1], k);
        self.from[k] = self.traced;
        weights.learn(self.cells[k]);
        let [low, high] = left(weights.row(self.cells[k]), ant.tabu.around(self.places[k]));
        ant.waits = !weights.knows(self.cells[k]);
        if ant.waits || (low + high).simd_gt(f32x4::ZERO).any() {
            self.waited[k] += 1;
            return ant.waits;
        }
        (ant.cell, ant.place) = (self.cells[k], self.places[k]);
        ant.at_dead_end(walk);
        (self.cells[k], self.places[k]) = (ant.cell, ant.place);
        ant.fate != Fate::Walking
    }

    /// Gives the ants their steps.
    #[inline(never)]
    fn hand_over(&mut self, ants: &mut [&mut Ant; LANES]) {
        for (k, ant) in ants.iter_mut().enumerate() {
            take_over(ant, &self.trace[self.from[k]..self.traced], k);
        }
        (self.traced, self.from) = (0, [0; LANES]);
    }

    /// Gives the ants all that they have come to.
    #[inline(never)]
    fn leave(mut self, walk: &Walk, ants: &mut [&mut Ant; LANES], made: u32) {
        self.hand_over(ants);
        for (k, stream) in self.draws.streams().into_iter().enumerate() {
            ants[k].stream = stream;
            ants[k].stand(walk, self.cells[k], self.places[k], made - self.waited[k]);
            if self.arrived[k] {
                ants[k].fate = Fate::Arrived;
            }
        }
    }
}

/// Four small numbers as four bytes.
#[inline(always)]
fn packed(numbers: u32x4) -> u32 {
    let words = i16x8::from_i32x8_saturate(cast([numbers, numbers]));
    cast::<u8x16, [u32; 4]>(u8x16::narrow_i16x8(words, words))[0]
}

#[inline(never)]
fn take_over(ant: &mut Ant, trace: &[u32], lane: usize) {
    ant.steps.extend(trace.iter().map(|steps| (steps >> (8 * lane)) as Direction));
}

fn each<T>(of: impl FnMut(usize) -> T) -> [T; LANES] {
    std::array::from_fn(of)
}
