//! Comparisons: a committed question is run, measured and judged the same way everywhere.
//!
//! A [`Question`] asks what a publication claims: which entries (planner, preset, values), on which instances (maps), over which seeds.
//! An [`Comparison`] is a question with its maps; each of its [`Task`]s is one run and gives one [`Row`], whether or not a path was
//! found, and tells each improvement on the way. [`document`] is all of it in one file. [`claims`] compares rows by [`statistics`] and gives a verdict by the rule of docs/methodology.md; [`ablation`] asks and tells what
//! each component of a planner does; [`report`] prints.
//!
//! No clock, no threads, no files: who calls decides where the tasks run, so that the browser can do it too.

pub mod ablation;
pub mod analysis;
pub mod check;
pub mod claims;
pub mod document;
pub mod given;
pub mod inference;
pub mod question;
pub mod report;
mod row;
mod run;
mod setting;
pub mod statistics;
mod verify;

pub use ablation::{Ablated, Effect, Finding, effects};
pub use analysis::{Analysis, Intervals, Samples, Seen, analyse};
pub use check::QuestionError;
pub use claims::{JudgedClaim, Verdict};
pub use document::Opened;
pub use question::{Axis, Budget, Claim, Direction, Entry, Instance, Measure, Published, Question, Role, Seeds, Statistic};
pub use row::{Found, Improvement, Row, Spent, Task};
pub use run::{Clock, Timed};
pub use setting::{Comparison, Map, Yardstick};
pub use verify::{Deviation, Record, Recorded, Runs, Verification};
