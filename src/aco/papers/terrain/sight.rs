//! What ants of one team see: η^β of every step, kept by place from the first time that an ant stands there.
//!
//! As in [`crate::aco::weights`], η is divided by the largest of the place first, and a feasible step keeps at least the same floor.

use super::field::{Field, along, distance};
use super::space::{Place, Space};
use crate::aco::heuristic::AT_GOAL;
use crate::aco::weights::{FLOOR, power};
use crate::map::Way;
use crate::param_choice;
use crate::planner::{Reading, held};

param_choice! {
    /// Which distance an ant sees.
    pub enum Heuristic {
        /// η = 1 / d(j, goal): what the paper's text calls the heuristic
        Goal = "goal",
        /// η = 1 / d_ij, the step's own length: eq. 2 as printed
        Step = "step",
        /// η = 1 / (d_ij + d(j, goal)): both, as in the textbook's program
        Both = "both",
    }
}

/// Eq. 2, the part of η without a force, by the step's length and the distance that is left from its end.
pub fn visibility(heuristic: Heuristic, step: f64, left: f64) -> f64 {
    match heuristic {
        Heuristic::Goal => 1.0 / left.max(AT_GOAL),
        Heuristic::Step => 1.0 / step,
        Heuristic::Both => 1.0 / (step + left),
    }
}

/// The weight of the exponent in iteration `it` (from 1). Repaired ((it_max − it)/it_max)³. Printed, that is a factor of η common to all
/// steps, which cancels in Eq. 1 (and is 0 for all of them in the last iteration); the exponent has none.
pub fn force_weight(reading: Reading, it: u32, budget: u32) -> f64 {
    match reading {
        Reading::Printed => 1.0,
        Reading::Repaired => {
            let part = f64::from(budget.saturating_sub(it)) / f64::from(budget);
            part * part * part
        }
    }
}

/// The second "Eq. 12": a^(weight · F_tot·cos φ).
pub fn force_factor(base: f64, weight: f64, pull: f64) -> f64 {
    libm::exp(libm::log(base) * weight * pull)
}

/// What the ants of a team look at.
#[derive(Debug, Clone, Copy)]
pub struct Eyes {
    /// Which way they go.
    pub way: Way,
    /// Which distance they see.
    pub heuristic: Heuristic,
    /// β.
    pub beta: f64,
    /// The field and a, the base of its power; none where they do not feel it.
    pub force: Option<(Field, f64)>,
}

impl Eyes {
    /// η without the force, and F_tot·cos φ, of a feasible step.
    fn step(&self, space: &impl Space, from: Place, to: Place, k: usize, force: [f64; 3]) -> (f64, f64) {
        let seen = visibility(self.heuristic, space.length(from, to, k), self.left(space, to));
        (seen, along(force, space.position(from), space.position(to)))
    }

    /// The distance from a place to the target, as ants see it.
    pub fn left(&self, space: &impl Space, from: Place) -> f64 {
        distance(space.seen_at(from), space.seen_at(space.target(self.way)))
    }

    fn force_at(&self, space: &impl Space, place: Place) -> [f64; 3] {
        self.force.map_or([0.0; 3], |(field, _)| field.force(space, place))
    }

    /// η of every feasible step from a place, with its end. `left` is [`Eyes::left`], or what is known of it: many steps lead to a place.
    pub fn eta(
        &self,
        space: &impl Space,
        from: Place,
        weight: f64,
        left: impl Fn(Place) -> f64,
    ) -> impl Iterator<Item = (Place, f64)> {
        let (at, force) = (space.position(from), self.force.map(|(_, base)| (self.force_at(space, from), base)));
        (0..space.steps()).filter_map(move |k| {
            let to = space.step(from, k, self.way)?;
            let seen = visibility(self.heuristic, space.length(from, to, k), left(to));
            let pulled = |(force, base)| force_factor(base, weight, along(force, at, space.position(to)));
            Some((to, seen * force.map_or(1.0, pulled)))
        })
    }
}

/// No row has been computed for this place.
const NONE: u32 = u32::MAX;

