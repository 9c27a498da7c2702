//! Fireworks: Tan, Zhu, "Fireworks algorithm for optimization", ICSI 2010, LNCS 6145, 355–364, doi:10.1007/978-3-642-13495-1_44, over cell
//! priorities, as in Zhou, Mu, Zhang 2019 (基于烟花混合蚁群的移动机器人路径规划研究), whose equation numbers stand here.
//!
//! The formulas stand in `explosion.rs`; here is what is done with them.
//!
//! | step | source |
//! |---|---|
//! | path of a firework, its cost | Eq. 1: `decode.rs`; the path's length |
//! | sparks of an explosion, how many and how far | Eq. 2 and 3, `allotment`, `rounded_sparks` |
//! | displacement of a spark | Eq. 4, `displacement` |
//! | Gaussian spark of a random firework | Eq. 5, `gaussian` |
//! | a number out of range | Eq. 6, `confined` |
//! | survivors | the best; the others by Eq. 7 and 8, `crowding`, `roulette` |
//! | `ifwa`: cooled radius, weighted mutation | Eq. 9, `cooled_radius`, `inertia`, `mutation_factor` |
//!
//! Eq. 4 is printed with rand(0, A_i), by which an explosion only ever adds; Tan and Zhu draw from −A_i to A_i. `reading`: repaired takes
//! theirs.
//!
//! Eq. 9 is cut out of the copy that we read; its text says: the radius follows simulated annealing over G / G_max, the mutation has an
//! inertia weight. **Our choice:** Â(G) = Â·c^(G / G_max), the geometric cooling of simulated annealing, down to the share c = 0.01; and the
//! weight of Shi and Eberhart 1999, 0.9 falling to 0.4, on the mutation's deviation: x ← x·(1 + w·(g − 1)), so that its mean stays 1.
//!
//! Where the paper is silent, as Tan and Zhu: each explosion and each mutation changes a random share of the dimensions by one and the
//! same draw; ε is the smallest constant of the machine; the best position always survives; the others are drawn with replacement; the
//! distance is Euclidean. Ours: priorities lie in 0 to 1 (with Â = 3 the 15 radii sum up to 3, a fifth of the range each); the first
//! iteration also decodes the random fireworks; a decoding that is cut off costs more than any path.
//!
//! Eq. 6 has two limits, x_min and x_max, and the paper gives neither a value. `range_min` is 0 by default; preset `second-reading` has one
//! above 0. What they do to a path: `decode.rs`.

use std::sync::Arc;

use rand::Rng;

use crate::error::ParamError;
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset, Reading};
use crate::rng::{Stream, Streams, unit_f32};
use crate::scenario::Scenario;

use super::decode::{DecodeRows, Decoder, Limits};
use super::explosion::{
    confined, cooled_radius, crowding, displacement, explosions, gaussian, inertia, mutation_factor, roulette, rounded_sparks,
};
use super::population::{Population, below};
use super::search::{Method, Settings, Swarm, check_memory};

params! {
    /// What all fireworks algorithms share.
    pub struct FireworkRows {
        /// fireworks kept from iteration to iteration
        fireworks: u32 = 15, "n", [1..=128], "fireworks", "Zhou, Mu, Zhang 2019, section 2.1";
        /// explosion sparks that all fireworks share by their lengths
        sparks: f64 = 5.0, "m", [0.0..=100.0], "sparks", "Zhou, Mu, Zhang 2019, section 2.1; eq. 2";
        /// fewest sparks of a firework, as a share of m
        fewest: f64 = 0.3, "a", [0.0..=1.0], "× m", "Zhou, Mu, Zhang 2019, section 2.1";
        /// most sparks of a firework, as a share of m
        most: f64 = 0.5, "b", [0.0..=1.0], "× m", "Zhou, Mu, Zhang 2019, section 2.1";
        /// radii of all explosions together
        radius: f64 = 3.0, "Â", [0.0..=1000.0], "", "Zhou, Mu, Zhang 2019, section 2.1; eq. 3";
        /// Gaussian sparks, each of a random firework
        gaussian_sparks: u32 = 10, "m̂", [0..=512], "sparks", "Zhou, Mu, Zhang 2019, section 2.1";
        /// how the displacement of a spark is read
        reading: Reading = Reading::Repaired, "", [], "", "ours: eq. 4 draws from 0 to A_i, Tan and Zhu 2010 from −A_i to A_i";
    }
}

params! {
    /// Eq. 9, of the improved fireworks.
    pub struct AnnealingRows {
        /// share of the radius that is left in the last iteration
        radius_end: f64 = 0.01, "c", [1e-6..=1.0], "", "our choice: eq. 9 is cut out of the copy that we read";
        /// weight of the mutation's deviation at the beginning
        mutation_start: f64 = 0.9, "w_1", [0.0..=2.0], "", "our choice: eq. 9 is cut; Shi and Eberhart 1999";
        /// weight of the mutation's deviation in the last iteration
        mutation_end: f64 = 0.4, "w_2", [0.0..=2.0], "", "our choice: eq. 9 is cut; Shi and Eberhart 1999";
    }
}

