//! Digits of five by three dots.

const ROWS: [[u8; 5]; 10] = [
    [7, 5, 5, 5, 7],
    [2, 6, 2, 2, 7],
    [7, 1, 7, 4, 7],
    [7, 1, 7, 1, 7],
    [5, 5, 7, 1, 1],
    [7, 4, 7, 1, 7],
    [7, 4, 7, 5, 7],
    [7, 1, 2, 2, 2],
    [7, 5, 7, 5, 7],
    [7, 5, 7, 1, 7],
];

/// Whether a place, in pixels from the upper left of a text, is inked; `dot` pixels a dot.
pub fn is_ink(text: &str, x: f64, y: f64, dot: f64) -> bool {
    let (column, row) = ((x / dot).floor(), (y / dot).floor());
    if column < 0.0 || !(0.0..5.0).contains(&row) {
        return false;
    }
    let (letter, column) = (column as usize / 4, column as usize % 4);
    let digit = text.as_bytes().get(letter).and_then(|byte| byte.checked_sub(b'0'));
    digit.is_some_and(|digit| column < 3 && ROWS[usize::from(digit)][row as usize] >> (2 - column) & 1 == 1)
}
