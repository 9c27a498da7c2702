//! Reading what the arguments name: files, cells, movement, scenarios.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::error::{Error, FormatError, Notice};
use crate::formats::{self, Imported, MAX_TEXT_BYTES, ScenLine};
use crate::map::{CornerRule, Moves, Point, Window};
use crate::scenario::{CostRule, Goal, Scenario, ScenarioSpec};
use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::driving::DrivingArgs;
use super::error::CliError;
use super::reading::ReadingArgs;
use super::robot::RobotArgs;
use super::terrain::TerrainArgs;
use super::text;

/// Which question is asked on which map.
#[derive(clap::Args)]
pub struct ScenarioArgs {
    /// The map: MovingAI .map, a matrix of 0 and 1, a raster of heights, or a scenario as JSON
    #[arg(required_unless_present = "scenario")]
    map: Option<PathBuf>,
    /// Start and goal from a line of a MovingAI .scen, counted from 1 as in an editor
    #[arg(long, value_name = "FILE:LINE", conflicts_with_all = ["from", "to", "scenario"])]
    scen: Option<String>,
    /// A scenario file in place of the map
    #[arg(long, value_name = "F.json", conflicts_with = "map")]
    scenario: Option<PathBuf>,
    #[command(flatten)]
    route: RouteArgs,
    #[command(flatten)]
    driving: DrivingArgs,
    #[command(flatten)]
    reading: ReadingArgs,
}

/// Where one goes on a map, and how one moves.
#[derive(clap::Args)]
pub struct RouteArgs {
    /// Start: a cell, or a place of a ROS map in metres such as -1.5m,2m
    #[arg(long, value_name = "X,Y", value_parser = place, allow_hyphen_values = true)]
    from: Option<Place>,
    /// Goal: a cell, or a place in metres; repeated for several goals
    #[arg(long, value_name = "X,Y", value_parser = place, allow_hyphen_values = true)]
    to: Vec<Place>,
    #[command(flatten)]
    movement: MovementArgs,
    #[command(flatten)]
    robot: RobotArgs,
    #[command(flatten)]
    terrain: TerrainArgs,
}

impl RouteArgs {
    /// Whether ends are asked for.
    pub fn has_ends(&self) -> bool {
        self.from.is_some() || !self.to.is_empty()
    }

    /// Lets the arguments override a map's ends and rules.
    pub fn apply(&self, map: &mut Imported) -> Result<(), CliError> {
        let start = self.from.map(|place| place.on(&map.spec)).transpose()?;
        let goals = self.to.iter().map(|place| place.on(&map.spec)).collect::<Result<Vec<_>, _>>()?;
        set_ends(map, start, &goals);
        self.movement.apply(map);
        let assumed = self.robot.apply(&mut map.spec);
        map.notices.extend(assumed);
        self.terrain.apply(map)
    }
}

/// A place that was asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// Column and row.
    Cell(Point),
    /// x and y in the world.
    Metres([f64; 2]),
}

impl Place {
    /// Its cell on a map.
    pub fn on(self, spec: &ScenarioSpec) -> Result<Point, CliError> {
        match self {
            Self::Cell(at) => Ok(at),
            Self::Metres([x, y]) => spec.to_cell([x, y]).ok_or_else(|| match spec.world {
                Some(_) => CliError::usage(format!("({x} m, {y} m) lies beside the map"), "give a place on the map"),
                None => {
                    let hint = "give a cell such as 3,12; a ROS map and an OccupancyGrid say where they lie";
                    CliError::usage("the map does not say where it lies in the world", hint)
                }
            }),
        }
    }
}

/// How one moves.
#[derive(clap::Args)]
pub struct MovementArgs {
    /// Cells free beside a diagonal step: always, one-free, both-free [default: the map's, else both-free]
    #[arg(long, value_name = "RULE", hide_possible_values = true, value_parser = corner_rules())]
    pub corner_rule: Option<CornerRule>,
    /// Moves a cell offers [default: the map's, else 8]
    #[arg(long, value_name = "4|8|16", hide_possible_values = true, value_parser = moves())]
    pub moves: Option<Moves>,
    /// Metres per cell [default: the map's, else 1]
    #[arg(long, visible_alias = "cell-size", value_name = "M", value_parser = metres, allow_negative_numbers = true)]
    pub resolution: Option<f64>,
}

