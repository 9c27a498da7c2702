//! A whole analysis of runs that are written down here; references are SciPy 1.17's.

use std::sync::Arc;

use super::*;
use crate::comparison::question::Question;
use crate::comparison::row::{Found, Improvement, Row, Spent, Task};
use crate::comparison::{Comparison, Seen};
use crate::map::{Grid, Movement, Point};
use crate::planner::Status;
use crate::scenario::Scenario;
use serde_json::json;

/// Corridors of 11 cells, optimum 10; three entries and one that cannot be run.
fn comparison(maps: usize) -> Comparison {
    let ids: Vec<String> = (0..maps).map(|i| format!("map-{i}")).collect();
    let entry = |id: &str, role: &str| {
        json!({ "id": id, "label": id, "role": role, "planner": "ant-system", "set": { "ants": 3 },
                "published": { "map-0": { "length": 9.9, "turns": 4 } } })
    };
    let question: Question = serde_json::from_value(json!({
        "format": "formicarium/question@1", "title": "t", "asks": "?", "seeds": { "from": 1, "count": 40 },
        "instances": ids.iter().map(|id| json!({ "id": id, "map": "m.json" })).collect::<Vec<_>>(),
        "entries": [entry("a", "improved"), entry("b", "baseline"), entry("c", "other"),
                    { "id": "d", "label": "d", "role": "other", "missing": "nowhere", "published": { "map-0": { "length": 10 } } }],
        "claims": [{ "id": "shorter", "says": "shorter", "improved": "a", "baseline": "b", "measure": "length", "direction": "less", "size": 0.01 }]
    }))
    .unwrap();
    let corridor = |map: usize| {
        let grid = Grid::open(11, 1 + map as u32).expect("a usable size");
        Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(10, 0)).expect("usable"))
    };
    Comparison::new(question, (0..maps).map(corridor).collect()).unwrap()
}

/// A run that finds a path of this length in its third iteration; infinite: none.
fn row(instance: usize, entry: usize, seed: u32, length: f64) -> Row {
    let spent =
        |n: u64| Spent { iterations: Some(n), constructed_paths: Some(3 * n), ant_moves: Some(30 * n), cell_expansions: Some(0) };
    let found = length.is_finite();
    Row {
        task: Task { instance, entry, seed },
        status: Status::BudgetSpent,
        found: found.then_some(Found {
            length,
            turns: Some(2),
            turn_index: None,
            weight: None,
            value: length,
            clearance: None,
            driving: None,
        }),
        effort: spent(9),
        trace: if found { vec![Improvement { value: length, spent: spent(3) }] } else { Vec::new() },
        digest: String::new(),
    }
}

/// Samples with many ties, as SciPy was given them, 20 longer.
fn tied(factor: u32, modulus: u32, shift: f64) -> Vec<f64> {
    (0..40).map(|i| f64::from(i * factor % modulus) / 2.0 - shift + 20.0).collect()
}

fn three() -> Vec<Row> {
    let samples = [tied(7919, 23, 0.0), tied(104_729, 29, 1.0), tied(31, 17, 0.5)];
    let of = |(entry, sample): (usize, &Vec<f64>)| {
        (1..).zip(sample.clone()).map(move |(seed, v)| row(0, entry, seed, v)).collect::<Vec<_>>()
    };
    samples.iter().enumerate().flat_map(of).collect()
}

fn analysed(comparison: &Comparison, rows: &[Row]) -> Analysis {
    whole(&Samples::new(comparison, rows.iter().map(Seen::from)), &mut Intervals::default())
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * b.abs(), "{a} is not {b}");
}

#[test]
fn summaries_and_pairs_are_scipys() {
    let comparison = comparison(1);
    let analysis = analysed(&comparison, &three());
    let map = &analysis.instances[0];
    let summary = map.entries[0].summary.unwrap();
    assert_eq!(
        (summary.least, summary.lower, summary.median, summary.upper, summary.greatest),
        (20.0, 22.875, 25.75, 28.5, 31.0)
    );
    close(summary.mean, 25.575);
    close(summary.deviation.unwrap(), 3.411_049_165_616_997);
    let tests: Vec<(usize, usize)> = map.pairs.iter().map(|p| (p.first, p.second)).collect();
    assert_eq!(tests, [(0, 1), (0, 2), (1, 2)]);
    let signed = [(408.0, 0.978_541_745_142_374_5), (179.0, 0.001_873_548_029_445_640_2), (227.5, 0.023_304_525_694_551_322)];
    let ranked = [(813.5, 0.900_379_977_432_766_5), (1095.5, 0.004_485_659_867_688_062), (1025.5, 0.030_225_561_888_935_954)];
    for ((pair, signed), ranked) in map.pairs.iter().zip(signed).zip(ranked) {
        let (w, u) = (pair.wilcoxon.unwrap(), pair.mann_whitney.unwrap());
        assert_eq!((w.statistic, u.statistic), (signed.0, ranked.0));
        close(w.p, signed.1);
        close(u.p, ranked.1);
        // U of the first counts where it is larger; A where it is better, so that they add up.
        close(pair.a12, 1.0 - u.statistic / 1600.0);
    }
    // Holm: the smallest p three times, the next one twice, the last one once.
    close(map.pairs[1].wilcoxon_holm.unwrap(), 3.0 * signed[1].1);
    close(map.pairs[2].wilcoxon_holm.unwrap(), 2.0 * signed[2].1);
    close(map.pairs[0].wilcoxon_holm.unwrap(), signed[0].1);
    assert!(map.pairs.iter().all(|pair| pair.paired));
}

