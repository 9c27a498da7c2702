//! `compare --shard` and `--merge`: runs that many processes have done, as if one had.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use formicarium::digest::Digest;

use super::folder::Folder;
use super::interrupted::LONGER;

/// All files that a comparison writes unless some are chosen.
const RESULTS: [&str; 7] = ["csv", "md", "tests.md", "summary.csv", "summary.json", "tex", "json"];

/// Does a shard of the small question.
fn shard(folder: &Folder, shard: &str, out: &str) {
    let (code, said) = folder.compare(&["q.toml", "--shard", shard, "--out", out]);
    assert_eq!(code, 0, "{said}");
}

/// The small question in four shards, in `out`; and whole, in `whole`.
fn four_shards(test: &str) -> Folder {
    let folder = Folder::with_question(test);
    assert_eq!(folder.compare(&["q.toml", "--out", "whole"]).0, 0);
    (1..=4).for_each(|index| shard(&folder, &format!("{index}/4"), "out"));
    folder
}

fn merge(folder: &Folder, out: &str, more: &[&str]) -> (i32, String) {
    folder.compare(&[&["q.toml", "--merge", out], more].concat())
}

/// The journals in a folder, in the order of their names.
fn journals(folder: &Folder, out: &str) -> Vec<PathBuf> {
    let names = std::fs::read_dir(folder.0.join(out)).unwrap().map(|entry| entry.unwrap().path());
    let mut journals: Vec<PathBuf> = names.filter(|path| path.extension().is_some_and(|ending| ending == "journal")).collect();
    journals.sort();
    journals
}

fn name(path: &Path) -> &str {
    path.file_name().unwrap().to_str().unwrap()
}

/// A line with what `change` makes of it, and the check sum that belongs to that: as a forger writes it.
fn forged(line: &str, change: impl Fn(&str) -> String) -> String {
    let (body, _) = line.rsplit_once(",\"check\":\"").unwrap();
    let body = change(body);
    let mut check = Digest::default();
    check.bytes(env!("CARGO_PKG_VERSION").as_bytes());
    check.bytes(body.as_bytes());
    format!("{body},\"check\":\"{}\"}}", check.hex())
}

/// Forges every line behind a journal's head.
fn forge(path: &Path, change: impl Fn(&str) -> String) {
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().enumerate().map(|(at, line)| if at == 0 { line.into() } else { forged(line, &change) } + "\n");
    let text: String = lines.collect();
    std::fs::write(path, text).unwrap();
}

/// One more iteration than was done.
fn one_more_iteration(body: &str) -> String {
    let (before, effort) = body.split_once("\"effort\":[").unwrap();
    let (iterations, rest) = effort.split_once(',').unwrap();
    format!("{before}\"effort\":[{},{rest}", iterations.parse::<u32>().unwrap() + 1)
}

#[test]
fn thirty_shards_in_any_order_some_killed_give_the_bytes_of_one_run() {
    let folder = Folder::with_question("shards");
    folder.write("longer.toml", LONGER);
    let (code, said) = folder.compare(&["longer.toml", "--out", "whole", "--jobs", "2"]);
    assert_eq!(code, 0, "{said}");
    let mut killed = 0;
    for turn in 0..30u64 {
        let shard = format!("{}/30", 1 + turn * 11 % 30);
        let args = ["compare", "longer.toml", "--shard", &shard, "--out", "out", "--jobs", "1"];
        if turn % 3 == 0 {
            // SIGKILL, at another moment of its life each time.
            let mut command = Command::new(env!("CARGO_BIN_EXE_formicarium"));
            command.args(args).current_dir(&folder.0).stdout(Stdio::null()).stderr(Stdio::null());
            let mut child = command.spawn().unwrap();
            std::thread::sleep(Duration::from_millis(2 + turn));
            child.kill().unwrap();
            killed += usize::from(!child.wait().unwrap().success());
        }
        let (code, said) = folder.compare(&args[1..]);
        assert_eq!(code, 0, "{said}");
    }
    assert!(killed > 0, "none was killed in time");
    let (code, said) = folder.compare(&["longer.toml", "--merge", "out"]);
    assert_eq!(code, 0, "{said}");
    assert!(said.starts_with("merged 30 journals: 240 runs\n"), "{said}");
    for ending in RESULTS {
        assert_eq!(folder.read(&format!("out/longer.{ending}")), folder.read(&format!("whole/longer.{ending}")), "{ending}");
    }
    let names: Vec<_> = std::fs::read_dir(folder.0.join("out")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names.len(), 30 + RESULTS.len(), "{names:?}");
}

