//! Who lends rules: one variant of every planner, made from the same numbers.

use crate::aco::classics::ant_colony_system::{AntColonySystem, AntColonySystemParams};
use crate::aco::classics::ant_system::{AntSystem, AntSystemParams};
use crate::aco::classics::elitist_ant_system::{ElitistAntSystem, ElitistAntSystemParams};
use crate::aco::classics::max_min_ant_system::{MaxMinAntSystem, MaxMinAntSystemParams};
use crate::aco::classics::rank_based_ant_system::{RankBasedAntSystem, RankBasedAntSystemParams};
use crate::aco::papers::fire::{Fire, FireParams};
use crate::aco::papers::fireworks::{ColonyRows, FwaAcoParams, PsoAcoParams, Seeded};
use crate::aco::papers::ship::{Ship, ShipParams};
use crate::aco::papers::threshold::{Acomsp, AcomspParams, Acost, AcostParams};
use crate::error::ParamError;
use crate::param_choice;
use crate::params::{ParamChoice, ParamSpec, Params, Values};

param_choice! {
    /// The planner that lends a rule.
    pub enum Donor {
        /// Ant System
        AntSystem = "ant-system",
        /// Elitist Ant System
        Elitist = "elitist-ant-system",
        /// rank-based Ant System
        RankBased = "rank-based-ant-system",
        /// MAX–MIN Ant System
        MaxMin = "max-min-ant-system",
        /// Ant Colony System
        AntColonySystem = "ant-colony-system",
        /// multi-fire ACO (Zhang et al. 2020)
        Fire = "fire",
        /// engine-room ACO (Fan et al. 2026)
        Ship = "ship",
        /// ACOST (Lai and Guo 2014)
        Acost = "acost",
        /// ACOMSP (as given by Lai and Guo 2014)
        Acomsp = "acomsp",
        /// fireworks, then ants (Zhou, Mu, Zhang 2019)
        FwaAco = "fwa-aco",
        /// particles, then ants (named by Zhou, Mu, Zhang 2019)
        PsoAco = "pso-aco",
    }
}

/// One variant of each planner, made from the same numbers.
#[derive(Debug, Clone)]
pub(super) struct Donors {
    pub(super) ant_system: AntSystem,
    pub(super) elitist: ElitistAntSystem,
    pub(super) rank_based: RankBasedAntSystem,
    pub(super) max_min: MaxMinAntSystem,
    pub(super) ant_colony_system: AntColonySystem,
    pub(super) fire: Fire,
    pub(super) ship: Ship,
    pub(super) acost: Acost,
    pub(super) acomsp: Acomsp,
    pub(super) seeded: Seeded,
}

/// Reads a donor's parameters; keys of others are not its business.
pub(super) fn pick<P: Params>(values: &Values) -> Result<P, ParamError> {
    P::pick(values, P::default())
}

impl Donors {
    pub(super) fn pick(values: &Values) -> Result<Self, ParamError> {
        Ok(Self {
            ant_system: AntSystem::new(pick::<AntSystemParams>(values)?),
            elitist: ElitistAntSystem::new(pick::<ElitistAntSystemParams>(values)?),
            rank_based: RankBasedAntSystem::new(pick::<RankBasedAntSystemParams>(values)?),
            max_min: MaxMinAntSystem::new(pick::<MaxMinAntSystemParams>(values)?),
            ant_colony_system: AntColonySystem::new(pick::<AntColonySystemParams>(values)?),
            fire: Fire::new(pick::<FireParams>(values)?),
            ship: Ship::new(pick::<ShipParams>(values)?),
            acost: Acost::new(pick::<AcostParams>(values)?),
            acomsp: Acomsp::new(pick::<AcomspParams>(values)?),
            seeded: Seeded::new(pick::<ColonyRows>(values)?, None),
        })
    }

    /// The rows of all donors, in the order of [`Donor`].
    pub(super) fn specs() -> Vec<ParamSpec> {
        [
            AntSystemParams::specs(),
            ElitistAntSystemParams::specs(),
            RankBasedAntSystemParams::specs(),
            MaxMinAntSystemParams::specs(),
            AntColonySystemParams::specs(),
            FireParams::specs(),
            ShipParams::specs(),
            AcostParams::specs(),
            AcomspParams::specs(),
            FwaAcoParams::specs(),
            PsoAcoParams::specs(),
        ]
        .concat()
    }
}

/// Calls a hook of the donor that a rule names.
macro_rules! lent {
    ($custom:ident, $rule:ident, $hook:ident($($arg:expr),*)) => {
        match $custom.rules.$rule {
            Donor::AntSystem => $custom.donors.ant_system.$hook($($arg),*),
            Donor::Elitist => $custom.donors.elitist.$hook($($arg),*),
            Donor::RankBased => $custom.donors.rank_based.$hook($($arg),*),
            Donor::MaxMin => $custom.donors.max_min.$hook($($arg),*),
            Donor::AntColonySystem => $custom.donors.ant_colony_system.$hook($($arg),*),
            Donor::Fire => $custom.donors.fire.$hook($($arg),*),
            Donor::Ship => $custom.donors.ship.$hook($($arg),*),
            Donor::Acost => $custom.donors.acost.$hook($($arg),*),
            Donor::Acomsp => $custom.donors.acomsp.$hook($($arg),*),
            Donor::FwaAco | Donor::PsoAco => $custom.donors.seeded.$hook($($arg),*),
        }
    };
}

/// Calls a hook of every donor.
macro_rules! all {
    ($custom:ident, $hook:ident($($arg:expr),*)) => {{
        let donors = &mut $custom.donors;
        donors.ant_system.$hook($($arg),*);
        donors.elitist.$hook($($arg),*);
        donors.rank_based.$hook($($arg),*);
        donors.max_min.$hook($($arg),*);
        donors.ant_colony_system.$hook($($arg),*);
        donors.fire.$hook($($arg),*);
        donors.ship.$hook($($arg),*);
        donors.acost.$hook($($arg),*);
        donors.acomsp.$hook($($arg),*);
        donors.seeded.$hook($($arg),*);
    }};
}

impl Donor {
    /// Its planner's id.
    pub fn id(self) -> &'static str {
        Self::OPTIONS.iter().find(|o| o.0 == self).map_or("", |o| o.1)
    }

    /// Whether its η changes with time as ln η = a + b·w(t).
    pub(super) fn is_timed(self) -> bool {
        self == Self::Ship
    }

    /// Whether its selection is the random proportional rule.
    pub(super) fn is_proportional(self) -> bool {
        !matches!(self, Self::AntColonySystem | Self::Fire | Self::Acost | Self::Acomsp)
    }

    /// Whether its ants change trails while they walk.
    pub(super) fn updates_on_moves(self) -> bool {
        matches!(self, Self::AntColonySystem | Self::Acost)
    }
}

pub(super) use {all, lent};
