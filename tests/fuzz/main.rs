//! Spoiled files for every reader, odd values for every planner, any points as paths: nothing may panic, take more memory or time than
//! `limits.rs` allows, or break a promise. `cargo test` runs some hundred inputs that are always the same; `cargo xtask fuzz` runs more.
//!
//!     cargo test --test fuzz -- [--seed S] [--inputs N | --minutes M] [--only NUMBER]
//!
//! The work is done by a second process, so that an input that ends it (a stack that overflows, gigabytes at once) is named too. Each fault
//! is made smaller and written to target/fuzz/; its number and the seed make it again.
#![cfg(not(target_arch = "wasm32"))]

mod allocator;
#[path = "../common/mod.rs"]
mod common;
mod corpus;
mod limits;
mod mutate;
mod paths;
mod planners;
mod random;
mod readers;
mod report;
mod shrink;
mod stated;
#[path = "../common/terrains.rs"]
mod terrains;
mod watch;

use std::process::{Command, ExitCode, ExitStatus};
use std::time::{Duration, Instant};
use std::{env, process, thread};

use corpus::File;
use random::Random;
use readers::READERS;
use report::{Progress, Report};
use watch::Fault;

#[global_allocator]
static COUNTING: allocator::Counting = allocator::Counting;

/// Tells the second process that it is one, and of which run.
const WORKER: &str = "FORMICARIUM_FUZZ_WORKER";

#[derive(Clone, Copy)]
struct Options {
    seed: u64,
    inputs: Option<u64>,
    minutes: Option<f64>,
    only: Option<u64>,
    /// Where a worker goes on after one that was ended.
    from: u64,
}

impl Options {
    /// None where the tests are filtered by another name.
    fn read() -> Option<Self> {
        let mut options = Self { seed: 1, inputs: None, minutes: None, only: None, from: 0 };
        let mut words = env::args().skip(1);
        while let Some(word) = words.next() {
            let mut number = || words.next().and_then(|text| text.parse::<f64>().ok()).expect("a number after the option");
            match word.as_str() {
                "--seed" => options.seed = number() as u64,
                "--inputs" => options.inputs = Some(number() as u64),
                "--minutes" => options.minutes = Some(number()),
                "--only" => options.only = Some(number() as u64),
                "--from" => options.from = number() as u64,
                "--list" => return None,
                filter if !filter.starts_with('-') && !"fuzz".contains(filter) => return None,
                _ => {}
            }
        }
        Some(options)
    }

    fn is_short(self) -> bool {
        self.minutes.is_none() && self.only.is_none() && self.inputs.is_none()
    }

    /// Which inputs; those of a short run take about two seconds.
    fn numbers(self) -> impl Iterator<Item = u64> {
        const SHORT: u64 = 2500;
        let end = Instant::now() + Duration::from_secs_f64(60.0 * self.minutes.unwrap_or(1e6));
        let all = if self.minutes.is_some() { u64::MAX } else { SHORT };
        let numbers = self.only.map_or(self.from..self.inputs.unwrap_or(all), |only| only.max(self.from)..only + 1);
        numbers.take_while(move |_| Instant::now() < end)
    }
}

