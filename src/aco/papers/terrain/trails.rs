//! Pheromone of one team: one trail τ for each place, as Eq. 14 has it, τ(x, y, z), whatever step leads there.
//!
//! As on the grid ([`crate::aco::trails`]), what leaves everywhere is kept as one factor; what ants take away where they come by is not.

use super::space::Place;
use crate::planner::held;

/// Stored trails never fall below this, so that τ stays positive however long it evaporates.
const FLOOR: f32 = 1e-30;
/// Below this scale the stored values are brought back to size in one sweep.
const SWEEP_BELOW: f64 = 1e-9;

/// The trails of one team.
#[derive(Debug, Clone)]
pub struct PlaceTrails {
    stored: Vec<f32>,
    scale: f64,
}

impl PlaceTrails {
    /// From τ of every place, above 0.
    pub fn new(initial: impl Iterator<Item = f64>) -> Self {
        Self { stored: initial.map(|t| (t as f32).max(FLOOR)).collect(), scale: 1.0 }
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.stored)
    }

    /// τ of a place.
    pub fn get(&self, place: Place) -> f64 {
        f64::from(self.stored[place as usize]) * self.scale
    }

    /// τ / scale of a place: enough to compare places.
    #[inline(always)]
    pub fn relative(&self, place: Place) -> f32 {
        self.stored[place as usize]
    }

    /// Eq. 3 where an ant comes by, with the local λ: τ ← (1 − λ)·τ.
    #[inline(always)]
    pub fn fade(&mut self, place: Place, lambda: f64) {
        let t = &mut self.stored[place as usize];
        *t = (*t * (1.0 - lambda) as f32).max(FLOOR);
    }

    /// τ ← (1 − λ)·τ + λ·target on one place: the local update of Ant Colony System, with τ0 as target.
    #[inline(always)]
    pub fn blend(&mut self, place: Place, lambda: f64, target: f64) {
        let t = &mut self.stored[place as usize];
        *t = ((f64::from(*t) * (1.0 - lambda) + lambda * target / self.scale) as f32).max(FLOOR);
    }

    /// The first term of Eq. 3 and 10 with the global λ: τ ← (1 − λ)·τ everywhere.
    pub fn evaporate(&mut self, lambda: f64) {
        self.scale *= 1.0 - lambda;
        if self.scale < SWEEP_BELOW {
            let scale = self.scale as f32;
            self.stored.iter_mut().for_each(|t| *t = (*t * scale).max(FLOOR));
            self.scale = 1.0;
        }
    }

    /// Δτ of Eq. 4 or Δτ⁺ of Eq. 11: τ ← τ + amount on every place of a path.
    pub fn deposit(&mut self, path: &[Place], amount: f64) {
        let amount = (amount / self.scale) as f32;
        path.iter().for_each(|&place| self.stored[place as usize] += amount);
    }
}

/// Eq. 11 over 1/L_k: (it/it_max)³, with `it` from 1.
pub fn elite_weight(iteration: u32, budget: u32) -> f64 {
    let part = f64::from(iteration) / f64::from(budget);
    part * part * part
}

/// How many ants of a team are elite: this share of them, rounded down, but at least one; none when the share is 0.
pub fn elite_count(share: f64, ants: usize) -> usize {
    if share > 0.0 { ((share * ants as f64) as usize).max(1) } else { 0 }
}
