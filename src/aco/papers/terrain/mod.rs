//! Elitist potential-field ACO in three dimensions: 基于改进精英势场蚁群算法的机器人三维路径规划算法研究 (Robot 3D Path Planning Algorithm Based on
//! Improved Elitist Potential Field Ant Colony Algorithm), Hans Publishers, article 41567, in Chinese with an English abstract. The copy
//! that we read names no author, journal or DOI.
//!
//! | override point | `terrain-aco` (sections 2 and 5) | `terrain-epf` (section 4) |
//! |---|---|---|
//! | initial trail | τ0 | Eq. 14: τ0·F'_tot (`initial`) |
//! | heuristic | Eq. 2 | second "Eq. 12": a^(F_tot·cos φ)·Eq. 2 (`force`), weaker and weaker (`force_fades`) |
//! | selection | Eq. 1, with q0 of Table 1 | as `terrain-aco` |
//! | on each move | local evaporation of Table 1 by Eq. 3, or Ant Colony System's rule (`local_rule`) | as `terrain-aco` |
//! | update | Eq. 3 and 4 | and Eq. 10 and 11: the best 5 % deposit once more (`elite`) |
//! | construction | from the start | from both ends, joined where two ants meet (`two_colonies`) |
//!
//! Each addition has a parameter that turns it off ([`COMPONENTS`]); with all of them off `terrain-epf` is `terrain-aco`, bit for bit. But
//! for the 16 directions of section 4.4: how one moves belongs to the scenario, and whoever plans there has them; `directions` leaves both
//! with 8. Both go over places ([`space::Space`]): the cells of a plane or a surface, with as many moves as the scenario has, or the places of slices. Trails lie on
//! places, not on steps, as in Eq. 14.
//!
//! `reading` decides where the print does not do what its text says:
//!
//! | Eq. | `printed` | `repaired` |
//! |---|---|---|
//! | 6 | k·d, the farther the stronger | 2k·d0/(d0 + d): "the nearer the goal, the stronger" |
//! | 12, 13 | ρ ≤ ρ0 *or* z > z0: low places near the ground attract, high ones far from it too | ρ ≤ ρ0 *and* z > z0: "below the base height 0" |
//! | second 12 | ((T − t)/T)³ is a factor of η, common to all steps: it cancels in Eq. 1 | it weighs the exponent: "strong early, weak late" |
//!
//! Where the print does not decide: η is 1/d(j, E), as the words before Eq. 1 have it; `heuristic=step` is 1/L_ij, as Eq. 2 has it. Eq. 3 is
//! called a local update, but Δτ of Eq. 4 needs the whole path: a step evaporates by the local λ, the end of the iteration evaporates by
//! the global one and adds Δτ. `local_rule=acs` reads the words before it otherwise, "mainly increase and evaporation of trails" after each
//! step, with a rate of its own in Table 1: that is the local rule of Ant Colony System (Dorigo, Gambardella 1997, IEEE Trans. Evolutionary
//! Computation 1, 53–66, eq. 5), whose name the paper gives its basic ACO. F_tot is a scalar in Eq. 14, the pull less the push as in Eq. 9, and a vector in η: the pull to the goal, the
//! push straight down, for heights push and nothing says whereto.
//!
//! Where the paper is silent, we: let a level of slices count as one cell in the distances of η (`level_height`) and in the field (`field_level_height`); give the baseline Table 1 too, which is headed EPF-ACO; count 50 ants in both teams together; take ρ for
//! the height above the ground, at least 1, and 1 on a surface; measure distances for k in parts of the distance from start to goal and
//! heights for θ in parts of the highest place's, so that k = θ = 1 and a = e do on any map; keep Eq. 14 at or above 1 % of τ0; mirror all
//! of it for the backward team (its goal is the start, its base height the goal's); let an ant meet the first ant of the other team that
//! still walks and has the place on its list, without what it took back; let both deposit on the whole path, each on its own team's trails;
//! round 5 % of a team down, to at least one ant; let ants at a dead end step back (`dead_end`), by slices also those that can no longer
//! reach the end.

pub mod field;
pub mod params;
pub mod sight;
pub mod space;
pub mod trails;
pub mod walk;

mod colony;
mod moves;
mod team;
mod view;

use std::sync::Arc;

use colony::FieldColony;
use params::{BasicParams, EpfParams};
use space::{Layered, Surface};

use crate::error::ParamError;
use crate::params::{Params, Values};
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry, Preset};
use crate::scenario::Scenario;

/// The colony in the scenario's space.
fn colony(scenario: &Arc<Scenario>, params: EpfParams, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let BasicParams { directions, level_height, .. } = params.common;
    Ok(match &scenario.slices {
        None => {
            let space = Surface::new(Arc::clone(scenario)).only(directions);
            Box::new(FieldColony::new(space, scenario, params, seed)?)
        }
        Some(slices) => {
            let space = Layered::new(Arc::clone(scenario), Arc::clone(slices))
                .seen_as(directions, level_height)
                .field_by(params.field_level_height);
            Box::new(FieldColony::new(space, scenario, params, seed)?)
        }
    })
}

