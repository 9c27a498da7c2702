//! What runs trade off: fronts and hypervolumes of each map, as CSV, Markdown and LaTeX.

use serde::Serialize;

use super::escape::prose;
use super::latex::{self, Table};
use super::names::{impossible_note, name};
use super::numbers::{percent, short};
use super::printed::{Cell, markdown_row, sentence};
use super::words::Words;
use crate::comparison::Comparison;
use crate::comparison::analysis::{Analysis, EntryAnalysis, MapAnalysis};
use crate::comparison::measure::RunMeasure;
use crate::comparison::pareto::{EntryFront, FrontPoint, MapFronts};

/// One point of an entry on a map, with what its front comes to; an entry without points has one line.
#[derive(Debug, Serialize)]
struct Line<'a> {
    instance: &'a str,
    entry: &'a str,
    runs: usize,
    points: usize,
    own: usize,
    joint: usize,
    alone: usize,
    share: Option<f64>,
    hypervolume: Option<f64>,
    beyond: usize,
    impossible: usize,
    first_measure: RunMeasure,
    second_measure: RunMeasure,
    third_measure: Option<RunMeasure>,
    first_reference: Option<f64>,
    second_reference: Option<f64>,
    third_reference: Option<f64>,
    first: Option<f64>,
    second: Option<f64>,
    third: Option<f64>,
    point_runs: Option<u32>,
    on_own: Option<bool>,
    on_joint: Option<bool>,
}

/// How such a file begins.
pub const FRONTS_BEGIN: &str = "instance,entry,runs,points,own,joint,alone,share,hypervolume,";

/// One line a point.
pub(super) fn csv(comparison: &Comparison, all: &[MapFronts]) -> String {
    let mut lines = Vec::new();
    for map in all {
        for entry in &map.entries {
            lines.extend(entry.points.is_empty().then(|| line(comparison, map, entry, None)));
            lines.extend(entry.points.iter().map(|point| line(comparison, map, entry, Some(point))));
        }
    }
    super::csv::of_lines(lines)
}

fn line<'a>(comparison: &'a Comparison, map: &MapFronts, e: &EntryFront, point: Option<&FrontPoint>) -> Line<'a> {
    let question = &comparison.question;
    let value = |place: usize| point.and_then(|p| p.values.get(place).copied());
    let reference = |place: usize| map.reference.get(place).copied();
    Line {
        instance: &question.instances[map.instance].id,
        entry: &question.entries[e.entry].id,
        runs: e.runs,
        points: e.points.len(),
        own: e.own,
        joint: e.joint,
        alone: e.alone,
        share: e.share,
        hypervolume: e.hypervolume,
        beyond: e.beyond,
        impossible: e.impossible,
        first_measure: map.measures[0],
        second_measure: map.measures[1],
        third_measure: map.measures.get(2).copied(),
        first_reference: reference(0),
        second_reference: reference(1),
        third_reference: reference(2),
        first: value(0),
        second: value(1),
        third: value(2),
        point_runs: point.map(|p| p.runs),
        on_own: point.map(|p| p.own),
        on_joint: point.map(|p| p.joint),
    }
}

/// A table a map, as Markdown; the largest hypervolume is bold.
pub(super) fn markdown(words: &Words, comparison: &Comparison, analysis: &Analysis, all: &[MapFronts]) -> String {
    let (said, signs) = (&words.fronts, &words.signs);
    let title = (said.title)(&prose(&comparison.question.title));
    let setting = super::setting_of(words, comparison, analysis);
    let mut out = format!("# {title}\n\n{setting}\n\n{}{}\n", sentence(said.about), signs.end);
    for (fronts, map) in all.iter().zip(&analysis.instances) {
        out += &format!("\n## {}\n\n{}{}\n\n", prose(&map.name), sentence(&told(words, fronts)), signs.end);
        let head = columns(words).map(Cell::from);
        out += &format!("{}|{}\n", markdown_row(&head), "---|".repeat(head.len()));
        rows(words, fronts, map).iter().for_each(|row| out += &markdown_row(row));
        notes(words, fronts, map).iter().for_each(|note| out += &format!("\n- {}{}", prose(note), signs.end));
        out = out.trim_end().to_owned() + "\n";
    }
    out
}

