//! Tours of the library.

use super::super::text::{self, quote};
use super::parts::{Parts, Section, missing};
use super::{dimension, type_word};
use crate::error::FormatError;
use crate::exact::order_problem::OrderProblem;

const SECTION: &str = "TOUR_SECTION";

/// Reads a tour of a problem as an order of all places but the first, counted from 0 without it. A tour has no beginning: it is turned so
/// that it begins with the first place.
///
/// # Errors
/// [`FormatError`]: it is none, or does not visit every place of the problem once.
pub fn read_tour(bytes: &[u8], problem: &OrderProblem) -> Result<Vec<u32>, FormatError> {
    let text = text::decode(bytes)?;
    let parts = Parts::of(&text)?;
    if type_word(&parts)? != "TOUR" {
        return Err(FormatError::field("TYPE", "is not TOUR", "TYPE: TOUR, as tours of the library have it"));
    }
    parts.only(&[SECTION])?;
    let n = problem.len();
    if let Some(said) = dimension(&parts)?.filter(|&said| said != n) {
        return Err(FormatError::field("DIMENSION", format!("is {said}"), format!("{n}, as the problem has places")));
    }
    let section = parts.section(SECTION).ok_or_else(|| missing(SECTION, "the places in their order"))?;
    let mut places = visited(section, n)?;
    let first = places.iter().position(|&place| place == 0).unwrap_or(0);
    places.rotate_left(first);
    Ok(places[1..].iter().map(|place| place - 1).collect())
}

/// The places from 0 up to −1 or the end of the file, every one once.
fn visited(section: Section<'_>, n: usize) -> Result<Vec<u32>, FormatError> {
    let (mut places, mut seen, mut ended) = (Vec::new(), vec![false; n], false);
    for (line, words) in section.rows() {
        for word in words {
            if word == "-1" {
                ended = true;
                continue;
            }
            if ended {
                return Err(FormatError::syntax(line, "a second tour", "one tour in a file"));
            }
            let id = word.parse::<usize>().ok().filter(|id| (1..=n).contains(id));
            let outside =
                || FormatError::syntax(line, format!("`{}` is no place", quote(word)), format!("numbers from 1 to {n}, then -1"));
            let place = id.ok_or_else(outside)? - 1;
            if std::mem::replace(&mut seen[place], true) {
                return Err(FormatError::syntax(line, format!("place {word} a second time"), "every place once"));
            }
            places.push(place as u32);
        }
    }
    match seen.iter().position(|seen| !seen) {
        Some(left) => {
            Err(FormatError::syntax(section.line, format!("the tour leaves out place {}", left + 1), "every place once"))
        }
        None => Ok(places),
    }
}
