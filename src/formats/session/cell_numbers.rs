//! Numbers of a map's cells as bytes: the heights of a terrain, or the factors of weighted ground. First a byte that says how:
//!
//! - 0, decimals: u8 places p · varint s · 1 if some have no data, and then a bit a cell that says which · zig-zag varints, each the
//!   difference from the number before; the cell's is s · number / 10^p
//! - 1, floats: the bits of each xor those of the one before, all lowest bytes first, then the next ones
//!
//! `www/src/share/cell_numbers.ts` writes either, whichever tells the numbers exactly; here floats alone are written, which always do.

use super::bytes::Reader;
use super::damaged;
use crate::error::FormatError;

const DECIMALS: u8 = 0;
const FLOATS: u8 = 1;
const MOST_PLACES: u8 = 3;

/// Everything that is read is checked against `count` before room is made for it.
pub(super) fn unpack(reader: &mut Reader<'_>, count: usize) -> Result<Vec<f32>, FormatError> {
    match reader.byte()? {
        DECIMALS => decimals(reader, count),
        FLOATS => floats(reader, count),
        _ => Err(damaged("its numbers are packed in no known way")),
    }
}

fn decimals(reader: &mut Reader<'_>, count: usize) -> Result<Vec<f32>, FormatError> {
    let places = reader.byte()?;
    let step = i64::from(reader.varint()?);
    if places > MOST_PLACES {
        return Err(damaged("its numbers have too many decimals"));
    }
    let scale = f64::from(10_u32.pow(places.into()));
    let missing = if reader.byte()? == 1 { Some(reader.bits(count)?) } else { None };
    let is_missing = |i: usize| missing.as_ref().is_some_and(|missing| missing[i] == 1);
    // A byte a number at least: nothing is made for numbers that cannot be there.
    if reader.left() < (0..count).filter(|&i| !is_missing(i)).count() {
        return Err(damaged("it ends too early"));
    }
    let mut value = 0_i64;
    let mut numbers = Vec::with_capacity(count);
    for i in 0..count {
        if is_missing(i) {
            numbers.push(f32::NAN);
            continue;
        }
        let code = i64::from(reader.varint()?);
        value += step * if code % 2 == 1 { -(code + 1) / 2 } else { code / 2 };
        numbers.push((value as f64 / scale) as f32);
    }
    Ok(numbers)
}

fn floats(reader: &mut Reader<'_>, count: usize) -> Result<Vec<f32>, FormatError> {
    let planes = reader.take(4 * count)?;
    let mut bits = 0;
    let mut number = |i: usize| {
        bits ^= (0..4).fold(0, |bits, byte| bits | (u32::from(planes[byte * count + i]) << (8 * byte)));
        f32::from_bits(bits)
    };
    Ok((0..count).map(&mut number).collect())
}

/// Writes floats.
pub(super) fn push(out: &mut Vec<u8>, numbers: &[f32]) {
    // There are many ways to write that there is no data; one is enough.
    let bits = |number: &f32| if number.is_nan() { 0x7fc0_0000 } else { number.to_bits() };
    let all: Vec<u32> = numbers.iter().map(bits).collect();
    let changed: Vec<u32> = all.iter().enumerate().map(|(i, bits)| bits ^ if i == 0 { 0 } else { all[i - 1] }).collect();
    out.push(FLOATS);
    (0..4).for_each(|byte| out.extend(changed.iter().map(|bits| (bits >> (8 * byte)) as u8)));
}
