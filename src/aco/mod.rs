//! The ant-colony metaheuristic (Dorigo and Stützle 2004, ch. 3): construct solutions, update trails, daemon actions, repeat.
//!
//! [`colony::Colony`] is the one skeleton; a [`variant::Variant`] overrides what its publication changes. The parts:
//!
//! | component | file |
//! |---|---|
//! | η, what an ant can see | `heuristic.rs` |
//! | τ, evaporation, limits | `trails.rs` |
//! | τ^α·η^β by cell and direction, selection rules | `choice.rs` |
//! | one ant: its way, its tabu list, its random stream | `ant.rs` |
//! | four ants in SIMD lanes, the same walk | `lanes.rs` |
//! | what arrived ants leave behind | `deposit.rs` |
//! | what happens at a dead end | `dead_end.rs` |
//!
//! | variant | initial trail | η | selection | on each move | update | daemon |
//! |---|---|---|---|---|---|---|
//! | `ant-system` | τ0 | goal, step or detour | random proportional | – | evaporate, every arrived ant deposits Q/L | – |

pub mod ant;
pub mod choice;
pub mod colony;
pub mod dead_end;
pub mod deposit;
pub mod heuristic;
mod lanes;
pub mod trails;
pub mod variant;

mod classics;

pub use classics::ant_system;
