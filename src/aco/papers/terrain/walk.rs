//! One ant of the terrain paper: its list of places, its path once it has one, and how it selects a step.

use rand::Rng;
use wide::f32x4;

use super::space::Place;
use super::trails::PlaceTrails;
use crate::aco::weights::{FLOOR, power};
use crate::map::Way;
use crate::planner::{Fate, Walked, held};
use crate::rng::{Stream, unit_f32};

/// An ant of one team.
#[derive(Debug, Clone)]
pub struct Walker {
    fate: Fate,
    /// The places that it has visited, in order, without those that it took back: the paper's list.
    list: Vec<Place>,
    /// Places that it took back; they stay on the tabu list.
    abandoned: Vec<Place>,
    /// One bit a place.
    tabu: Vec<u64>,
    moves: u32,
    /// From start to goal, once it has arrived or met another.
    route: Vec<Place>,
    cost: f64,
    /// Its random stream.
    pub stream: Stream,
}

impl Walker {
    /// An ant among this many places; it begins to walk by [`Walker::begin`].
    pub fn new(places: usize, stream: Stream) -> Self {
        let (list, abandoned, route) = (Vec::new(), Vec::new(), Vec::new());
        Self { fate: Fate::Lost, list, abandoned, tabu: vec![0; places.div_ceil(64)], moves: 0, route, cost: 0.0, stream }
    }

    /// Puts the ant on its origin with nothing else on its lists.
    pub fn begin(&mut self, origin: Place, stream: Stream) {
        for &place in self.list.iter().chain(&self.abandoned) {
            self.tabu[place as usize >> 6] = 0;
        }
        self.list.clear();
        self.abandoned.clear();
        self.route.clear();
        self.fate = Fate::Walking;
        self.moves = 0;
        self.stream = stream;
        self.enter(origin);
    }

    /// What became of it.
    pub fn fate(&self) -> Fate {
        self.fate
    }

    /// Whether it is still under way.
    #[inline(always)]
    pub fn is_walking(&self) -> bool {
        self.fate == Fate::Walking
    }

    /// Where it is.
    #[inline(always)]
    pub fn place(&self) -> Place {
        self.list.last().copied().unwrap_or(0)
    }

    /// The places that it has visited, in order, without those that it took back.
    pub fn list(&self) -> &[Place] {
        &self.list
    }

    /// How far it has come.
    pub fn walked(&self) -> Walked {
        Walked { way: self.list.clone(), fate: self.fate }
    }

    /// Moves so far: steps, steps back, and the one in which it finds itself lost.
    pub fn moves(&self) -> u32 {
        self.moves
    }

    /// Its path from start to goal with what it costs, once it has one.
    pub fn path(&self) -> Option<(&[Place], f64)> {
        (self.fate == Fate::Arrived).then_some((self.route.as_slice(), self.cost))
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.list) + held(&self.abandoned) + held(&self.tabu) + held(&self.route)
    }

    /// All ones where it has not visited a place.
    #[inline(always)]
    pub fn open(&self, place: Place) -> u32 {
        ((self.tabu[place as usize >> 6] >> (place & 63) & 1) as u32).wrapping_sub(1)
    }

    /// One step.
    #[inline(always)]
    pub fn step(&mut self, to: Place) {
        self.moves += 1;
        self.enter(to);
    }

    fn enter(&mut self, place: Place) {
        self.tabu[place as usize >> 6] |= 1 << (place & 63);
        self.list.push(place);
    }

    /// At a dead end: back to where it came from; the place that it leaves. None at its origin, where it is lost instead.
    pub fn step_back(&mut self) -> Option<Place> {
        if self.list.len() < 2 {
            self.lose();
            return None;
        }
        self.moves += 1;
        let left = self.list.pop();
        self.abandoned.extend(left);
        left
    }

    /// At a dead end, without a step back.
    pub fn lose(&mut self) {
        self.moves += 1;
        self.stop();
    }

    /// It ends where it is, without a path.
    pub fn stop(&mut self) {
        self.fate = Fate::Lost;
    }

    /// It has walked alone from start to goal, at this cost: its list is its path.
    pub fn arrive_alone(&mut self, cost: f64) {
        self.route.clone_from(&self.list);
        self.cost = cost;
        self.fate = Fate::Arrived;
    }

    /// It has a path: what [`join`] made of its list, with what that costs.
    pub fn arrive(&mut self, route: &[Place], cost: f64) {
        self.route.clear();
        self.route.extend_from_slice(route);
        self.cost = cost;
        self.fate = Fate::Arrived;
    }
}

/// Section 4.2: the path from start to goal that a list from the start and one from the goal make where they overlap, at `place`, or that
/// one of them is alone, whose other end `place` then is. Lists that begin to overlap with their newest place have but that one in
/// common, so no path visits a place twice.
pub fn join(from_start: &[Place], from_goal: &[Place], place: Place, route: &mut Vec<Place>) {
    let before = |list: &[Place]| list.iter().position(|&p| p == place).unwrap_or(list.len());
    route.clear();
    route.extend_from_slice(&from_start[..before(from_start)]);
    route.push(place);
    route.extend(from_goal[..before(from_goal)].iter().rev());
}

