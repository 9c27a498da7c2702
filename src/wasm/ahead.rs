//! One ant of a run, on a copy that looks ahead.

use std::sync::Arc;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::Number;
use super::run::Run;
use super::{Answer, object};
use crate::map::{Cell, Point};
use crate::planner::ahead::Ahead;
use crate::planner::{Fate, MoveOdds, Turn};
use crate::scenario::Scenario;

/// A move that an ant weighs.
#[derive(Serialize, Tsify)]
pub struct AntMove {
    /// The cell to which it leads.
    #[tsify(type = "[number, number]")]
    pub to: Point,
    /// By slices its level, else 0.
    pub level: u32,
    /// τ.
    pub trail: f64,
    /// η.
    pub heuristic: f64,
    /// τ^α·η^β as the ant weighs it, τ and η divided by their largest; 0 for what it has visited.
    pub weight: f64,
    /// By the planner's own rule.
    pub probability: f64,
}

/// One ant: where it stands, what it weighs, and what it does then.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct AntTurn {
    /// What became of it.
    pub fate: Fate,
    /// Its way from its origin on, without what it took back.
    #[tsify(type = "[number, number][]")]
    pub way: Vec<Point>,
    /// By slices the level at which it stands, else 0.
    pub level: u32,
    /// What it weighs; empty once it has ended.
    pub moves: Vec<AntMove>,
    /// Which of `moves` it takes; null at a dead end, and once it has ended.
    pub takes: Option<u32>,
    /// Where it goes; at a dead end a step back. Null where it gives up, and once it has ended.
    #[tsify(type = "[number, number] | null")]
    pub next: Option<Point>,
}

/// A copy of a run that goes ahead of it, or of what it was at the iteration that is looked at.
#[wasm_bindgen]
pub struct LookAhead {
    scenario: Arc<Scenario>,
    ahead: Ahead,
}

#[wasm_bindgen]
impl Run {
    /// Looks ahead from the iteration that is looked at, or from where the run stands, between two iterations. The run stays as it is.
    pub fn look_ahead(&self) -> LookAhead {
        LookAhead { scenario: Arc::clone(&self.scenario), ahead: Ahead::of(self.shown()) }
    }
}

#[wasm_bindgen]
impl LookAhead {
    /// On until so many moves of the iteration are made, or it is over; the moves made. It never goes back.
    pub fn go_to(&mut self, moves: &Number) -> Answer<u32> {
        Ok(self.ahead.go_to(moves.whole("moves")?))
    }

    /// Whether the iteration has ended, and with it the walks of all its ants.
    pub fn is_over(&self) -> bool {
        self.ahead.is_over()
    }

    /// An ant by its number from 0; with several goals those of the first leg come first. Null where there is no such ant.
    pub fn ant(&self, number: &Number) -> Answer<Option<Ts<AntTurn>>> {
        let turn = self.ahead.turn(number.whole("number")?);
        Ok(turn.map(|turn| object(&self.told(&turn))))
    }

    /// The cell of each ant, x and y, by number; −1, −1 for lost ones. Empty before the first move.
    pub fn ants(&self) -> Vec<i32> {
        let xy = |place: Option<Cell>| place.map_or([-1, -1], |place| [self.point(place).x as i32, self.point(place).y as i32]);
        self.ahead.ants().into_iter().flat_map(xy).collect()
    }
}

impl LookAhead {
    fn told(&self, turn: &Turn) -> AntTurn {
        AntTurn {
            fate: turn.walked.fate,
            way: turn.walked.way.iter().map(|&place| self.point(place)).collect(),
            level: turn.walked.way.last().map_or(0, |&place| self.level(place)),
            moves: turn.odds.iter().map(|odds| self.weighed(odds)).collect(),
            takes: turn.odds.iter().position(|m| turn.next == Some(m.to) && m.weight > 0.0).map(|at| at as u32),
            next: turn.next.map(|place| self.point(place)),
        }
    }

    fn weighed(&self, odds: &MoveOdds) -> AntMove {
        let MoveOdds { to, trail, heuristic, weight, probability, .. } = *odds;
        AntMove { to: self.point(to), level: self.level(to), trail, heuristic, weight, probability }
    }

    fn point(&self, place: Cell) -> Point {
        self.scenario.grid.point(place % self.scenario.grid.len() as Cell)
    }

    fn level(&self, place: Cell) -> u32 {
        place / self.scenario.grid.len() as Cell
    }
}
