//! The build helper: `cargo xtask serve`, `test`, `fuzz`, `build`, `one-file`, `wasm`, `bench`, `record`, `cards`, `maps`.
//!
//! Everything a fresh machine needs beside Rust and Node.js is either installed by these commands
//! or named in their message. One file per command; `tools.rs` starts programs, `install.rs` looks
//! after what is missing.

mod bench;
mod campaigns;
mod cards;
mod deny;
mod environment;
mod fuzz;
mod install;
mod maps;
mod notices;
mod one_file;
mod page;
mod python;
mod record;
mod serve;
mod stages;
mod test;
mod tools;
mod wasm;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", about = "Build, serve and test Formicarium")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Build everything and serve the page
    Serve(serve::Options),
    /// Compile the engine to pkg/, the wasm library the page and other programs import
    Wasm {
        /// Compile with debug assertions, without wasm-opt
        #[arg(long)]
        dev: bool,
    },
    /// Build the page as a static folder for any host and any sub-path
    Build {
        /// Where to put it [default: www/dist]
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Make one-file.html anew beside a page that is built: the whole page as one file
    OneFile {
        /// Where the page is [default: www/dist]
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Run every check, or the named stages only
    Test(test::Options),
    /// Give spoiled inputs to everything that reads, for as long as you like
    Fuzz(fuzz::Options),
    /// Measure the engine beside its peers
    Bench(bench::Options),
    /// Run the questions in experiments/ again and replace their records
    Record(record::Options),
    /// Write the tables of the papers' cards anew from the records
    Cards,
    /// Make the suite of maps in experiments/maps again, with the table in their README
    Maps(maps::Options),
}

fn main() -> ExitCode {
    match run(Cli::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> anyhow::Result<()> {
    match command {
        Command::Serve(options) => serve::serve(&options),
        Command::Wasm { dev } => wasm::build(wasm::Mode::from_dev(dev)),
        Command::Build { out } => page::build(out.as_deref()).map(|folder| {
            println!("page: {}", folder.display());
        }),
        Command::OneFile { out } => one_file::build(&out.unwrap_or_else(|| tools::www().join("dist"))),
        Command::Test(options) => test::test(&options),
        Command::Fuzz(options) => fuzz::fuzz(&options),
        Command::Bench(options) => bench::bench(&options),
        Command::Record(options) => record::record(&options),
        Command::Cards => cards::update(),
        Command::Maps(options) => maps::maps(&options),
    }
}
