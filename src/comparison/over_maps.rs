//! A claim over all maps that it is about: on how many it holds, and what the median of the maps' effects is. One map is one case: maps are
//! drawn before anything runs on them, and how many seeds run on each only makes each case surer.

use serde::{Serialize, Serializer};

use super::claim::{Claim, Direction};
use super::contrast::EffectSize;
use super::judge::JudgedClaim;
use super::measure::RunMeasure;
use super::question::Question;
use super::signs::{median_within, sign_test};
use super::statistics::{CONFIDENCE, quantile, sorted, wilson};
use super::verdict::{Verdict, by_interval};
use crate::planner::PaperReading;

/// Fewest maps of which a verdict over maps is drawn: of fewer no interval of a median holds at 95 %.
pub const FEWEST_MAPS: usize = 6;

/// From so many maps and such a share of them on, both for and against, a claim depends on the map.
pub const SEVERAL: (usize, f64) = (2, 0.1);

/// The confidence of the interval by which two one-sided tests at 5 % go.
const EQUIVALENCE: f64 = 0.9;

/// What became of a claim over maps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum OverallVerdict {
    /// As of one map, of the median effect and its interval over maps.
    Reproduced,
    /// As of one map.
    Direction,
    /// As of one map.
    Partly,
    /// As of one map.
    Equivalent,
    /// As of one map.
    Not,
    /// As of one map.
    Opposite,
    /// Several maps are certainly and relevantly for it, and several against it.
    DependsOnMap,
    /// There are fewer than [`FEWEST_MAPS`].
    CannotTell,
}

impl OverallVerdict {
    /// The verdict on one map that is like it.
    pub fn as_of_one(self) -> Option<Verdict> {
        match self {
            Self::Reproduced => Some(Verdict::Reproduced),
            Self::Direction => Some(Verdict::Direction),
            Self::Partly => Some(Verdict::Partly),
            Self::Equivalent => Some(Verdict::Equivalent),
            Self::Not => Some(Verdict::Not),
            Self::Opposite => Some(Verdict::Opposite),
            Self::DependsOnMap | Self::CannotTell => None,
        }
    }
}

/// On how many maps a claim came to what.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct VerdictCounts {
    /// With the claimed size, if one is claimed.
    pub reproduced: usize,
    /// In the claimed direction, of a size that cannot be told.
    pub direction: usize,
    /// In the claimed direction, and certainly smaller.
    pub partly: usize,
    /// No relevant difference.
    pub equivalent: usize,
    /// No difference shown.
    pub not: usize,
    /// In the other direction.
    pub opposite: usize,
    /// There is nothing to compare: these count in nothing else.
    pub cannot_tell: usize,
}

impl VerdictCounts {
    pub(super) fn of<'a>(judged: impl Iterator<Item = &'a JudgedClaim>) -> Self {
        let mut counts = Self::default();
        for c in judged {
            let count = match c.verdict {
                Verdict::Reproduced => &mut counts.reproduced,
                Verdict::Direction => &mut counts.direction,
                Verdict::Partly => &mut counts.partly,
                Verdict::Equivalent => &mut counts.equivalent,
                Verdict::Not => &mut counts.not,
                Verdict::Opposite => &mut counts.opposite,
                Verdict::CannotTell(_) => &mut counts.cannot_tell,
            };
            *count += 1;
        }
        counts
    }

    /// Certainly and relevantly in the claimed direction.
    pub fn better(&self) -> usize {
        self.reproduced + self.direction + self.partly
    }
}

/// A claim over maps. Effects are parts of the baseline's value, of shares differences, positive as the claim says.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct OverMaps {
    /// Its id.
    pub claim: String,
    /// The claim in words.
    pub says: String,
    /// Id of the entry that is said to differ.
    pub improved: String,
    /// Id of the entry that it is compared with.
    pub baseline: String,
    /// What is compared.
    pub measure: RunMeasure,
    /// Whether that is a share of runs.
    pub is_share: bool,
    /// Which way it is said to differ.
    pub direction: Direction,
    /// The smallest effect that matters.
    pub relevant: f64,
    /// The median of the sizes that are claimed for the maps; null where one of them has none.
    pub claimed: Option<f64>,
    /// Maps of which something can be told.
    pub maps: usize,
    /// On how many of all its maps it came to what.
    pub counts: VerdictCounts,
    /// Of the maps of which something can be told, those that are certainly and relevantly as the claim says.
    pub better: usize,
    /// What their share may be: Wilson's interval at 95 %.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
    pub share_interval: [f64; 2],
    /// Maps with an effect above 0, however small or unsure.
    pub above: usize,
    /// Below 0.
    pub below: usize,
    /// Of exactly 0: the sign test leaves them out.
    pub level: usize,
    /// Two-sided p of the sign test; null where no map has a sign.
    pub sign_p: Option<f64>,
    /// The median of the maps' effects; null where it is infinite, or there is no map.
    #[serde(serialize_with = "finite")]
    pub median: Option<f64>,
    /// Lower end of its interval, an effect of one of the maps; null where there are fewer than six maps, or it is infinite.
    #[serde(serialize_with = "finite")]
    pub low: Option<f64>,
    /// Upper end of that.
    #[serde(serialize_with = "finite")]
    pub high: Option<f64>,
    /// At which confidence the interval holds, at least 0.95; null without one.
    pub confidence: Option<f64>,
    /// What follows.
    pub verdict: OverallVerdict,
    /// The reading of the publication that the claim is about; absent where it names none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub reading: Option<PaperReading>,
}

