//! A particle swarm: over cell priorities the seeder of the hybrid that Zhou, Mu, Zhang 2019 compare with, of which they give no formula;
//! by itself the planner `pso` (`pso.rs`), there also over the places of movement by slices.
//!
//! Standard particle swarm with inertia weight: Shi, Eberhart, "A modified particle swarm optimizer", ICEC 1998, 69–73,
//! doi:10.1109/ICEC.1998.699146; the weight falls linearly as in their "Empirical study of particle swarm optimization", CEC 1999,
//! 1945–1950, doi:10.1109/CEC.1999.785511:
//!
//! v ← w·v + c1·r1·(p − x) + c2·r2·(g − x), x ← x + v, r1 and r2 anew for each dimension; |v| ≤ v_max.
//!
//! p is the best position of the particle, g that of the swarm. Particles begin at rest, uniformly in range. One that would leave the range
//! stops at its border (x is set to it, v to 0). There are 40 particles, because the fireworks decode about 40 paths an iteration.

use rand::Rng;

use crate::params;
use crate::planner::{GoalStep, held};
use crate::rng::{Streams, unit_f32};

use super::decode::{DecodeRows, Limits};
use super::explosion::inertia;
use super::population::Population;
use super::search::{Method, Settings};

params! {
    /// What a particle swarm needs.
    pub struct ParticleRows {
        /// particles of the swarm
        particles: u32 = 40, "N", [1..=512], "particles", "our choice: the fireworks decode about 40 paths an iteration";
        /// weight of the old velocity at the beginning
        inertia_start: f64 = 0.9, "w_1", [0.0..=2.0], "", "Shi and Eberhart 1999";
        /// weight of the old velocity in the last iteration
        inertia_end: f64 = 0.4, "w_2", [0.0..=2.0], "", "Shi and Eberhart 1999";
        /// pull of the particle's own best position
        cognitive: f64 = 2.0, "c_1", [0.0..=10.0], "", "Shi and Eberhart 1999";
        /// pull of the swarm's best position
        social: f64 = 2.0, "c_2", [0.0..=10.0], "", "Shi and Eberhart 1999";
        /// largest velocity, as a share of the range
        speed_limit: f64 = 1.0, "v_max", [0.0..=10.0], "× x_max", "Shi and Eberhart 1999: v_max = x_max";
    }
}

/// One dimension's new velocity: w·v + c1·r1·(p − x) + c2·r2·(g − x), cut at ±`limit`; `pulls` are c1·r1 and c2·r2.
pub fn velocity(v: f64, x: f64, best: [f64; 2], weight: f64, pulls: [f64; 2], limit: f64) -> f64 {
    (weight * v + pulls[0] * (best[0] - x) + pulls[1] * (best[1] - x)).clamp(-limit, limit)
}

/// Position and velocity after the move: at one of the limits a particle stops.
pub fn moved(x: f64, v: f64, limits: Limits) -> (f64, f64) {
    let to = x + v;
    if (limits.min..=limits.max).contains(&to) { (to, v) } else { (to.clamp(limits.min, limits.max), 0.0) }
}

/// A particle swarm.
#[derive(Debug, Clone)]
pub struct ParticleSwarm {
    settings: Settings,
    rows: ParticleRows,
    /// Between which values a dimension lies; the dimensions take them in turn.
    limits: [Limits; 2],
    /// The particles' positions are decoded and not yet taken in.
    flown: bool,
    velocities: Vec<f32>,
    /// Each particle's best position, one after the other, and its length.
    own: Vec<f32>,
    own_costs: Vec<f64>,
    /// The particle with the best of these.
    leader: usize,
}

impl ParticleSwarm {
    /// Over cell priorities with these parameters, for so many iterations, and no longer than `stagnation` without a shorter path (0 = all).
    pub fn new(rows: ParticleRows, decoding: DecodeRows, iterations: u32, stagnation: u32) -> Self {
        let mut swarm = Self::within([decoding.limits(); 2], rows, iterations, stagnation);
        swarm.settings.decode_limit = decoding.decode_limit;
        swarm.settings.goal_step = decoding.decode_goal;
        swarm
    }

    /// Over any dimensions, whose values lie between these limits in turn.
    pub fn within(limits: [Limits; 2], rows: ParticleRows, iterations: u32, stagnation: u32) -> Self {
        let (size, most) = (rows.particles, 3 * rows.particles);
        Self {
            settings: Settings { size, most, iterations, stagnation, decode_limit: 0.0, goal_step: GoalStep::Enter },
            rows,
            limits,
            flown: false,
            velocities: Vec::new(),
            own: Vec::new(),
            own_costs: Vec::new(),
            leader: 0,
        }
    }

    /// Takes in what the positions decoded to.
    fn learn(&mut self, population: &Population) {
        let n = population.dimensions();
        if self.own.is_empty() {
            (0..population.len()).for_each(|i| self.own.extend_from_slice(population.position(i)));
            self.velocities = vec![0.0; self.own.len()];
            self.own_costs = population.costs().to_vec();
        }
        for (i, &cost) in population.costs().iter().enumerate() {
            if cost < self.own_costs[i] {
                self.own_costs[i] = cost;
                self.own[i * n..(i + 1) * n].copy_from_slice(population.position(i));
            }
        }
        let costs = &self.own_costs;
        self.leader = (0..costs.len()).reduce(|best, i| if costs[i] < costs[best] { i } else { best }).unwrap_or(0);
    }

    fn fly(&mut self, population: &mut Population, number: u32, streams: Streams) {
        let (n, rows, limits) = (population.dimensions(), self.rows, self.limits);
        let w = inertia(rows.inertia_start, rows.inertia_end, number, self.settings.iterations);
        for i in 0..population.len() {
            let mut stream = streams.ant(number, i as u32);
            let mut draw = || f64::from(unit_f32(stream.next_u32()));
            for ((k, x), limits) in population.position_mut(i).iter_mut().enumerate().zip(limits.into_iter().cycle()) {
                let best = [self.own[i * n + k], self.own[self.leader * n + k]].map(f64::from);
                let pulls = [rows.cognitive * draw(), rows.social * draw()];
                let v = &mut self.velocities[i * n + k];
                let faster = velocity(f64::from(*v), f64::from(*x), best, w, pulls, rows.speed_limit * limits.max);
                let (to, left) = moved(f64::from(*x), faster, limits);
                (*x, *v) = (to as f32, left as f32);
            }
        }
        population.forget_costs();
    }
}

impl Method for ParticleSwarm {
    fn settings(&self) -> Settings {
        self.settings
    }

    fn bytes(&self) -> usize {
        held(&self.velocities) + held(&self.own) + held(&self.own_costs)
    }

    fn propose(&mut self, population: &mut Population, number: u32, streams: Streams) -> bool {
        if self.flown {
            self.learn(population);
        } else if population.is_empty() {
            (0..self.rows.particles).for_each(|i| population.push_within(&self.limits, &mut streams.ant(0, i)));
        } else {
            self.fly(population, number, streams);
        }
        self.flown = !self.flown;
        self.flown
    }
}
