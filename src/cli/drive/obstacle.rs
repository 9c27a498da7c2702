//! An obstacle as arguments name it: corners of its track, and how it moves.

use crate::cli::error::CliError;
use crate::cli::input::{self, Place};
use crate::map::Point;
use crate::scenario::{AtEnd, ScenarioSpec, Track};

/// What goes in straight lines from place to place.
#[derive(Debug, Clone)]
pub struct Obstacle {
    /// As it was written.
    text: String,
    corners: Vec<Place>,
    /// Its track, but for the cells.
    moves: Track,
}

impl Obstacle {
    /// Its track on a map.
    pub fn on(&self, spec: &ScenarioSpec) -> Result<Track, CliError> {
        let corners = self.corners.iter().map(|place| place.on(spec)).collect::<Result<Vec<_>, _>>()?;
        let cells = straight(&corners).ok_or_else(|| {
            let said: Vec<String> = corners.iter().map(|at| format!("{},{}", at.x, at.y)).collect();
            let message = format!("`{}` goes through {}, which is no row, column or diagonal", self.text, said.join(":"));
            CliError::usage(message, "name corners so that each lies straight or diagonal from the one before it")
        })?;
        Ok(Track { cells, ..self.moves.clone() })
    }
}

/// Reads `X,Y:X,Y:…` and what follows by name.
pub fn read(text: &str) -> Result<Obstacle, String> {
    let wrong = || format!("`{text}` is no obstacle: write cells such as 10,3:10,15 and then size=2,from=4,each=3,end=leave");
    let (places, named) = match text.split_once('=') {
        Some((before, _)) => text.split_at(before.rfind(',').ok_or_else(wrong)?),
        None => (text, ""),
    };
    let corners = places.split(':').map(input::place).collect::<Result<Vec<_>, _>>()?;
    let cells = |place: &Place| if let Place::Cell(at) = place { Some(*at) } else { None };
    if corners.iter().map(cells).collect::<Option<Vec<_>>>().is_some_and(|cells| straight(&cells).is_none()) {
        return Err(wrong());
    }
    let mut moves = Track { cells: Vec::new(), size: 1, from_step: 0, steps_per_cell: 1, at_end: AtEnd::BackAndForth };
    for pair in named.split(',').filter(|pair| !pair.is_empty()) {
        let (key, value) = pair.split_once('=').ok_or_else(wrong)?;
        let number = || value.parse().map_err(|_| wrong());
        match key {
            "size" => moves.size = number()?,
            "from" => moves.from_step = number()?,
            "each" => moves.steps_per_cell = number()?,
            "end" => moves.at_end = at_end(value).ok_or_else(wrong)?,
            _ => return Err(wrong()),
        }
    }
    Ok(Obstacle { text: text.to_owned(), corners, moves })
}

fn at_end(id: &str) -> Option<AtEnd> {
    [("stay", AtEnd::Stay), ("back-and-forth", AtEnd::BackAndForth), ("loop", AtEnd::Loop), ("leave", AtEnd::Leave)]
        .into_iter()
        .find_map(|(name, end)| (name == id).then_some(end))
}

/// The cells from corner to corner along rows, columns and diagonals; none where two corners lie on none of them, or beyond any map.
fn straight(corners: &[Point]) -> Option<Vec<Point>> {
    let mut cells = Vec::new();
    for &to in corners {
        go_straight(&mut cells, to)?;
    }
    Some(cells)
}

fn go_straight(cells: &mut Vec<Point>, to: Point) -> Option<()> {
    let from = cells.last().copied().unwrap_or(to);
    let (dx, dy) = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
    let far = dx.abs().max(dy.abs());
    let straight = dx == 0 || dy == 0 || dx.abs() == dy.abs();
    if !straight || far > i64::from(crate::map::MAX_SIDE) {
        return None;
    }
    let along = |v: u32, d: i64, k: i64| (i64::from(v) + d.signum() * k) as u32;
    let first = i64::from(!cells.is_empty());
    cells.extend((first..=far).map(|k| Point::new(along(from.x, dx, k), along(from.y, dy, k))));
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::Grid;
    use crate::scenario::World;

    /// On a map of 20 × 20 cells of half a metre, its lower left corner at (−5 m, −5 m).
    fn obstacle(text: &str) -> Result<Track, String> {
        let grid = Grid::open(20, 20).expect("a map");
        let spec = ScenarioSpec::new(&grid, Point::new(0, 0), Point::new(19, 19));
        let spec = ScenarioSpec { resolution: 0.5, world: Some(World::at(-5.0, -5.0)), ..spec };
        read(text)?.on(&spec).map_err(|error| error.to_string())
    }

    #[test]
    fn obstacles_are_read_as_they_are_written() {
        let cells = |text| obstacle(text).map(|track| track.cells.iter().map(|p| (p.x, p.y)).collect::<Vec<_>>());
        assert_eq!(cells("3,4"), Ok(vec![(3, 4)]));
        assert_eq!(cells("3,4:5,4:5,3"), Ok(vec![(3, 4), (4, 4), (5, 4), (5, 3)]));
        assert_eq!(cells("3,4:1,2"), Ok(vec![(3, 4), (2, 3), (1, 2)]));
        let full = obstacle("3,4:5,4,size=2,from=7,each=3,end=loop").expect("an obstacle");
        assert_eq!((full.cells.len(), full.size, full.from_step, full.steps_per_cell, full.at_end), (3, 2, 7, 3, AtEnd::Loop));
        for wrong in ["", "3", "3,4:5,5:9,9", "3,4,size", "3,4,width=2", "3,4,size=x", "3,4,end=go", "0,0:99999,0", "size=2"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn corners_may_be_metres() {
        let cells = |text| obstacle(text).map(|track| track.cells.iter().map(|p| (p.x, p.y)).collect::<Vec<_>>());
        assert_eq!(cells("0m,0m:0m,1m"), Ok(vec![(10, 9), (10, 8), (10, 7)]));
        assert_eq!(cells("-1m,0m:9,9,end=leave"), Ok(vec![(8, 9), (9, 9)]), "some in metres, some in cells");
        assert!(cells("0m,0m:1m,0.5m").is_err_and(|said| said.contains("10,9:12,8")));
        assert!(cells("0m,7m").is_err_and(|said| said.contains("beside the map")));
    }
}
