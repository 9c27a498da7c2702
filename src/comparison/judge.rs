//! Claims against runs, map by map: the difference that was measured, how sure it is, and the verdict. The rule is stated in
//! docs/methodology.md; `over_maps` tells of all maps together.

use super::Comparison;
use super::claim::{Claim, Direction, Statistic};
use super::contrast::{Contrast, EffectSize, TwoSamples, contrast};
use super::facts::UnfitMap;
use super::gap::is_below;
use super::inference::{mann_whitney, wilcoxon};
use super::intervals::Intervals;
use super::maps::Map;
use super::measure::RunMeasure;
use super::running_time::{Spending, expected, may_be_chance, spendings};
use super::samples::{Samples, paired, without_seeds};
use super::statistics::{Difference, a12, mean, median_of};
use super::verdict::{Verdict, WhyNot, by_interval};

/// Fewest runs of an entry, or pairs of runs, from which a verdict is drawn.
pub const FEWEST_RUNS: usize = 30;

/// Of a first stage: this share of the runs must go on to better paths.
pub const NEARLY_ALL: f64 = 0.95;

/// From this share of optimal runs on, a baseline leaves no room for shorter paths.
pub const NO_ROOM: f64 = 0.95;

/// A claim on one map, measured.
#[derive(Debug, Clone, PartialEq)]
pub struct JudgedClaim {
    /// Which claim of the question.
    pub claim: usize,
    /// Which instance.
    pub instance: usize,
    /// By how much the entries are said to differ, in the unit of `effect`; none where no size is claimed.
    pub claimed: Option<f64>,
    /// The smallest effect that matters.
    pub relevant: f64,
    /// Whether runs of equal seed are pairs; else the samples are independent.
    pub paired: bool,
    /// Runs of the improved entry and of the baseline; of pairs those that have one.
    pub runs: [usize; 2],
    /// Those that the means are over: with a finite value, of pairs both.
    pub finite: [usize; 2],
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
    /// Improved − baseline of the means over the finite runs; of running times the expected ones.
    pub means: Option<Difference>,
    /// By which part of the baseline's value they differ, positive as the claim says; of shares the difference. None where that is no number.
    pub effect: Option<EffectSize>,
    /// How likely a run of the improved entry is the better one, as the claim counts better; ties half.
    pub better: Option<f64>,
    /// Of a rank test: Wilcoxon's of pairs, Mann and Whitney's of independent samples. No verdict follows from it.
    pub p: Option<f64>,
    /// What follows.
    pub verdict: Verdict,
}

/// Compares the runs of every claim on every map that it is about.
pub fn judge(samples: &Samples, intervals: &mut Intervals, unfit: &[UnfitMap]) -> Vec<JudgedClaim> {
    let question = &samples.comparison().question;
    let about = |claim: usize| {
        let places = question.instances.iter().enumerate();
        places.filter(move |(_, i)| question.claims[claim].is_about(i)).map(move |(instance, _)| (claim, instance))
    };
    let all = (0..question.claims.len()).flat_map(about);
    let judged = all.map(|(claim, instance)| compare(samples, intervals, claim, instance));
    let contradicts = |c: &JudgedClaim| {
        let here = unfit.iter().filter(|map| map.instance == question.instances[c.instance].id);
        here.into_iter().any(|map| map.concerns(&question.claims[c.claim]))
    };
    let fitting = |c: JudgedClaim| match contradicts(&c) {
        true => JudgedClaim { verdict: Verdict::CannotTell(WhyNot::Contradicted), ..c },
        false => c,
    };
    judged.map(fitting).collect()
}

fn compare(samples: &Samples, intervals: &mut Intervals, index: usize, instance: usize) -> JudgedClaim {
    let question = &samples.comparison().question;
    let (claim, place) = (&question.claims[index], &question.instances[instance]);
    let entries = [&claim.improved, &claim.baseline].map(|id| question.entries.iter().position(|e| e.id == *id));
    let nothing = JudgedClaim {
        claim: index,
        instance,
        claimed: question.claimed_size(claim, place).and_then(|size| in_unit(claim.measure, size, None)),
        relevant: claim.relevant(),
        paired: false,
        runs: [0, 0],
        finite: [0, 0],
        baseline_optimal: None,
        statistic: claim.statistic(true),
        baseline: None,
        improved: None,
        medians: None,
        means: None,
        effect: None,
        better: None,
        p: None,
        verdict: Verdict::CannotTell(WhyNot::NotRun),
    };
    let [Some(improved), Some(baseline)] = entries else { return nothing };
    let entries = [improved, baseline];
    let name = format!("{}/{}", claim.id, place.id);
    if entries.iter().any(|&entry| samples.of(instance, entry).is_empty()) {
        return of_one(samples, nothing, claim, entries);
    }
    let judged = match claim.measure {
        RunMeasure::RunningTime => match spendings(samples, claim, instance, entries) {
            Ok(both) => of_times(nothing, claim, intervals, &name, &both),
            Err(why) => JudgedClaim { verdict: Verdict::CannotTell(why), ..nothing },
        },
        _ => of_values(samples, nothing, claim, intervals, &name, entries),
    };
    if is_same_as_before(samples.comparison(), claim, instance) {
        return JudgedClaim { verdict: Verdict::CannotTell(WhyNot::SameMap), ..judged };
    }
    if entries.iter().any(|&entry| samples.impossible(instance, entry) > 0) {
        return JudgedClaim { verdict: Verdict::CannotTell(WhyNot::Impossible), ..judged };
    }
    if claim.measure == RunMeasure::IterationOfBest && entries.iter().any(|&entry| ends_in_first_stage(samples, instance, entry))
    {
        return JudgedClaim { verdict: Verdict::CannotTell(WhyNot::FirstStage), ..judged };
    }
    judged
}

