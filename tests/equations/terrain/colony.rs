//! Section 4.2 and the colony as a whole.

use super::*;

#[test]
fn section_4_2_lists_join_where_they_overlap() {
    let mut route = Vec::new();
    // The ant from the start has come to 5, where the other has been before it went on to 3 and 4.
    join(&[0, 1, 5], &[9, 8, 5, 3, 4], 5, &mut route);
    assert_eq!(route, [0, 1, 5, 8, 9]);
    join(&[0, 1, 5, 7], &[9, 8, 1], 1, &mut route);
    assert_eq!(route, [0, 1, 8, 9]);
    join(&[0], &[9, 8, 0], 0, &mut route);
    assert_eq!(route, [0, 8, 9]);
    alone(&[9, 8, 0], Way::Backward, &mut route);
    assert_eq!(route, [0, 8, 9]);
}

#[test]
fn section_4_2_two_ants_in_a_corridor_meet_in_its_middle_and_stop() {
    for (cells, moves) in [(7, 6), (6, 5), (2, 1)] {
        let mut planner = planner("terrain-epf", &corridor(cells), &[("ants", "2"), ("iterations", "1")], 1);
        planner.run();
        assert_eq!(planner.effort().ant_moves, moves, "{cells} cells");
        let (best, record) = (planner.best().expect("a path"), planner.history()[0]);
        assert_eq!(best.path, (0..cells).collect::<Vec<_>>());
        assert_eq!((best.length, record.arrived, record.iteration_mean), (f64::from(cells - 1), 2, Some(f64::from(cells - 1))));
    }
    // Both leave 1/6 on the whole path, each on its own trails; the layer shows the stronger. Each has taken 0.1 from three places.
    let set = [("ants", "2"), ("iterations", "2"), ("initial", "uniform"), ("elite", "0"), ("force", "false")];
    let trails = trails_after_one("terrain-epf", &corridor(7), &set);
    for (place, &trail) in trails.iter().enumerate() {
        let evaporated = if place == 3 { 0.72 } else { 0.8 };
        assert!(close(trail, evaporated + 1.0 / 6.0), "{place}: {trail}");
    }
}

#[test]
fn section_4_2_the_two_colonies_are_of_equal_size() {
    let back =
        |ants| EpfParams { common: BasicParams { ants, ..BasicParams::default() }, ..EpfParams::default() }.backward_ants();
    assert_eq!([1, 2, 50, 51].map(back), [0, 1, 25, 25]);
    assert_eq!(EpfParams::basic(BasicParams::default()).backward_ants(), 0);
}

#[test]
fn joined_paths_are_paths_without_loops_and_cost_what_they_cost_forwards() {
    for scenario in [by_slices(), on_surface(Moves::Four), on_surface(Moves::Eight), on_surface(Moves::Sixteen)] {
        for seed in 0..40 {
            let mut planner =
                planner("terrain-epf", &scenario, &[("ants", "12"), ("iterations", "6"), ("q0", "0.3"), ("beta", "1")], seed);
            planner.run();
            let best = planner.best().expect("a path");
            let mut once = best.path.clone();
            once.sort_unstable();
            once.dedup();
            assert_eq!(once.len(), best.path.len(), "a place twice");
            match &scenario.slices {
                Some(slices) => {
                    audit_slices(&scenario, &slices.points(&best.path)).expect("a path");
                    assert_eq!(best.length, slices.value(&best.path));
                }
                None => {
                    audit(&scenario, &points(&scenario, &best.path), PathKind::Steps).expect("a path");
                    assert_eq!(best.length, scenario.path_length(&best.path));
                }
            }
        }
    }
}

