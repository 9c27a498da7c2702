//! F-RRT*: Liao, Wan, Hua, Ma, Zhu, Qing, "F-RRT*: An improved path planning algorithm with improved initial solution and convergence
//! rate", Expert Systems with Applications 184 (2021) 115457, doi:10.1016/j.eswa.2021.115457. The ship paper names it as the source of its
//! path refinement, "which by random samples makes a tree that spreads to the goal, and prunes it" (`docs/papers/ship.md`).
//!
//! It is RRT* (Karaman, Frazzoli, "Sampling-based algorithms for optimal motion planning", International Journal of Robotics Research 30
//! (2011) 846–894, doi:10.1177/0278364911406761) but for the parent of a sample, which it makes instead of choosing it:
//!
//! | step | what | function |
//! |---|---|---|
//! | SampleFree, Nearest | a random cell, and the node nearest to it, which must see it | [`FRrtStar`], [`Tree::nearest`] |
//! | FindReachest | the last ancestor of the nearest node, one after the other, that sees the sample | [`find_reachest`] |
//! | CreateNode | by bisection a node near the obstacle that hides the sample from that one's own parent: first towards that parent, then from there towards the sample, until the bracket is no longer than D_dichotomy | [`create_node`] |
//! | Rewire | near nodes are hung on the sample where that is shorter; near is γ·√(ln n / n) | [`radius`] |
//!
//! We had the publication's summary and what others tell of it, not its text. Ours: nodes are centres of cells, so what bisection finds is
//! rounded to a cell; a made node must see both the sample and the parent, and is taken only where it shortens the way. A cell that is
//! sampled again looks for a shorter way. Samples are cells that can be reached by steps, with a probability (`goal_bias`) the goal itself;
//! the goal joins as any other. There is no step by default: the tree reaches for the sample itself. With one (`step`) the tree goes so
//! far towards it, and near is no farther (as in RRT*). γ is in multiples of the least that makes RRT* optimal in the limit,
//! √(3·free cells / π). An iteration is a batch of samples, as many as the ship paper's colonies have ants. With 4 moves there is sight
//! along rows and columns only.

use std::f64::consts::PI;
use std::sync::Arc;

use rand::Rng;

use crate::error::ParamError;
use crate::map::{Cell, Point};
use crate::metrics::SAME_LENGTH;
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{
    Family, Granularity, Ground, Iterations, Layer, Objective, Planner, PlannerEntry, Progress, Record, Solution, Status,
    advance, held,
};
use crate::rng::{Streams, unit_f32};
use crate::scenario::Scenario;

use super::tree::{Tree, distance, squared};

params! {
    /// Parameters of F-RRT*.
    pub struct FRrtStarParams {
        /// iterations after which the tree stops growing
        iterations: u32 = 100, "", [1..=100_000], "iterations", "our choice: as many as the ship paper's colonies have";
        /// samples of each iteration
        samples: u32 = 50, "", [1..=1024], "samples", "our choice: as many as the ship paper's colonies have ants";
        /// probability that a sample is the goal itself
        goal_bias: f64 = 0.05, "", [0.0..=1.0], "", "our choice: not given";
        /// how far the tree goes towards a sample at a time; 0 = as far as the sample is
        step: u32 = 0, "η", [0..=10_000], "cells", "our choice; Karaman and Frazzoli 2011: a constant";
        /// within which radius nodes are hung on a new one where that is shorter, as a multiple of the least that leads to an optimum
        near: f64 = 1.1, "γ", [0.0..=10.0], "× γ*", "Karaman and Frazzoli 2011, theorem 38: above 1";
        /// how exactly a node beside an obstacle is looked for: bisection ends when the bracket is no longer
        dichotomy: u32 = 1, "D_dichotomy", [1..=10_000], "cells", "Liao et al. 2021; our choice: a cell";
        /// stops after this many iterations without a shorter path; 0 = never
        stagnation: u32 = 0, "", [0..=100_000], "iterations", "our addition";
    }
}

/// The farthest ancestor of `from`, one after the other, that sees the sample; `from` sees it.
pub fn find_reachest(tree: &mut Tree, scenario: &Scenario, from: Cell, sample: Cell) -> Cell {
    let mut reachest = from;
    while let Some(parent) = tree.parent(reachest).filter(|&parent| tree.sees(scenario, parent, sample)) {
        reachest = parent;
    }
    reachest
}