fn main() -> ExitCode {
    let Some(options) = Options::read() else { return ExitCode::SUCCESS };
    let Ok(run) = env::var(WORKER) else { return supervise(options) };
    let work = thread::Builder::new().stack_size(limits::STACK).spawn(move || work(options, &Progress::of(&run)));
    let faults = work.expect("a thread").join().expect("faults are caught");
    if faults == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Starts workers until one comes to its end. One that is ended by an input is followed by another, which begins behind that input.
fn supervise(options: Options) -> ExitCode {
    const MOST: usize = 20;
    let run = process::id().to_string();
    let progress = Progress::of(&run);
    let start = Instant::now();
    let (mut from, mut failed) = (0, false);
    for _ in 0..MOST {
        let mut rest = vec!["--from".into(), from.to_string()];
        let minutes = options.minutes.map(|all| (all - start.elapsed().as_secs_f64() / 60.0).max(0.0));
        rest.extend(minutes.into_iter().flat_map(|minutes| ["--minutes".into(), minutes.to_string()]));
        let status = watch_worker(&run, &rest, &progress);
        let number = progress.number().unwrap_or_default();
        progress.clear();
        match status.code() {
            Some(0) if !failed => return ExitCode::SUCCESS,
            Some(0 | 1) => return ExitCode::FAILURE,
            _ => tell_end(options, number, status),
        }
        (from, failed) = (number + 1, true);
    }
    println!("fuzz: {MOST} inputs have ended the process; that is enough");
    ExitCode::FAILURE
}

/// Starts a worker and waits for its end; one that stands still is killed.
fn watch_worker(run: &str, rest: &[String], progress: &Progress) -> ExitStatus {
    let program = env::current_exe().expect("a running program has a path");
    let mut command = Command::new(program);
    command.args(env::args().skip(1)).args(rest).env(WORKER, run);
    let mut worker = command.spawn().expect("the same program");
    let (mut last, mut since) = (None, Instant::now());
    loop {
        if let Some(status) = worker.try_wait().expect("a child") {
            return status;
        }
        if progress.number() != last {
            (last, since) = (progress.number(), Instant::now());
        }
        if since.elapsed() > limits::STANDSTILL {
            worker.kill().expect("a child");
        }
        thread::sleep(Duration::from_millis(20));
    }
}

fn tell_end(options: Options, number: u64, status: ExitStatus) {
    println!("FAULT ended: input {number} of seed {} ended the process ({status})", options.seed);
    let name = format!("ended-{}-{number}", options.seed);
    let about = |words: &str| format!("seed {}, input {number}\n{words}\n", options.seed);
    let file = match Inputs::new(options).input(number) {
        Ok(Some(Input::File(file))) => report::write(&name, &file.bytes, &about(&file.name)),
        Ok(Some(Input::Planner(case))) => report::write(&name, &[], &about(&case.words())),
        Ok(Some(Input::Path(case))) => report::write(&name, &[], &about(&case.words())),
        _ => return,
    };
    println!("      {file}");
}

fn work(options: Options, progress: &Progress) -> usize {
    watch::keep_panics();
    let inputs = Inputs::new(options);
    let mut report = Report::new(options.seed);
    let start = Instant::now();
    for number in options.numbers() {
        progress.set(number);
        report.count();
        inputs.check(number, &mut report);
    }
    report.end(inputs.files.len(), start.elapsed())
}

enum Input {
    File(File),
    Planner(planners::Case),
    Path(paths::Case),
}

/// All inputs of a seed; each follows from its number.
struct Inputs {
    seed: u64,
    files: Vec<File>,
    tile: Option<File>,
}

impl Inputs {
    fn new(options: Options) -> Self {
        let mut files = corpus::corpus();
        let short = options.is_short();
        if !short {
            corpus::add_data(&mut files);
        }
        Self { seed: options.seed, files, tile: (!short).then(corpus::tile) }
    }

    fn input(&self, number: u64) -> Result<Option<Input>, Fault> {
        let mut random = Random::of(self.seed, number);
        match random.below(12) {
            0 | 1 => Ok(planners::case(&mut random)?.map(Input::Planner)),
            2 => Ok(paths::case(&mut random)?.map(Input::Path)),
            _ => Ok(Some(Input::File(self.spoiled(&mut random)))),
        }
    }

    fn spoiled(&self, random: &mut Random) -> File {
        let rare = self.tile.as_ref().filter(|_| random.one_in(4000));
        let mut file = rare.unwrap_or_else(|| random.of_list(&self.files)).clone();
        let other = random.of_list(&self.files);
        // As it is, now and then.
        if !random.one_in(50) {
            mutate::spoil(random, &mut file.bytes, &other.bytes);
        }
        if random.one_in(10) {
            file.name.clone_from(&other.name);
        }
        file
    }

    fn check(&self, number: u64, report: &mut Report) {
        match self.input(number) {
            Err(fault) => report.add(number, "scenario", &fault, None, ""),
            Ok(None) => {}
            Ok(Some(Input::Planner(case))) => {
                told(case.check(), |fault| report.add(number, "planner", &fault, None, &case.words()))
            }
            Ok(Some(Input::Path(case))) => told(case.check(), |fault| report.add(number, "path", &fault, None, &case.words())),
            Ok(Some(Input::File(file))) => {
                report.count_file();
                for reader in READERS {
                    told(reader.check(&file), |fault| {
                        if report.is_new(&fault) {
                            let small = shrink::shrink(reader, &file, &fault);
                            report.add(number, reader.name, &fault, Some(&small.bytes), &file.name);
                        }
                    });
                }
            }
        }
    }
}

fn told(result: Result<(), Fault>, tell: impl FnOnce(Fault)) {
    if let Err(fault) = result {
        tell(fault);
    }
}
