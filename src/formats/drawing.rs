//! Maps drawn with letters, as textbooks and programming puzzles have them: `#` is a wall, `.` or a blank is free, `S` and `G` are the ends. In programs
//! their rows stand in quotation marks (`quoted`).

mod quoted;

use super::recognise::Sureness;
use super::text::{is_ours, lines, quote};
use crate::error::{FormatError, Notice};
use crate::map::{Grid, Point, check_size};

/// Letters of walls.
const WALLS: &str = "#@X█■%";
/// Letters of free cells; the last ones mark a path.
const FREE: &str = ". _-·□*+o";
/// In rows of digits, what is a wall and what is free.
const DIGITS: [char; 2] = ['1', '0'];
/// Letters of the start, and of the goal.
const ENDS: [&str; 2] = ["SA", "GEB"];

/// A drawn map as read.
pub(super) struct DrawnMap {
    pub grid: Grid,
    pub start: Option<Point>,
    pub goal: Option<Point>,
    pub notices: Vec<Notice>,
}

/// How sure it is that a text is a drawing: at least two rows of such letters and nothing else, walls and free cells among them.
pub(super) fn sureness(text: &str) -> Sureness {
    let rows: Vec<&str> = rows(text).map(|(_, row)| row).take(64).collect();
    let is_drawn = |row: &&str| row.chars().all(|c| WALLS.contains(c) || FREE.contains(c) || ENDS.iter().any(|e| e.contains(c)));
    // The last row may be cut off where only the beginning of a long text is looked at.
    let has = |letters: &str| rows.iter().any(|row| row.chars().any(|c| c != ' ' && letters.contains(c)));
    let drawn = rows.len() > 1
        && rows.iter().all(is_drawn)
        && has("#@X█■")
        && (has(".") || rows.iter().any(|r| r.contains([' ', '_', '□'])));
    if !drawn {
        // Scenarios of our own hold their map in such rows.
        let may_be = text.contains(['"', '\'']) && !is_ours(text);
        let is_quoted = may_be && !quoted::find(text).is_empty();
        // Of another program's JSON nobody knows what its rows stand for.
        let is_json = text.trim_start().starts_with('{') && text.contains("\":");
        return match is_quoted {
            true if is_json => Sureness::Likely("rows of # and ., or of 0 and 1, in quotation marks"),
            true => Sureness::Certain("rows of # and ., or of 0 and 1, in quotation marks"),
            false => Sureness::No,
        };
    }
    let even = rows.iter().all(|row| row.chars().count() == rows[0].chars().count());
    if even { Sureness::Certain("rows of # and .") } else { Sureness::Likely("rows of # and . or blanks") }
}

/// The rows: lines that are not empty, below a line that says how many there are. Blanks between all letters are left out by [`read`].
fn rows(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_size = |line: &str| !line.is_empty() && line.bytes().all(|b| b.is_ascii_digit() || b" ,x".contains(&b));
    let mut lines = lines(text).filter(|(_, line)| !line.trim().is_empty()).peekable();
    while lines.next_if(|(_, line)| is_size(line.trim())).is_some() {}
    lines
}

/// Reads a drawing.
///
/// # Errors
/// [`FormatError::Syntax`] with the line of a row of another length, or of a letter that means nothing here or stands for an end twice.
pub(super) fn read(text: &str) -> Result<DrawnMap, FormatError> {
    let rows = letters(text)?;
    let is_blank = |from: usize, row: &[char]| row.iter().skip(from).step_by(2).all(|&c| c == ' ');
    let spaced = rows.iter().all(|(_, row)| row.len() > 2 && is_blank(1, row) && !row.iter().step_by(2).any(|&c| c == ' '));
    let thinned = |row: &[char]| -> Vec<char> { if spaced { row.iter().step_by(2).copied().collect() } else { row.to_vec() } };
    let rows: Vec<(usize, Vec<char>)> = rows.iter().map(|(line, row)| (*line, thinned(row))).collect();
    let width = rows.iter().map(|(_, row)| row.len()).max().unwrap_or(0);
    check_size(width as u64, rows.len() as u64)?;
    let blanks_are_free = rows.iter().any(|(_, row)| row.contains(&' '));
    let mut ends = [None, None];
    let mut cells = Vec::with_capacity(width * rows.len());
    let mut padded = 0;
    let has_digits = rows.iter().all(|(_, row)| row.iter().all(|letter| DIGITS.contains(letter)));
    for (y, (line, row)) in rows.iter().enumerate() {
        if row.len() < width && !blanks_are_free {
            let what = format!("row {} has {} letters where the longest has {width}", y + 1, row.len());
            return Err(FormatError::syntax(*line, what, "equally long rows"));
        }
        padded += width - row.len();
        for (x, &letter) in row.iter().enumerate() {
            let at = Point::new(x as u32, y as u32);
            cells.push(if has_digits { u8::from(letter == DIGITS[0]) } else { cell(letter, at, *line, &mut ends)? });
        }
        cells.resize((y + 1) * width, 0);
    }
    let grid = Grid::from_bytes(width as u32, rows.len() as u32, &cells)?;
    let [start, goal] = ends;
    Ok(DrawnMap { grid, start, goal, notices: notices(&rows, padded, blanks_are_free, ends) })
}

