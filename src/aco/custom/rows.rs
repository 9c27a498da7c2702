//! The rows of `custom`: which planner lends which rule, the numbers that all of them share, and every donor's own.

use super::donors::{Donor, Donors, Needs};
use crate::aco::shared_params::{SelectionParams, SightParams, WalkParams};
use crate::params;
use crate::params::{AppliesWhen, ParamSpec, Params, Value};
use crate::planner::{Preset, Reading};

params! {
    /// The rules by name, and the numbers that all donors share.
    pub struct CustomParams {
        /// the trails before the first iteration are those of this planner; a hybrid's first stage needs a single goal
        initial_trail_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// what an ant sees of a step is as in this planner
        heuristic_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// an ant selects a step as in this planner; its random numbers are those of this planner
        selection_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// what happens to the trail of each step that an ant takes is as in this planner
        local_update_of: Donor = Donor::AntSystem, "", [], "", "composition; Ant System: nothing";
        /// trails change at the end of an iteration as in this planner
        update_of: Donor = Donor::AntSystem, "", [], "", "composition";
        /// what no single ant could do is as in this planner; MAX–MIN restarts need its update, whose limits they use
        daemon_of: Donor = Donor::AntSystem, "", [], "", "composition; Ant System: nothing";
        /// the best path is refined, or not, as in this planner
        refinement_of: Donor = Donor::AntSystem, "", [], "", "composition; Ant System: not refined";
        /// how the lent rules take the places where their papers contradict themselves
        reading: Reading = Reading::Repaired, "", [], "", "the planners that lend the rules";
        /// ants that build a path in each iteration
        ants: u32 = 50, "m", [1..=1024], "ants", "papers' common value";
        ..selection: SelectionParams;
        /// evaporation rate: the part of every trail that leaves in each iteration
        rho: f64 = 0.5, "ρ", [0.001..=1.0], "", "Dorigo and Stützle 2004, box 3.1";
        ..sight: SightParams;
        ..walk: WalkParams;
    }
}

/// The rows of this file, then every donor's own. Those that only one rule needs say for which of its donors they are.
pub(super) fn specs() -> Vec<ParamSpec> {
    let needs = Donors::needs();
    let mut rows = joined(CustomParams::specs(), Donors::specs());
    for row in &mut rows {
        if let Some((key, values)) = needed_by(&needs, row.key) {
            row.applies_when = Some(AppliesWhen { key, values });
        }
    }
    rows
}

/// The rows of several sets without those that a set before them has.
fn joined(mut rows: Vec<ParamSpec>, more: Vec<ParamSpec>) -> Vec<ParamSpec> {
    for row in more {
        if rows.iter().all(|r| r.key != row.key) {
            rows.push(row);
        }
    }
    rows
}

/// The rule that a row is for, with the ids of the donors for whom it is; none where more than one rule can need it, or the order of
/// several goals.
fn needed_by(needs: &[Needs], key: &str) -> Option<(&'static str, Vec<Value>)> {
    let all: Vec<&Needs> = needs.iter().filter(|n| n.keys.contains(&key)).collect();
    Some((all.first()?.rule, all.iter().map(|n| Value::from(n.donor.id())).collect()))
}

/// All rules from one planner.
macro_rules! all_rules {
    ($id:literal $(, $key:literal = $value:literal)*) => {
        &[
            ("initial_trail_of", $id),
            ("heuristic_of", $id),
            ("selection_of", $id),
            ("local_update_of", $id),
            ("update_of", $id),
            ("daemon_of", $id),
            ("refinement_of", $id),
            $(($key, $value)),*
        ]
    };
}

pub(super) const PRESETS: &[Preset] = &[
    Preset {
        name: "max-min-ant-system",
        source: "Stützle, Hoos 2000",
        meaning: "all rules of MAX–MIN Ant System: the same runs",
        numbers: &[("rho", 0.02)],
        choices: all_rules!("max-min-ant-system"),
        reading: None,
    },
    Preset {
        name: "ant-colony-system",
        source: "Dorigo, Gambardella 1997",
        meaning: "all rules of Ant Colony System: the same runs",
        numbers: &[("ants", 10.0), ("rho", 0.1)],
        choices: all_rules!("ant-colony-system"),
        reading: None,
    },
    Preset {
        name: "fire",
        source: "Zhang et al. 2020",
        meaning: "all rules of the multi-fire ACO: the same runs",
        numbers: &[("beta", 7.0), ("rho", 0.3)],
        choices: all_rules!("fire"),
        reading: None,
    },
    Preset {
        name: "ship",
        source: "Fan et al. 2026",
        meaning: "all rules of the engine-room ACO: the same runs",
        numbers: &[("beta", 2.0), ("rho", 0.8), ("deposit", 10.0)],
        choices: all_rules!("ship"),
        reading: None,
    },
    Preset {
        name: "acost",
        source: "Lai, Guo 2014",
        meaning: "all rules of ACOST: the same runs",
        numbers: &[("ants", 10.0), ("iterations", 50.0), ("beta", 25.0), ("move_limit", 0.0)],
        choices: all_rules!("acost", "dead_end" = "die"),
        reading: None,
    },
    Preset {
        name: "acomsp",
        source: "Lai, Guo 2014",
        meaning: "all rules of ACOMSP: the same runs",
        numbers: &[("ants", 10.0), ("iterations", 50.0), ("beta", 15.0), ("move_limit", 0.0)],
        choices: all_rules!("acomsp", "dead_end" = "die"),
        reading: None,
    },
    Preset {
        name: "fwa-aco",
        source: "Zhou, Mu, Zhang 2019",
        meaning: "all rules of the fireworks hybrid: the same runs",
        numbers: &[("iterations", 50.0), ("alpha", 2.0), ("beta", 8.0), ("rho", 0.1)],
        choices: all_rules!("fwa-aco", "heuristic" = "goal"),
        reading: None,
    },
    Preset {
        name: "pso-aco",
        source: "named by Zhou, Mu, Zhang 2019",
        meaning: "all rules of the particle hybrid: the same runs",
        numbers: &[("iterations", 50.0), ("alpha", 2.0), ("beta", 8.0), ("rho", 0.1)],
        choices: all_rules!("pso-aco", "heuristic" = "goal"),
        reading: None,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_that_only_one_rule_needs_is_a_row_and_names_that_rule_alone() {
        let (needs, rows) = (Donors::needs(), specs());
        for (need, key) in needs.iter().flat_map(|need| need.keys.iter().map(move |key| (need, *key))) {
            assert!(rows.iter().any(|row| row.key == key), "{key} of {}", need.donor.id());
            let rule = needed_by(&needs, key).map(|(rule, _)| rule);
            assert_eq!(rule, Some(need.rule), "{key} of {}", need.donor.id());
        }
    }
}
