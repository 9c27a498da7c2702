//! Maps.

use std::path::PathBuf;
use std::sync::Arc;

use formicarium::cli::shared::{self, heard};
use formicarium::error::{Error, Notice};
use formicarium::formats::{self, Imported, Kind, ReadOptions, TerrainOptions};
use formicarium::map::{Generator, Grid, Point, SliceRules, Window};
use formicarium::scenario::Scenario;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::errors::{Refusal, said};

/// A cell as column and row.
type At = (u32, u32);

/// What is worth saying, as kind and sentence.
type Notices = Vec<(String, String)>;

/// A map with the question asked on it, validated; it never changes.
#[pyclass(frozen, module = "formicarium._engine")]
pub struct Map {
    pub scenario: Arc<Scenario>,
    /// Whether somebody has named start and goal, the file or the caller.
    pub has_ends: bool,
}

impl Map {
    fn of(map: Imported) -> Result<(Self, Notices), Refusal> {
        let (has_ends, mut notices) = (!map.ends_were_chosen(), map.notices);
        let scenario = Scenario::new(map.grid, map.spec)?;
        notices.extend(scenario.notices());
        Ok((Self { scenario: Arc::new(scenario), has_ends }, told(notices)))
    }

    fn imported(&self) -> Imported {
        let Scenario { drawn, spec, .. } = &*self.scenario;
        let notices = if self.has_ends { Vec::new() } else { vec![Notice::new("ends-chosen", "")] };
        Imported { kind: Kind::Scenario, grid: drawn.clone(), spec: spec.clone(), notices, unknown: None }
    }
}

fn told(notices: Vec<Notice>) -> Notices {
    notices.into_iter().map(|notice| (notice.kind, notice.message)).collect()
}

#[pymethods]
impl Map {
    /// From one byte a cell, 0 = free, row by row; heights and factors as little-endian f32, NaN = no data. Ends that are not given are
    /// chosen.
    #[staticmethod]
    fn of_cells(
        py: Python<'_>,
        size: (u32, u32),
        cells: &[u8],
        heights: Option<&[u8]>,
        factors: Option<&[u8]>,
        name: &str,
        ends: (Option<At>, Option<At>),
    ) -> PyResult<(Self, Notices)> {
        let made = py.detach(|| {
            let [start, goal] = [ends.0, ends.1].map(|end| end.map(|(x, y)| Point::new(x, y)));
            let grid = grid(size, cells, [heights, factors])?;
            let outside = [start, goal].into_iter().flatten().any(|end| !grid.contains(end));
            // Ends beside the map are the scenario's to refuse.
            let (start, goal) = if outside { (start.or(goal), goal.or(start)) } else { (start, goal) };
            let mut map = formats::of_cells(grid, "", start, goal).map_err(Error::from)?;
            map.spec.name = name.into();
            Self::of(map)
        });
        Ok(made?)
    }

    /// The same with every field of the scenario, as JSON.
    #[staticmethod]
    fn of_parts(
        py: Python<'_>,
        size: (u32, u32),
        cells: &[u8],
        heights: Option<&[u8]>,
        factors: Option<&[u8]>,
        spec: &str,
        has_ends: bool,
    ) -> PyResult<Self> {
        let made = py.detach(|| {
            let spec = formats::read_spec(spec)?;
            let scenario = Scenario::new(grid(size, cells, [heights, factors])?, spec)?;
            Ok::<_, Refusal>(Self { scenario: Arc::new(scenario), has_ends })
        });
        Ok(made?)
    }

    /// The same cells with other fields, as JSON.
    fn with_spec(&self, py: Python<'_>, spec: &str, has_ends: bool) -> PyResult<(Self, Notices)> {
        let made = py.detach(|| {
            let spec = formats::read_spec(spec)?;
            let scenario = Scenario::new(self.scenario.drawn.clone(), spec)?;
            let notices = told(scenario.notices());
            Ok::<_, Refusal>((Self { scenario: Arc::new(scenario), has_ends }, notices))
        });
        Ok(made?)
    }

    /// Columns and rows.
    #[getter]
    fn size(&self) -> (u32, u32) {
        (self.scenario.grid.width(), self.scenario.grid.height())
    }

    #[getter]
    fn has_ends(&self) -> bool {
        self.has_ends
    }

    /// Every field of the scenario but its cells, as JSON.
    #[getter]
    fn spec(&self) -> String {
        json(&self.scenario.spec)
    }

