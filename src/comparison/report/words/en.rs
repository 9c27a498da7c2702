//! English.

use super::{Ablation, Fronts, Latex, Matrix, Names, Page, Signs, Summary, Tests, Words, claims};
use crate::comparison::analysis::{NoRunningTime, RunCounts};
use crate::comparison::budget::{Axis, Budget};
use crate::comparison::claim::Statistic;
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::Role;
use crate::planner::Objective;

pub(super) static WORDS: Words = Words {
    signs: Signs {
        list: ", ",
        parts: "; ",
        comma: ", ",
        next: ". ",
        end: ".",
        percent: |number| format!("{number} %"),
        about: |name, said| format!("{name}: {said}"),
        beside: |what, beside| format!("{what} ({beside})"),
        part_of: |part, whole| format!("{part} of {whole}"),
    },
    names: Names {
        measure: RunMeasure::name,
        objective,
        axis: Axis::words,
        role: |role| match role {
            Role::Baseline => "baseline",
            Role::Improved => "improved",
            Role::Other => "",
        },
        no_running_time: NoRunningTime::words,
        statistic: |statistic| match statistic {
            Statistic::Mean => "mean",
            Statistic::Median => "median",
        },
        from_elsewhere: |name| format!("{name} (from elsewhere)"),
        no_path: "no path",
        not_run: "not run",
        impossible_runs: |runs, entry| format!("{runs} runs of {entry}"),
        impossible: |runs| {
            format!(
                "†: impossible on this map, better than the proven optimum: {runs}; so it is not ranked, tested or set in bold"
            )
        },
        moves: |moves| format!("{moves} moves"),
        on_surface: ", on the surface",
        on_weighted: ", on weighted ground",
        robot: |radius| format!(", robot of radius {radius} m"),
        by_slices: |[levels, level, aside, climb]| {
            format!("by slices, {levels} levels of {level} m, |Δy| ≤ {aside}, |Δh| ≤ {climb}")
        },
        engine: ENGINE,
        setting,
        makes_small: |objectives| format!("makes small: {objectives}"),
    },
    page: Page {
        paper: |paper| format!("Paper: {paper}."),
        made_by: "Made by ",
        made_with: |setting| format!(" with {setting} "),
        how_to_read: "How to read it: docs/methodology.md.",
        entry: "entry",
        runs: "runs",
        results_from: |file| format!("results from {file}"),
        cannot_run: |why| format!("not run: {why}"),
        no_planner: "no planner",
        published: |measure| format!("published: {measure} / turns / iterations"),
        columns: [
            "found a path",
            "best",
            "median",
            "IQR",
            "mean ± sd [95 %]",
            "iteration of best: median (IQR)",
            "constructed paths to best: median",
            "turns: median (IQR)",
            "optimal",
        ],
        exact_optimum: |objective| format!("exact optimum, {objective}"),
        best_known: |objective| format!("best known, not proven, {objective}"),
        best_of_runs: |objective| format!("best of these runs, nothing is proven, {objective}"),
        exact: "exact",
        no_path_exists: "no path exists",
        none: "none",
        published_impossible: |value, optimum| {
            format!("the published {value} is impossible on this map under its rule: the exact optimum is {optimum}.")
        },
        runs_impossible: |part, whole| {
            format!(
                "{part} of {whole} runs are impossible on this map under its rule: they are better than the exact optimum, or there is no \
                 path; so the entry is not ranked or tested."
            )
        },
        stand_in: "Of a map that only stands for the publication's, this says that the two differ.",
    },
    claims: claims::EN,
    ablation: Ablation {
        title: "What each component does",
        about: |level| {
            format!(
                "Each component is taken out alone and all else stays; differences are of the runs without it less the full planner's, of \
                 equal seeds, so that more means that it helps. It matters where Wilcoxon's p, adjusted by Holm over the components of the \
                 map, is below {level}; nothing is said about two at once."
            )
        },
        map: |[map, what, full]| format!("{map}: {what} of the full planner {full}"),
        columns: |what, confidence| {
            let (means, medians) = (format!("difference of means [{confidence} %]"), format!("of medians [{confidence} %]"));
            let [path, worse, leaning, holm, finding] =
                ["runs with a path", "worse", "leaning", "p by Holm", "finding"].map(String::from);
            ["without".into(), what.into(), "change".into(), means, medians, path, worse, leaning, holm, finding]
        },
        helps: "helps",
        harms: "harms",
        not_shown: "no difference shown",
        too_few: "too few runs for a test",
    },
    tests: Tests {
        title: |title| format!("{title}: tests"),
        about: "Two-sided rank tests of every pair of entries, runs without a path ranked last. W: Wilcoxon's signed ranks over pairs of \
                equal seed; U: Mann and Whitney's, seeds not paired; p by Holm is adjusted for all pairs of the map. A: how likely a run of \
                the first entry is the better (smaller) one, ties counted half. ",
        none: |fewest| format!("No two entries with {fewest} runs or more: no tests."),
        columns: ["first", "second", "median, first", "second", "A", "W", "p", "p by Holm", "U", "p", "p by Holm"],
        over_maps: "Over all maps",
        friedman: |maps, statistic, degrees, p| {
            format!(
                "Friedman's test over the medians of {maps} maps: χ² = {statistic:.3} with {degrees} degrees of freedom, p = {p}."
            )
        },
        few_maps: " So few maps can hardly show a difference.",
        rank_columns: ["entry", "mean rank"],
        differ: |[first, second, p]| format!("{first} and {second} (p = {p})"),
        none_differ: "no two entries are shown to differ",
        post_hoc: |said| format!("Post hoc, adjusted by Holm, at 5 %: {said}."),
    },
    summary: Summary {
        makes_small: "makes small",
        columns: [
            "runs with a path",
            "best",
            "median (IQR)",
            "mean ± sd",
            "95 % of the mean",
            "median gap",
            "mean gap",
            "turns",
            "iteration of best",
        ],
        running_time: |near| format!("running time to +{near}"),
        about: |measure, axis, target, impossible| {
            let target = target.map_or_else(String::new, |[what, near, value]| format!(", to a {what} within {near} of {value}"));
            let impossible = if impossible.is_empty() { String::new() } else { format!("; {impossible}") };
            format!(
                "{measure} over the runs with a path; gap of a run: value / reference − 1 by the entry's own objective, which makes the median \
                 gap the gap of the median; turns and iteration of best: medians; running time: expected, in {axis}{target}{impossible}"
            )
        },
        not_reached: "no run reaches it",
    },
    matrix: Matrix {
        title: |title| format!("{title}: maps × entries"),
        about: "each field: the median over the runs with a path, the gap of that median, the rank by the median of all runs, of which those \
                without a path are the longest, and the share of runs with a path where some have none; last row: the mean rank and the mean \
                gap over all maps",
        map: "map",
        all_maps: "all maps",
        rank: |rank| format!("rank {rank}"),
        path_in: |share| format!("path in {share}"),
        impossible: "impossible",
        not_ranked: |entries| format!("Not ranked, without runs on every map: {entries}"),
        note: |map, note| format!("{map}, {note}"),
        objectives: |map, objectives| {
            format!("{map}, the entries make different things small, by which their gaps go: {objectives}")
        },
    },
    fronts: Fronts {
        title: |title| format!("{title}: trade-offs"),
        about: "a run is a point, and on a front where no other run is at least as good in every measure and better in one; equal points \
                are one, and count for every entry that has it; hypervolume: the part of the box between the best value of each measure and the \
                reference point that at least one run of the entry dominates",
        side: |measure, more| format!("{measure} ({} is better)", if more { "more" } else { "less" }),
        measures: |measures, at| match at {
            "" => format!("{measures}: no run is a point"),
            at => format!("{measures}; reference point: {at}"),
        },
        columns: [
            "",
            "runs that are points",
            "points of its front",
            "of these on the joint front (alone)",
            "share of the joint front",
            "hypervolume",
        ],
        alone: |joint, alone| format!("{joint} ({alone})"),
        all: "all together",
        beyond: |points, entry| {
            format!(
                "{points} points of the front of {entry} are not better than the reference point in every measure, and add nothing"
            )
        },
        left_out: "and its runs are no points",
    },
    latex: Latex {
        made_by: "% Made by ",
        needs: ".\n% Needs \\usepackage{booktabs,graphicx}.\n",
        made_with: |setting| format!("Formicarium, {setting}"),
    },
};

/// How a setting begins.
const ENGINE: &str = "engine version ";

fn objective(objective: Objective, measure: RunMeasure) -> &'static str {
    if measure == RunMeasure::Cost { objective.cost_words() } else { objective.words() }
}

fn setting([first, last]: [u32; 2], runs: RunCounts, budget: Option<Budget>) -> String {
    let seeds = format!("seeds {first} to {last} of every entry on every map, {}", runs.words());
    let budget = budget.map_or_else(String::new, |b| format!(", of each at most {} {} count", b.amount, b.axis.words()));
    format!("{ENGINE}{}: {seeds}{budget}.", env!("CARGO_PKG_VERSION"))
}
