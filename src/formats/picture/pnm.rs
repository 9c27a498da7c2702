//! Netpbm: PBM, PGM and PPM as letters (P1, P2, P3) and as bytes (P4, P5, P6). By hand, because `image` scales by floats and refuses comments
//! among the numbers, while maps of robots depend on the exact gray.

use super::decode::{Picture, check_claim, first_only};
use crate::error::FormatError;

/// Largest number that a pixel may have.
const MOST: u32 = 65535;

/// Whether the bytes begin as Netpbm: `P1` to `P6`, and a blank or a comment.
pub(super) fn looks_like(bytes: &[u8]) -> bool {
    matches!(bytes, [b'P', b'1'..=b'6', next, ..] if next.is_ascii_whitespace() || *next == b'#')
}

/// What stands before the pixels.
struct Header {
    width: u32,
    height: u32,
    /// The number that is white.
    white: u32,
    /// Numbers of a pixel.
    channels: usize,
}

impl Header {
    /// Whether grays of 0 to 255 would not be those of the file.
    fn is_deep(&self) -> bool {
        self.channels == 1 && self.white != 255
    }

    /// A number of the file, at most [`Header::white`], with 16 bits.
    fn deep(&self, value: u32) -> u16 {
        let (value, white) = (u64::from(value), u64::from(self.white));
        ((value * 65535 + white / 2) / white) as u16
    }
}

/// Pixels, and their grays with 16 bits where 8 do not hold them.
type Pixels = (Vec<[u8; 4]>, Option<Vec<u16>>);

/// Reads the first picture of a file. A number v of 0 … m becomes ⌊(255 v + ⌊m/2⌋) / m⌋, as netpbm rounds. Of grays with another m than 255
/// ⌊(65535 v + ⌊m/2⌋) / m⌋ is kept as well.
///
/// # Errors
/// [`FormatError`]: the header or a number is broken, or the file ends too soon.
pub(super) fn read(bytes: &[u8]) -> Result<Picture, FormatError> {
    let kind = bytes.get(1).copied().unwrap_or(0);
    let mut reader = Reader { rest: bytes.get(2..).unwrap_or_default() };
    let header = reader.header(kind)?;
    let count = header.width as usize * header.height as usize;
    let (pixels, deep) = match kind {
        b'1' => (reader.bits_in_letters(count)?, None),
        b'4' => (reader.bits(header.width as usize, count)?, None),
        b'2' | b'3' => reader.letters(count, &header)?,
        _ => reader.bytes(count, &header)?,
    };
    let more = reader.rest.iter().any(|byte| !byte.is_ascii_whitespace());
    let notices = if more { vec![first_only()] } else { Vec::new() };
    Ok(Picture { width: header.width, height: header.height, pixels, has_alpha: false, deep, notices })
}

/// A row of PGM bytes with its header: `gray` is `width · height` values, 0 black and 255 white.
pub fn write_pgm(width: u32, height: u32, gray: &[u8]) -> Vec<u8> {
    let mut file = format!("P5\n{width} {height}\n255\n").into_bytes();
    file.extend_from_slice(gray);
    file
}

struct Reader<'a> {
    rest: &'a [u8],
}

