//! How one moves on a terrain, from the command line.

use crate::formats::Imported;
use crate::map::{Measure, SliceRules};
use crate::scenario::{TerrainMoves, TerrainSpec};
use clap::ValueEnum;

use super::error::CliError;

/// How one moves on a map with heights. What is not given stays as the map's file says.
#[derive(clap::Args)]
#[command(next_help_heading = "Terrains")]
pub struct TerrainArgs {
    /// surface (on the ground, from cell to cell) or slices (above it, from column to column) [default: the map's, else surface]
    #[arg(long, value_enum, hide_possible_values = true)]
    model: Option<Model>,
    /// On the surface: the steepest ground, in degrees [default: the map's, else 90, no limit]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    max_slope: Option<f64>,
    /// Metres per unit of the heights: 0.3048 for feet [default: the map's, else 1]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    vertical_unit: Option<f64>,
    /// By slices: metres per level [default: the map's, else a tenth of the highest ground]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    level: Option<f64>,
    /// By slices: the highest level, 1 to 255 [default: the map's, else 20]
    #[arg(long, value_name = "N")]
    levels: Option<u32>,
    /// By slices: most cells aside in a step, 0 to 5 [default: the map's, else 2]
    #[arg(long, value_name = "N")]
    max_aside: Option<u32>,
    /// By slices: most levels up or down in a step, 0 to 5 [default: the map's, else 2]
    #[arg(long, value_name = "N")]
    max_climb: Option<u32>,
    /// By slices: level of the start [default: the map's, else the lowest above the ground]
    #[arg(long, value_name = "N")]
    pub from_level: Option<u32>,
    /// By slices: level of the goal [default: the map's, else the lowest above the ground]
    #[arg(long, value_name = "N")]
    pub to_level: Option<u32>,
    /// By slices: cost (length and levels, as the textbook's program) or length [default: the map's, else cost]
    #[arg(long, value_enum, hide_possible_values = true)]
    measure: Option<MeasuredBy>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Model {
    Surface,
    Slices,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum MeasuredBy {
    Cost,
    Length,
}

impl TerrainArgs {
    /// Lets the arguments override a terrain's rules. Start and goal must be where they will stay: by slices they have a level.
    pub fn apply(&self, map: &mut Imported) -> Result<(), CliError> {
        let Some(mut terrain) = map.spec.terrain else { return self.refuse_on_a_plane() };
        terrain.vertical_unit = self.vertical_unit.unwrap_or(terrain.vertical_unit);
        let is_by_slices = matches!(terrain.moves, TerrainMoves::Slices(_));
        let model = self.model.unwrap_or(if is_by_slices { Model::Slices } else { Model::Surface });
        self.refuse_of_the_other(model)?;
        terrain.moves = match model {
            Model::Surface => self.surface(terrain.moves),
            Model::Slices => TerrainMoves::Slices(self.slices(map, terrain)),
        };
        map.spec.terrain = Some(terrain);
        Ok(())
    }

    fn refuse_on_a_plane(&self) -> Result<(), CliError> {
        let given = self.of_surface().into_iter().chain(self.of_slices()).chain(self.of_both());
        match given.into_iter().find(|(_, given)| *given) {
            Some((name, _)) => {
                let message = format!("{name} is for terrains, and the map has no heights");
                Err(CliError::usage(message, "open a raster of heights, or make one: `generate hills`"))
            }
            None => Ok(()),
        }
    }

    /// What belongs to the other way of moving is a mistake, not a wish to be ignored.
    fn refuse_of_the_other(&self, model: Model) -> Result<(), CliError> {
        let (given, other, way) = match model {
            Model::Surface => (self.of_slices(), "slices", "on the surface"),
            Model::Slices => (self.of_surface().to_vec(), "surface", "by slices"),
        };
        match given.into_iter().find(|(_, given)| *given) {
            Some((name, _)) => {
                let message = format!("{name} says nothing about moving {way}");
                Err(CliError::usage(message, format!("add --model {other}, or leave {name} out")))
            }
            None => Ok(()),
        }
    }

    fn of_both(&self) -> [(&'static str, bool); 2] {
        [("--model", self.model.is_some()), ("--vertical-unit", self.vertical_unit.is_some())]
    }

    fn of_surface(&self) -> [(&'static str, bool); 1] {
        [("--max-slope", self.max_slope.is_some())]
    }

    fn of_slices(&self) -> Vec<(&'static str, bool)> {
        let numbers = [
            ("--levels", self.levels),
            ("--max-aside", self.max_aside),
            ("--max-climb", self.max_climb),
            ("--from-level", self.from_level),
            ("--to-level", self.to_level),
        ];
        let numbers = numbers.into_iter().map(|(name, number)| (name, number.is_some()));
        numbers.chain([("--level", self.level.is_some()), ("--measure", self.measure.is_some())]).collect()
    }

    fn surface(&self, moves: TerrainMoves) -> TerrainMoves {
        let own = if let TerrainMoves::Surface { max_slope } = moves { max_slope } else { 90.0 };
        TerrainMoves::Surface { max_slope: self.max_slope.unwrap_or(own) }
    }

    fn slices(&self, map: &Imported, terrain: TerrainSpec) -> SliceRules {
        let own = match terrain.moves {
            TerrainMoves::Slices(rules) => rules,
            TerrainMoves::Surface { .. } => {
                let spec = &map.spec;
                SliceRules::fitting_map(&map.grid, terrain.vertical_unit, spec.start, spec.goals[0].at, self.level)
            }
        };
        SliceRules {
            level: self.level.unwrap_or(own.level),
            levels: self.levels.unwrap_or(own.levels),
            max_aside: self.max_aside.unwrap_or(own.max_aside),
            max_climb: self.max_climb.unwrap_or(own.max_climb),
            start_level: self.from_level.unwrap_or(own.start_level),
            goal_level: self.to_level.unwrap_or(own.goal_level),
            measure: self.measure.map_or(own.measure, |by| match by {
                MeasuredBy::Cost => Measure::Cost,
                MeasuredBy::Length => Measure::Length,
            }),
        }
    }
}
