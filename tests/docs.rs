//! The documents name files that are there, and link to headings that are there.
#![cfg(not(target_arch = "wasm32"))]

use std::path::{Path, PathBuf};

const DOCUMENTS: [&str; 13] = [
    "README.md",
    "CONTRIBUTING.md",
    "docs/architecture.md",
    "docs/dependencies.md",
    "docs/formats.md",
    "docs/glossary.md",
    "docs/hosting.md",
    "docs/lessons.md",
    "docs/methodology.md",
    "docs/one_file.md",
    "docs/performance.md",
    "docs/tracker.md",
    "tests/fixtures/links/README.md",
];

/// Where a path in backticks may begin: documents of the engine and of the page write short ones.
const ROOTS: [&str; 4] = ["", "src", "www/src", "www"];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn text(document: &str) -> String {
    std::fs::read_to_string(root().join(document)).unwrap_or_else(|error| panic!("{document}: {error}"))
}

/// The anchor of a heading, as code hosts make it.
fn anchor(heading: &str) -> String {
    let plain = heading.trim_start_matches('#').trim().to_lowercase();
    let keep = |c: char| (c.is_alphanumeric() || c == '-' || c == '_' || c == ' ').then_some(if c == ' ' { '-' } else { c });
    plain.chars().filter_map(keep).collect()
}

/// The targets of `[…](target)`, but for addresses elsewhere.
fn links(text: &str) -> Vec<String> {
    let target = |rest: &str| rest.split(')').next().unwrap_or("").to_owned();
    text.split("](").skip(1).map(target).filter(|link| !link.contains("://")).collect()
}

/// What stands in backticks and looks like a file of this repository, without patterns.
fn paths(text: &str) -> Vec<String> {
    let is_path = |word: &&str| {
        let ends = [".rs", ".ts", ".tsx", ".toml", ".mjs"].iter().any(|ending| word.ends_with(ending));
        ends && word.contains('/') && !word.contains(['*', ' ', '{', '…'])
    };
    text.split('`').skip(1).step_by(2).filter(is_path).map(Into::into).collect()
}

#[test]
fn every_link_leads_somewhere() {
    let mut wrong = Vec::new();
    for document in DOCUMENTS {
        let folder = root().join(document).parent().expect("a folder").to_owned();
        for link in links(&text(document)) {
            let (file, heading) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() { root().join(document) } else { folder.join(file) };
            let has_heading = || {
                let text = std::fs::read_to_string(&target).unwrap_or_default();
                text.lines().filter(|line| line.starts_with('#')).any(|line| anchor(line) == heading)
            };
            if !target.exists() || !(heading.is_empty() || has_heading()) {
                wrong.push(format!("{document}: {link}"));
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn every_file_that_is_named_exists() {
    let exists = |path: &str| ROOTS.iter().any(|base| Path::new(&root()).join(base).join(path).exists());
    let wrong =
        |document| paths(&text(document)).into_iter().filter(|path| !exists(path)).map(move |path| format!("{document}: {path}"));
    let wrong: Vec<String> = DOCUMENTS.into_iter().flat_map(wrong).collect();
    assert_eq!(wrong, Vec::<String>::new());
    assert!(paths(&text("docs/architecture.md")).len() > 20, "paths are not found");
}

/// The tables that a card takes over: the record, its heading, and the lines.
fn taken(card: &str) -> Vec<(String, String, Vec<String>)> {
    let part = |part: &str| {
        let (from, rest) = part.split_once(" -->\n").expect("a record");
        let (record, heading) = from.split_once(": ").expect("a heading");
        let table = rest.split("<!-- End -->").next().unwrap_or_default();
        (record.to_owned(), heading.to_owned(), table.lines().filter(|line| !line.is_empty()).map(Into::into).collect())
    };
    card.split("<!-- From records/").skip(1).map(part).collect()
}

/// Numbers as they stand in a line, in their order but for those of "3 of 5 maps", which Chinese turns round.
fn numbers(line: &str) -> Vec<String> {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '−' | '+');
    let mut found: Vec<String> =
        line.split(|c| !is_part(c)).filter(|word| word.contains(|c: char| c.is_ascii_digit())).map(Into::into).collect();
    found.sort();
    found
}

#[test]
fn cards_say_what_the_records_say() {
    for card in ["fire", "fireworks", "ship", "terrain", "threshold"] {
        let english = taken(&text(&format!("docs/papers/{card}.md")));
        let chinese = taken(&text(&format!("docs/zh/papers/{card}.md")));
        assert!(!english.is_empty(), "{card} takes nothing from its record");
        for ((record, heading, table), (of, at, translated)) in english.iter().zip(&chinese) {
            assert_eq!((record, heading), (of, at), "{card}");
            let lines = text(&format!("experiments/records/{record}"));
            let (_, below) = lines.split_once(&format!("\n## {heading}\n\n")).unwrap_or_else(|| panic!("{record}: no {heading}"));
            let recorded: Vec<&str> = below.lines().take_while(|line| line.starts_with('|')).collect();
            assert!(recorded.len() > 2 && *table == recorded, "{card}: write it anew with `cargo xtask cards`");
            for (row, translated) in table.iter().zip(translated).skip(2) {
                let (_, cells) = row.split_once(" | ").expect("cells");
                let (_, same) = translated.split_once(" | ").expect("cells");
                assert_eq!(numbers(cells), numbers(same), "{card}: {row}\n{translated}");
            }
        }
        assert_eq!(english.len(), chinese.len(), "{card}");
    }
}
