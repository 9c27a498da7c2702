//! Formica by the turn index V and the weighted sum J: beside the turn-aware search on small maps and on benchmark maps, beside brute force on
//! every ground, and its search in parts of a map that grow.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../common/mod.rs"]
mod common;
mod growing;
mod maps;
#[path = "../common/movingai.rs"]
mod movingai;
mod small;
#[path = "../common/terrains.rs"]
mod terrains;

use std::sync::Arc;

use common::{movements, random};
use formicarium::catalog;
use formicarium::map::{Cell, Direction};
use formicarium::metrics::{Metrics, WeightedSum, turn_index};
use formicarium::params::{Value, Values};
use formicarium::planner::Planner;
use formicarium::scenario::Scenario;

/// A criterion with its weights.
#[derive(Debug, Clone, Copy)]
enum By {
    TurnIndex,
    Sum(WeightedSum),
}

impl By {
    /// V, and sums in which each term weighs much, or nothing.
    fn all() -> Vec<Self> {
        let none = WeightedSum { turn_weight: 0.0, clearance_weight: 0.0, ..WeightedSum::default() };
        let sums = [
            WeightedSum::default(),
            WeightedSum { turn_weight: 3.5, ..none },
            WeightedSum { clearance_weight: 8.0, clearance_wanted: 2.5, ..none },
            WeightedSum { energy_weight: 8.0, length_weight: 0.001, ..none },
            WeightedSum { energy_weight: 0.5, turn_weight: 0.3, clearance_weight: 2.0, ..WeightedSum::default() },
        ];
        std::iter::once(Self::TurnIndex).chain(sums.map(Self::Sum)).collect()
    }

    /// What a path comes to.
    fn of(self, s: &Scenario, path: &[Cell]) -> f64 {
        match self {
            Self::TurnIndex => turn_index(s, path),
            Self::Sum(sum) => sum.of(s, path),
        }
    }

    fn values(self) -> Values {
        let own = |key: &str, value: Value| (key.to_string(), value);
        let Self::Sum(sum) = self else { return [own("criterion", "turn-index".into())].into() };
        [
            own("criterion", "weighted-sum".into()),
            own("length_weight", sum.length_weight.into()),
            own("turn_weight", sum.turn_weight.into()),
            own("clearance_weight", sum.clearance_weight.into()),
            own("energy_weight", sum.energy_weight.into()),
            own("clearance_wanted", sum.clearance_wanted.into()),
        ]
        .into()
    }
}

/// A planner by a criterion with some numbers of its own, run to its end.
fn solved(s: &Arc<Scenario>, planner: &str, by: By, set: &[(&str, f64)]) -> Box<dyn Planner> {
    let mut values = by.values();
    values.extend(set.iter().map(|&(key, value)| (key.to_string(), Value::Number(value))));
    let mut planner = catalog::build(s, planner, None, &values, 1).expect("valid parameters");
    planner.run();
    planner
}

/// What its result is measured by; infinite without one.
fn value(s: &Scenario, planner: &dyn Planner) -> f64 {
    let value = |path: &[Cell]| planner.value(&Metrics::of(s, path)).expect("a value");
    planner.best().map_or(f64::INFINITY, |best| value(&best.path))
}

/// Maps of 5 to 16 cells a side under every movement by 4 and 8 steps, four for each seed.
fn small(seeds: u32) -> impl Iterator<Item = Arc<Scenario>> {
    let map = |seed: u32, movement| random(5 + seed % 12, [0.1, 0.25, 0.4][seed as usize % 3], 500 + seed, movement);
    (0..seeds).flat_map(move |seed| movements().into_iter().map(move |movement| map(seed, movement)))
}

/// The same scenario on ground of several factors.
fn weighed_down(s: &Scenario) -> Arc<Scenario> {
    let factor = |c: u32| [1.25, 4.0, 1.5, 2.0][(c.wrapping_mul(2_654_435_761) >> 30) as usize];
    let grid = s.grid.clone().with_factors((0..s.grid.len() as u32).map(factor).collect()).expect("factors of every cell");
    Arc::new(Scenario::new(grid, s.spec.clone()).expect("usable"))
}

/// The least value of a path from start to goal: states are cell · 16 + direction of the step that led there, and what a step costs is the
/// difference of two short paths, measured as any path is. Without a heap, a heuristic or an order.
fn least(s: &Scenario, by: By) -> f64 {
    let cells = s.grid.len();
    let from = |c: Cell| s.moves.directions(c).map(move |d| (c, d, s.moves.step(c, d)));
    let steps: Vec<(Cell, Direction, Cell)> = (0..cells as Cell).flat_map(from).collect();
    let state = |c: Cell, d: Direction| c as usize * 16 + usize::from(d);
    let mut edges = Vec::new();
    let mut cost = vec![f64::INFINITY; cells * 16];
    for &(c, d, next) in &steps {
        if c == s.start {
            cost[state(next, d)] = by.of(s, &[c, next]);
        }
        for e in s.moves.directions(next) {
            let last = s.moves.step(next, e);
            edges.push((state(next, d), state(last, e), by.of(s, &[c, next, last]) - by.of(s, &[c, next])));
        }
    }
    let mut changed = true;
    while std::mem::take(&mut changed) {
        for &(a, b, d) in &edges {
            if cost[a] + d < cost[b] - 1e-12 {
                (cost[b], changed) = (cost[a] + d, true);
            }
        }
    }
    let arrived = cost[state(s.goal, 0)..][..16].iter().copied().fold(f64::INFINITY, f64::min);
    if s.start == s.goal { 0.0 } else { arrived }
}

/// Equal but for rounding.
fn same(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() < 1e-7
}
