//! Rows of numbers without brackets: CSV, blanks, semicolons, digits; with names, sizes or a title above; several of them with a blank
//! line between; what MATLAB prints of a wide matrix, a few columns at a time.

use std::borrow::Cow;

use super::labels::{self, Labels};
use super::scan::{Layout, plain_layout, scan, separator};
use super::table::number;
use super::{Found, head, spelling};
use crate::error::{FormatError, Notice};

/// Most fields of a line that are looked at to tell names from numbers.
const MOST_FIELDS: usize = 8192;

/// More lines than any table has.
const MOST_LINES: usize = 1 << 20;

/// A block of lines without a blank one among them.
struct Block<'a> {
    /// `G` of the line `G =` above it.
    title: &'a str,
    /// 4 and 6 of `Columns 4 through 6` above it.
    columns: Option<(u32, u32)>,
    /// Its first line in the text, from 1, and how many lines it has.
    line: usize,
    lines: usize,
    /// Whether blank lines stand between all of its rows.
    is_spaced: bool,
    /// From its first line to the end of its last.
    text: &'a str,
}

/// Whether a text, perhaps only its beginning, starts with rows of numbers.
pub(super) fn begins(text: &str) -> bool {
    let mut lines = text
        .lines()
        .filter(|line| !line.trim().is_empty() && title(line).is_none() && columns(line).is_none() && !is_display(line));
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
    let (spelled, commas) = spelling::plain(text)?;
    let text = spelled.as_ref();
    let mut found: Vec<Found> = Vec::new();
    for block in joined(text, blocks(text)) {
        let mut one = read(&block)?;
        one.notices.extend(commas.clone());
        check_columns(&block, &one, found.last())?;
        let goes_on = block.goes_on();
        match found.last_mut().filter(|_| goes_on) {
            Some(before) => before.table = before.table.beside(&one.table)?,
            None => found.push(one),
        }
        if let Some(last) = found.last_mut().filter(|last| goes_on && last.notices.is_empty()) {
            let message = "columns that were printed in several blocks were put side by side";
            last.notices.push(Notice::new("matrix-columns-joined", message));
        }
    }
    Ok(found)
}

impl Block<'_> {
    /// Whether its columns stand beside those of the block before.
    fn goes_on(&self) -> bool {
        self.columns.is_some_and(|(first, _)| first > 1)
    }
}

/// The columns of a printed block must be as many as stand above it, and follow those of the block before.
fn check_columns(block: &Block<'_>, one: &Found, before: Option<&Found>) -> Result<(), FormatError> {
    let Some((first, last)) = block.columns else { return Ok(()) };
    let width = |found: &Found| found.table.row(0).len() as u64;
    let had = if first > 1 { before.map_or(0, width) } else { 0 };
    if u64::from(first) == had + 1 && u64::from(last) == had + width(one) {
        return Ok(());
    }
    let what = format!("columns {first} to {last} stand above {} columns, behind {had}", width(one));
    Err(FormatError::syntax(block.line.saturating_sub(1), what, "every column once, from the first to the last"))
}

/// The lines of a text in blocks.
fn blocks(text: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    let (mut name, mut above, mut is_open) = ("", None, false);
    let mut from = 0;
    for (index, line) in text.split('\n').enumerate() {
        let to = from + line.len();
        if line.trim().is_empty() {
            is_open = false;
        } else if let Some(title) = title(line) {
            (name, above, is_open) = (title, None, false);
        } else if let Some(columns) = columns(line) {
            (above, is_open) = (Some(columns), false);
        } else if is_display(line) {
            is_open = false;
        } else if let Some(block) = blocks.last_mut().filter(|_| is_open) {
            (block.lines, block.is_spaced) = (block.lines + 1, false);
            block.text = &text[start_of(text, block.text)..to];
        } else {
            blocks.push(Block { title: name, columns: above, line: index + 1, lines: 1, is_spaced: true, text: &text[from..to] });
            (name, above, is_open) = ("", None, true);
        }
        from = to + 1;
    }
    blocks
}

/// Where a part of a text begins in it.
fn start_of(text: &str, part: &str) -> usize {
    part.as_ptr() as usize - text.as_ptr() as usize
}

