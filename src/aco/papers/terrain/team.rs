//! A team of ants (of the paper's two colonies; together they are one colony of ours), its trails and what it sees; the moves of all ants, and how two of different teams meet (section 4.2).

use super::field::Field;
use super::params::{EpfParams, Initial, LocalRule};
use super::sight::{Eyes, Sight};
use super::space::{Place, Space};
use super::trails::{PlaceTrails, elite_count, elite_weight};
use super::walk::{Walker, alone, join, select, weigh};
use crate::aco::dead_end::DeadEnd;
use crate::error::ParamError;
use crate::map::Way;
use crate::planner::held;
use crate::rng::Streams;

/// The ants of one way, their trails and what they see.
#[derive(Clone)]
pub(super) struct Team {
    pub(super) way: Way,
    /// The index of the first ant.
    first: usize,
    ants: usize,
    target: Place,
    deltas: Vec<i32>,
    pub(super) trails: PlaceTrails,
    pub(super) sight: Sight,
    /// By place: how many ants of the team that still walk have it on their list. Empty where there is nobody to meet.
    on_lists: Vec<u16>,
}

impl Team {
    fn new(space: &impl Space, params: &EpfParams, way: Way, first: usize, ants: usize) -> Self {
        let others = params.backward_ants() > 0;
        Self {
            way,
            first,
            ants,
            target: space.target(way),
            deltas: (0..space.steps()).map(|k| space.delta(k, way)).collect(),
            trails: PlaceTrails::new(first_trails(space, params, way)),
            sight: Sight::new(space, eyes(space, params, way)),
            on_lists: if others { vec![0; space.places()] } else { Vec::new() },
        }
    }

    /// The indices of its ants.
    pub(super) fn range(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.ants
    }

    /// Takes a place onto the list of a walking ant.
    pub(super) fn note(&mut self, place: Place) {
        if let Some(count) = self.on_lists.get_mut(place as usize) {
            *count += 1;
        }
    }

    /// Takes places from the list of an ant that has left them or walks no more.
    fn forget(&mut self, places: &[Place]) {
        if !self.on_lists.is_empty() {
            places.iter().for_each(|&place| self.on_lists[place as usize] -= 1);
        }
    }

    /// Whether a walking ant of the team has a place on its list.
    fn lists(&self, place: Place) -> bool {
        self.on_lists.get(place as usize).is_some_and(|&count| count > 0)
    }

    /// Eq. 3 and 4, with the elite's increase Eq. 10 and 11.
    pub(super) fn update_trails(&mut self, params: &EpfParams, ants: &[Walker], iteration: u32) {
        let (q, ants) = (params.common.deposit, &ants[self.range()]);
        self.trails.evaporate(params.common.rho);
        let mut arrived: Vec<(&[Place], f64)> = ants.iter().filter_map(Walker::path).collect();
        arrived.iter().for_each(|&(path, cost)| self.trails.deposit(path, q / cost));
        arrived.sort_by(|a, b| a.1.total_cmp(&b.1));
        let weight = elite_weight(iteration, params.common.selection.iterations);
        for &(path, cost) in arrived.iter().take(elite_count(params.elite, ants.len())) {
            self.trails.deposit(path, weight * q / cost);
        }
    }
}

/// τ of every place before the first iteration: τ0, or Eq. 14.
pub(super) fn first_trails(space: &impl Space, params: &EpfParams, way: Way) -> impl Iterator<Item = f64> {
    let (field, tau0, initial) = (Field::new(space, way, params.gains()), params.common.initial_trail, params.initial);
    (0..space.places() as Place).map(move |place| match initial {
        Initial::Uniform => tau0,
        Initial::Field => tau0 * field.trail(space, place),
    })
}

/// What the ants of one way look at.
pub(super) fn eyes(space: &impl Space, params: &EpfParams, way: Way) -> Eyes {
    let force = params.force.then(|| (Field::new(space, way, params.gains()), params.force_base));
    Eyes { way, heuristic: params.common.heuristic, beta: params.common.selection.beta, force }
}

/// Refuses what could run out of memory: every place with a row in each team's tables, and a tabu list for each ant.
///
/// # Errors
/// [`ParamError::Memory`].
pub(super) fn check_memory(space: &impl Space, params: &EpfParams) -> Result<(), ParamError> {
    let (places, steps, ants) = (space.places() as u64, space.steps() as u64, params.common.ants);
    let row = 4 * steps * if params.force { 3 } else { 1 };
    let teams = params.ways().count() as u64;
    ParamError::check_memory("ants", ants, teams * places * (16 + row) + u64::from(ants) * (places / 8 + 4096))
}

