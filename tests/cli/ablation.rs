//! `compare --ablate`: a planner without each of its components.
use super::folder::Folder;

#[test]
fn an_ablation_needs_no_question() {
    let folder = Folder::with_question("ablation");
    let asked = ["--ablate", "rank-based-ant-system", "--set", "ants=4", "--set", "iterations=3", "--out", "out"];
    folder.write("Wall 2.csv", "0,1,0\n0,1,0\n0,1,3\n2,1,0\n");
    let (code, said) = folder.compare(&[&asked[..], &["--map", "small.csv", "--map", "Wall 2.csv", "--seeds", "20"]].concat());
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/ablation-rank-based-ant-system.csv");
    assert_eq!(csv.lines().count(), 1 + 2 * 3 * 20);
    assert!(csv.lines().nth(21).is_some_and(|row| row.starts_with("small,without-ranking,1,")), "{csv}");
    let page = folder.read("out/ablation-rank-based-ant-system.md");
    for wanted in [
        "## What each component does",
        "### small: length, mean of the full planner",
        "### wall-2: length, median of the full planner no path",
        "| without deposits by rank |",
        "--ablate rank-based-ant-system --out DIR --set ants=4 --set iterations=3 --seeds 20 --map small.csv --map Wall 2.csv`",
    ] {
        assert!(page.contains(wanted), "`{wanted}` is not in\n{page}");
    }
    // Nobody finds a path through the wall: nothing differs.
    assert!(said.contains("without ranking on wall-2: length, median no path → no path: no difference shown"), "{said}");
    // It opens again, and is an ablation still.
    let (code, said) = folder.compare(&["out/ablation-rank-based-ant-system.json", "--out", "again"]);
    assert!(code == 0 && said.contains("120 of 120 runs the same") && said.contains("without ranking on small"), "{said}");
    assert_eq!(folder.read("again/ablation-rank-based-ant-system.csv"), csv);
}

#[test]
fn what_cannot_be_taken_apart_is_named_with_code_2() {
    let folder = Folder::with_question("ablation-errors");
    for (args, message) in [
        (&["--ablate", "astar", "--map", "small.csv"][..], "--ablate astar: ablation.planner = astar"),
        (&["--ablate", "bee", "--map", "small.csv"], "there is no planner `bee`"),
        (&["--ablate", "ship", "--map", "none.csv"], "cannot read none.csv"),
        (&["--ablate", "ship", "--map", "small.csv", "--map", "small.csv"], "instances.id = small"),
        (&["--ablate", "ship", "--map", "small.csv", "--set", "rho=2"], "rho = 2 is outside"),
        (&["--ablate", "ship"], "--map"),
        (&["q.toml", "--ablate", "ship", "--map", "small.csv"], "cannot be used with"),
        (&["q.toml", "--set", "rho=0.5"], "--ablate"),
    ] {
        let (code, said) = folder.compare(&[args, &["--out", "out"]].concat());
        assert!(code == 2 && said.contains(message), "{message}: {said}");
    }
    assert!(!folder.0.join("out").exists());
}
