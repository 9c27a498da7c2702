//! Contour lines of a terrain: marching squares on the lattice of the cells' centres (Lorensen and Cline 1987, in two dimensions).
//!
//! A square with a corner that has no data has no line. Where two opposite corners stand above a level and two below, the mean of the
//! four decides which of them are joined. The lines are chained, so that they can be drawn and labelled as wholes; same heights, same
//! lines, in the same order.

/// Most lines of different height on a map.
pub const MOST_LEVELS: f64 = 15.0;

/// Larger maps are followed at every so-manyth cell only: a screen shows no more.
const MOST_SIDE: u32 = 1024;

const NONE: u32 = u32::MAX;

/// The contour lines of a map.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Contours {
    /// Metres between a line and the next: 1, 2 or 5 times a power of ten, such that there are at most [`MOST_LEVELS`]. 0 on level ground.
    pub interval: f64,
    /// From the lowest to the highest, each as its cells come row by row.
    pub lines: Vec<ContourLine>,
}

/// One line of equal height.
#[derive(Debug, Clone, PartialEq)]
pub struct ContourLine {
    /// Its height in intervals: every fifth is a main line.
    pub level: i32,
    /// x, y in cells from the upper left corner of the map, a cell's centre at its index + 0.5. A closed line ends where it began.
    pub points: Vec<[f32; 2]>,
}

impl Contours {
    /// Of heights row by row, `unit` metres each; what is not finite has no data.
    pub fn of(heights: &[f32], width: u32, unit: f64) -> Self {
        let field = Field::sampled(heights, width, unit);
        let finite = || field.metres.iter().filter(|h| h.is_finite());
        let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
        let interval = interval(high - low);
        if interval <= 0.0 {
            return Self::default();
        }
        let levels = libm::ceil(low / interval) as i32..=libm::floor(high / interval) as i32;
        let mut tracer = Tracer::new(&field);
        Self { interval, lines: levels.flat_map(|level| tracer.lines(level, f64::from(level) * interval)).collect() }
    }
}

/// The smallest of 1, 2, 5, 10, … and 0.5, 0.2, … that cuts a span into at most [`MOST_LEVELS`]; 0 when there is nothing to cut.
pub fn interval(span: f64) -> f64 {
    if !(span > 0.0 && span.is_finite()) {
        return 0.0;
    }
    let least = span / MOST_LEVELS;
    let power = libm::pow(10.0, libm::floor(libm::log10(least)));
    [1.0, 2.0, 5.0].map(|step| step * power).into_iter().find(|&step| step >= least).unwrap_or(10.0 * power)
}

/// Heights in metres on a lattice of every `stride`-th cell.
struct Field {
    metres: Vec<f64>,
    width: usize,
    height: usize,
    stride: f32,
}

impl Field {
    fn sampled(heights: &[f32], width: u32, unit: f64) -> Self {
        let (width, height) = (width.max(1), heights.len() as u32 / width.max(1));
        let stride = width.max(height).div_ceil(MOST_SIDE) as usize;
        let rows = (0..height as usize).step_by(stride).map(|y| &heights[y * width as usize..][..width as usize]);
        let metres: Vec<f64> = rows.flat_map(|row| row.iter().step_by(stride)).map(|&h| f64::from(h) * unit).collect();
        let width = (width as usize).div_ceil(stride);
        Self { height: metres.len() / width, width, metres, stride: stride as f32 }
    }

    /// Where a level crosses an edge: `2·c` leads from place c to the next in its row, `2·c + 1` to the next in its column.
    fn crossing(&self, edge: u32, level: f64) -> [f32; 2] {
        let (from, down) = ((edge / 2) as usize, edge % 2 == 1);
        let (a, b) = (self.metres[from], self.metres[from + if down { self.width } else { 1 }]);
        let part = ((level - a) / (b - a)) as f32;
        let (x, y) = ((from % self.width) as f32, (from / self.width) as f32);
        let (x, y) = if down { (x, y + part) } else { (x + part, y) };
        [x * self.stride + 0.5, y * self.stride + 0.5]
    }
}

/// Chains the segments of one level after the other; its buffers are kept clean in between.
struct Tracer<'a> {
    field: &'a Field,
    /// For each edge the edges it is joined with by a segment: none, one, or one on either side.
    joined: Vec<[u32; 2]>,
    /// Edges with a segment, in the order in which they were met.
    met: Vec<u32>,
}

impl<'a> Tracer<'a> {
    fn new(field: &'a Field) -> Self {
        Self { field, joined: vec![[NONE; 2]; 2 * field.metres.len()], met: Vec::new() }
    }

    fn lines(&mut self, level: i32, metres: f64) -> Vec<ContourLine> {
        for y in 0..self.field.height.saturating_sub(1) {
            for x in 0..self.field.width - 1 {
                self.square(y * self.field.width + x, metres);
            }
        }
        let met = std::mem::take(&mut self.met);
        // Lines that end at the border or at a hole first, so that none is begun in its middle.
        let ends = met.iter().filter(|&&edge| self.joined[edge as usize][1] == NONE).copied().collect::<Vec<_>>();
        let starts = ends.into_iter().chain(met.iter().copied());
        let lines = starts.filter_map(|edge| self.follow(edge, metres)).map(|points| ContourLine { level, points }).collect();
        self.met = met;
        self.met.clear();
        lines
    }

