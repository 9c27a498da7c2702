//! The hypervolume of a set of points: how much of the unit box at least one of them dominates (Zitzler and Thiele 1999). Exact, by a sweep:
//! along the third axis, between one point's value and the next, the part of the plane that the points so far dominate stays the same, and
//! that part is the area below a staircase. (The sweep over dimensions of Fonseca, Paquete and López-Ibáñez 2006, without its tree: n² for n
//! points. While, Bradstreet and Barone 2012 compare exact algorithms for more measures than three.)
//!
//! Sums have one order, that of the sorted points.

use super::front::Point;

/// Part of the unit box, whose worst corner is (1, 1, 1), that points dominate; less is better. Points outside it add nothing.
pub(super) fn hypervolume(mut points: Vec<Point>) -> f64 {
    points.retain(|point| point.iter().all(|&place| place < 1.0));
    points.sort_unstable_by(|a, b| a[2].total_cmp(&b[2]).then(a[0].total_cmp(&b[0])).then(a[1].total_cmp(&b[1])));
    let mut stairs = Staircase::default();
    let mut volume = 0.0;
    for (index, point) in points.iter().enumerate() {
        stairs.add(point[0], point[1]);
        let next = points.get(index + 1).map_or(1.0, |next| next[2]);
        if next > point[2] {
            volume += stairs.area() * (next - point[2]);
        }
    }
    volume
}

/// Points of a plane of which none dominates another: x ascending, y descending.
#[derive(Default)]
struct Staircase {
    steps: Vec<(f64, f64)>,
}

impl Staircase {
    /// Takes in a point, and lets go of those that it dominates.
    fn add(&mut self, x: f64, y: f64) {
        let at = self.steps.partition_point(|step| step.0 < x);
        let is_dominated = self.steps[..at].last().is_some_and(|left| left.1 <= y)
            || self.steps.get(at).is_some_and(|here| here.0 <= x && here.1 <= y);
        if is_dominated {
            return;
        }
        let end = at + self.steps[at..].iter().take_while(|step| step.1 >= y).count();
        self.steps.splice(at..end, [(x, y)]);
    }

    /// What the points dominate of the unit square.
    fn area(&self) -> f64 {
        let mut ceiling = 1.0;
        let mut area = 0.0;
        for &(x, y) in &self.steps {
            area += (1.0 - x) * (ceiling - y);
            ceiling = y;
        }
        area
    }
}

#[cfg(test)]
mod tests {
    use rand::RngExt;

    use super::*;
    use crate::rng::{Stream, Streams};

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance
    }

    fn stream(number: u32) -> Stream {
        Streams::new(1, "hypervolume", number).daemon(1)
    }

    fn draw(stream: &mut Stream, count: usize, places: usize) -> Vec<Point> {
        (0..count).map(|_| std::array::from_fn(|i| if i < places { stream.random::<f64>() } else { 0.0 })).collect()
    }

    #[test]
    fn by_hand() {
        assert_eq!(hypervolume(Vec::new()), 0.0);
        assert_eq!(hypervolume(vec![[0.0, 0.0, 0.0]]), 1.0);
        assert!(near(hypervolume(vec![[0.5, 0.25, 0.0]]), 0.375, 1e-15));
        // Two steps: 0.75 · 0.25 + 0.5 · 0.5.
        assert!(near(hypervolume(vec![[0.5, 0.25, 0.0], [0.25, 0.75, 0.0]]), 0.4375, 1e-15));
        // A dominated point, an equal one and one outside add nothing.
        let more = vec![[0.5, 0.25, 0.0], [0.5, 0.25, 0.0], [0.6, 0.3, 0.0], [0.25, 0.75, 0.0], [0.0, 1.0, 0.0], [1.2, 0.0, 0.0]];
        assert!(near(hypervolume(more), 0.4375, 1e-15));
        // Two cubes of ½ that share one of ¼·½·¼… by inclusion and exclusion.
        let two = vec![[0.5, 0.0, 0.5], [0.0, 0.5, 0.75]];
        assert!(near(hypervolume(two), 0.25 + 0.125 - 0.5 * 0.5 * 0.25, 1e-15));
    }

    #[test]
    fn agrees_with_monte_carlo_in_two_and_three_measures() {
        const DRAWS: usize = 40_000;
        for (number, places) in [(1, 2), (2, 3), (3, 3)] {
            let mut stream = stream(number);
            let points = draw(&mut stream, 12, places);
            let exact = hypervolume(points.clone());
            let hits =
                draw(&mut stream, DRAWS, places).iter().filter(|at| points.iter().any(|p| (0..3).all(|i| p[i] <= at[i]))).count();
            // Four standard errors are at most 0.01.
            assert!(near(exact, hits as f64 / DRAWS as f64, 0.01), "{places}: {exact}, {hits}");
        }
    }

    #[test]
    fn agrees_with_inclusion_and_exclusion() {
        for number in 10..40 {
            let points = draw(&mut stream(number), 6, 3);
            let corner = |subset: u32| {
                let chosen = (0..6).filter(|i| subset >> i & 1 == 1).map(|i| points[i]);
                chosen.reduce(|a, b| std::array::from_fn(|k| f64::max(a[k], b[k]))).expect("not empty")
            };
            let volume = |point: Point| point.iter().map(|place| 1.0 - place).product::<f64>();
            let sign = |subset: u32| if subset.count_ones() % 2 == 1 { 1.0 } else { -1.0 };
            let expected: f64 = (1..1u32 << 6).map(|subset| sign(subset) * volume(corner(subset))).sum();
            assert!(near(hypervolume(points), expected, 1e-12), "{number}");
        }
    }

    #[test]
    fn the_order_of_the_points_changes_no_bit() {
        let points = draw(&mut stream(50), 30, 3);
        let mut turned = points.clone();
        turned.reverse();
        assert_eq!(hypervolume(points).to_bits(), hypervolume(turned).to_bits());
    }
}