#[test]
fn what_is_missing_is_listed_with_the_command_that_does_it() {
    let folder = Folder::with_question("missing");
    assert_eq!(folder.compare(&["q.toml", "--out", "whole", "--seeds", "9"]).0, 0);
    let (code, said) = folder.compare(&["q.toml", "--merge", ".", "--seeds", "9"]);
    assert_eq!(code, 2, "{said}");
    assert!(said.contains("there is no journal") && said.contains("--shard 1/N"), "{said}");
    for index in [1, 3, 4] {
        let shard = format!("{index}/5");
        assert_eq!(folder.compare(&["q.toml", "--seeds", "9", "--shard", &shard, "--out", "out"]).0, 0);
    }
    let (code, said) = folder.compare(&["q.toml", "--merge", "out", "--seeds", "9"]);
    assert_eq!(code, 1, "{said}");
    assert!(said.starts_with("15 of 36 runs are missing\n") && said.contains("nothing was written\n"), "{said}");
    let commands: Vec<&str> =
        said.lines().filter_map(|line| line.split_once(": formicarium ").map(|(_, command)| command)).collect();
    assert_eq!(commands, ["compare q.toml --shard 2/5 --out out --seeds 9", "compare q.toml --shard 5/5 --out out --seeds 9"]);
    for command in commands {
        let args: Vec<&str> = command.split(' ').skip(1).collect();
        assert_eq!(folder.compare(&args).0, 0);
    }
    assert_eq!(folder.compare(&["q.toml", "--merge", "out", "--seeds", "9", "--out", "results"]).0, 0);
    for ending in RESULTS {
        assert_eq!(folder.read(&format!("results/q.{ending}")), folder.read(&format!("whole/q.{ending}")), "{ending}");
    }
}

#[test]
fn every_planted_fault_is_found_by_name() {
    let folder = four_shards("faults");
    let whole: Vec<(PathBuf, String)> =
        journals(&folder, "out").into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect();
    let (path, text) = &whole[1];
    let second = text.lines().nth(1).unwrap();
    let digit = second.find("\"length\":").unwrap() + 9;
    let changed = format!("{}{}{}", &second[..digit], (second.as_bytes()[digit] - b'0' + 1) % 10, &second[digit + 1..]);
    let engine = format!("\"engine\":\"{}\"", env!("CARGO_PKG_VERSION"));
    let other_question = forged(second, |body| body.replacen("experiment\":\"", "experiment\":\"0", 1));
    let no_task = forged(second, |body| body.replace("\"seed\":", "\"seed\":9"));
    let spaced = forged(second, |body| body.replace("\"effort\":", "\"effort\": "));
    let faults = [
        ("a changed digit", text.replacen(second, &changed, 1), "line 2 is damaged or was changed"),
        ("another engine", text.replacen(&engine, "\"engine\":\"9.9.9\"", 1), "was made by engine 9.9.9"),
        ("a cut line", text[..text.len() - 9].to_owned(), "is cut off"),
        ("another version", text.replacen("journal@2", "journal@7", 1), "another version, `formicarium/journal@7`"),
        ("a line of another question", text.replacen(second, &other_question, 1), "line 2 is of another question"),
        (
            "a run that is not asked for",
            text.replacen(second, &no_task, 1),
            "line 2 is of a run that the question does not ask for",
        ),
        ("a run in other letters", text.replacen(second, &spaced, 1), "line 2 was changed"),
        ("line ends of Windows", text.replace('\n', "\r\n"), "has the line ends of Windows"),
        ("something else", "x,y\n1,2\n".into(), "is no journal"),
        ("nothing", String::new(), "is no journal"),
    ];
    for (what, spoilt, found) in faults {
        std::fs::write(path, &spoilt).unwrap();
        let (code, said) = merge(&folder, "out", &[]);
        assert_eq!(code, 1, "{what}: {said}");
        let of = said.lines().find(|line| line.starts_with(name(path))).unwrap_or_default();
        assert!(of.contains(found), "{what}: {said}");
        assert!(!folder.0.join("out/q.csv").exists(), "{what}");
    }
    // Rerun, the shard mends what can be mended.
    std::fs::write(path, text.replacen(second, &changed, 1)).unwrap();
    shard(&folder, name(path).rsplit_once("shard-").unwrap().1.replace("of", "/").trim_end_matches(".journal"), "out");
    assert_eq!(merge(&folder, "out", &[]).0, 0);
    assert_eq!(folder.read("out/q.csv"), folder.read("whole/q.csv"));
}

