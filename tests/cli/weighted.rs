//! What ground costs, and the robot that moves on it: `plan`, `check`, `convert` and `bench-scen`.
use serde_json::{Value, json};

use super::folder::Folder;

/// Rows of a map with a wall in its middle, and gaps above and below.
const ROOM: [&str; 9] = [
    "..............",
    "..............",
    "......@.......",
    "......@@......",
    "......@@......",
    "......@.......",
    "..............",
    "............@.",
    "..............",
];

fn room() -> String {
    format!("type octile\nheight 9\nwidth 14\nmap\n{}\n", ROOM.join("\n"))
}

/// Nav2's cost of every cell by its definition, of cells of `cell` metres: `InflationLayer::computeCost`.
fn costs(cell: f64, radius: f64, inflation: f64, scaling: f64) -> Vec<Vec<u8>> {
    let blocked = |x: usize, y: usize| ROOM[y].as_bytes()[x] == b'@';
    let walls: Vec<(usize, usize)> = (0..9).flat_map(|y| (0..14).map(move |x| (x, y))).filter(|&(x, y)| blocked(x, y)).collect();
    let cost = |x: usize, y: usize| {
        let squared = |&(bx, by): &(usize, usize)| (bx.abs_diff(x).pow(2) + by.abs_diff(y).pow(2)) as f64;
        let cells = walls.iter().map(squared).fold(f64::INFINITY, f64::min).sqrt();
        match cells * cell {
            0.0 => 254,
            d if d <= radius => 253,
            d if cells <= (inflation / cell).ceil() => (252.0 * (-scaling * (d - radius)).exp()) as u8,
            _ => 0,
        }
    };
    (0..9).map(|y| (0..14).map(|x| cost(x, y)).collect()).collect()
}

/// What SmacPlanner2D counts for a step into a cell, `getTraversalCost`.
fn smac(costs: &[Vec<u8>], m: f64, from: (usize, usize), to: (usize, usize)) -> f64 {
    let diagonal = from.0 != to.0 && from.1 != to.1;
    (if diagonal { 2f64.sqrt() } else { 1.0 }) * (1.0 + m * f64::from(costs[to.1][to.0]) / 252.0)
}

/// The least that a way between two cells costs by that, no cell of 253 being entered: Bellman and Ford.
fn least(costs: &[Vec<u8>], m: f64, start: (usize, usize), goal: (usize, usize)) -> f64 {
    let mut best = vec![vec![f64::INFINITY; 14]; 9];
    best[start.1][start.0] = 0.0;
    for _ in 0..9 * 14 {
        for (y, x) in (0..9usize).flat_map(|y| (0..14usize).map(move |x| (y, x))) {
            for (dy, dx) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dy, dx))).filter(|&d| d != (0, 0)) {
                let (Some(to_y), Some(to_x)) = (y.checked_add_signed(dy), x.checked_add_signed(dx)) else { continue };
                if to_y < 9 && to_x < 14 && costs[to_y][to_x] < 253 {
                    best[to_y][to_x] = best[to_y][to_x].min(best[y][x] + smac(costs, m, (x, y), (to_x, to_y)));
                }
            }
        }
    }
    best[goal.1][goal.0]
}

const WAY: [(usize, usize); 14] =
    [(0, 4), (1, 3), (2, 2), (3, 1), (4, 0), (5, 0), (6, 0), (7, 0), (8, 0), (9, 0), (10, 1), (11, 2), (12, 3), (13, 4)];

/// A number of a checked path's price.
fn price(found: &Value, path: &str) -> f64 {
    found.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} is no number in {found}"))
}

