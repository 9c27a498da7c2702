//! Files that are joined to a question of two maps.

use std::sync::Arc;

use super::*;
use crate::comparison::Comparison;
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::{FORMAT, Question};
use crate::formats::import_results;
use crate::map::{Grid, Point};
use crate::planner::Status;
use crate::scenario::{Scenario, ScenarioSpec};
use serde_json::json;

/// Two open maps, 6 × 5 and 9 × 1: their optima are 1 + 4√2 = 6.656854… and 8.
fn comparison() -> Comparison {
    let question: Question = serde_json::from_value(json!({
        "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 2 },
        "instances": [{ "id": "open", "map": "open.json" }, { "id": "lane", "map": "long-lane.map" }],
        "entries": [
            { "id": "ants", "label": "Ants", "role": "other", "planner": "ant-system" },
            { "id": "mine", "label": "mine", "role": "other", "results": "m.csv" }
        ]
    }))
    .unwrap();
    let map = |width, height| {
        let grid = Grid::open(width, height).unwrap();
        let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(width - 1, height - 1));
        Arc::new(Scenario::new(grid, spec).unwrap())
    };
    Comparison::new(question, vec![map(6, 5), map(9, 1)]).unwrap()
}

fn results(text: &str) -> ImportedResults {
    import_results(text.as_bytes(), "folder/own.csv").unwrap()
}

fn refused(text: &str) -> String {
    join(comparison(), &results(text), None).unwrap_err().to_string()
}

#[test]
fn entries_of_a_file_become_entries_with_rows() {
    let text = "entry,instance,seed,length,turns,iterations\nAnts,open,7,7.5,3,12\nAnts,LANE,7,8,0,1\nants,long-lane,3,,,\n";
    let joined = join(comparison(), &results(text), None).unwrap();
    let entries: Vec<_> = joined.question.entries.iter().map(|e| (e.id.as_str(), e.label.as_str())).collect();
    assert_eq!(entries, [("ants", "Ants"), ("mine", "mine"), ("ants-2", "Ants (own.csv)"), ("ants-3", "ants")]);
    assert_eq!(joined.question.entries[2].results.as_deref(), Some("own.csv"));
    let tasks: Vec<_> = joined.imported.iter().map(|r| (r.task.instance, r.task.entry, r.task.seed)).collect();
    assert_eq!(tasks, [(0, 2, 7), (1, 2, 7), (1, 3, 3)]);
    let row = &joined.imported[0];
    assert_eq!((row.value(RunMeasure::Length), row.value(RunMeasure::Turns)), (Some(7.5), Some(3.0)));
    assert_eq!((row.value(RunMeasure::IterationOfBest), row.value(RunMeasure::AntMoves)), (Some(12.0), None));
    assert_eq!((joined.imported[2].found, joined.imported[2].status), (None, Status::BudgetSpent));
    // Nothing of it is to be run, and what was to be run still is.
    assert_eq!(joined.tasks(), comparison().tasks());
}

#[test]
fn an_entry_of_the_question_takes_its_runs_from_a_file() {
    let one = fill(comparison(), 1, &results("instance,length\nopen,7\nopen,8\n")).unwrap();
    assert_eq!(one.imported.iter().map(|r| (r.task.entry, r.task.seed)).collect::<Vec<_>>(), [(1, 1), (1, 2)]);
    let several = "entry,instance,length\nother,open,7\nMine,open,9\n";
    let two = fill(one, 1, &results(several)).unwrap();
    assert_eq!(two.imported.len(), 3);
    let error = fill(comparison(), 1, &results(&several.replace("Mine", "yours"))).unwrap_err().to_string();
    assert!(error.contains("entries.mine.results") && error.contains("other, yours"), "{error}");
}

#[test]
fn where_runs_belong_is_said_or_asked_for() {
    assert!(
        refused("instance,length\ncave,7\n").contains("results.instance = cave cannot be used: it must be one of open, lane")
    );
    assert!(refused("length\n7\n").contains("the file does not say on which map its runs are"));
    let place = |text: &str, instance| join(comparison(), &results(text), instance).unwrap().imported[0].task.instance;
    assert_eq!((place("length\n7\n", Some(1)), place("instance,length\ncave,7\n", Some(1))), (1, 1));
    // A name that is known wins.
    assert_eq!(place("instance,length\nopen.json,7\n", Some(1)), 0);
    let twice = "instance,seed,length\nopen,1,7\nopen.json,1,8\n";
    assert!(refused(twice).contains("results.seed = 1"));
    assert!(join(comparison(), &results("length\n7\n"), Some(2)).is_err());
}

