//! Clamped uniform cubic B-splines, span by span as Bézier curves.
//!
//! A spline of n control points has n − 3 spans, span s between the control points s to s + 3, each one unit of the parameter long; all knots
//! beside them lie on its two ends. The Bézier points of a span divide the edges of the control polygon as the knots divide the parameter
//! (Boehm 1980; Piegl and Tiller, The NURBS Book, 1997, section 5.3).

/// Column and row; the centre of a cell is at whole numbers.
pub(super) type At = [f64; 2];

/// Samples lie no farther apart, in cells.
const SAMPLE: f64 = 0.25;

/// Fewest samples of a span.
const FEWEST: u32 = 8;

/// Steps of the search between two samples for the largest curvature: each leaves two thirds of the interval.
const NARROWINGS: u32 = 24;

/// Sine of the angle below which a span is straight: what rounding leaves.
const STRAIGHT: f64 = 1e-12;

/// The point so far on the way from one point to another; exact at 0 and 1.
pub(super) fn mix(from: At, to: At, share: f64) -> At {
    [0, 1].map(|k| (1.0 - share) * from[k] + share * to[k])
}

pub(super) fn minus(a: At, b: At) -> At {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn cross(a: At, b: At) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: At, b: At) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn norm(a: At) -> f64 {
    libm::sqrt(dot(a, a))
}

/// One span, as the four Bézier points of its cubic.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span([At; 4]);

impl Span {
    /// Span `s` of the spline over `n` ≥ 4 control points.
    pub(super) fn of(control: impl Fn(usize) -> At, n: usize, s: usize) -> Self {
        // The length of a span in the parameter; spans are counted from 3, so that those before the first have numbers.
        let width = |s: usize| if (3..n).contains(&s) { 1.0 } else { 0.0 };
        // Edge e of the control polygon carries the spans e − 2, e − 1 and e: where on it the first `count` of them end.
        let on_edge = |e: usize, count: usize| {
            let widths = [width(e + 1), width(e + 2), width(e + 3)];
            let share = widths[..count].iter().sum::<f64>() / widths.iter().sum::<f64>();
            mix(control(e), control(e + 1), share)
        };
        let joint = |s: usize, before: At, after: At| mix(before, after, width(s - 1) / (width(s - 1) + width(s)));
        let (inner, next) = ([on_edge(s + 1, 1), on_edge(s + 1, 2)], on_edge(s + 2, 1));
        let first = joint(s + 3, on_edge(s, 2), inner[0]);
        Self([first, inner[0], inner[1], joint(s + 4, inner[1], next)])
    }

    /// Its point at 0 ≤ t ≤ 1.
    pub(super) fn at(&self, t: f64) -> At {
        let [a, b, c, d] = self.0;
        let u = 1.0 - t;
        [0, 1].map(|k| u * u * u * a[k] + 3.0 * u * u * t * b[k] + 3.0 * u * t * t * c[k] + t * t * t * d[k])
    }

    /// The edges between its Bézier points.
    fn edges(&self) -> [At; 3] {
        let [a, b, c, d] = self.0;
        [minus(b, a), minus(c, b), minus(d, c)]
    }

    /// First derivative at t.
    fn velocity(&self, t: f64) -> At {
        let ([a, b, c], u) = (self.edges(), 1.0 - t);
        [0, 1].map(|k| 3.0 * (u * u * a[k] + 2.0 * u * t * b[k] + t * t * c[k]))
    }

    /// Second derivative at t.
    fn acceleration(&self, t: f64) -> At {
        let [a, b, c] = self.edges();
        [0, 1].map(|k| 6.0 * ((1.0 - t) * (b[k] - a[k]) + t * (c[k] - b[k])))
    }

    /// In how many parts it is looked at and drawn: none is longer than [`SAMPLE`], for no derivative is above three times the longest edge.
    pub(super) fn parts(&self) -> u32 {
        let speed = 3.0 * self.edges().into_iter().map(norm).fold(0.0, f64::max);
        FEWEST.max(libm::ceil(speed / SAMPLE) as u32)
    }