/// Whether the claim is about an instance before this one whose map is the same: what is one map counts once.
fn is_same_as_before(comparison: &Comparison, claim: &Claim, instance: usize) -> bool {
    let before = comparison.question.instances.iter().zip(&comparison.maps).take(instance);
    before.into_iter().any(|(place, map)| claim.is_about(place) && map.is_same(&comparison.maps[instance]))
}

/// Whether more than a few runs of an entry with a first stage tell no iteration after it: the others would be a choice of the lucky ones.
fn ends_in_first_stage(samples: &Samples, instance: usize, entry: usize) -> bool {
    let told = samples.values(instance, entry, RunMeasure::IterationOfBest).len();
    let has_first_stage = samples.comparison().question.entries[entry].first_stage.is_some();
    has_first_stage && (told as f64) < NEARLY_ALL * samples.of(instance, entry).len() as f64
}

/// The values of a claim's two entries as they are compared: what one has not printed breaks no tie, and a run without a path is never the
/// better one. Of one planner with two settings runs of equal seed are pairs; two planners draw from different streams.
fn values_of(samples: &Samples, claim: &Claim, instance: usize, entries: [usize; 2]) -> [Vec<(u32, f64)>; 2] {
    let comparison = samples.comparison();
    let compared = |(seed, value)| {
        let value = comparison.in_common_digits(&entries, claim.measure, value);
        (seed, worst_if_missing(claim.direction, value))
    };
    entries.map(|entry| samples.values(instance, entry, claim.measure).into_iter().map(compared).collect())
}

/// What stands for the only entry that has runs.
fn of_one(samples: &Samples, nothing: JudgedClaim, claim: &Claim, entries: [usize; 2]) -> JudgedClaim {
    let values = values_of(samples, claim, nothing.instance, entries).map(|sample| without_seeds(&sample));
    let every_run_counts = values.iter().flatten().all(|v| v.is_finite());
    let statistic = claim.statistic(every_run_counts);
    let [improved, baseline] = values.map(|sample| statistic.of(&sample));
    JudgedClaim { statistic, improved, baseline, ..nothing }
}

fn of_values(
    samples: &Samples,
    nothing: JudgedClaim,
    claim: &Claim,
    intervals: &mut Intervals,
    name: &str,
    entries: [usize; 2],
) -> JudgedClaim {
    let comparison = samples.comparison();
    let [a, b] = values_of(samples, claim, nothing.instance, entries);
    let all = [without_seeds(&a), without_seeds(&b)];
    let both = if samples.are_paired(entries) {
        let (improved, baseline) = paired(&a, &b).into_iter().unzip();
        TwoSamples { improved, baseline, paired: true }
    } else {
        TwoSamples { improved: all[0].clone(), baseline: all[1].clone(), paired: false }
    };
    let finite = both.only(f64::is_finite);
    let statistic = claim.statistic(finite.runs() == both.runs());
    let mut drawn = |of: &TwoSamples<f64>, statistic: Statistic| of_statistic(intervals, claim, name, of, statistic);
    let (medians, means) = (drawn(&both, Statistic::Median), drawn(&finite, Statistic::Mean));
    let (counted, deciding) = if statistic == Statistic::Mean { (&finite, means) } else { (&both, medians) };
    let baseline = statistic.of(&counted.baseline).or_else(|| statistic.of(&all[1]));
    let bound = is_bound(&comparison.maps[nothing.instance], claim.measure, entries);
    let optimal = samples.values(nothing.instance, entries[1], RunMeasure::Optimal);
    let size = comparison.question.claimed_size(claim, &comparison.question.instances[nothing.instance]);
    let judged = JudgedClaim {
        claimed: size.and_then(|size| in_unit(claim.measure, size, baseline)),
        paired: both.paired,
        runs: both.runs(),
        finite: finite.runs(),
        baseline_optimal: bound.then(|| mean(&without_seeds(&optimal))).flatten(),
        statistic,
        baseline,
        improved: statistic.of(&counted.improved).or_else(|| statistic.of(&all[0])),
        medians: medians.map(|c| c.difference),
        means: means.map(|c| c.difference),
        effect: deciding.filter(|_| baseline.is_some_and(f64::is_finite)).map(|c| c.effect.signed(claim.direction)),
        better: better(claim.direction, &all[0], &all[1]),
        p: rank_test(&both),
        ..nothing
    };
    let verdict = verdict(claim, &judged);
    JudgedClaim { verdict, ..judged }
}

