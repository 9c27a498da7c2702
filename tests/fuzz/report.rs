//! What was found: printed once for each fault, with a file in target/fuzz/. And how far the worker is, for whoever watches it.

use std::fs;
use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::time::Duration;

use crate::planners::RAN;
use crate::readers::ACCEPTED;
use crate::watch::Fault;

fn folder() -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).with_file_name("fuzz");
    fs::create_dir_all(&folder).expect("target/ can be written");
    folder
}

/// The number of the input at work, in a file that survives whatever happens to the worker.
pub struct Progress(PathBuf);

impl Progress {
    /// `run` tells two runs at the same time apart.
    pub fn of(run: &str) -> Self {
        Self(folder().join(format!("at-{run}")))
    }

    pub fn clear(&self) {
        let _ = fs::remove_file(&self.0);
    }

    pub fn set(&self, number: u64) {
        let _ = fs::write(&self.0, number.to_string());
    }

    pub fn number(&self) -> Option<u64> {
        fs::read_to_string(&self.0).ok()?.parse().ok()
    }
}

pub struct Report {
    seed: u64,
    inputs: u64,
    /// Those that every reader was given.
    files: u64,
    faults: Vec<Fault>,
}

impl Report {
    pub fn new(seed: u64) -> Self {
        Self { seed, inputs: 0, files: 0, faults: Vec::new() }
    }

    pub fn is_new(&self, fault: &Fault) -> bool {
        !self.faults.iter().any(|known| known.is_like(fault))
    }

    pub fn count(&mut self) {
        self.inputs += 1;
    }

    pub fn count_file(&mut self) {
        self.files += 1;
    }

    /// Tells a fault that is not known yet: of a file its bytes and name, of the rest the words that make it again.
    pub fn add(&mut self, number: u64, what: &str, fault: &Fault, bytes: Option<&[u8]>, words: &str) {
        if !self.is_new(fault) {
            return;
        }
        let Fault { kind, place, message } = fault;
        let story = format!("{kind} in {what} at {place}\n{message}\nseed {}, input {number}\n{words}\n", self.seed);
        let name = format!("{kind}-{what}-{}-{number}", self.seed);
        let file = write(&name, bytes.unwrap_or_default(), &story);
        let short: String = message.chars().take(300).collect();
        println!("FAULT {kind} in {what} at {place}: {short}\n      seed {}, input {number}: {file}", self.seed);
        self.faults.push(fault.clone());
    }

    /// How many faults there were.
    pub fn end(&self, files: usize, took: Duration) -> usize {
        let (inputs, faults, seconds, seed) = (self.inputs, self.faults.len(), took.as_secs_f64(), self.seed);
        let [maps, runs] = [&ACCEPTED, &RAN].map(|count| count.load(Ordering::Relaxed));
        println!(
            "fuzz: seed {seed}, {inputs} inputs, {} of them spoiled from {files} files and given to every reader: {maps} maps read, {runs} planners run, {faults} faults, {seconds:.1} s",
            self.files
        );
        faults
    }
}

/// Writes an input as base64 beside its story; gives the file's path.
pub fn write(name: &str, bytes: &[u8], story: &str) -> String {
    let path = folder().join(format!("{name}.txt"));
    let text = format!("{story}{}\n", base64(bytes));
    if let Err(error) = fs::write(&path, text) {
        return format!("{} cannot be written: {error}", path.display());
    }
    path.display().to_string()
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let digits = |three: &[u8]| {
        let bits = three.iter().fold(0u32, |bits, byte| bits << 8 | u32::from(*byte)) << (8 * (3 - three.len()));
        (0..4)
            .map(move |k| if k > three.len() { '=' } else { DIGITS[(bits >> (18 - 6 * k)) as usize & 63] as char })
            .collect::<Vec<_>>()
    };
    bytes.chunks(3).flat_map(digits).collect()
}
