//! Results from elsewhere: tables in every spelling, data files of IOHanalyzer, and what is refused.

use formicarium::comparison::Spent;
use formicarium::comparison::imported::{ImportedResults, ImportedRun};
use formicarium::error::ErrorReport;
use formicarium::formats::{Kind, import_results, sniff};
use formicarium::planner::Status;

fn results(text: &str) -> ImportedResults {
    import_results(text.as_bytes(), "runs/my planner.csv").unwrap_or_else(|e| panic!("{text:?}: {e}"))
}

fn refused(text: &str) -> ErrorReport {
    match import_results(text.as_bytes(), "mine.csv") {
        Err(error) => error.report(),
        Ok(results) => panic!("{text:?} was accepted as {results:?}"),
    }
}

/// Entry, instance, seed and length of every run.
fn told(results: &ImportedResults) -> Vec<(String, String, u32, Option<f64>)> {
    let of = |label: &str, run: &ImportedRun| {
        let instance = run.instance.map_or_else(String::new, |i| results.instances[i].clone());
        let best = run.steps.last().and_then(|s| s.length.or(s.value));
        (label.to_owned(), instance, run.seed, best)
    };
    results.entries.iter().flat_map(|e| e.runs.iter().map(move |run| of(&e.label, run))).collect()
}

#[test]
fn one_table_in_every_spelling() {
    let spellings = [
        "entry,instance,seed,length\nA,m,1,34.5\nA,m,2,\nB b,m,1,36\n",
        "Algorithm;Map;Run;Length\r\nA;m;1;34,5\r\nA;m;2;NaN\r\nB b;m;1;36,0\r\n;;;\r\n",
        "\u{feff}\"entry\"\t\"instance\"\t\"seed\"\t\"length\"\n\"A\"\tm\t1.0\t+3.45e1\n\nA\tm\t2\tinf\n\"B b\"\tm\t1\t36\n",
        "# made by hand\n\n planner , problem , seed , Path Length , note\nA, m, 1, 34.5,\"a, b\"\nA, m, 2, none,\n B  b , m, 1, 36, x\n",
        "entry,instance,seed,length\rA,m,1,34.5\rA,m,2,-\rB b,m,1,36\r",
        "length,seed,entry,instance\n34.5,1,A,m\n,2,A,m\n36,1,B b,m",
    ];
    let row = |entry: &str, seed, length| (entry.to_owned(), "m".to_owned(), seed, length);
    let wanted = [row("A", 1, Some(34.5)), row("A", 2, None), row("B b", 1, Some(36.0))];
    for text in spellings {
        assert_eq!(told(&results(text)), wanted, "{text:?}");
        assert_eq!(sniff(text.as_bytes(), "a.csv"), Kind::Results, "{text:?}");
    }
    let ids: Vec<String> = results(spellings[0]).entries.into_iter().map(|e| e.id).collect();
    assert_eq!(ids, ["a", "b-b"]);
}

#[test]
fn what_a_table_does_not_say_is_filled_in() {
    let read = results("value\n34.5\n35\n\"\"\n");
    assert_eq!((read.file.as_str(), read.instances.len()), ("my planner.csv", 0));
    let labels = told(&read);
    assert_eq!(labels[0], ("my planner".into(), String::new(), 1, Some(34.5)));
    assert_eq!(read.entries[0].id, "my-planner");
    assert_eq!(labels.iter().map(|(.., seed, _)| *seed).collect::<Vec<_>>(), [1, 2]);
    // Runs are counted for each entry and map.
    let read = results("entry,map,length\nA,x,1\nB,x,2\nA,y,3\nA,x,4\n");
    assert_eq!(read.entries[0].runs.iter().map(|r| r.seed).collect::<Vec<_>>(), [1, 1, 2]);
    assert_eq!(read.instances, ["x", "y"]);
    let statuses = |text: &str| results(text).entries[0].runs.iter().map(|r| r.status).collect::<Vec<_>>();
    assert_eq!(statuses("length\n1\nnan\n"), [Status::Complete, Status::BudgetSpent]);
    let told = "length,status\n1,stagnated\n2,Optimal\n3,\n,no-path\n5,timeout\n6,running\n";
    let wanted = [Status::Stagnated, Status::Optimal, Status::Complete, Status::NoPath, Status::Complete, Status::Complete];
    assert_eq!(statuses(told), wanted);
    let notices = results(told).notices;
    assert_eq!((notices[0].kind.as_str(), notices[0].args["words"].as_str()), ("results-status", "timeout, running"));
}

