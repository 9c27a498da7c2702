//! Small maps: what is proven is the least, and nothing is better.

use formicarium::exact::{Reference, reference};
use formicarium::map::{Generator, Movement, Moves, generate};
use formicarium::metrics::WeightedSum;
use formicarium::planner::{Objective, Status};

use super::common::{drawn, rooms, swamp};
use super::terrains::{hilly, sixteen};
use super::{Arc, By, Scenario, least, movements, same, small, solved, value, weighed_down};

/// A run by its defaults has the least value there is and has proven it; one without a proof has none that is less.
fn holds(s: &Arc<Scenario>, by: By, least: f64) {
    let told = || format!("{by:?} on {:?} {:?}", s.spec, s.grid);
    let bare = value(s, &*solved(s, "formica", by, &[("proof_limit", 0.0), ("iterations", 2.0)]));
    assert!(bare > least - 1e-7, "{}: {bare}, {least}", told());
    let full = solved(s, "formica", by, &[("proof_limit", 20.0)]);
    let found = value(s, &*full);
    assert!(same(found, least), "{}: {found}, {least}", told());
    if least.is_infinite() {
        assert_eq!((full.status(), full.certificate()), (Status::NoPath, None), "{}", told());
    } else if least > 0.0 {
        let certificate = full.certificate().unwrap_or_else(|| panic!("{}: no certificate", told()));
        assert!(full.status() == Status::Optimal && certificate.complete, "{}: {certificate:?}", told());
        assert_eq!(certificate.lower_bound, found, "{}", told());
    }
}

#[test]
fn the_turn_index_is_that_of_the_turn_aware_search() {
    for s in small(60) {
        holds(&s, By::TurnIndex, value(&s, &*solved(&s, "turn-aware", By::TurnIndex, &[])));
    }
}

#[test]
fn the_weighted_sum_is_that_of_the_turn_aware_search() {
    let sums = &By::all()[1..];
    for (k, s) in small(60).enumerate() {
        // Each movement meets each sum.
        let by = sums[(k / movements().len() + k) % sums.len()];
        holds(&s, by, value(&s, &*solved(&s, "turn-aware", by, &[])));
    }
}

#[test]
fn both_are_those_of_the_turn_aware_search_on_weighted_ground() {
    let all = By::all();
    for (k, s) in small(50).enumerate().map(|(k, s)| (k, weighed_down(&s))) {
        holds(&s, By::TurnIndex, value(&s, &*solved(&s, "turn-aware", By::TurnIndex, &[])));
        if k % 4 == k / 4 % 4 {
            let by = all[k % all.len()];
            holds(&s, by, least(&s, by));
        }
    }
}

#[test]
fn both_are_the_least_there_is_on_every_ground() {
    let all = By::all();
    let many = (0..10).flat_map(|seed| sixteen().map(|movement| super::random(5 + seed % 5, 0.2, 700 + seed, movement)));
    let heavy = many.clone().map(|s| weighed_down(&s));
    let hills = (0..10).flat_map(|seed| [sixteen()[0], movements()[1], movements()[0]].map(|m| hilly(7, 6, seed, 6.0, m, 60.0)));
    let swamps = movements().into_iter().chain(sixteen()).map(swamp);
    for (k, s) in many.chain(heavy).chain(hills).chain(swamps).enumerate() {
        let by = all[(k + k / 3) % all.len()];
        holds(&s, by, least(&s, by));
        holds(&s, By::TurnIndex, least(&s, By::TurnIndex));
    }
}

#[test]
fn a_longer_path_with_fewer_turns_wins() {
    // Straight along the bottom is 10 steps and two turns, as `turn-aware` has it.
    let s = drawn(&["S.#.#.#.G", ".........", "........."], Movement { moves: Moves::Four, ..Movement::default() });
    let ants = solved(&s, "formica", By::TurnIndex, &[]);
    assert_eq!((ants.objective(), ants.weighed()), (Objective::TurnIndex, None));
    assert!(same(value(&s, &*ants), 10.4));
    assert!(ants.certificate().is_some_and(|c| c.complete && same(c.lower_bound, 10.4)));
    let sum = WeightedSum { turn_weight: 5.0, clearance_weight: 0.0, ..WeightedSum::default() };
    let ants = solved(&s, "formica", By::Sum(sum), &[]);
    assert_eq!((ants.objective(), ants.weighed().map(|w| w.sum)), (Objective::Weighted, Some(sum)));
    assert!(same(value(&s, &*ants), 20.0) && ants.certificate().is_some_and(|c| same(c.lower_bound, 20.0)));
}

