//! What each cell of a figure is.

use serde::Serialize;

use super::colours::{self, Colour, FILLED};
use super::lattice::Lattice;
use super::look::{Look, looks, medians};
use crate::error::{FormatError, Notice};
use crate::formats::picture::{Picture, otsu};

/// Classes of cells, as [`FigureCells::classes`] numbers them.
pub mod class {
    /// Free.
    pub const FREE: u8 = 0;
    /// A wall.
    pub const WALL: u8 = 1;
    /// The start; free.
    pub const START: u8 = 2;
    /// The goal; free.
    pub const GOAL: u8 = 3;
    /// Free, and something coloured is drawn across it.
    pub const PATH: u8 = 4;
    /// Neither plainly free nor plainly a wall.
    pub const UNSURE: u8 = 5;
}

/// Cells of which less is dark are free.
const CLEAR: f64 = 0.35;

/// Cells of which more has a colour are crossed by a path.
const CROSSED: f64 = 0.08;

/// Walls and free space differ by at least this luma.
const CONTRAST: u8 = 40;

/// The cells of a figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FigureCells {
    /// Columns.
    pub columns: u32,
    /// Rows.
    pub rows: u32,
    /// What each cell is, row by row from the upper left: see [`class`].
    pub classes: Vec<u8>,
    /// How sure that is, cell by cell: 0 not at all, 255 fully.
    pub confidence: Vec<u8>,
    /// Luma below which a pixel is dark.
    pub threshold: u8,
    /// What was assumed.
    pub notices: Vec<Notice>,
}

impl FigureCells {
    /// 1 for walls and for cells that are unsure (the safe side), 0 for all others.
    pub fn blocked(&self) -> Vec<u8> {
        blocked(&self.classes)
    }

    /// Column and row of the first cell of a class.
    pub fn first(&self, class: u8) -> Option<(u32, u32)> {
        let cell = self.classes.iter().position(|&found| found == class)? as u32;
        Some((cell % self.columns, cell / self.columns))
    }
}

pub(super) fn blocked(classes: &[u8]) -> Vec<u8> {
    classes.iter().map(|&class| u8::from(matches!(class, class::WALL | class::UNSURE))).collect()
}

/// Reads the cells of a lattice, found or set by hand. Each is judged by the inner part of it, so that lines between cells do not matter.
///
/// # Errors
/// [`FormatError::Field`]: the lattice is out of its ranges ([`Lattice::check`]).
pub fn read(picture: &Picture, lattice: &Lattice) -> Result<FigureCells, FormatError> {
    lattice.check()?;
    let medians = medians(picture, lattice);
    let light = Light::of(&medians);
    let looks = looks(picture, lattice, &medians, light.threshold);
    let (walls, drawn): (Vec<Colour>, Vec<Colour>) =
        colours::colours(&looks).into_iter().partition(|colour| colour.is_wall(&looks, light.threshold));
    let judged = |cell: usize| judge(&looks[cell], share(&walls, cell), share(&drawn, cell), &light);
    let (mut classes, mut confidence): (Vec<u8>, Vec<u8>) = (0..looks.len()).map(judged).unzip();
    let (start, goal, is_known) = colours::ends(&drawn, lattice.columns as usize);
    for (end, class) in [(start, class::START), (goal, class::GOAL)] {
        if let Some(end) = end {
            classes[end.cell] = class;
            confidence[end.cell] = if is_known { 220 } else { 120 };
        }
    }
    let notices = notices(&classes, is_known);
    Ok(FigureCells { columns: lattice.columns, rows: lattice.rows, classes, confidence, threshold: light.threshold, notices })
}

fn share(colours: &[Colour], cell: usize) -> f64 {
    colours.iter().map(|colour| colour.shares[cell]).sum()
}

/// What is dark and what is light.
struct Light {
    threshold: u8,
    /// Half of what dark and light differ.
    half: u8,
}

impl Light {
    /// Two classes of the cells' lumas, by Otsu's method; dark is what lies below the middle of their means.
    fn of(lumas: &[u8]) -> Self {
        let parted = otsu(lumas);
        let mean = |dark: bool| {
            let class = lumas.iter().filter(|&&luma| (luma < parted) == dark);
            let (count, sum) = class.fold((0_u64, 0_u64), |(count, sum), &luma| (count + 1, sum + u64::from(luma)));
            sum.checked_div(count).map(|mean| mean as u8)
        };
        match (mean(true), mean(false)) {
            (Some(dark), Some(light)) if light - dark >= CONTRAST => {
                Self { threshold: dark + (light - dark) / 2, half: (light - dark) / 2 }
            }
            // All cells look alike: free, if they are not dark.
            _ => Self { threshold: 128, half: 64 },
        }
    }
}

/// The class of a cell, and how sure it is; `walls` and `drawn` are the shares of coloured walls and of what else has a colour.
fn judge(look: &Look, walls: f64, drawn: f64, light: &Light) -> (u8, u8) {
    if look.pixels == 0 {
        return (class::UNSURE, 0);
    }
    // What is drawn in colour hides what lies under it.
    let dark = ((f64::from(look.dark) / f64::from(look.pixels)).max(walls) - drawn).max(0.0);
    let contrast = f64::from(look.luma.abs_diff(light.threshold)) / f64::from(light.half.max(1));
    let sure = |share: f64| (255.0 * share.clamp(0.0, 1.0)) as u8;
    if dark >= FILLED && look.corner < light.threshold {
        return (class::WALL, sure((2.0 * contrast).min((dark - 0.6) / 0.4)));
    }
    if dark > CLEAR {
        return (class::UNSURE, sure(contrast.min(0.3)));
    }
    let clear = 1.0 - dark / 0.5;
    match drawn >= CROSSED {
        true => (class::PATH, sure(clear.min(0.9))),
        false => (class::FREE, sure((2.0 * contrast).min(clear))),
    }
}

fn notices(classes: &[u8], is_known: bool) -> Vec<Notice> {
    let count = |class: u8| classes.iter().filter(|&&found| found == class).count();
    let mut notices = Vec::new();
    let (walls, unsure) = (count(class::WALL), count(class::UNSURE));
    let message = format!("{walls} of {} cells are walls, {unsure} are to be checked", classes.len());
    notices.push(Notice::new("figure-cells", message).with("walls", walls).with("cells", classes.len()).with("unsure", unsure));
    let ends = count(class::START) + count(class::GOAL);
    if ends == 0 {
        notices.push(Notice::new("figure-no-ends", "no start and goal in colours of their own were found"));
    } else if !is_known {
        let message = "which marker is the start and which the goal is a guess: neither is green or red";
        notices.push(Notice::new("figure-ends-guessed", message));
    }
    notices
}
