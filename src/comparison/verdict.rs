//! What follows from an effect and how sure it is: the rule of docs/methodology.md, for one map and over maps.

use super::contrast::EffectSize;

/// The part of the claimed size that must be there for a claim to count as reproduced.
pub const ENOUGH: f64 = 0.5;

/// What became of a claim. The 95 % interval of the effect decides, and whether the effect is as large as the smallest that matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Relevantly and certainly in the claimed direction, and certainly at least half of the claimed size, if one is claimed.
    Reproduced,
    /// Relevantly and certainly in the claimed direction; whether half of the claimed size is there cannot be told.
    Direction,
    /// Relevantly and certainly in the claimed direction, and certainly less than half of the size.
    Partly,
    /// The 90 % interval lies within what does not matter: no relevant difference.
    Equivalent,
    /// Nothing of all that is certain.
    Not,
    /// Relevantly and certainly in the other direction.
    Opposite,
    /// There is nothing to compare, for this reason.
    CannotTell(WhyNot),
}

/// Why nothing can be told of a claim on a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WhyNot {
    /// The map contradicts what the publication says of its own.
    Contradicted,
    /// It is the map of an instance before it, which has counted.
    SameMap,
    /// Some of their runs are better than the proven optimum.
    Impossible,
    /// There are runs of both, and no pair.
    NoCommonSeed,
    /// There are no runs of one of them.
    NotRun,
    /// The baseline has no value to compare with.
    NoBaseline,
    /// There are fewer than [`super::judge::FEWEST_RUNS`].
    TooFewRuns,
    /// No path can be shorter than the baseline's.
    NoRoom,
    /// Of an iteration of the best: in more than a few runs of one of them it is one of a first stage, which does not count, or there is none.
    FirstStage,
    /// They make different things small, so that no target is one of both.
    OtherObjective,
    /// Nothing is known that could be a target.
    NoTarget,
    /// A run does not tell what it has spent.
    NoEffort,
    /// No run of either reaches the target.
    NeitherReaches,
}

impl WhyNot {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Contradicted => "the map contradicts what the publication says of its own",
            Self::SameMap => "an instance before it is the same map",
            Self::Impossible => "runs of one of the two are impossible on this map",
            Self::NoCommonSeed => "no two runs share a seed",
            Self::NotRun => "one of the two cannot be run",
            Self::NoBaseline => "the baseline finds no path in half of its runs or more",
            Self::TooFewRuns => "too few runs to compare",
            Self::NoRoom => "nearly all of the baseline's runs are optimal already",
            Self::FirstStage => "in many runs of one of the two the best is of its first stage",
            Self::OtherObjective => "the two make different things small",
            Self::NoTarget => "no target is known",
            Self::NoEffort => "the effort of a run is not known",
            Self::NeitherReaches => "no run of either reaches the target",
        }
    }
}

/// Of an effect that is counted as the claim counts; `claimed` in its unit.
pub(super) fn by_interval(effect: &EffectSize, claimed: Option<f64>, relevant: f64) -> Verdict {
    if effect.low > 0.0 && effect.value >= relevant {
        return by_size(effect, claimed);
    }
    if effect.high < 0.0 && -effect.value >= relevant {
        return Verdict::Opposite;
    }
    if effect.inner_low > -relevant && effect.inner_high < relevant { Verdict::Equivalent } else { Verdict::Not }
}

fn by_size(effect: &EffectSize, claimed: Option<f64>) -> Verdict {
    match claimed.map(|claimed| ENOUGH * claimed) {
        Some(enough) if effect.high < enough => Verdict::Partly,
        Some(enough) if effect.low < enough => Verdict::Direction,
        _ => Verdict::Reproduced,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An effect with a 95 % interval, whose 90 % interval is a fifth narrower on each side of the value.
    fn effect(value: f64, low: f64, high: f64) -> EffectSize {
        let inner = |end: f64| value + 0.8 * (end - value);
        EffectSize { value, low, high, inner_low: inner(low), inner_high: inner(high) }
    }

    #[test]
    fn every_line_of_the_rule() {
        let of = |value, low, high, claimed| by_interval(&effect(value, low, high), claimed, 0.01);
        // Claimed: 10 %; half of it is 5 %.
        assert_eq!(of(0.08, 0.05, 0.11, Some(0.1)), Verdict::Reproduced);
        assert_eq!(of(0.08, 0.049, 0.11, Some(0.1)), Verdict::Direction);
        assert_eq!(of(0.03, 0.02, 0.05, Some(0.1)), Verdict::Direction);
        assert_eq!(of(0.03, 0.02, 0.049, Some(0.1)), Verdict::Partly);
        assert_eq!(of(0.03, 0.02, 0.049, None), Verdict::Reproduced);
        // Certain and too small to matter; as large as what matters and not certain.
        assert_eq!(of(0.005, 0.002, 0.008, None), Verdict::Equivalent);
        assert_eq!(of(0.009, 0.002, 0.02, None), Verdict::Not);
        assert_eq!(of(0.03, 0.0, 0.06, None), Verdict::Not);
        assert_eq!(of(-0.03, -0.06, 0.0, None), Verdict::Not);
        assert_eq!(of(-0.03, -0.06, -0.001, Some(0.1)), Verdict::Opposite);
        assert_eq!(of(-0.005, -0.008, -0.002, Some(0.1)), Verdict::Equivalent);
        // The 90 % interval [−0.0098, 0.0094] lies within ±0.01 though the 95 % one does not; ends on ±0.01 do not.
        assert_eq!(of(-0.0002, -0.0122, 0.0118, None), Verdict::Equivalent);
        assert_eq!(of(0.0, -0.0125, 0.0125, None), Verdict::Not);
        // Nothing but equal runs.
        assert_eq!(of(0.0, 0.0, 0.0, Some(0.1)), Verdict::Equivalent);
    }

    #[test]
    fn infinite_effects_are_judged_too() {
        let inf = f64::INFINITY;
        let of =
            |value, low, high| by_interval(&EffectSize { value, low, high, inner_low: low, inner_high: high }, Some(0.1), 0.01);
        assert_eq!(of(-inf, -inf, -inf), Verdict::Opposite);
        assert_eq!(of(-inf, -inf, 0.2), Verdict::Not);
        assert_eq!(of(inf, 0.2, inf), Verdict::Reproduced);
    }
}
