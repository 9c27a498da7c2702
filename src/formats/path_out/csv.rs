//! A table: column and row of each cell, by slices its level, then metres. The reader of paths takes the columns by their names.

use std::fmt::Write;

use super::PlannedPath;

pub(super) fn write(path: &PlannedPath<'_>) -> String {
    let mut out = String::from("x,y");
    out += if path.levels.is_some() { ",level" } else { "" };
    out += if path.metres.iter().any(|at| at.len() > 2) { ",x_m,y_m,z_m\n" } else { ",x_m,y_m\n" };
    for (index, (at, metres)) in path.cells.iter().zip(&path.metres).enumerate() {
        let _ = write!(out, "{},{}", at.x, at.y);
        if let Some(level) = path.levels.as_ref().and_then(|levels| levels.get(index)) {
            let _ = write!(out, ",{level}");
        }
        for number in metres {
            let _ = write!(out, ",{number}");
        }
        out.push('\n');
    }
    out
}
