//! The cheapest path by slices inside a part of the places that grows: what was expanded stays, as in [`Within`](crate::exact::Within).
//!
//! Every step leads to the next column, so columns are worked off in order: in each the places to which a cheaper way has turned up. A way to a
//! place outside the part waits there. Of a cheapest path the first place that is not expanded at its true cost is open or waits, since all
//! before it are: so the least f of those is a lower bound, and a place whose f is not below the best cost known needs no expansion.

use std::sync::Arc;

use crate::map::{Cell, Measure, Slices, Way};
use crate::metrics::SAME_LENGTH;
use crate::planner::held;

/// No way leads to a place.
const NONE: Cell = Cell::MAX;

/// What a path by slices costs at least from a place to the goal: the straight line, and where levels are charged the lowest levels from which
/// the goal's can be climbed to; infinite where the goal is out of reach of the steps that are left. No step can lower it by more than it costs.
#[derive(Debug, Clone)]
pub struct SliceEstimate {
    goal: (u32, u32, u32),
    /// Most rows, and most levels, of a step.
    reach: (u32, u32),
    /// By the steps that are left: the levels at their ends, added up; all 0 where levels cost nothing.
    levels: Vec<f64>,
}

impl SliceEstimate {
    /// For the goal of a scenario by slices.
    pub fn new(slices: &Slices) -> Self {
        let (goal, rules) = (slices.at(slices.goal()), slices.rules());
        // Nothing is free below level 1 but an end.
        let lowest = |from_end: u32| match from_end {
            0 => goal.2,
            steps => goal.2.saturating_sub(steps.saturating_mul(rules.max_climb)).max(1),
        };
        let charged = f64::from(u8::from(rules.measure == Measure::Cost));
        let mut levels = vec![0.0];
        for from_end in 0..slices.slices() {
            levels.push(levels[from_end as usize] + charged * f64::from(lowest(from_end)));
        }
        Self { goal, reach: (rules.max_aside, rules.max_climb), levels }
    }

    /// From a place on the way there.
    pub fn of(&self, slices: &Slices, place: Cell) -> f64 {
        let ((x, y, h), goal) = (slices.at(place), self.goal);
        let (steps, rows, climb) = (x.abs_diff(goal.0), y.abs_diff(goal.1), h.abs_diff(goal.2));
        if rows > steps.saturating_mul(self.reach.0) || climb > steps.saturating_mul(self.reach.1) {
            return f64::INFINITY;
        }
        let [along, aside, up] = [steps, rows, climb].map(f64::from);
        libm::sqrt(along * along + aside * aside + up * up) + self.levels[steps as usize]
    }
}

/// A search from start to goal of a scenario by slices inside a part of its places, at first none of them.
#[derive(Clone)]
pub struct SlicesWithin {
    slices: Arc<Slices>,
    estimate: SliceEstimate,
    /// By place: whether it is of the part, and how far around it has been widened already, one more than that.
    inside: Vec<bool>,
    widened: Vec<u8>,
    /// By place: cost of the cheapest way known, the place before, and the cost at which it was expanded last.
    cost: Vec<f64>,
    parent: Vec<Cell>,
    expanded: Vec<f64>,
    /// By column from the start: places of the part to which a cheaper way leads than when they were expanded.
    open: Vec<Vec<Cell>>,
    /// The same outside the part; some may be outdated.
    waiting: Vec<Cell>,
    /// The least cost known.
    bound: f64,
    expansions: u64,
}

impl SlicesWithin {
    /// What one place takes, in bytes.
    pub const BYTES: u64 = 24;

    /// None of the places is of the part yet.
    pub fn new(slices: &Arc<Slices>) -> Self {
        let (places, start) = (slices.places(), slices.start());
        let mut cost = vec![f64::INFINITY; places];
        cost[start as usize] = 0.0;
        Self {
            estimate: SliceEstimate::new(slices),
            inside: vec![false; places],
            widened: vec![0; places],
            cost,
            parent: vec![NONE; places],
            expanded: vec![f64::INFINITY; places],
            open: vec![Vec::new(); slices.slices() as usize + 1],
            waiting: vec![start],
            bound: f64::INFINITY,
            expansions: 0,
            slices: Arc::clone(slices),
        }
    }

    /// Takes the places of the same column up to `radius` rows and levels away into the part.
    pub fn widen(&mut self, place: Cell, radius: u8) {
        let done = &mut self.widened[place as usize];
        if *done > radius {
            return;
        }
        *done = radius.saturating_add(1);
        let (x, y, level) = self.slices.at(place);
        let around = |at: u32, last: u32| at.saturating_sub(u32::from(radius))..=(at + u32::from(radius)).min(last);
        for level in around(level, self.slices.rules().levels) {
            for y in around(y, self.slices.rows() - 1) {
                self.inside[self.slices.place(x, y, level) as usize] = true;
            }
        }
    }

