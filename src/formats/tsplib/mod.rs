//! Instances and tours of TSPLIB: places without a map.
//!
//! Reinelt, "TSPLIB – a traveling salesman problem library", ORSA Journal on Computing 3 (1991) 376–384, and the library's own description
//! of its files, "TSPLIB 95". Read are problems of the types TSP and ATSP; what else the library has is refused by name.

mod distances;
mod explicit;
mod parts;
mod places;
mod tour;

use self::distances::Metric;
use self::parts::{Parts, missing};
use super::text::{self, lines, quote};
use crate::error::FormatError;
use crate::exact::order::{Costs, Shape};
use crate::exact::order_problem::{MAX_PLACES, OrderProblem};

pub use tour::read_tour;

/// What the keys of a text tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Looks {
    /// An instance.
    Instance,
    /// A tour.
    Tour,
}

/// Whether a text begins with the keys of an instance or of a tour.
pub(super) fn looks_like(text: &str) -> Option<Looks> {
    let key = |line: &str| line.trim_start().split([':', ' ', '\t']).next().unwrap_or("").to_owned();
    let keys: Vec<String> = lines(text).take(40).map(|(_, line)| key(line)).collect();
    let has = |wanted: &str| keys.iter().any(|key| key == wanted);
    if has("TOUR_SECTION") && (has("TYPE") || has("DIMENSION")) {
        return Some(Looks::Tour);
    }
    let is_instance = has("DIMENSION") && (has("EDGE_WEIGHT_TYPE") || has("NODE_COORD_SECTION") || has("TYPE"));
    is_instance.then_some(Looks::Instance)
}

/// Reads an instance. Its tours are closed.
///
/// # Errors
/// [`FormatError`]: what is wrong, and in which line or key; [`FormatError::Foreign`] for problems that are none of a single tour.
pub fn read_instance(bytes: &[u8]) -> Result<OrderProblem, FormatError> {
    let text = text::decode(bytes)?;
    let parts = Parts::of(&text)?;
    let is_directed = problem_type(&parts)?;
    let n = dimension(&parts)?.ok_or_else(|| missing("DIMENSION", "the number of places"))?;
    let weight_type = parts.value("EDGE_WEIGHT_TYPE").ok_or_else(|| missing("EDGE_WEIGHT_TYPE", distances::NAMES))?;
    let metric = Metric::named(weight_type)?;
    parts.only(&["NODE_COORD_SECTION", "EDGE_WEIGHT_SECTION", "DISPLAY_DATA_SECTION"])?;
    let listed = places::coordinates(&parts, n, metric)?;
    let costs = match metric {
        Metric::Explicit => explicit::costs(&parts, n, is_directed)?,
        _ if is_directed => {
            let what = format!("{weight_type} has one cost for both directions");
            return Err(FormatError::field("EDGE_WEIGHT_TYPE", what, "EXPLICIT for an ATSP, or TYPE: TSP"));
        }
        _ => {
            explicit::none(&parts)?;
            let at = listed.as_ref().ok_or_else(|| missing("NODE_COORD_SECTION", "a line of each place"))?;
            Costs::new(n, |i, j| metric.distance(at[i], at[j]))
        }
    };
    let places = places::to_draw(&parts, n, metric, listed)?;
    let name = parts.value("NAME").unwrap_or("");
    let name = [".tsp", ".atsp"].iter().find_map(|end| name.strip_suffix(end)).unwrap_or(name);
    let (name, comment) = (name.chars().take(200).collect(), parts.comment.clone());
    Ok(OrderProblem { name, comment, weight_type: weight_type.into(), places, costs, shape: Shape::Closed })
}

/// Whether costs may be directed, from the word of TYPE; a remark in parentheses may follow it.
fn problem_type(parts: &Parts<'_>) -> Result<bool, FormatError> {
    match type_word(parts)? {
        "TSP" => Ok(false),
        "ATSP" => Ok(true),
        "TOUR" => {
            Err(FormatError::field("TYPE", "is TOUR", "an instance; name a tour beside it, with --tour on the command line"))
        }
        _ => Err(missing("TYPE", "TSP or ATSP")),
    }
}

/// The word of TYPE, empty where there is none; types that are not read are refused when their line is met.
fn type_word<'a>(parts: &Parts<'a>) -> Result<&'a str, FormatError> {
    let given = parts.value("TYPE").unwrap_or("");
    let (word, rest) = given.split_at(given.find(|c: char| c.is_whitespace() || c == '(').unwrap_or(given.len()));
    let remark = rest.trim();
    if remark.is_empty() || (remark.starts_with('(') && remark.ends_with(')')) {
        return Ok(word);
    }
    Err(FormatError::field(
        "TYPE",
        format!("`{}` follows `{word}`", quote(remark)),
        "nothing behind the type, or a remark in parentheses",
    ))
}

/// The number of places.
fn dimension(parts: &Parts<'_>) -> Result<Option<usize>, FormatError> {
    let Some(text) = parts.value("DIMENSION") else { return Ok(None) };
    let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let refused = |what: String, expected: String| Err(FormatError::field("DIMENSION", what, expected));
    match text.parse::<usize>() {
        Ok(n) if digits && n > MAX_PLACES => {
            refused(format!("{n} places are too many"), format!("up to {MAX_PLACES}: costs and trails are n² numbers"))
        }
        Ok(n) if digits && n >= 2 => Ok(Some(n)),
        _ => refused(format!("`{}`", quote(text)), format!("a whole number from 2 to {MAX_PLACES}")),
    }
}

#[cfg(test)]
mod tests;