#[test]
fn with_all_additions_off_it_is_the_basic_aco_bit_for_bit() {
    let off = [("initial", "uniform"), ("force", "false"), ("elite", "0"), ("two_colonies", "false")];
    let common = [("ants", "14"), ("iterations", "15"), ("heuristic", "both"), ("alpha", "1.3"), ("beta", "2.5")];
    for scenario in [by_slices(), on_surface(Moves::Sixteen), on_surface(Moves::Eight), corridor(9)] {
        let run = |id, set: &[(&str, &str)]| {
            let mut planner = planner(id, &scenario, set, 7);
            planner.run();
            (planner.digest().hex(), planner.effort())
        };
        let basic = run("terrain-aco", &common);
        assert_eq!(run("terrain-epf", &[&common[..], &off].concat()), basic);
        if scenario.grid.height() > 1 {
            // Each addition alone makes another run.
            for k in 0..4 {
                let but_one: Vec<_> = off.iter().enumerate().filter(|&(i, _)| i != k).map(|(_, &row)| row).collect();
                assert_ne!(run("terrain-epf", &[&common[..], &but_one].concat()), basic, "{}", off[k].0);
            }
        }
    }
}

#[test]
fn ants_that_can_no_longer_reach_the_end_are_counted_as_lost_or_step_back() {
    // Three steps of at most two rows to a goal six rows below: one way, and every other place is a dead end.
    let flat = Grid::open(4, 9).expect("a usable size").with_heights(vec![0.0; 36]).expect("one a cell");
    let rules = SliceRules { max_climb: 0, start_level: 1, goal_level: 1, ..RULES };
    let s = on(flat, Some(TerrainMoves::Slices(rules)), Moves::Eight, (0, 1), (3, 7));
    let arrived = |dead_end| {
        let set =
            [("ants", "40"), ("iterations", "1"), ("heuristic", "step"), ("beta", "0"), ("q0", "0"), ("dead_end", dead_end)];
        let mut planner = planner("terrain-aco", &s, &set, 2);
        planner.run();
        assert_eq!(planner.effort().constructed_paths, 40);
        assert_eq!(planner.best().map(|b| b.path.len()), Some(4), "{dead_end}");
        (planner.history()[0].arrived, planner.effort().ant_moves)
    };
    let (alive, moves) = arrived("die");
    assert!((1..20).contains(&alive), "{alive}");
    // Two or three steps, or two and the move in which the ant finds itself lost.
    assert!((80..=120).contains(&moves), "{moves}");
    assert_eq!(arrived("backtrack").0, 40);
}

#[test]
fn table_1_is_the_default_and_the_preset() {
    let p = BasicParams::default();
    assert_eq!((p.ants, p.selection.iterations, p.selection.alpha, p.selection.beta), (50, 100, 1.0, 7.0));
    assert_eq!((p.q0, p.local_rho, p.rho, EpfParams::default().repulsion_range), (0.8, 0.1, 0.2, 2.0));
    assert_eq!((EpfParams::default().elite, EpfParams::default().initial), (0.05, Initial::Field));
    for scenario in [by_slices(), on_surface(Moves::Sixteen)] {
        for id in ["terrain-aco", "terrain-epf"] {
            let run = |preset| {
                let mut planner =
                    catalog::build(&scenario, id, preset, &values(&[("iterations", "10")]), 1).expect("valid parameters");
                planner.run();
                planner.digest().hex()
            };
            assert_eq!(run(Some("paper")), run(None), "{id}");
            assert_ne!(run(Some("printed")), run(None), "{id}");
            assert_ne!(run(Some("second-reading")), run(None), "{id}");
        }
    }
}

#[test]
fn layers_show_the_strongest_place_of_each_cell() {
    let s = by_slices();
    let (space, slices) = (layered(&s), s.slices.as_ref().expect("by slices"));
    let mut shown = Vec::new();
    assert!(planner("terrain-epf", &s, &[("initial_trail", "3")], 1).layer(Layer::InitialTrail, &mut shown));
    let fields = [Way::Forward, Way::Backward].map(|way| Field::new(&space, way, EpfParams::default().gains()));
    for cell in 0..slices.area() {
        let places = (0..=6).map(|level| cell + level * slices.area());
        let strongest =
            places.flat_map(|p| fields.iter().map(move |f| (f, p))).map(|(f, p)| 3.0 * f.trail(&space, p)).fold(0.0, f64::max);
        assert!(close(f64::from(shown[cell as usize]), strongest), "{cell}");
    }
}
