//! The control polygon: it begins on the path, is refined until its curve touches nothing, and relaxed where the curve is too tight.

use super::room::Room;
use super::spline::{At, Span, minus, mix, norm};

/// Edges of the control polygon that are no longer are not divided any more, in cells. Two edges to a corner are then shorter than half a
/// cell: the curve leaves the path within the corner's own cell alone, which is free.
const SHORTEST: f64 = 0.24;

/// Moves of a control point that are shorter are not made, in cells.
const STILL: f64 = 1e-3;

/// Most rounds of relaxation, and most parts of spans that are looked at in all of them.
const ROUNDS: u32 = 400;
const MOST_LOOKS: u64 = 3_000_000;

/// Curvatures that exceed the bound by this part meet it: what is left of rounding.
const SAME_CURVATURE: f64 = 1e-9;

/// A control point.
#[derive(Debug, Clone, Copy)]
struct Control {
    at: At,
    /// Where on the path it lies, in stretches from its beginning; none where it was moved away.
    along: Option<f64>,
    /// Whether it must stay.
    is_fixed: bool,
}

/// The control polygon of a curve, and how tight each span is.
#[derive(Debug, Clone)]
pub(super) struct Polygon<'a> {
    room: Room<'a>,
    controls: Vec<Control>,
    curvatures: Vec<f64>,
}

impl<'a> Polygon<'a> {
    /// On the path through these corners, two or more, none the same as the next. It comes through the cell of each corner for which
    /// `is_stop` says so.
    pub(super) fn on(corners: &[At], is_stop: impl Fn(usize) -> bool, room: Room<'a>) -> Self {
        let mut controls = Vec::new();
        let last = corners.len() - 1;
        for (k, &at) in corners.iter().enumerate() {
            let is_end = k == 0 || k == last;
            // Beside a stop two more are fixed: between the three the curve cannot leave the stop's cell.
            let is_stop = !is_end && is_stop(k);
            let beside = |other: usize| {
                let share = SHORTEST / norm(minus(corners[other], at));
                let along = k as f64 + if other > k { share } else { -share };
                Control { at: mix(at, corners[other], share), along: Some(along), is_fixed: true }
            };
            controls.extend(is_stop.then(|| beside(k - 1)));
            controls.push(Control { at, along: Some(k as f64), is_fixed: is_end || is_stop });
            controls.extend(is_stop.then(|| beside(k + 1)));
        }
        let mut polygon = Self { room, controls, curvatures: Vec::new() };
        while polygon.controls.len() < 4 {
            polygon.divide(|_| true);
        }
        polygon
    }

    /// How many spans it has.
    fn spans(&self) -> usize {
        self.controls.len() - 3
    }

    fn span(&self, s: usize) -> Span {
        Span::of(|i| self.controls[i].at, self.controls.len(), s)
    }

    /// Whether a span lies on one stretch of the path.
    fn is_on_path(&self, s: usize) -> bool {
        let ends = (self.controls[s].along, self.controls[s + 3].along);
        let all = self.controls[s..s + 4].iter().all(|c| c.along.is_some());
        matches!(ends, (Some(from), Some(to)) if all && libm::ceil(to) - libm::floor(from) <= 1.0)
    }

    /// Whether a span touches nothing. What lies on the path is as free as the path.
    fn is_free(&self, s: usize) -> bool {
        self.is_on_path(s) || self.room.holds(&self.span(s))
    }

    /// Puts a control point in the middle of each edge that is asked for and long enough; how many.
    fn divide(&mut self, is_asked: impl Fn(usize) -> bool) -> usize {
        let before = self.controls.len();
        let mut divided = Vec::with_capacity(2 * before);
        for (edge, &control) in self.controls.iter().enumerate() {
            divided.push(control);
            let Some(&next) = self.controls.get(edge + 1) else { break };
            if is_asked(edge) && norm(minus(next.at, control.at)) > SHORTEST {
                let along = control.along.zip(next.along).map(|(a, b)| 0.5 * (a + b));
                divided.push(Control { at: mix(control.at, next.at, 0.5), along, is_fixed: false });
            }
        }
        self.controls = divided;
        self.controls.len() - before
    }

    /// Divides the edges of all spans for which this holds; how many.
    fn divide_spans(&mut self, is_meant: &[bool]) -> usize {
        // Edge e carries the spans e − 2 to e.
        self.divide(|edge| is_meant[edge.saturating_sub(2).min(is_meant.len())..is_meant.len().min(edge + 1)].contains(&true))
    }