/// A cell between the parent of `reachest` and the sample that sees both and makes the way shorter than by `reachest`; none where there is
/// nothing to cut off.
pub fn create_node(tree: &mut Tree, scenario: &Scenario, reachest: Cell, sample: Cell, dichotomy: u32) -> Option<Cell> {
    let parent = tree.parent(reachest)?;
    let at_parent = scenario.grid.point(parent);
    let mut allow = scenario.grid.point(reachest);
    for end in [at_parent, scenario.grid.point(sample)] {
        let mut forbid = end;
        while squared(allow, forbid) > u64::from(dichotomy) * u64::from(dichotomy) {
            let middle = Point::new(u32::midpoint(allow.x, forbid.x), u32::midpoint(allow.y, forbid.y));
            if middle == allow || middle == forbid {
                break;
            }
            let cell = scenario.grid.cell(middle);
            let sees_both =
                !scenario.grid.is_blocked(cell) && tree.sees(scenario, cell, sample) && tree.sees(scenario, parent, cell);
            if sees_both { allow = middle } else { forbid = middle }
        }
    }
    let made = scenario.grid.cell(allow);
    let by = |node| distance(scenario, parent, node) + distance(scenario, node, sample);
    (by(made) < by(reachest) - SAME_LENGTH).then_some(made)
}

/// γ·√(ln n / n) for n nodes, γ = `near`·√(3·free cells / π), and no more than the step where there is one.
pub fn radius(p: &FRrtStarParams, free: usize, nodes: usize) -> f64 {
    let n = nodes as f64;
    let radius = p.near * libm::sqrt(3.0 * free as f64 / PI) * libm::sqrt(libm::log(n) / n);
    if p.step > 0 { radius.min(f64::from(p.step)) } else { radius }
}

/// What the planner needs while it works; allocated at its first step.
#[derive(Clone)]
struct Tables {
    tree: Tree,
    /// The cells that can be sampled; no copy changes them.
    free: Arc<[Cell]>,
    /// Nodes near the sample.
    near: Vec<Cell>,
}

impl Tables {
    fn new(scenario: &Scenario) -> Self {
        let reached = scenario.moves.reached_from(scenario.start);
        let free = (0..scenario.grid.len() as Cell).filter(|&c| reached[c as usize]).collect();
        Self { tree: Tree::new(scenario), free, near: Vec::new() }
    }

    /// Takes a sample in.
    fn grow(&mut self, p: &FRrtStarParams, scenario: &Scenario, sample: Cell) {
        let Some(nearest) = self.tree.nearest(scenario, sample) else { return };
        let sample = towards(scenario, nearest, sample, p.step);
        if sample == nearest || scenario.grid.is_blocked(sample) || !self.tree.sees(scenario, nearest, sample) {
            return;
        }
        let radius = radius(p, self.free.len(), self.tree.nodes().len());
        self.tree.near(scenario, sample, radius, &mut self.near);
        let reachest = find_reachest(&mut self.tree, scenario, nearest, sample);
        let made = create_node(&mut self.tree, scenario, reachest, sample, p.dichotomy);
        let made = made.zip(self.tree.parent(reachest));
        let on = made.map_or(reachest, |(made, parent)| {
            self.hang_if_shorter(scenario, made, parent);
            made
        });
        self.hang_if_shorter(scenario, sample, on);
        for i in 0..self.near.len() {
            self.rewire(scenario, self.near[i], sample);
        }
    }

    /// Hangs a cell on a node that sees it, where that makes the way to it shorter.
    fn hang_if_shorter(&mut self, scenario: &Scenario, cell: Cell, on: Cell) {
        let tree = &mut self.tree;
        if tree.cost(scenario, on) + distance(scenario, on, cell) < tree.cost(scenario, cell) - SAME_LENGTH {
            tree.hang(cell, on);
        }
    }

    /// Hangs a near node on the sample, where that is shorter and in sight. No node that the sample's way leads by is: its way is no longer.
    fn rewire(&mut self, scenario: &Scenario, node: Cell, sample: Cell) {
        let tree = &mut self.tree;
        let by_sample = tree.cost(scenario, sample) + distance(scenario, sample, node);
        if by_sample < tree.cost(scenario, node) - SAME_LENGTH && tree.sees(scenario, sample, node) {
            tree.hang(node, sample);
        }
    }
}