    /// The ends of its parts, without the first.
    pub(super) fn samples(&self) -> impl Iterator<Item = At> + use<'_> {
        let parts = self.parts();
        (1..=parts).map(move |k| self.at(f64::from(k) / f64::from(parts)))
    }

    /// How far, in cells, the curve is at most from the straight line of any of its parts: its second derivative is linear, so that it is
    /// largest at an end, and a part of duration h lies within h²/8 times that of its chord.
    pub(super) fn sag(&self) -> f64 {
        let parts = f64::from(self.parts());
        norm(self.acceleration(0.0)).max(norm(self.acceleration(1.0))) / (8.0 * parts * parts)
    }

    /// |C′ × C″| / |C′|³ per cell at t.
    fn curvature(&self, t: f64) -> f64 {
        let (v, a) = (self.velocity(t), self.acceleration(t));
        let (turn, speed) = (cross(v, a).abs(), norm(v));
        if turn == 0.0 { 0.0 } else { turn / (speed * speed * speed) }
    }

    /// The largest curvature per cell: the largest of its samples, and then between their two neighbours. Infinite where it turns straight
    /// back.
    pub(super) fn largest_curvature(&self) -> f64 {
        let edges = self.edges();
        let is_straight = |&(a, b): &(At, At)| cross(a, b).abs() <= STRAIGHT * norm(a) * norm(b);
        let pairs = [(edges[0], edges[1]), (edges[1], edges[2]), (edges[0], edges[2])];
        if pairs.iter().all(is_straight) {
            let turns_back = pairs.iter().any(|&(a, b)| dot(a, b) < 0.0);
            return if turns_back { f64::INFINITY } else { 0.0 };
        }
        let parts = 2 * self.parts();
        let share = |k: u32| f64::from(k) / f64::from(parts);
        let sampled = (0..=parts).map(|k| (self.curvature(share(k)), k));
        let (most, at) = sampled.fold((-1.0, 0), |most, one| if one.0 > most.0 { one } else { most });
        let between = self.peak(share(at.saturating_sub(1)), share((at + 1).min(parts)));
        most.max(between)
    }

    /// The curvature of the peak between two parameters.
    fn peak(&self, mut low: f64, mut high: f64) -> f64 {
        for _ in 0..NARROWINGS {
            let third = (high - low) / 3.0;
            let (left, right) = (low + third, high - third);
            if self.curvature(left) < self.curvature(right) { low = left } else { high = right }
        }
        self.curvature(0.5 * (low + high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spans(controls: &[At]) -> Vec<Span> {
        (0..controls.len() - 3).map(|s| Span::of(|i| controls[i], controls.len(), s)).collect()
    }

    /// By the recursion of de Boor and Cox, which knows nothing of Bézier points.
    fn de_boor(controls: &[At], x: f64) -> At {
        let n = controls.len();
        let knot = |i: usize| (i as f64 - 3.0).clamp(0.0, n as f64 - 3.0);
        let span = (3 + x as usize).min(n - 1);
        let mut d: Vec<At> = (0..4).map(|j| controls[span - 3 + j]).collect();
        for r in 1..4 {
            for j in (r..4).rev() {
                let (low, high) = (knot(j + span - 3), knot(j + 1 + span - r));
                d[j] = mix(d[j - 1], d[j], (x - low) / (high - low));
            }
        }
        d[3]
    }

    const CONTROLS: [At; 7] = [[0.0, 0.0], [3.0, 0.0], [5.0, 4.0], [6.0, 1.0], [9.0, 2.5], [9.0, 7.0], [4.0, 8.0]];

    #[test]
    fn spans_agree_with_de_boor() {
        for n in 4..=CONTROLS.len() {
            for (s, span) in spans(&CONTROLS[..n]).iter().enumerate() {
                for k in 0..=10 {
                    let t = f64::from(k) / 10.0;
                    let away = norm(minus(span.at(t), de_boor(&CONTROLS[..n], s as f64 + t)));
                    assert!(away < 1e-12, "{n} control points, span {s}, {t}: {away}");
                }
            }
        }
    }

    #[test]
    fn the_ends_are_exact_and_curvature_goes_on_over_the_joints() {
        let spans = spans(&CONTROLS);
        assert_eq!((spans[0].at(0.0), spans[3].at(1.0)), (CONTROLS[0], CONTROLS[6]));
        for joint in spans.windows(2) {
            assert!(norm(minus(joint[0].at(1.0), joint[1].at(0.0))) < 1e-12);
            assert!((joint[0].curvature(1.0) - joint[1].curvature(0.0)).abs() < 1e-9);
        }
    }

    #[test]
    fn the_curvature_of_an_arc_is_one_over_its_radius() {
        // A quarter of a circle of radius 4 as a Bézier curve comes within 0.03 % of its radius, and within 2.5 % of its curvature.
        let (r, k) = (4.0, 4.0 * 0.552_284_749_830_793_6);
        let arc = Span([[r, 0.0], [r, k], [k, r], [0.0, r]]);
        for t in [0.0, 0.3, 0.5, 0.8, 1.0] {
            assert!((arc.curvature(t) * r - 1.0).abs() < 0.025, "{t}: {}", arc.curvature(t));
        }
        assert!((arc.largest_curvature() * r - 1.0).abs() < 0.025);
    }

    #[test]
    fn the_curvature_of_a_parabola_is_exact() {
        // (t, t²).
        let parabola = Span([[0.0, 0.0], [1.0 / 3.0, 0.0], [2.0 / 3.0, 1.0 / 3.0], [1.0, 1.0]]);
        for t in [0.0, 0.25, 1.0f64] {
            assert!((parabola.curvature(t) - 2.0 / libm::pow(1.0 + 4.0 * t * t, 1.5)).abs() < 1e-12);
        }
        assert!((parabola.largest_curvature() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn the_largest_curvature_is_no_less_than_any_sampled_one() {
        for span in spans(&CONTROLS) {
            let densest = (0..=20_000).map(|k| span.curvature(f64::from(k) / 20_000.0)).fold(0.0, f64::max);
            let largest = span.largest_curvature();
            assert!(largest >= densest * (1.0 - 1e-7) && largest <= densest * (1.0 + 1e-6), "{largest}, {densest}");
        }
    }

    #[test]
    fn straight_spans_have_none_and_those_that_turn_back_have_no_radius() {
        let line: Vec<At> = [0.0, 1.0, 3.0, 4.0].map(|x| [x, 2.0 * x]).into();
        assert_eq!(spans(&line)[0].largest_curvature(), 0.0);
        let back: Vec<At> = [0.0, 2.0, 1.0, 0.0].map(|x| [x, 2.0 * x]).into();
        assert_eq!(spans(&back)[0].largest_curvature(), f64::INFINITY);
    }

    #[test]
    fn no_part_is_farther_from_its_chord_than_its_sag() {
        for span in spans(&CONTROLS) {
            let (parts, sag) = (span.parts(), span.sag());
            for k in 0..parts {
                let ends = [k, k + 1].map(|k| span.at(f64::from(k) / f64::from(parts)));
                let chord = minus(ends[1], ends[0]);
                assert!(norm(chord) <= SAMPLE);
                for i in 1..10 {
                    let at = span.at((f64::from(k) + f64::from(i) / 10.0) / f64::from(parts));
                    let away = cross(chord, minus(at, ends[0])).abs() / norm(chord);
                    assert!(away <= sag, "{away} > {sag}");
                }
            }
        }
    }
}