/// Blocks of a single line belong to what follows: blank lines stand between all rows, or below a line of sizes.
fn joined<'a>(text: &'a str, blocks: Vec<Block<'a>>) -> Vec<Block<'a>> {
    let mut joined: Vec<Block<'_>> = Vec::new();
    for block in blocks {
        let is_free = block.title.is_empty() && block.columns.is_none();
        match joined.last_mut().filter(|before| is_free && (before.lines == 1 || before.is_spaced && block.lines == 1)) {
            Some(before) => {
                before.is_spaced &= block.lines == 1;
                before.lines = block.line - before.line + block.lines;
                let (from, end) = (start_of(text, before.text), start_of(text, block.text) + block.text.len());
                before.text = &text[from..end];
            }
            None => joined.push(block),
        }
    }
    joined
}

/// The name of a line `G =`.
fn title(line: &str) -> Option<&str> {
    let name = line.trim_end().strip_suffix('=')?.trim();
    Some(name).filter(|name| !name.contains(['=', ',', ';']))
}

/// Whether a text is what MATLAB or Julia print of one matrix.
pub(super) fn is_displayed(text: &str) -> bool {
    let said = text.lines().filter(|line| !line.trim().is_empty() && title(line).is_none());
    said.take(1).any(is_display)
}

/// What MATLAB and Julia print above a matrix: `2×3 logical array`, `2×3 Matrix{Int64}:`.
fn is_display(line: &str) -> bool {
    let mut words = line.split_whitespace();
    let size = words.next().unwrap_or("");
    let is_size = size.split(['×', 'x']).filter(|side| side.parse::<u32>().is_ok()).count() == 2;
    is_size && words.any(|word| ["array", "matrix"].contains(&word) || word.starts_with("Matrix{"))
}

/// The first and the last column of a line such as `Columns 4 through 6`, as MATLAB and Octave print it, or of the same in Chinese.
fn columns(line: &str) -> Option<(u32, u32)> {
    let rest = line.trim().strip_prefix("Columns").or_else(|| line.trim().strip_prefix("Column"));
    let rest = rest.or_else(|| line.trim().strip_prefix('列'))?;
    let mut words = rest.split(|c: char| c.is_whitespace() || c == ':').filter(|word| !word.is_empty());
    let first = words.next()?.parse().ok()?;
    let mut last = first;
    for word in words {
        match word.parse() {
            Ok(number) => last = number,
            Err(_) if matches!(word, "through" | "to" | "and" | "至") => {}
            Err(_) => return None,
        }
    }
    Some((first, last))
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
    let (top, rest) = block.text.split_once('\n').unwrap_or((block.text, ""));
    let first = fields(top);
    let above = labels::is_names(&first).then_some(block.line);
    let (text, skipped) = if above.is_some() { (rest, 1) } else { (block.text, 0) };
    let below = fields(text.split('\n').next().unwrap_or(""));
    let before = below.len() > 1 && below.first().is_some_and(|field| is_name(field));
    let body = if before { Cow::Owned(without_names(text)) } else { Cow::Borrowed(text) };
    let table = scan(&body, block.line + skipped - 1, plain_layout(&body))?;
    // Above a column of labels a name may stand, or nothing at all.
    let is_corner = |field: &&str| {
        let bare = field.trim().trim_matches('"');
        bare.is_empty()
            || number(bare).is_none() && first.get(1).is_some_and(|next| number(next.trim().trim_matches('"')).is_some())
    };
    let labels = Labels { above, has_corner: first.first().is_some_and(is_corner), before };
    let (table, ends, size) = head::without(table);
    let (table, label) = if size.is_some() { (table, None) } else { labels::without(table, &labels)? };
    let notices = size.into_iter().chain(label).collect();
    let named = |field: &&str| field.trim().trim_matches(['"', '\'']).trim().to_owned();
    let names = if above.is_some() { first.iter().map(named).filter(|name| !name.is_empty()).collect() } else { Vec::new() };
    Ok(Found { notices, ends, names, ..Found::new(block.title, table) })
}

/// The name of a row, as R writes it: with a letter, or between quotation marks.
fn is_name(field: &str) -> bool {
    let bare = field.trim();
    bare.starts_with('"') && bare.trim_matches('"').starts_with(char::is_alphabetic)
        || bare.starts_with(char::is_alphabetic) && number(bare).is_none() && !bare.eq_ignore_ascii_case("nan")
}

/// The lines without the first field of each, which is a name.
fn without_names(lines: &str) -> String {
    let mut text = String::with_capacity(lines.len());
    for line in lines.split('\n') {
        let kept = match separator(line, Layout::Lines) {
            Some(separator) => line.split_once(separator).map_or("", |(_, rest)| rest),
            None => line.trim_start().split_once(char::is_whitespace).map_or("", |(_, rest)| rest),
        };
        text.push_str(kept);
        text.push('\n');
    }
    text
}