#[test]
fn a_path_is_counted_as_smac_planner_2d_counts() {
    let folder = Folder::with_map("weighted-smac");
    folder.write("room.map", &room());
    folder.write("way.json", &json!(WAY).to_string());
    let check =
        |more: &[&str]| folder.run(&[&["check", "way.json", "--map", "room.map", "--cost", "nav2-smac-2d"], more].concat());
    let given = ["--cell-size", "0.25", "--robot-radius", "0.3", "--inflation-radius", "1", "--cost-scaling", "2"];
    let with_multiplier = [&given[..], &["--cost-multiplier", "3.5", "--format", "json"]].concat();
    let run = check(&with_multiplier).ends(0);
    assert_eq!(run.err, "", "everything was given");
    let (found, costs) = (run.json(), costs(0.25, 0.3, 1.0, 2.0));
    let by_hand: f64 = WAY.windows(2).map(|s| smac(&costs, 3.5, s[0], s[1])).sum();
    let optimum = least(&costs, 3.5, (0, 4), (13, 4));
    assert!((price(&found, "/price/value") - by_hand).abs() < 1e-5 && by_hand > 16.0, "{by_hand}: factors are f32");
    assert!((price(&found, "/price/reference/value") - optimum).abs() < 1e-5 && optimum < by_hand - 0.1, "{optimum}");
    assert!((price(&found, "/price/gap") - (by_hand / optimum - 1.0)).abs() < 1e-6);
    assert_eq!((&found["price"]["charge"], &found["price"]["reference"]["kind"]), (&json!("entered"), &json!("proven")));
    check(&given).ends(0).says(&[
        "cost_travel_multiplier 2 (1 in newer versions)",
        "as nav2-smac-2d counts",
        "by cost",
        "rule always",
    ]);
    check(&["--robot-radius", "0"]).ends(0).says(&["inflation_radius 0.55 m", "cost_scaling_factor 10"]);
    check(&[]).says(&["robot_radius 0.1 m"]);
}

#[test]
fn what_is_too_narrow_is_told_with_its_place_and_costs_nothing() {
    let folder = Folder::with_map("weighted-narrow");
    folder.write("room.map", &room());
    // The cell (5, 1) is √2 from the wall's end.
    folder.write("near.csv", "0,1\n1,1\n2,1\n3,1\n4,1\n5,1\n6,1\n7,1\n8,1\n");
    let check = |path: &str, more: &[&str]| {
        folder.run(&[&["check", path, "--map", "room.map", "--cost", "nav2-smac-2d", "--robot-radius", "1"], more].concat())
    };
    check("near.csv", &[]).ends(1).says(&[
        "too narrow    1, first at cell 6 (6, 1)",
        "cost          none: the path leads",
        "proven",
    ]);
    let found = check("near.csv", &["--format", "json"]).ends(1).json();
    assert_eq!((&found["price"]["value"], &found["metrics"]["cost"]), (&Value::Null, &Value::Null));
    assert_eq!(found["narrow"][0]["index"], 6);
    folder.write("within.csv", "6,1\n7,1\n8,1\n");
    check("within.csv", &[]).ends(1).says(&["optimum       unknown: the robot does not fit at the start (6, 1)"]);
    folder.write("beside.csv", "0,1\n99,1\n");
    check("beside.csv", &[]).ends(1).says(&["outside       1"]);
}

#[test]
fn navfn_is_charged_by_what_a_path_crosses() {
    let folder = Folder::with_map("weighted-navfn");
    folder.write("room.map", &room());
    folder.write("way.json", &json!(WAY).to_string());
    let given = ["--cell-size", "0.25", "--robot-radius", "0.3", "--inflation-radius", "1", "--cost-scaling", "2"];
    let check = |more: &[&str]| {
        folder.run(&[&["check", "way.json", "--map", "room.map", "--cost", "nav2-navfn"], &given[..], more].concat()).ends(0)
    };
    let (found, costs) = (check(&["--format", "json"]).json(), costs(0.25, 0.3, 1.0, 2.0));
    let factor = |(x, y): (usize, usize)| (50.0 + 0.8 * f64::from(costs[y][x])).floor() / 50.0;
    let length = |a: (usize, usize), b: (usize, usize)| if a.0 != b.0 && a.1 != b.1 { 2f64.sqrt() } else { 1.0 };
    let by_hand: f64 = WAY.windows(2).map(|s| length(s[0], s[1]) * (factor(s[0]) + factor(s[1])) / 2.0).sum();
    assert!((price(&found, "/price/value") - by_hand).abs() < 1e-5, "{by_hand}");
    assert_eq!((&found["price"]["charge"], &found["price"]["by"]), (&json!("crossed"), &json!("nav2-navfn")));
    let said = check(&[]).says(&["as nav2-navfn counts", "eikonal"]);
    assert_eq!(said.err, "", "NavFn has no multiplier: everything was given");
    // The corners of a polyline are compared with a good one: nothing is proven.
    folder.write("way.json", "[[0, 4], [4, 0], [9, 0], [13, 4]]");
    assert_eq!(check(&["--polyline", "--format", "json"]).json()["price"]["reference"]["kind"], "unproven");
}

