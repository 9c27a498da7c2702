//! What an accepted file was taken for must follow from its notices: nothing is assumed in silence.

use formicarium::error::Notice;
use formicarium::formats::{self, Imported, Kind};

use crate::corpus::File;
use crate::watch::Fault;

/// Notices that say nothing of how cells were read.
const ABOUT_ENDS: [&str; 3] = ["ends-chosen", "matrix-one-is-blocked", "start-is-goal"];

/// Holds an accepted map against what is counted here without the readers.
pub fn stated(file: &File) -> Result<(), Fault> {
    let Ok(map) = formats::import(&file.bytes, &file.name) else { return Ok(()) };
    let Ok(found) = formats::recognise(&file.bytes, &file.name) else { return Ok(()) };
    let has = |kind: &str| map.notices.iter().any(|notice| notice.kind == kind);
    if !found.is_certain && !has("read-as") {
        return Err(Fault::broken("what is only likely is told", format!("{:?}", found.kind)));
    }
    if found.kind == Kind::Archive {
        return Ok(());
    }
    let names_no_ends = matches!(map.kind, Kind::MovingaiMap | Kind::Picture) || map.kind.is_raster();
    if names_no_ends && !has("ends-chosen") {
        return Err(Fault::broken("ends that were chosen are told", format!("{:?}", map.kind)));
    }
    if map.kind.is_raster() {
        cells_without_data(&map)?;
    }
    numbers(file, &map)
}

/// As many cells are blocked on a terrain as are told to be without data.
fn cells_without_data(map: &Imported) -> Result<(), Fault> {
    let blocked = map.grid.to_bytes().iter().filter(|&&cell| cell == 1).count();
    let count = |notice: &Notice| notice.args.get("count").and_then(|count| count.parse::<usize>().ok());
    let told = map.notices.iter().find(|notice| notice.kind == "terrain-no-data").and_then(count).unwrap_or(0);
    if blocked == told {
        Ok(())
    } else {
        Err(Fault::broken("cells without data are told", format!("{blocked} blocked, {told} told")))
    }
}

/// Of a text of digits alone every number is a cell, or something is said.
fn numbers(file: &File, map: &Imported) -> Result<(), Fault> {
    let is_plain = |b: &u8| b.is_ascii_digit() || b" ,;\t\r\n.-".contains(b);
    if !matches!(map.kind, Kind::Matrix | Kind::HeightTable) || !file.bytes.iter().all(is_plain) {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&file.bytes);
    let words: Vec<&str> = text.split(|c: char| " ,;\t\r\n".contains(c)).filter(|word| !word.is_empty()).collect();
    // Rows of digits without anything between them: each digit is a cell.
    let width = map.grid.width() as usize;
    let are_rows = width > 1 && words.iter().all(|word| word.len() == width && word.bytes().all(|b| b.is_ascii_digit()));
    let numbers = if are_rows { width * words.len() } else { words.len() };
    let is_said = map.notices.iter().any(|notice| !ABOUT_ENDS.contains(&notice.kind.as_str()));
    if numbers == map.grid.len() || is_said {
        return Ok(());
    }
    let sizes = format!("{numbers} numbers, {} × {} cells", map.grid.width(), map.grid.height());
    Err(Fault::broken("numbers that are no cells are told", sizes))
}
