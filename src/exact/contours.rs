//! How a search advances: state by state, or contour by contour.

use crate::planner::{Granularity, Layer, Status};

/// A search that expands states in contours, whole numbers of f.
pub(super) trait Contours {
    /// Whether and how it has ended.
    fn status(&self) -> Status;
    /// Whether its tables are there: they are made at the first step, so that a search that is only shown costs nothing.
    fn is_prepared(&self) -> bool;
    /// Makes its tables and opens the start.
    fn prepare(&mut self);
    /// Expands one state; false when none is left in this contour.
    fn advance_one(&mut self) -> bool;
}

/// One state further, or to the end of the contour; inert once finished.
pub(super) fn advance(search: &mut impl Contours, by: Granularity) -> Status {
    if search.status().is_finished() {
        return search.status();
    }
    if !search.is_prepared() {
        search.prepare();
    }
    // A move that finds its contour empty goes on into the next one, so that every move expands a state.
    loop {
        let has_expanded = search.advance_one();
        let ends = if by == Granularity::Iteration { !has_expanded } else { has_expanded || search.status().is_finished() };
        if ends {
            break;
        }
    }
    search.status()
}

/// What a layer shows where the search has not been: nothing expanded, no cost known.
pub(super) fn untouched(kind: Layer) -> f32 {
    if kind == Layer::Cost { f32::INFINITY } else { 0.0 }
}
