//! `compare`: what it writes, and what can be changed about the question from outside.
use super::folder::{Folder, QUESTION};

#[test]
fn every_run_is_a_row_and_every_map_a_table() {
    let folder = Folder::with_question("rows");
    let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    let rows: Vec<&str> = csv.lines().collect();
    // A header; two maps, two entries that run, 40 seeds.
    assert_eq!(rows.len(), 1 + 2 * 2 * 40);
    assert!(rows[0].starts_with("instance,entry,seed,status,length,turns,"));
    assert!(rows[1].starts_with("small,colony,5,budget-spent,"), "{}", rows[1]);
    assert!(rows[41].starts_with("small,exact,5,optimal,"), "{}", rows[41]);
    // A run without a path is a row with empty fields.
    assert!(rows[81].starts_with("wall,colony,5,no-path,,,,,,,"), "{}", rows[81]);
    assert!(rows.iter().all(|r| r.matches(',').count() == rows[0].matches(',').count()));

    let page = folder.read("out/q.md");
    for wanted in
        ["# Small", "## small", "`formicarium compare q.toml --out DIR`", "| lost |  | not run: its formulas are nowhere |"]
    {
        assert!(page.contains(wanted), "`{wanted}` is not in\n{page}");
    }
    assert!(page.contains("| A* | 10 / – / – | 40 of 40 |") && page.contains("| exact optimum, length by steps |"), "{page}");
    // Nothing is shorter than A*: claimed −10 %.
    assert!(said.contains("shorter on small: length,") && page.contains("| −10.0 % |"), "{page}");
    assert!(page.contains("**cannot tell**: one of the two cannot be run"), "{page}");
}

#[test]
fn the_number_of_jobs_changes_nothing() {
    let folder = Folder::with_question("jobs");
    for (jobs, out) in [("1", "one"), ("7", "seven")] {
        assert_eq!(folder.compare(&["q.toml", "--out", out, "--jobs", jobs]).0, 0);
    }
    for file in ["q.csv", "q.md", "q.tests.md", "q.json", "q.summary.csv", "q.summary.json", "q.tex"] {
        assert_eq!(folder.read(&format!("one/{file}")), folder.read(&format!("seven/{file}")), "{file}");
    }
    // What stood there is replaced as a whole, and nothing else is left behind.
    assert_eq!(folder.compare(&["q.toml", "--out", "one", "--seeds", "1"]).0, 0);
    assert_eq!(folder.read("one/q.csv").lines().count(), 1 + 4);
    assert_eq!(std::fs::read_dir(folder.0.join("one")).unwrap().count(), 7);
}

#[test]
fn the_summary_has_a_line_an_entry_and_map() {
    let folder = Folder::with_question("summary");
    folder.write("q.toml", &QUESTION.replacen("length = 9.0", "length = 8.0", 1));
    assert_eq!(folder.compare(&["q.toml", "--out", "out"]).0, 0);
    let csv = folder.read("out/q.summary.csv");
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let of = |line: usize, name: &str| lines[line][lines[0].iter().position(|column| *column == name).unwrap()];
    // Two maps, three entries.
    assert_eq!(lines.len(), 1 + 2 * 3);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()), "{csv}");
    assert_eq!(
        [of(2, "instance"), of(2, "entry"), of(2, "runs"), of(2, "with_path"), of(2, "optimal")],
        ["small", "exact", "40", "40", "40"]
    );
    assert_eq!((of(2, "best"), of(2, "reference"), of(2, "deviation")), (of(2, "mean_high"), of(2, "median"), "0.0"));
    assert_eq!([of(3, "origin"), of(3, "runs"), of(3, "best")], ["missing", "0", ""]);
    assert_eq!([of(4, "with_path"), of(4, "median"), of(4, "success_low")], ["0", "", "0.0"]);
    let json: serde_json::Value = serde_json::from_str(&folder.read("out/q.summary.json")).unwrap();
    assert_eq!((&json["format"], json["lines"].as_array().unwrap().len()), (&"formicarium/summary@1".into(), 6));
    assert_eq!((json["lines"][1]["runs"].as_u64(), &json["lines"][2]["best"]), (Some(40), &serde_json::Value::Null));
    // Printed without decimals: 8.5 at most. What is published of A*, 10, is longer than the optimum.
    let page = folder.read("out/q.md");
    assert!(
        page.contains(
            "\n\n- colony: the published 8 is impossible on this map under its rule: the exact optimum is 9.000.\n\nOf a map that"
        ),
        "{page}"
    );
}

