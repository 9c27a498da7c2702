//! Two planners in a row: the first one's best path shapes the trails of the colony that follows.
//!
//! The iterations of both are numbered through, effort adds up, and the best path is the best of both: what a hybrid spends and finds can
//! be held against planners that do it in one go.

use std::num::NonZero;
use std::sync::Arc;

use crate::map::Cell;
#[cfg(feature = "whole")]
use crate::path::PathKind;
use crate::planner::{
    Effort, Granularity, Layer, MoveOdds, Objective, Planner, Progress, Record, Solution, Status, Turn, Walked, Weighed,
};
use crate::scenario::Scenario;

use super::colony::{self, Colony};
use super::variant::Variant;

/// A planner, and then a colony on the trails that it seeds.
#[derive(Clone)]
pub struct Hybrid<V> {
    scenario: Arc<Scenario>,
    first: Box<dyn Planner>,
    /// The second stage without a seed.
    second: V,
    colony: Option<Colony<V>>,
    planner: &'static str,
    layers: &'static [Layer],
    seed: u32,
    progress: Progress,
    /// On which ants walk.
    threads: NonZero<usize>,
}

impl<V: Variant + 'static> Hybrid<V> {
    /// The planner whose streams are those of the id `planner`, with the first stage ready to run; `layers` are those of its entry.
    pub fn new(
        scenario: Arc<Scenario>,
        first: Box<dyn Planner>,
        second: V,
        (planner, layers): (&'static str, &'static [Layer]),
        seed: u32,
    ) -> Self {
        let (progress, threads) = (Progress::default(), NonZero::<usize>::MIN);
        Self { scenario, first, second, colony: None, planner, layers, seed, progress, threads }
    }

    /// The second stage, from what the first has found so far.
    fn second_stage(&self) -> Colony<V> {
        let found = self.first.best().map(|b| (b.path.clone(), b.length));
        let mut second = self.second.clone();
        second.take_seed(found.as_ref());
        let mut colony = Colony::new(Arc::clone(&self.scenario), second, self.planner, self.seed, 0);
        colony.walk_on(self.threads);
        colony
    }

    /// Goes from stage to stage, and ends.
    fn pass_on(&mut self, status: Status) {
        if self.colony.is_some() || matches!(status, Status::Optimal | Status::NoPath) {
            self.progress.status = status;
        } else if status.is_finished() {
            self.colony = Some(self.second_stage());
        }
    }
}

/// Takes the stage at work into the progress of both: `before` is what the stage before it has spent.
fn take_in(progress: &mut Progress, stage: &dyn Planner, before: Effort) {
    let (now, done) = (stage.effort(), progress.effort.iterations);
    progress.effort = before.plus(now);
    if let Some(best) = stage.best()
        && progress.best.as_ref().is_none_or(|b| best.length < b.length)
    {
        // 0 stays 0: the start is the goal.
        let iteration = if best.iteration == 0 { 0 } else { before.iterations + best.iteration };
        progress.best = Some(Solution { iteration, ..best.clone() });
    }
    if progress.effort.iterations > done
        && let Some(&last) = stage.history().last()
    {
        let best_so_far = progress.best.as_ref().map(|b| b.length);
        progress.record(Record { iteration: progress.effort.iterations, best_so_far, ..last });
    }
}

impl<V: Variant + 'static> Planner for Hybrid<V> {
    fn advance(&mut self, by: Granularity) -> Status {
        if self.progress.status.is_finished() {
            return self.progress.status;
        }
        let status = match &mut self.colony {
            None => {
                let status = self.first.advance(by);
                take_in(&mut self.progress, &*self.first, Effort::default());
                status
            }
            Some(colony) => {
                let status = colony.advance(by);
                take_in(&mut self.progress, colony, self.first.effort());
                status
            }
        };
        self.pass_on(status);
        self.progress.status
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn bytes(&self) -> usize {
        let second = self.colony.as_ref().map_or(0, |colony| colony.bytes() - size_of::<Colony<V>>());
        size_of::<Self>() + self.progress.bytes() + self.first.bytes() + second
    }

    fn walk_on(&mut self, threads: NonZero<usize>) -> bool {
        self.threads = threads;
        if let Some(colony) = &mut self.colony {
            colony.walk_on(threads);
        }
        Colony::<V>::ON_THREADS
    }

    /// Those of the colony; none while the first stage runs, which has no ants.
    fn moves_from(&self, cell: Cell) -> Vec<MoveOdds> {
        self.colony.as_ref().map_or_else(Vec::new, |colony| colony.moves_from(cell))
    }

    fn ant(&self, number: u32) -> Option<Walked> {
        self.colony.as_ref()?.ant(number)
    }

    fn turn_of(&self, number: u32) -> Option<Turn> {
        self.colony.as_ref()?.turn_of(number)
    }

    fn objective(&self) -> Objective {
        colony::objective(&self.second)
    }

    #[cfg(feature = "whole")]
    fn goes_by_steps(&self) -> bool {
        self.second.path_kind() == PathKind::Steps
    }

    fn weighed(&self) -> Option<Weighed> {
        colony::weighed(&self.second, &self.scenario, self.best())
    }

    fn budget(&self) -> Option<u32> {
        self.first.budget().map(|first| first + self.second.settings().iterations)
    }

    fn colony_size(&self) -> u32 {
        self.second.settings().ants
    }

    /// While the first stage runs: its visits and priorities, the trails without a seed, and the initial trail that it would leave now.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        out.resize(self.scenario.grid.len(), 0.0);
        match (kind, &self.colony) {
            _ if !self.layers.contains(&kind) => return false,
            (Layer::Cost | Layer::Scent | Layer::Merged, _) => return false,
            (Layer::SeedPath, _) => self.first.best().into_iter().flat_map(|b| &b.path).for_each(|&c| out[c as usize] = 1.0),
            (Layer::Priority, _) | (Layer::Visits, None) => return self.first.layer(kind, out),
            (Layer::Trail, None) => out.fill(self.second.initial_trail(&self.scenario) as f32),
            (Layer::Heuristic | Layer::InitialTrail | Layer::Density, None) => return self.second_stage().layer(kind, out),
            (Layer::Trail | Layer::Visits | Layer::Heuristic | Layer::InitialTrail | Layer::Density, Some(colony)) => {
                return colony.layer(kind, out);
            }
        }
        true
    }

    fn layer_version(&self, kind: Layer) -> Option<u64> {
        match kind {
            Layer::SeedPath | Layer::Priority => self.colony.as_ref().map(|_| 0),
            _ => self.colony.as_ref().and_then(|colony| colony.layer_version(kind)),
        }
    }

    fn ants(&self, out: &mut Vec<Cell>) {
        match &self.colony {
            Some(colony) => colony.ants(out),
            None => out.clear(),
        }
    }
}
