//! Obstacles that move along tracks while a robot drives.

use serde::{Deserialize, Serialize};

use super::ScenarioSpec;
use super::drive::{MAX_STEP, check_number, said, wrong};
use crate::error::ScenarioError;
use crate::map::{Grid, Point};

/// Most cells of a track.
pub const MAX_TRACK_CELLS: usize = 10_000;
/// Most cells a side of an obstacle.
pub const MAX_OBSTACLE: u32 = 64;
/// Most steps for which an obstacle stays on a cell of its track.
pub const MAX_STEPS_PER_CELL: u32 = 1000;

/// What an obstacle does at the end of its track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum AtEnd {
    /// It stays on the last cell.
    #[default]
    Stay,
    /// It turns, at either end.
    BackAndForth,
    /// It goes on from the first cell, which is beside the last one.
    Loop,
    /// It is gone.
    Leave,
}

/// An obstacle that moves: a square that blocks the cells it stands on. It goes by its timetable, whatever walls there are, and gives way to
/// the robot: where its timetable would have it touch the robot, it waits at the last place before that is clear of it, and catches up
/// as soon as the robot has left.
///
/// ```
/// use formicarium::map::Point;
/// use formicarium::scenario::{AtEnd, Track};
///
/// let cells = (0..4).map(|x| Point::new(x, 2)).collect();
/// let track = Track { cells, size: 1, from_step: 10, steps_per_cell: 2, at_end: AtEnd::BackAndForth };
/// let at = |step| track.at(step).map(|p| p.x);
/// assert_eq!((at(9), at(10), at(11), at(12), at(16), at(18)), (None, Some(0), Some(0), Some(1), Some(3), Some(2)));
/// assert_eq!(track.clear_of(12, Point::new(1, 2), |squared| squared == 0), Some(Point::new(0, 2)), "the robot is in its way");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Track {
    /// The way of its centre, from cell to neighbouring cell; 1 to [`MAX_TRACK_CELLS`].
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub cells: Vec<Point>,
    /// Cells a side, 1 to [`MAX_OBSTACLE`]; of an even size the centre is the upper left one of the four in the middle.
    #[serde(default = "one")]
    pub size: u32,
    /// The step at which it comes to stand on the first cell, up to [`MAX_STEP`]; before that it is not there.
    #[serde(default)]
    pub from_step: u32,
    /// For how many steps of the robot it stays on each cell, 1 to [`MAX_STEPS_PER_CELL`].
    #[serde(default = "one")]
    pub steps_per_cell: u32,
    /// What it does at the end.
    #[serde(default)]
    pub at_end: AtEnd,
}

fn one() -> u32 {
    1
}

impl Track {
    /// After how many cells it begins from the front; those of its track where it does not.
    fn cycle(&self) -> u32 {
        let cells = self.cells.len() as u32;
        if self.at_end == AtEnd::BackAndForth { (2 * cells).saturating_sub(2).max(1) } else { cells }
    }

    /// After how many steps it begins from the front; none where it ends.
    pub fn period(&self) -> Option<u32> {
        matches!(self.at_end, AtEnd::BackAndForth | AtEnd::Loop).then(|| self.cycle() * self.steps_per_cell)
    }

    /// The step from which on it does what it will always do: it stands or is gone, or has gone through its track once.
    pub fn settled(&self) -> u32 {
        self.from_step + self.cycle() * self.steps_per_cell
    }

    /// How many cells it has left behind at a step; none before it is there.
    fn passed(&self, step: u32) -> Option<u32> {
        let passed = step.checked_sub(self.from_step)? / self.steps_per_cell;
        Some(if self.at_end == AtEnd::Stay { passed.min(self.cycle() - 1) } else { passed })
    }

    /// Its centre after so many cells; none where it has left.
    fn place(&self, passed: u32) -> Option<Point> {
        let cycle = self.cycle();
        let k = match self.at_end {
            AtEnd::Stay | AtEnd::Leave => passed,
            AtEnd::Loop => passed % cycle,
            AtEnd::BackAndForth => (passed % cycle).min(cycle - passed % cycle),
        };
        self.cells.get(k as usize).copied()
    }

    /// Where its timetable has its centre at a step; none while it is not on the map.
    pub fn at(&self, step: u32) -> Option<Point> {
        self.passed(step).and_then(|passed| self.place(passed))
    }

    /// Where its centre is at a step while the robot stands on a cell: by the timetable, or at the last place before that is clear of it, which
    /// `touches` says of a squared distance in cells. None while it is not on the map.
    pub fn clear_of(&self, step: u32, robot: Point, touches: impl Fn(u32) -> bool) -> Option<Point> {
        let now = self.passed(step)?;
        let first = now.saturating_sub(self.cycle());
        let is_clear = |centre: Point| !touches(self.squared_distance(centre, robot));
        (first..=now).rev().map(|passed| self.place(passed)).find(|place| place.is_none_or(is_clear)).flatten()
    }