/// The rows of a team.
#[derive(Debug, Clone)]
pub struct Sight {
    eyes: Eyes,
    steps: usize,
    /// Row by place.
    row_of: Vec<u32>,
    /// (η/η_max)^β of the steps of each row; 0 for infeasible ones.
    seen: Vec<f32>,
    /// The same without the force, and F_tot·cos φ; empty without a force.
    near: Vec<f32>,
    pull: Vec<f32>,
    /// The iteration in which each row of `seen` was computed.
    seen_in: Vec<u32>,
    iteration: u32,
    /// β·ln a·weight of the iteration at work.
    exponent: f64,
}

impl Sight {
    /// Of a space with this many places.
    pub fn new(space: &impl Space, eyes: Eyes) -> Self {
        let row_of = vec![NONE; space.places()];
        let (seen, near, pull, seen_in) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { eyes, steps: space.steps(), row_of, seen, near, pull, seen_in, iteration: 0, exponent: 0.0 }
    }

    /// What these ants look at.
    pub fn eyes(&self) -> &Eyes {
        &self.eyes
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.row_of) + held(&self.seen) + held(&self.near) + held(&self.pull) + held(&self.seen_in)
    }

    /// Another iteration begins, in which the exponent has this weight.
    pub fn begin(&mut self, iteration: u32, weight: f64) {
        self.iteration = iteration;
        self.exponent = self.eyes.force.map_or(0.0, |(_, base)| self.eyes.beta * libm::log(base) * weight);
    }

    /// (η/η_max)^β of every step from a place; 0 for infeasible ones.
    #[inline(always)]
    pub fn row(&mut self, space: &impl Space, place: Place) -> &[f32] {
        let row = self.row_of[place as usize];
        if row == NONE || (self.eyes.force.is_some() && self.seen_in[row as usize] != self.iteration) {
            self.look(space, place);
        }
        let first = self.row_of[place as usize] as usize * self.steps;
        &self.seen[first..first + self.steps]
    }

    /// Computes a row: the first time what does not depend on time, and each time the power of the force.
    #[inline(never)]
    fn look(&mut self, space: &impl Space, place: Place) {
        if self.row_of[place as usize] == NONE {
            self.row_of[place as usize] = self.seen_in.len() as u32;
            self.seen_in.push(0);
            self.survey(space, place);
        }
        if self.eyes.force.is_none() {
            return;
        }
        let row = self.row_of[place as usize] as usize;
        self.seen_in[row] = self.iteration;
        let steps = row * self.steps..(row + 1) * self.steps;
        let (near, pull) = (&self.near[steps.clone()], &self.pull[steps.clone()]);
        let exponent = self.exponent;
        let log = |pull: f32| exponent * f64::from(pull);
        let mut largest = f64::NEG_INFINITY;
        for (&near, &pull) in near.iter().zip(pull) {
            largest = if near > 0.0 && log(pull) > largest { log(pull) } else { largest };
        }
        for (seen, (&near, &pull)) in self.seen[steps].iter_mut().zip(near.iter().zip(pull)) {
            *seen = if near > 0.0 { (near * libm::exp(log(pull) - largest) as f32).max(FLOOR) } else { 0.0 };
        }
    }

    /// Adds a row without the power of the force.
    fn survey(&mut self, space: &impl Space, place: Place) {
        let (eyes, first, force) = (self.eyes, self.seen.len(), self.eyes.force_at(space, place));
        for k in 0..self.steps {
            let step = space.step(place, k, eyes.way).map(|to| eyes.step(space, place, to, k, force));
            let (seen, pull) = step.unwrap_or((0.0, 0.0));
            self.seen.push(seen as f32);
            if eyes.force.is_some() {
                self.pull.push(pull as f32);
            }
        }
        let row = &mut self.seen[first..];
        let largest = f64::from(row.iter().fold(0.0f32, |m, &e| if e > m { e } else { m }));
        for seen in row.iter_mut().filter(|e| **e > 0.0) {
            *seen = (power(f64::from(*seen) / largest, eyes.beta) as f32).max(FLOOR);
        }
        if eyes.force.is_some() {
            self.near.extend_from_slice(&self.seen[first..]);
        }
    }
}