#[test]
fn effort_is_of_the_best_path_or_of_the_whole_run() {
    let run = |text: &str| results(text).entries[0].runs[0].clone();
    let spent =
        |iterations, constructed_paths, ant_moves| Spent { iterations, constructed_paths, ant_moves, cell_expansions: None };
    // `iterations` alone are those until the best; moves are of the whole run.
    let one = run("length,iterations,evaluations,ant_moves\n30,12,600,9000\n");
    assert_eq!((one.steps[0].spent, one.effort), (spent(Some(12), Some(600), None), spent(None, None, Some(9000))));
    // Beside a column of their own for the best they are of the whole run, as they are without a path.
    let both = run("length,iteration_of_best,iterations\n30,12,100\n");
    assert_eq!((both.steps[0].spent, both.effort), (spent(Some(12), None, None), spent(Some(100), None, None)));
    assert_eq!(run("length,iterations\n,100\n").effort, spent(Some(100), None, None));
    // What only tells of the best path tells nothing of the whole run.
    assert_eq!(run("length,iteration_of_best,paths_to_best\n30,12,600\n").effort, Spent::default());
    // One line an improvement: lines that improve nothing only tell how long it went on.
    let text = "seed,evaluations,length\n4,50,40\n9,10,38\n4,100,41\n4,200,36\n4,900,36\n";
    let read = results(text);
    let [first, second] = &read.entries[0].runs[..] else { panic!("{read:?}") };
    let steps: Vec<_> = first.steps.iter().map(|s| (s.length, s.spent.constructed_paths)).collect();
    assert_eq!(steps, [(Some(40.0), Some(50)), (Some(36.0), Some(200))]);
    assert_eq!((first.effort.constructed_paths, second.seed, second.effort.constructed_paths), (Some(900), 9, Some(10)));
    let notice = &read.notices[0];
    assert_eq!(
        (notice.kind.as_str(), notice.args["lines"].as_str(), notice.args["runs"].as_str()),
        ("results-improvements", "5", "2")
    );
}

#[test]
fn our_own_table_is_read_back() {
    let header = formicarium::comparison::report::HEADER;
    let text = format!(
        "{header}\nship,basic,1,budget-spent,34.727922,19,39.273506,,10,500,180474,length,34.727922,33.899495,true,0.024438,8701\n\
         ship,basic,2,no-path,,,,,,,500,length,,33.899495,true,,0afb\n"
    );
    assert_eq!(sniff(text.as_bytes(), "ship.csv"), Kind::Results);
    let read = results(&text);
    assert_eq!(read.notices, []);
    let [found, lost] = &read.entries[0].runs[..] else { panic!("{read:?}") };
    let step = found.steps[0];
    assert_eq!(
        (step.length, step.value, step.turns, step.turn_index, step.weight),
        (Some(34.727922), Some(34.727922), Some(19), Some(39.273506), None)
    );
    assert_eq!(
        (step.spent.iterations, step.spent.constructed_paths, found.effort.ant_moves),
        (Some(10), Some(500), Some(180_474))
    );
    assert_eq!(
        (found.status, lost.status, lost.steps.len(), lost.effort.ant_moves),
        (Status::BudgetSpent, Status::NoPath, 0, Some(500))
    );
}

