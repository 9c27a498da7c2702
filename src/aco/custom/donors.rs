//! Who lends rules: one variant of every planner, made from the same numbers.
//!
//! A donor is one line of the list at the end of this file. Whatever else the composer has to know of it follows from its planner: the id
//! from its entry, how its ants may walk from the constants of its [`Variant`], its rows from its `params!` set.

use std::sync::Arc;

use crate::aco::classics::*;
use crate::aco::papers::*;
use crate::aco::variant::Variant;
use crate::error::ParamError;
use crate::params::{ParamChoice, ParamSpec, ParamType, Params, Values};
use crate::planner::Planner;
use crate::scenario::Scenario;

use super::rows::CustomParams;

/// Reads a parameter set from the values of all; the keys of other sets are left alone.
pub(super) fn pick<P: Params>(values: &Values) -> Result<P, ParamError> {
    P::pick(values, P::default())
}

/// A variant from the values of all.
fn variant<P: Params, V>(make: fn(P) -> V, values: &Values) -> Result<V, ParamError> {
    pick(values).map(make)
}

/// A rule and those of a donor's rows that only this rule needs.
pub(super) struct Needs {
    /// Key of the row that names the rule's donor.
    pub(super) rule: &'static str,
    pub(super) donor: Donor,
    pub(super) keys: Vec<&'static str>,
}

/// The key of a row, given by its field; the function is there so that the compiler looks for the field.
fn key<P: Params, T: ParamType>(_: fn(&P) -> T, field: &'static str) -> &'static str {
    field.rsplit('.').next().map_or(field, str::trim)
}

/// The keys of all rows of a set that another set has taken in, without those that all donors share.
fn keys<P: Params, S: Params>(_: fn(&P) -> &S) -> Vec<&'static str> {
    let shared = CustomParams::specs();
    S::specs().into_iter().map(|row| row.key).filter(|key| shared.iter().all(|row| row.key != *key)).collect()
}

