//! Lines above the rows that say how large a matrix is, and perhaps where start and goal are, as programming courses have it.

use super::Table;
use crate::error::Notice;

/// Two pairs of numbers, as they stand in the lines above.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::formats) struct Ends {
    /// The pair for the start.
    pub start: [u32; 2],
    /// The pair for the goal.
    pub goal: [u32; 2],
}

/// Most rows that may stand above.
const MOST_ROWS: usize = 6;

/// Takes the size, and start and goal, from the rows above the matrix; a table without such rows stays what it is.
pub(super) fn without(table: Table) -> (Table, Option<Ends>, Option<Notice>) {
    let Some(rows) = head_rows(&table) else { return (table, None, None) };
    let numbers: Vec<f32> = (0..rows).flat_map(|row| table.row(row).iter()).collect();
    let body = (table.row(rows).len(), table.height() - rows);
    let Some(ends) = size_and_ends(&numbers, body) else { return (table, None, None) };
    let last = table.line(rows - 1);
    let message = match ends {
        Some(_) => format!("lines {} to {last} were read as the size, the start and the goal", table.line(0)),
        None => format!("the numbers down to line {last} were read as the size {} × {}", body.0, body.1),
    };
    let notice = Notice::new("matrix-size-line", message).with("line", last);
    let notice = notice.with("width", body.0).with("height", body.1).with("ends", ends.is_some());
    (table.without(rows, false), ends, Some(notice))
}

/// How many rows stand above: those that are shorter than the ones that follow, which are all equally long. A matrix of two columns may
/// have a pair above it that no cell can be.
fn head_rows(table: &Table) -> Option<usize> {
    let height = table.height();
    let width = table.row(height.checked_sub(1)?).len();
    let equal = table.rows().rev().take_while(|row| row.len() == width).count();
    let above = height - equal;
    let above = if above == 0 && width == 2 && height > 4 { 1 } else { above };
    (1..=MOST_ROWS).contains(&above).then_some(above).filter(|&above| height > above)
}

/// What the numbers above say, if they name the size of what follows: `n`, `rows columns` or `columns rows`, then perhaps two pairs.
fn size_and_ends(numbers: &[f32], (width, height): (usize, usize)) -> Option<Option<Ends>> {
    let whole = |n: f32| (n.fract() == 0.0 && (0.0..65536.0).contains(&n)).then_some(n as u32);
    let numbers: Vec<u32> = numbers.iter().map(|&n| whole(n)).collect::<Option<_>>()?;
    let is = |a: u32, b: u32| (a as usize, b as usize) == (height, width) || (a as usize, b as usize) == (width, height);
    match numbers[..] {
        [n] if is(n, n) => Some(None),
        [a, b] if is(a, b) => Some(None),
        [a, b, c, d, e, f] if is(a, b) => Some(Some(Ends { start: [c, d], goal: [e, f] })),
        [n, c, d, e, f] if is(n, n) => Some(Some(Ends { start: [c, d], goal: [e, f] })),
        _ => None,
    }
}
