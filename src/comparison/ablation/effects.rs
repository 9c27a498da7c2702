//! What the runs of an ablation say of each component.

use serde::Serialize;

use super::WITHOUT;
use super::roles::parts;
use crate::comparison::claim::Statistic;
use crate::comparison::inference::{holm, rank_biserial, wilcoxon};
use crate::comparison::measure::RunMeasure;
use crate::comparison::samples::{Samples, paired, without_seeds};
use crate::comparison::statistics::{Difference, a12, mean, mean_difference, median_difference};
use crate::planner::Component;

/// From which p (adjusted by Holm over the components of a map) on a difference may be chance.
pub const LEVEL: f64 = 0.05;

/// What the runs say of a component.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Finding {
    /// Without it runs are worse.
    Helps,
    /// Without it runs are better.
    Harms,
    /// No difference is certain enough.
    NotShown,
    /// There are too few pairs of runs for a test.
    TooFew,
}

/// What taking one component out does on one map. Differences are of the run without it less the full one, so that above 0 it helps; lengths
/// in cells. A run without a path is infinitely long: infinite numbers are null in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Effect {
    /// Id of the component.
    pub component: String,
    /// Its name in tables.
    pub name: String,
    /// The entry without it, as its place in the question.
    pub entry: usize,
    /// Pairs of runs with the same seed.
    pub pairs: usize,
    /// Pairs of which both runs found a path: those that the means are over.
    pub finite_pairs: usize,
    /// What stands for the runs without it, by the statistic of the map.
    pub without: Option<f64>,
    /// Of the medians over all pairs.
    pub medians: Option<Difference>,
    /// Of the means over the finite pairs.
    pub means: Option<Difference>,
    /// Of Wilcoxon's signed ranks, two-sided; none below 20 pairs.
    pub p: Option<f64>,
    /// The same, adjusted by Holm over the components of the map.
    pub holm: Option<f64>,
    /// Which way the pairs lean, by the ranks of that test: from −1, runs without it are always better, to 1, always worse.
    pub leaning: f64,
    /// A of Vargha and Delaney: how likely a run without it is the worse one, ties half; ½ is no difference.
    pub worse: Option<f64>,
    /// Share of the runs that found a path, without it less with it.
    pub success: f64,
    /// What follows.
    pub finding: Finding,
}

/// An ablation on one map.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Ablated {
    /// Which instance of the question.
    pub instance: usize,
    /// What is measured: what the full planner makes small.
    pub measure: RunMeasure,
    /// What stands for all runs and orders the components: the mean where every run of the ablation found a path, else the median.
    pub statistic: Statistic,
    /// What stands for the full planner's runs.
    pub full: Option<f64>,
    /// The components: those that matter first, of these the larger difference first.
    pub effects: Vec<Effect>,
}

/// What each component does, on each map; empty where the question is no ablation.
pub fn effects(samples: &Samples) -> Vec<Ablated> {
    let comparison = samples.comparison();
    let Some((full, components)) = parts(&comparison.question) else { return Vec::new() };
    (0..comparison.maps.len()).map(|instance| on_map(samples, instance, full, &components)).collect()
}

fn on_map(samples: &Samples, instance: usize, full: usize, components: &[(usize, &'static Component)]) -> Ablated {
    let comparison = samples.comparison();
    let map = &comparison.maps[instance];
    let measure = map.objective(full).map_or(map.measure(), |objective| map.measure_of(objective));
    let sample = |entry| Sample {
        values: samples.values(instance, entry, measure),
        found: samples.values(instance, entry, RunMeasure::Success),
    };
    let base = sample(full);
    let without: Vec<Sample> = components.iter().map(|&(entry, _)| sample(entry)).collect();
    let all_found = without.iter().chain([&base]).flat_map(|s| &s.values).all(|(_, v)| v.is_finite());
    let statistic = if all_found { Statistic::Mean } else { Statistic::Median };
    let place = &comparison.question.instances[instance].id;
    let measured = components.iter().zip(&without).map(|(&(entry, component), sample)| {
        let name = format!("{WITHOUT}{}/{place}", component.id);
        let effect = effect(&base, sample, statistic, &name);
        Effect { component: component.id.into(), name: component.name.into(), entry, ..effect }
    });
    let mut effects: Vec<Effect> = measured.collect();
    judge(&mut effects);
    effects.sort_by(|a, b| weight(b, statistic).partial_cmp(&weight(a, statistic)).unwrap_or(std::cmp::Ordering::Equal));
    let standing = statistic.of(&without_seeds(&base.values));
    Ablated { instance, measure, statistic, full: standing, effects }
}

/// The runs of an entry on a map: (seed, value), and (seed, 1 or 0) whether a path was found.
struct Sample {
    values: Vec<(u32, f64)>,
    found: Vec<(u32, f64)>,
}

/// Everything but what depends on the other components.
fn effect(full: &Sample, without: &Sample, statistic: Statistic, name: &str) -> Effect {
    let pairs = paired(&without.values, &full.values);
    let finite: Vec<(f64, f64)> = pairs.iter().copied().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
    let (first, second): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let found = paired(&without.found, &full.found);
    Effect {
        component: String::new(),
        name: String::new(),
        entry: 0,
        pairs: pairs.len(),
        finite_pairs: finite.len(),
        medians: median_difference(&pairs, name),
        means: mean_difference(&finite, name),
        p: wilcoxon(&pairs).map(|test| test.p),
        holm: None,
        leaning: rank_biserial(&pairs),
        worse: a12(&first, &second),
        success: mean(&found.iter().map(|(a, b)| a - b).collect::<Vec<_>>()).unwrap_or(0.0),
        finding: Finding::TooFew,
        without: statistic.of(&first),
    }
}

/// Adjusts the tests of one map, and says what follows.
fn judge(effects: &mut [Effect]) {
    let tested: Vec<f64> = effects.iter().filter_map(|e| e.p).collect();
    let mut adjusted = holm(&tested).into_iter();
    for effect in effects {
        effect.holm = effect.p.and_then(|_| adjusted.next());
        effect.finding = match effect.holm {
            None => Finding::TooFew,
            Some(p) if p >= LEVEL => Finding::NotShown,
            Some(_) if effect.leaning > 0.0 => Finding::Helps,
            Some(_) => Finding::Harms,
        };
    }
}

/// What components are ordered by: whether they matter, how large their difference is, and how clearly it shows.
fn weight(effect: &Effect, statistic: Statistic) -> (bool, f64, f64) {
    let difference = match statistic {
        Statistic::Mean => effect.means,
        Statistic::Median => effect.medians,
    };
    let matters = matches!(effect.finding, Finding::Helps | Finding::Harms);
    (matters, difference.map_or(0.0, |d| d.value.abs()), effect.leaning.abs())
}

#[cfg(test)]
mod tests;
