//! What a publication says of its maps, which one of ours must fulfil to stand for it.

use serde::{Deserialize, Serialize};

use super::claim::Claim;
use super::gap::is_below;
use super::judge::FEWEST_RUNS;
use super::printed_digits::half_unit;
use super::question::Instance;
use super::samples::Samples;
use crate::exact::Reference;

/// What a publication says of a map. A map of ours that contradicts it cannot stand for it: of claims about it nothing can be told; where
/// somebody does not arrive, of claims about this entry.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Fact {
    /// The group of the instances that it is about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
    pub group: Option<String>,
    /// Ids of the instances or groups that it is about; empty, and without a group: all.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub instances: Vec<String>,
    /// Where the publication says so.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub says: String,
    /// The least published length (by slices and on weighted ground cost): the exact optimum under the map's rule cannot be above it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub optimum_at_most: Option<f64>,
    /// The entry whose kind of path that optimum is of. Absent: by steps, by slices, or of a tour by several goals, as the map is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "string | null"))]
    pub optimum_of: Option<String>,
    /// Ids of the entries that find a path there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub arrives: Vec<String>,
    /// In which share of their runs at least. Absent: [`Fact::HALF`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number | null"))]
    pub in_at_least: Option<f64>,
}

impl Fact {
    /// In which share of its runs somebody who arrives does so at least.
    pub const HALF: f64 = 0.5;

    /// Whether it is about an instance.
    pub fn is_about(&self, instance: &Instance) -> bool {
        match &self.group {
            Some(group) => instance.group.as_ref() == Some(group),
            None => self.instances.is_empty() || self.instances.iter().any(|id| instance.goes_by(id)),
        }
    }

    /// The entries that it names, with the fields that do.
    pub(super) fn entries(&self) -> impl Iterator<Item = (&'static str, &String)> {
        let of = self.optimum_of.iter().map(|id| ("optimum_of", id));
        of.chain(self.arrives.iter().map(|id| ("arrives", id)))
    }
}

/// A map that cannot stand for the publication's.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct UnfitMap {
    /// Id of the instance.
    pub instance: String,
    /// Where the publication says what it contradicts.
    pub says: String,
    /// Why it cannot.
    pub why: Unfit,
    /// Id of the entry whose runs or whose kind of path tell.
    pub entry: Option<String>,
    /// What is there: the optimum, or the share of runs with a path; null where no path exists.
    pub found: Option<f64>,
    /// What had to be: the greatest optimum, or the least share.
    pub demanded: f64,
}

/// Why a map cannot stand for the publication's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Unfit {
    /// Its optimum is above the least published length.
    Optimum,
    /// Somebody who arrives in the publication does not arrive here.
    Arrives,
}

impl UnfitMap {
    /// Whether nothing can be told of a claim here: an optimum speaks of the map, and who does not arrive of his own claims alone.
    pub(super) fn concerns(&self, claim: &Claim) -> bool {
        match self.why {
            Unfit::Optimum => true,
            Unfit::Arrives => self.entry.as_ref().is_some_and(|entry| [&claim.improved, &claim.baseline].contains(&entry)),
        }
    }
}

/// What maps contradict: of each the first optimum that it has not, and everybody who does not arrive, each once.
pub(super) fn unfit(samples: &Samples) -> Vec<UnfitMap> {
    let question = &samples.comparison().question;
    let of_map = |(index, instance): (usize, &Instance)| {
        let about: Vec<&Fact> = question.facts.iter().filter(|fact| fact.is_about(instance)).collect();
        let too_far = about.iter().find_map(|fact| too_far(samples, index, fact));
        let mut told: Vec<UnfitMap> = too_far.into_iter().collect();
        for missing in about.iter().flat_map(|fact| not_arriving(samples, index, fact)) {
            if !told.iter().any(|map| map.why == Unfit::Arrives && map.entry == missing.entry) {
                told.push(missing);
            }
        }
        told
    };
    question.instances.iter().enumerate().flat_map(of_map).collect()
}

/// Only a proven optimum contradicts, and only by more than the published number's rounding.
fn too_far(samples: &Samples, index: usize, fact: &Fact) -> Option<UnfitMap> {
    let (map, question) = (&samples.comparison().maps[index], &samples.comparison().question);
    let most = fact.optimum_at_most?;
    let of = fact.optimum_of.as_ref().and_then(|id| question.entries.iter().position(|e| e.id == *id));
    let found = match of.map_or_else(|| map.own_reference(), |entry| map.reference(entry)) {
        Reference::NoPath => None,
        Reference::Proven { value } if is_below(most + half_unit(std::iter::once(most)), value) => Some(value),
        _ => return None,
    };
    let instance = question.instances[index].id.clone();
    let (says, entry) = (fact.says.clone(), fact.optimum_of.clone());
    Some(UnfitMap { instance, says, why: Unfit::Optimum, entry, found, demanded: most })
}

/// Of fewer runs than a verdict needs nothing is said.
fn not_arriving(samples: &Samples, index: usize, fact: &Fact) -> Vec<UnfitMap> {
    let question = &samples.comparison().question;
    let demanded = fact.in_at_least.unwrap_or(Fact::HALF);
    let share = |id: &String| {
        let entry = question.entries.iter().position(|e| e.id == *id)?;
        let runs = samples.of(index, entry);
        let with_path = runs.iter().filter(|seen| seen.row.found.is_some()).count();
        (runs.len() >= FEWEST_RUNS).then(|| with_path as f64 / runs.len() as f64)
    };
    let fewer = fact.arrives.iter().filter_map(|id| Some((id, share(id).filter(|s| *s < demanded)?)));
    let told = |(entry, found): (&String, f64)| UnfitMap {
        instance: question.instances[index].id.clone(),
        says: fact.says.clone(),
        why: Unfit::Arrives,
        entry: Some(entry.clone()),
        found: Some(found),
        demanded,
    };
    fewer.map(told).collect()
}

#[cfg(test)]
mod tests;
