//! Several goals.

use formicarium::catalog::{self, CATALOG};
use formicarium::error::ParamError;
use formicarium::map::Movement;
use formicarium::planner::Status;

use super::common::{drawn, movements, with_goals};
use super::{everywhere, planner, short, takes};

#[test]
fn one_unreachable_goal_of_several_is_an_answer() {
    for entry in CATALOG.iter().filter(|e| e.max_goals > 1) {
        for movement in movements() {
            let walled = with_goals(&drawn(&["S.#..", "..#..", "###..", "....G"], movement), &[(1, 1), (4, 3)]);
            let mut planner = planner(entry, &walled, 1);
            assert_eq!(planner.run(), Status::NoPath, "{}", entry.id);
            assert!(planner.best().is_none());
        }
    }
}

#[test]
fn more_goals_than_a_planner_takes_are_refused_by_name() {
    let open = drawn(&["S.......", "........", "........", ".......G"], Movement::default());
    for entry in CATALOG {
        let most = entry.max_goals as usize;
        if most >= formicarium::scenario::MAX_GOALS || !takes(entry, &open) {
            continue;
        }
        let cells: Vec<_> = (1..=most as u32 + 1).map(|c| (c % 8, c / 8)).collect();
        let error = catalog::build(&with_goals(&open, &cells), entry.id, None, &short(entry), 1).err();
        assert!(
            matches!(&error, Some(ParamError::TooManyGoals { planner, most, got, .. })
                if planner == entry.id && *most == entry.max_goals && *got == cells.len()),
            "{}: {error:?}",
            entry.id
        );
        assert!(catalog::build(&with_goals(&open, &cells[1..]), entry.id, None, &short(entry), 1).is_ok(), "{}", entry.id);
    }
}

#[test]
fn tours_visit_every_goal_once_and_tell_what_each_leg_costs() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 3);
        planner.run();
        let (Some(tour), true) = (planner.tour(), scenario.goals.len() > 1) else {
            assert!(scenario.goals.len() == 1 && planner.tour().is_none(), "{what}");
            return;
        };
        let best = planner.best().unwrap_or_else(|| panic!("{what}: no path"));
        let mut order = tour.order.clone();
        order.sort_unstable();
        assert_eq!(order, (0..scenario.goals.len() as u32).collect::<Vec<_>>(), "{what}");
        let weigh = |legs: &[f64]| -> f64 {
            tour.order.iter().zip(legs).map(|(&g, l)| l * scenario.spec.goals[g as usize].weight()).sum()
        };
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{what}: {a}, {b}");
        close(tour.planned_length, tour.planned.iter().sum());
        close(tour.planned_weight, weigh(&tour.planned));
        close(best.length, tour.walked.iter().sum());
        close(tour.walked_weight.expect("walked"), weigh(&tour.walked));
        // The path comes by the goals in this order.
        let mut rest = best.path.as_slice();
        for &goal in &tour.order {
            let at = rest.iter().position(|&c| c == scenario.goals[goal as usize]);
            rest = &rest[at.unwrap_or_else(|| panic!("{what}: goal {goal}"))..];
        }
    });
}