/// Nothing cools: the fireworks of Eq. 2–8.
const UNCHANGING: AnnealingRows = AnnealingRows { radius_end: 1.0, mutation_start: 1.0, mutation_end: 1.0 };

params! {
    /// Parameters of the fireworks algorithm.
    pub struct FwaParams {
        /// iterations after which the fireworks stop
        iterations: u32 = 50, "G_max", [1..=100_000], "iterations", "Zhou, Mu, Zhang 2019, section 2.1";
        ..fireworks: FireworkRows;
        ..decoding: DecodeRows;
        /// stops after this many iterations without a shorter path; 0 = never
        stagnation: u32 = 0, "", [0..=100_000], "iterations", "our addition";
    }
}

params! {
    /// Parameters of the improved fireworks algorithm.
    pub struct IfwaParams {
        /// iterations after which the fireworks stop
        iterations: u32 = 50, "G_max", [1..=100_000], "iterations", "Zhou, Mu, Zhang 2019, section 2.1";
        ..fireworks: FireworkRows;
        ..annealing: AnnealingRows;
        ..decoding: DecodeRows;
        /// stops after this many iterations without a shorter path; 0 = never
        stagnation: u32 = 0, "", [0..=100_000], "iterations", "our addition";
    }
}

fn uniform(stream: &mut Stream) -> f64 {
    f64::from(unit_f32(stream.next_u32()))
}

/// Uniform from 0 to 1, 0 excluded.
fn positive(stream: &mut Stream) -> f64 {
    1.0 - uniform(stream)
}

/// Changes each dimension with one random probability: as many dimensions as Tan and Zhu draw, any number equally likely.
fn change(position: &mut [f32], limits: Limits, stream: &mut Stream, new: impl Fn(f64) -> f64) {
    let share = uniform(stream);
    for x in position {
        if uniform(stream) < share {
            *x = confined(new(f64::from(*x)), limits.min, limits.max) as f32;
        }
    }
}

/// Where an iteration stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// No firework is there.
    Empty,
    /// The fireworks are decoded.
    Lit,
    /// Their sparks are decoded as well.
    Exploded,
}

/// The fireworks algorithm; improved or not is a matter of the annealing.
#[derive(Debug, Clone)]
pub struct Fireworks {
    settings: Settings,
    rows: FireworkRows,
    annealing: AnnealingRows,
    limits: Limits,
    stage: Stage,
}

impl Fireworks {
    /// With these parameters, for so many iterations.
    pub fn new(rows: FireworkRows, annealing: AnnealingRows, decoding: DecodeRows, iterations: u32, stagnation: u32) -> Self {
        let each = rounded_sparks(0.0, &rows).max(rounded_sparks(f64::MAX, &rows));
        let settings = Settings {
            size: rows.fireworks,
            most: rows.fireworks * (2 + each) + rows.gaussian_sparks,
            iterations,
            stagnation,
            decode_limit: decoding.decode_limit,
            goal_step: decoding.decode_goal,
        };
        Self { settings, rows, annealing, limits: decoding.limits(), stage: Stage::Empty }
    }

    /// Adds the explosion sparks and the Gaussian sparks.
    fn explode(&self, population: &mut Population, number: u32, streams: Streams) {
        let (rows, n) = (&self.rows, population.len());
        let radius = cooled_radius(rows.radius, self.annealing.radius_end, number, self.settings.iterations);
        for (i, (sparks, radius)) in explosions(rows, radius, population.costs()).into_iter().enumerate() {
            let mut stream = streams.ant(number, i as u32);
            for _ in 0..sparks {
                let h = displacement(rows.reading, radius, uniform(&mut stream));
                change(population.push_copy(i), self.limits, &mut stream, |x| x + h);
            }
        }
        let weight = inertia(self.annealing.mutation_start, self.annealing.mutation_end, number, self.settings.iterations);
        for k in 0..rows.gaussian_sparks {
            let mut stream = streams.ant(number, n as u32 + k);
            let i = below(n, &mut stream);
            let factor = mutation_factor(gaussian(positive(&mut stream), uniform(&mut stream)), weight);
            change(population.push_copy(i), self.limits, &mut stream, |x| x * factor);
        }
    }

    /// Eq. 7 and 8: the best survives, the other places are drawn.
    fn select(&self, population: &mut Population, number: u32, streams: Streams) {
        let mut stream = streams.ant(number, u32::MAX);
        let weights = crowding(population);
        let others = (1..self.rows.fireworks).map(|_| roulette(&weights, uniform(&mut stream)));
        let chosen: Vec<usize> = population.cheapest().into_iter().chain(others).collect();
        population.keep(&chosen);
    }
}

impl Method for Fireworks {
    fn settings(&self) -> Settings {
        self.settings
    }

