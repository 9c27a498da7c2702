//! Looking back at a run: snapshots of the planner within a budget of memory, and the same iterations once more from the nearest of them.
//!
//! A planner depends on nothing but its own state, so a snapshot that goes on repeats the run bit for bit. Snapshots are therefore few: one is
//! worth its memory and the time to copy it only where repeating would cost far more. It is due when the planner has worked
//! [`WORK_PER_BYTE`] for each byte of it, which keeps the copies below 5 % of the walk and every replay shorter than a moment. When the
//! budget is full, every second one goes and they come half as often. The beginning and the newest one always stay, unless one snapshot
//! alone exceeds the budget: then the beginning is all, and every look back is a repetition from there.

use super::{Effort, Granularity, Planner};
#[cfg(feature = "whole")]
use crate::scenario::Change;

/// Moves of ants, or cells expanded, for each byte of a snapshot, before the next one is due. Copying fresh memory takes 0.5 to 2 ns a
/// byte, a move 20 to 50 ns.
const WORK_PER_BYTE: f64 = 2.0;

/// A planner as it stood at the end of an iteration.
struct Snapshot {
    planner: Box<dyn Planner>,
    bytes: usize,
}

impl Snapshot {
    fn of(planner: &dyn Planner) -> Self {
        let planner = planner.snapshot();
        Self { bytes: planner.bytes(), planner }
    }

    fn iteration(&self) -> u32 {
        self.planner.effort().iterations
    }
}

/// What is kept of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kept {
    /// How many snapshots there are, the beginning included.
    pub snapshots: u32,
    /// Bytes that they hold.
    pub bytes: u32,
    /// Bytes that they may hold.
    pub budget: u32,
    /// Snapshots are at least so many iterations apart: 1, 2, 4, ….
    pub stride: u32,
    /// Most iterations that a look back may repeat.
    pub most_repeated: u32,
}

/// The snapshots of one run, by iteration.
pub struct Playback {
    /// The first one is the beginning.
    kept: Vec<Snapshot>,
    budget: usize,
    stride: u32,
    /// The iteration that was noted last.
    latest: u32,
}

impl Playback {
    /// Begins with the planner as it stands, before its first step; `budget` in bytes.
    pub fn new(planner: &dyn Planner, budget: u32) -> Self {
        let first = Snapshot::of(planner);
        Self { latest: first.iteration(), kept: vec![first], budget: budget as usize, stride: 1 }
    }

    /// Takes note of where the planner stands, after each step of it.
    #[inline]
    pub fn note(&mut self, planner: &dyn Planner, by: Granularity) {
        let iteration = planner.progress().effort.iterations;
        if iteration > self.latest {
            self.latest = iteration;
            // A move of a search that ends a contour has begun the next one: it stands at no end.
            if by == Granularity::Iteration || planner.budget().is_some() {
                self.end_iteration(planner, iteration);
            }
        }
    }

    /// Takes note of a change that the run has just taken ([`super::Changing::schedule`]): what is kept has it to come.
    #[cfg(feature = "whole")]
    pub fn change(&mut self, run: &dyn Planner, change: &Change) {
        let made = run.changing().is_some_and(|changing| changing.to_come() == 0);
        for kept in &mut self.kept {
            if made && kept.iteration() == run.effort().iterations {
                *kept = Snapshot::of(run);
            } else if let Some(changing) = kept.planner.changing_mut() {
                changing.schedule(change.clone()).expect("the run has taken it");
                kept.bytes = kept.planner.bytes();
            }
        }
    }

    #[inline(never)]
    fn end_iteration(&mut self, planner: &dyn Planner, iteration: u32) {
        let (last, bytes) = (&self.kept[self.kept.len() - 1], planner.bytes());
        let worked = work(planner.effort()) - work(last.planner.effort());
        let due = worked as f64 >= WORK_PER_BYTE * bytes as f64 * f64::from(self.stride);
        if iteration - last.iteration() < self.stride || !due || bytes + self.kept[0].bytes > self.budget {
            return;
        }
        self.kept.push(Snapshot::of(planner));
        while self.bytes() > self.budget && self.kept.len() > 2 {
            self.thin();
        }
        if self.bytes() > self.budget {
            self.kept.truncate(1);
        }
    }

    /// Every second one goes, but neither the first nor the last.
    fn thin(&mut self) {
        let mut next = 1;
        while next + 1 < self.kept.len() {
            self.kept.remove(next);
            next += 1;
        }
        self.stride = self.stride.saturating_mul(2);
    }

    fn bytes(&self) -> usize {
        self.kept.iter().map(|s| s.bytes).sum()
    }

    /// What is kept.
    pub fn summary(&self) -> Kept {
        let (mut end, mut most_repeated) = (self.latest + 1, 0);
        for iteration in self.kept.iter().rev().map(Snapshot::iteration) {
            most_repeated = most_repeated.max(end - 1 - iteration);
            end = iteration;
        }
        Kept {
            snapshots: self.kept.len() as u32,
            bytes: self.bytes() as u32,
            budget: self.budget as u32,
            stride: self.stride,
            most_repeated,
        }
    }

    /// The way back to the end of an iteration, from the nearest snapshot or from `near`, what was looked at before, if that is nearer. An
    /// iteration that the run has not reached yet becomes its last one.
    pub fn back_to(&self, iteration: u32, near: Option<&dyn Planner>) -> Replay {
        let target = iteration.min(self.latest);
        let nearest = self.kept.iter().rev().find(|s| s.iteration() <= target).unwrap_or(&self.kept[0]);
        let near = near.filter(|p| (nearest.iteration()..=target).contains(&p.effort().iterations));
        Replay { planner: near.unwrap_or(&*nearest.planner).snapshot(), target }
    }
}

/// What a planner has done so far, as far as it takes time.
fn work(effort: Effort) -> u64 {
    effort.ant_moves + effort.cell_expansions
}

/// A planner on its way to how it stood at the end of an iteration.
pub struct Replay {
    planner: Box<dyn Planner>,
    target: u32,
}

impl Replay {
    /// Goes on by at most so many iterations; true once it is there.
    pub fn go_on(&mut self, at_most: u32) -> bool {
        for _ in 0..at_most {
            if self.is_there() {
                break;
            }
            self.planner.advance(Granularity::Iteration);
        }
        self.is_there()
    }

    /// Whether this iteration is where it goes.
    pub fn leads_to(&self, iteration: u32) -> bool {
        self.target == iteration
    }

    fn is_there(&self) -> bool {
        self.planner.effort().iterations >= self.target || self.planner.status().is_finished()
    }

    /// The planner where it stands now.
    pub fn into_planner(mut self) -> Box<dyn Planner> {
        self.go_on(u32::MAX);
        self.planner
    }
}