fn of_statistic(
    intervals: &mut Intervals,
    claim: &Claim,
    name: &str,
    of: &TwoSamples<f64>,
    statistic: Statistic,
) -> Option<Contrast> {
    let kind = format!("{statistic:?} of {:?}, paired: {}", claim.measure, of.paired);
    let told = [of.improved.len() as f64].into_iter().chain(of.improved.iter().chain(&of.baseline).copied());
    let by: fn(&mut [f64]) -> Option<f64> = match statistic {
        Statistic::Median => median_of,
        Statistic::Mean => |sample| mean(sample),
    };
    intervals.contrast(&kind, name, told, || contrast(of, claim.measure, name, by))
}

fn of_times(
    nothing: JudgedClaim,
    claim: &Claim,
    intervals: &mut Intervals,
    name: &str,
    both: &TwoSamples<Spending>,
) -> JudgedClaim {
    let runs = both.runs();
    let (improved, baseline) = (expected(&both.improved), expected(&both.baseline));
    let told = both.improved.iter().chain(&both.baseline).flat_map(|run| [run.spent, f64::from(u8::from(run.reached))]);
    let told = [runs[0] as f64].into_iter().chain(told);
    let drawn = intervals.contrast("expected", name, told, || contrast(both, claim.measure, name, |drawn| expected(drawn)));
    let certain = |effect: EffectSize| if may_be_chance(both) { effect.to_nothing() } else { effect };
    let judged = JudgedClaim {
        runs,
        finite: runs,
        statistic: Statistic::Mean,
        improved,
        baseline,
        means: drawn.map(|c| c.difference),
        effect: drawn.map(|c| certain(c.effect.signed(claim.direction))),
        ..nothing
    };
    let verdict = verdict(claim, &judged);
    JudgedClaim { verdict, ..judged }
}

/// A claimed size is a part of the baseline's value; the effect of a share is a difference, which is none without that value.
fn in_unit(measure: RunMeasure, size: f64, baseline: Option<f64>) -> Option<f64> {
    if measure.is_share() { baseline.map(|share| share * size) } else { Some(size) }
}

fn rank_test(of: &TwoSamples<f64>) -> Option<f64> {
    let test = if of.paired {
        wilcoxon(&of.improved.iter().copied().zip(of.baseline.iter().copied()).collect::<Vec<_>>())
    } else {
        mann_whitney(&of.improved, &of.baseline)
    };
    test.map(|test| test.p)
}

/// Whether the baseline's optimum is one by the claim's measure, and no path of the improved entry can have less: a polyline is shorter than
/// the shortest path of steps, and the path of the smallest V need not be the shortest one.
fn is_bound(map: &Map, measure: RunMeasure, entries: [usize; 2]) -> bool {
    let best = |entry: usize| {
        map.objective(entry).filter(|o| map.measure_of(*o) == measure)?;
        map.reference(entry).value()
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

/// The rule of docs/methodology.md, of two entries that have runs, none of them impossible.
fn verdict(claim: &Claim, c: &JudgedClaim) -> Verdict {
    let cannot = Verdict::CannotTell;
    let is_time = claim.measure == RunMeasure::RunningTime;
    if c.paired && c.runs[0] == 0 {
        return cannot(WhyNot::NoCommonSeed);
    }
    if !is_time && c.baseline.is_some_and(f64::is_infinite) {
        return cannot(WhyNot::NoBaseline);
    }
    let counted = if c.statistic == Statistic::Mean { c.finite } else { c.runs };
    let Some(effect) = c.effect.filter(|_| counted.into_iter().all(|runs| runs >= FEWEST_RUNS)) else {
        return cannot(WhyNot::TooFewRuns);
    };
    if has_no_room(claim, c) {
        return cannot(WhyNot::NoRoom);
    }
    by_interval(&effect, c.claimed, c.relevant)
}

/// Where no path can be shorter than the baseline's, nothing is told of who is: whatever came out, so that no outcome chooses its maps.
fn has_no_room(claim: &Claim, c: &JudgedClaim) -> bool {
    let is_of_length = matches!(claim.measure, RunMeasure::Length | RunMeasure::Cost);
    is_of_length && claim.direction == Direction::Less && c.baseline_optimal.is_some_and(|share| share >= NO_ROOM)
}

#[cfg(test)]
mod tests;
