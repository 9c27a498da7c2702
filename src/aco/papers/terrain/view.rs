//! The fields over the map that the colony of the terrain paper can show: over places that are more than cells, the strongest or the mean.

use super::colony::FieldColony;
use super::sight::Eyes;
use super::space::{Place, Space};
use super::team::{eyes, first_trails};
use crate::map::Way;
use crate::planner::Layer;

impl<S: Space> FieldColony<S> {
    /// Writes a layer; false when there is no such layer.
    pub(super) fn show(&self, kind: Layer, out: &mut Vec<f32>) -> bool {
        out.clear();
        out.resize(self.space.area(), 0.0);
        match (kind, &self.tables) {
            (Layer::InitialTrail, _) => {
                self.params.ways().for_each(|way| strongest(first_trails(&self.space, &self.params, way), out));
            }
            (Layer::Heuristic, _) => self.mean_heuristic(&eyes(&self.space, &self.params, Way::Forward), out),
            (Layer::Trail, Some(tables)) => {
                let places = 0..self.space.places() as Place;
                tables.teams.iter().for_each(|team| strongest(places.clone().map(|place| team.trails.get(place)), out));
            }
            (Layer::Visits, Some(tables)) => {
                let visited = tables.ants.iter().flat_map(|ant| ant.list());
                visited.for_each(|&place| out[place as usize % self.space.area()] += 1.0);
            }
            (Layer::Trail | Layer::Visits, None) => {}
            _ => return false,
        }
        true
    }

    /// Mean η of the steps of the forward team that lead into each cell, over all of its places.
    fn mean_heuristic(&self, eyes: &Eyes, out: &mut [f32]) {
        let (weight, area) = (self.weight(self.iteration()), out.len());
        let mut ways = vec![0.0f32; area];
        let places = 0..self.space.places() as Place;
        let left: Vec<f64> = places.clone().map(|place| eyes.left(&self.space, place)).collect();
        for from in places {
            for (to, eta) in eyes.eta(&self.space, from, weight, |place| left[place as usize]) {
                out[to as usize % area] += eta as f32;
                ways[to as usize % area] += 1.0;
            }
        }
        out.iter_mut().zip(ways).for_each(|(sum, n)| *sum /= n.max(1.0));
    }
}

/// Of the values by place, the largest of each cell.
fn strongest(values: impl Iterator<Item = f64>, out: &mut [f32]) {
    let area = out.len();
    for (place, value) in values.enumerate() {
        let most = &mut out[place % area];
        *most = most.max(value as f32);
    }
}
