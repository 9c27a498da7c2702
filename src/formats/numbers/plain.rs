//! Rows of numbers without brackets: CSV, blanks, semicolons, digits; with names, sizes or a title above; several of them with a blank
//! line between; what MATLAB prints of a wide matrix, a few columns at a time.

use super::labels::{self, Labels};
use super::scan::{Layout, plain_layout, scan, separator};
use super::table::number;
use super::{Found, head};
use crate::error::{FormatError, Notice};

/// Most fields of a line that are looked at to tell names from numbers.
const MOST_FIELDS: usize = 8192;

/// More lines than any table has.
const MOST_LINES: usize = 1 << 20;

/// A block of lines without a blank one among them.
struct Block<'a> {
    /// `G` of the line `G =` above it.
    title: &'a str,
    /// Whether `Columns 4 through 6` stands above it.
    goes_on: bool,
    /// Its first line in the text, from 1.
    line: usize,
    /// Its lines.
    lines: Vec<&'a str>,
}

/// Whether a text, perhaps only its beginning, starts with rows of numbers.
pub(super) fn begins(text: &str) -> bool {
    let mut lines = text.lines().filter(|line| !line.trim().is_empty() && title(line).is_none() && columns(line).is_none());
    let Some(first) = lines.next() else { return false };
    let numbers = |line: &str| {
        let is_between = |c: char| c.is_whitespace() || matches!(c, ',' | ';' | '"' | '\'');
        let mut tokens = line.split(is_between).filter(|token| !token.is_empty()).peekable();
        tokens.peek().is_some() && tokens.all(|token| number(token).is_some() || token.bytes().all(|b| b.is_ascii_digit()))
    };
    // Names above, or before each row, and numbers below: at least half of the second line's.
    let mostly = |line: &str| {
        let fields = fields(line);
        2 * fields.iter().filter(|field| number(field.trim().trim_matches('"')).is_some()).count() > fields.len()
    };
    numbers(first)
        || (labels::is_names(&fields(first)) && lines.next().is_some_and(mostly))
        || first.contains(',') && mostly(first)
}

/// Every matrix of a text.
///
/// # Errors
/// [`FormatError`] with the line of the first thing that is no number.
pub(super) fn find(text: &str) -> Result<Vec<Found>, FormatError> {
    if text.bytes().filter(|&b| b == b'\n').count() > MOST_LINES {
        return Err(FormatError::TooLarge { what: "the number of lines".into(), max: format!("{MOST_LINES} lines") });
    }
    let mut found: Vec<Found> = Vec::new();
    for block in joined(blocks(text)) {
        let one = read(&block)?;
        match found.last_mut().filter(|_| block.goes_on) {
            Some(before) => before.table = before.table.beside(&one.table)?,
            None => found.push(one),
        }
        if let Some(last) = found.last_mut().filter(|last| block.goes_on && last.notices.is_empty()) {
            let message = "columns that were printed in several blocks were put side by side";
            last.notices.push(Notice::new("matrix-columns-joined", message));
        }
    }
    Ok(found)
}

/// The lines of a text in blocks.
fn blocks(text: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    let (mut name, mut goes_on, mut is_open) = ("", false, false);
    for (index, line) in text.lines().enumerate() {
        if line.trim().is_empty() {
            is_open = false;
        } else if let Some(title) = title(line) {
            (name, goes_on, is_open) = (title, false, false);
        } else if let Some(first) = columns(line) {
            (goes_on, is_open) = (first > 1, false);
        } else if let Some(block) = blocks.last_mut().filter(|_| is_open) {
            block.lines.push(line);
        } else {
            blocks.push(Block { title: name, goes_on, line: index + 1, lines: vec![line] });
            (name, goes_on, is_open) = ("", false, true);
        }
    }
    blocks
}

