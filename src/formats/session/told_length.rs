//! How many characters a link's text has, told in its beginning: the Rust of `www/src/share/told_length.ts`, which says how.

use super::envelope::from_base64url;

const BASE: usize = 32;
const EMPTY: [u8; 4] = [0, 0, 0xff, 0xff];
const BLOCK: usize = 1 + EMPTY.len();
const MOST_DIGITS: usize = 6;
/// Bytes before the blocks: the one that names the way of packing.
const BEFORE: usize = 1;

/// The blocks for a text of so many other bytes, as many as let it end in a letter or a digit.
pub(super) fn blocks_of_length(others: usize) -> Vec<u8> {
    let fits = |digits: &usize| {
        let bytes = others + BLOCK * digits;
        !bytes.is_multiple_of(3) && (bytes * 4).div_ceil(3) < BASE.pow(*digits as u32)
    };
    let digits = (1..).find(fits).expect("lengths grow slower than powers");
    let length = ((others + BLOCK * digits) * 4).div_ceil(3);
    let digit = |k: usize| (length / BASE.pow((digits - 1 - k) as u32) % BASE) as u8;
    (0..digits).flat_map(|k| [&[digit(k) << 3][..], &EMPTY].concat()).collect()
}

/// None where none is told: in links of before, and where hardly anything is left.
pub(super) fn told_length(text: &str) -> Option<usize> {
    let most = (BEFORE + BLOCK * (MOST_DIGITS + 1)).div_ceil(3) * 4;
    let head = text.get(..most.min(text.len() - text.len() % 4))?;
    let bytes = from_base64url(head).ok()?;
    let digit = |block: &[u8]| (block[0].is_multiple_of(8) && block[1..] == EMPTY).then_some(usize::from(block[0] / 8));
    let mut length = None;
    for block in bytes[BEFORE..].chunks_exact(BLOCK) {
        match digit(block) {
            Some(digit) => length = Some(length.unwrap_or(0) * BASE + digit),
            None => return length,
        }
    }
    None
}