/// [`join`] for an ant that has walked alone from end to end.
pub fn alone(list: &[Place], way: Way, route: &mut Vec<Place>) {
    route.clear();
    match way {
        Way::Forward => route.extend_from_slice(list),
        Way::Backward => route.extend(list.iter().rev()),
    }
}

/// Eq. 1 without its denominator, τ_j^α·η_ij^β of every step by what `seen` has of η; 0 for steps that are infeasible or tabu. τ is
/// divided by the largest of the steps that are left.
#[inline(always)]
pub fn weigh(ant: &Walker, seen: &[f32], deltas: &[i32], trails: &PlaceTrails, alpha: f64, weights: &mut [f32]) {
    gather(ant, seen, deltas, weights, |to, _| trails.relative(to));
    combine(weights, seen, alpha);
}

/// The trail of every step that is left, by where it leads and its number; 0 for the others.
#[inline(always)]
pub fn gather(ant: &Walker, seen: &[f32], deltas: &[i32], trails: &mut [f32], trail: impl Fn(Place, usize) -> f32) {
    let from = ant.place();
    // Without branches: where no step is feasible one looks at the ant's own place, which is tabu.
    let of = |seen: f32, delta: i32, k: usize| {
        let to = if seen > 0.0 { from.wrapping_add_signed(delta) } else { from };
        f32::from_bits(trail(to, k).to_bits() & ant.open(to))
    };
    // Eight at a time, which the compiler unrolls: there are 8 or 16 on the ground.
    let (trails, rest) = trails.as_chunks_mut::<8>();
    let eights = trails.len();
    for (i, ((trails, seen), deltas)) in trails.iter_mut().zip(seen.as_chunks::<8>().0).zip(deltas.as_chunks::<8>().0).enumerate()
    {
        for k in 0..8 {
            trails[k] = of(seen[k], deltas[k], 8 * i + k);
        }
    }
    for (k, trail) in (8 * eights..).zip(rest) {
        *trail = of(seen[k], deltas[k], k);
    }
}

/// From the trails τ of the steps that are left to τ^α·η^β by what `seen` has of η; τ is divided by the largest. 0 stays 0.
#[inline(always)]
pub fn combine(weights: &mut [f32], seen: &[f32], alpha: f64) {
    let largest = largest(weights).max(f32::MIN_POSITIVE);
    if alpha != 1.0 {
        for (weight, &seen) in weights.iter_mut().zip(seen).filter(|(weight, _)| **weight > 0.0) {
            *weight = (power(f64::from(*weight / largest), alpha) as f32 * seen).max(FLOOR);
        }
        return;
    }
    let (fours, rest) = weights.as_chunks_mut::<4>();
    let (seen_fours, seen_rest) = seen.as_chunks::<4>();
    for (weights, &seen) in fours.iter_mut().zip(seen_fours) {
        let trails = f32x4::new(*weights);
        let product = (trails / f32x4::splat(largest) * f32x4::new(seen)).fast_max(f32x4::splat(FLOOR));
        *weights = (product & trails.simd_gt(f32x4::ZERO)).to_array();
    }
    for (weight, seen) in rest.iter_mut().zip(seen_rest).filter(|(weight, _)| **weight > 0.0) {
        *weight = (*weight / largest * seen).max(FLOOR);
    }
}

/// The largest weight; 0 of none.
#[inline(always)]
fn largest(weights: &[f32]) -> f32 {
    let (fours, rest) = weights.as_chunks::<4>();
    let mut most = f32x4::ZERO;
    for &four in fours {
        most = most.fast_max(f32x4::new(four));
    }
    let [a, b, c, d] = most.to_array();
    let larger = |a: f32, b: f32| if a > b { a } else { b };
    rest.iter().fold(larger(larger(a, b), larger(c, d)), |most, &weight| larger(most, weight))
}

/// The first of the weights that are at least so large.
#[inline(always)]
fn first_at_least(weights: &[f32], least: f32) -> Option<usize> {
    let (fours, rest) = weights.as_chunks::<4>();
    for (i, &four) in fours.iter().enumerate() {
        let found = f32x4::new(four).simd_ge(f32x4::splat(least)).to_bitmask();
        if found != 0 {
            return Some(4 * i + found.trailing_zeros() as usize);
        }
    }
    rest.iter().position(|&weight| weight >= least).map(|k| 4 * fours.len() + k)
}

/// With probability q0 the step of the largest weight, the first of equals; otherwise Eq. 1. `None` when no step is left.
///
/// Draws q first, unless q0 is 0, and for Eq. 1 a second number; at a dead end none at all.
#[inline(always)]
pub fn select(weights: &[f32], q0: f64, stream: &mut Stream) -> Option<usize> {
    let largest = largest(weights);
    if largest <= 0.0 {
        return None;
    }
    if q0 > 0.0 && f64::from(unit_f32(stream.next_u32())) <= q0 {
        return first_at_least(weights, largest);
    }
    let threshold = unit_f32(stream.next_u32()) * weights.iter().sum::<f32>();
    let mut sum = 0.0;
    let above = weights.iter().position(|w| {
        sum += w;
        sum > threshold
    });
    // u < 1, but the product may round up to the sum.
    above.or_else(|| weights.iter().rposition(|w| *w > 0.0))
}
