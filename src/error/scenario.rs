//! What is wrong with a scenario.

use thiserror::Error;

use super::ErrorReport;

/// A scenario cannot be planned on.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ScenarioError {
    /// The map has no cells, or too many a side.
    #[error("a map of {width} × {height} cells cannot be used")]
    MapSize {
        /// Width in cells.
        width: u64,
        /// Height in cells.
        height: u64,
        /// Most cells a side.
        most: u32,
    },
    /// The cell list does not have width × height entries.
    #[error("the map has {got} cells where {width} × {height} = {} are needed", u64::from(*.width) * u64::from(*.height))]
    CellCount {
        /// Width in cells.
        width: u32,
        /// Height in cells.
        height: u32,
        /// Entries found.
        got: usize,
    },
    /// Start or goal lies outside the map.
    #[error("the {role} ({x}, {y}) lies outside the map of {width} × {height} cells")]
    OutsideMap {
        /// `start` or `goal`.
        role: &'static str,
        /// Column asked for.
        x: i64,
        /// Row asked for.
        y: i64,
        /// Width in cells.
        width: u32,
        /// Height in cells.
        height: u32,
    },
    /// Start or goal lies on an obstacle.
    #[error("the {role} ({x}, {y}) lies on a blocked cell")]
    Blocked {
        /// `start` or `goal`.
        role: &'static str,
        /// Column.
        x: u32,
        /// Row.
        y: u32,
    },
    /// The scenario has no goal, or too many.
    #[error("the scenario has {got} goals where 1 to {most} are possible")]
    GoalCount {
        /// Goals found.
        got: usize,
        /// Most goals there can be.
        most: usize,
    },
    /// Two goals share a cell.
    #[error("two goals lie on the cell ({x}, {y})")]
    GoalTwice {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
    },
    /// Heights without a terrain, or a terrain without heights.
    #[error("{}", if *.missing { "the scenario is a terrain, but the map has no heights" } else { "the map has heights, but the scenario is no terrain" })]
    Heights {
        /// Whether the heights are what is missing.
        missing: bool,
    },
    /// The factor of a cell of weighted ground is none.
    #[cfg(feature = "whole")]
    #[error("the factor {value} of the cell ({x}, {y}) cannot be used: it must be 1 to {most}")]
    Factor {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
        /// The refused value.
        value: String,
        /// Largest factor there can be.
        most: f32,
    },
    /// Factors of cells on a map with heights.
    #[cfg(feature = "whole")]
    #[error("the map has heights and factors of cells: what a step costs there is not defined")]
    WeightedTerrain,
    /// Start or goal lies nearer to an obstacle than the robot's radius.
    #[cfg(feature = "whole")]
    #[error("the robot does not fit at the {role} ({x}, {y}): an obstacle is no farther than its radius of {radius} m")]
    TooNarrow {
        /// `start` or `goal`.
        role: &'static str,
        /// Column.
        x: u32,
        /// Row.
        y: u32,
        /// The robot's radius in metres.
        radius: f64,
    },
    /// By slices: start or goal lies in the ground.
    #[error("the {role} at level {level} lies below the ground there")]
    BelowGround {
        /// `start` or `goal`.
        role: &'static str,
        /// Level asked for.
        level: u32,
        /// The lowest level that is not below the ground there.
        lowest: u32,
    },
    /// A change of walls that cannot be made.
    #[cfg(feature = "whole")]
    #[error("{field} = {value} cannot be used: it must be {allowed}")]
    Change {
        /// The field, such as `changes[2].blocked[0]`.
        field: String,
        /// The refused value.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// What moves while a robot drives cannot do so, or nobody can drive so.
    #[cfg(feature = "whole")]
    #[error("{field} = {value} cannot be used: it must be {allowed}")]
    Drive {
        /// The field, such as `drive.tracks[2].cells[0]`.
        field: String,
        /// The refused value.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A physical quantity is not a positive, finite number (or not in its set).
    #[error("{field} = {value} cannot be used: it must be {allowed}")]
    Quantity {
        /// The field.
        field: &'static str,
        /// The refused value.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
}

impl ScenarioError {
    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        match self {
            Self::MapSize { width, height, most } => {
                ErrorReport::new("map-size", "map", message, format!("use 1 to {most} cells a side"))
                    .with("width", width)
                    .with("height", height)
                    .with("max", most)
            }
            Self::CellCount { got, .. } => {
                ErrorReport::new("cell-count", "cells", message, "give one cell for each place of the map").with("value", got)
            }
            Self::OutsideMap { role, x, y, width, height } => ErrorReport::new(
                "outside-map",
                *role,
                message,
                format!("columns run from 0 to {}, rows from 0 to {}", width - 1, height - 1),
            )
            .with("x", x)
            .with("y", y),
            Self::Blocked { role, x, y } => {
                ErrorReport::new(&format!("{role}-blocked"), *role, message, "move it to a free cell or clear the wall under it")
                    .with("x", x)
                    .with("y", y)
            }
            Self::GoalCount { got, most } => {
                let hint = format!("use 1 to {most} goals");
                ErrorReport::new("goal-count", "goals", message, hint).with("value", got).with("max", most)
            }
            Self::GoalTwice { x, y } => {
                ErrorReport::new("goal-twice", "goals", message, "move one of them, or remove it").with("x", x).with("y", y)
            }
            Self::Heights { missing } => {
                let (kind, hint) = if *missing {
                    ("heights-missing", "open the terrain again, or plan on the plane")
                } else {
                    ("terrain-missing", "say how one moves: give the scenario a `terrain`")
                };
                ErrorReport::new(kind, "terrain", message, hint)
            }
            #[cfg(feature = "whole")]
            Self::Factor { x, y, value, most } => {
                let hint = format!("give 1 for plain ground and up to {most} for dearer ground; block what cannot be entered");
                ErrorReport::new("factor", "factors", message, hint)
                    .with("x", x)
                    .with("y", y)
                    .with("value", value)
                    .with("max", most)
            }
            #[cfg(feature = "whole")]
            Self::WeightedTerrain => ErrorReport::new(
                "weighted-terrain",
                "factors",
                message,
                "leave out the heights, or the factors and the inflation",
            ),
            #[cfg(feature = "whole")]
            Self::TooNarrow { role, x, y, radius } => {
                let hint = "move it away from obstacles, or make the radius smaller";
                ErrorReport::new(&format!("{role}-too-narrow"), *role, message, hint)
                    .with("x", x)
                    .with("y", y)
                    .with("radius", radius)
            }
            Self::BelowGround { role, level, lowest } => {
                let hint = format!("the lowest level there is {lowest}");
                ErrorReport::new(&format!("{role}-below-ground"), *role, message, hint)
                    .with("level", level)
                    .with("lowest", lowest)
            }
            #[cfg(feature = "whole")]
            Self::Change { field, value, allowed } => {
                ErrorReport::new("change", field, message, format!("give {allowed}")).with("value", value)
            }
            #[cfg(feature = "whole")]
            Self::Drive { field, value, allowed } => {
                ErrorReport::new("drive", field, message, format!("give {allowed}")).with("value", value)
            }
            Self::Quantity { field, value, allowed } => {
                ErrorReport::new("quantity", *field, message, format!("give {allowed}")).with("value", value)
            }
        }
    }
}
