//! One planner at work on one scenario, for a panel's worker.

use std::cell::RefCell;
use std::sync::Arc;

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{self, Bytes, Context, Flag, Heights, LayerOrNone, Number, ParamValues, Text, ThemeName};
use super::paint::{Canvas, Moment, Style, Underfoot, layer_of};
use super::{Answer, grid, object, scenario, throw};
use crate::metrics::Metrics;
use crate::planner::playback::{Playback, Replay};
use crate::planner::{Effort, Granularity, Layer, Objective, Planner, Record, Status, Tour};
use crate::scenario::{Scenario, ScenarioSpec};

#[cfg(not(feature = "whole"))]
use crate::catalog::build;
#[cfg(feature = "whole")]
use crate::catalog::build_changing as build;

/// What the types of the package call parameter values by key.
#[wasm_bindgen(typescript_custom_section)]
const PARAM_INPUT: &str = r#"
/** Parameter values by key. */
export type ParamInput = Record<string, number | string | boolean>;
"#;

/// Where a run stands.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct RunSummary {
    /// Whether and how it has ended.
    pub status: Status,
    /// Finished iterations.
    pub iteration: u32,
    /// Budget of iterations; null for a search.
    pub iteration_budget: Option<u32>,
    /// The iteration that found the best path.
    pub iteration_of_best: Option<u32>,
    /// Metrics of the best path; null while there is none.
    pub metrics: Option<Metrics>,
    /// What the result is measured by; `value` is compared with this objective's reference.
    pub objective: Objective,
    /// The result's value by that objective, in cells; null while there is none.
    pub value: Option<f64>,
    /// Length in cells before refinement; null where the planner does not refine its path.
    pub unrefined_length: Option<f64>,
    /// The order of the goals; null for a planner that chooses none.
    pub tour: Option<Tour>,
    /// What has been spent.
    pub effort: Effort,
    /// Ants that arrived in the last finished iteration.
    pub arrived: u32,
    /// Ants per iteration; 0 for a search.
    pub ants: u32,
    /// Moves made of the iteration at work; 0 between two, and of the past.
    pub moves: u32,
    /// How many changes of the walls have been made; the opening build knows none.
    #[cfg(feature = "whole")]
    #[tsify(optional)]
    pub changes: u32,
    /// 16 hexadecimal digits over best path, length and history of the finished iterations.
    pub digest: String,
}

/// A planner at work.
#[wasm_bindgen]
pub struct Run {
    pub(super) scenario: Arc<Scenario>,
    pub(super) planner: Box<dyn Planner>,
    /// What is kept to look back; the beginning alone before [`Run::keep_snapshots`].
    pub(super) playback: Playback,
    /// On its way to the iteration that is to be looked at.
    pub(super) replay: Option<Replay>,
    /// How the planner stood at the iteration that is looked at.
    pub(super) past: Option<Box<dyn Planner>>,
    /// Painted in place of the map, for as long as a change is to come.
    #[cfg(feature = "whole")]
    pub(super) drawn: Option<super::changes::Drawn>,
    /// Moves made since the last iteration ended.
    moves: u32,
    /// How often it has advanced by a move or an iteration.
    steps: u32,
    /// How often something else was to be looked at: the past, or other walls.
    pub(super) looks: u32,
    layers: &'static [Layer],
    canvas: RefCell<Canvas>,
    /// Metrics of the best path, the iteration that found it, and the changes of the map so far: measured once per improvement, not per frame.
    measured: RefCell<Option<(u32, u32, Metrics)>>,
}

#[wasm_bindgen]
impl Run {
    /// Makes a run; nothing is computed before the first `advance`.
    #[wasm_bindgen(constructor)]
    pub fn new(
        spec: Ts<ScenarioSpec>,
        cells: &Bytes,
        heights: Option<Heights>,
        factors: Option<Heights>,
        planner: &Text,
        params: &ParamValues,
        seed: &Number,
    ) -> Answer<Run> {
        let scenario = scenario(&spec, cells, [heights.as_ref(), factors.as_ref()])?;
        let (planner, seed) = (planner.read("planner")?, seed.whole("seed")?);
        let values = params.read("params")?;
        let layers = crate::catalog::find(&planner).map_err(throw)?.layers;
        let planner = build(&scenario, &planner, None, &values, seed).map_err(throw)?;
        let (canvas, measured) = Default::default();
        let playback = Playback::new(&*planner, 0);
        Ok(Run {
            scenario,
            planner,
            playback,
            replay: None,
            past: None,
            #[cfg(feature = "whole")]
            drawn: None,
            moves: 0,
            steps: 0,
            looks: 0,
            layers,
            canvas,
            measured,
        })
    }

