//! The search beside itself as its header describes it, without anything that makes it fast: the same cells in the same order, the same bits.

use super::*;
use crate::exact::Distance;
use crate::exact::order::{Costs, grid_row, nodes};
use crate::map::{CornerRule, Generator, Movement, Moves, generate};
use crate::scenario::{Goal, ScenarioSpec};

/// What a search leaves behind.
#[derive(PartialEq, Debug)]
struct Outcome {
    /// Bits of the costs of all cells, and the steps that led there.
    costs: Vec<u64>,
    parents: Vec<Direction>,
    /// How many cells were expanded, and the bits of the shortest path's cost.
    expansions: u64,
    bound: u64,
}

/// Expands cell by cell, each step by itself, from buckets that are never used again; on a terrain the bucket at work is sorted.
fn plainly(scenario: &Scenario, start: Cell, goal: Cell, estimate: &Distance) -> Outcome {
    let moves = &scenario.moves;
    let to_goal = |c: Cell| {
        let at = scenario.grid.point(c);
        estimate.to_goal(at.x, at.y)
    };
    let (base, per_cell) = (libm::floor(to_goal(start)), BUCKETS_PER_CONTOUR as f64 / contour(scenario));
    let mut g = vec![f64::INFINITY; scenario.grid.len()];
    g[start as usize] = 0.0;
    let mut parents = vec![NO_PARENT; scenario.grid.len()];
    let (mut expansions, mut bound) = (0, if start == goal { 0.0 } else { f64::INFINITY });
    let mut buckets = vec![if start == goal { Vec::new() } else { vec![Open { state: start, g: 0.0, f: to_goal(start) }] }];
    let mut at_work = 0;
    while at_work < buckets.len() {
        if moves.relief().is_some() {
            buckets[at_work].sort();
        }
        let Some(open) = buckets[at_work].pop() else {
            let floor = base + at_work as f64 / per_cell;
            at_work += 1;
            if at_work % 2 == 0 && floor + 1.0 / per_cell >= bound - SAME_LENGTH {
                break;
            }
            continue;
        };
        let cell = open.state;
        if open.g > g[cell as usize] || open.f >= bound - SAME_LENGTH {
            continue;
        }
        expansions += 1;
        for d in moves.directions(cell) {
            let (next, next_g) = (moves.step(cell, d), g[cell as usize] + moves.length(cell, d));
            let f = next_g + to_goal(next);
            if next_g >= g[next as usize] - SAME_LENGTH || f >= bound - SAME_LENGTH {
                continue;
            }
            (g[next as usize], parents[next as usize]) = (next_g, d);
            if next == goal {
                bound = next_g;
                continue;
            }
            let bucket = (((f - base) * per_cell) as usize).max(at_work);
            buckets.resize_with(buckets.len().max(bucket + 1), Vec::new);
            buckets[bucket].push(Open { state: next, g: next_g, f });
        }
    }
    Outcome { costs: g.iter().map(|g| g.to_bits()).collect(), parents, expansions, bound: bound.to_bits() }
}

/// The search as it is.
fn as_it_is(scenario: &Arc<Scenario>, start: Cell, goal: Cell, estimate: &Distance) -> Outcome {
    let mut search = Search::between(Arc::clone(scenario), start, goal, estimate.clone());
    search.run();
    Outcome {
        costs: search.costs().iter().map(|g| g.to_bits()).collect(),
        parents: (0..scenario.grid.len() as Cell).map(|cell| search.ways.parent(cell)).collect(),
        expansions: search.effort().cell_expansions,
        bound: search.bound.to_bits(),
    }
}

/// Maps of several kinds and sizes under every movement, planes and terrains, narrow ones too.
fn scenarios() -> impl Iterator<Item = Arc<Scenario>> {
    let kinds = [Generator::Random, Generator::Cave, Generator::Rooms, Generator::Maze, Generator::Hills];
    let movements = [Moves::Four, Moves::Eight, Moves::Sixteen].into_iter();
    let movements = movements.flat_map(|moves| CornerRule::ALL.map(|corner_rule| Movement { moves, corner_rule }));
    movements.flat_map(move |movement| {
        (0..40).map(move |seed| {
            let (width, height) = (1 + seed * 7 % 40, 1 + seed * 11 % 37);
            let made = generate(kinds[seed as usize % kinds.len()], width, height, seed, 0.3).expect("a map");
            let spec = ScenarioSpec { movement, ..made.spec("") };
            Arc::new(Scenario::new(made.grid, spec).expect("usable"))
        })
    })
}

#[test]
fn it_finds_what_the_plain_search_finds_bit_for_bit() {
    let (mut on_terrain, mut expansions) = (0, 0);
    for scenario in scenarios() {
        let (start, goal) = (scenario.start, scenario.goal);
        let questions = [
            (goal, Distance::of(&scenario)),
            (goal, Distance::unknown(&scenario)),
            (start, Distance::to(&scenario, start)),
            (EVERYWHERE, Distance::unknown(&scenario)),
        ];
        for (to, estimate) in questions {
            let (found, expected) = (as_it_is(&scenario, start, to, &estimate), plainly(&scenario, start, to, &estimate));
            assert!(
                found == expected,
                "{:?} to {to}: {} and {} expansions",
                scenario.spec,
                found.expansions,
                expected.expansions
            );
            expansions += found.expansions;
        }
        on_terrain += u32::from(scenario.moves.relief().is_some());
    }
    assert!(on_terrain > 20 && expansions > 100_000, "{on_terrain} terrains, {expansions} expansions");
}

#[test]
fn lengths_between_goals_have_the_bits_of_the_plain_search() {
    for scenario in scenarios().filter(|s| s.grid.len() > 60) {
        let free = (0..scenario.grid.len() as Cell).filter(|&c| c != scenario.start && !scenario.grid.is_blocked(c));
        let goals: Vec<Goal> = free.step_by(9).take(16).map(|c| Goal::new(scenario.grid.point(c), "")).collect();
        let scenario = Arc::new(scenario.with_ends(scenario.grid.point(scenario.start), goals).expect("usable"));
        let at = nodes(&scenario);
        let costs = Costs::grid(&scenario);
        for from in 0..at.len() - 1 {
            let expected = plainly(&scenario, at[from], EVERYWHERE, &Distance::unknown(&scenario));
            assert_eq!(grid_row(&scenario, from).1, expected.expansions);
            for (to, &cell) in at.iter().enumerate().skip(from + 1) {
                assert_eq!(costs.get(from, to).to_bits(), expected.costs[cell as usize]);
            }
        }
    }
}
