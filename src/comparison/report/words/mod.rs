//! What reports say, in each language they can be had in. A word that one of them lacks does not compile.
//!
//! Titles, notes, names of entries and maps are people's own: they stay as the file has them.

mod claims;
mod en;
mod zh_cn;

use serde::Deserialize;

use crate::comparison::analysis::{NoRunningTime, RunCounts};
use crate::comparison::budget::{Axis, Budget};
use crate::comparison::claim::Statistic;
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::Role;
use crate::planner::Objective;

pub(super) use claims::Claims;

/// The language of the files that people read, by its code on the command line and in the browser. CSV and JSON have none: programs read them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ReportLanguage {
    /// English.
    #[default]
    #[serde(rename = "en")]
    En,
    /// Simplified Chinese.
    #[serde(rename = "zh-CN")]
    ZhCn,
}

impl ReportLanguage {
    /// All of them, with their codes.
    pub const NAMED: [(&'static str, Self); 2] = [("en", Self::En), ("zh-CN", Self::ZhCn)];

    /// Its code.
    pub fn code(self) -> &'static str {
        Self::NAMED.iter().find(|(_, language)| *language == self).map_or("", |(code, _)| code)
    }

    pub(super) fn words(self) -> &'static Words {
        match self {
            Self::En => &en::WORDS,
            Self::ZhCn => &zh_cn::WORDS,
        }
    }
}

/// A text with one gap.
pub(super) type With = fn(&str) -> String;
/// A text with two.
pub(super) type WithTwo = fn(&str, &str) -> String;

/// All words of one language.
pub(super) struct Words {
    pub signs: Signs,
    pub names: Names,
    pub page: Page,
    pub claims: Claims,
    pub ablation: Ablation,
    pub tests: Tests,
    pub summary: Summary,
    pub matrix: Matrix,
    pub fronts: Fronts,
    pub latex: Latex,
}

/// What stands between words and numbers.
pub(super) struct Signs {
    /// Between the items of a list.
    pub list: &'static str,
    /// Between larger ones.
    pub parts: &'static str,
    /// Between the parts of a phrase.
    pub comma: &'static str,
    /// Behind a sentence that another one follows.
    pub next: &'static str,
    /// Behind the last one.
    pub end: &'static str,
    /// A number of hundredths.
    pub percent: With,
    /// What is said of something that is named first.
    pub about: WithTwo,
    /// Something, and beside it in brackets what belongs to it.
    pub beside: WithTwo,
    /// So many of so many.
    pub part_of: fn(usize, usize) -> String,
}

/// What the engine's own terms are called.
pub(super) struct Names {
    pub measure: fn(RunMeasure) -> &'static str,
    /// By the measure of its values: on weighted ground a cost.
    pub objective: fn(Objective, RunMeasure) -> &'static str,
    pub axis: fn(Axis) -> &'static str,
    pub role: fn(Role) -> &'static str,
    pub no_running_time: fn(NoRunningTime) -> &'static str,
    pub statistic: fn(Statistic) -> &'static str,
    pub from_elsewhere: With,
    pub no_path: &'static str,
    pub not_run: &'static str,
    /// How many runs of which entry are impossible.
    pub impossible_runs: WithTwo,
    /// What the mark † means, with those.
    pub impossible: With,
    pub moves: With,
    pub on_surface: &'static str,
    pub on_weighted: &'static str,
    /// A robot of a radius in metres.
    pub robot: With,
    /// Levels, their height, and the farthest step aside and up.
    pub by_slices: fn([String; 4]) -> String,
    /// How the next one begins.
    pub engine: &'static str,
    /// Engine, first and last seed, runs, budget: what numbers depend on beside the question.
    pub setting: fn([u32; 2], RunCounts, Option<Budget>) -> String,
    /// What the entries of a map make small.
    pub makes_small: With,
}

