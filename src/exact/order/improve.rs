//! Better orders by small changes: 2-opt (Croes, "A method for solving traveling-salesman problems", Operations Research 6 (1958) 791–812,
//! doi:10.1287/opre.6.6.791) and Or-opt (Or, "Traveling salesman-type combinatorial problems and their relation to the logistics of regional
//! blood banking", Northwestern University 1976). The first change that makes the tour cheaper is made, until none does.
//!
//! The two directions of a way may differ in cost: what a part of the tour costs turned round is known from sums along it.

use super::whole::Whole;
use super::{Costs, Shape};

/// Most nodes that Or-opt moves at once.
const LONGEST: usize = 3;

/// A tour that is being improved.
struct Walk<'a> {
    whole: &'a Whole,
    /// Nodes in visiting order, from node 0.
    at: Vec<usize>,
    /// What it costs to come to each place of the tour, the way back to node 0 at last; and to come back from there, turned round.
    there: Vec<i64>,
    back: Vec<i64>,
}

/// An order of all goals (counted from 0) after 2-opt and Or-opt: no single change of theirs makes it cheaper. The same order where a cost is
/// negative or not finite.
///
/// ```
/// use formicarium::exact::order::{Costs, Shape, improved};
///
/// let along = Costs::new(6, |i, j| i.abs_diff(j) as f64);
/// assert_eq!(improved(&along, Shape::Open, &[2, 1, 0, 3, 4]), [0, 1, 2, 3, 4]);
/// ```
pub fn improved(costs: &Costs, shape: Shape, order: &[u32]) -> Vec<u32> {
    let mut order = order.to_vec();
    if let Some(whole) = Whole::new(costs, shape) {
        improve(&whole, &mut order);
    }
    order
}

/// Changes an order until neither 2-opt nor Or-opt makes it cheaper by at least the grain of its costs.
pub(super) fn improve(whole: &Whole, order: &mut [u32]) {
    let nodes = std::iter::once(0).chain(order.iter().map(|&goal| goal as usize + 1)).collect();
    let mut walk = Walk { whole, at: nodes, there: Vec::new(), back: Vec::new() };
    walk.sum();
    while walk.turn_parts() | walk.move_parts() {}
    order.iter_mut().zip(&walk.at[1..]).for_each(|(goal, &node)| *goal = node as u32 - 1);
}

impl Walk<'_> {
    fn sum(&mut self) {
        (self.there, self.back) = (vec![0], vec![0]);
        for p in 0..self.at.len() {
            let (here, next) = (self.node(p), self.node(p + 1));
            self.there.push(self.there[p] + self.whole.get(here, next));
            self.back.push(self.back[p] + self.whole.get(next, here));
        }
    }

    /// The node of a place; node 0 after the last.
    fn node(&self, place: usize) -> usize {
        self.at.get(place).copied().unwrap_or(0)
    }

    fn cost(&self, from: usize, to: usize) -> i64 {
        self.whole.get(self.node(from), self.node(to))
    }

    /// Whether a change by so much is made.
    fn is_better(&self, change: i64) -> bool {
        change <= -self.whole.grain()
    }

    /// 2-opt: turns parts round; whether one was.
    fn turn_parts(&mut self) -> bool {
        let mut turned = false;
        for first in 1..self.at.len() {
            for last in first + 1..self.at.len() {
                let is = self.there[last + 1] - self.there[first - 1];
                let ends = self.cost(first - 1, last) + self.cost(first, last + 1);
                if self.is_better(ends + self.back[last] - self.back[first] - is) {
                    self.at[first..=last].reverse();
                    self.sum();
                    turned = true;
                }
            }
        }
        turned
    }

    /// Or-opt: moves up to three nodes elsewhere, turned round or not; whether any were.
    fn move_parts(&mut self) -> bool {
        let mut moved = false;
        for length in 1..=LONGEST {
            for first in 1..(self.at.len() + 1).saturating_sub(length) {
                for before in 0..self.at.len() {
                    moved |= self.move_part(first, first + length - 1, before);
                }
            }
        }
        moved
    }

    /// Moves the nodes from `first` to `last` behind the place `before`, if that is better.
    fn move_part(&mut self, first: usize, last: usize, before: usize) -> bool {
        if (first - 1..=last).contains(&before) {
            return false;
        }
        let left = self.cost(first - 1, last + 1) - self.cost(first - 1, first) - self.cost(last, last + 1);
        let opened = left - self.cost(before, before + 1);
        let turn = self.back[last] - self.back[first] - (self.there[last] - self.there[first]);
        let straight = opened + self.cost(before, first) + self.cost(last, before + 1);
        let turned = opened + self.cost(before, last) + self.cost(first, before + 1) + turn;
        if !self.is_better(straight.min(turned)) {
            return false;
        }
        if turned < straight {
            self.at[first..=last].reverse();
        }
        let length = last - first + 1;
        if before > last {
            self.at[first..=before].rotate_left(length);
        } else {
            self.at[before + 1..=last].rotate_right(length);
        }
        self.sum();
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Costs as if drawn at random, the two directions different unless `even`.
    fn drawn(nodes: usize, seed: u32, even: bool) -> Costs {
        let cost = |i: usize, j: usize| {
            let (i, j) = if even { (i.min(j), i.max(j)) } else { (i, j) };
            f64::from((seed + 7 * i as u32 + 131 * j as u32).wrapping_mul(2_654_435_761) >> 20)
        };
        Costs::new(nodes, cost)
    }

    #[test]
    fn no_change_makes_an_improved_order_cheaper() {
        for seed in 1..=20 {
            for (shape, even) in [(Shape::Open, true), (Shape::Closed, true), (Shape::Open, false), (Shape::Closed, false)] {
                let costs = drawn(9, seed, even);
                let whole = Whole::new(&costs, shape).expect("finite");
                let mut order: Vec<u32> = (0..8).collect();
                let before = costs.total(&order, shape);
                improve(&whole, &mut order);
                let reached = costs.total(&order, shape);
                assert!(reached <= before);
                for first in 0..8 {
                    for last in first + 1..8 {
                        let mut turned = order.clone();
                        turned[first..=last].reverse();
                        assert!(costs.total(&turned, shape) >= reached, "seed {seed}: {first} to {last} turned");
                    }
                    for to in 0..8 {
                        let mut moved = order.clone();
                        let goal = moved.remove(first);
                        moved.insert(to, goal);
                        assert!(costs.total(&moved, shape) >= reached, "seed {seed}: {first} moved to {to}");
                    }
                }
            }
        }
    }
}
