//! From the cells of a figure to a map.

use super::cells::blocked;
use super::{Lattice, class, find, read};
use crate::error::{FormatError, Notice};
use crate::formats::picture::{self, PictureOptions};
use crate::formats::{FigureOptions, Imported, Kind, complete};
use crate::map::{Grid, Point};

/// A map of a figure's cells: walls and cells that are unsure (the safe side) are blocked, all others free. Where no cell is the start or
/// the goal, they are chosen as on any map that names none.
///
/// # Errors
/// [`FormatError::Field`] `classes`: there are not as many whole rows of `columns` as cells, a class is unknown, or several cells are the
/// start or the goal. [`FormatError::TooLarge`]; [`FormatError::NoFreeCell`].
pub fn to_map(classes: &[u8], columns: u32, name: &str) -> Result<Imported, FormatError> {
    let rows = classes.len() as u64 / u64::from(columns.max(1));
    if columns == 0 || u64::from(columns) * rows != classes.len() as u64 {
        let what = format!("{} cells in {columns} columns", classes.len());
        return Err(FormatError::field("classes", what, "whole rows of cells"));
    }
    if let Some(wrong) = classes.iter().find(|&&class| class > class::UNSURE) {
        return Err(FormatError::field("classes", format!("the class {wrong}"), "classes from 0 to 5"));
    }
    let (start, goal) = (only(classes, columns, class::START)?, only(classes, columns, class::GOAL)?);
    let grid = Grid::from_bytes(columns, rows as u32, &blocked(classes))?;
    let unsure = classes.iter().filter(|&&class| class == class::UNSURE).count();
    let message = format!("{unsure} unsure cells count as walls");
    let notice = Notice::new("figure-unsure-blocked", message).with("unsure", unsure);
    let notices = if unsure > 0 { vec![notice] } else { Vec::new() };
    complete(Kind::Picture, name, grid, start, goal, notices)
}

/// Column and row of the one cell of a class, if any.
fn only(classes: &[u8], columns: u32, class: u8) -> Result<Option<Point>, FormatError> {
    let mut cells = (0_u32..).zip(classes).filter(|&(_, &found)| found == class).map(|(cell, _)| cell);
    match (cells.next(), cells.next()) {
        (_, Some(_)) => {
            let end = if class == class::START { "start" } else { "goal" };
            Err(FormatError::field("classes", format!("several cells are the {end}"), "at most one"))
        }
        (cell, None) => Ok(cell.map(|cell| Point::new(cell % columns, cell / columns))),
    }
}

/// A picture's bytes as the map of a figure, by its lattice if that is given, else by the one that is found.
pub(in crate::formats) fn import(
    bytes: &[u8],
    name: &str,
    figure: &FigureOptions,
    options: &PictureOptions,
) -> Result<Imported, FormatError> {
    check(options)?;
    let picture = picture::decode(bytes)?;
    let cells = match &figure.lattice {
        Some(lattice) => read(&picture, lattice)?,
        None => {
            let found = find(&picture)?;
            let mut cells = found.cells;
            cells.notices.insert(0, found_notice(&found.lattice));
            cells
        }
    };
    let mut imported = to_map(&cells.classes, cells.columns, name)?;
    imported.spec.resolution = options.metres_per_cell.unwrap_or(imported.spec.resolution);
    imported.notices.splice(0..0, picture.notices.into_iter().chain(cells.notices));
    Ok(imported)
}

/// Says which lattice was found, as the command line takes it: so it can be corrected.
fn found_notice(lattice: &Lattice) -> Notice {
    let Lattice { x0, y0, dx, dy, columns, rows, shear_x, shear_y } = lattice;
    let given = format!("{x0:.2},{y0:.2},{dx:.3},{dy:.3},{columns},{rows},{shear_x:.3},{shear_y:.3}");
    let message = format!("a lattice of {columns} × {rows} cells was found: --lattice {given} gives the same");
    Notice::new("figure-lattice", message).with("columns", columns).with("rows", rows).with("lattice", given)
}

/// What says how pixels become cells says nothing of a figure.
fn check(options: &PictureOptions) -> Result<(), FormatError> {
    let usual = PictureOptions { metres_per_cell: options.metres_per_cell, ..PictureOptions::default() };
    let differs = [
        ("threshold", options.threshold != usual.threshold),
        ("light_is_blocked", options.light_is_blocked),
        ("crop", options.crop.is_some()),
        ("cells", options.cells.is_some()),
        ("metres_per_pixel", options.metres_per_pixel.is_some()),
    ];
    if let Some((field, _)) = differs.into_iter().find(|(_, differs)| *differs) {
        let expected = "either a figure, whose lattice and colours say it all, or a picture with this option";
        return Err(FormatError::field(field, "it says nothing of a figure", expected));
    }
    picture::metres("metres_per_cell", options.metres_per_cell).map(drop)
}
