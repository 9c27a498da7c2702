//! Looking back at a run and into a cell: what a snapshot and the odds of moves promise, of every planner.

use std::collections::BTreeMap;
use std::sync::Arc;

use formicarium::catalog;
use formicarium::map::Cell;
use formicarium::params::{Value, Values};
use formicarium::planner::playback::Playback;
use formicarium::planner::{Family, Granularity, Layer, Planner};
use formicarium::scenario::Scenario;

use super::{everywhere, planner, scenarios, short, takes};

#[test]
fn a_snapshot_goes_on_as_the_original() {
    everywhere(|entry, what, scenario| {
        let mut alone = planner(entry, scenario, 3);
        alone.run();
        // At the beginning, after three iterations, and in the middle of one.
        for (iterations, moves) in [(0, 0), (3, 0), (2, 5)] {
            let mut original = planner(entry, scenario, 3);
            for by in std::iter::repeat_n(Granularity::Iteration, iterations).chain(std::iter::repeat_n(Granularity::Move, moves))
            {
                original.advance(by);
            }
            let mut snapshot = original.snapshot();
            snapshot.run();
            original.run();
            for run in [&original, &snapshot] {
                assert_eq!(run.digest().hex(), alone.digest().hex(), "{what} after {iterations} iterations, {moves} moves");
                assert_eq!(run.history(), alone.history(), "{what}");
                assert_eq!((run.effort(), run.status()), (alone.effort(), alone.status()), "{what}");
            }
        }
    });
}

/// What stands at the end of an iteration: digest, layers, status.
fn standing(planner: &dyn Planner) -> (String, Vec<Vec<u32>>, u32) {
    let mut field = Vec::new();
    let kinds = [Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::Cost, Layer::Priority];
    let layers =
        kinds.map(|kind| if planner.layer(kind, &mut field) { field.iter().map(|v| v.to_bits()).collect() } else { vec![] });
    (planner.digest().hex(), layers.into(), planner.effort().iterations)
}

#[test]
fn every_iteration_can_be_looked_at_again_bit_for_bit() {
    everywhere(|entry, what, scenario| {
        // Small budgets make every look back a longer or shorter repetition; by moves searches end iterations half way into the next.
        for (budget, by) in [(0, Granularity::Iteration), (100_000, Granularity::Iteration), (u32::MAX, Granularity::Move)] {
            let mut run = planner(entry, scenario, 6);
            let mut playback = Playback::new(&*run, budget);
            let mut reference = planner(entry, scenario, 6);
            let mut stood = vec![standing(&*reference)];
            while !run.advance(by).is_finished() {
                playback.note(&*run, by);
            }
            playback.note(&*run, by);
            while !reference.status().is_finished() && stood.len() < 400 {
                reference.advance(Granularity::Iteration);
                stood.push(standing(&*reference));
            }
            let last = run.effort().iterations.min(stood.len() as u32 - 1);
            let mut near: Option<Box<dyn Planner>> = None;
            for iteration in [last, last / 2, 0, last / 3, last / 3 + 1, last] {
                let at = playback.back_to(iteration, near.as_deref()).into_planner();
                let expected = &stood[iteration.min(last) as usize];
                assert!(standing(&*at) == *expected, "{what}: iteration {iteration} of {last}, budget {budget}, by {by:?}");
                near = Some(at);
            }
            assert_eq!(run.digest().hex(), reference.digest().hex(), "{what}: looking back has changed the run");
        }
    });
}

/// Probability by colony and cell.
fn sums(planner: &dyn Planner, cell: Cell) -> BTreeMap<u32, f64> {
    let mut sums = BTreeMap::new();
    for odds in planner.moves_from(cell) {
        assert!(odds.trail > 0.0 && odds.heuristic > 0.0 && (0.0..=1.0 + 1e-12).contains(&odds.probability), "{odds:?}");
        *sums.entry(odds.colony).or_insert(0.0) += odds.probability;
    }
    sums
}

#[test]
fn probabilities_of_moves_sum_up_to_one() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 1);
        let places = scenario.slices.as_ref().map_or(scenario.grid.len(), |s| s.places()) as Cell;
        for step in 0..3 {
            let mut asked = 0;
            for cell in (0..places).step_by(places as usize / 40 + 1).chain([scenario.start, places, Cell::MAX]) {
                let sums = sums(&*planner, cell);
                assert!(sums.values().all(|sum| (sum - 1.0).abs() < 1e-9), "{what}: cell {cell}: {sums:?}");
                asked += sums.len();
            }
            let has_ants = entry.family == Family::AntColony;
            assert!(has_ants || asked == 0, "{what}: no ants, yet moves");
            // The first stage of a hybrid has none either, nor has a tour before its order is chosen.
            let at_once = has_ants && !entry.layers.contains(&Layer::Priority) && scenario.goals.len() == 1;
            assert!(!at_once || scenario.moves.all_bits(scenario.start) == 0 || asked > 0, "{what}: ants, but no moves");
            planner.advance(if step == 0 { Granularity::Move } else { Granularity::Iteration });
        }
    });
}

#[test]
fn odds_are_the_frequencies_with_which_first_ants_move() {
    const SEEDS: u32 = 1500;
    let all = scenarios();
    // Not where the first step is the last one: ants at the goal are gone when the iteration ends.
    let suited = |(name, s): &&(String, Arc<Scenario>)| {
        s.goals.len() == 1 && (name.contains("dead ends") || s.slices.as_ref().is_some_and(|slices| slices.slices() > 1))
    };
    for entry in catalog::CATALOG.iter().filter(|e| e.family == Family::AntColony && !e.layers.contains(&Layer::Priority)) {
        for (name, scenario) in all.iter().filter(suited).filter(|(_, s)| takes(entry, s)).step_by(2) {
            let mut values: Values = short(entry);
            values.insert("ants".into(), Value::Number(2.0));
            let build = |seed| catalog::build(scenario, entry.id, None, &values, seed).expect("valid parameters");
            let start = scenario.slices.as_ref().map_or(scenario.start, |s| s.start());
            let odds: Vec<_> = build(0).moves_from(start).into_iter().filter(|m| m.colony == 0).collect();
            let mut counts = BTreeMap::new();
            for seed in 0..SEEDS {
                let mut planner = build(seed);
                planner.advance(Granularity::Move);
                let mut ants = Vec::new();
                planner.ants(&mut ants);
                ants.first().into_iter().for_each(|&at| *counts.entry(at).or_insert(0u32) += 1);
            }
            for m in &odds {
                let (n, seen) = (f64::from(SEEDS), f64::from(counts.remove(&m.to).unwrap_or(0)));
                let deviation = (n * m.probability * (1.0 - m.probability)).max(0.0).sqrt();
                assert!(
                    (seen - n * m.probability).abs() <= 4.5 * deviation + 1e-6,
                    "{} on {name}: {m:?}, {seen} of {n}",
                    entry.id
                );
            }
            assert!(counts.is_empty(), "{} on {name}: ants went where no move leads: {counts:?}", entry.id);
        }
    }
}
