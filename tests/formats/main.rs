//! Every file format: what is accepted, what is refused and in which words, and that nothing is lost on the way out and in.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../common/mod.rs"]
mod common;
mod comparison;
mod costs;
mod figure;
mod figure_picture;
mod geotiff;
mod matrix;
mod movingai;
mod path_out;
mod properties;
mod recognition;
mod results;
mod ros;
mod scen;
mod scenario;
mod schema;
mod terrain;
#[path = "../common/terrains.rs"]
mod terrains;

use formicarium::error::{Error, ErrorReport};
use formicarium::formats::{Imported, import};
use formicarium::map::Grid;

/// The map's rows as `.` and `@`.
fn rows(grid: &Grid) -> Vec<String> {
    let letters: Vec<char> = grid.to_bytes().iter().map(|&b| if b == 0 { '.' } else { '@' }).collect();
    letters.chunks(grid.width() as usize).map(|row| row.iter().collect()).collect()
}

fn read(text: &str) -> Result<Imported, Error> {
    import(text.as_bytes(), "test")
}

/// The error of a text that must be refused.
fn refused(text: &str) -> ErrorReport {
    match read(text) {
        Err(error) => error.report(),
        Ok(imported) => panic!("{text:?} was accepted as {imported:?}"),
    }
}

fn notices(imported: &Imported) -> Vec<&str> {
    imported.notices.iter().map(|n| n.kind.as_str()).collect()
}

/// A file of the data folder that the environment variable FORMICARIUM_DATA names.
fn data(path: &str) -> Option<Vec<u8>> {
    let Some(folder) = std::env::var_os("FORMICARIUM_DATA") else {
        println!("skipped: FORMICARIUM_DATA is not set ({path})");
        return None;
    };
    Some(std::fs::read(std::path::Path::new(&folder).join(path)).unwrap())
}