#[test]
fn ranks_over_maps_are_scipys() {
    // friedmanchisquare of these four rows.
    let medians = [[13.0, 11.0, 12.0], [14.0, 14.0, 11.0], [19.0, 17.0, 18.0], [15.0, 12.0, 12.0]];
    let comparison = comparison(4);
    let of_map = |(map, of): (usize, &[f64; 3])| {
        of.iter().enumerate().flat_map(|(entry, &v)| [row(map, entry, 1, v), row(map, entry, 2, v)]).collect::<Vec<_>>()
    };
    let rows: Vec<Row> = medians.iter().enumerate().flat_map(of_map).collect();
    let ranks = analysed(&comparison, &rows).ranks.unwrap();
    close(ranks.statistic, 5.285_714_285_714_286);
    close(ranks.p, 0.071_157_671_208_081_9);
    assert_eq!((ranks.degrees, ranks.maps, &ranks.entries[..]), (2, 4, &[0, 1, 2][..]));
    assert_eq!(ranks.mean_ranks, [2.875, 1.5, 1.625]);
    assert_eq!(ranks.by_map, [[3.0, 1.0, 2.0], [2.5, 2.5, 1.0], [3.0, 1.0, 2.0], [3.0, 1.5, 1.5]]);
    assert_eq!(ranks.pairs.iter().map(|p| (p.first, p.second)).collect::<Vec<_>>(), [(0, 1), (0, 2), (1, 2)]);
    // An entry that has no runs on one of the maps takes no part.
    let fewer: Vec<Row> = rows.into_iter().filter(|r| (r.task.instance, r.task.entry) != (2, 1)).collect();
    assert_eq!(analysed(&comparison, &fewer).ranks.unwrap().entries, [0, 2]);
}

#[test]
fn runs_without_a_path_are_counted_and_never_left_out() {
    let comparison = comparison(1);
    let inf = f64::INFINITY;
    let lengths = [10.0, 10.5, 12.0, inf, inf];
    let rows: Vec<Row> = (1..).zip(lengths).map(|(seed, v)| row(0, 0, seed, v)).collect();
    let analysis = analysed(&comparison, &rows);
    let entry = &analysis.instances[0].entries[0];
    assert_eq!((entry.runs, entry.expected, entry.with_path, entry.optimal, entry.impossible), (5, 40, 3, 1, 0));
    assert_eq!(entry.values, [Some(10.0), Some(10.5), Some(12.0), None, None]);
    // The median of all five is 12, that of the three with a path 10.5.
    assert_eq!((entry.median(), entry.summary.unwrap().median), (Some(12.0), 10.5));
    // Gaps 0, 0.05 and 0.2; a bin is 0.02 wide: 0.19 (95 %) / 12 = 0.0158.
    let edges = &analysis.instances[0].gap_edges;
    assert_eq!((edges[1], edges.len(), entry.gap_counts.iter().sum::<u32>()), (0.02, 11, 3));
    assert_eq!((entry.gap_counts[0], entry.gap_counts[2], entry.gap_counts[10]), (1, 1, 1));
    let last = entry.band.last().unwrap();
    assert_eq!((last.x, last.lower, last.median, last.upper), (27.0, Some(10.5), Some(12.0), None));
    // Of 5 · 6 pairs: three runs reach 12, two 11 and 10.5, one 10.2, 10.1 and 10.
    assert_eq!(entry.ecdf.last().unwrap().share, (3 + 2 + 2 + 1 + 1 + 1) as f64 / 30.0);
    // Until 12: (3 · 9 + 2 · 27) / 3.
    assert_eq!(entry.running_times[0].expected, Some(27.0));
}

