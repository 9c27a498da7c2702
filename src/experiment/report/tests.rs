//! Every pair of entries on every map, and all entries over all maps: rank tests with what many of them at once ask for.

use std::fmt::Write;

use crate::experiment::inference::{Friedman, MIN_RUNS, friedman, holm, mann_whitney, wilcoxon};
use crate::experiment::question::Measure;
use crate::experiment::row::Row;
use crate::experiment::setting::Experiment;
use crate::experiment::statistics::{a12, quantile, sorted};

/// The page of tests: a table of pairs for each map, then ranks over the maps. Which measure is compared follows from the map.
pub fn tests(experiment: &Experiment, rows: &[Row]) -> String {
    let q = &experiment.question;
    let mut out = format!(
        "# {}: tests\n\nTwo-sided rank tests of every pair of entries, runs without a path ranked last. W: Wilcoxon's signed ranks over pairs of \
         equal seed; U: Mann and Whitney's, seeds not paired; p by Holm is adjusted for all pairs of the map. A: how likely a run of the first \
         entry is the better (smaller) one, ties counted half. How to read it: docs/methodology.md.\n",
        q.title
    );
    let runnable: Vec<usize> = (0..q.entries.len()).filter(|&e| q.entries[e].planner.is_some()).collect();
    for (index, instance) in q.instances.iter().enumerate() {
        let measure = experiment.maps.get(index).map_or(Measure::Length, |map| map.measure());
        let _ = writeln!(out, "\n## {}, {}\n", instance.id, measure.name());
        let samples: Vec<Vec<f64>> = runnable.iter().map(|&e| sample(rows, index, e, measure)).collect();
        pairs_table(&mut out, experiment, &runnable, &samples);
    }
    over_maps(&mut out, experiment, rows, &runnable);
    out
}

/// A measure of an entry's runs on a map, by seed.
fn sample(rows: &[Row], instance: usize, entry: usize, measure: Measure) -> Vec<f64> {
    rows.iter().filter(|r| (r.task.instance, r.task.entry) == (instance, entry)).filter_map(|r| r.value(measure)).collect()
}

/// All pairs of indices below `n`.
fn pairs(n: usize) -> Vec<(usize, usize)> {
    (0..n).flat_map(|a| (a + 1..n).map(move |b| (a, b))).collect()
}

fn pairs_table(out: &mut String, experiment: &Experiment, entries: &[usize], samples: &[Vec<f64>]) {
    if samples.iter().any(|s| s.len() < MIN_RUNS) {
        let _ = writeln!(out, "Fewer than {MIN_RUNS} runs of each entry: no tests.");
        return;
    }
    let pairs = pairs(entries.len());
    let paired = |&(a, b): &(usize, usize)| samples[a].iter().copied().zip(samples[b].iter().copied()).collect::<Vec<_>>();
    let signed: Vec<_> = pairs.iter().map(|pair| wilcoxon(&paired(pair))).collect();
    let adjusted = holm(&signed.iter().map(|t| t.map_or(1.0, |t| t.p)).collect::<Vec<_>>());
    out.push_str("| first | second | median, first | second | A | W | p | p by Holm | U | p |\n|---|---|---|---|---|---|---|---|---|---|\n");
    for ((&(a, b), signed), holm) in pairs.iter().zip(&signed).zip(adjusted) {
        let label = |k: usize| &experiment.question.entries[entries[k]].id;
        let better = a12(&samples[b], &samples[a]).map_or_else(|| "–".into(), |v| format!("{v:.3}"));
        let [w, u] = [*signed, mann_whitney(&samples[a], &samples[b])]
            .map(|t| t.map_or_else(|| ("–".into(), "–".into()), |t| (format!("{}", t.statistic), probability(t.p))));
        let (one, other) = (median(&samples[a]), median(&samples[b]));
        let _ = writeln!(
            out,
            "| {} | {} | {one} | {other} | {better} | {} | {} | {} | {} | {} |",
            label(a),
            label(b),
            w.0,
            w.1,
            probability(holm),
            u.0,
            u.1
        );
    }
}

fn median(sample: &[f64]) -> String {
    match quantile(&sorted(sample.to_vec()), 0.5) {
        Some(v) if v.is_finite() => format!("{v:.3}"),
        _ => "no path".into(),
    }
}

/// Friedman's test over the medians of all maps, and its post-hoc comparisons.
fn over_maps(out: &mut String, experiment: &Experiment, rows: &[Row], entries: &[usize]) {
    let of_map = |index: usize| {
        let measure = experiment.maps[index].measure();
        entries.iter().map(|&e| quantile(&sorted(sample(rows, index, e, measure)), 0.5).unwrap_or(f64::INFINITY)).collect()
    };
    let medians: Vec<Vec<f64>> = (0..experiment.maps.len()).map(of_map).collect();
    let Some(result) = friedman(&medians) else { return };
    let (statistic, degrees, p) = (result.test.statistic, entries.len() - 1, probability(result.test.p));
    let _ = writeln!(
        out,
        "\n## Over all maps\n\nFriedman's test over the medians of {} maps: χ² = {statistic:.3} with {degrees} degrees of freedom, p = {p}.{}\n",
        result.blocks,
        if result.blocks < 10 { " So few maps can hardly show a difference." } else { "" },
    );
    ranks_table(out, experiment, entries, &result);
}

fn ranks_table(out: &mut String, experiment: &Experiment, entries: &[usize], result: &Friedman) {
    let label = |k: usize| &experiment.question.entries[entries[k]].id;
    out.push_str("| entry | mean rank |\n|---|---|\n");
    for (k, rank) in result.mean_ranks.iter().enumerate() {
        let _ = writeln!(out, "| {} | {rank:.2} |", label(k));
    }
    let pairs = pairs(entries.len());
    let raw: Vec<f64> = pairs.iter().map(|&(a, b)| result.between(a, b).unwrap_or(1.0)).collect();
    let adjusted = holm(&raw);
    let told: Vec<String> = pairs
        .iter()
        .zip(&adjusted)
        .filter(|(_, p)| **p < 0.05)
        .map(|(&(a, b), p)| format!("{} and {} (p = {})", label(a), label(b), probability(*p)))
        .collect();
    let said = if told.is_empty() { "no two entries differ".into() } else { told.join("; ") };
    let _ = writeln!(out, "\nPost hoc, adjusted by Holm, at 5 %: {said}.");
}

/// A probability as people print it.
fn probability(p: f64) -> String {
    if p < 0.0001 { "< 0.0001".into() } else { format!("{p:.4}") }
}