#[test]
fn what_people_read_is_in_their_language_and_what_programs_read_in_none() {
    const FOR_PEOPLE: [&str; 8] = ["md", "tests.md", "summary.md", "matrix.md", "fronts.md", "tex", "matrix.tex", "fronts.tex"];
    let folder = Folder::with_question("chinese");
    let files = "csv,tests-csv,summary-csv,summary-json,claims-csv,matrix-csv,json,markdown,tests,summary-markdown,matrix-markdown,latex,matrix-latex,\
                 fronts-csv,fronts-markdown,fronts-latex";
    let compare = |out: &str, language: &str| folder.compare(&["q.toml", "--out", out, "--files", files, "--language", language]);
    assert_eq!((compare("en", "en").0, compare("zh", "zh-CN").0), (0, 0));
    for ending in ["csv", "tests.csv", "summary.csv", "summary.json", "claims.csv", "matrix.csv", "fronts.csv", "json"] {
        assert_eq!(folder.read(&format!("en/q.{ending}")), folder.read(&format!("zh/q.{ending}")), "{ending}");
    }
    // Every word is Chinese but those of the question, names, and what is typed.
    let kept = "formicarium compare toml out dir language zh cn planner set docs methodology md both free iqr wilcoxon mann whitney holm \
                friedman tex program xelatex usepackage booktabs graphicx ctex lualatex begin end table tabular centering caption label tab \
                linewidth width textbf shortstack toprule midrule bottomrule resizebox ifdim else fi setlength tabcolsep pt times pm leq \
                matrix fronts lrrrrrrrrrr lrrr ant system astar over maps lrrrrr";
    let known = format!("{kept} {}", QUESTION.to_lowercase());
    let is_known = |word: &str| known.split(|c: char| !c.is_ascii_alphabetic()).any(|known| known == word);
    for ending in FOR_PEOPLE {
        let text = folder.read(&format!("zh/q.{ending}")).to_lowercase();
        let words = text.split(|c: char| !c.is_ascii_alphabetic()).filter(|word| word.len() > 1);
        let english: Vec<&str> = words.filter(|word| !is_known(word)).collect();
        assert!(english.is_empty(), "{ending}: {english:?} in\n{text}");
    }
    assert!(folder.read("zh/q.md").contains("由 `formicarium compare q.toml --out DIR --language zh-CN` 生成，引擎版本 "));
    assert!(folder.read("zh/q.tex").starts_with("% !TEX program = xelatex\n% 由 `formicarium compare"));
    // Files in one language are known as ours when they are written in the other.
    assert_eq!((compare("zh", "en").0, compare("en", "zh-CN").0), (0, 0));
    FOR_PEOPLE.iter().for_each(|e| assert!(!folder.read(&format!("zh/q.{e}")).contains("种子"), "{e}"));
    let (code, said) = compare("de", "de");
    assert!(code == 2 && said.contains("choose from en, zh-CN"), "{said}");
}

