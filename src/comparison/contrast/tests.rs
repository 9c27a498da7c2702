//! Against values by hand and SciPy's.

use super::*;
use crate::comparison::statistics::{mean, median_difference, median_of};

/// Samples with many ties, as SciPy was given them.
fn tied(n: u32, factor: u32, modulus: u32, shift: f64) -> Vec<f64> {
    (0..n).map(|i| f64::from(i * factor % modulus) / 2.0 - shift).collect()
}

fn two(paired: bool) -> TwoSamples<f64> {
    let mut improved = tied(40, 7919, 23, -20.0);
    improved.truncate(if paired { 35 } else { 40 });
    TwoSamples { improved, baseline: tied(35, 104_729, 29, -20.0), paired }
}

fn of_means(samples: &TwoSamples<f64>) -> Contrast {
    contrast(samples, RunMeasure::Length, "t", |sample| mean(sample)).unwrap()
}

fn near(found: f64, scipys: f64, within: f64) {
    assert!((found - scipys).abs() < within, "{found} is not {scipys}");
}

#[test]
fn independent_samples_are_drawn_as_scipy_draws_them() {
    // scipy.stats.bootstrap, percentile, paired = False, 400,000 resamples, SciPy 1.17.1: the ends of 10,000 are known to about 2 %.
    let Contrast { difference: d, effect: e } = of_means(&two(false));
    near(d.value, -1.125, 1e-12);
    near(e.value, -0.042_134_831, 1e-9);
    near(d.low, -2.870, 0.06);
    near(d.high, 0.623, 0.06);
    let ends = [(e.low, -0.1034), (e.high, 0.0238), (e.inner_low, -0.0938), (e.inner_high, 0.0131)];
    ends.into_iter().for_each(|(a, b)| near(a, b, 0.0025));
    let medians = contrast(&two(false), RunMeasure::Length, "t", median_of).unwrap().effect;
    near(medians.value, -0.028_301_887, 1e-9);
    [(medians.low, -0.1466), (medians.high, 0.0700)].into_iter().for_each(|(a, b)| near(a, b, 0.01));
}

#[test]
fn pairs_are_drawn_together() {
    // The same with paired = True, of the first 35: wider, because these pairs lean against each other.
    let effect = of_means(&two(true)).effect;
    near(effect.value, -0.052_969_502, 1e-9);
    [(effect.low, -0.1208), (effect.high, 0.0220)].into_iter().for_each(|(a, b)| near(a, b, 0.0035));
    // The differences are those of every other paired bootstrap of this name.
    let TwoSamples { improved, baseline, .. } = two(true);
    let pairs: Vec<(f64, f64)> = improved.into_iter().zip(baseline).collect();
    let drawn = contrast(&two(true), RunMeasure::Length, "t", median_of).unwrap();
    assert_eq!(Some(drawn.difference), median_difference(&pairs, "t"));
}

#[test]
fn effects_by_hand() {
    let inf = f64::INFINITY;
    let of = |improved, baseline| effect(RunMeasure::Length, improved, baseline);
    assert_eq!((of(38.0, 40.0), of(42.0, 40.0), of(0.1 + 0.2, 0.3)), (-0.05, 0.05, 0.0));
    // No path is longer than any; two without one do not differ; a path where there was none saves all of it.
    assert_eq!((of(inf, 40.0), of(inf, inf), of(40.0, inf)), (inf, 0.0, -1.0));
    // Where more is better, a run without a path counts as −∞.
    assert_eq!((of(-inf, 40.0), of(40.0, -inf)), (-inf, inf));
    assert_eq!((of(0.0, 0.0), of(2.0, 0.0), of(0.0, 2.0)), (0.0, inf, -1.0));
    assert_eq!(effect(RunMeasure::Success, 0.8, 0.5), 0.3);
}

#[test]
fn what_the_claim_says_is_positive() {
    let effect = EffectSize { value: -0.1, low: -0.2, high: 0.05, inner_low: -0.15, inner_high: 0.0 };
    let less = EffectSize { value: 0.1, low: -0.05, high: 0.2, inner_low: 0.0, inner_high: 0.15 };
    assert_eq!((effect.signed(Direction::Less), effect.signed(Direction::More)), (less, effect));
    let chance = EffectSize { value: 0.4, low: 0.2, high: 0.6, inner_low: 0.25, inner_high: 0.5 }.to_nothing();
    assert_eq!((chance.low, chance.high, chance.inner_low), (0.0, 0.6, 0.0));
}

#[test]
fn runs_that_do_not_count_leave_with_their_pairs() {
    let inf = f64::INFINITY;
    let both = |paired| TwoSamples { improved: vec![1.0, inf, 3.0], baseline: vec![inf, 5.0, 6.0], paired };
    assert_eq!(both(true).only(f64::is_finite).runs(), [1, 1]);
    let independent = both(false).only(f64::is_finite);
    assert_eq!((independent.improved, independent.baseline), (vec![1.0, 3.0], vec![5.0, 6.0]));
    let nobody = TwoSamples { improved: vec![1.0], ..TwoSamples::default() };
    assert_eq!(contrast(&nobody, RunMeasure::Length, "t", median_of), None);
}
