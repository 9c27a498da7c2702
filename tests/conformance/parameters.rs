//! Parameters, presets and names.

use std::sync::Arc;

use formicarium::catalog::{self, CATALOG};
use formicarium::error::ParamError;
use formicarium::map::{Measure, Movement};
use formicarium::params::{ParamKind, ParamSpec, Value, Values};
use formicarium::planner::{Granularity, Ground, Layer, PaperReading, PlannerEntry};
use formicarium::scenario::Scenario;

use super::common::{random, with_goals};
use super::{short, takes, terrains};

/// A scenario of every ground that the planner knows.
fn one_of_each(entry: &PlannerEntry) -> Vec<Arc<Scenario>> {
    let plane = random(12, 0.2, 1, Movement::default());
    let both = [plane.spec.goals[0].at, plane.spec.start].map(|p| (p.x, p.y));
    let hilly = |movement| terrains::hilly(12, 12, 1, 6.0, movement, 90.0);
    let slices = terrains::hilly_slices(10, 7, 1, terrains::rules(Measure::Cost));
    let plane = if entry.max_goals > 1 { with_goals(&plane, &both) } else { plane };
    let all = [plane, hilly(Movement::default()), hilly(terrains::sixteen()[2]), slices];
    all.into_iter().filter(|s| takes(entry, s)).collect()
}

/// The values at both ends of a parameter's range, and those just outside.
fn ends(spec: &ParamSpec) -> (Vec<Value>, Vec<Value>) {
    match &spec.kind {
        ParamKind::Integer { min, max } | ParamKind::Real { min, max } => (
            vec![Value::Number(*min), Value::Number(*max)],
            vec![
                Value::Number(min - 1.0),
                Value::Number(max + 1.0),
                Value::Number(f64::NAN),
                Value::Text("x".into()),
                Value::Flag(true),
            ],
        ),
        ParamKind::Flag => (vec![Value::Flag(true), Value::Flag(false)], vec![Value::Number(1.0)]),
        ParamKind::Choice { options } => {
            (options.iter().map(|o| Value::from(o.id)).collect(), vec![Value::Text("no such option".into()), Value::Number(0.0)])
        }
    }
}

#[test]
fn range_ends_run_and_what_is_outside_is_refused_by_name() {
    let cases = CATALOG.iter().flat_map(|entry| one_of_each(entry).into_iter().map(move |scenario| (entry, scenario)));
    for (entry, scenario) in cases {
        let scenario = &scenario;
        for spec in (entry.specs)() {
            let (inside, outside) = ends(&spec);
            for value in inside {
                let mut values = short(entry);
                values.insert(spec.key.into(), value.clone());
                let built = catalog::build(scenario, entry.id, None, &values, 1);
                if let Err(ParamError::ValueOnGround { .. }) = &built {
                    // Polylines are on a plane, and by one goal as V and J.
                    let is_polyline = (spec.key, &value) == ("paths", &Value::from("polylines"));
                    assert!(entry.id == "formica" && (is_polyline || spec.key == "criterion"));
                    assert!(scenario.goals.len() > 1 || is_polyline && Ground::of(scenario) != Ground::Plane);
                    continue;
                }
                let mut planner = built.unwrap_or_else(|e| panic!("{} {} = {value}: {e}", entry.id, spec.key));
                for _ in 0..8 {
                    planner.advance(Granularity::Iteration);
                }
                let mut trail = Vec::new();
                if planner.layer(Layer::Trail, &mut trail) {
                    assert!(trail.iter().all(|t| *t > 0.0 && t.is_finite()), "{} {} = {value}", entry.id, spec.key);
                }
            }
            for value in outside {
                let values: Values = [(spec.key.to_string(), value.clone())].into();
                let error = catalog::build(scenario, entry.id, None, &values, 1).err();
                let report = error.unwrap_or_else(|| panic!("{} {} = {value} was accepted", entry.id, spec.key)).report();
                assert_eq!(report.field, spec.key);
                assert!(report.message.contains(spec.meaning) && !report.hint.is_empty(), "{report:?}");
            }
        }
    }
}

#[test]
fn unknown_names_are_refused_with_what_is_known() {
    let scenario = random(8, 0.1, 1, Movement::default());
    let on = |scenario: &Arc<Scenario>, id: &str, preset: Option<&str>, values: &Values| {
        catalog::build(scenario, id, preset, values, 1).err()
    };
    let build = |id: &str, preset: Option<&str>, values: &Values| on(&scenario, id, preset, values);
    assert!(
        matches!(build("ants", None, &Values::new()), Some(ParamError::UnknownPlanner { known, .. }) if known.contains("astar"))
    );
    for entry in CATALOG {
        let values: Values = [("no_such_key".to_string(), Value::Number(1.0))].into();
        for scenario in one_of_each(entry) {
            assert!(matches!(on(&scenario, entry.id, None, &values), Some(ParamError::UnknownKey { .. })), "{}", entry.id);
            let unknown = on(&scenario, entry.id, Some("no such preset"), &Values::new());
            assert!(matches!(unknown, Some(ParamError::UnknownPreset { .. })), "{}", entry.id);
        }
    }
}

