//! What a drive comes to.

use serde::Serialize;

use super::clairvoyant::TooMuch;
use crate::digest::Digest;
use crate::exact::Reference;
use crate::map::Point;
use crate::metrics::SAME_LENGTH;
use crate::planner::Effort;
use crate::scenario::ScenarioSpec;

/// What a robot did in a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Did {
    /// It stood at the start, before its first step.
    Start,
    /// It moved to another cell.
    Move,
    /// It waited.
    Wait,
}

/// A step of a drive, and the map after it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct DriveStep {
    /// Moves and waits so far.
    pub step: u32,
    /// What it did.
    pub did: Did,
    /// Where it stands then.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub at: Point,
    /// Length of its way so far, in cells.
    pub length: f64,
    /// On weighted ground, and with costs near obstacles: what its way has cost so far, in cells; absent where it costs its length.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub cost: Option<f64>,
    /// What the planning before it has spent; absent where it kept its path.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub planned: Option<Effort>,
    /// Cells that are blocked after it and were not before.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub blocked: Vec<Point>,
    /// Cells that are free after it and were not before.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub freed: Vec<Point>,
}

/// Why a robot gave up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Stuck {
    /// On the map as it knows it no path leads to the goal.
    NoPath,
    /// The planner found none in its iterations.
    NotFound,
    /// Something stands on the goal, as far as it knows.
    GoalTaken,
    /// It touches a wall that was not there before.
    NoRoom,
    /// The next cell of its path was taken for all its patience.
    Held,
    /// It has driven for as many steps as it may.
    TooLong,
}

/// How a drive ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", content = "why", rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum End {
    /// At the goal.
    Arrived,
    /// Elsewhere.
    Stuck(Stuck),
}

/// What a drive comes to. Lengths and costs in cells.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Drive {
    /// How it ended; null while it goes on.
    pub end: Option<End>,
    /// Length of its way.
    pub length: f64,
    /// On weighted ground, and with costs near obstacles: what its way has cost; absent where it costs its length.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub cost: Option<f64>,
    /// Steps in which it moved.
    pub moves: u32,
    /// Steps in which it waited.
    pub waits: u32,
    /// Moves in another direction than the move before, whatever waits lie between.
    pub turns: u32,
    /// Arrival time in seconds, or the time so far: metres / speed + turns · seconds per turn + waits, each of which lasts as long as a straight
    /// move by one cell.
    pub travel_time: f64,
    /// How often it has planned after the first time.
    pub replans: u32,
    /// What all plannings have spent.
    pub effort: Effort,
    /// The best drive of somebody who knows in advance what will move, by cost where there is one: see [`super::best_in_advance`].
    pub clairvoyant: Reference,
    /// Why that is unknown; absent where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub too_much: Option<TooMuch>,
    /// The cost, or the length, as a multiple of that; null unless it has arrived and the reference is known.
    pub ratio: Option<f64>,
    /// 16 hexadecimal digits over every step and the end.
    pub digest: String,
}

/// length / best; 1 where they differ by no more than what adding has rounded.
pub(super) fn ratio(length: f64, best: f64) -> f64 {
    if (length - best).abs() < SAME_LENGTH { 1.0 } else { length / best }
}

/// Turns of a drive, and its seconds so far.
pub(super) fn travel(spec: &ScenarioSpec, steps: &[DriveStep]) -> (u32, f64) {
    let between = |a: &DriveStep, b: &DriveStep| (i64::from(b.at.x) - i64::from(a.at.x), i64::from(b.at.y) - i64::from(a.at.y));
    let moves: Vec<_> = steps.windows(2).map(|pair| between(&pair[0], &pair[1])).filter(|&by| by != (0, 0)).collect();
    let turns = moves.windows(2).filter(|pair| pair[0] != pair[1]).count() as u32;
    let waits = steps.iter().filter(|step| step.did == Did::Wait).count() as f64;
    let (length, vehicle) = (steps.last().map_or(0.0, |last| last.length), spec.vehicle);
    (turns, (length + waits) * spec.resolution / vehicle.speed + f64::from(turns) * vehicle.seconds_per_turn)
}

/// Over every step, what was planned for it, and the end.
pub(super) fn digest(steps: &[DriveStep], end: Option<End>) -> Digest {
    let mut digest = Digest::default();
    for step in steps {
        [step.did as u32, step.at.x, step.at.y, u32::from(step.planned.is_some())].into_iter().for_each(|v| digest.u32(v));
        if let Some(Effort { iterations, constructed_paths, ant_moves, cell_expansions }) = step.planned {
            digest.u32(iterations);
            [constructed_paths, ant_moves, cell_expansions].into_iter().for_each(|v| digest.bytes(&v.to_le_bytes()));
        }
        digest.f64(step.cost.unwrap_or(step.length));
    }
    digest.u32(match end {
        None => 0,
        Some(End::Arrived) => 1,
        Some(End::Stuck(why)) => 2 + why as u32,
    });
    digest
}
