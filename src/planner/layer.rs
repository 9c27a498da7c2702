//! What a planner can show of its inside, cell by cell.

use serde::{Deserialize, Serialize};
use wide::f32x4;

use super::shades::fours;
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
        /// A search's cost from the start, in cells, of D* Lite to the goal; infinite where none is known.
        Cost,
        /// Distance to the goal in cells as a colony's ants smell it, or the least that they have shown; infinite where no way is known.
        Scent,
        /// 1 on the cells among which a search looks for the best path that ants' ways can be put together to.
        Merged,
    }
}

/// Smallest and largest value of a layer over the free cells; infinite values do not count. None where there is no finite one.
pub fn extent(field: &[f32], grid: &Grid) -> Option<[f32; 2]> {
    // Four chains of comparisons: one alone would wait for itself.
    let (mut low, mut high) = (f32x4::splat(f32::INFINITY), f32x4::splat(f32::NEG_INFINITY));
    for (four, blocked) in fours(field).zip(grid.blocked().chunks(4)) {
        let mut four = four.to_array();
        four.iter_mut().zip(blocked).for_each(|(value, &blocked)| *value = if blocked { f32::NAN } else { *value });
        let four = f32x4::new(four);
        let counts = four.is_finite();
        low = counts.bitselect(four, low).fast_min(low);
        high = counts.bitselect(four, high).fast_max(high);
    }
    let (low, high) = (low.to_array().into_iter().reduce(f32::min)?, high.to_array().into_iter().reduce(f32::max)?);
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

    #[test]
    fn an_extent_is_that_of_a_plain_look_at_each_cell() {
        for width in [1, 7, 8, 19] {
            let cells: Vec<u8> = (0..width * 5).map(|c| u8::from(c % 11 == 3)).collect();
            let grid = Grid::from_bytes(width, 5, &cells).expect("a grid");
            let field: Vec<f32> =
                (0..width * 5).map(|c| if c % 13 == 5 { f32::INFINITY } else { (c * 37 % 101) as f32 - 40.0 }).collect();
            let free = field.iter().zip(&cells).filter(|(value, blocked)| value.is_finite() && **blocked == 0);
            let sorted = std::collections::BTreeSet::from_iter(free.map(|(&value, _)| value as i32));
            let ends = [sorted.first(), sorted.last()].map(|end| *end.expect("some are free") as f32);
            assert_eq!(extent(&field, &grid), Some(ends), "{width}");
        }
    }
}
