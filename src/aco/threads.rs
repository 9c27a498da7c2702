//! The ants of one iteration on several threads, where none of them changes what another sees: with the very same walks.
//!
//! An ant's walk depends on its own stream and on tables that stay as they are. Where an ant comes to a cell whose weights nobody has learnt
//! yet, it waits there: learning changes the tables, and is left to the one thread that goes on after the others.

use std::num::NonZero;
use std::thread::{self, Builder};

use super::ant::Ant;

/// Has every part of the ants walk on a thread of its own. `walk` takes them as far as they come.
pub(super) fn each_part(ants: &mut [Ant], threads: NonZero<usize>, walk: impl Fn(&mut [Ant]) + Sync) {
    let share = ants.len().div_ceil(threads.get());
    if let Some((own, others)) = ants.split_at_mut_checked(share) {
        thread::scope(|scope| {
            for part in others.chunks_mut(share) {
                // Ants for which there is no thread walk with those that wait.
                let _ = Builder::new().spawn_scoped(scope, || walk(part));
            }
            walk(own);
        });
    }
    ants.iter_mut().for_each(Ant::go_on);
}