    /// Advances by up to `count` moves or iterations; stops early when finished.
    pub fn advance(&mut self, by: Ts<Granularity>, count: &Number) -> Answer<Ts<Status>> {
        let by = arguments::word(&by.js_value(), "by")?;
        for _ in 0..count.whole("count")? {
            let iteration = self.iteration();
            self.steps = self.steps.wrapping_add(1);
            let finished = self.planner.advance(by).is_finished();
            self.moves = if self.iteration() == iteration { self.moves + 1 } else { 0 };
            self.playback.note(&*self.planner, by);
            if finished {
                break;
            }
        }
        Ok(self.status())
    }

    /// Whether and how the run has ended.
    pub fn status(&self) -> Ts<Status> {
        object(&self.planner.status())
    }

    /// Finished iterations.
    pub fn iteration(&self) -> u32 {
        self.planner.effort().iterations
    }

    /// Where the run stands, or stood at the iteration that is looked at.
    pub fn summary(&self) -> Ts<RunSummary> {
        let planner = self.shown();
        let last: Option<&Record> = planner.history().last();
        object(&RunSummary {
            status: planner.status(),
            iteration: planner.effort().iterations,
            iteration_budget: planner.budget(),
            iteration_of_best: planner.best().map(|b| b.iteration),
            metrics: self.metrics(),
            objective: planner.objective(),
            value: self.metrics().and_then(|m| planner.value(&m)),
            unrefined_length: planner.best().filter(|b| b.refined.is_some()).map(|b| b.length),
            tour: planner.tour().cloned(),
            effort: planner.effort(),
            arrived: last.map_or(0, |r| r.arrived),
            ants: planner.colony_size(),
            moves: if self.past.is_none() { self.moves } else { 0 },
            #[cfg(feature = "whole")]
            changes: self.changes(),
            digest: planner.digest().hex(),
        })
    }

    /// Rows of the history from `from_row` on: iteration, best so far, iteration best, mean, worst, arrived; NaN where no ant arrived.
    pub fn history(&self, from_row: &Number) -> Answer<Vec<f64>> {
        let rows = self.shown().history().get(from_row.whole("from_row")? as usize..).unwrap_or_default();
        let real = |v: Option<f64>| v.unwrap_or(f64::NAN);
        let numbers = rows
            .iter()
            .flat_map(|r| {
                let lengths = [r.best_so_far, r.iteration_best, r.iteration_mean, r.iteration_worst].map(real);
                [f64::from(r.iteration), lengths[0], lengths[1], lengths[2], lengths[3], f64::from(r.arrived)]
            })
            .collect();
        Ok(numbers)
    }

    /// Number of rows of the history.
    pub fn history_rows(&self) -> usize {
        self.shown().history().len()
    }

    /// The best path, refined where the planner does so, as x0, y0, x1, y1, …; empty while there is none.
    pub fn best_path(&self) -> Vec<u32> {
        self.shown().best().map_or_else(Vec::new, |b| self.points(b.result().0))
    }

    /// Altitude in metres of each place of the best path: on the ground of a terrain, by slices at its level; empty on a plane.
    pub fn best_altitudes(&self) -> Vec<f64> {
        self.shown().best().map_or_else(Vec::new, |b| self.scenario.altitudes(b.result().0))
    }

    /// x, y of every living ant of the current iteration.
    pub fn ants(&self) -> Vec<u32> {
        let mut cells = Vec::new();
        self.shown().ants(&mut cells);
        self.points(&cells)
    }

    /// The layers that `paint` knows for this planner.
    pub fn layers(&self) -> Vec<Ts<Layer>> {
        self.layers.iter().map(object).collect()
    }

    /// Paints map and layer into a canvas of width × height pixels, one pixel a cell; a terrain with light and shade or, not `shaded`, in
    /// the ground's colours alone. Cells without data stay clear. The colours go from the lower to the upper value of `ends`, or, with null, from
    /// the smallest to the largest of the layer over the free cells. Gives those two; empty where the layer has no finite value.
    pub fn paint(
        &self,
        context: &Context,
        layer: &LayerOrNone,
        theme: &ThemeName,
        shaded: &Flag,
        ends: Option<Heights>,
    ) -> Answer<Vec<f32>> {
        let layer = layer_of(layer)?;
        let style = Style::of(theme, cells_per_unit(&self.scenario.spec), shaded)?;
        let ends = ends.map(|ends| ends_of(&ends)).transpose()?;
        let shown = (self.shown(), self.moment_of(layer));
        let own = self.canvas.borrow_mut().paint(context, self.underfoot(), shown, layer, style, ends)?;
        Ok(own.map_or_else(Vec::new, |own| own.to_vec()))
    }

