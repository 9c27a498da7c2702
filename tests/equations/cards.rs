//! A card in docs/papers has a table of equations; a row that names a file and functions (`src/….rs`, then `name`, …) is checked here.

use std::path::Path;

/// What stands between backticks.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// The (file, function) pairs of a card.
fn named(card: &str) -> Vec<(&str, &str)> {
    let mut pairs = Vec::new();
    for row in card.lines().filter(|l| l.starts_with('|')) {
        let cells: Vec<&str> = row.split('|').collect();
        for pair in cells.windows(2) {
            let file = quoted(pair[0]).find(|q| q.starts_with("src/") && q.ends_with(".rs"));
            pairs.extend(file.into_iter().flat_map(|f| quoted(pair[1]).map(move |name| (f, name))));
        }
    }
    pairs
}

#[test]
fn every_function_that_a_card_names_is_in_its_file() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let cards = root.join("docs/papers").read_dir().expect("the cards");
    for card in cards.map(|c| c.expect("readable").path()) {
        let text = std::fs::read_to_string(&card).expect("text");
        let pairs = named(&text);
        assert!(!pairs.is_empty(), "{} names no function", card.display());
        for (file, name) in pairs {
            let source = std::fs::read_to_string(root.join(file)).unwrap_or_else(|e| panic!("{}: {file}: {e}", card.display()));
            assert!(source.contains(&format!("fn {name}(")), "{}: no `{name}` in {file}", card.display());
        }
    }
}
