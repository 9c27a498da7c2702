//! Pipes, full disks and files without an end.
#![cfg(target_os = "linux")]

use std::path::Path;
use std::process::{Command, Output};

use super::folder::Folder;

/// Runs a line of the shell in the folder, in which `$F` is the binary.
fn sh(folder: &Folder, line: &str) -> Output {
    let mut command = Command::new("sh");
    command.args(["-c", line]).env("F", env!("CARGO_BIN_EXE_formicarium")).current_dir(&folder.0).output().unwrap()
}

#[test]
fn what_cannot_be_printed_is_a_failure() {
    let folder = Folder::with_question("print");
    for command in [
        "$F generate cave --size 9x9",
        "$F generate cave --size 9x9 --out /dev/full",
        "$F generate cave --size 9x9 --out /dev/stdout",
        "$F convert small.csv - --as matrix",
        "$F plan small.csv --planner astar",
        "$F catalog",
        "$F --help",
        "$F compare q.toml --document",
        "$F compare q.toml --out out --seeds 1",
    ] {
        let ran = sh(&folder, &format!("{command} > /dev/full"));
        let said = String::from_utf8_lossy(&ran.stderr);
        assert!(ran.status.code() == Some(2) && said.contains("No space left"), "{command}: {said}");
        // A reader that has seen enough.
        let ran = sh(&folder, &format!("({command}; echo $? >&2) | true"));
        assert!(command.contains("full") || String::from_utf8_lossy(&ran.stderr).ends_with("0\n"), "{command}: {ran:?}");
    }
    // Nobody can be told: the code still says what happened.
    for (command, code) in [
        ("$F plan none.csv --planner astar", 2),
        ("$F plan small.csv --planner astar --format json > /dev/null", 0),
        ("$F convert small.csv a.map", 0),
        ("$F fly", 2),
    ] {
        assert_eq!(sh(&folder, &format!("{command} 2> /dev/full")).status.code(), Some(code), "{command}");
    }
}

#[test]
fn special_files_are_written_to() {
    let folder = Folder::with_map("special");
    let made = "$F generate maze --size 9x9 --as matrix";
    let plain = sh(&folder, made).stdout;
    for line in [
        format!("{made} --out /dev/stdout"),
        format!("{made} --out /dev/stdout | cat"),
        format!("{made} --out /dev/fd/3 3> three; cat three"),
        format!("mkfifo pipe; cat pipe & {made} --out pipe; wait"),
        format!("printf '' > there; {made} --out /dev/stdout >> there; cat there"),
    ] {
        let ran = sh(&folder, &line);
        assert!(ran.status.success() && ran.stdout == plain, "{line}: {ran:?}");
    }
    assert!(Path::new("/dev/stdout").is_symlink());
}

#[test]
fn files_without_an_end_are_refused_by_name() {
    let folder = Folder::with_question("endless");
    let sparse = std::fs::File::create(folder.0.join("large.json")).unwrap();
    sparse.set_len(8 << 30).unwrap();
    let small = [
        "plan large.json --planner astar",
        "convert large.json a.map",
        "check large.json --map small.csv",
        "bench-scen large.json",
        "compare large.json --out out",
        "compare q.toml --out out --results large.json",
        "compare q.toml --out out --map small=large.json",
    ];
    for command in small {
        // With less memory than a twentieth of the file: it is refused by its size.
        let ran = sh(&folder, &format!("ulimit -v 400000; $F {command}"));
        let said = String::from_utf8_lossy(&ran.stderr);
        let told = said.contains("large.json: a file of 8192 MiB is more than the");
        assert!(ran.status.code() == Some(2) && told, "{command}: {said}");
    }
    for command in ["check /dev/zero --map small.csv", "bench-scen /dev/zero", "check - --map small.csv < /dev/zero"] {
        let ran = sh(&folder, &format!("ulimit -v 400000; $F {command}"));
        let said = String::from_utf8_lossy(&ran.stderr);
        assert!(ran.status.code() == Some(2) && said.contains("is more than the 64 MiB"), "{command}: {said}");
    }
}

#[test]
fn pictures_of_ros_maps_are_files() {
    let folder = Folder::with_map("ros-fifo");
    let yaml = |image: &str| {
        format!("image: {image}\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n")
    };
    folder.write("fifo.yaml", &yaml("pipe"));
    folder.write("zero.yaml", &yaml("/dev/zero"));
    sh(&folder, "mkfifo pipe");
    for name in ["fifo.yaml", "zero.yaml"] {
        let ran = sh(&folder, &format!("$F plan {name} --planner astar"));
        let said = String::from_utf8_lossy(&ran.stderr);
        assert!(ran.status.code() == Some(2) && said.contains("is no file"), "{name}: {said}");
    }
    // A map that comes through a pipe is read once.
    let ran = sh(&folder, "mkfifo maps; (cat small.map > maps &); $F plan maps --planner astar");
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
}
