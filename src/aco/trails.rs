//! Pheromone: one trail τ per cell and direction, with lazy evaporation.
//!
//! Evaporation multiplies every trail by the same factor, and selection compares the trails of one cell only; so the factor is kept
//! once, as `scale`, and τ = stored · scale. A deposit is divided by the scale when it is stored. That is the definition (not a sweep over
//! all trails, which rounds differently): an iteration touches the cells where ants have been, not the whole map.

use crate::map::{Cell, DIRECTIONS, Direction, MoveSet};
use crate::planner::held;

/// Values by cell and direction.
pub type Row = [f32; DIRECTIONS];

/// Stored trails never fall below this, so that τ stays positive however long it evaporates.
const FLOOR: f32 = 1e-30;
/// Largest stored trail that a limit may ask for.
const CEILING: f32 = 1e30;
/// Below this scale the stored values are brought back to size in one sweep.
const SWEEP_BELOW: f64 = 1e-9;

/// Of a cell: it has trails of its own.
const ACTIVE: u8 = 1;
/// Of a cell: its trails have changed since the weights were last computed.
const DIRTY: u8 = 2;

/// The trails of one colony.
#[derive(Debug, Clone)]
pub struct Trails {
    stored: Vec<Row>,
    scale: f64,
    /// What is known of a cell: [`ACTIVE`], [`DIRTY`].
    state: Vec<u8>,
    /// The dirty cells.
    touched: Vec<Cell>,
    /// Everything has changed.
    all_dirty: bool,
    /// Cells whose trails no longer are the common background, in the order of their first deposit.
    active: Vec<Cell>,
    /// Stored value of every step of a cell that is not active; what `stored` has there may be outdated.
    background: f32,
}

impl Trails {
    /// The same trail everywhere.
    #[inline(never)]
    pub fn new(cells: usize, initial: f64) -> Self {
        Self {
            stored: vec![Row::default(); cells],
            scale: 1.0,
            state: vec![0; cells],
            touched: Vec::new(),
            all_dirty: true,
            active: Vec::new(),
            background: initial as f32,
        }
    }

    /// Forgets everything: the same trail everywhere.
    pub fn reset(&mut self, initial: f64) {
        *self = Self::new(self.stored.len(), initial);
    }

    /// τ of a step.
    pub fn get(&self, c: Cell, d: Direction) -> f64 {
        f64::from(self.relative(c)[d as usize]) * self.scale
    }

    /// The largest τ of the steps from a cell.
    pub fn strongest(&self, c: Cell) -> f32 {
        let stored = self.relative(c).iter().fold(0.0f32, |m, &t| if t > m { t } else { m });
        (f64::from(stored) * self.scale) as f32
    }

    /// [`Trails::strongest`] of every cell. Costs as much as ants have deposited around: all other cells share one value.
    pub fn strongest_of_all(&self, out: &mut [f32]) {
        out.fill((f64::from(self.background.max(0.0)) * self.scale) as f32);
        self.active.iter().for_each(|&c| out[c as usize] = self.strongest(c));
    }

    /// τ / scale of all steps from a cell: enough to compare them.
    pub fn relative(&self, c: Cell) -> Row {
        if self.state[c as usize] & ACTIVE != 0 { self.stored[c as usize] } else { [self.background; DIRECTIONS] }
    }

    /// The same where ants leave trails as they walk: a cell without any of its own gets a row.
    #[inline(always)]
    pub(super) fn here(&mut self, c: Cell) -> &Row {
        self.touch(c);
        &self.stored[c as usize]
    }

    /// τ ← (1 − ρ)·τ everywhere; ρ is the part that leaves.
    pub fn evaporate(&mut self, rho: f64) {
        self.scale *= 1.0 - rho;
        if self.scale < SWEEP_BELOW {
            self.sweep();
        }
    }

    /// τ ← τ + amount on one step.
    #[inline]
    pub fn deposit(&mut self, c: Cell, d: Direction, amount: f64) {
        self.touch(c);
        self.stored[c as usize][d as usize] += (amount / self.scale) as f32;
    }

