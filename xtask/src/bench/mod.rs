//! `cargo xtask bench`: the engine beside its peers. Each part races contestants in paired rounds and gives ratios with intervals.
//!
//! One file a part; `runner.rs` starts what is timed (benches/runner, benches/peers), `rounds.rs` races it, `interval.rs` sums it up,
//! `report.rs` writes it down.

mod campaigns;
mod colonies;
mod exact;
mod growth;
mod instructions;
mod interval;
mod maps;
mod page;
mod python;
mod report;
mod rounds;
mod runner;
mod walk;

use anyhow::Result;
use clap::{Args, ValueEnum};

use report::Section;

#[derive(Args)]
pub struct Options {
    /// Only these parts [default: all]
    #[arg(value_enum)]
    parts: Vec<Part>,
    /// The same work on small maps, a few seconds a part: whether everything still runs, and no number to quote
    #[arg(long)]
    quick: bool,
    /// Paired rounds of each race
    #[arg(long, default_value_t = 11)]
    rounds: usize,
    /// Put the tables into docs/performance.md and the README
    #[arg(long, conflicts_with = "quick")]
    write: bool,
    /// Write the counted instructions to benches/instructions.json
    #[arg(long)]
    bless: bool,
}

/// What can be measured.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// Ant System's walk beside the naive one and one in JavaScript
    Walk,
    /// Every colony of the catalog
    Colonies,
    /// Shortest paths beside other libraries
    Exact,
    /// Ant colonies of PyPI
    Python,
    /// Time as ants, cells and cores grow
    Growth,
    /// The page in Chromium: from an input to its picture, from the address to the first step
    Page,
    /// Comparisons in shards beside one process; merging very many runs
    Campaigns,
    /// Instructions an ant move, beside those that were counted before
    Instructions,
}

/// How much is measured.
pub struct Extent {
    quick: bool,
    rounds: usize,
    bless: bool,
}

pub fn bench(options: &Options) -> Result<()> {
    let parts = if options.parts.is_empty() { Part::value_variants() } else { &options.parts };
    let rounds = if options.quick { 2 } else { options.rounds };
    measure(parts, &Extent { quick: options.quick, rounds, bless: options.bless }, options.write)
}

/// Every benchmark, shortly: that none of them rots.
pub fn stage() -> Result<()> {
    measure(Part::value_variants(), &Extent { quick: true, rounds: 2, bless: false }, false)
}

fn measure(parts: &[Part], extent: &Extent, write: bool) -> Result<()> {
    let mut is_of_machine = false;
    for part in parts {
        let Some(section) = part.run(extent)? else { continue };
        is_of_machine |= section.page == report::PERFORMANCE;
        println!("\n{}", section.text);
        if write {
            section.write()?;
        }
    }
    if write && is_of_machine { report::write_machine() } else { Ok(()) }
}

impl Part {
    /// Nothing where the part cannot be measured here; it has said why.
    fn run(self, extent: &Extent) -> Result<Option<Section>> {
        match self {
            Self::Walk => walk::run(extent).map(Some),
            Self::Colonies => colonies::run(extent).map(Some),
            Self::Exact => exact::run(extent).map(Some),
            Self::Python => python::run(extent),
            Self::Growth => growth::run(extent).map(Some),
            Self::Page => page::run(extent),
            Self::Campaigns => campaigns::run(extent).map(Some),
            Self::Instructions => instructions::run(extent),
        }
    }
}
