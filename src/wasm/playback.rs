//! Looking back at a run, and into one of its cells.
//!
//! Numbers cross as plain lists: the page asks many times a second, and the opening build has to be small.

use tsify::Ts;
use wasm_bindgen::prelude::*;

use super::Answer;
use super::arguments::{self, Number};
use super::run::Run;
use crate::map::Cell;
use crate::planner::Layer;
use crate::planner::playback::Playback;

#[wasm_bindgen]
impl Run {
    /// Keeps snapshots from here on, up to so many bytes; to be called before the first step. Walks stay as they are. Without it every look
    /// back is a repetition from the beginning.
    pub fn keep_snapshots(&mut self, bytes: &Number) -> Answer<()> {
        self.playback = Playback::new(&*self.planner, bytes.whole("bytes")?);
        Ok(())
    }

    /// What is kept to look back: how many snapshots, the bytes that they hold, the bytes that they may hold, by how many iterations they are
    /// apart at least, and the most iterations that a look back repeats.
    pub fn snapshots(&self) -> Vec<u32> {
        let kept = self.playback.summary();
        vec![kept.snapshots, kept.bytes, kept.budget, kept.stride, kept.most_repeated]
    }

    /// Looks back: `paint`, `ants`, `best_path`, `summary`, `history`, `layer` and `moves_from` answer as at the end of that iteration, the
    /// last one if it has not been reached; null or undefined for where the run stands. The run itself is left as it is. Repeats at most
    /// `at_most` iterations: false when it is not there yet, until when they answer as before, and it is to be called again.
    pub fn show_iteration(&mut self, iteration: Option<Number>, at_most: &Number) -> Answer<bool> {
        let at_most = at_most.whole("at_most")?;
        let Some(iteration) = iteration else {
            (self.replay, self.past) = (None, None);
            self.looks += 1;
            return Ok(true);
        };
        let iteration = iteration.whole("iteration")?.min(self.iteration());
        if self.replay.as_ref().is_none_or(|replay| !replay.leads_to(iteration)) {
            self.replay = Some(self.playback.back_to(iteration, self.past.as_deref()));
        }
        let arrived = self.replay.as_mut().is_some_and(|replay| replay.go_on(at_most));
        if arrived {
            self.past = self.replay.take().map(|replay| replay.into_planner());
            self.looks += 1;
        }
        Ok(arrived)
    }

    /// The moves among which an ant on the cell (x, y) chooses that has visited nothing else, eight numbers each: the colony (the leg of a
    /// tour, from 0; of two teams 1 is the one from the goal), x, y, the level by slices (else 0), τ, η, τ^α·η^β as it is weighed, and the probability, by which
    /// those of each colony add up to 1. By slices at a level of the cell, counted from 1. Empty where no ant goes on, and beyond the map.
    pub fn moves_from(&self, x: &Number, y: &Number, level: &Number) -> Answer<Vec<f64>> {
        let (x, y, level) = (x.whole("x")?, y.whole("y")?, level.whole("level")?);
        let grid = &self.scenario.grid;
        let (width, area) = (grid.width(), grid.len() as Cell);
        if x >= width || y >= grid.height() {
            return Ok(Vec::new());
        }
        let place = level.saturating_mul(area).saturating_add(y * width + x);
        let mut rows = Vec::new();
        for m in self.shown().moves_from(place) {
            let (cell, level) = (m.to % area, m.to / area);
            rows.extend([m.colony, cell % width, cell / width, level].map(f64::from));
            rows.extend([m.trail, m.heuristic, m.weight, m.probability]);
        }
        Ok(rows)
    }

    /// By slices the level at which `moves_from` has most to tell of a cell: where the best path passes it, else the lowest above the ground.
    /// 0 where there is none, and elsewhere.
    #[cfg(feature = "whole")]
    pub fn level_at(&self, x: &Number, y: &Number) -> Answer<u32> {
        let (x, y) = (x.whole("x")?, y.whole("y")?);
        let Some(slices) = &self.map().slices else { return Ok(0) };
        let cell = y.saturating_mul(self.scenario.grid.width()).saturating_add(x);
        let passed = self.shown().best().and_then(|best| best.path.iter().find(|&&place| slices.cell(place) == cell));
        let lowest =
            || (1..=slices.rules().levels).map(|level| cell + slices.area() * level).find(|&place| slices.is_free(place));
        Ok(passed.copied().or_else(|| (cell < slices.area()).then(lowest)?).map_or(0, |place| place / slices.area()))
    }

    /// One value a cell, row by row; empty when the planner has no such layer.
    pub fn layer(&self, kind: Ts<Layer>) -> Answer<Vec<f32>> {
        let mut field = Vec::new();
        let known = self.shown().layer(arguments::word(&kind.js_value(), "kind")?, &mut field);
        Ok(if known { field } else { Vec::new() })
    }
}
