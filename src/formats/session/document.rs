//! The session document: a session as JSON, without the map's cells: the Rust of `www/src/share/session_document.ts`.

use serde::de::DeserializeOwned;
use serde_json::{Map, Value as Json, json};

use super::{Origin, Panel, Session};
use crate::error::{Error, FormatError};
use crate::formats::scenario_json::read_spec;
use crate::formats::text::quote;
use crate::map::Grid;
use crate::scenario::{Scenario, ScenarioSpec};

const FORMAT: &str = "formicarium/experiment@1";
/// With changes of walls, which a reader of version 1 would leave out.
const CHANGING: &str = "formicarium/experiment@2";
/// With factors of cells or a robot, with or without changes: to readers of the others every map is plain ground for a point.
const WEIGHTED: &str = "formicarium/experiment@3";

/// A session whose cells travel beside it.
pub(super) struct Described {
    pub(super) spec: ScenarioSpec,
    pub(super) origin: Option<Origin>,
    /// Whether the map may have factors.
    weighted: bool,
    engine: String,
    changes: usize,
    panels: Vec<Panel>,
    seed: u32,
}

impl Described {
    /// Refuses factors that the document's version does not know.
    pub(super) fn check_factors(&self, has_factors: bool) -> Result<(), FormatError> {
        if has_factors && !self.weighted { Err(wrong("factors", format!("and {WEIGHTED} must come together"))) } else { Ok(()) }
    }

    /// The session on its map.
    pub(super) fn on(self, grid: Grid) -> Result<Session, Error> {
        let Self { spec, origin, engine, changes, panels, seed, .. } = self;
        // Validation takes both and gives them back.
        let Scenario { drawn, spec, .. } = Scenario::new(grid, spec)?;
        Ok(Session { engine, grid: drawn, spec, origin, changes, panels, seed })
    }
}

/// A field that cannot be used.
pub(super) fn wrong(field: &str, what: impl std::fmt::Display) -> FormatError {
    FormatError::syntax(0, format!("`{field}` {what}"), "a session as the page saves it; docs/formats.md has its fields")
}

/// Reads a document; with it what stands in its other fields, the map's among them.
pub(super) fn read(json: &str) -> Result<(Described, Map<String, Json>), FormatError> {
    let syntax =
        |e: serde_json::Error| FormatError::syntax(e.line(), format!("broken JSON: {e}"), "a session as the page saves it");
    let mut fields: Map<String, Json> = serde_json::from_str(json).map_err(syntax)?;
    let format = take::<String>(&mut fields, "format")?;
    if ![FORMAT, CHANGING, WEIGHTED].contains(&format.as_str()) {
        return Err(FormatError::Version { found: quote(&format), expected: FORMAT });
    }
    let mut scenario = take::<Map<String, Json>>(&mut fields, "scenario")?;
    let origin = optional(&mut scenario, "origin")?;
    let changes = optional::<Vec<Json>>(&mut scenario, "changes")?;
    let weighted = format == WEIGHTED;
    if !weighted && changes.is_some() != (format == CHANGING) {
        return Err(wrong("scenario.changes", format!("and {CHANGING} must come together")));
    }
    let panels: Vec<Panel> = take(&mut fields, "panels")?;
    check(&panels)?;
    let spec = read_spec(scenario)?;
    if spec.robot.is_some() && !weighted {
        return Err(wrong("scenario.robot", format!("and {WEIGHTED} must come together")));
    }
    let described = Described {
        spec,
        origin,
        weighted,
        engine: optional(&mut fields, "engine")?.unwrap_or_default(),
        changes: changes.map_or(0, |changes| changes.len()),
        panels,
        seed: take(&mut fields, "seed")?,
    };
    Ok((described, fields))
}

fn check(panels: &[Panel]) -> Result<(), FormatError> {
    let is_digest = |text: &str| text.len() == 16 && text.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b));
    let results = panels.iter().enumerate().filter_map(|(i, panel)| Some((i, panel.result.as_ref()?)));
    match results.into_iter().find(|(_, result)| !is_digest(&result.digest)) {
        Some((i, _)) => Err(wrong(&format!("panels[{i}].result.digest"), "must be 16 hexadecimal digits")),
        None => Ok(()),
    }
}

fn take<T: DeserializeOwned>(fields: &mut Map<String, Json>, field: &str) -> Result<T, FormatError> {
    optional(fields, field)?.ok_or_else(|| wrong(field, "is missing"))
}

/// None where it is absent or null.
fn optional<T: DeserializeOwned>(fields: &mut Map<String, Json>, field: &str) -> Result<Option<T>, FormatError> {
    let value = fields.remove(field).unwrap_or(Json::Null);
    serde_json::from_value(value).map_err(|e| wrong(field, format!("cannot be used: {e}")))
}

/// The document of a link. What the page wants to know beside the runs is as it is when a page is opened.
pub(super) fn write(session: &Session, map: &str) -> String {
    let mut scenario = json!(session.spec);
    if let (Some(origin), Some(fields)) = (session.origin, scenario.as_object_mut()) {
        fields.insert("origin".into(), json!(origin));
    }
    let is_weighted = session.grid.factors().is_some() || session.spec.robot.is_some();
    json!({
        "format": if is_weighted { WEIGHTED } else { FORMAT },
        "engine": session.engine,
        "scenario": scenario,
        "panels": session.panels,
        "seed": session.seed,
        "sync": "iterations",
        "speed": "iteration",
        "layer": "trail",
        "map": map,
    })
    .to_string()
}
