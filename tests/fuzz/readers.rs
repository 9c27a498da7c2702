//! Every public reader. What it accepts must be usable, and come back the same when it is written and read again.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU64, Ordering};

use formicarium::comparison::{Axis, Question, Samples, Seen, analyse};
use formicarium::error::{Error, ErrorReport};
use formicarium::formats::journal::JournalLines;
use formicarium::formats::session::Session;
use formicarium::formats::{
    self, BinaryExport, Companion, Export, Imported, PathFormat, PlannedPath, ReadOptions, TerrainOptions, comparison_json,
};
use formicarium::map::{Grid, Point, Window};
use formicarium::scenario::{Scenario, ScenarioSpec};

use crate::corpus::{FIVE_PLACES, File, placed, small};
use crate::limits::{Limits, MOST_CELLS, MOST_CELLS_PER_BYTE};
use crate::stated::stated;
use crate::watch::{Fault, watch};

/// Files that were read as maps: where hardly any are, hardly anything is tried.
pub static ACCEPTED: AtomicU64 = AtomicU64::new(0);

type Read = fn(&File) -> Result<(), Fault>;

pub struct Reader {
    pub name: &'static str,
    read: Read,
    raster: bool,
}

const fn text(name: &'static str, read: Read) -> Reader {
    Reader { name, read, raster: false }
}

const fn raster(name: &'static str, read: Read) -> Reader {
    Reader { name, read, raster: true }
}

pub const READERS: &[Reader] = &[
    raster("sniff", |file| done(formats::sniff(&file.bytes, &file.name))),
    raster("import", |file| typed(formats::import(&file.bytes, &file.name)).map(drop)),
    raster("import with costs", |file| typed(formats::import_with(&file.bytes, &file.name, &as_costs(), None)).map(drop)),
    raster("round-trip", round_trip),
    raster("what is said of it", stated),
    raster("import_piece", import_piece),
    raster("import_terrain", |file| typed(formats::import_terrain(&file.bytes, &file.name, piece())).map(drop)),
    raster("survey", |file| typed(formats::survey(&file.bytes, &file.name)).map(drop)),
    text("import_scen", import_scen),
    text("import_results", import_results),
    text("read_path", |file| typed(formats::read_path(&file.bytes).map_err(Error::from)).map(drop)),
    text("read_places", |file| typed(formats::read_places(&file.bytes).map_err(Error::from)).map(drop)),
    text("read_world_path", |file| typed(formats::read_world_path(&file.bytes).map_err(Error::from)).map(drop)),
    text("read_path_on", path_on),
    raster("list_matrices", |file| typed(formats::list_matrices(&file.bytes)).map(drop)),
    raster("unpack", |file| typed(formats::unpack(&file.bytes, &file.name).map_err(Error::from)).map(drop)),
    raster("recognise", |file| typed(formats::recognise(&file.bytes, &file.name).map_err(Error::from)).map(drop)),
    raster("picture of a ROS map", ros_picture),
    raster("description of a ROS map", |file| {
        typed(formats::ros::image_of(&file.bytes))?;
        let beside = Companion { name: "lab.pgm", bytes: b"P5\n2 2\n255\n\xfe\xcd\x00\xfe" };
        typed(formats::import_with(&file.bytes, &file.name, &ReadOptions::default(), Some(beside))).map(drop)
    }),
    raster("figure", figure),
    text("order problem", order_problem),
    text("path_kind", |file| done(formats::path_kind(&file.bytes))),
    text("read_scenario", |file| typed(formats::read_scenario(&utf8(file)).map_err(Error::from)).map(drop)),
    text("format_of", |file| done(formats::format_of(&utf8(file)))),
    text("session", |file| session(formats::session::read_session(&utf8(file)))),
    text("session link", |file| session(formats::session::read_session_link(&utf8(file)))),
    text("question", question),
    text("comparison", comparison),
    text("journal", journal),
];

impl Reader {
    pub fn check(&self, file: &File) -> Result<(), Fault> {
        let len = file.bytes.len();
        let limits = || if self.raster { Limits::raster(len, cells(file)) } else { Limits::text(len) };
        watch(self.name, limits, || (self.read)(file))
    }
}