#[test]
fn a_costmap_is_judged_as_it_was_published() {
    let folder = Folder::with_map("weighted-costmap");
    let origin = r#"{"position": {"x": 0, "y": 0}}"#;
    let costmap =
        format!(r#"{{"info": {{"resolution": 0.5, "width": 4, "height": 1, "origin": {origin}}}, "data": [0, 98, 98, 0]}}"#);
    folder.write("costmap.json", &costmap);
    folder.write("way.csv", "0,0\n1,0\n2,0\n3,0\n");
    let check = |more: &[&str]| folder.run(&[&["check", "way.csv", "--map", "costmap.json"], more].concat());
    // 98 is 252: 1 + 2 for each of the two cells, and 1 for the last.
    let found = check(&["--costs", "nav2-smac-2d", "--format", "json"]).ends(0).json();
    assert_eq!((price(&found, "/price/value"), price(&found, "/price/gap")), (7.0, 0.0));
    let found = check(&["--costs", "nav2-smac-2d", "--costs-multiplier", "1", "--format", "json"]).ends(0).json();
    assert_eq!(price(&found, "/price/value"), 5.0);
    check(&[]).ends(1).says(&["2 cells have a value from 1 to 99", "--costs nav2-smac-2d"]);
    check(&["--costs", "nav2-smac-2d", "--cost", "nav2-smac-2d"]).ends(2).says(&["cannot be used with"]);
    check(&["--costs-multiplier", "1"]).ends(2);
}

#[test]
fn plan_tells_the_cost_beside_the_length() {
    let folder = Folder::with_map("weighted-plan");
    folder.write("swamp.map", "type octile\nheight 1\nwidth 4\nmap\n.SS.\n");
    let plan = |more: &[&str]| folder.run(&[&["plan", "swamp.map", "--from", "0,0", "--to", "3,0", "--planner"], more].concat());
    plan(&["astar", "--swamp-factor", "3"]).ends(0).says(&[
        "length        3.0000 cells",
        "cost          7.0000 cells",
        "above the optimum of 7.0000 cells (cost by steps)",
        "2 cells of swamp (S) have the factor 3",
    ]);
    plan(&["astar"]).ends(0).says(&["(length by steps)", "--swamp-factor"]);
    plan(&["astar", "--swamp-factor", "0.5"]).ends(2).says(&["swamp_factor", "1 to 1000"]);
    plan(&["any-angle", "--swamp-factor", "3"]).ends(2).says(&["on weighted ground"]);
    plan(&["astar", "--robot-radius=-1"]).ends(2).says(&["robot.radius"]);
    plan(&["astar", "--cost", "nav2-navfn", "--cost-scaling", "0"]).ends(2).says(&["robot.inflation.cost_scaling"]);
    let found = plan(&["astar", "--speed", "0.5", "--seconds-per-turn", "2", "--format", "json"]).ends(0).json();
    assert_eq!(found["metrics"]["travel_time"], 6.0);
}

#[test]
fn what_a_format_does_not_hold_is_told() {
    let folder = Folder::with_map("weighted-convert");
    folder.write("swamp.map", "type octile\nheight 2\nwidth 3\nmap\n.S.\n...\n");
    let convert = |to: &str| {
        let options = ["--swamp-factor", "3", "--robot-radius", "0.1", "--from", "0,0", "--to", "2,0"];
        folder.run(&[&["convert", "swamp.map", to], &options[..]].concat()).ends(0)
    };
    for name in ["a.map", "a.scen", "a.csv", "a.asc", "a.tif", "a.yaml"] {
        convert(name).says(&["no factors of cells", "no robot"]);
    }
    // The list's optimum is that of the benchmark: of plain ground.
    assert!(folder.read("a.scen").trim_end().ends_with("2.00000000") || folder.read("a.scen").trim_end().ends_with('2'));
    let kept = convert("kept.json");
    assert!(!kept.err.contains("factors"), "{}", kept.err);
    folder.run(&["plan", "kept.json", "--planner", "astar"]).ends(0).says(&["cost "]);
    folder.write("a.map.scen", "version 1\n0\ta.map\t3\t2\t0\t0\t2\t0\t2.0\n");
    folder
        .run(&["bench-scen", "a.map.scen", "--map", "kept.json"])
        .ends(2)
        .says(&["plain ground", "leave `factors` and `robot` out"]);
    folder.run(&["bench-scen", "a.map.scen", "--map", "a.map"]).ends(0);
    folder.run(&["generate", "random", "--size", "6x6", "--robot-radius", "0.2", "--out", "g.json"]).ends(0);
    assert!(folder.read("g.json").contains("\"robot\": {\"radius\":0.2}"));
}

/// Three ways from left to right: the straight one is the dearest.
const SWAMPS: &str = "type octile\nheight 3\nwidth 6\nmap\n......\n.SSSS.\n.SSSS.\n";

#[test]
fn comparisons_are_by_cost_and_say_so() {
    let folder = Folder::with_map("weighted-compare");
    folder.write("swamp.map", SWAMPS);
    let ends = ["--from", "0,1", "--to", "5,1", "--moves", "4"];
    folder.run(&[&["convert", "swamp.map", "swamp.json", "--swamp-factor", "4"], &ends[..]].concat()).ends(0);
    let question = |entry: &str| {
        format!(
            "format = \"formicarium/question@1\"\ntitle = \"Swamp\"\nasks = \"?\"\nseeds = {{ from = 1, count = 5 }}\n\
             instances = [{{ id = \"swamp\", map = \"swamp.json\" }}]\n\n\
             [[entries]]\nid = \"exact\"\nlabel = \"A*\"\nrole = \"baseline\"\nplanner = \"astar\"\n\n{entry}"
        )
    };
    let colony = "[[entries]]\nid = \"ants\"\nlabel = \"ants\"\nrole = \"improved\"\nplanner = \"ant-system\"\n";
    folder.write("q.toml", &question(colony));
    folder.compare(&["q.toml", "--out", "out"]);
    let report = folder.read("out/q.md");
    for said in ["6 × 3, 4 moves, on weighted ground", "exact optimum, cost by steps", "published: cost", "7.000"] {
        assert!(report.contains(said), "`{said}` is not in\n{report}");
    }
    assert!(!report.contains("length by steps"), "{report}");
    // Around it costs 7 steps of 1; straight on is 5 cells long and costs 17.
    folder.write("length.csv", "entry,instance,seed,length\nother,swamp,1,5\n");
    folder.write("value.csv", "entry,instance,seed,length,value\nother,swamp,1,5,17\n");
    let with = |file: &str| folder.compare(&["q.toml", "--out", "out", "--results", file]);
    let (code, said) = with("length.csv");
    assert!(code == 2 && said.contains("a column `value` with the cost"), "{said}");
    with("value.csv");
    let report = folder.read("out/q.md");
    assert!(report.contains("17.000"), "{report}");
}