fn build_basic(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    colony(scenario, EpfParams::basic(BasicParams::read(ACO.id, values)?), seed)
}

fn build_epf(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    colony(scenario, EpfParams::read(EPF.id, values)?, seed)
}

const SOURCE: &str = "elitist potential-field ACO in three dimensions (Hans Publishers, article 41567)";

/// Table 1, as far as both planners have it.
const TABLE_1: &[(&str, f64)] =
    &[("ants", 50.0), ("iterations", 100.0), ("alpha", 1.0), ("beta", 7.0), ("q0", 0.8), ("local_rho", 0.1), ("rho", 0.2)];

/// Table 1's three rates as those of Ant Colony System.
const SECOND_READING: Preset = Preset {
    name: "second-reading",
    source: "the paper's words before eq. 3 and table 1; Dorigo, Gambardella 1997",
    meaning: "trails grow and evaporate at each step, by Ant Colony System's local rule with τ0 = 0.01; else as we read it",
    numbers: &[("initial_trail", 0.01)],
    choices: &[("local_rule", "acs")],
    reading: Some(PaperReading::SecondReading),
};

/// The paper's basic ACO in the catalog.
pub const ACO: PlannerEntry = PlannerEntry {
    id: "terrain-aco",
    name: "Terrain ACO",
    family: Family::AntColony,
    summary: "The terrain paper's basic colony, on surfaces and by slices: trails lie on places, ants mostly take the best step, and trails evaporate where they come by.",
    source: SOURCE,
    presets: &[
        Preset {
            name: "paper",
            source: SOURCE,
            meaning: "its table 1, which is headed EPF-ACO, and η = 1/distance to the goal, as its text has it",
            numbers: TABLE_1,
            choices: &[("heuristic", "goal")],
            reading: Some(PaperReading::AsRead),
        },
        Preset {
            name: "printed",
            source: SOURCE,
            meaning: "eq. 1–4 and nothing else: η = 1/step length, every step by its probability, evaporation at the end of the iteration alone",
            numbers: &[("q0", 0.0), ("local_rho", 0.0)],
            choices: &[("heuristic", "step")],
            reading: Some(PaperReading::Printed),
        },
        SECOND_READING,
    ],
    components: &[],
    layers: &[Layer::Trail, Layer::InitialTrail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::UNWEIGHTED,
    specs: BasicParams::specs,
    build: build_basic,
};

/// What the paper adds, in the order of its section 4.
pub const COMPONENTS: &[Component] = &[
    Component {
        id: "elite",
        name: "elite",
        adds: "the best 5 % of the ants deposit once more, by (it/it_max)³ (eq. 10–11); without: every ant once (eq. 3–4)",
        without: &[("elite", "0")],
    },
    Component {
        id: "two-colonies",
        name: "two colonies",
        adds: "half of the ants set out from the goal, and two that meet join their ways (section 4.2); without: all from the start",
        without: &[("two_colonies", "false")],
    },
    Component {
        id: "field-trails",
        name: "first trails by the field",
        adds: "the potential field makes the first trails (eq. 12–14); without: τ0 everywhere",
        without: &[("initial", "uniform")],
    },
    Component {
        id: "force",
        name: "force of the field",
        adds: "the force of the field bends the heuristic (section 4.5, the second eq. 12); without: the distance alone (eq. 2)",
        without: &[("force", "false")],
    },
    Component {
        id: "fading-force",
        name: "fading force",
        adds: "the force weighs ((it_max − it)/it_max)³, less and less (section 4.5, the second eq. 12); without: its full weight all the time",
        without: &[("force_fades", "false")],
    },
];

/// The paper's own method in the catalog.
pub const EPF: PlannerEntry = PlannerEntry {
    id: "terrain-epf",
    name: "Elitist potential-field ACO",
    family: Family::AntColony,
    summary: "Two teams set out from both ends and join where they meet; a potential field makes the first trails and bends the heuristic, and the best ants deposit more and more.",
    source: SOURCE,
    presets: &[
        Preset {
            name: "paper",
            source: SOURCE,
            meaning: "its method with its table 1, repaired where the print does not do what its text says",
            numbers: TABLE_1,
            choices: &[("reading", "repaired"), ("heuristic", "goal")],
            reading: Some(PaperReading::AsRead),
        },
        Preset {
            name: "printed",
            source: SOURCE,
            meaning: "everything literally: the pull grows with the distance, \"or\" in eq. 13, no time in the exponent, η = 1/step length",
            numbers: &[],
            choices: &[("reading", "printed"), ("heuristic", "step")],
            reading: Some(PaperReading::Printed),
        },
        SECOND_READING,
    ],
    components: COMPONENTS,
    layers: &[Layer::Trail, Layer::InitialTrail, Layer::Visits, Layer::Heuristic],
    max_goals: 1,
    grounds: Ground::UNWEIGHTED,
    specs: EpfParams::specs,
    build: build_epf,
};
