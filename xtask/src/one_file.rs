//! The page as one file: what Vite's second build leaves (`www/one_file.config.ts`), packed into `one-file.html` beside the page.

use std::fs;
use std::io::Write as _;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use lzma_rust2::{CheckType, LzmaOptions, XzOptions, XzWriter};

use crate::notices;
use crate::tools::{run, target_dir, vite};

const NAME: &str = "one-file.html";
/// Who sends it by e-mail or puts it on a stick must not ask how large it is.
const MOST_BYTES: usize = 2_500_000;
/// What a browser sets aside to unpack it. All parts fit in: a worker finds what it shares with another.
const DICTIONARY: u32 = 8 << 20;

/// Puts `one-file.html` into the folder of the built page.
pub fn build(folder: &Path) -> Result<()> {
    let licences = std::path::absolute(folder.join(notices::NAME))?;
    ensure!(licences.is_file(), "no page is built in {}: cargo xtask build makes both", folder.display());
    println!("page: building {NAME}…");
    let halves = target_dir().join("one-file");
    let args = ["build", "--config", "one_file.config.ts", "--logLevel", "warn", "--outDir"];
    run(vite().args(args).arg(&halves).env("FORMICARIUM_LICENCES", licences))?;
    let packed = written(&packed(&fs::read(halves.join("parts.bin"))?)?);
    let shell = fs::read_to_string(halves.join("shell.html"))?;
    let page = shell.replace("%characters%", &packed.len().to_string()).replace("%packed%", &packed);
    ensure!(page.len() <= MOST_BYTES, "{NAME} has {} bytes: no more than {MOST_BYTES} can be sent everywhere", page.len());
    fs::write(folder.join(NAME), page).with_context(|| format!("cannot write {NAME} into {}", folder.display()))
}

/// Bits that two characters hold: 91 · 91 is just above 2^13. Base64 holds 12, base85 12.8.
const BITS: u32 = 13;

/// Two characters for 13 bits, highest first, the last filled up with zeros. A stream of xz is a multiple of four bytes long: so its end is known.
fn written(bytes: &[u8]) -> String {
    let alphabet: Vec<char> = ('!'..='~').filter(|sign| !"&<\\".contains(*sign)).collect();
    assert!(bytes.len().is_multiple_of(4), "a stream of xz is a multiple of four bytes long");
    let mut text = String::with_capacity(bytes.len() * 5 / 4);
    let (mut waiting, mut count) = (0u32, 0);
    for byte in bytes.iter().copied().map(Some).chain([None, None]) {
        if byte.is_none() && count == 0 {
            break;
        }
        (waiting, count) = (waiting << 8 | u32::from(byte.unwrap_or(0)), count + 8);
        if count >= BITS {
            count -= BITS;
            let number = (waiting >> count) as usize;
            text.extend([alphabet[number / alphabet.len()], alphabet[number % alphabet.len()]]);
            waiting &= (1 << count) - 1;
            count = if byte.is_none() { 0 } else { count };
        }
    }
    text
}

/// As small as it gets: the file is packed once, and sent many times.
fn packed(parts: &[u8]) -> Result<Vec<u8>> {
    let mut options = XzOptions::with_preset(9);
    // The check that the browser's unpacker knows.
    options.check_type = CheckType::Crc32;
    // Bytes of text and of WebAssembly stand at any place; what comes next is told by the byte before.
    options.lzma_options =
        LzmaOptions { dict_size: DICTIONARY, nice_len: LzmaOptions::NICE_LEN_MAX, lc: 4, pb: 0, ..options.lzma_options };
    let mut writer = XzWriter::new(Vec::new(), options)?;
    writer.write_all(parts)?;
    Ok(writer.finish()?)
}