    /// The segments of the square below and right of place `c`.
    fn square(&mut self, c: usize, level: f64) {
        let (m, w) = (&self.field.metres, self.field.width);
        let corners = [m[c], m[c + 1], m[c + w + 1], m[c + w]];
        let sum: f64 = corners.iter().sum();
        if sum.is_nan() {
            return;
        }
        let above = corners.iter().rev().fold(0, |bits, &h| bits << 1 | u8::from(h >= level));
        let (c, w) = (c as u32, w as u32);
        let (top, right, bottom, left) = (2 * c, 2 * (c + 1) + 1, 2 * (c + w), 2 * c + 1);
        let middle_above = sum / 4.0 >= level;
        match above {
            0 | 15 => {}
            1 | 14 => self.join(left, top),
            2 | 13 => self.join(top, right),
            3 | 12 => self.join(left, right),
            4 | 11 => self.join(right, bottom),
            6 | 9 => self.join(top, bottom),
            7 | 8 => self.join(left, bottom),
            _ if (above == 5) == middle_above => {
                self.join(top, right);
                self.join(left, bottom);
            }
            _ => {
                self.join(left, top);
                self.join(right, bottom);
            }
        }
    }

    fn join(&mut self, a: u32, b: u32) {
        for (from, to) in [(a, b), (b, a)] {
            let links = &mut self.joined[from as usize];
            if links[0] == NONE {
                links[0] = to;
                self.met.push(from);
            } else {
                links[1] = to;
            }
        }
    }

    /// The line through an edge, taken off the buffers; none when it has been taken already.
    fn follow(&mut self, start: u32, level: f64) -> Option<Vec<[f32; 2]>> {
        let mut points = vec![self.field.crossing(start, level)];
        let (mut before, mut here) = (NONE, start);
        loop {
            let links = std::mem::replace(&mut self.joined[here as usize], [NONE; 2]);
            let next = if links[0] == before { links[1] } else { links[0] };
            if next == NONE {
                break;
            }
            points.push(self.field.crossing(next, level));
            (before, here) = (here, next);
            if here == start {
                break;
            }
        }
        (points.len() > 1).then_some(points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_one_two_or_five_and_give_at_most_fifteen_lines() {
        assert_eq!([interval(100.0), interval(150.0), interval(151.0), interval(400.0)], [10.0, 10.0, 20.0, 50.0]);
        assert_eq!([interval(15.0), interval(3.0), interval(0.0), interval(f64::NEG_INFINITY)], [1.0, 0.2, 0.0, 0.0]);
    }

    #[test]
    fn a_peak_has_diamonds_around_it() {
        let mut heights = [0.0f32; 9];
        heights[4] = 30.0;
        let Contours { interval, lines } = Contours::of(&heights, 3, 0.5);
        // 15 m: levels 1 to 15, one closed line each; level 0 lies nowhere above the ground.
        assert_eq!((interval, lines.len()), (1.0, 15));
        let third = &lines[2];
        assert_eq!(third.level, 3);
        // A fifth of the way from the rim (0.5) to the middle (1.5).
        let around = [[1.5, 0.7], [0.7, 1.5], [1.5, 2.3], [2.3, 1.5], [1.5, 0.7]];
        for (got, want) in third.points.iter().zip(around) {
            assert!((got[0] - want[0]).abs() < 1e-6 && (got[1] - want[1]).abs() < 1e-6, "{:?}", third.points);
        }
        assert_eq!(third.points.len(), 5);
    }

    #[test]
    fn a_slope_has_straight_lines_from_border_to_border_and_stops_at_holes() {
        let mut heights: Vec<f32> = (0..20).map(|c| (c % 5) as f32).collect();
        let whole = Contours::of(&heights, 5, 1.0);
        assert_eq!((whole.interval, whole.lines.len()), (0.5, 8));
        let line = &whole.lines[2];
        assert_eq!((line.level, &line.points[..]), (3, &[[2.0, 0.5], [2.0, 1.5], [2.0, 2.5], [2.0, 3.5]][..]));
        heights[7] = f32::NAN;
        let holed = Contours::of(&heights, 5, 1.0);
        let third: Vec<_> = holed.lines.iter().filter(|l| l.level == 3).map(|l| l.points.clone()).collect();
        assert_eq!(third, [[[2.0, 2.5], [2.0, 3.5]]]);
    }

    #[test]
    fn a_saddle_is_joined_by_its_mean() {
        // Upper left and lower right stand at 10 and 8, the others at 0 and 1: the mean 4.75 is below 5, above 4.
        let at = |level: i32| {
            let lines = Contours::of(&[10.0, 0.0, 1.0, 8.0], 2, 1.0).lines;
            lines.into_iter().filter(|l| l.level == level).map(|l| l.points).collect::<Vec<_>>()
        };
        // Below the level: a line around each high corner. Left edge at 0.5 + 5/9, top edge at 0.5 + 1/2.
        let below = at(5);
        assert_eq!(below.len(), 2);
        assert!((below[0][0][1] - (0.5 + 5.0 / 9.0)).abs() < 1e-6 && below[0][1] == [1.0, 0.5], "{below:?}");
        // Above it: around each low corner.
        assert_eq!(at(4)[0][0], [0.5 + 0.6, 0.5]);
    }

    #[test]
    fn no_data_level_ground_and_single_rows_have_none() {
        assert_eq!(Contours::of(&[f32::NAN; 4], 2, 1.0), Contours::default());
        assert_eq!(Contours::of(&[3.0; 4], 2, 1.0), Contours::default());
        assert!(Contours::of(&[0.0, 1.0, 2.0], 3, 1.0).lines.is_empty());
        assert!(Contours::of(&[0.0, 1.0, 2.0], 1, 1.0).lines.is_empty());
    }
}
