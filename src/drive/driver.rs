//! The robot, step by step.

use std::cell::OnceCell;
use std::sync::Arc;

use super::clairvoyant::{TooMuch, best_in_advance, reference};
use super::params::{DriveParams, Replan};
use super::pilot::Pilot;
use super::result::{Did, Drive, DriveStep, End, Stuck, digest, ratio, travel};
use super::surroundings::{Walls, differences, is_allowed, is_weighted, look, map_at, step_between};
use crate::error::{Error, ScenarioError};
use crate::map::{Cell, Grid, Point};
use crate::params::Values;
use crate::path::Path;
use crate::planner::{Effort, Planner};
use crate::scenario::{DriveSpec, Scenario};

/// A robot on its way.
#[derive(Clone)]
pub struct Driver {
    scenario: Arc<Scenario>,
    moving: DriveSpec,
    params: DriveParams,
    pilot: Pilot,
    walls: Walls,
    /// The map as it is, and as the robot knows it.
    now: Grid,
    known: Grid,
    /// Both as the robot feels them: blocked where it does not fit, dearer near obstacles.
    felt: [Grid; 2],
    /// Whether it has learnt of a change since it planned last.
    news: bool,
    at: Cell,
    /// From its cell to the goal; or why there is no path.
    path: Result<Path, Stuck>,
    /// Waits in a row, and those of them for the next cell of a path.
    waited: u32,
    held: u32,
    steps: Vec<DriveStep>,
    end: Option<End>,
    best: OnceCell<Result<Option<f64>, TooMuch>>,
}

impl Driver {
    /// A robot at the start of a scenario, before its first step; what moves is the scenario's `drive`. Nothing is planned yet.
    ///
    /// # Errors
    /// [`ScenarioError::Drive`] for several goals, movement by slices, or a planner of polylines; what [`crate::catalog::build`] says of
    /// planner and values.
    pub fn new(
        scenario: &Arc<Scenario>,
        planner: &str,
        preset: Option<&str>,
        values: &Values,
        seed: u32,
        params: DriveParams,
    ) -> Result<Self, Error> {
        check(scenario)?;
        let pilot = Pilot::new(scenario, planner, preset, values, seed, &params)?;
        let (scenario, moving) = (Arc::clone(scenario), scenario.spec.drive.clone().unwrap_or_default());
        let mut driver = Self {
            walls: Walls::new(scenario.drawn.clone()),
            now: scenario.drawn.clone(),
            known: scenario.drawn.clone(),
            felt: [scenario.grid.clone(), scenario.grid.clone()],
            news: false,
            at: scenario.start,
            path: Err(Stuck::NotFound),
            waited: 0,
            held: 0,
            steps: Vec::new(),
            end: (scenario.start == scenario.goal).then_some(End::Arrived),
            best: OnceCell::new(),
            scenario,
            moving,
            params,
            pilot,
        };
        let weighted = is_weighted(&driver.scenario).then_some(0.0);
        driver.see(Did::Start, (0.0, weighted), None);
        Ok(driver)
    }

    /// One step further: what was done; none once the drive has ended.
    pub fn step(&mut self) -> Option<&DriveStep> {
        if self.end.is_none() && self.taken() >= self.params.longest {
            self.end = Some(End::Stuck(Stuck::TooLong));
        }
        if self.end.is_some() {
            return None;
        }
        let planned = self.decide();
        match self.next() {
            Some(next) => self.go(next, planned),
            None if self.waited >= self.params.patience => {
                self.end = Some(End::Stuck(self.path.as_ref().err().copied().unwrap_or(Stuck::Held)));
                return None;
            }
            None => self.wait(planned),
        }
        self.steps.last()
    }

    /// To the end.
    pub fn run(&mut self) -> Drive {
        while self.step().is_some() {}
        self.drive()
    }

    /// Plans where that is due; what it has spent.
    fn decide(&mut self) -> Option<Effort> {
        let is_held = self.path.is_ok() && self.next().is_none() && self.held < self.params.hold;
        if is_held {
            self.held += 1;
            return None;
        }
        if !self.is_due() {
            return None;
        }
        let before = self.pilot.effort();
        self.path = self.pilot.plan(&self.scenario, &self.known, self.now.point(self.at));
        (self.news, self.held) = (false, 0);
        Some(self.pilot.effort().since(before))
    }

    /// Whether it plans before its next step: ants may find on another try what they have not found.
    fn is_due(&self) -> bool {
        match &self.path {
            Err(Stuck::NotFound) => true,
            Err(_) => self.news,
            Ok(path) => (self.news && self.params.replan == Replan::Changed) || !self.is_open(path),
        }
    }

    /// Whether a path is allowed on the map as the robot knows it.
    fn is_open(&self, path: &[Cell]) -> bool {
        path.windows(2).all(|step| is_allowed(&self.scenario, &self.felt[1], step[0], step[1]))
    }

    /// The next cell of its path, where it can go there now.
    fn next(&self) -> Option<Cell> {
        let next = *self.path.as_ref().ok()?.get(1)?;
        is_allowed(&self.scenario, &self.felt[0], self.at, next).then_some(next)
    }

