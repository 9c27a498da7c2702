//! Dijkstra, A* and jump points against the listed optima of every MovingAI scenario file in the data folder that the environment variable
//! FORMICARIUM_DATA names. The files themselves may not be redistributed, so without the variable this is skipped, aloud.
#![cfg(not(target_arch = "wasm32"))]

use std::path::{Path, PathBuf};
use std::sync::Arc;

use formicarium::catalog;
use formicarium::exact::{Optima, point_robot};
use formicarium::formats::{ScenLine, check_scen, import, import_scen, misfit};
use formicarium::map::{CornerRule, Grid, Movement, Moves};
use formicarium::params::Values;
use formicarium::planner::Status;
use formicarium::scenario::{Goal, Scenario};

/// Scenarios of each file, spread evenly over it.
const SAMPLE: usize = 100;

/// The one file whose list is known not to belong to its map: many of its ends lie on walls.
const INCONSISTENT: &str = "divideandconquer.map.scen";

fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("FORMICARIUM_DATA").map(|f| PathBuf::from(f).join("movingai"));
    if folder.is_none() {
        println!("skipped: FORMICARIUM_DATA is not set, so there are no MovingAI files to compare with");
    }
    folder
}

fn scen_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut files: Vec<_> = entries.map(|e| e.unwrap().path()).filter(|p| p.extension().is_some_and(|e| e == "scen")).collect();
    files.sort();
    files
}

/// The lines of a file and its map.
fn load(scen: &Path) -> (Vec<ScenLine>, Grid) {
    let lines = import_scen(&std::fs::read(scen).unwrap()).unwrap_or_else(|e| panic!("{}: {e}", scen.display())).lines;
    let name = lines[0].map.rsplit('/').next().unwrap().to_string();
    let map = import(&std::fs::read(scen.with_file_name(&name)).unwrap(), &name).unwrap();
    (lines, map.grid)
}

fn spread(lines: &[ScenLine]) -> impl Iterator<Item = &ScenLine> {
    let count = SAMPLE.min(lines.len());
    (0..count).map(move |i| &lines[i * lines.len() / count])
}

/// Length of the shortest path by a planner of the catalog.
fn length(scenario: &Arc<Scenario>, planner: &str) -> Option<f64> {
    let mut planner = catalog::build(scenario, planner, None, &Values::new(), 0).unwrap();
    planner.run();
    planner.best().map(|b| b.length)
}

#[test]
fn exact_planners_find_every_listed_optimum() {
    let Some(folder) = folder() else { return };
    let movement = Movement { moves: Moves::Eight, corner_rule: CornerRule::BothFree };
    let files = scen_files(&folder);
    assert!(!files.is_empty(), "{} holds no .scen", folder.display());
    for scen in files.iter().filter(|f| !f.ends_with(INCONSISTENT)) {
        let (lines, grid) = load(scen);
        assert!(check_scen(&import_scen(&std::fs::read(scen).unwrap()).unwrap(), &grid).is_empty(), "{}", scen.display());
        let mut scenario = Arc::new(Scenario::on(grid, movement, lines[0].start, lines[0].goal).unwrap());
        let mut run = 0;
        for line in spread(&lines) {
            // Only the ends change from line to line: the moves of the map are derived once.
            let s = Arc::make_mut(&mut scenario);
            (s.start, s.goal) = (s.grid.cell(line.start), s.grid.cell(line.goal));
            (s.spec.start, s.spec.goals[0].at) = (line.start, line.goal);
            for planner in ["dijkstra", "astar"] {
                let found = length(&scenario, planner);
                assert!(found.is_some_and(|l| line.fits(l)), "{planner}, {}: {found:?} for {line:?}", scen.display());
            }
            run += 1;
        }
        println!("{}: {run} of {} scenarios, all equal", scen.display(), lines.len());
    }
}

#[test]
fn scenarios_that_do_not_belong_to_their_map_are_named() {
    let Some(folder) = folder() else { return };
    let (lines, grid) = load(&folder.join(INCONSISTENT));
    let notices: Vec<_> = lines.iter().filter_map(|l| misfit(l, &grid)).collect();
    assert!(!notices.is_empty());
    for notice in &notices {
        assert!(notice.message.starts_with("line ") && notice.kind.starts_with("scen-"), "{notice:?}");
    }
    println!("{INCONSISTENT}: {} of {} scenarios have an end on a wall", notices.len(), lines.len());
}

#[test]
fn jump_points_find_every_listed_optimum() {
    let Some(folder) = folder() else { return };
    let mut run = 0;
    for scen in scen_files(&folder).iter().filter(|f| !f.ends_with(INCONSISTENT)) {
        let (lines, grid) = load(scen);
        let scenario = Arc::new(Scenario::on(grid, Movement::default(), lines[0].start, lines[0].goal).unwrap());
        let mut optima = Optima::new(&scenario);
        for line in &lines {
            let asked = scenario.with_ends(line.start, vec![Goal::new(line.goal, "")]).unwrap();
            let found = optima.between(asked.start, asked.goal);
            assert!(found.is_some_and(|l| line.fits(l)), "{}: {found:?} for {line:?}", scen.display());
        }
        run += lines.len();
    }
    println!("{run} scenarios, all equal");
}

#[test]
fn the_shortest_polyline_is_proven_between_the_point_robots_way_and_the_listed_path() {
    let Some(folder) = folder() else { return };
    let movement = Movement { moves: Moves::Eight, corner_rule: CornerRule::BothFree };
    let mut proven = 0;
    for scen in scen_files(&folder).iter().filter(|scen| !scen.ends_with(INCONSISTENT)) {
        let (lines, grid) = load(scen);
        for line in [lines.len() / 3, lines.len() - 1].map(|k| &lines[k]).into_iter().filter(|line| misfit(line, &grid).is_none())
        {
            let scenario = Arc::new(Scenario::on(grid.clone(), movement, line.start, line.goal).unwrap());
            let mut search = catalog::build(&scenario, "any-angle", None, &Values::new(), 0).unwrap();
            assert_eq!(search.run(), Status::Optimal, "{}, line {}", scen.display(), line.line);
            let (found, told) = (search.best().unwrap().length, search.certificate().unwrap());
            assert!(told.complete && told.lower_bound == found && told.expansions == search.effort().cell_expansions);
            let point = point_robot(&scenario).unwrap().unwrap();
            assert!(
                point <= found + 1e-9 && (line.is_unlisted() || found < line.optimal || line.fits(found)),
                "{}, line {}",
                scen.display(),
                line.line
            );
            proven += 1;
        }
    }
    assert!(proven > 20, "{proven} lengths are proven");
}
