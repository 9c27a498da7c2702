//! Where the binary runs: folders with small maps and a small question.
use std::path::PathBuf;
use std::process::{Command, Output};

use serde_json::Value;

pub const MAP: &str = "type octile\nheight 4\nwidth 5\nmap\n.....\n.@@@.\n.@.@.\n...@.\n";
pub const SCEN: &str = "version 1\n1\tmaps/small.map\t5\t4\t0\t0\t4\t3\t7.00000\n0\tmaps/small.map\t5\t4\t0\t3\t2\t2\t3.00000\n";

const SMALL: &str = "0,0,0,0,0,0\n0,1,1,1,1,0\n0,1,0,0,0,0\n0,0,0,1,1,0\n0,1,0,0,0,0\n";

/// A colony and A* on two maps, one of them without a path; an entry that cannot run, and what is claimed.
pub const QUESTION: &str = r#"
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
pub struct Folder(pub PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("formicarium-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// With a map and its benchmark.
    pub fn with_map(test: &str) -> Self {
        let folder = Self::new(test);
        folder.write("small.map", MAP);
        folder.write("small.map.scen", SCEN);
        folder
    }

    /// With a question and the maps that it names.
    pub fn with_question(test: &str) -> Self {
        let folder = Self::new(test);
        folder.write("q.toml", QUESTION);
        folder.write("small.csv", SMALL);
        folder.write("wall.csv", "0,1,0\n0,1,0\n0,1,3\n2,1,0\n");
        folder
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// Runs the binary in the folder.
    pub fn run(&self, args: &[&str]) -> Run {
        let output = Command::new(env!("CARGO_BIN_EXE_formicarium")).args(args).current_dir(&self.0).output().unwrap();
        Run::new(args, output)
    }

    /// Runs `compare`: exit code, and what it said on both streams.
    pub fn compare(&self, args: &[&str]) -> (i32, String) {
        let run = self.run(&[&["compare"], args].concat());
        (run.code, run.out + &run.err)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// What a run said.
pub struct Run {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Run {
    fn new(args: &[&str], output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        let (out, err) = (text(output.stdout), text(output.stderr));
        println!("formicarium {}\n{out}{err}", args.join(" "));
        Self { code: output.status.code().unwrap(), out, err }
    }

    pub fn ends(self, code: i32) -> Self {
        assert_eq!(self.code, code, "{}{}", self.out, self.err);
        self
    }

    pub fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap_or_else(|e| panic!("{e}: {}", self.out))
    }

    pub fn says(self, wanted: &[&str]) -> Self {
        for text in wanted {
            assert!(self.out.contains(text) || self.err.contains(text), "`{text}` is not in\n{}{}", self.out, self.err);
        }
        self
    }
}
