//! The ant-colony metaheuristic (Dorigo and Stützle 2004, ch. 3): construct solutions, update trails, daemon actions, repeat.
//!
//! [`colony::Colony`] is the one skeleton; a [`variant::Variant`] overrides what its publication changes. Colonies may use what lies below
//! them, [`crate::exact`] and [`crate::swarm`]: the first stage of a hybrid is any planner. The parts:
//!
//! | component | file |
//! |---|---|
//! | parameter rows that many share | `shared_params.rs` |
//! | η, what an ant can see | `heuristic.rs` |
//! | τ, evaporation, limits | `trails.rs` |
//! | τ^α·η^β by cell and direction; the part of it that η has | `weights.rs`, `visibility.rs` |
//! | selection rules | `selection.rs` |
//! | the same where η changes with time, computed where ants come by | `on_demand.rs` |
//! | probabilities of the steps by these rules, shown for a cell | `odds.rs` |
//! | steps by where they lead beside the way to the goal | `orientation.rs` |
//! | one ant: its way, its random stream | `ant.rs` |
//! | its tabu list: where it has been | `tabu.rs` |
//! | eight ants in SIMD lanes, the same walk; parts of all ants on threads | `lanes.rs`, `threads.rs` |
//! | their selection rules and their random streams | `lane_rules.rs`, `draws.rs` |
//! | what arrived ants leave behind | `deposit.rs` |
//! | what makes one finished path better than another | `criterion.rs` |
//! | a colony after another planner, on trails that it seeds | `hybrid.rs` |
//! | what happens at a dead end | `dead_end.rs` |
//! | ants that go several cells at a time, a planner of its own | `papers/tdi_msaco/` |
//! | a search that puts ants' ways together, and proves | `formica/`, over `../exact/within.rs` |
//! | several goals: a colony for their order, then one for each leg | `tour.rs`, `legs.rs` |
//! | orders that a search puts together from ants' tours, and proves | `order_solve.rs`, over `../exact/order/search.rs` |
//! | colonies by slices: the classics, and the textbook's own | `by_slices/` |
//! | the same colony on problems that have no map | `order_run.rs` |
//!
//! | variant | initial trail | η | selection | on each move | update | daemon |
//! |---|---|---|---|---|---|---|
//! | `ant-system` | τ0 | goal, step or detour | random proportional | – | evaporate, every arrived ant deposits Q/L | – |
//! | `elitist-ant-system` | (e + m)·Q/(ρ·L_open) | as Ant System | as Ant System | – | as Ant System, and e·Q/L_bs on the best so far | – |
//! | `rank-based-ant-system` | w·(w − 1)/2·Q/(ρ·L_open) | as Ant System | as Ant System | – | evaporate, (w − r)·Q/L_r by rank, w·Q/L_bs | – |
//! | `max-min-ant-system` | τ_max | as Ant System | as Ant System | – | evaporate, 1/L_ib or 1/L_bs, limits | restart at τ_max |
//! | `ant-colony-system` | 1/(n·L_open) | as Ant System | pseudo-random proportional | blend τ0 in by ξ | blend 1/L_bs in by ρ on the best so far | – |
//! | `best-worst-ant-system` | 1/(n·L_open) | as Ant System | as Ant System | – | evaporate, 1/L_bs on the best so far, the worst path evaporates again | mutate trails, restart at τ0 |
//! | `formica` | 0.5 | exp(−κ·detour), by scent | as Ant System | – | evaporate, ρ on the path that a search makes of all ants' ways, limits | restart; a proof at the end |
//! | `acost` | τ0 | goal | roulette up to a threshold that rises with time; any step if none | + Q1/l | evaporate, Q2/L_min on the iteration's shortest path | – |
//! | `acomsp` | τ0 | goal | the most probable | – | evaporate, Q2/L_min on the iteration's shortest path | – |
//! | `iaaco` | τ0 | step and goal, times an angle to the goal | pseudo-random proportional; q0(t) falls | – | every arrived path blends Q/L in by ρ = κ·L_SG/L_ib, then best and worst | – |
//! | `ihmaco` | by step: d_ST / (d_Si + d_iT), of both cells | goal, times the step's direction and whether it is straight on | pseudo-random proportional; q0(t) dips | – | evaporate by ρ(t), every arrived ant deposits Q/(w1·L + w2·turns) | – |
//! | `maaco` | by cell: d_ST / (d_Si + d_iT) | start and goal, and turns | the three steps nearest to the goal's direction, pseudo-random proportional; q0(t) falls, then grows | – | as Ant System, limits | – |
//! | `tdi-msaco` | 10 diagonals, on cells | goal | in proportion to a sum: any cell in sight up to three away | – | the shortest way to the goal shown by ants | – |
//! | `ship` | as Ant System | goal, direction, obstacle density; ω(t) grows | as Ant System | – | evaporate, best paths deposit, the worst is weakened | refine the best path |
//! | `fire` | τ0 | goal | pseudo-random proportional; the order of several goals alike, η = 1/R | – | as Ant System, or Q/V | – |
//! | `fwa-aco`, `pso-aco` | τ0, and Δτ along the path of fireworks or particles that ran before | goal | as Ant System | – | as Ant System | – |
//! | `terrain-aco` | τ0, on places | goal | pseudo-random proportional | evaporate the place | evaporate, every arrived ant deposits Q/L | – |
//! | `terrain-epf` | by a potential field | goal, times a power of the field's force | as `terrain-aco` | as `terrain-aco`; ants of two teams that meet join | as `terrain-aco`, and more and more by the elite | – |
//! | `terrain-textbook` | τ0, on places | low and short steps | as Ant System | evaporate the place | blend K/C_bs in by ρ on the best so far | – |
//! | `acs-slices`, `mmas-slices` | as the classics, by the cost of the straight way | 1 / cost of the step | as the classics | as the classics | as the classics, by cost | as the classics |
//! | `formica-slices` | 0.5 | exp(−κ·detour), by the straight line | as Ant System | – | evaporate, ρ on the cheapest path so far, limits | restart; a proof at the end |
//! | `custom` | of any of these | of any | of any | of any | of any | of any, and whether the best path is refined |

pub mod ant;
pub mod by_slices;
pub mod colony;
pub mod criterion;
pub mod custom;
pub mod dead_end;
pub mod deposit;
mod draws;
pub mod formica;
pub mod heuristic;
pub mod hybrid;
mod lane_rules;
mod lanes;
pub mod legs;
pub mod odds;
pub mod on_demand;
pub mod order_run;
pub mod order_solve;
pub mod orientation;
pub mod selection;
pub mod shared_params;
mod tabu;
mod threads;
pub mod tour;
pub mod trails;
pub mod variant;
pub mod visibility;
pub mod weights;

mod classics;
mod papers;

pub use classics::*;
pub use papers::*;
