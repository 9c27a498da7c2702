//! A table: column and row of each cell, by slices its level, then metres; of a curve metres alone. The reader of paths takes the columns by
//! their names.

use std::fmt::Write;

use super::PlannedPath;

pub(super) fn write(path: &PlannedPath<'_>) -> String {
    let metres = if path.metres.iter().any(|at| at.len() > 2) { "x_m,y_m,z_m\n" } else { "x_m,y_m\n" };
    if path.curve.is_some() {
        let line = |at: &Vec<f64>| at.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n";
        return metres.to_owned() + &path.metres.iter().map(line).collect::<String>();
    }
    let mut out = String::from("x,y,");
    out += if path.levels.is_some() { "level," } else { "" };
    out += metres;
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
