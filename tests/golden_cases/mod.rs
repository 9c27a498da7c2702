//! Frozen results: the same runs must give the same 64 bits natively, in node and in Chromium, today and in every later version.
//!
//! A change of a digest is a change of results: it needs an entry under "Results" in CHANGELOG.md that says why.

mod changes;
mod drives;
mod terrains;

use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::{CornerRule, Generator, Movement, Moves, generate};
use formicarium::params::{Value, Values};
use formicarium::scenario::{Goal, Scenario, ScenarioSpec};

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
        map: (Generator::Random, 128, 128, 5, 0.3),
        movement: eight(CornerRule::BothFree),
        planner: "d-star-lite",
        values: &[],
        seed: 1,
        digest: "3ca442f54771dc4e",
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
        digest: "a806d5f0bba016dd",
    },
    Golden {
        map: (Generator::Random, 30, 30, 9, 0.25),
        movement: eight(CornerRule::OneFree),
        planner: "ship",
        values: &[("reading", "printed"), ("alpha", "1.2"), ("beta", "2.5"), ("iterations", "60")],
        seed: 4,
        digest: "83f81253738ac3bf",
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
        map: (Generator::Rooms, 64, 64, 2, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "formica",
        values: &[],
        seed: 1,
        digest: "76b0b996be837f65",
    },
    Golden {
        map: (Generator::Bars, 64, 48, 2, 0.3),
        movement: eight(CornerRule::OneFree),
        planner: "formica",
        values: &[("ants", "7"), ("beta", "2.7"), ("kappa", "1.3"), ("rho", "0.13"), ("proof_limit", "0"), ("iterations", "12")],
        seed: 20,
        digest: "8dfafe96946e15e5",
    },
    Golden {
        map: (Generator::Random, 64, 64, 7, 0.3),
        movement: eight(CornerRule::OneFree),
        planner: "formica",
        values: &[
            ("paths", "polylines"),
            ("ants", "7"),
            ("kappa", "1.3"),
            ("widening", "0"),
            ("corridor", "0"),
            ("corridor_most", "3"),
            ("proof_limit", "0"),
            ("iterations", "12"),
        ],
        seed: 20,
        digest: "ba8681dbc59f2401",
    },
    Golden {
        map: (Generator::Rooms, 64, 64, 3, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "formica",
        values: &[("criterion", "turn-index")],
        seed: 1,
        digest: "6ae45f4cf8ed9bea",
    },
    Golden {
        map: (Generator::Cave, 64, 48, 5, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "formica",
        values: &[("criterion", "weighted-sum"), ("turn_weight", "1.7"), ("energy_weight", "0.3"), ("clearance_wanted", "2.3")],
        seed: 7,
        digest: "257ca3ac311a341b",
    },
    Golden {
        map: (Generator::Cave, 40, 30, 21, 0.0),
        movement: eight(CornerRule::BothFree),
        planner: "maaco",
        values: &[("alpha", "1.3"), ("beta", "6.7"), ("iterations", "60")],
        seed: 5,
        digest: "4041e71880182225",
    },
    Golden {
        map: (Generator::Random, 30, 24, 22, 0.2),
        movement: eight(CornerRule::OneFree),
        planner: "maaco",
        values: &[
            ("initial", "cell-entered"),
            ("orientation", "start-to-goal"),
            ("late_greed", "grows"),
            ("trail_limits", "max-min"),
            ("iterations", "40"),
        ],
        seed: 6,
        digest: "0ef0adfd6993f008",
    },
    Golden {
        map: (Generator::Cave, 40, 30, 23, 0.0),
        movement: eight(CornerRule::BothFree),
        planner: "iaaco",
        values: &[("alpha", "1.3"), ("angle_weight", "4.7"), ("iterations", "60")],
        seed: 7,
        digest: "df0f9a51fb11bd6f",
    },
    Golden {
        map: (Generator::Random, 30, 24, 24, 0.2),
        movement: FOUR,
        planner: "ihmaco",
        values: &[("beta", "2.7"), ("dead_end", "backtrack"), ("iterations", "60")],
        seed: 8,
        digest: "198727ad193ab8ba",
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
    Golden {
        map: (Generator::Random, 40, 40, 15, 0.25),
        movement: eight(CornerRule::OneFree),
        planner: "best-worst-ant-system",
        values: &[("beta", "2.5"), ("restart_below", "0.4"), ("iterations", "150")],
        seed: 15,
        digest: "b974413103a9d262",
    },
    Golden {
        map: (Generator::Random, 24, 24, 15, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "fwa",
        values: &[("reading", "printed"), ("range", "2.5"), ("decode_limit", "12")],
        seed: 15,
        digest: "197328dc3d90747f",
    },
    Golden {
        map: (Generator::Cave, 40, 30, 16, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "ifwa",
        values: &[("sparks", "20"), ("radius_end", "0.1")],
        seed: 16,
        digest: "ddadc74e5f50e892",
    },
    Golden {
        map: (Generator::Random, 30, 30, 17, 0.25),
        movement: eight(CornerRule::BothFree),
        planner: "fwa-aco",
        values: &[("seed_ants", "12.5")],
        seed: 17,
        digest: "cbaa8ee481989f71",
    },
    Golden {
        map: (Generator::Random, 24, 24, 18, 0.2),
        movement: FOUR,
        planner: "pso-aco",
        values: &[("alpha", "1.3"), ("rho", "0.9"), ("seed_iterations", "30"), ("iterations", "40")],
        seed: 18,
        digest: "38addda11c66b0d8",
    },
    Golden {
        map: (Generator::Random, 24, 24, 28, 0.2),
        movement: Movement { moves: Moves::Sixteen, corner_rule: CornerRule::BothFree },
        planner: "pso",
        values: &[("speed_limit", "0.5"), ("iterations", "40")],
        seed: 28,
        digest: "3110c83169eaa046",
    },
    Golden {
        map: (Generator::Random, 24, 24, 29, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "ga",
        values: &[("crossover", "exchange"), ("mutations", "3.5"), ("iterations", "40")],
        seed: 29,
        digest: "da97f5abcc0fb6fd",
    },
    Golden {
        map: (Generator::Rooms, 60, 60, 15, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "any-angle",
        values: &[],
        seed: 1,
        digest: "4652a5813d881439",
    },
    Golden {
        map: (Generator::Random, 200, 150, 16, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "theta-star",
        values: &[],
        seed: 1,
        digest: "3edfd224f262e088",
    },
    Golden {
        map: (Generator::Cave, 120, 90, 17, 0.0),
        movement: eight(CornerRule::Always),
        planner: "turn-aware",
        values: &[],
        seed: 1,
        digest: "717ee0f4bc954287",
    },
    Golden {
        map: (Generator::Random, 24, 24, 31, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "fwa",
        values: &[("range_min", "0.8"), ("decode_goal", "weighed")],
        seed: 31,
        digest: "fdfcbcb124b7256e",
    },
    Golden {
        map: (Generator::Cave, 40, 30, 32, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "ifwa",
        values: &[("range_min", "0.8"), ("range", "2.5")],
        seed: 32,
        digest: "6e438f92336300a4",
    },
    Golden {
        map: (Generator::Random, 30, 30, 33, 0.25),
        movement: eight(CornerRule::BothFree),
        planner: "fwa-aco",
        values: &[("range_min", "0.8"), ("depositors", "iteration-best")],
        seed: 33,
        digest: "6875a7eede5c016e",
    },
    Golden {
        map: (Generator::Random, 30, 24, 34, 0.2),
        movement: eight(CornerRule::OneFree),
        planner: "fwa-aco",
        values: &[("reading", "printed"), ("depositors", "best-so-far"), ("ants_first", "0.14")],
        seed: 34,
        digest: "4271d568604fc76d",
    },
    Golden {
        map: (Generator::Random, 24, 24, 35, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "pso-aco",
        values: &[("range_min", "0.8"), ("depositors", "iteration-best"), ("ants_first", "0.075"), ("iterations", "40")],
        seed: 35,
        digest: "1502aee2aa8522bf",
    },
    Golden {
        map: (Generator::Random, 24, 24, 36, 0.2),
        movement: eight(CornerRule::OneFree),
        planner: "acost",
        values: &[("goal_step", "enter")],
        seed: 36,
        digest: "f330ed9c4c8b6d36",
    },
    Golden {
        map: (Generator::Random, 24, 24, 37, 0.1),
        movement: eight(CornerRule::BothFree),
        planner: "acomsp",
        values: &[("goal_step", "enter")],
        seed: 37,
        digest: "35219edaeb04f08a",
    },
    Golden {
        map: (Generator::Random, 24, 24, 38, 0.1),
        movement: eight(CornerRule::BothFree),
        planner: "acomsp",
        values: &[("reading", "printed"), ("maximal", "false"), ("beta", "2.7"), ("iterations", "30")],
        seed: 38,
        digest: "887b8b01ff63bae9",
    },
    Golden {
        map: (Generator::Cave, 50, 40, 22, 0.0),
        movement: eight(CornerRule::BothFree),
        planner: "custom",
        values: &[
            ("initial_trail_of", "max-min-ant-system"),
            ("heuristic_of", "ship"),
            ("selection_of", "ant-colony-system"),
            ("local_update_of", "acost"),
            ("update_of", "rank-based-ant-system"),
            ("refinement_of", "ship"),
            ("beta", "1.5"),
            ("q0", "0.6"),
            ("iterations", "60"),
        ],
        seed: 22,
        digest: "434f8b33f25df82d",
    },
    Golden {
        map: (Generator::Cave, 40, 30, 32, 0.0),
        movement: eight(CornerRule::BothFree),
        planner: "ship",
        values: &[("rho_part", "stays")],
        seed: 32,
        digest: "995c58d8932c5d93",
    },
    Golden {
        map: (Generator::Random, 30, 30, 33, 0.25),
        movement: eight(CornerRule::OneFree),
        planner: "ship",
        values: &[("evaporation", "shrinking"), ("count_ants", "true"), ("iterations", "60")],
        seed: 33,
        digest: "a112a85722e90227",
    },
    Golden {
        map: (Generator::Random, 30, 30, 34, 0.25),
        movement: eight(CornerRule::BothFree),
        planner: "ship",
        values: &[("evaporation", "by-lengths"), ("reading", "printed"), ("count_ants", "true"), ("iterations", "60")],
        seed: 34,
        digest: "0ae377e2bff21158",
    },
    Golden {
        map: (Generator::Random, 40, 30, 35, 0.2),
        movement: eight(CornerRule::OneFree),
        planner: "fire",
        values: &[("criterion", "turn-index"), ("legs", "basic"), ("beta", "2.5"), ("iterations", "60")],
        seed: 35,
        digest: "ccb3721e3548d25c",
    },
    Golden {
        map: (Generator::Random, 40, 30, 36, 0.07),
        movement: eight(CornerRule::BothFree),
        planner: "f-rrt-star",
        values: &[],
        seed: 36,
        digest: "56df4df4487b5520",
    },
    Golden {
        map: (Generator::Cave, 40, 30, 37, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "f-rrt-star",
        values: &[("step", "7"), ("near", "2.5"), ("dichotomy", "3"), ("goal_bias", "0.13"), ("samples", "80")],
        seed: 37,
        digest: "1e6f4e8415b55dbd",
    },
    Golden {
        map: (Generator::Random, 40, 30, 38, 0.2),
        movement: eight(CornerRule::BothFree),
        planner: "tdi-msaco",
        values: &[],
        seed: 38,
        digest: "6891d6d6673113c6",
    },
    Golden {
        map: (Generator::Cave, 40, 30, 39, 0.0),
        movement: eight(CornerRule::OneFree),
        planner: "tdi-msaco",
        values: &[
            ("reach", "2"),
            ("distance_power", "2.3"),
            ("index_power", "1.7"),
            ("tabu", "false"),
            ("dead_end", "backtrack"),
            ("move_limit", "0"),
        ],
        seed: 39,
        digest: "3a53be32ef4b83dd",
    },
];

/// Frozen runs by this many goals.
pub const TOURS: &[(u32, Golden)] = &[
    (
        5,
        Golden {
            map: (Generator::Random, 30, 30, 19, 0.2),
            movement: eight(CornerRule::BothFree),
            planner: "fire",
            values: &[],
            seed: 19,
            digest: "605b6c42ba89e292",
        },
    ),
    (
        12,
        Golden {
            map: (Generator::Cave, 40, 30, 20, 0.0),
            movement: eight(CornerRule::OneFree),
            planner: "fire",
            values: &[
                ("order", "distance"),
                ("order_rule", "improved"),
                ("leg_length", "euclidean"),
                ("legs", "basic"),
                ("reading", "printed"),
                ("alpha", "1.2"),
                ("beta", "2.5"),
                ("iterations", "30"),
            ],
            seed: 20,
            digest: "29d51ee496023f3b",
        },
    ),
    (
        4,
        Golden {
            map: (Generator::Random, 30, 30, 38, 0.2),
            movement: eight(CornerRule::BothFree),
            planner: "fire",
            values: &[("leg_length", "euclidean"), ("criterion", "turn-index")],
            seed: 38,
            digest: "490a043e250e74eb",
        },
    ),
    (
        9,
        Golden {
            map: (Generator::Rooms, 60, 45, 21, 0.0),
            movement: eight(CornerRule::Always),
            planner: "tour-exact",
            values: &[],
            seed: 1,
            digest: "0fb0cf8f577b9d37",
        },
    ),
    (
        20,
        Golden {
            map: (Generator::Rooms, 60, 45, 21, 0.0),
            movement: eight(CornerRule::BothFree),
            planner: "formica",
            values: &[("order_iterations", "5"), ("order_limit", "3000"), ("ants", "8")],
            seed: 7,
            digest: "1cfbb19b4e38e6aa",
        },
    ),
    (
        18,
        Golden {
            map: (Generator::Cave, 48, 36, 12, 0.0),
            movement: FOUR,
            planner: "formica",
            values: &[("order", "length"), ("order_limit", "300"), ("iterations", "3"), ("widening", "0"), ("corridor", "1")],
            seed: 3,
            digest: "e6ab5b96c7c2753d",
        },
    ),
    (
        24,
        Golden {
            map: (Generator::Random, 50, 40, 9, 0.2),
            movement: eight(CornerRule::BothFree),
            planner: "tour-exact",
            values: &[("order_limit", "2500")],
            seed: 1,
            digest: "57ccdaa2f288ceec",
        },
    ),
];

/// The map's own goal and others spread over the cells that can be reached, each with another weight.
fn goals(scenario: &Scenario, count: u32) -> Vec<Goal> {
    let reached = scenario.moves.reached_from(scenario.start);
    let free: Vec<u32> =
        (0..).zip(&reached).filter(|(cell, reached)| **reached && *cell != scenario.goal).map(|(cell, _)| cell).collect();
    let spread = |k: u32| {
        let at = scenario.grid.point(free[(k as usize * free.len()) / count as usize]);
        Goal { area: 0.5 + 0.25 * f64::from(k), ..Goal::new(at, "") }
    };
    scenario.spec.goals.iter().cloned().chain((1..count).map(spread)).collect()
}

impl Golden {
    /// Runs it to its end; the digest.
    pub fn run(&self) -> String {
        self.run_by(1)
    }

    /// Runs it to its end by this many goals; the digest.
    pub fn run_by(&self, count: u32) -> String {
        let (kind, width, height, map_seed, density) = self.map;
        let made = generate(kind, width, height, map_seed, density).expect("a valid size");
        let one = Scenario::on(made.grid, self.movement, made.start, made.goal).expect("usable");
        let spec = ScenarioSpec { goals: goals(&one, count), ..one.spec.clone() };
        let scenario = Arc::new(Scenario::new(one.grid, spec).expect("usable"));
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
    let tour_differs = |(i, (count, g)): (usize, &(u32, Golden))| {
        let digest = g.run_by(*count);
        (digest != g.digest).then(|| format!("tour {i} ({}): {digest}, frozen {}", g.planner, g.digest))
    };
    let runs = GOLDENS.iter().enumerate().filter_map(differs);
    let tours = TOURS.iter().enumerate().filter_map(tour_differs);
    let wrong: Vec<String> =
        runs.chain(tours).chain(terrains::differences()).chain(changes::differences()).chain(drives::differences()).collect();
    assert!(wrong.is_empty(), "results have changed:\n{}", wrong.join("\n"));
}
