//! Whether a question can be asked as it is written, and what follows from it.

use std::collections::BTreeSet;

use thiserror::Error;

use super::question::{Axis, Budget, Claim, Entry, FORMAT, Instance, Question};
use crate::catalog;
use crate::error::{ErrorReport, ParamError};

/// Largest number of runs of one entry on one instance.
const MAX_SEEDS: u32 = 100_000;

/// A question cannot be asked as it is written.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum QuestionError {
    /// It is of another version, or something else.
    #[error("`format` is `{found}`")]
    Version {
        /// What it says.
        found: String,
    },
    /// A field does not fit.
    #[error("{field} = {value} cannot be used: it must be {allowed}")]
    Field {
        /// Where it stands, e.g. `claims.shorter.baseline`.
        field: String,
        /// What stands there.
        value: String,
        /// What may stand there.
        allowed: String,
    },
    /// The catalog refuses an entry.
    #[error("entries.{entry}: {error}")]
    Planner {
        /// The entry's id.
        entry: String,
        /// Why.
        error: Box<ParamError>,
    },
}

impl QuestionError {
    /// The catalog refuses an entry.
    pub(super) fn planner(entry: &Entry, error: ParamError) -> Self {
        Self::Planner { entry: entry.id.clone(), error: Box::new(error) }
    }

    pub(super) fn field(field: impl Into<String>, value: impl ToString, allowed: impl Into<String>) -> Self {
        Self::Field { field: field.into(), value: value.to_string(), allowed: allowed.into() }
    }

    /// A run that the question does not ask for.
    pub(crate) fn outside(field: &str) -> Self {
        Self::field(format!("task.{field}"), "outside", "one of the question's runs")
    }

    /// The flat form.
    pub fn report(&self) -> ErrorReport {
        let message = self.to_string();
        match self {
            Self::Version { found } => {
                ErrorReport::new("version", "format", message, format!("this engine reads `{FORMAT}`")).with("value", found)
            }
            Self::Field { field, value, allowed } => {
                ErrorReport::new("question-field", field, message, format!("give {allowed}")).with("value", value)
            }
            Self::Planner { entry, error } => {
                let report = error.report();
                ErrorReport { field: format!("entries.{entry}.{}", report.field), message, ..report }
            }
        }
    }
}

