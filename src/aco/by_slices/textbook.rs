//! The textbook's colony in three dimensions: the program on path planning by an ant colony over the terrain `HeightData` in 史峰, 王辉, 郁磊,
//! 胡斐, *MATLAB智能算法30个案例分析* (Shi Feng, Wang Hui, Yu Lei, Hu Fei, "30 case studies of intelligent algorithms in MATLAB"), 北京航空航天大学
//! 出版社 (Beihang University Press), 2011. Movement by slices is its model, the cost its objective, and the terrain the one that the
//! terrain paper (`docs/papers/terrain.md`) uses. We know the program from copies in public repositories, which agree in all that stands here.
//!
//! | override point | the program |
//! |---|---|
//! | initial trail | 1 on every place |
//! | heuristic | S·M·D: S = 1 above the ground and 0 in it; M = 30/(h' + 1); D = 50/(d + r), d the step's length, r the distance left |
//! | selection | Eq. 1 of every colony, with α = β = 1 |
//! | on each move | a part of a place's trail leaves |
//! | update | τ ← (1 − ρ)·τ + ρ·K/C_bs on the places of the best path so far, its ends left out, and there only |
//! | daemon actions | none |
//!
//! In d and r a level counts as 0.2 cells: on its map levels are 200 m and cells 1 km. 30 and 50 are common to all steps and cancel.
//!
//! `reading` decides where the program does not do what it says:
//!
//! | place | `printed`: what runs | `repaired`: what it says |
//! |---|---|---|
//! | local update | the place one column *beyond* the one entered, same row and level: index x + 1 | the place entered |
//! | what leaves locally | 0.5, a number in the line; preset `printed` sets it | 0.1: `decr = 0.9`, "rate of decay of trails", which nothing reads |
//! | r in D | by the row of the *current* place | by the row of the next one, whose column and level it has |
//!
//! Ours: the last step obeys the rules of the scenario as all others do; the program puts the goal behind column 20 however far it is. So ants
//! can miss it, and `dead_end` decides. Rows and levels are those of the scenario; the program stays within 1 to 19. The program's run before
//! its loop of 100 is one of the iterations. K is `reward`.

use std::sync::Arc;

use super::colony::{Built, Numbers, Rules, SliceColony};
use super::trails::RowTrails;
use crate::aco::shared_params::{SelectionParams, WalkParams};
use crate::error::ParamError;
use crate::map::{Cell, Slices};
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset, Reading};
use crate::scenario::Scenario;

params! {
    /// Parameters of the textbook's colony.
    pub struct TextbookParams {
        /// how the program is read where it does not do what it says
        reading: Reading = Reading::Repaired, "", [], "", "ours: see the planner's file";
        /// ants that build a path in each iteration
        ants: u32 = 10, "m", [1..=1024], "ants", "the textbook's program";
        ..selection: SelectionParams {
            iterations = 100, "the textbook's program";
            alpha = 1.0, "the textbook's program";
            beta = 1.0, "the textbook's program";
        };
        /// by slices: as how many cells one level counts in the distances of η
        level_height: f64 = 0.2, "", [0.0..=10.0], "cells", "the textbook's program";
        /// evaporation rate: the part that leaves in each iteration, on the best path so far only
        rho: f64 = 0.2, "ρ", [0.0..=1.0], "", "the textbook's program";
        /// local evaporation rate: the part of a place's trail that an ant takes away by stepping there
        local_rho: f64 = 0.1, "λ_local", [0.0..=1.0], "", "the textbook's program: decr, its words; 0.5 is what runs";
        /// the trail towards which the best path so far pulls is K / cost
        reward: f64 = 100.0, "K", [1e-6..=1e6], "", "the textbook's program";
        /// trail of every place before the first iteration
        initial_trail: f64 = 1.0, "τ0", [1e-6..=1e6], "", "the textbook's program";
        ..walk: WalkParams;
    }
}

