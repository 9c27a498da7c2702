//! Best known values: every committed entry is repeated, what is forged is refused by name, and `submit` takes what is better alone.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use formicarium::formats::session::{Session, read_session_link, write_session_link};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// What a call of the binary came to.
struct Said {
    code: i32,
    text: String,
}

impl Said {
    fn of(Output { status, stdout, stderr }: &Output) -> Self {
        let text = [stdout, stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned()).concat();
        Self { code: status.code().expect("it ends by itself"), text }
    }

    /// Ends with a code and says all of this.
    #[track_caller]
    fn is(&self, code: i32, said: &[&str]) {
        assert_eq!(self.code, code, "{}", self.text);
        said.iter().for_each(|part| assert!(self.text.contains(part), "`{part}` is not in\n{}", self.text));
    }
}

fn formicarium(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_formicarium")).current_dir(folder).args(args).output().expect("the binary starts")
}

/// A tracker of its own with one committed scenario, removed at the end.
struct Small(PathBuf);

const ID: &str = "threshold-1";
const ANTS: &str = "entries/threshold-1/ant-system.toml";

impl Small {
    /// With the entry of Ant System by the seeds 1 to 3.
    fn new(test: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("formicarium-tracker-{}-{test}", std::process::id()));
        fs::create_dir_all(folder.join("scenarios")).expect("a folder");
        let small = Self(folder);
        fs::copy(Path::new(ROOT).join("experiments/maps/threshold-1.json"), small.0.join("map.json")).expect("a map");
        small.write("scenarios/threshold-1.toml", "map = \"../map.json\"\nabout = \"Walls with gaps.\"\n");
        small
            .run(&["tracker", "run", "--planner", "ant-system", "--seeds", "1-3", "--date", "2026-03-21"])
            .is(0, &["1 entry written"]);
        small
    }

    fn run(&self, args: &[&str]) -> Said {
        Said::of(&formicarium(&self.0, &[args, &["--tracker", "."]].concat()))
    }

    fn write(&self, name: &str, text: &str) {
        let file = self.0.join(name);
        fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
        fs::write(file, text).expect("a file");
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).expect(name)
    }

    /// The link of the entry.
    fn link(&self) -> String {
        let text = self.read(ANTS);
        let line = text.lines().find_map(|line| line.strip_prefix("session = ")).expect("a session");
        line.trim_matches('"').to_owned()
    }

    fn session(&self) -> Session {
        read_session_link(&self.link()).expect("a session")
    }

    /// Puts another session into the entry, and checks.
    fn forge(&self, spoil: impl Fn(&mut Session)) -> Said {
        let mut session = self.session();
        spoil(&mut session);
        let forged = self.read(ANTS).replace(&self.link(), &write_session_link(&session).expect("short"));
        self.check(&forged)
    }

    /// Checks with another text in the place of the entry.
    fn check(&self, entry: &str) -> Said {
        let honest = self.read(ANTS);
        assert_ne!(entry, honest, "nothing is forged");
        self.write(ANTS, entry);
        let said = self.run(&["tracker", "check"]);
        self.write(ANTS, &honest);
        said
    }
}