/// The cell a step from one cell towards another; the other one where that is no farther, or where the step is 0.
fn towards(scenario: &Scenario, from: Cell, to: Cell, step: u32) -> Cell {
    let (a, b) = (scenario.grid.point(from), scenario.grid.point(to));
    if step == 0 || squared(a, b) <= u64::from(step) * u64::from(step) {
        return to;
    }
    let part = f64::from(step) / a.distance(b);
    let between = |a: u32, b: u32| libm::round(f64::from(a) + part * (f64::from(b) - f64::from(a))) as u32;
    scenario.grid.cell(Point::new(between(a.x, b.x), between(a.y, b.y)))
}

/// F-RRT* at work on one scenario.
#[derive(Clone)]
pub struct FRrtStar {
    scenario: Arc<Scenario>,
    params: FRrtStarParams,
    streams: Streams,
    tables: Option<Tables>,
    /// Samples of the iteration at work.
    sampled: u32,
    progress: Progress,
}

impl FRrtStar {
    /// With these parameters.
    pub fn new(scenario: Arc<Scenario>, params: FRrtStarParams, seed: u32) -> Self {
        let streams = Streams::new(u64::from(seed), ENTRY.id, 0);
        Self { scenario, params, streams, tables: None, sampled: 0, progress: Progress::default() }
    }
}

impl Iterations for FRrtStar {
    fn parts(&mut self) -> (&mut Progress, &Scenario) {
        (&mut self.progress, &self.scenario)
    }

    fn is_prepared(&self) -> bool {
        self.tables.is_some()
    }

    fn prepare(&mut self) {
        self.tables = Some(Tables::new(&self.scenario));
    }

    /// One sample.
    fn move_all(&mut self) -> bool {
        let Some(tables) = &mut self.tables else { return true };
        let mut stream = self.streams.ant(self.progress.effort.iterations + 1, self.sampled);
        let [bias, place] = [(); 2].map(|()| f64::from(unit_f32(stream.next_u32())));
        let drawn = tables.free[(place * tables.free.len() as f64) as usize];
        let sample = if bias < self.params.goal_bias { self.scenario.goal } else { drawn };
        tables.grow(&self.params, &self.scenario, sample);
        self.sampled += 1;
        self.progress.effort.constructed_paths += 1;
        self.progress.effort.ant_moves = tables.tree.looked_along();
        self.sampled == self.params.samples
    }

    fn end_iteration(&mut self) {
        self.sampled = 0;
        self.progress.effort.iterations += 1;
        let number = self.progress.effort.iterations;
        if let Some(tables) = self.tables.as_ref().filter(|tables| tables.tree.holds(self.scenario.goal)) {
            let path = tables.tree.way(self.scenario.goal);
            let length = self.scenario.path_length(&path);
            if self.progress.best.as_ref().is_none_or(|best| length < best.length - SAME_LENGTH) {
                self.progress.best = Some(Solution { path, length, iteration: number, refined: None });
            }
        }
        self.progress.record(Record::of_search(number, self.progress.best.as_ref().map(|best| best.length)));
        self.progress.status = self.progress.after_iteration(self.params.iterations, self.params.stagnation);
    }
}

impl Planner for FRrtStar {
    fn advance(&mut self, by: Granularity) -> Status {
        advance(self, by)
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn budget(&self) -> Option<u32> {
        Some(self.params.iterations)
    }

    /// Samples.
    fn colony_size(&self) -> u32 {
        self.params.samples
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.progress.bytes() + self.tables.as_ref().map_or(0, |t| t.tree.bytes() + held(&t.near))
    }

    fn objective(&self) -> Objective {
        Objective::PolylineLength
    }

    /// The tree: how long the way to each cell is that its segments cross.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        out.resize(self.scenario.grid.len(), f32::INFINITY);
        if let Some(tables) = &self.tables {
            tables.tree.draw(&self.scenario, |c, way| out[c as usize] = out[c as usize].min(way as f32));
        }
        kind == Layer::Cost
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    Ok(Box::new(FRrtStar::new(Arc::clone(scenario), FRrtStarParams::read(ENTRY.id, values)?, seed)))
}

/// F-RRT* in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "f-rrt-star",
    name: "F-RRT*",
    family: Family::Sampling,
    summary: "A tree grows from the start towards random cells by straight segments of any angle; the parent of each is made beside the obstacle in the way, and near nodes are hung where the way is shorter (Liao et al. 2021).",
    source: "Liao, Wan, Hua, Ma, Zhu, Qing 2021, Expert Systems with Applications 184, 115457, doi:10.1016/j.eswa.2021.115457",
    presets: &[],
    components: &[],
    layers: &[Layer::Cost],
    max_goals: 1,
    grounds: Ground::PLANE,
    specs: FRrtStarParams::specs,
    build,
};
