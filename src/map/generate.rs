//! Made-up maps: random obstacles, a maze, rooms with doors, a cave, blocks, bars; terrains of eroded ground or of round hills. Seeded, and the same
//! bits on every machine.
//!
//! Start and goal lie near the upper-left and the lower-right corner and are connected even under 4 moves (so under every
//! corner rule). Mazes and rooms are connected by construction; elsewhere walls are opened along the path from start to goal
//! that needs the fewest openings ([`openings`]), which leaves a map alone where both are connected already.
//! Planes are integer arithmetic over one random stream, terrains f64 with `libm` alone; all are linear in the number of cells.

mod bars;
mod blocks;
mod cave;
mod fractal;
mod hills;
mod maze;
mod openings;
mod rooms;
mod terrain;

use rand::Rng;
use serde::{Deserialize, Serialize};

use super::grid::{Grid, Point, check_size};
use crate::error::ScenarioError;
use crate::listed::listed;
use crate::rng::{Stream, Streams};

/// Largest share of obstacles that a generator takes, and largest roughness of the terrains.
pub const MAX_DENSITY: f64 = 0.9;

/// Smallest side at which mazes and rooms get a wall around them.
const FRAMED_SIDE: u32 = 5;

/// Metres a cell of a terrain: the grid of the radar mission that mapped most of the land.
const RESOLUTION: f64 = 30.0;

listed! {
    /// What kind of map to make. Serialized as `random`, `maze`, `rooms`, `cave`, `blocks`, `bars`, `hills`, `fractal`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Generator {
        /// Every cell is blocked with the same probability.
        Random,
        /// A perfect maze: exactly one way between any two cells, corridors one cell wide.
        Maze,
        /// Rectangular rooms of different sizes, joined by doors.
        Rooms,
        /// A cave of round chambers, grown by a cellular automaton.
        Cave,
        /// Rectangular blocks of different sizes with aisles between them, as machinery stands.
        Blocks,
        /// Straight walls of different lengths that touch and cross.
        Bars,
        /// A terrain of round hills.
        Hills,
        /// A terrain of eroded ground: value noise in octaves.
        Fractal,
    }
}

impl Generator {
    /// Whether it makes heights.
    pub const fn is_terrain(self) -> bool {
        matches!(self, Self::Fractal | Self::Hills)
    }

    /// What the number beside size and seed says, 0 to [`MAX_DENSITY`]: the `density` of obstacles or the `roughness` of the ground; none where
    /// the generator does not look at it.
    pub const fn asks_for(self) -> Option<&'static str> {
        match self {
            Self::Random | Self::Blocks | Self::Bars => Some("density"),
            Self::Fractal | Self::Hills => Some("roughness"),
            Self::Maze | Self::Rooms | Self::Cave => None,
        }
    }

    /// Its id in files, links and on the command line.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Maze => "maze",
            Self::Rooms => "rooms",
            Self::Cave => "cave",
            Self::Blocks => "blocks",
            Self::Bars => "bars",
            Self::Fractal => "fractal",
            Self::Hills => "hills",
        }
    }
}

/// A made-up map.
#[derive(Debug, Clone, PartialEq)]
pub struct Generated {
    /// The map; with heights in metres on a terrain.
    pub grid: Grid,
    /// A free cell near the upper left.
    pub start: Point,
    /// A free cell near the lower right, connected with the start under 4 moves.
    pub goal: Point,
    /// Metres per cell: 1 on planes, 30 on terrains.
    pub resolution: f64,
}

impl Generated {
    /// A plane.
    fn plane(grid: Grid, start: Point, goal: Point) -> Self {
        Self { grid, start, goal, resolution: 1.0 }
    }
}

