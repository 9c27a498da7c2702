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

/// A session whose cells travel beside it.
pub(super) struct Described {
    pub(super) spec: ScenarioSpec,
    pub(super) origin: Option<Origin>,
    engine: String,
    changes: usize,
    panels: Vec<Panel>,
    seed: u32,
}

impl Described {
    /// The session on its map.
    pub(super) fn on(self, grid: Grid) -> Result<Session, Error> {
        let Self { spec, origin, engine, changes, panels, seed } = self;
        // Validation takes both and gives them back.
        let Scenario { grid, spec, .. } = Scenario::new(grid, spec)?;
        Ok(Session { engine, grid, spec, origin, changes, panels, seed })
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
    if format != FORMAT && format != CHANGING {
        return Err(FormatError::Version { found: quote(&format), expected: FORMAT });
    }
    let mut scenario = take::<Map<String, Json>>(&mut fields, "scenario")?;
    let origin = optional(&mut scenario, "origin")?;
    let changes = optional::<Vec<Json>>(&mut scenario, "changes")?;
    if changes.is_some() != (format == CHANGING) {
        return Err(wrong("scenario.changes", format!("and {CHANGING} must come together")));
    }
    let panels: Vec<Panel> = take(&mut fields, "panels")?;
    check(&panels)?;
    let described = Described {
        spec: read_spec(scenario)?,
        origin,
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
    json!({
        "format": FORMAT,
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
