//! Maps and how one moves on them.

mod generate;
mod grid;
mod movement;

pub use generate::{Generated, Generator, generate};
pub use grid::{Cell, Grid, MAX_SIDE, Point, check_size};
pub use movement::{
    CornerRule, DIRECTIONS, Direction, MoveSet, Movement, Moves, OFFSETS, is_diagonal, octile, opposite, step_length,
};