/// The page of a comparison.
pub(super) struct Page {
    pub paper: With,
    /// Before the command.
    pub made_by: &'static str,
    /// Behind it, with the setting.
    pub made_with: With,
    /// Where it stands how to read it.
    pub how_to_read: &'static str,
    pub entry: &'static str,
    pub runs: &'static str,
    pub results_from: With,
    pub cannot_run: With,
    pub no_planner: &'static str,
    /// Published measure, turns, iterations.
    pub published: With,
    /// From the runs with a path to the optimal ones.
    pub columns: [&'static str; 9],
    pub exact_optimum: With,
    pub best_known: With,
    pub best_of_runs: With,
    pub exact: &'static str,
    pub no_path_exists: &'static str,
    pub none: &'static str,
    /// A published value, and the optimum.
    pub published_impossible: WithTwo,
    /// How many of how many runs.
    pub runs_impossible: fn(usize, usize) -> String,
    pub stand_in: &'static str,
}

/// What each component does.
pub(super) struct Ablation {
    pub title: &'static str,
    /// With the level of p.
    pub about: fn(f64) -> String,
    /// Map, measure, and the full planner's value.
    pub map: fn([&str; 3]) -> String,
    /// With measure and confidence.
    pub columns: fn(&str, f64) -> [String; 10],
    pub helps: &'static str,
    pub harms: &'static str,
    pub not_shown: &'static str,
    pub too_few: &'static str,
}

/// Rank tests.
pub(super) struct Tests {
    pub title: With,
    /// What the tables have; where it stands how to read them follows.
    pub about: &'static str,
    /// With the fewest runs of a test.
    pub none: fn(usize) -> String,
    pub columns: [&'static str; 11],
    pub over_maps: &'static str,
    /// Maps, χ², degrees of freedom, p.
    pub friedman: fn(usize, f64, usize, &str) -> String,
    pub few_maps: &'static str,
    pub rank_columns: [&'static str; 2],
    /// Two entries, and p.
    pub differ: fn([&str; 3]) -> String,
    pub none_differ: &'static str,
    pub post_hoc: With,
}

/// The statistics that papers print.
pub(super) struct Summary {
    pub makes_small: &'static str,
    pub columns: [&'static str; 9],
    /// With the distance from the best known value.
    pub running_time: With,
    /// How to read it: with the measure, the axis, the target (measure, distance, value) and what is impossible, which may be empty.
    pub about: fn(&str, &str, Option<[&str; 3]>, &str) -> String,
    pub not_reached: &'static str,
}

/// Maps × entries.
pub(super) struct Matrix {
    pub title: With,
    pub about: &'static str,
    pub map: &'static str,
    pub all_maps: &'static str,
    pub rank: With,
    pub path_in: With,
    pub impossible: &'static str,
    pub not_ranked: With,
    /// A map, and what must be known of it.
    pub note: WithTwo,
    /// A map, and what its entries make small.
    pub objectives: WithTwo,
}

/// What runs trade off.
pub(super) struct Fronts {
    pub title: With,
    pub about: &'static str,
    /// A measure, and whether more of it is better.
    pub side: fn(&str, bool) -> String,
    /// The measures with their sides, and the reference point, which may be empty.
    pub measures: WithTwo,
    pub columns: [&'static str; 6],
    /// Points of the joint front, and of these those that nobody else has.
    pub alone: fn(usize, usize) -> String,
    pub all: &'static str,
    /// How many points of which entry are not better than the reference.
    pub beyond: fn(usize, &str) -> String,
    /// Behind what is impossible.
    pub left_out: &'static str,
}

/// What stands around the tables of LaTeX.
pub(super) struct Latex {
    /// Before the command, comments and all.
    pub made_by: &'static str,
    /// Behind it.
    pub needs: &'static str,
    /// Who made it, with the setting.
    pub made_with: With,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn languages_go_by_their_codes() {
        for (code, language) in ReportLanguage::NAMED {
            let read: ReportLanguage = serde_json::from_str(&format!("\"{code}\"")).unwrap();
            assert_eq!((read, read.code()), (language, code));
        }
        assert!(serde_json::from_str::<ReportLanguage>("\"zh\"").is_err());
        assert_eq!(ReportLanguage::default(), ReportLanguage::En);
    }
}
