//! The page as one file: what Vite's second build leaves (`www/one_file.config.ts`), packed into `one-file.html` beside the page.

use std::fs;
use std::io::Write as _;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use lzma_rust2::{CheckType, LzmaOptions, XzOptions, XzWriter};

use crate::tools::{run, target_dir, vite};

const NAME: &str = "one-file.html";
/// Who sends it by e-mail or puts it on a stick must not ask how large it is.
const MOST_BYTES: usize = 2_500_000;
/// What a browser sets aside to unpack it. All parts fit in: a worker finds what it shares with another.
const DICTIONARY: u32 = 8 << 20;

/// Puts `one-file.html` into the folder of the built page.
pub fn build(folder: &Path) -> Result<()> {
    println!("page: building {NAME}…");
    let halves = target_dir().join("one-file");
    let args = ["build", "--config", "one_file.config.ts", "--logLevel", "warn", "--outDir"];
    run(vite().args(args).arg(&halves))?;
    let packed = written(&packed(&fs::read(halves.join("parts.bin"))?)?);
    let shell = fs::read_to_string(halves.join("shell.html"))?;
    let page = shell.replace("%characters%", &packed.len().to_string()).replace("%packed%", &packed);
    ensure!(page.len() <= MOST_BYTES, "{NAME} has {} bytes: no more than {MOST_BYTES} can be sent everywhere", page.len());
    fs::write(folder.join(NAME), page).with_context(|| format!("cannot write {NAME} into {}", folder.display()))
}

/// Five characters for four bytes, where base64 needs more than five for four: the digits of a number to the base 85, highest first. A stream
/// of xz is a multiple of four bytes long.
fn written(bytes: &[u8]) -> String {
    let alphabet: Vec<char> = ('#'..='z').filter(|sign| !"&<\\".contains(*sign)).collect();
    let signs = |four: &[u8; 4]| {
        let number = u32::from_be_bytes(*four);
        (0..5).rev().map(|place| alphabet[(number / 85_u32.pow(place) % 85) as usize]).collect::<String>()
    };
    let (fours, rest) = bytes.as_chunks();
    assert!(rest.is_empty(), "a stream of xz is a multiple of four bytes long");
    fours.iter().map(signs).collect()
}

/// As small as it gets: the file is packed once, and sent many times.
fn packed(parts: &[u8]) -> Result<Vec<u8>> {
    let mut options = XzOptions::with_preset(9);
    // The check that the browser's unpacker knows.
    options.check_type = CheckType::Crc32;
    options.lzma_options = LzmaOptions { dict_size: DICTIONARY, nice_len: LzmaOptions::NICE_LEN_MAX, ..options.lzma_options };
    let mut writer = XzWriter::new(Vec::new(), options)?;
    writer.write_all(parts)?;
    Ok(writer.finish()?)
}
