//! What is drawn in colour: start, goal, a path, coloured walls.

use super::look::{COLOURS, HUES, Look};

/// Cells that less of a colour touches than this share are not counted.
const TOUCHED: f64 = 0.1;

/// A marker covers at least this share of its cell.
const MARKER: f64 = 0.25;

/// A colour in so many cells is no marker.
const MANY: usize = 5;

/// A filled cell has so much of its colour.
pub(super) const FILLED: f64 = 0.85;

/// One hue, and how much of each cell it covers.
#[derive(Debug, Clone)]
pub(super) struct Colour {
    /// In tens of degrees from red.
    pub hue: usize,
    pub shares: Vec<f64>,
}

/// Start or goal, drawn in a colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Marker {
    pub cell: usize,
    hue: usize,
    share: f64,
}

/// Hues that lie together, the most frequent first.
pub(super) fn colours(looks: &[Look]) -> Vec<Colour> {
    let mut counts = [0_u64; COLOURS];
    looks.iter().for_each(|look| counts.iter_mut().zip(look.colours).for_each(|(sum, n)| *sum += u64::from(n)));
    let mut colours = Vec::new();
    while let Some(hue) = (0..COLOURS).filter(|&hue| counts[hue] > 0).max_by_key(|&hue| counts[hue]) {
        let hues = around(&counts, hue);
        hues.iter().for_each(|&hue| counts[hue] = 0);
        let share = |look: &Look| {
            let count: u32 = hues.iter().map(|&hue| u32::from(look.colours[hue])).sum();
            f64::from(count) / f64::from(look.pixels.max(1))
        };
        colours.push(Colour { hue: hue % HUES, shares: looks.iter().map(share).collect() });
    }
    colours
}

/// A hue and up to two on either side, as far as they become rarer: brown walls and a red path are two colours.
fn around(counts: &[u64; COLOURS], hue: usize) -> Vec<usize> {
    let mut hues = vec![hue];
    for step in [1, HUES - 1] {
        let mut last = hue;
        for _ in 0..2 {
            let next = last / HUES * HUES + (last + step) % HUES;
            if counts[next] == 0 || counts[next] > counts[last] {
                break;
            }
            hues.push(next);
            last = next;
        }
    }
    hues
}

impl Colour {
    fn cells(&self, least: f64) -> Vec<usize> {
        (0..self.shares.len()).filter(|&cell| self.shares[cell] >= least).collect()
    }

    /// Whether walls have it: it fills many dark cells.
    pub(super) fn is_wall(&self, looks: &[Look], threshold: u8) -> bool {
        let filled = self.cells(FILLED);
        let dark = filled.iter().filter(|&&cell| looks[cell].corner < threshold).count();
        dark >= MANY && 2 * dark > self.cells(TOUCHED).len()
    }

    /// Cells that stand out: all of a rare colour, those that are much fuller of a frequent one.
    fn markers(&self) -> Vec<Marker> {
        let touched = self.cells(TOUCHED);
        let least = if touched.len() < MANY { MARKER } else { self.outstanding(&touched) };
        let mut cells = self.cells(least);
        cells.sort_by(|&a, &b| self.shares[b].total_cmp(&self.shares[a]).then(a.cmp(&b)));
        if touched.len() >= MANY && cells.len() > 2 {
            return Vec::new();
        }
        cells.into_iter().take(2).map(|cell| Marker { cell, hue: self.hue, share: self.shares[cell] }).collect()
    }

    fn outstanding(&self, touched: &[usize]) -> f64 {
        let mut shares: Vec<f64> = touched.iter().map(|&cell| self.shares[cell]).collect();
        shares.sort_by(f64::total_cmp);
        (1.7 * shares[shares.len() / 2]).max(0.45)
    }
}

/// Start and goal: the two fullest markers, of two colours where there are two. Green is a start and red a goal; otherwise the first is the
/// one that comes first row by row, and the answer says so by `false`.
pub(super) fn ends(colours: &[Colour], columns: usize) -> (Option<Marker>, Option<Marker>, bool) {
    let mut found: Vec<Marker> = colours.iter().flat_map(|colour| apart(colour.markers(), columns)).collect();
    found.sort_by(|a, b| b.share.total_cmp(&a.share).then(a.cell.cmp(&b.cell)));
    let Some(&first) = found.first() else { return (None, None, true) };
    let others = || found.iter().copied().filter(|other| other.cell != first.cell);
    let Some(second) = others().find(|other| other.hue != first.hue).or_else(|| others().next()) else {
        let likes = first.likes_goal();
        return if likes > 0 { (None, Some(first), true) } else { (Some(first), None, likes < 0) };
    };
    let (a, b) = (first.likes_goal(), second.likes_goal());
    let is_turned = a > b || (a == b && first.cell > second.cell);
    let (start, goal) = if is_turned { (second, first) } else { (first, second) };
    (Some(start), Some(goal), a != b)
}

/// Two markers of a colour, or the first alone if the second is that one reaching into the next cell.
fn apart(mut markers: Vec<Marker>, columns: usize) -> Vec<Marker> {
    if let [a, b] = markers[..] {
        let near = |a: usize, b: usize| a.abs_diff(b) <= 1;
        if near(a.cell % columns, b.cell % columns) && near(a.cell / columns, b.cell / columns) {
            markers.truncate(1);
        }
    }
    markers
}

impl Marker {
    /// −1 for green, 1 for red.
    fn likes_goal(self) -> i32 {
        match self.hue {
            8..=17 => -1,
            0..=2 | 33.. => 1,
            _ => 0,
        }
    }
}
