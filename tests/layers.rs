//! The engine's layers: a module knows those below it and its neighbours, none above it.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The top-level modules from the lowest to the highest. Modules of one line are neighbours: either may know the other, but not both.
const LAYERS: [&[&str]; 14] = [
    // What knows nothing of maps: everybody may use it.
    &["error", "params", "rng", "digest", "listed"],
    &["map"],
    &["scenario"],
    &["path"],
    &["metrics", "drawn", "smoothing"],
    &["planner", "findings"],
    &["exact", "swarm", "sampling"],
    &["aco"],
    &["catalog"],
    &["drive"],
    &["comparison"],
    &["formats"],
    &["wasm", "cli"],
    &["main", "lib"],
];

/// Macros stand at the crate's root, whatever module they are written in.
const MACROS: [(&str, &str); 1] = [("choice", "params")];

/// Names at the crate's root that are used in the code of `text`, without its tests and comments.
fn known(text: &str) -> BTreeSet<String> {
    let code = code_of(text);
    let paths = code.match_indices("crate::").filter(|(at, _)| !code[..*at].ends_with('$'));
    let name = |rest: &str| rest.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').next().unwrap_or("").to_owned();
    let one = |(at, head): (usize, &str)| match &code[at + head.len()..] {
        // `use crate::{a, b::c}`: each name that begins a path at this depth.
        rest if rest.starts_with('{') => first_names(rest),
        rest => vec![name(rest)],
    };
    paths
        .flat_map(one)
        .map(|name| MACROS.iter().find(|(of, _)| *of == name).map_or(name, |(_, module)| (*module).into()))
        .collect()
}

/// The names behind `{` and `,` at the first depth of braces.
fn first_names(braced: &str) -> Vec<String> {
    let (mut depth, mut names, mut name) = (0, Vec::new(), String::new());
    for c in braced.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 || (depth == 1 && c == ',') {
            names.push(std::mem::take(&mut name));
        } else if depth == 1 && c != '{' {
            name.push(c);
        }
        if depth == 0 {
            break;
        }
    }
    names.iter().map(|path| path.trim().split("::").next().unwrap_or("").to_owned()).collect()
}

/// Without comments, and without what `#[cfg(test)]` stands before.
fn code_of(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let mut code = String::new();
    let mut lines = lines.peekable();
    while let Some(line) = lines.next() {
        if line.trim() != "#[cfg(test)]" {
            code += line;
            code.push('\n');
            continue;
        }
        // The item ends where its indentation comes back with a closing brace, or with its only line.
        let indent = &line[..line.len() - line.trim_start().len()];
        let Some(first) = lines.next() else { break };
        if first.trim_end().ends_with('{') {
            let end = format!("{indent}}}");
            lines.by_ref().find(|line| *line == end);
        }
    }
    code
}

/// Files of the module's tests, which a `#[cfg(test)] mod tests;` brings in.
fn is_test(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == "tests.rs") && !path.ends_with("report/tests.rs")
}

fn files(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in folder.read_dir().expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files(&path, out);
        } else if path.extension().is_some_and(|ending| ending == "rs") && !is_test(&path) {
            out.push(path);
        }
    }
}

/// `super::super::…` as `crate::…`, where it leads out of the top-level module.
fn from_root(text: &str, file: &Path) -> String {
    let depth = file.iter().count() - usize::from(file.ends_with("mod.rs"));
    text.replace(&"super::".repeat(depth), "crate::")
}

fn level(module: &str) -> Option<usize> {
    LAYERS.iter().position(|layer| layer.contains(&module))
}

/// Every (module, module that it knows, file).
fn imports() -> Vec<(String, String, String)> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = Vec::new();
    files(&source, &mut all);
    let of = |path: PathBuf| {
        let inside = path.strip_prefix(&source).expect("below src").to_owned();
        let module = inside.iter().next().expect("a name").to_string_lossy().trim_end_matches(".rs").to_owned();
        let text = std::fs::read_to_string(&path).expect("a text");
        // The command line is a crate of its own and calls the engine by its name.
        let text = from_root(&text, &inside);
        let text = if ["main", "cli"].contains(&&*module) { text.replace("formicarium::", "crate::") } else { text };
        let file = inside.display().to_string();
        known(&text).into_iter().map(move |name| (module.clone(), name, file.clone())).collect::<Vec<_>>()
    };
    all.into_iter().flat_map(of).filter(|(module, name, _)| module != name && level(name).is_some()).collect()
}

#[test]
fn no_module_knows_one_above_it() {
    let imports = imports();
    assert!(imports.len() > 200, "imports are not found: {}", imports.len());
    let knows = |one: &str, other: &str| imports.iter().any(|(module, name, _)| module == one && name == other);
    let is_wrong = |(module, name): (&str, &str)| {
        let (own, other) = (level(module).unwrap_or_else(|| panic!("LAYERS lacks {module}")), level(name));
        let is_mutual = other == Some(own) && knows(name, module);
        other > Some(own) || is_mutual
    };
    let wrong: Vec<String> = imports
        .iter()
        .filter(|(module, name, _)| is_wrong((module.as_str(), name.as_str())))
        .map(|(module, name, file)| format!("{module} knows {name}, which is not below it: src/{file}"))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn imports_are_read_as_they_are_written() {
    let text = "//! [`crate::wasm`]\nuse crate::map::{Grid, Point};\nuse crate::{catalog, exact::{self, Reference}};\n\
                #[cfg(test)]\nmod tests {\n    use crate::cli::run;\n}\nfn f() { crate::rng::draw(); $crate::formats::g() }\n\
                #[cfg(test)]\nmod more;\nuse crate::choice;\n";
    let names: Vec<String> = known(text).into_iter().collect();
    assert_eq!(names, ["catalog", "exact", "map", "params", "rng"]);
}
