//! The places of an instance: what costs are made of, and where they are drawn.

use super::distances::{self, Metric};
use super::parts::{Parts, Section, missing, number};
use crate::error::FormatError;

const SHOWN: &str = "DISPLAY_DATA_TYPE: TWOD_DISPLAY with it";

/// Coordinates of every place in their order, from NODE_COORD_SECTION; none without it. Where there are two, the third is 0.
pub(super) fn coordinates(parts: &Parts<'_>, n: usize, metric: Metric) -> Result<Option<Vec<[f64; 3]>>, FormatError> {
    let axes = match parts.value("NODE_COORD_TYPE") {
        None => metric.axes().unwrap_or(2),
        Some("TWOD_COORDS") => 2,
        Some("THREED_COORDS") => 3,
        Some("NO_COORDS") => return no_section(parts, "NODE_COORD_SECTION", "another NODE_COORD_TYPE").map(|()| None),
        Some(_) => {
            return Err(FormatError::field("NODE_COORD_TYPE", "is not known", "TWOD_COORDS, THREED_COORDS or NO_COORDS"));
        }
    };
    if metric.axes().is_some_and(|wanted| wanted != axes) {
        let what = format!("of {axes} coordinates does not go with this EDGE_WEIGHT_TYPE");
        return Err(FormatError::field("NODE_COORD_TYPE", what, "as many coordinates as distances are of"));
    }
    let listed = parts.section("NODE_COORD_SECTION").map(|section| list(section, n, axes)).transpose()?;
    if metric == Metric::Geographical {
        listed.iter().flatten().try_for_each(on_globe)?;
    }
    Ok(listed)
}

/// Where to draw the places: DISPLAY_DATA_SECTION, else the coordinates that costs are made of.
pub(super) fn to_draw(
    parts: &Parts<'_>,
    n: usize,
    metric: Metric,
    listed: Option<Vec<[f64; 3]>>,
) -> Result<Option<Vec<[f64; 2]>>, FormatError> {
    let flat = |at: &[f64; 3]| if metric == Metric::Geographical { east_north(at) } else { [at[0], at[1]] };
    let by_coordinates = listed.map(|all| all.iter().map(flat).collect());
    match parts.value("DISPLAY_DATA_TYPE") {
        Some("TWOD_DISPLAY") => {
            let none = || missing("DISPLAY_DATA_SECTION", "a line of each place");
            let shown = list(parts.section("DISPLAY_DATA_SECTION").ok_or_else(none)?, n, 2)?;
            Ok(Some(shown.iter().map(|at| [at[0], at[1]]).collect()))
        }
        None | Some("COORD_DISPLAY") => no_section(parts, "DISPLAY_DATA_SECTION", SHOWN).map(|()| by_coordinates),
        Some("NO_DISPLAY") => no_section(parts, "DISPLAY_DATA_SECTION", SHOWN).map(|()| None),
        Some(_) => Err(FormatError::field("DISPLAY_DATA_TYPE", "is not known", "COORD_DISPLAY, TWOD_DISPLAY or NO_DISPLAY")),
    }
}

/// Longitude and latitude in degrees, for x and y.
fn east_north(at: &[f64; 3]) -> [f64; 2] {
    [distances::degrees(at[1]), distances::degrees(at[0])]
}

fn on_globe(at: &[f64; 3]) -> Result<(), FormatError> {
    if at[0].abs() <= 90.0 && at[1].abs() <= 360.0 {
        return Ok(());
    }
    let what = format!("{}, {} is no place on the globe", at[0], at[1]);
    Err(FormatError::field("NODE_COORD_SECTION", what, "latitude to 90 and longitude to 360, as DDD.MM"))
}

/// Refuses a section that another key rules out.
fn no_section(parts: &Parts<'_>, name: &str, expected: &str) -> Result<(), FormatError> {
    let refused = |section: Section<'_>| FormatError::syntax(section.line, format!("{name} is not announced"), expected);
    parts.section(name).map_or(Ok(()), |section| Err(refused(section)))
}

/// Lines of a number from 1 and coordinates, in any order, every place once.
fn list(section: Section<'_>, n: usize, axes: usize) -> Result<Vec<[f64; 3]>, FormatError> {
    let mut places: Vec<Option<[f64; 3]>> = vec![None; n];
    let form = if axes == 2 { "number, x, y" } else { "number, x, y, z" };
    for (line, mut words) in section.rows() {
        let named = words.next().unwrap_or("");
        let id = named.parse::<usize>().ok().filter(|id| (1..=n).contains(id));
        let outside =
            || FormatError::syntax(line, format!("`{named:.30}` is no place"), format!("a number from 1 to {n} (DIMENSION)"));
        let place = &mut places[id.ok_or_else(outside)? - 1];
        if place.is_some() {
            return Err(FormatError::syntax(line, format!("place {named} a second time"), "every place once"));
        }
        let mut at = [0.0; 3];
        for value in &mut at[..axes] {
            let word = words.next().ok_or_else(|| FormatError::syntax(line, "a coordinate is missing", form))?;
            *value = number(word, line)?;
        }
        if words.next().is_some() {
            return Err(FormatError::syntax(line, "more than its coordinates", form));
        }
        *place = Some(at);
    }
    let found = places.iter().flatten().count();
    let short =
        || FormatError::syntax(section.line, format!("{} lists {found} places, DIMENSION says {n}", section.name), "as many");
    places.into_iter().collect::<Option<Vec<_>>>().ok_or_else(short)
}
