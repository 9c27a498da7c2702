//! Sampling trees: they grow from the start towards random cells, by straight segments of any angle.
//!
//! | component | file |
//! |---|---|
//! | the tree: who hangs on whom, what is in sight, nearest and near nodes | `tree.rs` |
//! | F-RRT*, and its planner | `f_rrt_star.rs` |
//!
//! A move is one sample, and so is a constructed path: the way from the start to a sample, whether or not there is one. `ant_moves` counts
//! the cells along which sight was tried, by the longer side of each segment.

pub mod f_rrt_star;
pub mod tree;