/// Makes a map. `density` is the share of obstacles or the roughness of terrains, 0 to [`MAX_DENSITY`], as [`Generator::asks_for`] says; the
/// others do not look at it. The relief of a terrain is 12 % of its longer side.
///
/// # Errors
/// [`ScenarioError::MapSize`], or [`ScenarioError::Quantity`] for the density.
pub fn generate(kind: Generator, width: u32, height: u32, seed: u32, density: f64) -> Result<Generated, ScenarioError> {
    check_size(u64::from(width), u64::from(height))?;
    check_density(kind, density)?;
    let mut dice = Dice::new(seed, kind);
    match kind {
        Generator::Random => random(Grid::open(width, height)?, &mut dice, density),
        Generator::Maze => Ok(maze::carve(solid(width, height)?, &mut dice)),
        Generator::Rooms => Ok(rooms::build(Grid::open(width, height)?, &mut dice)),
        Generator::Cave => Ok(cave::grow(Grid::open(width, height)?, &mut dice)),
        Generator::Blocks => Ok(blocks::place(Grid::open(width, height)?, &mut dice, density)),
        Generator::Bars => Ok(bars::place(Grid::open(width, height)?, &mut dice, density)),
        Generator::Fractal => fractal::ground(width, height, &mut dice, density).terrain(),
        Generator::Hills => hills::ground(width, height, &mut dice, density).terrain(),
    }
}

fn check_density(kind: Generator, density: f64) -> Result<(), ScenarioError> {
    let Some(field) = kind.asks_for() else { return Ok(()) };
    let allowed = if kind.is_terrain() { "a number between 0 and 0.9" } else { "a share between 0 and 0.9" };
    let value = density.to_string();
    if (0.0..=MAX_DENSITY).contains(&density) { Ok(()) } else { Err(ScenarioError::Quantity { field, value, allowed }) }
}

fn random(mut grid: Grid, dice: &mut Dice, density: f64) -> Result<Generated, ScenarioError> {
    let chance = Chance::of(density);
    for cell in 0..grid.len() as u32 {
        grid.set_blocked(cell, dice.happens(chance));
    }
    Ok(corner_to_corner(grid))
}

/// From the upper-left to the lower-right corner, the fewest walls between them opened.
fn corner_to_corner(mut grid: Grid) -> Generated {
    let (start, goal) = (Point::new(0, 0), Point::new(grid.width() - 1, grid.height() - 1));
    openings::connect(&mut grid, start, goal);
    Generated::plane(grid, start, goal)
}

/// How many cells a share of the map comes to.
fn cells_of(grid: &Grid, density: f64) -> usize {
    (density * grid.len() as f64) as usize
}

/// A map without a free cell.
fn solid(width: u32, height: u32) -> Result<Grid, ScenarioError> {
    Grid::from_bytes(width, height, &vec![1; width as usize * height as usize])
}

/// How wide the wall around the map is: 1, or 0 where it would leave no room.
fn frame(grid: &Grid) -> u32 {
    u32::from(grid.width().min(grid.height()) >= FRAMED_SIDE)
}

/// A probability as a threshold for 32 random bits: exact, and the same everywhere.
#[derive(Debug, Clone, Copy)]
struct Chance(u64);

impl Chance {
    fn of(probability: f64) -> Self {
        Self((probability * 4_294_967_296.0) as u64)
    }
}

/// The random stream of one map.
struct Dice(Stream);

impl Dice {
    fn new(seed: u32, kind: Generator) -> Self {
        let name = format!("generate-{}", kind.id());
        Self(Streams::new(u64::from(seed), &name, 0).ant(0, 0))
    }

    /// A whole number below `n`; 0 when `n` is 0.
    fn below(&mut self, n: u32) -> u32 {
        ((u64::from(self.0.next_u32()) * u64::from(n)) >> 32) as u32
    }

    /// A number from 0 to below 1, in steps of 2⁻³².
    fn share(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / 4_294_967_296.0
    }

    fn happens(&mut self, chance: Chance) -> bool {
        u64::from(self.0.next_u32()) < chance.0
    }
}

#[cfg(test)]
mod tests;
