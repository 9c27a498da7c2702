//! `submit`: is this better than the best known?

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::catalog;
use crate::comparison::best_known::{ClaimedPath, Measured, Standing, check_bound};
use crate::comparison::gap::relative_gap;
use crate::error::BestKnownError;
use crate::exact::Reference;
use crate::formats::session::{Panel, Session, has_session_link, read_session, read_session_link};
use crate::formats::{MAX_TEXT_BYTES, path_kind, read_places};
use crate::path::PathKind;
use crate::planner::Objective;
use crate::scenario::Scenario;
use clap::ValueEnum;

use super::error::CliError;
use super::tracker::entry::{self, Entry, Head, outside_name};
use super::tracker::folder::{Tracked, Tracker, best};
use super::tracker::{Proof, Where, check_session};
use super::{Outcome, input, text, text::row};

/// Checks a claim to be better than the best known, and makes an entry of it
#[derive(clap::Args)]
#[command(after_help = "\
The claim: a link of the page's share dialog, or its session file: every recorded run is repeated; or the path of a planner from elsewhere, as
`check` reads it. What holds and is better becomes a file of the tracker; docs/tracker.md says what happens with it.

Examples:
  formicarium submit 'https://example.org/formicarium/#x=Aa1Ry27b…' --by 'Ada'
  formicarium submit race.experiment.json --by 'Ada' --dry-run
  formicarium submit path.csv --scenario ship-20x20 --planner my-planner --by 'Ada'

Exit code 1 when a claim does not hold.")]
pub struct Args {
    /// A session's link or file, or a path
    claim: String,
    /// Who has found it; the entry's file is called by it
    #[arg(long, value_name = "NAME", value_parser = entry::one_line, default_value = "")]
    by: String,
    /// How it was found, in a sentence
    #[arg(long, value_name = "TEXT", value_parser = entry::one_line, default_value = "")]
    note: String,
    /// The scenario; a session tells it by its map
    #[arg(long, value_name = "ID")]
    scenario: Option<String>,
    /// Paths: what to call their planner
    #[arg(long, value_name = "NAME")]
    planner: Option<String>,
    /// Paths: what measures them [default: by kind of path and map]
    #[arg(long, value_enum, value_name = "ID")]
    objective: Option<MeasuredBy>,
    /// Paths: their points are joined by straight segments in line of sight, not by steps
    #[arg(long)]
    polyline: bool,
    /// The day [default: today]
    #[arg(long, value_name = "YYYY-MM-DD", value_parser = entry::date)]
    date: Option<String>,
    #[command(flatten)]
    tracker: Where,
    /// Says what would be written
    #[arg(long)]
    dry_run: bool,
}

/// Most panels that are repeated: the page has far fewer.
const MOST_PANELS: usize = 64;

/// What may measure a path.
#[derive(Clone, Copy, ValueEnum)]
enum MeasuredBy {
    Length,
    TurnIndex,
    PolylineLength,
    SliceCost,
    TourLength,
}

impl From<MeasuredBy> for Objective {
    fn from(by: MeasuredBy) -> Self {
        match by {
            MeasuredBy::Length => Self::Length,
            MeasuredBy::TurnIndex => Self::TurnIndex,
            MeasuredBy::PolylineLength => Self::PolylineLength,
            MeasuredBy::SliceCost => Self::SliceCost,
            MeasuredBy::TourLength => Self::TourLength,
        }
    }
}

/// What is claimed, on the scenario that it belongs to.
struct Claims<'a> {
    tracked: &'a Tracked,
    /// Each with the planner that it names.
    proofs: Vec<(String, Proof)>,
    /// Planners of recorded runs that have no path yet.
    silent: Vec<String>,
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let tracker = args.tracker.open()?;
    let claims = args.claims(&tracker)?;
    let tracked = claims.tracked;
    let mut report = Report { text: format!("{} ({})\n\n", tracked.id, tracked.about), fine: true, written: Vec::new() };
    for (planner, proof) in claims.proofs {
        match proof.measure(tracked, &planner) {
            Ok(measured) => args.keep(&tracker, tracked, (planner, measured, proof), &mut report)?,
            Err(error) => report.refuse(&planner, &error),
        }
    }
    claims.silent.iter().for_each(|planner| report.pass_over(planner));
    report.next(args.dry_run);
    Ok(Outcome { text: report.text, fine: report.fine })
}

