//! Bytes of a link, read and written one after the other: the Rust of `www/src/share/byte_stream.ts`.

use super::damaged;
use crate::error::FormatError;

/// Numbers of up to this many bits go into a varint.
const VARINT_BITS: u32 = 28;

/// Bytes that are read from the first to the last.
pub(super) struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    /// Bytes that have not been read.
    pub(super) fn left(&self) -> usize {
        self.rest.len()
    }

    pub(super) fn byte(&mut self) -> Result<u8, FormatError> {
        Ok(self.take(1)?[0])
    }

    pub(super) fn varint(&mut self) -> Result<u32, FormatError> {
        let mut value = 0;
        for shift in (0..VARINT_BITS).step_by(7) {
            let byte = self.byte()?;
            value |= u32::from(byte & 127) << shift;
            if byte < 128 {
                return Ok(value);
            }
        }
        Err(damaged("a number in it is too long"))
    }

    pub(super) fn take(&mut self, count: usize) -> Result<&'a [u8], FormatError> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or_else(|| damaged("it ends too early"))?;
        self.rest = rest;
        Ok(taken)
    }

    /// So many flags, one bit each, the most significant first.
    pub(super) fn bits(&mut self, count: usize) -> Result<Vec<u8>, FormatError> {
        let bits = self.take(count.div_ceil(8))?;
        Ok((0..count).map(|i| (bits[i / 8] >> (7 - i % 8)) & 1).collect())
    }
}

/// Writes a number of less than 28 bits: seven a byte, lowest first; the high bit says that more follow.
pub(super) fn push_varint(out: &mut Vec<u8>, mut value: u32) {
    while value >= 128 {
        out.push((value & 127) as u8 | 128);
        value >>= 7;
    }
    out.push(value as u8);
}

/// Writes flags, one bit each, the most significant first.
pub(super) fn push_bits(out: &mut Vec<u8>, flags: &[bool]) {
    out.extend(
        flags.chunks(8).map(|eight| eight.iter().enumerate().fold(0, |byte, (i, &flag)| byte | (u8::from(flag) << (7 - i)))),
    );
}
