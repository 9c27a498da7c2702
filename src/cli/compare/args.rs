//! The arguments of `compare`.

use std::path::{Path, PathBuf};

use crate::comparison::report::{ReportLanguage, ResultFile};
use crate::comparison::{Budget, FrontQuestion, MAX_SHARDS, RunMeasure, Shard};
use crate::error::QuestionError;
use crate::params::Value;

use super::place::Place;
use super::recheck::Share;
use crate::cli::error::CliError;
use crate::cli::input::{file_name, stem};

/// Runs a question: every entry on every map with every seed, and judges its claims
#[derive(clap::Args)]
#[command(after_help = "\
Writes NAME.csv, one row a run, NAME.md, tables and verdicts, NAME.tests.md, rank tests of all pairs, NAME.summary.csv and
NAME.summary.json, one row an entry and map with every statistic, NAME.tex, the same for a paper, and NAME.json, question, maps
and runs in one file, which the page opens and which can be compared again: exit code 1 when other bits come out though engine, question,
maps and parameters are the recorded ones. They depend on the question alone, not on the number of jobs.
Every finished run is kept in NAME.partial at once: a comparison that was broken off goes on where it was when it is started again. A
second process of the same NAME waits for the first. Files that this program has not written are not overwritten, nor is a NAME.json whose
runs do not come out again: what came out instead is in NAME.again.*. The question's format and the rule of the verdicts: docs/methodology.md.

--shard and --merge split the runs among machines, tabs or jobs of a cluster: docs/campaigns.md. A shard's journal, NAME.DIGEST.shard-IofN.journal,
is whole when it has that name; one that was broken off goes on where it was. --merge gives the bytes of an unbroken comparison, or says
which runs are missing and which journals are damaged, foreign, or at odds with each other: exit code 1, and nothing is written.

--ablate asks without a file what each component of a planner does: the full planner beside the same without one, on maps of your own.
`formicarium catalog PLANNER` lists the components.

Examples:
  formicarium compare experiments/ship.toml --out experiments/records
  formicarium compare ship.json --out /tmp/again
  formicarium compare experiments/ship.toml --out /tmp/look --seeds 10 --files markdown,latex
  formicarium compare experiments/ship.toml --out /tmp/zh --files markdown,latex --language zh-CN
  formicarium compare experiments/ship.toml --out /tmp/fair --budget constructed-paths=2000
  formicarium compare experiments/ship.toml --out /tmp/mine --only mine --map ship-20x20/mine=mine.csv
  formicarium compare experiments/ship.toml --results mine.csv --out /tmp/beside-mine
  formicarium compare experiments/ship.toml --results-template > mine.csv
  formicarium compare --ablate ship --map cave.json --map maze.json --seeds 50 --out /tmp/ablation
  formicarium compare experiments/ship.toml --shard 3/30 --out /shared/ship
  formicarium compare experiments/ship.toml --list-shards 30
  formicarium compare experiments/ship.toml --merge /shared/ship --out results --recheck 2%
  formicarium compare experiments/ship.toml --document > ship.json")]
