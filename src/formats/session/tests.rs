use std::path::Path;

use super::*;
use crate::map::Point;
use crate::scenario::{AtEnd, DriveSpec, Track};

fn sample(path: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/links");
    std::fs::read_to_string(folder.join(path)).expect("a committed sample")
}

/// What earlier versions of the page have written, as link and as file.
const SAMPLES: [&str; 4] = ["b298a60/plane-one-goal", "34386b4/plane-weighted-goals", "ae9355b/terrain-surface", "0.1.0/session"];

#[test]
fn links_and_files_of_earlier_versions_are_the_same_session() {
    for stem in SAMPLES {
        let link = read_session_link(&sample(&format!("{stem}.link"))).expect(stem);
        let file = read_session(&sample(&format!("{stem}.experiment.json"))).expect(stem);
        assert!(!link.panels.is_empty() && link.panels.iter().all(|panel| panel.result.is_some()), "{stem}");
        assert_eq!(link, file, "{stem}");
    }
}

#[test]
fn what_is_written_is_read_as_the_same() {
    for stem in SAMPLES {
        let session = read_session_link(&sample(&format!("{stem}.link"))).expect(stem);
        let address = format!("https://example.org/formicarium/{}", write_session_link(&session).expect(stem));
        assert_eq!(read_session_link(&address).as_ref(), Ok(&session), "{stem}");
    }
}

/// A session on a made map, which travels as its generator call.
fn made(generator: Generator) -> Session {
    let (seed, density) = (3, 0.2);
    let map = crate::map::generate(generator, 30, 20, seed, density).expect("a small map");
    Session {
        engine: "0.1.0".into(),
        spec: map.spec("made"),
        grid: map.grid,
        origin: Some(Origin { generator, seed, density }),
        changes: 0,
        panels: Vec::new(),
        seed: 7,
    }
}

#[test]
fn what_moves_while_a_robot_drives_travels_along() {
    let cells = [(3, 3), (4, 3), (4, 4)].map(|(x, y)| Point::new(x, y)).to_vec();
    let track = Track { cells, size: 2, from_step: 1, steps_per_cell: 3, at_end: AtEnd::BackAndForth };
    let mut session = made(Generator::Random);
    session.spec.drive = Some(DriveSpec { changes: Vec::new(), tracks: vec![track], sight: Some(4.5) });
    let link = write_session_link(&session).expect("short");
    assert_eq!(read_session_link(&link), Ok(session));
}

#[test]
fn a_made_map_travels_as_its_call() {
    for generator in [Generator::Random, Generator::Hills] {
        let session = made(generator);
        let link = write_session_link(&session).expect("short");
        assert!(link.len() < 800, "{generator:?}: {}", link.len());
        assert_eq!(read_session_link(&link), Ok(session));
    }
}

#[test]
fn an_edited_map_travels_with_its_cells() {
    let mut session = made(Generator::Hills);
    session.grid.set_blocked(77, true);
    let link = write_session_link(&session).expect("short");
    assert_eq!(read_session_link(&link), Ok(session));
}

/// What mail and chat make of a link, with nothing lost.
fn manglings(link: &str) -> Vec<String> {
    let address = format!("https://example.org/ants/{link}");
    let broken = |between: &str| {
        let lines: Vec<_> = link.as_bytes()[3..].chunks(60).map(|line| std::str::from_utf8(line).expect("letters")).collect();
        format!("https://example.org/#x={}", lines.join(between))
    };
    let coded = address.replace('#', "%23").replace('=', "%3D");
    let mut all: Vec<_> = [
        ".",
        ",",
        ")",
        "]",
        ">",
        "\"",
        "”",
        "。",
        "》",
        " and more",
        "\r\n\r\nAda",
        "&fbclid=I_-",
        "?utm_source=x",
        "=20",
        "%20",
        "%E3%80%82",
    ]
    .iter()
    .map(|behind| format!("{address}{behind}"))
    .collect();
    all.extend(["\n", "\r\n", "\n> ", "=\r\n", " ", "\u{200b}", "\u{ad}", "%0D%0A", "<wbr>"].map(broken));
    all.extend([
        format!("(see <{address}>)"),
        coded.clone(),
        coded.replace('%', "%25"),
        address.replace('=', "=3D"),
        address.replace('#', "&#35;"),
        address.replace('-', "%2D").replace('_', "%5F"),
        format!("https://example.org/##{}", &link[1..]),
        link[3..].to_owned(),
    ]);
    all
}

#[test]
fn links_survive_being_sent() {
    let mut ends = std::collections::BTreeSet::new();
    for seed in 0..100 {
        let session = Session { seed, ..made(if seed % 2 == 0 { Generator::Random } else { Generator::Hills }) };
        let link = write_session_link(&session).expect("short");
        ends.insert(link.chars().last());
        assert!(link.ends_with(|last: char| last.is_ascii_alphanumeric()), "{link}");
        assert_eq!(told_length::told_length(&link[3..]), Some(link.len() - 3), "{link}");
        for mangled in manglings(&link) {
            assert_eq!(read_session_link(&mangled).as_ref(), Ok(&session), "{mangled}");
        }
    }
    assert!(ends.len() > 4, "{ends:?}");
    for stem in SAMPLES {
        let link = sample(&format!("{stem}.link"));
        let session = read_session_link(&link).expect(stem);
        for mangled in manglings(link.trim()) {
            assert_eq!(read_session_link(&mangled).as_ref(), Ok(&session), "{mangled}");
        }
    }
}

