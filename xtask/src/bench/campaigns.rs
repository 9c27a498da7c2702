//! What it takes to do a comparison in shards, and to merge very many runs.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};

use super::Extent;
use super::interval::{Interval, short};
use super::maps::{self, quietly};
use super::report::{Section, machine, table};
use crate::campaigns;
use crate::tools::root;

const NOTE: &str = "\
`experiments/ship.toml` on two cores, the whole command each time, in rounds: one process with `--jobs 2`; its shards by two processes at a \
time, each from its start to its end, and merged; the same by Snakemake (`campaigns/Snakefile`). *Throughput*: runs a second beside one \
process.";

const MERGE: &str = "\
Merging: ten colonies, 3 iterations each, on ten maps of 12²; reading the journals, all statistics with their intervals, writing every file.";

pub fn run(extent: &Extent) -> Result<Section> {
    let formicarium = maps::formicarium(extent.quick)?;
    let program = PathBuf::from(formicarium().get_program());
    let engines = engines(&program, extent)?;
    let merging = merging(&program, extent)?;
    Ok(Section {
        name: "campaigns",
        page: "docs/campaigns.md",
        text: format!("{NOTE} `cargo xtask bench campaigns`; {}\n\n{engines}\n{MERGE}\n\n{merging}", machine()),
        readme: None,
    })
}

/// Does the whole question into an empty folder.
type Run<'a> = Box<dyn Fn(&Path) -> Result<()> + 'a>;

/// A way to do it.
struct Way<'a> {
    name: String,
    run: Run<'a>,
}

fn engines(program: &Path, extent: &Extent) -> Result<String> {
    let (shards, rounds) = if extent.quick { (4, 1) } else { (50, extent.rounds.min(5)) };
    let options: &[&str] = if extent.quick { &["--seeds", "1", "--only", "ship-20x20-00"] } else { &["--seeds", "60"] };
    let question = &root().join("experiments/ship.toml");
    let compare = || {
        let mut command = Command::new(program);
        command.arg("compare").arg(question).args(options);
        command
    };
    let mut ways = vec![
        Way { name: "one process".into(), run: Box::new(move |out| quietly(compare().args(["--jobs", "2", "--out"]).arg(out))) },
        Way {
            name: format!("{shards} shards, two processes at a time"),
            run: Box::new(move |out| by_hand(&compare, shards, out)),
        },
    ];
    match campaigns::snakemake() {
        Ok(snakemake) => ways.push(Way {
            name: format!("{shards} shards by Snakemake"),
            run: Box::new(move |out| {
                let mut command = campaigns::local(&snakemake, program, question, &options.join(" "), out);
                quietly(command.arg(format!("shards={shards}")))
            }),
        }),
        Err(error) => println!("bench: Snakemake SKIPPED, {error:#}"),
    }
    println!("bench: campaigns…");
    let mut seconds = vec![Vec::new(); ways.len()];
    for _ in 0..rounds {
        for (way, seconds) in ways.iter().zip(&mut seconds) {
            let out = emptied(&maps::folder()?.join("campaign"))?;
            let start = Instant::now();
            (way.run)(&out).with_context(|| way.name.clone())?;
            seconds.push(start.elapsed().as_secs_f64());
        }
    }
    let row = |(way, of): (&Way, &Vec<f64>)| {
        let ratio = Interval::of(seconds[0].iter().zip(of).map(|(one, this)| one / this));
        let more = Interval::of(seconds[0].iter().zip(of).map(|(one, this)| 1e3 * (this - one) / f64::from(shards)));
        let more = if way.name == ways[0].name { "–".into() } else { short(more.median) };
        vec![way.name.clone(), Interval::of(of.iter().copied()).to_string(), ratio.to_string(), more]
    };
    let rows: Vec<_> = ways.iter().zip(&seconds).map(row).collect();
    Ok(table(&["how", "seconds", "throughput", "ms more a shard"], &rows))
}

