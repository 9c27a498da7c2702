//! A colony goes on when walls have changed, between two iterations.
//!
//! | what | then |
//! |---|---|
//! | trails τ | stay, on every step: those of freed cells are what they evaporated to, like all that no ant has walked on |
//! | η and weights τ^α·η^β | anew for the cells around the change |
//! | what a paper derives from the map | anew ([`Variant::prepare`]): avg of MAX–MIN Ant System; τ0 of Ant Colony System, which an open map decides and walls do not |
//! | limits of MAX–MIN Ant System | with the next best path, as ever |
//! | best path so far | stays where it is still allowed, and is refined again; otherwise there is none until the next ants arrive |
//! | the start, where a robot has moved on | the next ants begin there; of the best path the rest from there stays |
//! | stagnation | counts from the change |
//!
//! The publications know no changing maps: all of this is ours.

use std::sync::Arc;

use super::tables::Tables;
use super::{Colony, Variant, refined};
use crate::map::Cell;
use crate::path::Path;
use crate::planner::Solution;
use crate::scenario::{Change, Scenario};

impl<V: Variant + 'static> Colony<V> {
    /// Goes on from the map that a change has led to.
    pub(super) fn go_on(&mut self, change: &Change, to: &Arc<Scenario>) {
        let before = std::mem::replace(&mut self.scenario, Arc::clone(to));
        self.progress.best = self.progress.best.take().and_then(|best| rest_of(best, to));
        if let Some(best) = &mut self.progress.best {
            if !to.moves.is_plain() {
                best.length = to.path_length(&best.path);
            }
            best.refined = refined(to, &best.path, self.variant.refinement());
        }
        if let Some(tables) = &mut self.tables {
            self.variant.prepare(to);
            tables.look_again::<V>(&change.felt(&before.grid, &to.grid));
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

/// What of a path leads from the start on, if that is still allowed.
fn rest_of(best: Solution, to: &Scenario) -> Option<Solution> {
    let from = best.path.iter().position(|&cell| cell == to.start)?;
    let path = best.path[from..].to_vec();
    let length = if from == 0 { best.length } else { to.path_length(&path) };
    is_allowed(to, &path).then_some(Solution { path, length, ..best })
}

/// Whether every step of a path is still allowed.
fn is_allowed(scenario: &Scenario, path: &Path) -> bool {
    path.windows(2).all(|step| scenario.moves.directions(step[0]).any(|d| scenario.moves.step(step[0], d) == step[1]))
}
