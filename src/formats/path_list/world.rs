//! Paths in metres of the world, and the cells in which their places lie.

use crate::error::{FormatError, Notice};
use crate::formats::path_list::columns;
use crate::formats::path_out::placed;
use crate::formats::text::quote;
use crate::map::Point;
use crate::scenario::{ScenarioSpec, TerrainMoves, TerrainSpec};

/// A path in metres: a Path message of ROS, or a line of GeoJSON.
#[derive(Debug, Clone, PartialEq)]
pub struct WorldPath {
    /// x, y and z of its places; z is 0 where the file has none.
    pub places: Vec<[f64; 3]>,
    /// In which frame they are; empty where the file does not say.
    pub frame: String,
}

impl WorldPath {
    /// The cells in which its places lie, one for each run of places in the same cell; by slices with the level nearest to z.
    ///
    /// # Errors
    /// [`FormatError::Field`] with the number of the place that lies beside the map.
    pub fn on(&self, spec: &ScenarioSpec) -> Result<Vec<(Point, Option<u32>)>, FormatError> {
        let expected = "places on the map: check against the one that the path was planned on";
        let (placed, level) = (placed(spec), metres_of_level(spec));
        let mut places = Vec::with_capacity(self.places.len());
        for (index, &[x, y, z]) in self.places.iter().enumerate() {
            let beside = || FormatError::field("poses", format!("pose {index} ({x}, {y}) lies beside the map"), expected);
            let at = placed.to_cell([x, y]).ok_or_else(beside)?;
            // Far above or below what there is the cast stops at an end: the audit says so.
            places.push((at, level.map(|level| libm::round(z / level) as u32)));
        }
        places.dedup();
        Ok(places)
    }

    /// Its places as column and row, the middles of cells being whole numbers, where they are more than a hundredth of a cell from them: what
    /// was planned from cell to cell, and written and read as decimals, is nearer.
    pub fn between_centres(&self, spec: &ScenarioSpec) -> Option<Vec<[f64; 2]>> {
        const NEAR: f64 = 0.01;
        let placed = placed(spec);
        let places: Vec<[f64; 2]> = self.places.iter().filter_map(|&[x, y, _]| placed.to_place([x, y])).collect();
        let is_off = |v: f64| (v - libm::round(v)).abs() > NEAR;
        places.iter().any(|&[x, y]| is_off(x) || is_off(y)).then_some(places)
    }

    /// What is worth saying of the path and a map: no place, or another frame; the description of a ROS map names none, and map_server
    /// publishes it as `map`.
    pub fn notices(&self, spec: &ScenarioSpec) -> Vec<Notice> {
        let Some(world) = &spec.world else {
            let message = "the map's place in the world is not known: the path's metres count from its lower left corner";
            return vec![Notice::new("path-map-unplaced", message)];
        };
        let (path, map) = (&self.frame, &world.frame);
        let differ = |map: &str| !path.is_empty() && !path.trim_start_matches('/').eq_ignore_ascii_case(map);
        if map.is_empty() {
            let message =
                || format!("the path is in the frame {path}, and the map names none: their metres were taken for the same");
            return differ("map").then(|| Notice::new("path-frame-unnamed", message()).with("path", path)).into_iter().collect();
        }
        let message = || format!("the path is in the frame {path}, the map in {map}: their metres were taken for the same");
        differ(map).then(|| Notice::new("path-frame", message()).with("path", path).with("map", map)).into_iter().collect()
    }
}

/// A table of metres, with a line of names that says which column is which; none for any other text.
///
/// # Errors
/// [`FormatError::Syntax`] with the line of the first thing that is no place.
pub(super) fn in_columns(text: &str) -> Result<Option<WorldPath>, FormatError> {
    let (head, body) = text.split_once('\n').unwrap_or((text, ""));
    let Some((columns, width)) = columns::in_metres(head) else { return Ok(None) };
    let lines = body.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let place = |(index, line): (usize, &str)| {
        let wrong = || {
            let what = format!("`{}` is no place in metres", quote(line));
            FormatError::syntax(index + 2, what, "a number in every column that is named")
        };
        let fields = columns::fields(line);
        let number = |at: usize| fields.get(at)?.parse::<f64>().ok().filter(|v| v.is_finite());
        let [x, y, z] = columns.map(|at| at.map(|at| number(at).ok_or_else(wrong)).transpose());
        let place = [x?.unwrap_or(0.0), y?.unwrap_or(0.0), z?.unwrap_or(0.0)];
        if fields.len() == width { Ok(place) } else { Err(wrong()) }
    };
    Ok(Some(WorldPath { places: lines.map(place).collect::<Result<_, _>>()?, frame: String::new() }))
}

/// Metres of a level, by slices.
fn metres_of_level(spec: &ScenarioSpec) -> Option<f64> {
    match spec.terrain {
        Some(TerrainSpec { moves: TerrainMoves::Slices(rules), .. }) => Some(rules.level),
        _ => None,
    }
}