#[test]
fn a_best_path_may_be_longer_than_another() {
    let by = By::Sum(WeightedSum { turn_weight: 20.0, ..WeightedSum::default() });
    let longer = (0..40).map(|seed| rooms(48, seed, Movement::default())).find_map(|s| {
        let ants = solved(&s, "formica", by, &[]);
        let best = ants.best()?.length;
        let shortest = formicarium::exact::optimum(&s)?;
        (best > shortest + 0.1).then_some((ants, shortest))
    });
    let (ants, shortest) = longer.expect("rooms in which turns are worth a detour");
    for record in ants.history() {
        let [best, mean, worst] =
            [record.iteration_best, record.iteration_mean, record.iteration_worst].map(|l| l.expect("a length"));
        assert!(shortest <= best + 1e-9 && best <= mean + 1e-9 && mean <= worst + 1e-9, "{record:?}");
    }
}

#[test]
fn the_bound_is_right_when_the_proof_limit_is_small() {
    let mut open = 0;
    for seed in 0..8 {
        let made = generate(Generator::Rooms, 48, 48, seed, 0.2).expect("a valid size");
        let s = Arc::new(Scenario::on(made.grid, Movement::default(), made.start, made.goal).expect("usable"));
        for by in By::all() {
            let optimum = value(&s, &*solved(&s, "turn-aware", by, &[]));
            for limit in [0.001, 0.02, 0.2, 1.0] {
                let set =
                    [("proof_limit", limit), ("iterations", 2.0), ("widening", 0.0), ("corridor", 1.0), ("corridor_most", 1.0)];
                let ants = solved(&s, "formica", by, &set);
                let (best, certificate) = (value(&s, &*ants), ants.certificate().expect("as far as it goes"));
                let (low, complete) = (certificate.lower_bound, certificate.complete);
                assert!(low <= optimum + 1e-7 && optimum <= best + 1e-7, "{by:?} {limit}: {low}, {optimum}, {best}");
                assert_eq!((complete, ants.status() == Status::Optimal), (same(low, best), complete), "{by:?} {limit}");
                open += u32::from(!complete);
            }
        }
    }
    assert!(open > 40, "{open} proofs were cut off");
}

#[test]
fn references_know_what_is_proven() {
    let s = rooms(48, 3, Movement::default());
    let ants = solved(&s, "formica", By::TurnIndex, &[]);
    let Reference::Proven { value: proven } = reference(&s, ants.objective()) else { panic!("a plane") };
    assert!(same(value(&s, &*ants), proven));
}

#[test]
fn without_merging_the_best_ant_by_the_criterion_leads() {
    let s = rooms(32, 4, Movement::default());
    let mut values = By::TurnIndex.values();
    values.extend([
        ("merge".to_string(), false.into()),
        ("iterations".to_string(), 1.0.into()),
        ("proof_limit".to_string(), 0.0.into()),
    ]);
    let mut ants = formicarium::catalog::build(&s, "formica", None, &values, 1).expect("valid parameters");
    ants.run();
    let walked = (0..ants.colony_size()).filter_map(|k| ants.ant(k)).filter(|w| w.way.last() == Some(&s.goal));
    let least = walked.map(|w| By::TurnIndex.of(&s, &w.way)).fold(f64::INFINITY, f64::min);
    assert!(same(value(&s, &*ants), least));
    let mut trails = Vec::new();
    assert!(ants.layer(formicarium::planner::Layer::Trail, &mut trails));
    let path = &ants.best().expect("an ant arrives").path;
    let (most, at_start) = (trails.iter().copied().fold(0.0, f32::max), trails[s.start as usize]);
    assert!(path.contains(&s.goal) && same(f64::from(at_start), f64::from(most)), "{at_start} {most}");
}