impl Question {
    /// Checks everything that needs no map.
    ///
    /// # Errors
    /// [`QuestionError`] with the first field that does not fit.
    pub fn check(&self) -> Result<(), QuestionError> {
        if self.format != FORMAT {
            return Err(QuestionError::Version { found: self.format.clone() });
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
        self.entries.iter().try_for_each(|e| self.check_entry(e))?;
        self.claims.iter().try_for_each(|c| self.check_claim(c))
    }

    /// Leaves out every other instance, what is published about it, and claims that are about none that is left.
    ///
    /// # Errors
    /// [`QuestionError`] for an id that no instance has.
    pub fn keep_instances(&mut self, ids: &[String]) -> Result<(), QuestionError> {
        ids.iter().try_for_each(|id| self.check_instance("instances", id))?;
        self.instances.retain(|i| ids.contains(&i.id));
        self.entries.iter_mut().for_each(|e| e.published.retain(|id, _| ids.contains(id)));
        self.claims.retain(|c| c.instances.is_empty() || c.instances.iter().any(|i| ids.contains(i)));
        self.claims.iter_mut().for_each(|c| c.instances.retain(|i| ids.contains(i)));
        Ok(())
    }

    /// The instance of an id, to be changed.
    ///
    /// # Errors
    /// [`QuestionError`] if there is none.
    pub fn instance_mut(&mut self, id: &str) -> Result<&mut Instance, QuestionError> {
        self.check_instance("instances", id)?;
        self.instances.iter_mut().find(|i| i.id == id).ok_or_else(|| QuestionError::outside("instance"))
    }

    /// The place of an instance among the question's.
    ///
    /// # Errors
    /// [`QuestionError`] if there is none of this id.
    pub fn place(&self, id: &str) -> Result<usize, QuestionError> {
        self.check_instance("instances", id)?;
        self.instances.iter().position(|i| i.id == id).ok_or_else(|| QuestionError::outside("instance"))
    }

    /// The entry of an id.
    pub fn entry(&self, id: &str) -> Option<&Entry> {
        self.entries.iter().find(|e| e.id == id)
    }

    /// By which part of the baseline's value a claim's entries are said to differ on an instance, counted as the claim counts.
    pub fn claimed_size(&self, claim: &Claim, instance: &str) -> Option<f64> {
        if claim.size.is_some() {
            return claim.size;
        }
        let published = |id: &str| claim.measure.published(self.entry(id)?.published.get(instance)?);
        let (improved, baseline) = (published(&claim.improved)?, published(&claim.baseline)?);
        (baseline > 0.0).then(|| claim.direction.signed(improved - baseline) / baseline)
    }

    fn check_entry(&self, entry: &Entry) -> Result<(), QuestionError> {
        let at = |field: &str| format!("entries.{}.{field}", entry.id);
        let given = [&entry.planner, &entry.missing, &entry.results].into_iter().flatten().count();
        if given != 1 {
            let value = entry.planner.as_deref().unwrap_or("absent");
            let allowed = "an id of the catalog, or else `missing` says why there is none, or `results` names a file of runs";
            return Err(QuestionError::field(at("planner"), value, allowed));
        }
        if let Some(id) = &entry.planner {
            catalog::find(id).map_err(|error| QuestionError::planner(entry, error))?;
        }
        for (instance, row) in &entry.published {
            self.check_instance(&at("published"), instance)?;
            let numbers = [row.length, row.cost, row.turns, row.turn_index, row.weight, row.iterations];
            if let Some(wrong) = numbers.into_iter().flatten().find(|v| !(v.is_finite() && *v >= 0.0)) {
                return Err(QuestionError::field(at(&format!("published.{instance}")), wrong, "numbers of at least 0"));
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

    fn check_instance(&self, field: &str, id: &str) -> Result<(), QuestionError> {
        if self.instances.iter().any(|i| i.id == id) {
            return Ok(());
        }
        Err(QuestionError::field(field, id, format!("one of {}", list(self.instances.iter().map(|i| &i.id)))))
    }
}

impl Budget {
    /// Whether runs can be ended by it.
    pub(super) fn check(self) -> Result<(), QuestionError> {
        match self {
            Self { axis: Axis::Time, .. } => {
                let allowed = "iterations, constructed-paths, ant-moves, cell-expansions or moves: by time no two machines agree";
                Err(QuestionError::field("budget.axis", "time", allowed))
            }
            Self { amount: 0, .. } => Err(QuestionError::field("budget.amount", 0, "at least 1")),
            _ => Ok(()),
        }
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
mod tests {
    use super::super::question::{Direction, Seeds};
    use super::*;
    use serde_json::json;

    fn question() -> Question {
        serde_json::from_value(json!({
            "format": FORMAT, "title": "t", "asks": "?", "seeds": { "from": 1, "count": 3 },
            "instances": [{ "id": "a", "map": "a.json" }, { "id": "b", "map": "b.json" }],
            "entries": [
                { "id": "old", "label": "old", "role": "baseline", "planner": "ant-system",
                  "published": { "a": { "length": 40.0, "turns": 20 }, "b": { "length": 50.0 } } },
                { "id": "new", "label": "new", "role": "improved", "planner": "ship", "published": { "a": { "length": 30.0 } } },
                { "id": "ref", "label": "ref", "role": "other", "missing": "formulas not published" }
            ],
            "claims": [{ "id": "shorter", "says": "shorter", "improved": "new", "baseline": "old", "measure": "length", "direction": "less" }]
        }))
        .unwrap()
    }

    #[test]
    fn a_claims_size_follows_from_the_published_numbers() {
        let q = question();
        assert_eq!(q.check(), Ok(()));
        // (40 − 30) / 40.
        assert_eq!(q.claimed_size(&q.claims[0], "a"), Some(0.25));
        assert_eq!(q.claimed_size(&q.claims[0], "b"), None);
        let stated = Claim { size: Some(0.1), ..q.claims[0].clone() };
        assert_eq!(q.claimed_size(&stated, "b"), Some(0.1));
    }

    #[test]
    fn what_does_not_fit_is_named() {
        let wrong = |change: fn(&mut Question), field: &str| {
            let mut q = question();
            change(&mut q);
            let report = q.check().unwrap_err().report();
            assert_eq!(report.field, field, "{}", report.message);
            assert!(!report.hint.is_empty());
        };
        wrong(|q| q.format = "formicarium/question@2".into(), "format");
        wrong(|q| q.seeds.count = 0, "seeds.count");
        wrong(|q| q.seeds.from = u32::MAX, "seeds.from");
        wrong(|q| q.budget = Some(Budget { axis: Axis::Time, amount: 3 }), "budget.axis");
        wrong(|q| q.budget = Some(Budget { axis: Axis::Moves, amount: 0 }), "budget.amount");
        wrong(|q| q.entries[0].results = Some("mine.csv".into()), "entries.old.planner");
        wrong(|q| q.instances.clear(), "instances");
        wrong(|q| q.instances[0].id = "A map".into(), "instances.id");
        wrong(|q| q.entries[1].id = "old".into(), "entries.id");
        wrong(|q| q.entries[0].planner = Some("bee".into()), "entries.old.planner");
        wrong(|q| q.entries[0].planner = None, "entries.old.planner");
        wrong(|q| q.entries[2].planner = Some("ship".into()), "entries.ref.planner");
        wrong(|q| q.claims[0].baseline = "older".into(), "claims.shorter.baseline");
        wrong(|q| q.claims[0].instances = vec!["c".into()], "claims.shorter.instances");
        wrong(|q| q.claims[0].direction = Direction::More, "claims.shorter.size");
        wrong(|q| q.claims[0].size = Some(f64::NAN), "claims.shorter.size");
    }

    #[test]
    fn instances_can_be_left_out() {
        let mut q = question();
        q.claims.push(Claim { id: "on-a".into(), instances: vec!["a".into()], ..q.claims[0].clone() });
        q.keep_instances(&["b".into()]).unwrap();
        assert_eq!((q.instances.len(), q.claims.len(), q.entries[0].published.len()), (1, 1, 1));
        assert_eq!(q.check(), Ok(()));
        assert!(q.keep_instances(&["a".into()]).is_err());
        assert!(q.instance_mut("a").is_err());
        assert_eq!(q.instance_mut("b").unwrap().map, "b.json");
    }

    #[test]
    fn unknown_fields_are_refused() {
        let error = serde_json::from_value::<Seeds>(json!({ "from": 1, "count": 2, "till": 3 })).unwrap_err();
        assert!(error.to_string().contains("till"));
    }
}