/// Allocated at the first step, so that a colony that is only shown costs nothing.
#[derive(Clone)]
pub(super) struct Tables {
    pub(super) teams: Vec<Team>,
    pub(super) ants: Vec<Walker>,
    /// Of the steps of the ant at work.
    weights: Vec<f32>,
    /// The path of the ants that arrive at the moment.
    route: Vec<Place>,
}

impl Tables {
    pub(super) fn new(space: &impl Space, params: &EpfParams, streams: Streams) -> Self {
        let (all, back) = (params.common.ants as usize, params.backward_ants() as usize);
        let team = |way| match way {
            Way::Forward => Team::new(space, params, way, 0, all - back),
            Way::Backward => Team::new(space, params, way, all - back, back),
        };
        let teams = params.ways().map(team).collect();
        let ants = (0..all).map(|k| Walker::new(space.places(), streams.ant(0, k as u32))).collect();
        Self { teams, ants, weights: vec![0.0; space.steps()], route: Vec::new() }
    }

    /// What they hold, in bytes.
    pub(super) fn bytes(&self) -> usize {
        let team = |t: &Team| held(&t.deltas) + t.trails.bytes() + t.sight.bytes() + held(&t.on_lists);
        let teams = held(&self.teams) + self.teams.iter().map(team).sum::<usize>();
        let ants = held(&self.ants) + self.ants.iter().map(Walker::bytes).sum::<usize>();
        teams + ants + held(&self.weights) + held(&self.route)
    }

    /// One move of one ant.
    #[inline(always)]
    pub(super) fn move_one(&mut self, space: &impl Space, params: &EpfParams, k: usize) {
        let side = usize::from(k >= self.teams[0].ants);
        let (team, ant, common) = (&mut self.teams[side], &mut self.ants[k], &params.common);
        let seen = team.sight.row(space, ant.place());
        weigh(ant, seen, &team.deltas, &team.trails, common.selection.alpha, &mut self.weights);
        let Some(step) = select(&self.weights, common.q0, &mut ant.stream) else {
            self.dead_end(side, k, common.walk.dead_end);
            return;
        };
        let to = ant.place().wrapping_add_signed(team.deltas[step]);
        ant.step(to);
        match common.local_rule {
            LocalRule::Evaporate => team.trails.fade(to, common.local_rho),
            LocalRule::Acs => team.trails.blend(to, common.local_rho, common.initial_trail),
        }
        team.note(to);
        if self.teams.get(1 - side).is_some_and(|other| other.lists(to)) {
            self.meet(space, side, k, to);
        } else if to == self.teams[side].target {
            alone(self.ants[k].list(), self.teams[side].way, &mut self.route);
            self.arrive(space, &[(side, k)]);
        }
    }

    #[inline(never)]
    fn dead_end(&mut self, side: usize, k: usize, how: DeadEnd) {
        let (team, ant) = (&mut self.teams[side], &mut self.ants[k]);
        match how {
            DeadEnd::Backtrack => {
                if let Some(left) = ant.step_back() {
                    team.forget(&[left]);
                }
            }
            DeadEnd::Die => ant.lose(),
        }
        if !ant.is_walking() {
            team.forget(ant.list());
        }
    }

    /// Section 4.2, step 3: joins the list of an ant with that of the first walking ant of the other team that has its place.
    #[inline(never)]
    fn meet(&mut self, space: &impl Space, side: usize, k: usize, place: Place) {
        let has = |&other: &usize| self.ants[other].is_walking() && self.ants[other].list().contains(&place);
        let Some(other) = self.teams[1 - side].range().find(has) else { return };
        let (forward, backward) = if side == 0 { (k, other) } else { (other, k) };
        join(self.ants[forward].list(), self.ants[backward].list(), place, &mut self.route);
        self.arrive(space, &[(0, forward), (1, backward)]);
    }

    /// Ants, by team and index, stop with the path in `route`.
    #[inline(never)]
    fn arrive(&mut self, space: &impl Space, ants: &[(usize, usize)]) {
        let cost = space.value(&self.route);
        for &(side, k) in ants {
            self.ants[k].arrive(&self.route, cost);
            self.teams[side].forget(self.ants[k].list());
        }
    }

    /// An ant at the cap on its moves stops without a path.
    pub(super) fn give_up(&mut self, k: usize) {
        let side = usize::from(k >= self.teams[0].ants);
        self.ants[k].stop();
        self.teams[side].forget(self.ants[k].list());
    }
}