#[test]
fn what_would_run_out_of_memory_is_refused() {
    let grid = formicarium::map::Grid::open(4096, 4096).expect("the largest map");
    let ends = (formicarium::map::Point::new(0, 0), formicarium::map::Point::new(9, 9));
    let scenario = Arc::new(Scenario::on(grid, Movement::default(), ends.0, ends.1).expect("usable"));
    let with = |ants: f64| catalog::build(&scenario, "ant-system", None, &[("ants".to_string(), Value::Number(ants))].into(), 1);
    assert!(with(50.0).is_ok());
    let report = with(1024.0).err().expect("too many ants").report();
    assert_eq!((report.kind.as_str(), report.field.as_str()), ("memory", "ants"));
    // With several goals every leg has a colony of its own: one fits, three do not.
    assert!(catalog::build(&scenario, "fire", None, &Values::new(), 1).is_ok());
    let several = with_goals(&scenario, &[(9, 9), (4000, 9), (9, 4000)]);
    let report = catalog::build(&several, "fire", None, &Values::new(), 1).err().expect("three colonies").report();
    assert_eq!((report.kind.as_str(), report.field.as_str()), ("memory", "ants"));
}

#[test]
fn a_planner_has_one_preset_of_each_reading() {
    for entry in CATALOG {
        for reading in PaperReading::ALL {
            let of_it: Vec<_> = entry.presets.iter().filter(|p| p.reading == Some(reading)).map(|p| p.name).collect();
            assert!(of_it.len() < 2, "{}: {} is {of_it:?}", entry.id, reading.id());
        }
        // Questions and people take the names for the readings.
        for preset in entry.presets.iter().filter(|p| ["printed", "second-reading"].contains(&p.name)) {
            assert_eq!(preset.reading.map(PaperReading::id), Some(preset.name), "{}", entry.id);
        }
    }
}

#[test]
fn defaults_are_as_we_read_it_unless_a_preset_is() {
    let of = |id: &str, preset: Option<&str>| catalog::find(id).expect("listed").reading_of(preset);
    assert_eq!(of("ship", None), Some(PaperReading::AsRead));
    assert_eq!(of("ship", Some("cells")), None);
    assert_eq!(of("ship", Some("printed")), Some(PaperReading::Printed));
    assert_eq!(of("ship", Some("no such preset")), None);
    // The paper orders its fires by straight lines, the defaults by paths on the map.
    assert_eq!((of("fire", None), of("fire", Some("paper"))), (None, Some(PaperReading::AsRead)));
    // The paper's own numbers are the defaults.
    assert_eq!(
        (of("terrain-epf", None), of("terrain-epf", Some("paper"))),
        (Some(PaperReading::AsRead), Some(PaperReading::AsRead))
    );
    assert_eq!((of("ant-system", None), of("ant-system", Some("fire-printed"))), (None, None));
}

#[test]
fn the_catalog_is_complete_and_its_presets_run() {
    for (i, entry) in CATALOG.iter().enumerate() {
        assert!(CATALOG[..i].iter().all(|e| e.id != entry.id), "{} twice", entry.id);
        assert!(!entry.source.is_empty() && !entry.summary.is_empty() && !entry.layers.is_empty(), "{}", entry.id);
        for spec in (entry.specs)() {
            assert!(!spec.meaning.is_empty() && !spec.source.is_empty(), "{} {}", entry.id, spec.key);
            let keys: Vec<_> = (entry.specs)().iter().map(|s| s.key).collect();
            assert!(spec.applies_when.is_none_or(|w| keys.contains(&w.key)), "{} {}", entry.id, spec.key);
        }
        let scenarios = one_of_each(entry);
        assert!(!scenarios.is_empty(), "{} plans nowhere", entry.id);
        for (preset, scenario) in entry.presets.iter().flat_map(|p| scenarios.iter().map(move |s| (p, s))) {
            let mut planner = catalog::build(scenario, entry.id, Some(preset.name), &short(entry), 1)
                .unwrap_or_else(|e| panic!("{} --preset {}: {e}", entry.id, preset.name));
            planner.advance(Granularity::Iteration);
        }
    }
}