    /// Comes closer to the path until no span touches anything; whether that is so.
    pub(super) fn settle(&mut self) -> bool {
        loop {
            let touching: Vec<bool> = (0..self.spans()).map(|s| !self.is_free(s)).collect();
            if !touching.contains(&true) {
                self.measure();
                return true;
            }
            if self.divide_spans(&touching) == 0 {
                return false;
            }
        }
    }

    fn measure(&mut self) {
        self.curvatures = (0..self.spans()).map(|s| self.span(s).largest_curvature()).collect();
    }

    /// The largest curvature per cell; infinite where the curve turns straight back.
    pub(super) fn largest_curvature(&self) -> f64 {
        self.curvatures.iter().fold(0.0, |most, &c| f64::max(most, c))
    }

    /// Relaxes a settled polygon until no curvature is above this bound per cell, or nothing gets better; it never touches anything. The
    /// best it comes by is kept.
    pub(super) fn relax(&mut self, bound: f64) {
        let (mut best, mut looks) = (self.clone(), 0);
        for _ in 0..ROUNDS {
            if best.meets(bound) || looks > MOST_LOOKS {
                break;
            }
            looks += self.looks(bound);
            let moved = (1..self.controls.len() - 1).filter(|&i| self.is_tight_at(i, bound) && self.pull(i)).count();
            if moved == 0 && !self.loosen(bound) {
                break;
            }
            if self.largest_curvature() < best.largest_curvature() {
                best = self.clone();
            }
        }
        *self = best;
    }

    /// How many parts of spans are looked at when each control point of what is too tight moves once.
    fn looks(&self, bound: f64) -> u64 {
        let parts: Vec<u64> = (0..self.spans()).map(|s| self.span(s).parts().into()).collect();
        let tight = (1..self.controls.len() - 1).filter(|&i| self.is_tight_at(i, bound));
        tight.flat_map(|i| &parts[self.shaped_by(i)]).sum()
    }

    /// Whether no curvature is above a bound per cell.
    pub(super) fn meets(&self, bound: f64) -> bool {
        self.largest_curvature() <= bound * (1.0 + SAME_CURVATURE)
    }

    /// The spans that a control point shapes.
    fn shaped_by(&self, i: usize) -> std::ops::Range<usize> {
        i.saturating_sub(3)..self.spans().min(i + 1)
    }

    fn is_tight_at(&self, i: usize, bound: f64) -> bool {
        self.curvatures[self.shaped_by(i)].iter().any(|&c| c > bound)
    }

    /// Pulls a control point halfway to the middle of its neighbours, or less far where that would touch something; whether it moved.
    fn pull(&mut self, i: usize) -> bool {
        let before = self.controls[i];
        if before.is_fixed {
            return false;
        }
        let middle = mix(self.controls[i - 1].at, self.controls[i + 1].at, 0.5);
        let away = norm(minus(middle, before.at));
        for share in [0.5, 0.25, 0.125].into_iter().filter(|share| share * away >= STILL) {
            self.controls[i] = Control { at: mix(before.at, middle, share), along: None, is_fixed: false };
            if self.shaped_by(i).all(|s| self.is_free(s)) {
                self.shaped_by(i).for_each(|s| self.curvatures[s] = self.span(s).largest_curvature());
                return true;
            }
        }
        self.controls[i] = before;
        false
    }

    /// Gives spans that are too tight more control points, if the curve still touches nothing; whether it has more.
    fn loosen(&mut self, bound: f64) -> bool {
        let before = self.controls.clone();
        let tight: Vec<bool> = self.curvatures.iter().map(|&c| c > bound).collect();
        if self.divide_spans(&tight) > 0 && (0..self.spans()).all(|s| self.is_free(s)) {
            self.measure();
            return true;
        }
        self.controls = before;
        false
    }

    /// The curve: both ends of what lies on the path, and samples of the rest.
    pub(super) fn points(&self) -> Vec<At> {
        let mut points = vec![self.controls[0].at];
        for s in 0..self.spans() {
            let span = self.span(s);
            if self.is_on_path(s) {
                // A stretch that goes on has no joint.
                let goes_on = s + 1 < self.spans() && self.is_on_path(s + 1);
                points.extend((!goes_on).then(|| span.at(1.0)));
            } else {
                points.extend(span.samples());
            }
        }
        points
    }
}
