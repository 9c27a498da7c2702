//! The question as it is written down: `formicarium/question@1`.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::budget::Budget;
use super::check::one_of;
use super::claim::Claim;
use super::facts::Fact;
use crate::catalog;
use crate::error::QuestionError;
use crate::params::Values;

/// What `format` must say.
pub const FORMAT: &str = "formicarium/question@1";

/// What is asked of a publication, and how it is to be answered.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Question {
    /// [`FORMAT`].
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"formicarium/question@1\""))]
    pub format: String,
    /// One line.
    pub title: String,
    /// The publication, as one cites it; empty for a question that comes from none.
    #[serde(default)]
    pub paper: String,
    /// The question in a sentence or two.
    pub asks: String,
    /// The seeds of every entry on every instance.
    pub seeds: Seeds,
    /// What a run may spend; absent: what its planner's own parameters say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub budget: Option<Budget>,
    /// The maps.
    pub instances: Vec<Instance>,
    /// What runs on them.
    pub entries: Vec<Entry>,
    /// What is claimed.
    #[serde(default)]
    pub claims: Vec<Claim>,
    /// What a map must fulfil to stand for the publication's.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub facts: Vec<Fact>,
}

/// `count` seeds from `from` on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "`from` and `count`, such as { from = 1, count = 30 }")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Seeds {
    /// The first.
    pub from: u32,
    /// How many, 1 to 100,000.
    pub count: u32,
}

impl Seeds {
    /// All of them, in ascending order.
    pub fn iter(self) -> impl Iterator<Item = u32> {
        (0..self.count).map(move |i| self.from.saturating_add(i))
    }
}

/// One map of the question.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Instance {
    /// Stable id: small letters, digits, `-`.
    pub id: String,
    /// The map's file, seen from the question's.
    pub map: String,
    /// What it stands for, and whose it is.
    #[serde(default)]
    pub note: String,
    /// Id of the publication's map that it stands for, as others do too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
    pub group: Option<String>,
}

impl Instance {
    /// Whether an id is its own or its group's.
    pub fn goes_by(&self, id: &str) -> bool {
        self.id == id || self.group.as_deref() == Some(id)
    }
}

/// What an entry is in the comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Role {
    /// What the publication compares with.
    Baseline,
    /// What the publication proposes.
    Improved,
    /// Neither: another reading, a setting.
    Other,
}

/// One algorithm with its parameters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Entry {
    /// Stable id: small letters, digits, `-`.
    pub id: String,
    /// Its name in tables.
    pub label: String,
    /// What it is in the comparison.
    pub role: Role,
    /// Its id in the catalog; absent where nothing can be run.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
    pub planner: Option<String>,
    /// Why nothing can be run; there where neither `planner` nor `results` is.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
    pub missing: Option<String>,
    /// The file whose runs it stands for: results from elsewhere, which are compared and never run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
    pub results: Option<String>,
    /// A named parameter set of the planner.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
    pub preset: Option<String>,
    /// Values over preset and default.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Record<string, number | string | boolean>"))]
    pub set: Values,
    /// Iterations of a first stage, which the publication does not count: the iteration of the best is without them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub first_stage: Option<u32>,
    /// What is published of it, by the instance that stands for the publication's map, or by the group of all that do.
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Record<string, Published>"))]
    pub published: BTreeMap<String, Published>,
}

/// The numbers of one row of a published table.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Published {
    /// Path length in cells.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub length: Option<f64>,
    /// Cost of a path by slices, by the scenario's measure.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub cost: Option<f64>,
    /// Turns of the path.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub turns: Option<f64>,
    /// The turn-weighted index V(d, r) in cells.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub turn_index: Option<f64>,
    /// Σ R in cells of a tour by several goals.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub weight: Option<f64>,
    /// Iterations until the final best was found.
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub iterations: Option<f64>,
    /// Seconds to the goal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub arrival_time: Option<f64>,
}