    /// Takes every place into the part.
    pub fn widen_to_all(&mut self) {
        self.inside.fill(true);
    }

    /// A path of this cost is known from elsewhere: only cheaper ones are looked for.
    pub fn bound_by(&mut self, cost: f64) {
        self.bound = self.bound.min(cost);
    }

    /// Searches on until nothing inside the part can lead to a cheaper path. False where that would take more than so many expansions.
    pub fn go_on(&mut self, most: u64) -> bool {
        self.reopen();
        let end = self.expansions.saturating_add(most);
        (0..self.open.len()).all(|column| self.work_off(column, end))
    }

    /// The cheapest path found, from start to goal, with its cost; none while there is none.
    pub fn best(&self) -> Option<(Vec<Cell>, f64)> {
        let goal = self.slices.goal();
        self.cost[goal as usize].is_finite().then(|| {
            let before = |&at: &Cell| Some(self.parent[at as usize]).filter(|&p| p != NONE);
            let mut path: Vec<Cell> = std::iter::successors(Some(goal), before).collect();
            path.reverse();
            let cost = self.slices.value(&path);
            (path, cost)
        })
    }

    /// No path costs less: the least f of what is open or waits, or the best cost where nothing can beat it.
    pub fn lower_bound(&self) -> f64 {
        let left = self.open.iter().flatten().chain(&self.waiting).filter(|&&place| self.is_hopeful(place));
        left.map(|&place| self.f(place)).fold(self.bound, f64::min)
    }

    /// Whether no path costs less than the cheapest one known.
    pub fn is_proven(&self) -> bool {
        self.lower_bound() == self.bound
    }

    /// Places expanded so far.
    pub fn expansions(&self) -> u64 {
        self.expansions
    }

    /// Whether each place is of the part.
    pub fn part(&self) -> &[bool] {
        &self.inside
    }

    /// What it holds, in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        let places =
            self.inside.capacity() + self.widened.capacity() + held(&self.cost) + held(&self.parent) + held(&self.expanded);
        places + held(&self.open) + self.open.iter().map(held).sum::<usize>() + held(&self.waiting)
    }

    fn f(&self, place: Cell) -> f64 {
        self.cost[place as usize] + self.estimate.of(&self.slices, place)
    }

    /// Whether an expansion could lead to a cheaper path.
    fn is_hopeful(&self, place: Cell) -> bool {
        self.cost[place as usize] < self.expanded[place as usize] && self.f(place) < self.bound - SAME_LENGTH
    }

    fn column(&self, place: Cell) -> usize {
        self.slices.at(place).0.abs_diff(self.slices.at(self.slices.start()).0) as usize
    }

    /// Opens what waits at places that are of the part by now; what cannot lead to a cheaper path is dropped.
    fn reopen(&mut self) {
        let mut waiting = std::mem::take(&mut self.waiting);
        waiting.sort_unstable();
        waiting.dedup();
        for place in waiting.into_iter().filter(|&place| self.is_hopeful(place)).collect::<Vec<_>>() {
            self.file(place);
        }
    }

    fn file(&mut self, place: Cell) {
        let column = self.column(place);
        let list = if self.inside[place as usize] { &mut self.open[column] } else { &mut self.waiting };
        list.push(place);
    }

    /// Expands what is open of a column, in the order of places; false once `end` places have been expanded and more are open.
    fn work_off(&mut self, column: usize, end: u64) -> bool {
        let mut list = std::mem::take(&mut self.open[column]);
        list.sort_unstable();
        list.dedup();
        list.retain(|&place| self.is_hopeful(place));
        for (at, &place) in list.iter().enumerate() {
            if self.expansions >= end {
                self.open[column] = list.split_off(at);
                return false;
            }
            self.expand(place);
        }
        true
    }

    fn expand(&mut self, from: Cell) {
        let slices = Arc::clone(&self.slices);
        let so_far = self.cost[from as usize];
        self.expansions += 1;
        self.expanded[from as usize] = so_far;
        for to in (0..slices.directions()).filter_map(|k| slices.step(from, k, Way::Forward)) {
            let cost = so_far + slices.cost(from, to);
            if cost >= self.cost[to as usize] {
                continue;
            }
            (self.cost[to as usize], self.parent[to as usize]) = (cost, from);
            if to == slices.goal() {
                self.bound = self.bound.min(cost);
            } else if self.is_hopeful(to) {
                self.file(to);
            }
        }
    }
}