#[test]
fn journals_of_another_question_are_refused_by_name() {
    let folder = four_shards("foreign");
    let other = Folder::with_question("foreign-other");
    assert_eq!(other.compare(&["q.toml", "--seeds", "3", "--shard", "1/4", "--out", "out"]).0, 0);
    let foreign = journals(&other, "out").remove(0);
    std::fs::copy(&foreign, folder.0.join("out").join(name(&foreign))).unwrap();
    let (code, said) = merge(&folder, "out", &[]);
    assert_eq!(code, 1, "{said}");
    assert!(said.starts_with(&format!("{}: is of another question or of other maps", name(&foreign))), "{said}");
}

#[test]
fn runs_that_stand_twice_must_agree() {
    let folder = four_shards("twice");
    let first = journals(&folder, "out").remove(0);
    let copy = folder.0.join("out/copy.journal");
    std::fs::copy(&first, &copy).unwrap();
    let (code, said) = merge(&folder, "out", &["--out", "results"]);
    assert_eq!(code, 0, "{said}");
    // The copy's name comes first.
    let doubled = format!("  {}: 40 runs that copy.journal has too, the same bit for bit\n", name(&first));
    assert!(said.contains(&doubled), "{said}");
    assert_eq!(folder.read("results/q.csv"), folder.read("whole/q.csv"));
    forge(&copy, one_more_iteration);
    let (code, said) = merge(&folder, "out", &["--out", "results"]);
    assert_eq!(code, 1, "{said}");
    assert!(said.starts_with("40 runs two journals do not agree on:\n") && said.contains("  and 20 more\n"), "{said}");
    assert!(said.contains("copy.journal:2 says ") && said.contains(&format!(", {}:2 says ", name(&first))), "{said}");
}

#[test]
fn a_sample_done_again_finds_forged_runs() {
    let folder = four_shards("forged");
    let (code, said) = merge(&folder, "out", &["--out", "results", "--recheck", "2%"]);
    assert_eq!(code, 0, "{said}");
    // One of each of four journals.
    assert!(said.contains("recheck: 4 runs done again, the same bit for bit (--recheck-seed "), "{said}");
    let path = journals(&folder, "out").remove(2);
    forge(&path, one_more_iteration);
    let (code, said) = merge(&folder, "out", &["--out", "forged", "--recheck", "2%", "--recheck-seed", "1"]);
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("recheck: 1 of 4 runs done again did not come out as they stand (--recheck-seed 1):\n"), "{said}");
    assert!(said.contains(&format!("  {}:", name(&path))) && !folder.0.join("forged/q.csv").exists(), "{said}");
    // The same ones again, and each of them by all.
    assert_eq!(merge(&folder, "out", &["--out", "forged", "--recheck", "2%", "--recheck-seed", "1"]).1, said);
    let (_, all) = merge(&folder, "out", &["--out", "forged", "--recheck", "100%"]);
    assert!(all.contains("recheck: 40 of 160 runs done again"), "{all}");
}

#[test]
fn a_shard_repeats_runs_of_the_next_one() {
    let folder = Folder::with_question("recheck");
    assert_eq!(folder.compare(&["q.toml", "--out", "whole"]).0, 0);
    for index in 1..=4 {
        let shard = format!("{index}/4");
        assert_eq!(folder.compare(&["q.toml", "--shard", &shard, "--out", "out", "--recheck", "10%"]).0, 0);
    }
    let (code, said) = merge(&folder, "out", &[]);
    assert_eq!(code, 0, "{said}");
    assert_eq!(said.matches(": 4 runs that ").count(), 4, "{said}");
    assert_eq!(folder.read("out/q.json"), folder.read("whole/q.json"));
    // A machine that computes wrongly is found by its neighbour.
    forge(&journals(&folder, "out")[1], one_more_iteration);
    let (code, said) = merge(&folder, "out", &[]);
    assert_eq!(code, 1, "{said}");
    assert!(said.starts_with("8 runs two journals do not agree on:\n"), "{said}");
}

