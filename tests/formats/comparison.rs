//! A whole comparison as JSON, and its schema.

use formicarium::comparison::{Comparison, Question, Row, Task};
use formicarium::formats::{Kind, comparison_json, sniff};
use formicarium::map::{Grid, Point};
use formicarium::scenario::{Goal, Scenario, ScenarioSpec, TerrainMoves, TerrainSpec};
use serde_json::{Value, json};

use super::schema::{load, violations};

/// A plane and a surface with a hole in its data; a colony, a search, what cannot be run, and a claim.
fn comparison() -> Comparison {
    let question: Question = serde_json::from_value(json!({
        "format": "formicarium/question@1", "title": "Everything – 全部", "asks": "Does all of it come back?",
        "seeds": { "from": 4_294_967_294u32, "count": 2 }, "budget": { "axis": "moves", "amount": 5000 },
        "instances": [{ "id": "plane", "map": "plane.csv" }, { "id": "hill", "map": "hill.asc", "note": "with a hole" }],
        "entries": [
            { "id": "ants", "label": "ants", "role": "improved", "planner": "ant-system", "preset": "fire",
              "set": { "ants": 4, "iterations": 6, "dead_end": "die" }, "published": { "plane": { "length": 9.5, "turns": 3 } } },
            { "id": "exact", "label": "A*", "role": "baseline", "planner": "astar" },
            { "id": "lost", "label": "lost", "role": "other", "missing": "its formulas are nowhere" }
        ],
        "claims": [{ "id": "shorter", "says": "shorter", "improved": "ants", "baseline": "exact", "measure": "length",
                     "direction": "less", "size": 0.1, "statistic": "median", "instances": ["plane"] }]
    }))
    .unwrap();
    let walls = [0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0];
    Comparison::new(question, vec![plane(&walls), hill(&walls)]).unwrap()
}

fn plane(walls: &[u8]) -> std::sync::Arc<Scenario> {
    let grid = Grid::from_bytes(4, 3, walls).unwrap();
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
    Scenario::new(grid, spec).unwrap().into()
}

fn hill(walls: &[u8]) -> std::sync::Arc<Scenario> {
    let heights = (0..12).map(|i| if i == 6 { f32::NAN } else { 0.1 * i as f32 }).collect();
    let grid = Grid::from_bytes(4, 3, walls).unwrap().with_heights(heights).unwrap();
    let mut spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
    spec.goals = vec![Goal::new(Point::new(3, 2), "top")];
    spec.terrain = Some(TerrainSpec { vertical_unit: 1.0, moves: TerrainMoves::Surface { max_slope: 60.0 } });
    Scenario::new(grid, spec).unwrap().into()
}

fn run_all(comparison: &Comparison) -> Vec<Row> {
    let run = |task: Task| comparison.run(task, &mut || 0.0).unwrap().row;
    comparison.tasks().into_iter().map(run).collect()
}

#[test]
fn a_comparison_comes_out_as_it_went_in() {
    let first = comparison();
    let rows = run_all(&first);
    // Two maps, two entries that run, the last two seeds there are.
    assert_eq!(rows.len(), 8);
    assert_eq!(rows[1].task.seed, u32::MAX);
    for (some, with_rows) in [(&rows[..], true), (&rows[..3], true), (&rows[..], false), (&[], true)] {
        let text = comparison_json::write(&first, some, with_rows);
        assert_eq!(sniff(text.as_bytes(), "anything"), Kind::Comparison);
        let again = comparison_json::open(&text).unwrap();
        assert_eq!(again.rows, if with_rows { some } else { &[] });
        assert_eq!(again.comparison.digest().hex(), first.digest().hex());
        assert_eq!(comparison_json::write_as(&again.comparison, &again.rows, true, again.recorded.as_ref()), text);
    }
    // What was opened runs as what was written.
    let again = comparison_json::open(&comparison_json::write(&first, &[], true)).unwrap();
    assert_eq!(run_all(&again.comparison), rows);
}

