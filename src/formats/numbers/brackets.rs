//! Matrices between brackets: `G = [0 1; 1 0];`, `[[0, 1], [1, 0]]`, `int grid[2][2] = {{0, 1}, {1, 0}};`, one or many in a program.

use std::ops::Range;

use super::scan::{Layout, scan};
use super::{Found, Table};
use crate::error::FormatError;

/// A text with more than this many letters around its matrix is a program.
const TITLE_LETTERS: usize = 40;

/// Deepest nesting that is followed: a matrix has two.
const DEEPEST: usize = 64;

/// Most brackets of numbers in a text.
const MOST: usize = 1 << 18;

/// A bracket on its way.
struct Open {
    from: usize,
    letter: u8,
    /// `dx[8]`, `grid[0][0]`: no matrix, whatever it holds.
    is_subscript: bool,
    /// Nothing but numbers so far.
    is_numeric: bool,
    /// Rows of numbers and rows that are none, one behind the other.
    is_list: bool,
    /// Numeric brackets within.
    within: Vec<Range<usize>>,
}

/// The brackets of a text that hold numbers alone, none of them within another, in order.
struct Brackets {
    numeric: Vec<Range<usize>>,
    /// The first that is never closed.
    unclosed: Option<usize>,
}

impl Brackets {
    fn of(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut open: Vec<Open> = Vec::new();
        let mut numeric = Vec::new();
        let mut too_deep = 0usize;
        for (at, &letter) in bytes.iter().enumerate() {
            match letter {
                b'[' | b'{' if open.len() == DEEPEST => {
                    too_deep += 1;
                    open.last_mut().into_iter().for_each(|top| top.is_numeric = false);
                }
                b']' | b'}' if too_deep > 0 => too_deep -= 1,
                b'[' | b'{' => {
                    let is_subscript = is_subscript(text, at) || is_quoted(bytes, at);
                    open.push(Open { from: at, letter, is_subscript, is_numeric: true, is_list: false, within: Vec::new() });
                }
                b']' | b'}' => {
                    close(&mut open, &mut numeric, bytes, at);
                    if numeric.len() > MOST {
                        break;
                    }
                }
                _ if is_numeric(letter) && !begins_digits(&bytes[at..]) => {}
                _ => open.last_mut().into_iter().for_each(|top| top.is_numeric = false),
            }
        }
        let unclosed = open.first().map(|first| first.from);
        open.into_iter().for_each(|one| numeric.extend(one.within));
        numeric.sort_by_key(|span| span.start);
        Self { numeric, unclosed }
    }
}

/// Closes the last bracket of this kind, and those within it that were left open.
fn close(open: &mut Vec<Open>, numeric: &mut Vec<Range<usize>>, bytes: &[u8], at: usize) {
    let opening = if bytes[at] == b']' { b'[' } else { b'{' };
    if !open.iter().any(|one| one.letter == opening) {
        return;
    }
    while let Some(one) = open.pop() {
        let matches = one.letter == opening;
        let has_digit = || bytes[one.from..at].iter().any(u8::is_ascii_digit);
        let is_matrix = matches && one.is_numeric && !one.is_subscript && has_digit();
        let around = open.last_mut();
        let whole = one.is_numeric && matches;
        let found = match around {
            Some(around) => {
                around.is_numeric &= whole;
                around.is_list |= !whole;
                &mut around.within
            }
            None => &mut *numeric,
        };
        if is_matrix {
            found.push(one.from..at + 1);
        } else {
            // A row beside rows that are none is no matrix of its own.
            let has_rows = |span: &Range<usize>| bytes[span.start + 1..span.end].iter().any(|b| b"[{;\n".contains(b));
            found.extend(one.within.into_iter().filter(|span| !one.is_list || has_rows(span)));
        }
        if matches {
            return;
        }
    }
}

/// Whether a bracket stands right behind a name or another bracket.
fn is_subscript(text: &str, at: usize) -> bool {
    let before = &text[..at];
    let ends_name = before.ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | ']' | ')' | '.'));
    ends_name && !before.ends_with("return")
}

/// Whether a bracket begins a text in quotation marks, or a regular expression.
fn is_quoted(bytes: &[u8], at: usize) -> bool {
    at > 0 && b"\"'`/".contains(&bytes[at - 1])
}

