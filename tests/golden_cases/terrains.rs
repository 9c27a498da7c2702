//! Frozen results on terrains: the same hills, made by whole numbers, under every way of moving over them.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::{CornerRule, Grid, Measure, Movement, Moves, Point, SliceRules};
use formicarium::params::{Value, Values};
use formicarium::scenario::{Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};

/// How one moves over the hills.
pub enum Way {
    /// On the surface, with this steepest slope in degrees.
    Surface(Moves, f64),
    /// By slices.
    Slices(Measure),
}

/// One frozen run over the hills.
pub struct TerrainGolden {
    pub way: Way,
    pub planner: &'static str,
    pub values: &'static [(&'static str, &'static str)],
    pub seed: u32,
    pub digest: &'static str,
}

/// All frozen runs on terrains.
pub const TERRAINS: &[TerrainGolden] = &[
    TerrainGolden { way: Way::Surface(Moves::Sixteen, 90.0), planner: "astar", values: &[], seed: 1, digest: "2be82f03cf0dc931" },
    TerrainGolden { way: Way::Surface(Moves::Four, 80.0), planner: "astar", values: &[], seed: 1, digest: "d60bfd8c681f4d00" },
    TerrainGolden {
        way: Way::Surface(Moves::Eight, 70.0),
        planner: "dijkstra",
        values: &[],
        seed: 1,
        digest: "4e9b9769e5d70bb7",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Eight, 75.0),
        planner: "any-angle",
        values: &[],
        seed: 1,
        digest: "cf4e92463d6a6ce2",
    },
    TerrainGolden { way: Way::Slices(Measure::Cost), planner: "slices-exact", values: &[], seed: 1, digest: "705fcaafc4d7a69a" },
    TerrainGolden {
        way: Way::Slices(Measure::Length),
        planner: "slices-exact",
        values: &[],
        seed: 1,
        digest: "544f75a056d8120c",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Eight, 80.0),
        planner: "ant-system",
        values: &[("alpha", "1.3"), ("beta", "2.7"), ("iterations", "40")],
        seed: 23,
        digest: "95cbd671832ba5b0",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Eight, 90.0),
        planner: "ship",
        values: &[("iterations", "40")],
        seed: 24,
        digest: "f476c245cafff79b",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "pso",
        values: &[("particles", "50"), ("iterations", "100")],
        seed: 25,
        digest: "4165243cb712ff61",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Length),
        planner: "pso",
        values: &[("inertia_start", "0.73"), ("inertia_end", "0.73"), ("cognitive", "1.5"), ("social", "1.5")],
        seed: 26,
        digest: "106338cfb1d95bd5",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Sixteen, 80.0),
        planner: "pso",
        values: &[("decode_limit", "6"), ("stagnation", "12")],
        seed: 27,
        digest: "60eeecde325e44a4",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "terrain-aco",
        values: &[("heuristic", "both"), ("alpha", "1.3"), ("beta", "2.7")],
        seed: 28,
        digest: "43102f2b1943465a",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Length),
        planner: "terrain-epf",
        values: &[("q0", "0.4"), ("elite", "0.2"), ("iterations", "80")],
        seed: 29,
        digest: "ef95d28f3ceacbc6",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Sixteen, 80.0),
        planner: "terrain-aco",
        values: &[("beta", "3.3"), ("iterations", "40")],
        seed: 30,
        digest: "6ec3b5eda49837ad",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Sixteen, 90.0),
        planner: "terrain-epf",
        values: &[("reading", "printed"), ("beta", "2.5"), ("repulsion", "3"), ("dead_end", "die"), ("iterations", "40")],
        seed: 31,
        digest: "3dafb6d2ecaa1db5",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Eight, 75.0),
        planner: "terrain-epf",
        values: &[("ants", "31"), ("force_base", "1.7"), ("q0", "0.5"), ("iterations", "40")],
        seed: 32,
        digest: "9c7d49227e9b9127",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "terrain-aco",
        values: &[("local_rule", "acs"), ("initial_trail", "0.01")],
        seed: 33,
        digest: "cfd87ed3b9a74ac4",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "terrain-epf",
        values: &[("local_rule", "acs"), ("initial_trail", "0.01"), ("level_height", "0.2"), ("directions", "eight")],
        seed: 34,
        digest: "79245bb209207818",
    },
    TerrainGolden {
        way: Way::Surface(Moves::Sixteen, 90.0),
        planner: "terrain-epf",
        values: &[("local_rule", "acs"), ("initial_trail", "0.01"), ("directions", "eight"), ("iterations", "40")],
        seed: 35,
        digest: "5ff5b35fc8f491b9",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "terrain-textbook",
        values: &[],
        seed: 36,
        digest: "443ab4acdc26988b",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "terrain-textbook",
        values: &[("reading", "printed"), ("local_rho", "0.5"), ("alpha", "1.3"), ("beta", "2.7")],
        seed: 37,
        digest: "ceba27fd0de98d8b",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "terrain-textbook",
        values: &[("ants", "50"), ("beta", "7")],
        seed: 38,
        digest: "457db02e99ab785b",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "acs-slices",
        values: &[("q0", "0.7"), ("heuristic", "cost-and-distance")],
        seed: 39,
        digest: "8df63a6088185a89",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Length),
        planner: "mmas-slices",
        values: &[("beta", "2.5"), ("best_every", "7"), ("restart_after", "20")],
        seed: 40,
        digest: "8fe0e8414815bbcd",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "ga",
        values: &[("iterations", "60")],
        seed: 41,
        digest: "e7c89f562439812e",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Cost),
        planner: "formica-slices",
        values: &[],
        seed: 42,
        digest: "c29070d3fed00734",
    },
    TerrainGolden {
        way: Way::Slices(Measure::Length),
        planner: "formica-slices",
        values: &[("ants", "7"), ("beta", "2.3"), ("kappa", "1.1"), ("proof_limit", "0"), ("iterations", "12")],
        seed: 43,
        digest: "c75b27713cabd88a",
    },
];