/// Every shard in a process of its own, two at a time, and then merged.
fn by_hand(compare: &(impl Fn() -> Command + Sync), shards: u32, out: &Path) -> Result<()> {
    let (next, journals) = (AtomicU32::new(1), out.join("shards"));
    let worker = || -> Result<()> {
        loop {
            let shard = next.fetch_add(1, Ordering::Relaxed);
            if shard > shards {
                return Ok(());
            }
            quietly(compare().args(["--jobs", "1", "--shard", &format!("{shard}/{shards}"), "--out"]).arg(&journals))?;
        }
    };
    thread::scope(|scope| {
        let both = [scope.spawn(worker), scope.spawn(worker)];
        both.into_iter().try_for_each(|worker| worker.join().expect("a worker does not panic"))
    })?;
    quietly(compare().arg("--merge").arg(&journals).arg("--out").arg(out))
}

fn merging(program: &Path, extent: &Extent) -> Result<String> {
    let seeds: &[u32] = if extent.quick { &[20] } else { &[1_000, 10_000] };
    let rows = seeds.iter().map(|&seeds| {
        let question = question(program, seeds)?;
        let journals = emptied(&maps::folder()?.join("journals"))?;
        for shard in ["1/4", "2/4", "3/4", "4/4"] {
            quietly(Command::new(program).arg("compare").arg(&question).args(["--shard", shard, "--out"]).arg(&journals))?;
        }
        let out = emptied(&maps::folder()?.join("merged"))?;
        let mut merge = Command::new(program);
        merge.arg("compare").arg(&question).arg("--merge").arg(&journals).arg("--out").arg(&out);
        let (seconds, megabytes) = watched(&mut merge)?;
        let size = |folder: &Path| -> Result<u64> { fs::read_dir(folder)?.map(|file| Ok(file?.metadata()?.len())).sum() };
        let megabytes_of = |folder: &Path| size(folder).map(|bytes| short(bytes as f64 / 1e6));
        Ok(vec![(100 * seeds).to_string(), short(seconds), megabytes, megabytes_of(&journals)?, megabytes_of(&out)?])
    });
    let heads = ["runs", "seconds", "MiB at most", "MB of journals", "MB of results"];
    Ok(table(&heads, &rows.collect::<Result<Vec<_>>>()?))
}

/// Ten colonies on ten small maps.
fn question(program: &Path, seeds: u32) -> Result<PathBuf> {
    const COLONIES: [&str; 10] = [
        "ant-system",
        "elitist-ant-system",
        "rank-based-ant-system",
        "max-min-ant-system",
        "ant-colony-system",
        "best-worst-ant-system",
        "ship",
        "fire",
        "acomsp",
        "acost",
    ];
    let folder = emptied(&maps::folder()?.join("many-runs"))?;
    let mut text = format!(
        "format = \"formicarium/question@1\"\ntitle = \"Many runs\"\nasks = \"How long does it take to merge them?\"\n\
         seeds = {{ from = 1, count = {seeds} }}\n"
    );
    for map in 1..=10 {
        let file = folder.join(format!("m{map}.json"));
        let seed = map.to_string();
        quietly(Command::new(program).args(["generate", "random", "--size", "12x12", "--seed", &seed, "--out"]).arg(&file))?;
        text += &format!("\n[[instances]]\nid = \"m{map}\"\nmap = \"m{map}.json\"\n");
    }
    for colony in COLONIES {
        text += &format!(
            "\n[[entries]]\nid = \"{colony}\"\nlabel = \"{colony}\"\nrole = \"other\"\nplanner = \"{colony}\"\n\
             set = {{ iterations = 3, ants = 4 }}\n"
        );
    }
    let file = folder.join("many.toml");
    fs::write(&file, text)?;
    Ok(file)
}

/// Seconds of a command, and the most memory that it had, where the system tells.
fn watched(command: &mut Command) -> Result<(f64, String)> {
    let start = Instant::now();
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    let mut most = None;
    let status = loop {
        most = resident(&child).or(most);
        if let Some(status) = child.try_wait()? {
            break status;
        }
        thread::sleep(Duration::from_millis(20));
    };
    ensure!(status.success(), "{command:?} failed");
    Ok((start.elapsed().as_secs_f64(), most.map_or_else(|| "unknown".into(), |kib| (kib / 1024).to_string())))
}

/// The most KiB that a process has had in memory so far.
fn resident(child: &Child) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.trim().strip_suffix(" kB")?.trim().parse().ok()
}

fn emptied(folder: &Path) -> Result<PathBuf> {
    if folder.exists() {
        fs::remove_dir_all(folder).with_context(|| format!("cannot empty {}", folder.display()))?;
    }
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    Ok(folder.into())
}
