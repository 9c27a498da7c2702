//! `compare` with results from elsewhere.
use super::folder::{Folder, QUESTION};
use super::journal::journal_of;

/// What somebody else's planner has found on the map `small`, whose optimum is 9.
const MINE: &str = "algorithm,map,seed,length,turns,iterations\nmine,small,5,9.0,6,3\nmine,small,6,9.9,7,1\nmine,small,7,,,\nBad luck,small,5,8.5,2,1\n";

#[test]
fn results_from_elsewhere_stand_beside_ours() {
    let folder = Folder::with_question("results");
    folder.write("mine.csv", MINE);
    let narrow = ["q.toml", "--out", "out", "--seeds", "3", "--results", "mine.csv"];
    let (code, said) = folder.compare(&narrow);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    // Two maps, two entries that run, three seeds; four runs from elsewhere, after ours of the same map.
    assert_eq!(csv.lines().count(), 1 + 2 * 2 * 3 + 4, "{csv}");
    let mine: Vec<&str> = csv.lines().filter(|l| l.starts_with("small,mine,") || l.starts_with("small,bad-luck,")).collect();
    assert_eq!(mine[0], "small,mine,5,complete,9.000000,6,,,3,,,length,9.000000,9.000000,true,0.000000,");
    assert!(mine[1].starts_with("small,mine,6,complete,9.900000,7,,,1,,,length,9.900000,9.000000,true,0.100000,"), "{mine:?}");
    assert_eq!(mine[2], "small,mine,7,budget-spent,,,,,,,,length,,9.000000,true,,");
    // Shorter than the optimum: a negative gap, told and not hidden.
    assert!(
        mine[3].starts_with("small,bad-luck,5,complete,8.500000,2,,,1,,,length,8.500000,9.000000,true,-0.055556,"),
        "{mine:?}"
    );
    let page = folder.read("out/q.md");
    for wanted in
        ["| mine (from elsewhere) |  | results from mine.csv |", "--results mine.csv`", "| mine (from elsewhere) | – | 2 of 3 |"]
    {
        assert!(page.contains(wanted), "`{wanted}` is not in\n{page}");
    }
    // The file that was written holds them, and ours come out of it again, bit for bit.
    let (code, said) = folder.compare(&["out/q.json", "--out", "again"]);
    assert!(code == 0 && said.contains("12 of 12 runs the same, bit for bit"), "{said}");
    assert_eq!(folder.read("again/q.csv"), csv);
    // Our own table is such a file.
    let (code, said) = folder.compare(&["q.toml", "--out", "twice", "--seeds", "3", "--results", "out/q.csv"]);
    assert_eq!(code, 0, "{said}");
    let twice = folder.read("twice/q.csv");
    assert_eq!(twice.lines().count(), 1 + 12 + 16);
    let fields = |entry: &str| {
        let line =
            twice.lines().find(|l| l.starts_with(&format!("small,{entry},5,"))).unwrap_or_else(|| panic!("{entry}: {twice}"));
        line.split(',').skip(3).take(13).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(fields("exact"), fields("exact-2"));
}

#[test]
fn an_empty_table_is_there_to_be_filled_in() {
    let folder = Folder::with_question("template");
    let table = folder.run(&["compare", "q.toml", "--results-template", "--seeds", "2"]).ends(0).out;
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("entry,instance,seed,length,turns,evaluations"));
    assert_eq!(lines.clone().count(), 2 * 2);
    assert_eq!(lines.next(), Some("my planner,small,5,,,"));
    folder.write("mine.csv", &table);
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2", "--results", "mine.csv"]);
    assert!(code == 0 && said.contains("no run of the file has a path"), "{said}");
}

#[test]
fn an_entry_may_take_its_runs_from_a_file_beside_the_question() {
    let folder = Folder::with_question("entry-results");
    std::fs::create_dir_all(folder.0.join("questions")).unwrap();
    folder.write("mine.csv", MINE);
    let entry = "\n[[entries]]\nid = \"mine\"\nlabel = \"My planner\"\nrole = \"other\"\nresults = \"mine.csv\"\n\n[[claims]]";
    folder.write("q.toml", &QUESTION.replacen("\n[[claims]]", entry, 1));
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2"]);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    assert_eq!(csv.lines().filter(|l| l.contains(",mine,")).count(), 3, "{csv}");
    assert!(!csv.contains("bad-luck"));
    assert!(folder.read("out/q.md").contains("| My planner (from elsewhere) |  | results from mine.csv |"));
    // Runs on a map that is not asked for are left out, not refused.
    let (code, said) = folder.compare(&["q.toml", "--out", "wall", "--seeds", "2", "--only", "wall"]);
    assert_eq!(code, 0, "{said}");
    assert!(!folder.read("wall/q.csv").contains("mine"));
    // A map that nobody knows is.
    folder.write("mine.csv", &MINE.replace("small", "smell"));
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert!(code == 2 && said.contains("mine.csv: results.instance = smell") && said.contains("one of small, wall"), "{said}");
    folder.write("mine.csv", "algorithm,length\nmine,9\nmine,9,8\n");
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert!(code == 2 && said.contains("mine.csv: line 3: 3 fields where the header has 2"), "{said}");
    std::fs::remove_file(folder.0.join("mine.csv")).unwrap();
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert!(code == 2 && said.contains("cannot read mine.csv"), "{said}");
}

