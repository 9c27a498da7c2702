//! Spoils a file: bytes, numbers, lines, words, nesting.

use std::ops::Range;

use crate::limits::LONGEST;
use crate::random::Random;

/// Spoils a file in a few places; `other` is a file to splice it with.
pub fn spoil(random: &mut Random, file: &mut Vec<u8>, other: &[u8]) {
    // Mostly one change alone: what is refused at once tries nothing else.
    let times = if random.one_in(3) { 1 + random.below(6) } else { 1 };
    for _ in 0..times {
        once(random, file, other);
        file.truncate(LONGEST.max(other.len()));
    }
}

fn once(random: &mut Random, file: &mut Vec<u8>, other: &[u8]) {
    match random.below(24) {
        0 | 1 => flip(random, file),
        2 | 3 => put_byte(random, file),
        4 => file.truncate(random.below(file.len() + 1)),
        5 => drop(file.drain(random.piece(file.len()))),
        6 => repeat(random, file),
        7 => splice(random, file, other),
        8..=14 => replace_number(random, file),
        15 | 16 => spoil_lines(random, file),
        17 => replace_word(random, file),
        18 => nest(random, file),
        19 => change_ends(random, file),
        20..=22 => put_binary(random, file),
        _ => insert(random, file),
    }
}

fn flip(random: &mut Random, file: &mut [u8]) {
    let at = random.below(file.len());
    file.get_mut(at).into_iter().for_each(|byte| *byte ^= 1 << random.below(8));
}

const TELLING: &[u8] = b"\0\t\n\r \"'%#,;-+./\\0123456789:@GSTWE[]{}()_eNn\x1a\xc3\xef\xfe\xff";

fn telling(random: &mut Random) -> u8 {
    if random.one_in(4) { random.byte() } else { *random.of_list(TELLING) }
}

fn put_byte(random: &mut Random, file: &mut [u8]) {
    let at = random.below(file.len());
    file.get_mut(at).into_iter().for_each(|byte| *byte = telling(random));
}

fn insert(random: &mut Random, file: &mut Vec<u8>) {
    let at = random.below(file.len() + 1);
    let bytes: Vec<u8> = (0..=random.below(4)).map(|_| telling(random)).collect();
    file.splice(at..at, bytes);
}

fn repeat(random: &mut Random, file: &mut Vec<u8>) {
    let piece = random.piece(file.len());
    let times = if random.one_in(8) { 1000 } else { 1 + random.below(4) };
    let many = file[piece.clone()].repeat(times.min(LONGEST / piece.len().max(1)));
    file.splice(piece.end..piece.end, many);
}

fn splice(random: &mut Random, file: &mut Vec<u8>, other: &[u8]) {
    file.truncate(random.below(file.len() + 1));
    file.extend_from_slice(&other[random.below(other.len() + 1)..]);
}

/// Numbers at which programs break.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "0.1",
    "0.5",
    "1.5",
    "-2.25",
    "63",
    "64",
    "65",
    "255",
    "256",
    "257",
    "1201",
    "3600",
    "3601",
    "4095",
    "4096",
    "4097",
    "32767",
    "32768",
    "65535",
    "65536",
    "1000000",
    "1000001",
    "16777216",
    "16777217",
    "67108864",
    "67108865",
    "2147483647",
    "2147483648",
    "2147483649",
    "-2147483647",
    "-2147483648",
    "-2147483649",
    "4294967295",
    "4294967296",
    "4294967297",
    "9007199254740993",
    "9223372036854775807",
    "9223372036854775808",
    "18446744073709551615",
    "18446744073709551616",
    "1e-9",
    "1e9",
    "1e19",
    "1e38",
    "1e39",
    "3.4028236e38",
    "1e-45",
    "1e-46",
    "1e308",
    "-1e308",
    "1e309",
    "1e-320",
    "1e999999999999",
    "5e-324",
    "nan",
    "NaN",
    "-nan",
    "inf",
    "-inf",
    "Infinity",
    "-9999",
    "-32768",
    "0x10",
    "1_000",
    "1,5",
    "٣",
    "",
    "true",
    "null",
    "\"1\"",
    "1.#QNAN",
];

fn extreme(random: &mut Random) -> Vec<u8> {
    match random.below(20) {
        0 => b"9".repeat(1 + random.below(2000)),
        1 => [b"0.", &b"3".repeat(1 + random.below(2000))[..]].concat(),
        2 => [b"1e", &b"9".repeat(1 + random.below(30))[..]].concat(),
        3 => random.word().to_string().into_bytes(),
        4 => (random.unit() * 1000.0 - 500.0).to_string().into_bytes(),
        _ => random.of_list(NUMBERS).as_bytes().to_vec(),
    }
}

/// Runs of bytes that belong together.
fn runs(file: &[u8], belongs: impl Fn(u8) -> bool) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (at, _) in file.iter().enumerate().filter(|(_, byte)| belongs(**byte)) {
        match runs.last_mut() {
            Some(run) if run.end == at => run.end += 1,
            _ => runs.push(at..at + 1),
        }
    }
    runs
}

/// Half of the time among the first, where headers are.
fn choose<T: Clone>(random: &mut Random, list: &[T]) -> Option<T> {
    let most = if random.one_in(2) { list.len().min(12) } else { list.len() };
    list.get(random.below(most)).cloned()
}

