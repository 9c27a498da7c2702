//! THE list of planners. A new planner is one file with its `mod` line, one line here, one frozen run in `tests/golden_cases`, and its texts
//! in other languages; conformance tests, command line and page follow. A colony that is to lend its rules has a line in
//! `aco/custom/donors.rs` as well.

use std::sync::Arc;

use serde::Serialize;

use crate::error::ParamError;
use crate::map::Generator;
#[cfg(feature = "whole")]
use crate::map::{MAX_DENSITY, MAX_LEVELS, MAX_REACH, MAX_SIDE};
use crate::params::{ParamSpec, Values};
#[cfg(feature = "whole")]
use crate::planner::Changing;
#[cfg(feature = "whole")]
use crate::planner::GroundRule;
use crate::planner::{Component, Family, Ground, Layer, PaperReading, Planner, PlannerEntry};
use crate::scenario::Scenario;
#[cfg(feature = "whole")]
use crate::scenario::{MAX_CHANGES, MAX_GOALS};
use crate::{aco, exact, sampling, swarm};

/// In every build: what a first visit to the page needs.
const OPENING: bool = true;
/// In the whole build alone.
const MORE: bool = cfg!(feature = "whole");

/// Most runs of one entry on one map of a comparison.
pub const MAX_SEEDS: u32 = 100_000;

/// The planners in the order in which people meet them, each with the builds that have it.
const LIST: &[(bool, &PlannerEntry)] = &[
    (OPENING, &aco::ant_system::ENTRY),
    (MORE, &aco::elitist_ant_system::ENTRY),
    (MORE, &aco::rank_based_ant_system::ENTRY),
    (MORE, &aco::max_min_ant_system::ENTRY),
    (MORE, &aco::ant_colony_system::ENTRY),
    (MORE, &aco::best_worst_ant_system::ENTRY),
    (MORE, &aco::formica::ENTRY),
    (OPENING, &exact::dijkstra::ENTRY),
    (OPENING, &exact::astar::ENTRY),
    (MORE, &exact::d_star_lite::ENTRY),
    (MORE, &exact::theta_star::ENTRY),
    (MORE, &exact::any_angle::ENTRY),
    (MORE, &exact::turn_aware::ENTRY),
    (MORE, &exact::tour::ENTRY),
    (MORE, &exact::slices::ENTRY),
    (MORE, &aco::fire::ENTRY),
    (MORE, &aco::ship::ENTRY),
    (MORE, &aco::terrain::ACO),
    (MORE, &aco::terrain::EPF),
    (MORE, &aco::by_slices::textbook::ENTRY),
    (MORE, &aco::by_slices::ant_colony_system::ENTRY),
    (MORE, &aco::by_slices::max_min_ant_system::ENTRY),
    (MORE, &aco::by_slices::formica::ENTRY),
    (MORE, &aco::threshold::ACOST),
    (MORE, &aco::threshold::ACOMSP),
    (MORE, &aco::iaaco::ENTRY),
    (MORE, &aco::maaco::ENTRY),
    (MORE, &aco::ihmaco::ENTRY),
    (MORE, &aco::tdi_msaco::ENTRY),
    (MORE, &swarm::fireworks::FWA),
    (MORE, &swarm::fireworks::IFWA),
    (MORE, &swarm::pso::ENTRY),
    (MORE, &swarm::genetic::ENTRY),
    (MORE, &sampling::f_rrt_star::ENTRY),
    (MORE, &aco::fireworks::FWA_ACO),
    (MORE, &aco::fireworks::PSO_ACO),
    (MORE, &aco::custom::ENTRY),
];

/// Every planner of this build, in the list's order. The linker drops the others: nothing else mentions them.
pub static CATALOG: &[&PlannerEntry] = &const {
    let mut built = [LIST[0].1; count()];
    let (mut row, mut next) = (0, 0);
    while row < LIST.len() {
        if LIST[row].0 {
            built[next] = LIST[row].1;
            next += 1;
        }
        row += 1;
    }
    built
};

const fn count() -> usize {
    let (mut row, mut count) = (0, 0);
    while row < LIST.len() {
        count += LIST[row].0 as usize;
        row += 1;
    }
    count
}

