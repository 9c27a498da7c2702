//! A drawing that stands alone: walls, start, goals, the path, a scale. Its unit is a cell, and the points of its line are the path's cells, so that it
//! is read back.

use std::fmt::Write;

use super::{ANY_VERSION, CURVE, FORMAT, PlannedPath, ReadPath, check_version, kind_of, svg_walls, with_levels};
use crate::error::FormatError;
use crate::formats::text::quote;
use crate::map::Point;
use crate::scenario::ScenarioSpec;

/// The attribute that holds [`FORMAT`].
const MARK: &str = "data-format=\"";

/// The beginning of the line's element.
const LINE: &str = "<polyline";

const INK: &str = "#2b2f36";
const PATH: &str = "#0b69c7";
const START: &str = "#1a7f37";
const GOAL: &str = "#c4281c";

/// What is read.
const EXPECTED: &str = "the drawing as `plan --format svg` writes it, with whole numbers `x,y` as the points of its line";

pub(super) fn write(path: &PlannedPath<'_>) -> String {
    let PlannedPath { grid, spec, .. } = path;
    let (width, height) = (grid.width(), grid.height());
    let letter = letter(spec);
    // Below the map there is room for the scale.
    let below = f64::from(height) + 2.5 * letter;
    let size = (960.0 / f64::from(width)).clamp(0.25, 32.0);
    let (shown_width, shown_height) = (f64::from(width) * size, below * size);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" {MARK}{FORMAT}\" width=\"{shown_width:.0}\" height=\"{shown_height:.0}\" viewBox=\"0 0 {width} {below}\">\n"
    );
    let _ = writeln!(out, "<title>{}</title>", escaped(&spec.name));
    let _ = writeln!(out, "<rect width=\"{width}\" height=\"{below}\" fill=\"#fff\"/>");
    let _ = writeln!(out, "<path fill=\"{INK}\" d=\"{}\"/>", svg_walls::commands(grid));
    // The middle of a cell is half a cell from its corner.
    out += "<g transform=\"translate(.5 .5)\">\n";
    line(path, &mut out, letter);
    ends(spec, &mut out, letter);
    out += "</g>\n";
    scale(spec, &mut out, letter);
    out + "</svg>\n"
}

/// The height of letters, in cells.
fn letter(spec: &ScenarioSpec) -> f64 {
    (f64::from(spec.width.max(spec.height)) / 40.0).max(0.4)
}

fn line(path: &PlannedPath<'_>, out: &mut String, letter: f64) {
    let points: Vec<String> = match &path.curve {
        Some(curve) => curve.points.iter().map(|[x, y]| format!("{x},{y}")).collect(),
        None => path.cells.iter().map(|at| format!("{},{}", at.x, at.y)).collect(),
    };
    let _ = write!(out, "{LINE} data-kind=\"{}\" points=\"{}\"", path.kind, points.join(" "));
    if let Some(levels) = &path.levels {
        let levels: Vec<String> = levels.iter().map(u32::to_string).collect();
        let _ = write!(out, " data-levels=\"{}\"", levels.join(" "));
    }
    let width = (letter / 3.0).clamp(0.15, 4.0);
    let _ = writeln!(
        out,
        " fill=\"none\" stroke=\"{PATH}\" stroke-width=\"{width}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>"
    );
}

/// A disc at the start, a ring at each goal.
fn ends(spec: &ScenarioSpec, out: &mut String, letter: f64) {
    let radius = letter.max(0.7) / 2.0;
    let Point { x, y } = spec.start;
    let _ = writeln!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{START}\"><title>start</title></circle>");
    for goal in &spec.goals {
        let name = if goal.name.is_empty() { "goal" } else { &goal.name };
        let (Point { x, y }, width, name) = (goal.at, radius / 2.0, escaped(name));
        let _ = writeln!(
            out,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"#fff\" stroke=\"{GOAL}\" stroke-width=\"{width}\"><title>{name}</title></circle>"
        );
    }
}