fn moves() -> impl TypedValueParser<Value = Moves> {
    PossibleValuesParser::new(["4", "8", "16"]).map(|text| match text.as_str() {
        "4" => Moves::Four,
        "16" => Moves::Sixteen,
        _ => Moves::Eight,
    })
}

impl MovementArgs {
    /// Lets the arguments override a map's movement.
    pub fn apply(&self, map: &mut Imported) {
        let movement = &mut map.spec.movement;
        movement.corner_rule = self.corner_rule.unwrap_or(movement.corner_rule);
        movement.moves = self.moves.unwrap_or(movement.moves);
        map.spec.resolution = self.resolution.unwrap_or(map.spec.resolution);
    }
}

/// The id of a rule.
pub fn rule_id(rule: CornerRule) -> &'static str {
    match rule {
        CornerRule::Always => "always",
        CornerRule::OneFree => "one-free",
        CornerRule::BothFree => "both-free",
    }
}

/// Reads a rule by its id.
pub fn corner_rules() -> impl TypedValueParser<Value = CornerRule> {
    PossibleValuesParser::new(CornerRule::ALL.map(rule_id)).map(|id| {
        let found = CornerRule::ALL.into_iter().find(|r| rule_id(*r) == id);
        found.unwrap_or_default()
    })
}

/// Reads a rule of costs by its id.
pub fn cost_rules() -> impl TypedValueParser<Value = CostRule> {
    PossibleValuesParser::new(CostRule::ALL.map(CostRule::id)).map(|id| {
        let found = CostRule::ALL.into_iter().find(|rule| rule.id() == id);
        found.unwrap_or_default()
    })
}

/// Reads `WIDTHxHEIGHT`.
pub fn size(text: &str) -> Result<(u32, u32), String> {
    let wrong = || format!("`{text}` is no size: write WIDTHxHEIGHT such as 40x30");
    let (w, h) = text.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
    Ok((w.trim().parse().map_err(|_| wrong())?, h.trim().parse().map_err(|_| wrong())?))
}

/// Reads a length above 0.
pub fn metres(text: &str) -> Result<f64, String> {
    let metres = text.trim().parse().ok().filter(|&m: &f64| m.is_finite() && m > 0.0);
    metres.ok_or_else(|| format!("`{text}` is no length: write a positive number of metres such as 30"))
}

/// Reads `x,y,width,height`.
pub fn window(text: &str) -> Result<Window, String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|n| n.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, width, height]) => Ok(Window { x, y, width, height }),
        _ => Err(format!("`{text}` is no window: write column,row,width,height such as 10,20,40,30")),
    }
}

/// Reads `x,y`, or `1.5m,-2m`.
pub fn place(text: &str) -> Result<Place, String> {
    let metres = |part: &str| part.trim().strip_suffix('m')?.trim().parse().ok().filter(|v: &f64| v.is_finite());
    match text.split_once(',').and_then(|(x, y)| metres(x).zip(metres(y))) {
        Some((x, y)) => Ok(Place::Metres([x, y])),
        None => point(text).map(Place::Cell),
    }
}

/// Reads `x,y`.
pub fn point(text: &str) -> Result<Point, String> {
    let wrong = || format!("`{text}` is no cell: write column,row such as 3,12");
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    let number = |s: &str| s.trim().parse().map_err(|_| wrong());
    Ok(Point::new(number(x)?, number(y)?))
}

impl ScenarioArgs {
    /// Whether `--smooth` asks for a curve.
    pub fn asks_for_a_curve(&self) -> bool {
        self.driving.asks_for_a_curve()
    }

    /// Reads and validates the scenario, and prints notes about it.
    pub fn load(&self) -> Result<Arc<Scenario>, CliError> {
        let path = self.map.as_deref().or(self.scenario.as_deref()).unwrap_or(Path::new("-"));
        let mut map = self.reading.import(path)?;
        self.route.correct_note(&mut map, self.scen.is_some());
        if let Some(place) = &self.scen {
            let line = scen_line(place)?;
            map.notices.extend(other_map(&line.map, path));
            // Ends that do not fit are errors of the scenario; another size would pass unnoticed.
            map.notices.extend(formats::misfit(&line, &map.grid).filter(|n| n.kind == "scen-size"));
            set_ends(&mut map, Some(line.start), &[line.goal]);
        }
        self.route.apply(&mut map)?;
        self.driving.apply(&mut map.spec.vehicle);
        let scenario = Scenario::new(map.grid, map.spec)?;
        text::notes(&map.notices);
        text::notes(&scenario.notices());
        Ok(Arc::new(scenario))
    }
}