/// Blocks of a single line belong to what follows: blank lines stand between all rows, or below a line of sizes.
fn joined(blocks: Vec<Block<'_>>) -> Vec<Block<'_>> {
    let mut joined: Vec<Block<'_>> = Vec::new();
    for block in blocks {
        let is_free = block.title.is_empty() && !block.goes_on;
        match joined.last_mut().filter(|before| is_free && (before.lines.len() == 1 || before.is_spaced(&block))) {
            Some(before) => {
                before.lines.resize(block.line - before.line, "");
                before.lines.extend(block.lines);
            }
            None => joined.push(block),
        }
    }
    joined
}

impl Block<'_> {
    /// Whether blank lines stand between all rows so far, and before a single one that follows.
    fn is_spaced(&self, next: &Self) -> bool {
        next.lines.len() == 1 && self.lines.windows(2).all(|pair| pair[0].trim().is_empty() != pair[1].trim().is_empty())
    }
}

/// The name of a line `G =`.
fn title(line: &str) -> Option<&str> {
    let name = line.trim_end().strip_suffix('=')?.trim();
    Some(name).filter(|name| !name.contains(['=', ',', ';']))
}

/// The first column of a line such as `Columns 4 through 6`, as MATLAB and Octave print it, or of the same in Chinese.
fn columns(line: &str) -> Option<u32> {
    let rest = line.trim().strip_prefix("Columns").or_else(|| line.trim().strip_prefix("Column"));
    let rest = rest.or_else(|| line.trim().strip_prefix('列'))?;
    let mut words = rest.split(|c: char| c.is_whitespace() || c == ':').filter(|word| !word.is_empty());
    let first = words.next()?.parse().ok()?;
    let is_word = |word: &str| matches!(word, "through" | "to" | "and" | "至") || word.parse::<u32>().is_ok();
    words.all(is_word).then_some(first)
}

/// The fields of a line, whatever stands between them.
fn fields(line: &str) -> Vec<&str> {
    match separator(line, Layout::Lines) {
        Some(separator) => line.split(separator).take(MOST_FIELDS).collect(),
        None => line.split_whitespace().take(MOST_FIELDS).collect(),
    }
}

/// The matrix of a block.
fn read(block: &Block<'_>) -> Result<Found, FormatError> {
    let first = fields(block.lines[0]);
    let above = labels::is_names(&first).then_some(block.line);
    let skipped = usize::from(above.is_some());
    let below = block.lines.get(skipped).map(|line| fields(line)).unwrap_or_default();
    let before = below.len() > 1 && below.first().is_some_and(|field| is_name(field));
    let body = body(&block.lines[skipped..], before);
    let table = scan(&body, block.line + skipped - 1, plain_layout(&body))?;
    // Above a column of labels a name may stand, or nothing at all.
    let corner_is_empty = first.first().is_some_and(|field| field.trim().trim_matches('"').is_empty());
    let labels = Labels { above, corner_is_empty, before };
    let (table, ends, size) = head::without(table);
    let (table, label) = if size.is_some() { (table, None) } else { labels::without(table, &labels)? };
    let notices = size.into_iter().chain(label).collect();
    Ok(Found { notices, ends, ..Found::new(block.title, table) })
}

/// The name of a row, as R writes it: with a letter, or between quotation marks.
fn is_name(field: &str) -> bool {
    let bare = field.trim();
    bare.starts_with('"') && bare.trim_matches('"').starts_with(char::is_alphabetic)
        || bare.starts_with(char::is_alphabetic) && number(bare).is_none() && !bare.eq_ignore_ascii_case("nan")
}

/// The lines below the names as one text, without the first field of each where that is a name.
fn body(lines: &[&str], before: bool) -> String {
    let mut text = String::with_capacity(lines.iter().map(|line| line.len() + 1).sum());
    for line in lines {
        let kept = match separator(line, Layout::Lines) {
            _ if !before => line,
            Some(separator) => line.split_once(separator).map_or("", |(_, rest)| rest),
            None => line.trim_start().split_once(char::is_whitespace).map_or("", |(_, rest)| rest),
        };
        text.push_str(kept);
        text.push('\n');
    }
    text
}