impl Drop for Small {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn result(session: &mut Session) -> &mut formicarium::comparison::best_known::RecordedRun {
    session.panels[0].result.as_mut().expect("a result")
}

#[test]
fn every_committed_entry_holds() {
    Said::of(&formicarium(Path::new(ROOT), &["tracker", "check"])).is(0, &[" 0 refused"]);
}

/// An entry from outside is one file: until the table is made anew, it may lack it.
#[test]
fn the_committed_table_is_current() {
    let small = Small(std::env::temp_dir().join(format!("formicarium-tracker-{}-table", std::process::id())));
    let tracker = Path::new(ROOT).join("experiments/tracker");
    let table = fs::read_to_string(tracker.join("README.md")).expect("a table");
    for folder in ["maps", "tracker/scenarios"] {
        copy(&Path::new(ROOT).join("experiments").join(folder), &small.0.join(folder), |_| true);
    }
    for folder in fs::read_dir(tracker.join("entries")).expect("entries").flatten() {
        let name = folder.file_name().to_string_lossy().into_owned();
        let is_listed = |file: &str| !file.contains("--") || table.contains(&format!("entries/{name}/{file}"));
        copy(&folder.path(), &small.0.join("tracker/entries").join(&name), is_listed);
    }
    let made = formicarium(&small.0, &["tracker", "table", "--tracker", "tracker"]);
    assert!(made.status.success(), "{}", Said::of(&made).text);
    let hint = "make it anew: formicarium tracker table > experiments/tracker/README.md";
    assert!(String::from_utf8_lossy(&made.stdout) == table, "experiments/tracker/README.md is not current; {hint}");
}

fn copy(from: &Path, to: &Path, wanted: impl Fn(&str) -> bool) {
    fs::create_dir_all(to).expect("a folder");
    for file in fs::read_dir(from).expect("a folder").flatten() {
        let name = file.file_name().to_string_lossy().into_owned();
        if file.path().is_file() && wanted(&name) {
            fs::copy(file.path(), to.join(name)).expect("a file");
        }
    }
}

#[test]
fn changed_values_are_refused() {
    let small = Small::new("value");
    small.run(&["tracker", "check"]).is(0, &["1 entry repeated, 0 refused"]);
    let honest = small.read(ANTS);
    let value = honest.lines().find_map(|line| line.strip_prefix("value = ")).expect("a value");
    let with = |other: &str| small.check(&honest.replace(value, other));
    with("40.242640687119385").is(1, &["threshold-1/ant-system.toml", "value = 40.24264068711938 is claimed"]);
    with("39.242640687119284").is(1, &["39.242640687119284 is below the proven optimum"]);
    small.check(&honest.replace("\"length\"", "\"turn-index\"")).is(1, &["refused"]);
}

#[test]
fn changed_runs_are_refused() {
    let small = Small::new("run");
    let forge = |spoil: &dyn Fn(&mut Session), said: &str| small.forge(spoil).is(1, &["threshold-1/ant-system.toml", said]);
    forge(&|session| result(session).digest = "feedfacecafebeef".into(), "the digest does not come out again: feedfacecafebeef");
    forge(&|session| result(session).iterations += 1, "the digest does not come out again");
    forge(&|session| result(session).length = Some(40.0), "length = Some(40.0) is claimed");
    forge(&|session| session.seed += 1, "the digest does not come out again");
    forge(&|session| drop(session.panels[0].params.insert("ants".into(), 3.0.into())), "the digest does not come out again");
    forge(&|session| drop(session.panels[0].params.insert("wings".into(), 2.0.into())), "wings");
    forge(&|session| session.panels[0].planner = "fire".into(), "planner = \"ant-system\" is claimed");
    forge(&|session| session.panels[0].result = None, "no recorded run with a path");
    forge(&|session| session.engine = "0.0.9".into(), "the run is of engine 0.0.9; this is");
}

#[test]
fn entries_of_another_engine_are_renewed_where_they_come_out_again() {
    let small = Small::new("renew");
    let honest = small.read(ANTS);
    small.run(&["tracker", "renew"]).is(0, &["0 entries renewed"]);
    let of = |spoil: &dyn Fn(&mut Session)| {
        small.write(ANTS, &honest);
        let mut session = small.session();
        session.engine = "0.0.9".into();
        spoil(&mut session);
        small.write(ANTS, &honest.replace(&small.link(), &write_session_link(&session).expect("short")));
    };
    of(&|_| ());
    small.run(&["tracker", "check"]).is(1, &["the run is of engine 0.0.9"]);
    small.run(&["tracker", "renew"]).is(0, &["1 entry renewed"]);
    assert_eq!(small.read(ANTS), honest);
    of(&|session| result(session).digest = "feedfacecafebeef".into());
    let forged = small.read(ANTS);
    small.run(&["tracker", "renew"]).is(1, &["the digest does not come out again", "0 entries renewed"]);
    assert_eq!(small.read(ANTS), forged);
}

#[test]
fn runs_of_other_maps_are_refused() {
    let small = Small::new("map");
    let wall = |session: &mut Session| session.grid.set_blocked(6 * 20 + 4, true);
    small.forge(wall).is(1, &["none of the tracker's scenarios", "its cells differ from threshold-1"]);
    let four = |session: &mut Session| session.spec.movement.moves = formicarium::map::Moves::Four;
    small.forge(four).is(1, &["its moves differ from threshold-1"]);
}

#[test]
fn spoiled_files_are_refused() {
    let small = Small::new("file");
    let honest = small.read(ANTS);
    let link = small.link();
    let at = link.len() / 2;
    let other = if &link[at..=at] == "A" { "B" } else { "A" };
    let spoiled = format!("{}{other}{}", &link[..at], &link[at + 1..]);
    small.check(&honest.replace(&link, &spoiled)).is(1, &["link: it is damaged", "the whole address"]);
    small.check(&honest.replace("best-known@1", "best-known@7")).is(1, &["formicarium/best-known@7"]);
    for day in ["in spring", "2026-02-31", "0001-01-01"] {
        small.check(&honest.replace("2026-03-21", day)).is(1, &[&format!("`{day}` is no date")]);
    }
    small.check(&honest.replace("by = \"", r#"by = "Eve\n## "#)).is(1, &["by: it has more than one line"]);
    small.check(&honest.replace("value = ", "value = -inf #")).is(1, &["value: -inf is no length"]);
    small.check(&format!("{honest}colour = 3\n")).is(1, &["unknown field `colour`"]);
    small.check(&honest.replace("planner = \"ant-system\"", "planner = \"fire\"")).is(1, &["fire.toml or fire--NAME.toml"]);
    small.check(&honest.replace("session = ", "note = ")).is(1, &["refused"]);
    small.write("entries/nowhere/ant-system.toml", &honest);
    small.run(&["tracker", "check"]).is(1, &["entries/nowhere: the tracker has no scenario of this id"]);
}

#[test]
fn a_run_with_parameters_of_ones_own_needs_no_browser() {
    let small = Small::new("own");
    let run = |more: &[&str]| {
        let args = [
            "tracker",
            "run",
            "--planner",
            "elitist-ant-system",
            "--seeds",
            "1-3",
            "--date",
            "2026-03-22",
            "--set",
            "iterations=3",
        ];
        small.run(&[&args[..], more].concat())
    };
    run(&[]).is(2, &["say who you are: --by NAME"]);
    run(&["--set", "ants=0", "--by", "Ada"]).is(2, &["ants"]);
    run(&["--by", "Ada"]).is(0, &["1 entry written"]);
    assert!(
        small
            .read("entries/threshold-1/elitist-ant-system--ada.toml")
            .contains("note = \"iterations = 3; the best of the seeds 1 to 3\"")
    );
    run(&["--by", "Bob"]).is(0, &["no better than what is there", "0 entries written"]);
    small.run(&["tracker", "check"]).is(0, &["2 entries repeated, 0 refused"]);
}

/// The shortest path of the small map as lines, by the exact planner.
fn shortest(small: &Small) -> Vec<[u32; 2]> {
    let said = formicarium(&small.0, &["plan", "map.json", "--planner", "astar", "--format", "json"]);
    let result: serde_json::Value = serde_json::from_slice(&said.stdout).expect("a result");
    serde_json::from_value(result["path"].clone()).expect("a path")
}

#[test]
fn paths_from_elsewhere_are_walked() {
    let small = Small::new("path");
    let path = shortest(&small);
    let submit = |cells: &[[u32; 2]], planner: &str| {
        small.write("path.json", &serde_json::json!(cells).to_string());
        small.run(&["submit", "path.json", "--scenario", ID, "--planner", planner, "--by", "Ada", "--date", "2026-03-22"])
    };
    small.write("path.json", "[[0, 0]]");
    small.run(&["submit", "path.json"]).is(2, &["a path does not say what it is a claim for", "--scenario ID --planner NAME"]);
    submit(&path, "astar").is(2, &["cannot name a planner from elsewhere", "formicarium tracker run --planner"]);
    submit(&path, "AStar").is(2, &["cannot name a planner from elsewhere"]);
    // The wall of the first row is at column 4.
    let through: Vec<[u32; 2]> = (0..20).map(|x| [x, 0]).chain((1..20).map(|y| [19, y])).collect();
    submit(&through, "mine").is(1, &["refused", "cell 4 of the path, (4, 0), is blocked"]);
    submit(&[[0, 0], [19, 19]], "mine").is(1, &["step 0 of the path leads to a cell that is no neighbour"]);
    submit(&path[1..], "mine").is(1, &["not at the start"]);

    let mut detour = path.clone();
    detour.splice(0..1, [path[0], path[1], path[0]]);
    submit(&detour, "mine").is(0, &["the first value of this planner here", "written: ./entries/threshold-1/mine--ada.toml"]);
    submit(&detour, "mine").is(0, &["equal to the best known, which was there first", "Nothing is to be written"]);
    submit(&path, "mine").is(0, &["better than the best known by", "open a pull request"]);
    submit(&detour, "mine").is(0, &["worse than the best known by"]);
    small.run(&["tracker", "check"]).is(0, &["2 entries repeated, 0 refused"]);
    small.run(&["tracker", "table"]).is(0, &["| `mine` | length by steps | 40.2426 | 40.2426 | 0.00 % | – | Ada | 2026-03-22 |"]);

    let entry = small.read("entries/threshold-1/mine--ada.toml");
    small.write("entries/threshold-1/mine--ada.toml", &entry.replace("value = 40.24", "value = 40.14"));
    small.run(&["tracker", "check"]).is(1, &["mine--ada.toml", "is below the proven optimum"]);
    small.write("entries/threshold-1/astar--ada.toml", &entry.replace("\"mine\"", "\"astar\""));
    small.run(&["tracker", "check"]).is(1, &["a path does not prove that `astar` has found it"]);
}

#[test]
fn sessions_are_repeated_and_compared() {
    let small = Small::new("session");
    let honest = small.link();
    let mut forged = small.session();
    small.write("entries/threshold-1/ant-system--ada.toml", &small.read(ANTS));
    fs::remove_file(small.0.join(ANTS)).expect("a file");
    let equal = [
        "equal to the best known, which was there first",
        "of Formicarium, 2026-03-21",
        "40.2426, proven; the value is 0.00 % above",
    ];
    small.run(&["submit", &honest, "--by", "Bo"]).is(0, &equal);
    let address = format!("https://example.org/ants/{honest}");
    small.run(&["submit", &address, "--by", "Bo"]).is(0, &equal);
    small.run(&["submit", honest.trim_start_matches("#x="), "--by", "Bo"]).is(0, &equal);
    small.write("race.link", &format!("{address}\n"));
    small.run(&["submit", "race.link", "--by", "Bo", "--scenario", ID]).is(0, &equal);
    small.run(&["submit", "race.link", "--scenario", "elsewhere"]).is(2, &["the session is on threshold-1, not on elsewhere"]);

    fs::remove_file(small.0.join("entries/threshold-1/ant-system--ada.toml")).expect("a file");
    small.run(&["submit", &honest, "--dry-run"]).is(0, &["the first value of this planner here", "would be written: "]);
    small.run(&["submit", &honest]).is(2, &["the entry's file needs a name", "--by NAME"]);
    small.run(&["submit", &honest, "--by", "Bo"]).is(0, &["written: ./entries/threshold-1/ant-system--bo.toml"]);
    assert!(small.read("entries/threshold-1/ant-system--bo.toml").contains(&honest), "the link is kept as it is");
    small.run(&["tracker", "check"]).is(0, &["1 entry repeated, 0 refused"]);

    result(&mut forged).digest = "feedfacecafebeef".into();
    let link = write_session_link(&forged).expect("short");
    small.run(&["submit", &link, "--by", "Cy"]).is(1, &["refused", "digest", "feedfacecafebeef is claimed", "hint"]);
    let mut early = forged.panels[0].clone();
    early.result.as_mut().expect("a result").length = None;
    let mixed = Session { panels: vec![read_session_link(&honest).expect("a session").panels[0].clone(), early], ..forged };
    let link = write_session_link(&mixed).expect("short");
    small.run(&["submit", &link, "--by", "Cy"]).is(0, &["equal to the best known", "no path yet, so nothing is claimed"]);
}

#[test]
fn sessions_that_cannot_be_judged_are_refused() {
    let small = Small::new("refused");
    let submit = |spoil: &dyn Fn(&mut Session), said: &[&str]| {
        let mut session = small.session();
        spoil(&mut session);
        small.run(&["submit", &write_session_link(&session).expect("short"), "--by", "Ada"]).is(2, said);
    };
    submit(&|session| session.engine = "9.9.9".into(), &["the run is of engine 9.9.9", "hint: repeat the run with engine"]);
    submit(&|session| session.panels[0].result = None, &["no recorded run with a path"]);
    let wall = |session: &mut Session| session.grid.set_blocked(6 * 20 + 4, true);
    submit(&wall, &["its 20 × 20 cells are those of none", "hint: take one of threshold-1"]);
    submit(&|session| session.spec.start.x = 1, &["it has the cells of threshold-1, but its start differs"]);
    small.run(&["submit", &small.link()[..80], "--by", "Ada"]).is(2, &["damaged"]);
    small.run(&["submit", "nothing.csv"]).is(2, &["cannot read nothing.csv"]);

    let sample =
        fs::read_to_string(Path::new(ROOT).join("tests/fixtures/links/0.1.0/session.experiment.json")).expect("a sample");
    small.write("race.experiment.json", &sample);
    small.run(&["submit", "race.experiment.json", "--by", "Ada"]).is(2, &["its 36 × 22 cells are those of none"]);
    let changing = sample
        .replace("experiment@1", "experiment@2")
        .replace("\"resolution\":", "\"changes\": [{\"blocked\": [[1, 1]], \"freed\": [], \"at\": [1, 1]}], \"resolution\":");
    small.write("race.experiment.json", &changing);
    small.run(&["submit", "race.experiment.json", "--by", "Ada"]).is(2, &["walls changed while the planners ran (changes: 1)"]);
}

#[test]
fn a_worse_run_takes_nobodys_place() {
    let small = Small::new("worse");
    let before = small.read(ANTS);
    small
        .run(&["tracker", "run", "--planner", "ant-system", "--seeds", "1-1"])
        .is(0, &["no better than what is there", "0 entries written"]);
    assert_eq!(small.read(ANTS), before);
    small.write(ANTS, &before.replace("#x=A", "#x=B"));
    assert_ne!(small.read(ANTS), before);
    small
        .run(&["tracker", "run", "--planner", "ant-system", "--seeds", "1-3", "--date", "2026-03-21"])
        .is(0, &["1 entry written"]);
    assert_eq!(small.read(ANTS), before, "what does not hold is made anew");
}
