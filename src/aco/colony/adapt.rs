//! A colony goes on when walls have changed, between two iterations.
//!
//! | what | then |
//! |---|---|
//! | trails τ | stay, on every step: those of freed cells are what they evaporated to, like all that no ant has walked on |
//! | η and weights τ^α·η^β | anew for the cells around the change |
//! | what a paper derives from the map | anew ([`Variant::prepare`]): avg of MAX–MIN Ant System; τ0 of Ant Colony System, which an open map decides and walls do not |
//! | limits of MAX–MIN Ant System | with the next best path, as ever |
//! | best path so far | stays where it is still allowed, and is refined again; otherwise there is none until the next ants arrive |
//! | stagnation | counts from the change |
//!
//! The publications know no changing maps: all of this is ours.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::tables::Tables;
use super::{Colony, Variant, refined};
use crate::map::{Cell, Grid, Point};
use crate::path::Path;
use crate::scenario::{Change, Scenario};

/// How far, in cells, a wall is felt: a step from beside it, and what an ant sees at that step's end (eight cells around).
const FELT: u32 = 2;

impl<V: Variant + 'static> Colony<V> {
    /// Goes on from the map that a change has led to.
    pub(super) fn go_on(&mut self, change: &Change, to: &Arc<Scenario>) {
        let before = std::mem::replace(&mut self.scenario, Arc::clone(to));
        self.progress.best.take_if(|best| !is_allowed(to, &best.path));
        if let Some(best) = &mut self.progress.best {
            if !to.moves.is_plain() {
                best.length = to.path_length(&best.path);
            }
            best.refined = refined(to, &best.path, self.variant.refinement());
        }
        if let Some(tables) = &mut self.tables {
            self.variant.prepare(to);
            tables.look_again::<V>(&around(&before.grid, &to.grid, change));
        }
        self.progress.go_on(change, to, self.settings.iterations);
    }
}

impl Tables {
    /// Has the weights of these cells follow the map.
    fn look_again<V: Variant>(&mut self, cells: &[Cell]) {
        if V::TIMED {
            self.on_demand.forget(cells);
        } else {
            self.weights.forget(cells);
        }
        cells.iter().for_each(|&c| self.trails.look_again(c));
    }
}

/// The cells whose steps, or what is seen of them, a change concerns: around its own cells and, where the robot needs room, around all that
/// it has made narrow or wide, dear or cheap.
fn around(before: &Grid, now: &Grid, change: &Change) -> Vec<Cell> {
    let mut cells = BTreeSet::new();
    for p in change.cells().chain(differing(before, now)) {
        for y in p.y.saturating_sub(FELT)..=(p.y + FELT).min(now.height() - 1) {
            let row = y * now.width();
            cells.extend(row + p.x.saturating_sub(FELT)..=row + (p.x + FELT).min(now.width() - 1));
        }
    }
    cells.into_iter().collect()
}

/// The cells that two maps of one size differ in.
fn differing<'a>(before: &'a Grid, now: &'a Grid) -> impl Iterator<Item = Point> + use<'a> {
    let factor = |grid: &Grid, cell: usize| grid.factors().map_or(1.0, |factors| factors[cell]);
    let differs = move |&cell: &usize| before.blocked()[cell] != now.blocked()[cell] || factor(before, cell) != factor(now, cell);
    (0..now.len()).filter(differs).map(|cell| now.point(cell as Cell))
}

/// Whether every step of a path is still allowed.
fn is_allowed(scenario: &Scenario, path: &Path) -> bool {
    path.windows(2).all(|step| scenario.moves.directions(step[0]).any(|d| scenario.moves.step(step[0], d) == step[1]))
}