/// Whether a row of digits begins in quotation marks: `"0010"` is a row of cells, no number.
fn begins_digits(text: &[u8]) -> bool {
    let Some((&mark, rest)) = text.split_first().filter(|(mark, _)| matches!(mark, b'"' | b'\'')) else { return false };
    let digits = rest.iter().take_while(|&&b| matches!(b, b'0' | b'1')).count();
    digits > 1 && rest.get(digits) == Some(&mark)
}

/// What numbers are made of, and what may stand between them.
fn is_numeric(letter: u8) -> bool {
    letter.is_ascii_digit() || letter.is_ascii_whitespace() || b",;.+-eE\"'".contains(&letter)
}

/// Whether a text, perhaps only its beginning, holds a matrix between brackets.
pub(super) fn begin(text: &str) -> bool {
    let brackets = Brackets::of(text);
    let has_digit = |span: &Range<usize>| text[span.clone()].bytes().any(|b| b.is_ascii_digit());
    let has_rows = |span: &Range<usize>| text[span.start + 1..span.end].contains(['[', '{', ';', '\n']);
    let mut spans = brackets.numeric.iter().filter(|span| has_digit(span));
    if spans.clone().any(has_rows) || text.trim_start().starts_with('[') && spans.next().is_some() {
        return true;
    }
    // What is assigned and begins with a number, closed or not.
    brackets.numeric.is_empty() && almost(text).is_some()
}

/// Every matrix between brackets, in order; none where a text holds no brackets.
///
/// # Errors
/// [`FormatError`] with the line where what looks like the only matrix breaks off.
pub(super) fn find(text: &str) -> Result<Option<Vec<Found>>, FormatError> {
    if !text.contains(['[', '{']) {
        return Ok(None);
    }
    let brackets = Brackets::of(text);
    if brackets.numeric.len() > MOST {
        return Err(FormatError::TooLarge { what: "the number of brackets".into(), max: format!("{MOST} brackets") });
    }
    if let Some(rows) = one_row_each(text, &brackets.numeric)? {
        return Ok(Some(vec![rows]));
    }
    let (mut found, mut failed) = (Vec::new(), None);
    for span in brackets.numeric.iter().take(super::MAX_MATRICES) {
        match matrix(text, span.clone()) {
            Ok(one) => found.push(one),
            Err(error) => failed = failed.or(Some(error)),
        }
    }
    let found = maps_among(found);
    match failed.filter(|_| found.is_empty()) {
        Some(error) => Err(error),
        None if found.is_empty() => Err(no_matrix(text, brackets.unclosed)),
        None => Ok(Some(found)),
    }
}

/// Why a text with brackets holds no matrix.
fn no_matrix(text: &str, unclosed: Option<usize>) -> FormatError {
    let line = |at: usize| text[..at].bytes().filter(|&b| b == b'\n').count() + 1;
    if let Some(span) = almost(text) {
        let layout = layout(&text[span.clone()]);
        if let Err(error) = scan(&text[span.clone()], line(span.start) - 1, layout) {
            return error;
        }
        if unclosed == Some(span.start) {
            return FormatError::syntax(line(span.start), "`[` is never closed", "a `]` after the last row");
        }
    }
    let expected = "rows of numbers, or a bracket of numbers with at least two rows and two columns";
    FormatError::syntax(0, "no bracket of the text holds a matrix", expected)
}

/// The first bracket that is assigned, or begins the text, and begins with a number: up to its end, or the text's.
fn almost(text: &str) -> Option<Range<usize>> {
    let starts = text.char_indices().filter(|(at, c)| *c == '[' && !is_subscript(text, *at)).map(|(at, _)| at);
    let is_assigned = |at: &usize| {
        let before = text[..*at].trim_end();
        before.is_empty() || before.ends_with(['=', '('])
    };
    let begins = |at: &usize| text[*at..].trim_start_matches(['[', ' ', '\n', '\t']).starts_with(|c: char| c.is_ascii_digit());
    let from = starts.filter(is_assigned).find(begins)?;
    let mut depth = 0;
    let end = text[from..].char_indices().find(|(_, c)| {
        depth += i32::from(*c == '[') - i32::from(*c == ']');
        depth == 0
    });
    Some(from..end.map_or(text.len(), |(at, _)| from + at + 1))
}

