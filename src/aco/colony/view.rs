//! What a colony shows of its inside, cell by cell.

use super::Colony;
use crate::aco::criterion::way;
use crate::aco::variant::Variant;
use crate::aco::visibility::Eta;
use crate::map::Cell;
use crate::metrics::obstacle_density;
use crate::planner::Layer;
use crate::scenario::Scenario;

impl<V: Variant + 'static> Colony<V> {
    /// [`Planner::layer`](crate::planner::Planner::layer).
    pub(super) fn show(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        let scenario = &self.scenario;
        let count = scenario.grid.len();
        out.clear();
        out.resize(count, 0.0);
        match (kind, &self.tables) {
            (Layer::Cost | Layer::SeedPath | Layer::Priority, _) => return false,
            (Layer::Scent | Layer::Merged, _) => return self.variant.show(scenario, kind, out),
            (Layer::Density, _) => {
                out.iter_mut().enumerate().for_each(|(c, v)| *v = obstacle_density(scenario, c as Cell) as f32)
            }
            (Layer::InitialTrail, _) => self.initial_trails().strongest_of_all(out),
            (Layer::Heuristic, _) => mean_heuristic(scenario, out, &|i, d, j| self.variant.heuristic(scenario, i, d, j)),
            (Layer::Trail, Some(tables)) => tables.trails.strongest_of_all(out),
            (Layer::Visits, Some(tables)) => {
                for ant in &tables.ants {
                    way(scenario, ant).iter().for_each(|&c| out[c as usize] += 1.0);
                }
            }
            (Layer::Trail | Layer::Visits, None) => {}
        }
        true
    }

    /// [`Planner::layer_version`](crate::planner::Planner::layer_version).
    pub(super) fn version_of(&self, kind: Layer) -> Option<u64> {
        let finished = self.progress.effort.iterations;
        match kind {
            Layer::Density => Some(0),
            Layer::Scent => Some(0),
            Layer::Merged => Some(finished.into()),
            // What a variant learns of the map before its first step.
            Layer::InitialTrail => Some(u64::from(self.tables.is_some())),
            Layer::Heuristic => Some(self.seen_since.into()),
            Layer::Trail if !V::LOCK_STEP => Some(u64::from(finished) + u64::from(self.tables.is_some())),
            _ => None,
        }
    }
}

/// Mean η of the steps that lead into each cell.
#[inline(never)]
fn mean_heuristic(scenario: &Scenario, out: &mut [f32], eta: &Eta) {
    let mut ways = vec![0.0f32; out.len()];
    for i in 0..out.len() as Cell {
        for d in scenario.moves.directions(i) {
            let j = scenario.moves.step(i, d);
            out[j as usize] += eta(i, d, j) as f32;
            ways[j as usize] += 1.0;
        }
    }
    out.iter_mut().zip(ways).for_each(|(sum, n)| *sum /= n.max(1.0));
}
