//! Tables as Markdown, and their places in docs/performance.md and the README: between `<!-- bench NAME -->` and `<!-- end -->`.

use std::fs;
use std::path::Path;
use std::thread::available_parallelism;

use anyhow::{Context, Result};

use crate::tools::{output, root};

/// Where most tables stand.
pub const PERFORMANCE: &str = "docs/performance.md";

/// What a part has measured.
pub struct Section {
    pub name: &'static str,
    /// Where its table stands.
    pub page: &'static str,
    /// Its table, and what is to be said about it.
    pub text: String,
    /// What the README says of it.
    pub readme: Option<String>,
}

impl Section {
    /// Puts it in its places.
    pub fn write(&self) -> Result<()> {
        splice(self.page, self.name, &format!("\n\n{}\n", self.text))?;
        self.readme.as_ref().map_or(Ok(()), |readme| splice("README.md", self.name, readme))
    }
}

/// The machine, in docs/performance.md.
pub fn write_machine() -> Result<()> {
    splice(PERFORMANCE, "machine", &machine())
}

/// A table of Markdown.
pub fn table(heads: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: Vec<&str>| format!("| {} |\n", cells.join(" | "));
    let rule = format!("|{}\n", "---|".repeat(heads.len()));
    let rows = rows.iter().map(|row| line(row.iter().map(String::as_str).collect()));
    line(heads.to_vec()) + &rule + &rows.collect::<String>()
}

fn splice(file: &str, place: &str, text: &str) -> Result<()> {
    let path = root().join(file);
    let old = fs::read_to_string(&path).with_context(|| format!("no {file}"))?;
    let new = spliced(&old, place, text).with_context(|| format!("{file} has no place for {place}"))?;
    Ok(fs::write(path, new)?)
}

fn spliced(old: &str, place: &str, text: &str) -> Option<String> {
    const END: &str = "<!-- end -->";
    let begin = format!("<!-- bench {place} -->");
    let (before, rest) = old.split_once(&begin)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{begin}{text}{END}{after}"))
}

/// Where and when was measured.
pub fn machine() -> String {
    let cpu = read("/proc/cpuinfo").and_then(|info| {
        let model = info.lines().find_map(|line| line.strip_prefix("model name"))?;
        Some(model.trim_start_matches([':', ' ', '\t']).to_owned())
    });
    let cores = available_parallelism().map_or(1, usize::from);
    let governor = read("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
    let git = |arguments: &[&str]| output("git", &[&["-C", &root().to_string_lossy()], arguments].concat());
    let commit = git(&["rev-parse", "--short", "HEAD"]);
    let date = output("date", &["+%-d %B %Y"]);
    let known = |what: Option<String>| what.map_or_else(|| "unknown".into(), |what| what.trim().to_owned());
    format!(
        "{}: {}, cores: {cores}, governor: {}, {}, node {}, engine at commit {}",
        known(date),
        known(cpu),
        known(governor),
        known(output("rustc", &["--version"])),
        known(output("node", &["--version"])),
        known(commit)
    )
}

fn read(file: &str) -> Option<String> {
    fs::read_to_string(Path::new(file)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_filled_and_the_rest_stays() {
        let old = "a <!-- bench walk -->old<!-- end --> b <!-- bench exact --><!-- end -->";
        let new = "a <!-- bench walk -->new<!-- end --> b <!-- bench exact --><!-- end -->";
        assert_eq!(spliced(old, "walk", "new").as_deref(), Some(new));
        assert_eq!(spliced(old, "growth", "new"), None);
    }

    #[test]
    fn a_table() {
        assert_eq!(table(&["a", "b"], &[vec!["1".into(), "2".into()]]), "| a | b |\n|---|---|\n| 1 | 2 |\n");
    }
}
