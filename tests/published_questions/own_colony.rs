//! experiments/public/own-colony.toml: every colony takes part, by the setting that its tuning found best, and so do the parts of our own.

use std::collections::{BTreeMap, BTreeSet};

use formicarium::catalog;
use formicarium::comparison::{Entry, Question};
use formicarium::params::{Value, Values};
use formicarium::planner::{Family, Ground, PlannerEntry};

use super::{folder, question, read};

const NAME: &str = "public/own-colony";

/// Colonies that are not asked: the composer, which has no rules of its own, and one whose paths are polylines. Who is younger than the record
/// joins them until it is made anew.
const NOT_ASKED: [&str; 2] = ["custom", "tdi-msaco"];

/// The lines of a table of the tuning below its head, in cells.
fn table(file: &str, separator: char) -> Vec<Vec<String>> {
    let text = read(&folder().join("tuning/own-colony").join(file));
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split(separator).map(str::to_owned).collect()).collect()
}

fn entry<'a>(question: &'a Question, id: &str) -> &'a Entry {
    question.entries.iter().find(|e| e.id == id).unwrap_or_else(|| panic!("no entry {id}"))
}

/// Of each colony the setting of the least cost, the first of equals: the rule of tune.sh.
fn best_settings() -> BTreeMap<String, String> {
    let mut best: BTreeMap<String, (f64, String)> = BTreeMap::new();
    for row in table("runs.csv", ',').into_iter().skip(1) {
        let [planner, setting, .., cost] = &row[..] else { panic!("{row:?}") };
        let cost = cost.parse().expect("a cost");
        if best.get(planner).is_none_or(|b| cost < b.0) {
            best.insert(planner.clone(), (cost, setting.clone()));
        }
    }
    best.into_iter().map(|(planner, (_, setting))| (planner, setting)).collect()
}

/// What a setting sets of a colony, over what planners.txt sets of it.
fn values_of(planner: &str, setting: &str) -> Values {
    let rows = (catalog::find(planner).expect("a planner").specs)();
    let has = |key: &str| rows.iter().any(|row| row.key == key);
    let mut settings = table("settings.csv", ',').into_iter();
    let keys = settings.next().expect("a head");
    let row = settings.find(|row| row[0] == setting).expect("a setting");
    let given = keys.iter().zip(&row).skip(1).filter(|(_, text)| !text.is_empty());
    let named = given.map(|(key, text)| (if key == "rho" && !has("rho") { "rho_gain" } else { key }, Value::parse(text)));
    let mut values: Values = named.filter(|(key, _)| has(key)).map(|(key, value)| (key.to_owned(), value)).collect();
    let lines = table("planners.txt", ' ');
    let of_planner = lines.iter().find(|line| line[0] == planner).expect("a line of planners.txt");
    values.extend(
        of_planner[1..].iter().map(|set| set.split_once('=').expect("KEY=VALUE")).map(|(k, v)| (k.to_owned(), Value::parse(v))),
    );
    values
}

#[test]
fn every_colony_that_goes_by_steps_on_a_plane_takes_part() {
    let goes_by_steps = |e: &&PlannerEntry| e.family == Family::AntColony && e.grounds.contains(&Ground::Plane);
    let colonies = catalog::CATALOG.iter().copied().filter(goes_by_steps).map(|e| e.id.to_owned());
    let colonies: BTreeSet<String> = colonies.filter(|id| !NOT_ASKED.contains(&id.as_str())).collect();
    let tuned: BTreeSet<String> = table("planners.txt", ' ').into_iter().map(|line| line[0].clone()).collect();
    assert_eq!(tuned, colonies);
    let question = question(NAME);
    for id in &colonies {
        assert_eq!(entry(&question, id).planner.as_ref(), Some(id));
        for claim in [format!("shorter-{id}"), format!("optimum-{id}")].iter().filter(|_| id != "formica") {
            assert!(question.claims.iter().any(|c| c.id == *claim && c.improved == "formica" && c.baseline == *id), "{claim}");
        }
    }
    assert_eq!(question.claims[0].improved, "astar", "where A* is better is said first");
}