impl Reader<'_> {
    fn header(&mut self, kind: u8) -> Result<Header, FormatError> {
        let (width, height) = (self.number("width")?, self.number("height")?);
        let (width, height) = check_claim(width.into(), height.into())?;
        let white = if matches!(kind, b'1' | b'4') { 1 } else { self.number("maxval")? };
        if !(1..=MOST).contains(&white) {
            return Err(FormatError::field("maxval", format!("{white}"), format!("1 to {MOST}")));
        }
        if kind >= b'4' {
            match self.rest.split_first() {
                Some((blank, rest)) if blank.is_ascii_whitespace() => self.rest = rest,
                _ => return Err(FormatError::field("header", "no blank before the pixels", "one blank")),
            }
        }
        let channels = if matches!(kind, b'3' | b'6') { 3 } else { 1 };
        Ok(Header { width, height, white, channels })
    }

    /// Goes behind blanks and comments.
    fn skip(&mut self) {
        while let Some((&first, rest)) = self.rest.split_first() {
            if first == b'#' {
                let end = rest.iter().position(|&byte| byte == b'\n' || byte == b'\r').unwrap_or(rest.len());
                self.rest = &rest[end..];
            } else if first.is_ascii_whitespace() {
                self.rest = rest;
            } else {
                break;
            }
        }
    }

    fn number(&mut self, field: &'static str) -> Result<u32, FormatError> {
        self.skip();
        let digits = self.rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let (number, rest) = self.rest.split_at(digits);
        let value = std::str::from_utf8(number).ok().and_then(|number| number.parse().ok());
        self.rest = rest;
        match value {
            Some(value) => Ok(value),
            None if self.rest.is_empty() && digits == 0 => Err(too_soon()),
            None => Err(FormatError::field(field, "no whole number that can be used", "a number in decimal digits")),
        }
    }

    /// Zeros and ones, with or without blanks between them; 1 is black.
    fn bits_in_letters(&mut self, count: usize) -> Result<Vec<[u8; 4]>, FormatError> {
        self.expect(count)?;
        let mut pixels = Vec::with_capacity(count);
        for _ in 0..count {
            self.skip();
            let (&bit, rest) = self.rest.split_first().ok_or_else(too_soon)?;
            self.rest = rest;
            pixels.push(match bit {
                b'0' => gray(255),
                b'1' => gray(0),
                _ => return Err(FormatError::field("pixels", "a letter that is neither 0 nor 1", "0 and 1")),
            });
        }
        Ok(pixels)
    }

    /// Eight pixels a byte, each row from a new one; 1 is black.
    fn bits(&mut self, width: usize, count: usize) -> Result<Vec<[u8; 4]>, FormatError> {
        let wide = width.div_ceil(8);
        let raw = self.take(wide * (count / width))?;
        let row = |row: &[u8]| (0..width).map(|x| gray(if row[x / 8] >> (7 - x % 8) & 1 == 1 { 0 } else { 255 })).collect();
        let rows: Vec<Vec<[u8; 4]>> = raw.chunks_exact(wide).map(row).collect();
        Ok(rows.concat())
    }

    fn letters(&mut self, count: usize, header: &Header) -> Result<Pixels, FormatError> {
        self.expect(count * header.channels)?;
        let mut pixels = Vec::with_capacity(count);
        let mut deep = header.is_deep().then(|| Vec::with_capacity(count));
        for _ in 0..count {
            let first = self.number("pixels")?;
            let shade = scaled(first, header.white)?;
            deep.iter_mut().for_each(|deep| deep.push(header.deep(first)));
            let mut value = || scaled(self.number("pixels")?, header.white);
            pixels.push(match header.channels {
                1 => gray(shade),
                _ => [shade, value()?, value()?, 255],
            });
        }
        Ok((pixels, deep))
    }

    /// One byte a number up to 255, two beyond, the high one first.
    fn bytes(&mut self, count: usize, header: &Header) -> Result<Pixels, FormatError> {
        let each = if header.white > 255 { 2 } else { 1 };
        let raw = self.take(count * header.channels * each)?;
        let number = |bytes: &[u8]| bytes.iter().fold(0, |value, &byte| value << 8 | u32::from(byte));
        let value = |bytes: &[u8]| scaled(number(bytes), header.white);
        let pixel = |pixel: &[u8]| match header.channels {
            1 => Ok(gray(value(pixel)?)),
            _ => Ok([value(&pixel[..each])?, value(&pixel[each..2 * each])?, value(&pixel[2 * each..])?, 255]),
        };
        let pixels = raw.chunks_exact(header.channels * each).map(pixel).collect::<Result<_, FormatError>>()?;
        let deep = header.is_deep().then(|| raw.chunks_exact(each).map(|bytes| header.deep(number(bytes))).collect());
        Ok((pixels, deep))
    }

    fn take(&mut self, count: usize) -> Result<&[u8], FormatError> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or_else(too_soon)?;
        self.rest = rest;
        Ok(taken)
    }

    /// Memory is set aside only for what the file can hold: a letter a number at least.
    fn expect(&self, numbers: usize) -> Result<(), FormatError> {
        if self.rest.len() < numbers { Err(too_soon()) } else { Ok(()) }
    }
}

fn too_soon() -> FormatError {
    FormatError::field("pixels", "the file ends too soon", "a number for each pixel")
}

fn gray(value: u8) -> [u8; 4] {
    [value, value, value, 255]
}

fn scaled(value: u32, white: u32) -> Result<u8, FormatError> {
    if value > white {
        return Err(FormatError::field("pixels", format!("{value} is more than maxval, {white}"), format!("0 to {white}")));
    }
    Ok(((value * 255 + white / 2) / white) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grays(bytes: &[u8]) -> Vec<u8> {
        read(bytes).unwrap().pixels.iter().map(|p| p[0]).collect()
    }

    #[test]
    fn all_six() {
        assert_eq!(grays(b"P1 # one is black\n3 2\n010\n1 0 1"), [255, 0, 255, 0, 255, 0]);
        assert_eq!(grays(b"P4\n3 2\n\x40\xa0"), [255, 0, 255, 0, 255, 0]);
        assert_eq!(grays(b"P2\n2 2\n# a comment\n4\n0 1 # here too\n2 4"), [0, 64, 128, 255]);
        assert_eq!(grays(b"P5 2 2 4\n\x00\x01\x02\x04"), [0, 64, 128, 255]);
        assert_eq!(grays(b"P5 2 1 1000\n\x01\xf4\x03\xe8"), [128, 255]);
        assert_eq!(read(b"P3 1 1 255 1 2 3").unwrap().pixels, [[1, 2, 3, 255]]);
        assert_eq!(read(b"P6 1 1 255\n\x01\x02\x03").unwrap().pixels, [[1, 2, 3, 255]]);
    }

    #[test]
    fn grays_keep_sixteen_bits() {
        assert_eq!(read(b"P2 2 1 65535 52700 52685").unwrap().deep, Some(vec![52700, 52685]));
        assert_eq!(read(b"P5 2 1 100\n\x00\x50").unwrap().deep, Some(vec![0, 52428]));
        for shallow in [&b"P2 1 1 255 7"[..], b"P3 1 1 9 1 2 3", b"P1 1 1 1"] {
            assert_eq!(read(shallow).unwrap().deep, None);
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let gray: Vec<u8> = (0..=255).collect();
        assert_eq!(grays(&write_pgm(32, 8, &gray)), gray);
        assert_eq!(read(&write_pgm(1, 1, &[35, 7])).unwrap().notices.len(), 1);
    }

    #[test]
    fn broken_ones_are_refused() {
        for text in ["P2", "P2 x", "P2 0 1 255 1", "P2 2 2 255 1 2 3", "P2 1 1 0 0", "P2 1 1 70000 1", "P2 1 1 4 5", "P1 1 1 2"] {
            assert!(read(text.as_bytes()).is_err(), "{text}");
        }
        assert!(matches!(read(b"P5 99999 99999 255\n"), Err(FormatError::TooLarge { .. })));
        assert!(matches!(read(b"P5 8000 8000 255\n1234"), Err(FormatError::Field { .. })));
    }
}