#[test]
fn the_optimum_is_met_within_the_printed_digits_and_beaten_by_none() {
    let with = |text: &str| join(comparison(), &results(text), Some(0)).unwrap();
    let one = |length: &str| {
        let comparison = with(&format!("length\n{length}\n"));
        let row = comparison.imported[0].clone();
        (comparison.gap(&row), comparison.value(&row, RunMeasure::Optimal), comparison.impossible(&row))
    };
    // 6.656854…: with six digits, three, one and as f32; 6.65 is not a rounded one.
    for printed in ["6.656854", "6.657", "6.7", "6.656854249492381", "6.6568541"] {
        assert_eq!(one(printed), (Some(0.0), Some(1.0), false), "{printed}");
    }
    for printed in ["6.65", "6.6567", "6"] {
        assert!(one(printed).2, "{printed}");
        assert_eq!(one(printed).1, Some(0.0), "{printed}");
    }
    assert!(!one("6.658").2 && one("6.658").1 == Some(0.0) && one("nan").1 == Some(0.0) && !one("nan").2);
    // The digits are those of all runs of the entry: 7 beside 6.656854 is 7.000000.
    let both = with("seed,length\n1,6.656854\n2,7\n");
    assert!(both.gap(&both.imported[1]).unwrap() > 0.05);
}

#[test]
fn values_are_ranked_in_the_digits_that_both_have() {
    let joined = join(comparison(), &results("entry,length\nA,6.66\nB,6.6568543\nC,7\n"), Some(0)).unwrap();
    let ours = 6.656_854_249_492_381;
    let common = |entries: &[usize]| joined.in_common_digits(entries, RunMeasure::Length, ours);
    // Entry 0 is run here, 2 to 4 are A, B and C with two, seven and no decimals.
    assert_eq!([common(&[0]), common(&[0, 1])], [ours, ours]);
    assert_eq!([common(&[0, 2]), common(&[3, 0]), common(&[0, 2, 3, 4])], [6.66, 6.656_854_2, 7.0]);
    assert_eq!(joined.in_common_digits(&[0, 2], RunMeasure::TurnIndex, ours), ours);
    assert_eq!(joined.in_common_digits(&[0, 2], RunMeasure::Length, f64::INFINITY), f64::INFINITY);
    // As many digits as a double has: the last ones depend on the order of a sum.
    let full = join(comparison(), &results("length\n6.656854249492380\n6.656854249492382\n"), Some(0)).unwrap();
    let values = full.imported.iter().map(|row| full.in_common_digits(&[0, 2], RunMeasure::Length, row.found.unwrap().value));
    assert_eq!(values.collect::<Vec<_>>(), [6.656_854_249; 2]);
}

#[test]
fn a_target_is_reached_within_the_printed_digits() {
    use crate::comparison::analysis::whole;
    use crate::comparison::{Intervals, Samples};
    let text = "evaluations,length\n40,6.657\n";
    let joined = join(comparison(), &results(text), Some(0)).unwrap();
    let rows = joined.imported.clone();
    let analysis = whole(&Samples::new(&joined, rows.iter().map(Into::into)), &mut Intervals::default());
    let (map, mine) = (&analysis.instances[0], &analysis.instances[0].entries[2]);
    assert_eq!((mine.optimal, mine.impossible, mine.ecdf.last().map(|p| p.share)), (1, 0, Some(1.0)));
    let last = mine.running_times.last().unwrap();
    assert_eq!((last.successes, last.target), (1, *map.targets.last().unwrap()));
}

#[test]
fn improvements_become_a_trace_of_what_is_better() {
    let text = "seed,evaluations,length,turns\n1,10,9,5\n1,30,8.5,4\n1,50,8.5,3\n1,70,7,2\n1,100,7,2\n";
    let joined = join(comparison(), &results(text), Some(0)).unwrap();
    let row = &joined.imported[0];
    let trace: Vec<_> = row.trace.iter().map(|i| (i.value, i.spent.constructed_paths)).collect();
    assert_eq!(trace, [(9.0, Some(10)), (8.5, Some(30)), (7.0, Some(70))]);
    assert_eq!((row.found.unwrap().turns, row.effort.constructed_paths), (Some(2), Some(100)));
    assert_eq!(row.value(RunMeasure::PathsToBest), Some(70.0));
}

#[test]
fn what_belongs_where_is_told_before_it_is_joined() {
    let file = results("entry,map,length\nA,open,7\nA,cave,8\nB,LANE,\nB,cave,9\n");
    let told = matched(&comparison(), &file);
    let maps: Vec<_> = told.maps.iter().map(|m| (m.name.as_str(), m.runs, m.instance.as_deref())).collect();
    assert_eq!(maps, [("open", 1, Some("open")), ("cave", 2, None), ("LANE", 1, Some("lane"))]);
    let entries: Vec<_> = told.entries.iter().map(|e| (e.label.as_str(), e.runs, e.with_path)).collect();
    assert_eq!((told.runs, told.unnamed, entries), (4, 0, vec![("A", 2, 2), ("B", 2, 1)]));
    assert_eq!(matched(&comparison(), &results("length\n7\n8\n")).unnamed, 2);
    // An entry without runs on the other maps does not join.
    let mut rest = results("entry,map,length\nA,open,7\nB,cave,9\n");
    rest.leave_out(&["cave".into()]);
    assert_eq!(join(comparison(), &rest, None).unwrap().question.entries.len(), comparison().question.entries.len() + 1);
}
