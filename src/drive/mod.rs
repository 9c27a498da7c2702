//! A robot that drives: it plans with any planner of the catalog that goes from cell to cell, follows its path one step at a time, and plans
//! again from where it stands when the map has changed.
//!
//! Time is counted in steps, its moves and waits. At each step
//! 1. the robot decides by what it knows, and moves to a cell that is free now, or waits;
//! 2. walls change and obstacles move, all at once. Nothing enters the robot's cell: a wall there waits until it has left, and an obstacle
//!    waits at the last place of its timetable that is clear of it ([`crate::scenario::Track`]);
//! 3. the robot looks around, as far as it sees. What it does not see it takes for what it last was.
//!
//! So the map of a step depends on the step and on the robot's cell alone, and the best drive of somebody who knows everything in advance
//! can be searched for exactly: [`best_in_advance`].
//!
//! On weighted ground, and where cells near obstacles cost more, a move costs its length times the mean factor of its cells on the map as the
//! robot feels it when it moves: what moves is an obstacle like any other. A wait costs nothing.
//!
//! ```
//! use std::sync::Arc;
//! use formicarium::drive::{Driver, End};
//! use formicarium::map::{Grid, Point};
//! use formicarium::params::Values;
//! use formicarium::scenario::{AtEnd, DriveSpec, Scenario, ScenarioSpec, Track};
//!
//! // A corridor; an obstacle stands in it and leaves by the door in its middle.
//! let grid = Grid::from_bytes(5, 2, &[1, 1, 0, 1, 1, 0, 0, 0, 0, 0])?;
//! let cells = vec![Point::new(2, 1), Point::new(2, 0)];
//! let track = Track { cells, size: 1, from_step: 0, steps_per_cell: 2, at_end: AtEnd::Leave };
//! let drive = DriveSpec { tracks: vec![track], ..DriveSpec::default() };
//! let spec = ScenarioSpec { drive: Some(drive), ..ScenarioSpec::new(&grid, Point::new(0, 1), Point::new(4, 1)) };
//! let scenario = Arc::new(Scenario::new(grid, spec)?);
//!
//! let mut driver = Driver::new(&scenario, "d-star-lite", None, &Values::new(), 1, Default::default())?;
//! while driver.step().is_some() {}
//! let drive = driver.drive();
//! assert_eq!((drive.end, drive.length, drive.waits), (Some(End::Arrived), 4.0, 2));
//! assert_eq!(drive.ratio, Some(1.0), "nobody could have come on a shorter way");
//! # Ok::<(), formicarium::error::Error>(())
//! ```

mod clairvoyant;
mod driver;
mod params;
mod pilot;
mod result;
mod surroundings;

pub use clairvoyant::{MOST_FELT, MOST_KEPT, MOST_STATES, TooMuch, best_in_advance, clairvoyant};
pub use driver::Driver;
pub use params::{DriveParams, Replan};
pub use result::{Did, Drive, DriveStep, End, Stuck};

/// The name of a drive's parameters in errors.
pub const DRIVE: &str = "drive";
