//! The engine's layers: a module names modules below it, and none beside or above it.
#![cfg(not(target_arch = "wasm32"))]

use std::path::{Path, PathBuf};

/// From the bottom to the top. Modules of one line do not know each other.
///
/// `error` is not among them: its messages name the limits of whatever they are about.
const LAYERS: &[&[&str]] = &[
    &["rng", "digest", "params", "listed"],
    &["map"],
    &["scenario"],
    &["path"],
    &["metrics"],
    &["planner"],
    &["exact", "swarm"],
    &["aco"],
    &["catalog"],
];

/// What uses the layers: none of them may name it.
const ABOVE: &[&str] = &["comparison", "formats", "wasm", "cli"];

fn rank(module: &str) -> Option<usize> {
    let above = ABOVE.contains(&module).then_some(LAYERS.len());
    LAYERS.iter().position(|layer| layer.contains(&module)).or(above)
}

/// The files of a module.
fn files(module: &str) -> Vec<PathBuf> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut found, mut folders) = (vec![source.join(format!("{module}.rs"))], vec![source.join(module)]);
    while let Some(folder) = folders.pop() {
        for entry in folder.read_dir().into_iter().flatten() {
            let path = entry.expect("readable").path();
            if path.is_dir() { folders.push(path) } else { found.push(path) }
        }
    }
    found.into_iter().filter(|path| path.extension().is_some_and(|e| e == "rs") && path.exists()).collect()
}

/// The modules that a line of code names after `crate::`, also those of a list in braces.
fn named(line: &str) -> Vec<String> {
    let code = line.split("//").next().unwrap_or("");
    let word = |text: &str| text.trim().chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect::<String>();
    let after = |text: &str| match text.strip_prefix('{') {
        Some(list) => list.split(',').map(word).collect(),
        None => vec![word(text)],
    };
    code.split("crate::").skip(1).flat_map(after).collect()
}

#[test]
fn no_module_knows_one_above_it() {
    for (height, module) in LAYERS.iter().enumerate().flat_map(|(height, layer)| layer.iter().map(move |m| (height, *m))) {
        let files = files(module);
        assert!(!files.is_empty(), "{module} has no file");
        for file in files {
            let text = std::fs::read_to_string(&file).expect("text");
            for (number, line) in text.lines().enumerate() {
                for other in named(line).iter().filter(|other| other.as_str() != module) {
                    let below = rank(other).is_none_or(|rank| rank < height);
                    assert!(below, "{}:{}: {module} names {other}", file.display(), number + 1);
                }
            }
        }
    }
}

#[test]
fn every_module_has_a_place() {
    let library = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).expect("text");
    for module in library.lines().filter_map(|l| l.trim_start_matches("pub ").strip_prefix("mod ")?.strip_suffix(';')) {
        assert!(rank(module).is_some() || module == "error", "{module} has no layer");
    }
}