#[test]
fn every_comparison_fits_the_schema() {
    let schema = load("comparison");
    let e = comparison();
    let rows = run_all(&e);
    for text in [comparison_json::write(&e, &rows, true), comparison_json::write(&e, &[], true)] {
        let written: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(violations(&schema, &written), Vec::<String>::new());
    }
    let written: Value = serde_json::from_str(&comparison_json::write(&e, &rows, true)).unwrap();
    for (place, value) in [
        ("/format", json!("formicarium/comparison@2")),
        ("/question/seeds/count", json!(0)),
        ("/recorded/experiment", json!("12")),
        ("/rows/0/effort", json!([1, 2, 3])),
        ("/rows/0/task/seed", json!(-1)),
        ("/question/budget/amount", json!(1u64 << 54)),
        ("/rows/0/effort/2", json!(1u64 << 54)),
    ] {
        let mut spoilt = written.clone();
        *spoilt.pointer_mut(place).unwrap() = value;
        assert!(!violations(&schema, &spoilt).is_empty(), "{place}");
        assert!(comparison_json::open(&spoilt.to_string()).is_err() || place.starts_with("/recorded"), "{place}");
    }
}

#[test]
fn counts_above_two_to_the_53rd_are_refused_by_name() {
    let e = comparison();
    let written: Value = serde_json::from_str(&comparison_json::write(&e, &run_all(&e), true)).unwrap();
    let with = |place: &str, value: u64| {
        let mut other = written.clone();
        *other.pointer_mut(place).unwrap() = json!(value);
        comparison_json::open(&other.to_string())
    };
    for (place, name) in [
        ("/rows/0/effort/0", "iterations"),
        ("/rows/0/effort/3", "cell_expansions"),
        ("/rows/0/trace/0/2", "constructed_paths"),
        ("/rows/0/trace/0/3", "ant_moves"),
        ("/question/budget/amount", "budget.amount"),
    ] {
        assert!(with(place, 1 << 53).is_ok(), "{place}");
        let report = with(place, (1 << 53) + 1).unwrap_err().report();
        assert!(report.message.contains(name) && report.message.contains("9007199254740993"), "{place}: {report:?}");
        assert!(!report.hint.is_empty(), "{report:?}");
    }
}

#[test]
fn every_committed_question_fits_the_schema() {
    let alone = load("question");
    assert_eq!(
        (&alone["$id"], &alone["$ref"]),
        (&"formicarium/question@1".into(), &"comparison.schema.json#/$defs/question".into())
    );
    let schema = json!({ "$ref": "#/$defs/question", "$defs": load("comparison")["$defs"] });
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("experiments");
    let folders = [folder.clone(), folder.join("public")];
    let files = folders.iter().flat_map(|folder| folder.read_dir().unwrap().map(|file| file.unwrap().path()));
    let questions: Vec<_> = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml")).collect();
    assert!(questions.len() >= 6, "{questions:?}");
    for path in questions {
        let question: Value = toml::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
        assert_eq!(violations(&schema, &question), Vec::<String>::new(), "{}", path.display());
        // And as it is written within a comparison.
        let written = serde_json::to_value(serde_json::from_value::<Question>(question).unwrap()).unwrap();
        assert_eq!(violations(&schema, &written), Vec::<String>::new(), "{}", path.display());
    }
}

#[test]
fn no_spoilt_byte_makes_it_panic() {
    let e = comparison();
    let text = comparison_json::write(&e, &run_all(&e), true);
    for at in (0..text.len()).step_by(61) {
        for byte in [b'"', b'9', b'-', b'{'] {
            let mut spoilt = text.clone().into_bytes();
            spoilt[at] = byte;
            let Ok(spoilt) = String::from_utf8(spoilt) else { continue };
            if let Ok(opened) = comparison_json::open(&spoilt) {
                opened.record().verify(&opened.comparison, &opened.rows, &opened.rows);
            }
        }
        let _ = comparison_json::open(&text[..text.floor_char_boundary(at)]);
    }
}