impl Args {
    fn claims<'a>(&self, tracker: &'a Tracker) -> Result<Claims<'a>, CliError> {
        if has_session_link(&self.claim) || (is_payload(&self.claim) && !Path::new(&self.claim).exists()) {
            return self.session(tracker, &read_session_link(&self.claim)?);
        }
        let file = Path::new(&self.claim);
        let content = input::in_file(file, MAX_TEXT_BYTES, |bytes, _| {
            let text = String::from_utf8_lossy(bytes);
            Ok(if has_session_link(&text) && !text.trim_start().starts_with('{') {
                Content::Session(Box::new(read_session_link(&text)?))
            } else if text.contains("formicarium/experiment@") {
                Content::Session(Box::new(read_session(&text)?))
            } else {
                Content::Path(ClaimedPath { kind: path_kind(bytes), places: read_places(bytes)? })
            })
        })?;
        match content {
            Content::Session(session) => self.session(tracker, &session),
            Content::Path(path) => self.path(tracker, path),
        }
    }

    fn session<'a>(&self, tracker: &'a Tracker, session: &Session) -> Result<Claims<'a>, CliError> {
        check_session(session)?;
        let scenario = Scenario::new(session.grid.clone(), session.spec.clone())?;
        let tracked = tracker.same_as(&scenario)?;
        if let Some(asked) = self.scenario.as_ref().filter(|asked| **asked != tracked.id) {
            let message = format!("the session is on {}, not on {asked}", tracked.id);
            return Err(CliError::usage(message, "leave out --scenario: the map tells it"));
        }
        let alone = |panel: &Panel| Session { panels: vec![panel.clone()], ..session.clone() };
        let (mut proofs, mut silent) = (Vec::new(), Vec::new());
        for (panel, run) in session.panels.iter().filter_map(|panel| Some((panel, panel.result.as_ref()?))) {
            match run.length {
                Some(_) => proofs.push((panel.planner.clone(), Proof::Run(Box::new(alone(panel))))),
                None => silent.push(panel.planner.clone()),
            }
        }
        if session.panels.len() > MOST_PANELS {
            let message = format!("the session has {} panels", session.panels.len());
            return Err(CliError::usage(message, format!("submit one with at most {MOST_PANELS}")));
        }
        if proofs.is_empty() { Err(BestKnownError::NoRun.into()) } else { Ok(Claims { tracked, proofs, silent }) }
    }

    fn path<'a>(&self, tracker: &'a Tracker, path: ClaimedPath) -> Result<Claims<'a>, CliError> {
        let (Some(id), Some(planner)) = (&self.scenario, &self.planner) else {
            let hint = "say on which map, and what to call its planner: --scenario ID --planner NAME";
            return Err(CliError::usage("a path does not say what it is a claim for", hint));
        };
        let is_name =
            !planner.is_empty() && planner.split('-').all(|p| !p.is_empty() && p.bytes().all(|b| b.is_ascii_alphanumeric()));
        if !is_name || catalog::find(&planner.to_ascii_lowercase()).is_ok() {
            let message = format!("`{planner}` cannot name a planner from elsewhere");
            return Err(CliError::usage(
                message,
                "take letters, digits and single hyphens; a planner of the catalog is proven by its run: the page's link or session, or \
                 `formicarium tracker run --planner … --set …`",
            ));
        }
        let tracked = tracker.scenario(id)?;
        let kind = if self.polyline { PathKind::Polyline } else { path.kind };
        let path = ClaimedPath { kind, ..path };
        let objective = self.objective.map_or_else(|| path.usual_objective(&tracked.scenario), Objective::from);
        Ok(Claims { tracked, proofs: vec![(planner.clone(), Proof::Path(path, objective))], silent: Vec::new() })
    }

    /// Tells how a claim that holds stands, and writes it where it is the best.
    fn keep(
        &self,
        tracker: &Tracker,
        tracked: &Tracked,
        (planner, measured, proof): (String, Measured, Proof),
        report: &mut Report,
    ) -> Result<(), CliError> {
        let entries = tracker.entries(&tracked.id)?;
        let reference = tracked.reference(measured.objective);
        let is_same = |entry: &&Entry| {
            entry.planner == planner && entry.objective == measured.objective && check_bound(entry.value, reference).is_ok()
        };
        let known = best(entries.iter().filter(is_same));
        let standing = Standing::of(measured.value, known.map(|entry| entry.value));
        let objective = text::objective(measured.objective, &tracked.scenario);
        report.tell(&planner, (objective, measured.value), standing, known, reference);
        if !standing.wins() {
            return Ok(());
        }
        let Measured { objective, value } = measured;
        if self.dry_run && self.by.is_empty() {
            report.written.push(tracker.place(&tracked.id, &format!("{planner}--NAME")));
            return Ok(());
        }
        let place = self.place(tracker, tracked, &planner, objective)?;
        if self.dry_run {
            report.written.push(place);
            return Ok(());
        }
        let (by, note) = (self.by.clone(), self.note.clone());
        let date = self.date.clone().unwrap_or_else(entry::today);
        let head = Head { scenario: tracked.id.clone(), planner, objective, value, by, date, note };
        proof.into_entry(Entry::new(head))?.write(&place)?;
        report.written.push(place);
        Ok(())
    }

    /// The file of an entry; a planner that somebody claims by two measures has two.
    fn place(&self, tracker: &Tracker, tracked: &Tracked, planner: &str, objective: Objective) -> Result<PathBuf, CliError> {
        let name = outside_name(planner, &self.by)?;
        let place = tracker.place(&tracked.id, &name);
        let is_free = !place.exists() || Entry::read(&place)?.objective == objective;
        let place = if is_free { place } else { tracker.place(&tracked.id, &format!("{name}-{}", objective.id())) };
        if place.exists() && Entry::read(&place)?.by != self.by {
            let message = format!("{} is somebody else's, whose name is written alike", place.display());
            return Err(CliError::usage(message, "say by another --by who you are"));
        }
        Ok(place)
    }
}