#[test]
fn data_of_iohanalyzer_needs_the_map_that_it_does_not_name() {
    let folder = Folder::with_question("ioh");
    folder.write("acs.dat", "\"function evaluation\" \"best-so-far f(x)\"\n10 12.5\n40 9.0\n500 9\n");
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2", "--results", "acs.dat"]);
    assert!(code == 2 && said.contains("the file does not say on which map its runs are"), "{said}");
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "2", "--results", "small=acs.dat"]);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    assert!(csv.contains("\nsmall,acs,1,complete,9.000000,,,,,40,,length,9.000000,9.000000,true,0.000000,\n"), "{csv}");
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--results", "cave=acs.dat"]);
    assert!(code == 2 && said.contains("instances = cave") && said.contains("small, wall"), "{said}");
}

#[test]
fn a_comparison_with_results_goes_on_where_it_was() {
    let folder = Folder::with_question("results-journal");
    folder.write("mine.csv", MINE);
    let args = ["q.toml", "--out", "out", "--seeds", "4", "--results", "mine.csv"];
    assert_eq!(folder.compare(&args).0, 0);
    // The journal of a process that was killed after two of its runs, made from the file that it would have written.
    // Its rows are told apart from runs that are done again.
    let journal = journal_of(&folder.read("out/q.json").replace("budget-spent", "stagnated"));
    let journal: String = journal.split_inclusive('\n').take(3).collect();
    std::fs::create_dir_all(folder.0.join("on")).unwrap();
    folder.write("on/q.partial", &journal);
    let on = ["q.toml", "--out", "on", "--seeds", "4", "--results", "mine.csv"];
    assert_eq!(folder.compare(&on).0, 0);
    let (one, other) = (folder.read("out/q.csv"), folder.read("on/q.csv"));
    assert_eq!(one.replace("budget-spent", "stagnated"), other.replace("budget-spent", "stagnated"));
    assert_eq!(other.lines().filter(|l| l.starts_with("small,colony") && l.contains(",stagnated,")).count(), 2, "{other}");
    // Other results are another comparison: nothing of it is kept.
    folder.write("mine.csv", &MINE.replace("9.9", "9.8"));
    folder.write("on/q.partial", &journal);
    assert_eq!(folder.compare(&on).0, 0);
    assert!(!folder.read("on/q.csv").contains("stagnated"));
}

#[test]
fn what_is_impossible_is_marked_in_every_file_and_preferred_in_none() {
    let folder = Folder::with_question("impossible");
    folder.write("mine.csv", MINE);
    let files = "csv,markdown,tests,summary-csv,summary-markdown,latex,matrix-csv,matrix-markdown,matrix-latex";
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--results", "mine.csv", "--files", files]);
    assert_eq!(code, 0, "{said}");
    // Two maps, two entries that run, 40 seeds; four runs from elsewhere.
    let counts = "160 runs, 80 of them by searches that need no seeds, alike on each map, beside 4 runs from elsewhere";
    for file in ["q.md", "q.tests.md", "q.summary.md", "q.tex", "q.matrix.md", "q.matrix.tex"] {
        let text = folder.read(&format!("out/{file}"));
        let mark = if file.ends_with("tex") { "\\textdagger{}" } else { "†" };
        assert!(text.contains("impossible on this map"), "{file}: {text}");
        assert!(text.contains("(from elsewhere)"), "{file}: {text}");
        assert!(file == "q.md" || text.contains(mark), "{file}: {text}");
        assert!(file == "q.tests.md" || text.contains(counts), "{file}: {text}");
        let bold = |line: &&str| line.contains("Bad luck") && (line.contains("**") || line.contains("\\textbf"));
        assert_eq!(text.lines().find(bold), None, "{file}");
    }
    assert!(said.contains(counts), "{said}");
    assert!(!folder.read("out/q.tests.md").contains("| bad-luck"));
}