/// The entry of an id.
///
/// ```
/// use formicarium::catalog;
///
/// assert_eq!(catalog::find("astar")?.name, "A*");
/// assert!(catalog::find("a-star").is_err(), "the error lists all ids");
/// # Ok::<(), formicarium::error::ParamError>(())
/// ```
///
/// # Errors
/// [`ParamError::UnknownPlanner`] with all known ids.
pub fn find(id: &str) -> Result<&'static PlannerEntry, ParamError> {
    CATALOG.iter().copied().find(|e| e.id == id).ok_or_else(|| ParamError::UnknownPlanner {
        id: id.into(),
        known: CATALOG.iter().map(|e| e.id).collect::<Vec<_>>().join(", "),
    })
}

/// Makes a planner: the entry's defaults, then the preset's values, then `values`. The seed decides every random number.
///
/// ```
/// # use std::sync::Arc;
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::{catalog, params::Value, scenario::Scenario};
///
/// let scenario = Scenario::on(Grid::open(8, 8)?, Movement::default(), Point::new(0, 0), Point::new(7, 7))?;
/// let values = [("ants".to_string(), Value::from(10.0))].into();
/// let mut planner = catalog::build(&Arc::new(scenario), "ant-system", Some("fire"), &values, 7)?;
/// planner.run();
/// assert_eq!(planner.effort().constructed_paths, 10 * 100);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ParamError`] for an unknown planner, preset or key, a value that does not fit, or tables that would not fit into memory.
pub fn build(
    scenario: &Arc<Scenario>,
    id: &str,
    preset: Option<&str>,
    values: &Values,
    seed: u32,
) -> Result<Box<dyn Planner>, ParamError> {
    #[cfg(feature = "whole")]
    if !scenario.spec.changes.is_empty() {
        return build_changing(scenario, id, preset, values, seed);
    }
    let (entry, all) = recipe(scenario, id, preset, values)?;
    let planner = (entry.build)(scenario, &all, seed)?;
    check_memory(scenario, planner.colony_size())?;
    Ok(planner)
}

/// The same for a planner that takes the scenario's changes, and others while it is at work ([`Changing::schedule`]).
///
/// ```
/// # use std::sync::Arc;
/// use formicarium::map::{Grid, Movement, Point};
/// use formicarium::planner::Granularity;
/// use formicarium::scenario::{Change, Scenario};
/// use formicarium::{catalog, params::Values};
///
/// let scenario = Arc::new(Scenario::on(Grid::open(8, 8)?, Movement::default(), Point::new(0, 0), Point::new(7, 7))?);
/// let mut planner = catalog::build_changing(&scenario, "ant-system", None, &Values::new(), 7)?;
/// planner.advance(Granularity::Iteration);
/// let changing = planner.changing_mut().expect("it takes changes");
/// let at = changing.next_end();
/// changing.schedule(Change { at, blocked: vec![Point::new(3, 3)], freed: vec![] })?;
/// assert_eq!((at, changing.made()), (1, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`build`].
#[cfg(feature = "whole")]
pub fn build_changing(
    scenario: &Arc<Scenario>,
    id: &str,
    preset: Option<&str>,
    values: &Values,
    seed: u32,
) -> Result<Box<dyn Planner>, ParamError> {
    let (entry, all) = recipe(scenario, id, preset, values)?;
    let planner = Changing::new(scenario, entry.build, all, seed)?;
    check_memory(scenario, planner.colony_size())?;
    Ok(Box::new(planner))
}

/// A planner's entry and its values, where it takes the scenario's goals and ground.
fn recipe(
    scenario: &Scenario,
    id: &str,
    preset: Option<&str>,
    values: &Values,
) -> Result<(&'static PlannerEntry, Values), ParamError> {
    let entry = find(id)?;
    if scenario.goals.len() > entry.max_goals as usize {
        return Err(too_many_goals(entry, scenario.goals.len()));
    }
    check_ground(entry, scenario)?;
    let mut all = preset.map_or(Ok(Values::new()), |name| preset_values(entry, name))?;
    all.extend(values.clone());
    Ok((entry, all))
}

