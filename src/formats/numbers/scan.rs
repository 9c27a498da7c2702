//! From the text of one matrix to its numbers.

use super::table::{Table, no_number, number};
use crate::error::FormatError;

/// What ends a row, apart from the end of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// Nothing else: `;` separates columns.
    Lines,
    /// `;` as in MATLAB.
    Semicolons,
    /// `]` or `}` alone, not even the end of a line: nested brackets as in Python and C.
    Nested,
    /// Nothing else, and every digit is a number: `0010`.
    Digits,
}

impl Layout {
    fn ends_row(self, letter: char) -> bool {
        match self {
            Self::Nested => matches!(letter, ']' | '}'),
            _ => letter == ';',
        }
    }
}

/// Cuts a text into rows and numbers; `lines_before` are the lines of the file above it.
///
/// # Errors
/// [`FormatError`] with the line of what is no number, or of an empty field.
pub(super) fn scan(text: &str, lines_before: usize, layout: Layout) -> Result<Table, FormatError> {
    let mut table = Table::default();
    let mut last = lines_before;
    // Only between brackets of MATLAB a row goes on behind `...`; elsewhere numbers were left out there.
    let goes_on_by_dots = matches!(layout, Layout::Semicolons | Layout::Nested);
    for (index, line) in text.lines().enumerate() {
        last = lines_before + index + 1;
        let (line, goes_on) = match line
            .trim_end()
            .strip_suffix("...")
            .filter(|before| goes_on_by_dots && !before.trim_end_matches(['[', ' ']).is_empty())
        {
            Some(line) => (line, true),
            None => (line, layout == Layout::Nested),
        };
        if line.contains("...") {
            return Err(left_out(last));
        }
        if layout == Layout::Lines || layout == Layout::Digits {
            fields(&mut table, line, last, layout)?;
        } else {
            let mut pieces = line.split(|letter| layout.ends_row(letter)).peekable();
            while let Some(piece) = pieces.next() {
                fields(&mut table, piece, last, layout)?;
                if pieces.peek().is_some() {
                    table.end_row(last)?;
                }
            }
        }
        if !goes_on {
            table.end_row(last)?;
        }
    }
    table.end_row(last)?;
    Ok(table)
}

/// The numbers of a piece of a row.
fn fields(table: &mut Table, piece: &str, line: usize, layout: Layout) -> Result<(), FormatError> {
    if layout == Layout::Digits {
        return piece.trim().bytes().try_for_each(|b| table.push(f32::from(b.wrapping_sub(b'0'))));
    }
    let separator = separator(piece, layout);
    let Some(separator) = separator else { return tokens(table, piece, line) };
    let piece = if separator == '\t' { piece.trim_start() } else { piece };
    let mut rest = piece.split(separator).enumerate().peekable();
    while let Some((column, field)) = rest.next() {
        let is_last = rest.peek().is_none();
        // Behind the last separator of a row nothing need follow; between nested rows nothing stands before the first either.
        let may_be_empty = is_last || (layout == Layout::Nested && column == 0);
        if field.bytes().all(|b| b.is_ascii_whitespace()) && !may_be_empty {
            return Err(hole(line, column + 1));
        }
        tokens(table, field, line)?;
    }
    Ok(())
}

fn tokens(table: &mut Table, field: &str, line: usize) -> Result<(), FormatError> {
    let between = |c: char| c.is_whitespace() || matches!(c, '[' | ']' | '{' | '}' | '"' | '\'');
    for token in field.split(between).filter(|token| !token.is_empty()) {
        table.push(number(token).ok_or_else(|| no_number(line, token))?)?;
    }
    Ok(())
}

/// What stands between the fields of a row, other than blanks.
pub(super) fn separator(row: &str, layout: Layout) -> Option<char> {
    let semicolon = (layout == Layout::Lines).then_some(';');
    [Some(','), semicolon].into_iter().flatten().find(|&separator| row.contains(separator)).or_else(|| {
        // Tabs separate where numbers stand between them without blanks.
        (row.contains('\t') && !row.trim().contains(' ')).then_some('\t')
    })
}

/// The error for numbers that whoever printed them has left out.
fn left_out(line: usize) -> FormatError {
    let expected = "all of them: in NumPy, np.set_printoptions(threshold=sys.maxsize) before it is printed, or np.savetxt";
    FormatError::syntax(line, "numbers were left out where `...` stands", expected)
}

/// The error for a field in which nothing stands.
pub(super) fn hole(line: usize, column: usize) -> FormatError {
    FormatError::syntax(line, format!("column {column} is empty"), "a number in every field: 0 for free, 1 for blocked")
}

/// How rows without brackets are laid out: `;` ends rows where more than one number stands between two of them, and digits count one by
/// one where every row is a single run of them.
pub(super) fn plain_layout(text: &str) -> Layout {
    let mut rows = text.lines().map(str::trim).filter(|l| !l.is_empty()).peekable();
    let long = rows.peek().is_some_and(|l| l.len() > 1);
    let several = rows.clone().nth(1).is_some();
    if long && several && rows.all(|l| l.bytes().all(|b| b.is_ascii_digit())) {
        return Layout::Digits;
    }
    let is_between = |c: char| c.is_whitespace() || matches!(c, ',' | '"' | '\'');
    let has_two = |piece: &str| piece.split(is_between).filter(|t| !t.is_empty()).nth(1).is_some();
    let semicolons_end_rows = text.lines().any(|line| line.contains(';') && line.split(';').any(has_two));
    if semicolons_end_rows { Layout::Semicolons } else { Layout::Lines }
}
