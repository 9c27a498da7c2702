//! `order`: places in an order, with a proof where they are few.
use super::folder::Folder;

const FIVE: &str = "NAME : five\nTYPE : TSP (made up)\nDIMENSION: 5\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n\
                    1 0 0\n2 3 0\n3 6 0\n4 6 4\n5 0 4\nEOF\n";

#[test]
fn order_proves_runs_and_compares_with_a_tour() {
    let folder = Folder::with_map("order");
    folder.write("five.tsp", FIVE);
    folder.write("five.tour", "TYPE: TOUR\nTOUR_SECTION\n1 3 2 4 5\n-1\nEOF\n");
    let said = ["five (5 places, EUC_2D, closed tours)", "20, proven by Held and Karp", "0.00 % above the proven optimum"];
    folder.run(&["order", "five.tsp"]).ends(0).says(&said);
    // 6 + 3 + 5 + 6 + 4.
    let more = ["24, length of the tour in five.tour", "3 runs: best 20, median 20, worst 20", "-16.67 % from the tour"];
    folder.run(&["order", "five.tsp", "--tour", "five.tour", "--runs", "3"]).ends(0).says(&more);
    folder.run(&["order", "five.tsp", "--open"]).ends(0).says(&["open tours", "16, proven"]);

    let json = || folder.run(&["order", "five.tsp", "--seed", "7", "--iterations", "9", "--format", "json"]).ends(0).json();
    let first = json();
    assert_eq!(first, json());
    assert_eq!((&first["format"], &first["exact"]["cost"]), (&"formicarium/order@1".into(), &20.0.into()));
    assert_eq!(first["runs"][0]["places"].as_array().map(Vec::len), Some(5));
    assert_eq!(first["runs"][0]["digest"].as_str().map(str::len), Some(16));
}

#[test]
fn order_bounds_many_places() {
    let folder = Folder::with_map("order-bound");
    // 4 × 5 places a unit apart, to be visited once around: 20.
    let places: String = (0..20).map(|k| format!("{} {} {}\n", k + 1, k % 4, k / 4)).collect();
    let head = "NAME: grid\nTYPE: TSP\nDIMENSION: 20\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n";
    folder.write("grid.tsp", &format!("{head}{places}EOF\n"));
    let run = |more: &[&str]| folder.run(&[&["order", "grid.tsp", "--iterations", "5"], more].concat()).ends(0);
    run(&[]).says(&["unknown: Held and Karp prove", "no tour costs less than 20, and one costs that"]);
    let scattered: String = (0..24).map(|k| format!("{} {} {}\n", k + 1, k * k % 23, 7 * k % 19)).collect();
    folder.write("scattered.tsp", &format!("{}{scattered}EOF\n", head.replace("20", "24")));
    let stopped = folder.run(&["order", "scattered.tsp", "--iterations", "5", "--open", "--trees", "1"]);
    stopped.ends(0).says(&["no tour costs less than", "one costs", "stopped after"]);
    let bound = &run(&["--format", "json"]).json()["bound"];
    assert_eq!((&bound["lower_bound"], &bound["cost"], &bound["complete"]), (&20.0.into(), &20.0.into(), &true.into()));
    assert_eq!(bound["places"].as_array().map(Vec::len), Some(20));
    assert_eq!(run(&["--trees", "0", "--format", "json"]).json().get("bound"), None);
}

#[test]
fn order_refuses_by_name() {
    let folder = Folder::with_map("order-refusals");
    folder.write("five.tsp", FIVE);
    folder.write("five.tour", "TYPE: TOUR\nTOUR_SECTION\n1 3 2 4\n-1\nEOF\n");
    folder.write("goods.vrp", &FIVE.replace("TSP (made up)", "CVRP"));
    let run = |args: &[&str], said: &[&str]| drop(folder.run(args).ends(2).says(said));
    run(&["plan", "five.tsp", "--planner", "astar"], &["an instance of TSPLIB", "formicarium order five.tsp"]);
    run(&["convert", "five.tsp", "five.map"], &["formicarium order five.tsp"]);
    run(&["order", "goods.vrp"], &["vehicle routing problem", "TYPE TSP or ATSP"]);
    run(&["order", "small.map"], &["this is a map of the MovingAI benchmarks", "an instance of TSPLIB (.tsp)"]);
    run(&["order", "five.tour"], &["TYPE: is TOUR", "--tour"]);
    run(&["order", "five.tsp", "--tour", "five.tour"], &["the tour leaves out place 5"]);
    run(&["order", "five.tsp", "--ants", "0"], &["ants = 0 is outside 1 to 1024"]);
    run(&["order", "five.tsp", "--rho", "1.5"], &["rho = 1.5 is outside"]);
    run(&["order", "five.tsp", "--rule", "best"], &["random-proportional"]);
    run(&["order", "five.tsp", "--seed", "4294967295", "--runs", "2"], &["the last seed"]);
}