#[test]
fn published_numbers_lie_among_the_runs_or_cannot_be() {
    let comparison = comparison(1);
    let rows = [row(0, 0, 1, 10.0), row(0, 0, 2, 10.5), row(0, 1, 1, 9.94)];
    let analysis = analysed(&comparison, &rows);
    let of = |entry: usize| analysis.instances[0].entries[entry].published.unwrap();
    // 9.9 means 9.95 at most: below the optimum.
    let a = of(0);
    assert_eq!((a.value, a.optimum, a.turns, a.impossible), (Some(9.9), Some(10.0), Some(4.0), true));
    assert_eq!((a.below_all, a.share_at_or_below), (true, Some(0.0)));
    // 9.94 reads 9.9.
    assert_eq!((of(1).below_all, of(1).share_at_or_below), (false, Some(1.0)));
    // Nothing was run; the other entries' optimum tells.
    let d = of(3);
    assert_eq!((d.optimum, d.impossible, d.below_all, d.share_at_or_below), (Some(10.0), false, false, None));
    assert!(analysis.instances[0].entries[1].impossible == 1);
}

#[test]
fn nothing_is_known_of_what_has_not_been_run() {
    let comparison = comparison(2);
    let analysis = analysed(&comparison, &[]);
    assert!(analysis.ranks.is_none() && analysis.instances.iter().all(|map| map.pairs.is_empty()));
    let entry = &analysis.instances[0].entries[0];
    assert_eq!((entry.runs, entry.success_interval, entry.summary), (0, [0.0, 1.0], None));
    assert!(entry.band.is_empty() && entry.ecdf.is_empty() && entry.mean_interval.is_none());
    assert_eq!(analysis.instances[0].entries[3].origin, Origin::Missing);
    assert!(analysis.verdicts.iter().all(|line| line.verdict == VerdictKind::CannotTell));
    // Runs of an entry or a map that there is not are no runs.
    let strange = [row(7, 0, 1, 10.0), row(0, 9, 1, 10.0)];
    assert_eq!(analysed(&comparison, &strange), analysis);
}

#[test]
fn without_intervals_there_are_no_verdicts_and_all_else_is_the_same() {
    let comparison = comparison(1);
    let rows = three();
    let samples = Samples::new(&comparison, rows.iter().map(Seen::from));
    let quick = analyse(&samples, Axis::ConstructedPaths, None);
    let full = whole(&samples, &mut Intervals::default());
    assert!(quick.verdicts.is_empty() && quick.instances[0].entries[0].mean_interval.is_none());
    let [low, high] = full.instances[0].entries[0].mean_interval.unwrap();
    assert!(low < 25.575 && 25.575 < high);
    assert_eq!((quick.ranks, &quick.instances[0].pairs), (full.ranks, &full.instances[0].pairs));
    assert_eq!(full.verdicts.len(), 1);
}

#[test]
fn what_crosses_to_the_page_has_numbers_or_null() {
    let comparison = comparison(1);
    let rows: Vec<Row> = (1..=30).flat_map(|seed| [row(0, 0, seed, f64::INFINITY), row(0, 1, seed, 11.0)]).collect();
    let analysis = analysed(&comparison, &rows);
    let line = &analysis.verdicts[0];
    assert_eq!((line.improved_value, line.baseline_value, line.medians), (None, Some(11.0), None));
    assert_eq!(line.verdict, VerdictKind::Opposite);
    let json = serde_json::to_value(&analysis).unwrap();
    assert_eq!((&json["axis"], &json["verdicts"][0]["verdict"]), (&"constructed-paths".into(), &"opposite".into()));
    assert!(json["instances"][0]["entries"][0]["summary"].is_null() && json.get("comparisons").is_none());
}

