//! The page: Vite's build of www/ around pkg/.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::tools::{node_script, root, run, vite, www};
use crate::{notices, one_file, wasm};

/// Every TypeScript project: the page, its workers, the build, the browser tests.
const PROJECTS: [&str; 4] = ["tsconfig.json", "tsconfig.worker.json", "tsconfig.node.json", "../tests/browser/tsconfig.json"];

/// Engine, page, and the custom element in `pkg/`; the answer is the static folder.
pub fn build(out: Option<&Path>) -> Result<PathBuf> {
    wasm::build(wasm::Mode::Release)?;
    println!("page: building…");
    let folder = out.map_or_else(|| Ok(www().join("dist")), std::path::absolute)?;
    let args = ["build", "--emptyOutDir", "--logLevel", "warn", "--outDir"];
    run(vite().args(args).arg(&folder))?;
    notices::write_for_page(&folder)?;
    one_file::build(&folder)?;
    run(vite().args(["build", "--config", "element.config.ts", "--logLevel", "warn"]))?;
    // Hosts of static pages answer with it where nothing is, as where a program has written `#` as a code: the page finds its link there.
    fs::copy(folder.join("index.html"), folder.join("404.html"))?;
    // Last of all: it lists what is there.
    let args = ["build", "--config", "service_worker.config.ts", "--logLevel", "warn", "--outDir"];
    run(vite().args(args).arg(&folder))?;
    Ok(folder)
}

/// Build, types, lint.
pub fn check() -> Result<()> {
    build(None)?;
    println!("page: checking types…");
    for project in PROJECTS {
        run(node_script("typescript/bin/tsc").args(["--noEmit", "--project", project]))?;
    }
    println!("page: linting…");
    let mut biome = node_script("@biomejs/biome/bin/biome");
    run(biome.args(["check", "--error-on-warnings"]).current_dir(root()))
}
