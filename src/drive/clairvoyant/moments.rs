//! The map of each step, made when the search first comes to it.

use super::places::Places;
use crate::drive::surroundings::map_at;
use crate::map::{Cell, Grid, Point, Window};
use crate::scenario::{DriveSpec, Scenario};

/// How far a step reaches, in cells.
const STEP: u32 = 2;

/// How many places, one after the other, are noted together.
pub(super) const TOGETHER: usize = 16;

/// Least cost and fewest steps to a place; infinite where it was not reached.
type Known = (f64, u32);

/// A step of a drive: the map as the robot feels it while all go by their timetables, and what is known of each place.
pub(super) struct Moment {
    blocked: Vec<bool>,
    /// Factors of weighted ground; none where all are 1.
    factors: Option<Vec<f32>>,
    /// Of places that were reached, and those beside them.
    known: Vec<Option<Box<[Known; TOGETHER]>>>,
}

impl Moment {
    fn of(felt: &Grid, places: &Places) -> Self {
        let each = || places.cells.iter().map(|&cell| cell as usize);
        Self {
            blocked: each().map(|cell| felt.blocked()[cell]).collect(),
            factors: felt.factors().map(|factors| each().map(|cell| factors[cell]).collect()),
            known: vec![None; places.len().div_ceil(TOGETHER)],
        }
    }

    pub fn is_blocked(&self, place: usize) -> bool {
        self.blocked[place]
    }

    pub fn factor(&self, place: usize) -> f64 {
        self.factors.as_ref().map_or(1.0, |factors| f64::from(factors[place]))
    }

    pub fn known(&self, place: usize) -> Known {
        self.known[place / TOGETHER].as_ref().map_or((f64::INFINITY, u32::MAX), |known| known[place % TOGETHER])
    }
}

/// All steps, and the walls that they have.
pub(super) struct Moments<'a> {
    scenario: &'a Scenario,
    moving: &'a DriveSpec,
    /// By step.
    made: Vec<Option<Box<Moment>>>,
    /// How many are made, and of how many places something is noted in them.
    pub count: u64,
    pub states: u64,
    /// The walls as drawn, by the number of changes made.
    walls: Vec<Option<Grid>>,
}

impl<'a> Moments<'a> {
    pub fn new(scenario: &'a Scenario, moving: &'a DriveSpec) -> Self {
        let walls = vec![None; moving.changes.len() + 1];
        Self { scenario, moving, made: Vec::new(), count: 0, states: 0, walls }
    }

    /// A step that was made.
    pub fn get(&self, step: u32) -> &Moment {
        self.made[step as usize].as_deref().expect("a state is offered at a step that was made")
    }

    /// Notes that a place is reached at a step at this cost, in so many steps; true where that is better than what was known.
    pub fn reach(&mut self, step: u32, place: usize, (cost, taken): Known, places: &Places) -> bool {
        self.make(step, places);
        let moment = self.made[step as usize].as_deref_mut().expect("it was made");
        let (least, fewest) = moment.known(place);
        if cost > least || (cost == least && taken >= fewest) {
            return false;
        }
        let known = moment.known[place / TOGETHER].get_or_insert_with(|| {
            self.states += TOGETHER as u64;
            Box::new([(f64::INFINITY, u32::MAX); TOGETHER])
        });
        known[place % TOGETHER] = (cost, taken);
        true
    }

    /// Makes a step where it is not made yet.
    fn make(&mut self, step: u32, places: &Places) {
        let index = step as usize;
        if self.made.len() <= index {
            self.made.resize_with(index + 1, || None);
        }
        if self.made[index].is_none() {
            let felt = self.scenario.spec.felt(&self.map(step, None));
            self.made[index] = Some(Box::new(Moment::of(&felt, places)));
            self.count += 1;
        }
    }

    /// The map of a step as it is; where the robot is, all keep clear of it.
    fn map(&mut self, step: u32, robot: Option<Point>) -> Grid {
        let changes = &self.moving.changes;
        let made = changes.partition_point(|change| change.at_step <= step);
        let walls = self.walls[made].get_or_insert_with(|| {
            let mut grid = self.scenario.drawn.clone();
            changes[..made].iter().for_each(|change| change.make(&mut grid));
            grid
        });
        map_at(&self.scenario.spec, walls, &self.moving.tracks, step, robot)
    }

    /// What a robot feels around its cell at a step in which something gives way to it.
    pub fn around(&mut self, step: u32, robot: Point) -> Around {
        let map = self.map(step, Some(robot));
        let Some(reach) = self.scenario.spec.reach() else { return Around { felt: map, left: 0, top: 0 } };
        let reach = reach.saturating_add(STEP).min(map.width().max(map.height()));
        let (left, top) = (robot.x.saturating_sub(reach), robot.y.saturating_sub(reach));
        let (right, below) = ((robot.x + reach).min(map.width() - 1), (robot.y + reach).min(map.height() - 1));
        let window = Window { x: left, y: top, width: right - left + 1, height: below - top + 1 };
        let map = map.cropped(window).expect("the window lies on the map");
        Around { felt: self.scenario.spec.felt(&map), left, top }
    }
}

/// A piece of a map around the robot, as it feels it.
pub(super) struct Around {
    felt: Grid,
    left: u32,
    top: u32,
}

impl Around {
    /// The cell of the piece; `at` is no farther from the robot than a step reaches, and on the map.
    fn cell(&self, at: Point) -> Cell {
        self.felt.cell(Point::new(at.x - self.left, at.y - self.top))
    }

    pub fn is_blocked(&self, at: Point) -> bool {
        self.felt.is_blocked(self.cell(at))
    }

    pub fn factor(&self, at: Point) -> f64 {
        self.felt.factors().map_or(1.0, |factors| f64::from(factors[self.cell(at) as usize]))
    }
}