fn finite<S: Serializer>(value: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
    value.filter(|v| v.is_finite()).serialize(to)
}

/// Every claim over its maps.
pub(super) fn over_maps(question: &Question, judged: &[JudgedClaim]) -> Vec<OverMaps> {
    let of = |(index, claim): (usize, &Claim)| {
        let all: Vec<&JudgedClaim> = judged.iter().filter(|c| c.claim == index).collect();
        one(claim, &all)
    };
    question.claims.iter().enumerate().map(of).collect()
}

fn one(claim: &Claim, all: &[&JudgedClaim]) -> OverMaps {
    let counts = VerdictCounts::of(all.iter().copied());
    let told = || all.iter().filter(|c| !matches!(c.verdict, Verdict::CannotTell(_)));
    let effects = sorted(told().filter_map(|c| Some(c.effect?.value)).collect());
    let sizes: Option<Vec<f64>> = told().map(|c| c.claimed).collect();
    let claimed = sizes.and_then(|sizes| quantile(&sorted(sizes), 0.5));
    let [above, below] = [1.0, -1.0].map(|sign| effects.iter().filter(|v| **v * sign > 0.0).count());
    let (maps, median) = (effects.len(), quantile(&effects, 0.5));
    let within = median_within(&effects, CONFIDENCE);
    OverMaps {
        claim: claim.id.clone(),
        says: claim.says.clone(),
        improved: claim.improved.clone(),
        baseline: claim.baseline.clone(),
        measure: claim.measure,
        is_share: claim.measure.is_share(),
        direction: claim.direction,
        relevant: claim.relevant(),
        claimed,
        maps,
        counts,
        better: counts.better(),
        share_interval: wilson(counts.better(), maps),
        above,
        below,
        level: maps - above - below,
        sign_p: sign_test(above, below),
        median,
        low: within.map(|(ends, _)| ends[0]),
        high: within.map(|(ends, _)| ends[1]),
        confidence: within.map(|(_, holds)| holds),
        verdict: verdict(&effects, &counts, claimed, claim.relevant()),
        reading: claim.reading,
    }
}

fn verdict(effects: &[f64], counts: &VerdictCounts, claimed: Option<f64>, relevant: f64) -> OverallVerdict {
    let Some(effect) = of_median(effects).filter(|_| effects.len() >= FEWEST_MAPS) else {
        return OverallVerdict::CannotTell;
    };
    let several = |maps: usize| maps >= SEVERAL.0 && maps as f64 >= SEVERAL.1 * effects.len() as f64;
    if several(counts.better()) && several(counts.opposite) {
        return OverallVerdict::DependsOnMap;
    }
    match by_interval(&effect, claimed, relevant) {
        Verdict::Reproduced => OverallVerdict::Reproduced,
        Verdict::Direction => OverallVerdict::Direction,
        Verdict::Partly => OverallVerdict::Partly,
        Verdict::Equivalent => OverallVerdict::Equivalent,
        Verdict::Not => OverallVerdict::Not,
        Verdict::Opposite => OverallVerdict::Opposite,
        Verdict::CannotTell(_) => OverallVerdict::CannotTell,
    }
}

/// The median of ascending effects with its intervals.
fn of_median(effects: &[f64]) -> Option<EffectSize> {
    let [([low, high], _), ([inner_low, inner_high], _)] =
        [median_within(effects, CONFIDENCE)?, median_within(effects, EQUIVALENCE)?];
    Some(EffectSize { value: quantile(effects, 0.5)?, low, high, inner_low, inner_high })
}

#[cfg(test)]
mod tests;
