//! The moves of an ant of the terrain paper at one place, as the page shows them. They come from the walk's own functions. Sight and ant are
//! made for the question: those of the walk depend on where ants have been.

use super::colony::FieldColony;
use super::sight::Sight;
use super::space::{Place, Space};
use super::team::{eyes, first_trails};
use super::trails::PlaceTrails;
use super::walk::{Walker, weigh};
use crate::aco::odds;
use crate::map::Way;
use crate::planner::MoveOdds;

impl<S: Space> FieldColony<S> {
    /// [`Planner::moves_from`](crate::planner::Planner::moves_from) of every team, the one from the start first.
    pub(super) fn odds_at(&self, place: Place) -> Vec<MoveOdds> {
        if place as usize >= self.space.places() {
            return Vec::new();
        }
        let teams = (0..).zip(self.params.ways()).filter(|&(_, way)| place != self.space.target(way));
        teams.flat_map(|(team, way)| self.odds_of(team, way, place)).collect()
    }

    /// Of one team.
    fn odds_of(&self, team: u32, way: Way, from: Place) -> Vec<MoveOdds> {
        let (space, params) = (&self.space, &self.params);
        let first;
        let trails = match self.tables.as_ref().and_then(|tables| tables.teams.get(team as usize)) {
            Some(team) => &team.trails,
            None => {
                first = PlaceTrails::new(first_trails(space, params, way));
                &first
            }
        };
        let odds = self.probabilities(way, from, trails);
        let feasible = (0..space.steps()).filter_map(|k| Some((space.step(from, k, way)?, odds[k])));
        let eyes = eyes(space, params, way);
        let seen = eyes.eta(space, from, self.weight(self.iteration()));
        let step =
            |((to, probability), (_, heuristic))| MoveOdds { colony: team, to, trail: trails.get(to), heuristic, probability };
        feasible.zip(seen).map(step).collect()
    }

    /// Of every step from a place, of an ant that has visited nothing else; 0 for those that are infeasible.
    fn probabilities(&self, way: Way, from: Place, trails: &PlaceTrails) -> Vec<f64> {
        let (space, common, iteration) = (&self.space, &self.params.common, self.iteration());
        let mut sight = Sight::new(space, eyes(space, &self.params, way));
        sight.begin(iteration, self.weight(iteration));
        let mut ant = Walker::new(space.places(), self.stream());
        ant.begin(from, self.stream());
        let deltas: Vec<i32> = (0..space.steps()).map(|k| space.delta(k, way)).collect();
        let mut weights = vec![0.0; space.steps()];
        weigh(&ant, sight.row(space, from), &deltas, trails, common.selection.alpha, &mut weights);
        odds::pseudo_random_proportional(&weights, common.q0)
    }
}
