//! Several goals on two levels: first the order (a colony on the complete graph of start and goals, and where asked for a search after it), then
//! one colony for each leg.
//!
//! All legs advance together, iteration by iteration, so that a whole path stands after the first iteration. Each leg has streams of its
//! own (run = its place in the order), so its walk does not depend on the others'. A record of the history is the sum over the legs.
//!
//! Effort: the searches between the goals count as cell expansions. Tours of the order level are no paths on the map: they count neither as
//! iterations nor as constructed paths nor as moves. On that level a move is one search, one iteration of the order colony or one step of the
//! search for the best order; an iteration goes through all of it and on to the end of the legs' first iteration.
//!
//! Proof: the lengths by which the order is chosen are those of shortest paths, so a bound of all orders bounds all paths by all goals. Where the
//! order is proven and each leg is as short as its shortest path, so is the whole.

mod proof;
mod record;

use std::num::NonZero;
use std::sync::Arc;

use crate::exact::order::{self, Costs, Shape};
use crate::map::Cell;
#[cfg(feature = "whole")]
use crate::planner::Certificate;
use crate::planner::{Granularity, Layer, MoveOdds, Objective, Planner, Progress, Status, Turn, Walked, nested};
use crate::rng::Streams;
use crate::scenario::Scenario;

use super::colony::Colony;
use super::order_solve::{OrderProof, OrderSolver, Solving};
use super::tour::{OrderColony, TourSettings};
use super::variant::Variant;

/// The run of the streams of the order level; legs count from 0.
const ORDER_RUN: u32 = u32::MAX;

/// How the order of the goals is chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrderLevel {
    /// Of the colony on the complete graph.
    pub settings: TourSettings,
    /// Whether costs are lengths times the weight of the goal (Σ R), or lengths alone.
    pub weighted: bool,
    /// Whether lengths are straight lines, or shortest paths on the map.
    pub straight: bool,
    /// What a search makes of the colony's tours; none where the colony's best stands. Not for straight lines, which prove nothing.
    pub solving: Option<Solving>,
}

/// A planner for one goal or several: with one there is no order to choose, and it is the variant's colony alone. Its streams are those
/// of the planner with the id `streams`; `layers` are those of its entry.
pub fn planner<V: Variant + 'static>(
    scenario: &Arc<Scenario>,
    level: OrderLevel,
    variant: V,
    (streams, layers): (&'static str, &'static [Layer]),
    seed: u32,
) -> Box<dyn Planner> {
    let scenario = Arc::clone(scenario);
    if scenario.goals.len() == 1 {
        let (walked_on, variant) = variant.of_leg(&scenario);
        Box::new(Colony::new(walked_on, variant, streams, seed, 0))
    } else {
        Box::new(Legs {
            scenario,
            level,
            variant,
            streams,
            layers,
            seed,
            stage: Stage::Begin,
            proof: None,
            ordering: 0,
            legs: Vec::new(),
            progress: Progress::default(),
            threads: NonZero::<usize>::MIN,
        })
    }
}

/// What is being done.
#[derive(Clone)]
enum Stage {
    /// Nothing yet.
    Begin,
    /// Shortest paths between the goals: a row for each search that has ended.
    Measuring(Vec<Vec<f64>>),
    /// The order, by these lengths.
    Ordering(Costs, Box<OrderSolver>),
    /// The legs.
    Walking,
}

/// A colony for each leg, after a colony for their order.
#[derive(Clone)]
struct Legs<V> {
    scenario: Arc<Scenario>,
    level: OrderLevel,
    variant: V,
    streams: &'static str,
    layers: &'static [Layer],
    seed: u32,
    stage: Stage,
    /// What is proven of the order.
    proof: Option<OrderProof>,
    /// Expansions of the searches between the goals.
    ordering: u64,
    /// In the order of the tour; empty before the legs are walked.
    legs: Vec<Colony<V>>,
    progress: Progress,
    /// On which ants walk.
    threads: NonZero<usize>,
}

