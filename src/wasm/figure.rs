//! Figures of grids: their lattice, their cells, and the map that these come to. Left out of the core (feature `maps`).

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{self, Bytes, Number, Text};
use super::maps::{Imported, imported};
use super::{Answer, object, throw};
use crate::error::Notice;
use crate::formats::figure::{self, FigureCells, Lattice};
use crate::formats::picture::{self, Picture};

/// A figure with its cells.
#[derive(Serialize, Tsify)]
pub struct Figure {
    /// Where they lie in the picture.
    pub lattice: Lattice,
    /// What each is, row by row from the upper left: 0 free, 1 wall, 2 start, 3 goal, 4 crossed by a path, 5 unsure.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub classes: Vec<u8>,
    /// How sure that is, cell by cell: 0 not at all, 255 fully.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub confidence: Vec<u8>,
    /// What was assumed.
    pub warnings: Vec<Notice>,
}

/// A picture to look at.
#[derive(Serialize, Tsify)]
pub struct Shown {
    /// Columns of the picture.
    pub width: u32,
    /// Rows of the picture.
    pub height: u32,
    /// Columns of what is shown.
    pub shown_width: u32,
    /// Rows of what is shown.
    pub shown_height: u32,
    /// Pixels of the picture in one of what is shown, along a row and along a column.
    pub by: u32,
    /// Red, green, blue and alpha of each pixel that is shown.
    #[serde(with = "serde_bytes")]
    #[tsify(type = "Uint8Array")]
    pub rgba: Vec<u8>,
}

/// The pixels of a picture as the readers see them, at most `most` a side: means of n × n of them where there are more.
#[wasm_bindgen]
pub fn show_picture(bytes: &Bytes, most: &Number) -> Answer<Ts<Shown>> {
    let (picture, most) = (decoded(bytes)?, most.whole("most")?);
    let small = picture::small(&picture, most);
    Ok(object(&Shown {
        width: picture.width,
        height: picture.height,
        shown_width: small.width,
        shown_height: small.height,
        by: small.by,
        rgba: small.rgba,
    }))
}

/// Looks for the lattice of a figure and reads its cells.
#[wasm_bindgen]
pub fn find_figure(bytes: &Bytes) -> Answer<Ts<Figure>> {
    let found = figure::find(&decoded(bytes)?).map_err(throw)?;
    Ok(figure_of(found.lattice, found.cells))
}

/// Reads the cells of a figure by its lattice.
#[wasm_bindgen]
pub fn read_figure(bytes: &Bytes, lattice: Ts<Lattice>) -> Answer<Ts<Figure>> {
    let lattice = arguments::value(&lattice, "lattice")?;
    let cells = figure::read(&decoded(bytes)?, &lattice).map_err(throw)?;
    Ok(figure_of(lattice, cells))
}

/// The map that a figure's cells come to, numbered as [`Figure`] has them: walls and unsure cells are blocked.
#[wasm_bindgen]
pub fn figure_map(classes: &Bytes, columns: &Number, name: &Text) -> Answer<Ts<Imported>> {
    let (classes, columns, name) = (classes.read("classes")?, columns.whole("columns")?, name.read("name")?);
    Ok(imported(figure::to_map(&classes, columns, &name).map_err(throw)?))
}

fn decoded(bytes: &Bytes) -> Answer<Picture> {
    picture::decode(&bytes.read("bytes")?).map_err(throw)
}

fn figure_of(lattice: Lattice, cells: FigureCells) -> Ts<Figure> {
    object(&Figure { lattice, classes: cells.classes, confidence: cells.confidence, warnings: cells.notices })
}