fn layout(span: &str) -> Layout {
    if span[1..].contains(['[', '{']) || span.starts_with('{') { Layout::Nested } else { Layout::Semicolons }
}

/// The matrix of a bracket.
fn matrix(text: &str, span: Range<usize>) -> Result<Found, FormatError> {
    let (before, after) = (&text[..span.start], &text[span.end..]);
    in_two_dimensions(text, &span)?;
    let mut table = scan(&text[span.clone()], before.bytes().filter(|&b| b == b'\n').count(), layout(&text[span.clone()]))?;
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).take(TITLE_LETTERS + 1).count();
    // An assignment before and a bracket or two behind belong to the matrix; a program does not.
    table.has_rest = letters(before) + letters(after) > TITLE_LETTERS;
    let name = assigned(before);
    let computed = super::around::computed(text, &span, name);
    Ok(Found { notices: computed.into_iter().collect(), ..Found::new(name, table) })
}

/// A bracket of brackets of rows is more than one matrix, and an empty one is no row.
fn in_two_dimensions(text: &str, span: &Range<usize>) -> Result<(), FormatError> {
    let (mut depth, mut deepest, mut second, mut last) = (0usize, 0usize, 0usize, b' ');
    for (at, letter) in text.as_bytes()[span.clone()].iter().copied().enumerate().filter(|(_, b)| !b.is_ascii_whitespace()) {
        let line = || text[..span.start + at].bytes().filter(|&b| b == b'\n').count() + 1;
        match letter {
            b'[' | b'{' => {
                depth += 1;
                deepest = deepest.max(depth);
                second += usize::from(depth == 2);
                if deepest > 2 && second > 1 {
                    let expected = "one matrix: rows of numbers within one bracket";
                    return Err(FormatError::syntax(line(), "the bracket has three dimensions", expected));
                }
            }
            b']' | b'}' if matches!(last, b'[' | b'{') => {
                return Err(FormatError::syntax(line(), "a row is empty", "numbers in every row"));
            }
            b']' | b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        last = letter;
    }
    Ok(())
}

/// `[0, 1]` in one line, `[1, 0]` in the next, and nothing else: the rows of one matrix.
fn one_row_each(text: &str, spans: &[Range<usize>]) -> Result<Option<Found>, FormatError> {
    let is_row = |span: &Range<usize>| !text[span.start + 1..span.end].contains(['[', '{', ';', '\n']);
    let ends = spans.iter().map(|span| span.start).chain([text.len()]);
    let mut outside = [0].into_iter().chain(spans.iter().map(|span| span.end)).zip(ends).map(|(from, to)| &text[from..to]);
    let is_blank = |between: &str| between.chars().all(|c| c.is_whitespace() || c == ',');
    if spans.len() < 2 || !spans.iter().all(is_row) || !outside.all(is_blank) {
        return Ok(None);
    }
    Ok(Some(Found::new("", scan(text, 0, Layout::Nested)?)))
}

/// Those that can be maps: at least two by two, unless nothing else is there. Beside another, what is two wide or high is a list of places
/// or moves if the other is larger, or if it holds numbers below 0.
fn maps_among(mut found: Vec<Found>) -> Vec<Found> {
    let sides = |table: &Table| table.row(0).len().min(table.height());
    if let [only] = &found[..]
        && !only.table.has_rest
    {
        return found;
    }
    let smallest = found.iter().map(|one| sides(&one.table)).max().unwrap_or(0).clamp(2, 3);
    found.retain(|one| sides(&one.table) >= smallest);
    if found.len() > 1 {
        found.retain(|one| sides(&one.table) > 2 || one.table.numbers().all(|number| number >= 0.0));
    }
    found
}

/// The name to which what follows is assigned: `G` of `G = `, `grid` of `int grid[2][2] = `, `m` of `m = np.array(`.
fn assigned(before: &str) -> &str {
    let line = before.rsplit(['\n', ';']).find(|part| !part.trim().is_empty()).unwrap_or("");
    let Some((left, _)) = line.rsplit_once('=') else { return "" };
    let mut name = left.trim_end();
    while let Some((rest, _)) = name.strip_suffix(']').and_then(|open| open.rsplit_once('[')) {
        name = rest.trim_end();
    }
    let from = name.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |at| at + 1);
    name.get(from..).unwrap_or("")
}
