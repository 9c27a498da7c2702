//! Claims by the reading of the publication that they are about: what is said of several readings stands side by side, so that it can be seen
//! which of them it holds for.

use serde::Serialize;

use super::claim::Claim;
use super::question::{Entry, Question};
use crate::catalog;
use crate::error::QuestionError;
use crate::planner::PaperReading;

/// A table reading × claim, of the claims that name a reading; empty where none does.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ByReading {
    /// The readings that occur: the columns.
    pub readings: Vec<PaperReading>,
    /// What is claimed, in the order of the question.
    pub rows: Vec<ReadingRow>,
}

/// What is claimed of one or several readings.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadingRow {
    /// For each reading of the table the place of its claim among the question's; null where it has none.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "(number | null)[]"))]
    pub claims: Vec<Option<usize>>,
}

impl ByReading {
    /// One row for all claims that say the same, as long as their readings differ: of a second one of the same reading another row begins.
    pub(super) fn of(claims: &[Claim]) -> Self {
        let occurs = |reading: &PaperReading| claims.iter().any(|claim| claim.reading == Some(*reading));
        let readings: Vec<PaperReading> = PaperReading::ALL.into_iter().filter(occurs).collect();
        let mut rows: Vec<ReadingRow> = Vec::new();
        for (place, claim) in claims.iter().enumerate() {
            let Some(column) = readings.iter().position(|reading| claim.reading == Some(*reading)) else { continue };
            let takes = |row: &&mut ReadingRow| row.claims[column].is_none() && claims[row.first()].says_the_same(claim);
            match rows.iter_mut().find(takes) {
                Some(row) => row.claims[column] = Some(place),
                None => {
                    let mut claims = vec![None; readings.len()];
                    claims[column] = Some(place);
                    rows.push(ReadingRow { claims });
                }
            }
        }
        Self { readings, rows }
    }
}

impl ReadingRow {
    /// The place of one of its claims; they all say the same.
    pub fn first(&self) -> usize {
        self.claims.iter().flatten().copied().next().unwrap_or(0)
    }
}

impl Question {
    /// A claim's reading is one that its entries can be run by: it is refused where neither is run by it and one is certainly run by another.
    pub(super) fn check_reading(&self, claim: &Claim) -> Result<(), QuestionError> {
        let Some(reading) = claim.reading else { return Ok(()) };
        let of = |id: &String| self.entry(id).and_then(Entry::reading);
        let both = [&claim.improved, &claim.baseline].map(of);
        match both.into_iter().flatten().next() {
            Some(other) if !both.contains(&Some(reading)) => {
                let allowed = format!("{}, by which its entries are run, or entries that are run by this one", other.id());
                Err(QuestionError::field(format!("claims.{}.reading", claim.id), reading.id(), allowed))
            }
            _ => Ok(()),
        }
    }
}

impl Entry {
    /// The reading that it is run by, as far as that is certain: own values over a preset may make another one of it.
    fn reading(&self) -> Option<PaperReading> {
        let planner = self.planner.as_deref().filter(|_| self.set.is_empty())?;
        catalog::find(planner).ok()?.reading_of(self.preset.as_deref())
    }
}

#[cfg(test)]
mod tests;
