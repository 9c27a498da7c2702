//! How many runs there are, told apart by what they say: page, captions and command line say it alike.

use serde::Serialize;

use super::MapAnalysis;
use super::entry::{EntryAnalysis, Origin};

/// Runs that are done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RunCounts {
    /// Of planners of the catalog.
    pub done: usize,
    /// Those among them of searches that need no seeds, all alike on a map.
    pub alike: usize,
    /// From elsewhere, beside those.
    pub elsewhere: usize,
}

impl RunCounts {
    pub(super) fn of(maps: &[MapAnalysis]) -> Self {
        let count =
            |is: fn(&EntryAnalysis) -> bool| maps.iter().flat_map(|map| &map.entries).filter(|e| is(e)).map(|e| e.runs).sum();
        Self {
            done: count(|e| e.origin == Origin::Planner),
            alike: count(|e| e.needs_no_seed),
            elsewhere: count(|e| e.origin == Origin::Results),
        }
    }

    /// In words.
    pub fn words(self) -> String {
        let Self { done, alike, elsewhere } = self;
        let runs = |count: usize| if count == 1 { "1 run".into() } else { format!("{count} runs") };
        let alike = if alike > 0 {
            format!(", {alike} of them by searches that need no seeds, alike on each map")
        } else {
            String::new()
        };
        let elsewhere = if elsewhere > 0 { format!(", beside {} from elsewhere", runs(elsewhere)) } else { String::new() };
        runs(done) + &alike + &elsewhere
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_told_apart() {
        let words = |done, alike, elsewhere| RunCounts { done, alike, elsewhere }.words();
        assert_eq!([words(1, 0, 0), words(2400, 0, 0)], ["1 run", "2400 runs"]);
        assert_eq!(
            words(60, 30, 1),
            "60 runs, 30 of them by searches that need no seeds, alike on each map, beside 1 run from elsewhere"
        );
    }
}
