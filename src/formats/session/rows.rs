//! The session's file: the document, with the map as rows of `.` and `@` and heights and factors as rows of numbers.

use serde_json::{Value as Json, json};

use super::document;
use super::{Session, document::wrong};
use crate::error::Error;
use crate::formats::scenario_json::read_map;

pub(super) fn read(text: &str) -> Result<Session, Error> {
    let (described, mut fields) = document::read(text)?;
    let heights = fields.remove("heights");
    if heights.is_some() != described.spec.terrain.is_some() {
        return Err(wrong("scenario.terrain", "and `heights` must come together").into());
    }
    let factors = fields.remove("factors");
    described.check_factors(factors.is_some())?;
    // A scenario's file has them in one field.
    let mut map = json!({ "rows": fields.remove("map").unwrap_or(Json::Null) });
    for (field, numbers) in [("heights", heights), ("factors", factors)] {
        if let Some(numbers) = numbers {
            map[field] = numbers;
        }
    }
    let grid = read_map(&map, &described.spec)?;
    described.on(grid)
}