pub struct Args {
    /// The question as TOML (formicarium/question@1), or with its maps and results as JSON (formicarium/comparison@1)
    #[arg(required_unless_present = "ablate")]
    pub question: Option<PathBuf>,
    /// In place of a question: this planner, and the same without each of its components
    #[arg(long, value_name = "PLANNER", conflicts_with = "question", requires = "map")]
    pub ablate: Option<String>,
    /// With --ablate: a named parameter set of the planner
    #[arg(long, value_name = "NAME", requires = "ablate")]
    pub preset: Option<String>,
    /// With --ablate: a parameter, over preset and default; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "ablate", value_parser = crate::cli::planner_args::assignment)]
    pub set: Vec<(String, Value)>,
    /// Folder for the files; made if it is missing [default with --merge: the journals' folder]
    #[arg(long, value_name = "DIR", required_unless_present_any = ["document", "results_template", "merge", "list_shards"])]
    out: Option<PathBuf>,
    /// Only this part of the runs, such as 3/30: keeps them in a journal in --out, and writes no results
    #[arg(long, value_name = "I/N", group = "shards", conflicts_with_all = ["merge", "document", "results_template", "replace", "files", "language"])]
    pub shard: Option<Shard>,
    /// Run nothing: print the names that the journals of so many shards will have, one a line, for what runs the shards
    #[arg(long, value_name = "N", conflicts_with_all = ["out", "shard", "merge", "document", "results_template"],
          value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SHARDS)))]
    pub list_shards: Option<u32>,
    /// Run nothing: the results from the journals of shards in this folder, however many machines have written them
    #[arg(long, value_name = "DIR", group = "shards", conflicts_with_all = ["document", "results_template"])]
    pub merge: Option<PathBuf>,
    /// Repeat so many runs of somebody else, such as 2%: with --merge here and now, of each journal at least one; with --shard runs of the
    /// next shard, which --merge compares
    #[arg(long, value_name = "P%", requires = "shards")]
    pub recheck: Option<Share>,
    /// With --merge: which runs are repeated, to do the same again [default: others each time]
    #[arg(long, value_name = "SEED", requires_all = ["recheck", "merge"])]
    pub recheck_seed: Option<u64>,
    /// Overwrite files that have the names of the results and are something else
    #[arg(long, conflicts_with_all = ["document", "results_template"])]
    pub replace: bool,
    /// While another process compares under the same name: fail at once instead of waiting for it
    #[arg(long, conflicts_with_all = ["document", "results_template"])]
    pub no_wait: bool,
    /// Run nothing: print the question with its maps and imported results (formicarium/comparison@1), as the page opens it
    #[arg(long, conflicts_with = "out")]
    pub document: bool,
    /// Run nothing: print an empty table for results from elsewhere, with a line for each map and seed
    #[arg(long, conflicts_with_all = ["out", "document"])]
    pub results_template: bool,
    /// Which files: csv, markdown, tests, tests-csv, summary-csv, summary-json, summary-markdown, latex,
    /// claims-csv (NAME.claims.csv), matrix-csv, matrix-markdown, matrix-latex (NAME.matrix.csv, .md, .tex: maps × entries), fronts-csv, fronts-markdown,
    /// fronts-latex (NAME.fronts.csv, .md, .tex: what runs trade off), json [default: those above]
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', hide_default_value = true, value_parser = result_file,
          default_value = "csv,markdown,tests,summary-csv,summary-json,latex,json")]
    pub files: Vec<(&'static str, ResultFile)>,
    /// What the files fronts-… trade off: two or three of length, cost, turns, turn-index, min-clearance, mean-clearance, weight,
    /// iteration-of-best, paths-to-best, ant-moves [default: length,turns]
    #[arg(long, value_name = "MEASURE,…", value_delimiter = ',', value_parser = front_measure)]
    pub fronts: Vec<RunMeasure>,
    /// Their reference point, a value for each measure [default: the worst value on the map, and a tenth of the range more]
    #[arg(long, value_name = "VALUE,…", value_delimiter = ',', allow_hyphen_values = true)]
    pub fronts_reference: Vec<f64>,
    /// What Markdown and LaTeX are written in: en or zh-CN; CSV and JSON, which programs read, are the same in each
    #[arg(long, value_name = "LANGUAGE", default_value = "en", hide_default_value = true, value_parser = language)]
    pub language: ReportLanguage,
    /// Runs at the same time [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
    /// Only the question's first seeds; with --ablate how many [default: 100]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub seeds: Option<u32>,
    /// What a run may spend, in place of the question's budget: iterations, constructed-paths, ant-moves, cell-expansions or moves
    #[arg(long, value_name = "AXIS=AMOUNT", value_parser = budget)]
    pub budget: Option<Budget>,
    /// Only this instance, or all of this group; may be repeated
    #[arg(long, value_name = "ID")]
    pub only: Vec<String>,
    /// Another map in place of an instance's; GROUP/ID=FILE one more beside those of a group; with --ablate a map, its ID= may be left out;
    /// may be repeated
    #[arg(long, value_name = "ID=FILE", value_parser = named_map)]
    pub map: Vec<(Option<String>, PathBuf)>,
    /// Imported results, compared and not run: a table or an IOHanalyzer file; ID= says on which map, where the file does not;
    /// may be repeated
    #[arg(long, value_name = "ID=FILE", value_parser = named_map)]
    pub results: Vec<(Option<String>, PathBuf)>,
}

impl Args {
    /// Where the files go.
    pub fn place(&self) -> Place {
        Place::new(self.folder(), self.name())
    }

    /// Where a shard's journal goes. It is one of a kind: by name, question and shard.
    pub fn place_of(&self, shard: Shard, digest: &str) -> Place {
        Place::new(self.folder(), format!("{}.{digest}.shard-{}of{}", self.name(), shard.index(), shard.of()))
    }

    /// What runs are traded off by.
    pub fn fronts(&self) -> FrontQuestion {
        let asked = FrontQuestion::default();
        let measures = if self.fronts.is_empty() { asked.measures } else { self.fronts.clone() };
        FrontQuestion { measures, reference: (!self.fronts_reference.is_empty()).then(|| self.fronts_reference.clone()) }
    }

    /// The folder for the files.
    pub fn folder(&self) -> &Path {
        self.out.as_deref().or(self.merge.as_deref()).unwrap_or(Path::new(""))
    }

    /// What the files are called.
    fn name(&self) -> String {
        match (&self.ablate, &self.question) {
            (Some(planner), _) => format!("ablation-{planner}"),
            (None, question) => question.as_deref().map_or_else(String::new, stem),
        }
    }

