//! `page`: a session or comparison as a page of its own, one file with the whole program inside.
//!
//! The page is a template, `one-file.html` as `cargo xtask build` makes it or any page that was saved: of it the title and what it carries
//! are replaced. docs/formats.md describes both; the page writes the same (`www/src/share/page_file.ts`).

use std::env;
use std::path::{Path, PathBuf};

use serde_json::Value as Json;

use crate::error::{Error, FormatError};
use crate::formats::session::{has_session_link, read_session, session_link_in};
use crate::formats::{Kind, MAX_TEXT_BYTES, comparison_json, recognise};

use super::error::CliError;
use super::streams::say;
use super::{Outcome, input, output};

/// Makes a page of one file that opens without a network, verifies what it carries and can be edited
#[derive(clap::Args)]
#[command(after_help = "\
FILE: a session or comparison as the page or `compare` saves it, or a text with a session's link. The page has the whole program inside and
opens by a double click; docs/one_file.md tells what it can do.

The template is the file named by --page, else by the variable FORMICARIUM_PAGE, else one-file.html beside this program, else
www/dist/one-file.html below the current folder. Any page that \"Save as a page\" has made is one.

Examples:
  formicarium page race.experiment.json > lesson.html
  formicarium page study.result.json --page saved.html --out study.html")]
pub struct Args {
    /// What the page carries
    file: PathBuf,
    /// The page to put it into
    #[arg(long, value_name = "TEMPLATE")]
    page: Option<PathBuf>,
    /// Where to write it [default: standard output]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// The engine of this command line.
const VERSION: &str = env!("CARGO_PKG_VERSION");
/// The variable that names a template.
const VARIABLE: &str = "FORMICARIUM_PAGE";
const TEMPLATE_NAME: &str = "one-file.html";
/// A page that carries the largest file, and its program.
const MOST_BYTES: u64 = 2 * MAX_TEXT_BYTES as u64;

const TITLE: (&str, &str) = ("<title>", "</title>");
const CARRIED: (&str, &str) = ("<script type=\"application/json\" id=\"carried\"", "</script>");
const FORMAT: &str = "data-format=\"formicarium/page@1\"";
const FROM: (&str, &str) = ("data-from=\"", "\"");
/// By which engine a template was made.
const ENGINE: (&str, &str) = ("content=\"Formicarium ", "\"");

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    output::check(args.out.as_deref())?;
    let carried = input::in_file(&args.file, MAX_TEXT_BYTES, read)?;
    let template = args.template()?;
    carried.compare_with(engine_of(&template));
    output::write(args.out.as_deref(), carried.on(&template).as_bytes())?;
    Ok(Outcome::fine(String::new()))
}

impl Args {
    fn template(&self) -> Result<String, CliError> {
        let path = self.page.clone().or_else(|| env::var_os(VARIABLE).map(PathBuf::from)).or_else(nearest);
        let Some(path) = path else {
            return Err(CliError::usage(format!("there is no {TEMPLATE_NAME} to make the page of"), how_to_get_one()));
        };
        let bytes = input::bytes(&path, MOST_BYTES)?;
        let text = String::from_utf8_lossy(&bytes);
        if [FORMAT, TITLE.0, CARRIED.0].iter().all(|mark| text.contains(mark)) {
            return Ok(text.into_owned());
        }
        Err(CliError::usage(format!("{} is no page of one file that this version can fill", path.display()), how_to_get_one()))
    }
}

fn how_to_get_one() -> String {
    format!(
        "name a page by --page or {VARIABLE}: one that \"Save as a page\" of the share dialog has made, or {TEMPLATE_NAME} of a hosted or \
         built page (`cargo xtask build` puts it into www/dist)"
    )
}

/// Beside the program, or where the page has been built.
fn nearest() -> Option<PathBuf> {
    let beside = env::current_exe().ok().map(|program| program.with_file_name(TEMPLATE_NAME));
    let built = Path::new("www/dist").join(TEMPLATE_NAME);
    [beside, Some(built)].into_iter().flatten().find(|path| path.is_file())
}

/// What a page is to carry.
struct Carried {
    /// What it is called; may be empty.
    title: String,
    /// The version that recorded its results; empty where that is not told.
    engine: String,
    /// A file of JSON, or a link as a text of JSON.
    text: String,
}

