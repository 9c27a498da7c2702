//! Costs of orders in whole units, so that a bound is found without any rounding: sums of whole numbers are the same in every order.
//!
//! A cost c counts as ⌊c·2^e⌋ units, e being as large as the largest cost allows: a bound of orders in units, divided by 2^e, is one of their
//! costs. What is told is less by what rounding may take from the sum of an order's costs as [`Costs::total`] adds it.

use super::{Costs, Shape};
use crate::metrics::SAME_LENGTH;
use crate::planner::held;

/// No cost is as many units: sums over [`crate::exact::order_problem::MAX_PLACES`] stay far below what 64 bits hold.
pub(super) const MOST_UNITS: i64 = 1 << 46;
/// The exponent of [`MOST_UNITS`].
const BITS: i32 = 46;
/// Whole costs up to this add up without rounding.
const LARGEST_EXACT: f64 = (1u64 << 43) as f64;

/// From each node to each other, in units. A tour always returns to node 0; where it is open that costs nothing.
#[derive(Debug, Clone)]
pub(super) struct Whole {
    nodes: usize,
    units: Vec<i64>,
    /// e: a cell is 2^e units.
    exponent: i32,
    /// By how much a better order is better at least: 1 where all costs are whole, else [`SAME_LENGTH`]; in units.
    grain: i64,
    /// Costs are whole, and so is every sum.
    is_exact: bool,
    is_symmetric: bool,
    shape: Shape,
}

impl Whole {
    /// None where a cost is negative or not finite.
    pub(super) fn new(costs: &Costs, shape: Shape) -> Option<Self> {
        Self::below(costs, shape, f64::INFINITY)
    }

    /// The same for who looks for orders that cost less than this: a way of more than twice as much counts as that, so that what no good order
    /// goes leaves the others their digits.
    pub(super) fn below(costs: &Costs, shape: Shape, known: f64) -> Option<Self> {
        let nodes = costs.nodes();
        let given = || (0..nodes * nodes).map(|k| costs.get(k / nodes, k % nodes));
        if !given().all(|cost| cost.is_finite() && cost >= 0.0) {
            return None;
        }
        // The ways back of an open tour cost nothing.
        let counts = |k: usize| shape == Shape::Closed || !k.is_multiple_of(nodes);
        let all = || given().zip(0..).map(|(cost, k)| if counts(k) { cost.min(2.0 * known) } else { 0.0 });
        let largest = all().fold(0.0, f64::max);
        let exponent = BITS - libm::frexp(largest).1;
        let is_exact = largest <= LARGEST_EXACT && all().all(|cost| cost.fract() == 0.0);
        let unit = if is_exact { 1.0 } else { SAME_LENGTH };
        let units: Vec<i64> = all().map(|cost| libm::scalbn(cost, exponent) as i64).collect();
        // An open tour leaves node 0 and never comes back.
        let first = usize::from(shape == Shape::Open);
        let is_symmetric = (first..nodes).all(|i| (first..i).all(|j| units[i * nodes + j] == units[j * nodes + i]));
        let grain = (libm::scalbn(unit, exponent) as i64).max(1);
        Some(Self { nodes, units, exponent, grain, is_exact, is_symmetric, shape })
    }

    pub(super) fn nodes(&self) -> usize {
        self.nodes
    }

    pub(super) fn grain(&self) -> i64 {
        self.grain
    }

    /// Whether what rounding takes from an order cannot hide that another one is better than one of this cost, by a part of it that counts.
    pub(super) fn is_fine(&self, cost: f64) -> bool {
        self.is_exact || libm::scalbn(self.nodes as f64, -self.exponent) <= SAME_LENGTH * cost.max(1.0)
    }

    /// Whether each way costs as much as the way back; of an open tour those from its start and to it do not count.
    pub(super) fn is_symmetric(&self) -> bool {
        self.is_symmetric
    }

    pub(super) fn shape(&self) -> Shape {
        self.shape
    }

