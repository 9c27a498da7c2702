//! What became of the claims, as a table and as lines.

use std::fmt::Write;

use super::escape::{cell, prose};
use super::names::asked_name;
use super::numbers::{hundredths, length, short};
use super::words::{Names, ReportLanguage, Words};
use crate::comparison::Comparison;
use crate::comparison::claim::{Claim, Direction, Statistic};
use crate::comparison::judge::{JudgedClaim, Verdict};
use crate::comparison::measure::RunMeasure;
use crate::comparison::statistics::{CONFIDENCE, Difference};

/// The table, its totals, and what a reader must know beside it.
pub(super) fn claims_table(words: &Words, out: &mut String, comparison: &Comparison, judged: &[JudgedClaim]) {
    if judged.is_empty() {
        return;
    }
    let columns = (words.claims.columns)(100.0 * CONFIDENCE);
    let _ = writeln!(out, "\n## {}\n\n| {} |\n|{}", words.claims.title, columns.join(" | "), "---|".repeat(columns.len()));
    for c in judged {
        claim_row(words, out, comparison, c);
    }
    let _ = writeln!(out, "\n{}", totals(words, judged));
    let notes = comparison.question.claims.iter().filter(|c| !c.note.is_empty());
    for (number, claim) in notes.enumerate() {
        let gap = if number == 0 { "\n" } else { "" };
        let note = (words.signs.about)(&prose(&in_words(words, comparison, claim)), &prose(&claim.note));
        let _ = writeln!(out, "{gap}- {note}");
    }
}

/// Who is said to do what, against whom.
fn in_words(words: &Words, comparison: &Comparison, claim: &Claim) -> String {
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
    let _ = writeln!(
        out,
        "| {} | {} | {what} | {} | {at} → {how} | {} | {} | {} | {better} | {} |",
        cell(&in_words(words, comparison, claim)),
        instance.id,
        change(words, claim.direction, c.claimed),
        change(words, claim.direction, c.size(claim.direction)),
        if claim.measure.is_share() { "–".into() } else { interval(c.medians) },
        of_means(words, c, interval(c.means)),
        verdict_text(words, c),
    );
}

fn statistic_name(words: &Words, claim: &Claim, statistic: Statistic) -> String {
    let measure = (words.names.measure)(claim.measure);
    if claim.measure.is_share() { measure.into() } else { by_statistic(words, claim.measure, statistic) }
}

/// A measure, and what stands for all runs.
pub(super) fn by_statistic(words: &Words, measure: RunMeasure, statistic: Statistic) -> String {
    let Names { measure: name, statistic: kind, .. } = &words.names;
    [name(measure), words.signs.comma, kind(statistic)].concat()
}

/// Says so where the means leave out pairs.
fn of_means(words: &Words, c: &JudgedClaim, interval: String) -> String {
    if c.finite_pairs == c.pairs || c.means.is_none() { interval } else { interval + &(words.claims.pairs)(c.finite_pairs) }
}

/// A relative change as people write it: less is negative.
fn change(words: &Words, direction: Direction, size: Option<f64>) -> String {
    let told = |s: f64| (words.signs.percent)(&signed(100.0 * direction.signed(s), |v| format!("{v:.1}")));
    size.map_or_else(|| "–".into(), told)
}

pub(super) fn amount(words: &Words, measure: RunMeasure, v: f64) -> String {
    if !v.is_finite() {
        return words.names.no_path.into();
    }
    match measure {
        RunMeasure::Length | RunMeasure::Cost | RunMeasure::TurnIndex | RunMeasure::Weight => length(v),
        RunMeasure::Success | RunMeasure::Optimal => hundredths(words, v),
        RunMeasure::Turns | RunMeasure::IterationOfBest | RunMeasure::PathsToBest | RunMeasure::AntMoves => short(v),
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

fn verdict_text(words: &Words, c: &JudgedClaim) -> String {
    (words.claims.verdict)(c.verdict, c.claimed.is_some())
}

/// Every verdict as a line of plain English.
pub fn verdicts(comparison: &Comparison, judged: &[JudgedClaim]) -> String {
    let (q, words) = (&comparison.question, ReportLanguage::En.words());
    let mut out = String::new();
    for c in judged {
        let (Some(claim), Some(instance)) = (q.claims.get(c.claim), q.instances.get(c.instance)) else { continue };
        let stands = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| amount(words, claim.measure, v));
        let (from, to) = (stands(c.baseline), stands(c.improved));
        let verdict = verdict_text(words, c).replace("**", "");
        let what = statistic_name(words, claim, c.statistic);
        let _ = writeln!(out, "  {} on {}: {what} {from} → {to}: {verdict}", claim.id, instance.id);
    }
    out
}

fn totals(words: &Words, judged: &[JudgedClaim]) -> String {
    let count = |is: fn(Verdict) -> bool| judged.iter().filter(|c| is(c.verdict)).count();
    (words.claims.totals)([
        judged.len(),
        count(|v| v == Verdict::Reproduced),
        count(|v| v == Verdict::Partly),
        count(|v| matches!(v, Verdict::Not | Verdict::Opposite)),
        count(|v| matches!(v, Verdict::CannotTell(_))),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_look_as_they_should() {
        let [words, chinese] = [ReportLanguage::En, ReportLanguage::ZhCn].map(ReportLanguage::words);
        assert_eq!(change(words, Direction::Less, Some(0.087)), "−8.7 %");
        assert_eq!(change(words, Direction::More, Some(0.5)), "+50.0 %");
        let d = Difference { value: -1.5, low: -2.0, high: 0.0 };
        assert_eq!(difference(words, RunMeasure::Length, &d), "−1.500 [−2.000, 0.000]");
        assert_eq!(difference(words, RunMeasure::Turns, &d), "−1.5 [−2, 0]");
        let share = Difference { value: -0.66, low: -0.75, high: -0.57 };
        assert_eq!(difference(words, RunMeasure::Success, &share), "−66 points [−75, −57]");
        assert_eq!(amount(words, RunMeasure::Length, f64::INFINITY), "no path");
        assert_eq!(difference(chinese, RunMeasure::Success, &share), "−66 个百分点 [−75, −57]");
        assert_eq!(change(chinese, Direction::Less, Some(0.087)), "−8.7%");
    }
}
