//! Scent: how far it is from each cell to the goal, over the parts of blocks of cells instead of the cells themselves.
//!
//! The map is cut into blocks of [`SIDE`] × [`SIDE`] cells. What is free of a block falls into parts, the sets of cells that the allowed steps
//! join inside the block. Parts that a step joins are neighbours, as far from each other as their centres on an open map; Dijkstra's search from
//! the goal's part gives D of every part. The scent of a cell is the least D(N) + d(cell, centre of N) over its own part and the neighbours of
//! that: no bound in either direction, but it knows walls and dead ends. Dijkstra's search expands the parts, about one for 64 cells in the
//! open; to find them and their neighbours each free cell and its steps are looked at twice, which no effort counts.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::exact::Distance;
use crate::map::{Cell, Point};
use crate::planner::held;
use crate::scenario::Scenario;

/// Cells of a side of a block.
pub const SIDE: u32 = 8;

/// The part of a blocked cell.
const NONE: u32 = u32::MAX;

/// The scent of a map towards its goal.
#[derive(Debug, Clone)]
pub struct Scent {
    distance: Distance,
    width: u32,
    /// The part of each cell.
    part_of: Vec<u32>,
    parts: Vec<Part>,
    /// The neighbours of all parts, one part after the other.
    neighbours: Vec<u32>,
}

/// A set of cells of a block that steps inside the block join.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Part {
    /// The cell in whose middle, or nearly so, the part's cells have their mean.
    centre: Point,
    /// Mean factor of its cells; 1 but on weighted ground.
    factor: f64,
    /// Where its neighbours begin, and where they end.
    neighbours: (u32, u32),
    /// Distance from its centre to the goal, in cells; infinite where no way leads there.
    to_goal: f64,
}

impl Scent {
    /// Of a scenario towards its goal.
    pub fn new(scenario: &Scenario) -> Self {
        let (part_of, parts) = parts(scenario);
        let (distance, width) = (Distance::of(scenario), scenario.grid.width());
        let mut scent = Self { distance, width, part_of, parts, neighbours: Vec::new() };
        scent.join(scenario);
        scent.spread(scenario.goal);
        scent
    }

    /// Distance from a free cell to the goal, in cells; infinite where no way leads there.
    pub fn of(&self, cell: Cell) -> f64 {
        let Some(own) = self.parts.get(self.part_of[cell as usize] as usize) else { return f64::INFINITY };
        let at = Point::new(cell % self.width, cell / self.width);
        let over = |part: &Part| part.to_goal + self.between((at, own.factor), (part.centre, part.factor));
        if own.to_goal == 0.0 { over(own) } else { self.around(own).map(over).fold(over(own), f64::min) }
    }

    /// How many parts Dijkstra's search has expanded: those from which a way leads to the goal.
    pub fn expanded(&self) -> u64 {
        self.parts.iter().filter(|part| part.to_goal.is_finite()).count() as u64
    }

    /// Writes the scent of every cell.
    pub fn show(&self, out: &mut [f32]) {
        out.iter_mut().zip(0..).for_each(|(value, cell)| *value = self.of(cell) as f32);
    }

    /// What it holds, in bytes, its own size not counted.
    pub fn bytes(&self) -> usize {
        held(&self.part_of) + held(&self.parts) + held(&self.neighbours)
    }

    fn around(&self, part: &Part) -> impl Iterator<Item = &Part> {
        let (from, to) = part.neighbours;
        self.neighbours[from as usize..to as usize].iter().map(|&n| &self.parts[n as usize])
    }

    /// Distance between two cells on an open map, times the mean of the factors of their parts.
    fn between(&self, (a, its): (Point, f64), (b, others): (Point, f64)) -> f64 {
        self.distance.on_open_map(a.x.abs_diff(b.x), a.y.abs_diff(b.y)) * ((its + others) / 2.0)
    }

