//! Pheromone by place and step (or by place alone): rows of their own where ants have changed them, one value for all the rest.

use crate::map::Cell;
use crate::planner::held;

/// Trails never fall below this, so that τ stays positive however long it evaporates.
const FLOOR: f32 = 1e-30;
/// No row of its own.
const NONE: u32 = u32::MAX;

/// The trails of a colony.
#[derive(Debug, Clone)]
pub struct RowTrails {
    width: usize,
    /// Row by place.
    row_of: Vec<u32>,
    rows: Vec<f32>,
    /// τ wherever there is no row.
    background: f32,
}

impl RowTrails {
    /// τ everywhere, for this many places with `width` steps each.
    pub fn new(places: usize, width: usize, initial: f64) -> Self {
        Self { width, row_of: vec![NONE; places], rows: Vec::new(), background: (initial as f32).max(FLOOR) }
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.row_of) + held(&self.rows)
    }

    /// τ of a step of a place.
    #[inline(always)]
    pub fn get(&self, place: Cell, step: usize) -> f32 {
        match self.row_of[place as usize] {
            NONE => self.background,
            row => self.rows[row as usize * self.width + step],
        }
    }

    /// τ of the steps of a place that has a row of its own.
    #[inline(always)]
    pub fn row(&self, place: Cell) -> Option<&[f32]> {
        let first = match self.row_of[place as usize] {
            NONE => return None,
            row => row as usize * self.width,
        };
        Some(&self.rows[first..first + self.width])
    }

    /// τ wherever there is no row.
    pub fn elsewhere(&self) -> f32 {
        self.background
    }

    /// τ of the strongest step of a place.
    pub fn strongest(&self, place: Cell) -> f32 {
        (0..self.width).map(|k| self.get(place, k)).fold(0.0, f32::max)
    }

    /// τ ← (1 − rate)·τ + rate·target on one step.
    #[inline]
    pub fn blend(&mut self, place: Cell, step: usize, rate: f64, target: f64) {
        let t = self.own(place, step);
        *t = ((f64::from(*t) * (1.0 - rate) + rate * target) as f32).max(FLOOR);
    }

    /// τ ← τ + amount on one step.
    pub fn deposit(&mut self, place: Cell, step: usize, amount: f64) {
        *self.own(place, step) += amount as f32;
    }

    /// τ ← (1 − rate)·τ everywhere.
    pub fn evaporate(&mut self, rate: f64) {
        let stays = (1.0 - rate) as f32;
        self.rows.iter_mut().for_each(|t| *t = (*t * stays).max(FLOOR));
        self.background = (self.background * stays).max(FLOOR);
    }

    /// min ≤ τ ≤ max everywhere; where both cannot be, max gives way.
    pub fn limit(&mut self, min: f64, max: f64) {
        let low = (min as f32).max(FLOOR);
        let high = (max as f32).max(low);
        self.rows.iter_mut().for_each(|t| *t = t.max(low).min(high));
        self.background = self.background.max(low).min(high);
    }

    /// The same τ everywhere again.
    pub fn reset(&mut self, value: f64) {
        self.rows.clear();
        self.row_of.fill(NONE);
        self.background = (value as f32).max(FLOOR);
    }

    /// The step's own τ, which begins as that of all the rest.
    #[inline]
    fn own(&mut self, place: Cell, step: usize) -> &mut f32 {
        if self.row_of[place as usize] == NONE {
            self.begin(place);
        }
        &mut self.rows[self.row_of[place as usize] as usize * self.width + step]
    }

    #[inline(never)]
    fn begin(&mut self, place: Cell) {
        self.row_of[place as usize] = (self.rows.len() / self.width) as u32;
        self.rows.resize(self.rows.len() + self.width, self.background);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_changed_and_what_is_not_by_hand() {
        let mut t = RowTrails::new(3, 2, 1.0);
        t.deposit(1, 0, 0.5);
        t.evaporate(0.5);
        assert_eq!([(0, 1), (1, 0), (1, 1)].map(|(p, k)| t.get(p, k)), [0.5, 0.75, 0.5]);
        // 0.75·0.9 + 0.1·2 = 0.875.
        t.blend(1, 0, 0.1, 2.0);
        assert_eq!((t.get(1, 0), t.strongest(1), t.strongest(2)), (0.875, 0.875, 0.5));
        t.limit(0.6, 0.8);
        assert_eq!([(0, 1), (1, 0), (1, 1)].map(|(p, k)| t.get(p, k)), [0.6, 0.8, 0.6]);
        t.reset(3.0);
        assert_eq!((t.get(1, 0), t.get(2, 1)), (3.0, 3.0));
    }

    #[test]
    fn trails_stay_positive_and_finite_under_any_evaporation() {
        for rate in [0.0, 0.5, 1.0] {
            let mut t = RowTrails::new(2, 1, 1.0);
            (0..3000).for_each(|_| {
                t.evaporate(rate);
                t.blend(0, 0, rate, 0.0);
            });
            assert!((0..2).all(|p| t.get(p, 0) > 0.0 && t.get(p, 0).is_finite()), "{rate}");
        }
    }
}
