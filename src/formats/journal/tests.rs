use std::sync::Arc;

use crate::comparison::Question;
use crate::map::{Grid, Point};
use crate::scenario::{Scenario, ScenarioSpec};
use serde_json::json;

use super::*;

/// One map, a colony and A*, two seeds; of the colony so many ants.
fn comparison(ants: u32) -> Comparison {
    let question: Question = serde_json::from_value(json!({
        "format": "formicarium/question@1", "title": "t", "asks": "?", "seeds": { "from": 1, "count": 2 },
        "instances": [{ "id": "open", "map": "open.json" }],
        "entries": [
            { "id": "ants", "label": "ants", "role": "other", "planner": "ant-system", "set": { "iterations": 2, "ants": ants } },
            { "id": "exact", "label": "exact", "role": "other", "planner": "astar" }
        ]
    }))
    .unwrap();
    let grid = Grid::open(4, 3).unwrap();
    let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(3, 2));
    Comparison::new(question, vec![Arc::new(Scenario::new(grid, spec).unwrap())]).unwrap()
}

/// Its rows, and the journal that has them all.
fn journal(comparison: &Comparison) -> (Vec<Row>, String) {
    let run = |task| comparison.run(task, &mut || 0.0).unwrap().row;
    let rows: Vec<Row> = comparison.tasks().into_iter().map(run).collect();
    let lines = JournalLines::of(comparison, None);
    let text = lines.head() + &rows.iter().map(|row| lines.line(row)).collect::<String>();
    (rows, text)
}

#[test]
fn a_journal_gives_its_rows_back() {
    let comparison = comparison(2);
    let (rows, text) = journal(&comparison);
    let lines = JournalLines::of(&comparison, None);
    let whole = text.len();
    assert_eq!(lines.read(text.as_bytes()), Found::Ours { rows: rows.clone(), damaged: 0, whole });
    // Half a line, of which a process was killed in the middle.
    let cut = &text[..whole - 5];
    let kept = cut.rfind('\n').unwrap() + 1;
    assert_eq!(lines.read(cut.as_bytes()), Found::Ours { rows: rows[..3].to_vec(), damaged: 0, whole: kept });
    // A line twice, and lines in another order.
    let twice = text.clone() + text.lines().nth(2).unwrap() + "\n";
    assert_eq!(lines.read(twice.as_bytes()), Found::Ours { rows, damaged: 0, whole: twice.len() });
    assert_eq!(lines.read(b""), Found::Ours { rows: Vec::new(), damaged: 0, whole: 0 });
}

#[test]
fn no_flipped_bit_gives_a_wrong_row() {
    let comparison = comparison(2);
    let (rows, text) = journal(&comparison);
    let lines = JournalLines::of(&comparison, None);
    for bit in 0..8 * text.len() {
        let mut bytes = text.clone().into_bytes();
        bytes[bit / 8] ^= 1 << (bit % 8);
        assert!(lines.is_journal(&bytes), "bit {bit}");
        let Found::Ours { rows: kept, damaged, .. } = lines.read(&bytes) else { panic!("bit {bit}: not ours") };
        assert!(kept.iter().all(|row| rows.contains(row)), "bit {bit}");
        // A flip is in one line; one that makes or takes a line's end is in two, and the last line's end is no damage.
        assert!(kept.len() + 2 >= rows.len() && (damaged > 0 || kept.len() + 1 == rows.len()), "bit {bit}: {damaged} damaged");
    }
}

#[test]
fn what_is_not_from_this_comparison_does_not_count() {
    let (mine, other) = (comparison(2), comparison(3));
    let lines = JournalLines::of(&mine, None);
    let ((rows, text), (_, foreign)) = (journal(&mine), journal(&other));
    assert_eq!(lines.read(foreign.as_bytes()), Found::Other);
    // A line of the other one between ours; and one of ours whose row says it is another task's.
    let mixed = text.clone() + foreign.lines().nth(1).unwrap() + "\n";
    assert_eq!(lines.read(mixed.as_bytes()), Found::Ours { rows: rows.clone(), damaged: 1, whole: 0 });
    let body = format!("{LINE}{}\",\"task\":1,\"row\":{}", lines.digest, rows[0].to_line());
    let wrong = format!("{}{body},\"check\":\"{}\"}}\n", lines.head(), check(&body));
    assert_eq!(lines.read(wrong.as_bytes()), Found::Ours { rows: Vec::new(), damaged: 1, whole: 0 });
    // The same row in other letters is not the row that was written.
    let body = format!("{LINE}{}\",\"task\":0,\"row\":{}", lines.digest, rows[0].to_line().replacen(":", ": ", 1));
    let spaced = format!("{}{body},\"check\":\"{}\"}}\n", lines.head(), check(&body));
    assert_eq!(lines.read(spaced.as_bytes()), Found::Ours { rows: Vec::new(), damaged: 1, whole: 0 });
    let old = text.replacen("journal@2", "journal@1", 1).replace(LINE, "{\"task\":\"");
    assert_eq!(lines.read(old.as_bytes()), Found::Unchecked);
}

#[test]
fn somebody_elses_file_is_no_journal() {
    let lines = JournalLines::of(&comparison(2), None);
    for text in ["my notes\n", "{\"format\":\"mine\"}\n", "\n", "{\"format\":\"formicarium/journey\"}\n"] {
        assert!(!lines.is_journal(text.as_bytes()), "{text}");
    }
    let head = lines.head();
    for text in ["", &head[..20], &head, "{\"format\":\"formicarium/journal@1\",\"engine\":\"0\"}\n"] {
        assert!(lines.is_journal(text.as_bytes()), "{text}");
    }
}

#[test]
fn a_journal_tells_which_comparison_it_needs() {
    let comparison = comparison(2);
    let (_, text) = journal(&comparison);
    assert_eq!(digest_in(text.as_bytes()), Some(comparison.digest().hex()));
    for other in ["", "{}", r#"{"format":"formicarium/result@1","engine":"0","experiment":"0"}"#] {
        assert_eq!(digest_in(other.as_bytes()), None, "{other}");
    }
}