/// The picture of a ROS map, as it stands and in fewer cells.
fn ros_picture(file: &File) -> Result<(), Fault> {
    let yaml = b"image: a.pgm\nresolution: 0.05\norigin: [-1.0, 2.0, 0.5]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";
    let beside = Companion { name: "a.pgm", bytes: &file.bytes };
    let options = ReadOptions { cells: Some(7), unknown: formats::ros::Unknown::Free, ..ReadOptions::default() };
    typed(formats::import_with(yaml, "a.yaml", &options, Some(beside)))?;
    let scaled = [&yaml[..], b"mode: scale\n"].concat();
    typed(formats::import_with(&scaled, "a.yaml", &as_costs(), Some(beside))).map(drop)
}

/// What ground costs is read where a file tells it.
fn as_costs() -> ReadOptions {
    let costs = formats::ros::Costs::by(formicarium::scenario::CostRule::Nav2Navfn);
    ReadOptions { costs: Some(costs), swamp_factor: Some(3.5), ..ReadOptions::default() }
}

fn figure(file: &File) -> Result<(), Fault> {
    let Some(picture) = typed(formats::picture::decode(&file.bytes).map_err(Error::from))? else { return Ok(()) };
    let Some(found) = typed(formats::figure::find(&picture).map_err(Error::from))? else { return Ok(()) };
    typed(formats::figure::to_map(&found.cells.classes, found.cells.columns, &file.name).map_err(Error::from)).map(drop)
}

/// What a raster honestly claims; a packed one that cannot be read to its end, and pictures and archives, what their length allows.
fn cells(file: &File) -> u64 {
    let len = file.bytes.len() as u64;
    let packed = [&b"II"[..], b"MM", b"PK", b"\x1f\x8b"].iter().any(|magic| file.bytes.starts_with(magic))
        || formats::picture::looks_like(&file.bytes);
    let most = if packed { (len * MOST_CELLS_PER_BYTE).min(MOST_CELLS) } else { 0 };
    let survey = catch_unwind(AssertUnwindSafe(|| formats::survey(&file.bytes, &file.name)));
    survey.ok().and_then(Result::ok).map_or(most, |survey| u64::from(survey.width) * u64::from(survey.height))
}

fn utf8(file: &File) -> std::borrow::Cow<'_, str> {
    String::from_utf8_lossy(&file.bytes)
}

#[expect(clippy::unnecessary_wraps, reason = "readers that accept everything stand in a list with those that do not")]
fn done<T>(_: T) -> Result<(), Fault> {
    Ok(())
}

/// A refusal must tell what is wrong and what to do.
fn typed<T>(read: Result<T, Error>) -> Result<Option<T>, Fault> {
    match read {
        Ok(value) => Ok(Some(value)),
        Err(error) => told(&error.report()).map(|()| None),
    }
}

pub fn told(report: &ErrorReport) -> Result<(), Fault> {
    if report.kind.is_empty() || report.message.is_empty() || report.hint.is_empty() {
        return Err(Fault::broken("errors have kind, message and hint", format!("{report:?}")));
    }
    if report.message.len() + report.hint.len() > 4000 {
        let begin: String = report.message.chars().take(100).collect();
        return Err(Fault::broken("errors are short", format!("{} bytes: {begin}…", report.message.len())));
    }
    Ok(())
}

/// A path that is accepted on a map can be written and read again, if it is one.
fn path_on(file: &File) -> Result<(), Fault> {
    static MAP: LazyLock<Scenario> = LazyLock::new(placed);
    let Some(read) = typed(formats::read_path_on(&file.bytes, &MAP.spec).map_err(Error::from))? else { return Ok(()) };
    let points: Vec<Point> = read.places.iter().map(|(at, _)| *at).collect();
    let Some(path) = typed(PlannedPath::of_points(&MAP, &points, &[], read.kind).map_err(Error::from))? else { return Ok(()) };
    for format in PathFormat::ALL {
        let text = format.write(&path).map_err(|error| Fault::broken("a path is written", error.to_string()))?.text;
        let back = formats::read_path_on(text.as_bytes(), &MAP.spec);
        if back.as_ref().is_ok_and(|back| back.places.iter().map(|(at, _)| *at).eq(points.iter().copied())) {
            continue;
        }
        return Err(Fault::broken("a path comes back", format!("{} {back:?}", format.id())));
    }
    Ok(())
}

