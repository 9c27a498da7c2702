//! The colony at work: ants walk by several cells at a time, then the index learns from those that have arrived.

use std::sync::Arc;

use super::index::Index;
use super::walker::Walker;
use super::window::Window;
use super::{ENTRY, TdiMsacoParams, weight};
use crate::map::Cell;
use crate::path::crossed;
use crate::planner::{
    Fate, Granularity, Iterations, Layer, MoveOdds, Objective, Planner, Progress, Solution, Status, Tally, Turn, Walked, advance,
    held, stand_ready,
};
use crate::rng::Streams;
use crate::scenario::Scenario;

/// What the colony needs while it works; allocated at its first move.
#[derive(Clone)]
struct Tables {
    window: Window,
    index: Index,
    /// What a cell weighs, 0 where that is to be worked out anew.
    weights: Vec<f64>,
    ants: Vec<Walker>,
    /// The cells among which the ant chooses whose turn it is, with their weights.
    options: Vec<(Cell, f64)>,
}

impl Tables {
    fn new(p: &TdiMsacoParams, scenario: &Scenario, streams: Streams) -> Self {
        let cells = scenario.grid.len();
        let ant = |k| Walker::new(cells, scenario.start, streams.ant(1, k));
        Self {
            window: Window::new(p.reach, cells),
            index: Index::new(cells, scenario.goal, super::initial_index(p, scenario)),
            weights: vec![0.0; cells],
            ants: (0..p.ants).map(ant).collect(),
            options: Vec::new(),
        }
    }

    /// One move of an ant, where it still walks.
    fn move_ant(&mut self, p: &TdiMsacoParams, scenario: &Scenario, number: usize, most: u32) {
        let Self { window, index, weights, ants, options } = self;
        let ant = &mut ants[number];
        if ant.fate() != Fate::Walking {
            return;
        }
        let seen = window.seen_from(scenario, ant.cell());
        let open = window.cells(scenario.grid.width(), ant.cell(), seen).filter(|&to| !p.tabu || !ant.has_been_at(to));
        options.clear();
        options.extend(open.map(|to| {
            let known = &mut weights[to as usize];
            if *known == 0.0 {
                *known = weight(p, scenario, to, index.get(to));
            }
            (to, *known)
        }));
        let to = ant.draw(options);
        ant.go(to, scenario.goal, p.walk.dead_end, most);
    }

    /// Has the index learn from the ants that have arrived, one after the other. Their lengths in cells, and the best path of the iteration:
    /// that along the index from the start, or the shortest ant's where that is shorter.
    fn learn(&mut self, scenario: &Scenario) -> (Tally, Option<(Vec<Cell>, f64)>) {
        let mut tally = Tally::default();
        let mut best: Option<(&Walker, f64)> = None;
        for ant in self.ants.iter().filter(|ant| ant.fate() == Fate::Arrived) {
            let length = scenario.path_length(ant.way());
            tally.add(length);
            self.index.learn(scenario, ant.way(), |cell| self.weights[cell as usize] = 0.0);
            best = best.filter(|&(_, least)| least <= length).or(Some((ant, length)));
        }
        let Some((ant, length)) = best else { return (tally, None) };
        let led = self.index.way_from(scenario.start).map(|way| (scenario.path_length(&way), way));
        match led {
            Some((led, way)) if led <= length => (tally, Some((way, led))),
            _ => (tally, Some((ant.way().to_vec(), length))),
        }
    }

    fn bytes(&self) -> usize {
        let ants = held(&self.ants) + self.ants.iter().map(Walker::bytes).sum::<usize>();
        self.window.bytes() + self.index.bytes() + held(&self.weights) + ants + held(&self.options)
    }
}

/// TDI-MSACO at work on one scenario.
#[derive(Clone)]
pub struct TdiMsaco {
    scenario: Arc<Scenario>,
    params: TdiMsacoParams,
    streams: Streams,
    tables: Option<Tables>,
    /// An iteration has begun and not ended.
    walking: bool,
    progress: Progress,
}

impl TdiMsaco {
    /// With these parameters.
    pub fn new(scenario: Arc<Scenario>, params: TdiMsacoParams, seed: u32) -> Self {
        let streams = Streams::new(u64::from(seed), ENTRY.id, 0);
        Self { scenario, params, streams, tables: None, walking: false, progress: Progress::default() }
    }

    /// Moves that an ant makes at most.
    fn most_moves(&self) -> u32 {
        let (grid, p) = (&self.scenario.grid, &self.params);
        let limit = p.walk.move_limit * f64::from(grid.width() + grid.height());
        let limit = if p.walk.move_limit == 0.0 { u32::MAX } else { limit as u32 };
        if p.tabu { limit } else { limit.min(grid.len() as u32) }
    }

    /// The cells in sight of one, as an ant weighs them that may not go where `is_shut`.
    fn odds(&self, from: Cell, is_shut: impl Fn(Cell) -> bool) -> Vec<MoveOdds> {
        let (scenario, p) = (&*self.scenario, &self.params);
        let window = Window::new(p.reach, 0);
        let before = super::initial_index(p, scenario);
        let odds = |to| {
            let index = self.tables.as_ref().map_or(if to == scenario.goal { 0.0 } else { before }, |t| t.index.get(to));
            let shut = is_shut(to);
            let weight = if shut { 0.0 } else { weight(p, scenario, to, index) };
            let heuristic = super::nearness(p, super::straight(scenario, to));
            MoveOdds { colony: 0, to, trail: super::nearness(p, index), heuristic, weight, probability: 0.0 }
        };
        let mut all: Vec<MoveOdds> = window.cells(scenario.grid.width(), from, window.look(scenario, from)).map(odds).collect();
        let total: f64 = all.iter().map(|m| m.weight).sum();
        all.iter_mut().filter(|m| m.weight > 0.0).for_each(|m| m.probability = m.weight / total);
        all
    }