#[test]
fn the_files_of_the_overview_agree() {
    let folder = Folder::with_question("overview");
    let args = ["q.toml", "--out", "out", "--files", "matrix-csv,matrix-markdown,matrix-latex,summary-csv"];
    let (code, said) = folder.compare(&args);
    assert_eq!(code, 0, "{said}");
    let table = |file: &str| -> Vec<Vec<String>> {
        folder.read(file).lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
    };
    let (overview, summary) = (table("out/q.matrix.csv"), table("out/q.summary.csv"));
    let column = |of: &[Vec<String>], name: &str| -> Vec<String> {
        let at = of[0].iter().position(|column| column == name).unwrap();
        of[1..].iter().map(|line| line[at].clone()).collect()
    };
    // Two maps and all of them, three entries each; one is ranked, for the other has no runs.
    assert_eq!(overview.len(), 1 + 3 * 3);
    for (one, other) in [("median", "median"), ("gap", "median_gap"), ("runs", "runs"), ("objective", "objective")] {
        assert_eq!(column(&overview, one)[..6], column(&summary, other), "{one}");
    }
    let ranks = column(&overview, "rank");
    // Both medians are the optimum; on the wall nobody finds a path. So both share their rank.
    assert_eq!(ranks, ["1.5", "1.5", "", "1.5", "1.5", "", "1.5", "1.5", ""]);
    assert_eq!(column(&overview, "unranked")[8], "not-on-every-map");
    let (page, tex) = (folder.read("out/q.matrix.md"), folder.read("out/q.matrix.tex"));
    assert!(page.contains("| all maps | **rank 1.5** | **rank 1.5** | – |"), "{page}");
    assert!(page.contains("| **no path; rank 1.5; path in 0.0 %** |"), "{page}");
    assert!(tex.contains("\\label{tab:matrix}") && tex.contains("\\textbf{rank 1.5}"), "{tex}");
    // Files of an earlier run are replaced.
    assert_eq!(folder.compare(&args).0, 0);
}

#[test]
fn the_files_of_fronts_agree() {
    let folder = Folder::with_question("fronts");
    let files = "fronts-csv,fronts-markdown,fronts-latex";
    let compare = |more: &[&str]| folder.compare(&[&["q.toml", "--out", "out", "--files", files], more].concat());
    assert_eq!(compare(&[]).0, 0);
    let csv = folder.read("out/q.fronts.csv");
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| lines[0].iter().position(|column| *column == name).unwrap();
    let of = |line: &[&str], name: &str| line[column(name)].to_owned();
    // Every entry of both maps has a line, with points or without.
    let mut seen: Vec<(String, String)> = lines[1..].iter().map(|line| (of(line, "instance"), of(line, "entry"))).collect();
    seen.dedup();
    assert_eq!(seen.len(), 6, "{csv}");
    for line in &lines[1..] {
        assert_eq!(
            (of(line, "first_measure"), of(line, "second_measure"), of(line, "third_measure")),
            ("length".into(), "turns".into(), String::new())
        );
        let is_point = !of(line, "first").is_empty();
        assert_eq!(is_point, of(line, "points") != "0", "{line:?}");
        // What is on the joint front is on its own as well.
        assert!(of(line, "on_joint") != "true" || of(line, "on_own") == "true", "{line:?}");
    }
    let page = folder.read("out/q.fronts.md");
    assert!(page.contains("Length (less is better), turns (less is better); reference point: length "), "{page}");
    assert!(folder.read("out/q.fronts.tex").contains("\\label{tab:fronts:"));
    // Other measures, and a point that is given: it stands in the command.
    let given = ["--fronts", "length,mean-clearance,turns", "--fronts-reference", "99,0,-1"];
    assert_eq!(compare(&given).0, 0, "an earlier file is replaced");
    let page = folder.read("out/q.fronts.md");
    assert!(
        page.contains("mean clearance (more is better)")
            && page.contains("reference point: length 99, mean clearance 0, turns -1"),
        "{page}"
    );
    let tex = folder.read("out/q.fronts.tex");
    assert!(tex.contains("--fronts length,mean-clearance,turns --fronts-reference 99,0,-1"), "{tex}");
    let (code, said) = compare(&["--fronts", "length,success"]);
    assert!(code == 2 && said.contains("choose from length, cost, turns"), "{said}");
    let (code, said) = compare(&["--fronts", "length"]);
    assert!(code == 2 && said.contains("two or three measures"), "{said}");
    let (code, said) = compare(&["--fronts-reference", "1"]);
    assert!(code == 2 && said.contains("2 finite numbers"), "{said}");
}