fn piece() -> TerrainOptions {
    TerrainOptions { crop: Some(Window { x: 1, y: 0, width: 2, height: 2 }), size: Some((3, 1)) }
}

fn import_piece(file: &File) -> Result<(), Fault> {
    typed(formats::import_piece(&file.bytes, &file.name, TerrainOptions { crop: None, size: Some((5, 3)) }))?;
    typed(formats::import_piece(&file.bytes, &file.name, piece())).map(drop)
}

fn import_scen(file: &File) -> Result<(), Fault> {
    let Some(scen) = typed(formats::import_scen(&file.bytes).map_err(Error::from))? else { return Ok(()) };
    let grid = Grid::open(4, 3).expect("a small map");
    let misfits = formats::check_scen(&scen, &grid);
    if misfits.len() > scen.lines.len() {
        return Err(Fault::broken("one notice a line", format!("{} of {}", misfits.len(), scen.lines.len())));
    }
    scen.lines.iter().for_each(|line| assert!(line.fits(line.optimal)));
    Ok(())
}

/// An instance that is accepted has tours, and a tour of it costs something finite.
fn order_problem(file: &File) -> Result<(), Fault> {
    let five = formats::tsplib::read_instance(FIVE_PLACES.as_bytes()).expect("an instance");
    typed(formats::tsplib::read_tour(&file.bytes, &five).map_err(Error::from))?;
    let Some(problem) = typed(formats::tsplib::read_instance(&file.bytes).map_err(Error::from))? else { return Ok(()) };
    let order: Vec<u32> = (0..problem.len() as u32 - 1).collect();
    let cost = problem.cost(&order);
    let drawn = problem.places.as_ref().is_none_or(|places| places.len() == problem.len());
    if cost.is_finite() && cost >= 0.0 && drawn { Ok(()) } else { Err(Fault::broken("tours have a cost", cost.to_string())) }
}

fn import_results(file: &File) -> Result<(), Fault> {
    let results = formats::import_results(&file.bytes, &file.name).map_err(Error::from);
    let Some(results) = typed(results)? else { return Ok(()) };
    let named = results.entries.iter().all(|entry| !entry.id.is_empty() && !entry.label.is_empty());
    if results.runs() == 0 || !named {
        return Err(Fault::broken(
            "accepted results have runs and names",
            format!("{results:?}").chars().take(300).collect::<String>(),
        ));
    }
    Ok(())
}

/// A scenario that the engine takes, or a typed error.
fn scenario(grid: &Grid, spec: &ScenarioSpec) -> Result<Option<Scenario>, Fault> {
    typed(Scenario::new(grid.clone(), spec.clone()).map_err(Error::from))
}

/// Every accepted map, written in the formats that hold it, is read as the same map.
fn round_trip(file: &File) -> Result<(), Fault> {
    let Ok(map) = formats::import(&file.bytes, &file.name) else { return Ok(()) };
    ACCEPTED.fetch_add(1, Ordering::Relaxed);
    if map.grid.len() > 1 << 16 {
        return Ok(());
    }
    // A terrain may have heights that no scenario can have; only what can be planned on can be written as one.
    if scenario(&map.grid, &map.spec)?.is_none() {
        return Ok(());
    }
    let back = again(&map, Export::Scenario)?;
    if back.spec != map.spec {
        return Err(Fault::broken("scenario JSON keeps everything", format!("{:?}\nbecame {:?}", map.spec, back.spec)));
    }
    let in_metres = map.spec.terrain.is_none_or(|terrain| terrain.vertical_unit == 1.0);
    match map.grid.heights() {
        // Only a scenario's file holds factors.
        None if map.grid.factors().is_some() => Ok(()),
        // A single number is no matrix.
        None if map.grid.len() == 1 => again(&map, Export::MovingaiMap).map(drop),
        None => [Export::MovingaiMap, Export::Matrix].into_iter().try_for_each(|format| again(&map, format).map(drop)),
        // Walls on known ground are lost, and sides of cells beyond a raster's limits are refused.
        Some(heights) if in_metres && (1e-9..1e9).contains(&map.spec.resolution) => {
            let blocked = (0..map.grid.len()).any(|cell| map.grid.is_blocked(cell as u32) && !heights[cell].is_nan());
            // Heights that no ground has are without data when they are read.
            let impossible = heights.iter().any(|height| f64::from(height.abs()) > formats::FARTHEST);
            if blocked || impossible { Ok(()) } else { rasters(&map) }
        }
        Some(_) => Ok(()),
    }
}

