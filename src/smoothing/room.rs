//! Where a curve may lead: through free cells, past corners by the scenario's rule, over no ground that is too steep.

use super::spline::{At, Span, cross, minus, mix, norm};
use crate::map::{CornerRule, Grid, Moves, Relief};
use crate::scenario::Scenario;

/// In cells: what comes so near to a cell touches it.
pub(super) const TOUCH: f64 = 1e-9;

/// Longest part of a line whose two ends tell what its ground is like, in cells.
const ON_GROUND: f64 = 0.25;

/// The map of a scenario, for curves.
#[derive(Debug, Clone, Copy)]
pub(super) struct Room<'a> {
    grid: &'a Grid,
    rule: CornerRule,
    relief: Option<&'a Relief>,
}

impl<'a> Room<'a> {
    pub(super) fn new(scenario: &'a Scenario) -> Self {
        let movement = scenario.spec.movement;
        // With 4 moves no corner is passed at all.
        let rule = if movement.moves == Moves::Four { CornerRule::BothFree } else { movement.corner_rule };
        Self { grid: &scenario.grid, rule, relief: scenario.moves.relief() }
    }

    /// Whether a whole span is free: every cell that comes within its sag of one of its chords, and the ground below.
    pub(super) fn holds(&self, span: &Span) -> bool {
        let (sag, mut from) = (span.sag(), span.at(0.0));
        span.samples().all(|to| {
            let part = [from, to];
            from = to;
            self.is_free(part, sag) && self.is_walkable(part)
        })
    }

    /// Whether a straight line comes into no blocked cell; cells reach `wider` beyond their sides.
    fn is_free(&self, [from, to]: [At; 2], wider: f64) -> bool {
        let reach = 0.5 + wider + TOUCH;
        let cells = |k: usize| {
            let (low, high) = (from[k].min(to[k]), from[k].max(to[k]));
            libm::ceil(low - reach) as i64..=libm::floor(high + reach) as i64
        };
        let blocked = |x: i64, y: i64| !self.grid.is_free_at(x, y) && touches([from, to], (x, y), 0.5 + wider + self.edge(x, y));
        !cells(1).any(|y| cells(0).any(|x| blocked(x, y)))
    }

    /// By how much a blocked cell reaches beyond its sides, or less than nothing where its sides may be touched.
    fn edge(&self, x: i64, y: i64) -> f64 {
        let blocked = |x, y| !self.grid.is_free_at(x, y);
        // Two blocked cells that meet at a corner, with free ones beside it.
        let is_pinch = |&(dx, dy): &(i64, i64)| blocked(x + dx, y + dy) && !blocked(x + dx, y) && !blocked(x, y + dy);
        let may_touch = match self.rule {
            CornerRule::Always => true,
            CornerRule::OneFree => ![(-1, -1), (1, -1), (-1, 1), (1, 1)].iter().any(is_pinch),
            CornerRule::BothFree => false,
        };
        if may_touch { -TOUCH } else { TOUCH }
    }

    /// Whether the ground below a straight line is not too steep.
    fn is_walkable(&self, [from, to]: [At; 2]) -> bool {
        let Some(relief) = self.relief.filter(|relief| relief.steepest().is_finite()) else { return true };
        let rise = self.height(relief, to) - self.height(relief, from);
        rise.abs() <= relief.steepest() * norm(minus(to, from)) * (1.0 + TOUCH)
    }

    /// Length of a straight line in cells; on a terrain along its ground.
    pub(super) fn length(&self, from: At, to: At) -> f64 {
        let run = norm(minus(to, from));
        let Some(relief) = self.relief else { return run };
        let parts = libm::ceil(run / ON_GROUND).max(1.0) as u32;
        let (mut length, mut before) = (0.0, self.height(relief, from));
        for k in 1..=parts {
            let here = self.height(relief, mix(from, to, f64::from(k) / f64::from(parts)));
            let (run, rise) = (run / f64::from(parts), here - before);
            length += libm::sqrt(run * run + rise * rise);
            before = here;
        }
        length
    }

    /// Height of the ground in cells: bilinear between the centres of the four cells around, as far as their heights are known.
    pub(super) fn height(&self, relief: &Relief, [x, y]: At) -> f64 {
        let (left, up) = (libm::floor(x), libm::floor(y));
        let (right_share, down_share) = (x - left, y - up);
        let (mut sum, mut known) = (0.0, 0.0);
        for (dy, share_y) in [(0, 1.0 - down_share), (1, down_share)] {
            for (dx, share_x) in [(0, 1.0 - right_share), (1, right_share)] {
                let (column, row, share) = (left as i64 + dx, up as i64 + dy, share_x * share_y);
                let inside =
                    (0..i64::from(self.grid.width())).contains(&column) && (0..i64::from(self.grid.height())).contains(&row);
                if !inside || share == 0.0 {
                    continue;
                }
                let height = relief.height((row * i64::from(self.grid.width()) + column) as u32);
                if !height.is_nan() {
                    sum += share * height;
                    known += share;
                }
            }
        }
        if known > 0.0 { sum / known } else { 0.0 }
    }
}

/// Whether a straight line comes within the square of this half side about a cell's centre: unless they lie apart along an axis, or all of
/// the square lies on one side of the line.
fn touches([from, to]: [At; 2], (x, y): (i64, i64), half: f64) -> bool {
    let centre = [x as f64, y as f64];
    let (d, c) = (minus(to, from), minus(centre, from));
    let apart = |k: usize| from[k].max(to[k]) < centre[k] - half || from[k].min(to[k]) > centre[k] + half;
    !apart(0) && !apart(1) && cross(d, c).abs() <= half * (d[0].abs() + d[1].abs())
}
