//! Swarms over cell priorities: a position is one real number for each free cell, and decodes into a path (Zhou, Mu, Zhang 2019, Eq. 1).
//! By slices a position is a row and a level for each column between the ends. Swarms know no ants; hybrids in [`crate::aco`] use them.
//!
//! [`search::Swarm`] is the one skeleton: decode what a [`search::Method`] proposes, until its iteration is complete. The parts:
//!
//! | component | file |
//! |---|---|
//! | from priorities to a path | `decode.rs` |
//! | positions and what they decode to | `population.rs` |
//! | the skeleton and its planner | `search.rs` |
//! | fireworks, `fwa` and `ifwa` | `fireworks.rs` |
//! | their formulas (Eq. 2–9) | `explosion.rs` |
//! | particles, the seeder of `pso-aco` | `particle_swarm.rs` |
//! | particles as a planner of their own, `pso` | `pso.rs` |
//! | generations, `ga` | `genetic.rs` |
//! | from rows and levels to a path by slices | `slices.rs` |
//!
//! A move is one decoded path. `constructed_paths` counts decoded paths; `ant_moves` counts what a decoding walks, steps and steps back.

pub mod decode;
pub mod explosion;
pub mod fireworks;
pub mod genetic;
pub mod particle_swarm;
pub mod population;
pub mod pso;
pub mod search;
pub mod slices;