    fn propose(&mut self, population: &mut Population, number: u32, streams: Streams) -> bool {
        match self.stage {
            Stage::Empty => {
                (0..self.rows.fireworks).for_each(|i| population.push_random(self.limits, &mut streams.ant(0, i)));
                self.stage = Stage::Lit;
            }
            Stage::Lit => {
                self.explode(population, number, streams);
                self.stage = Stage::Exploded;
            }
            Stage::Exploded => {
                self.select(population, number, streams);
                self.stage = Stage::Lit;
                return false;
            }
        }
        true
    }
}

/// The improved fireworks, with the streams of `ifwa`: what a hybrid starts with is a run of that planner.
///
/// # Errors
/// [`ParamError::Memory`] where the positions would not fit.
pub fn improved(
    scenario: &Arc<Scenario>,
    rows: (FireworkRows, AnnealingRows, DecodeRows),
    iterations: u32,
    stagnation: u32,
    seed: u32,
) -> Result<Swarm<Fireworks>, ParamError> {
    let method = Fireworks::new(rows.0, rows.1, rows.2, iterations, stagnation);
    check_memory(scenario, "fireworks", rows.0.fireworks, method.settings.most)?;
    Ok(Swarm::new(Arc::clone(scenario), method, IFWA.id, seed))
}

fn build_fwa(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let p = FwaParams::read(FWA.id, values)?;
    let method = Fireworks::new(p.fireworks, UNCHANGING, p.decoding, p.iterations, p.stagnation);
    check_memory(scenario, "fireworks", p.fireworks.fireworks, method.settings.most)?;
    Ok(Box::new(Swarm::<_, Decoder>::new(Arc::clone(scenario), method, FWA.id, seed)))
}

fn build_ifwa(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let p = IfwaParams::read(IFWA.id, values)?;
    Ok(Box::new(improved(scenario, (p.fireworks, p.annealing, p.decoding), p.iterations, p.stagnation, seed)?))
}

/// Eq. 4 as printed.
pub const PRINTED: Preset = Preset {
    name: "printed",
    source: "Zhou, Mu, Zhang 2019, as printed",
    meaning: "eq. 4 literally: an explosion only ever adds to a priority",
    numbers: &[],
    choices: &[("reading", "printed")],
    reading: Some(PaperReading::Printed),
};

const SECOND_READING: Preset = Preset {
    name: "second-reading",
    source: "Zhou, Mu, Zhang 2019, eq. 6",
    meaning: "an x_min above 0, so that paths keep nearer to the greedy one; the paper gives no value, 0.8 is ours",
    numbers: &[("range_min", 0.8)],
    choices: &[],
    reading: Some(PaperReading::SecondReading),
};

/// What the paper adds to the fireworks of Tan and Zhu 2010; its Eq. 9 has both.
pub const COMPONENTS: &[Component] = &[COOLED_RADIUS, WEIGHTED_MUTATION];

/// Eq. 9, the radius.
pub const COOLED_RADIUS: Component = Component {
    id: "cooled-radius",
    name: "cooled radius",
    adds: "the radius of the explosions shrinks as by annealing (eq. 9, first part); without: it stays (eq. 3)",
    without: &[("radius_end", "1")],
};

/// Eq. 9, the mutation.
pub const WEIGHTED_MUTATION: Component = Component {
    id: "weighted-mutation",
    name: "weighted mutation",
    adds: "the mutation's deviation has an inertia weight that falls (eq. 9, second part); without: the weight is 1 (eq. 5)",
    without: &[("mutation_start", "1"), ("mutation_end", "1")],
};

/// The fireworks algorithm in the catalog.
pub const FWA: PlannerEntry = PlannerEntry {
    id: "fwa",
    name: "Fireworks",
    family: Family::Swarm,
    summary: "Each firework gives every cell a priority and so decodes into a path; good ones explode into many near sparks, bad ones into far ones.",
    source: "Tan, Zhu 2010, LNCS 6145, 355–364, doi:10.1007/978-3-642-13495-1_44; priorities as in Zhou, Mu, Zhang 2019",
    presets: &[PRINTED, SECOND_READING],
    components: &[],
    layers: &[Layer::Priority, Layer::Visits],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: FwaParams::specs,
    build: build_fwa,
};

/// The improved fireworks algorithm in the catalog.
pub const IFWA: PlannerEntry = PlannerEntry {
    id: "ifwa",
    name: "Improved fireworks",
    family: Family::Swarm,
    summary: "Fireworks whose explosions shrink as by annealing and whose mutations weigh less and less (its formula is lost: our choice).",
    source: "Zhou, Mu, Zhang 2019 (基于烟花混合蚁群的移动机器人路径规划研究), eq. 1–9",
    presets: &[PRINTED, SECOND_READING],
    components: COMPONENTS,
    layers: &[Layer::Priority, Layer::Visits],
    max_goals: 1,
    grounds: Ground::NEIGHBOURS,
    specs: IfwaParams::specs,
    build: build_ifwa,
};
