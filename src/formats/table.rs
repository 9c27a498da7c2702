//! Tables of numbers as people paste them: CSV, blanks, semicolons, MATLAB (`G = [0 1; 1 0];`), Python (`[[0, 1], [1, 0]]`).
//!
//! The numbers are never kept here: a text of 64 MiB may hold 30 million of them, each in a row of its own. [`Table`] tells how many there are
//! and which; who wants them has them read off one by one, and keeps what it needs.

use std::borrow::Cow;
use std::ops::Range;

use super::text::quote;
use crate::error::FormatError;
use crate::map::{MAX_SIDE, Point};

/// More numbers than any map has.
const MAX_NUMBERS: usize = (MAX_SIDE as usize) * (MAX_SIDE as usize);

/// Takes in the numbers of a text, one by one.
pub(super) trait Sink {
    /// The next number of the row at hand.
    fn number(&mut self, value: f64);

    /// The row at hand, which has a number at least, has ended in this line of the file, from 1.
    ///
    /// # Errors
    /// [`FormatError`] where the row cannot be used.
    fn end_row(&mut self, line: usize) -> Result<(), FormatError>;
}

/// What ends a row, apart from the end of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Layout {
    /// Nothing else: `;` separates columns.
    Lines,
    /// `;` as in MATLAB.
    Semicolons,
    /// `]` alone, not even the end of a line: nested brackets as in Python and JSON.
    Nested,
    /// Nothing else, and every digit is a number: `0010`.
    Digits,
}

/// Where the numbers of a text stand, and how they are told apart.
struct Numbers<'a> {
    /// The text without comments.
    clean: Cow<'a, str>,
    span: Range<usize>,
    layout: Layout,
}

/// A text's numbers, as far as can be told without keeping them.
pub(super) struct Table<'a> {
    numbers: Numbers<'a>,
    pub census: Census,
    /// Whether there was text around the numbers, such as the rest of a program.
    pub has_rest: bool,
}

/// What has been counted.
#[derive(Default)]
pub(super) struct Census {
    /// Rows with numbers.
    pub rows: usize,
    /// Numbers of the first row.
    pub columns: usize,
    /// Line in which the first row ends.
    pub first_line: usize,
    /// The first row of another length than the first one.
    pub ragged: Option<Ragged>,
    /// Which numbers there are besides 0 and 1, in the order in which they come; none where there are more than [`MOST_TOLD_APART`].
    pub others: Option<Vec<Other>>,
    /// Numbers of the row at hand.
    at: usize,
}

/// A row of another length than the first one.
pub(super) struct Ragged {
    /// From 0.
    pub row: usize,
    /// The line in which it ends.
    pub line: usize,
    /// Its numbers.
    pub columns: usize,
}

/// A number that is neither 0 nor 1.
pub(super) struct Other {
    pub value: f64,
    /// How often it occurs.
    pub count: usize,
    /// Where it occurs first.
    pub first: Point,
}

/// Numbers besides 0 and 1 that are counted: more than a map can have.
pub(super) const MOST_TOLD_APART: usize = 5;

impl Sink for Census {
    fn number(&mut self, value: f64) {
        if value != 0.0 && value != 1.0 {
            self.note(value);
        }
        self.at += 1;
    }

    fn end_row(&mut self, line: usize) -> Result<(), FormatError> {
        let columns = std::mem::take(&mut self.at);
        if self.rows == 0 {
            (self.columns, self.first_line) = (columns, line);
        } else if columns != self.columns && self.ragged.is_none() {
            self.ragged = Some(Ragged { row: self.rows, line, columns });
        }
        self.rows += 1;
        Ok(())
    }
}

impl Census {
    fn note(&mut self, value: f64) {
        let Some(others) = &mut self.others else { return };
        if let Some(known) = others.iter_mut().find(|other| other.value == value) {
            known.count += 1;
        } else if others.len() < MOST_TOLD_APART {
            others.push(Other { value, count: 1, first: Point::new(self.at as u32, self.rows as u32) });
        } else {
            self.others = None;
        }
    }
}

