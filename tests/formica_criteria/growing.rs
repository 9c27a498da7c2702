//! The search in a part of the map that grows at random, and stops at random: what it bounds holds at every moment, and in the end it has the
//! least value.

use formicarium::exact::Within;
use formicarium::metrics::WeightedSum;

use super::terrains::{hilly, sixteen};
use super::{Arc, By, Scenario, least, same, small, weighed_down};

fn search(s: &Arc<Scenario>, by: By) -> Within {
    match by {
        By::TurnIndex => Within::by_turn_index(s),
        By::Sum(sum) => Within::by_sum(s, sum),
    }
}

/// Numbers that look random, the same everywhere.
struct Draws(u32);

impl Draws {
    fn below(&mut self, end: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((u64::from(self.0) * u64::from(end)) >> 32) as u32
    }
}

/// Lets the part grow by small squares, some of them far away, with a few expansions in between; how often a bound stood between.
fn grown(s: &Arc<Scenario>, by: By, optimum: f64, draws: &mut Draws) -> u32 {
    let mut search = search(s, by);
    let mut between = 0;
    let holds = |search: &Within| {
        let (low, best) = (search.lower_bound(), search.best().map_or(f64::INFINITY, |b| b.1));
        assert!(low <= optimum + 1e-7 && optimum <= best + 1e-7, "{by:?} {:?} {:?}: {low}, {optimum}, {best}", s.spec, s.grid);
        assert!(!search.is_proven() || same(best, optimum), "{by:?} {:?} {:?}: {best} is not {optimum}", s.spec, s.grid);
        u32::from(low < best - 1e-7 && low > 0.0)
    };
    for _ in 0..30 {
        for _ in 0..=draws.below(3) {
            search.widen(draws.below(s.grid.len() as u32), draws.below(3) as u8);
        }
        if draws.below(4) == 0 {
            search.widen(s.start, 1);
        }
        search.go_on(u64::from(draws.below(12)));
        between += holds(&search);
    }
    search.widen_to_all();
    while !search.go_on(7) {
        between += holds(&search);
    }
    holds(&search);
    assert!(search.is_proven(), "nothing is open");
    assert!(same(search.best().map_or(f64::INFINITY, |b| b.1), optimum), "{by:?} {:?} {:?}", s.spec, s.grid);
    between
}

#[test]
fn bounds_hold_however_the_part_grows() {
    let (all, mut draws, mut between) = (By::all(), Draws(7), 0);
    let plain = small(24);
    let heavy = small(12).map(|s| weighed_down(&s));
    let far = (0..12).flat_map(|seed| sixteen().map(|movement| super::random(5 + seed % 5, 0.2, 900 + seed, movement)));
    let hills = (0..12).map(|seed| hilly(8, 6, seed, 6.0, sixteen()[seed as usize % 3], 60.0));
    for (k, s) in plain.chain(heavy).chain(far).chain(hills).enumerate() {
        for by in [By::TurnIndex, all[k % all.len()]] {
            let optimum = least(&s, by);
            for _ in 0..4 {
                between += grown(&s, by, optimum, &mut draws);
            }
        }
    }
    assert!(between > 10_000, "{between} bounds lay below the best path");
}

#[test]
fn a_known_value_bounds_what_is_looked_for() {
    for s in small(10) {
        let by = By::Sum(WeightedSum::default());
        let optimum = least(&s, by);
        if !optimum.is_finite() || optimum == 0.0 {
            continue;
        }
        let mut search = search(&s, by);
        search.bound_by(optimum);
        search.widen_to_all();
        assert!(search.go_on(u64::MAX) && search.is_proven() && search.best().is_none());
        assert!(same(search.lower_bound(), optimum));
    }
}

#[test]
fn a_copy_goes_on_to_the_same_end() {
    let s = small(40).last().expect("a map");
    let mut search = search(&s, By::TurnIndex);
    search.widen_to_all();
    search.go_on(9);
    let mut copy = search.clone();
    assert!(search.go_on(u64::MAX) && copy.go_on(u64::MAX));
    let end = |search: &Within| (search.best(), search.expansions(), search.lower_bound().to_bits(), search.bytes() > 0);
    assert_eq!(end(&search), end(&copy));
}
