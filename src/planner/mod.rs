//! The one interface of every planner: advance by a move or an iteration, and tell what stands.

pub mod ahead;
mod certificate;
#[cfg(feature = "whole")]
mod changing;
mod ground;
mod layer;
mod memory;
mod moves;
pub mod playback;
mod progress;
mod reading;
pub mod shades;
mod turn;

use std::num::NonZero;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::digest::Digest;
use crate::error::ParamError;
use crate::map::Cell;
use crate::metrics::{Metrics, WeightedSum};
use crate::params::{ParamSpec, Value, Values};
use crate::path::PathKind;
#[cfg(feature = "whole")]
use crate::scenario::Change;
use crate::scenario::Scenario;

pub use certificate::Certificate;
#[cfg(feature = "whole")]
pub use changing::Changing;
pub use ground::{Ground, GroundRule};
pub use layer::{Layer, extent};
pub(crate) use memory::{held, nested};
pub use moves::MoveOdds;
pub use progress::{Effort, Progress, Record, Refined, Solution, Tally, Tour};
pub(crate) use progress::{Iterations, advance, stand_ready};
pub use reading::{AT_GOAL, GoalStep, PaperReading, Reading};
pub use turn::{Fate, Turn, Walked};

/// How far one call of [`Planner::advance`] goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Granularity {
    /// One move of every living ant; one cell expansion of a search.
    Move,
    /// One iteration of a colony; one contour (whole number of f) of a search.
    Iteration,
}

/// Whether and how a planner has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Status {
    /// There is more to do.
    Running,
    /// The best path is proven optimal under the scenario's rules.
    Optimal,
    /// The search has ended, without a proof that nothing is better.
    Complete,
    /// No improvement for as long as the planner was told to wait.
    Stagnated,
    /// The budget of iterations is spent, or a search has done all the work that it may do.
    BudgetSpent,
    /// No path exists. An answer, not an error.
    NoPath,
}

impl Status {
    /// Whether nothing is left to do.
    pub fn is_finished(self) -> bool {
        self != Self::Running
    }
}

/// What a planner's result is measured by, and over which paths: it tells which exact planner is its yardstick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Objective {
    /// Length of a path of steps to the goal.
    #[default]
    Length,
    /// Length of a polyline to the goal, its segments in line of sight.
    PolylineLength,
    /// By slices: Σ √(1 + Δy² + Δh²) + |h|, or Σ √(1 + Δy² + Δh²), as the scenario says.
    SliceCost,
    /// V(d, r) of a path of steps to the goal.
    TurnIndex,
    /// A weighted sum of length, turns, closeness to obstacles and energy of a path of steps to the goal; [`Planner::weighed`] has the weights.
    Weighted,
    /// Length of a path of steps by all goals.
    TourLength,
    /// Σ R of a path of steps by all goals: the length of each leg times the weight of the goal that it leads to.
    TourWeight,
}

impl Objective {
    /// Every objective.
    pub const ALL: [Self; 7] = [
        Self::Length,
        Self::PolylineLength,
        Self::SliceCost,
        Self::TurnIndex,
        Self::Weighted,
        Self::TourLength,
        Self::TourWeight,
    ];

    /// Its id in files.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::PolylineLength => "polyline-length",
            Self::SliceCost => "slice-cost",
            Self::TurnIndex => "turn-index",
            Self::Weighted => "weighted",
            Self::TourLength => "tour-length",
            Self::TourWeight => "tour-weight",
        }
    }

    /// What it is, in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Length => "length by steps",
            Self::PolylineLength => "length of a polyline",
            Self::SliceCost => "cost by slices",
            Self::TurnIndex => "turn index V",
            Self::Weighted => "weighted sum J",
            Self::TourLength => "length by all goals",
            Self::TourWeight => "weight R by all goals",
        }
    }

    /// The same on weighted ground, where ways cost more than their length.
    #[cfg(feature = "whole")]
    pub const fn cost_words(self) -> &'static str {
        match self {
            Self::Length => "cost by steps",
            Self::PolylineLength => "cost of a polyline",
            Self::TourLength => "cost by all goals",
            Self::SliceCost | Self::TurnIndex | Self::Weighted | Self::TourWeight => self.words(),
        }
    }

    /// The value of a path of steps from start to goal that no planner has found; none where more than the path decides.
    pub fn of_steps(self, metrics: &Metrics) -> Option<f64> {
        match self {
            Self::Length | Self::PolylineLength | Self::TourLength => Some(metrics.made_small()),
            Self::TurnIndex => Some(metrics.turn_index),
            Self::SliceCost | Self::Weighted | Self::TourWeight => None,
        }
    }

    /// The kind of the paths that it compares.
    pub fn path_kind(self) -> PathKind {
        if self == Self::PolylineLength { PathKind::Polyline } else { PathKind::Steps }
    }
}

