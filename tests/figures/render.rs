//! Draws figures of grids as papers have them.

use formicarium::formats::figure::class;
use formicarium::formats::picture::Picture;

use super::digits;

/// Numbers from a seed, the same everywhere (SplitMix64).
pub struct Dice(pub u64);

impl Dice {
    pub fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.roll() % n as u64) as usize
    }

    /// From a number up to another.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * (self.roll() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }
}

/// How a figure is drawn.
#[derive(Debug, Clone, Copy, Default)]
pub struct Style {
    pub name: &'static str,
    /// Pixels of a line between cells, from and to; 0 for no lines.
    pub line: (f64, f64),
    pub line_grays: &'static [u8],
    /// Whether cells are a whole number of pixels.
    pub whole: bool,
    /// Pixels that the figure leans from one end to the other, at most.
    pub skew: f64,
    pub jpeg: bool,
    pub labels: bool,
    pub ends: bool,
    pub path: bool,
}

/// A figure to draw, and what is true of it.
pub struct Scene {
    pub side: usize,
    /// Classes by row.
    pub cells: Vec<u8>,
    /// Places of the path, in cells.
    path: Vec<(f64, f64)>,
    /// Pixels of a cell.
    pub size: f64,
    line: f64,
    lean: (f64, f64),
    pub padding: [f64; 4],
    colours: [[u8; 3]; 5],
    path_width: f64,
    filled: bool,
    labels: bool,
}

const WHITE: [u8; 3] = [255; 3];
const BLACK: [u8; 3] = [0; 3];

/// Of walls, start, goal, path and lines.
fn colours(style: &Style, dice: &mut Dice) -> [[u8; 3]; 5] {
    let walls = [BLACK, [40; 3], [80; 3], [20, 30, 90], [92, 51, 23]];
    let ends = [([0, 160, 0], [230, 20, 20]), ([0, 200, 60], [200, 0, 0]), ([30, 60, 230], [230, 20, 20])];
    let (start, goal) = dice.one_of(&ends);
    let path = dice.one_of(&[[30, 80, 230], [220, 30, 30], [240, 130, 0], [190, 0, 190]]);
    [dice.one_of(&walls), start, goal, path, [dice.one_of(style.line_grays); 3]]
}

impl Scene {
    pub fn new(side: usize, style: &Style, dice: &mut Dice) -> Self {
        let density = dice.between(0.1, 0.4);
        let cells = (0..side * side).map(|_| u8::from(dice.between(0.0, 1.0) < density)).collect();
        let size = dice.between(8.0, 25.0);
        let size = if style.whole { size.round() } else { size };
        let margin = if style.labels { (40.0, 90.0) } else { (0.0, 40.0) };
        let part = if style.whole { 0.0 } else { dice.between(0.0, 1.0) };
        let mut scene = Self {
            side,
            cells,
            path: Vec::new(),
            size,
            line: dice.between(style.line.0, style.line.1).min(0.3 * size),
            lean: (dice.between(-style.skew, style.skew), dice.between(-style.skew, style.skew)),
            padding: core::array::from_fn(|_| dice.between(margin.0, margin.1).round() + style.skew + part),
            colours: colours(style, dice),
            path_width: dice.between(2.0, 4.0),
            filled: dice.below(2) == 0,
            labels: style.labels,
        };
        if style.ends || style.path {
            scene.ends(style, dice);
        }
        scene
    }

    /// A start, the goal farthest from it, and a way between them.
    fn ends(&mut self, style: &Style, dice: &mut Dice) {
        let n = self.side;
        let start = dice.below(n / 3) * n + dice.below(n / 3);
        self.cells[start] = 0;
        let (from, goal) = self.ways(start);
        if goal == start {
            return;
        }
        if style.path {
            let before = |cell: &usize| (*cell != start).then_some(from[*cell]);
            let middle = |cell: usize| ((cell % n) as f64 + 0.5, (cell / n) as f64 + 0.5);
            self.path = std::iter::successors(Some(goal), before).map(middle).collect();
        }
        if style.ends {
            (self.cells[start], self.cells[goal]) = (class::START, class::GOAL);
        }
    }

