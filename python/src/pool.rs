//! Runs on all cores.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;

use formicarium::comparison::{Comparison, Row, Task, Timed};
use formicarium::error::QuestionError;
use pyo3::prelude::*;

use super::errors::Refusal;
use super::patience::GLANCE;

/// A run that has come to its end, by the place of its task.
type Ended = (usize, Result<Timed, QuestionError>);

/// Does every task of a comparison, in the order of the tasks. `progress` is called on the calling thread with the number of runs that are
/// done, and with that of all.
///
/// # Errors
/// What a run refuses, what `progress` raises, and `KeyboardInterrupt`: runs that have begun end first.
pub fn run_all(py: Python<'_>, comparison: &Comparison, jobs: usize, progress: Option<&Py<PyAny>>) -> PyResult<Vec<Row>> {
    let tasks = comparison.tasks();
    let (next, is_over) = (AtomicUsize::new(0), AtomicBool::new(false));
    py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel();
            for _ in 0..jobs.min(tasks.len()) {
                let (sender, tasks, next, is_over) = (sender.clone(), &tasks, &next, &is_over);
                scope.spawn(move || {
                    let take = || tasks.get(next.fetch_add(1, Ordering::Relaxed)).filter(|_| !is_over.load(Ordering::Relaxed));
                    let run = |task: Task| (place(tasks, task), comparison.run(task, &mut || 0.0));
                    while take().is_some_and(|&task| sender.send(run(task)).is_ok()) {}
                });
            }
            drop(sender);
            let gathered = gather(&receiver, tasks.len(), progress);
            is_over.store(true, Ordering::Relaxed);
            gathered
        })
    })
}

/// The place of a task among all.
fn place(tasks: &[Task], task: Task) -> usize {
    tasks.binary_search(&task).expect("tasks are in their own order")
}

/// Takes the runs as they end.
fn gather(ended: &Receiver<Ended>, of: usize, progress: Option<&Py<PyAny>>) -> PyResult<Vec<Row>> {
    let (mut rows, mut done): (Vec<Option<Row>>, usize) = (vec![None; of], 0);
    loop {
        match ended.recv_timeout(GLANCE) {
            Ok((place, run)) => {
                rows[place] = Some(run.map_err(Refusal::from)?.row);
                done += 1;
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return Ok(rows.into_iter().flatten().collect()),
        }
        Python::attach(|py| {
            py.check_signals()?;
            progress.map_or(Ok(()), |progress| progress.call1(py, (done, of)).map(drop))
        })?;
    }
}
