//! Eight corridors, of which one cannot stand for the publication's, as each kind of file tells of them.

use std::sync::Arc;

use super::*;
use crate::comparison::analysis::whole;
use crate::comparison::report::{ReportLanguage, Reports, ResultFile, verdicts};
use crate::comparison::row::{Found, Improvement, Row, Spent, Task};
use crate::comparison::{Claim, FrontQuestion, Intervals, Question, Samples, Seen};
use crate::map::{Grid, Movement, Point};
use crate::planner::Status;
use crate::scenario::Scenario;
use serde_json::json;

const MAPS: usize = 8;

fn comparison() -> Comparison {
    let entry = |id: &str, planner: &str| json!({ "id": id, "label": id.to_uppercase(), "role": "other", "planner": planner });
    let claim = |id: &str, measure: &str| json!({ "id": id, "says": format!("less {measure}"), "improved": "new", "baseline": "old", "measure": measure, "direction": "less" });
    let mut shorter = claim("shorter", "length");
    shorter["size"] = json!(0.1);
    let ids: Vec<String> = (0..MAPS).map(|i| format!("map-{i}")).collect();
    let question: Question = serde_json::from_value(json!({
        "format": "formicarium/question@1", "title": "t", "asks": "?", "seeds": { "from": 1, "count": 30 },
        "instances": ids.iter().map(|id| json!({ "id": id, "map": "m.json" })).collect::<Vec<_>>(),
        "entries": [entry("old", "ant-system"), entry("new", "max-min-ant-system")],
        "claims": [shorter, claim("sooner", "running-time")],
        "facts": [{ "instances": ["map-7"], "optimum_at_most": 9.5, "says": "table 1 | 2" }]
    }))
    .unwrap();
    let corridor = |map: usize| {
        let grid = Grid::open(11, 1 + map as u32).unwrap();
        Arc::new(Scenario::on(grid, Movement::default(), Point::new(0, 0), Point::new(10, 0)).unwrap())
    };
    Comparison::new(question, (0..MAPS).map(corridor).collect()).unwrap()
}

/// Every run of `old` has length 20 and never gets near 10; those of `new` are 5 % to 12 % shorter, and find the optimum on no map.
fn rows() -> Vec<Row> {
    let spent = Spent { iterations: Some(3), constructed_paths: Some(30), ant_moves: Some(300), cell_expansions: Some(0) };
    let one = |instance: usize, entry: usize, seed: u32| {
        let length = if entry == 0 { 20.0 } else { 19.0 - 0.2 * instance as f64 };
        Row {
            task: Task { instance, entry, seed },
            status: Status::BudgetSpent,
            found: Some(Found {
                length,
                turns: Some(1),
                turn_index: None,
                weight: None,
                value: length,
                clearance: None,
                driving: None,
            }),
            effort: spent,
            trace: vec![Improvement { value: length, spent }],
            digest: String::new(),
        }
    };
    let tasks = (0..MAPS).flat_map(|map| (0..2).flat_map(move |entry| (1..=30).map(move |seed| (map, entry, seed))));
    tasks.map(|(map, entry, seed)| one(map, entry, seed)).collect()
}

fn files(kinds: &[ResultFile], language: ReportLanguage) -> Vec<String> {
    files_of(comparison(), kinds, language)
}

fn files_of(comparison: Comparison, kinds: &[ResultFile], language: ReportLanguage) -> Vec<String> {
    let rows = rows();
    let analysis = whole(&Samples::new(&comparison, rows.iter().map(Seen::from)), &mut Intervals::default());
    let document = |_| String::new();
    let (comparison, analysis) = (&comparison, &analysis);
    let fronts = &FrontQuestion::default();
    let reports = Reports { comparison, rows: &rows, analysis, command: "c", language, fronts, document: &document };
    kinds.iter().map(|kind| reports.contents(*kind)).collect()
}

#[test]
fn the_page_has_the_verdict_over_maps_first() {
    let page = &files(&[ResultFile::Markdown], ReportLanguage::En)[0];
    let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("no {text} in {page}"));
    // Seven maps of eight: 5 % to 11 %, of 10 %. The least of them is half of it.
    let over = "| less length: NEW against OLD | 7 of 7 maps [65 %, 100 %] | 7 reproduced, 1 cannot tell | 7 / 0 / 0, p = 0.0156 \
                | −8.0 % [−11.0, −5.0] | **reproduced** |";
    let unfit = "| map-7 | the exact optimum is 10.000; published is 9.5 | table 1 \\| 2 |";
    assert!(at(unfit) < at(over) && at(over) < at("### Map by map"));
    at("| less running-time: NEW against OLD | – | 8 cannot tell | 0 / 0 / 0 | – | **cannot tell**: fewer than 6 maps |");
    at("| map-0 | length, mean | −10.0 % | 20.000 → 19.000 | −5.0 % [−5.0, −5.0] | −1.000 [−1.000, −1.000] |");
    at(
        "expected running time to within 1 %, constructed paths | – | – → – | – | – | – | – | – | **cannot tell**: no run of either reaches",
    );
    at("Of 16 comparisons on single maps: 7 reproduced, 0 in direction, 0 partly, 0 without a relevant difference,");
    let chinese = &files(&[ResultFile::Markdown], ReportLanguage::ZhCn)[0];
    assert!(chinese.contains("| 7 张地图中的 7 张 [65%, 100%] | 已复现 7，无法判断 1 |"), "{chinese}");
    assert!(chinese.contains("| map-7 | 精确最优为 10.000，论文报告 9.5 |"), "{chinese}");
}

