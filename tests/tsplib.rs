//! Orders on problems of TSPLIB 95: listed optima, Held and Karp on the small ones, and how near the order colony comes.
//!
//! The files are read from `$FORMICARIUM_DATA/tsplib`; without it these tests say that they skip. burma14 is small enough to stand here.

#![cfg(not(target_arch = "wasm32"))]

use std::path::PathBuf;

use formicarium::aco::order_solve::{OrderSolver, Solving};
use formicarium::aco::tour::{OrderColony, TourSettings};
use formicarium::exact::order::{Costs, OrderSearch, Shape, good_order, held_karp};
use formicarium::exact::order_problem::OrderProblem;
use formicarium::formats::tsplib::{read_instance, read_tour};
use formicarium::rng::Streams;

/// Problems with a tour file, and the length of the best closed tour.
const LISTED: [(&str, f64); 5] =
    [("ulysses16", 6859.0), ("att48", 10628.0), ("eil51", 426.0), ("berlin52", 7542.0), ("kroA100", 21282.0)];

/// 14 cities in Burma (Zaw Win), GEO.
const BURMA14: &str = "\
NAME: burma14
TYPE: TSP
COMMENT: 14-Staedte in Burma (Zaw Win)
DIMENSION: 14
EDGE_WEIGHT_TYPE: GEO
EDGE_WEIGHT_FORMAT: FUNCTION
DISPLAY_DATA_TYPE: COORD_DISPLAY
NODE_COORD_SECTION
   1  16.47       96.10
   2  16.47       94.44
   3  20.09       92.54
   4  22.39       93.37
   5  25.23       97.24
   6  22.00       96.05
   7  20.47       97.02
   8  17.20       96.29
   9  16.30       97.38
  10  14.05       98.12
  11  16.53       97.38
  12  21.52       95.59
  13  19.41       97.13
  14  20.09       94.55
EOF
";

fn burma14() -> OrderProblem {
    read_instance(BURMA14.as_bytes()).expect("an instance")
}

/// A file of the data folder; none without the folder.
fn file(name: &str) -> Option<String> {
    let Ok(data) = std::env::var("FORMICARIUM_DATA") else {
        println!("skipped: FORMICARIUM_DATA is not set");
        return None;
    };
    let path = PathBuf::from(data).join("tsplib").join(name);
    Some(std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display())))
}

/// A problem and its listed optimal order.
fn listed(name: &str) -> Option<(OrderProblem, Vec<u32>)> {
    let problem = read_instance(file(&format!("{name}.tsp"))?.as_bytes()).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(problem.name, name);
    let tour = read_tour(file(&format!("{name}.opt.tour"))?.as_bytes(), &problem);
    Some((problem, tour.unwrap_or_else(|error| panic!("{name}: {error}"))))
}

/// Best of a short run of the order colony: the settings of Ant System for tours (Dorigo and Stützle 2004, box 3.1), m = 25.
fn colony(costs: &Costs, shape: Shape, exploit: Option<f64>) -> f64 {
    let settings =
        TourSettings { ants: 25, iterations: 200, alpha: 1.0, beta: 5.0, rho: 0.5, deposit: 1.0, initial_trail: 1.0, exploit };
    let mut colony = OrderColony::new(costs.clone(), shape, settings, Streams::new(1, "tsplib", 0));
    while !colony.is_finished() {
        colony.advance();
    }
    let best = colony.best().expect("ants build tours");
    assert_eq!(costs.total(&best.order, shape), best.cost);
    best.cost
}

#[test]
fn listed_tours_have_the_listed_lengths() {
    for (name, optimum) in LISTED {
        let Some((problem, order)) = listed(name) else { return };
        assert_eq!(order.len() + 1, problem.len(), "{name}");
        assert_eq!(problem.cost(&order), optimum, "{name}");
        assert_eq!(problem.listed_optimum(), Some(optimum), "{name}: {}", problem.digest().hex());
        // Of another shape, or of other costs, nothing is listed.
        assert_eq!(OrderProblem { shape: Shape::Open, ..problem.clone() }.listed_optimum(), None);
        let other = Costs::new(problem.len(), |i, j| problem.costs.get(i, j) + 1.0);
        assert_eq!(OrderProblem { costs: other, ..problem }.listed_optimum(), None);
    }
}

#[test]
fn held_karp_proves_burma14() {
    let problem = burma14();
    assert_eq!(problem.listed_optimum(), Some(3323.0), "{}", problem.digest().hex());
    assert_eq!(problem.prove().expect("13 goals").cost, 3323.0);
    let costs = problem.costs;
    let order = held_karp(&costs, Shape::Closed).expect("13 goals");
    assert_eq!(costs.total(&order, Shape::Closed), 3323.0);
    let open = held_karp(&costs, Shape::Open).expect("13 goals");
    // Without the way back, the closed tour is an upper bound; its longest edge at the end would be the best to drop.
    assert!(costs.total(&open, Shape::Open) <= costs.total(&order, Shape::Open));
    println!("burma14, open from city 1: {}", costs.total(&open, Shape::Open));
}

#[test]
fn held_karp_proves_ulysses16() {
    let Some((OrderProblem { costs, .. }, order)) = listed("ulysses16") else { return };
    let closed = held_karp(&costs, Shape::Closed).expect("15 goals");
    assert_eq!(costs.total(&closed, Shape::Closed), 6859.0);
    let open = held_karp(&costs, Shape::Open).expect("15 goals");
    assert!(costs.total(&open, Shape::Open) <= costs.total(&order, Shape::Open));
    println!("ulysses16, open from city 1: {}", costs.total(&open, Shape::Open));
}

