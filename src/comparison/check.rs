//! Whether a question can be asked as it is written.

use std::collections::BTreeSet;

use super::budget::Axis;
use super::claim::Claim;
use super::facts::Fact;
use super::measure::RunMeasure;
use super::question::{Entry, FORMAT, Question};
use super::row::MAX_COUNT;
use crate::catalog::{self, MAX_SEEDS};
use crate::error::QuestionError;

/// Largest number of runs altogether: what is more fits into no memory, and is no question for one machine.
const MAX_RUNS: u64 = 2_000_000;

/// Farthest target of a running time, as a part of the best known value: what is farther is no target.
const MAX_TARGET: f64 = 100.0;

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
        self.check_groups()?;
        check_ids("entries", self.entries.iter().map(|e| &e.id), true)?;
        check_ids("claims", self.claims.iter().map(|c| &c.id), false)?;
        self.check_runs()?;
        self.entries.iter().try_for_each(|e| self.check_entry(e))?;
        self.claims.iter().try_for_each(|c| self.check_claim(c))?;
        self.facts.iter().enumerate().try_for_each(|(place, fact)| self.check_fact(place, fact))
    }

    /// A name must not mean one map here and several there.
    fn check_groups(&self) -> Result<(), QuestionError> {
        for instance in &self.instances {
            let Some(group) = &instance.group else { continue };
            let at = format!("instances.{}.group", instance.id);
            check_plain(&at, group)?;
            if self.instances.iter().any(|i| i.id == *group) {
                return Err(QuestionError::field(at, group, "different from the id of every instance"));
            }
        }
        Ok(())
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
            self.check_instance_or_group(&at("published"), instance)?;
            let numbers = [row.length, row.cost, row.turns, row.turn_index, row.weight, row.iterations, row.arrival_time];
            if let Some(wrong) = numbers.into_iter().flatten().find(|v| !(v.is_finite() && v.is_sign_positive())) {
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
                return Err(QuestionError::field(at(field), id, one_of(self.entries.iter().map(|e| e.id.as_str()))));
            }
        }
        if claim.improved == claim.baseline {
            return Err(QuestionError::field(at("baseline"), &claim.baseline, "another entry than the improved one"));
        }
        claim.instances.iter().try_for_each(|i| self.check_instance_or_group(&at("instances"), i))?;
        let about = self.instances.iter().filter(|i| claim.is_about(i));
        for size in about.filter_map(|i| self.claimed_size(claim, i)) {
            if !(size.is_finite() && size > 0.0) {
                return Err(QuestionError::field(at("size"), size, "above 0: published numbers differ in the claimed direction"));
            }
        }
        if let Some(wrong) = claim.relevant.filter(|v| !(*v > 0.0 && *v < 1.0)) {
            return Err(QuestionError::field(at("relevant"), wrong, "above 0 and below 1: a part of the baseline's value"));
        }
        self.check_reading(claim)?;
        check_running_time(claim)
    }

    fn check_fact(&self, place: usize, fact: &Fact) -> Result<(), QuestionError> {
        let at = |field: &str| format!("facts.{place}.{field}");
        if let Some(group) = &fact.group {
            if !self.instances.iter().any(|i| i.group.as_ref() == Some(group)) {
                return Err(QuestionError::field(at("group"), group, "the group of an instance"));
            }
            if !fact.instances.is_empty() {
                return Err(QuestionError::field(at("instances"), fact.instances.join(", "), "absent where there is a group"));
            }
        }
        fact.instances.iter().try_for_each(|i| self.check_instance_or_group(&at("instances"), i))?;
        for (field, id) in fact.entries() {
            if self.entry(id).is_none() {
                return Err(QuestionError::field(at(field), id, one_of(self.entries.iter().map(|e| e.id.as_str()))));
            }
        }
        if let Some((field, id)) = fact.entries().find(|(_, id)| self.entry(id).is_some_and(|e| e.missing.is_some())) {
            return Err(QuestionError::field(at(field), id, "an entry that can be run, or that has results"));
        }
        if fact.optimum_at_most.is_none() && (fact.arrives.is_empty() || fact.optimum_of.is_some()) {
            let allowed = "there: a fact says of a map what its optimum is at most, or who arrives, or both";
            return Err(QuestionError::field(at("optimum_at_most"), "absent", allowed));
        }
        if let Some(wrong) = fact.optimum_at_most.filter(|v| !(v.is_finite() && *v > 0.0)) {
            return Err(QuestionError::field(at("optimum_at_most"), wrong, "above 0: a published length, by slices a cost"));
        }
        match fact.in_at_least {
            Some(wrong) if !(wrong > 0.0 && wrong <= 1.0) => {
                Err(QuestionError::field(at("in_at_least"), wrong, "above 0, and at most 1: a share of runs"))
            }
            Some(share) if fact.arrives.is_empty() => {
                Err(QuestionError::field(at("in_at_least"), share, "absent where nobody is said to arrive"))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn check_instance_or_group(&self, field: &str, id: &str) -> Result<(), QuestionError> {
        if self.instances.iter().any(|i| i.goes_by(id)) {
            return Ok(());
        }
        Err(QuestionError::field(field, id, one_of(self.instances.iter().map(|i| i.id.as_str()).chain(self.groups()))))
    }

    pub(super) fn check_instance(&self, field: &str, id: &str) -> Result<(), QuestionError> {
        if self.instances.iter().any(|i| i.id == id) {
            return Ok(());
        }
        Err(QuestionError::field(field, id, one_of(self.instances.iter().map(|i| i.id.as_str()))))
    }
}

/// What may stand where one of these ids must.
pub(super) fn one_of<'a>(ids: impl IntoIterator<Item = &'a str>) -> String {
    format!("one of {}", ids.into_iter().collect::<Vec<_>>().join(", "))
}

/// What only a running time has, and what none can be counted in.
fn check_running_time(claim: &Claim) -> Result<(), QuestionError> {
    let at = |field: &str| format!("claims.{}.{field}", claim.id);
    let is_time = claim.measure == RunMeasure::RunningTime;
    match (claim.target, claim.axis) {
        (Some(target), _) if !is_time => Err(QuestionError::field(at("target"), target, "absent: only a running time has one")),
        (_, Some(axis)) if !is_time => Err(QuestionError::field(at("axis"), axis.words(), "absent: only a running time has one")),
        (Some(target), _) if !(0.0..=MAX_TARGET).contains(&target) => {
            let allowed = format!("0 to {MAX_TARGET}: how near to the best known value, as a part of it");
            Err(QuestionError::field(at("target"), target, allowed))
        }
        (_, Some(Axis::Time)) => Err(QuestionError::field(at("axis"), "time", Axis::BY_NO_CLOCK)),
        _ => Ok(()),
    }
}

fn check_plain(field: &str, id: &str) -> Result<(), QuestionError> {
    let plain = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-';
    if id.is_empty() || !id.bytes().all(plain) {
        return Err(QuestionError::field(field, id, "made of a to z, 0 to 9 and -"));
    }
    Ok(())
}

/// Ids are file names, columns of a CSV and names of random streams: plain, and each one once.
fn check_ids<'a>(field: &str, ids: impl Iterator<Item = &'a String>, needed: bool) -> Result<(), QuestionError> {
    let mut seen = BTreeSet::new();
    for id in ids {
        check_plain(&format!("{field}.id"), id)?;
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
