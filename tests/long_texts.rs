//! Texts of many megabytes take no more memory than `fuzz/limits.rs` allows, however many numbers and rows stand in them.
#![cfg(not(target_arch = "wasm32"))]

#[path = "fuzz/allocator.rs"]
mod allocator;
#[path = "fuzz/limits.rs"]
#[expect(dead_code, reason = "the fuzzer's")]
mod limits;

use allocator::peak_of;
use formicarium::formats::{TerrainOptions, import, import_piece, import_results, read_path, sniff, survey};
use limits::Limits;

#[global_allocator]
static COUNTING: allocator::Counting = allocator::Counting;

const BYTES: usize = 8 << 20;

type Reader = fn(&[u8]);

#[test]
fn long_tables_take_little_memory() {
    let pieces = [
        "0\n",
        "0 ",
        "0",
        "00\n",
        "0\n%\n",
        "0\n\n\n",
        "[]",
        "[0]\n",
        "[",
        "0;1\n",
        "0.51\n5\n",
        "7 8 9 10 11 12\n",
        "...\n",
        "-\n",
        "\r",
        ",",
    ];
    for piece in pieces {
        let head = if piece == "," { "length\n" } else { "" };
        let text = (head.to_owned() + &piece.repeat(BYTES / piece.len())).into_bytes();
        let allowed = Limits::text(text.len()).bytes;
        let readers: [(&str, Reader); 6] = [
            ("sniff", |text| _ = sniff(text, "a.csv")),
            ("import", |text| drop(import(text, "a.csv"))),
            ("import_piece", |text| drop(import_piece(text, "a.csv", TerrainOptions::default()))),
            ("survey", |text| drop(survey(text, "a.csv"))),
            ("import_results", |text| drop(import_results(text, "a.csv"))),
            ("read_path", |text| drop(read_path(text))),
        ];
        for (name, read) in readers {
            let ((), peak) = peak_of(|| read(&text));
            assert!(peak <= allowed, "{name} of {piece:?}: {} MiB in use, {} allowed", peak >> 20, allowed >> 20);
        }
    }
}
