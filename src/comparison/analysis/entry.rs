//! One entry on one map.

use serde::Serialize;

use super::curves::{BandPoint, Curves, EcdfPoint, RunningTime};
use super::published::{self, PublishedAnalysis};
use crate::comparison::ablation::AblationRole;
use crate::comparison::budget::Axis;
use crate::comparison::course;
use crate::comparison::gap::ROUNDING;
use crate::comparison::intervals::Intervals;
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::{Entry, Role};
use crate::comparison::samples::{Samples, Seen};
use crate::comparison::statistics::{Summary, quantile, sorted, wilson};
use crate::metrics::WeightedSum;
use crate::planner::Objective;

/// Where an entry's runs come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Origin {
    /// A planner of the catalog.
    Planner,
    /// Results from elsewhere.
    Results,
    /// Nowhere: nothing can be run.
    Missing,
}

/// Why an entry has no running times on a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum NoRunningTime {
    /// It has no runs here.
    NoRuns,
    /// No value is known that could be a target.
    NoTarget,
    /// Its planner makes something else small than what the targets are about.
    OtherObjective,
    /// Effort is counted in iterations, and its planner has none.
    NoIterations,
    /// A run does not tell its effort on the axis.
    NoEffort,
    /// Some of its runs are impossible: reaching a target would say nothing.
    Impossible,
}

impl NoRunningTime {
    /// In words, for tables.
    pub fn words(self) -> &'static str {
        match self {
            Self::NoRuns => "not run",
            Self::NoTarget => "no target known",
            Self::OtherObjective => "other objective",
            Self::NoIterations => "has no iterations",
            Self::NoEffort => "effort not told",
            Self::Impossible => "impossible runs",
        }
    }
}

/// What the runs of one entry on one map say. Numbers about paths are over the runs that found one; how many did stands beside them.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct EntryAnalysis {
    /// Its id.
    pub id: String,
    /// Its name in tables.
    pub label: String,
    /// What it is in the comparison.
    pub role: Role,
    /// Its part in an ablation; null where the question is none, or the entry has no part in it.
    pub ablation_role: Option<AblationRole>,
    /// Where its runs come from.
    pub origin: Origin,
    /// What its planner makes small here; null where nothing can be run.
    pub objective: Option<Objective>,
    /// The weights, where that is the weighted sum.
    #[serde(skip)]
    pub sum: Option<WeightedSum>,
    /// Whether it is a search that needs no seeds: all its runs on a map are the same, and it has no iterations.
    pub needs_no_seed: bool,
    /// Runs that are done.
    pub runs: usize,
    /// Runs that are to be done, the done ones among them.
    pub expected: usize,
    /// Runs that found a path.
    pub with_path: usize,
    /// What their true share may be, from and to: Wilson's 95 % interval.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub success_interval: [f64; 2],
    /// The seeds of the runs, ascending.
    pub seeds: Vec<u32>,
    /// The measure of each of them; null without a path.
    pub values: Vec<Option<f64>>,
    /// The measure.
    pub summary: Option<Summary>,
    /// 95 % bootstrap interval of its mean; null where intervals are not asked for.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number] | null"))]
    pub mean_interval: Option<[f64; 2]>,
    /// 95 % bootstrap interval of its median.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number] | null"))]
    pub median_interval: Option<[f64; 2]>,
    /// The best value of a run by the entry's own objective.
    pub best: Option<f64>,
    /// Whether the optimum of the entry's own objective is proven.
    pub proven: bool,
    /// Runs that found it, where it is.
    pub optimal: usize,
    /// Runs with a better value than the proven optimum: their rules cannot have been the map's.
    pub impossible: usize,
    /// Relative distance to that reference.
    pub gap: Option<Summary>,
    /// How many runs lie in each bin of the map's `gap_edges`; runs without a path in none.
    pub gap_counts: Vec<u32>,
    /// Turns.
    pub turns: Option<Summary>,
    /// The iteration that found the best path; null of a planner without iterations.
    pub iteration_of_best: Option<Summary>,
    /// Constructed paths up to the end of that iteration.
    pub paths_to_best: Option<Summary>,
    /// Effort up to there, on the axis.
    pub effort_to_best: Option<Summary>,
    /// Effort to the end, on the axis, of all runs.
    pub total_effort: Option<Summary>,
    /// The best so far over the axis; empty where a run does not tell.
    pub band: Vec<BandPoint>,
    /// Share of (run, target) pairs solved over the axis; empty where a run does not tell.
    pub ecdf: Vec<EcdfPoint>,
    /// What reaching each target takes.
    pub running_times: Vec<RunningTime>,
    /// Why nothing is told of that; null where something is, if only that no run reaches the target.
    pub no_running_time: Option<NoRunningTime>,
    /// What is published of it for this map.
    pub published: Option<PublishedAnalysis>,
}

