//! What a planner can show of its inside, cell by cell.

use serde::{Deserialize, Serialize};

use crate::listed::listed;

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