/// S·M·D of a step from one place (row, level) to the next over the ground, with `left` columns to go from there to the goal (row, level).
pub fn visibility(reading: Reading, level_height: f64, from: (f64, f64), to: (f64, f64), left: f64, goal: (f64, f64)) -> f64 {
    let high = |a: f64, b: f64| (a - b) * level_height;
    let length = |x: f64, y: f64, h: f64| libm::sqrt(x * x + y * y + h * h);
    let row = if reading == Reading::Printed { from.0 } else { to.0 };
    let step = length(1.0, to.0 - from.0, high(to.1, from.1));
    let rest = length(left, goal.0 - row, high(goal.1, to.1));
    30.0 / (to.1 + 1.0) * (50.0 / (step + rest))
}

/// The textbook's colony.
#[derive(Debug, Clone, Copy)]
pub struct Textbook {
    params: TextbookParams,
}

impl Textbook {
    /// With these parameters.
    pub fn new(params: TextbookParams) -> Self {
        Self { params }
    }
}

impl Rules for Textbook {
    const ON_PLACES: bool = true;

    fn numbers(&self) -> Numbers {
        let p = &self.params;
        Numbers { ants: p.ants, selection: p.selection, q0: 0.0, walk: p.walk }
    }

    fn initial_trail(&self, _: &Slices) -> f64 {
        self.params.initial_trail
    }

    fn eta(&self, slices: &Slices, from: Cell, to: Cell) -> f64 {
        let at = |place: Cell| {
            let (_, y, h) = slices.at(place);
            (f64::from(y), f64::from(h))
        };
        let left = slices.at(to).0.abs_diff(slices.at(slices.goal()).0);
        visibility(self.params.reading, self.params.level_height, at(from), at(to), f64::from(left), at(slices.goal()))
    }

    fn on_move(&self, trails: &mut RowTrails, slices: &Slices, (_, _, to): (Cell, usize, Cell)) {
        let ahead = self.params.reading == Reading::Printed;
        if ahead && to == slices.goal() {
            return;
        }
        let onward = if slices.at(slices.goal()).0 > slices.at(slices.start()).0 { 1 } else { -1 };
        trails.blend(if ahead { to.wrapping_add_signed(onward) } else { to }, 0, self.params.local_rho, 0.0);
    }

    fn update(&mut self, trails: &mut RowTrails, built: Built) {
        let Some(best) = built.best else { return };
        let between = best.path.len().saturating_sub(2);
        for &place in best.path.iter().skip(1).take(between) {
            trails.blend(place, 0, self.params.rho, self.params.reward / best.length);
        }
    }
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let rules = Textbook::new(TextbookParams::read(ENTRY.id, values)?);
    Ok(Box::new(SliceColony::new(scenario, rules, ENTRY.id, seed)?))
}

const SOURCE: &str = "Shi, Wang, Yu, Hu 2011, 30 case studies of intelligent algorithms in MATLAB (in Chinese), Beihang University Press: its program on three dimensions";

/// The textbook's colony in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "terrain-textbook",
    name: "Textbook's 3-D colony",
    family: Family::AntColony,
    summary: "The textbook's colony by slices: trails lie on places, ants prefer low and short steps, and the best path so far pulls the trails towards K/cost.",
    source: SOURCE,
    presets: &[
        Preset {
            name: "printed",
            source: SOURCE,
            meaning: "the program as it runs: half of a trail leaves one column beyond the place entered, the distance left by the row before the step",
            numbers: &[("local_rho", 0.5)],
            choices: &[("reading", "printed")],
            reading: Some(PaperReading::Printed),
        },
        Preset {
            name: "terrain",
            source: "terrain paper, Table 1",
            meaning: "50 ants, 100 iterations, α = 1 and β = 7, the numbers of the colonies that it is compared with; the rest stays",
            numbers: &[("ants", 50.0), ("iterations", 100.0), ("alpha", 1.0), ("beta", 7.0)],
            choices: &[],
            reading: None,
        },
    ],
    components: &[],
    layers: &[Layer::Trail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: &[Ground::Slices],
    specs: TextbookParams::specs,
    build,
};