impl RouteArgs {
    /// The note about ends that a map does not name tells only of those that are not given here either, or all `from_scen`.
    pub fn correct_note(&self, map: &mut Imported, from_scen: bool) {
        map.ends_are_given(from_scen || self.from.is_some(), from_scen || !self.to.is_empty());
    }
}

/// Puts start and goals where they are asked for. As many goals as the map has are moved and keep their names and weights; another
/// number takes their place.
fn set_ends(map: &mut Imported, start: Option<Point>, goals: &[Point]) {
    map.spec.start = start.unwrap_or(map.spec.start);
    if goals.len() == map.spec.goals.len() {
        map.spec.goals.iter_mut().zip(goals).for_each(|(goal, &at)| goal.at = at);
    } else if !goals.is_empty() {
        map.spec.goals = goals.iter().map(|&at| Goal::new(at, "")).collect();
    }
}

/// The scenario of `FILE:LINE`.
fn scen_line(place: &str) -> Result<ScenLine, CliError> {
    let hint = "write FILE:LINE such as arena2.map.scen:17; line 1 is the version, scenarios begin in line 2";
    let split = place.rsplit_once(':').and_then(|(file, line)| Some((file, line.parse::<u32>().ok()?)));
    let (file, number) = split.ok_or_else(|| CliError::usage(format!("`{place}` names no line"), hint))?;
    let scen = in_file(Path::new(file), MAX_TEXT_BYTES, |bytes, _| Ok(formats::import_scen(bytes)?))?;
    let last = scen.lines.last().map_or(0, |l| l.line);
    let found = scen.lines.into_iter().find(|l| l.line == number);
    found.ok_or_else(|| CliError::usage(format!("{file} has no scenario in line {number} (its last line is {last})"), hint))
}

/// Whether a scenario's map is the file, by their names without folders and endings.
pub fn is_of_map(listed: &str, map: &Path) -> bool {
    let listed = listed.rsplit(['/', '\\']).next().unwrap_or_default();
    stem(Path::new(listed)).eq_ignore_ascii_case(&stem(map))
}

/// That a scenario names another map than the file; standard input has no name.
pub fn other_map(listed: &str, map: &Path) -> Option<Notice> {
    (map != Path::new("-") && !is_of_map(listed, map)).then(|| {
        let message = format!("the scenario is of the map {listed}, the file is {}", file_name(map));
        Notice::new("scen-map", message).with("listed", listed).with("map", file_name(map))
    })
}

/// A file's name without its folders.
pub fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The same without its ending.
pub fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Reads a file of up to `most` bytes and names it in the error when its contents cannot be used.
pub fn in_file<T>(path: &Path, most: usize, read: impl FnOnce(&[u8], &str) -> Result<T, Error>) -> Result<T, CliError> {
    let name = path.display().to_string();
    let bytes = bytes(path, most as u64)?;
    read(&bytes, &name).map_err(|error| CliError::Contents { path: name, error })
}

/// What a file holds. No more of it is read than tells that it is too large; some files have no end.
pub fn bytes(path: &Path, most: u64) -> Result<Vec<u8>, CliError> {
    let name = || path.display().to_string();
    let failed = |error| CliError::File { action: "read", path: name(), error };
    let too_large = |what: String| {
        let error = FormatError::TooLarge { what, max: format!("{} MiB", most >> 20) };
        CliError::Contents { path: name(), error: error.into() }
    };
    let source: Box<dyn Read> = if path == Path::new("-") {
        Box::new(std::io::stdin().lock())
    } else {
        let file = File::open(path).map_err(failed)?;
        let size = file.metadata().map_err(failed)?.len();
        if size > most {
            return Err(too_large(format!("a file of {} MiB", size >> 20)));
        }
        Box::new(file)
    };
    let mut bytes = Vec::new();
    source.take(most + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > most { Err(too_large("a file without an end in sight".into())) } else { Ok(bytes) }
}
