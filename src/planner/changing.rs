//! A planner whose walls change while it is at work.
//!
//! A change is made between two iterations. A planner that can ([`Planner::adapts`]) goes on with what it has learnt; any other begins anew
//! on the new map: its iterations are numbered through, its effort adds up, its best path is that of the new map. The digest takes in
//! each change with the iteration that it follows; without changes it is the planner's own.
//!
//! A change is noted with the number of an iteration, so that a run is repeated exactly, whatever its pace: the change is made at the end of
//! that iteration, or when the planner ends before. A search that begins anew is no wiser in the middle of a contour than at its end: it does
//! so at once, and the contours that it has closed count.

use std::num::NonZero;
use std::sync::Arc;

use super::{
    Build, Certificate, Effort, Granularity, Layer, MoveOdds, Objective, Planner, Progress, Record, Solution, Status, Turn,
    Walked, Weighed, held,
};
use crate::error::{ParamError, ScenarioError};
use crate::map::{Cell, Grid};
use crate::metrics::Metrics;
use crate::params::Values;
use crate::scenario::{Change, MAX_CHANGES, Scenario};

/// What a planner is made of, to make it once more.
struct Recipe {
    build: Build,
    values: Values,
    seed: u32,
}

/// The run of a planner that has begun anew: what came before, and what of its present stage has been taken in.
#[derive(Clone)]
struct Anew {
    progress: Progress,
    /// Spent before the present stage.
    before: Effort,
    /// Records of the present stage that have been taken in.
    taken: usize,
}

/// A planner and the changes that it has had and will have.
#[derive(Clone)]
pub struct Changing {
    planner: Box<dyn Planner>,
    recipe: Arc<Recipe>,
    /// The map as it is now.
    now: Arc<Scenario>,
    /// Changes to come, in the order of their iterations.
    due: Vec<Change>,
    /// Changes made.
    made: u32,
    /// Whether a change could be made right now.
    between: bool,
    /// None until it begins anew.
    anew: Option<Anew>,
    /// On which ants walk.
    threads: NonZero<usize>,
}

impl Changing {
    /// Makes a planner that takes the scenario's changes, and others while it is at work.
    ///
    /// # Errors
    /// As the planner's entry.
    pub fn new(scenario: &Arc<Scenario>, build: Build, values: Values, seed: u32) -> Result<Self, ParamError> {
        let planner = build(scenario, &values, seed)?;
        let recipe = Arc::new(Recipe { build, values, seed });
        let due = scenario.spec.changes.clone();
        let (now, threads) = (Arc::clone(scenario), NonZero::<usize>::MIN);
        let mut changing = Self { planner, recipe, now, due, made: 0, between: true, anew: None, threads };
        changing.make_due();
        Ok(changing)
    }

    /// The map as it is now, with the question asked on it.
    pub fn scenario(&self) -> &Arc<Scenario> {
        &self.now
    }

    /// How many changes have been made.
    pub fn made(&self) -> u32 {
        self.made
    }

    /// How many are still to come.
    pub fn to_come(&self) -> u32 {
        self.due.len() as u32
    }

    /// The map as the changes to come will leave it.
    pub fn coming(&self) -> Grid {
        let mut grid = self.now.drawn.clone();
        let make = |due: &Change| due.make(&mut grid, &self.now.spec, 0);
        self.due.iter().try_for_each(make).expect("a change is checked when it is taken");
        grid
    }

    /// The end of the iteration at work, where a change can be made next: the number of the last finished one if none is at work.
    pub fn next_end(&self) -> u32 {
        self.effort().iterations + u32::from(!self.between)
    }

    /// Takes a change that follows all others; it is made at once where the planner stands between two iterations and is that far.
    ///
    /// # Errors
    /// [`ScenarioError::Change`]: the cells cannot be blocked or freed then, the iteration is past, or there are [`MAX_CHANGES`] already.
    pub fn schedule(&mut self, change: Change) -> Result<(), ScenarioError> {
        let index = self.made as usize + self.due.len();
        if index >= MAX_CHANGES {
            let (field, value) = ("changes".into(), (index + 1).to_string());
            return Err(ScenarioError::Change { field, value, allowed: "a list of at most 1000" });
        }
        let earliest = self.due.last().map_or_else(|| self.next_end(), |last| last.at);
        if change.at < earliest {
            let (field, value) = (format!("changes[{index}].at"), change.at.to_string());
            return Err(ScenarioError::Change {
                field,
                value,
                allowed: "the iteration at work or a later one, after all other changes",
            });
        }
        change.make(&mut self.coming(), &self.now.spec, index)?;
        self.due.push(change);
        self.make_due();
        Ok(())
    }

    /// Makes the changes whose time has come.
    fn make_due(&mut self) {
        while let Some(change) = self.due.first()
            && self.between
            && (change.at <= self.effort().iterations || self.status().is_finished())
        {
            let change = self.due.remove(0);
            self.make(&change);
        }
    }