    /// The same on every step of a way from a cell.
    pub fn deposit_along(&mut self, moves: &MoveSet, from: Cell, steps: &[Direction], amount: f64) {
        let amount = (amount / self.scale) as f32;
        let mut at = from;
        for &d in steps {
            self.touch(at);
            self.stored[at as usize][d as usize % DIRECTIONS] += amount;
            at = moves.step(at, d);
        }
    }

    /// τ ← τ − amount on one step, but not below `floor`, nor below τ where that is smaller already.
    #[inline]
    pub fn withdraw(&mut self, c: Cell, d: Direction, amount: f64, floor: f64) {
        self.touch(c);
        let t = &mut self.stored[c as usize][d as usize];
        *t = (*t - (amount / self.scale) as f32).max(t.min((floor / self.scale) as f32)).max(FLOOR);
    }

    /// τ ← τ + amount on every step of the map, kept above 0; the amount may be negative. One sweep over the cells with trails of their own.
    #[inline(never)]
    pub fn shift(&mut self, amount: f64) {
        let amount = (amount / self.scale) as f32;
        for &c in &self.active {
            self.stored[c as usize].iter_mut().for_each(|t| *t = (*t + amount).max(FLOOR));
        }
        self.background = (self.background + amount).max(FLOOR);
        self.all_dirty = true;
    }

    /// τ ← (1 − rate)·τ + rate·target on one step: the local and the global update of Ant Colony System.
    #[inline]
    pub fn blend(&mut self, c: Cell, d: Direction, rate: f64, target: f64) {
        self.touch(c);
        let t = &mut self.stored[c as usize][d as usize];
        *t = (f64::from(*t) * (1.0 - rate) + rate * target / self.scale).max(f64::from(FLOOR)) as f32;
    }

    /// min ≤ τ ≤ max everywhere; where both cannot be, max gives way. Costs as much as ants have deposited around: all other cells share
    /// one value, and as selection compares the steps of one cell only, their weights need not follow it.
    #[expect(clippy::manual_clamp, reason = "clamp would keep NaN")]
    #[inline(never)]
    pub fn limit(&mut self, min: f64, max: f64) {
        let low = ((min / self.scale) as f32).max(FLOOR).min(CEILING);
        let high = ((max / self.scale) as f32).max(low).min(CEILING);
        self.background = self.background.clamp(low, high);
        for i in 0..self.active.len() {
            let c = self.active[i];
            let limited = self.stored[c as usize].map(|t| t.clamp(low, high));
            if limited != self.stored[c as usize] {
                self.touch(c);
                self.stored[c as usize] = limited;
            }
        }
    }

    /// Before the trails of a cell change.
    #[inline(always)]
    fn touch(&mut self, c: Cell) {
        if self.state[c as usize] != ACTIVE | DIRTY {
            self.touch_first(c);
        }
    }

    /// The first change since the weights were computed; of all, from here on a cell has trails of its own, which begin as the background.
    #[inline(never)]
    fn touch_first(&mut self, c: Cell) {
        let state = std::mem::replace(&mut self.state[c as usize], ACTIVE | DIRTY);
        if state & DIRTY == 0 {
            self.touched.push(c);
        }
        if state & ACTIVE == 0 {
            self.active.push(c);
            self.stored[c as usize] = [self.background; DIRECTIONS];
        }
    }

    /// The weights of a cell are to be computed anew, because its η or its steps have changed; its trails stay.
    #[cfg(feature = "whole")]
    pub fn look_again(&mut self, c: Cell) {
        self.touch(c);
    }

    /// What it holds, in bytes.
    pub fn bytes(&self) -> usize {
        held(&self.stored) + held(&self.state) + held(&self.touched) + held(&self.active)
    }

    /// Every weight is to be computed anew, because η has changed.
    pub fn all_changed(&mut self) {
        self.all_dirty = true;
    }

    /// Writes the scale into the stored values. With ρ = 1 it is 0, and the floor is all that remains.
    #[inline(never)]
    fn sweep(&mut self) {
        let scale = self.scale as f32;
        for &c in &self.active {
            self.stored[c as usize].iter_mut().for_each(|t| *t = (*t * scale).max(FLOOR));
        }
        self.background = (self.background * scale).max(FLOOR);
        self.scale = 1.0;
        self.all_dirty = true;
    }

