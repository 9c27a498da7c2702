//! Runs a piece of work under watch: panics, memory, time of its thread.

use std::cell::RefCell;
use std::fs;
use std::panic::{self, AssertUnwindSafe};
use std::time::{Duration, Instant};

use crate::allocator::peak_of;
use crate::limits::Limits;

/// What is wrong with an input. Two faults with equal `kind` and `place` are the same.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    pub kind: &'static str,
    /// Where: a line of code, or the promise that is broken.
    pub place: String,
    pub message: String,
}

impl Fault {
    pub fn broken(promise: &str, message: impl Into<String>) -> Self {
        Self { kind: "promise", place: promise.into(), message: message.into() }
    }

    pub fn is_like(&self, other: &Self) -> bool {
        (self.kind, &self.place) == (other.kind, &other.place)
    }
}

thread_local! {
    static PANIC: RefCell<Option<(String, String)>> = const { RefCell::new(None) };
}

/// Panics are kept instead of printed.
pub fn keep_panics() {
    panic::set_hook(Box::new(|info| {
        let place = info.location().map_or_else(String::new, |at| format!("{}:{}", at.file(), at.line()));
        let words = info.payload().downcast_ref::<&str>().map(|words| (*words).to_owned());
        let words = words.or_else(|| info.payload().downcast_ref::<String>().cloned());
        PANIC.set(Some((place, words.unwrap_or_default())));
    }));
}

/// Does the work, which may find a fault by itself. Too slow is what is too slow three times. What an input may cost at most is asked for
/// those alone that go beyond what every input may.
pub fn watch(name: &str, limits: impl Fn() -> Limits, work: impl Fn() -> Result<(), Fault>) -> Result<(), Fault> {
    let every = Limits::text(0);
    let start = Instant::now();
    let (result, peak) = peak_of(|| caught(&work));
    result?;
    let took = start.elapsed();
    if peak <= every.bytes && took <= every.time {
        return Ok(());
    }
    let limits = limits();
    if peak > limits.bytes {
        let message = format!("{peak} bytes in use, at most {} allowed", limits.bytes);
        return Err(Fault { kind: "memory", place: name.into(), message });
    }
    if took <= limits.time {
        return Ok(());
    }
    let took = (0..3).map(|_| time_of(|| caught(&work))).min().unwrap_or(took);
    if took <= limits.time {
        return Ok(());
    }
    let message = format!("{took:?}, at most {:?} allowed", limits.time);
    Err(Fault { kind: "time", place: name.into(), message })
}

fn caught(work: &impl Fn() -> Result<(), Fault>) -> Result<(), Fault> {
    panic::catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
        let (place, message) = PANIC.take().unwrap_or_default();
        Err(Fault { kind: "panic", place, message })
    })
}

/// Time on a processor where the system tells it, so that a busy machine is no fault of ours.
fn time_of<T>(work: impl FnOnce() -> T) -> Duration {
    let (start, account) = (Instant::now(), on_processor());
    work();
    let elapsed = start.elapsed();
    match (account, on_processor()) {
        (Some(before), Some(after)) => elapsed.min(after.saturating_sub(before)),
        _ => elapsed,
    }
}

/// How long this thread has been on a processor; Linux tells, elsewhere the clock on the wall must do.
fn on_processor() -> Option<Duration> {
    let account = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    account.split(' ').next()?.parse().ok().map(Duration::from_nanos)
}