    /// Finds the neighbours of every part.
    fn join(&mut self, scenario: &Scenario) {
        let part_of = &self.part_of;
        let outwards = |c: Cell| {
            let to = scenario.moves.directions(c).map(move |d| part_of[scenario.moves.step(c, d) as usize]);
            let own = part_of[c as usize];
            to.filter(move |&part| part != own).map(move |part| (own, part))
        };
        let mut pairs: Vec<(u32, u32)> = (0..scenario.grid.len() as Cell).flat_map(outwards).collect();
        pairs.sort_unstable();
        pairs.dedup();
        let mut from = 0;
        for (number, part) in (0..).zip(&mut self.parts) {
            let count = pairs[from..].iter().take_while(|pair| pair.0 == number).count();
            part.neighbours = (from as u32, (from + count) as u32);
            from += count;
        }
        self.neighbours = pairs.into_iter().map(|pair| pair.1).collect();
    }

    /// Dijkstra's search from the goal's part, whose centre is the goal itself.
    fn spread(&mut self, goal: Cell) {
        let first = self.part_of[goal as usize];
        let Some(part) = self.parts.get_mut(first as usize) else { return };
        (part.centre, part.to_goal) = (Point::new(goal % self.width, goal / self.width), 0.0);
        // Distances are not negative, and so in the order of their bits.
        let mut open = BinaryHeap::from([Reverse((0.0f64.to_bits(), first))]);
        while let Some(Reverse((bits, number))) = open.pop() {
            let part = self.parts[number as usize];
            if bits > part.to_goal.to_bits() {
                continue;
            }
            for at in part.neighbours.0..part.neighbours.1 {
                let next = self.neighbours[at as usize];
                let other = self.parts[next as usize];
                let to_goal = part.to_goal + self.between((part.centre, part.factor), (other.centre, other.factor));
                if to_goal < other.to_goal {
                    self.parts[next as usize].to_goal = to_goal;
                    open.push(Reverse((to_goal.to_bits(), next)));
                }
            }
        }
    }
}

/// The part of every cell, and all parts, in the order of their first cells in their blocks; blocks row by row.
fn parts(scenario: &Scenario) -> (Vec<u32>, Vec<Part>) {
    let (width, height) = (scenario.grid.width(), scenario.grid.height());
    let (mut part_of, mut parts) = (vec![NONE; scenario.grid.len()], Vec::new());
    let mut cells = Vec::new();
    for (top, left) in (0..height).step_by(SIDE as usize).flat_map(|y| (0..width).step_by(SIDE as usize).map(move |x| (y, x))) {
        for y in top..(top + SIDE).min(height) {
            for x in left..(left + SIDE).min(width) {
                let cell = y * width + x;
                if part_of[cell as usize] == NONE && !scenario.grid.is_blocked(cell) {
                    fill(scenario, cell, parts.len() as u32, &mut part_of, &mut cells);
                    parts.push(part(scenario, &cells));
                }
            }
        }
    }
    (part_of, parts)
}

/// Collects the cells that steps inside a cell's block join to it.
fn fill(scenario: &Scenario, from: Cell, number: u32, part_of: &mut [u32], cells: &mut Vec<Cell>) {
    let width = scenario.grid.width();
    let block = |c: Cell| (c % width / SIDE, c / width / SIDE);
    cells.clear();
    cells.push(from);
    part_of[from as usize] = number;
    let mut next = 0;
    while let Some(&cell) = cells.get(next) {
        next += 1;
        for to in scenario.moves.directions(cell).map(|d| scenario.moves.step(cell, d)) {
            if part_of[to as usize] == NONE && block(to) == block(from) {
                part_of[to as usize] = number;
                cells.push(to);
            }
        }
    }
}

/// A part of these cells, alone and far from the goal.
fn part(scenario: &Scenario, cells: &[Cell]) -> Part {
    let (width, count) = (scenario.grid.width(), cells.len() as u32);
    let mean = |sum: u32| (2 * sum + count) / (2 * count);
    let centre = Point::new(mean(cells.iter().map(|c| c % width).sum()), mean(cells.iter().map(|c| c / width).sum()));
    let factors = scenario.grid.factors().filter(|_| scenario.moves.weights().is_some());
    let sum = factors.map(|factors| cells.iter().map(|&c| f64::from(factors[c as usize])).sum::<f64>());
    Part { centre, factor: sum.map_or(1.0, |sum| sum / f64::from(count)), neighbours: (0, 0), to_goal: f64::INFINITY }
}