/// What entries on one map are analysed by.
pub(super) struct About<'a> {
    pub samples: &'a Samples<'a>,
    pub map: usize,
    pub axis: Axis,
    pub curve_measure: RunMeasure,
    pub targets: &'a [f64],
    pub gap_edges: &'a [f64],
    pub roles: &'a [Option<AblationRole>],
}

impl EntryAnalysis {
    /// The median over all runs, those without a path among them: infinite where it is none of a path.
    pub fn median(&self) -> Option<f64> {
        quantile(&sorted(self.values.iter().map(|v| v.unwrap_or(f64::INFINITY)).collect()), 0.5)
    }
}

impl About<'_> {
    pub(super) fn entry(&self, entry: usize, intervals: Option<&mut Intervals>) -> EntryAnalysis {
        let comparison = self.samples.comparison();
        let (map, asked) = (&comparison.maps[self.map], &comparison.question.entries[entry]);
        let instance = &comparison.question.instances[self.map];
        let runs = self.samples.of(self.map, entry);
        let values: Vec<Option<f64>> = runs.iter().map(|seen| finite(seen.row.value(map.measure()))).collect();
        let known: Vec<f64> = values.iter().copied().flatten().collect();
        let with_path = runs.iter().filter(|seen| seen.row.found.is_some()).count();
        let name = format!("{}/{}", instance.id, asked.id);
        let (mean, median) = intervals.map_or((None, None), |i| (i.mean(&known, &name), i.median(&known, &name)));
        let of = |measure| summary(runs.iter().filter_map(|seen| finite(comparison.value(seen.row, measure))));
        let gaps: Vec<f64> = runs.iter().filter_map(|seen| comparison.gap(seen.row)).collect();
        let no_curves = self.why_no_curves(entry);
        let Curves { band, ecdf, running_times } =
            if no_curves.is_none() { self.told_curves(entry, runs) } else { Curves::default() };
        let impossible = self.samples.impossible(self.map, entry);
        let told = |effort: Option<Summary>| effort.filter(|_| no_curves != Some(NoRunningTime::NoIterations));
        EntryAnalysis {
            id: asked.id.clone(),
            label: asked.label.clone(),
            role: asked.role,
            ablation_role: self.roles.get(entry).cloned().flatten(),
            origin: origin(asked),
            objective: map.objective(entry),
            sum: map.aim(entry).and_then(|aim| aim.sum),
            needs_no_seed: comparison.needs_no_seed(entry),
            runs: runs.len(),
            expected: if asked.planner.is_some() { comparison.question.seeds.count as usize } else { runs.len() },
            with_path,
            success_interval: wilson(with_path, runs.len()),
            seeds: runs.iter().map(|seen| seen.row.task.seed).collect(),
            summary: Summary::of(&known),
            mean_interval: mean,
            median_interval: median,
            best: runs.iter().filter_map(|seen| Some(seen.row.found?.value)).reduce(f64::min),
            proven: map.reference(entry).is_proven(),
            optimal: runs.iter().filter(|seen| comparison.value(seen.row, RunMeasure::Optimal) == Some(1.0)).count(),
            impossible,
            gap_counts: counts(&gaps, self.gap_edges),
            gap: Summary::of(&gaps),
            turns: of(RunMeasure::Turns),
            iteration_of_best: of(RunMeasure::IterationOfBest),
            paths_to_best: of(RunMeasure::PathsToBest),
            effort_to_best: told(summary(runs.iter().filter_map(|seen| course::to_best(*seen, self.axis)))),
            total_effort: told(summary(runs.iter().filter_map(|seen| course::end(*seen, self.axis)))),
            published: asked.published_for(instance).map(|row| published::analyse(map, entry, row, &values)),
            values,
            no_running_time: no_curves.or_else(|| self.why_no_times(&running_times, impossible)),
            running_times: if impossible == 0 { running_times } else { Vec::new() },
            band,
            ecdf,
        }
    }

    /// Why the course of the runs tells nothing of what the curves are about.
    fn why_no_curves(&self, entry: usize) -> Option<NoRunningTime> {
        let comparison = self.samples.comparison();
        let map = &comparison.maps[self.map];
        let objective = map.objective(entry);
        if self.samples.of(self.map, entry).is_empty() {
            return Some(NoRunningTime::NoRuns);
        }
        if objective.is_none_or(|o| map.measure_of(o) != self.curve_measure) {
            return Some(NoRunningTime::OtherObjective);
        }
        (self.axis == Axis::Iterations && comparison.needs_no_seed(entry)).then_some(NoRunningTime::NoIterations)
    }

    /// Why curves tell no running times.
    fn why_no_times(&self, times: &[RunningTime], impossible: usize) -> Option<NoRunningTime> {
        if impossible > 0 {
            return Some(NoRunningTime::Impossible);
        }
        if self.targets.is_empty() {
            return Some(NoRunningTime::NoTarget);
        }
        times.iter().any(|time| time.successes > 0 && time.expected.is_none()).then_some(NoRunningTime::NoEffort)
    }

    /// An imported value reaches a target within the digits it was printed with.
    fn told_curves(&self, entry: usize, runs: &[Seen]) -> Curves {
        let comparison = self.samples.comparison();
        let within: Vec<f64> = self.targets.iter().map(|&target| target + comparison.slack(entry, target)).collect();
        let most = course::most(comparison.question.budget, self.axis);
        let mut curves = Curves::of(runs, self.axis, &within, most);
        curves.running_times.iter_mut().zip(self.targets).for_each(|(time, &target)| time.target = target);
        curves
    }
}

