//! Container bytes ⇄ the text of a link: base64url of one byte (0 stored, 1 raw deflate) and the bytes. What is written is deflated, tells its
//! own length, and ends in a letter or a digit.

use std::io::{Read as _, Write as _};

use flate2::Compression;
use flate2::bufread::DeflateDecoder;
use flate2::write::DeflateEncoder;

use super::container::MAX_CONTAINER;
use super::damaged;
use super::told_length::{blocks_of_length, told_length};
use crate::error::FormatError;

const SHORTEST_LINE: usize = 20;
/// So many characters are tried, over all ends that a broken text may have; an honest link, broken into lines, needs less.
const MOST_TRIED: usize = 1 << 20;
const STORED: u8 = 0;
const DEFLATED: u8 = 1;
const FOREIGN: &str = "it contains characters no link has";
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

pub(super) fn seal(bytes: &[u8]) -> String {
    let packed = deflate(bytes);
    to_base64url(&[&[DEFLATED], &blocks_of_length(1 + packed.len())[..], &packed].concat())
}

/// The text may be in several words: a program has broken it, or the words behind are none of it.
pub(super) fn open(words: &[String]) -> Result<Vec<u8>, FormatError> {
    let whole = words.concat();
    if whole.len() > 2 * MAX_CONTAINER {
        return Err(FormatError::TooLarge { what: "the link".into(), max: format!("{MAX_CONTAINER} bytes") });
    }
    let told = told_length(&whole);
    // How far it may reach, the likeliest first.
    let ends = match told {
        Some(length) => vec![length.min(whole.len()), whole.len()],
        None => words
            .iter()
            .scan(0, |end, word| {
                *end += word.len();
                Some(*end)
            })
            .collect(),
    };
    let mut first = None;
    let mut tried = 0;
    for end in ends {
        tried += end;
        if tried > MOST_TRIED && first.is_some() {
            break;
        }
        match unsealed(&whole[..end]) {
            // Of what is too large the rest would be, too.
            Err(fault @ FormatError::TooLarge { .. }) => return Err(fault),
            Err(fault) => first = first.or(Some(fault)),
            bytes => return bytes,
        }
    }
    match (first, told) {
        (Some(FormatError::Field { .. }), Some(told)) => Err(missing(words, told)),
        (fault, _) => Err(fault.unwrap_or_else(|| damaged(FOREIGN))),
    }
}

/// What is wrong with a link that knows its length. Where programs break links, lines are long: words behind it are none of it.
fn missing(words: &[String], told: usize) -> FormatError {
    let length_of = |some: &[String]| some.iter().map(String::len).sum::<usize>();
    let end = words.iter().skip(1).position(|word| word.len() < SHORTEST_LINE).map_or(words.len(), |at| at + 1);
    let here = length_of(&words[..end]);
    let is_cut = here < told && length_of(words) != told;
    if is_cut { damaged(&format!("{} of its {told} characters are missing", told - here)) } else { damaged(super::CHANGED) }
}

fn unsealed(text: &str) -> Result<Vec<u8>, FormatError> {
    let mut sealed = from_base64url(text)?;
    let payload = sealed.split_off(1);
    match sealed[0] {
        STORED => Ok(payload),
        DEFLATED => inflate(&payload),
        _ => Err(damaged("its first byte names no way of packing")),
    }
}

fn deflate(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).and_then(|()| encoder.finish()).expect("memory can always be written to")
}

/// Nothing beyond the largest honest container is unpacked, and nothing may stand behind what was packed.
fn inflate(packed: &[u8]) -> Result<Vec<u8>, FormatError> {
    let mut decoder = DeflateDecoder::new(packed);
    let mut bytes = Vec::new();
    let read = decoder.by_ref().take(MAX_CONTAINER as u64 + 1).read_to_end(&mut bytes);
    if bytes.len() > MAX_CONTAINER {
        return Err(FormatError::TooLarge { what: "what is packed in the link".into(), max: format!("{MAX_CONTAINER} bytes") });
    }
    match read {
        Ok(_) if decoder.total_in() == packed.len() as u64 => Ok(bytes),
        _ => Err(damaged("it cannot be unpacked")),
    }
}

/// Without padding.
fn to_base64url(bytes: &[u8]) -> String {
    let letters = |three: &[u8]| {
        let word = three.iter().fold(0, |word, &byte| (word << 8) | u32::from(byte)) << (8 * (3 - three.len()));
        let letter = move |k: usize| char::from(LETTERS[(word >> (18 - 6 * k)) as usize & 63]);
        (0..=three.len()).map(letter).collect::<Vec<_>>()
    };
    bytes.chunks(3).flat_map(letters).collect()
}

pub(super) fn from_base64url(text: &str) -> Result<Vec<u8>, FormatError> {
    let value = |letter: u8| match letter {
        b'A'..=b'Z' => Some(letter - b'A'),
        b'a'..=b'z' => Some(letter - b'a' + 26),
        b'0'..=b'9' => Some(letter - b'0' + 52),
        b'-' => Some(62),
        b'_' => Some(63),
        _ => None,
    };
    let values = text.bytes().map(value).collect::<Option<Vec<u8>>>().filter(|values| !values.is_empty());
    let values = values.ok_or_else(|| damaged(FOREIGN))?;
    if values.len() % 4 == 1 {
        return Err(damaged("its length is impossible"));
    }
    let mut bytes = Vec::with_capacity(values.len() / 4 * 3 + 3);
    for four in values.chunks(4) {
        let word = four.iter().fold(0, |word, &six| (word << 6) | u32::from(six)) << (6 * (4 - four.len()));
        bytes.extend_from_slice(&u32::to_be_bytes(word)[1..four.len()]);
    }
    Ok(bytes)
}