    /// How far a cell is from the nearest of those on which it stands, along one axis; 0 within them.
    fn beyond(&self, centre: u32, at: u32) -> u32 {
        let (first, last) = (i64::from(centre) - i64::from((self.size - 1) / 2), i64::from(centre + self.size / 2));
        (first - i64::from(at)).max(i64::from(at) - last).max(0) as u32
    }

    /// Squared distance in cells, centre to centre, from a cell of the map to the nearest of those on which it stands.
    fn squared_distance(&self, centre: Point, cell: Point) -> u32 {
        self.beyond(centre.x, cell.x).pow(2) + self.beyond(centre.y, cell.y).pow(2)
    }

    /// Whether it stands on a cell while its centre is on another. The cell may be any, even one beyond the map.
    pub fn covers(&self, centre: Point, cell: Point) -> bool {
        self.beyond(centre.x, cell.x) == 0 && self.beyond(centre.y, cell.y) == 0
    }

    /// The cells of a map on which it stands.
    pub fn covered(&self, centre: Point, grid: &Grid) -> impl Iterator<Item = Point> + use<> {
        let (before, behind) = ((self.size - 1) / 2, self.size / 2);
        let columns = centre.x.saturating_sub(before)..=(centre.x + behind).min(grid.width() - 1);
        let rows = centre.y.saturating_sub(before)..=(centre.y + behind).min(grid.height() - 1);
        rows.flat_map(move |y| columns.clone().map(move |x| Point::new(x, y)))
    }

    /// Whether from some step on it always stands on a cell.
    fn rests_on(&self, cell: Point) -> bool {
        match self.at_end {
            AtEnd::Leave => false,
            AtEnd::Stay => self.cells.last().is_some_and(|&last| self.covers(last, cell)),
            AtEnd::BackAndForth | AtEnd::Loop => self.cells.iter().all(|&centre| self.covers(centre, cell)),
        }
    }

    /// What is allowed in the place of a cell that cannot be on the track; none where it can.
    fn unfit(&self, i: usize, grid: &Grid) -> Option<&'static str> {
        let before = match i {
            0 if self.at_end == AtEnd::Loop => self.cells.last(),
            0 => None,
            _ => self.cells.get(i - 1),
        };
        if !grid.contains(self.cells[i]) {
            return Some("a cell of the map");
        }
        before.is_some_and(|&before| !beside(before, self.cells[i])).then_some("beside the cell before it")
    }

    /// Whether it can be on a map, and rests on none of the goals; `index` is its number in errors.
    ///
    /// # Errors
    /// [`ScenarioError::Drive`] names the field, the value and what is allowed.
    pub(super) fn check(&self, grid: &Grid, spec: &ScenarioSpec, index: usize) -> Result<(), ScenarioError> {
        let wrong = |field: &str, value: String, allowed| wrong(&format!("tracks[{index}].{field}"), value, allowed);
        if !(1..=MAX_TRACK_CELLS).contains(&self.cells.len()) {
            return Err(wrong("cells", self.cells.len().to_string(), "a list of 1 to 10000 cells"));
        }
        let number =
            |field: &str, value, within, allowed| check_number(&format!("tracks[{index}].{field}"), value, within, allowed);
        number("size", self.size, 1..=MAX_OBSTACLE, "1 to 64 cells a side")?;
        number("from_step", self.from_step, 0..=MAX_STEP, "a step up to 1000000")?;
        number("steps_per_cell", self.steps_per_cell, 1..=MAX_STEPS_PER_CELL, "1 to 1000 steps")?;
        for (i, &cell) in self.cells.iter().enumerate() {
            if let Some(allowed) = self.unfit(i, grid) {
                return Err(wrong(&format!("cells[{i}]"), said(cell), allowed));
            }
        }
        match spec.goals.iter().find(|goal| self.rests_on(goal.at)) {
            Some(goal) => Err(wrong("cells", said(goal.at), "a track that does not end on a goal")),
            None => Ok(()),
        }
    }
}

