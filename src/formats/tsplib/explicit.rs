//! Costs that stand in the file, as a matrix or a triangle of one.

use super::super::text::quote;
use super::parts::{Parts, missing, number};
use crate::error::FormatError;
use crate::exact::order::Costs;

const SECTION: &str = "EDGE_WEIGHT_SECTION";
const FORMATS: &str =
    "FULL_MATRIX, UPPER_ROW, LOWER_ROW, UPPER_DIAG_ROW, LOWER_DIAG_ROW, UPPER_COL, LOWER_COL, UPPER_DIAG_COL or LOWER_DIAG_COL";

/// Which part of the matrix is there. A triangle by columns is the other triangle by rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Full,
    /// By rows, above the diagonal; with it, or without.
    Upper(bool),
    /// By rows, below the diagonal; with it, or without.
    Lower(bool),
}

impl Form {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "FULL_MATRIX" => Self::Full,
            "UPPER_ROW" | "LOWER_COL" => Self::Upper(false),
            "LOWER_ROW" | "UPPER_COL" => Self::Lower(false),
            "UPPER_DIAG_ROW" | "LOWER_DIAG_COL" => Self::Upper(true),
            "LOWER_DIAG_ROW" | "UPPER_DIAG_COL" => Self::Lower(true),
            _ => return None,
        })
    }

    /// How many numbers there are.
    fn count(self, n: usize) -> usize {
        match self {
            Self::Full => n * n,
            Self::Upper(true) | Self::Lower(true) => n * (n + 1) / 2,
            Self::Upper(false) | Self::Lower(false) => n * (n - 1) / 2,
        }
    }

    /// Where the cost from i to another place j stands among them.
    fn place(self, n: usize, i: usize, j: usize) -> usize {
        let (low, high) = (i.min(j), i.max(j));
        match self {
            Self::Full => i * n + j,
            // Rows before `low` have n − 1, n − 2, … numbers, with the diagonal one more each.
            Self::Upper(false) => low * (2 * n - low - 1) / 2 + high - low - 1,
            Self::Upper(true) => low * (2 * n - low + 1) / 2 + high - low,
            Self::Lower(false) => high * (high - 1) / 2 + low,
            Self::Lower(true) => high * (high + 1) / 2 + low,
        }
    }
}

/// The costs of EDGE_WEIGHT_SECTION; what stands on the diagonal counts for nothing.
pub(super) fn costs(parts: &Parts<'_>, n: usize, is_directed: bool) -> Result<Costs, FormatError> {
    let name = parts.value("EDGE_WEIGHT_FORMAT").ok_or_else(|| missing("EDGE_WEIGHT_FORMAT", FORMATS))?;
    let form = Form::named(name)
        .ok_or_else(|| FormatError::field("EDGE_WEIGHT_FORMAT", format!("`{}` is not read", quote(name)), FORMATS))?;
    if is_directed && form != Form::Full {
        return Err(FormatError::field(
            "EDGE_WEIGHT_FORMAT",
            format!("{name} has one cost for both directions"),
            "FULL_MATRIX for an ATSP",
        ));
    }
    let values = numbers(parts, form.count(n), name)?;
    let costs = Costs::new(n, |i, j| values[form.place(n, i, j)]);
    if !is_directed {
        check_both_ways(&costs)?;
    }
    Ok(costs)
}

/// Exactly so many numbers of at least 0, in lines of any length.
fn numbers(parts: &Parts<'_>, count: usize, form: &str) -> Result<Vec<f64>, FormatError> {
    let section = parts.section(SECTION).ok_or_else(|| missing(SECTION, "the costs"))?;
    let mut values = Vec::with_capacity(count);
    let of_this = format!("{count} numbers for {form} of this DIMENSION");
    for (line, words) in section.rows() {
        for word in words {
            if values.len() == count {
                return Err(FormatError::syntax(line, format!("`{}` is one cost too many", quote(word)), of_this));
            }
            let value = number(word, line)?;
            if value < 0.0 {
                return Err(FormatError::syntax(line, format!("the cost {word:.30} is below 0"), "costs of 0 and more"));
            }
            values.push(value);
        }
    }
    let found = values.len();
    if found == count {
        Ok(values)
    } else {
        Err(FormatError::syntax(section.line, format!("{SECTION} has {found} costs"), of_this))
    }
}

/// A TSP costs the same there and back.
fn check_both_ways(costs: &Costs) -> Result<(), FormatError> {
    let n = costs.nodes();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let uneven = pairs.into_iter().find(|&(i, j)| costs.get(i, j) != costs.get(j, i));
    uneven.map_or(Ok(()), |(i, j)| {
        let (there, back) = (costs.get(i, j), costs.get(j, i));
        let what = format!("from place {} to {} costs {there}, back {back}", i + 1, j + 1);
        Err(FormatError::field(SECTION, what, "equal costs both ways for a TSP, or TYPE: ATSP"))
    })
}

/// Refuses costs beside coordinates that they are made of.
pub(super) fn none(parts: &Parts<'_>) -> Result<(), FormatError> {
    if let Some(section) = parts.section(SECTION) {
        let what = format!("{SECTION} without EDGE_WEIGHT_TYPE: EXPLICIT");
        return Err(FormatError::syntax(section.line, what, "costs by coordinates, or in the file, not both"));
    }
    match parts.value("EDGE_WEIGHT_FORMAT") {
        None | Some("FUNCTION") => Ok(()),
        Some(name) => {
            let what = format!("`{}` does not go with costs by coordinates", quote(name));
            Err(FormatError::field("EDGE_WEIGHT_FORMAT", what, "FUNCTION, or EDGE_WEIGHT_TYPE: EXPLICIT"))
        }
    }
}
