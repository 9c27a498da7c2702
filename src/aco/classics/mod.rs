//! The classics of the field, one file each.

pub mod ant_system;
