//! A card in docs/papers has a table of equations; a row that names a file and functions (`src/….rs`, then `name`, …) is checked here. So are
//! its tables of components, which are the catalog's.

use std::path::{Path, PathBuf};

use formicarium::catalog::{self, CatalogEntry};

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

/// The cards; drawings stand beside them.
fn cards() -> Vec<PathBuf> {
    let files = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/papers").read_dir().expect("the cards");
    files.map(|file| file.expect("readable").path()).filter(|path| path.extension().is_some_and(|e| e == "md")).collect()
}

#[test]
fn every_function_that_a_card_names_is_in_its_file() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for card in cards() {
        let text = std::fs::read_to_string(&card).expect("text");
        let pairs = named(&text);
        assert!(!pairs.is_empty(), "{} names no function", card.display());
        for (file, name) in pairs {
            let source = std::fs::read_to_string(root.join(file)).unwrap_or_else(|e| panic!("{}: {file}: {e}", card.display()));
            assert!(source.contains(&format!("fn {name}(")), "{}: no `{name}` in {file}", card.display());
        }
    }
}

/// The table of a planner's components, as its card has it.
fn components(planner: &CatalogEntry) -> String {
    let head = format!("| component of `{}` | what the paper adds | taken out by |\n|---|---|---|\n", planner.id);
    let row = |c: &catalog::ComponentEntry| {
        let values: Vec<String> = c.without.iter().map(|(key, value)| format!("`{key}={value}`")).collect();
        format!("| {} (`{}`) | {} | {} |\n", c.name, c.id, c.adds, values.join(", "))
    };
    head + &planner.components.iter().map(row).collect::<String>()
}

#[test]
fn every_card_has_the_components_of_its_planners() {
    let planners = catalog::catalog().planners;
    for card in cards() {
        let text = std::fs::read_to_string(&card).expect("text");
        let line = text.lines().find(|l| l.starts_with("Planners:")).expect("its planners");
        let own: Vec<&CatalogEntry> =
            planners.iter().filter(|p| !p.components.is_empty() && quoted(line).any(|q| q == p.id)).collect();
        assert!(!own.is_empty(), "{} names no planner with components", card.display());
        for planner in own {
            let table = components(planner);
            assert!(text.contains(&table), "{} should have\n{table}", card.display());
        }
    }
}