fn origin(asked: &Entry) -> Origin {
    match (&asked.planner, &asked.results) {
        (Some(_), _) => Origin::Planner,
        (None, Some(_)) => Origin::Results,
        (None, None) => Origin::Missing,
    }
}

fn finite(value: Option<f64>) -> Option<f64> {
    value.filter(|v| v.is_finite())
}

fn summary(values: impl Iterator<Item = f64>) -> Option<Summary> {
    Summary::of(&values.collect::<Vec<_>>())
}

/// Where the bins of a map's histogram begin: at 0, and so wide (1, 2 or 5 times a power of ten) that about a dozen of them hold 95 % of the
/// runs of every entry.
pub(super) fn gap_edges(samples: &Samples, map: usize) -> Vec<f64> {
    const BINS: usize = 12;
    let comparison = samples.comparison();
    let most_of = |entry| {
        let gaps = samples.of(map, entry).iter().filter_map(|seen| comparison.gap(seen.row)).collect();
        quantile(&sorted(gaps), 0.95)
    };
    let widest = (0..comparison.question.entries.len()).filter_map(most_of).fold(0.0, f64::max);
    let (step, per) = round_step(widest / BINS as f64);
    let bins = if widest > 0.0 { (widest * per / step) as usize + 1 } else { 1 };
    (0..=bins).map(|i| i as f64 * step / per).collect()
}

/// The smallest of 1, 2 or 5 times a power of ten that is not below `least`, as a fraction of whole numbers; 1/100 for 0.
fn round_step(least: f64) -> (f64, f64) {
    if least <= 0.0 {
        return (1.0, 100.0);
    }
    let (mut tens, mut per) = (1.0, 1e6);
    loop {
        if let Some(digit) = [1.0, 2.0, 5.0].into_iter().find(|digit| digit * tens / per >= least) {
            return (digit * tens, per);
        }
        if per > 1.0 { per /= 10.0 } else { tens *= 10.0 }
    }
}

/// How many gaps lie in each bin, a rounding below an edge counting as on it; a negative one, possible where the reference is not proven, in the first.
fn counts(gaps: &[f64], edges: &[f64]) -> Vec<u32> {
    let mut counts = vec![0; edges.len()];
    for gap in gaps {
        let bin = edges.partition_point(|edge| *edge <= gap + ROUNDING).saturating_sub(1);
        if let Some(count) = counts.get_mut(bin) {
            *count += 1;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_have_round_edges() {
        assert_eq!(round_step(0.013), (2.0, 100.0));
        assert_eq!(round_step(0.02), (2.0, 100.0));
        assert_eq!(round_step(0.0), (1.0, 100.0));
        assert_eq!(round_step(6.0), (10.0, 1.0));
        assert_eq!(round_step(1e-9), (1.0, 1e6));
        assert_eq!(counts(&[-0.1, 0.0, 0.019, 0.02, 0.04, 9.0], &[0.0, 0.02, 0.04]), [3, 1, 2]);
        assert!(counts(&[0.5], &[]).is_empty());
    }
}