#[test]
fn links_that_lost_something_say_how_much() {
    let link = write_session_link(&made(Generator::Random)).expect("short");
    let all = link.len() - 3;
    for lost in 1..all - 60 {
        let (end, at) = (&link[..link.len() - lost], 50);
        for text in [end.to_owned(), format!("{end}… and so on"), format!("{}{}", &link[..at], &link[at + lost..])] {
            let said = read_session_link(&text).expect_err("less than a link").report().message;
            assert!(said.contains(&format!("{lost} of its {all} characters are missing")), "{text}: {said}");
        }
    }
    let changed = format!("{}{}{}", &link[..80], if &link[80..81] == "k" { "R" } else { "k" }, &link[81..]);
    let said = read_session_link(&changed).expect_err("another text").report().message;
    assert!(said.contains("not the same as when it was made"), "{said}");
}

#[test]
fn damaged_links_are_refused_by_name() {
    let link = sample("0.1.0/session.link");
    let at = link.len() / 2;
    let other = if link.as_bytes()[at] == b'A' { "B" } else { "A" };
    let spoiled = format!("{}{other}{}", &link[..at], &link[at + 1..]);
    for (text, said) in [
        (spoiled.as_str(), "damaged"),
        (&link[..60], "damaged"),
        ("#x=", "characters no link has"),
        ("#x=%F0%9F!", "characters no link has"),
        ("#x=AAAAA", "its length is impossible"),
        ("#x=AAAAAAAAAAAA", "checksum"),
        ("https://example.org/#q=AAAA", "holds no session"),
    ] {
        let error = read_session_link(text).expect_err(text).report();
        assert!(error.message.contains(said) && !error.hint.is_empty(), "{text}: {error:?}");
    }
}

#[test]
fn a_container_that_claims_more_than_it_has_is_refused() {
    let session = made(Generator::Random);
    let bytes = container::pack(&session).expect("short");
    for length in 0..bytes.len() {
        assert!(container::unpack(&bytes[..length]).is_err(), "{length} of {}", bytes.len());
    }
}

#[test]
fn files_are_refused_by_field() {
    let file = sample("0.1.0/session.experiment.json");
    for (from, to, said) in [
        ("experiment@1", "experiment@9", "`format` is `formicarium/experiment@9`"),
        ("experiment@1", "experiment@2", "scenario.changes"),
        ("\"seed\": ", "\"seed\": -", "`seed` cannot be used"),
        ("\"digest\": \"", "\"digest\": \"x", "panels[0].result.digest"),
        ("\"map\": [", "\"map\": [\"..\", ", "rows"),
    ] {
        let spoiled = file.replacen(from, to, 1);
        assert_ne!(spoiled, file, "{from}");
        let error = read_session(&spoiled).expect_err(said).report();
        assert!(error.message.contains(said), "{said}: {error:?}");
    }
}

#[test]
fn factors_and_a_robot_travel_in_a_version_of_their_own() {
    let mut session = made(Generator::Random);
    let factors = (0..600u16).map(|i| 1.0 + f32::from(i % 7) / 3.0).collect();
    session.grid = session.grid.with_factors(factors).expect("factors");
    let link = write_session_link(&session).expect("short");
    assert_eq!(read_session_link(&link).as_ref(), Ok(&session));
    let robot = crate::scenario::Robot { radius: 0.0, inflation: Some(crate::scenario::Inflation::NAV2) };
    let with_robot = Session { spec: ScenarioSpec { robot: Some(robot), ..session.spec.clone() }, ..session.clone() };
    // The map comes back as it was drawn, not as the robot feels it.
    assert_eq!(read_session_link(&write_session_link(&with_robot).expect("short")).as_ref(), Ok(&with_robot));

    let rows: Vec<String> = crate::formats::movingai::rows(&session.grid).collect();
    let numbers: Vec<&[f32]> = session.grid.factors().expect("factors").chunks(30).collect();
    let file = |format: &str, spec: &ScenarioSpec| {
        serde_json::json!({
            "format": format, "engine": "0.1.0", "scenario": spec, "panels": [], "seed": 7, "map": rows, "factors": numbers,
        })
        .to_string()
    };
    let read = read_session(&file("formicarium/experiment@3", &with_robot.spec)).expect("a session");
    assert_eq!((read.grid, read.spec), (with_robot.grid.clone(), with_robot.spec.clone()));
    for (format, spec, named) in [
        ("formicarium/experiment@1", &session.spec, "factors"),
        ("formicarium/experiment@1", &with_robot.spec, "scenario.robot"),
        ("formicarium/experiment@4", &session.spec, "experiment@4"),
    ] {
        let error = read_session(&file(format, spec)).expect_err("another version").to_string();
        assert!(error.contains(named), "{format}: {error}");
    }
}