#[test]
fn a_shard_that_is_whole_is_not_done_again() {
    let folder = Folder::with_question("again");
    shard(&folder, "2/3", "out");
    let path = journals(&folder, "out").remove(0);
    let (text, written) = (folder.read(&format!("out/{}", name(&path))), std::fs::metadata(&path).unwrap().modified().unwrap());
    let again = folder.run(&["compare", "q.toml", "--shard", "2/3", "--out", "out"]).ends(0);
    assert_eq!(again.out, format!("shard 2/3 is whole already: {}\n", PathBuf::from("out").join(name(&path)).display()));
    assert_eq!(std::fs::metadata(&path).unwrap().modified().unwrap(), written);
    // More is asked than before: the runs that are there stay, in whatever order they had been finished.
    let (code, said) = folder.compare(&["q.toml", "--shard", "2/3", "--out", "out", "--recheck", "50%"]);
    assert_eq!(code, 0, "{said}");
    let more = folder.read(&format!("out/{}", name(&path)));
    let more: BTreeSet<&str> = more.lines().collect();
    assert!(text.lines().all(|line| more.contains(line)) && more.len() > text.lines().count());
    // What is in its way and is no journal stays as it is.
    std::fs::write(&path, "mine\n").unwrap();
    shard(&folder, "1/3", "out");
    let (code, said) = folder.compare(&["q.toml", "--shard", "2/3", "--out", "out"]);
    assert_eq!((code, folder.read(&format!("out/{}", name(&path)))), (2, "mine\n".into()), "{said}");
}

#[test]
fn two_processes_of_one_shard_do_it_once() {
    let folder = Folder::with_question("one-shard");
    folder.write("longer.toml", LONGER);
    let start = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_formicarium"));
        command.args(["compare", "longer.toml", "--shard", "1/2", "--out", "out", "--jobs", "1"]).current_dir(&folder.0);
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    };
    let both = [start(), start()].map(|child| child.wait_with_output().unwrap());
    assert!(both.iter().all(|output| output.status.success()), "{both:?}");
    let said = both.map(|output| String::from_utf8(output.stdout).unwrap());
    assert_eq!(said.iter().filter(|said| said.contains("is whole already")).count(), 1, "{said:?}");
    let names: Vec<_> = std::fs::read_dir(folder.0.join("out")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names.len(), 1, "{names:?}");
}

#[test]
fn the_journals_names_are_known_before_they_are_there() {
    let folder = four_shards("names");
    let listed = folder.run(&["compare", "q.toml", "--list-shards", "4"]).ends(0).out;
    assert_eq!(listed.lines().collect::<Vec<_>>(), journals(&folder, "out").iter().map(|path| name(path)).collect::<Vec<_>>());
    assert_eq!(folder.compare(&["q.toml", "--list-shards", "0"]).0, 2);
}

#[test]
fn what_goes_with_no_shard_is_refused() {
    let folder = Folder::with_question("refused");
    for (args, tells) in [
        (&["--shard", "5/4", "--out", "out"][..], "I/N such as 3/30"),
        (&["--shard", "1/2"], "--out"),
        (&["--shard", "1/2", "--out", "out", "--files", "csv"], "cannot be used with"),
        (&["--shard", "1/2", "--merge", "out"], "cannot be used with"),
        (&["--merge", "out", "--recheck", "2"], "such as 2%"),
        (&["--merge", "out", "--recheck", "0%"], "such as 2%"),
        (&["--merge", "out", "--recheck", "NaN%"], "such as 2%"),
        (&["--merge", "out", "--recheck-seed", "2"], "--recheck"),
        (&["--out", "out", "--recheck", "2%"], "--shard"),
        (&["--merge", "nowhere"], "cannot read nowhere"),
    ] {
        let (code, said) = folder.compare(&[&["q.toml"], args].concat());
        assert_eq!(code, 2, "{args:?}: {said}");
        assert!(said.contains(tells), "{args:?}: {said}");
    }
}

