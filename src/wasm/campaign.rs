//! Comparisons that many computers do: a tab's shard of the runs, and the journals of the others.

use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use super::arguments::{Bytes, Number, Text};
use super::comparison::{Comparison, DoneRun};
use super::{Answer, object, throw};
use crate::comparison::{MAX_SHARDS, Row, Shard, Timed};
use crate::formats::journal::{self, JournalFault, JournalLines};

/// Most faults of a journal that are told one by one.
const MOST_FAULTS: usize = 20;

/// A line of a journal that does not hold.
#[derive(Serialize, Tsify)]
pub struct LineFault {
    /// Which one; the first one is its head.
    pub line: usize,
    /// What is wrong with it.
    pub fault: JournalFault,
}

/// What became of a journal. Its runs are kept only where nothing in it is wrong.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct TakenJournal {
    /// Whose runs these are, as `I/N`; null where the journal is no shard's.
    pub shard: Option<String>,
    /// Runs that were not there yet.
    pub new: usize,
    /// Runs that were there, the same bit for bit.
    pub same: usize,
    /// The places of the runs that are there and say something else: the first ones.
    pub unlike: Vec<usize>,
    /// How many of those there are.
    pub unlike_count: usize,
    /// What does not hold: the first lines.
    pub faults: Vec<LineFault>,
    /// How many of those there are.
    pub fault_count: usize,
    /// Whether it ends in the middle of a line, as a process leaves it that was killed; that run is missing then.
    pub is_cut: bool,
    /// The new runs, where they were kept.
    pub runs: Vec<DoneRun>,
}

/// The digest of the comparison whose runs a journal says to have; null where it is no journal.
#[wasm_bindgen]
pub fn journal_digest(journal: &Bytes) -> Answer<Option<String>> {
    Ok(journal::digest_in(&journal.read("journal")?))
}

/// Most shards that a comparison is dealt to.
#[wasm_bindgen]
pub fn most_shards() -> u32 {
    MAX_SHARDS
}

#[wasm_bindgen]
impl Comparison {
    /// The places of the tasks that a shard gets; `shard` is `I/N`, such as `3/30`. Throws where there is no such shard.
    pub fn dealt(&self, shard: &Text) -> Answer<Vec<u32>> {
        Ok(self.inner.dealt(self::shard(shard)?).into_iter().map(|place| place as u32).collect())
    }

    /// The journal of the runs that were done here, which `formicarium compare --merge` and [`Comparison::take_journal`] read: of a shard's
    /// alone where one is named.
    pub fn journal(&self, shard: Option<Text>) -> Answer<String> {
        let shard = shard.as_ref().map(self::shard).transpose()?;
        let lines = JournalLines::of(&self.inner, shard);
        let places = shard.map_or_else(|| (0..lines.tasks().len()).collect(), |shard| self.inner.dealt(shard));
        let done = places.iter().filter_map(|place| self.done.get(place));
        Ok(done.fold(lines.head(), |text, timed| text + &lines.line(&timed.row)))
    }

    /// What a journal's file is called without its ending, after the comparison's own name: digest and shard.
    pub fn journal_name(&self, shard: &Text) -> Answer<String> {
        let shard = self::shard(shard)?;
        Ok(format!("{}.shard-{}of{}", self.digest(), shard.index(), shard.of()))
    }

    /// Takes in a journal of runs that somebody else has done. None of them is kept where a line does not hold, or says something else than a
    /// run that is there.
    pub fn take_journal(&mut self, text: &Text) -> Answer<Ts<TakenJournal>> {
        let text = text.read("text")?;
        let (mut taken, rows) = self.read_journal(text.as_bytes());
        if taken.fault_count == 0 && taken.unlike_count == 0 {
            for (place, row) in rows {
                let found = row.found.is_some();
                taken.runs.push(DoneRun { index: place as u32, row: row.to_line(), seconds: Vec::new(), found });
                self.brought.insert(place, row.clone());
                self.done.insert(place, Timed { row, seconds: Vec::new() });
            }
        }
        Ok(object(&taken))
    }

    /// Lets go of a run, as if it had never been done; without effect where it was not.
    pub fn forget(&mut self, index: &Number) -> Answer<()> {
        let index = index.whole("index")? as usize;
        self.brought.remove(&index);
        self.again.remove(&index);
        self.done.remove(&index);
        Ok(())
    }
}

impl Comparison {
    /// What a journal says, and the runs in it that are not there yet.
    fn read_journal(&self, text: &[u8]) -> (TakenJournal, Vec<(usize, Row)>) {
        let lines = JournalLines::of(&self.inner, None);
        let mut taken = TakenJournal {
            shard: None,
            new: 0,
            same: 0,
            unlike: Vec::new(),
            unlike_count: 0,
            faults: Vec::new(),
            fault_count: 0,
            is_cut: false,
            runs: Vec::new(),
        };
        let mut rows = Vec::new();
        let mut pieces = text.split_inclusive(|&byte| byte == b'\n').enumerate();
        match lines.read_head(pieces.next().map_or(&[], |(_, line)| line)) {
            Ok(shard) => taken.shard = shard.map(|shard| shard.to_string()),
            Err(fault) => {
                taken.note(1, fault);
                return (taken, rows);
            }
        }
        for (index, line) in pieces {
            match lines.read_line(line) {
                Ok((place, row)) => match self.done.get(&place) {
                    None => rows.push((place, row)),
                    Some(known) if known.row.to_line() == row.to_line() => taken.same += 1,
                    Some(_) => taken.differs(place),
                },
                Err(JournalFault::Cut) => taken.is_cut = true,
                Err(fault) => taken.note(index + 1, fault),
            }
        }
        rows.sort_by_key(|(place, _)| *place);
        let twice: Vec<usize> = rows
            .windows(2)
            .filter(|two| two[0].0 == two[1].0 && two[0].1.to_line() != two[1].1.to_line())
            .map(|two| two[0].0)
            .collect();
        twice.into_iter().for_each(|place| taken.differs(place));
        rows.dedup_by_key(|(place, _)| *place);
        taken.new = rows.len();
        (taken, rows)
    }
}

impl TakenJournal {
    fn note(&mut self, line: usize, fault: JournalFault) {
        self.fault_count += 1;
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(LineFault { line, fault });
        }
    }

    fn differs(&mut self, place: usize) {
        self.unlike_count += 1;
        if self.unlike.len() < MOST_FAULTS {
            self.unlike.push(place);
        }
    }
}

fn shard(text: &Text) -> Answer<Shard> {
    text.read("shard")?.parse().map_err(throw)
}