/// The same as LaTeX.
pub(super) fn latex(words: &Words, comparison: &Comparison, analysis: &Analysis, all: &[MapFronts], command: &str) -> String {
    let setting = super::setting_of(words, comparison, analysis);
    let mut out = latex::head(words, command);
    for (fronts, map) in all.iter().zip(&analysis.instances) {
        let mut said = vec![comparison.question.title.clone(), (words.signs.about)(&map.name, &told(words, fronts))];
        said.push(sentence(words.fronts.about));
        said.extend(notes(words, fronts, map));
        let (head, rows) = (columns(words), rows(words, fronts, map));
        let table = Table { id: &format!("fronts:{}", map.id), head: &head, rows: &rows, last_apart: true };
        out += &latex::environment(&table, &latex::caption(words, said, &setting));
    }
    out
}

fn columns(words: &Words) -> [String; 6] {
    words.fronts.columns.map(String::from)
}

/// Over what, and against which point.
fn told(words: &Words, fronts: &MapFronts) -> String {
    let said = &words.fronts;
    let names = fronts.measures.iter().map(|&measure| (words.names.measure)(measure));
    let sides: Vec<String> = names.clone().zip(&fronts.more_is_better).map(|(name, &more)| (said.side)(name, more)).collect();
    let at = names.zip(&fronts.reference).map(|(name, &value)| format!("{name} {}", short(value)));
    (said.measures)(&sides.join(words.signs.list), &at.collect::<Vec<_>>().join(words.signs.list))
}

/// Every entry, and all of them together.
fn rows(words: &Words, fronts: &MapFronts, map: &MapAnalysis) -> Vec<Vec<Cell>> {
    let most = fronts.entries.iter().filter_map(|e| e.hypervolume).reduce(f64::max);
    let row = |(e, of): (&EntryFront, &EntryAnalysis)| {
        let text = |text: String| Cell::from(text);
        let volume = Cell { best: most.is_some() && e.hypervolume == most, ..text(volume(e.hypervolume)) };
        let joint = (words.fronts.alone)(e.joint, e.alone);
        let share = e.share.map_or_else(|| "–".into(), |share| percent(words, share));
        let told = (words.signs.part_of)(e.told, e.runs);
        vec![text(name(words, of).into_owned()), text(told), text(e.own.to_string()), text(joint), text(share), volume]
    };
    let mut rows: Vec<Vec<Cell>> = fronts.entries.iter().zip(&map.entries).map(row).collect();
    let [told, runs] = [|e: &EntryFront| e.told, |e: &EntryFront| e.runs].map(|of| fronts.entries.iter().map(of).sum());
    let points = fronts.joint_points.to_string();
    let all = [words.fronts.all.into(), (words.signs.part_of)(told, runs), points.clone(), points, "–".into()];
    rows.push(all.into_iter().chain([volume(fronts.joint_hypervolume)]).map(Cell::from).collect());
    rows
}

fn volume(of: Option<f64>) -> String {
    of.map_or_else(|| "–".into(), |part| format!("{part:.4}"))
}

/// What must be known beside the table.
fn notes(words: &Words, fronts: &MapFronts, map: &MapAnalysis) -> Vec<String> {
    let beyond = |(e, of): (&EntryFront, &EntryAnalysis)| (e.beyond > 0).then(|| (words.fronts.beyond)(e.beyond, &of.label));
    let mut notes: Vec<String> = fronts.entries.iter().zip(&map.entries).filter_map(beyond).collect();
    let impossible = impossible_note(words, map);
    notes.extend((!impossible.is_empty()).then(|| format!("{impossible}{}{}", words.signs.comma, words.fronts.left_out)));
    notes
}