/// A donor: doc comment = its name; `Donor: module::{ENTRY, Variant::new(Params)}`. After it may stand `after stage`, a function of its
/// module that makes the planner whose path seeds its trails. In braces `rule_of: [rows]`: the rows of `Params` that have no effect unless that
/// rule is this donor's, with `and all of [sets]` for the sets that `Params` takes in. A row that several rules need is not named; then it always
/// counts. The first `$` lets the list define macros of its own.
macro_rules! donors {
    ($d:tt $(
        #[doc = $name:literal]
        $donor:ident: $module:ident::{$entry:ident, $variant:ident::$new:ident($params:ident)}
            $(after $stage:ident)?
            { $($rule:ident: [$($($row:ident).+),*] $(and all of [$($set:ident),+])?),* }
    )+) => {
        /// The planner that lends a rule.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Donor { $( #[doc = $name] $donor, )+ }

        impl ParamChoice for Donor {
            const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[ $( (Self::$donor, $module::$entry.id, $name), )+ ];
        }

        impl Donor {
            /// Its planner's id.
            pub const fn id(self) -> &'static str {
                match self { $( Self::$donor => $module::$entry.id, )+ }
            }

            /// Whether its η changes with time as ln η = a + b·w(t).
            pub(super) const fn is_timed(self) -> bool {
                match self { $( Self::$donor => <$module::$variant as Variant>::TIMED, )+ }
            }

            /// Whether its ants change trails while they walk.
            pub(super) const fn updates_on_moves(self) -> bool {
                match self { $( Self::$donor => <$module::$variant as Variant>::LOCK_STEP, )+ }
            }

            /// The planner that runs before its colony and seeds the trails, of hybrids.
            pub(super) fn stage_before(
                self,
                scenario: &Arc<Scenario>,
                values: &Values,
                seed: u32,
            ) -> Result<Option<Box<dyn Planner>>, ParamError> {
                match self {
                    $( $( Self::$donor => $module::$stage(scenario, &pick::<$module::$params>(values)?, seed).map(Some), )? )+
                    _ => Ok(None),
                }
            }
        }

        /// One variant of each planner, made from the same numbers; each by its donor's name.
        #[derive(Debug, Clone)]
        #[expect(non_snake_case, reason = "a field is found by the name of its donor")]
        pub(super) struct Donors { $( pub(super) $donor: $module::$variant, )+ }

        impl Donors {
            pub(super) fn pick(values: &Values) -> Result<Self, ParamError> {
                Ok(Self { $( $donor: variant($module::$variant::$new, values)?, )+ })
            }

            /// The rows of all donors, in their order.
            pub(super) fn specs() -> Vec<ParamSpec> {
                [$( <$module::$params as Params>::specs(), )+].concat()
            }

            /// Which of their rows only one rule needs.
            pub(super) fn needs() -> Vec<Needs> {
                vec![ $( $( {
                    let _: fn(&CustomParams) -> Donor = |rules| rules.$rule;
                    let own: &[&'static str] = &[$( key(|p: &$module::$params| p.$($row).+, stringify!($($row).+)), )*];
                    let sets: &[Vec<&'static str>] = &[$($( keys(|p: &$module::$params| &p.$set), )+)?];
                    Needs { rule: stringify!($rule), donor: Donor::$donor, keys: [own, &sets.concat()].concat() }
                }, )* )+ ]
            }
        }

        /// Calls a hook of the donor that a rule names.
        macro_rules! lent {
            ($d custom:ident, $d rule:ident, $d hook:ident($d($d arg:expr),*)) => {
                match $d custom.rules.$d rule {
                    $( Donor::$donor => $d custom.donors.$donor.$d hook($d($d arg),*), )+
                }
            };
        }

        /// Calls a hook of every donor.
        macro_rules! all {
            ($d donors:expr, $d hook:ident($d($d arg:expr),*)) => {
                $( $d donors.$donor.$d hook($d($d arg),*); )+
            };
        }
    };
}

donors! { $
    /// Ant System
    AntSystem: ant_system::{ENTRY, AntSystem::new(AntSystemParams)}
        { heuristic_of: [sight.heuristic] }
    /// Elitist Ant System
    Elitist: elitist_ant_system::{ENTRY, ElitistAntSystem::new(ElitistAntSystemParams)}
        { heuristic_of: [sight.heuristic] }
    /// rank-based Ant System
    RankBased: rank_based_ant_system::{ENTRY, RankBasedAntSystem::new(RankBasedAntSystemParams)}
        { heuristic_of: [sight.heuristic], update_of: [ranking, best_so_far] }
    /// MAX–MIN Ant System
    MaxMin: max_min_ant_system::{ENTRY, MaxMinAntSystem::new(MaxMinAntSystemParams)}
        { heuristic_of: [sight.heuristic], update_of: [rules.limits, rules.p_best, rules.best_every], daemon_of: [rules.restart_after] }
    /// Ant Colony System
    AntColonySystem: ant_colony_system::{ENTRY, AntColonySystem::new(AntColonySystemParams)}
        { heuristic_of: [sight.heuristic], selection_of: [rules.q0], local_update_of: [rules.xi] }
    /// Best-Worst Ant System
    BestWorst: best_worst_ant_system::{ENTRY, BestWorstAntSystem::new(BestWorstAntSystemParams)}
        { heuristic_of: [sight.heuristic], update_of: [worst_evaporates],
          daemon_of: [mutation_probability, mutation_strength, restart_below] }
    /// multi-fire ACO (Zhang et al. 2020)
    Fire: fire::{ENTRY, Fire::new(FireParams)}
        { selection_of: [legs], update_of: [criterion, deposit_by] and all of [sum] }
    /// engine-room ACO (Fan et al. 2026)
    Ship: ship::{ENTRY, Ship::new(ShipParams)}
        { heuristic_of: [direction, growing_pull, goal_pull, omega_min, omega_max, obstacle_push],
          update_of: [rho_part, evaporation, rho_shrink, rho_min, update, shifting_weights, weaken_worst, count_ants, k_best, k_worst,
                      trail_min],
          refinement_of: [refinement] }
    /// ACOST (Lai and Guo 2014)
    Acost: threshold::{ACOST, Acost::new(AcostParams)}
        { heuristic_of: [common.goal_step, common.goal_distance], selection_of: [rule], local_update_of: [move_deposit], update_of: [common.path_deposit] }
    /// ACOMSP (as given by Lai and Guo 2014)
    Acomsp: threshold::{ACOMSP, Acomsp::new(AcomspParams)}
        { heuristic_of: [common.goal_step, common.goal_distance], selection_of: [maximal], update_of: [common.path_deposit] }
    /// fireworks, then ants (Zhou, Mu, Zhang 2019)
    FwaAco: fireworks::{FWA_ACO, Seeded::by_fireworks(FwaAcoParams)} after fireworks_first
        { heuristic_of: [colony.sight.heuristic], update_of: [colony.depositors],
          initial_trail_of: [seed_iterations, colony.seed_ants] and all of [fireworks, annealing, decoding] }
    /// particles, then ants (named by Zhou, Mu, Zhang 2019)
    PsoAco: fireworks::{PSO_ACO, Seeded::by_particles(PsoAcoParams)} after particles_first
        { heuristic_of: [colony.sight.heuristic], update_of: [colony.depositors],
          initial_trail_of: [seed_iterations, colony.seed_ants] and all of [particles, decoding] }
}

pub(super) use {all, lent};
