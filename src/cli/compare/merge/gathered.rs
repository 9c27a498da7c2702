//! The runs of many journals, each in its place, with where it came from and what did not hold.

use std::collections::BTreeMap;
use std::path::Path;

use crate::cli::streams::harmless;
use crate::comparison::{Comparison, Row, Shard};
use crate::formats::journal::{JournalFault, JournalLines};

/// Most faults of one journal that are kept to be shown; the others are counted.
const MOST_FAULTS: usize = 20;

/// A journal that was read.
#[derive(Debug)]
pub struct Source {
    /// Its name without the folder.
    pub name: String,
    /// Whose it is; none where it is of all runs, or unknown.
    pub shard: Option<Shard>,
    /// Whether its name says that it is whole.
    pub is_finished: bool,
    /// Runs that it brought first.
    pub runs: usize,
    /// Runs that another journal had brought before, by that journal; itself among them.
    pub again: BTreeMap<usize, usize>,
    /// What does not hold, by line; 1 is its head.
    pub faults: Vec<(usize, JournalFault)>,
    /// How many of these there are.
    pub fault_count: usize,
    /// Whether it ends in the middle of a line, as a process leaves it that was killed or is writing.
    pub is_cut: bool,
}

impl Source {
    /// Whether its head says that none of its lines counts.
    pub fn is_foreign(&self) -> bool {
        self.faults.first().is_some_and(|(line, fault)| *line <= 1 && *fault != JournalFault::Damaged)
    }
}

/// Where a run came from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Origin {
    source: u32,
    line: u32,
}

/// Two journals that tell different things of the same run.
#[derive(Debug)]
pub struct Disagreement {
    /// Its place among the tasks.
    pub place: usize,
    /// What the second one says; the first one's stands in its place.
    pub row: Row,
    /// The second one, as [`Gathered::source_of`] tells it.
    pub source: String,
}

/// What many journals hold.
pub struct Gathered {
    lines: JournalLines,
    rows: Vec<Option<Row>>,
    origins: Vec<Origin>,
    sources: Vec<Source>,
    disagreements: Vec<Disagreement>,
    disagreement_count: usize,
}

impl Gathered {
    /// Nothing yet.
    pub fn new(lines: JournalLines) -> Self {
        let count = lines.tasks().len();
        Self {
            rows: vec![None; count],
            origins: vec![Origin { source: 0, line: 0 }; count],
            sources: Vec::new(),
            disagreements: Vec::new(),
            disagreement_count: 0,
            lines,
        }
    }

    /// Begins with the next journal.
    pub fn begin(&mut self, path: &Path) {
        self.sources.push(Source {
            name: path
                .file_name()
                .map_or_else(String::new, |name| harmless(&name.to_string_lossy()).replace(['\n', '\t'], "\u{fffd}")),
            shard: None,
            is_finished: path.extension().is_some_and(|ending| ending == "journal"),
            runs: 0,
            again: BTreeMap::new(),
            faults: Vec::new(),
            fault_count: 0,
            is_cut: false,
        });
    }

    /// Takes its first line.
    pub fn head(&mut self, line: &[u8]) {
        match self.lines.read_head(line) {
            Ok(shard) => self.now().shard = shard,
            Err(JournalFault::Cut) if !self.now().is_finished => self.now().is_cut = true,
            Err(fault) => self.fault(1, fault),
        }
    }

    /// Takes another one.
    pub fn line(&mut self, number: usize, line: &[u8]) {
        match self.lines.read_line(line) {
            Ok((place, row)) => self.run(number, place, row),
            Err(JournalFault::Cut) if !self.now().is_finished => self.now().is_cut = true,
            Err(fault) => self.fault(number, fault),
        }
    }

    /// Notes that a line does not hold.
    pub fn fault(&mut self, number: usize, fault: JournalFault) {
        let now = self.now();
        now.fault_count += 1;
        if now.faults.len() < MOST_FAULTS {
            now.faults.push((number, fault));
        }
    }

    /// Whether the journal that is read has nothing that counts.
    pub fn is_foreign(&self) -> bool {
        self.sources.last().is_some_and(Source::is_foreign)
    }

    fn run(&mut self, number: usize, place: usize, row: Row) {
        let source = self.sources.len() - 1;
        let Some(first) = &self.rows[place] else {
            self.rows[place] = Some(row);
            self.origins[place] = Origin { source: source as u32, line: number as u32 };
            self.sources[source].runs += 1;
            return;
        };
        // As it is written: −0 is equal to 0, and other bytes.
        if first.to_line() == row.to_line() {
            *self.sources[source].again.entry(self.origins[place].source as usize).or_default() += 1;
            return;
        }
        self.disagreement_count += 1;
        if self.disagreements.len() < MOST_FAULTS {
            let source = format!("{}:{number}", self.sources[source].name);
            self.disagreements.push(Disagreement { place, row, source });
        }
    }

    fn now(&mut self) -> &mut Source {
        self.sources.last_mut().expect("a journal is begun before it is read")
    }

    /// Whether no journal was read.
    pub fn is_empty(&self) -> bool {
        self.sources.is_empty()
    }

    /// The journals, in the order in which they were read.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// Runs of which two journals tell different things, the first ones, and how many there are.
    pub fn disagreements(&self) -> (&[Disagreement], usize) {
        (&self.disagreements, self.disagreement_count)
    }

    /// The places of runs that no journal has.
    pub fn missing(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|&place| self.rows[place].is_none()).collect()
    }

    /// The run in a place.
    pub fn row(&self, place: usize) -> Option<&Row> {
        self.rows.get(place)?.as_ref()
    }

    /// The place of a run.
    pub fn place(&self, row: &Row) -> Option<usize> {
        self.lines.tasks().binary_search(&row.task).ok()
    }

    /// File and line of the run in a place.
    pub fn source_of(&self, place: usize) -> String {
        let Origin { source, line } = self.origins[place];
        format!("{}:{line}", self.sources[source as usize].name)
    }

    /// The run in a place, as people call it.
    pub fn task(&self, comparison: &Comparison, place: usize) -> String {
        let task = self.lines.tasks()[place];
        let question = &comparison.question;
        let id = |id: Option<&String>| id.map_or("?", String::as_str).to_owned();
        let map = id(question.instances.get(task.instance).map(|i| &i.id));
        format!("{map}, {}, seed {}", id(question.entries.get(task.entry).map(|e| &e.id)), task.seed)
    }

    /// For each journal the places of the runs that it brought first.
    pub fn by_source(&self) -> Vec<Vec<usize>> {
        let mut all = vec![Vec::new(); self.sources.len()];
        let brought = (0..self.rows.len()).filter(|&place| self.rows[place].is_some());
        brought.for_each(|place| all[self.origins[place].source as usize].push(place));
        all
    }

    /// The runs in the order of the tasks.
    pub fn into_rows(self) -> Vec<Row> {
        self.rows.into_iter().flatten().collect()
    }
}