    /// What is asked, with the file's name alone: its folder is this machine's.
    fn asked(&self) -> String {
        match (&self.ablate, &self.question) {
            (Some(planner), _) => format!("--ablate {planner}"),
            (None, question) => question.as_deref().map_or_else(String::new, file_name),
        }
    }

    /// What is asked as it was typed, for errors alone: they are no part of a result.
    fn typed(&self) -> String {
        match &self.question {
            Some(file) if self.ablate.is_none() => file.display().to_string(),
            _ => self.asked(),
        }
    }

    /// The command that does one shard, for whoever looks for a missing one.
    pub fn command_of(&self, shard: Shard, journals: &Path) -> String {
        let typed = |file: &Path| quoted(&file.display().to_string());
        self.said(&quoted(&self.typed()), &format!("--shard {shard} --out {}", typed(journals)), typed)
    }

    /// The arguments that the results depend on; other maps by their names alone, because their folders are this machine's.
    pub fn command(&self) -> String {
        self.said(&self.asked(), "--out DIR", file_name)
    }

    /// The arguments on which runs depend, with files by the names that `named` gives them.
    fn said(&self, asked: &str, out: &str, named: impl Fn(&Path) -> String) -> String {
        let mut said = format!("formicarium compare {asked} {out}");
        self.preset.iter().for_each(|name| said += &format!(" --preset {name}"));
        self.set.iter().for_each(|(key, value)| said += &format!(" --set {key}={value}"));
        self.seeds.iter().for_each(|n| said += &format!(" --seeds {n}"));
        self.budget.iter().for_each(|b| said += &format!(" --budget {b}"));
        self.only.iter().for_each(|id| said += &format!(" --only {id}"));
        let id = |id: &Option<String>| id.as_ref().map_or_else(String::new, |id| format!("{id}="));
        self.map.iter().for_each(|(of, file)| said += &format!(" --map {}{}", id(of), named(file)));
        self.results.iter().for_each(|(of, file)| said += &format!(" --results {}{}", id(of), named(file)));
        if !self.fronts.is_empty() {
            said += &format!(" --fronts {}", self.fronts.iter().map(|m| m.id()).collect::<Vec<_>>().join(","));
        }
        if !self.fronts_reference.is_empty() {
            said += &format!(
                " --fronts-reference {}",
                self.fronts_reference.iter().map(f64::to_string).collect::<Vec<_>>().join(",")
            );
        }
        if self.language != ReportLanguage::default() {
            said += &format!(" --language {}", self.language.code());
        }
        said
    }

    /// Names what is asked in an error about it.
    pub fn wrong(&self, error: QuestionError) -> CliError {
        CliError::Contents { path: self.typed(), error: error.into() }
    }
}

/// A file's name as a shell takes it: in quotes where it has signs that mean something there.
fn quoted(name: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_./=,:@%+-".contains(c);
    match name {
        _ if name.starts_with('-') => quoted(&format!("./{name}")),
        _ if !name.is_empty() && name.chars().all(is_plain) => name.into(),
        _ => format!("'{}'", name.replace('\'', r"'\''")),
    }
}

/// A kind of `--files`, with the ending of its name.
fn result_file(text: &str) -> Result<(&'static str, ResultFile), String> {
    let named = ResultFile::NAMED.iter().find(|(id, ..)| *id == text);
    let all = || ResultFile::NAMED.map(|(id, ..)| id).join(", ");
    named.map(|&(_, ending, file)| (ending, file)).ok_or_else(|| format!("choose from {}", all()))
}

/// A measure of `--fronts`.
fn front_measure(text: &str) -> Result<RunMeasure, String> {
    let named = FrontQuestion::MEASURES.into_iter().find(|measure| measure.id() == text);
    named.ok_or_else(|| format!("choose from {}", FrontQuestion::MEASURES.map(RunMeasure::id).join(", ")))
}

/// A language of `--language`.
fn language(text: &str) -> Result<ReportLanguage, String> {
    let named = ReportLanguage::NAMED.iter().find(|(code, _)| *code == text);
    named
        .map(|&(_, language)| language)
        .ok_or_else(|| format!("choose from {}", ReportLanguage::NAMED.map(|(code, _)| code).join(", ")))
}

/// `AXIS=AMOUNT` of `--budget`.
pub fn budget(text: &str) -> Result<Budget, String> {
    text.parse().map_err(|e: QuestionError| e.to_string())
}

/// `ID=FILE` or `FILE` of `--map`.
pub fn named_map(text: &str) -> Result<(Option<String>, PathBuf), String> {
    match text.split_once('=') {
        None if !text.is_empty() => Ok((None, text.into())),
        Some((id, file)) if !id.is_empty() && !file.is_empty() => Ok((Some(id.into()), file.into())),
        _ => Err(format!("`{text}` names no map: write ID=FILE such as ship-20x20-01=mine.csv, or GROUP/ID=FILE")),
    }
}