/// Whether two cells are the same or neighbours.
fn beside(a: Point, b: Point) -> bool {
    a.x.abs_diff(b.x).max(a.y.abs_diff(b.y)) <= 1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Along row 1, from the left.
    fn track(cells: u32, size: u32, at_end: AtEnd) -> Track {
        let cells = (0..cells).map(|x| Point::new(x, 1)).collect();
        Track { cells, size, from_step: 2, steps_per_cell: 1, at_end }
    }

    fn columns(track: &Track, steps: u32) -> Vec<Option<u32>> {
        (0..steps).map(|step| track.at(step).map(|p| p.x)).collect()
    }

    #[test]
    fn timetables_by_hand() {
        let [a, b, c] = [Some(0), Some(1), Some(2)];
        assert_eq!(columns(&track(3, 1, AtEnd::Stay), 8), [None, None, a, b, c, c, c, c]);
        assert_eq!(columns(&track(3, 1, AtEnd::Leave), 8), [None, None, a, b, c, None, None, None]);
        assert_eq!(columns(&track(3, 1, AtEnd::Loop), 8), [None, None, a, b, c, a, b, c]);
        assert_eq!(columns(&track(3, 1, AtEnd::BackAndForth), 8), [None, None, a, b, c, b, a, b]);
        assert_eq!(columns(&track(1, 1, AtEnd::BackAndForth), 4), [None, None, a, a]);
        assert_eq!(track(3, 1, AtEnd::BackAndForth).period(), Some(4));
        assert_eq!((track(3, 1, AtEnd::Stay).period(), track(3, 1, AtEnd::Stay).settled()), (None, 5));
    }

    #[test]
    fn squares_are_cut_off_at_the_border() {
        let grid = Grid::open(9, 9).expect("a map");
        let cells =
            |size, x, y| track(3, size, AtEnd::Stay).covered(Point::new(x, y), &grid).map(|p| (p.x, p.y)).collect::<Vec<_>>();
        assert_eq!(cells(1, 4, 4), [(4, 4)]);
        assert_eq!(cells(2, 4, 4), [(4, 4), (5, 4), (4, 5), (5, 5)]);
        assert_eq!(cells(3, 0, 8), [(0, 7), (1, 7), (0, 8), (1, 8)]);
        for size in 1..5 {
            let (track, centre) = (track(3, size, AtEnd::Stay), Point::new(3, 5));
            let covered: Vec<Point> = track.covered(centre, &grid).collect();
            let all = (0..81).map(|c| Point::new(c % 9, c / 9));
            assert_eq!(all.filter(|&p| track.covers(centre, p)).collect::<Vec<_>>(), covered, "{size}");
        }
    }

    #[test]
    fn a_goal_far_beyond_the_map_is_not_under_a_track() {
        let far = Point::new(u32::MAX, 1);
        assert!(!track(3, 2, AtEnd::Stay).covers(Point::new(2, 1), far));
        assert!(track(3, 2, AtEnd::Stay).covers(Point::new(2, 1), Point::new(3, 2)));
    }

    /// Of a robot that is a point.
    fn on_it(squared: u32) -> bool {
        squared == 0
    }

    #[test]
    fn it_gives_way_and_catches_up() {
        let robot = Point::new(2, 1);
        let clear = |at_end, step| track(4, 1, at_end).clear_of(step, robot, on_it).map(|p| p.x);
        // Its timetable is 0, 1, 2, 3 from step 2 on.
        assert_eq!([3, 4, 5].map(|step| clear(AtEnd::Stay, step)), [Some(1), Some(1), Some(3)]);
        // Of three cells a side it covers column 2 from its second cell on.
        let wide = track(4, 3, AtEnd::Stay);
        assert_eq!([2, 3, 4, 9].map(|step| wide.clear_of(step, robot, on_it).map(|p| p.x)), [Some(0); 4]);
        assert_eq!(
            wide.clear_of(4, Point::new(1, 0), on_it),
            None,
            "it would cover the robot from the first cell on: it does not appear"
        );
        assert_eq!(clear(AtEnd::Leave, 6), None);
    }

    #[test]
    fn what_cannot_be_is_refused_by_name() {
        let grid = Grid::open(6, 3).expect("a map");
        let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(5, 2));
        let field = |track: Track| match track.check(&grid, &spec, 7) {
            Err(ScenarioError::Drive { field, .. }) => field,
            other => format!("{other:?}"),
        };
        let row = || track(4, 1, AtEnd::Stay);
        assert_eq!(row().check(&grid, &spec, 7), Ok(()));
        assert_eq!(field(Track { cells: Vec::new(), ..row() }), "drive.tracks[7].cells");
        assert_eq!(field(Track { size: 0, ..row() }), "drive.tracks[7].size");
        assert_eq!(field(Track { size: 65, ..row() }), "drive.tracks[7].size");
        assert_eq!(field(Track { from_step: 1_000_001, ..row() }), "drive.tracks[7].from_step");
        assert_eq!(field(Track { steps_per_cell: 0, ..row() }), "drive.tracks[7].steps_per_cell");
        assert_eq!(field(track(7, 1, AtEnd::Stay)), "drive.tracks[7].cells[6]");
        assert_eq!(field(Track { cells: vec![Point::new(0, 0), Point::new(2, 0)], ..row() }), "drive.tracks[7].cells[1]");
        assert_eq!(field(track(4, 1, AtEnd::Loop)), "drive.tracks[7].cells[0]");
        // On the goal (5, 2) it may pass and turn, but not stay.
        let to_goal = |at_end| Track { cells: vec![Point::new(4, 1), Point::new(5, 2)], at_end, ..row() };
        assert_eq!(field(to_goal(AtEnd::Stay)), "drive.tracks[7].cells");
        assert_eq!([AtEnd::Leave, AtEnd::Loop, AtEnd::BackAndForth].map(|at_end| field(to_goal(at_end))), ["Ok(())"; 3]);
        assert_eq!(field(Track { size: 3, ..to_goal(AtEnd::Loop) }), "drive.tracks[7].cells");
    }
}
