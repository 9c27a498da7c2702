//! Which entry of a question plays which part in an ablation.

use serde::Serialize;

use super::{FULL, WITHOUT};
use crate::catalog;
use crate::comparison::question::{Entry, Question};
use crate::planner::Component;

/// What an entry is in an ablation.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum AblationRole {
    /// The planner with all of its components.
    Full,
    /// The same without one of them.
    Without {
        /// Id of the component that is missing, as the catalog has it.
        component: String,
    },
}

/// For each entry of a question its part in an ablation; none for an entry that has no part in it, and for all where the question is none.
pub fn roles(question: &Question) -> Vec<Option<AblationRole>> {
    let mut roles = vec![None; question.entries.len()];
    if let Some((full, components)) = parts(question) {
        roles[full] = Some(AblationRole::Full);
        for (entry, component) in components {
            roles[entry] = Some(AblationRole::Without { component: component.id.into() });
        }
    }
    roles
}

/// The place of the full entry, and of the entries without a component. None where the question is no ablation.
pub(super) fn parts(question: &Question) -> Option<(usize, Vec<(usize, &'static Component)>)> {
    let entries = &question.entries;
    let full = entries.iter().position(|e| e.id == FULL)?;
    let planner = entries[full].planner.as_deref()?;
    let known = catalog::find(planner).ok()?.components;
    let component = |e: &Entry| {
        let id = e.id.strip_prefix(WITHOUT).filter(|_| e.planner.as_deref() == Some(planner))?;
        known.iter().find(|c| c.id == id)
    };
    let without: Vec<_> = entries.iter().enumerate().filter_map(|(place, e)| Some((place, component(e)?))).collect();
    (!without.is_empty()).then_some((full, without))
}