/// 40 × 30 cells of 30 m: ridges and valleys up to 630 m, rough by up to 40 m, with a hole without data.
fn hills() -> Grid {
    let fold = |k: u32, period: u32| (k % (2 * period)).abs_diff(period);
    let rough = |x: u32, y: u32| (x.wrapping_mul(0x9e37_79b9) ^ y.wrapping_mul(0x85eb_ca6b)).wrapping_mul(0xc2b2_ae35) >> 16;
    let height = |x: u32, y: u32| {
        let hole = (18..22).contains(&x) && (3..9).contains(&y);
        if hole { f32::NAN } else { (fold(x, 9) * fold(y, 7) * 10 + rough(x, y) % 40) as f32 }
    };
    let heights = (0..30).flat_map(|y| (0..40).map(move |x| height(x, y))).collect();
    Grid::open(40, 30).and_then(|grid| grid.with_heights(heights)).expect("a height for each cell")
}

/// From the left edge to the right edge of the hills.
fn scenario(way: &Way) -> Arc<Scenario> {
    let (grid, start, goal) = (hills(), Point::new(0, 15), Point::new(39, 12));
    let level = 50.0;
    let lowest =
        |p: Point| libm::ceil(f64::from(grid.heights().map_or(0.0, |h| h[grid.cell(p) as usize])) / level).max(1.0) as u32;
    let (start_level, goal_level) = (lowest(start), lowest(goal));
    let rules = |measure| SliceRules { level, levels: 15, max_aside: 2, max_climb: 2, start_level, goal_level, measure };
    let (moves, terrain) = match *way {
        Way::Surface(moves, max_slope) => (moves, TerrainMoves::Surface { max_slope }),
        Way::Slices(measure) => (Moves::Eight, TerrainMoves::Slices(rules(measure))),
    };
    let spec = ScenarioSpec {
        resolution: 30.0,
        movement: Movement { moves, corner_rule: CornerRule::OneFree },
        terrain: Some(TerrainSpec { vertical_unit: 1.0, moves: terrain }),
        ..ScenarioSpec::new(&grid, start, goal)
    };
    Arc::new(Scenario::new(grid, spec).expect("usable"))
}

impl TerrainGolden {
    /// Runs it to its end; the digest. A run that finds nothing would freeze nothing.
    pub fn run(&self) -> String {
        let scenario = scenario(&self.way);
        let values: Values = self.values.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect();
        let mut planner = catalog::build(&scenario, self.planner, None, &values, self.seed).expect("valid parameters");
        planner.run();
        assert!(planner.best().is_some(), "{} found no path", self.planner);
        planner.digest().hex()
    }
}

/// Every difference, in words.
pub fn differences() -> impl Iterator<Item = String> {
    TERRAINS.iter().enumerate().filter_map(|(i, g)| {
        let digest = g.run();
        (digest != g.digest).then(|| format!("terrain {i} ({}): {digest}, frozen {}", g.planner, g.digest))
    })
}
