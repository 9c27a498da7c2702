//! What a planner can show of its inside, cell by cell.

use serde::{Deserialize, Serialize};

use crate::listed::listed;
use crate::map::Grid;

listed! {
    /// A field over the map that can be drawn.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Layer {
        /// The strongest trail that leaves a cell.
        Trail,
        /// Colonies: how many ants of the current iteration have the cell on their way. Searches: 1 where a cell was expanded.
        Visits,
        /// Mean heuristic value η of the steps that lead into a cell.
        Heuristic,
        /// Share of blocked cells among the eight around a cell; beyond the border is blocked.
        Density,
        /// The strongest trail that leaves a cell before the first iteration.
        InitialTrail,
        /// The path that seeded the trails, 1 on its cells; of a hybrid's first stage.
        SeedPath,
        /// The numbers by which a decoded path is chosen, one a cell: a firework's or a particle's position.
        Priority,
        /// A search's cost from the start, in cells; infinite where none is known.
        Cost,
    }
}

/// Smallest and largest value of a layer over the free cells; infinite values do not count. None where there is no finite one.
pub fn extent(field: &[f32], grid: &Grid) -> Option<[f32; 2]> {
    let free = field.iter().zip(0..).filter(|&(value, cell)| value.is_finite() && !grid.is_blocked(cell));
    let (low, high) = free.fold((f32::INFINITY, f32::NEG_INFINITY), |(l, h), (&v, _)| (l.min(v), h.max(v)));
    (low <= high).then_some([low, high])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_extent_leaves_out_walls_and_what_is_not_finite() {
        let grid = Grid::from_bytes(2, 2, &[0, 1, 0, 0]).expect("a grid");
        assert_eq!(extent(&[0.5, 9.0, f32::INFINITY, -1.0], &grid), Some([-1.0, 0.5]));
        assert_eq!(extent(&[f32::NAN, 9.0, f32::INFINITY, f32::NAN], &grid), None);
    }
}