/// Finds the numbers of a text and counts them.
///
/// # Errors
/// [`FormatError`] with the line of the first thing that is no number.
pub(super) fn read(text: &str) -> Result<Table<'_>, FormatError> {
    let numbers = Numbers::of(text)?;
    let mut census = Census { others: Some(Vec::new()), ..Census::default() };
    numbers.read(&mut census)?;
    if census.rows == 0 {
        return Err(FormatError::syntax(0, "the file holds no numbers", "rows of 0 and 1"));
    }
    // An assignment before and a bracket or two behind belong to the table; a program does not.
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).count();
    let Numbers { clean, span, .. } = &numbers;
    let has_rest = letters(&clean[..span.start]) + letters(&clean[span.end..]) > 40;
    Ok(Table { numbers, census, has_rest })
}

impl Table<'_> {
    /// Columns and rows, if all rows are equally long.
    ///
    /// # Errors
    /// [`FormatError`] with the line of the first row that is not.
    pub(super) fn size(&self) -> Result<(usize, usize), FormatError> {
        let Census { rows, columns, ragged, .. } = &self.census;
        let Some(Ragged { row, line, columns: found }) = ragged else { return Ok((*columns, *rows)) };
        let what = format!("row {} has {found} numbers where the first row has {columns}", row + 1);
        Err(FormatError::syntax(*line, what, "equally long rows"))
    }

    /// Reads the numbers off, row by row.
    ///
    /// # Errors
    /// What the sink refuses.
    pub(super) fn read(&self, sink: &mut impl Sink) -> Result<(), FormatError> {
        self.numbers.read(sink)
    }
}

/// Whether the first line that says anything could belong to a table.
pub(super) fn looks_like(text: &str) -> bool {
    let clean = without_comments(text);
    if let Ok(Some(span)) = brackets(&clean) {
        return is_numeric(&clean[span.clone()]) && clean[span].contains(|c: char| c.is_ascii_digit());
    }
    let first = after_title(&clean).lines().find(|l| !l.trim().is_empty());
    first.is_some_and(|l| is_numeric(l) && l.contains(|c: char| c.is_ascii_digit()))
}

/// Comments (`%`, `#`, `//` to the end of the line, and what follows a `...`) become nothing; lines stay, and end with LF or CRLF.
fn without_comments(text: &str) -> Cow<'_, str> {
    let text = text.trim_end_matches('\u{1a}');
    let end = if text.contains('\n') || !text.contains('\r') { b'\n' } else { b'\r' };
    let bytes = text.as_bytes();
    if end == b'\n' && !bytes.iter().any(|b| matches!(b, b'%' | b'#' | b'/')) && !text.contains("...") {
        return Cow::Borrowed(text);
    }
    let mut clean = String::with_capacity(text.len() + 1);
    // The end of what is kept of the line at hand, where something is not.
    let (mut begin, mut cut) = (0, None);
    for (at, &byte) in bytes.iter().enumerate() {
        if byte == end {
            clean.push_str(&text[begin..cut.take().unwrap_or(at)]);
            clean.push('\n');
            begin = at + 1;
        } else if cut.is_none() {
            cut = match byte {
                b'%' | b'#' => Some(at),
                b'/' if bytes.get(at + 1) == Some(&b'/') => Some(at),
                b'.' if bytes[at..].starts_with(b"...") => Some(at + 3),
                _ => None,
            };
        }
    }
    clean.push_str(&text[begin..cut.unwrap_or(text.len())]);
    clean.push('\n');
    Cow::Owned(clean)
}