    /// [`Planner::turn_of`], taken.
    fn take_turn(mut self, number: usize) -> Option<Turn> {
        if stand_ready(&mut self).is_finished() {
            return None;
        }
        let ant = self.tables.as_ref()?.ants.get(number)?;
        let walked = ant.walked();
        if ant.fate() != Fate::Walking {
            return Some(Turn::over(walked));
        }
        let (from, tabu) = (ant.cell(), self.params.tabu);
        let odds = self.odds(from, |to| tabu && ant.has_been_at(to));
        let most = self.most_moves();
        let tables = self.tables.as_mut()?;
        tables.move_ant(&self.params, &self.scenario, number, most);
        let to = tables.ants[number].cell();
        Some(Turn { walked, odds, next: (to != from).then_some(to) })
    }
}

impl Iterations for TdiMsaco {
    fn parts(&mut self) -> (&mut Progress, &Scenario) {
        (&mut self.progress, &self.scenario)
    }

    fn is_prepared(&self) -> bool {
        self.tables.is_some()
    }

    fn prepare(&mut self) {
        self.tables = Some(Tables::new(&self.params, &self.scenario, self.streams));
    }

    fn begin_iteration(&mut self) {
        let Some(tables) = self.tables.as_mut().filter(|_| !self.walking) else { return };
        let number = self.progress.effort.iterations + 1;
        (0..).zip(&mut tables.ants).for_each(|(k, ant)| ant.begin(self.scenario.start, self.streams.ant(number, k)));
        self.walking = true;
    }

    /// One move of every walking ant, in index order; true when none is left.
    fn move_all(&mut self) -> bool {
        let most = self.most_moves();
        let Some(tables) = &mut self.tables else { return true };
        (0..tables.ants.len()).for_each(|k| tables.move_ant(&self.params, &self.scenario, k, most));
        tables.ants.iter().all(|ant| ant.fate() != Fate::Walking)
    }

    fn end_iteration(&mut self) {
        let Some(tables) = &mut self.tables else { return };
        self.walking = false;
        self.progress.effort.iterations += 1;
        self.progress.effort.constructed_paths += u64::from(self.params.ants);
        self.progress.effort.ant_moves += tables.ants.iter().map(|ant| u64::from(ant.moves())).sum::<u64>();
        let iteration = self.progress.effort.iterations;
        let (tally, found) = tables.learn(&self.scenario);
        let length = found.as_ref().map(|found| found.1);
        if let Some((path, length)) = found
            && self.progress.best.as_ref().is_none_or(|best| length < best.length)
        {
            self.progress.best = Some(Solution { path, length, iteration, refined: None });
        }
        let record = tally.record(iteration, self.progress.best.as_ref());
        self.progress.record(length.map_or(record, |length| record.with_found(length)));
        self.progress.status = self.progress.after_iteration(self.params.iterations, self.params.walk.stagnation);
    }
}

impl Planner for TdiMsaco {
    fn advance(&mut self, by: Granularity) -> Status {
        advance(self, by)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn budget(&self) -> Option<u32> {
        Some(self.params.iterations)
    }

    fn colony_size(&self) -> u32 {
        self.params.ants
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.progress.bytes() + self.tables.as_ref().map_or(0, Tables::bytes)
    }

    fn objective(&self) -> Objective {
        Objective::PolylineLength
    }

    fn ants(&self, out: &mut Vec<Cell>) {
        out.clear();
        let ants = self.tables.iter().filter(|_| self.walking).flat_map(|tables| &tables.ants);
        out.extend(ants.filter(|ant| ant.fate() != Fate::Lost).map(Walker::cell));
    }

    fn ant(&self, number: u32) -> Option<Walked> {
        self.tables.as_ref()?.ants.get(number as usize).map(Walker::walked)
    }

    fn moves_from(&self, cell: Cell) -> Vec<MoveOdds> {
        let grid = &self.scenario.grid;
        if cell as usize >= grid.len() || grid.is_blocked(cell) || cell == self.scenario.goal {
            return Vec::new();
        }
        self.odds(cell, |_| false)
    }

    fn turn_of(&self, number: u32) -> Option<Turn> {
        (number < self.params.ants).then(|| self.clone().take_turn(number as usize))?
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        let cells = self.scenario.grid.len();
        out.clear();
        match kind {
            Layer::Scent => {
                let known = |cell| self.tables.as_ref().map_or(f64::INFINITY, |tables| tables.index.known(cell));
                out.extend((0..cells as Cell).map(|cell| known(cell) as f32));
            }
            Layer::Visits => {
                out.resize(cells, 0.0);
                let mut counted = vec![0; cells];
                let ants = self.tables.iter().flat_map(|tables| &tables.ants);
                for (number, ant) in (1u32..).zip(ants) {
                    for cell in crossed(self.scenario.grid.width(), ant.way()) {
                        let by = std::mem::replace(&mut counted[cell as usize], number);
                        out[cell as usize] += if by == number { 0.0 } else { 1.0 };
                    }
                }
            }
            _ => return false,
        }
        true
    }
}
