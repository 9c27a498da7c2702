//! `plan`: paths, tours, where scenarios come from, and what ends with an error.
use serde_json::Value;

use super::folder::{Folder, MAP, SCEN};
use super::schema;

#[test]
fn plan_prints_text_json_and_csv() {
    let folder = Folder::with_map("plan");
    let plan = ["plan", "small.map", "--from", "0,0", "--to", "4,3", "--planner"];
    let with = |more: &[&str]| folder.run(&[&plan[..], more].concat());
    with(&["astar"]).ends(0).says(&["A* on small (5 × 4, 14 free cells)", "optimal (proven)", "7.0000 cells", "0.00 %"]);

    let result = with(&["ant-system", "--seed", "5", "--set", "ants=10", "--format", "json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["seed"], &result["optimum"], &result["length"]), (&5.into(), &7.0.into(), &7.0.into()));
    assert_eq!((&result["path"][0], &result["path"][7]), (&serde_json::json!([0, 0]), &serde_json::json!([4, 3])));

    let csv = with(&["ant-system", "--set", "iterations=7", "--set", "stagnation=0", "--format", "csv"]).ends(0).out;
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!(rows[0], "iteration,best_so_far,iteration_best,iteration_mean,iteration_worst,arrived");
    assert_eq!(rows.len(), 8);
}

#[test]
fn plan_shows_what_refinement_saves_and_what_no_polyline_can_beat() {
    let folder = Folder::with_map("refined");
    folder.write("open.csv", &"0,0,0,0,0,0,0,0\n".repeat(4));
    let plan = ["plan", "open.csv", "--from", "0,0", "--to", "7,3", "--planner"];
    let with = |more: &[&str]| folder.run(&[&plan[..], more].concat()).ends(0);
    // √(49 + 9) where nothing is in the way; 3√2 + 4 by steps, and V is 0.2 more when one straight step turns.
    let said = [
        "7.6158 cells (length of a polyline)",
        "unrefined     8.2426 cells by steps",
        "point robot   7.6158 cells",
        "steps         1",
    ];
    with(&["ship", "--set", "iterations=3"]).says(&said);
    with(&["ship", "--preset", "cells", "--set", "iterations=3"]).says(&["8.2426 cells (length by steps)"]);
    with(&["any-angle"]).says(&["optimal (proven)", "0.00 % above the optimum of 7.6158 cells"]);
    with(&["theta-star"]).says(&["complete (not proven)", "0.00 % above the optimum of 7.6158 cells"]);
    with(&["turn-aware"]).says(&["optimal (proven)", "turn index V = 8.4426 cells", "(turn index V)"]);

    let result = with(&["ship", "--set", "iterations=3", "--format", "json"]).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["objective"], &result["path"]), (&"polyline-length".into(), &serde_json::json!([[0, 0], [7, 3]])));
    let theta = with(&["theta-star", "--format", "json"]).json();
    assert_eq!(schema::violations(&schema::load("result"), &theta), Vec::<String>::new());

    folder.run(&["generate", "random", "--size", "65x65", "--out", "large.map"]).ends(0);
    let plan = |map, planner| folder.run(&["plan", map, "--planner", planner]);
    plan("large.map", "any-angle").ends(0).says(&["optimal (proven)"]);
    plan("large.map", "theta-star").ends(0).says(&["above the optimum of", "no polyline through centres is shorter"]);
    folder.run(&["generate", "random", "--size", "1025x1024", "--out", "huge.map"]).ends(0);
    plan("huge.map", "any-angle").ends(2).says(&["up to 1048576 cells", "theta-star"]);
}

