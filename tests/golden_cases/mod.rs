//! Frozen results: the same runs must give the same 64 bits natively, in node and in Chromium, today and in every later version.
//!
//! A change of a digest is a change of results: it needs an entry under "Results" in CHANGELOG.md that says why.

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::{CornerRule, Generator, Movement, Moves, generate};
use formicarium::params::{Value, Values};
use formicarium::scenario::Scenario;

/// One frozen run on a generated map.
pub struct Golden {
    pub map: (Generator, u32, u32, u32, f64),
    pub movement: Movement,
    pub planner: &'static str,
    pub values: &'static [(&'static str, &'static str)],
    pub seed: u32,
    pub digest: &'static str,
}

const fn eight(corner_rule: CornerRule) -> Movement {
    Movement { moves: Moves::Eight, corner_rule }
}

const FOUR: Movement = Movement { moves: Moves::Four, corner_rule: CornerRule::BothFree };

/// All frozen runs; each long enough that a difference in the last bit of one power would show.
pub const GOLDENS: &[Golden] = &[
    Golden {
        map: (Generator::Random, 40, 30, 1, 0.25),
        movement: eight(CornerRule::BothFree),
        planner: "ant-system",
        values: &[("iterations", "200")],
        seed: 1,
        digest: "bddbb33e94477789",
    },
    Golden {
        map: (Generator::Cave, 64, 48, 2, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "ant-system",
        values: &[("alpha", "1.3"), ("beta", "2.7"), ("rho", "0.13"), ("heuristic", "goal"), ("iterations", "60")],
        seed: 20,
        digest: "e51a47a1ed60d87f",
    },
    Golden {
        map: (Generator::Random, 50, 50, 3, 0.15),
        movement: eight(CornerRule::Always),
        planner: "ant-system",
        values: &[("beta", "25"), ("dead_end", "die"), ("heuristic", "detour"), ("iterations", "60"), ("move_limit", "0")],
        seed: 4_294_967_295,
        digest: "752e418bfd16aa17",
    },
    Golden {
        map: (Generator::Maze, 41, 41, 4, 0.0),
        movement: FOUR,
        planner: "ant-system",
        values: &[("ants", "7"), ("stagnation", "20")],
        seed: 0,
        digest: "2c40910d77469bc5",
    },
    Golden {
        map: (Generator::Random, 128, 128, 5, 0.3),
        movement: eight(CornerRule::BothFree),
        planner: "astar",
        values: &[],
        seed: 1,
        digest: "b274e6f013e9e267",
    },
    Golden {
        map: (Generator::Cave, 100, 80, 6, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "dijkstra",
        values: &[],
        seed: 1,
        digest: "3257cc7edd4cd43c",
    },
    Golden {
        map: (Generator::Cave, 60, 45, 8, 0.0),
        movement: eight(CornerRule::BothFree),
        planner: "ship",
        values: &[],
        seed: 3,
        digest: "0a84f39a83da6f3c",
    },
    Golden {
        map: (Generator::Random, 30, 30, 9, 0.25),
        movement: eight(CornerRule::OneFree),
        planner: "ship",
        values: &[("reading", "printed"), ("alpha", "1.2"), ("beta", "2.5"), ("iterations", "60")],
        seed: 4,
        digest: "4bb26f772a938a26",
    },
    Golden {
        map: (Generator::Random, 24, 24, 7, 0.2),
        movement: eight(CornerRule::OneFree),
        planner: "acost",
        values: &[],
        seed: 1,
        digest: "f5763cce1bd455be",
    },
    Golden {
        map: (Generator::Random, 30, 24, 8, 0.15),
        movement: eight(CornerRule::BothFree),
        planner: "acost",
        values: &[("reading", "printed"), ("alpha", "1.3"), ("beta", "2.7"), ("rho", "0.13"), ("iterations", "80")],
        seed: 20,
        digest: "fc232cb6aa712be5",
    },
    Golden {
        map: (Generator::Random, 24, 24, 9, 0.1),
        movement: eight(CornerRule::BothFree),
        planner: "acomsp",
        values: &[],
        seed: 3,
        digest: "6cf9edabea98fcfa",
    },
    Golden {
        map: (Generator::Cave, 60, 60, 11, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "elitist-ant-system",
        values: &[("elitists", "12.5"), ("beta", "3.3"), ("iterations", "80")],
        seed: 11,
        digest: "f80f09fc4c894b31",
    },
    Golden {
        map: (Generator::Random, 60, 50, 12, 0.25),
        movement: eight(CornerRule::BothFree),
        planner: "rank-based-ant-system",
        values: &[("alpha", "1.2"), ("iterations", "150")],
        seed: 12,
        digest: "160e64d9b9234b92",
    },
    Golden {
        map: (Generator::Random, 50, 60, 13, 0.3),
        movement: eight(CornerRule::Always),
        planner: "max-min-ant-system",
        values: &[("beta", "2.5"), ("best_every", "7"), ("restart_after", "40"), ("iterations", "300")],
        seed: 13,
        digest: "34393c6c3b8de289",
    },
    Golden {
        map: (Generator::Rooms, 60, 60, 14, 0.0),
        movement: eight(CornerRule::BothFree),
        planner: "ant-colony-system",
        values: &[("q0", "0.7"), ("beta", "2"), ("iterations", "200")],
        seed: 14,
        digest: "0e2252706b7f8286",
    },
];

impl Golden {
    /// Runs it to its end; the digest.
    pub fn run(&self) -> String {
        let (kind, width, height, map_seed, density) = self.map;
        let made = generate(kind, width, height, map_seed, density).expect("a valid size");
        let scenario = Arc::new(Scenario::on(made.grid, self.movement, made.start, made.goal).expect("usable"));
        let values: Values = self.values.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect();
        let mut planner = catalog::build(&scenario, self.planner, None, &values, self.seed).expect("valid parameters");
        planner.run();
        planner.digest().hex()
    }
}

/// Runs all of them and tells every difference at once.
pub fn check_all() {
    let differs = |(i, g): (usize, &Golden)| {
        let digest = g.run();
        (digest != g.digest).then(|| format!("golden {i} ({}): {digest}, frozen {}", g.planner, g.digest))
    };
    let wrong: Vec<String> = GOLDENS.iter().enumerate().filter_map(differs).collect();
    assert!(wrong.is_empty(), "results have changed:\n{}", wrong.join("\n"));
}
