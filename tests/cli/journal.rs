//! The journal of `compare`: damaged, of another comparison, in another process's hands.
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use formicarium::comparison::{Row, report};
use formicarium::digest::Digest;

use super::folder::Folder;
use super::interrupted::LONGER;

/// The results that must not differ.
const RESULTS: [&str; 2] = ["csv", "json"];

/// The journal that a process would have left that was killed when all runs were done.
pub fn journal_of(document: &str) -> String {
    let whole: serde_json::Value = serde_json::from_str(document).unwrap();
    let (experiment, engine) = (whole["recorded"]["experiment"].as_str().unwrap(), env!("CARGO_PKG_VERSION"));
    let rows: Vec<Row> = serde_json::from_value(whole["rows"].clone()).unwrap();
    let head = format!("{{\"format\":\"formicarium/journal@2\",\"engine\":\"{engine}\",\"experiment\":\"{experiment}\"}}\n");
    let line = |(task, row): (usize, &Row)| {
        let body = format!("{{\"experiment\":\"{experiment}\",\"task\":{task},\"row\":{}", row.to_line());
        let mut check = Digest::default();
        check.bytes(engine.as_bytes());
        check.bytes(body.as_bytes());
        format!("{body},\"check\":\"{}\"}}\n", check.hex())
    };
    head + &rows.iter().enumerate().map(line).collect::<String>()
}

