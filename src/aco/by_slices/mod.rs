//! Colonies by slices: the classics on places and steps of [`Slices`](crate::map::Slices), whose steps are more than the eight that the
//! colonies from cell to cell know.
//!
//! [`colony::SliceColony`] is the one skeleton; [`colony::Rules`] is what a publication decides. Ants, selection and the names of places are
//! those of the terrain paper's colonies ([`super::terrain`]). What a path costs is what the scenario charges, levels included.
//!
//! | component | file |
//! |---|---|
//! | the skeleton and its planner | `colony.rs` |
//! | one iteration's tables: ants, what they see and weigh | `tables.rs` |
//! | τ by place and step, kept where it differs from the rest | `trails.rs` |
//! | probabilities and layers, as they are shown | `view.rs` |
//! | η by the cost of a step, and the cost of the straight way | `cost.rs` |
//! | Formica by slices | `formica.rs` |

pub mod ant_colony_system;
pub mod colony;
pub mod cost;
pub mod formica;
pub mod max_min_ant_system;
mod tables;
pub mod textbook;
pub mod trails;
mod view;
