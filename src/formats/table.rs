//! Tables of numbers as people paste them: CSV, blanks, semicolons, MATLAB (`G = [0 1; 1 0];`), Python (`[[0, 1], [1, 0]]`).

use super::text::{lines, quote};
use crate::error::FormatError;
use crate::map::MAX_SIDE;

/// More numbers than any map has.
const MAX_NUMBERS: usize = (MAX_SIDE as usize) * (MAX_SIDE as usize);

/// One row of numbers.
pub(super) struct Row {
    /// Its line in the file, from 1.
    pub line: usize,
    /// Its numbers.
    pub values: Vec<f64>,
}

/// The numbers of a file.
pub(super) struct Table {
    pub rows: Vec<Row>,
    /// Whether there was text around the numbers, such as the rest of a program.
    pub has_rest: bool,
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

/// Reads the numbers of a text.
///
/// # Errors
/// [`FormatError`] with the line of the first thing that is no number.
pub(super) fn read(text: &str) -> Result<Table, FormatError> {
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
    let (before, after) = (&clean[..span.start], &clean[span.end..]);
    let rows = scan(&clean[span], before.matches('\n').count(), layout)?;
    if rows.is_empty() {
        return Err(FormatError::syntax(0, "the file holds no numbers", "rows of 0 and 1"));
    }
    // An assignment before and a bracket or two behind belong to the table; a program does not.
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).count();
    Ok(Table { rows, has_rest: letters(before) + letters(after) > 40 })
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

/// Comments (`%`, `#`, `//` to the end of the line, and what follows a `...`) become nothing; lines stay, and end with LF.
fn without_comments(text: &str) -> String {
    let mut clean = String::with_capacity(text.len());
    for (_, line) in lines(text) {
        let continued = line.find("...").map(|at| at + 3);
        let end = [line.find(['%', '#']), line.find("//"), continued].into_iter().flatten().min();
        clean.push_str(end.map_or(line, |end| &line[..end]));
        clean.push('\n');
    }
    clean
}

/// Where the table stands in a text with brackets: the longest bracket that holds only numbers, or else the longest.
fn brackets(text: &str) -> Result<Option<std::ops::Range<usize>>, FormatError> {
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

fn tokens(text: &str) -> impl Iterator<Item = &str> {
    text.split(is_blank).filter(|t| !t.is_empty())
}

/// Without brackets, `;` ends rows where more than one number stands between two of them. Digits count one by one where every
/// row is a single run of them.
fn plain_layout(text: &str) -> Layout {
    let mut rows = text.lines().map(str::trim).filter(|l| !l.is_empty()).peekable();
    let long = rows.peek().is_some_and(|l| l.len() > 1);
    if long && rows.all(|l| l.bytes().all(|b| b.is_ascii_digit())) {
        return Layout::Digits;
    }
    let semicolons_end_rows = text.lines().any(|l| l.split(';').any(|piece| tokens(piece).nth(1).is_some()));
    if semicolons_end_rows { Layout::Semicolons } else { Layout::Lines }
}

/// Cuts the text into rows and numbers.
fn scan(text: &str, lines_before: usize, layout: Layout) -> Result<Vec<Row>, FormatError> {
    let mut scanner = Scanner { rows: Vec::new(), values: Vec::new(), left: MAX_NUMBERS };
    for (index, line) in text.lines().enumerate() {
        let number = lines_before + index + 1;
        let (line, goes_on) = match line.split_once("...") {
            Some((line, _)) => (line, true),
            None => (line, layout == Layout::Nested),
        };
        let end = if layout == Layout::Nested { ']' } else { ';' };
        let mut pieces = line.split(end).peekable();
        while let Some(piece) = pieces.next() {
            scanner.numbers(piece, number, layout)?;
            let row_ends = if pieces.peek().is_some() { layout != Layout::Lines } else { !goes_on };
            if row_ends {
                scanner.end_row(number);
            }
        }
    }
    scanner.end_row(lines_before + text.lines().count());
    Ok(scanner.rows)
}

struct Scanner {
    rows: Vec<Row>,
    values: Vec<f64>,
    left: usize,
}

impl Scanner {
    fn numbers(&mut self, piece: &str, line: usize, layout: Layout) -> Result<(), FormatError> {
        if layout == Layout::Digits {
            return piece.trim().bytes().try_for_each(|b| self.push(f64::from(b.wrapping_sub(b'0'))));
        }
        for token in piece.split(|c| is_blank(c) || matches!(c, '[' | ']')).filter(|t| !t.is_empty()) {
            let value = number(token);
            let wrong = || FormatError::syntax(line, format!("`{}` is no number", quote(token)), "numbers");
            self.push(value.ok_or_else(wrong)?)?;
        }
        Ok(())
    }

    fn push(&mut self, value: f64) -> Result<(), FormatError> {
        let max = format!("{MAX_SIDE} × {MAX_SIDE} cells");
        self.left = self.left.checked_sub(1).ok_or(FormatError::TooLarge { what: "the number of cells".into(), max })?;
        self.values.push(value);
        Ok(())
    }

    fn end_row(&mut self, line: usize) {
        if !self.values.is_empty() {
            self.rows.push(Row { line, values: std::mem::take(&mut self.values) });
        }
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
            let rows: Vec<_> = table.rows.iter().map(|r| r.values.clone()).collect();
            assert_eq!(rows, [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]], "{text:?}");
        }
    }

    #[test]
    fn a_program_around_the_table_is_noticed() {
        let text = "function main()\nclear all;\nG=[0 1\n1 0];\nMM=size(G,1);\nfor i=1:MM\n disp(G(i,:));\nend\n";
        let table = read(text).unwrap();
        assert!(table.has_rest);
        assert_eq!(table.rows[0].line, 3);
    }

    #[test]
    fn what_is_no_number_is_quoted_with_its_line() {
        for (text, line, what) in [("0 1\n0 x\n", 2, "`x`"), ("G = [0 1;\n 1 nan]", 2, "`nan`"), ("\nG = [0 1", 2, "`[`")] {
            let Err(FormatError::Syntax { line: got, what: said, .. }) = read(text) else { panic!("{text:?}") };
            assert_eq!(got, line, "{text:?}");
            assert!(said.contains(what), "{said}");
        }
    }
}