fn start(folder: &Folder, args: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_formicarium"));
    command.arg("compare").args(args).current_dir(&folder.0).stdin(Stdio::null());
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// Resumes journals of which one bit has flipped, spread over the whole file, and compares what comes out with what should.
fn flip_bits(test: &str, flips: usize) {
    let folder = Folder::with_question(test);
    let args = |out| ["q.toml", "--out", out, "--seeds", "6", "--files", "csv,json"];
    assert_eq!(folder.compare(&args("whole")).0, 0);
    let journal = journal_of(&folder.read("whole/q.json")).into_bytes();
    std::fs::create_dir_all(folder.0.join("out")).unwrap();
    let mut told = 0;
    for flip in 0..flips {
        // Coprime to eight: every bit of a byte has its turn.
        let bit = (flip * 8 * journal.len() / flips / 8) * 8 + flip % 8;
        let mut damaged = journal.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        std::fs::write(folder.0.join("out/q.partial"), &damaged).unwrap();
        let (code, said) = folder.compare(&args("out"));
        assert_eq!(code, 0, "bit {bit}: {said}");
        told += usize::from(said.contains(" dropped; those runs are done again"));
        for ending in RESULTS {
            assert_eq!(folder.read(&format!("out/q.{ending}")), folder.read(&format!("whole/q.{ending}")), "bit {bit}: {ending}");
        }
        assert!(!folder.0.join("out/q.partial").exists());
    }
    // Only the end of the last line can be lost without a word: then it is half a line.
    assert!(told + 1 >= flips, "{told} of {flips} told");
}

#[test]
fn a_flipped_bit_costs_a_run_and_never_changes_one() {
    flip_bits("flips", 24);
}

#[test]
#[ignore = "takes minutes: cargo test --test cli -- --ignored a_thousand_flipped_bits"]
fn a_thousand_flipped_bits_change_no_run() {
    flip_bits("thousand-flips", 1000);
}

/// Two comparisons of one name in one folder, killed and resumed, again and again.
fn mix(test: &str, times: u64) {
    let folder = Folder::with_question(test);
    folder.write("longer.toml", LONGER);
    let budgets = ["iterations=300", "iterations=400"];
    let args =
        |out, budget| ["longer.toml", "--out", out, "--seeds", "12", "--budget", budget, "--files", "csv,json", "--jobs", "2"];
    for (out, budget) in ["first", "second"].into_iter().zip(budgets) {
        assert_eq!(folder.compare(&args(out, budget)).0, 0);
    }
    assert_ne!(folder.read("first/longer.csv"), folder.read("second/longer.csv"));
    let mut resumed = 0;
    for time in 0..times {
        let mut both = budgets.map(|budget| {
            let child = start(&folder, &args("out", budget));
            std::thread::sleep(Duration::from_millis(time * 13 % 40));
            child
        });
        std::thread::sleep(Duration::from_millis(5 + time * 37 % 120));
        for child in &mut both {
            child.kill().unwrap();
            child.wait().unwrap();
        }
        let (wanted, budget) = if time % 2 == 0 { ("first", budgets[0]) } else { ("second", budgets[1]) };
        resumed += u64::from(folder.0.join("out/longer.partial").exists());
        let (code, said) = folder.compare(&args("out", budget));
        assert_eq!(code, 0, "{said}");
        for ending in RESULTS {
            let of = |out: &str| folder.read(&format!("{out}/longer.{ending}"));
            assert_eq!(of("out"), of(wanted), "time {time}: {ending}");
        }
        std::fs::remove_dir_all(folder.0.join("out")).unwrap();
    }
    println!("{resumed} of {times} resumed a journal");
    assert!(resumed > 0);
}

#[test]
fn two_comparisons_of_one_name_never_share_a_row() {
    mix("mixed", 6);
}

#[test]
#[ignore = "takes minutes: cargo test --test cli -- --ignored two_hundred_mixed"]
fn two_hundred_mixed_resumes_share_no_row() {
    mix("mixed-often", 200);
}

#[test]
fn a_second_process_waits_or_refuses() {
    let folder = Folder::with_question("second");
    std::fs::create_dir_all(folder.0.join("out")).unwrap();
    folder.write("out/q.partial", "");
    let held = std::fs::File::open(folder.0.join("out/q.partial")).unwrap();
    held.lock().unwrap();
    let args = ["q.toml", "--out", "out", "--seeds", "2"];
    let (code, said) = folder.compare(&[&args[..], &["--no-wait"]].concat());
    assert!(code == 2 && said.contains("another process is comparing under this name"), "{said}");
    let mut command = Command::new(env!("CARGO_BIN_EXE_formicarium"));
    command.arg("compare").args(args).current_dir(&folder.0).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut waiting = command.spawn().unwrap();
    std::thread::sleep(Duration::from_millis(300));
    assert!(waiting.try_wait().unwrap().is_none(), "it waits");
    held.unlock().unwrap();
    let said = waiting.wait_with_output().unwrap();
    assert!(said.status.success() && String::from_utf8_lossy(&said.stderr).contains("waiting for it"), "{said:?}");
    assert_eq!(folder.read("out/q.csv").lines().count(), 1 + 2 * 2 * 2);
}

#[test]
fn journals_of_others_are_set_aside_and_files_of_others_refused() {
    let folder = Folder::with_question("aside");
    let args = ["q.toml", "--out", "out", "--seeds", "2"];
    assert_eq!(folder.compare(&args).0, 0);
    let other = journal_of(&folder.read("out/q.json"));
    let old = "{\"format\":\"formicarium/journal@1\",\"engine\":\"0.1.0\",\"experiment\":\"0\"}\n{}\n";
    // Of another budget, and of a version that cannot be checked: neither is lost.
    let more = [&args[..], &["--budget", "iterations=1"]].concat();
    for (n, (journal, what)) in [(&*other, "of another comparison"), (old, "of an older version")].into_iter().enumerate() {
        folder.write("out/q.partial", journal);
        let (code, said) = folder.compare(&more);
        assert!(code == 0 && said.contains(what) && said.contains("it is kept as"), "{said}");
        assert_eq!(folder.read(&format!("out/q.partial.{}", n + 1)), journal);
    }
    // Somebody's own file is neither emptied nor deleted.
    let csv = folder.read("out/q.csv");
    for mine in ["what I have found so far\n", "{\"format\":\"mine\"}\n"] {
        folder.write("out/q.partial", mine);
        let (code, said) = folder.compare(&args);
        assert!(code == 2 && said.contains("q.partial is no journal of this program") && said.contains("--out"), "{said}");
        assert_eq!((folder.read("out/q.partial"), folder.read("out/q.csv")), (mine.into(), csv.clone()));
    }
    assert!(csv.starts_with(report::HEADER));
}
