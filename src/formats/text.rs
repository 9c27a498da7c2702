//! From bytes to lines: what every text format shares.

use std::borrow::Cow;

use super::foreign;
use crate::error::FormatError;

/// Largest text that is read: a 4096 × 4096 matrix at three bytes a cell fits.
pub const MAX_TEXT_BYTES: usize = 64 << 20;

/// Largest file of any kind that is read, a raster of heights or a whole comparison: 8192 × 8192 heights at eight letters each fit.
pub const MAX_BYTES: usize = 512 << 20;

/// The text of a file: UTF-8, with or without a byte order mark. Other 8-bit encodings pass as well, because the formats
/// themselves are ASCII and only comments and names can be hurt.
///
/// # Errors
/// [`FormatError::Foreign`] or [`FormatError::NotText`] for UTF-16 and binary files, [`FormatError::TooLarge`] beyond 64 MiB.
pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, FormatError> {
    decode_up_to(bytes, MAX_TEXT_BYTES)
}

/// The same for files of up to `max` bytes.
pub(super) fn decode_up_to(bytes: &[u8], max: usize) -> Result<Cow<'_, str>, FormatError> {
    if bytes.len() > max {
        let what = format!("a file of {} MiB", bytes.len() >> 20);
        return Err(FormatError::TooLarge { what, max: format!("{} MiB", max >> 20) });
    }
    if let Some(error) = foreign::by_first_bytes(bytes) {
        return Err(error);
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match bytes.iter().position(|&b| is_binary(b)) {
        None => Ok(String::from_utf8_lossy(bytes)),
        // UTF-16 without a mark: every other byte of plain letters is 0.
        Some(at) if bytes[at] == 0 && at < 2 && bytes.len() > 3 && bytes[at + 2] == 0 => Err(foreign::UTF_16),
        Some(at) => Err(FormatError::NotText { found: format!("binary data (byte {at} is {:#04x})", bytes[at]) }),
    }
}

/// Control characters that no text holds; tab, line ends and DOS's end of file are fine.
fn is_binary(byte: u8) -> bool {
    byte < 0x20 && !matches!(byte, b'\t' | b'\n' | b'\r' | 0x0b | 0x0c | 0x1a)
}

/// (number from 1, line without its end) for LF, CRLF and lone CR.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let text = text.trim_end_matches('\u{1a}');
    text.split(end).map(|line| line.strip_suffix('\r').unwrap_or(line)).enumerate().map(|(i, line)| (i + 1, line))
}

/// Whether a text is JSON of this program: whatever stands in its names, it is nothing else.
pub(super) fn is_ours(text: &str) -> bool {
    text.trim_start().starts_with('{') && text.contains("\"formicarium/")
}

/// A short quotation for an error message.
pub(super) fn quote(text: &str) -> String {
    const LONGEST: usize = 30;
    let text = text.trim();
    let mut short: String = text.chars().take(LONGEST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().nth(LONGEST).is_some() {
        short.push('…');
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_and_line_ends_are_taken() {
        for text in ["\u{feff}a\nb\n", "a\r\nb\r\n", "a\rb\r", "a\nb\n\u{1a}"] {
            let text = decode(text.as_bytes()).unwrap();
            let lines: Vec<_> = lines(&text).collect();
            assert_eq!(lines[..2], [(1, "a"), (2, "b")], "{text:?}");
        }
    }

    #[test]
    fn what_is_no_text_is_named() {
        let utf16: Vec<u8> = "type octile".encode_utf16().flat_map(u16::to_le_bytes).collect();
        for (bytes, name) in
            [(&utf16[..], "UTF-16"), (b"\xff\xfet\0", "UTF-16"), (b"\x89PNG\r\n", "picture"), (b"0 1\x00", "byte 3")]
        {
            let error = decode(bytes).unwrap_err().to_string();
            assert!(error.contains(name), "{error}");
        }
    }
}