    fn make(&mut self, change: &Change) {
        let now = self.now.changed(change).expect("a change is checked when it is taken");
        self.now = Arc::new(now);
        self.made += 1;
        if self.planner.adapts() {
            self.planner.adapt(change, &self.now);
        } else {
            self.begin_anew(change);
        }
    }

    /// A move of a search may close several contours: those behind the change do not count.
    fn begin_anew(&mut self, change: &Change) {
        let first = || Progress::up_to(change.at, self.planner.history(), self.planner.effort());
        let mut progress = self.anew.take().map_or_else(first, |anew| anew.progress);
        progress.begin_anew(change);
        let Recipe { build, values, seed } = &*self.recipe;
        self.planner = build(&self.now, values, *seed).expect("the same values suit a map of the same size");
        self.planner.walk_on(self.threads);
        self.between = true;
        self.anew = Some(Anew { before: progress.effort, progress, taken: 0 });
    }

    /// Takes what the present stage has reached into the progress of all.
    fn take_in(&mut self) {
        let limit = self.due.first().map_or(u32::MAX, |change| change.at);
        let Some(Anew { progress, before, taken }) = &mut self.anew else { return };
        let stage = self.planner.progress();
        progress.effort = before.plus(stage.effort);
        progress.tour.clone_from(&stage.tour);
        let is_news = stage.history.len() > *taken || stage.status != progress.status;
        for record in &stage.history[*taken..] {
            let iteration = before.iterations + record.iteration;
            if iteration <= limit {
                progress.record(Record { iteration, ..*record });
            }
        }
        *taken = stage.history.len();
        if is_news {
            // 0 stays 0: the start is the goal.
            let iteration = |found: u32| if found == 0 { 0 } else { before.iterations + found };
            progress.best = stage.best.as_ref().map(|b| Solution { iteration: iteration(b.iteration), ..b.clone() });
        }
        progress.status = stage.status;
    }
}

impl Planner for Changing {
    fn advance(&mut self, by: Granularity) -> Status {
        let before = self.planner.effort().iterations;
        let status = self.planner.advance(by);
        let forgets = self.planner.budget().is_none() && !self.planner.adapts();
        let ended = self.planner.effort().iterations > before || status.is_finished();
        self.between = ended || forgets || by == Granularity::Iteration;
        self.take_in();
        self.make_due();
        self.status()
    }

    fn progress(&self) -> &Progress {
        self.anew.as_ref().map_or_else(|| self.planner.progress(), |anew| &anew.progress)
    }

    fn budget(&self) -> Option<u32> {
        let before = self.anew.as_ref().map_or(0, |anew| anew.before.iterations);
        self.planner.budget().map(|budget| before.saturating_add(budget))
    }

    fn colony_size(&self) -> u32 {
        self.planner.colony_size()
    }

    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        self.planner.layer(kind, out)
    }

    /// A planner that began anew counts from 0 again: the changes count more than all that it can count.
    fn layer_version(&self, kind: Layer) -> Option<u64> {
        self.planner.layer_version(kind).map(|version| u64::from(self.made) << 40 | version)
    }

    fn ants(&self, out: &mut Vec<Cell>) {
        self.planner.ants(out);
    }

    fn bytes(&self) -> usize {
        let cells = self.due.iter().map(|c| held(&c.blocked) + held(&c.freed)).sum::<usize>();
        let before = self.anew.as_ref().map_or(0, |anew| anew.progress.bytes());
        size_of::<Self>() + self.planner.bytes() + held(&self.due) + cells + before
    }

    fn moves_from(&self, cell: Cell) -> Vec<MoveOdds> {
        self.planner.moves_from(cell)
    }

    fn ant(&self, number: u32) -> Option<Walked> {
        self.planner.ant(number)
    }

    fn turn_of(&self, number: u32) -> Option<Turn> {
        self.planner.turn_of(number)
    }

    fn objective(&self) -> Objective {
        self.planner.objective()
    }

    fn goes_by_steps(&self) -> bool {
        self.planner.goes_by_steps()
    }

    fn value(&self, metrics: &Metrics) -> Option<f64> {
        self.planner.value(metrics)
    }

    fn weighed(&self) -> Option<Weighed> {
        self.planner.weighed()
    }

    fn certificate(&self) -> Option<Certificate> {
        self.planner.certificate()
    }

    fn walk_on(&mut self, threads: NonZero<usize>) -> bool {
        self.threads = threads;
        self.planner.walk_on(threads)
    }

    fn adapts(&self) -> bool {
        self.planner.adapts()
    }

    fn changing(&self) -> Option<&Changing> {
        Some(self)
    }

    fn changing_mut(&mut self) -> Option<&mut Changing> {
        Some(self)
    }
}
