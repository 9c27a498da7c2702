//! A genetic algorithm: 遗传算法, which the terrain paper (`docs/papers/terrain.md`) names in its introduction as what it compares with, and of
//! which it gives neither formulas nor results.
//!
//! Real-coded, over the same positions as the other swarms: by slices a row and a level for each column between the ends (`slices.rs`), from
//! cell to cell a priority for each free cell (`decode.rs`).
//!
//! | step | source |
//! |---|---|
//! | selection | tournament: the cheapest of k positions drawn with replacement (Goldberg, Deb, "A comparative analysis of selection schemes used in genetic algorithms", FOGA 1991, 69–93, doi:10.1016/B978-0-08-050684-5.50008-2) |
//! | crossover `blx` | BLX-α: each number uniformly from the parents' interval, α of its length longer on either side (Eshelman, Schaffer, "Real-coded genetic algorithms and interval-schemata", FOGA 1992, 1993, 187–202, doi:10.1016/B978-0-08-094832-4.50018-0) |
//! | crossover `exchange` | each number from either parent (Syswerda, "Uniform crossover in genetic algorithms", ICGA 1989, 2–9) |
//! | mutation | a number is drawn anew from its range (Michalewicz, *Genetic Algorithms + Data Structures = Evolution Programs*, Springer 1996, uniform mutation) |
//! | survivors | the children, and the elite of the generation before (De Jong 1975, in Goldberg, *Genetic Algorithms in Search, Optimization, and Machine Learning*, Addison-Wesley 1989) |
//!
//! Numbers out of range stop at its border, as particles do. By slices a position becomes what its path was, so that children inherit paths.
//! Each child has one random stream of its own: its parents, whether they cross, then number by number crossing and mutation. A position
//! without a path costs more than any path. The first iteration is the random population; in each later one the children are decoded.

use std::sync::Arc;

use rand::Rng;

use crate::error::ParamError;
use crate::params::{Params, Values};
use crate::planner::{Family, Ground, Layer, Planner, PlannerEntry, Preset};
use crate::rng::{Stream, Streams, unit_f32};
use crate::scenario::Scenario;
use crate::{param_choice, params};

use super::decode::{DecodeRows, Limits};
use super::population::{Population, below};
use super::search::{Method, Settings, Swarm, check_memory};
use super::slices::SliceDecoder;

param_choice! {
    /// What a child has of its two parents.
    pub enum Crossover {
        /// each number from the interval between the parents' numbers, and a share of its length beyond: BLX-α
        Blx = "blx",
        /// each number from one of the parents, either as likely
        Exchange = "exchange",
    }
}

params! {
    /// What the genetic algorithm does in each generation.
    pub struct GeneticRows {
        /// positions of a generation
        population: u32 = 50, "N", [2..=512], "positions", "our choice: as many as the terrain paper has ants";
        /// positions of which the cheapest becomes a parent
        tournament: u32 = 2, "k", [1..=64], "positions", "Goldberg and Deb 1991: binary tournament";
        /// how likely a child has two parents; else it is a copy of one
        crossover_rate: f64 = 0.9, "p_c", [0.0..=1.0], "", "our choice: no paper gives it";
        /// what a child has of its two parents
        crossover: Crossover = Crossover::Blx, "", [], "", "Eshelman and Schaffer 1993; Syswerda 1989";
        /// how far beyond the parents' numbers a child's may lie, as a share of their distance
        blend: f64 = 0.5, "α", [0.0..=2.0], "", "Eshelman and Schaffer 1993: BLX-0.5", when(crossover: "blx");
        /// numbers of a child that are drawn anew, on average
        mutations: f64 = 1.0, "", [0.0..=100.0], "numbers", "our choice: one, as is usual; no paper gives it";
        /// cheapest positions that stay as they are
        survivors: u32 = 1, "", [0..=256], "positions", "De Jong 1975, in Goldberg 1989";
    }
}

params! {
    /// Parameters of the genetic algorithm.
    pub struct GeneticParams {
        /// generations after which the algorithm stops
        iterations: u32 = 100, "", [1..=100_000], "iterations", "our choice: as many as the terrain paper has";
        ..genes: GeneticRows;
        ..decoding: DecodeRows;
        /// stops after this many iterations without a shorter path; 0 = never
        stagnation: u32 = 0, "", [0..=100_000], "iterations", "our addition";
    }
}

fn uniform(stream: &mut Stream) -> f64 {
    f64::from(unit_f32(stream.next_u32()))
}

/// BLX-α: of two numbers the one at `u`, 0 to 1, of the interval that reaches beyond both by `alpha` of their distance.
pub fn blended(a: f64, b: f64, alpha: f64, u: f64) -> f64 {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    let beyond = alpha * (high - low);
    low - beyond + u * (high - low + 2.0 * beyond)
}

/// The cheapest of `size` positions drawn with replacement; the first drawn of equals.
pub fn tournament(costs: &[f64], size: u32, stream: &mut Stream) -> usize {
    let first = below(costs.len(), stream);
    (1..size).map(|_| below(costs.len(), stream)).fold(first, |best, i| if costs[i] < costs[best] { i } else { best })
}