/// A bar of a round number of metres, at most a third of the map.
fn scale(spec: &ScenarioSpec, out: &mut String, letter: f64) {
    let metres = round_length(f64::from(spec.width) * spec.resolution / 3.0);
    let (cells, y) = (metres / spec.resolution, f64::from(spec.height) + letter);
    let _ = writeln!(
        out,
        "<path fill=\"none\" stroke=\"{INK}\" stroke-width=\"{}\" d=\"M{} {y}v{}h{cells}v-{}\"/>",
        letter / 8.0,
        letter / 2.0,
        letter / 2.0,
        letter / 2.0
    );
    let _ = writeln!(
        out,
        "<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{letter}\" fill=\"{INK}\">{metres} m</text>",
        cells + letter,
        y + letter / 2.0
    );
}

/// The largest of 1, 2 and 5 times a power of ten that is no longer.
fn round_length(most: f64) -> f64 {
    let power = libm::floor(libm::log10(most));
    let ten = |factor: f64| if power < 0.0 { factor / libm::pow(10.0, -power) } else { factor * libm::pow(10.0, power) };
    [5.0, 2.0].into_iter().map(ten).find(|&length| length <= most).unwrap_or_else(|| ten(1.0))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Whether a text, or the first part of one, is a drawing of this program in any version.
pub(super) fn is_own(text: &str) -> bool {
    text.trim_start().starts_with('<') && element(text, "<svg").and_then(|svg| value(svg, MARK)).is_some_and(is_path)
}

fn is_path(format: &str) -> bool {
    format.starts_with(ANY_VERSION)
}

/// Reads the cells of the line.
///
/// # Errors
/// [`FormatError`]: another version, or a line that is none in cells.
pub(super) fn read(text: &str) -> Result<ReadPath, FormatError> {
    check_version(element(text, "<svg").and_then(|svg| value(svg, MARK)).unwrap_or_default())?;
    let wrong = |what: &str| FormatError::field("polyline", what, EXPECTED);
    let line = element(text, LINE).ok_or_else(|| wrong("missing"))?;
    if value(line, "data-kind=\"") == Some(CURVE) {
        return Err(FormatError::field(
            "polyline",
            "the drawing of a curve",
            "a curve as path-csv, path-json, nav-msgs or geojson",
        ));
    }
    let points = value(line, "points=\"").ok_or_else(|| wrong("no points"))?;
    let cells = points.split_ascii_whitespace().map(cell).collect::<Result<_, _>>()?;
    let levels = value(line, "data-levels=\"");
    let level = |word: &str| word.parse().map_err(|_| wrong(&format!("the level `{}` is none", quote(word))));
    let levels = levels.map(|levels| levels.split_ascii_whitespace().map(level).collect::<Result<_, _>>()).transpose()?;
    Ok(ReadPath { places: with_levels(cells, levels)?, kind: kind_of(value(line, "data-kind=\"")) })
}

fn cell(point: &str) -> Result<Point, FormatError> {
    let both = point.split_once(',').and_then(|(x, y)| Some(Point::new(x.parse().ok()?, y.parse().ok()?)));
    both.ok_or_else(|| FormatError::field("polyline", format!("`{}` is no cell", quote(point)), EXPECTED))
}

/// The first element that begins so, up to its end.
fn element<'a>(text: &'a str, begin: &str) -> Option<&'a str> {
    let from = text.find(begin)?;
    text[from..].split('>').next()
}

/// The value of an attribute.
fn value<'a>(element: &'a str, attribute: &str) -> Option<&'a str> {
    element.split_once(attribute)?.1.split_once('"').map(|(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_a_round_number() {
        for (most, round) in [(1.0, 1.0), (1.99, 1.0), (2.0, 2.0), (49.0, 20.0), (73.0, 50.0), (0.07, 0.05), (0.012, 0.01)] {
            assert_eq!(round_length(most), round, "{most}");
        }
    }

    #[test]
    fn names_are_texts() {
        assert_eq!(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
    }
}