    /// From node i to node j.
    #[inline]
    pub(super) fn get(&self, i: usize, j: usize) -> i64 {
        self.units[i * self.nodes + j]
    }

    /// What a tour costs that visits the goals (counted from 0) in this order.
    pub(super) fn total(&self, order: &[u32]) -> i64 {
        edges(order).map(|(i, j)| self.get(i, j)).sum()
    }

    /// What an order of at least so many units has at least: where all costs are whole, a whole cost.
    pub(super) fn least_order(&self, units: i64) -> i64 {
        if self.is_exact { -(-units).div_euclid(self.grain) * self.grain } else { units }
    }

    /// The cost below which no order's [`Costs::total`] lies, where none is of fewer units.
    pub(super) fn told(&self, least: i64) -> f64 {
        let least = least.max(0);
        if self.is_exact {
            return (self.least_order(least) / self.grain) as f64;
        }
        // Each of the additions, and the change into a float here, is off by a part of 2⁻⁵³ at most.
        let rounding = self.nodes as i64 * (1 + (least >> 50));
        libm::scalbn((least - rounding).max(0) as f64, -self.exponent)
    }
}

/// The ways of a tour from node to node, back to node 0 at last.
fn edges(order: &[u32]) -> impl Iterator<Item = (usize, usize)> + '_ {
    let node = |&goal: &u32| goal as usize + 1;
    std::iter::once(0).chain(order.iter().map(node)).zip(order.iter().map(node).chain(std::iter::once(0)))
}

/// The ways that some orders go, from node to node.
#[derive(Debug, Clone, PartialEq)]
pub struct Ways {
    nodes: usize,
    gone: Vec<bool>,
}

impl Ways {
    /// None yet, on a complete graph of so many nodes.
    pub fn none(nodes: usize) -> Self {
        Self { nodes, gone: vec![false; nodes * nodes] }
    }

    /// Takes in those of an order, and the way back from its end: goals counted from 0.
    pub fn take(&mut self, order: &[u32]) {
        edges(order).for_each(|(i, j)| self.gone[i * self.nodes + j] = true);
    }

    /// Whether some order has gone from node i to node j.
    pub fn has(&self, i: usize, j: usize) -> bool {
        self.gone[i * self.nodes + j]
    }

    /// What it holds, in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        held(&self.gone)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn costs_are_rounded_down_and_told_again() {
        let costs = Costs::new(3, |i, j| (i + j) as f64 * std::f64::consts::SQRT_2);
        let whole = Whole::new(&costs, Shape::Closed).expect("finite");
        let order = [0, 1];
        let (units, cost) = (whole.total(&order), costs.total(&order, Shape::Closed));
        let told = whole.told(units);
        assert!(told <= cost && told > cost - 1e-12, "{told}, {cost}");
        assert!(
            whole.is_symmetric() && !Whole::new(&Costs::new(3, |i, _| i as f64), Shape::Open).expect("finite").is_symmetric()
        );
        let twice = Costs::new(4, |i, j| if j == 0 { 1.0 } else { 2.0 } * i.abs_diff(j) as f64);
        assert!(Whole::new(&twice, Shape::Open).expect("finite").is_symmetric(), "goals of one weight");
        assert!(Whole::new(&Costs::new(2, |_, _| f64::INFINITY), Shape::Open).is_none());
    }

    #[test]
    fn whole_costs_are_told_whole() {
        let whole = Whole::new(&Costs::new(3, |i, j| (i + j) as f64), Shape::Open).expect("finite");
        assert_eq!((whole.told(whole.grain() * 3), whole.told(whole.grain() * 3 + 1)), (3.0, 4.0));
        assert_eq!(whole.total(&[1, 0]), 5 * whole.grain(), "2 to node 2 and 3 on to node 1");
        let none = Whole::new(&Costs::new(3, |_, _| 0.0), Shape::Open).expect("finite");
        assert_eq!((none.total(&[0, 1]), none.told(0)), (0, 0.0));
    }
}
