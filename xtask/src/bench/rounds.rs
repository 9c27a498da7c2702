//! Races: contestants do the same work one after the other, round by round, in an order that alternates.
//!
//! The machine's speed drifts, but hardly within a round: so ratios are taken within rounds, and the median is that of the ratios.

use anyhow::{Context, Result};
use serde_json::Value;

use super::interval::Interval;
use super::runner::Runner;

/// Rounds that do not count: engines of JavaScript compile what they have seen to be slow.
const WARM_UP: usize = 3;

/// Who takes part: a job that a runner has been given.
struct Contestant {
    name: String,
    runner: usize,
    number: u64,
}

/// What a contestant answered, round by round; the same seed in the same round.
pub struct Rounds {
    /// As a table calls it.
    pub name: String,
    pub answers: Vec<Value>,
}

/// Contestants of some runners.
pub struct Race<'a> {
    runners: Vec<&'a mut Runner>,
    contestants: Vec<Contestant>,
}

impl<'a> Race<'a> {
    pub fn new(runners: Vec<&'a mut Runner>) -> Self {
        Self { runners, contestants: Vec::new() }
    }

    /// How many runners take part.
    pub fn runners(&self) -> usize {
        self.runners.len()
    }

    /// Makes a contestant ready.
    pub fn join(&mut self, name: &str, runner: usize, job: &Value) -> Result<()> {
        let number = self.runners[runner].prepare(job).with_context(|| format!("{name} does not get ready"))?;
        self.contestants.push(Contestant { name: name.into(), runner, number });
        Ok(())
    }

    /// Some rounds to warm up, then these.
    pub fn run(mut self, rounds: usize) -> Result<Vec<Rounds>> {
        let mut all: Vec<Rounds> =
            self.contestants.iter().map(|c| Rounds { name: c.name.clone(), answers: Vec::with_capacity(rounds) }).collect();
        for round in 0..WARM_UP + rounds {
            for place in 0..all.len() {
                let who = if round % 2 == 0 { place } else { all.len() - 1 - place };
                let Contestant { name, runner, number } = &self.contestants[who];
                let answer = self.runners[*runner].round(*number, round as u32 + 1);
                let answer = answer.with_context(|| format!("{name} does not finish round {round}"))?;
                if round >= WARM_UP {
                    all[who].answers.push(answer);
                }
            }
        }
        Ok(all)
    }
}

impl Rounds {
    /// A number of each round.
    pub fn each(&self, of: impl Fn(&Value) -> f64) -> impl Iterator<Item = f64> {
        self.answers.iter().map(of)
    }

    /// Its median.
    pub fn median(&self, of: impl Fn(&Value) -> f64) -> Interval {
        Interval::of(self.each(of))
    }

    /// How many times as large it is as another's, round by round.
    pub fn ratio(&self, to: &Self, of: impl Fn(&Value) -> f64) -> Interval {
        Interval::of(self.answers.iter().zip(&to.answers).map(|(mine, theirs)| of(mine) / of(theirs)))
    }
}

/// How long a round took.
pub fn seconds(answer: &Value) -> f64 {
    answer["seconds"].as_f64().unwrap_or(f64::NAN)
}

/// Nanoseconds for each move of an ant.
pub fn nanoseconds_a_move(answer: &Value) -> f64 {
    1e9 * seconds(answer) / answer["moves"].as_f64().unwrap_or(f64::NAN)
}