#[test]
fn what_is_to_be_done_is_said_by_fault() {
    let folder = four_shards("advice");
    // All shards were made with an option that is forgotten now: nothing is missing.
    let (code, said) = merge(&folder, "out", &["--seeds", "3"]);
    assert_eq!((code, said.contains("--seeds, --only, --budget")), (1, true), "{said}");
    assert!(!said.contains("missing") && !said.contains("do it again"), "{said}");
    // A damaged one is gone on with where it lies, however it is dealt beside others.
    let path = journals(&folder, "out").remove(0);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replacen("\"status\":", "\"statut\":", 1)).unwrap();
    shard(&folder, "1/7", "out");
    let (_, said) = merge(&folder, "out", &[]);
    assert!(said.contains("a shard whose journal is damaged is done again where that lies"), "{said}");
    // Most journals are of four shards.
    std::fs::remove_file(&path).unwrap();
    let (_, said) = merge(&folder, "out", &[]);
    assert!(said.contains("  shard 1/4: ") && !said.contains("moved out"), "{said}");
    // Elsewhere than where they are.
    let (_, said) = merge(&folder, ".", &[]);
    assert!(said.contains("there are some in ./out"), "{said}");
    let (_, said) = merge(&folder, "out/q.toml", &[]);
    assert!(said.contains("cannot read out/q.toml"), "{said}");
    let (_, said) = merge(&folder, "q.toml", &[]);
    assert!(said.contains("q.toml is a file"), "{said}");
}

#[test]
fn commands_can_be_pasted_into_a_shell() {
    let folder = four_shards("quoted");
    std::fs::rename(folder.0.join("q.toml"), folder.0.join("my $(touch pwned) q.toml")).unwrap();
    let question = "my $(touch pwned) q.toml";
    assert_eq!(folder.compare(&[question, "--shard", "1/3", "--out", "out 2"]).0, 0);
    let (_, said) = folder.compare(&[question, "--merge", "out 2"]);
    assert!(said.contains("formicarium compare 'my $(touch pwned) q.toml' --shard 2/3 --out 'out 2'\n"), "{said}");
}

#[test]
fn a_journal_that_is_taken_away_is_missed() {
    let folder = Folder::with_question("taken");
    folder.write("longer.toml", LONGER);
    let mut command = Command::new(env!("CARGO_BIN_EXE_formicarium"));
    command.args(["compare", "longer.toml", "--shard", "1/2", "--out", "out", "--jobs", "1"]).current_dir(&folder.0);
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let partial = || {
        let mut paths = std::fs::read_dir(folder.0.join("out")).into_iter().flatten().map(|entry| entry.unwrap().path());
        paths.find(|path| path.extension().is_some_and(|ending| ending == "partial"))
    };
    while partial().is_none() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    let Some(path) = partial() else { return };
    std::fs::remove_file(path).unwrap();
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("was removed or replaced") && journals(&folder, "out").is_empty(), "{said}");
}

#[test]
fn runs_of_a_whole_journal_and_of_one_that_was_begun_again_are_joined() {
    let folder = Folder::with_question("joined");
    shard(&folder, "1/2", "out");
    let path = journals(&folder, "out").remove(0);
    let text = std::fs::read_to_string(&path).unwrap();
    let head: String = text.lines().take(3).map(|line| format!("{line}\n")).collect();
    std::fs::write(path.with_extension("partial"), head).unwrap();
    // One line of the whole one is damaged: all others stay.
    std::fs::write(&path, text.replacen("\"status\":\"optimal\"", "\"status\":\"optimax\"", 1)).unwrap();
    let (code, said) = folder.compare(&["q.toml", "--shard", "1/2", "--out", "out"]);
    assert_eq!((code, said.contains("80 runs, 79 from before")), (0, true), "{said}");
    assert!(!path.with_extension("partial").exists());
}

#[test]
fn equal_numbers_of_other_bytes_are_not_the_same() {
    let folder = four_shards("bytes");
    let first = journals(&folder, "out").remove(0);
    let copy = folder.0.join("out/copy.journal");
    std::fs::copy(&first, &copy).unwrap();
    forge(&copy, |body| body.replace("\"weight\":null", "\"weight\":-0.0"));
    forge(&first, |body| body.replace("\"weight\":null", "\"weight\":0.0"));
    let (code, said) = merge(&folder, "out", &[]);
    assert_eq!((code, said.contains("two journals do not agree on")), (1, true), "{said}");
}
