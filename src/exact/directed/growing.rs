//! The search over states inside a part of the map that grows.
//!
//! Of each cell it knows the **lead**, the state with the cheapest way known, of equals the first one seen. Another state s of the cell is left out
//! where its way costs no less than the lead's and the most that s can save by its next step ([`Costs::saves`]). That loses nothing, in whatever order
//! states are expanded and however the part grows. Let s be a known state and π a way on from it to the goal that costs less in all than the
//! best path. Then some state q is open or waits, with a way on π′ that costs no more in all. By induction, first over the steps of π, then
//! over the cost of s:
//!
//! - s is open, or waits: q is s.
//! - s was left out, for a lead l. After the first step of π nothing depends on how one came to the cell, and that step costs after l at most what
//!   s saves more: so l with π costs no more in all than s with π, and is cheaper than s, or was seen first.
//! - s was expanded, and the state that π leads to next was known then, or left out, at no more than the cost of s and that step. What is known
//!   gets no dearer, and a cheaper state is opened again: that state, or the lead of its cell, has fewer steps to go.
//!
//! For the start and a best path: the least f of what is open or waits is no more than the least cost there is. Leads get cheaper alone, so
//! neither case goes round in circles.

use std::sync::Arc;

use super::Costs;
use crate::exact::best_first::{State, Tree};
use crate::exact::growing::{Growing, Node};
use crate::exact::region::Part;
use crate::map::{ALL_DIRECTIONS, Cell, DIRECTIONS, Direction, Moves};
use crate::metrics::SAME_LENGTH;
use crate::path::Path;
use crate::planner::held;
use crate::scenario::Scenario;

/// The lead of a cell of which no state is known.
const UNSEEN: u8 = u8::MAX;

/// A search over states cell · n + direction; of n states of a cell the last is that of the start, which no step led to.
#[derive(Clone)]
pub(in crate::exact) struct Directed<C> {
    scenario: Arc<Scenario>,
    costs: C,
    part: Part,
    tree: Tree,
    per_cell: u32,
    /// The lead's number among the states of its cell, by cell.
    lead: Vec<u8>,
    expansions: u64,
}

impl<C: Costs> Directed<C> {
    /// From the scenario's start to its goal; none of the map is of the part yet.
    pub(in crate::exact) fn new(scenario: &Arc<Scenario>, costs: C) -> Self {
        let (cells, start) = (scenario.grid.len(), scenario.start);
        let directions = if scenario.spec.movement.moves == Moves::Sixteen { ALL_DIRECTIONS } else { DIRECTIONS };
        let per_cell = directions as u32 + 1;
        let to_goal = costs.to_goal(scenario, start);
        let mut search = Self {
            costs,
            part: Part::none(scenario.grid.width(), cells),
            tree: Tree::along(scenario, cells * per_cell as usize, to_goal),
            per_cell,
            lead: vec![UNSEEN; cells],
            expansions: 0,
            scenario: Arc::clone(scenario),
        };
        search.tree.begin(start * per_cell + per_cell - 1, to_goal, start == scenario.goal);
        search.lead[start as usize] = per_cell as u8 - 1;
        search.set_aside();
        search
    }

    /// The direction that led to a state; none at the start.
    #[inline]
    fn came(&self, state: State) -> Option<Direction> {
        let number = state % self.per_cell;
        (number + 1 < self.per_cell).then_some(number as Direction)
    }

    /// The lead of a cell, if any of its states is known.
    #[inline]
    fn lead(&self, cell: Cell) -> Option<State> {
        let number = self.lead[cell as usize];
        (number != UNSEEN).then(|| cell * self.per_cell + State::from(number))
    }

    /// Whether a way of cost g to a state can be left out for the lead of its cell.
    #[inline]
    fn is_left_out(&self, cell: Cell, state: State, g: f64) -> bool {
        let Some(lead) = self.lead(cell).filter(|&lead| lead != state) else { return false };
        // After the start no step turns, so nobody saves anything against it.
        let both = self.came(lead).zip(self.came(state));
        let saved = both.map_or(0.0, |(lead, came)| self.costs.saves(&self.scenario, cell, lead, came));
        g >= self.tree.g(lead) + saved - SAME_LENGTH
    }

    /// Takes in the step in direction `d` from a state of a cell.
    #[inline]
    fn step(&mut self, cell: Cell, state: State, d: Direction) {
        let next = self.scenario.moves.step(cell, d);
        let to = next * self.per_cell + State::from(d);
        let g = self.tree.g(state) + self.costs.step(&self.scenario, cell, self.came(state), d);
        let to_goal = self.costs.to_goal(&self.scenario, next);
        if !self.tree.improves(to, g, to_goal) || self.is_left_out(next, to, g) {
            return;
        }
        let at_goal = next == self.scenario.goal;
        self.tree.note(to, g, state, at_goal);
        if self.lead(next).is_none_or(|lead| g < self.tree.g(lead)) {
            self.lead[next as usize] = d;
        }
        if at_goal {
            return;
        }
        if self.part.has(next) {
            self.tree.file(to, g, g + to_goal);
        } else {
            self.part.waiting.push((g, to));
        }
    }
}

/// A node is a state.
impl<C: Costs> Growing for Directed<C> {
    fn part(&self) -> &Part {
        &self.part
    }

    fn part_mut(&mut self) -> &mut Part {
        &mut self.part
    }

    #[inline]
    fn cell(&self, node: Node) -> Cell {
        node / self.per_cell
    }

    fn bound(&self) -> f64 {
        self.tree.bound()
    }

    fn bound_by(&mut self, cost: f64) {
        self.tree.bound_by(cost);
    }

    fn to_goal(&self, cell: Cell) -> f64 {
        self.costs.to_goal(&self.scenario, cell)
    }

    fn is_current(&self, node: Node, g: f64) -> bool {
        g <= self.tree.g(node) && !self.is_left_out(self.cell(node), node, g)
    }

    fn file(&mut self, node: Node, g: f64, f: f64) {
        self.tree.file(node, g, f);
    }

    fn take_next(&mut self) -> Option<(f64, Node)> {
        loop {
            let state = self.tree.take_least()?;
            let g = self.tree.g(state);
            if !self.is_left_out(self.cell(state), state, g) {
                return Some((g, state));
            }
        }
    }

    fn expand(&mut self, node: Node) {
        self.expansions += 1;
        let cell = self.cell(node);
        for d in self.scenario.moves.directions(cell) {
            self.step(cell, node, d);
        }
    }

    fn set_aside(&mut self) {
        self.part.waiting.extend(self.tree.take_all().map(|open| (open.g, open.state)));
    }

    fn expansions(&self) -> u64 {
        self.expansions
    }

    fn best(&self) -> Option<(Path, f64)> {
        self.tree.has_arrived().then(|| {
            let path: Path = self.tree.way().iter().map(|&state| self.cell(state)).collect();
            let cost = self.costs.of(&self.scenario, &path);
            (path, cost)
        })
    }

    fn bytes(&self) -> usize {
        self.costs.bytes() + self.part.bytes() + self.tree.bytes() + held(&self.lead)
    }

    fn boxed(&self) -> Box<dyn Growing> {
        Box::new(self.clone())
    }
}