#[test]
fn programs_read_the_same() {
    let [csv, json, latex] = &files(&[ResultFile::ClaimsCsv, ResultFile::SummaryJson, ResultFile::Latex], ReportLanguage::En)[..]
    else {
        panic!("three files")
    };
    let lines: Vec<&str> = csv.lines().collect();
    // The head, two claims on eight maps, and two over maps.
    assert_eq!(lines.len(), 1 + 2 * MAPS + 2);
    let table = |line: &str| -> Vec<(String, String)> {
        lines[0].split(',').map(String::from).zip(line.split(',').map(String::from)).collect()
    };
    let field = |line: &str, name: &str| table(line).into_iter().find(|(column, _)| column == name).unwrap().1;
    let over = lines[1 + 2 * MAPS];
    let told = ["instance", "claim", "maps", "better_maps", "effect", "effect_low", "overall", "confidence", "p"]
        .map(|name| field(over, name));
    assert_eq!(told, ["", "shorter", "7", "7", "0.08", "0.05", "reproduced", "0.984375", "0.015625"]);
    assert_eq!(
        ["instance", "paired", "verdict", "why"].map(|name| field(lines[8], name)),
        ["map-7", "false", "cannot-tell", "the map contradicts what the publication says of its own"]
    );
    let json: serde_json::Value = serde_json::from_str(json).unwrap();
    assert_eq!((&json["over_maps"][0]["verdict"], &json["unfit"][0]["why"]), (&json!("reproduced"), &json!("optimum")));
    assert!(latex.contains("\\label{tab:claims:over-maps}") && latex.contains("7 of 7 maps [65 \\%, 100 \\%]"));
}

/// The first claim by one reading, and once more by another; the second one by none.
fn with_readings() -> Comparison {
    let mut comparison = comparison();
    let claims = &mut comparison.question.claims;
    let printed = Claim { id: "shorter-printed".into(), reading: Some(PaperReading::Printed), size: None, ..claims[0].clone() };
    claims[0].reading = Some(PaperReading::SecondReading);
    claims.push(printed);
    comparison
}

#[test]
fn readings_stand_beside_each_other_before_all_other_claims() {
    let page = &files_of(with_readings(), &[ResultFile::Markdown], ReportLanguage::En)[0];
    let table = "## Claims by reading\n\n| claim | measure | as printed | second reading |\n|---|---|---|---|\n\
                 | less length | length | **reproduced** (no size is claimed); 7 of 7 maps; −8.0 % [−11.0, −5.0] \
                 | **reproduced**; 7 of 7 maps; −8.0 % [−11.0, −5.0] |\n\n## Claims\n";
    assert!(page.contains(table), "{page}");
    let chinese = &files_of(with_readings(), &[ResultFile::Markdown], ReportLanguage::ZhCn)[0];
    assert!(chinese.contains("| 主张 | 衡量标准 | 按印刷公式 | 第二种读法 |"), "{chinese}");
    let [latex, csv, json] =
        &files_of(with_readings(), &[ResultFile::Latex, ResultFile::ClaimsCsv, ResultFile::SummaryJson], ReportLanguage::En)[..]
    else {
        panic!("three files")
    };
    let at = |label: &str| latex.find(&format!("\\label{{tab:claims:{label}}}")).unwrap();
    assert!(at("readings") < at("over-maps"));
    let ends: Vec<&str> = csv.lines().map(|line| line.rsplit(',').next().unwrap()).collect();
    assert_eq!((ends[0], ends[1], ends[1 + MAPS], ends[1 + 2 * MAPS]), ("reading", "second-reading", "", "printed"));
    assert_eq!(ends[1 + 3 * MAPS..], ["second-reading", "", "printed"], "over maps");
    let json: serde_json::Value = serde_json::from_str(json).unwrap();
    assert_eq!(
        (&json["verdicts"][0]["reading"], &json["over_maps"][2]["reading"]),
        (&json!("second-reading"), &json!("printed"))
    );
    assert!(json["over_maps"][1].get("reading").is_none());
}

#[test]
fn without_readings_nothing_is_said_of_them() {
    for file in
        files(&[ResultFile::Markdown, ResultFile::Latex, ResultFile::ClaimsCsv, ResultFile::SummaryJson], ReportLanguage::En)
    {
        assert!(!file.contains("reading"), "{file}");
    }
}

#[test]
fn the_command_line_says_both() {
    let (comparison, rows) = (comparison(), rows());
    let analysis = whole(&Samples::new(&comparison, rows.iter().map(Seen::from)), &mut Intervals::default());
    let said = verdicts(&comparison, &analysis);
    assert!(said.contains("  shorter: better on 7 of 7 maps (7 reproduced, 1 cannot tell): reproduced\n"), "{said}");
    assert!(said.contains("  sooner: better on 0 of 0 maps (8 cannot tell): cannot tell: fewer than 6 maps\n"), "{said}");
    // Of that many, none by itself.
    assert!(!said.contains(" on map-0"), "{said}");
}