    fn go(&mut self, next: Cell, planned: Option<Effort>) {
        let step = step_between(&self.scenario, &self.felt[0], self.at, next);
        self.at = next;
        (self.waited, self.held) = (0, 0);
        if let Ok(path) = &mut self.path {
            path.remove(0);
        }
        if next == self.scenario.goal {
            self.end = Some(End::Arrived);
        }
        self.see(Did::Move, step, planned);
    }

    fn wait(&mut self, planned: Option<Effort>) {
        self.waited += 1;
        self.see(Did::Wait, (0.0, None), planned);
    }

    /// What moves goes on, the robot looks around, and the step of this length and cost is noted.
    fn see(&mut self, did: Did, (length, cost): (f64, Option<f64>), planned: Option<Effort>) {
        let (step, at) = (self.steps.len() as u32, self.now.point(self.at));
        let walls = self.walls.at(step, &self.moving.changes);
        let now = map_at(&self.scenario.spec, walls, &self.moving.tracks, step, Some(at));
        let (blocked, freed) = differences(&self.now, &now);
        self.now = now;
        let is_news = look(&mut self.known, &self.now, at, self.moving.sight);
        self.news |= is_news;
        if !(blocked.is_empty() && freed.is_empty()) {
            self.felt[0] = self.scenario.spec.felt(&self.now);
        }
        if is_news {
            self.felt[1] = self.scenario.spec.felt(&self.known);
        }
        let length = self.length() + length;
        let cost = self.cost().map(|before| before + cost.unwrap_or(0.0)).or(cost);
        self.steps.push(DriveStep { step, did, at, length, cost, planned, blocked, freed });
    }

    /// Moves and waits so far.
    fn taken(&self) -> u32 {
        self.steps.len() as u32 - 1
    }

    /// Its steps so far, the first of them at the start.
    pub fn steps(&self) -> &[DriveStep] {
        &self.steps
    }

    /// The last of them.
    pub fn last(&self) -> &DriveStep {
        self.steps.last().expect("a drive begins with a step at the start")
    }

    /// The centre of each obstacle, none while it is not on the map, and how many cells a side it has.
    pub fn obstacles(&self) -> impl Iterator<Item = (Option<Point>, u32)> {
        let (step, at) = (self.taken(), self.at());
        self.moving
            .tracks
            .iter()
            .map(move |track| (track.clear_of(step, at, |squared| self.scenario.spec.touches(squared)), track.size))
    }

    /// The cells that the robot takes for blocked and that are free, and those that it takes for free and that are blocked.
    pub fn mistaken(&self) -> (Vec<Point>, Vec<Point>) {
        differences(&self.now, &self.known)
    }

    /// How the drive has ended; none while it goes on.
    pub fn end(&self) -> Option<End> {
        self.end
    }

    /// The map as it is.
    pub fn map(&self) -> &Grid {
        &self.now
    }

    /// The map as the robot knows it.
    pub fn known(&self) -> &Grid {
        &self.known
    }

    /// Where it stands.
    pub fn at(&self) -> Point {
        self.now.point(self.at)
    }

    /// The rest of its path, from its cell to the goal; empty without one.
    pub fn path(&self) -> &[Cell] {
        self.path.as_deref().unwrap_or_default()
    }

    /// Its planner, as the last planning has left it; none before the first.
    pub fn planner(&self) -> Option<&dyn Planner> {
        self.pilot.planner()
    }

    /// What the drive comes to so far. The reference is searched for when it is first asked for.
    pub fn drive(&self) -> Drive {
        let (length, waits) = (self.length(), self.steps.iter().filter(|step| step.did == Did::Wait).count() as u32);
        let found = *self.best.get_or_init(|| best_in_advance(&self.scenario));
        let best = found.ok().flatten().filter(|_| self.end == Some(End::Arrived));
        let (turns, travel_time) = travel(&self.scenario.spec, &self.steps);
        Drive {
            end: self.end,
            length,
            cost: self.cost(),
            moves: self.taken() - waits,
            waits,
            turns,
            travel_time,
            replans: self.pilot.plans().saturating_sub(1),
            effort: self.pilot.effort(),
            clairvoyant: reference(found),
            too_much: found.err(),
            ratio: best.map(|best| ratio(self.cost().unwrap_or(length), best)),
            digest: digest(&self.steps, self.end).hex(),
        }
    }

    /// Length of its way so far, in cells.
    fn length(&self) -> f64 {
        self.steps.last().map_or(0.0, |step| step.length)
    }

    /// What it has cost, in cells; none where ways cost their length.
    fn cost(&self) -> Option<f64> {
        self.steps.last().and_then(|step| step.cost)
    }
}

/// Whether a robot can drive in a scenario: from cell to cell, and to one goal.
fn check(scenario: &Scenario) -> Result<(), ScenarioError> {
    let (field, value, allowed) = match scenario.goals.len() {
        1 if scenario.by_slices().is_none() => return Ok(()),
        1 => ("terrain.slices", "by slices".to_owned(), "absent: a robot drives from cell to cell"),
        count => ("goals", count.to_string(), "a list of one goal"),
    };
    Err(ScenarioError::Drive { field: field.into(), value, allowed })
}