/// Where the table stands in a text with brackets: the longest bracket that holds only numbers, or else the longest.
fn brackets(text: &str) -> Result<Option<Range<usize>>, FormatError> {
    if !text.contains('[') {
        return Ok(None);
    }
    let (mut best, mut best_score) = (None, (false, 0));
    let (mut depth, mut from) = (0usize, 0);
    for (at, letter) in text.bytes().enumerate() {
        match letter {
            b'[' => {
                from = if depth == 0 { at } else { from };
                depth += 1;
            }
            b']' if depth == 1 => {
                depth = 0;
                let span = from..at + 1;
                let score = (is_numeric(&text[span.clone()]), span.len());
                if score > best_score {
                    (best, best_score) = (Some(span), score);
                }
            }
            b']' => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    if depth > 0 && best.is_none() {
        let line = text[..from].bytes().filter(|&b| b == b'\n').count() + 1;
        return Err(FormatError::syntax(line, "`[` is never closed", "a `]` after the last row"));
    }
    Ok(best)
}

/// Whether a text holds nothing but numbers and what may stand between them.
fn is_numeric(text: &str) -> bool {
    text.bytes().all(|b| b.is_ascii_digit() || b.is_ascii_whitespace() || b",;.+-eE[]\"'".contains(&b))
}

/// Without the line `G =` that MATLAB prints above a matrix.
fn after_title(text: &str) -> &str {
    let body = text.trim_start();
    match body.split_once('\n') {
        Some((title, rest)) if title.trim_end().ends_with('=') => rest,
        _ => body,
    }
}

fn is_blank(letter: char) -> bool {
    letter.is_whitespace() || matches!(letter, ',' | '"' | '\'')
}

/// Without brackets, `;` ends rows where more than one number stands between two of them. Digits count one by one where every
/// row is a single run of them.
fn plain_layout(text: &str) -> Layout {
    if is_digits(text) {
        return Layout::Digits;
    }
    let (mut tokens, mut in_token) = (0, false);
    for letter in text.chars() {
        if matches!(letter, '\n' | ';') {
            (tokens, in_token) = (0, false);
        } else if is_blank(letter) {
            in_token = false;
        } else if !in_token {
            (tokens, in_token) = (tokens + 1, true);
            if tokens > 1 {
                return Layout::Semicolons;
            }
        }
    }
    Layout::Lines
}

/// Whether every row is a single run of digits, the first one of several.
fn is_digits(text: &str) -> bool {
    let (mut rows, mut digits, mut has_ended) = (0, 0, false);
    for letter in text.chars().chain(['\n']) {
        match letter {
            '\n' if digits == 0 => {}
            '\n' => {
                if rows == 0 && digits == 1 {
                    return false;
                }
                (rows, digits, has_ended) = (rows + 1, 0, false);
            }
            '0'..='9' if !has_ended => digits += 1,
            _ if letter.is_whitespace() => has_ended = digits > 0,
            _ => return false,
        }
    }
    rows > 0
}

impl<'a> Numbers<'a> {
    fn of(text: &'a str) -> Result<Self, FormatError> {
        let clean = without_comments(text);
        let (span, layout) = match brackets(&clean)? {
            Some(span) => {
                let nested = clean[span.start + 1..span.end].contains('[');
                (span, if nested { Layout::Nested } else { Layout::Semicolons })
            }
            None => {
                let block = after_title(&clean);
                (clean.len() - block.len()..clean.len(), plain_layout(block))
            }
        };
        Ok(Self { clean, span, layout })
    }

    /// Cuts the text into rows and numbers.
    fn read(&self, sink: &mut impl Sink) -> Result<(), FormatError> {
        let (before, text) = (&self.clean[..self.span.start], &self.clean[self.span.clone()]);
        let line = before.bytes().filter(|&b| b == b'\n').count() + 1;
        let mut scanner = Scanner { sink, text, line, token: None, in_row: false, left: MAX_NUMBERS };
        // A `...`: the rest of the line says nothing, and the row goes on in the next one.
        let mut goes_on = false;
        for (at, letter) in text.char_indices() {
            match letter {
                '\n' => {
                    scanner.end_token(at)?;
                    if !goes_on && self.layout != Layout::Nested {
                        scanner.end_row()?;
                    }
                    goes_on = false;
                    scanner.line += 1;
                }
                _ if goes_on => {}
                '0'..='9' if self.layout == Layout::Digits => scanner.push(f64::from(letter as u8 - b'0'))?,
                '.' if text[at..].starts_with("...") => {
                    scanner.end_token(at)?;
                    goes_on = true;
                }
                '[' => scanner.end_token(at)?,
                ']' => {
                    scanner.end_token(at)?;
                    if self.layout == Layout::Nested {
                        scanner.end_row()?;
                    }
                }
                ';' if self.layout != Layout::Nested => {
                    scanner.end_token(at)?;
                    if self.layout == Layout::Semicolons {
                        scanner.end_row()?;
                    }
                }
                _ if is_blank(letter) => scanner.end_token(at)?,
                _ => scanner.token = scanner.token.or(Some(at)),
            }
        }
        scanner.end_token(text.len())?;
        scanner.line -= usize::from(text.ends_with('\n'));
        scanner.end_row()
    }
}

struct Scanner<'a, S> {
    sink: &'a mut S,
    text: &'a str,
    /// The line at hand, from 1.
    line: usize,
    /// Where the number at hand begins.
    token: Option<usize>,
    /// Whether the row at hand has a number.
    in_row: bool,
    /// How many numbers may follow.
    left: usize,
}

impl<S: Sink> Scanner<'_, S> {
    fn end_token(&mut self, at: usize) -> Result<(), FormatError> {
        let Some(begin) = self.token.take() else { return Ok(()) };
        let token = &self.text[begin..at];
        let wrong = || FormatError::syntax(self.line, format!("`{}` is no number", quote(token)), "numbers");
        self.push(number(token).ok_or_else(wrong)?)
    }

    fn push(&mut self, value: f64) -> Result<(), FormatError> {
        let Some(left) = self.left.checked_sub(1) else {
            let max = format!("{MAX_SIDE} × {MAX_SIDE} cells");
            return Err(FormatError::TooLarge { what: "the number of cells".into(), max });
        };
        (self.left, self.in_row) = (left, true);
        self.sink.number(value);
        Ok(())
    }

    fn end_row(&mut self) -> Result<(), FormatError> {
        if std::mem::take(&mut self.in_row) { self.sink.end_row(self.line) } else { Ok(()) }
    }
}

