//! A comparison's runs in equal parts, for many machines or many tabs.

use std::fmt;
use std::str::FromStr;

use super::Comparison;
use crate::error::QuestionError;

/// Most shards that a comparison is dealt to.
pub const MAX_SHARDS: u32 = 100_000;

/// One part of a comparison's runs; written `3/30`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shard {
    index: u32,
    of: u32,
}

impl Shard {
    /// Number `index` of `of`, counted from 1.
    ///
    /// # Errors
    /// [`QuestionError`] where there is no such shard.
    pub fn new(index: u32, of: u32) -> Result<Self, QuestionError> {
        if index >= 1 && index <= of && of <= MAX_SHARDS {
            return Ok(Self { index, of });
        }
        Err(wrong(&format!("{index}/{of}")))
    }

    /// Which one, from 1.
    pub fn index(self) -> u32 {
        self.index
    }

    /// How many there are.
    pub fn of(self) -> u32 {
        self.of
    }

    /// The one after it; the first one after the last.
    pub fn next(self) -> Self {
        Self { index: self.index % self.of + 1, of: self.of }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

impl FromStr for Shard {
    type Err = QuestionError;

    fn from_str(text: &str) -> Result<Self, QuestionError> {
        // Digits alone: a number in other letters would be a second name of the same shard.
        let number = |digits: &str| digits.parse().ok().filter(|n: &u32| n.to_string() == digits);
        let (index, of) = text.split_once('/').and_then(|(a, b)| number(a).zip(number(b))).ok_or_else(|| wrong(text))?;
        Self::new(index, of)
    }
}

fn wrong(text: &str) -> QuestionError {
    QuestionError::field("shard", text, format!("I/N such as 3/30, with I from 1 to N and N up to {MAX_SHARDS}"))
}

impl Comparison {
    /// The places of [`Comparison::tasks`] that a shard gets, in their order. Every task is one shard's, and no shard has more than one
    /// task more than another.
    ///
    /// The tasks are dealt like cards: in each round every shard gets one, and each round begins at another shard. Tasks that stand in a
    /// row cost about the same (one entry on one map, seed after seed), so that costs are spread too, whatever the number of shards has in
    /// common with that of seeds, entries or maps.
    pub fn dealt(&self, shard: Shard) -> Vec<usize> {
        let (tasks, of) = (self.task_count(), shard.of as usize);
        let seat = |round: usize| (shard.index as usize - 1 + of - first_seat(round, of)) % of;
        (0..tasks.div_ceil(of)).map(|round| round * of + seat(round)).filter(|&place| place < tasks).collect()
    }
}

/// At which shard, from 0, a round begins: multiples of the golden ratio, which fill the circle evenly however many there are (Weyl 1916).
fn first_seat(round: usize, of: usize) -> usize {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let turn = (round as u64).wrapping_mul(GOLDEN) >> 32;
    ((turn * of as u64) >> 32) as usize
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use serde_json::json;

    use super::super::question::FORMAT;
    use super::super::{Question, Task};
    use super::*;
    use crate::map::{Grid, Point};
    use crate::scenario::{Scenario, ScenarioSpec};

    fn comparison(maps: usize, entries: usize, seeds: u32) -> Comparison {
        let instances: Vec<_> = (0..maps).map(|i| json!({ "id": format!("m{i}"), "map": "m.json" })).collect();
        let entry = |i| json!({ "id": format!("e{i}"), "label": format!("e{i}"), "role": "other", "planner": "ant-system" });
        let entries: Vec<_> = (0..entries).map(entry).collect();
        let question: Question = serde_json::from_value(json!({
            "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": seeds },
            "instances": instances, "entries": entries
        }))
        .unwrap();
        let grid = Grid::open(4, 3).unwrap();
        let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
        let scenario = Arc::new(Scenario::new(grid, spec).unwrap());
        Comparison::new(question, vec![scenario; maps]).unwrap()
    }

    fn shards(of: u32) -> impl Iterator<Item = Shard> {
        (1..=of).map(move |index| Shard::new(index, of).unwrap())
    }

    #[test]
    fn every_task_is_one_shards_and_none_has_two_more() {
        let comparison = comparison(3, 4, 5);
        for of in [1, 2, 3, 7, 12, 30, 59, 60, 61, 200] {
            let parts: Vec<Vec<usize>> = shards(of).map(|shard| comparison.dealt(shard)).collect();
            let mut all = parts.concat();
            all.sort_unstable();
            assert_eq!(all, (0..60).collect::<Vec<_>>(), "{of}");
            let sizes = parts.iter().map(Vec::len);
            assert!(sizes.clone().max().unwrap() <= sizes.min().unwrap() + 1, "{of}");
            assert!(parts.iter().all(|part| part.is_sorted()));
        }
    }

    #[test]
    fn costs_are_spread_whatever_the_numbers_have_in_common() {
        // An entry costs as much as its number and its map say, a hundred times as much at most: shards that would get whole entries by
        // `task mod n` differ by that.
        for (maps, entries, seeds, of) in
            [(20, 10, 30, 30), (20, 10, 30, 60), (30, 8, 25, 50), (24, 10, 20, 100), (50, 4, 10, 40)]
        {
            let comparison = comparison(maps, entries, seeds);
            let tasks = comparison.tasks();
            let cost = |Task { instance, entry, .. }: Task| ((1 + entry % 10) * (1 + instance % 10)) as f64;
            let mean = tasks.iter().map(|&task| cost(task)).sum::<f64>() / f64::from(of);
            let of_shard = |shard| comparison.dealt(shard).into_iter().map(|place| cost(tasks[place])).sum::<f64>();
            let most = shards(of).map(of_shard).fold(0.0, f64::max);
            assert!(most <= 1.25 * mean, "{maps} × {entries} × {seeds} on {of}: {most} against {mean}");
        }
    }

    #[test]
    fn a_shard_has_one_name() {
        let shard: Shard = "3/30".parse().unwrap();
        assert_eq!((shard.index(), shard.of(), shard.to_string()), (3, 30, "3/30".into()));
        assert_eq!("30/30".parse::<Shard>().unwrap().next().to_string(), "1/30");
        for text in ["0/3", "4/3", "1/0", "1/100001", "+1/3", "01/3", "1", "1/", "/3", "1/3/3", "a/b", "1 /3", "4294967297/3"] {
            let error = text.parse::<Shard>().unwrap_err().report();
            assert_eq!(error.field, "shard", "{text}");
            assert!(error.message.contains(text) && error.message.contains("3/30"), "{error:?}");
        }
    }
}
