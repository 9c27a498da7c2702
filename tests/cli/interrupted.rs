//! `compare` that was killed goes on where it was.
use std::process::Command;

use super::folder::Folder;

/// Runs of a question that takes a second or so, with everything in it that a journal has to keep.
pub const LONGER: &str = r#"
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
    let folder = Folder::with_question("killed");
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
        if kill % 3 == 0 && journal.exists() {
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
    // A killed process has left its unfinished files; whoever comes next removes them.
    let names = std::fs::read_dir(folder.0.join("out")).unwrap().map(|entry| entry.unwrap().file_name());
    assert_eq!(names.filter(|name| name.to_string_lossy().starts_with(".formicarium")).count(), 0);
}

#[test]
fn a_journal_of_another_question_is_not_taken_for_this_one() {
    let folder = Folder::with_question("journal");
    folder.write("longer.toml", LONGER);
    std::fs::create_dir_all(folder.0.join("out")).unwrap();
    folder.write("out/longer.partial", "{\"format\":\"formicarium/journal@2\",\"engine\":\"0\",\"experiment\":\"0\"}\n{}\n");
    let (code, said) = folder.compare(&["longer.toml", "--out", "out", "--seeds", "2"]);
    assert_eq!(code, 0, "{said}");
    assert_eq!(folder.read("out/longer.csv").lines().count(), 1 + 2 * 2 * 2);
}
