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
    let measure = comparison.maps[instance].objective(full).map_or(RunMeasure::Length, RunMeasure::of);
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
mod tests {
    use std::sync::Arc;

    use super::super::roles::{AblationRole, roles};
    use super::*;
    use crate::comparison::Comparison;
    use crate::comparison::question::{Instance, Seeds};
    use crate::comparison::row::{Found, Row, Spent, Task};
    use crate::map::{Grid, Movement, Point};
    use crate::params::Values;
    use crate::planner::Status;
    use crate::scenario::Scenario;

    const SEEDS: Seeds = Seeds { from: 1, count: 20 };

    /// An ablation with the entries full, without-ranking and without-best-so-far-deposit, on a corridor.
    fn comparison() -> Comparison {
        let grid = Grid::open(6, 1).expect("a usable size");
        let scenario = Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(5, 0)).expect("usable");
        let instance = Instance { id: "a".into(), map: "a.json".into(), note: String::new() };
        let question = super::super::question("rank-based-ant-system", None, &Values::new(), vec![instance], SEEDS).unwrap();
        Comparison::new(question, vec![Arc::new(scenario)]).unwrap()
    }

    /// Lengths by entry, for seeds from 1 on; infinite: no path.
    fn rows(lengths: [Vec<f64>; 3]) -> Vec<Row> {
        let row = |entry, seed, length: f64| Row {
            task: Task { instance: 0, entry, seed },
            status: Status::BudgetSpent,
            found: length.is_finite().then_some(Found { length, turns: None, turn_index: None, weight: None, value: length }),
            effort: Spent::default(),
            trace: Vec::new(),
            digest: String::new(),
        };
        let all = lengths.into_iter().enumerate();
        all.flat_map(|(entry, of)| (1..).zip(of).map(move |(seed, length)| row(entry, seed, length))).collect()
    }

    fn judged(lengths: [Vec<f64>; 3]) -> Ablated {
        effects(&Samples::new(&comparison(), rows(lengths).iter().map(Into::into))).remove(0)
    }

    fn close(a: Option<f64>, b: f64) {
        assert!(a.is_some_and(|a| (a - b).abs() <= 1e-4 * b), "{a:?} is not {b}");
    }

    #[test]
    fn one_that_matters_and_one_that_does_not() {
        let full: Vec<f64> = (0..20).map(|i| 30.0 + f64::from(i)).collect();
        let longer = full.iter().map(|v| v + 1.0).collect();
        let a = judged([full.clone(), full.clone(), longer]);
        assert_eq!((a.measure, a.statistic, a.full), (RunMeasure::Length, Statistic::Mean, Some(39.5)));
        let [deposit, ranking] = &a.effects[..] else { panic!("two components") };
        assert_eq!((deposit.component.as_str(), ranking.component.as_str()), ("best-so-far-deposit", "ranking"));
        // 20 equal differences: W = 0, z = 105 / √(717.5 − 166.25) = √20, p = 7.7442e-6; times 2 by Holm.
        close(deposit.p, 7.744_2e-6);
        close(deposit.holm, 1.548_84e-5);
        assert_eq!((deposit.finding, deposit.leaning, deposit.without), (Finding::Helps, 1.0, Some(40.5)));
        assert_eq!((deposit.pairs, deposit.finite_pairs, deposit.success), (20, 20, 0.0));
        let means = deposit.means.unwrap();
        assert_eq!((means.value, means.low, means.high), (1.0, 1.0, 1.0));
        // 31 to 50 against 30 to 49: of 400 pairs 19 are equal and 210 larger.
        close(deposit.worse, (210.0 + 9.5) / 400.0);
        assert_eq!((ranking.finding, ranking.p, ranking.holm), (Finding::NotShown, Some(1.0), Some(1.0)));
        assert_eq!((ranking.leaning, ranking.worse), (0.0, Some(0.5)));
    }

    #[test]
    fn a_run_without_a_path_is_worse_than_any() {
        let full = vec![30.0; 20];
        let lost = |n: usize| [vec![f64::INFINITY; n], vec![29.0; 20 - n]].concat();
        // 11 of 20: W⁺ = 165, W⁻ = 45, z = 60 / √(717.5 − 42.5) = 2.3094, p = 0.020921, times 2.
        let a = judged([full.clone(), lost(11), full.clone()]);
        let ranking = &a.effects[0];
        assert_eq!((a.statistic, ranking.component.as_str()), (Statistic::Median, "ranking"));
        close(ranking.holm, 0.041_842);
        close(Some(ranking.leaning), 120.0 / 210.0);
        assert_eq!((ranking.finding, ranking.success, ranking.finite_pairs), (Finding::Helps, -0.55, 9));
        assert_eq!((ranking.without, ranking.medians.unwrap().value), (Some(f64::INFINITY), f64::INFINITY));
        // The nine runs that arrive are shorter; their mean alone would say the opposite.
        assert_eq!(ranking.means.unwrap().value, -1.0);
        // 10 of 20: p = 0.0545.
        assert_eq!(judged([full.clone(), lost(10), full]).effects[0].finding, Finding::NotShown);
    }

    #[test]
    fn without_a_component_that_harms_runs_are_better() {
        let a = judged([vec![30.0; 20], vec![29.0; 20], vec![31.0; 20]]);
        let findings: Vec<Finding> = a.effects.iter().map(|e| e.finding).collect();
        // As large and as clear as each other: in the order of the catalog.
        assert_eq!(findings, [Finding::Harms, Finding::Helps]);
        assert_eq!((a.effects[0].leaning, a.effects[0].worse), (-1.0, Some(0.0)));
    }

    #[test]
    fn the_larger_difference_comes_first() {
        let a = judged([vec![30.0; 20], vec![31.0; 20], vec![34.0; 20]]);
        assert_eq!(a.effects.iter().map(|e| e.component.as_str()).collect::<Vec<_>>(), ["best-so-far-deposit", "ranking"]);
    }

    #[test]
    fn runs_are_paired_by_seed_and_below_twenty_there_is_no_test() {
        let a = judged([vec![30.0; 20], vec![31.0; 19], vec![]]);
        let [ranking, deposit] = &a.effects[..] else { panic!("two components") };
        assert_eq!((ranking.pairs, ranking.p, ranking.finding), (19, None, Finding::TooFew));
        assert_eq!((deposit.pairs, deposit.means, deposit.worse), (0, None, None));
    }

    #[test]
    fn other_questions_are_no_ablations() {
        let mut other = comparison();
        other.question.entries[0].id = "all".into();
        assert_eq!(effects(&Samples::new(&other, [])), []);
        assert_eq!(roles(&other.question), [None, None, None]);
    }

    #[test]
    fn every_entry_has_its_part() {
        let without = |component: &str| Some(AblationRole::Without { component: component.into() });
        let told = roles(&comparison().question);
        assert_eq!(told, [Some(AblationRole::Full), without("ranking"), without("best-so-far-deposit")]);
    }

    #[test]
    fn infinite_numbers_are_null_in_json() {
        let a = judged([vec![30.0; 20], vec![f64::INFINITY; 20], vec![30.0; 20]]);
        let json = serde_json::to_value(&a).unwrap();
        assert_eq!(json["effects"][0]["finding"], "helps");
        assert!(json["effects"][0]["medians"]["value"].is_null() && json["full"] == 30.0);
    }
}
