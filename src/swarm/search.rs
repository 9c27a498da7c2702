//! The one skeleton of every swarm: decode what the method proposes until its iteration is complete.

use std::sync::Arc;

use crate::error::ParamError;
use crate::map::Cell;
use crate::planner::{
    GoalStep, Granularity, Iterations, Layer, Objective, Planner, Progress, Solution, Status, Tally, advance, held,
};
use crate::rng::Streams;
use crate::scenario::Scenario;

use super::decode::Decoder;
use super::population::Population;

/// Numbers that every swarm has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Positions kept from iteration to iteration.
    pub size: u32,
    /// Most positions in memory at a time.
    pub most: u32,
    /// Budget of iterations.
    pub iterations: u32,
    /// Iterations without improvement after which the swarm stops; 0 = never.
    pub stagnation: u32,
    /// Cap on the moves of a decoding, in multiples of width + height; 0 = none.
    pub decode_limit: f64,
    /// What a decoding does beside the goal.
    pub goal_step: GoalStep,
}

/// What moves the positions.
pub trait Method: Clone + Send {
    /// The common numbers.
    fn settings(&self) -> Settings;

    /// What it holds beside the population, in bytes.
    fn bytes(&self) -> usize {
        0
    }

    /// Adds the next positions to decode in iteration `number` (from 1), or changes those that are there; everything in the population is
    /// decoded when it is called. False when the iteration is complete.
    fn propose(&mut self, population: &mut Population, number: u32, streams: Streams) -> bool;
}

/// What turns positions into paths.
pub trait Decode: Clone + Send {
    /// For one scenario.
    fn new(scenario: &Scenario, settings: &Settings) -> Self;
    /// Length of a position, at least 1.
    fn dimensions(&self) -> usize;
    /// Decodes a position; what it may not be is put right in place. Length in cells (by slices the cost); `None` if that is no path.
    fn decode(&mut self, scenario: &Scenario, position: &mut [f32]) -> Option<f64>;
    /// What a position costs that has no path: more than any path.
    fn lost(&self) -> f64;
    /// Cells (by slices places) of the last decoded path, without what it took back.
    fn path(&self) -> &[Cell];
    /// Moves of the last decoding, steps back included.
    fn moves(&self) -> u32;
    /// What it holds, in bytes.
    fn bytes(&self) -> usize;
    /// Writes a position's numbers where they belong on the map; `out` has a value for each cell.
    fn draw(&self, scenario: &Scenario, position: &[f32], out: &mut [f32]);
}

/// What a swarm needs while it works; allocated at its first step.
#[derive(Clone)]
struct Tables<D> {
    decoder: D,
    population: Population,
    /// How many paths of the iteration have a cell on their way.
    visits: Vec<u32>,
}

/// A swarm at work on one scenario.
#[derive(Clone)]
pub struct Swarm<M, D = Decoder> {
    scenario: Arc<Scenario>,
    method: M,
    settings: Settings,
    streams: Streams,
    tables: Option<Tables<D>>,
    /// An iteration has begun and not ended.
    decoding: bool,
    /// What the iteration at work has decoded.
    tally: Tally,
    /// The shortest path so far, also of an iteration that has not ended, with its length and its position.
    leader: Option<(Vec<Cell>, f64)>,
    leader_position: Vec<f32>,
    progress: Progress,
}

impl<M: Method, D: Decode> Swarm<M, D> {
    /// A swarm whose streams are those of the planner with this id.
    pub fn new(scenario: Arc<Scenario>, method: M, planner: &str, seed: u32) -> Self {
        Self {
            scenario,
            settings: method.settings(),
            method,
            streams: Streams::new(u64::from(seed), planner, 0),
            tables: None,
            decoding: false,
            tally: Tally::default(),
            leader: None,
            leader_position: Vec::new(),
            progress: Progress::default(),
        }
    }
}

impl<M: Method, D: Decode> Iterations for Swarm<M, D> {
    fn parts(&mut self) -> (&mut Progress, &Scenario) {
        (&mut self.progress, &self.scenario)
    }

    fn is_prepared(&self) -> bool {
        self.tables.is_some()
    }