#[test]
fn the_order_colony_comes_near_the_best_closed_tours() {
    for (name, optimum) in LISTED {
        let Some((OrderProblem { costs, .. }, _)) = listed(name) else { return };
        for (rule, exploit) in [("random proportional", None), ("pseudo-random proportional", Some(0.7))] {
            let found = colony(&costs, Shape::Closed, exploit);
            println!("{name}, closed, {rule}: {found}, {:.2} % above {optimum}", 100.0 * (found / optimum - 1.0));
            assert!((optimum..1.2 * optimum).contains(&found), "{name}, {rule}: {found}");
        }
    }
}

#[test]
fn the_order_colony_comes_near_the_best_open_tours() {
    for (name, _) in LISTED {
        let Some((OrderProblem { costs, .. }, order)) = listed(name) else { return };
        // Beyond 16 goals nothing is proven for open tours: the best closed one without its way back is something to compare with.
        let best = held_karp(&costs, Shape::Open);
        let (what, yardstick) = match &best {
            Some(best) => ("the optimum", costs.total(best, Shape::Open)),
            None => ("the best closed tour without its last edge", costs.total(&order, Shape::Open)),
        };
        let found = colony(&costs, Shape::Open, None);
        println!("{name}, open: {found}, {:+.2} % from {what}, {yardstick}", 100.0 * (found / yardstick - 1.0));
        assert!(best.is_none() || found >= yardstick, "{name}: {found}");
        assert!(found < 1.2 * yardstick, "{name}: {found}");
    }
}

#[test]
fn a_bound_is_never_above_the_optimum_and_near_it() {
    for (name, optimum) in LISTED {
        let Some((OrderProblem { costs, .. }, order)) = listed(name) else { return };
        let mut search = OrderSearch::new(&costs, Shape::Closed, &good_order(&costs, Shape::Closed)).expect("costs are finite");
        let begun = search.cost();
        search.step(u64::MAX);
        let first = search.lower_bound();
        search.go_on(20_000);
        let (bound, found) = (search.lower_bound(), search.cost());
        println!(
            "{name}, closed: begun with {begun}, first bound {first}, after {} 1-trees {bound} to {found}, {:.2} % to the optimum",
            search.trees(),
            100.0 * (1.0 - bound / optimum)
        );
        assert!(first <= bound && bound <= optimum && optimum <= found && found <= begun, "{name}: {bound}, {found}");
        assert!(bound >= 0.99 * optimum, "{name}: {bound}");
        assert!(!search.is_proven() || found == optimum, "{name}: {found}");
        // From the listed tour on nothing better can be found.
        let mut above = OrderSearch::new(&costs, Shape::Closed, &order).expect("costs are finite");
        above.step(100);
        assert!(above.cost() == optimum && above.lower_bound() <= optimum, "{name}");
    }
}

#[test]
fn a_bound_of_open_tours_is_below_them() {
    for (name, _) in LISTED {
        let Some((OrderProblem { costs, .. }, order)) = listed(name) else { return };
        let mut search = OrderSearch::new(&costs, Shape::Open, &good_order(&costs, Shape::Open)).expect("costs are finite");
        search.go_on(4000);
        let (bound, found) = (search.lower_bound(), search.cost());
        println!("{name}, open: {bound} to {found}, proven: {}", search.is_proven());
        let reversed: Vec<u32> = order.iter().rev().copied().collect();
        let known = costs.total(&order, Shape::Open).min(costs.total(&reversed, Shape::Open));
        assert!(bound <= found && bound <= known && bound > 0.95 * found, "{name}: {bound}, {found}");
        if let Some(best) = held_karp(&costs, Shape::Open) {
            assert!(bound <= costs.total(&best, Shape::Open), "{name}");
        }
    }
}

#[test]
fn merged_orders_are_never_dearer_than_the_colonys() {
    let settings = TourSettings {
        ants: 10,
        iterations: 20,
        alpha: 1.0,
        beta: 5.0,
        rho: 0.5,
        deposit: 1.0,
        initial_trail: 1.0,
        exploit: None,
    };
    let solving = Solving { merge: true, prove: true, limit: 2000 };
    for (name, _) in LISTED {
        let Some((OrderProblem { costs, .. }, _)) = listed(name) else { return };
        for (shape, seed) in [(Shape::Closed, 1), (Shape::Open, 2)] {
            let colony = || OrderColony::new(costs.clone(), shape, settings, Streams::new(seed, "merged", 0));
            let (mut alone, mut solver) = (colony(), OrderSolver::new(costs.clone(), shape, solving, colony()));
            while !alone.is_finished() {
                alone.advance();
            }
            while !solver.is_finished() {
                solver.advance();
            }
            let alone = alone.best().expect("ants build tours").cost;
            let ((order, cost), proof) = (solver.best().expect("ants build tours"), solver.proof().expect("it was asked for"));
            println!("{name}, {shape:?}: colony {alone}, merged {cost}, bound {}, {} 1-trees", proof.lower_bound, solver.trees());
            assert_eq!(costs.total(order, shape), cost);
            assert!(proof.lower_bound <= cost && cost <= alone, "{name}, {shape:?}");
            assert_eq!(proof.complete, proof.lower_bound == cost, "{name}, {shape:?}");
        }
    }
}
