//! Drawings within programs: rows in quotation marks, one after the other.
//!
//! `["..#.", "...."]`, one text of several lines between three quotation marks, `"..#.\n....\n"`, or letter by letter
//! `[['.', '#'], ['.', '.']]`.

use std::mem::take;

use super::{ENDS, FREE, WALLS};
use crate::map::MAX_SIDE;

/// Rows and columns of the smallest drawing.
const LEAST: usize = 2;

/// A drawing in quotation marks: its rows, each with its line.
pub(super) type Quoted = Vec<(usize, String)>;

/// The drawings of a text, at most two of them; equal ones count once.
pub(super) fn find(text: &str) -> Vec<Quoted> {
    let mut scan = Scan { rest: text, line: 1, ..Scan::default() };
    while scan.step() {}
    scan.end_drawing();
    scan.found
}

/// A text on the way through it.
#[derive(Default)]
struct Scan<'a> {
    rest: &'a str,
    line: usize,
    /// Letters that stood one by one: the row that they are.
    letters: String,
    rows: Quoted,
    found: Vec<Quoted>,
}

impl Scan<'_> {
    /// Takes the next thing: a text in quotation marks, a comment, a sign. False at the end.
    fn step(&mut self) -> bool {
        let Some(first) = self.rest.chars().next() else { return false };
        let end_of = |mark: &str| self.rest.find(mark).map_or(self.rest.len(), |at| at + mark.len());
        match first {
            '"' | '\'' => self.text(first),
            '/' if self.rest.starts_with("/*") => self.pass(end_of("*/")),
            '/' if self.rest.starts_with("//") => self.pass(end_of("\n")),
            '#' | '%' => self.pass(end_of("\n")),
            _ => {
                match first {
                    ']' | '}' | ')' | ';' => self.end_row(),
                    ',' | '[' | '{' | '(' | '+' => {}
                    _ if first.is_whitespace() => {}
                    _ => self.end_drawing(),
                }
                self.pass(first.len_utf8());
            }
        }
        true
    }

    fn pass(&mut self, bytes: usize) {
        self.line += self.rest[..bytes].bytes().filter(|&b| b == b'\n').count();
        self.rest = &self.rest[bytes..];
    }

    /// A text in quotation marks; an apostrophe is passed over.
    fn text(&mut self, mark: char) {
        let three = String::from_iter([mark; 3]);
        let is_block = self.rest.starts_with(&three);
        let skip = if is_block { 3 } else { 1 };
        let within = &self.rest[skip..];
        let end = match is_block {
            true => within.find(&three),
            false => within.find([mark, '\n']).filter(|&at| within[at..].starts_with(mark)),
        };
        let Some(end) = end else {
            self.end_drawing();
            return self.pass(skip);
        };
        let content = &within[..end];
        match (is_block, content.chars().count()) {
            (true, _) => {
                self.end_drawing();
                self.take_rows(content);
                self.end_drawing();
            }
            (false, 1) => self.letters.push_str(content),
            (false, _) => {
                self.end_row();
                self.take_rows(content);
            }
        }
        self.pass(2 * skip + end);
    }

    /// The rows of a text; one more than a map has tells that they are too many.
    fn take_rows(&mut self, content: &str) {
        for (at, line) in content.split('\n').enumerate() {
            let free = (MAX_SIDE as usize + 1).saturating_sub(self.rows.len());
            let rows = line.split("\\n").map(str::trim_end).filter(|row| !row.is_empty());
            self.rows.extend(rows.take(free).map(|row| (self.line + at, row.to_owned())));
        }
    }

    fn end_row(&mut self) {
        if !self.letters.is_empty() {
            self.rows.push((self.line, take(&mut self.letters)));
        }
    }

    fn end_drawing(&mut self) {
        self.end_row();
        let rows = take(&mut self.rows);
        let is_new = |found: &Quoted| !found.iter().map(|(_, row)| row).eq(rows.iter().map(|(_, row)| row));
        if self.found.len() < 2 && is_drawing(&rows) && self.found.iter().all(is_new) {
            self.found.push(rows);
        }
    }
}

/// Whether rows are equally long and made of walls and free cells, some of each; or of 0 and 1.
fn is_drawing(rows: &Quoted) -> bool {
    let Some((_, first)) = rows.first() else { return false };
    let width = first.chars().count();
    if rows.iter().all(|(_, row)| row.len() == width && row.bytes().all(|b| matches!(b, b'0' | b'1'))) {
        return rows.len() >= LEAST && width >= LEAST;
    }
    let is_known = |c: char| WALLS.contains(c) || FREE.contains(c) || ENDS.iter().any(|ends| ends.contains(c));
    let is_row = |row: &str| row.chars().count() == width && row.chars().all(is_known);
    let has = |letters: &str| rows.iter().any(|(_, row)| row.chars().any(|c| letters.contains(c)));
    rows.len() >= LEAST && width >= LEAST && rows.iter().all(|(_, row)| is_row(row)) && has(WALLS) && has(FREE)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> Vec<Vec<String>> {
        find(text).into_iter().map(|rows| rows.into_iter().map(|(_, row)| row).collect()).collect()
    }

    #[test]
    fn every_way_to_write_one_down() {
        for text in [
            "grid = [\"..#\", \"#..\"]",
            "grid = [\n  '..#',  # row one\n  '#..', // row two\n]\n",
            "char map[2][4] = {\"..#\", \"#..\"};",
            "maze = \"\"\"\n..#\n#..\n\"\"\"\nprint('no')",
            "s = \"..#\\n#..\\n\";",
            "s = \"..#\\n\" +\n \"#..\\n\"",
            "m = [['.', '.', '#'], ['#', '.', '.']]",
            "/* [\"##\", \"..\"] */ m = [\"..#\", \"#..\"]",
            "x = [\"..#\", \"#..\"]; again = [\"..#\", \"#..\"]",
        ] {
            assert_eq!(rows(text), [["..#", "#.."]], "{text:?}");
        }
        assert_eq!(rows("maze = [\"0010\", \"0100\"]"), [["0010", "0100"]]);
        assert_eq!(find("\n\nm = [\n'..#',\n'#..']")[0][1].0, 5);
        assert_eq!(find("\n'''\n..#\n#..'''")[0][1].0, 4);
    }

    #[test]
    fn what_is_none() {
        for text in [
            "",
            "it's \"fine\"",
            "['ab', 'cd']",
            "['..', '...', '##']",
            "['..', '..']",
            "['##', '##']",
            "x = '#'",
            "# '..#'\n# '#..'\n",
            "'..#' and '#..'",
        ] {
            assert!(find(text).is_empty(), "{text:?}");
        }
        assert_eq!(find("['.#', '..'] x ['##', '.#']").len(), 2);
    }
}
