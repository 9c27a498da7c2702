//! The classics of the field, one file each.

pub mod ant_colony_system;
pub mod ant_system;
pub mod best_worst_ant_system;
pub mod elitist_ant_system;
pub mod max_min_ant_system;
pub mod rank_based_ant_system;
