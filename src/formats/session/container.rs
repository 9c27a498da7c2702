//! A session as bytes, and back: the Rust of `www/src/share/codec.ts`.
//!
//! ```text
//! u32 checksum · u8 version · varint n · n bytes of JSON (document.rs) · the map · heights or factors (cell_numbers.rs)
//! ```
//!
//! The checksum (FNV-1a, lowest byte first) covers all that follows. The map is 1 bit a cell, or, when the JSON's `map` says `edits`, the
//! cells to toggle after the generator call in `scenario.origin`: varint count, then varint gaps.

use super::bytes::{Reader, push_bits, push_varint};
use super::document::{self, Described};
use super::{Origin, Session, cell_numbers, damaged};
use crate::error::{Error, FormatError};
use crate::map::{Grid, MAX_SIDE, check_size};
use crate::scenario::ScenarioSpec;

const PLANE: u8 = 1;
const TERRAIN: u8 = 2;
/// With factors.
const WEIGHTED: u8 = 3;
/// A link carries as many heights or factors as this, about 1000 × 1000; a file carries all.
const MAX_NUMBERS: usize = 1 << 20;
/// No honest container is larger: a full map of bits, four bytes a height, and a generous document.
pub(super) const MAX_CONTAINER: usize = (MAX_SIDE as usize).pow(2) / 8 + 4 * MAX_NUMBERS + (1 << 18);

const BITS: &str = "bits";
const EDITS: &str = "edits";

pub(super) fn unpack(bytes: &[u8]) -> Result<Session, Error> {
    let mut reader = Reader::new(verified(bytes)?);
    let version = reader.byte()?;
    if version > WEIGHTED {
        return Err(FormatError::Version { found: format!("container {version}"), expected: "containers 1 to 3" }.into());
    }
    if version < PLANE {
        return Err(damaged("its first byte is no container version").into());
    }
    let length = reader.varint()? as usize;
    let json = std::str::from_utf8(reader.take(length)?).map_err(|_| damaged("its description is no text"))?;
    let (described, fields) = document::read(json)?;
    let Described { spec, origin, .. } = &described;
    check_size(spec.width.into(), spec.height.into())?;
    if spec.terrain.is_some() != (version == TERRAIN) {
        return Err(document::wrong("scenario.terrain", "does not come with heights").into());
    }
    described.check_factors(version == WEIGHTED)?;
    let grid = match fields.get("map").and_then(|map| map.as_str()) {
        Some(BITS) => own(&mut reader, spec, version)?,
        Some(EDITS) => edited(&mut reader, spec, *origin)?,
        _ => return Err(document::wrong("map", "must be one of bits, edits").into()),
    };
    described.on(grid)
}

/// What the checksum covers, if it agrees.
fn verified(bytes: &[u8]) -> Result<&[u8], FormatError> {
    let (noted, covered) = bytes.split_first_chunk().ok_or_else(|| damaged("it ends too early"))?;
    if checksum(covered) != u32::from_le_bytes(*noted) {
        return Err(damaged(super::CHANGED));
    }
    Ok(covered)
}

/// FNV-1a, 32 bits: enough against slips and cuts, and no claim of more.
fn checksum(bytes: &[u8]) -> u32 {
    bytes.iter().fold(0x811c_9dc5, |hash: u32, &byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

fn own(reader: &mut Reader<'_>, spec: &ScenarioSpec, version: u8) -> Result<Grid, Error> {
    let count = spec.width as usize * spec.height as usize;
    let grid = Grid::from_bytes(spec.width, spec.height, &reader.bits(count)?)?;
    if version == PLANE {
        return Ok(grid);
    }
    check_count(count)?;
    let numbers = cell_numbers::unpack(reader, count)?;
    Ok(if version == TERRAIN { grid.with_heights(numbers) } else { grid.with_factors(numbers) }?)
}

fn edited(reader: &mut Reader<'_>, spec: &ScenarioSpec, origin: Option<Origin>) -> Result<Grid, Error> {
    let origin = origin.ok_or_else(|| damaged("it has edits of a map but not the map they belong to"))?;
    let mut grid = origin.make(spec)?;
    if grid.heights().is_some() != spec.terrain.is_some() {
        return Err(document::wrong("scenario.origin.generator", "makes another kind of map").into());
    }
    let mut at = 0;
    for _ in 0..reader.varint()? {
        at += reader.varint()? as usize;
        if at >= grid.len() {
            return Err(damaged("an edit lies outside the map").into());
        }
        grid.set_blocked(at as u32, !grid.is_blocked(at as u32));
    }
    // What has no height stays blocked.
    match grid.heights().map(|heights| heights.to_vec()) {
        Some(heights) => Ok(grid.with_heights(heights)?),
        None => Ok(grid),
    }
}

fn check_count(count: usize) -> Result<(), FormatError> {
    if count <= MAX_NUMBERS {
        return Ok(());
    }
    Err(FormatError::TooLarge { what: format!("a map of {count} heights or factors"), max: format!("{MAX_NUMBERS} of a link") })
}

pub(super) fn pack(session: &Session) -> Result<Vec<u8>, FormatError> {
    let is_made = session.origin.is_some_and(|origin| origin.make(&session.spec).as_ref() == Ok(&session.grid));
    let json = document::write(session, if is_made { EDITS } else { BITS });
    let (heights, factors) = (session.grid.heights(), session.grid.factors());
    let mut covered = vec![match (heights, factors) {
        (Some(_), _) => TERRAIN,
        (None, Some(_)) => WEIGHTED,
        (None, None) => PLANE,
    }];
    push_varint(&mut covered, json.len() as u32);
    covered.extend(json.as_bytes());
    match heights.or(factors) {
        _ if is_made => push_varint(&mut covered, 0),
        None => push_bits(&mut covered, session.grid.blocked()),
        Some(all) => {
            check_count(all.len())?;
            push_bits(&mut covered, session.grid.blocked());
            cell_numbers::push(&mut covered, all);
        }
    }
    Ok([&checksum(&covered).to_le_bytes()[..], &covered].concat())
}
