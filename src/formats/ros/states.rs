//! Cells that are free, unknown or occupied, and the map they make.

use serde::{Deserialize, Serialize};

use crate::error::{FormatError, Notice};
use crate::map::{Grid, MAX_SIDE};

/// States of a cell, the worse the larger: of several cells that become one the worst counts.
pub(super) const FREE: u8 = 0;
pub(super) const UNKNOWN: u8 = 1;
pub(super) const OCCUPIED: u8 = 2;

/// How unknown cells count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Unknown {
    /// As walls: no robot goes where nobody has looked.
    #[default]
    Blocked,
    /// As free cells.
    Free,
}

/// The cells of a map of ROS, row by row from the upper left.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::formats) struct States {
    pub width: u32,
    pub height: u32,
    pub cells: Vec<u8>,
}

/// The state of an occupancy of 0 to 100; anything else is unknown.
pub(super) fn of_percent(value: f64, free: f64, occupied: f64) -> u8 {
    match value / 100.0 {
        p if !(0.0..=1.0).contains(&p) => UNKNOWN,
        p if p > occupied => OCCUPIED,
        p if p < free || p == 0.0 => FREE,
        _ => UNKNOWN,
    }
}

impl States {
    /// Fewer cells: at most `cells` a side, or as many as a map has. Every n × n cells become one, from the upper left on, as bad as the worst of
    /// them. Tells n.
    ///
    /// # Errors
    /// [`FormatError::Field`] for no cells.
    pub fn shrunk(self, cells: Option<u32>) -> Result<(Self, u32, Option<Notice>), FormatError> {
        let most = cells.unwrap_or(MAX_SIDE).min(MAX_SIDE);
        if most == 0 {
            return Err(FormatError::field("cells", "0", format!("1 to {MAX_SIDE}")));
        }
        let by = self.width.max(self.height).div_ceil(most);
        if by == 1 {
            return Ok((self, 1, None));
        }
        let (width, height) = (self.width.div_ceil(by), self.height.div_ceil(by));
        let mut worst = vec![FREE; width as usize * height as usize];
        for (y, row) in self.cells.chunks(self.width as usize).enumerate() {
            let from = y / by as usize * width as usize;
            for (x, &state) in row.iter().enumerate() {
                let cell = &mut worst[from + x / by as usize];
                *cell = state.max(*cell);
            }
        }
        let message = format!(
            "{} × {} cells became {width} × {height}: each is as blocked as the worst of {by} × {by} cells",
            self.width, self.height
        );
        let notice = Notice::new("cells-shrunk", message).with("width", self.width).with("height", self.height);
        Ok((Self { width, height, cells: worst }, by, Some(notice.with("columns", width).with("rows", height).with("by", by))))
    }

    /// Free, unknown and occupied cells.
    pub fn counts(&self) -> [usize; 3] {
        let count = |state: u8| self.cells.iter().filter(|&&cell| cell == state).count();
        [FREE, UNKNOWN, OCCUPIED].map(count)
    }

    /// The map, and how many cells were what.
    ///
    /// # Errors
    /// [`crate::error::ScenarioError::MapSize`].
    pub fn grid(&self, unknown: Unknown) -> Result<(Grid, Notice), FormatError> {
        let blocked = |&state: &u8| u8::from(state == OCCUPIED || (state == UNKNOWN && unknown == Unknown::Blocked));
        let cells: Vec<u8> = self.cells.iter().map(blocked).collect();
        let grid = Grid::from_bytes(self.width, self.height, &cells)?;
        let [free, unsure, occupied] = self.counts();
        let count_as = if unknown == Unknown::Free { "free" } else { "blocked" };
        let message = format!("{free} cells are free, {occupied} occupied, {unsure} unknown: unknown ones count as {count_as}");
        let notice = Notice::new("ros-cells", message).with("free", free).with("occupied", occupied);
        Ok((grid, notice.with("unknown", unsure).with("as", count_as)))
    }
}