fn read(bytes: &[u8], name: &str) -> Result<Carried, Error> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}').trim();
    if text.contains(FORMAT) {
        let expected = "what it carries: open it in a browser and save that as a file";
        return Err(FormatError::syntax(0, "this is a page of one file already", expected).into());
    }
    if has_session_link(text) && !text.starts_with('{') {
        let (link, session) = session_link_in(text)?;
        return Ok(Carried { title: session.spec.name, engine: session.engine, text: Json::from(link).to_string() });
    }
    match recognise(bytes, name)?.kind {
        Kind::Session => {
            let engine = read_session(text)?.engine;
            check_words(text)?;
            Ok(Carried { title: title_of_session(text), engine, text: text.into() })
        }
        Kind::Comparison => {
            let opened = comparison_json::open(text)?;
            let engine = opened.recorded.map(|recorded| recorded.engine).unwrap_or_default();
            Ok(Carried { title: opened.comparison.question.title.clone(), engine, text: text.into() })
        }
        other => {
            let found = format!("this is {}", other.name());
            Err(FormatError::syntax(0, found, "a session or comparison as the page saves it, or a text with a session's link")
                .into())
        }
    }
}

/// What the page says of a session that its runs do not depend on, so that no page is made that refuses what it carries: most characters of
/// its title, its note and each panel's label (`www/src/model/names.ts`).
const LONGEST: [(&str, usize); 3] = [("title", 120), ("note", 2000), ("label", 60)];

/// Refuses words that the page would refuse.
fn check_words(text: &str) -> Result<(), Error> {
    let fields: Json = serde_json::from_str(text).unwrap_or_default();
    let [title, note, label] = LONGEST;
    let panels = fields["panels"].as_array().map(Vec::as_slice).unwrap_or_default();
    let labels = panels.iter().map(|panel| (label, &panel[label.0]));
    for ((field, most), value) in [title, note].map(|own| (own, &fields[own.0])).into_iter().chain(labels) {
        let is_text = value.is_null() || value.is_string();
        // As JavaScript counts.
        if !is_text || value.as_str().is_some_and(|words| words.encode_utf16().count() > most) {
            let found = value.to_string();
            return Err(FormatError::field(field, found, format!("a text of at most {most} characters")).into());
        }
    }
    Ok(())
}

/// Its own, or its map's.
fn title_of_session(text: &str) -> String {
    let fields: Json = serde_json::from_str(text).unwrap_or_default();
    let named = |field: &Json| field.as_str().filter(|name| !name.is_empty()).map(String::from);
    named(&fields["title"]).or_else(|| named(&fields["scenario"]["name"])).unwrap_or_default()
}

impl Carried {
    /// Says where versions differ: the page repeats the runs with its own engine.
    fn compare_with(&self, page: &str) {
        if page != VERSION {
            say(format!("note: the page runs engine {page}, this command line is {VERSION}"));
        }
        if !self.engine.is_empty() && self.engine != page {
            say(format!(
                "note: the page runs engine {page}, the results were recorded by {}: they may come out otherwise",
                self.engine
            ));
        }
    }

    /// The template with this in it.
    fn on(&self, template: &str) -> String {
        let title = if self.title.is_empty() { "Formicarium".into() } else { format!("{} · Formicarium", self.title) };
        let named = replaced(template, TITLE, &format!("{}{}", TITLE.0, escaped(&title)));
        // The address that a saved page came from stays: links lead there.
        let from = within(&template[template.find(CARRIED.0).unwrap_or(0)..], FROM);
        // In JSON this sign stands in texts alone, and none of them may end the element.
        let text = self.text.replace('<', "\\u003c");
        replaced(&named, CARRIED, &format!("{} {FORMAT} {}{from}{}>{text}", CARRIED.0, FROM.0, FROM.1))
    }
}

fn engine_of(template: &str) -> &str {
    within(template, ENGINE)
}

/// What stands between two marks for the first time.
fn within<'a>(text: &'a str, (begin, end): (&str, &str)) -> &'a str {
    let rest = text.split_once(begin).map_or("", |(_, rest)| rest);
    rest.split_once(end).map_or(rest, |(inside, _)| inside)
}

/// Up to the end of what stood there.
fn replaced(page: &str, (begin, end): (&str, &str), by: &str) -> String {
    let at = page.find(begin).unwrap_or(0);
    let rest = &page[at..];
    [&page[..at], by, &rest[rest.find(end).unwrap_or(0)..]].concat()
}

/// As browsers write texts out.
fn escaped(text: &str) -> String {
    [("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\"", "&quot;"), ("\u{a0}", "&nbsp;")]
        .iter()
        .fold(text.to_owned(), |text, (sign, name)| text.replace(sign, name))
}