/// Where a generation stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// Nothing is there.
    Empty,
    /// The first generation is to be decoded.
    First,
    /// The generation is decoded.
    Grown,
    /// Its children are decoded as well.
    Born,
}

/// The genetic algorithm.
#[derive(Debug, Clone)]
pub struct Genetic {
    settings: Settings,
    rows: GeneticRows,
    /// Between which values a dimension lies; the dimensions take them in turn.
    limits: [Limits; 2],
    stage: Stage,
}

impl Genetic {
    /// Over dimensions whose values lie between these limits in turn.
    pub fn within(limits: [Limits; 2], params: &GeneticParams) -> Self {
        let settings = Settings {
            size: params.genes.population,
            most: 2 * params.genes.population,
            iterations: params.iterations,
            stagnation: params.stagnation,
            decode_limit: params.decoding.decode_limit,
            goal_step: params.decoding.decode_goal,
        };
        Self { settings, rows: params.genes, limits, stage: Stage::Empty }
    }

    /// How many positions stay.
    fn survivors(&self) -> usize {
        self.rows.survivors.min(self.rows.population) as usize
    }

    /// Adds a child of each place that the elite leaves.
    fn breed(&self, population: &mut Population, number: u32, streams: Streams) {
        let (rows, dimensions) = (&self.rows, population.dimensions());
        let (parents, rate) = (population.len(), rows.mutations / dimensions as f64);
        for i in self.survivors()..parents {
            let stream = &mut streams.ant(number, i as u32);
            let costs = &population.costs()[..parents];
            let (mother, father) = (tournament(costs, rows.tournament, stream), tournament(costs, rows.tournament, stream));
            let crosses = uniform(stream) < rows.crossover_rate;
            population.push_copy(mother);
            let child = population.len() - 1;
            for (k, limits) in (0..dimensions).zip(self.limits.into_iter().cycle()) {
                let [a, b] = [mother, father].map(|parent| f64::from(population.position(parent)[k]));
                let crossed = if crosses { self.crossed(a, b, uniform(stream)) } else { a };
                let x = if uniform(stream) < rate { limits.min + uniform(stream) * limits.span() } else { crossed };
                population.position_mut(child)[k] = x.clamp(limits.min, limits.max) as f32;
            }
        }
    }

    fn crossed(&self, a: f64, b: f64, u: f64) -> f64 {
        match self.rows.crossover {
            Crossover::Blx => blended(a, b, self.rows.blend, u),
            Crossover::Exchange => [a, b][usize::from(u >= 0.5)],
        }
    }

    /// The elite of the parents, the cheapest first, and all children.
    fn select(&self, population: &mut Population) {
        let parents = self.rows.population as usize;
        let mut order: Vec<usize> = (0..parents).collect();
        order.sort_by(|&a, &b| population.costs()[a].total_cmp(&population.costs()[b]));
        order.truncate(self.survivors());
        order.extend(parents..population.len());
        population.keep(&order);
    }
}

impl Method for Genetic {
    fn settings(&self) -> Settings {
        self.settings
    }

    fn propose(&mut self, population: &mut Population, number: u32, streams: Streams) -> bool {
        match self.stage {
            Stage::Empty => {
                (0..self.rows.population).for_each(|i| population.push_within(&self.limits, &mut streams.ant(0, i)));
                self.stage = Stage::First;
                return true;
            }
            Stage::First => {}
            Stage::Grown => {
                self.breed(population, number, streams);
                self.stage = Stage::Born;
                return true;
            }
            Stage::Born => self.select(population),
        }
        self.stage = Stage::Grown;
        false
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let params = GeneticParams::read(ENTRY.id, values)?;
    let scenario_of = || Arc::clone(scenario);
    let Some(slices) = &scenario.slices else {
        let method = Genetic::within([params.decoding.limits(); 2], &params);
        check_memory(scenario, "population", params.genes.population, method.settings.most)?;
        return Ok(Box::new(Swarm::<_>::new(scenario_of(), method, ENTRY.id, seed)));
    };
    let method = Genetic::within(SliceDecoder::ranges(slices, scenario).map(Limits::up_to), &params);
    Ok(Box::new(Swarm::<_, SliceDecoder>::new(scenario_of(), method, ENTRY.id, seed)))
}

/// The genetic algorithm in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "ga",
    name: "Genetic algorithm",
    family: Family::Swarm,
    summary: "Generations of positions: the cheaper ones become parents, children lie between them, and a few numbers are drawn anew; a position is a row and a level for each slice, or a priority for each cell.",
    source: "Goldberg 1989, Genetic Algorithms in Search, Optimization, and Machine Learning, Addison-Wesley; Eshelman, Schaffer 1993, FOGA 2, 187–202, doi:10.1016/B978-0-08-094832-4.50018-0; named in the terrain paper's introduction",
    presets: &[Preset {
        name: "uniform",
        source: "Syswerda 1989, ICGA, 2–9",
        meaning: "uniform crossover in place of BLX-0.5: each number from either parent",
        numbers: &[],
        choices: &[("crossover", "exchange")],
        reading: None,
    }],
    components: &[],
    layers: &[Layer::Priority, Layer::Visits],
    max_goals: 1,
    grounds: Ground::UNWEIGHTED,
    specs: GeneticParams::specs,
    build,
};
