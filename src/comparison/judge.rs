//! Claims against runs: the difference that was measured, how sure it is, and the verdict. The rule is stated in docs/methodology.md.

use super::claim::{Claim, Direction, Statistic};
use super::gap::is_below;
use super::intervals::Intervals;
use super::maps::Map;
use super::measure::RunMeasure;
use super::samples::{Samples, paired, without_seeds};
use super::statistics::{Difference, a12, mean};

/// Fewest pairs of runs from which a verdict is drawn.
pub const MIN_PAIRS: usize = 30;

/// The part of the claimed size that must be there for a claim to count as reproduced.
pub const ENOUGH: f64 = 0.5;

/// From this share of optimal runs on, a baseline leaves no room for shorter paths.
pub const NO_ROOM: f64 = 0.95;

/// What became of a claim on one map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The interval excludes 0 in the claimed direction, and at least half of the claimed size is there.
    Reproduced,
    /// The interval excludes 0 in the claimed direction, but the difference is smaller.
    Partly,
    /// The interval does not exclude 0.
    Not,
    /// The interval excludes 0 in the other direction: not reproduced, either.
    Opposite,
    /// There is nothing to compare, for this reason.
    CannotTell(WhyNot),
}

/// Why nothing can be told of a claim on a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WhyNot {
    /// Some of their runs are better than the proven optimum.
    Impossible,
    /// There are runs of both, and no pair.
    NoCommonSeed,
    /// There are no runs of one of them.
    NotRun,
    /// The baseline has no value to compare with.
    NoBaseline,
    /// There are fewer than [`MIN_PAIRS`] pairs.
    TooFewRuns,
    /// No path can be shorter than the baseline's.
    NoRoom,
}

impl WhyNot {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Impossible => "runs of one of the two are impossible on this map",
            Self::NoCommonSeed => "no two runs share a seed",
            Self::NotRun => "one of the two cannot be run",
            Self::NoBaseline => "the baseline finds no path in half of its runs or more",
            Self::TooFewRuns => "too few runs to compare",
            Self::NoRoom => "nearly all of the baseline's runs are optimal already",
        }
    }
}

/// A claim on one map, measured.
#[derive(Debug, Clone, PartialEq)]
pub struct JudgedClaim {
    /// Which claim of the question.
    pub claim: usize,
    /// Which instance.
    pub instance: usize,
    /// By which part of the baseline's value the entries are said to differ; none where no size is claimed.
    pub claimed: Option<f64>,
    /// Pairs of runs with the same seed.
    pub pairs: usize,
    /// Pairs of which both runs have a finite value: those that the means are over.
    pub finite_pairs: usize,
    /// Share of the baseline's runs that found a proven optimum; none where the improved entry may be better by the claim's measure even so.
    pub baseline_optimal: Option<f64>,
    /// What decides.
    pub statistic: Statistic,
    /// What stands for the baseline's runs, by this statistic; infinite where half of them or more found no path.
    pub baseline: Option<f64>,
    /// What stands for the improved entry's runs.
    pub improved: Option<f64>,
    /// Improved − baseline of the medians.
    pub medians: Option<Difference>,
    /// Improved − baseline of the means over the finite pairs.
    pub means: Option<Difference>,
    /// How likely a run of the improved entry is the better one, as the claim counts better; ties half.
    pub better: Option<f64>,
    /// By the claim's statistic.
    pub verdict: Verdict,
}

impl JudgedClaim {
    /// By which part of the baseline's value the entries differ, positive as the claim says. None where the baseline is 0 or infinite.
    pub fn size(&self, direction: Direction) -> Option<f64> {
        let (improved, baseline) = (self.improved?, self.baseline?);
        let usable = baseline.is_finite() && baseline > 0.0 && improved.is_finite();
        usable.then(|| direction.signed(improved - baseline) / baseline)
    }

    /// The difference that decides.
    fn difference(&self) -> Option<Difference> {
        match self.statistic {
            Statistic::Median => self.medians,
            Statistic::Mean => self.means,
        }
    }
}

/// Compares the runs of every claim on every map that it is about.
pub fn judge(samples: &Samples, intervals: &mut Intervals) -> Vec<JudgedClaim> {
    let question = &samples.comparison().question;
    let about = |claim: usize| {
        let places = question.instances.iter().enumerate();
        places.filter(move |(_, i)| question.claims[claim].is_about(&i.id)).map(move |(instance, _)| (claim, instance))
    };
    let all = (0..question.claims.len()).flat_map(about);
    all.map(|(claim, instance)| compare(samples, intervals, claim, instance)).collect()
}

