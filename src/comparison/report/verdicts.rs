//! What became of the claims, as a table and as lines.

use std::fmt::Write;

use super::escape::{cell, prose};
use super::names::asked_name;
use super::numbers::{hundredths, length, short};
use super::tests::probability;
use super::words::{Names, ReportLanguage, Words};
use crate::comparison::Comparison;
use crate::comparison::analysis::Analysis;
use crate::comparison::claim::{Claim, Direction, Statistic};
use crate::comparison::judge::FEWEST_RUNS;
use crate::comparison::judge::JudgedClaim;
use crate::comparison::measure::RunMeasure;
use crate::comparison::over_maps::{FEWEST_MAPS, VerdictCounts};
use crate::comparison::statistics::{CONFIDENCE, Difference};

/// The table of single maps, its totals, and what a reader must know beside it.
pub(super) fn claims_by_map(words: &Words, out: &mut String, comparison: &Comparison, judged: &[JudgedClaim]) {
    let columns = (words.claims.columns)(100.0 * CONFIDENCE);
    let _ = writeln!(out, "\n### {}\n\n| {} |\n|{}", words.claims.by_map, columns.join(" | "), "---|".repeat(columns.len()));
    for c in judged {
        claim_row(words, out, comparison, c);
    }
    let _ = writeln!(out, "\n{}", (words.claims.totals)(&VerdictCounts::of(judged.iter())));
    let notes = comparison.question.claims.iter().filter(|c| !c.note.is_empty());
    for (number, claim) in notes.enumerate() {
        let gap = if number == 0 { "\n" } else { "" };
        let note = (words.signs.about)(&prose(&in_words(words, comparison, claim)), &prose(&claim.note));
        let _ = writeln!(out, "{gap}- {note}");
    }
}

/// Who is said to do what, against whom.
pub(super) fn in_words(words: &Words, comparison: &Comparison, claim: &Claim) -> String {
    let label = |id: &str| comparison.question.entry(id).map_or_else(String::new, |e| asked_name(words, e).into_owned());
    (words.claims.against)([&claim.says, &label(&claim.improved), &label(&claim.baseline)])
}

fn claim_row(words: &Words, out: &mut String, comparison: &Comparison, c: &JudgedClaim) {
    let q = &comparison.question;
    let (Some(claim), Some(instance)) = (q.claims.get(c.claim), q.instances.get(c.instance)) else { return };
    let stands = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| amount(words, claim.measure, v));
    let interval = |d: Option<Difference>| d.map_or_else(|| "–".into(), |d| difference(words, claim.measure, &d));
    let [what, at, how] = [statistic_name(words, claim, c.statistic), stands(c.baseline), stands(c.improved)];
    let better = c.better.map_or_else(|| "–".into(), |a| hundredths(words, a));
    let claimed = c.claimed.map_or_else(|| "–".into(), |size| change(words, claim.measure, claim.direction, size));
    let effect = c.effect.map_or_else(|| "–".into(), |e| effect(words, claim.measure, claim.direction, [e.value, e.low, e.high]));
    let _ = writeln!(
        out,
        "| {} | {} | {what} | {claimed} | {at} → {how} | {effect} | {} | {} | {better} | {} | {} |",
        cell(&in_words(words, comparison, claim)),
        instance.id,
        if claim.measure.is_share() { "–".into() } else { interval(c.medians) },
        of_means(words, c, interval(c.means)),
        c.p.map_or_else(|| "–".into(), probability),
        (words.claims.verdict)(c.verdict, c.claimed.is_some()),
    );
}

fn statistic_name(words: &Words, claim: &Claim, statistic: Statistic) -> String {
    let has_one = claim.measure == RunMeasure::RunningTime || claim.measure.is_share();
    if has_one { measure_name(words, claim) } else { by_statistic(words, claim.measure, statistic) }
}

/// What is compared; a running time with its target.
pub(super) fn measure_name(words: &Words, claim: &Claim) -> String {
    let measure = (words.names.measure)(claim.measure);
    if claim.measure != RunMeasure::RunningTime {
        return measure.into();
    }
    let near = (words.signs.percent)(&short(100.0 * claim.target()));
    (words.claims.to_target)(measure, &near, claim.axis())
}

/// A measure, and what stands for all runs.
pub(super) fn by_statistic(words: &Words, measure: RunMeasure, statistic: Statistic) -> String {
    let Names { measure: name, statistic: kind, .. } = &words.names;
    [name(measure), words.signs.comma, kind(statistic)].concat()
}

/// Says so where the means leave out runs.
fn of_means(words: &Words, c: &JudgedClaim, interval: String) -> String {
    if c.finite == c.runs || c.means.is_none() { interval } else { interval + &(words.claims.runs)(c.finite, c.paired) }
}

/// An effect as people write it, less being negative; of shares in points.
pub(super) fn change(words: &Words, measure: RunMeasure, direction: Direction, effect: f64) -> String {
    let number = hundred(direction, effect);
    if measure.is_share() { (words.claims.points)(&number) } else { (words.signs.percent)(&number) }
}

/// The same with its interval.
pub(super) fn effect(words: &Words, measure: RunMeasure, direction: Direction, [value, low, high]: [f64; 3]) -> String {
    let ends = if direction == Direction::Less { [high, low] } else { [low, high] };
    let [low, high] = ends.map(|end| hundred(direction, end));
    format!("{} [{low}, {high}]", change(words, measure, direction, value))
}