/// A result by a weighted sum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weighed {
    /// The weights.
    pub sum: WeightedSum,
    /// The value in cells; none while there is no result.
    pub value: Option<f64>,
}

/// A planner at work on one scenario.
///
/// ```
/// # use std::sync::Arc;
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::planner::{Granularity, Layer};
/// use formicarium::{catalog, params::Values, scenario::Scenario};
///
/// let scenario = Scenario::on(Grid::open(9, 9)?, Movement::default(), Point::new(0, 0), Point::new(8, 8))?;
/// let mut planner = catalog::build(&Arc::new(scenario), "ant-system", None, &Values::new(), 1)?;
/// planner.advance(Granularity::Iteration);
/// let mut before = planner.snapshot();
/// assert_eq!(planner.run(), before.run(), "a snapshot goes on to the same end");
/// assert_eq!(planner.digest().hex(), before.digest().hex());
///
/// let mut trails = Vec::new();
/// assert!(planner.layer(Layer::Trail, &mut trails));
/// assert_eq!(trails.len(), 9 * 9, "one value a cell, row by row");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Planner: Snapshot + Send {
    /// Goes one step further; inert once finished.
    fn advance(&mut self, by: Granularity) -> Status;
    /// Where it stands.
    fn progress(&self) -> &Progress;
    /// The budget of iterations; `None` for a search, which ends by itself.
    fn budget(&self) -> Option<u32> {
        None
    }
    /// Number of ants per iteration; 0 for a search.
    fn colony_size(&self) -> u32 {
        0
    }
    /// Writes a layer (one value a cell, row by row); false when the planner has no such layer.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool;
    /// A count that grows whenever a layer's values may have changed: while it stays, so do they. None where nobody counts: then every step
    /// may have changed them.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use formicarium::map::{Grid, Movement, Point};
    /// # use formicarium::planner::{Granularity, Layer};
    /// # use formicarium::{catalog, params::Values, scenario::Scenario};
    /// # let scenario = Scenario::on(Grid::open(9, 9)?, Movement::default(), Point::new(0, 0), Point::new(8, 8))?;
    /// let mut ants = catalog::build(&Arc::new(scenario), "ant-system", None, &Values::new(), 1)?;
    /// ants.advance(Granularity::Move);
    /// let before = ants.layer_version(Layer::Trail);
    /// ants.advance(Granularity::Move);
    /// assert_eq!(ants.layer_version(Layer::Trail), before, "ants deposit at the end of an iteration");
    /// ants.advance(Granularity::Iteration);
    /// assert!(ants.layer_version(Layer::Trail) > before);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn layer_version(&self, _kind: Layer) -> Option<u64> {
        None
    }
    /// Writes the cell of every living ant of the current iteration.
    fn ants(&self, out: &mut Vec<Cell>) {
        out.clear();
    }

    /// What a snapshot holds, in bytes: its own tables; not the scenario, nor what the planner's copies share.
    fn bytes(&self) -> usize;

    /// The moves among which an ant at a cell (by slices at a place) chooses, as it would see them that has visited nothing else: of the
    /// iteration at work or, between two of them, of the next. Empty where no ant goes on: at a goal, on a wall, in a planner without ants.
    fn moves_from(&self, _cell: Cell) -> Vec<MoveOdds> {
        Vec::new()
    }

    /// How far an ant has come in the iteration at work or, between two of them, in the one that has ended. Ants count from 0, with several
    /// goals those of the first leg first. None where there is no such ant, and before the first iteration.
    fn ant(&self, _number: u32) -> Option<Walked> {
        None
    }

    /// The next move of an ant, found on a copy, so that this planner stays as it is. Between two iterations it is the first move of the next
    /// one. None where there is no such ant, and once the planner has ended.
    fn turn_of(&self, _number: u32) -> Option<Turn> {
        None
    }

    /// Has the ants of an iteration walk on so many threads from now on; the results are the same for any number. False where they cannot,
    /// and nothing has changed: where ants share what changes while they walk, and in a planner without ants.
    fn walk_on(&mut self, _threads: NonZero<usize>) -> bool {
        false
    }

    /// What its result is measured by.
    fn objective(&self) -> Objective {
        Objective::Length
    }

    /// Whether its best path, as it was before any refinement, goes by steps from cell to cell, so that a robot can follow it.
    #[cfg(feature = "whole")]
    fn goes_by_steps(&self) -> bool {
        self.objective().path_kind() == PathKind::Steps
    }

    /// The lower bound that it has proven for what its result is measured by, at work as at its end; none before the first step, of a planner
    /// that proves nothing, and where there is no path. Looks at all that is open: not for every step.
    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        None
    }

    /// By which weights, and to what its result comes by them; only where its objective is [`Objective::Weighted`].
    fn weighed(&self) -> Option<Weighed> {
        None
    }

    /// Its result's value by its own objective, in cells, given the metrics of that result; none while there is none.
    fn value(&self, metrics: &Metrics) -> Option<f64> {
        match self.objective() {
            Objective::Length | Objective::PolylineLength | Objective::SliceCost | Objective::TourLength => {
                self.best().map(|b| b.result().1)
            }
            Objective::TurnIndex => Some(metrics.turn_index),
            Objective::Weighted => self.weighed().and_then(|weighed| weighed.value),
            Objective::TourWeight => self.tour().and_then(|t| t.walked_weight),
        }
    }

    /// Whether it can go on with what it has learnt on a map whose walls have changed; otherwise it begins anew there ([`Changing`]).
    #[cfg(feature = "whole")]
    fn adapts(&self) -> bool {
        false
    }

    /// Goes on from the map that `change` has led to, between two iterations; only where it [adapts](Planner::adapts). `to` may have another
    /// start: then a robot has moved on.
    #[cfg(feature = "whole")]
    fn adapt(&mut self, _change: &Change, _to: &Arc<Scenario>) {}

    /// The changes of the map that it has had, of a planner that takes them while it is at work.
    #[cfg(feature = "whole")]
    fn changing(&self) -> Option<&Changing> {
        None
    }

    /// The same, to take another one.
    #[cfg(feature = "whole")]
    fn changing_mut(&mut self) -> Option<&mut Changing> {
        None
    }

    /// Whether and how it has ended.
    fn status(&self) -> Status {
        self.progress().status
    }

    /// The best path of the finished iterations.
    fn best(&self) -> Option<&Solution> {
        self.progress().best.as_ref()
    }

    /// One record per finished iteration.
    fn history(&self) -> &[Record] {
        &self.progress().history
    }

    /// What has been spent.
    fn effort(&self) -> Effort {
        self.progress().effort
    }

    /// The order of the goals, of planners that choose one.
    fn tour(&self) -> Option<&Tour> {
        self.progress().tour.as_ref()
    }

    /// Digest over the history, the best path, its refinement, and the order of the goals.
    fn digest(&self) -> Digest {
        self.progress().digest()
    }

    /// Advances by iterations until finished.
    fn run(&mut self) -> Status {
        loop {
            let status = self.advance(Granularity::Iteration);
            if status.is_finished() {
                return status;
            }
        }
    }
}

