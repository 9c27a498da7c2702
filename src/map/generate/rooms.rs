//! Rooms with doors: a rectangle is divided by a wall with doors, then each half again, until the rooms are small.
//!
//! Walls stand only at every `step`-th line and doors only between those lines, so no later wall can end in a door: every room
//! is reachable by construction.

use super::{Dice, Generated, frame};
use crate::map::{Grid, Point};

/// A span of cells along one axis, inside the frame.
#[derive(Debug, Clone, Copy)]
struct Span {
    from: u32,
    to: u32,
}

impl Span {
    fn len(self) -> u32 {
        self.to - self.from
    }
}

/// A room, perhaps to be divided. Axis 0 is x, axis 1 is y.
type Room = [Span; 2];

/// How the walls are laid out.
struct Plan {
    frame: u32,
    /// Distance of the lines on which walls may stand; doors are `step - 1` cells wide.
    step: u32,
    /// Smallest side of a room.
    room: u32,
}

/// Builds walls into an open map.
pub(super) fn build(mut grid: Grid, dice: &mut Dice) -> Generated {
    let frame = frame(&grid);
    let (inner_w, inner_h) = (grid.width() - 2 * frame, grid.height() - 2 * frame);
    let shorter = inner_w.min(inner_h);
    let plan = Plan { frame, step: if shorter < 48 { 2 } else { 4 }, room: (shorter / 9).clamp(3, 20) };
    if frame > 0 {
        wall_around(&mut grid);
    }
    let mut rooms: Vec<Room> = vec![[Span { from: 0, to: inner_w }, Span { from: 0, to: inner_h }]];
    while let Some(room) = rooms.pop() {
        if let Some((axis, line)) = plan.divide(room, dice) {
            plan.wall(&mut grid, room, axis, line, dice);
            let (mut low, mut high) = (room, room);
            low[axis].to = line;
            high[axis].from = line + 1;
            rooms.extend([low, high]);
        }
    }
    let goal = Point::new(frame + inner_w - 1, frame + inner_h - 1);
    Generated::plane(grid, Point::new(frame, frame), goal)
}

fn wall_around(grid: &mut Grid) {
    let (w, h) = (grid.width(), grid.height());
    for cell in 0..grid.len() as u32 {
        let p = grid.point(cell);
        if p.x == 0 || p.y == 0 || p.x + 1 == w || p.y + 1 == h {
            grid.set_blocked(cell, true);
        }
    }
}

impl Plan {
    /// The axis and the line at which a room is divided; none when it is small enough.
    fn divide(&self, room: Room, dice: &mut Dice) -> Option<(usize, u32)> {
        let longer = usize::from(room[1].len() > room[0].len());
        // Every other room of middling size stays whole, so that sizes differ.
        if room[longer].len() < 3 * self.room && dice.below(2) == 0 {
            return None;
        }
        let line = self.line(room[longer], dice)?;
        Some((longer, line))
    }

    /// A random line that leaves both sides large enough.
    fn line(&self, span: Span, dice: &mut Dice) -> Option<u32> {
        // Lines are step − 1, 2·step − 1, …: the first one at or behind the smallest room, the last one before the other.
        let first = (span.from + self.room + 1).div_ceil(self.step);
        let last = span.to.checked_sub(self.room)? / self.step;
        (first <= last).then(|| (first + dice.below(last - first + 1)) * self.step - 1)
    }

    /// Builds a wall across a room, with a door for every few rooms of its length.
    fn wall(&self, grid: &mut Grid, room: Room, axis: usize, line: u32, dice: &mut Dice) {
        let along = room[1 - axis];
        for at in along.from..along.to {
            grid.set_blocked(self.cell(grid, axis, line, at), true);
        }
        let slots = along.len().div_ceil(self.step);
        for _ in 0..=along.len() / (5 * self.room) {
            let from = along.from + dice.below(slots) * self.step;
            for at in from..(from + self.step - 1).min(along.to) {
                grid.set_blocked(self.cell(grid, axis, line, at), false);
            }
        }
    }

    fn cell(&self, grid: &Grid, axis: usize, line: u32, at: u32) -> u32 {
        let (x, y) = if axis == 0 { (line, at) } else { (at, line) };
        grid.cell(Point::new(x + self.frame, y + self.frame))
    }
}