    /// Calls `refresh` for every cell that has changed since the last call; where everything has, for these.
    pub fn take_changes(&mut self, all: impl Iterator<Item = Cell>, mut refresh: impl FnMut(&Row, Cell)) {
        if std::mem::take(&mut self.all_dirty) {
            all.for_each(|c| refresh(&self.relative(c), c));
        } else {
            self.touched.iter().for_each(|&c| refresh(&self.stored[c as usize], c));
        }
        self.touched.iter().for_each(|&c| self.state[c as usize] &= !DIRTY);
        self.touched.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn evaporation_and_deposit_by_hand() {
        let mut t = Trails::new(2, 1.0);
        t.evaporate(0.5);
        t.deposit(1, 3, 0.25);
        assert_eq!(t.get(0, 3), 0.5);
        assert_eq!(t.get(1, 3), 0.75);
        let mut seen = Vec::new();
        t.take_changes(0..2, |_, c| seen.push(c));
        assert_eq!(seen, [0, 1]);
        t.deposit(1, 3, 0.25);
        t.deposit(1, 0, 0.25);
        seen.clear();
        t.take_changes(0..2, |_, c| seen.push(c));
        assert_eq!(seen, [1]);
    }

    #[test]
    fn limits_that_cannot_be_are_mended() {
        for (min, max) in [(1.0, 0.5), (f64::NAN, 1.0), (0.1, f64::NAN), (1e300, 1e301), (0.0, 0.0)] {
            let mut t = Trails::new(2, 1.0);
            t.deposit(0, 0, 1.0);
            t.limit(min, max);
            for c in 0..2 {
                assert!(t.get(c, 0) > 0.0 && t.get(c, 0).is_finite(), "{min} {max}: {}", t.get(c, 0));
            }
        }
    }

    #[test]
    fn limits_hold_everywhere_as_by_a_sweep() {
        let mut t = Trails::new(9, 1.0);
        let mut swept = [[1.0f64; DIRECTIONS]; 9];
        for i in 0..200u32 {
            let (c, d) = (i * 7 % 4, (i % 8) as Direction);
            t.evaporate(0.1);
            t.deposit(c, d, 0.3);
            t.limit(0.05, 0.9);
            swept.iter_mut().flatten().for_each(|v| *v *= 0.9);
            swept[c as usize][d as usize] += 0.3;
            swept.iter_mut().flatten().for_each(|v| *v = v.clamp(0.05, 0.9));
            for c in 0..9 {
                for d in 0..8 {
                    assert!((t.get(c, d) - swept[c as usize][d as usize]).abs() < 1e-5, "iteration {i}, cell {c}, direction {d}");
                }
            }
            let mut all = [0.0; 9];
            t.strongest_of_all(&mut all);
            assert_eq!(all, std::array::from_fn(|c| t.strongest(c as Cell)), "iteration {i}");
        }
    }

    #[test]
    fn withdrawing_and_shifting_by_hand() {
        let mut t = Trails::new(2, 1.0);
        t.evaporate(0.5);
        t.withdraw(0, 1, 0.125, 0.25);
        t.withdraw(0, 2, 0.5, 0.25);
        t.withdraw(0, 3, 0.5, 0.75);
        assert_eq!([0, 1, 2, 3].map(|d| t.get(0, d)), [0.5, 0.375, 0.25, 0.5]);
        t.shift(0.125);
        assert_eq!((t.get(0, 1), t.get(1, 7)), (0.5, 0.625));
        t.shift(-9.0);
        assert!(t.get(1, 7) > 0.0);
    }

    #[test]
    fn blending_by_hand() {
        let mut t = Trails::new(1, 1.0);
        t.blend(0, 2, 0.1, 0.5);
        assert!((t.get(0, 2) - 0.95).abs() < 1e-7);
        assert_eq!(t.get(0, 3), 1.0);
    }

    #[test]
    fn trails_stay_positive_and_finite_under_any_evaporation() {
        for rho in [0.0, 1e-3, 0.5, 0.999, 1.0] {
            let mut t = Trails::new(1, 1.0);
            for _ in 0..5000 {
                t.evaporate(rho);
                t.deposit(0, 0, 1.0);
                for d in 0..8 {
                    let v = t.get(0, d);
                    assert!(v > 0.0 && v.is_finite(), "rho {rho}: {v}");
                }
            }
        }
    }
}
