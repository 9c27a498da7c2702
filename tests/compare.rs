//! `formicarium compare`: the real binary on small questions.
#![cfg(not(target_arch = "wasm32"))]

use std::path::PathBuf;
use std::process::Command;

const MAP: &str = "0,0,0,0,0,0\n0,1,1,1,1,0\n0,1,0,0,0,0\n0,0,0,1,1,0\n0,1,0,0,0,0\n";

const QUESTION: &str = r#"
format = "formicarium/question@1"
title = "Small"
asks = "Does a colony agree with A*?"
seeds = { from = 5, count = 40 }
instances = [{ id = "small", map = "small.csv", note = "Ours." }, { id = "wall", map = "wall.csv" }]

[[entries]]
id = "colony"
label = "colony"
role = "improved"
planner = "ant-system"
set = { ants = 3, iterations = 2, heuristic = "step", dead_end = "die" }
published.small = { length = 9.0, turns = 5, iterations = 3 }

[[entries]]
id = "exact"
label = "A*"
role = "baseline"
planner = "astar"
published.small = { length = 10 }

[[entries]]
id = "lost"
label = "lost"
role = "other"
missing = "its formulas are nowhere"

[[claims]]
id = "shorter"
says = "shorter"
improved = "colony"
baseline = "exact"
measure = "length"
direction = "less"
instances = ["small"]

[[claims]]
id = "more-turns-than-lost"
says = "more turns"
improved = "colony"
baseline = "lost"
measure = "turns"
direction = "more"
"#;