    /// For each cell the one before it on a way from `start`, and the cell that is reached last.
    fn ways(&self, start: usize) -> (Vec<usize>, usize) {
        let n = self.side as i64;
        let mut from = vec![usize::MAX; self.cells.len()];
        from[start] = start;
        let mut queue = vec![start];
        let mut next = 0;
        while let Some(&cell) = queue.get(next) {
            next += 1;
            for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)] {
                let (x, y) = (cell as i64 % n + dx, cell as i64 / n + dy);
                let to = (y * n + x) as usize;
                if (0..n).contains(&x) && (0..n).contains(&y) && self.cells[to] == 0 && from[to] == usize::MAX {
                    from[to] = cell;
                    queue.push(to);
                }
            }
        }
        (from, queue[queue.len() - 1])
    }

    pub fn picture(&self) -> Picture {
        const FINE: usize = 4;
        let span = self.side as f64 * self.size;
        let [left, top, right, bottom] = self.padding;
        let (width, height) = ((left + span + right).ceil() as usize, (top + span + bottom).ceil() as usize);
        let near = self.near();
        let pixel = |x: usize, y: usize| {
            let mut sum = [0_u32; 3];
            for i in 0..FINE * FINE {
                let at = |n: usize, i: usize| n as f64 + (i as f64 + 0.5) / FINE as f64;
                let (px, py) = (at(x, i % FINE) - left, at(y, i / FINE) - top);
                let (px, py) = (px - self.lean.0 * py / span, py - self.lean.1 * px / span);
                sum.iter_mut().zip(self.colour(px, py, &near)).for_each(|(sum, c)| *sum += u32::from(c));
            }
            let [r, g, b] = sum.map(|sum| (sum / (FINE * FINE) as u32) as u8);
            [r, g, b, 255]
        };
        let pixels = (0..width * height).map(|i| pixel(i % width, i / width)).collect();
        Picture { width: width as u32, height: height as u32, pixels, has_alpha: false, deep: None, notices: Vec::new() }
    }

    /// The parts of the path near each cell.
    fn near(&self) -> Vec<Vec<usize>> {
        let mut near = vec![Vec::new(); self.side * self.side];
        for (i, pair) in self.path.windows(2).enumerate() {
            let low = |a: f64, b: f64| (a.min(b) - 1.0).max(0.0) as usize;
            let high = |a: f64, b: f64| ((a.max(b) + 1.0) as usize).min(self.side - 1);
            for y in low(pair[0].1, pair[1].1)..=high(pair[0].1, pair[1].1) {
                for x in low(pair[0].0, pair[1].0)..=high(pair[0].0, pair[1].0) {
                    near[y * self.side + x].push(i);
                }
            }
        }
        near
    }

    /// The colour at a place in pixels from the upper left corner of the cells.
    fn colour(&self, x: f64, y: f64, near: &[Vec<usize>]) -> [u8; 3] {
        let (u, v) = (x / self.size, y / self.size);
        let frame = (self.line / 2.0).max(0.5) / self.size;
        let away = |place: f64| (-place).max(place - self.side as f64);
        let outside = away(u).max(away(v));
        if outside >= frame {
            return if self.labels && self.is_label(x, y) { BLACK } else { WHITE };
        }
        if outside >= -frame {
            return BLACK;
        }
        let cell = v as usize * self.side + u as usize;
        if near[cell].iter().any(|&i| self.is_on_path(i, u, v)) {
            return self.colours[3];
        }
        let on_line = |place: f64| (place - place.round()).abs() * self.size <= self.line / 2.0;
        if self.line > 0.0 && (on_line(u) || on_line(v)) {
            return self.colours[4];
        }
        self.filling(self.cells[cell], u.fract() - 0.5, v.fract() - 0.5)
    }

    /// The colour of a cell's inside, at a place beside its middle.
    fn filling(&self, class: u8, u: f64, v: f64) -> [u8; 3] {
        let is_marker = self.filled || u * u + v * v < 0.36 * 0.36;
        match class {
            class::WALL => self.colours[0],
            class::START if is_marker => self.colours[1],
            class::GOAL if is_marker => self.colours[2],
            _ => WHITE,
        }
    }

    fn is_on_path(&self, part: usize, u: f64, v: f64) -> bool {
        let ((ax, ay), (bx, by)) = (self.path[part], self.path[part + 1]);
        let along = (((u - ax) * (bx - ax) + (v - ay) * (by - ay)) / ((bx - ax).powi(2) + (by - ay).powi(2))).clamp(0.0, 1.0);
        let (dx, dy) = (u - ax - along * (bx - ax), v - ay - along * (by - ay));
        (dx * dx + dy * dy).sqrt() * self.size <= self.path_width / 2.0
    }

    /// Ticks and numbers left and below, and a title above.
    fn is_label(&self, x: f64, y: f64) -> bool {
        let span = self.side as f64 * self.size;
        let tick = |along: f64, away: f64| {
            let near = (along / (5.0 * self.size)).round() * 5.0 * self.size;
            (0.0..=span + 1.0).contains(&near) && (along - near).abs() <= 0.5 && (0.0..=4.0).contains(&away)
        };
        if tick(x, y - span) || tick(y, -x) {
            return true;
        }
        let five = |along: f64| (0.max((along / (5.0 * self.size)).round() as i64) as usize * 5).min(self.side);
        let (below, beside) = (five(x), five(y));
        let number = |n: usize, x: f64, y: f64| digits::is_ink(&n.to_string(), x, y, 1.6);
        number(below, x - below as f64 * self.size + 7.0, y - span - 7.0)
            || number(beside, x + 26.0, y - beside as f64 * self.size + 5.0)
            || digits::is_ink("3 141 592 653 589 793", x - span / 4.0, y + 26.0, 2.3)
    }
}
