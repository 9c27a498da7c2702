//! Cells that are free, unknown or occupied, and the map they make.

use serde::{Deserialize, Serialize};

use super::costs::Costs;
use crate::error::{FormatError, Notice};
use crate::map::{Grid, MAX_SIDE};

/// States of a cell, the worse the larger: of several cells that become one the worst counts. 1 to 252 are free as well, at that cost.
pub(super) const FREE: u8 = 0;
pub(super) const UNKNOWN: u8 = 253;
pub(super) const OCCUPIED: u8 = 254;

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

/// That values between free and occupied count by thresholds, though they may be costs; none where there are none.
pub(super) fn tell_of_values_between(count: usize) -> Option<Notice> {
    let message = format!(
        "{count} cells have a value from 1 to 99 and count by the thresholds; of a costmap these are costs: read them with `costs` (--costs nav2-smac-2d)"
    );
    (count > 0).then(|| Notice::new("costs-unread", message).with("count", count))
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
        let [unknown, occupied] = [UNKNOWN, OCCUPIED].map(count);
        [self.cells.len() - unknown - occupied, unknown, occupied]
    }

    /// The map, and how many cells were what; with `costs` weighted ground.
    ///
    /// # Errors
    /// [`crate::error::ScenarioError::MapSize`], or what [`Costs`] refuse.
    pub fn grid(&self, unknown: Unknown, costs: Option<Costs>) -> Result<(Grid, Vec<Notice>), FormatError> {
        let blocked = |&state: &u8| u8::from(state == OCCUPIED || (state == UNKNOWN && unknown == Unknown::Blocked));
        let cells: Vec<u8> = self.cells.iter().map(blocked).collect();
        let grid = Grid::from_bytes(self.width, self.height, &cells)?;
        let [free, unsure, occupied] = self.counts();
        let count_as = if unknown == Unknown::Free { "free" } else { "blocked" };
        let message = format!("{free} cells are free, {occupied} occupied, {unsure} unknown: unknown ones count as {count_as}");
        let notice = Notice::new("ros-cells", message).with("free", free).with("occupied", occupied);
        let counted = notice.with("unknown", unsure).with("as", count_as);
        let Some(costs) = costs else { return Ok((grid, vec![counted])) };
        costs.check()?;
        let grid = grid.with_factors(self.cells.iter().map(|&state| costs.factor(state)).collect())?;
        Ok((grid, vec![counted, self.tell_of_costs(costs)]))
    }

    /// The unknown cells as the blocked ones of a grid, where they count as walls; none where there are none.
    ///
    /// # Errors
    /// [`crate::error::ScenarioError::MapSize`].
    pub fn unknown(&self, unknown: Unknown) -> Result<Option<Grid>, FormatError> {
        if unknown == Unknown::Free || !self.cells.contains(&UNKNOWN) {
            return Ok(None);
        }
        let cells: Vec<u8> = self.cells.iter().map(|&state| u8::from(state == UNKNOWN)).collect();
        Ok(Some(Grid::from_bytes(self.width, self.height, &cells)?))
    }

    /// How many cells cost more than their length.
    fn tell_of_costs(&self, costs: Costs) -> Notice {
        let dear = || self.cells.iter().filter(|&&state| (1..UNKNOWN).contains(&state));
        let (count, rule) = (dear().count(), costs.rule.id());
        let most = costs.factor(dear().copied().max().unwrap_or(FREE));
        let message = match count {
            0 => "the file holds no costs: every free cell costs its length".to_owned(),
            _ => format!("{count} cells hold a cost: by the rule {rule} their factors reach up to {most}"),
        };
        let kind = if count == 0 { "costs-none" } else { "costs-read" };
        Notice::new(kind, message).with("count", count).with("rule", rule).with("most", most)
    }
}