fn number(token: &str) -> Option<f64> {
    match token.as_bytes() {
        // Nearly all numbers of a map.
        [digit] if digit.is_ascii_digit() => Some(f64::from(digit - b'0')),
        _ => token.parse().ok().filter(|v: &f64| v.is_finite()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers with the lines of their rows.
    #[derive(Default)]
    struct Kept {
        rows: Vec<(usize, Vec<f64>)>,
        row: Vec<f64>,
    }

    impl Sink for Kept {
        fn number(&mut self, value: f64) {
            self.row.push(value);
        }

        fn end_row(&mut self, line: usize) -> Result<(), FormatError> {
            self.rows.push((line, std::mem::take(&mut self.row)));
            Ok(())
        }
    }

    fn kept(table: &Table) -> Vec<(usize, Vec<f64>)> {
        let mut kept = Kept::default();
        table.read(&mut kept).unwrap();
        kept.rows
    }

    #[test]
    fn every_spelling_of_one_table() {
        let spellings = [
            "0,0,1\n0,1,0\n",
            "0 0 1\r\n0 1 0",
            "0\t0\t1\t\n0\t1\t0\t\n\n",
            "0;0;1\n0;1;0\n",
            "0 0 1; 0 1 0",
            "0,0,1;\n0,1,0;\n",
            "001\n010\n",
            "G = [0 0 1; 0 1 0];",
            "G=[0 0 1;...\n 0 1 0;];\n",
            "G = [0 0 ... the first row\n 1\n 0 1 0];",
            "% map\nmap = [ 0, 0, 1 % top\n 0, 1, 0 ];\n[r,c] = size(map);",
            "[[0, 0, 1], [0, 1, 0]]",
            "grid = np.array([[0, 0,\n 1],\n [0, 1, 0]], dtype=int)",
            "[[0 0 1]\n [0 1 0]]",
            "G =\n\n     0     0     1\n     0     1     0\n",
            "\"0\",\"0\",\"1\"\n\"0\",\"1\",\"0\"\n",
            "# header\n0.0 0.0 1.0\n0.0 1.0 0.0",
        ];
        for text in spellings {
            assert!(looks_like(text), "{text:?}");
            let table = read(text).unwrap();
            let rows: Vec<_> = kept(&table).into_iter().map(|(_, row)| row).collect();
            assert_eq!(rows, [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]], "{text:?}");
            assert_eq!(table.size().unwrap(), (3, 2), "{text:?}");
        }
    }

    #[test]
    fn a_program_around_the_table_is_noticed() {
        let text = "function main()\nclear all;\nG=[0 1\n1 0];\nMM=size(G,1);\nfor i=1:MM\n disp(G(i,:));\nend\n";
        let table = read(text).unwrap();
        assert!(table.has_rest);
        assert_eq!((table.census.first_line, kept(&table)[1].0), (3, 4));
    }

    #[test]
    fn what_is_no_number_is_quoted_with_its_line() {
        for (text, line, what) in [("0 1\n0 x\n", 2, "`x`"), ("G = [0 1;\n 1 nan]", 2, "`nan`"), ("\nG = [0 1", 2, "`[`")] {
            let Err(FormatError::Syntax { line: got, what: said, .. }) = read(text) else { panic!("{text:?}") };
            assert_eq!(got, line, "{text:?}");
            assert!(said.contains(what), "{said}");
        }
    }

    #[test]
    fn rows_end_where_they_end() {
        type Rows = &'static [(usize, &'static [f64])];
        let cases: [(&str, Rows); 8] = [
            ("1 2 ...\n3\n\n4 5 6", &[(2, &[1.0, 2.0, 3.0]), (4, &[4.0, 5.0, 6.0])]),
            ("1 2 ... 7\n", &[(2, &[1.0, 2.0])]),
            ("[[1,\n2],\n[3,4\n]]\n", &[(2, &[1.0, 2.0]), (4, &[3.0, 4.0])]),
            ("[1 2;3 4\n5 6]", &[(1, &[1.0, 2.0]), (1, &[3.0, 4.0]), (2, &[5.0, 6.0])]),
            ("12\r\n 34 \r\n", &[(1, &[1.0, 2.0]), (2, &[3.0, 4.0])]),
            ("1;2 // 3\r3;4\r", &[(1, &[1.0, 2.0]), (2, &[3.0, 4.0])]),
            ("1.5\u{a0}2e1 # 8\n", &[(1, &[1.5, 20.0])]),
            ("G =\n7\n8%9\n\u{1a}", &[(2, &[7.0]), (3, &[8.0])]),
        ];
        for (text, rows) in cases {
            let told = kept(&read(text).unwrap());
            let told: Vec<(usize, &[f64])> = told.iter().map(|(line, row)| (*line, &row[..])).collect();
            assert_eq!(told, rows, "{text:?}");
        }
    }

    #[test]
    fn what_is_counted_is_what_a_map_is_told_by() {
        let table = read("0 1 2\n7 3 7\n1 0 2\n").unwrap();
        let others = table.census.others.unwrap();
        let told: Vec<_> = others.iter().map(|other| (other.value, other.count, (other.first.x, other.first.y))).collect();
        assert_eq!(told, [(2.0, 2, (2, 0)), (7.0, 2, (0, 1)), (3.0, 1, (1, 1))]);
        assert!(read("2 3 4 5 6\n").unwrap().census.others.is_some());
        assert!(read("2 3 4 5 6 7\n").unwrap().census.others.is_none());
        let ragged = read("1 2\n\n3\n4 5\n").unwrap();
        assert_eq!(ragged.size().unwrap_err().to_string(), "line 3: row 2 has 1 numbers where the first row has 2");
    }
}