#[test]
fn plan_takes_walls_that_change_and_other_commands_refuse_them() {
    let folder = Folder::with_map("changes");
    let changes = r#"[{"at":3,"blocked":[[2,0],[2,1]]},{"at":5,"freed":[[2,0]]}]"#;
    let scenario = |changes: &str| {
        format!(
            r#"{{"format":"formicarium/scenario@1","width":5,"height":3,"start":[0,0],"goals":[{{"at":[4,0]}}],
            "changes":{changes},"map":{{"rows":[".....",".....","....."]}}}}"#
        )
    };
    folder.write("moving.json", &scenario(changes));
    let plan = |planner, more: &[&str]| folder.run(&[&["plan", "moving.json", "--planner", planner], more].concat());
    plan("ant-system", &["--set", "iterations=9"]).ends(0).says(&["2 changes; trails were kept", "4.0000 cells"]);
    plan("astar", &[]).ends(0).says(&["2 changes; it began anew each time"]);
    let result = plan("ant-system", &["--format", "json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!(result["changes"], 2);

    folder.write("path.json", "[[0,0],[1,0],[2,0],[3,0],[4,0]]");
    folder.run(&["check", "path.json", "--map", "moving.json"]).ends(2).says(&["change 2 times", "`plan`"]);
    folder.run(&["convert", "moving.json", "out.map"]).ends(0).says(&["before its walls change"]);
    folder.run(&["convert", "moving.json", "again.json"]).ends(0);
    assert!(folder.read("again.json").contains(r#""changes": [{"at":3,"blocked":[[2,0],[2,1]],"freed":[]}"#));
    folder.write("moving.json", &scenario(r#"[{"at":3,"blocked":[[4,0]]}]"#));
    plan("astar", &[]).ends(2).says(&["changes[0].blocked[0]", "neither the start nor a goal"]);
}

#[test]
fn plan_visits_several_goals_and_tells_their_order() {
    let folder = Folder::with_map("goals");
    folder.write("open.csv", &"0,0,0,0,0,0,0,0\n".repeat(4));
    let plan = ["plan", "open.csv", "--from", "3,0", "--to", "7,0", "--to", "0,0", "--planner"];
    let with = |more: &[&str]| folder.run(&[&plan[..], more].concat());
    // 3 to the left, then 7 to the right; the other way round 4 + 7.
    let said = ["(3, 0) → 2 goals", "order         (0, 0) → (7, 0)", "length 10.0000, weight R 10.0000 cells", "0.00 % above"];
    with(&["tour-exact"]).ends(0).says(&said);
    with(&["fire", "--set", "iterations=5"]).ends(0).says(&said);
    with(&["ant-system"]).ends(2).says(&["`ant-system` plans for 1 goal(s) at most; the scenario has 2"]);

    let result = with(&["fire", "--set", "iterations=5", "--set", "order=distance", "--format", "json"]).ends(0).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["objective"], &result["optimum"]), (&"tour-length".into(), &10.0.into()));
    assert_eq!(
        (&result["tour"]["order"], &result["tour"]["walked"]),
        (&serde_json::json!([1, 0]), &serde_json::json!([3.0, 7.0]))
    );

    // As many goals as the scenario has are moved and keep their names and weights, b = 1/8 and 1.
    let goals = r#"[{"at":[7,0],"name":"hall","area":8,"strength":1,"danger":1},{"at":[0,0],"name":"door"}]"#;
    let rows = r#"{"rows": ["........", "........"]}"#;
    let head = r#""format": "formicarium/scenario@1", "width": 8, "height": 2, "start": [3,1]"#;
    folder.write("named.json", &format!("{{{head}, \"goals\": {goals}, \"map\": {rows}}}"));
    // hall first: 3.4142/8 + 6.4142 = 6.84; door first: 3 + 6.4142/8 = 3.80.
    let named = folder.run(&["plan", "named.json", "--to", "6,0", "--to", "0,1", "--planner", "tour-exact"]);
    named.ends(0).says(&["order         door → hall", "3.0000    1.0000    3.0000", "0.1250"]);

    // More goals than dynamic programming orders.
    let many: Vec<String> = (0..17).map(|k| format!("{},{}", k % 8, k / 8 + 1)).collect();
    let to: Vec<&str> = many.iter().flat_map(|cell| ["--to", cell]).collect();
    let all =
        folder.run(&[&["plan", "open.csv", "--from", "0,0", "--planner", "fire", "--set", "iterations=5"], &to[..]].concat());
    all.ends(0).says(&["above the optimum of 17.0000 cells"]);
    for planner in ["formica", "tour-exact"] {
        let many = folder.run(&[&["plan", "open.csv", "--from", "0,0", "--planner", planner], &to[..]].concat());
        many.ends(0).says(&["optimal (proven)", "no path weighs less than"]);
    }
}

#[test]
fn the_same_seed_prints_the_same_bytes() {
    let folder = Folder::with_map("seed");
    let plan =
        |seed| folder.run(&["plan", "small.map", "--planner", "ant-system", "--seed", seed, "--format", "json"]).ends(0).out;
    assert_eq!(plan("3"), plan("3"));
    assert_ne!(plan("3"), plan("4"));
}

#[test]
fn plan_takes_its_scenario_from_four_places() {
    let folder = Folder::with_map("places");
    let length = |args: &[&str]| {
        folder.run(&[args, &["--planner", "dijkstra", "--format", "json"]].concat()).ends(0).json()["length"].clone()
    };
    assert_eq!(length(&["plan", "small.map", "--scen", "small.map.scen:3"]), 3.0);
    assert_eq!(length(&["plan", "small.map"]), 7.0);
    folder.run(&["convert", "small.map", "small.json"]).ends(0);
    assert_eq!(length(&["plan", "--scenario", "small.json"]), 7.0);
    assert_eq!(length(&["plan", "small.json", "--to", "2,2"]), 6.0);
    assert_eq!(
        length(&["plan", "small.json", "--from", "0,3", "--to", "2,2", "--corner-rule", "one-free"]),
        1.0 + std::f64::consts::SQRT_2
    );
    folder.write("open.csv", "0,0\n0,0\n");
    assert_eq!(length(&["plan", "open.csv", "--moves", "4"]), 2.0);
}

#[test]
fn a_scen_line_for_a_map_of_another_size_is_noticed() {
    let folder = Folder::with_map("size");
    folder.write("other.scen", &SCEN.replace("\t5\t4\t", "\t6\t4\t"));
    let said = &["made for a map of 6 × 4 cells, not of 5 × 4"];
    folder.run(&["plan", "small.map", "--scen", "other.scen:2", "--planner", "astar"]).ends(0).says(said);
}

#[test]
fn no_path_is_an_answer_with_code_1() {
    let folder = Folder::with_map("none");
    folder.write("wall.csv", "0,1,0\n0,1,0\n");
    let plan = ["plan", "wall.csv", "--from", "0,0", "--to", "2,0", "--planner"];
    let result = folder.run(&[&plan[..], &["astar", "--format", "json"]].concat()).ends(1).json();
    assert_eq!(schema::violations(&schema::load("result"), &result), Vec::<String>::new());
    assert_eq!((&result["status"], &result["length"]), (&"no-path".into(), &Value::Null));
    folder.run(&[&plan[..], &["ant-system"]].concat()).ends(1).says(&["note: no path leads from start to goal"]);
}

#[test]
fn unusable_input_ends_with_code_2_and_a_hint() {
    let folder = Folder::with_map("errors");
    folder.write("broken.map", &MAP.replace(".@@@.", ".@@."));
    let cases: [(&[&str], &str, &str); 12] = [
        (&["plan", "none.map", "--planner", "astar"], "cannot read none.map", "check the name"),
        (&["plan", "broken.map", "--planner", "astar"], "broken.map: line 6: the row has 4 cells", "expected 5 terrain letters"),
        (&["plan", "small.map", "--planner", "bee"], "there is no planner `bee`", "ant-system"),
        (
            &["plan", "small.map", "--planner", "ant-system", "--set", "rho=1.5"],
            "rho = 1.5 is outside 0 to 1",
            "choose rho between",
        ),
        (&["plan", "small.map", "--planner", "ant-system", "--set", "rhoo=1"], "no parameter `rhoo`", "rho"),
        (&["plan", "small.map", "--planner", "ant-system", "--preset", "mine"], "no preset `mine`", "its presets are"),
        (&["plan", "small.map", "--planner", "astar", "--from", "1,1"], "start (1, 1) lies on a blocked cell", "move it"),
        (&["plan", "small.map", "--planner", "astar", "--to", "5,0"], "goal (5, 0) lies outside", "columns run from 0 to 4"),
        (&["plan", "small.map", "--planner", "astar", "--scen", "small.map.scen:1"], "no scenario in line 1", "FILE:LINE"),
        (&["bench-scen", "small.map.scen", "--planner", "ant-system"], "proves no optimum", "dijkstra, astar"),
        (&["convert", "small.map", "small.xyz"], "tells no format", "--as"),
        (&["plan", "small.map.scen", "--planner", "astar"], "a list of MovingAI scenarios, not a map", "open the map"),
    ];
    for (args, message, hint) in cases {
        let run = folder.run(args).ends(2);
        assert!(run.err.contains("error: ") && run.err.contains("\nhint: "), "{}", run.err);
        run.says(&[message, hint]);
    }
    for args in [&["plan", "small.map"][..], &["plan", "small.map", "--planner", "astar", "--from", "1"], &["fly"], &[]] {
        folder.run(args).ends(2);
    }
}

#[test]
fn errors_come_as_json_where_json_was_asked_for() {
    let folder = Folder::with_map("json-errors");
    let run = folder.run(&["plan", "small.map", "--planner", "ant-system", "--set", "rho=2", "--format", "json"]).ends(2);
    let error = &run.json()["error"];
    assert_eq!((&error["kind"], &error["field"], &error["args"]["max"]), (&"out-of-range".into(), &"rho".into(), &"1".into()));
    assert!(run.err.contains("error: rho = 2"));
}

#[test]
fn plan_says_where_threads_change_nothing() {
    let folder = Folder::with_map("threads");
    let plan = ["plan", "small.map", "--from", "0,0", "--to", "4,3", "--format", "json", "--planner"];
    let with = |more: &[&str]| folder.run(&[&plan[..], more].concat()).ends(0);
    let alone = with(&["ant-system"]);
    for threads in ["0", "1", "2", "7"] {
        let run = with(&["ant-system", "--threads", threads]);
        assert_eq!((run.out, run.err), (alone.out.clone(), alone.err.clone()), "{threads}");
    }
    with(&["ant-colony-system", "--threads", "2"]).says(&["--threads changes nothing here", "ant-colony-system"]);
}

#[test]
fn plan_tells_what_a_colony_has_proven() {
    let folder = Folder::with_map("proven");
    folder.run(&["generate", "rooms", "--size", "64x64", "--seed", "2", "--out", "rooms.map"]).ends(0);
    let with = |more: &[&str]| folder.run(&[&["plan", "rooms.map", "--planner", "formica"], more].concat()).ends(0);
    with(&[]).says(&["optimal (proven)", "no path is shorter than"]);
    let complete = with(&["--format", "json"]).json();
    assert_eq!(schema::violations(&schema::load("result"), &complete), Vec::<String>::new());
    assert_eq!(complete["certificate"]["complete"], true);
    assert_eq!(complete["certificate"]["lower_bound"], complete["value"]);

    let cut_off = ["--set", "proof_limit=0.001", "--set", "iterations=1", "--set", "widening=0", "--set", "corridor=0"];
    with(&cut_off).says(&["budget spent", "no path is shorter than", "so this one is within"]);
    let json = with(&[&cut_off[..], &["--format", "json"]].concat()).json();
    assert_eq!((&json["certificate"]["complete"], &json["status"]), (&false.into(), &"budget-spent".into()));
    let without = with(&["--set", "proof_limit=0", "--set", "iterations=2", "--format", "json"]).json();
    assert_eq!(without.get("certificate"), None);
}

#[test]
fn plan_tells_the_proof_of_an_exact_search_by_what_it_makes_small() {
    let folder = Folder::with_map("exact proof");
    let plan = ["plan", "small.map", "--from", "0,0", "--to", "4,3", "--planner"];
    let words = ["no path is shorter than", "no path comes to less than"];
    for (planner, more, [said, unsaid]) in [
        ("dijkstra", &[][..], words),
        ("astar", &[], words),
        ("d-star-lite", &[], words),
        ("turn-aware", &[], [words[1], words[0]]),
        ("turn-aware", &["--set", "criterion=weighted-sum"], [words[1], words[0]]),
        ("tour-exact", &["--to", "0,3"], ["no path weighs less than", words[0]]),
        ("tour-exact", &["--to", "0,3", "--set", "objective=length"], words),
    ] {
        let with = |last: &[&str]| folder.run(&[&plan[..], &[planner], more, last].concat()).ends(0);
        let text = with(&[]).says(&["optimal (proven)", said]);
        assert!(!text.out.contains(unsaid), "{planner}: {}", text.out);
        let json = with(&["--format", "json"]).json();
        assert_eq!(schema::violations(&schema::load("result"), &json), Vec::<String>::new());
        let (certificate, effort) = (&json["certificate"], &json["effort"]["cell_expansions"]);
        assert_eq!((&certificate["lower_bound"], &certificate["complete"]), (&json["value"], &true.into()), "{planner}");
        assert_eq!(&certificate["expansions"], effort, "{planner}");
    }
}