#[test]
fn every_colony_has_tried_the_same_settings_equally_often() {
    let settings: Vec<String> = table("settings.csv", ',').into_iter().skip(1).map(|row| row[0].clone()).collect();
    let mut tried: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for row in table("runs.csv", ',').into_iter().skip(1) {
        assert_eq!(row[2], "8", "{row:?}");
        tried.entry(row[0].clone()).or_default().push(row[1].clone());
    }
    assert_eq!(tried.len(), table("planners.txt", ' ').len());
    assert!(settings.len() == 42 && tried.values().all(|of| *of == settings), "{tried:?}");
}

#[test]
fn every_colony_runs_by_its_best_setting() {
    let question = question(NAME);
    for (planner, setting) in best_settings() {
        assert_eq!(entry(&question, &planner).set, values_of(&planner, &setting), "{planner}: {setting}");
    }
}

/// What takes a component out of our own colony is what the catalog says; where no proof is to end a run, its budget does.
#[test]
fn parts_are_taken_out_of_our_own_colony_one_at_a_time() {
    let question = question(NAME);
    let own = &entry(&question, "formica").set;
    let components = catalog::find("formica").expect("a planner").components;
    let without = |ids: &[&str]| {
        let taken = ids.iter().map(|id| components.iter().find(|c| c.id == *id).expect("a component"));
        let mut values = own.clone();
        values.extend(taken.flat_map(|c| c.values()));
        if ids.contains(&"proof") {
            values.insert("proof_after".into(), Value::Number(0.0));
        }
        values
    };
    for (id, taken) in [
        ("without-scent", &["scent"][..]),
        ("without-merging", &["merge-and-solve"]),
        ("fixed-corridor", &["adaptive-corridor"]),
        ("without-restarts", &["restarts"]),
        ("unproven", &["proof"]),
        ("ants-alone", &["merge-and-solve", "proof"]),
    ] {
        assert_eq!(
            (entry(&question, id).planner.as_deref(), &entry(&question, id).set),
            (Some("formica"), &without(taken)),
            "{id}"
        );
    }
}

/// The runs of an entry in the record that found a path, and those that found the optimum.
fn runs_of(record: &str, id: &str) -> (usize, usize) {
    let head: Vec<&str> = record.lines().next().expect("a head").split(',').collect();
    let column = |name: &str| head.iter().position(|cell| *cell == name).expect("a column");
    let (of, gap) = (column("entry"), column("gap"));
    let rows = record.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>()).filter(|row| row[of] == id);
    let gaps: Vec<f64> = rows.filter_map(|row| row[gap].parse().ok()).collect();
    (gaps.len(), gaps.iter().filter(|gap| **gap <= 0.0).count())
}

/// The card's table of colonies has the numbers and verdicts of the record; without a proof they are the same.
#[test]
fn the_card_says_what_the_record_says() {
    let [record, runs] = ["md", "csv"].map(|ending| read(&folder().join(format!("records/public/own-colony.{ending}"))));
    let card = read(&folder().join("../docs/papers/formica.md"));
    let question = question(NAME);
    let label = |id: &str| entry(&question, id).label.clone();
    let told = |improved: &str, baseline: &str| {
        let claim = format!("| shorter paths: {} against {} | ", label(improved), label(baseline));
        let row = record.lines().find_map(|line| line.strip_prefix(&claim)).unwrap_or_else(|| panic!("no {claim}"));
        let cells: Vec<&str> = row.trim_end_matches(" |").split(" | ").collect();
        let [better, .., effect, verdict] = cells[..] else { panic!("{row}") };
        let maps = better.split(" [").next().unwrap_or_default();
        format!("{}; {maps}; {effect}", verdict.trim_end_matches(" (no size is claimed)"))
    };
    for id in question.claims.iter().filter_map(|c| c.id.strip_prefix("shorter-")) {
        let (found, optimal) = runs_of(&runs, id);
        assert_eq!(told("unproven", id), told("formica", id));
        let row = format!("| {} | {found} | {optimal} | {} | {} |", label(id), told("formica", id), told("ants-alone", id));
        assert!(card.contains(&row), "the card lacks\n{row}");
    }
}
