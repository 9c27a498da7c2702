//! Tables that are lists: of places, of points, of records. They have rows and columns, but no cells.

use super::{Row, Table};
use crate::error::FormatError;

/// Fewest rows that tell a list from a small grid.
const FEWEST: usize = 4;

/// Refuses a single number, places or moves in two columns, and points in three.
///
/// # Errors
/// [`FormatError::Syntax`] that says what it is.
pub(super) fn check(table: &Table) -> Result<(), FormatError> {
    let (width, height, line) = (table.row(0).len(), table.height(), table.line(0));
    if width == 1 && height == 1 {
        return Err(FormatError::syntax(line, "the file holds a single number", "rows of numbers: 0 for free, 1 for blocked"));
    }
    let is_even = table.rows().all(|row| row.len() == width);
    if height < FEWEST || !is_even {
        return Ok(());
    }
    // A map may hold one start and one goal.
    let count = |wanted: f32| table.numbers().filter(|&number| number == wanted).count();
    let is_map = || table.numbers().all(|number| [0.0, 1.0, 2.0, 3.0].contains(&number)) && count(2.0) < 2 && count(3.0) < 2;
    if width == 2 && !is_map() {
        let what = "two columns, with numbers that no cell has: a list of places or moves";
        return Err(FormatError::syntax(line, what, "a grid of cells; a path is checked by `formicarium check`"));
    }
    // Of four points with heights of 0 and 1 nobody speaks: that is a map of three columns.
    let is_binary = || table.numbers().all(|number| number == 0.0 || number == 1.0);
    if width == 3 && !is_binary() && is_points(table) {
        let what = "three columns of x, y and a height: a list of points";
        return Err(FormatError::syntax(line, what, "a grid: gdal_translate in.xyz out.asc, or gdal_grid for scattered points"));
    }
    Ok(())
}

/// Whether the first two columns are the places of a lattice, each once, in rows or in columns.
fn is_points(table: &Table) -> bool {
    let runs = |fast: usize, slow: usize| {
        let mut length = 0;
        let rows: Vec<Row<'_>> = table.rows().collect();
        let ends = |at: usize| at + 1 == rows.len() || rows[at].at(slow) != rows[at + 1].at(slow);
        let mut from = 0;
        for at in (0..rows.len()).filter(|&at| ends(at)) {
            let run = &rows[from..=at];
            let is_first = length == 0;
            length = if is_first { run.len() } else { length };
            let same = |k: usize| run[k].at(fast) == rows[k].at(fast);
            let steps = |k: usize| (run[k].at(fast) - run[k - 1].at(fast)) * (run[1].at(fast) - run[0].at(fast)) > 0.0;
            if run.len() != length || length < 2 || !(0..length).all(same) || !(1..length).all(steps) {
                return false;
            }
            from = at + 1;
        }
        rows.len() / length >= 2
    };
    runs(0, 1) || runs(1, 0)
}

/// Whether names of columns only number them: `a,b,c`, `V1,V2,V3`, `col 0,col 1`.
pub(super) fn only_number(names: &[String]) -> bool {
    let stem = |name: &String| name.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned();
    let is_numbered = names.iter().all(|name| stem(name) == stem(&names[0]) && name.len() > stem(name).len());
    let letters: Vec<char> = names.iter().filter(|name| name.chars().count() == 1).flat_map(|name| name.chars()).collect();
    let is_alphabet = letters.len() == names.len() && letters.windows(2).all(|pair| pair[1] as u32 == pair[0] as u32 + 1);
    is_numbered || is_alphabet && matches!(letters.first(), Some('a' | 'A'))
}

#[cfg(test)]
mod tests {
    use super::super::read;
    use super::only_number;

    #[test]
    fn lists_are_no_grids() {
        for (text, told) in [
            ("42", "a single number"),
            ("0\n", "a single number"),
            ("moves = [[0,1],[1,0],[0,-1],[-1,0]]", "a list of places or moves"),
            ("0,0\n1,1\n2,2\n3,3\n", "a list of places or moves"),
            ("500 40 158\n510 40 159\n500 50 160\n510 50 161\n", "a list of points"),
            ("0 0 1\n0 1 1\n1 0 2\n1 1 5\n", "a list of points"),
        ] {
            let error = read(text, None).map(|_| ()).unwrap_err().to_string();
            assert!(error.contains(told), "{text:?}: {error}");
        }
        for text in [
            "0 1\n1 0\n",
            "0 1\n1 0\n0 1\n1 1\n",
            "0 1 0\n1 0 0\n0 0 0\n1 1 0\n",
            "5 6 7\n8 9 4\n3 2 1\n7 7 7\n",
            "0 0 1\n0 1 1\n1 0 1\n1 1 0\n",
        ] {
            assert!(read(text, None).is_ok(), "{text:?}");
        }
    }

    #[test]
    fn names_that_number_columns() {
        let names = |text: &str| text.split(',').map(String::from).collect::<Vec<_>>();
        for (text, is) in [("a,b,c", true), ("V1,V2,V3", true), ("col0,col1", true), ("x,y,z", false), ("lon,lat,elev", false)] {
            assert_eq!(only_number(&names(text)), is, "{text}");
        }
    }
}
