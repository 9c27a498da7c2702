//! A particle swarm as a planner of its own: what the terrain paper (`docs/papers/terrain.md`) compares with, 粒子群算法.
//!
//! The paper names it and gives its length and its iterations, and leaves out everything else: the encoding, the velocity, every
//! parameter. **Our choice:** the particle swarm with inertia weight of Shi and Eberhart (`particle_swarm.rs`). By slices a particle is one
//! row and one level for each column between the ends (`slices.rs`); from cell to cell it is one priority for each free cell, as in the
//! seeder of `pso-aco`, whose first stage is a run of this planner (`decode.rs`).
//!
//! | ground | position | path | particle without a path |
//! |---|---|---|---|
//! | plane, surface, 16 moves | a priority a cell, x_min to x_max | `decode.rs`: of the allowed steps the one with the largest a_j·L(j, e) | longer than any path |
//! | slices | (row, level) a column | `slices.rs`: clamped to the limits, rounded, lifted out of the ground | lost: cost ∞ |
//!
//! By slices v_max is a share of the rows and of the levels there are; the rows of decoding have no effect. A lost particle counts as
//! a constructed path that did not arrive, and keeps what it remembers.
//!
//! Preset `constriction`: Clerc, Kennedy, "The particle swarm: explosion, stability, and convergence in a multidimensional complex space",
//! IEEE Transactions on Evolutionary Computation 6 (2002) 58–73, doi:10.1109/4235.985692: χ = 2 / |2 − φ − √(φ² − 4φ)| is 0.72984 for
//! φ = c1 + c2 = 4.1; written as inertia, w = χ and c1 = c2 = 2.05·χ = 1.49618.

use std::sync::Arc;

use crate::error::ParamError;
use crate::params;
use crate::params::{Params, Values};
use crate::planner::{Family, Ground, Layer, Planner, PlannerEntry, Preset};
use crate::scenario::Scenario;

use super::decode::{DecodeRows, Limits};
use super::particle_swarm::{ParticleRows, ParticleSwarm};
use super::search::{Method, Swarm, check_memory};
use super::slices::SliceDecoder;

params! {
    /// Parameters of the particle swarm.
    pub struct PsoParams {
        /// iterations after which the swarm stops
        iterations: u32 = 50, "", [1..=100_000], "iterations", "our choice: as many as the fireworks have";
        ..particles: ParticleRows;
        ..decoding: DecodeRows;
        /// stops after this many iterations without a shorter path; 0 = never
        stagnation: u32 = 0, "", [0..=100_000], "iterations", "our addition";
    }
}

/// Whose random streams it draws from; older than the planner's id, so that the first stage of `pso-aco` is its run.
const STREAMS: &str = "priority-particles";

/// The swarm over cell priorities.
///
/// # Errors
/// [`ParamError::Memory`] where the positions would not fit.
pub fn over_cells(
    scenario: &Arc<Scenario>,
    (particles, decoding): (ParticleRows, DecodeRows),
    iterations: u32,
    stagnation: u32,
    seed: u32,
) -> Result<Swarm<ParticleSwarm>, ParamError> {
    let method = ParticleSwarm::new(particles, decoding, iterations, stagnation);
    check_memory(scenario, "particles", particles.particles, method.settings().most)?;
    Ok(Swarm::new(Arc::clone(scenario), method, STREAMS, seed))
}

fn build(scenario: &Arc<Scenario>, values: &Values, seed: u32) -> Result<Box<dyn Planner>, ParamError> {
    let p = PsoParams::read(ENTRY.id, values)?;
    let Some(slices) = &scenario.slices else {
        return Ok(Box::new(over_cells(scenario, (p.particles, p.decoding), p.iterations, p.stagnation, seed)?));
    };
    let limits = SliceDecoder::ranges(slices, scenario).map(Limits::up_to);
    let method = ParticleSwarm::within(limits, p.particles, p.iterations, p.stagnation);
    Ok(Box::new(Swarm::<_, SliceDecoder>::new(Arc::clone(scenario), method, STREAMS, seed)))
}

/// The particle swarm in the catalog.
pub const ENTRY: PlannerEntry = PlannerEntry {
    id: "pso",
    name: "Particle swarm",
    family: Family::Swarm,
    summary: "Particles fly towards their own best position and the swarm's; a position is a row and a level for each slice, or a priority for each cell.",
    source: "Shi, Eberhart 1998, ICEC, 69–73, doi:10.1109/ICEC.1998.699146; 1999, CEC, 1945–1950, doi:10.1109/CEC.1999.785511; named in the terrain paper as what it compares with",
    presets: &[
        Preset {
            name: "terrain",
            source: "terrain paper, Table 1",
            meaning: "50 particles and 100 iterations, the colony's numbers: our reading, the table names no particle; the rest stays",
            numbers: &[("particles", 50.0), ("iterations", 100.0)],
            choices: &[],
            reading: None,
        },
        Preset {
            name: "constriction",
            source: "Clerc, Kennedy 2002, IEEE Trans. Evolutionary Computation 6, 58–73, doi:10.1109/4235.985692",
            meaning: "the weights of the constricted swarm for φ = 4.1: w = 0.72984, c1 = c2 = 1.49618",
            numbers: &[("inertia_start", 0.729_84), ("inertia_end", 0.729_84), ("cognitive", 1.496_18), ("social", 1.496_18)],
            choices: &[],
            reading: None,
        },
    ],
    components: &[],
    layers: &[Layer::Priority, Layer::Visits],
    max_goals: 1,
    grounds: Ground::UNWEIGHTED,
    specs: PsoParams::specs,
    build,
};