#[test]
fn data_files_of_iohanalyzer() {
    let two = "\"function evaluation\" \"best-so-far f(x)\"\n1  +4.50000e+01\n20  +4.00000e+01\n300  +4.00000e+01\n\
               \"function evaluation\" \"best-so-far f(x)\"  \n7 inf\n15 38.5\n";
    let more = "\"function evaluation\"\t\"current f(x)\"\t\"best-so-far f(x)\"\t\"current af(x)+b\"\t\"best af(x)+b\"\n\
                1\t45\t45\t0\t0\n20\t40\t40\t0\t0\n300\t49\t40\t0\t0\n301\t4\n\
                \"function evaluation\"\t\"current f(x)\"\t\"best-so-far f(x)\"\t\"current af(x)+b\"\t\"best af(x)+b\"\n15\t38.5\t38.5\t0\t0\n";
    let unquoted = two.replace('"', "");
    let new = "evaluations raw_y rate\n1 45 0.1\n20 40 0.1\n21 43 0.1\n300 60 0.1\nevaluations raw_y rate\n15 38.5 0.2\n";
    for text in [two, more, &unquoted, new] {
        assert_eq!(sniff(text.as_bytes(), "IOHprofiler_f1_DIM2.dat"), Kind::Results, "{text}");
        let read = import_results(text.as_bytes(), "d/acs.dat").unwrap();
        assert_eq!((read.entries.len(), read.entries[0].id.as_str(), read.instances.len()), (1, "acs", 0));
        let [first, second] = &read.entries[0].runs[..] else { panic!("{text}: {read:?}") };
        let steps: Vec<_> = first.steps.iter().map(|s| (s.value, s.spent.constructed_paths)).collect();
        assert_eq!(steps, [(Some(45.0), Some(1)), (Some(40.0), Some(20))], "{text}");
        assert_eq!((first.seed, first.effort.constructed_paths, first.status), (1, Some(300), Status::Complete), "{text}");
        assert_eq!((second.seed, second.steps[0].value, second.effort.constructed_paths), (2, Some(38.5), Some(15)), "{text}");
    }
    let notices = results(more).notices;
    assert_eq!((notices[0].kind.as_str(), notices[0].args["records"].as_str()), ("results-incomplete", "1"));
    // A run that recorded nothing is a run without a path.
    let header = "evaluations raw_y_best\n";
    let read = results(&format!("{header}{header}4 2\n"));
    assert_eq!(
        read.entries[0].runs.iter().map(|r| (r.status, r.steps.len())).collect::<Vec<_>>(),
        [(Status::BudgetSpent, 0), (Status::Complete, 1)]
    );
    // A mark before the first line's names, as a spoilt file has it.
    assert_eq!(results(&format!("%{two}")).runs(), 2);
}

#[test]
fn what_cannot_be_used_is_named_with_its_line_and_column() {
    let cases = [
        ("length\n1\n\n# c\nabc\n", "line 5, column `length`: `abc` cannot be used", "a number of at least 0"),
        ("seed,length\n1,30\nx,31\n", "line 3, column `seed`: `x`", "from 0 to 4294967295"),
        ("seed,length\n1.5,30\n", "line 2, column `seed`: `1.5`", "a whole number from 0"),
        ("seed,length\n,30\n", "line 2, column `seed`: ``", "from 0 to"),
        ("seed,length\n1,-3\n", "line 2, column `length`: `-3`", "at least 0"),
        ("turns,length\n1.5,3\n", "line 2, column `turns`: `1.5`", "a whole number"),
        ("seed,length\n1,30,5\n", "line 2: 3 fields where the header has 2", "semicolons"),
        ("entry,seed,length\na,1\n", "line 2: 2 fields where the header has 3", "one field for each column"),
        ("seed,length\n1,30\n1,31\n", "line 3, column `seed`: `1`", "each run once"),
        ("seed,evaluations,length\n1,9,30\n1,8,29\n", "line 3, column `evaluations`: `8`", "no less than in the line before"),
        ("seed,turns\n1,2\n", "line 1: no column holds results: the columns are seed, turns", "`length` (or `value`)"),
        ("seed,length,seed\n1,2,3\n", "line 1: the column `seed` stands twice", "each column once"),
        ("seed,length\n", "the file has no line below its header", "one line a run"),
        ("", "the file is empty", "a line of column names"),
        ("evaluations raw_y\n1 2\nlast run\n", "line 3: `last run` is no separation line", "evaluations raw_y"),
        ("evaluations raw_y\n5 2\n4 1\n", "line 3, column `function evaluation`: `4`", "no less than"),
        ("evaluations raw_y_best\n5 2\n6 3\n", "line 3, column `raw_y_best`: `3`", "lengths are minimised"),
        ("evaluations raw_y\n1 2\n2 3\nevaluations raw_y\n1 1\n5 4\n", "line 3, column `raw_y`: `3`", "values only grow"),
        ("evaluations raw_y\nx 2\n", "line 2: `x 2` is no separation line", ""),
        ("evaluations raw_y\n1 2x\n", "line 2, column `raw_y`: `2x`", "a number"),
    ];
    for (text, message, hint) in cases {
        let report = refused(text);
        assert!(report.message.contains(message) && report.hint.contains(hint), "{text:?}: {report:?}");
    }
    assert_eq!(refused("length\nabc\n").kind, "bad-cell");
    assert!(import_results(b"\x89PNG\r\n", "a.csv").is_err());
}