fn rasters(map: &Imported) -> Result<(), Fault> {
    again(map, Export::EsriAscii)?;
    let bytes = formats::export_binary(&map.grid, &map.spec, BinaryExport::Geotiff).map_err(Error::from);
    let Some(bytes) = typed(bytes)? else { return Ok(()) };
    same(map, "GeoTIFF", formats::import(&bytes, "again.tif")).map(drop)
}

fn again(map: &Imported, format: Export) -> Result<Imported, Fault> {
    let text = formats::export(&map.grid, &map.spec, format);
    same(map, &format!("{format:?}"), formats::import(text.as_bytes(), "again"))
}

fn same(map: &Imported, format: &str, back: Result<Imported, Error>) -> Result<Imported, Fault> {
    let back = back.map_err(|error| Fault::broken(&format!("{format} is read again"), error.to_string()))?;
    if back.grid != map.grid {
        let sizes = format!("{} × {} became {} × {}", map.grid.width(), map.grid.height(), back.grid.width(), back.grid.height());
        return Err(Fault::broken(&format!("{format} keeps the map"), sizes));
    }
    Ok(back)
}

/// A session that is accepted is the same when its link is read; more heights than a link carries are refused.
fn session(read: Result<Session, Error>) -> Result<(), Fault> {
    let Some(session) = typed(read)? else { return Ok(()) };
    let Some(link) = typed(formats::session::write_session_link(&session).map_err(Error::from))? else { return Ok(()) };
    let back = formats::session::read_session_link(&link);
    // Only the page writes changes: what is written here has none.
    let kept = Session { changes: 0, ..session };
    if back.as_ref() == Ok(&kept) { Ok(()) } else { Err(Fault::broken("a session's link keeps everything", format!("{back:?}"))) }
}

fn question(file: &File) -> Result<(), Fault> {
    let Ok(question) = serde_json::from_slice::<Question>(&file.bytes) else { return Ok(()) };
    typed(question.check().map_err(Error::from)).map(drop)
}

/// A document that is opened can be judged as it stands, and is the same when it is written and opened again.
fn comparison(file: &File) -> Result<(), Fault> {
    let Some(opened) = typed(comparison_json::open(&utf8(file)))? else { return Ok(()) };
    let text = comparison_json::write_as(&opened.comparison, &opened.rows, true, opened.recorded.as_ref());
    let back = comparison_json::open(&text).map_err(|error| Fault::broken("a comparison is read again", error.to_string()))?;
    if back.comparison.digest().hex() != opened.comparison.digest().hex() || back.rows != opened.rows {
        return Err(Fault::broken("a comparison keeps everything", ""));
    }
    let rows = opened.comparison.all_rows(&opened.rows);
    let samples = Samples::new(&opened.comparison, rows.iter().map(Seen::from));
    [Axis::Iterations, Axis::Moves].into_iter().for_each(|axis| drop(analyse(&samples, axis, None)));
    Ok(())
}

/// A line that holds is the one that the run would be written as.
fn journal(file: &File) -> Result<(), Fault> {
    static LINES: LazyLock<JournalLines> = LazyLock::new(|| JournalLines::of(&small(), None));
    done(formats::journal::digest_in(&file.bytes))?;
    for line in file.bytes.split_inclusive(|&byte| byte == b'\n') {
        done(LINES.read_head(line).map_err(|fault| fault.to_string()))?;
        if LINES.read_line(line).is_ok_and(|(_, row)| LINES.line(&row).as_bytes() != line) {
            return Err(Fault::broken("a journal's line is the one that was written", String::from_utf8_lossy(line)));
        }
    }
    done(LINES.read(&file.bytes))
}