fn hundred(direction: Direction, effect: f64) -> String {
    signed(100.0 * direction.signed(effect), |v| if v.is_finite() { format!("{v:.1}") } else { "∞".into() })
}

pub(super) fn amount(words: &Words, measure: RunMeasure, v: f64) -> String {
    if !v.is_finite() {
        return match measure {
            RunMeasure::RunningTime => words.claims.never.into(),
            // No path, or one that turns straight back.
            RunMeasure::LargestCurvature => "∞".into(),
            _ => words.names.no_path.into(),
        };
    }
    match measure {
        RunMeasure::Length
        | RunMeasure::Cost
        | RunMeasure::TurnIndex
        | RunMeasure::ArrivalTime
        | RunMeasure::Weight
        | RunMeasure::MinClearance
        | RunMeasure::MeanClearance => length(v),
        RunMeasure::Turning | RunMeasure::LargestCurvature | RunMeasure::Smoothness | RunMeasure::Energy => length(v),
        RunMeasure::Success | RunMeasure::Optimal => hundredths(words, v),
        RunMeasure::Turns
        | RunMeasure::IterationOfBest
        | RunMeasure::PathsToBest
        | RunMeasure::AntMoves
        | RunMeasure::RunningTime => short(v),
    }
}

pub(super) fn difference(words: &Words, measure: RunMeasure, d: &Difference) -> String {
    let one = |v: f64| match measure {
        _ if v.is_infinite() => signed(v, |_| "∞".into()),
        RunMeasure::Success | RunMeasure::Optimal => signed(100.0 * v, |v| format!("{v:.0}")),
        _ => signed(v, |v| amount(words, measure, v)),
    };
    let value = if measure.is_share() { (words.claims.points)(&one(d.value)) } else { one(d.value) };
    format!("{value} [{}, {}]", one(d.low), one(d.high))
}

/// With a true minus sign, and a plus for what is above 0.
pub(super) fn signed(v: f64, digits: impl Fn(f64) -> String) -> String {
    let sign = if v < 0.0 {
        "−"
    } else if v > 0.0 {
        "+"
    } else {
        ""
    };
    format!("{sign}{}", digits(v.abs()))
}

/// Every verdict as a line of plain English: over maps, and map by map of claims about too few for that.
pub fn verdicts(comparison: &Comparison, analysis: &Analysis) -> String {
    let (q, words) = (&comparison.question, ReportLanguage::En.words());
    let mut out = String::new();
    let is_of_few = |claim: usize| analysis.judged.iter().filter(|c| c.claim == claim).count() < FEWEST_MAPS;
    for c in analysis.judged.iter().filter(|c| is_of_few(c.claim)) {
        let (Some(claim), Some(instance)) = (q.claims.get(c.claim), q.instances.get(c.instance)) else { continue };
        let stands = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| amount(words, claim.measure, v));
        let (from, to) = (stands(c.baseline), stands(c.improved));
        let verdict = (words.claims.verdict)(c.verdict, c.claimed.is_some()).replace("**", "");
        let what = statistic_name(words, claim, c.statistic);
        let _ = writeln!(out, "  {} on {}: {what} {from} → {to}: {verdict}", claim.id, instance.id);
    }
    for over in &analysis.over_maps {
        let verdict = (words.claims.overall)(over.verdict, over.claimed.is_some(), FEWEST_MAPS).replace("**", "");
        let (on, counts) = ((words.claims.on_maps)(over.better, over.maps), (words.claims.counts)(&over.counts));
        let _ = writeln!(out, "  {}: better on {on} ({counts}): {verdict}", over.claim);
    }
    if q.seeds.count < FEWEST_RUNS as u32 && !q.claims.is_empty() {
        let _ = writeln!(out, "  {} seeds: a verdict needs {FEWEST_RUNS} runs on a map", q.seeds.count);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_look_as_they_should() {
        let [words, chinese] = [ReportLanguage::En, ReportLanguage::ZhCn].map(ReportLanguage::words);
        assert_eq!(change(words, RunMeasure::Length, Direction::Less, 0.087), "−8.7 %");
        assert_eq!(change(words, RunMeasure::Turns, Direction::More, 0.5), "+50.0 %");
        assert_eq!(change(words, RunMeasure::Success, Direction::More, 0.05), "+5.0 points");
        let never = [f64::NEG_INFINITY, f64::NEG_INFINITY, 0.02];
        assert_eq!(effect(words, RunMeasure::RunningTime, Direction::Less, never), "+∞ % [−2.0, +∞]");
        assert_eq!(effect(words, RunMeasure::Length, Direction::Less, [0.03, 0.02, 0.04]), "−3.0 % [−4.0, −2.0]");
        assert_eq!(amount(words, RunMeasure::RunningTime, f64::INFINITY), "never");
        let d = Difference { value: -1.5, low: -2.0, high: 0.0 };
        assert_eq!(difference(words, RunMeasure::Length, &d), "−1.500 [−2.000, 0.000]");
        assert_eq!(difference(words, RunMeasure::Turns, &d), "−1.5 [−2, 0]");
        let share = Difference { value: -0.66, low: -0.75, high: -0.57 };
        assert_eq!(difference(words, RunMeasure::Success, &share), "−66 points [−75, −57]");
        assert_eq!(amount(words, RunMeasure::Length, f64::INFINITY), "no path");
        assert_eq!(difference(chinese, RunMeasure::Success, &share), "−66 个百分点 [−75, −57]");
        assert_eq!(change(chinese, RunMeasure::Length, Direction::Less, 0.087), "−8.7%");
    }
}