#[test]
fn limits_are_told() {
    let many: String = std::iter::once("length\n".to_owned()).chain((0..=1_000_000).map(|i| format!("{i}\n"))).collect();
    let report = refused(&many);
    assert!(report.message.contains("line 1000002: the file has more than 1000000 lines"), "{report:?}");
    let entries: String = std::iter::once("entry,length\n".to_owned()).chain((0..101).map(|i| format!("e{i},1\n"))).collect();
    let report = refused(&entries);
    assert!(
        report.message.contains("line 102, column `entry`: `e100`") && report.hint.contains("at most 100 entries"),
        "{report:?}"
    );
    let maps = (0..1001).map(|i| format!("m{i},1\n"));
    let report = refused(&std::iter::once("map,length\n".to_owned()).chain(maps).collect::<String>());
    assert!(report.message.contains("line 1002, column `map`: `m1000`"), "{report:?}");
    assert!(report.hint.contains("at most 1000 maps"), "{report:?}");
}

#[test]
fn counts_that_are_not_told_apart_are_refused_by_name() {
    let columns = ["iterations", "iteration_of_best", "evaluations", "paths_to_best", "ant_moves", "cell_expansions"];
    for column in columns {
        assert!(import_results(format!("length,{column}\n1,9007199254740992\n").as_bytes(), "a.csv").is_ok(), "{column}");
        for count in ["9007199254740993", "9007199254740993.0", "1e16"] {
            let report = refused(&format!("length,{column}\n1,{count}\n"));
            assert!(report.message.contains(&format!("line 2, column `{column}`: `{count}`")), "{report:?}");
            assert!(report.kind == "bad-cell" && report.hint.contains("2^53"), "{report:?}");
        }
    }
    let report = refused("evaluations raw_y\n9007199254740993 2\n");
    assert!(report.message.contains("line 2, column `function evaluation`") && report.hint.contains("2^53"), "{report:?}");
    let report = refused("length,turns\n1,4294967296\n");
    assert!(report.message.contains("column `turns`: `4294967296`") && report.hint.contains("4294967295"), "{report:?}");
}

#[test]
fn maps_are_never_taken_for_results() {
    let maps = [
        ("0,0,1\n0,1,0\n", Kind::Matrix),
        ("value = [0 1; 1 0];\n", Kind::Matrix),
        ("length = 3; value = 2;\nG=[0 1;\n1 0];\n", Kind::Matrix),
        ("% value, length\n0 1\n1 0\n", Kind::Matrix),
        ("# length,seed\n0,1\n1,0\n", Kind::Matrix),
        ("type octile\nheight 1\nwidth 2\nmap\n..\n", Kind::MovingaiMap),
        ("version 1\n0\tlength\t9\t9\t1\t1\t2\t2\t1.4\n", Kind::MovingaiScen),
        ("10,20,30\n40,50,60\n", Kind::HeightTable),
        ("ncols 2\nnrows 1\ncellsize 1\n1 2\n", Kind::EsriAscii),
        ("x,y\n0,0\n1,1\n", Kind::Path),
    ];
    for (text, kind) in maps {
        assert_eq!(sniff(text.as_bytes(), "a.csv"), kind, "{text:?}");
    }
    let error = formicarium::formats::import(b"seed,length\n1,30\n", "a.csv").unwrap_err().report();
    assert!(error.kind == "not-a-map" && error.message.contains("a table of results"), "{error:?}");
}

#[test]
fn runs_on_maps_that_are_left_out_are_left_out() {
    let mut read = results("entry,instance,length\nA,x,1\nA,y,2\nB,Z,3\nB,,4\n");
    read.leave_out(&["X".into(), "z".into()]);
    assert_eq!(told(&read), [("A".into(), "y".into(), 1, Some(2.0)), ("B".into(), String::new(), 1, Some(4.0))]);
    assert_eq!((read.instances.len(), read.runs()), (1, 2));
}
