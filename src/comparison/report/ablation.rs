//! What each component of a planner does, as tables and as lines.

use std::fmt::Write;

use super::numbers::hundredths;
use super::verdicts::{amount, by_statistic, difference, signed};
use super::words::{ReportLanguage, Words};
use crate::comparison::Comparison;
use crate::comparison::ablation::{Ablated, Effect, Finding, LEVEL};
use crate::comparison::statistics::{CONFIDENCE, Difference};

/// A table for each map; nothing where the question is no ablation.
pub(super) fn tables(words: &Words, out: &mut String, comparison: &Comparison, ablated: &[Ablated]) {
    if ablated.is_empty() {
        return;
    }
    let _ = writeln!(out, "\n## {}\n\n{}", words.ablation.title, (words.ablation.about)(LEVEL));
    ablated.iter().for_each(|map| table(words, out, comparison, map));
}

fn table(words: &Words, out: &mut String, comparison: &Comparison, map: &Ablated) {
    let Some(instance) = comparison.question.instances.get(map.instance) else { return };
    let full = map.full.map_or_else(|| "–".into(), |v| amount(words, map.measure, v));
    let what = by_statistic(words, map.measure, map.statistic);
    let columns = (words.ablation.columns)(&what, 100.0 * CONFIDENCE);
    let title = (words.ablation.map)([&instance.id, &what, &full]);
    let _ = writeln!(out, "\n### {title}\n\n| {} |\n|{}", columns.join(" | "), "---|".repeat(columns.len()));
    map.effects.iter().for_each(|effect| row(words, out, map, effect));
}

fn row(words: &Words, out: &mut String, map: &Ablated, e: &Effect) {
    let interval = |d: Option<Difference>| d.map_or_else(|| "–".into(), |d| difference(words, map.measure, &d));
    let leaves_out = e.finite_pairs < e.pairs && e.means.is_some();
    let left_out = if leaves_out { (words.claims.runs)([e.finite_pairs; 2], true) } else { String::new() };
    let share = |v: Option<f64>| v.map_or_else(|| "–".into(), |a| hundredths(words, a));
    let is_shown = matches!(e.finding, Finding::Helps | Finding::Harms);
    let bold = if is_shown { "**" } else { "" };
    let _ = writeln!(
        out,
        "| {} | {} | {} | {}{left_out} | {} | {} | {} | {} | {} | {bold}{}{bold} |",
        e.name,
        e.without.map_or_else(|| "–".into(), |v| amount(words, map.measure, v)),
        change(words, map, e),
        interval(e.means),
        interval(e.medians),
        (words.claims.points)(&signed(100.0 * e.success, |v| format!("{v:.0}"))),
        share(e.worse),
        signed(e.leaning, |v| format!("{v:.2}")),
        e.holm.map_or_else(|| "–".into(), super::tests::probability),
        finding(words, e.finding),
    );
}

/// By which part of the full planner's value the runs without it differ.
fn change(words: &Words, map: &Ablated, e: &Effect) -> String {
    let relative =
        |(without, full): (f64, f64)| (without.is_finite() && full.is_finite() && full > 0.0).then(|| without / full - 1.0);
    let change = e.without.zip(map.full).and_then(relative);
    // Rounded first: what is shown as 0.0 has no sign.
    let digits = |c: f64| signed(libm::round(1000.0 * c) / 10.0, |v| format!("{v:.1}"));
    change.map_or_else(|| "–".into(), |c| (words.signs.percent)(&digits(c)))
}

fn finding(words: &Words, finding: Finding) -> &'static str {
    match finding {
        Finding::Helps => words.ablation.helps,
        Finding::Harms => words.ablation.harms,
        Finding::NotShown => words.ablation.not_shown,
        Finding::TooFew => words.ablation.too_few,
    }
}

/// What each component does as a line of plain English.
pub fn components(comparison: &Comparison, ablated: &[Ablated]) -> String {
    let words = ReportLanguage::En.words();
    let mut out = String::new();
    for map in ablated {
        let Some(instance) = comparison.question.instances.get(map.instance) else { continue };
        let stands = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| amount(words, map.measure, v));
        let what = by_statistic(words, map.measure, map.statistic);
        for e in &map.effects {
            let (from, to) = (stands(map.full), stands(e.without));
            let finding = finding(words, e.finding);
            let _ = writeln!(out, "  without {} on {}: {what} {from} → {to}: {finding}", e.component, instance.id);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::claim::Statistic;
    use crate::comparison::measure::RunMeasure;

    #[test]
    fn a_row_of_the_table() {
        let effect = Effect {
            component: "ranking".into(),
            name: "deposits by rank".into(),
            entry: 1,
            pairs: 100,
            finite_pairs: 98,
            without: Some(33.0),
            medians: Some(Difference { value: 3.0, low: 2.5, high: f64::INFINITY }),
            means: Some(Difference { value: -0.5, low: -1.0, high: 0.25 }),
            p: Some(0.01),
            holm: Some(0.02),
            leaning: 0.4,
            worse: Some(0.625),
            success: -0.02,
            finding: Finding::Helps,
        };
        let map =
            Ablated { instance: 0, measure: RunMeasure::Length, statistic: Statistic::Median, full: Some(30.0), effects: vec![] };
        let words = ReportLanguage::En.words();
        let mut out = String::new();
        row(words, &mut out, &map, &effect);
        assert_eq!(
            out,
            "| deposits by rank | 33.000 | +10.0 % | −0.500 [−1.000, +0.250], 98 pairs | +3.000 [+2.500, +∞] | −2 points | 62 % | +0.40 \
             | 0.0200 | **helps** |\n"
        );
        assert_eq!(change(words, &map, &Effect { without: Some(f64::INFINITY), ..effect }), "–");
    }
}
