//! What each component of a planner does, as tables and as lines.

use std::fmt::Write;

use super::verdicts::{amount, difference, signed};
use crate::comparison::Comparison;
use crate::comparison::ablation::{Ablated, Effect, Finding, LEVEL};
use crate::comparison::claim::Statistic;
use crate::comparison::statistics::{CONFIDENCE, Difference};

/// A table for each map; nothing where the question is no ablation.
pub(super) fn tables(out: &mut String, comparison: &Comparison, ablated: &[Ablated]) {
    if ablated.is_empty() {
        return;
    }
    let _ = writeln!(
        out,
        "\n## What each component does\n\nEach component is taken out alone and all else stays; differences are of the runs without it less the full \
         planner's, of equal seeds, so that more means that it helps. It matters where Wilcoxon's p, adjusted by Holm over the components of \
         the map, is below {LEVEL}; nothing is said about two at once."
    );
    ablated.iter().for_each(|map| table(out, comparison, map));
}

fn table(out: &mut String, comparison: &Comparison, map: &Ablated) {
    let Some(instance) = comparison.question.instances.get(map.instance) else { return };
    let full = map.full.map_or_else(|| "–".into(), |v| amount(map.measure, v));
    let _ = writeln!(out, "\n### {}: {} of the full planner {full}\n", instance.id, what(map));
    let _ = writeln!(
        out,
        "| without | {} | change | difference of means [{1} %] | of medians [{1} %] | runs with a path | worse | leaning | p by Holm | finding |\n\
         |---|---|---|---|---|---|---|---|---|---|",
        what(map),
        100.0 * CONFIDENCE
    );
    map.effects.iter().for_each(|effect| row(out, map, effect));
}

fn row(out: &mut String, map: &Ablated, e: &Effect) {
    let interval = |d: Option<Difference>| d.map_or_else(|| "–".into(), |d| difference(map.measure, &d));
    let left_out =
        if e.finite_pairs < e.pairs && e.means.is_some() { format!(", {} pairs", e.finite_pairs) } else { String::new() };
    let share = |v: Option<f64>| v.map_or_else(|| "–".into(), |a| format!("{:.0} %", 100.0 * a));
    let _ = writeln!(
        out,
        "| {} | {} | {} | {}{left_out} | {} | {} | {} | {} | {} | {} |",
        e.name,
        e.without.map_or_else(|| "–".into(), |v| amount(map.measure, v)),
        change(map, e),
        interval(e.means),
        interval(e.medians),
        signed(100.0 * e.success, |v| format!("{v:.0}")) + " points",
        share(e.worse),
        signed(e.leaning, |v| format!("{v:.2}")),
        e.holm.map_or_else(|| "–".into(), super::tests::probability),
        finding(e.finding),
    );
}

/// RunMeasure and statistic.
fn what(map: &Ablated) -> String {
    let statistic = if map.statistic == Statistic::Mean { "mean" } else { "median" };
    format!("{}, {statistic}", map.measure.name())
}

/// By which part of the full planner's value the runs without it differ.
fn change(map: &Ablated, e: &Effect) -> String {
    let relative =
        |(without, full): (f64, f64)| (without.is_finite() && full.is_finite() && full > 0.0).then(|| without / full - 1.0);
    let change = e.without.zip(map.full).and_then(relative);
    // Rounded first: what is shown as 0.0 has no sign.
    change.map_or_else(|| "–".into(), |c| signed(libm::round(1000.0 * c) / 10.0, |v| format!("{v:.1}")) + " %")
}

fn finding(finding: Finding) -> &'static str {
    match finding {
        Finding::Helps => "**helps**",
        Finding::Harms => "**harms**",
        Finding::NotShown => "no difference shown",
        Finding::TooFew => "too few runs for a test",
    }
}

/// What each component does as a line of plain text.
pub fn components(comparison: &Comparison, ablated: &[Ablated]) -> String {
    let mut out = String::new();
    for map in ablated {
        let Some(instance) = comparison.question.instances.get(map.instance) else { continue };
        let stands = |v: Option<f64>| v.map_or_else(|| "–".into(), |v| amount(map.measure, v));
        for e in &map.effects {
            let (from, to) = (stands(map.full), stands(e.without));
            let finding = finding(e.finding).replace("**", "");
            let _ = writeln!(out, "  without {} on {}: {} {from} → {to}: {finding}", e.component, instance.id, what(map));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let mut out = String::new();
        row(&mut out, &map, &effect);
        assert_eq!(
            out,
            "| deposits by rank | 33.000 | +10.0 % | −0.500 [−1.000, +0.250], 98 pairs | +3.000 [+2.500, +∞] | −2 points | 62 % | +0.40 \
             | 0.0200 | **helps** |\n"
        );
        assert_eq!(change(&map, &Effect { without: Some(f64::INFINITY), ..effect }), "–");
    }
}
