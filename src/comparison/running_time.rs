//! The expected running times of two entries to one target, as a claim compares them.

use super::claim::Claim;
use super::contrast::TwoSamples;
use super::course::{Course, most};
use super::samples::Samples;
use super::statistics::wilson;
use super::verdict::WhyNot;

/// What a run has spent until it reached the target, or until its end without it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spending {
    pub spent: f64,
    pub reached: bool,
}

/// Of the runs of two entries on a map; independent, also of one planner with two settings.
pub(super) fn spendings(
    samples: &Samples,
    claim: &Claim,
    instance: usize,
    entries: [usize; 2],
) -> Result<TwoSamples<Spending>, WhyNot> {
    let map = &samples.comparison().maps[instance];
    let aims = entries.map(|entry| map.aim(entry));
    let measures = aims.map(|aim| aim.map(|aim| (map.measure_of(aim.objective), aim.sum)));
    let (measure, _) = measures[0].filter(|_| measures[0] == measures[1]).ok_or(WhyNot::OtherObjective)?;
    // Two colonies that go by steps need not come near to what polylines can reach.
    let best = match aims {
        [Some(one), Some(other)] if one == other => samples.best_like(instance, entries[0]),
        _ => samples.best_known(instance, measure),
    };
    let target = best.ok_or(WhyNot::NoTarget)? * (1.0 + claim.target());
    let [improved, baseline] = entries.map(|entry| of_entry(samples, claim, instance, entry, target));
    let both = TwoSamples { improved: improved?, baseline: baseline?, paired: false };
    if [&both.improved, &both.baseline].into_iter().all(|runs| hits(runs) == 0) {
        return Err(WhyNot::NeitherReaches);
    }
    Ok(both)
}

fn of_entry(samples: &Samples, claim: &Claim, instance: usize, entry: usize, target: f64) -> Result<Vec<Spending>, WhyNot> {
    let comparison = samples.comparison();
    let (axis, within) = (claim.axis(), target + comparison.slack(entry, target));
    let most = most(comparison.question.budget, axis);
    let spending = |seen| {
        let course = Course::of(seen, axis, most)?;
        Some(Spending { spent: course.spent(within)?, reached: course.hit(within).is_some() })
    };
    let all: Option<Vec<Spending>> = samples.of(instance, entry).iter().map(|&seen| spending(seen)).collect();
    all.ok_or(WhyNot::NoEffort)
}

fn hits(runs: &[Spending]) -> usize {
    runs.iter().filter(|run| run.reached).count()
}

/// The effort of all runs divided by those that reach the target: infinite where none does. None of no runs.
pub(super) fn expected(runs: &[Spending]) -> Option<f64> {
    let (total, hits) = (runs.iter().map(|run| run.spent).sum::<f64>(), hits(runs));
    (!runs.is_empty()).then(|| if hits > 0 { total / hits as f64 } else { f64::INFINITY })
}

/// Whether one of the two never reaches the target, and the other one so seldom that it may be chance: no resample of nothing but failures
/// has a hit, so that the bootstrap does not tell.
pub(super) fn may_be_chance(of: &TwoSamples<Spending>) -> bool {
    let counts = [&of.improved, &of.baseline].map(|runs| (hits(runs), runs.len()));
    let [a, b] = counts.map(|(hits, runs)| wilson(hits, runs));
    counts.iter().any(|(hits, _)| *hits == 0) && a[0] <= b[1] && b[0] <= a[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn runs(of: &[(f64, bool)]) -> Vec<Spending> {
        of.iter().map(|&(spent, reached)| Spending { spent, reached }).collect()
    }

    #[test]
    fn expected_by_hand() {
        // (10 + 100 + 30) / 2.
        assert_eq!(expected(&runs(&[(10.0, true), (100.0, false), (30.0, true)])), Some(70.0));
        assert_eq!((expected(&runs(&[(9.0, false)])), expected(&[])), (Some(f64::INFINITY), None));
    }

    #[test]
    fn a_few_hits_against_none_may_be_chance() {
        let of = |hits: usize| (0..100).map(|i| Spending { spent: 1.0, reached: i < hits }).collect::<Vec<_>>();
        let both = |improved, baseline| TwoSamples { improved: of(improved), baseline: of(baseline), paired: false };
        // Wilson: 0 of 100 is at most 3.7 %; 8 of 100 is at least 4.1 %, 7 of 100 at least 3.4 %.
        assert_eq!([1, 7, 8, 50].map(|hits| may_be_chance(&both(hits, 0))), [true, true, false, false]);
        assert_eq!([7, 8].map(|hits| may_be_chance(&both(0, hits))), [true, false]);
        // Where both reach it, the bootstrap tells.
        assert!(!may_be_chance(&both(1, 2)));
    }
}
