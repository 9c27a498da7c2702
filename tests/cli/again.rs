//! `compare` of a written comparison: run again and verified.
use super::folder::Folder;

#[test]
fn a_written_comparison_is_compared_again_and_verified() {
    let folder = Folder::with_question("verified");
    assert_eq!(folder.compare(&["q.toml", "--out", "one", "--seeds", "4"]).0, 0);
    let whole = folder.read("one/q.json");
    folder.write("again.json", &whole);
    let (code, said) = folder.compare(&["again.json", "--out", "two"]);
    // Two maps, two entries that run, four seeds.
    assert!(code == 0 && said.contains("recorded results: 16 of 16 runs the same, bit for bit\n"), "{said}");
    for ending in ["csv", "tests.md", "json"] {
        assert_eq!(folder.read(&format!("two/again.{ending}")), folder.read(&format!("one/q.{ending}")), "{ending}");
    }
    // A spot check: fewer seeds are no other question.
    let (code, said) = folder.compare(&["again.json", "--out", "spot", "--seeds", "1"]);
    assert!(code == 0 && said.contains("recorded results: 4 of 16 runs the same") && !said.contains("changed"), "{said}");
}

#[test]
fn what_does_not_come_out_again_is_told_with_its_cause() {
    let folder = Folder::with_question("differs");
    assert_eq!(folder.compare(&["q.toml", "--out", "one", "--seeds", "4"]).0, 0);
    let whole = folder.read("one/q.json");
    let again = |from: &str, to: &str| {
        assert!(whole.contains(from), "{from}");
        folder.write("again.json", &whole.replacen(from, to, 1));
        folder.compare(&["again.json", "--out", "two"])
    };
    // A run's row was changed by hand: seed 6 of A* on the first map is told, and that its digest never stood for it.
    let row = r#"{"task":{"instance":0,"entry":1,"seed":6},"status":"optimal""#;
    let (code, said) = again(row, &row.replace("optimal", "stagnated"));
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("runs of exact on small: the file's runs were changed since their digest was taken"), "{said}");
    // Its digest was changed as well: engine, question and parameters are the same, and nothing explains it.
    let version = env!("CARGO_PKG_VERSION");
    let digest = whole.split(r#""digest":""#).nth(1).and_then(|rest| rest.get(..16)).unwrap();
    let (code, said) = again(digest, "0123456789abcdef");
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("runs of colony on small: the file's runs were changed"), "{said}");
    // Another version, another default, another question: told, and no failure of this engine.
    let (code, said) = again(&format!(r#""engine":"{version}""#), r#""engine":"0.0.1""#);
    assert!(code == 0 && said.contains(&format!("engine: recorded with version 0.0.1, this is {version}")), "{said}");
    let (code, said) = again(r#""ants":3.0"#, r#""ants":5.0"#);
    assert_eq!(code, 0, "{said}");
    let order = ["question or maps were changed since", "parameter colony.ants: recorded with 3.0, now 5.0", "seed 5: digest"];
    let places: Vec<usize> = order.iter().map(|words| said.find(words).unwrap_or_else(|| panic!("`{words}`: {said}"))).collect();
    assert!(places.is_sorted(), "causes first: {said}");
    // Digests alone, as a link has them, and one that no run gives.
    let bare = &whole[..whole.find(",\n\"rows\"").unwrap()];
    folder.write("again.json", &format!("{}}}", bare.replacen(digest_of_runs(bare), "0000000000000000", 1)));
    let (code, said) = folder.compare(&["again.json", "--out", "two"]);
    assert!(code == 1 && said.contains("12 of 16 runs the same") && said.contains("nothing explains it"), "{said}");
}

/// The first digest over the runs of an entry.
fn digest_of_runs(document: &str) -> &str {
    let runs = document.split(r#""runs":[[{"count":4,"digest":""#).nth(1);
    runs.and_then(|rest| rest.get(..16)).unwrap()
}

#[test]
fn the_result_of_one_run_is_no_comparison() {
    let folder = Folder::with_question("one-run");
    folder.write("run.json", r#"{"format": "formicarium/result@1", "planner": "astar", "path": [[0,0],[1,1]]}"#);
    let (code, said) = folder.compare(&["run.json", "--out", "out"]);
    assert!(
        code == 2 && said.contains("the result of a single run") && said.contains("as `compare` or the page writes it"),
        "{said}"
    );
}

#[test]
fn a_document_without_runs_asks_the_same_question() {
    let folder = Folder::with_question("document");
    let printed = folder.run(&["compare", "q.toml", "--document", "--seeds", "2"]);
    assert!(printed.code == 0 && printed.out.starts_with(r#"{"format": "formicarium/comparison@1","#), "{}", printed.out);
    assert!(!printed.out.contains("\n\"rows\"") && !printed.out.contains("\"recorded\""), "{}", printed.out);
    folder.write("asked.json", &printed.out);
    assert_eq!(folder.compare(&["asked.json", "--out", "one"]).0, 0);
    assert_eq!(folder.compare(&["q.toml", "--out", "two", "--seeds", "2"]).0, 0);
    for ending in ["csv", "json"] {
        assert_eq!(folder.read(&format!("one/asked.{ending}")), folder.read(&format!("two/q.{ending}")), "{ending}");
    }
    assert_eq!(folder.compare(&["q.toml", "--document", "--out", "three"]).0, 2);
}