/// Every parameter's value: the entry's defaults, then the preset's values, then `values`.
///
/// # Errors
/// [`ParamError`] for an unknown planner, preset or key, and for a value that does not fit its row.
pub fn values(id: &str, preset: Option<&str>, values: &Values) -> Result<Values, ParamError> {
    let entry = find(id)?;
    let specs = (entry.specs)();
    let mut all: Values = specs.iter().map(|spec| (spec.key.to_owned(), spec.default.clone())).collect();
    all.extend(preset.map_or(Ok(Values::new()), |name| preset_values(entry, name))?);
    all.extend(values.clone());
    crate::params::check_keys(id, &specs, &all)?;
    specs.iter().try_for_each(|spec| all.get(spec.key).map_or(Ok(()), |value| spec.check(value)))?;
    Ok(all)
}

/// Refuses what would run out of memory at the first step. Bytes per cell: trails, weights, flags, and what the page draws; with several
/// goals once for each leg's colony.
fn check_memory(scenario: &Scenario, ants: u32) -> Result<(), ParamError> {
    const PER_CELL: u64 = 150;
    let cells = scenario.grid.len() as u64;
    let colonies = if ants > 0 { scenario.goals.len() as u64 } else { 1 };
    ParamError::check_memory("ants", ants, colonies * (cells * PER_CELL + u64::from(ants) * (cells / 8 + 4096)))
}

/// # Errors
/// [`ParamError::Ground`] where the planner does not know how one moves in the scenario.
fn check_ground(entry: &PlannerEntry, scenario: &Scenario) -> Result<(), ParamError> {
    let knows_all = |e: &PlannerEntry| Ground::all_of(scenario).all(|ground| e.grounds.contains(&ground));
    let Some(ground) = Ground::all_of(scenario).find(|ground| !entry.grounds.contains(ground)) else { return Ok(()) };
    let able = CATALOG.iter().filter(|e| knows_all(e)).map(|e| e.id).collect::<Vec<_>>();
    let (id, words) = ground.words();
    Err(ParamError::Ground { planner: entry.id.into(), ground: words, id, others: able.join(", ") })
}

fn too_many_goals(entry: &PlannerEntry, got: usize) -> ParamError {
    let able = CATALOG.iter().filter(|e| e.max_goals as usize >= got).map(|e| e.id);
    ParamError::TooManyGoals { planner: entry.id.into(), most: entry.max_goals, got, others: able.collect::<Vec<_>>().join(", ") }
}

fn preset_values(entry: &PlannerEntry, name: &str) -> Result<Values, ParamError> {
    entry.presets.iter().find(|p| p.name == name).map(|p| p.values()).ok_or_else(|| ParamError::UnknownPreset {
        planner: entry.id.into(),
        name: name.into(),
        known: entry.presets.iter().map(|p| p.name).collect::<Vec<_>>().join(", "),
    })
}

/// The catalog as data: `catalog --json`, and the page. What is not about planners is told by the whole build alone: a page has it from
/// there before any engine starts.
#[derive(Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Catalog {
    /// `formicarium/catalog@1`.
    pub format: String,
    /// Every planner.
    pub planners: Vec<CatalogEntry>,
    /// Every layer that some planner can draw, in the order in which people meet them.
    #[cfg(feature = "whole")]
    pub layers: Vec<Layer>,
    /// What the engine accepts at most.
    #[cfg(feature = "whole")]
    pub limits: Limits,
    /// How the ground follows from a scenario: the first rule that holds.
    #[cfg(feature = "whole")]
    pub grounds: Vec<GroundRule>,
    /// The generators of maps.
    #[cfg(feature = "whole")]
    pub generators: Vec<GeneratorEntry>,
}

/// What the engine accepts at most, from the constants that it checks by.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Limits {
    /// Cells a side of a map.
    pub max_side: u32,
    /// Goals of a scenario.
    pub max_goals: u32,
    /// Levels of movement by slices.
    pub max_levels: u32,
    /// Cells aside and levels up or down in a step by slices.
    pub max_reach: u32,
    /// Density of obstacles, or roughness, of a generated map.
    pub max_density: f64,
    /// Seeds of a comparison: runs of one entry on one map.
    pub max_seeds: u32,
    /// Changes of walls of a scenario.
    pub max_changes: u32,
}

