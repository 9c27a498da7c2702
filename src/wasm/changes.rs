//! Walls that change while a run goes on. Only the whole engine knows of it.

use serde::Deserialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments;
use super::paint::Underfoot;
use super::run::Run;
use super::{Answer, throw};
use crate::map::{Grid, Point};
use crate::planner::Changing;
use crate::scenario::{Change, ScenarioSpec};

/// Cells to block and to free.
#[derive(Deserialize, Tsify)]
pub struct Walls {
    /// Free cells that become blocked.
    #[tsify(type = "[number, number][]")]
    pub blocked: Vec<Point>,
    /// Blocked cells that become free.
    #[tsify(type = "[number, number][]")]
    pub freed: Vec<Point>,
}

/// A map that is painted before a run is on it.
pub(super) struct Drawn {
    /// As the robot will feel it, and as it will be drawn.
    grid: Grid,
    drawn: Grid,
    /// Until the run has had this many changes.
    until: u32,
}

#[wasm_bindgen]
impl Run {
    /// Changes walls at the end of the iteration at work, at once where none is. Returns its number; 0 = before the first. A planner that
    /// [adapts](Run::adapts) goes on with what it has learnt, any other begins anew. The map is painted with the change from now on.
    /// Looking back ends; what is kept to look back has the change.
    pub fn change_walls(&mut self, walls: Ts<Walls>) -> Answer<u32> {
        let Walls { blocked, freed } = arguments::value(&walls, "walls")?;
        let Some(changing) = self.planner.changing_mut() else { return Ok(0) };
        let change = Change { at: changing.next_end(), blocked, freed };
        changing.schedule(change.clone()).map_err(throw)?;
        self.drawn = coming(changing);
        self.looks += 1;
        (self.replay, self.past) = (None, None);
        self.playback.change(&*self.planner, &change);
        Ok(change.at)
    }

    /// Paints the map as it would be with these walls after all changes to come, until they are changed or others are shown; with none of
    /// them as it will be anyway. The run stays as it is.
    pub fn show_walls(&mut self, walls: Ts<Walls>) -> Answer<()> {
        let Walls { blocked, freed } = arguments::value(&walls, "walls")?;
        let Some(changing) = self.planner.changing() else { return Ok(()) };
        self.drawn = if blocked.is_empty() && freed.is_empty() {
            coming(changing)
        } else {
            let mut grid = changing.coming();
            Change { at: 0, blocked, freed }.make(&mut grid, &changing.scenario().spec, 0).map_err(throw)?;
            Some(Drawn::new(grid, &changing.scenario().spec, u32::MAX))
        };
        self.looks += 1;
        Ok(())
    }

    /// Whether its planner goes on with what it has learnt when walls change, instead of beginning anew.
    pub fn adapts(&self) -> bool {
        self.planner.adapts()
    }
}

/// The map with the changes that are still to come; none where there are none.
fn coming(changing: &Changing) -> Option<Drawn> {
    let until = changing.made() + changing.to_come();
    (changing.to_come() > 0).then(|| Drawn::new(changing.coming(), &changing.scenario().spec, until))
}

impl Drawn {
    fn new(drawn: Grid, spec: &ScenarioSpec, until: u32) -> Self {
        Self { grid: spec.felt(&drawn), drawn, until }
    }
}

impl Run {
    /// The map that is to be painted.
    pub(super) fn underfoot(&self) -> Underfoot<'_> {
        let made = self.shown().changing().map_or(0, Changing::made);
        let (grid, drawn) = match &self.drawn {
            Some(coming) if self.past.is_none() && made < coming.until => (&coming.grid, &coming.drawn),
            _ => (&self.map().grid, &self.map().drawn),
        };
        Underfoot { grid, drawn: self.map().spec.robot.map(|_| drawn) }
    }
}
