//! TDI-MSACO: Li, Wang, Cai, Ma, Tan, "Research on terminal distance index-based multi-step ant colony optimization for mobile robot path
//! planning", IEEE Transactions on Automation Science and Engineering, 2022, ieeexplore.ieee.org/document/9919849.
//!
//! Of the publication its abstract was at hand: ants go several cells at a time in any direction, two or three being best, and a terminal
//! distance index stands in for pheromone. Rules and numbers are those of two reproductions by one author, not checked against it. **A** is
//! RajeevlochanP/Parallel-TDIMSACO, `main.cpp`; **B** is RajeevlochanP/TDI-MSACO, `Main.java` and `MainT.java`. The defaults are A, the
//! preset `second-reading` has B's numbers.
//!
//! | step | what | function |
//! |---|---|---|
//! | where an ant may go | A, B: to any cell in sight up to `reach` columns and rows away | [`window::Window`] |
//! | selection | A, B: in proportion to (1/d_jT)^α + (1/TDI_j)^β, d_jT the straight distance from cell j to the goal | [`weight`] |
//! | index | A, B: 0 at the goal, 10 times the map's diagonal elsewhere; along each arrived ant's way, from its end, TDI_i = min(TDI_i, d_ij + TDI_j) | [`initial_index`], [`index::Index::learn`] |
//! | result | A, B: from the start on to the cell that each cell has its index from | [`index::Index::way_from`] |
//!
//! - **A sum.** A and B add the two terms; the same author's colony of several steps with pheromone (B, `MainP.java`) multiplies, as Ant
//!   System does. With B's numbers the index has next to no effect in a sum.
//! - **Where an ant has been** it does not go again, as in Ant System; A and B let it (`tabu`). A walk is limited (`move_limit`), theirs is not.
//! - **At the goal** both terms divide by 0; `goal_distance` stands for less, in all of them. In A and B the ant then goes there.
//! - **An index that falls** leaves those that were set by it as they are, as in A and B's `MainT.java`; B's `Main.java` carries it on.
//! - **An ant's way** is the path where it is shorter than that along the index, or where no index has been set from the start on.
//! - **Sight** is the scenario's: A and B let a segment pass between two obstacles that touch at a corner.

use std::sync::Arc;

use crate::aco::dead_end::DeadEnd;
use crate::aco::shared_params::WalkParams;
use crate::aco::weights::power;
use crate::error::ParamError;
use crate::map::{Cell, Point};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{AT_GOAL, Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset};
use crate::scenario::Scenario;

mod colony;
pub mod index;
pub mod walker;
pub mod window;

pub use colony::TdiMsaco;

params! {
    /// Parameters of TDI-MSACO.
    pub struct TdiMsacoParams {
        /// ants that build a path in each iteration
        ants: u32 = 10, "m", [1..=1024], "ants", "reproduction A of TDI-MSACO; B: 20";
        /// iterations after which the colony stops
        iterations: u32 = 100, "K", [1..=100_000], "iterations", "papers' common value";
        /// columns and rows that an ant goes at most in one move
        reach: u32 = 3, "s", [1..=3], "cells", "reproductions A and B of TDI-MSACO; abstract: 2 or 3";
        /// weight of the goal's distance in the choice of a cell
        distance_power: f64 = 1.5, "α", [0.0..=50.0], "", "reproduction A of TDI-MSACO; B: 1";
        /// weight of the terminal distance index in the choice of a cell
        index_power: f64 = 0.8, "β", [0.0..=50.0], "", "reproduction A of TDI-MSACO; B: 7";
        /// terminal distance index of a cell from which no ant has arrived yet
        initial_index: f64 = 10.0, "", [1.0..=1000.0], "× diagonal", "reproductions A and B of TDI-MSACO";
        /// whether an ant keeps out of cells where it has been; if not, it gives up after as many moves as there are cells at the latest
        tabu: bool = true, "", [], "", "as Ant System; reproductions A and B of TDI-MSACO: false";
        /// distance that stands for a shorter one to the goal
        goal_distance: f64 = AT_GOAL, "ε", [1e-3..=1.0], "cells", "our choice; reproductions A and B of TDI-MSACO divide by 0";
        ..walk: WalkParams { dead_end = DeadEnd::Die, "our choice; reproductions A and B of TDI-MSACO have none"; };
    }
}

/// Straight distance from a cell to the goal, in cells.
pub fn straight(scenario: &Scenario, cell: Cell) -> f64 {
    scenario.grid.point(cell).distance(scenario.grid.point(scenario.goal))
}

/// One over a distance in cells that is at least ε.
pub fn nearness(p: &TdiMsacoParams, distance: f64) -> f64 {
    1.0 / distance.max(p.goal_distance)
}

/// (1/d_jT)^α + (1/TDI_j)^β of a cell whose index in cells is this one; above 0.
pub fn weight(p: &TdiMsacoParams, scenario: &Scenario, j: Cell, index: f64) -> f64 {
    power(nearness(p, straight(scenario, j)), p.distance_power) + power(nearness(p, index), p.index_power)
}

/// The index of a cell from which no ant has arrived yet, in cells.
pub fn initial_index(p: &TdiMsacoParams, scenario: &Scenario) -> f64 {
    let corner = Point::new(scenario.grid.width() - 1, scenario.grid.height() - 1);
    p.initial_index * Point::new(0, 0).distance(corner)
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    Ok(Box::new(TdiMsaco::new(Arc::clone(scenario), TdiMsacoParams::read(ENTRY.id, values)?, seed)))
}

/// What the paper adds, as its abstract says.
const COMPONENTS: &[Component] = &[
    Component {
        id: "several-steps",
        name: "several cells at a time",
        adds: "an ant goes to any cell in sight up to three columns and rows away; without: to one of the eight around it",
        without: &[("reach", "1")],
    },
    Component {
        id: "terminal-distance-index",
        name: "terminal distance index",
        adds: "cells from which ants have shown short ways to the goal weigh more; without: all alike but for their distance to it",
        without: &[("index_power", "0")],
    },
];

/// TDI-MSACO in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "tdi-msaco",
    name: "Multi-step ACO",
    family: Family::AntColony,
    summary: "Ants go up to three cells at a time in any direction; in place of pheromone each cell keeps the shortest way to the goal that ants have shown.",
    source: "Li, Wang, Cai, Ma, Tan 2022, IEEE Trans. Autom. Sci. Eng., ieeexplore.ieee.org/document/9919849, after two reproductions",
    presets: &[Preset {
        name: "second-reading",
        source: "reproduction B of TDI-MSACO",
        meaning: "20 ants, α = 1 and β = 7, as reproduction B has them; the rest stays",
        numbers: &[("ants", 20.0), ("distance_power", 1.0), ("index_power", 7.0)],
        choices: &[],
        reading: Some(PaperReading::SecondReading),
    }],
    components: COMPONENTS,
    layers: &[Layer::Scent, Layer::Visits],
    max_goals: 1,
    grounds: Ground::PLANE,
    specs: TdiMsacoParams::specs,
    build,
};
