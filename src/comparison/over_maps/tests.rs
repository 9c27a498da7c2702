//! Maps whose effects are written down here.

use super::*;
use crate::comparison::claim::Statistic;
use crate::comparison::verdict::WhyNot;

const CLAIM: &str = r#"{ "id": "c", "says": "", "improved": "a", "baseline": "b", "measure": "length", "direction": "less" }"#;

/// A map with this effect, so certain that its interval is a thousandth wide.
fn map(effect: f64, claimed: Option<f64>) -> JudgedClaim {
    let effect = EffectSize {
        value: effect,
        low: effect - 5e-4,
        high: effect + 5e-4,
        inner_low: effect - 4e-4,
        inner_high: effect + 4e-4,
    };
    JudgedClaim {
        claim: 0,
        instance: 0,
        claimed,
        relevant: 0.01,
        paired: false,
        runs: [100, 100],
        finite: [100, 100],
        baseline_optimal: None,
        statistic: Statistic::Mean,
        baseline: Some(40.0),
        improved: Some(40.0),
        medians: None,
        means: None,
        effect: Some(effect),
        better: None,
        p: None,
        verdict: by_interval(&effect, claimed, 0.01),
    }
}

fn over(effects: &[f64], claimed: Option<f64>) -> OverMaps {
    let maps: Vec<JudgedClaim> = effects.iter().map(|&effect| map(effect, claimed)).collect();
    one(&serde_json::from_str(CLAIM).unwrap(), &maps.iter().collect::<Vec<_>>())
}

#[test]
fn fifteen_maps_by_hand() {
    // −2 % to 12 %: the median is 5 %, and 4th and 12th of 15 bound it at 96.48 %.
    let effects: Vec<f64> = (-2..13).map(|i| f64::from(i) / 100.0).collect();
    let told = over(&effects, Some(0.02));
    assert_eq!((told.median, told.low, told.high), (Some(0.05), Some(0.01), Some(0.09)));
    assert!((told.confidence.unwrap() - 0.964_843_75).abs() < 1e-12);
    // 1 % matters, and whether it is half of the claimed 2 % cannot be told. −1 % matters as well.
    let VerdictCounts { reproduced, direction, equivalent, not, opposite, .. } = told.counts;
    assert_eq!([reproduced, direction, equivalent, not, opposite], [11, 1, 1, 0, 2]);
    assert_eq!((told.better, told.maps), (12, 15));
    // 12 above, 2 below, one level: P(X ≤ 2 of 14) · 2 = 2 · (1 + 14 + 91) / 2¹⁴.
    assert_eq!((told.above, told.level, told.below), (12, 1, 2));
    assert!((told.sign_p.unwrap() - 212.0 / 16384.0).abs() < 1e-12);
    // Two maps of 15 are certainly against it, and two are 13 %.
    assert_eq!(told.verdict, OverallVerdict::DependsOnMap);
    assert_eq!(told.share_interval, wilson(12, 15));
}

#[test]
fn the_rule_of_one_map_holds_for_their_median() {
    let verdict = |effects: &[f64], claimed| over(effects, claimed).verdict;
    let six = [0.02, 0.03, 0.04, 0.05, 0.06, 0.07];
    assert_eq!(verdict(&six, None), OverallVerdict::Reproduced);
    assert_eq!(verdict(&six, Some(0.04)), OverallVerdict::Reproduced);
    assert_eq!(verdict(&six, Some(0.1)), OverallVerdict::Direction);
    assert_eq!(verdict(&six, Some(0.2)), OverallVerdict::Partly);
    assert_eq!(verdict(&six.map(|v| -v), Some(0.2)), OverallVerdict::Opposite);
    assert_eq!(verdict(&six.map(|v| v / 10.0), None), OverallVerdict::Equivalent);
    assert_eq!(verdict(&[-0.02, 0.0, 0.0, 0.03, 0.03, 0.03], None), OverallVerdict::Not);
    // Five maps are too few, whatever they say.
    let five = over(&six[..5], None);
    assert_eq!((five.verdict, five.low, five.better), (OverallVerdict::CannotTell, None, 5));
}

#[test]
fn one_map_of_many_is_no_dependence() {
    // Two of 21 are less than a tenth, two of 20 are one; one of 6 is more than a tenth, and one map alone.
    let of = |against: usize, all: usize| (0..all).map(|i| if i < against { -0.05 } else { 0.05 }).collect::<Vec<f64>>();
    let verdicts = [(2, 21), (2, 20), (1, 6)].map(|(against, all)| over(&of(against, all), None).verdict);
    assert_eq!(verdicts, [OverallVerdict::Reproduced, OverallVerdict::DependsOnMap, OverallVerdict::Not]);
    assert_eq!(over(&of(0, 6), None).verdict, OverallVerdict::Reproduced);
    // Sure for it on two, and against it on two, of forty of which most show nothing.
    let few: Vec<f64> = of(2, 4).into_iter().chain(std::iter::repeat_n(0.0, 36)).collect();
    assert_eq!(over(&few, None).verdict, OverallVerdict::Equivalent);
}

#[test]
fn maps_of_which_nothing_can_be_told_count_in_nothing() {
    let mut maps: Vec<JudgedClaim> = (0..7).map(|_| map(0.05, Some(0.1))).collect();
    maps[6] = JudgedClaim { verdict: Verdict::CannotTell(WhyNot::Contradicted), claimed: None, ..map(-0.9, None) };
    let told = one(&serde_json::from_str(CLAIM).unwrap(), &maps.iter().collect::<Vec<_>>());
    assert_eq!((told.maps, told.counts.cannot_tell, told.above, told.below), (6, 1, 6, 0));
    assert_eq!((told.claimed, told.verdict), (Some(0.1), OverallVerdict::Reproduced));
    let none = one(&serde_json::from_str(CLAIM).unwrap(), &[&maps[6]]);
    assert_eq!((none.median, none.sign_p, none.share_interval), (None, None, [0.0, 1.0]));
    assert_eq!((none.verdict, none.claimed), (OverallVerdict::CannotTell, None));
}

#[test]
fn infinite_effects_keep_their_place_and_cross_as_null() {
    let told = over(&[f64::NEG_INFINITY, f64::NEG_INFINITY, 0.25, 0.5, 0.5, 0.5], None);
    assert_eq!((told.median, told.low), (Some(0.375), Some(f64::NEG_INFINITY)));
    let json = serde_json::to_value(&told).unwrap();
    assert!(json["low"].is_null() && json["high"] == 0.5 && json["verdict"] == "depends-on-map", "{json}");
}