/// What every planner that can be cloned is: its state is all that it depends on.
pub trait Snapshot {
    /// The same planner as it stands, with tables of its own: either goes on to the same end.
    fn snapshot(&self) -> Box<dyn Planner>;
}

impl<P: Planner + Clone + 'static> Snapshot for P {
    fn snapshot(&self) -> Box<dyn Planner> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn Planner> {
    fn clone(&self) -> Self {
        self.snapshot()
    }
}

/// What kind of planner an entry of the catalog is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Family {
    /// Ant colonies, also as a part of hybrids.
    AntColony,
    /// Particle swarms and fireworks.
    Swarm,
    /// Trees that grow by random samples.
    Sampling,
    /// Searches without a proof.
    Search,
    /// Searches with a proof.
    Exact,
}

impl Family {
    /// Whether its planners draw no random numbers and have no iterations: each of their runs is the same, whatever the seed.
    pub const fn needs_no_seed(self) -> bool {
        matches!(self, Self::Search | Self::Exact)
    }
}

/// A named parameter set, e.g. a paper's.
#[derive(Debug, Clone, Copy)]
pub struct Preset {
    /// Its name on the command line and in links.
    pub name: &'static str,
    /// The publication.
    pub source: &'static str,
    /// What it stands for, and what was converted.
    pub meaning: &'static str,
    /// Numbers by key; what is absent keeps the default.
    pub numbers: &'static [(&'static str, f64)],
    /// Ids of choices, `true` or `false` of flags, by key; what is absent keeps the default.
    pub choices: &'static [(&'static str, &'static str)],
    /// Which reading of the planner's publication it is; none where it is something else. A planner has at most one preset of each.
    pub reading: Option<PaperReading>,
}

