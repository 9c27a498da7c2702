//! A good order to begin a search with: the nearest goal next, from several first goals, each improved by small changes.

use super::{Costs, Shape, improved};

/// Goals times starts: as many starts as keep to this, one at least.
const WORK: usize = 1 << 12;

/// The cheapest order, of goals counted from 0, that small changes reach from orders by nearest neighbours; the first found of equals.
///
/// ```
/// use formicarium::exact::order::{Costs, Shape, good_order};
///
/// let along = Costs::new(6, |i, j| i.abs_diff(j) as f64);
/// assert_eq!(good_order(&along, Shape::Open), [0, 1, 2, 3, 4]);
/// ```
pub fn good_order(costs: &Costs, shape: Shape) -> Vec<u32> {
    let goals = costs.nodes() - 1;
    let starts = (WORK / goals.max(1)).clamp(1, goals.max(1));
    let orders = (0..starts).map(|start| improved(costs, shape, &nearest_next(costs, start * goals / starts)));
    orders
        .reduce(|best, next| if costs.total(&next, shape) < costs.total(&best, shape) { next } else { best })
        .unwrap_or_default()
}

/// This goal first, then always the nearest that is left, the first of equals.
fn nearest_next(costs: &Costs, first: usize) -> Vec<u32> {
    let mut left: Vec<usize> = (0..costs.nodes() - 1).collect();
    let mut order: Vec<u32> = Vec::with_capacity(left.len());
    let mut next = first;
    while next < left.len() {
        let at = left.remove(next);
        order.push(at as u32);
        let cost = |k: usize| costs.get(at + 1, left[k] + 1);
        next = (0..left.len()).reduce(|best, k| if cost(k) < cost(best) { k } else { best }).unwrap_or(0);
    }
    order
}