impl<V: Variant + 'static> Legs<V> {
    /// One step of the order level; false once the legs are walked.
    fn choose_order(&mut self) -> bool {
        let scenario = &self.scenario;
        match &mut self.stage {
            Stage::Begin if !scenario.reachable() => self.progress.status = Status::NoPath,
            Stage::Begin if self.level.straight => self.begin_ordering(Costs::euclidean(scenario)),
            Stage::Begin => self.stage = Stage::Measuring(Vec::new()),
            Stage::Measuring(rows) if rows.len() < scenario.goals.len() => {
                let (row, expansions) = order::grid_row(scenario, rows.len());
                rows.push(row);
                self.ordering += expansions;
                self.progress.effort.cell_expansions = self.ordering;
            }
            Stage::Measuring(rows) => {
                let lengths = Costs::symmetric(rows);
                self.begin_ordering(lengths);
            }
            Stage::Ordering(_, ordering) if ordering.is_finished() => self.begin_walking(),
            Stage::Ordering(lengths, ordering) => {
                ordering.advance();
                self.progress.tour = ordering.best().map(|best| order::planned(scenario, lengths, best.0.to_vec()));
                self.proof = ordering.proof();
            }
            Stage::Walking => return false,
        }
        true
    }

    fn begin_ordering(&mut self, lengths: Costs) {
        let costs = if self.level.weighted { lengths.weighted(&self.scenario) } else { lengths.clone() };
        let streams = Streams::new(u64::from(self.seed), self.streams, ORDER_RUN);
        let colony = OrderColony::new(costs.clone(), Shape::Open, self.level.settings, streams);
        let solving = self.level.solving.unwrap_or(Solving::NONE);
        let ordering = Box::new(OrderSolver::new(costs, Shape::Open, solving, colony));
        self.stage = Stage::Ordering(lengths, ordering);
    }

    fn begin_walking(&mut self) {
        let mut from = self.scenario.start;
        for (run, &goal) in self.progress.tour.iter().flat_map(|t| &t.order).enumerate() {
            let to = self.scenario.goals[goal as usize];
            let leg = Arc::new(self.scenario.leg(from, to));
            let (walked_on, variant) = self.variant.of_leg(&leg);
            let mut colony = Colony::new(walked_on, variant, self.streams, self.seed, run as u32).never_stagnates();
            colony.walk_on(self.threads);
            self.legs.push(colony);
            from = to;
        }
        self.stage = Stage::Walking;
    }

    /// A move or the rest of the iteration, of every leg that has not ended its iteration yet.
    fn walk(&mut self, by: Granularity) {
        let number = self.progress.effort.iterations + 1;
        let mut done = true;
        for leg in &mut self.legs {
            let ended = |leg: &Colony<V>| leg.status().is_finished() || leg.effort().iterations == number;
            if !ended(leg) {
                leg.advance(by);
            }
            done &= ended(leg);
        }
        if done {
            self.end_iteration(number);
        }
    }

    /// The leg to which an ant belongs, and its number there.
    fn leg_of(&self, number: u32) -> Option<(u32, &Colony<V>, u32)> {
        let leg = number / self.colony_size();
        self.legs.get(leg as usize).map(|colony| (leg, colony, number % self.colony_size()))
    }
}

impl<V: Variant + 'static> Planner for Legs<V> {
    fn advance(&mut self, by: Granularity) -> Status {
        while !self.progress.status.is_finished() {
            let ordering = self.choose_order();
            if !ordering {
                self.walk(by);
            }
            if by == Granularity::Move || !ordering {
                break;
            }
        }
        self.progress.status
    }

    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn budget(&self) -> Option<u32> {
        Some(self.variant.settings().iterations)
    }

    fn bytes(&self) -> usize {
        let order = match &self.stage {
            Stage::Measuring(rows) => nested(rows),
            Stage::Ordering(_, ordering) => size_of::<OrderSolver>() + ordering.bytes(),
            Stage::Begin | Stage::Walking => 0,
        };
        let spare = (self.legs.capacity() - self.legs.len()) * size_of::<Colony<V>>();
        size_of::<Self>() + self.progress.bytes() + order + spare + self.legs.iter().map(Colony::bytes).sum::<usize>()
    }

    #[cfg(feature = "whole")]
    fn certificate(&self) -> Option<Certificate> {
        self.proven()
    }

    /// A colony for each leg, in visiting order; none before the legs are walked.
    fn moves_from(&self, cell: Cell) -> Vec<MoveOdds> {
        let of_leg =
            |(leg, colony): (u32, &Colony<V>)| colony.moves_from(cell).into_iter().map(move |m| MoveOdds { colony: leg, ..m });
        (0..).zip(&self.legs).flat_map(of_leg).collect()
    }

    fn ant(&self, number: u32) -> Option<Walked> {
        let (_, colony, ant) = self.leg_of(number)?;
        colony.ant(ant)
    }

    /// An ant of a leg that has ended its iteration waits for the others.
    fn turn_of(&self, number: u32) -> Option<Turn> {
        let (leg, colony, ant) = self.leg_of(number).filter(|_| !self.status().is_finished())?;
        let waits = colony.status().is_finished() || colony.effort().iterations > self.effort().iterations;
        let mut turn = if waits { Turn::over(colony.ant(ant)?) } else { colony.turn_of(ant)? };
        turn.odds.iter_mut().for_each(|odds| odds.colony = leg);
        Some(turn)
    }

    fn walk_on(&mut self, threads: NonZero<usize>) -> bool {
        self.threads = threads;
        for leg in &mut self.legs {
            leg.walk_on(threads);
        }
        Colony::<V>::ON_THREADS
    }

    /// Ants of each leg.
    fn colony_size(&self) -> u32 {
        self.variant.settings().ants
    }

    fn objective(&self) -> Objective {
        if self.level.weighted { Objective::TourWeight } else { Objective::TourLength }
    }

    /// Visits: the sum over the legs; every other layer: the largest value of a leg. All 0 while the order is being chosen.
    fn layer(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        out.resize(self.scenario.grid.len(), 0.0);
        let mut of_leg = Vec::new();
        for leg in &self.legs {
            leg.layer(kind, &mut of_leg);
            for (all, one) in out.iter_mut().zip(&of_leg) {
                *all = if kind == Layer::Visits { *all + one } else { all.max(*one) };
            }
        }
        self.layers.contains(&kind)
    }

    /// No version gets smaller, so that their sum tells whether one has changed.
    fn layer_version(&self, kind: Layer) -> Option<u64> {
        self.legs.iter().try_fold(self.legs.len() as u64, |sum, leg| Some(sum + leg.layer_version(kind)?))
    }

    fn ants(&self, out: &mut Vec<Cell>) {
        out.clear();
        let mut of_leg = Vec::new();
        for leg in &self.legs {
            leg.ants(&mut of_leg);
            out.append(&mut of_leg);
        }
    }
}