enum Content {
    Session(Box<Session>),
    Path(ClaimedPath),
}

/// Whether a word is what stands behind `#x=` in a link, rather than a file's name.
fn is_payload(word: &str) -> bool {
    const SHORTEST: usize = 60;
    word.len() >= SHORTEST && word.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-' || b == b'_')
}

/// What is printed.
struct Report {
    text: String,
    fine: bool,
    /// Files; with --dry-run those that would be.
    written: Vec<PathBuf>,
}

impl Report {
    fn tell(
        &mut self,
        planner: &str,
        (objective, value): (&str, f64),
        standing: Standing,
        known: Option<&Entry>,
        reference: Reference,
    ) {
        let beside = known.map_or(String::new(), |entry| format!("{:.4} of {}, {}", entry.value, entry.by, entry.date));
        let verdict = match standing {
            Standing::First => "the first value of this planner here".into(),
            Standing::Better(by) => format!("better than the best known by {}: {beside}", text::percent(by)),
            Standing::Equal => format!("equal to the best known, which was there first: {beside}"),
            Standing::Worse(by) => format!("worse than the best known by {}: {beside}", text::percent(by)),
        };
        let optimum = match reference {
            Reference::Proven { value: optimum } => {
                let gap = relative_gap(value, optimum);
                format!("{optimum:.4}, proven; the value is {} above", text::percent(gap))
            }
            Reference::Unproven { value } => format!("not proven; a good value is {value:.4}"),
            Reference::NoPath | Reference::Unknown => "not known".into(),
        };
        let _ = writeln!(self.text, "{planner}");
        row(&mut self.text, "value", format!("{value:.4}, {objective}; it holds"));
        row(&mut self.text, "verdict", verdict);
        row(&mut self.text, "optimum", optimum);
    }

    fn refuse(&mut self, planner: &str, error: &BestKnownError) {
        self.fine = false;
        let report = error.report();
        let _ = writeln!(self.text, "{planner}");
        row(&mut self.text, "refused", format!("{}: {}", report.field, report.message));
        row(&mut self.text, "hint", report.hint);
    }

    fn pass_over(&mut self, planner: &str) {
        let _ = writeln!(self.text, "{planner}");
        row(&mut self.text, "verdict", "no path yet, so nothing is claimed");
    }

    /// What to do with what was written.
    fn next(&mut self, dry_run: bool) {
        self.text.push('\n');
        if self.written.is_empty() {
            self.text += "Nothing is to be written.\n";
            return;
        }
        for file in &self.written {
            let verb = if dry_run { "would be written:" } else { "written:" };
            let _ = writeln!(self.text, "{verb} {}", file.display());
        }
        if !dry_run {
            self.text += "next: look at it, `git add` and commit it alone, and open a pull request\n";
        }
    }
}