/// A folder of its own for each test, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("formicarium-compare-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        let folder = Self(path);
        folder.write("q.toml", QUESTION);
        folder.write("small.csv", MAP);
        folder.write("wall.csv", "0,1,0\n0,1,0\n0,1,3\n2,1,0\n");
        folder
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).unwrap();
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// Runs `compare` in the folder: exit code, and what it said on both streams.
    fn compare(&self, args: &[&str]) -> (i32, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_formicarium"));
        let output = command.arg("compare").args(args).current_dir(&self.0).output().unwrap();
        let said = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        println!("compare {}\n{said}", args.join(" "));
        (output.status.code().unwrap(), said)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn every_run_is_a_row_and_every_map_a_table() {
    let folder = Folder::new("rows");
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    let rows: Vec<&str> = csv.lines().collect();
    // A header; two maps, two entries that run, 40 seeds.
    assert_eq!(rows.len(), 1 + 2 * 2 * 40);
    assert!(rows[0].starts_with("instance,entry,seed,status,length,turns,"));
    assert!(rows[1].starts_with("small,colony,5,budget-spent,"), "{}", rows[1]);
    assert!(rows[41].starts_with("small,exact,5,optimal,"), "{}", rows[41]);
    // A run without a path is a row with empty fields.
    assert!(rows[81].starts_with("wall,colony,5,no-path,,,,,,,"), "{}", rows[81]);
    assert!(rows.iter().all(|r| r.matches(',').count() == rows[0].matches(',').count()));

    let page = folder.read("out/q.md");
    for wanted in
        ["# Small", "## small", "`formicarium compare q.toml --out DIR`", "| lost |  | not run: its formulas are nowhere |"]
    {
        assert!(page.contains(wanted), "`{wanted}` is not in\n{page}");
    }
    assert!(page.contains("| A* | 10 / – / – | 40 of 40 |") && page.contains("| exact optimum, length by steps |"), "{page}");
    // Nothing is shorter than A*: claimed −10 %.
    assert!(said.contains("shorter on small: length,") && page.contains("| −10.0 % |"), "{page}");
    assert!(page.contains("**cannot tell**: one of the two cannot be run"), "{page}");
}

#[test]
fn the_number_of_jobs_changes_nothing() {
    let folder = Folder::new("jobs");
    for (jobs, out) in [("1", "one"), ("7", "seven")] {
        assert_eq!(folder.compare(&["q.toml", "--out", out, "--jobs", jobs]).0, 0);
    }
    for file in ["q.csv", "q.md", "q.tests.md", "q.json"] {
        assert_eq!(folder.read(&format!("one/{file}")), folder.read(&format!("seven/{file}")), "{file}");
    }
    // What stood there is replaced as a whole, and nothing else is left behind.
    assert_eq!(folder.compare(&["q.toml", "--out", "one", "--seeds", "1"]).0, 0);
    assert_eq!(folder.read("one/q.csv").lines().count(), 1 + 4);
    assert_eq!(std::fs::read_dir(folder.0.join("one")).unwrap().count(), 4);
}

#[test]
fn a_question_can_be_narrowed_and_asked_on_another_map() {
    let folder = Folder::new("narrow");
    folder.write("open.csv", "0,0,0\n0,0,0\n");
    let narrow = ["q.toml", "--out", "out", "--seeds", "2", "--only", "small", "--map", "small=open.csv"];
    let (code, said) = folder.compare(&narrow);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    // (0,0) → (2,1): one diagonal and one straight step.
    assert!(csv.lines().nth(3).is_some_and(|row| row.starts_with("small,exact,5,optimal,2.414214,1,")), "{csv}");
    assert_eq!(csv.lines().count(), 1 + 2 * 2);
    let page = folder.read("out/q.md");
    assert!(page.contains("--seeds 2 --only small --map small=open.csv`") && page.contains("open in place of"), "{page}");
    assert!(page.contains("too few runs to compare"), "{page}");
}

#[test]
fn what_cannot_be_asked_is_named_with_code_2() {
    let folder = Folder::new("errors");
    let changed = |from: &str, to: &str| QUESTION.replacen(from, to, 1);
    let cases = [
        (changed("question@1", "question@9"), "`format` is `formicarium/question@9`", "this engine reads"),
        (changed("title =", "titel ="), "q.toml: line 3: unknown field `titel`", "docs/methodology.md"),
        (changed("asks = ", "asks "), "q.toml: line 4:", "docs/methodology.md"),
        (changed("ants = 3", "ants = 0"), "entries.colony: ants = 0 is outside 1 to 1024", "choose ants"),
        (changed("ant-system", "bee"), "entries.colony: there is no planner `bee`", "ant-system"),
        (changed("baseline = \"exact\"", "baseline = \"none\""), "claims.shorter.baseline = none", "colony, exact, lost"),
        (changed("small.csv", "large.csv"), "cannot read large.csv", "check the name"),
        (changed("count = 40", "count = 0"), "seeds.count = 0", "1 to 100000"),
    ];
    for (question, message, hint) in cases {
        folder.write("q.toml", &question);
        let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
        assert_eq!(code, 2, "{said}");
        assert!(said.contains(message) && said.contains(hint), "`{message}`, `{hint}`:\n{said}");
    }
    folder.write("q.toml", QUESTION);
    for args in [&["q.toml"][..], &["none.toml", "--out", "out"], &["q.toml", "--out", "out", "--only", "big"]] {
        assert_eq!(folder.compare(args).0, 2);
    }
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--map", "small"]);
    assert!(code == 2 && said.contains("write ID=FILE"), "{said}");
    let (code, said) = folder.compare(&["--help"]);
    assert!(code == 0 && said.contains("Examples:") && said.contains("formicarium compare experiments/ship.toml"), "{said}");
    assert!(!folder.0.join("out").exists());
}

/// Runs of a question that takes a second or so, with everything in it that a journal has to keep.
const LONGER: &str = r#"
format = "formicarium/question@1"
title = "Longer"
asks = "Does anything get lost?"
seeds = { from = 1, count = 60 }
instances = [{ id = "small", map = "small.csv" }, { id = "wall", map = "wall.csv" }]

[[entries]]
id = "colony"
label = "colony"
role = "improved"
planner = "ant-system"
set = { ants = 40, iterations = 1000 }

[[entries]]
id = "ranked"
label = "ranked"
role = "baseline"
planner = "rank-based-ant-system"
set = { ants = 40, iterations = 1000 }
"#;

#[test]
fn killed_at_any_moment_it_goes_on_and_loses_no_finished_run() {
    let folder = Folder::new("killed");
    folder.write("longer.toml", LONGER);
    let (code, said) = folder.compare(&["longer.toml", "--out", "whole", "--jobs", "2"]);
    assert_eq!(code, 0, "{said}");
    let journal = folder.0.join("out/longer.partial");
    // Whole lines after the head.
    let kept = || std::fs::read(&journal).map_or(0, |bytes| bytes.iter().filter(|&&b| b == b'\n').count().saturating_sub(1));
    let mut before = 0;
    for kill in 0..20u64 {
        let mut command = Command::new(env!("CARGO_BIN_EXE_formicarium"));
        let mut child = command.args(["compare", "longer.toml", "--out", "out", "--jobs", "2"]).current_dir(&folder.0);
        child = child.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null());
        let mut child = child.spawn().unwrap();
        // At twenty different moments of its life, spread over the first fifth of a second.
        std::thread::sleep(std::time::Duration::from_millis(5 + kill * 37 % 200));
        child.kill().unwrap();
        let finished = child.wait().unwrap().success();
        if finished {
            break;
        }
        assert!(kept() >= before, "{} runs were kept, now {}", before, kept());
        before = kept();
        if kill % 3 == 0 {
            // Half a line, as a write that was cut off leaves it.
            let mut bytes = std::fs::read(&journal).unwrap_or_default();
            bytes.extend_from_slice(b"{\"task\":{\"insta");
            std::fs::write(&journal, bytes).unwrap();
        }
    }
    let (code, said) = folder.compare(&["longer.toml", "--out", "out", "--jobs", "1"]);
    assert_eq!(code, 0, "{said}");
    for name in ["longer.csv", "longer.md"] {
        assert_eq!(folder.read(&format!("out/{name}")), folder.read(&format!("whole/{name}")), "{name}");
    }
    assert!(!journal.exists(), "the journal goes when the results stand");
}

#[test]
fn a_journal_of_another_question_is_not_taken_for_this_one() {
    let folder = Folder::new("journal");
    folder.write("longer.toml", LONGER);
    std::fs::create_dir_all(folder.0.join("out")).unwrap();
    folder.write("out/longer.partial", "{\"format\":\"formicarium/journal@1\",\"engine\":\"0\",\"experiment\":\"0\"}\n{}\n");
    let (code, said) = folder.compare(&["longer.toml", "--out", "out", "--seeds", "2"]);
    assert_eq!(code, 0, "{said}");
    assert_eq!(folder.read("out/longer.csv").lines().count(), 1 + 2 * 2 * 2);
}