    fn prepare(&mut self) {
        let decoder = D::new(&self.scenario, &self.settings);
        let population = Population::new(decoder.dimensions());
        self.tables = Some(Tables { decoder, population, visits: vec![0; self.scenario.grid.len()] });
    }

    /// Decodes one position.
    fn move_all(&mut self) -> bool {
        let Some(Tables { decoder, population, visits }) = &mut self.tables else { return true };
        let number = self.progress.effort.iterations + 1;
        if !self.decoding {
            (self.decoding, self.tally) = (true, Tally::default());
            visits.fill(0);
            self.method.propose(population, number, self.streams);
        }
        if let Some(i) = population.next() {
            let length = decoder.decode(&self.scenario, population.position_mut(i));
            self.progress.effort.constructed_paths += 1;
            self.progress.effort.ant_moves += u64::from(decoder.moves());
            let cells = visits.len();
            decoder.path().iter().for_each(|&place| visits[place as usize % cells] += 1);
            population.note(length.unwrap_or_else(|| decoder.lost()));
            if let Some(length) = length {
                self.tally.add(length);
                if self.leader.as_ref().is_none_or(|(_, best)| length < *best) {
                    self.leader = Some((decoder.path().to_vec(), length));
                    self.leader_position.clear();
                    self.leader_position.extend_from_slice(population.position(i));
                }
            }
        }
        population.next().is_none() && !self.method.propose(population, number, self.streams)
    }

    fn end_iteration(&mut self) {
        self.decoding = false;
        self.progress.effort.iterations += 1;
        let (number, tally) = (self.progress.effort.iterations, self.tally);
        if let Some((path, length)) = &self.leader
            && self.progress.best.as_ref().is_none_or(|b| *length < b.length)
        {
            self.progress.best = Some(Solution { path: path.clone(), length: *length, iteration: number, refined: None });
        }
        self.progress.record(tally.record(number, self.progress.best.as_ref()));
        self.progress.status = self.progress.after_iteration(self.settings.iterations, self.settings.stagnation);
        if let (true, Some(tables)) = (self.progress.status.is_finished(), &mut self.tables) {
            tables.population = Population::default();
        }
    }
}

impl<M: Method + 'static, D: Decode + 'static> Planner for Swarm<M, D> {
    fn advance(&mut self, by: Granularity) -> Status {
        advance(self, by)
    }

    fn bytes(&self) -> usize {
        let tables = |t: &Tables<D>| t.decoder.bytes() + t.population.bytes() + held(&t.visits);
        let leader = held(&self.leader_position) + self.leader.as_ref().map_or(0, |(path, _)| held(path));
        size_of::<Self>() + self.progress.bytes() + self.method.bytes() + leader + self.tables.as_ref().map_or(0, tables)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn budget(&self) -> Option<u32> {
        Some(self.settings.iterations)
    }

    fn colony_size(&self) -> u32 {
        self.settings.size
    }

    fn objective(&self) -> Objective {
        if self.scenario.by_slices().is_some() { Objective::SliceCost } else { Objective::Length }
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        out.resize(self.scenario.grid.len(), 0.0);
        match kind {
            Layer::Visits => {
                let visits = self.tables.iter().flat_map(|t| &t.visits);
                out.iter_mut().zip(visits).for_each(|(v, &n)| *v = n as f32);
            }
            Layer::Priority => {
                self.tables.iter().for_each(|t| t.decoder.draw(&self.scenario, &self.leader_position, out));
            }
            _ => return false,
        }
        true
    }
}

/// Refuses what would run out of memory at the first step: `count` of the parameter `field` need `positions` positions at a time, of four
/// bytes a cell, beside the decoder's tables, what the page draws, and the tables of a colony that may follow.
///
/// # Errors
/// [`ParamError::Memory`].
pub fn check_memory(scenario: &Scenario, field: &'static str, count: u32, positions: u32) -> Result<(), ParamError> {
    const PER_CELL: u64 = 200;
    ParamError::check_memory(field, count, scenario.grid.len() as u64 * (PER_CELL + 4 * u64::from(positions)))
}
