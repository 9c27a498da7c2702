//! The colony of the terrain paper: one team from the start, or two of equal size from both ends, which join where they meet.
//!
//! All ants move in lock step, one move each in index order, the forward team first: they change trails as they go, and they meet.

use std::ops::Range;
use std::sync::Arc;

use super::params::EpfParams;
use super::sight::force_weight;
use super::space::Space;
use super::team::{Tables, check_memory};
use super::walk::Walker;
use crate::error::ParamError;
use crate::map::Cell;
use crate::planner::{
    Fate, Granularity, Iterations, Layer, MoveOdds, Objective, Planner, Progress, Solution, Status, Tally, Turn, Walked, advance,
};
use crate::rng::{Stream, Streams};
use crate::scenario::Scenario;

/// Both planners draw from the streams of this name: with everything off `terrain-epf` is `terrain-aco`, bit for bit.
const STREAMS: &str = "terrain-aco";

/// The colony at work on one scenario.
#[derive(Clone)]
pub(super) struct FieldColony<S> {
    pub(super) space: S,
    scenario: Arc<Scenario>,
    pub(super) params: EpfParams,
    streams: Streams,
    max_moves: u32,
    pub(super) tables: Option<Tables>,
    /// An iteration has begun and not ended.
    constructing: bool,
    progress: Progress,
}

impl<S: Space> FieldColony<S> {
    /// A colony in the space of this scenario.
    ///
    /// # Errors
    /// [`ParamError::Memory`] where its tables could grow too large.
    pub(super) fn new(space: S, scenario: &Arc<Scenario>, params: EpfParams, seed: u32) -> Result<Self, ParamError> {
        check_memory(&space, &params)?;
        let (width, height) = (scenario.grid.width(), scenario.grid.height());
        let limit = params.common.walk.move_limit;
        Ok(Self {
            space,
            scenario: Arc::clone(scenario),
            params,
            streams: Streams::new(u64::from(seed), STREAMS, 0),
            max_moves: if limit == 0.0 { u32::MAX } else { (limit * f64::from(width + height)) as u32 },
            tables: None,
            constructing: false,
            progress: Progress::default(),
        })
    }

    /// The iteration at work, or the next one; the last one once the budget is spent.
    pub(super) fn iteration(&self) -> u32 {
        (self.progress.effort.iterations + 1).min(self.params.common.selection.iterations)
    }

    /// A stream from which nothing is drawn.
    pub(super) fn stream(&self) -> Stream {
        self.streams.ant(0, 0)
    }

    /// The weight of the force in an iteration, full where it does not fade.
    pub(super) fn weight(&self, iteration: u32) -> f64 {
        if !self.params.force_fades {
            return 1.0;
        }
        force_weight(self.params.reading, iteration, self.params.common.selection.iterations)
    }
}

impl<S: Space> FieldColony<S> {
    /// One move of the walking ones among these ants, in index order; true when none of them is left.
    #[inline(always)]
    pub(super) fn move_ants(&mut self, which: Range<usize>) -> bool {
        let Some(tables) = &mut self.tables else { return true };
        let mut done = true;
        for k in which {
            if !tables.ants[k].is_walking() {
                continue;
            }
            tables.move_one(&self.space, &self.params, k);
            if tables.ants[k].is_walking() && tables.ants[k].moves() >= self.max_moves {
                tables.give_up(k);
            }
            done &= !tables.ants[k].is_walking();
        }
        done
    }
}

impl<S: Space> Iterations for FieldColony<S> {
    fn parts(&mut self) -> (&mut Progress, &Scenario) {
        (&mut self.progress, &self.scenario)
    }

    fn is_prepared(&self) -> bool {
        self.tables.is_some()
    }

    fn prepare(&mut self) {
        self.tables = Some(Tables::new(&self.space, &self.params, self.streams));
    }

    fn begin_iteration(&mut self) {
        if self.constructing {
            return;
        }
        let number = self.progress.effort.iterations + 1;
        let weight = self.weight(number);
        let Some(Tables { teams, ants, .. }) = &mut self.tables else { return };
        for team in teams {
            team.sight.begin(number, weight);
            let origin = self.space.origin(team.way);
            for k in team.range() {
                ants[k].begin(origin, self.streams.ant(number, k as u32));
                team.note(origin);
            }
        }
        self.constructing = true;
    }

    /// One move of every walking ant, in index order; true when none is left.
    fn move_all(&mut self) -> bool {
        self.move_ants(0..self.params.common.ants as usize)
    }

    fn end_iteration(&mut self) {
        let Some(Tables { teams, ants, .. }) = &mut self.tables else { return };
        self.constructing = false;
        let progress = &mut self.progress;
        progress.effort.iterations += 1;
        progress.effort.constructed_paths += ants.len() as u64;
        progress.effort.ant_moves += ants.iter().map(|a| u64::from(a.moves())).sum::<u64>();
        let number = progress.effort.iterations;
        let arrived = || ants.iter().filter_map(Walker::path);
        let best = arrived().reduce(|best, next| if next.1 < best.1 { next } else { best });
        if let Some((path, length)) = best
            && progress.best.as_ref().is_none_or(|b| length < b.length)
        {
            progress.best = Some(Solution { path: path.to_vec(), length, iteration: number, refined: None });
        }
        let tally: Tally = arrived().map(|(_, cost)| cost).collect();
        progress.record(tally.record(number, progress.best.as_ref()));
        teams.iter_mut().for_each(|team| team.update_trails(&self.params, ants, number));
        let common = &self.params.common;
        self.progress.status = self.progress.after_iteration(common.selection.iterations, common.walk.stagnation);
    }
}

impl<S: Space + 'static> Planner for FieldColony<S> {
    fn advance(&mut self, by: Granularity) -> Status {
        advance(self, by)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn budget(&self) -> Option<u32> {
        Some(self.params.common.selection.iterations)
    }

    fn colony_size(&self) -> u32 {
        self.params.common.ants
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.progress.bytes() + self.tables.as_ref().map_or(0, Tables::bytes)
    }

    fn moves_from(&self, place: Cell) -> Vec<MoveOdds> {
        self.odds_at(place)
    }

    fn ant(&self, number: u32) -> Option<Walked> {
        self.tables.as_ref()?.ants.get(number as usize).filter(|_| cfg!(feature = "whole")).map(Walker::walked)
    }

    fn turn_of(&self, number: u32) -> Option<Turn> {
        (cfg!(feature = "whole") && number < self.params.common.ants).then(|| self.clone().take_turn(number as usize))?
    }

    fn objective(&self) -> Objective {
        S::OBJECTIVE
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        self.show(kind, out)
    }

    fn layer_version(&self, kind: Layer) -> Option<u64> {
        let fades = self.params.force && self.params.force_fades;
        match kind {
            Layer::InitialTrail => Some(0),
            Layer::Heuristic => Some(if fades { u64::from(self.iteration()) } else { 0 }),
            _ => None,
        }
    }

    fn ants(&self, out: &mut Vec<Cell>) {
        out.clear();
        if let (Some(tables), true) = (&self.tables, self.constructing) {
            out.extend(tables.ants.iter().filter(|a| a.fate() != Fate::Lost).map(Walker::place));
        }
    }
}