/// One generator of maps as data.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct GeneratorEntry {
    /// Its id.
    pub id: Generator,
    /// Whether it makes a terrain, with heights.
    pub terrain: bool,
    /// What its number beside size and seed says: `density` or `roughness`, 0 to [`Limits::max_density`]; none where it has no such number.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"density\" | \"roughness\" | null"))]
    pub asks_for: Option<&'static str>,
}

/// One planner as data.
#[derive(Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CatalogEntry {
    /// Stable id.
    pub id: String,
    /// Name for people.
    pub name: String,
    /// Kind of planner.
    pub family: Family,
    /// Whether each of its runs is the same, whatever the seed.
    pub needs_no_seed: bool,
    /// One sentence.
    pub summary: String,
    /// The publication.
    pub source: String,
    /// Named parameter sets.
    pub presets: Vec<PresetEntry>,
    /// Which reading of its publication its defaults are; absent where they are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub reading: Option<PaperReading>,
    /// What its publication adds.
    pub components: Vec<ComponentEntry>,
    /// Its parameters.
    pub params: Vec<ParamSpec>,
    /// The layers it can draw.
    pub layers: Vec<Layer>,
    /// Most goals that it can visit.
    pub max_goals: u32,
    /// The ways of moving that it knows.
    pub grounds: Vec<Ground>,
}

/// One preset as data.
#[derive(Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PresetEntry {
    /// Its name.
    pub name: String,
    /// The publication.
    pub source: String,
    /// What it stands for.
    pub meaning: String,
    /// Values by key.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, number | string | boolean>"))]
    pub values: Values,
    /// Which reading of the planner's publication it is; absent where it is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub reading: Option<PaperReading>,
}

/// One component as data.
#[derive(Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ComponentEntry {
    /// Its id.
    pub id: String,
    /// Name for tables.
    pub name: String,
    /// What the publication adds.
    pub adds: String,
    /// The values that turn it off, by key.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, number | string | boolean>"))]
    pub without: Values,
}

/// See [`Limits`].
#[cfg(feature = "whole")]
const LIMITS: Limits = Limits {
    max_side: MAX_SIDE,
    max_goals: MAX_GOALS as u32,
    max_levels: MAX_LEVELS,
    max_reach: MAX_REACH,
    max_density: MAX_DENSITY,
    max_seeds: MAX_SEEDS,
    max_changes: MAX_CHANGES as u32,
};

/// The whole catalog as data.
pub fn catalog() -> Catalog {
    let preset = |p: &crate::planner::Preset| PresetEntry {
        name: p.name.into(),
        source: p.source.into(),
        meaning: p.meaning.into(),
        values: p.values(),
        reading: p.reading,
    };
    let component =
        |c: &Component| ComponentEntry { id: c.id.into(), name: c.name.into(), adds: c.adds.into(), without: c.values() };
    let entry = |e: &&PlannerEntry| CatalogEntry {
        id: e.id.into(),
        name: e.name.into(),
        family: e.family,
        needs_no_seed: e.family.needs_no_seed(),
        summary: e.summary.into(),
        source: e.source.into(),
        presets: e.presets.iter().map(preset).collect(),
        // No planner of the opening build has any readings or components; it is spared the reading of numbers.
        reading: if MORE { e.reading_of(None) } else { None },
        components: if MORE { e.components.iter().map(component).collect() } else { Vec::new() },
        params: (e.specs)(),
        layers: e.layers.to_vec(),
        max_goals: e.max_goals,
        grounds: e.grounds.to_vec(),
    };
    #[cfg(feature = "whole")]
    let generator = |kind: Generator| GeneratorEntry { id: kind, terrain: kind.is_terrain(), asks_for: kind.asks_for() };
    Catalog {
        format: "formicarium/catalog@1".into(),
        planners: CATALOG.iter().map(entry).collect(),
        #[cfg(feature = "whole")]
        layers: Layer::ALL.to_vec(),
        #[cfg(feature = "whole")]
        limits: LIMITS,
        #[cfg(feature = "whole")]
        grounds: Ground::RULES.to_vec(),
        #[cfg(feature = "whole")]
        generators: Generator::ALL.map(generator).to_vec(),
    }
}