impl Entry {
    /// What is published of it for an instance: its own numbers, else those of its group.
    pub fn published_for(&self, instance: &Instance) -> Option<&Published> {
        self.published.get(&instance.id).or_else(|| self.published.get(instance.group.as_ref()?))
    }

    /// Whether it is a search that draws no random numbers: each of its runs is the same, whatever the seed, and it has no iterations in which
    /// ants could find something. False of results from elsewhere, of which nobody can tell here.
    pub fn needs_no_seed(&self) -> bool {
        let known = self.planner.as_deref().and_then(|id| catalog::find(id).ok());
        known.is_some_and(|planner| planner.family.needs_no_seed())
    }
}

impl Question {
    /// Keeps the instances of these ids, a group's id for all of its instances. Leaves out every other one, what is published about it, and
    /// claims and facts that are about none that is left.
    ///
    /// # Errors
    /// [`QuestionError`] for an id that no instance and no group has.
    pub fn keep_instances(&mut self, ids: &[String]) -> Result<(), QuestionError> {
        ids.iter().try_for_each(|id| self.check_instance_or_group("instances", id))?;
        self.instances.retain(|i| ids.iter().any(|id| i.goes_by(id)));
        let left = &self.instances;
        let is_left = |id: &String| left.iter().any(|i| i.goes_by(id));
        self.entries.iter_mut().for_each(|e| e.published.retain(|id, _| is_left(id)));
        self.claims.retain(|c| c.instances.is_empty() || c.instances.iter().any(is_left));
        self.claims.iter_mut().for_each(|c| c.instances.retain(is_left));
        self.facts.retain(|f| left.iter().any(|i| f.is_about(i)));
        self.facts.iter_mut().for_each(|f| f.instances.retain(is_left));
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

    /// The groups of the instances, each once.
    pub(super) fn groups(&self) -> BTreeSet<&str> {
        self.instances.iter().filter_map(|i| i.group.as_deref()).collect()
    }

    /// Adds one more instance to those of its group.
    ///
    /// # Errors
    /// [`QuestionError`] if no instance has this group, or if one has this id already.
    pub fn add_instance(&mut self, added: Instance) -> Result<(), QuestionError> {
        let groups = self.groups();
        if !added.group.as_deref().is_some_and(|group| groups.contains(group)) {
            let allowed = if groups.is_empty() { "absent: the question has no groups".into() } else { one_of(groups) };
            return Err(QuestionError::field("instances.group", added.group.unwrap_or_default(), allowed));
        }
        if self.instances.iter().any(|i| i.goes_by(&added.id)) {
            return Err(QuestionError::field("instances.id", added.id, "different from the id of every instance and group"));
        }
        self.instances.push(added);
        Ok(())
    }

    /// The place of an instance among the question's.
    ///
    /// # Errors
    /// [`QuestionError`] if there is none of this id.
    pub fn place(&self, id: &str) -> Result<usize, QuestionError> {
        self.check_instance("instances", id)?;
        self.instances.iter().position(|i| i.id == id).ok_or_else(|| QuestionError::outside("instance"))
    }

    /// The places of the entries that can be run, in their order; the others have their results from elsewhere, or none.
    pub fn runnable(&self) -> Vec<usize> {
        (0..self.entries.len()).filter(|&entry| self.entries[entry].planner.is_some()).collect()
    }

    /// The entry of an id.
    pub fn entry(&self, id: &str) -> Option<&Entry> {
        self.entries.iter().find(|e| e.id == id)
    }

    /// By which part of the baseline's value a claim's entries are said to differ on an instance, counted as the claim counts; none where
    /// their published numbers are the same.
    pub fn claimed_size(&self, claim: &Claim, instance: &Instance) -> Option<f64> {
        if claim.size.is_some() {
            return claim.size;
        }
        let published = |id: &str| claim.measure.published(self.entry(id)?.published_for(instance)?);
        let (improved, baseline) = (published(&claim.improved)?, published(&claim.baseline)?);
        (baseline > 0.0 && improved != baseline).then(|| claim.direction.signed(improved - baseline) / baseline)
    }
}