    /// One byte a cell, row by row.
    fn cells<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.scenario.drawn.to_bytes())
    }

    /// The heights as little-endian f32, row by row; none on a plane.
    fn heights<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyBytes>> {
        self.scenario.drawn.heights().map(|heights| le_bytes(py, heights))
    }

    /// The factors as little-endian f32, row by row; none on plain ground.
    fn factors<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyBytes>> {
        self.scenario.drawn.factors().map(|factors| le_bytes(py, factors))
    }

    /// The rules by slices that suit the terrain, as JSON.
    fn fitting_slices(&self) -> PyResult<String> {
        let Scenario { drawn, spec, .. } = &*self.scenario;
        let Some(terrain) = spec.terrain else {
            return Err(Refusal::argument("slices", "a map without heights has no levels", "give heights").into());
        };
        Ok(json(&SliceRules::fitting_map(drawn, terrain.vertical_unit, spec.start, spec.goals[0].at, None)))
    }

    /// The middle of a cell in metres; none where the map's place is not known.
    fn to_world(&self, at: (u32, u32)) -> Option<(f64, f64)> {
        self.scenario.spec.to_world(Point::new(at.0, at.1)).map(|[x, y]| (x, y))
    }

    /// The cell at a place in metres; none beside the map, or where its place is not known.
    fn to_cell(&self, at: (f64, f64)) -> Option<(u32, u32)> {
        self.scenario.spec.to_cell([at.0, at.1]).map(|p| (p.x, p.y))
    }

    /// Writes it in the format that the ending tells; gives what that does not hold.
    fn write(&self, py: Python<'_>, path: PathBuf) -> PyResult<Vec<String>> {
        let map = self.imported();
        let (written, said_meanwhile) = py.detach(|| heard(|| shared::write_map(&path, &map)));
        written.map_err(|error| said(&error))?;
        Ok(said_meanwhile)
    }

    fn same_as(&self, other: &Self) -> bool {
        let (a, b) = (&self.scenario, &other.scenario);
        a.spec == b.spec && a.drawn == b.drawn
    }
}

fn grid((width, height): (u32, u32), cells: &[u8], [heights, factors]: [Option<&[u8]>; 2]) -> Result<Grid, Refusal> {
    let numbers = |bytes: &[u8]| bytes.as_chunks::<4>().0.iter().map(|four| f32::from_le_bytes(*four)).collect();
    let mut grid = Grid::from_bytes(width, height, cells)?;
    if let Some(heights) = heights {
        grid = grid.with_heights(numbers(heights))?;
    }
    if let Some(factors) = factors {
        grid = grid.with_factors(numbers(factors))?;
    }
    Ok(grid)
}

fn le_bytes<'py>(py: Python<'py>, numbers: &[f32]) -> Bound<'py, PyBytes> {
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    PyBytes::new(py, &bytes)
}

/// Plain data of the engine as JSON.
pub fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("plain data can always be written as JSON")
}

/// A window as column, row, columns and rows; a size in columns and rows; whether cells longer than wide become square.
type Piece = (Option<(u32, u32, u32, u32)>, Option<(u32, u32)>, bool);

/// Reads a map as the command line does. `options` are the engine's `ReadOptions` as JSON; `given`: whether start and goals come from elsewhere.
#[pyfunction]
pub fn read_map(
    py: Python<'_>,
    path: PathBuf,
    options: &str,
    piece: Piece,
    invert: bool,
    given: (bool, bool),
) -> PyResult<(Map, Notices)> {
    let (crop, size, square) = piece;
    let options: ReadOptions = serde_json::from_str(options)
        .map_err(|error| Refusal::argument("options", error.to_string(), "as `formicarium convert --help` lists them"))?;
    let crop = crop.map(|(x, y, width, height)| Window { x, y, width, height });
    let read = py.detach(|| {
        let (map, more) = heard(|| shared::read_map(&path, &options, TerrainOptions { crop, size }, square));
        let mut map = map.map_err(|error| said(&error))?;
        if invert {
            map = map.invert().map_err(Error::from)?;
        }
        map.ends_are_given(given.0, given.1);
        let (map, mut notices) = Map::of(map)?;
        notices.extend(more.into_iter().map(|message| ("note".to_owned(), message)));
        Ok::<_, Refusal>((map, notices))
    });
    Ok(read?)
}

/// Makes a map by seed; `density` absent: what the command line takes.
#[pyfunction]
pub fn generate(py: Python<'_>, kind: &str, size: (u32, u32), seed: u32, density: Option<f64>) -> PyResult<Map> {
    let kind = Generator::ALL.into_iter().find(|known| known.id() == kind).ok_or_else(|| {
        let known = Generator::ALL.map(Generator::id).join(", ");
        Refusal::argument("kind", format!("there is no generator `{kind}`"), format!("one of {known}"))
    })?;
    let made = py.detach(|| {
        let made = shared::generate(kind, size, seed, density)?;
        Ok::<_, Refusal>(Map { scenario: Arc::new(Scenario::new(made.grid, made.spec)?), has_ends: true })
    });
    Ok(made?)
}

/// Planners and generators, as JSON.
#[pyfunction]
pub fn catalog() -> String {
    json(&formicarium::catalog::catalog())
}