#[test]
fn the_matrix_has_a_row_a_map_and_one_ranking() {
    let comparison = comparison(2);
    let inf = f64::INFINITY;
    // Two runs each. On the first map medians 11, 10.5 and 11 (of all runs ∞: one without a path); on the second one 10, 12 and 11.
    let runs = [[[11.0, 11.0], [10.0, 11.0], [11.0, inf]], [[10.0, 10.0], [12.0, 12.0], [10.0, 12.0]]];
    let of_map = |(map, of): (usize, &[[f64; 2]; 3])| {
        of.iter().enumerate().flat_map(|(e, v)| [row(map, e, 1, v[0]), row(map, e, 2, v[1])]).collect::<Vec<_>>()
    };
    let rows: Vec<Row> = runs.iter().enumerate().flat_map(of_map).collect();
    let analysis = analysed(&comparison, &rows);
    let Matrix { rows: told, overall } = &analysis.matrix;
    let column = |number: fn(&MatrixCell) -> Option<f64>| -> Vec<Vec<Option<f64>>> {
        told.iter().map(|row| row.cells.iter().map(number).collect()).collect()
    };
    let some = |rows: [[f64; 3]; 2]| -> Vec<Vec<Option<f64>>> {
        rows.iter().map(|row| row.iter().copied().map(Some).chain([None]).collect()).collect()
    };
    assert_eq!(column(|c| c.median), some([[11.0, 10.5, 11.0], [10.0, 12.0, 11.0]]));
    // The optimum is 10.
    let gaps = column(|c| c.gap.map(|gap| libm::round(gap * 1e9) / 1e9));
    assert_eq!(gaps, some([[0.1, 0.05, 0.1], [0.0, 0.2, 0.1]]));
    assert_eq!(column(|c| c.success), some([[1.0, 1.0, 0.5], [1.0, 1.0, 1.0]]));
    assert_eq!(column(|c| c.rank), some([[2.0, 1.0, 3.0], [1.0, 3.0, 2.0]]));
    let ranks: Vec<_> = overall.iter().map(|o| o.mean_rank).collect();
    assert_eq!(ranks, [Some(1.5), Some(2.0), Some(2.5), None]);
    // The test ranks alike.
    assert_eq!(analysis.ranks.unwrap().mean_ranks, [1.5, 2.0, 2.5]);
    let gaps: Vec<_> = overall.iter().map(|o| o.mean_gap.map(|gap| libm::round(gap * 1e9) / 1e9)).collect();
    assert_eq!(gaps, [Some(0.05), Some(0.125), Some(0.1), None]);
    assert_eq!((overall[2].success, overall[3].success), (Some(0.75), None));
    assert_eq!(overall.iter().map(|o| o.unranked).collect::<Vec<_>>(), [None, None, None, Some(Unranked::NotOnEveryMap)]);
}

#[test]
fn the_matrix_of_one_map_ranks_all_the_same() {
    let comparison = comparison(1);
    let rows = [row(0, 0, 1, 11.0), row(0, 1, 1, 11.0), row(0, 2, 1, 10.0)];
    let analysis = analysed(&comparison, &rows);
    assert!(analysis.ranks.is_none());
    let ranks: Vec<_> = analysis.matrix.rows[0].cells.iter().map(|cell| cell.rank).collect();
    assert_eq!(ranks, [Some(2.5), Some(2.5), Some(1.0), None]);
    // Before anything is run there is a row as well.
    let empty = analysed(&comparison, &[]).matrix;
    assert_eq!((empty.rows.len(), empty.overall[0].unranked), (1, Some(Unranked::NotOnEveryMap)));
}

#[test]
fn what_is_impossible_is_compared_with_nobody() {
    let comparison = comparison(2);
    // One of the 40 runs of `b` on the first map is shorter than the corridor.
    let all = |map: usize, entry, length| (1..=40).map(move |seed| row(map, entry, seed, length));
    let mut rows: Vec<Row> = (0..2).flat_map(|map| (0..3).flat_map(move |e| all(map, e, 11.0 + e as f64))).collect();
    rows[40] = row(0, 1, 1, 9.0);
    let analysis = analysed(&comparison, &rows);
    let [first, second] = [0, 1].map(|map| &analysis.instances[map]);
    assert_eq!(first.pairs.iter().map(|p| (p.first, p.second)).collect::<Vec<_>>(), [(0, 2)]);
    assert_eq!(second.pairs.len(), 3);
    assert_eq!((first.entries[1].impossible, first.entries[1].no_running_time), (1, Some(NoRunningTime::Impossible)));
    assert!(first.entries[1].running_times.is_empty() && !second.entries[1].running_times.is_empty());
    assert_eq!(analysis.ranks.as_ref().unwrap().entries, [0, 2]);
    let matrix = &analysis.matrix;
    assert_eq!((matrix.rows[0].cells[1].rank, matrix.rows[1].cells[1].rank, matrix.rows[0].cells[1].impossible), (None, None, 1));
    assert_eq!((matrix.overall[1].unranked, matrix.overall[1].mean_gap), (Some(Unranked::Impossible), None));
    assert_eq!(matrix.rows[0].cells.iter().map(|cell| cell.rank).collect::<Vec<_>>(), [Some(1.0), None, Some(2.0), None]);
    // Of a claim about it nothing can be told, on that map.
    let verdicts: Vec<_> = analysis.verdicts.iter().map(|line| (line.verdict, line.why.as_str())).collect();
    assert_eq!(verdicts[0], (VerdictKind::CannotTell, "runs of one of the two are impossible on this map"));
    assert_ne!(verdicts[1].0, VerdictKind::CannotTell);
}
