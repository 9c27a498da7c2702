//! What became of the claims, as a table and as lines.

use std::fmt::Write;

use super::escape::{cell, prose};
use super::names::asked_name;
use super::{length, short};
use crate::comparison::Comparison;
use crate::comparison::claim::{Claim, Direction, Statistic};
use crate::comparison::judge::{JudgedClaim, Verdict};
use crate::comparison::measure::RunMeasure;
use crate::comparison::statistics::{CONFIDENCE, Difference};

/// The table, its totals, and what a reader must know beside it.
pub(super) fn claims_table(out: &mut String, comparison: &Comparison, judged: &[JudgedClaim]) {
    if judged.is_empty() {
        return;
    }
    out.push_str("\n## Claims\n\n| claim | map | measure | claimed | baseline → improved | change ");
    let _ = writeln!(out, "| difference of medians [{0} %] | of means [{0} %] | better | verdict |", 100.0 * CONFIDENCE);
    out.push_str("|---|---|---|---|---|---|---|---|---|---|\n");
    for c in judged {
        claim_row(out, comparison, c);
    }
    let _ = writeln!(out, "\n{}", totals(judged));
    let notes = comparison.question.claims.iter().filter(|c| !c.note.is_empty());
    for (number, claim) in notes.enumerate() {
        let gap = if number == 0 { "\n" } else { "" };
        let _ = writeln!(out, "{gap}- {}: {}", prose(&in_words(comparison, claim)), prose(&claim.note));
    }
}

/// Who is said to do what, against whom.
fn in_words(comparison: &Comparison, claim: &Claim) -> String {
    let label = |id: &str| comparison.question.entry(id).map_or_else(String::new, |e| asked_name(e).into_owned());
    format!("{}: {} against {}", claim.says, label(&claim.improved), label(&claim.baseline))
}

fn claim_row(out: &mut String, comparison: &Comparison, c: &JudgedClaim) {
    let q = &comparison.question;
    let (Some(claim), Some(instance)) = (q.claims.get(c.claim), q.instances.get(c.instance)) else { return };
    let stands = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| amount(claim.measure, v));
    let interval = |d: Option<Difference>| d.map_or_else(|| "–".into(), |d| difference(claim.measure, &d));
    let [what, at, how] = [statistic_name(claim, c.statistic), stands(c.baseline), stands(c.improved)];
    let better = c.better.map_or_else(|| "–".into(), |a| format!("{:.0} %", 100.0 * a));
    let _ = writeln!(
        out,
        "| {} | {} | {what} | {} | {at} → {how} | {} | {} | {} | {better} | {} |",
        cell(&in_words(comparison, claim)),
        instance.id,
        change(claim.direction, c.claimed),
        change(claim.direction, c.size(claim.direction)),
        if claim.measure.is_share() { "–".into() } else { interval(c.medians) },
        of_means(c, interval(c.means)),
        verdict_text(c),
    );
}

fn statistic_name(claim: &Claim, statistic: Statistic) -> String {
    match statistic {
        _ if claim.measure.is_share() => claim.measure.name().into(),
        Statistic::Median => format!("{}, median", claim.measure.name()),
        Statistic::Mean => format!("{}, mean", claim.measure.name()),
    }
}

/// Says so where the means leave out pairs.
fn of_means(c: &JudgedClaim, interval: String) -> String {
    if c.finite_pairs == c.pairs || c.means.is_none() { interval } else { format!("{interval}, {} pairs", c.finite_pairs) }
}

/// A relative change as people write it: less is negative.
fn change(direction: Direction, size: Option<f64>) -> String {
    size.map_or_else(|| "–".into(), |s| signed(100.0 * direction.signed(s), |v| format!("{v:.1}")) + " %")
}

pub(super) fn amount(measure: RunMeasure, v: f64) -> String {
    if !v.is_finite() {
        return "no path".into();
    }
    match measure {
        RunMeasure::Length | RunMeasure::Cost | RunMeasure::TurnIndex | RunMeasure::Weight => length(v),
        RunMeasure::Success | RunMeasure::Optimal => format!("{:.0} %", 100.0 * v),
        RunMeasure::Turns | RunMeasure::IterationOfBest | RunMeasure::PathsToBest | RunMeasure::AntMoves => short(v),
    }
}

pub(super) fn difference(measure: RunMeasure, d: &Difference) -> String {
    let one = |v: f64| match measure {
        _ if v.is_infinite() => signed(v, |_| "∞".into()),
        RunMeasure::Success | RunMeasure::Optimal => signed(100.0 * v, |v| format!("{v:.0}")),
        _ => signed(v, |v| amount(measure, v)),
    };
    let unit = if measure.is_share() { " points" } else { "" };
    format!("{}{unit} [{}, {}]", one(d.value), one(d.low), one(d.high))
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

fn verdict_text(c: &JudgedClaim) -> String {
    match c.verdict {
        Verdict::Reproduced if c.claimed.is_none() => "**reproduced** (no size is claimed)".into(),
        Verdict::Reproduced => "**reproduced**".into(),
        Verdict::Partly => "**partly**".into(),
        Verdict::Not => "**not reproduced**".into(),
        Verdict::Opposite => "**not reproduced**: the opposite".into(),
        Verdict::CannotTell(why) => format!("**cannot tell**: {why}"),
    }
}

/// Every verdict as a line of plain text.
pub fn verdicts(comparison: &Comparison, judged: &[JudgedClaim]) -> String {
    let q = &comparison.question;
    let mut out = String::new();
    for c in judged {
        let (Some(claim), Some(instance)) = (q.claims.get(c.claim), q.instances.get(c.instance)) else { continue };
        let stands = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| amount(claim.measure, v));
        let (from, to) = (stands(c.baseline), stands(c.improved));
        let verdict = verdict_text(c).replace("**", "");
        let _ =
            writeln!(out, "  {} on {}: {} {from} → {to}: {verdict}", claim.id, instance.id, statistic_name(claim, c.statistic));
    }
    out
}

fn totals(judged: &[JudgedClaim]) -> String {
    let count = |is: fn(Verdict) -> bool| judged.iter().filter(|c| is(c.verdict)).count();
    format!(
        "Of {} comparisons: {} reproduced, {} partly, {} not, {} that cannot be told.",
        judged.len(),
        count(|v| v == Verdict::Reproduced),
        count(|v| v == Verdict::Partly),
        count(|v| matches!(v, Verdict::Not | Verdict::Opposite)),
        count(|v| matches!(v, Verdict::CannotTell(_))),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_look_as_they_should() {
        assert_eq!([17.5, 20.0, 15.75, 0.0].map(short), ["17.5", "20", "15.75", "0"]);
        assert_eq!(change(Direction::Less, Some(0.087)), "−8.7 %");
        assert_eq!(change(Direction::More, Some(0.5)), "+50.0 %");
        let d = Difference { value: -1.5, low: -2.0, high: 0.0 };
        assert_eq!(difference(RunMeasure::Length, &d), "−1.500 [−2.000, 0.000]");
        assert_eq!(difference(RunMeasure::Turns, &d), "−1.5 [−2, 0]");
        let share = Difference { value: -0.66, low: -0.75, high: -0.57 };
        assert_eq!(difference(RunMeasure::Success, &share), "−66 points [−75, −57]");
        assert_eq!(amount(RunMeasure::Length, f64::INFINITY), "no path");
    }
}