    /// What `paint` would show with a layer, as four numbers: while they stay the same it paints the same picture by the same theme and ends.
    pub fn moment(&self, layer: &LayerOrNone) -> Answer<Vec<f64>> {
        let Moment { looks, changes, version, steps } = self.moment_of(layer_of(layer)?);
        Ok(vec![looks.into(), changes.into(), version.map_or(-1.0, |version| version as f64), steps.into()])
    }
}

/// Paints a map without a run on it, for a panel whose planner refuses: one pixel a cell, as [`Run::paint`] does.
#[wasm_bindgen]
pub fn paint_map(
    context: &Context,
    spec: Ts<ScenarioSpec>,
    cells: &Bytes,
    heights: Option<Heights>,
    factors: Option<Heights>,
    theme: &ThemeName,
    shaded: &Flag,
) -> Answer<()> {
    let spec: ScenarioSpec = arguments::value(&spec, "spec")?;
    let grid = grid(spec.width, spec.height, cells, [heights.as_ref(), factors.as_ref()])?;
    let style = Style::of(theme, cells_per_unit(&spec), shaded)?;
    #[cfg(feature = "whole")]
    if spec.robot.is_some() && spec.check(&grid).is_ok() {
        let felt = spec.felt(&grid);
        return Canvas::default().paint_map(context, Underfoot { grid: &felt, drawn: Some(&grid) }, style);
    }
    let map = Underfoot {
        grid: &grid,
        #[cfg(feature = "whole")]
        drawn: None,
    };
    Canvas::default().paint_map(context, map, style)
}

/// Two numbers, the smaller one first.
fn ends_of(given: &Heights) -> Answer<[f32; 2]> {
    match given.read("ends")?[..] {
        [low, high] if low.is_finite() && high.is_finite() && low <= high => Ok([low, high]),
        _ => Err(arguments::not("ends", "two numbers, the smaller one first")),
    }
}

/// Cells per unit of the heights; 1 on a plane, which has none.
fn cells_per_unit(spec: &ScenarioSpec) -> f64 {
    spec.terrain.map_or(1.0, |terrain| terrain.vertical_unit / spec.resolution)
}

impl Run {
    /// The planner that everything but stepping asks: as it stands, or as it stood.
    pub(super) fn shown(&self) -> &dyn Planner {
        self.past.as_deref().unwrap_or(&*self.planner)
    }

    /// The map alone is where no layer is shown.
    fn moment_of(&self, layer: Option<Layer>) -> Moment {
        let version = layer.map_or(Some(0), |kind| self.shown().layer_version(kind));
        let steps = if version.is_some() { 0 } else { self.steps };
        Moment { looks: self.looks, changes: self.changes(), version, steps }
    }

    /// The map that it is on, as changes have left it.
    #[cfg(feature = "whole")]
    pub(super) fn map(&self) -> &Scenario {
        self.shown().changing().map_or(&self.scenario, |changing| changing.scenario())
    }

    /// How often the map has changed.
    #[cfg(feature = "whole")]
    fn changes(&self) -> u32 {
        self.shown().changing().map_or(0, |changing| changing.made())
    }

    /// The opening build knows no changes.
    #[cfg(not(feature = "whole"))]
    pub(super) fn map(&self) -> &Scenario {
        &self.scenario
    }

    #[cfg(not(feature = "whole"))]
    fn underfoot(&self) -> Underfoot<'_> {
        Underfoot { grid: &self.scenario.grid }
    }

    #[cfg(not(feature = "whole"))]
    fn changes(&self) -> u32 {
        0
    }

    fn points(&self, cells: &[u32]) -> Vec<u32> {
        let width = self.scenario.grid.width();
        self.scenario.cells_of(cells).iter().flat_map(|&c| [c % width, c / width]).collect()
    }

    fn metrics(&self) -> Option<Metrics> {
        let best = self.shown().best()?;
        let mut measured = self.measured.borrow_mut();
        let changes = self.changes();
        if measured.is_none_or(|(iteration, made, _)| (iteration, made) != (best.iteration, changes)) {
            *measured = Some((best.iteration, changes, Metrics::of(self.map(), best.result().0)));
        }
        measured.map(|(.., metrics)| metrics)
    }
}
