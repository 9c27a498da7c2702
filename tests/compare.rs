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
    for file in ["q.csv", "q.md", "q.tests.md", "q.json", "q.summary.csv", "q.summary.json", "q.tex"] {
        assert_eq!(folder.read(&format!("one/{file}")), folder.read(&format!("seven/{file}")), "{file}");
    }
    // What stood there is replaced as a whole, and nothing else is left behind.
    assert_eq!(folder.compare(&["q.toml", "--out", "one", "--seeds", "1"]).0, 0);
    assert_eq!(folder.read("one/q.csv").lines().count(), 1 + 4);
    assert_eq!(std::fs::read_dir(folder.0.join("one")).unwrap().count(), 7);
}

#[test]
fn the_summary_has_a_line_an_entry_and_map() {
    let folder = Folder::new("summary");
    folder.write("q.toml", &QUESTION.replacen("length = 9.0", "length = 8.0", 1));
    assert_eq!(folder.compare(&["q.toml", "--out", "out"]).0, 0);
    let csv = folder.read("out/q.summary.csv");
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let of = |line: usize, name: &str| lines[line][lines[0].iter().position(|column| *column == name).unwrap()];
    // Two maps, three entries.
    assert_eq!(lines.len(), 1 + 2 * 3);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()), "{csv}");
    assert_eq!(
        [of(2, "instance"), of(2, "entry"), of(2, "runs"), of(2, "with_path"), of(2, "optimal")],
        ["small", "exact", "40", "40", "40"]
    );
    assert_eq!((of(2, "best"), of(2, "reference"), of(2, "deviation")), (of(2, "mean_high"), of(2, "median"), "0.0"));
    assert_eq!([of(3, "origin"), of(3, "runs"), of(3, "best")], ["missing", "0", ""]);
    assert_eq!([of(4, "with_path"), of(4, "median"), of(4, "success_low")], ["0", "", "0.0"]);
    let json: serde_json::Value = serde_json::from_str(&folder.read("out/q.summary.json")).unwrap();
    assert_eq!((&json["format"], json["lines"].as_array().unwrap().len()), (&"formicarium/summary@1".into(), 6));
    assert_eq!((json["lines"][1]["runs"].as_u64(), &json["lines"][2]["best"]), (Some(40), &serde_json::Value::Null));
    // Printed without decimals: 8.5 at most. What is published of A*, 10, is longer than the optimum.
    let page = folder.read("out/q.md");
    assert!(
        page.contains(
            "\n\n- colony: the published 8 is impossible on this map under its rule: the exact optimum is 9.000.\n\nOf a map that"
        ),
        "{page}"
    );
}

#[test]
fn the_table_for_a_paper_is_whole_latex() {
    let folder = Folder::new("latex");
    folder.write("q.toml", &QUESTION.replacen("label = \"colony\"", "label = \"colony_1 & 50 % of {η}\"", 1));
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--files", "latex"]).0, 0);
    assert_eq!(std::fs::read_dir(folder.0.join("out")).unwrap().count(), 1);
    let tex = folder.read("out/q.tex");
    let count = |what: &str| tex.matches(what).count();
    assert_eq!(
        (count("\\begin{table}"), count("\\end{table}"), count("\\begin{tabular}"), count("\\end{tabular}")),
        (2, 2, 2, 2)
    );
    assert_eq!((count("\\toprule"), count("\\midrule"), count("\\bottomrule"), count("\\caption{")), (2, 2, 2, 2));
    assert!(tex.contains("colony\\_1 \\& 50 \\% of \\{$\\eta$\\}") && tex.contains("seeds 5 to 44"), "{tex}");
    // Braces that are not escaped come in pairs, dollars too, and every row has as many fields as there are columns.
    let bare = tex.replace("\\{", "").replace("\\}", "").replace("\\$", "");
    assert_eq!(bare.matches('{').count(), bare.matches('}').count());
    assert!(bare.lines().all(|line| line.matches('$').count() % 2 == 0));
    let columns = tex.split("\\begin{tabular}{").nth(1).unwrap().find('}').unwrap();
    let rows: Vec<usize> =
        tex.lines().filter(|l| l.ends_with("\\\\")).map(|l| l.replace("\\&", "").matches('&').count()).collect();
    assert_eq!(rows, vec![columns - 1; 2 * (1 + 3)]);
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--files", "tests-csv,summary-markdown"]).0, 0);
    let tests = folder.read("out/q.tests.csv");
    // One pair on each map; on the wall no run finds a path, and none differs.
    assert!(tests.starts_with("instance,test,first,second,statistic,p,holm,a12\nsmall,wilcoxon,colony,exact,"), "{tests}");
    assert!(tests.contains("\nwall,mann-whitney,colony,exact,800.0,1.0,1.0,0.5\n"), "{tests}");
    assert!(folder.read("out/q.summary.md").contains("| A* | 40 of 40 | **"));
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--files", "pdf"]);
    assert!(code == 2 && said.contains("choose from csv, markdown"), "{said}");
}