/// The letters of each row, with its line.
fn letters(text: &str) -> Result<Vec<(usize, Vec<char>)>, FormatError> {
    match &quoted::find(text)[..] {
        [] => Ok(rows(text).map(|(line, row)| (line, row.trim_end_matches('\r').chars().collect())).collect()),
        [one] => Ok(one.iter().map(|(line, row)| (*line, row.chars().collect())).collect()),
        [one, other, ..] => {
            let found = format!("the drawing from line {} or the one from line {}", one[0].0, other[0].0);
            Err(FormatError::Ambiguous { found })
        }
    }
}

/// 1 for a wall, 0 for what is free.
fn cell(letter: char, at: Point, line: usize, ends: &mut [Option<Point>; 2]) -> Result<u8, FormatError> {
    if let Some(which) = ENDS.iter().position(|letters| letters.contains(letter)) {
        return match ends[which].replace(at) {
            None => Ok(0),
            Some(_) => {
                let what = format!("`{letter}` stands for {} twice", ["the start", "the goal"][which]);
                Err(FormatError::syntax(line, what, "one start (S or A) and one goal (G, E or B)"))
            }
        };
    }
    match letter {
        _ if WALLS.contains(letter) => Ok(1),
        _ if FREE.contains(letter) => Ok(0),
        _ => {
            Err(FormatError::syntax(line, format!("`{}` means nothing in a drawing", quote(&letter.to_string())), "# . and S, G"))
        }
    }
}

fn notices(rows: &[(usize, Vec<char>)], padded: usize, blanks: bool, ends: [Option<Point>; 2]) -> Vec<Notice> {
    let mut used: Vec<char> = rows.iter().flat_map(|(_, row)| row.iter().copied()).collect();
    used.sort_unstable();
    used.dedup();
    let list = |letters: &str| {
        let found = used.iter().filter(|c| letters.contains(**c));
        found.map(|&c| if c == ' ' { "a blank".into() } else { c.to_string() }).collect::<Vec<_>>().join(" ")
    };
    let (walls, free) = (list(&format!("{WALLS}{}", DIGITS[0])), list(&format!("{FREE}{}", DIGITS[1])));
    let message = format!("{walls} was read as blocked, {free} as free");
    let mut notices = vec![Notice::new("drawing-letters", message).with("walls", walls).with("free", free)];
    if ends.iter().any(Option::is_some) {
        let ends = list(&ENDS.concat());
        notices.push(Notice::new("drawing-ends", format!("{ends} was read as the ends of the way")).with("ends", ends));
    }
    if padded > 0 && blanks {
        let message = format!("{padded} blanks at the ends of short rows were added as free cells");
        notices.push(Notice::new("drawing-padded", message).with("count", padded));
    }
    notices
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows_of(text: &str) -> (Vec<String>, Option<Point>, Option<Point>) {
        let map = read(text).unwrap();
        let letters: Vec<char> = map.grid.to_bytes().iter().map(|&b| if b == 0 { '.' } else { '@' }).collect();
        let rows = letters.chunks(map.grid.width() as usize).map(|row| row.iter().collect()).collect();
        (rows, map.start, map.goal)
    }

    #[test]
    fn every_way_to_draw_one_map() {
        let (start, goal) = (Some(Point::new(0, 0)), Some(Point::new(3, 1)));
        for text in ["S.#.\n.#.G\n", "4 2\nS.#.\n.#.G\n", "2\n4\nA_X_\n_X_B\n", "S . # .\n. # . G\n", "S.#\r\n # G\r\n"] {
            assert_eq!(rows_of(text), (vec!["..@.".into(), ".@..".into()], start, goal), "{text:?}");
        }
    }

    #[test]
    fn letters_that_mean_nothing_and_short_rows_are_named() {
        for (text, line, what) in [("..#\n.?#\n", 2, "`?`"), ("S.#\nS..\n", 2, "twice"), ("..#\n..\n", 2, "2 letters")] {
            let Err(FormatError::Syntax { line: got, what: said, .. }) = read(text) else { panic!("{text:?}") };
            assert!(got == line && said.contains(what), "{said}");
        }
    }

    #[test]
    fn a_drawing_is_told_from_other_texts() {
        assert!(matches!(sureness("..#.\n.#..\n"), Sureness::Certain(_)));
        assert!(matches!(sureness("### ##\n#   #\n"), Sureness::Likely(_)));
        for text in ["0 1\n1 0\n", "# a comment\n0 1\n", "....\n....\n", "#..\n", "hello\nworld\n"] {
            assert_eq!(sureness(text), Sureness::No, "{text:?}");
        }
    }
}
