//! The genetic algorithm: BLX-α, tournaments, and what a generation leaves to the next.

use formicarium::params::{Params, Value, Values};
use formicarium::rng::Streams;
use formicarium::swarm::decode::Limits;
use formicarium::swarm::genetic::{Genetic, GeneticParams, blended, tournament};
use formicarium::swarm::population::Population;
use formicarium::swarm::search::Method;

use super::close;

const DIMENSIONS: usize = 6;

fn streams() -> Streams {
    Streams::new(1, "test", 0)
}

fn params(set: &[(&str, f64)], crossover: &str) -> GeneticParams {
    let numbers = set.iter().map(|&(k, v)| (k.to_string(), Value::Number(v)));
    let values: Values = numbers.chain([("crossover".to_string(), Value::from(crossover))]).collect();
    GeneticParams::read("ga", &values).expect("valid parameters")
}

/// The random generation with these costs, and its children, not yet decoded; the method stands before the next proposal.
fn bred(params: &GeneticParams, costs: &[f64]) -> (Genetic, Population) {
    let (mut method, mut population) = (Genetic::within([4.0, 9.0].map(Limits::up_to), params), Population::new(DIMENSIONS));
    assert!(method.propose(&mut population, 1, streams()));
    costs.iter().for_each(|&cost| population.note(cost));
    assert!(!method.propose(&mut population, 1, streams()), "the first generation is an iteration");
    assert!(method.propose(&mut population, 2, streams()));
    (method, population)
}

#[test]
fn blx_reaches_beyond_both_parents_by_hand() {
    // Between 2 and 6, α = 0.5: from 0 to 8, whichever comes first; α = 0 stays between.
    assert!([(0.0, 0.0), (0.5, 4.0), (0.75, 6.0), (1.0, 8.0)].iter().all(|&(u, x)| close(blended(2.0, 6.0, 0.5, u), x)));
    assert!(close(blended(6.0, 2.0, 0.5, 0.75), 6.0) && close(blended(6.0, 2.0, 0.0, 0.25), 3.0));
    assert_eq!(blended(3.0, 3.0, 0.5, 0.9), 3.0);
}

#[test]
fn a_tournament_takes_the_cheapest_it_draws() {
    let (costs, mut stream) = ([3.0, 1.0, 2.0, f64::INFINITY], streams().ant(0, 0));
    assert_eq!(tournament(&costs, 64, &mut stream), 1);
    let mut won = [0u32; 4];
    (0..16_000).for_each(|_| won[tournament(&costs, 2, &mut stream)] += 1);
    // Of 16 pairs the cheapest wins 7, then 5, 3 and 1.
    for (k, expected) in [(1, 7000.0), (2, 5000.0), (0, 3000.0), (3, 1000.0)] {
        assert!((f64::from(won[k]) - expected).abs() <= 4.0 * f64::sqrt(expected), "{k}: {won:?}");
    }
}

#[test]
fn the_elite_stays_and_children_take_the_other_places() {
    let p = params(&[("population", 4.0), ("survivors", 1.0)], "blx");
    let (mut method, mut population) = bred(&p, &[4.0, 1.0, 3.0, 2.0]);
    let best = population.position(1).to_vec();
    assert_eq!((population.len(), population.next()), (7, Some(4)));
    (0..3).for_each(|_| population.note(9.0));
    assert!(!method.propose(&mut population, 2, streams()));
    assert_eq!((population.position(0), population.costs()), (&best[..], &[1.0, 9.0, 9.0, 9.0][..]));
    // Where all survive, nothing is bred.
    let (_, population) = bred(&params(&[("population", 4.0), ("survivors", 9.0)], "blx"), &[4.0, 1.0, 3.0, 2.0]);
    assert_eq!(population.len(), 4);
}

#[test]
fn children_without_crossover_and_mutation_are_copies_of_winners() {
    let p = params(&[("population", 4.0), ("crossover_rate", 0.0), ("mutations", 0.0), ("tournament", 64.0)], "blx");
    let (_, population) = bred(&p, &[4.0, 1.0, 3.0, 2.0]);
    assert!((4..7).all(|i| population.position(i) == population.position(1)));
}

#[test]
fn numbers_are_exchanged_blended_and_drawn_anew_within_range() {
    let set = |mutations: f64| [("population", 8.0), ("crossover_rate", 1.0), ("mutations", mutations), ("blend", 2.0)];
    let costs = [1.0; 8];
    let (_, population) = bred(&params(&set(0.0), "exchange"), &costs);
    for child in (8..15).map(|i| population.position(i)) {
        for (k, x) in child.iter().enumerate() {
            assert!((0..8).any(|i| population.position(i)[k] == *x), "{x} is nobody's");
        }
    }
    for p in [params(&set(0.0), "blx"), params(&set(6.0), "blx")] {
        let (_, population) = bred(&p, &costs);
        let numbers = |ranged: usize| (8..15).flat_map(move |i| (0..DIMENSIONS / 2).map(move |k| (i, 2 * k + ranged)));
        for (ranged, range) in [(0, 4.0), (1, 9.0)] {
            let all: Vec<f32> = numbers(ranged).map(|(i, k)| population.position(i)[k]).collect();
            assert!(all.iter().all(|x| (0.0..=range).contains(x)), "{all:?}");
            assert!(all.iter().any(|&x| x > range / 2.0) && all.iter().any(|&x| x < range / 2.0), "{all:?}");
        }
    }
}
