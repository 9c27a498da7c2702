//! What `compare`, `convert` and `generate` must not destroy.
use super::folder::{Folder, QUESTION};

/// Names in a folder, in order.
fn names(folder: &Folder, of: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder.0.join(of)).unwrap();
    let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn endings_come_after_the_whole_name() {
    let folder = Folder::with_question("dots");
    folder.write("study.v2.toml", QUESTION);
    folder.write("study.toml", QUESTION);
    assert_eq!(folder.compare(&["study.toml", "--out", "out", "--seeds", "2"]).0, 0);
    let first = folder.read("out/study.csv");
    assert_eq!(folder.compare(&["study.v2.toml", "--out", "out", "--seeds", "1"]).0, 0);
    assert_eq!(folder.read("out/study.csv"), first);
    assert_eq!(folder.read("out/study.v2.csv").lines().count(), 1 + 4);
    assert_eq!(names(&folder, "out").len(), 14);
}

#[test]
fn results_of_somebody_else_are_not_overwritten() {
    let folder = Folder::with_question("others");
    for ending in ["csv", "md", "tests.md", "summary.csv", "summary.json", "tex", "json"] {
        let name = format!("q.{ending}");
        folder.write(&name, "{\"mine\": 1}\n# mine,x\n");
        let (code, said) = folder.compare(&["q.toml", "--out", "."]);
        let refused = format!("{name} is no result that this program has written: it is left as it is");
        assert!(code == 2 && said.contains(&refused) && said.contains("--replace"), "{said}");
        assert_eq!(folder.read(&name), "{\"mine\": 1}\n# mine,x\n");
        std::fs::remove_file(folder.0.join(&name)).unwrap();
    }
    assert!(!folder.0.join("q.partial").exists());
    folder.write("q.csv", "mine\n");
    let all = "csv,markdown,tests,tests-csv,summary-csv,summary-json,summary-markdown,latex,json";
    let args = ["q.toml", "--out", ".", "--seeds", "1", "--files", all];
    assert_eq!(folder.compare(&[&args[..], &["--replace"]].concat()).0, 0);
    // Every kind of our own is known again.
    let (code, said) = folder.compare(&args);
    assert_eq!(code, 0, "{said}");
    // Results that are compared are not what they are compared with.
    let (code, said) = folder.compare(&[&args[..], &["--results", "q.csv"]].concat());
    assert!(code == 2 && said.contains("q.csv is one of the files that are compared"), "{said}");
}

#[test]
fn what_does_not_come_out_again_keeps_its_evidence() {
    let folder = Folder::with_question("evidence");
    assert_eq!(folder.compare(&["q.toml", "--out", "out", "--seeds", "3"]).0, 0);
    let whole = folder.read("out/q.json");
    let in_place = |more: &[&str]| folder.compare(&[&["out/q.json", "--out", "out"], more].concat());
    // All the same: it takes its own place.
    let (code, said) = in_place(&[]);
    assert!(code == 0 && said.contains("12 of 12 runs the same") && !said.contains("again"), "{said}");
    assert_eq!((folder.read("out/q.json"), names(&folder, "out").len()), (whole.clone(), 7));
    // Fewer seeds or another budget: not all that the file has.
    for more in [&["--seeds", "1"][..], &["--budget", "iterations=1"]] {
        let (code, said) = in_place(more);
        assert!(code == 0 && said.contains("out/q.json and what is beside it stay as they are"), "{said}");
        assert_eq!(folder.read("out/q.json"), whole);
    }
    let row = r#"{"task":{"instance":0,"entry":1,"seed":6},"status":"optimal""#;
    let tampered = whole.replacen(row, &row.replace("optimal", "stagnated"), 1);
    assert_ne!(tampered, whole);
    folder.write("out/q.json", &tampered);
    let csv = folder.read("out/q.csv");
    let (code, said) = in_place(&[]);
    assert!(code == 1 && said.contains("the file's runs were changed") && said.contains("q.again.*"), "{said}");
    assert_eq!((folder.read("out/q.json"), folder.read("out/q.csv")), (tampered, csv));
    assert_eq!(folder.read("out/q.again.json"), whole);
}

#[test]
fn what_cannot_be_written_is_told_before_the_first_run() {
    let folder = Folder::with_question("preflight");
    std::fs::create_dir_all(folder.0.join("out/q.json")).unwrap();
    let refuses = |args: &[&str], what: &str| {
        let (code, said) = folder.compare(args);
        assert!(code == 2 && said.contains(what) && !said.contains("wrote"), "{said}");
    };
    refuses(&["q.toml", "--out", "out"], "cannot write out/q.json: is a directory");
    let long = "n".repeat(244);
    folder.write(&format!("{long}.toml"), QUESTION);
    refuses(&[&format!("{long}.toml"), "--out", "long"], "cannot write long/nnn");
    refuses(&["q.toml", "--out", "small.csv"], "cannot write small.csv");
    assert_eq!((names(&folder, "out"), names(&folder, "long")), (vec!["q.json".into()], Vec::<String>::new()));
    folder.run(&["convert", "small.csv", "none/a.map"]).ends(2).says(&["cannot write none/a.map"]);
    folder.run(&["generate", "maze", "--size", "9x9", "--out", "out"]).ends(2).says(&["cannot write out: is a directory"]);
}

#[test]
fn reports_do_not_tell_folders() {
    let folder = Folder::with_question("folders");
    let typed = [folder.0.join("q.toml").display().to_string(), "./q.toml".into(), "q.toml".into()];
    for (typed, out) in typed.iter().zip(["a", "b", "c"]) {
        assert_eq!(folder.compare(&[typed, "--out", out, "--seeds", "2", "--map", "small=./small.csv"]).0, 0);
    }
    for name in names(&folder, "a") {
        let [a, b, c] = ["a", "b", "c"].map(|out| folder.read(&format!("{out}/{name}")));
        assert!(a == b && b == c && !a.contains(folder.0.to_str().unwrap()), "{name}");
    }
    let page = folder.read("a/q.md");
    assert!(page.contains("`formicarium compare q.toml --out DIR --seeds 2 --map small=small.csv`"), "{page}");
}

#[cfg(unix)]
#[test]
fn links_are_replaced_and_permissions_are_usual() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::with_question("links");
    folder.write("precious.csv", "do not touch\n");
    std::fs::create_dir_all(folder.0.join("out")).unwrap();
    for name in ["q.csv", "q.json", "made.csv"] {
        symlink("../precious.csv", folder.0.join("out").join(name)).unwrap();
    }
    let (code, said) = folder.compare(&["q.toml", "--out", "out", "--seeds", "1"]);
    assert_eq!(code, 0, "{said}");
    folder.run(&["generate", "maze", "--size", "9x9", "--out", "out/made.csv"]).ends(0);
    assert_eq!(folder.read("precious.csv"), "do not touch\n");
    let mode = |name: &str| std::fs::symlink_metadata(folder.0.join(name)).unwrap().permissions().mode();
    // As any new file has them.
    assert_eq!((mode("out/q.csv"), mode("out/made.csv")), (mode("precious.csv"), mode("precious.csv")));
    std::fs::set_permissions(folder.0.join("out/made.csv"), std::fs::Permissions::from_mode(0o600)).unwrap();
    folder.run(&["convert", "small.csv", "out/made.csv"]).ends(0);
    assert_eq!(mode("out/made.csv") & 0o777, 0o600);
}
