//! What a best-first search knows: the ways found so far, and the states that wait.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::exact::frontier::Frontier;
use crate::exact::search::contour;
use crate::metrics::SAME_LENGTH;
use crate::planner::held;
use crate::scenario::Scenario;

/// A cell, or a cell and what else the cost of the next step depends on.
pub(in crate::exact) type State = u32;

/// Parent of the start.
pub(super) const NO_PARENT: State = State::MAX;

/// A state that waits to be expanded.
#[derive(Clone, Copy)]
pub(in crate::exact) struct Open {
    pub(in crate::exact) state: State,
    /// Cost from the start.
    pub(in crate::exact) g: f64,
    /// That and the estimate.
    pub(in crate::exact) f: f64,
}

impl Ord for Open {
    /// Smallest f first, of equals the farthest from the start, of equals the first state.
    fn cmp(&self, other: &Self) -> Ordering {
        other.f.total_cmp(&self.f).then(self.g.total_cmp(&other.g)).then(other.state.cmp(&self.state))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Open {}

/// Buckets of the queue to a contour of f, which is a cell unless a terrain has longer steps: narrow enough that a bucket's heap is small.
const BUCKETS_PER_CONTOUR: f64 = 4.0;

/// The open states, the least first: those of the bucket at work in a heap, the others unsorted until their bucket's turn comes.
#[derive(Clone, Default)]
pub(super) struct Queue {
    heap: BinaryHeap<Open>,
    later: Frontier<Open>,
    /// f at which bucket 0 begins.
    base: f64,
    buckets_per_cell: f64,
}

impl Queue {
    /// Has a state wait; it is up to date.
    #[inline]
    pub(in crate::exact) fn push(&mut self, open: Open) {
        let bucket = ((open.f - self.base) * self.buckets_per_cell) as u32 as usize;
        if bucket <= self.later.at_work() {
            self.heap.push(open);
        } else {
            self.later.file(bucket, open);
        }
    }

    fn peek(&mut self) -> Option<&Open> {
        while self.heap.is_empty() && self.later.has_more() {
            self.later.next();
            self.heap.extend(self.later.take());
        }
        self.heap.peek()
    }

    /// Without the state that was seen last by [`Queue::peek`].
    pub(in crate::exact) fn pop(&mut self) {
        self.heap.pop();
    }

    #[cfg(feature = "whole")]
    fn waiting(&self) -> impl Iterator<Item = &Open> {
        self.heap.iter().chain(self.later.waiting())
    }

    fn bytes(&self) -> usize {
        self.heap.capacity() * size_of::<Open>() + self.later.bytes()
    }
}

/// The ways found so far.
#[derive(Clone)]
pub(in crate::exact) struct Tree {
    /// Cost from the start by state; empty until the first step.
    pub(super) g: Vec<f64>,
    parent: Vec<State>,
    pub(super) expanded: Vec<bool>,
    pub(super) open: Queue,
    /// Cost of the best way to the goal so far, and the state at its end.
    pub(super) bound: f64,
    pub(super) arrived: State,
}

impl Tree {
    pub(in crate::exact) fn new(states: usize) -> Self {
        let (g, parent, expanded) = (vec![f64::INFINITY; states], vec![NO_PARENT; states], vec![false; states]);
        Self { g, parent, expanded, open: Queue::default(), bound: f64::INFINITY, arrived: NO_PARENT }
    }

    /// For a scenario's search over so many states, which begins at this estimate.
    pub(in crate::exact) fn along(scenario: &Scenario, states: usize, to_goal: f64) -> Self {
        let mut tree = Self::new(states);
        tree.open.base = libm::floor(to_goal);
        tree.open.buckets_per_cell = BUCKETS_PER_CONTOUR / contour(scenario);
        tree
    }

    /// Opens the state in which the search begins.
    pub(in crate::exact) fn begin(&mut self, state: State, to_goal: f64, at_goal: bool) {
        self.relax(state, 0.0, to_goal, NO_PARENT, at_goal);
    }

    /// Cost of the best way to the goal so far; infinite while none is known.
    pub(in crate::exact) fn bound(&self) -> f64 {
        self.bound
    }

    /// Has only ways that are better than this be looked for.
    pub(in crate::exact) fn bound_by(&mut self, cost: f64) {
        self.bound = cost;
    }

    /// Whether a way to the goal was found.
    pub(in crate::exact) fn has_arrived(&self) -> bool {
        self.arrived != NO_PARENT
    }

    /// Cost of the best way to a state so far.
    #[inline]
    pub(in crate::exact) fn g(&self, state: State) -> f64 {
        self.g[state as usize]
    }

    /// Where that way comes from; the start comes from itself.
    #[inline]
    pub(in crate::exact) fn parent(&self, state: State) -> State {
        let parent = self.parent[state as usize];
        if parent == NO_PARENT { state } else { parent }
    }

    /// Whether a way of cost g to a state is cheaper than the one known.
    #[inline]
    pub(in crate::exact) fn is_cheaper(&self, state: State, g: f64) -> bool {
        g < self.g[state as usize] - SAME_LENGTH
    }

    /// Whether a way of cost f is better than the best one known.
    #[inline]
    pub(in crate::exact) fn is_below_bound(&self, f: f64) -> bool {
        f < self.bound - SAME_LENGTH
    }

    /// Whether a way of cost g to a state, with this estimate of the rest, can lead to a better result.
    #[inline]
    pub(in crate::exact) fn improves(&self, state: State, g: f64, to_goal: f64) -> bool {
        self.is_cheaper(state, g) && self.is_below_bound(g + to_goal)
    }

    /// Takes note of a way that improves, and opens its state; `at_goal` where it leads to the goal.
    #[inline]
    pub(in crate::exact) fn relax(&mut self, state: State, g: f64, to_goal: f64, parent: State, at_goal: bool) {
        if !self.improves(state, g, to_goal) {
            return;
        }
        self.note(state, g, parent, at_goal);
        if !at_goal {
            self.file(state, g, g + to_goal);
        }
    }

    /// Takes note of a way to a state, by the state before it; `at_goal` where it leads to the goal.
    #[inline]
    pub(in crate::exact) fn note(&mut self, state: State, g: f64, parent: State, at_goal: bool) {
        self.g[state as usize] = g;
        self.parent[state as usize] = parent;
        if at_goal {
            (self.bound, self.arrived) = (g, state);
        }
    }

    /// Has a state wait for its turn; f is its cost and the estimate.
    #[inline]
    pub(in crate::exact) fn file(&mut self, state: State, g: f64, f: f64) {
        self.open.push(Open { state, g, f });
    }

    /// The open state of the smallest f that is neither outdated nor hopeless, and its f.
    pub(in crate::exact) fn least(&mut self) -> Option<(State, f64)> {
        while let Some(&Open { state, g, f }) = self.open.peek() {
            if g <= self.g[state as usize] && self.is_below_bound(f) {
                return Some((state, f));
            }
            self.open.pop();
        }
        None
    }

    /// The smallest f of the open states that are not outdated; infinite where there is none.
    #[cfg(feature = "whole")]
    pub(super) fn least_open(&self) -> f64 {
        let current = self.open.waiting().filter(|open| open.g <= self.g[open.state as usize]);
        current.map(|open| open.f).fold(f64::INFINITY, f64::min)
    }

    /// Takes out the state that [`Tree::least`] gives.
    pub(in crate::exact) fn take_least(&mut self) -> Option<State> {
        let (state, _) = self.least()?;
        self.open.pop();
        Some(state)
    }

    /// Takes out all that is open, and what may be outdated with it.
    pub(in crate::exact) fn take_all(&mut self) -> impl Iterator<Item = Open> + use<> {
        std::mem::take(&mut self.open.heap).into_iter().chain(self.open.later.take_all())
    }

    /// The states from the start to the goal.
    pub(in crate::exact) fn way(&self) -> Vec<State> {
        let mut way = vec![self.arrived];
        let mut at = self.arrived;
        while self.parent[at as usize] != NO_PARENT {
            at = self.parent[at as usize];
            way.push(at);
        }
        way.reverse();
        way
    }

    pub(in crate::exact) fn bytes(&self) -> usize {
        held(&self.g) + held(&self.parent) + held(&self.expanded) + self.open.bytes()
    }
}
