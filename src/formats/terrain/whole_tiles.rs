//! Tiles of a TIFF that reach beyond the image, as they are stored.
//!
//! The decoder cuts such tiles row by row, and on the way takes the end of LZW data for the end of the file. Where the image ends together
//! with its tiles it reads each in one go; so the image is made to end there, and the reader of the heights cuts.

/// ImageWidth and ImageLength.
const SIDES: [u64; 2] = [256, 257];

/// Type of a field: one number of 32 bits.
const LONG: [u8; 2] = [0, 4];

/// The file with an image of these sides, whose directory lies at `directory`. None where the directory is not what it should be.
pub(super) fn with_sides(bytes: &[u8], directory: u64, sides: [u32; 2]) -> Option<Vec<u8>> {
    let big_endian = bytes.starts_with(b"MM");
    let is_big_tiff = bytes.get(2..4)?.contains(&43);
    let (count_bytes, field_bytes, value_at) = if is_big_tiff { (8, 20, 12) } else { (2, 12, 8) };
    let number = |at: usize, length: usize| {
        let digits = bytes.get(at..at.checked_add(length)?)?;
        let join = |number: u64, &digit: &u8| number << 8 | u64::from(digit);
        Some(if big_endian { digits.iter().fold(0, join) } else { digits.iter().rfold(0, join) })
    };
    let mut file = bytes.to_vec();
    let mut put = |at: usize, mut digits: Vec<u8>| {
        if !big_endian {
            digits.reverse();
        }
        file.get_mut(at..at + digits.len())?.copy_from_slice(&digits);
        Some(())
    };
    let mut field = usize::try_from(directory).ok()?.checked_add(count_bytes)?;
    for _ in 0..number(field - count_bytes, count_bytes)? {
        let tag = number(field, 2)?;
        if let Some(axis) = SIDES.iter().position(|side| *side == tag) {
            put(field + 2, LONG.to_vec())?;
            put(field + value_at, sides[axis].to_be_bytes().to_vec())?;
        }
        field += field_bytes;
    }
    Some(file)
}