#[test]
fn different_objectives_are_told_below_each_table() {
    let folder = Folder::with_question("objectives");
    let told = |planner: &str| {
        folder.write("q.toml", &QUESTION.replacen("planner = \"astar\"", &format!("planner = \"{planner}\""), 1));
        assert_eq!(folder.compare(&["q.toml", "--out", "out", "--files", "markdown"]).0, 0);
        let page = folder.read("out/q.md");
        page.lines().filter(|line| line.starts_with("Makes small: ")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(told("astar"), [""; 0]);
    assert_eq!(told("any-angle"), ["Makes small: length by steps (“colony”); length of a polyline (“A*”)."; 2]);
    // All alike, and not what the map is measured by.
    let alone = QUESTION.replacen("planner = \"astar\"", "planner = \"turn-aware\"", 1);
    let alone = alone.replacen("planner = \"ant-system\"\nset", "planner = \"turn-aware\"\n# set", 1);
    folder.write("q.toml", &alone);
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--files", "markdown"]).0, 0);
    assert!(folder.read("out/q.md").contains("\n\nMakes small: turn index V (“colony”, “A*”).\n"));
}

#[test]
fn only_the_reference_is_printed_without_a_gap() {
    let folder = Folder::with_question("gaps");
    folder.write("mine.csv", "algorithm,map,seed,length\nmine,small,5,9.001\n");
    let files = "summary-markdown,matrix-markdown,latex,matrix-latex";
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--results", "mine.csv", "--files", files]).0, 0);
    let line = |file: &str, of: &str| folder.read(file).lines().find(|line| line.contains(of)).unwrap_or_default().to_owned();
    assert!(line("out/q.summary.md", "| mine").contains(" | < 0.1 % | < 0.1 % | "));
    assert!(line("out/q.summary.md", "| A*").contains(" | 0.0 % | 0.0 % | "));
    assert!(line("out/q.tex", "    mine (from").contains(" & $<$ 0.1 \\% & $<$ 0.1 \\% & "));
    assert!(line("out/q.matrix.md", "| small").contains(" 9.001; < 0.1 % |"));
    assert!(line("out/q.matrix.tex", "small (").contains(" 9.001; $<$ 0.1 \\% "));
}

#[test]
fn the_table_for_a_paper_is_whole_latex() {
    let folder = Folder::with_question("latex");
    folder.write("q.toml", &QUESTION.replacen("label = \"colony\"", "label = \"colony_1 & 50 % of {η}\"", 1));
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--files", "latex"]).0, 0);
    assert_eq!(std::fs::read_dir(folder.0.join("out")).unwrap().count(), 1);
    let tex = folder.read("out/q.tex");
    let count = |what: &str| tex.matches(what).count();
    assert_eq!(
        (count("\\begin{table}"), count("\\end{table}"), count("\\begin{tabular}"), count("\\end{tabular}")),
        (3, 3, 3, 3)
    );
    assert_eq!((count("\n  \\resizebox{"), count("\\end{tabular}}\n")), (3, 3));
    assert_eq!((count("\\toprule"), count("\\midrule"), count("\\bottomrule"), count("\\caption{")), (3, 3, 3, 3));
    assert!(tex.contains("colony\\_1 \\& 50 \\% of \\{$\\eta$\\}") && tex.contains("seeds 5 to 44"), "{tex}");
    // Braces that are not escaped come in pairs, dollars too, and every row has as many fields as there are columns.
    let bare = tex.replace("\\\\", "\n").replace("\\{", "").replace("\\}", "").replace("\\$", "");
    assert_eq!(bare.matches('{').count(), bare.matches('}').count());
    assert!(bare.lines().all(|line| line.matches('$').count() % 2 == 0));
    let columns = tex.split("\\begin{tabular}{").nth(1).unwrap().find('}').unwrap();
    let rows: Vec<usize> =
        tex.lines().filter(|l| l.ends_with("\\\\")).map(|l| l.replace("\\&", "").matches('&').count()).collect();
    // Two maps with three entries, then two claims over maps.
    assert_eq!(rows, [vec![columns - 1; 2 * (1 + 3)], vec![5; 1 + 2]].concat());
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--files", "tests-csv,summary-markdown"]).0, 0);
    let tests = folder.read("out/q.tests.csv");
    // One pair on each map; on the wall no run finds a path, and none differs.
    assert!(tests.starts_with("instance,test,first,second,statistic,p,holm,a12\nsmall,wilcoxon,colony,exact,"), "{tests}");
    assert!(tests.contains("\nwall,mann-whitney,colony,exact,800.0,1.0,1.0,0.5\n"), "{tests}");
    assert!(folder.read("out/q.summary.md").contains("| A* | 40 of 40 | **"));
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--files", "pdf"]);
    assert!(code == 2 && said.contains("choose from csv, markdown"), "{said}");
}

#[test]
fn a_budget_can_be_set_from_outside() {
    let folder = Folder::with_question("budget");
    // Three ants an iteration: of two iterations, one is within five paths, and the next one ends the run.
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--budget", "constructed-paths=5"]);
    assert_eq!(code, 0, "{said}");
    let page = folder.read("out/q.md");
    assert!(
        page.contains("--budget constructed-paths=5`") && page.contains(", of each at most 5 constructed paths count."),
        "{page}"
    );
    let csv = folder.read("out/q.csv");
    let paths = csv.lines().skip(1).filter(|l| l.starts_with("small,colony")).map(|l| l.split(',').nth(9).unwrap().to_owned());
    assert!(paths.clone().all(|n| n.is_empty() || n == "3") && paths.count() == 40, "{csv}");
    for wrong in ["constructed-paths", "time=3", "moves=0", "walks=4", "moves=-1"] {
        let (code, said) = folder.compare(&["q.toml", "--out", "out", "--budget", wrong]);
        assert!(code == 2 && said.contains("--budget"), "{said}");
    }
}

#[test]
fn a_question_can_be_narrowed_and_asked_on_another_map() {
    let folder = Folder::with_question("narrow");
    folder.write("open.csv", "0,0,0\n0,0,0\n");
    let narrow = ["q.toml", "--out", "out", "--seeds", "2", "--only", "small", "--map", "small=open.csv"];
    let (code, said) = folder.compare(&narrow);
    assert_eq!(code, 0, "{said}");
    let csv = folder.read("out/q.csv");
    // (0,0) → (2,1): one diagonal and one straight step.
    assert!(csv.lines().nth(3).is_some_and(|row| row.starts_with("small,exact,5,optimal,2.414214,1,")), "{csv}");
    assert_eq!(csv.lines().count(), 1 + 2 * 2);
    let page = folder.read("out/q.md");
    assert!(page.contains("--seeds 2 --only small --map small=open.csv`") && page.contains("open in place of"), "{page}");
    assert!(page.contains("too few runs to compare"), "{page}");
}

#[test]
fn a_map_can_stand_beside_those_of_a_group() {
    let folder = Folder::with_question("group");
    folder.write("q.toml", &QUESTION.replace("map = \"wall.csv\" }", "map = \"wall.csv\", group = \"walls\" }"));
    folder.write("Open 2.csv", "0,0,0\n0,0,0\n");
    let asked = |more: &[&str]| folder.compare(&[&["q.toml", "--out", "out", "--seeds", "2"], more].concat());
    let instances = || {
        let csv = folder.read("out/q.csv");
        let mut ids: Vec<String> = csv.lines().skip(1).map(|row| row.split(',').next().unwrap().to_owned()).collect();
        ids.dedup();
        ids
    };
    let (code, said) = asked(&["--map", "walls/open=Open 2.csv"]);
    assert!(code == 0 && instances() == ["small", "wall", "open"], "{said}");
    let page = folder.read("out/q.md");
    assert!(
        page.contains("--map walls/open=Open 2.csv`") && page.contains("Open 2 beside the question's maps of walls."),
        "{page}"
    );
    assert_eq!(asked(&["--map", "walls/open=Open 2.csv", "--only", "walls"]).0, 0);
    assert_eq!(instances(), ["wall", "open"]);
    assert_eq!(asked(&["--map", "walls/open=Open 2.csv", "--only", "open"]).0, 0);
    assert_eq!(instances(), ["open"]);
    for (map, message) in [
        ("doors/open=small.csv", "q.toml: instances.group = doors cannot be used: it must be one of walls"),
        ("small/open=small.csv", "instances.group = small"),
        ("walls/small=small.csv", "instances.id = small"),
        ("walls/walls=small.csv", "instances.id = walls"),
        ("walls/Open=small.csv", "instances.id = Open"),
        ("walls/=small.csv", "instances.id = "),
        ("walls=small.csv", "instances = walls cannot be used: it must be one of small, wall"),
    ] {
        let (code, said) = asked(&["--map", map]);
        assert!(code == 2 && said.contains(message), "{map}: {said}");
    }
    let (code, said) = asked(&["--only", "doors"]);
    assert!(code == 2 && said.contains("instances = doors cannot be used: it must be one of small, wall, walls"), "{said}");
    folder.write("q.toml", QUESTION);
    let (code, said) = asked(&["--map", "walls/open=small.csv"]);
    assert!(code == 2 && said.contains("the question has no groups"), "{said}");
}

#[test]
fn what_cannot_be_asked_is_named_with_code_2() {
    let folder = Folder::with_question("errors");
    let changed = |from: &str, to: &str| QUESTION.replacen(from, to, 1);
    let cases = [
        (changed("question@1", "question@9"), "`format` is `formicarium/question@9`", "this engine reads"),
        (changed("title =", "titel ="), "q.toml: line 3: unknown field `titel`", "docs/methodology.md"),
        (changed("asks = ", "asks "), "q.toml: line 4:", "docs/methodology.md"),
        (changed("ants = 3", "ants = 0"), "entries.colony: ants = 0 is outside 1 to 1024", "choose ants"),
        (changed("ant-system", "bee"), "entries.colony: there is no planner `bee`", "ant-system"),
        (changed("baseline = \"exact\"", "baseline = \"none\""), "claims.shorter.baseline = none", "colony, exact, lost"),
        (changed("small.csv", "large.csv"), "cannot read large.csv", "check the name"),
        (changed("count = 40", "count = 0"), "seeds.count = 0", "1 to 100000"),
    ];
    for (question, message, hint) in cases {
        folder.write("q.toml", &question);
        let (code, said) = folder.compare(&["q.toml", "--out", "out"]);
        assert_eq!(code, 2, "{said}");
        assert!(said.contains(message) && said.contains(hint), "`{message}`, `{hint}`:\n{said}");
    }
    folder.write("q.toml", QUESTION);
    for args in [&["q.toml"][..], &["none.toml", "--out", "out"], &["q.toml", "--out", "out", "--only", "big"]] {
        assert_eq!(folder.compare(args).0, 2);
    }
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--map", "small"]);
    assert!(code == 2 && said.contains("write ID=FILE"), "{said}");
    let (code, said) = folder.compare(&["--help"]);
    assert!(code == 0 && said.contains("Examples:") && said.contains("formicarium compare experiments/ship.toml"), "{said}");
    assert!(!folder.0.join("out").exists());
}
