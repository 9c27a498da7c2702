//! Positions, one after the other in one buffer, and what those that are decoded cost.

use rand::Rng;

use crate::planner::held;
use crate::rng::{Stream, unit_f32};

use super::decode::Limits;

/// The positions of an iteration. Those that are decoded come first.
#[derive(Debug, Clone, Default)]
pub struct Population {
    dimensions: usize,
    positions: Vec<f32>,
    /// Length in cells of each decoded position's path.
    costs: Vec<f64>,
    /// For [`Population::keep`], so that no iteration allocates.
    spare: Vec<f32>,
}

impl Population {
    /// No positions yet, of this many dimensions each (at least 1).
    pub fn new(dimensions: usize) -> Self {
        Self { dimensions, ..Self::default() }
    }

    /// Number of dimensions.
    pub fn dimensions(&self) -> usize {
        self.dimensions
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.positions) + held(&self.costs) + held(&self.spare)
    }

    /// Number of positions, decoded or not.
    pub fn len(&self) -> usize {
        self.positions.len() / self.dimensions.max(1)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// The position of an index below [`Population::len`].
    pub fn position(&self, i: usize) -> &[f32] {
        &self.positions[i * self.dimensions..(i + 1) * self.dimensions]
    }

    /// The same, to be changed.
    pub fn position_mut(&mut self, i: usize) -> &mut [f32] {
        &mut self.positions[i * self.dimensions..(i + 1) * self.dimensions]
    }

    /// What the decoded positions cost, in cells.
    pub fn costs(&self) -> &[f64] {
        &self.costs
    }

    /// The next position to decode.
    pub fn next(&self) -> Option<usize> {
        (self.costs.len() < self.len()).then_some(self.costs.len())
    }

    /// Notes what the next position costs.
    pub fn note(&mut self, cost: f64) {
        self.costs.push(cost);
    }

    /// All positions are to be decoded again.
    pub fn forget_costs(&mut self) {
        self.costs.clear();
    }

    /// The cheapest decoded position; the first of equals.
    pub fn cheapest(&self) -> Option<usize> {
        (0..self.costs.len()).reduce(|best, i| if self.costs[i] < self.costs[best] { i } else { best })
    }

    /// Adds a position drawn uniformly between the limits in every dimension.
    pub fn push_random(&mut self, limits: Limits, stream: &mut Stream) {
        self.push_within(&[limits], stream);
    }

    /// The same with limits that the dimensions take in turn.
    pub fn push_within(&mut self, limits: &[Limits], stream: &mut Stream) {
        let draw = |limits: &Limits| (limits.min + f64::from(unit_f32(stream.next_u32())) * limits.span()) as f32;
        self.positions.extend(limits.iter().cycle().take(self.dimensions).map(draw));
    }

    /// Adds a copy of position `i`, to be changed.
    pub fn push_copy(&mut self, i: usize) -> &mut [f32] {
        let begin = i * self.dimensions;
        self.positions.extend_from_within(begin..begin + self.dimensions);
        self.position_mut(self.len() - 1)
    }

    /// Keeps these positions with their costs, in this order; one may be named more than once.
    pub fn keep(&mut self, chosen: &[usize]) {
        let mut kept = std::mem::take(&mut self.spare);
        kept.clear();
        chosen.iter().for_each(|&i| kept.extend_from_slice(self.position(i)));
        self.costs = chosen.iter().map(|&i| self.costs[i]).collect();
        self.spare = std::mem::replace(&mut self.positions, kept);
    }
}

/// Euclidean distance between two positions. Eight sums side by side, always in the same order.
pub fn distance(a: &[f32], b: &[f32]) -> f64 {
    let (mut sums, mut rest) = ([0.0f32; 8], 0.0f64);
    let (a, b) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    for (x, y) in a.0.iter().zip(b.0) {
        for k in 0..8 {
            sums[k] += (x[k] - y[k]) * (x[k] - y[k]);
        }
    }
    for (x, y) in a.1.iter().zip(b.1) {
        rest += f64::from((x - y) * (x - y));
    }
    libm::sqrt(sums.iter().fold(rest, |sum, &s| sum + f64::from(s)))
}

/// An index below `count` (at least 1), each as likely as another.
pub fn below(count: usize, stream: &mut Stream) -> usize {
    ((u64::from(stream.next_u32()) * count as u64) >> 32) as usize
}
