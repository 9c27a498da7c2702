//! A run of a table on its way in: its lines become its improvements and its effort.

use super::columns::{Column, Columns};
use super::ended;
use crate::comparison::Spent;
use crate::comparison::imported::ImportedRun;
use crate::planner::Status;

/// A run of which not all lines may have been read.
pub(super) struct Run {
    /// As far as it is known.
    pub run: ImportedRun,
    /// How it ended, if a line says so.
    pub status: Option<Status>,
    /// What the last line says of its effort.
    pub last: Spent,
    /// Iteration of best and paths to best, from columns of their own.
    pub to_best: [Option<u64>; 2],
    /// Iterations and evaluations of its first line, from columns of these names.
    pub counted: [Option<u64>; 2],
}

impl Run {
    /// A run of one line: what it says of moves and expansions is of the whole run, and so are `iterations` and `evaluations` where the
    /// effort up to the best path has columns of its own, or where there is no path.
    pub fn of_one_line(self, columns: &Columns) -> ImportedRun {
        let Self { mut run, status, last, to_best: [best_iteration, best_paths], counted: [iterations, evaluations] } = self;
        let (own_iterations, own_paths) = (columns.has(Column::IterationOfBest), columns.has(Column::PathsToBest));
        let no_path = run.steps.is_empty();
        run.effort = Spent {
            iterations: iterations.filter(|_| own_iterations || no_path),
            constructed_paths: evaluations.filter(|_| own_paths || no_path),
            ..last
        };
        for step in &mut run.steps {
            step.spent = Spent {
                iterations: if own_iterations { best_iteration } else { iterations },
                constructed_paths: if own_paths { best_paths } else { evaluations },
                ..Spent::default()
            };
        }
        run.status = status.unwrap_or_else(|| ended(&run.steps));
        run
    }

    /// A run of one line an improvement: the last line tells what was spent when it ended.
    pub fn of_improvements(self) -> ImportedRun {
        let Self { run, status, last, .. } = self;
        ImportedRun { effort: last, status: status.unwrap_or_else(|| ended(&run.steps)), ..run }
    }
}

/// The first count that is smaller than it was before, by its column's usual name.
pub(super) fn goes_back(before: Spent, now: Spent) -> Option<(&'static str, u64)> {
    const COLUMNS: [&str; 4] = ["iterations", "evaluations", "ant_moves", "cell_expansions"];
    let [before, now]: [[Option<u64>; 4]; 2] = [before.into(), now.into()];
    let less = |&at: &usize| now[at].zip(before[at]).is_some_and(|(now, before)| now < before);
    (0..4).find(less).map(|at| (COLUMNS[at], now[at].unwrap_or(0)))
}
