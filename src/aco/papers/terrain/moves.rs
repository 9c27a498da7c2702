//! The moves of an ant of the terrain paper at one place, as the page shows them. They come from the walk's own functions. Sight and ant are
//! made for the question: those of the walk depend on where ants have been.

use super::colony::FieldColony;
use super::sight::Sight;
use super::space::{Place, Space};
use super::team::{Tables, eyes, first_trails};
use super::trails::PlaceTrails;
use super::walk::{Walker, weigh};
use crate::aco::odds;
use crate::map::Way;
use crate::planner::{MoveOdds, Turn, stand_ready};

impl<S: Space> FieldColony<S> {
    /// [`Planner::moves_from`](crate::planner::Planner::moves_from) of every team, the one from the start first.
    pub(super) fn odds_at(&self, place: Place) -> Vec<MoveOdds> {
        if place as usize >= self.space.places() {
            return Vec::new();
        }
        let mut ant = Walker::new(self.space.places(), self.stream());
        ant.begin(place, self.stream());
        let teams = (0..).zip(self.params.ways()).filter(|&(_, way)| place != self.space.target(way));
        teams.flat_map(|(team, way)| self.odds_of(team, way, &ant)).collect()
    }

    /// [`Planner::turn_of`](crate::planner::Planner::turn_of), taken: the ants before it move, then this one.
    pub(super) fn take_turn(mut self, number: usize) -> Option<Turn> {
        if stand_ready(&mut self).is_finished() {
            return None;
        }
        self.move_ants(0..number);
        let Tables { teams, ants, .. } = self.tables.as_ref()?;
        let (ant, side) = (&ants[number], usize::from(!teams[0].range().contains(&number)));
        let walked = ant.walked();
        if !ant.is_walking() {
            return Some(Turn::over(walked));
        }
        let (from, odds) = (ant.place(), self.odds_of(side as u32, teams[side].way, ant));
        self.move_ants(number..number + 1);
        let to = self.tables.as_ref()?.ants[number].place();
        Some(Turn { walked, odds, next: (to != from).then_some(to) })
    }

    /// Of one ant of a team.
    fn odds_of(&self, team: u32, way: Way, ant: &Walker) -> Vec<MoveOdds> {
        let (space, params, from) = (&self.space, &self.params, ant.place());
        let first;
        let trails = match self.tables.as_ref().and_then(|tables| tables.teams.get(team as usize)) {
            Some(team) => &team.trails,
            None => {
                first = PlaceTrails::new(first_trails(space, params, way));
                &first
            }
        };
        let weights = self.weights(way, ant, trails);
        let odds = odds::pseudo_random_proportional(&weights, params.common.q0);
        let feasible = (0..space.steps()).filter_map(|k| Some((space.step(from, k, way)?, k)));
        let eyes = eyes(space, params, way);
        let seen = eyes.eta(space, from, self.weight(self.iteration()), |place| eyes.left(space, place));
        let step = |((to, k), (_, heuristic)): ((Place, usize), (Place, f64))| MoveOdds {
            colony: team,
            to,
            trail: trails.get(to),
            heuristic,
            weight: f64::from(weights[k]),
            probability: odds[k],
        };
        feasible.zip(seen).map(step).collect()
    }

    /// Of every step of an ant; 0 for those that are infeasible or tabu.
    fn weights(&self, way: Way, ant: &Walker, trails: &PlaceTrails) -> Vec<f32> {
        let (space, common, iteration) = (&self.space, &self.params.common, self.iteration());
        let mut sight = Sight::new(space, eyes(space, &self.params, way));
        sight.begin(iteration, self.weight(iteration));
        let deltas: Vec<i32> = (0..space.steps()).map(|k| space.delta(k, way)).collect();
        let mut weights = vec![0.0; space.steps()];
        weigh(ant, sight.row(space, ant.place()), &deltas, trails, common.selection.alpha, &mut weights);
        weights
    }
}
