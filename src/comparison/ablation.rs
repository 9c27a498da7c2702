//! What each component of a planner does: the full planner beside the same without one component, on the same maps and seeds. How to read
//! it, and what it cannot tell: docs/methodology.md.
//!
//! An ablation is a question like any other. Its entries tell that it is one: `full`, and `without-` with the id of a component for each
//! component; [`roles`] reads them.

mod effects;
mod roles;

use super::question::{Entry, FORMAT, Instance, Question, Role, Seeds};
use crate::catalog::{self, CATALOG};
use crate::error::QuestionError;
use crate::params::{ParamSpec, Values};
use crate::planner::{Component, PlannerEntry};

pub use effects::{Ablated, Effect, Finding, LEVEL, effects};
pub use roles::{AblationRole, roles};

/// Id of the entry with all components.
pub const FULL: &str = "full";

/// What the id of an entry without a component begins with.
pub const WITHOUT: &str = "without-";

/// The entries of an ablation with their parts in it: the planner with this preset and these values, and the same without each of its components. A
/// component that these values turn off already, or whose parameters have no effect beside them, is left out.
///
/// # Errors
/// [`QuestionError`] where the catalog refuses planner, preset or values, and where nothing is left to take out.
pub fn ablation(planner: &str, preset: Option<&str>, set: &Values) -> Result<Vec<(Entry, AblationRole)>, QuestionError> {
    let make = |id: String, label: String, role, set: Values| Entry {
        id,
        label,
        role,
        planner: Some(planner.into()),
        missing: None,
        results: None,
        preset: preset.map(Into::into),
        set,
        first_stage: None,
        published: [].into(),
    };
    let full = make(FULL.into(), String::new(), Role::Improved, set.clone());
    let refused = |error| QuestionError::planner(&full.id, error);
    let entry = catalog::find(planner).map_err(refused)?;
    let values = catalog::values(planner, preset, set).map_err(refused)?;
    let without = |component: &Component| {
        let set = set.clone().into_iter().chain(component.values()).collect();
        let entry = make(format!("{WITHOUT}{}", component.id), format!("without {}", component.name), Role::Other, set);
        (entry, AblationRole::Without { component: component.id.into() })
    };
    let specs = (entry.specs)();
    let rest: Vec<_> = entry.components.iter().filter(|c| is_there(c, &specs, &values)).map(without).collect();
    if rest.is_empty() {
        return Err(nothing_to_take_out(entry));
    }
    Ok(std::iter::once((Entry { label: entry.name.into(), ..full }, AblationRole::Full)).chain(rest).collect())
}

/// Whether a run with these values has the component: one of its rows has an effect, and another value than the one that turns it off.
fn is_there(component: &Component, specs: &[ParamSpec], values: &Values) -> bool {
    let acts = |spec: &ParamSpec| {
        spec.applies_when.as_ref().is_none_or(|when| values.get(when.key).is_some_and(|value| when.values.contains(value)))
    };
    let off = component.values();
    specs.iter().any(|spec| off.get(spec.key).is_some_and(|off| values.get(spec.key) != Some(off) && acts(spec)))
}

fn nothing_to_take_out(entry: &PlannerEntry) -> QuestionError {
    if !entry.components.is_empty() {
        return QuestionError::field("ablation.set", "these values", "such that one component at least is there");
    }
    let able: Vec<&str> = CATALOG.iter().filter(|e| !e.components.is_empty()).map(|e| e.id).collect();
    QuestionError::field("ablation.planner", entry.id, format!("one that has components: {}", able.join(", ")))
}

