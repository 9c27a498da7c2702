//! What became of the claims, for a table.

use serde::Serialize;

use crate::comparison::claim::{Direction, Statistic};
use crate::comparison::contrast::EffectSize;
use crate::comparison::judge::JudgedClaim;
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::Question;
use crate::comparison::statistics::Difference;
use crate::comparison::verdict::Verdict;
use crate::planner::PaperReading;

/// What became of a claim on one map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum VerdictKind {
    /// The claimed direction, and certainly at least half of the claimed size.
    Reproduced,
    /// The claimed direction; its size cannot be told.
    Direction,
    /// The claimed direction, and certainly less than half of the size.
    Partly,
    /// No relevant difference.
    Equivalent,
    /// No difference is shown.
    Not,
    /// The other direction.
    Opposite,
    /// There is nothing to compare.
    CannotTell,
}

/// A claim on one map. Lengths in cells.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct VerdictLine {
    /// Its id.
    pub claim: String,
    /// The claim in words.
    pub says: String,
    /// What a reader of the verdict must know.
    pub note: String,
    /// Id of the instance.
    pub instance: String,
    /// Id of the entry that is said to differ.
    pub improved: String,
    /// Id of the entry that it is compared with.
    pub baseline: String,
    /// What is compared.
    pub measure: RunMeasure,
    /// Whether that is a share of runs, from 0 to 1.
    pub is_share: bool,
    /// Which way it is said to differ.
    pub direction: Direction,
    /// What stands for all runs and decides.
    pub statistic: Statistic,
    /// By which part of the baseline's value they are said to differ, of shares by what difference, positive as the claim says; null where
    /// no size is claimed.
    pub claimed: Option<f64>,
    /// The smallest effect that matters.
    pub relevant: f64,
    /// By how much they differ, counted alike; null where that is no number, or infinite.
    pub found: Option<f64>,
    /// The same with its intervals; null where an end of one is infinite.
    pub effect: Option<EffectSize>,
    /// What stands for the baseline's runs; null where half of them or more found no path.
    pub baseline_value: Option<f64>,
    /// What stands for the improved entry's runs; null where half of them or more found no path.
    pub improved_value: Option<f64>,
    /// Improved − baseline of the medians; null where an end of it is infinite.
    pub medians: Option<Difference>,
    /// Improved − baseline of the means over the runs that found a path, of pairs both; of running times the expected ones.
    pub means: Option<Difference>,
    /// How likely a run of the improved entry is the better one, as the claim counts better; ties half.
    pub better: Option<f64>,
    /// p of a rank test: Wilcoxon's of pairs, Mann and Whitney's of independent samples; null below 20 runs. No verdict follows from it.
    pub p: Option<f64>,
    /// Whether runs of equal seed are pairs, as of one planner with two settings; else the samples are independent.
    pub paired: bool,
    /// Pairs of runs with the same seed; 0 of independent samples.
    pub pairs: usize,
    /// Runs of the improved entry that are compared; of pairs those that have one.
    pub improved_runs: usize,
    /// Runs of the baseline that are.
    pub baseline_runs: usize,
    /// What follows.
    pub verdict: VerdictKind,
    /// Why nothing can be told; empty where something can.
    pub why: String,
    /// The reading of the publication that the claim is about; absent where it names none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub reading: Option<PaperReading>,
}

/// A judged claim for a table.
pub(super) fn line(question: &Question, c: &JudgedClaim) -> Option<VerdictLine> {
    let (claim, instance) = (question.claims.get(c.claim)?, question.instances.get(c.instance)?);
    let finite = |v: Option<f64>| v.filter(|v| v.is_finite());
    let (verdict, why) = kind(c.verdict);
    Some(VerdictLine {
        claim: claim.id.clone(),
        says: claim.says.clone(),
        note: claim.note.clone(),
        instance: instance.id.clone(),
        improved: claim.improved.clone(),
        baseline: claim.baseline.clone(),
        measure: claim.measure,
        is_share: claim.measure.is_share(),
        direction: claim.direction,
        statistic: c.statistic,
        claimed: c.claimed,
        relevant: c.relevant,
        found: finite(c.effect.map(|e| e.value)),
        effect: c.effect.filter(EffectSize::is_finite),
        baseline_value: finite(c.baseline),
        improved_value: finite(c.improved),
        medians: c.medians.filter(is_finite),
        means: c.means.filter(is_finite),
        better: c.better,
        p: c.p,
        paired: c.paired,
        pairs: if c.paired { c.runs[0] } else { 0 },
        improved_runs: c.runs[0],
        baseline_runs: c.runs[1],
        verdict,
        why: why.into(),
        reading: claim.reading,
    })
}

fn is_finite(d: &Difference) -> bool {
    d.value.is_finite() && d.low.is_finite() && d.high.is_finite()
}

fn kind(verdict: Verdict) -> (VerdictKind, &'static str) {
    match verdict {
        Verdict::Reproduced => (VerdictKind::Reproduced, ""),
        Verdict::Direction => (VerdictKind::Direction, ""),
        Verdict::Partly => (VerdictKind::Partly, ""),
        Verdict::Equivalent => (VerdictKind::Equivalent, ""),
        Verdict::Not => (VerdictKind::Not, ""),
        Verdict::Opposite => (VerdictKind::Opposite, ""),
        Verdict::CannotTell(why) => (VerdictKind::CannotTell, why.words()),
    }
}
