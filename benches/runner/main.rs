//! The engine, natively, as a runner of `cargo xtask bench`: one line of JSON in, one line of JSON out.
//!
//! `{"prepare": job}` makes a contestant ready and answers with its number; `{"round": number, "seed": n}` lets it do its work once and
//! answers with the seconds that it took and what came out. Jobs: see `walk.rs` and `exact.rs`; the other runners are in `benches/peers/`.
//! `runner count MAP PLANNER ITERATIONS` runs a colony without a clock, for whoever counts instructions.

mod exact;
#[path = "../reference/mod.rs"]
mod reference;
mod walk;

use std::io::{BufRead, Write, stdin, stdout};

use serde::Deserialize;
use serde_json::{Value, json};

/// What can be timed.
pub trait Contestant {
    /// Does the work once: seconds, and what came out.
    fn round(&mut self, seed: u32) -> Value;
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Request {
    Prepare(Job),
    #[serde(untagged)]
    Round {
        round: usize,
        seed: u32,
    },
}

#[derive(Deserialize)]
#[serde(tag = "work", rename_all = "lowercase")]
enum Job {
    Walk(walk::Job),
    Exact(exact::Job),
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["serve"] => serve(),
        ["count", map, planner, iterations] => {
            println!("{}", walk::moves(map, planner, iterations.parse().expect("a number of iterations")));
        }
        _ => eprintln!("the runner is started by `cargo xtask bench`"),
    }
}

fn serve() {
    let mut contestants: Vec<Box<dyn Contestant>> = Vec::new();
    for line in stdin().lock().lines() {
        let request = serde_json::from_str(&line.expect("a line")).expect("a request");
        let answer = match request {
            Request::Prepare(job) => {
                contestants.push(match job {
                    Job::Walk(job) => walk::contestant(job),
                    Job::Exact(job) => Box::new(exact::Exact::new(job)),
                });
                json!(contestants.len() - 1)
            }
            Request::Round { round, seed } => contestants[round].round(seed),
        };
        println!("{answer}");
        stdout().flush().expect("somebody reads");
    }
}
