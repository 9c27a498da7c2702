//! What the terrains share: heights under construction, and what becomes of them.

use super::{Generated, RESOLUTION};
use crate::error::ScenarioError;
use crate::map::{Grid, Point};

/// Heights under construction, row by row.
pub(super) struct Field {
    pub width: u32,
    pub height: u32,
    pub heights: Vec<f64>,
}

impl Field {
    /// All heights 0.
    pub fn flat(width: u32, height: u32) -> Self {
        Self { width, height, heights: vec![0.0; width as usize * height as usize] }
    }

    /// The same ground from 0 to `top` metres, in whole decimetres: files stay short, and no height hangs on a last bit.
    pub fn stretched(mut self, top: f64) -> Self {
        let (lowest, highest) = self.heights.iter().fold((f64::INFINITY, 0.0f64), |(l, h), &v| (l.min(v), h.max(v)));
        let span = highest - lowest;
        let scale = if span > 0.0 { top / span } else { 0.0 };
        self.heights.iter_mut().for_each(|h| *h = libm::round((*h - lowest) * scale * 10.0) / 10.0);
        self
    }

    /// The terrain, without obstacles: from its upper-left to its lower-right corner.
    pub fn terrain(self) -> Result<Generated, ScenarioError> {
        let heights = self.heights.iter().map(|&h| h as f32).collect();
        let grid = Grid::open(self.width, self.height)?.with_heights(heights)?;
        let goal = Point::new(self.width - 1, self.height - 1);
        Ok(Generated { grid, start: Point::new(0, 0), goal, resolution: RESOLUTION })
    }
}
