//! What a colony by slices works with: ants, trails, and what ants see, made at the first step.

use super::colony::{Numbers, Rules};
use super::trails::RowTrails;
use crate::aco::dead_end::DeadEnd;
use crate::aco::terrain::walk::{Walker, combine, gather, select};
use crate::aco::weights::{FLOOR, power};
use crate::map::{Cell, Slices, Way};
use crate::planner::held;
use crate::rng::Streams;

/// No row has been computed for this place.
const NONE: u32 = u32::MAX;

/// (η/η_max)^β of every step, kept by place from the first time that an ant stands there; 0 for steps that are not feasible.
#[derive(Clone)]
struct Sight {
    row_of: Vec<u32>,
    seen: Vec<f32>,
}

impl Sight {
    /// The row of a place.
    #[inline(always)]
    fn row<R: Rules>(&mut self, rules: &R, beta: f64, slices: &Slices, place: Cell) -> &[f32] {
        if self.row_of[place as usize] == NONE {
            self.row_of[place as usize] = (self.seen.len() / slices.directions()) as u32;
            self.seen.extend(seen(rules, beta, slices, place));
        }
        let first = self.row_of[place as usize] as usize * slices.directions();
        &self.seen[first..first + slices.directions()]
    }
}

/// (η/η_max)^β of every step from a place; a feasible one keeps at least a floor.
pub(super) fn seen<R: Rules>(rules: &R, beta: f64, slices: &Slices, place: Cell) -> Vec<f32> {
    let eta = |k| slices.step(place, k, Way::Forward).map_or(0.0, |to| rules.eta(slices, place, to));
    let row: Vec<f64> = (0..slices.directions()).map(eta).collect();
    let largest = row.iter().fold(0.0f64, |m, &e| if e > m { e } else { m });
    row.iter().map(|&e| if e > 0.0 { (power(e / largest, beta) as f32).max(FLOOR) } else { 0.0 }).collect()
}

/// Where the trail of a step lies: on the place that it leads to, or on the step.
#[inline(always)]
pub fn slot<R: Rules>(from: Cell, k: usize, to: Cell) -> (Cell, usize) {
    if R::ON_PLACES { (to, 0) } else { (from, k) }
}

/// What a step adds to a place's number.
pub(super) fn deltas(slices: &Slices) -> Vec<i32> {
    let onward = if slices.at(slices.goal()).0 > slices.at(slices.start()).0 { 1 } else { -1 };
    let row = slices.place(0, 1, 0) as i32;
    let delta = |k| {
        let (dy, dh) = slices.offset(k);
        dy * row + dh * slices.area() as i32 + onward
    };
    (0..slices.directions()).map(delta).collect()
}

/// τ_ij^α·η_ij^β of every step of an ant; 0 for steps that are infeasible or tabu.
#[inline(always)]
pub(super) fn weigh<R: Rules>(ant: &Walker, seen: &[f32], deltas: &[i32], trails: &RowTrails, alpha: f64, weights: &mut [f32]) {
    match trails.row(ant.place()) {
        _ if R::ON_PLACES => gather(ant, seen, deltas, weights, |to, _| trails.get(to, 0)),
        Some(row) => gather(ant, seen, deltas, weights, |_, k| row[k]),
        None => gather(ant, seen, deltas, weights, |_, _| trails.elsewhere()),
    }
    combine(weights, seen, alpha);
}

/// Of a colony at work.
#[derive(Clone)]
pub(super) struct Tables {
    pub(super) trails: RowTrails,
    sight: Sight,
    pub(super) ants: Vec<Walker>,
    deltas: Vec<i32>,
    /// Of the steps of the ant at work.
    weights: Vec<f32>,
}

impl Tables {
    pub(super) fn new<R: Rules>(rules: &R, slices: &Slices, ants: u32, streams: Streams) -> Self {
        let places = slices.places();
        Self {
            trails: first_trails(rules, slices),
            sight: Sight { row_of: vec![NONE; places], seen: Vec::new() },
            ants: (0..ants).map(|k| Walker::new(places, streams.ant(0, k))).collect(),
            deltas: deltas(slices),
            weights: vec![0.0; slices.directions()],
        }
    }

    /// What they hold, in bytes.
    pub(super) fn bytes(&self) -> usize {
        let ants = held(&self.ants) + self.ants.iter().map(Walker::bytes).sum::<usize>();
        let sight = held(&self.sight.row_of) + held(&self.sight.seen);
        ants + sight + self.trails.bytes() + held(&self.deltas) + held(&self.weights)
    }

    /// One move of one ant.
    #[inline(always)]
    pub(super) fn move_one<R: Rules>(&mut self, rules: &R, numbers: &Numbers, slices: &Slices, k: usize) {
        let ant = &mut self.ants[k];
        let from = ant.place();
        let seen = self.sight.row(rules, numbers.selection.beta, slices, from);
        weigh::<R>(ant, seen, &self.deltas, &self.trails, numbers.selection.alpha, &mut self.weights);
        let Some(step) = select(&self.weights, numbers.q0, &mut ant.stream) else {
            match numbers.walk.dead_end {
                DeadEnd::Backtrack => drop(ant.step_back()),
                DeadEnd::Die => ant.lose(),
            }
            return;
        };
        let to = from.wrapping_add_signed(self.deltas[step]);
        ant.step(to);
        rules.on_move(&mut self.trails, slices, (from, step, to));
        if to == slices.goal() {
            ant.arrive_alone(slices.value(ant.list()));
        }
    }
}

/// τ before the first iteration.
pub(super) fn first_trails<R: Rules>(rules: &R, slices: &Slices) -> RowTrails {
    let width = if R::ON_PLACES { 1 } else { slices.directions() };
    RowTrails::new(slices.places(), width, rules.initial_trail(slices))
}
