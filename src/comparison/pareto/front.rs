//! Points, which of them dominate which, and the box that hypervolumes are a part of.

use super::hypervolume::hypervolume;
use crate::comparison::measure::RunMeasure;

/// Part of the way from the best to the worst value by which the reference point is worse than the worst.
const MARGIN: f64 = 0.1;

/// A point as it is compared: less is better in each place; of two measures the third place is 0.
pub(super) type Point = [f64; 3];

/// Over which measures points stand.
pub(super) struct Space<'a> {
    measures: &'a [RunMeasure],
}

impl<'a> Space<'a> {
    pub(super) fn new(measures: &'a [RunMeasure]) -> Self {
        Self { measures }
    }

    /// The point of these values; none where one is unknown or infinite.
    pub(super) fn point(&self, value: impl Fn(RunMeasure) -> Option<f64>) -> Option<Point> {
        let mut point = [0.0; 3];
        for (place, &measure) in point.iter_mut().zip(self.measures) {
            *place = signed(measure, rounded(value(measure).filter(|v| v.is_finite())?));
        }
        Some(point)
    }

    /// A point in the measures' own units.
    pub(super) fn natural(&self, point: Point) -> Vec<f64> {
        self.measures.iter().zip(point).map(|(&measure, value)| signed(measure, value)).collect()
    }

    /// The box between the best value of each measure and the reference, given or worse than the worst value; none without points.
    pub(super) fn span(&self, points: impl Iterator<Item = Point> + Clone, given: Option<&[f64]>) -> Option<Span> {
        let all = |pick: fn(f64, f64) -> f64| points.clone().reduce(|a, b| std::array::from_fn(|i| pick(a[i], b[i])));
        let (best, worst) = (all(f64::min)?, all(f64::max)?);
        let place = |i: usize| match (self.measures.get(i), given) {
            (None, _) => 1.0,
            (Some(&measure), Some(given)) => given.get(i).map_or(worst[i], |&value| signed(measure, value)),
            (Some(_), None) => worst[i] + margin(best[i], worst[i]),
        };
        Some(Span { best, reference: std::array::from_fn(place) })
    }
}

/// How much worse than the worst value the reference is; where all values are one, a tenth of that value.
fn margin(best: f64, worst: f64) -> f64 {
    let range = if worst > best { worst - best } else { worst.abs() };
    MARGIN * if range > 0.0 { range } else { 1.0 }
}

/// Less is better.
fn signed(measure: RunMeasure, value: f64) -> f64 {
    // Not −0, which would be another point than 0.
    if measure.more_is_better() && value != 0.0 { -value } else { value }
}

/// To nine decimals. Large values have no more digits than that.
fn rounded(value: f64) -> f64 {
    if value.abs() < 1e6 { libm::round(value * 1e9) / 1e9 } else { value }
}

fn compare(a: &Point, b: &Point) -> std::cmp::Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
}

/// Every point once, ascending, with how often it is there.
pub(super) fn distinct(mut points: Vec<Point>) -> Vec<(Point, u32)> {
    points.sort_unstable_by(compare);
    let mut counted: Vec<(Point, u32)> = Vec::new();
    for point in points {
        match counted.last_mut() {
            Some((last, count)) if *last == point => *count += 1,
            _ => counted.push((point, 1)),
        }
    }
    counted
}

/// Whether a point is at least as good as another one in every place, and better in one.
pub(super) fn dominates(a: &Point, b: &Point) -> bool {
    a != b && a.iter().zip(b).all(|(a, b)| a <= b)
}

/// The points that no other one dominates, of distinct ones in ascending order: then only a point before another one can dominate it.
pub(super) fn undominated(ascending: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut front: Vec<Point> = Vec::new();
    for point in ascending {
        if !front.iter().any(|better| dominates(better, &point)) {
            front.push(point);
        }
    }
    front
}

/// The box of which hypervolumes are a part.
pub(super) struct Span {
    pub(super) best: Point,
    pub(super) reference: Point,
}

impl Span {
    /// The part of the box that a front dominates; none where the box has no extent.
    pub(super) fn hypervolume(&self, front: &[Point]) -> Option<f64> {
        let has_extent = (0..3).all(|i| self.reference[i] > self.best[i]);
        let part = |point: &Point| std::array::from_fn(|i| (point[i] - self.best[i]) / (self.reference[i] - self.best[i]));
        has_extent.then(|| hypervolume(front.iter().map(part).collect()))
    }

    /// How many points are not better than the reference in every measure.
    pub(super) fn beyond(&self, front: &[Point]) -> usize {
        front.iter().filter(|point| (0..3).any(|i| point[i] >= self.reference[i])).count()
    }
}