fn replace_number(random: &mut Random, file: &mut Vec<u8>) {
    let numbers = runs(file, |byte| byte.is_ascii_digit() || b".-+".contains(&byte));
    let Some(number) = choose(random, &numbers) else { return insert(random, file) };
    drop(file.splice(number, extreme(random)));
}

/// Words of every format, in the place of each other.
const WORDS: &[&str] = &[
    "type",
    "octile",
    "height",
    "width",
    "map",
    "version",
    "ncols",
    "nrows",
    "cellsize",
    "dx",
    "dy",
    "xllcorner",
    "yllcenter",
    "NODATA_value",
    "format",
    "formicarium/scenario@1",
    "formicarium/scenario@2",
    "formicarium/comparison@1",
    "formicarium/result@1",
    "formicarium/experiment@1",
    "formicarium/experiment@3",
    "rows",
    "heights",
    "factors",
    "robot",
    "inflation",
    "cost_scaling",
    "nav2-navfn",
    "start",
    "goals",
    "at",
    "area",
    "terrain",
    "slices",
    "max_slope",
    "movement",
    "moves",
    "corner_rule",
    "both-free",
    "always",
    "resolution",
    "vehicle",
    "path",
    "levels",
    "length",
    "value",
    "seed",
    "run",
    "entry",
    "algorithm",
    "iterations",
    "evaluations",
    "status",
    "optimal",
    "no-path",
    "question",
    "maps",
    "instances",
    "entries",
    "planner",
    "preset",
    "set",
    "seeds",
    "count",
    "budget",
    "axis",
    "claims",
    "facts",
    "group",
    "given",
    "recorded",
    "null",
    "true",
    "evaluations raw_y",
];

fn replace_word(random: &mut Random, file: &mut Vec<u8>) {
    let words = runs(file, |byte| byte.is_ascii_alphabetic() || byte == b'_');
    let Some(word) = choose(random, &words) else { return insert(random, file) };
    let instead = match random.below(4) {
        0 => choose(random, &words).map_or_else(Vec::new, |other| file[other].to_vec()),
        1 => file[word.clone()].to_ascii_uppercase(),
        2 => file[word.clone()].repeat(2),
        _ => random.of_list(WORDS).as_bytes().to_vec(),
    };
    drop(file.splice(word, instead));
}

fn spoil_lines(random: &mut Random, file: &mut Vec<u8>) {
    let mut lines: Vec<&[u8]> = file.split_inclusive(|byte| *byte == b'\n').collect();
    let [a, b] = [random.below(lines.len()), random.below(lines.len())];
    match random.below(4) {
        _ if lines.is_empty() => {}
        0 => drop(lines.remove(a)),
        1 => lines.swap(a, b),
        2 => lines.insert(b, lines[a]),
        _ => (0..random.below(200)).for_each(|_| lines.insert(b, lines[a])),
    }
    *file = lines.concat();
}

/// Brackets in brackets, closed or not.
fn nest(random: &mut Random, file: &mut Vec<u8>) {
    const PAIRS: [(&[u8], &[u8]); 4] = [(b"[", b"]"), (b"{\"a\":", b"}"), (b"(", b")"), (b"\"", b"\"")];
    let (open, close) = *random.of_list(&PAIRS);
    let depth = if random.one_in(3) { 10_000 } else { 1 + random.below(200) };
    let piece = random.piece(file.len());
    let inside = file[piece.clone()].to_vec();
    let closed = if random.one_in(3) { Vec::new() } else { close.repeat(depth) };
    drop(file.splice(piece, [open.repeat(depth), inside, closed].concat()));
}

fn change_ends(random: &mut Random, file: &mut Vec<u8>) {
    let change = |file: &[u8], to: &[u8]| file.split(|byte| *byte == b'\n').collect::<Vec<_>>().join(to);
    *file = match random.below(6) {
        0 => change(file, b"\r\n"),
        1 => change(file, b"\r"),
        2 => change(file, b"\n\n"),
        3 => [b"\xef\xbb\xbf", &file[..]].concat(),
        4 => [b"\xff\xfe".to_vec(), file.iter().flat_map(|byte| [*byte, 0]).collect()].concat(),
        _ => change(file, b" "),
    };
}

/// A number as binary files hold it, mostly in the header.
fn put_binary(random: &mut Random, file: &mut [u8]) {
    const NUMBERS: [u64; 16] =
        [0, 1, 2, 3, 7, 16, 255, 256, 0x7fff, 0x8000, 0xffff, 0x10000, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, u64::MAX];
    let reach = if random.one_in(2) { file.len().min(400) } else { file.len() };
    let at = random.below(reach) & if random.one_in(4) { usize::MAX } else { !1 };
    let number = if random.one_in(3) { u64::from(random.word()) } else { *random.of_list(&NUMBERS) };
    let size = *random.of_list(&[1, 2, 2, 4, 4, 8]);
    let bytes = if random.one_in(2) { number.to_le_bytes()[..size].to_vec() } else { number.to_be_bytes()[8 - size..].to_vec() };
    for (old, new) in file.iter_mut().skip(at).zip(bytes) {
        *old = new;
    }
}
