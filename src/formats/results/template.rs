//! An empty table of results, to be filled in elsewhere.

use super::columns::{Column, name};
use crate::comparison::question::Question;

/// The columns of the table: whose run, on which map, by which seed, and what came of it.
const COLUMNS: [Column; 6] = [Column::Entry, Column::Instance, Column::Seed, Column::Length, Column::Turns, Column::Evaluations];

/// A table as [`super::import_results`] reads it, with a line for each map and seed of a question. Its lengths are left open: a line that
/// nobody fills in is a run without a path.
pub fn results_table(question: &Question) -> String {
    let mut table = COLUMNS.map(name).join(",") + "\n";
    for instance in &question.instances {
        for seed in question.seeds.iter() {
            table += &format!("my planner,{},{seed},,,\n", instance.id);
        }
    }
    table
}