impl Preset {
    /// Its values by key.
    pub fn values(&self) -> Values {
        let numbers = self.numbers.iter().map(|&(k, v)| (k.to_string(), Value::from(v)));
        let choice = |v: &str| v.parse::<bool>().map_or_else(|_| Value::from(v), Value::from);
        // One by one: to be collected they would be sorted, and the opening build sorts nothing else.
        let mut values = Values::new();
        values.extend(numbers.chain(self.choices.iter().map(|&(k, v)| (k.to_string(), choice(v)))));
        values
    }
}

/// What a publication adds to the rule that it starts from, so that a run without it can be held against the full planner.
#[derive(Debug, Clone, Copy)]
pub struct Component {
    /// Its id in entries of questions and in tables: a to z, 0 to 9 and -; it names the same thing in every planner.
    pub id: &'static str,
    /// Name for tables.
    pub name: &'static str,
    /// What the publication adds, in one sentence with its equations.
    pub adds: &'static str,
    /// The values that turn it off by key, as `--set` reads them; whatever else is given stays.
    pub without: &'static [(&'static str, &'static str)],
}

impl Component {
    /// The values that turn it off.
    pub fn values(&self) -> Values {
        self.without.iter().map(|&(key, text)| (key.to_string(), Value::parse(text))).collect()
    }
}

/// A planner in the catalog: its file's only export that others need.
#[derive(Debug, Clone, Copy)]
pub struct PlannerEntry {
    /// Stable id in links, files and records.
    pub id: &'static str,
    /// Name for people.
    pub name: &'static str,
    /// Kind of planner.
    pub family: Family,
    /// One sentence.
    pub summary: &'static str,
    /// The publication.
    pub source: &'static str,
    /// Named parameter sets.
    pub presets: &'static [Preset],
    /// What its publication adds, in the order in which it tells them; empty for a rule to start from.
    pub components: &'static [Component],
    /// The layers it can draw.
    pub layers: &'static [Layer],
    /// Most goals that it can visit: 1 for a planner from one place to another.
    pub max_goals: u32,
    /// The ways of moving that it knows.
    pub grounds: &'static [Ground],
    /// The rows of its parameters.
    pub specs: fn() -> Vec<ParamSpec>,
    /// Makes one, after checking the values.
    pub build: Build,
}

/// Makes a planner for a scenario from values and a seed.
pub type Build = fn(&Arc<Scenario>, &Values, u32) -> Result<Box<dyn Planner>, ParamError>;
