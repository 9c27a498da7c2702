//! Whether a question can be asked as it is written.

use std::collections::BTreeSet;

use super::claim::Claim;
use super::question::{Entry, FORMAT, Question};
use super::row::MAX_COUNT;
use crate::catalog::{self, MAX_SEEDS};
use crate::error::QuestionError;

/// Largest number of runs altogether: what is more fits into no memory, and is no question for one machine.
const MAX_RUNS: u64 = 2_000_000;

impl Question {
    /// Checks everything that needs no map.
    ///
    /// # Errors
    /// [`QuestionError`] with the first field that does not fit.
    pub fn check(&self) -> Result<(), QuestionError> {
        if self.format != FORMAT {
            return Err(QuestionError::Version { found: self.format.clone(), expected: FORMAT });
        }
        if !(1..=MAX_SEEDS).contains(&self.seeds.count) {
            return Err(QuestionError::field("seeds.count", self.seeds.count, format!("1 to {MAX_SEEDS}")));
        }
        if self.seeds.from.checked_add(self.seeds.count - 1).is_none() {
            return Err(QuestionError::field("seeds.from", self.seeds.from, format!("at most {} − count + 1", u32::MAX)));
        }
        self.budget.map_or(Ok(()), |budget| budget.check())?;
        check_ids("instances", self.instances.iter().map(|i| &i.id), true)?;
        check_ids("entries", self.entries.iter().map(|e| &e.id), true)?;
        check_ids("claims", self.claims.iter().map(|c| &c.id), false)?;
        self.check_runs()?;
        self.entries.iter().try_for_each(|e| self.check_entry(e))?;
        self.claims.iter().try_for_each(|c| self.check_claim(c))
    }

    fn check_runs(&self) -> Result<(), QuestionError> {
        let [instances, entries] = [self.instances.len(), self.entries.len()].map(|n| n as u64);
        let runs = instances.saturating_mul(entries).saturating_mul(self.seeds.count.into());
        if runs <= MAX_RUNS {
            return Ok(());
        }
        let asked = format!("{instances} maps × {entries} entries × {} seeds", self.seeds.count);
        Err(QuestionError::field("seeds.count", asked, format!("at most {MAX_RUNS} runs altogether; split the question")))
    }

    fn check_entry(&self, entry: &Entry) -> Result<(), QuestionError> {
        let at = |field: &str| format!("entries.{}.{field}", entry.id);
        let sources = [&entry.planner, &entry.missing, &entry.results].into_iter().flatten().count();
        if sources != 1 {
            let value = entry.planner.as_deref().unwrap_or("absent");
            let allowed = "an id of the catalog, or else `missing` says why there is none, or `results` names a file of runs";
            return Err(QuestionError::field(at("planner"), value, allowed));
        }
        if let Some(id) = &entry.planner {
            catalog::find(id).map_err(|error| QuestionError::planner(&entry.id, error))?;
        }
        self.check_published(entry)
    }

    fn check_published(&self, entry: &Entry) -> Result<(), QuestionError> {
        let at = |field: &str| format!("entries.{}.{field}", entry.id);
        for (instance, row) in &entry.published {
            self.check_instance(&at("published"), instance)?;
            let numbers = [row.length, row.cost, row.turns, row.turn_index, row.weight, row.iterations];
            if let Some(wrong) = numbers.into_iter().flatten().find(|v| !(v.is_finite() && *v >= 0.0)) {
                return Err(QuestionError::field(at(&format!("published.{instance}")), wrong, "numbers of at least 0"));
            }
            // As floats they came, so that 2⁵³ itself may have been another number.
            if let Some(wrong) = [row.turns, row.iterations].into_iter().flatten().find(|v| *v >= MAX_COUNT as f64) {
                let allowed = format!("counts below {MAX_COUNT}");
                return Err(QuestionError::field(at(&format!("published.{instance}")), wrong, allowed));
            }
        }
        Ok(())
    }

    fn check_claim(&self, claim: &Claim) -> Result<(), QuestionError> {
        let at = |field: &str| format!("claims.{}.{field}", claim.id);
        for (field, id) in [("improved", &claim.improved), ("baseline", &claim.baseline)] {
            if self.entry(id).is_none() {
                return Err(QuestionError::field(at(field), id, format!("one of {}", list(self.entries.iter().map(|e| &e.id)))));
            }
        }
        claim.instances.iter().try_for_each(|i| self.check_instance(&at("instances"), i))?;
        let about = self.instances.iter().filter(|i| claim.is_about(&i.id));
        for size in about.filter_map(|i| self.claimed_size(claim, &i.id)) {
            if !(size.is_finite() && size > 0.0) {
                return Err(QuestionError::field(at("size"), size, "above 0: published numbers differ in the claimed direction"));
            }
        }
        Ok(())
    }

    pub(super) fn check_instance(&self, field: &str, id: &str) -> Result<(), QuestionError> {
        if self.instances.iter().any(|i| i.id == id) {
            return Ok(());
        }
        Err(QuestionError::field(field, id, format!("one of {}", list(self.instances.iter().map(|i| &i.id)))))
    }
}

fn list<'a>(ids: impl Iterator<Item = &'a String>) -> String {
    ids.map(String::as_str).collect::<Vec<_>>().join(", ")
}

/// Ids are file names, columns of a CSV and names of random streams: plain, and each one once.
fn check_ids<'a>(field: &str, ids: impl Iterator<Item = &'a String>, needed: bool) -> Result<(), QuestionError> {
    let mut seen = BTreeSet::new();
    for id in ids {
        let plain = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-';
        if id.is_empty() || !id.bytes().all(plain) {
            return Err(QuestionError::field(format!("{field}.id"), id, "made of a to z, 0 to 9 and -"));
        }
        if !seen.insert(id) {
            return Err(QuestionError::field(format!("{field}.id"), id, "different from every other one"));
        }
    }
    if needed && seen.is_empty() {
        return Err(QuestionError::field(field, "nothing", "at least one"));
    }
    Ok(())
}

#[cfg(test)]
mod tests;
