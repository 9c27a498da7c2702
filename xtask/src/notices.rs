//! The licences of all that leaves the house inside ours: crates in the engine, npm packages in the page. Most of them ask for no more than
//! that their notice goes along.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::tools::{self, www};

/// Lies in the page's folder and in the npm package, and is a part of the page of one file.
pub const NAME: &str = "licences.txt";

/// Where Vite's build of the page leaves those of the packages that it has bundled.
const OF_PAGE: &str = "licences-of-page.json";

/// What Vite does not tell: a font is no script, and these two are bundled by builds of their own.
const OTHERS: [&str; 3] = ["@fontsource-variable/figtree", "workbox-precaching", "xz-decompress"];

/// One crate or package: its name with its version, and the text of its licence.
type Notices = BTreeMap<String, String>;

/// The crates inside the engine, as the text of a file.
pub fn of_engine() -> Result<String> {
    Ok(text(&crates()?))
}

/// Those and all that the page has bundled into `folder`; what Vite has left for it there is taken away.
pub fn write_for_page(folder: &Path) -> Result<()> {
    let told = folder.join(OF_PAGE);
    let bundled: Vec<Value> = serde_json::from_slice(&fs::read(&told).context("the page's build tells no licences")?)?;
    fs::remove_file(told)?;
    let mut notices = crates()?;
    for package in &bundled {
        let field = |key: &str| package[key].as_str().unwrap_or_default();
        notices.insert(heading(field("name"), field("version"), field("identifier")), field("text").trim().to_owned());
    }
    for name in OTHERS {
        let home = www().join("node_modules").join(name);
        let package: Value = serde_json::from_slice(&fs::read(home.join("package.json"))?)?;
        let field = |key: &str| package[key].as_str().unwrap_or_default();
        // Where it brings no text, the name of its licence and of its author is all there is.
        let licence = licence_in(&home).unwrap_or_else(|_| field("author").to_owned());
        notices.insert(heading(name, field("version"), field("license")), licence);
    }
    fs::write(folder.join(NAME), text(&notices)).with_context(|| format!("cannot write {NAME}"))
}

fn heading(name: &str, version: &str, licence: &str) -> String {
    format!("{name} {version} ({licence})")
}

fn text(notices: &Notices) -> String {
    let mut text = String::from(
        "Formicarium is licensed under MIT or Apache-2.0, as you choose. It contains the following works of others, under their own licences, and \
         parts of the Rust standard library (MIT or Apache-2.0).\n",
    );
    for (heading, licence) in notices {
        text += &format!("\n{}\n{heading}\n\n{licence}\n", "-".repeat(72));
    }
    text
}

/// Every crate that the engine's library needs at run time, as WebAssembly; macros leave nothing of themselves.
fn crates() -> Result<Notices> {
    let args = ["metadata", "--format-version", "1", "--filter-platform", "wasm32-unknown-unknown", "--locked"];
    let output = tools::cargo().args(args).output().context("cannot start cargo metadata")?;
    ensure!(output.status.success(), "cargo metadata failed: {}", String::from_utf8_lossy(&output.stderr));
    let all: Value = serde_json::from_slice(&output.stdout)?;
    let by_id = |list: &'static str, root: &Value| -> BTreeMap<String, Value> {
        let items = root[list].as_array().into_iter().flatten();
        items.filter_map(|item| Some((item["id"].as_str()?.to_owned(), item.clone()))).collect()
    };
    let (packages, nodes) = (by_id("packages", &all), by_id("nodes", &all["resolve"]));
    let own = packages.iter().find(|(_, package)| package["name"] == "formicarium").context("no package formicarium")?.0;
    let mut waiting = needed_by(&nodes[own]);
    let mut notices = Notices::new();
    while let Some(id) = waiting.pop() {
        let package = &packages[&id];
        if is_macro(package) {
            continue;
        }
        let field = |key: &str| package[key].as_str().unwrap_or_default();
        let Entry::Vacant(notice) = notices.entry(heading(field("name"), field("version"), field("license"))) else { continue };
        let home = Path::new(field("manifest_path")).parent().context("a manifest lies in a folder")?;
        notice.insert(licence_in(home)?);
        waiting.extend(needed_by(&nodes[&id]));
    }
    Ok(notices)
}

/// At run time: not for tests, not for build scripts.
fn needed_by(node: &Value) -> Vec<String> {
    let at_run_time = |need: &&Value| need["dep_kinds"].as_array().into_iter().flatten().any(|kind| kind["kind"].is_null());
    let needs = node["deps"].as_array().into_iter().flatten();
    needs.filter(at_run_time).filter_map(|need| Some(need["pkg"].as_str()?.to_owned())).collect()
}

fn is_macro(package: &Value) -> bool {
    let targets = package["targets"].as_array().into_iter().flatten();
    targets.flat_map(|target| target["kind"].as_array().into_iter().flatten()).any(|kind| kind == "proc-macro")
}

/// The text of the licence in a package's folder. Of several to choose from the shortest that names who holds the rights.
fn licence_in(home: &Path) -> Result<String> {
    const BEGINNINGS: [&str; 3] = ["LICENSE", "LICENCE", "NOTICE"];
    let mut texts = Vec::new();
    for entry in fs::read_dir(home).with_context(|| format!("no folder {}", home.display()))? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().to_uppercase();
        if entry.file_type()?.is_file() && BEGINNINGS.iter().any(|beginning| name.starts_with(beginning)) {
            texts.push(fs::read_to_string(entry.path())?.replace("\r\n", "\n").trim().to_owned());
        }
    }
    texts.sort_by_key(|text| (!text.contains("opyright"), text.len()));
    texts.into_iter().next().with_context(|| format!("no licence in {}", home.display()))
}