fn compare(samples: &Samples, intervals: &mut Intervals, index: usize, instance: usize) -> JudgedClaim {
    let question = &samples.comparison().question;
    let (claim, place) = (&question.claims[index], &question.instances[instance].id);
    let of = |id: &String| question.entries.iter().position(|e| e.id == *id);
    let values = |id: &String, measure| {
        let entry = of(id);
        entry.map_or_else(Vec::new, |entry| samples.values(instance, entry, measure))
    };
    let both: Vec<usize> =
        (0..question.entries.len()).filter(|&e| [&claim.improved, &claim.baseline].contains(&&question.entries[e].id)).collect();
    let sample = |id: &String| {
        let common = |value| samples.comparison().in_common_digits(&both, claim.measure, value);
        let worst = |(seed, value)| (seed, worst_if_missing(claim.direction, common(value)));
        values(id, claim.measure).into_iter().map(worst).collect::<Vec<_>>()
    };
    let (improved, baseline) = (sample(&claim.improved), sample(&claim.baseline));
    let pairs = paired(&improved, &baseline);
    let (improved, baseline) = (without_seeds(&improved), without_seeds(&baseline));
    let finite: Vec<(f64, f64)> = pairs.iter().copied().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
    let statistic = claim.statistic(finite.len() == pairs.len());
    let counted = if statistic == Statistic::Mean { &finite } else { &pairs };
    let (first, second): (Vec<f64>, Vec<f64>) = counted.iter().copied().unzip();
    let name = format!("{}/{place}", claim.id);
    let bound = is_bound(&samples.comparison().maps[instance], claim.measure, [&claim.improved, &claim.baseline].map(of));
    let judged = JudgedClaim {
        claim: index,
        instance,
        claimed: question.claimed_size(claim, place),
        pairs: pairs.len(),
        finite_pairs: finite.len(),
        baseline_optimal: bound.then(|| mean(&without_seeds(&values(&claim.baseline, RunMeasure::Optimal)))).flatten(),
        statistic,
        improved: statistic.of(&first).or_else(|| statistic.of(&improved)),
        baseline: statistic.of(&second).or_else(|| statistic.of(&baseline)),
        medians: intervals.median_difference(&pairs, &name),
        means: intervals.mean_difference(&finite, &name),
        better: better(claim.direction, &improved, &baseline),
        verdict: Verdict::Not,
    };
    let is_impossible = |id| of(id).is_some_and(|entry| samples.impossible(instance, entry) > 0);
    let verdict = if [&claim.improved, &claim.baseline].into_iter().any(is_impossible) {
        Verdict::CannotTell(WhyNot::Impossible)
    } else {
        verdict(claim, &judged)
    };
    JudgedClaim { verdict, ..judged }
}

/// Whether the baseline's optimum is one by the claim's measure, and no path of the improved entry can have less: a polyline is shorter than
/// the shortest path of steps, and the path of the smallest V need not be the shortest one.
fn is_bound(map: &Map, measure: RunMeasure, entries: [Option<usize>; 2]) -> bool {
    let best = |entry: Option<usize>| {
        let objective = map.objective(entry?).filter(|o| RunMeasure::of(*o) == measure)?;
        map.yardsticks().iter().find(|y| y.objective == objective)?.reference.value()
    };
    let [improved, baseline] = entries.map(best);
    improved.zip(baseline).is_some_and(|(improved, baseline)| !is_below(improved, baseline))
}

/// A run without a path is never the better one, also where more is better.
fn worst_if_missing(direction: Direction, value: f64) -> f64 {
    if value.is_infinite() && direction == Direction::More { f64::NEG_INFINITY } else { value }
}

fn better(direction: Direction, improved: &[f64], baseline: &[f64]) -> Option<f64> {
    match direction {
        Direction::More => a12(improved, baseline),
        Direction::Less => a12(baseline, improved),
    }
}

/// The rule of docs/methodology.md.
fn verdict(claim: &Claim, c: &JudgedClaim) -> Verdict {
    if c.pairs == 0 && c.improved.is_some() && c.baseline.is_some() {
        return Verdict::CannotTell(WhyNot::NoCommonSeed);
    }
    if c.pairs == 0 {
        return Verdict::CannotTell(WhyNot::NotRun);
    }
    if c.baseline.is_some_and(f64::is_infinite) {
        return Verdict::CannotTell(WhyNot::NoBaseline);
    }
    let counted = if c.statistic == Statistic::Mean { c.finite_pairs } else { c.pairs };
    let Some(difference) = c.difference().filter(|_| counted >= MIN_PAIRS) else {
        return Verdict::CannotTell(WhyNot::TooFewRuns);
    };
    let ends = [difference.low, difference.high].map(|d| claim.direction.signed(d));
    if ends[0].max(ends[1]) < 0.0 {
        return Verdict::Opposite;
    }
    if ends[0].min(ends[1]) <= 0.0 {
        return without_difference(claim, c);
    }
    match (c.claimed, c.size(claim.direction)) {
        (None, _) => Verdict::Reproduced,
        (Some(claimed), Some(size)) if size >= ENOUGH * claimed => Verdict::Reproduced,
        _ => Verdict::Partly,
    }
}

/// Where no path can be shorter than the baseline's, finding none says nothing.
fn without_difference(claim: &Claim, c: &JudgedClaim) -> Verdict {
    let no_room = matches!(claim.measure, RunMeasure::Length | RunMeasure::Cost)
        && c.baseline_optimal.is_some_and(|share| share >= NO_ROOM);
    if no_room { Verdict::CannotTell(WhyNot::NoRoom) } else { Verdict::Not }
}

#[cfg(test)]
mod tests;
