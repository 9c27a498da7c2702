//! Made-up maps: random obstacles, a maze, rooms with doors, a cave; terrains of eroded ground or of round hills. Seeded, and the same
//! bits on every machine.
//!
//! Start and goal lie near the upper-left and the lower-right corner and are connected even under 4 moves (so under every
//! corner rule). Mazes and rooms are connected by construction; elsewhere walls are opened along the path from start to goal
//! that needs the fewest openings ([`openings`]), which leaves a map alone where both are connected already.
//! Planes are integer arithmetic over one random stream, terrains f64 with `libm` alone; all are linear in the number of cells.

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

/// Largest share of obstacles that [`Generator::Random`] takes, and largest roughness of the terrains.
pub const MAX_DENSITY: f64 = 0.9;

/// Smallest side at which mazes and rooms get a wall around them.
const FRAMED_SIDE: u32 = 5;

/// Metres a cell of a terrain: the grid of the radar mission that mapped most of the land.
const RESOLUTION: f64 = 30.0;

listed! {
    /// What kind of map to make. Serialized as `random`, `maze`, `rooms`, `cave`, `hills`, `fractal`.
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
            Self::Random => Some("density"),
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

/// Makes a map. `density` is the share of obstacles for [`Generator::Random`], the roughness of terrains, 0 to [`MAX_DENSITY`]; the others
/// do not look at it. The relief of a terrain is 12 % of its longer side.
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
    let (start, goal) = (Point::new(0, 0), Point::new(grid.width() - 1, grid.height() - 1));
    openings::connect(&mut grid, start, goal);
    Ok(Generated::plane(grid, start, goal))
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
mod tests {
    use super::*;
    use crate::map::{MoveSet, Movement, Moves};

    const SIZES: [(u32, u32); 12] =
        [(1, 1), (1, 2), (2, 1), (2, 2), (1, 40), (3, 3), (4, 5), (5, 5), (6, 6), (7, 30), (20, 20), (65, 48)];

    fn connected(made: &Generated, moves: Moves) -> bool {
        let movement = Movement { moves, ..Movement::default() };
        let (start, goal) = (made.grid.cell(made.start), made.grid.cell(made.goal));
        MoveSet::new(&made.grid, movement).connected(start, goal)
    }

    #[test]
    fn ends_are_free_and_connected_for_every_kind_and_size() {
        for kind in Generator::ALL {
            for (w, h) in SIZES {
                for seed in 0..20 {
                    for density in [0.0, 0.3, MAX_DENSITY] {
                        let made = generate(kind, w, h, seed, density).unwrap();
                        assert!(!made.grid.is_blocked(made.grid.cell(made.start)), "{kind:?} {w}×{h} seed {seed}");
                        assert!(!made.grid.is_blocked(made.grid.cell(made.goal)), "{kind:?} {w}×{h} seed {seed}");
                        assert!(connected(&made, Moves::Four), "{kind:?} {w}×{h} seed {seed}");
                        assert!(connected(&made, Moves::Eight), "{kind:?} {w}×{h} seed {seed}");
                    }
                }
            }
        }
    }

    #[test]
    fn start_is_upper_left_and_goal_lower_right() {
        for kind in Generator::ALL {
            for seed in 0..20 {
                let made = generate(kind, 60, 40, seed, 0.3).unwrap();
                assert!(made.start.x + made.start.y <= 24, "{kind:?} seed {seed}: {:?}", made.start);
                assert!(59 - made.goal.x + 39 - made.goal.y <= 24, "{kind:?} seed {seed}: {:?}", made.goal);
            }
        }
    }

    #[test]
    fn same_seed_same_map_and_other_seed_another() {
        for kind in Generator::ALL {
            let make = |seed| generate(kind, 40, 41, seed, 0.3).unwrap();
            assert_eq!(make(7), make(7), "{kind:?}");
            assert_ne!(make(7), make(8), "{kind:?}");
        }
    }

    #[test]
    fn maps_keep_their_bits_from_version_to_version() {
        let digest = |kind| {
            let made = generate(kind, 64, 48, 1, 0.3).unwrap();
            let mut digest = crate::digest::Digest::default();
            digest.bytes(&made.grid.to_bytes());
            made.grid.heights().iter().flat_map(|h| h.iter()).for_each(|h| digest.bytes(&h.to_le_bytes()));
            digest.hex()
        };
        let golden = [
            "2c632ca1d68b3b45",
            "fd359060835c17a6",
            "6121c2df948c6a04",
            "79eee4b11e1b285f",
            "479969d69fde95d5",
            "e66abdfd28e817a1",
        ];
        assert_eq!(Generator::ALL.map(digest), golden);
    }

    #[test]
    fn terrains_rise_from_0_to_their_relief() {
        for kind in [Generator::Fractal, Generator::Hills] {
            for (w, h) in [(2, 2), (21, 21), (40, 90), (257, 129)] {
                for roughness in [0.0, 0.5, MAX_DENSITY] {
                    let made = generate(kind, w, h, 3, roughness).unwrap();
                    let heights = made.grid.heights().unwrap();
                    let (low, high) = heights.iter().fold((f32::MAX, f32::MIN), |(l, h), &v| (l.min(v), h.max(v)));
                    let relief = (0.12 * 30.0 * f64::from(w.max(h)) * 10.0).round() / 10.0;
                    assert_eq!((low, high, made.resolution), (0.0, relief as f32, 30.0), "{kind:?} {w}×{h} {roughness}");
                    assert_eq!(made.grid.free_count(), made.grid.len());
                }
            }
        }
    }

    #[test]
    fn rough_ground_is_steeper() {
        for kind in [Generator::Fractal, Generator::Hills] {
            let steepness = |roughness| -> f64 {
                let makes = (0..20).map(|seed| generate(kind, 128, 128, seed, roughness).unwrap());
                let climb = |heights: &[f32]| heights.windows(2).map(|h| f64::from((h[1] - h[0]).abs())).sum::<f64>();
                makes.map(|made| climb(made.grid.heights().unwrap())).sum()
            };
            let steep = [0.0, 0.3, 0.6, 0.9].map(steepness);
            assert!(steep.is_sorted(), "{kind:?}: {steep:?}");
        }
    }

    #[test]
    fn a_maze_is_a_tree() {
        for (w, h) in [(5, 5), (6, 7), (20, 20), (21, 21), (64, 48)] {
            let grid = generate(Generator::Maze, w, h, 3, 0.0).unwrap().grid;
            let free = |x: i64, y: i64| u32::from(grid.is_free_at(x, y));
            let links: u32 = (0..i64::from(h))
                .flat_map(|y| (0..i64::from(w)).map(move |x| (x, y)))
                .map(|(x, y)| free(x, y) * (free(x + 1, y) + free(x, y + 1)))
                .sum();
            assert_eq!(links as usize + 1, grid.free_count(), "{w}×{h}: connected with n − 1 links");
        }
    }

    #[test]
    fn density_is_kept_and_checked() {
        let made = generate(Generator::Random, 200, 200, 5, 0.3).unwrap();
        let share = 1.0 - made.grid.free_count() as f64 / 40_000.0;
        assert!((share - 0.3).abs() < 0.01, "{share}");
        for density in [-0.1, 0.95, f64::NAN] {
            assert!(generate(Generator::Random, 9, 9, 0, density).is_err(), "{density}");
        }
        for density in [-0.1, 0.95, f64::NAN] {
            let refused = generate(Generator::Hills, 9, 9, 0, density).unwrap_err();
            assert!(refused.to_string().starts_with("roughness"), "{refused}");
        }
        assert!(generate(Generator::Cave, 0, 9, 0, 0.0).is_err());
    }
}