#[test]
fn a_budget_can_be_set_from_outside() {
    let folder = Folder::new("budget");
    // Three ants an iteration: of two iterations, one is within five paths, and the next one ends the run.
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--budget", "constructed-paths=5"]);
    assert_eq!(code, 0, "{said}");
    let page = folder.read("out/q.md");
    assert!(
        page.contains("--budget constructed-paths=5`") && page.contains(", of each at most 5 constructed paths count."),
        "{page}"
    );
    let csv = folder.read("out/q.csv");
    let paths = csv.lines().skip(1).filter(|l| l.starts_with("small,colony")).map(|l| l.split(',').nth(9).unwrap().to_owned());
    assert!(paths.clone().all(|n| n.is_empty() || n == "3") && paths.count() == 40, "{csv}");
    for wrong in ["constructed-paths", "time=3", "moves=0", "walks=4", "moves=-1"] {
        let (code, said) = folder.compare(&["q.toml", "--out", "out", "--budget", wrong]);
        assert!(code == 2 && said.contains("--budget"), "{said}");
    }
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

#[test]
fn an_ablation_needs_no_question() {
    let folder = Folder::new("ablation");
    let asked = ["--ablate", "rank-based-ant-system", "--set", "ants=4", "--set", "iterations=3", "--out", "out"];
    folder.write("Wall 2.csv", "0,1,0\n0,1,0\n0,1,3\n2,1,0\n");
    let (code, said) = folder.compare(&[&asked[..], &["--map", "small.csv", "--map", "Wall 2.csv", "--seeds", "20"]].concat());
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/ablation-rank-based-ant-system.csv");
    assert_eq!(csv.lines().count(), 1 + 2 * 3 * 20);
    assert!(csv.lines().nth(21).is_some_and(|row| row.starts_with("small,without-ranking,1,")), "{csv}");
    let page = folder.read("out/ablation-rank-based-ant-system.md");
    for wanted in [
        "## What each component does",
        "### small: length, mean of the full planner",
        "### wall-2: length, median of the full planner no path",
        "| without deposits by rank |",
        "--ablate rank-based-ant-system --out DIR --set ants=4 --set iterations=3 --seeds 20 --map small.csv --map Wall 2.csv`",
    ] {
        assert!(page.contains(wanted), "`{wanted}` is not in\n{page}");
    }
    // Nobody finds a path through the wall: nothing differs.
    assert!(said.contains("without ranking on wall-2: length, median no path → no path: no difference shown"), "{said}");
    // It opens again, and is an ablation still.
    let (code, said) = folder.compare(&["out/ablation-rank-based-ant-system.json", "--out", "again"]);
    assert!(code == 0 && said.contains("120 of 120 runs the same") && said.contains("without ranking on small"), "{said}");
    assert_eq!(folder.read("again/ablation-rank-based-ant-system.csv"), csv);
}

#[test]
fn what_cannot_be_taken_apart_is_named_with_code_2() {
    let folder = Folder::new("ablation-errors");
    for (args, message) in [
        (&["--ablate", "astar", "--map", "small.csv"][..], "--ablate astar: ablation.planner = astar"),
        (&["--ablate", "bee", "--map", "small.csv"], "there is no planner `bee`"),
        (&["--ablate", "ship", "--map", "none.csv"], "cannot read none.csv"),
        (&["--ablate", "ship", "--map", "small.csv", "--map", "small.csv"], "instances.id = small"),
        (&["--ablate", "ship", "--map", "small.csv", "--set", "rho=2"], "rho = 2 is outside"),
        (&["--ablate", "ship"], "--map"),
        (&["q.toml", "--ablate", "ship", "--map", "small.csv"], "cannot be used with"),
        (&["q.toml", "--set", "rho=0.5"], "--ablate"),
    ] {
        let (code, said) = folder.compare(&[args, &["--out", "out"]].concat());
        assert!(code == 2 && said.contains(message), "{message}: {said}");
    }
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
    // It may be killed before it has made its folder.
    std::fs::create_dir_all(folder.0.join("out")).unwrap();
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

#[test]
fn a_written_experiment_is_compared_again_and_verified() {
    let folder = Folder::new("verified");
    assert_eq!(folder.compare(&["q.toml", "--out", "one", "--seeds", "4"]).0, 0);
    let whole = folder.read("one/q.json");
    folder.write("again.json", &whole);
    let (code, said) = folder.compare(&["again.json", "--out", "two"]);
    // Two maps, two entries that run, four seeds.
    assert!(code == 0 && said.contains("recorded results: 16 of 16 runs the same, bit for bit\n"), "{said}");
    for ending in ["csv", "tests.md", "json"] {
        assert_eq!(folder.read(&format!("two/again.{ending}")), folder.read(&format!("one/q.{ending}")), "{ending}");
    }
    // A spot check: fewer seeds are no other question.
    let (code, said) = folder.compare(&["again.json", "--out", "spot", "--seeds", "1"]);
    assert!(code == 0 && said.contains("recorded results: 4 of 16 runs the same") && !said.contains("changed"), "{said}");
}

#[test]
fn what_does_not_come_out_again_is_told_with_its_cause() {
    let folder = Folder::new("differs");
    assert_eq!(folder.compare(&["q.toml", "--out", "one", "--seeds", "4"]).0, 0);
    let whole = folder.read("one/q.json");
    let again = |from: &str, to: &str| {
        assert!(whole.contains(from), "{from}");
        folder.write("again.json", &whole.replacen(from, to, 1));
        folder.compare(&["again.json", "--out", "two"])
    };
    // A run's row was changed by hand: seed 6 of A* on the first map is told, and that its digest never stood for it.
    let row = r#"{"task":{"instance":0,"entry":1,"seed":6},"status":"optimal""#;
    let (code, said) = again(row, &row.replace("optimal", "stagnated"));
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("runs of exact on small: the file's runs were changed since their digest was taken"), "{said}");
    // Its digest was changed as well: engine, question and parameters are the same, and nothing explains it.
    let version = env!("CARGO_PKG_VERSION");
    let digest = whole.split(r#""digest":""#).nth(1).and_then(|rest| rest.get(..16)).unwrap();
    let (code, said) = again(digest, "0123456789abcdef");
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("runs of colony on small: the file's runs were changed"), "{said}");
    // Another version, another default, another question: told, and no failure of this engine.
    let (code, said) = again(&format!(r#""engine":"{version}""#), r#""engine":"0.0.1""#);
    assert!(code == 0 && said.contains(&format!("engine: recorded with version 0.0.1, this is {version}")), "{said}");
    let (code, said) = again(r#""ants":3.0"#, r#""ants":5.0"#);
    assert_eq!(code, 0, "{said}");
    let order = ["question or maps were changed since", "parameter colony.ants: recorded with 3.0, now 5.0", "seed 5: digest"];
    let places: Vec<usize> = order.iter().map(|words| said.find(words).unwrap_or_else(|| panic!("`{words}`: {said}"))).collect();
    assert!(places.is_sorted(), "causes first: {said}");
    // Digests alone, as a link has them, and one that no run gives.
    let bare = &whole[..whole.find(",\n\"rows\"").unwrap()];
    folder.write("again.json", &format!("{}}}", bare.replacen(digest_of_runs(bare), "0000000000000000", 1)));
    let (code, said) = folder.compare(&["again.json", "--out", "two"]);
    assert!(code == 1 && said.contains("12 of 16 runs the same") && said.contains("nothing explains it"), "{said}");
}

/// The first digest over the runs of an entry.
fn digest_of_runs(document: &str) -> &str {
    let runs = document.split(r#""runs":[[{"count":4,"digest":""#).nth(1);
    runs.and_then(|rest| rest.get(..16)).unwrap()
}

#[test]
fn the_result_of_one_run_is_no_experiment() {
    let folder = Folder::new("one-run");
    folder.write("run.json", r#"{"format": "formicarium/result@1", "planner": "astar", "path": [[0,0],[1,1]]}"#);
    let (code, said) = folder.compare(&["run.json", "--out", "out"]);
    assert!(
        code == 2 && said.contains("the result of a single run") && said.contains("as `compare` or the page writes it"),
        "{said}"
    );
}

/// What somebody else's planner has found on the map `small`, whose optimum is 9.
const MINE: &str = "algorithm,map,seed,length,turns,iterations\nmine,small,5,9.0,6,3\nmine,small,6,9.9,7,1\nmine,small,7,,,\nBad luck,small,5,8.5,2,1\n";

#[test]
fn results_from_elsewhere_stand_beside_ours() {
    let folder = Folder::new("results");
    folder.write("mine.csv", MINE);
    let narrow = ["q.toml", "--out", "out", "--seeds", "3", "--results", "mine.csv"];
    let (code, said) = folder.compare(&narrow);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    // Two maps, two entries that run, three seeds; four runs from elsewhere, after ours of the same map.
    assert_eq!(csv.lines().count(), 1 + 2 * 2 * 3 + 4, "{csv}");
    let mine: Vec<&str> = csv.lines().filter(|l| l.starts_with("small,mine,") || l.starts_with("small,bad-luck,")).collect();
    assert_eq!(mine[0], "small,mine,5,complete,9.000000,6,,,3,,,length,9.000000,9.000000,true,0.000000,");
    assert!(mine[1].starts_with("small,mine,6,complete,9.900000,7,,,1,,,length,9.900000,9.000000,true,0.100000,"), "{mine:?}");
    assert_eq!(mine[2], "small,mine,7,budget-spent,,,,,,,,length,,9.000000,true,,");
    // Shorter than the optimum: a negative gap, told and not hidden.
    assert!(
        mine[3].starts_with("small,bad-luck,5,complete,8.500000,2,,,1,,,length,8.500000,9.000000,true,-0.055556,"),
        "{mine:?}"
    );
    let page = folder.read("out/q.md");
    for wanted in ["| mine |  | results from mine.csv |", "--results mine.csv`", "| mine | – | 2 of 3 |"] {
        assert!(page.contains(wanted), "`{wanted}` is not in\n{page}");
    }
    // The file that was written holds them, and ours come out of it again, bit for bit.
    let (code, said) = folder.compare(&["out/q.json", "--out", "again"]);
    assert!(code == 0 && said.contains("12 of 12 runs the same, bit for bit"), "{said}");
    assert_eq!(folder.read("again/q.csv"), csv);
    // Our own table is such a file.
    let (code, said) = folder.compare(&["q.toml", "--out", "twice", "--seeds", "3", "--results", "out/q.csv"]);
    assert_eq!(code, 0, "{said}");
    let twice = folder.read("twice/q.csv");
    assert_eq!(twice.lines().count(), 1 + 12 + 16);
    let fields = |entry: &str| {
        let line =
            twice.lines().find(|l| l.starts_with(&format!("small,{entry},5,"))).unwrap_or_else(|| panic!("{entry}: {twice}"));
        line.split(',').skip(3).take(13).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(fields("exact"), fields("exact-2"));
}

#[test]
fn an_entry_may_take_its_runs_from_a_file_beside_the_question() {
    let folder = Folder::new("entry-results");
    std::fs::create_dir_all(folder.0.join("questions")).unwrap();
    folder.write("mine.csv", MINE);
    let entry = "\n[[entries]]\nid = \"mine\"\nlabel = \"My planner\"\nrole = \"other\"\nresults = \"mine.csv\"\n\n[[claims]]";
    folder.write("q.toml", &QUESTION.replacen("\n[[claims]]", entry, 1));
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2"]);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    assert_eq!(csv.lines().filter(|l| l.contains(",mine,")).count(), 3, "{csv}");
    assert!(!csv.contains("bad-luck"));
    assert!(folder.read("out/q.md").contains("| My planner |  | results from mine.csv |"));
    // Runs on a map that is not asked for are left out, not refused.
    let (code, said) = folder.compare(&["q.toml", "--out", "wall", "--seeds", "2", "--only", "wall"]);
    assert_eq!(code, 0, "{said}");
    assert!(!folder.read("wall/q.csv").contains("mine"));
    // A map that nobody knows is.
    folder.write("mine.csv", &MINE.replace("small", "smell"));
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert!(code == 2 && said.contains("mine.csv: results.instance = smell") && said.contains("one of small, wall"), "{said}");
    folder.write("mine.csv", "algorithm,length\nmine,9\nmine,9,8\n");
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert!(code == 2 && said.contains("mine.csv: line 3: 3 fields where the header has 2"), "{said}");
    std::fs::remove_file(folder.0.join("mine.csv")).unwrap();
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert!(code == 2 && said.contains("cannot read mine.csv"), "{said}");
}

#[test]
fn data_of_iohanalyzer_needs_the_map_that_it_does_not_name() {
    let folder = Folder::new("ioh");
    folder.write("acs.dat", "\"function evaluation\" \"best-so-far f(x)\"\n10 12.5\n40 9.0\n500 9\n");
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2", "--results", "acs.dat"]);
    assert!(code == 2 && said.contains("the file does not say on which map its runs are"), "{said}");
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2", "--results", "small=acs.dat"]);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    assert!(csv.contains("\nsmall,acs,1,complete,9.000000,,,,,40,,length,9.000000,9.000000,true,0.000000,\n"), "{csv}");
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--results", "cave=acs.dat"]);
    assert!(code == 2 && said.contains("instances = cave") && said.contains("small, wall"), "{said}");
}

#[test]
fn a_comparison_with_results_goes_on_where_it_was() {
    let folder = Folder::new("results-journal");
    folder.write("mine.csv", MINE);
    let args = ["q.toml", "--out", "out", "--seeds", "4", "--results", "mine.csv"];
    assert_eq!(folder.compare(&args).0, 0);
    // The journal of a process that was killed after two of its runs, made from the file that it would have written.
    let whole: serde_json::Value = serde_json::from_str(&folder.read("out/q.json")).unwrap();
    let digest = whole["recorded"]["experiment"].as_str().unwrap();
    let version = env!("CARGO_PKG_VERSION");
    let mut journal = format!("{{\"format\":\"formicarium/journal@1\",\"engine\":\"{version}\",\"experiment\":\"{digest}\"}}\n");
    for row in &whole["rows"].as_array().unwrap()[..2] {
        // Told apart from a run that is done again.
        let row = row.to_string().replace("budget-spent", "stagnated");
        journal += &(row + "\n");
    }
    std::fs::create_dir_all(folder.0.join("on")).unwrap();
    folder.write("on/q.partial", &journal);
    let on = ["q.toml", "--out", "on", "--seeds", "4", "--results", "mine.csv"];
    assert_eq!(folder.compare(&on).0, 0);
    let (one, other) = (folder.read("out/q.csv"), folder.read("on/q.csv"));
    assert_eq!(one.replace("budget-spent", "stagnated"), other.replace("budget-spent", "stagnated"));
    assert_eq!(other.lines().filter(|l| l.starts_with("small,colony") && l.contains(",stagnated,")).count(), 2, "{other}");
    // Other results are another experiment: nothing of it is kept.
    folder.write("mine.csv", &MINE.replace("9.9", "9.8"));
    folder.write("on/q.partial", &journal);
    assert_eq!(folder.compare(&on).0, 0);
    assert!(!folder.read("on/q.csv").contains("stagnated"));
}