/// An ablation as a question; see [`ablation`].
///
/// # Errors
/// As [`ablation`].
pub fn question(
    planner: &str,
    preset: Option<&str>,
    set: &Values,
    instances: Vec<Instance>,
    seeds: Seeds,
) -> Result<Question, QuestionError> {
    let entries: Vec<Entry> = ablation(planner, preset, set)?.into_iter().map(|(entry, _)| entry).collect();
    let label = entries.first().map_or(planner, |full| &full.label);
    Ok(Question {
        format: FORMAT.into(),
        title: format!("{label}: what each component does"),
        paper: String::new(),
        asks: format!("What becomes of {label} when one of its components is taken out, and all else stays?"),
        seeds,
        budget: None,
        instances,
        entries,
        claims: Vec::new(),
        facts: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::Value;

    fn ids(planner: &str, preset: Option<&str>, set: &[(&str, &str)]) -> Vec<String> {
        let set = set.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect();
        ablation(planner, preset, &set).unwrap().into_iter().map(|(e, _)| e.id).collect()
    }

    fn refused(planner: &str, set: &[(&str, &str)]) -> (String, String) {
        let set = set.iter().map(|&(k, v)| (k.to_string(), Value::parse(v))).collect();
        let report = ablation(planner, None, &set).unwrap_err().report();
        (report.field, report.message)
    }

    #[test]
    fn every_component_is_taken_out_once_and_all_else_stays() {
        let set: Values = [("ants".to_string(), Value::from(7.0))].into();
        let (entries, roles): (Vec<Entry>, Vec<AblationRole>) =
            ablation("rank-based-ant-system", None, &set).unwrap().into_iter().unzip();
        let without = |component: &str| AblationRole::Without { component: component.into() };
        assert_eq!(roles, [AblationRole::Full, without("ranking"), without("best-so-far-deposit")]);
        assert_eq!(
            entries.iter().map(|e| e.id.as_str()).collect::<Vec<_>>(),
            ["full", "without-ranking", "without-best-so-far-deposit"]
        );
        assert_eq!((entries[0].role, &entries[0].set), (Role::Improved, &set));
        assert_eq!((entries[1].role, entries[1].label.as_str()), (Role::Other, "without deposits by rank"));
        let without: Values = [("ants".to_string(), Value::from(7.0)), ("ranking".to_string(), Value::from(false))].into();
        assert_eq!(entries[1].set, without);
    }

    #[test]
    fn what_is_off_already_or_has_no_effect_is_left_out() {
        let all = ids("ship", None, &[]);
        assert_eq!(all.len(), 10);
        // Eq. 12 has no weights that could shift.
        let printed = ids("ship", Some("printed"), &[]);
        let gone: Vec<&String> = all.iter().filter(|id| !printed.contains(id)).collect();
        assert_eq!(gone, ["without-weighted-paths", "without-shifting-weights"]);
        assert_eq!(ids("acost", None, &[("path_deposit", "0")]), ["full", "without-threshold"]);
        // Both values at once turn the additional trail off, one alone does not.
        assert!(ids("ship", None, &[("k_best", "0")]).contains(&"without-extra-trail".into()));
        assert!(!ids("ship", None, &[("k_best", "0"), ("k_worst", "0")]).contains(&"without-extra-trail".into()));
    }

    #[test]
    fn what_cannot_be_taken_apart_is_refused_by_name() {
        let (field, message) = refused("dijkstra", &[]);
        assert!(field == "ablation.planner" && message.contains("ship"), "{message}");
        assert_eq!(refused("acomsp", &[("maximal", "false")]).0, "ablation.set");
        assert_eq!(refused("bees", &[]).0, "entries.full.planner");
        assert_eq!(refused("ship", &[("rho", "2")]).0, "entries.full.rho");
    }

    #[test]
    fn it_is_a_question_that_can_be_asked() {
        let instance = Instance { id: "a".into(), map: "a.json".into(), note: String::new(), group: None };
        let asked = question("ship", None, &Values::new(), vec![instance], Seeds { from: 1, count: 5 }).unwrap();
        assert_eq!((asked.check(), asked.entries.len()), (Ok(()), 10));
        assert_eq!(asked.title, "Engine-room ACO: what each component does");
    }
}
