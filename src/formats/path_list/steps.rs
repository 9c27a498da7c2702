//! Paths of files as steps from cell to neighbouring cell, as a path by hand goes.

use super::{PathOnMap, read_path_on};
use crate::error::{FormatError, Notice};
use crate::map::{Moves, Point};
use crate::path::PathKind;
use crate::scenario::ScenarioSpec;

/// A path may be so long.
const MOST_CELLS: usize = 1_000_000;

/// Reads a path of a map as steps. Places further apart than a step are joined by the straight line of cells between them, which is said;
/// so are the corners of a polyline. The cells may be blocked and the steps forbidden: [`crate::path::audit`] tells.
///
/// ```
/// use formicarium::formats::read_steps_on;
/// use formicarium::map::{Grid, Point};
/// use formicarium::scenario::ScenarioSpec;
///
/// let spec = ScenarioSpec::new(&Grid::open(9, 9)?, Point::new(0, 0), Point::new(3, 1));
/// let (path, notices) = read_steps_on(b"x,y\n0,0\n3,1\n", &spec)?;
/// assert_eq!(path, [(0, 0), (1, 0), (2, 1), (3, 1)].map(|(x, y)| Point::new(x, y)));
/// assert_eq!(notices[0].kind, "path-joined");
/// # Ok::<(), formicarium::error::Error>(())
/// ```
///
/// # Errors
/// As [`read_path_on`], for a path with levels, for one without places or of more than a million cells, and for a place beside the map.
pub fn read_steps_on(bytes: &[u8], spec: &ScenarioSpec) -> Result<(Vec<Point>, Vec<Notice>), FormatError> {
    let PathOnMap { places, kind, metres, mut notices, .. } = read_path_on(bytes, spec)?;
    if metres.is_some_and(|metres| metres.between_centres(spec).is_some()) {
        let message = "its places were moved to the centres of their cells, as steps go: `check` measures the path as it is";
        notices.push(Notice::new("path-moved", message));
    }
    if let Some(index) = places.iter().position(|(_, level)| level.is_some()) {
        return Err(FormatError::syntax(0, format!("place {index} has a level"), "places without levels: column and row"));
    }
    if let Some((index, (at, _))) = places.iter().enumerate().find(|(_, (at, _))| at.x >= spec.width || at.y >= spec.height) {
        let what = format!("place {index} ({}, {}) lies beside the map", at.x, at.y);
        return Err(FormatError::syntax(0, what, "places on the map: check against the one that the path was planned on"));
    }
    let Some(&(first, _)) = places.first() else {
        return Err(FormatError::syntax(0, "the path has no place", "at least its start and its goal"));
    };
    let mut path = vec![first];
    let mut gaps = 0;
    for &(to, _) in &places[1..] {
        gaps += u64::from(join(&mut path, to, spec.movement.moves));
        if path.len() > MOST_CELLS {
            return Err(FormatError::syntax(0, format!("the path has more than {MOST_CELLS} cells"), "a shorter path"));
        }
    }
    if gaps > 0 {
        notices.push(joined(gaps, kind));
    }
    Ok((path, notices))
}

/// Goes on to a cell; whether it is further away than a step. A cell that comes twice in a row counts once.
fn join(path: &mut Vec<Point>, to: Point, moves: Moves) -> bool {
    let Some(&from) = path.last() else { return false };
    let line = line(from, to);
    let is_gap = line.len() > 1;
    for at in line {
        let before = *path.last().unwrap_or(&from);
        // Where one moves along columns and rows alone, a filled-in diagonal has a corner.
        if is_gap && moves == Moves::Four && before.x != at.x && before.y != at.y {
            path.push(Point::new(at.x, before.y));
        }
        path.push(at);
    }
    is_gap
}

/// The cells nearest to the straight line from one to another, one for each column or row, without the first.
fn line(from: Point, to: Point) -> Vec<Point> {
    let (dx, dy) = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
    let steps = dx.abs().max(dy.abs());
    // Half a cell up, so that the division rounds to the nearest one.
    let along = |begin: u32, d: i64, i: i64| (i64::from(begin) + (2 * d * i + steps).div_euclid(2 * steps)) as u32;
    (1..=steps).map(|i| Point::new(along(from.x, dx, i), along(from.y, dy, i))).collect()
}

fn joined(gaps: u64, kind: PathKind) -> Notice {
    let of = |what: &str| format!("{what} were joined by the cells between them ({gaps} times): its length counts those steps");
    let notice = match kind {
        PathKind::Steps => Notice::new("path-joined", of("places that are further apart than a step")),
        PathKind::Polyline => Notice::new("path-polyline-joined", of("corners of a polyline")),
    };
    notice.with("count", gaps)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::Grid;

    fn spec(moves: Moves) -> ScenarioSpec {
        let mut spec = ScenarioSpec::new(&Grid::open(6, 4).unwrap(), Point::new(0, 0), Point::new(5, 3));
        spec.movement.moves = moves;
        spec
    }

    fn cells(text: &str, moves: Moves) -> Vec<(u32, u32)> {
        read_steps_on(text.as_bytes(), &spec(moves)).unwrap().0.iter().map(|at| (at.x, at.y)).collect()
    }

    #[test]
    fn places_between_the_centres_of_cells_are_moved_and_that_is_told() {
        let kinds = |text: &str| {
            let (path, notices) = read_steps_on(text.as_bytes(), &spec(Moves::Eight)).unwrap();
            (path.len(), notices.into_iter().map(|n| n.kind).collect::<Vec<_>>())
        };
        assert_eq!(kinds("x_m,y_m\n0.5,3.5\n1.2,3.2\n1.5,2.5\n"), (3, vec!["path-map-unplaced".into(), "path-moved".into()]));
        assert_eq!(kinds("x_m,y_m\n0.5,3.5\n1.5,2.5\n"), (2, vec!["path-map-unplaced".into()]));
    }

    #[test]
    fn steps_stay_as_they_are_and_are_not_remarked() {
        let (path, notices) = read_steps_on(b"[[0, 0], [1, 1], [1, 1], [2, 1]]", &spec(Moves::Eight)).unwrap();
        assert_eq!(path, [(0, 0), (1, 1), (2, 1)].map(|(x, y)| Point::new(x, y)));
        assert_eq!(notices, []);
    }

    #[test]
    fn a_diagonal_is_a_step_or_has_a_corner_but_what_the_file_says_is_kept() {
        assert_eq!(cells("[[0, 0], [2, 2]]", Moves::Eight), [(0, 0), (1, 1), (2, 2)]);
        assert_eq!(cells("[[0, 0], [2, 2]]", Moves::Four), [(0, 0), (1, 0), (1, 1), (2, 1), (2, 2)]);
        assert_eq!(cells("[[0, 0], [1, 1]]", Moves::Four), [(0, 0), (1, 1)]);
        assert_eq!(cells("[[5, 3], [1, 2]]", Moves::Eight), [(5, 3), (4, 3), (3, 3), (2, 2), (1, 2)]);
    }

    #[test]
    fn corners_of_a_polyline_are_joined_as_such() {
        let text = "{\"objective\": \"polyline-length\", \"path\": [[0,0],[5,1]]}";
        let (path, notices) = read_steps_on(text.as_bytes(), &spec(Moves::Eight)).unwrap();
        assert_eq!(path.len(), 6);
        assert_eq!(notices[0].kind, "path-polyline-joined");
    }

    #[test]
    fn metres_become_the_cells_in_which_they_lie() {
        let pose = |x: f64, y: f64| format!("- pose: {{position: {{x: {x}, y: {y}, z: 0.0}}, orientation: {{w: 1.0}}}}\n");
        let text = format!("header: {{frame_id: map}}\nposes:\n{}{}", pose(0.25, 3.5), pose(2.5, 3.5));
        assert_eq!(cells(&text, Moves::Eight), [(0, 0), (1, 0), (2, 0)]);
    }

    #[test]
    fn what_lies_beside_the_map_or_has_levels_is_refused_by_name() {
        let fault = |text: &str| read_steps_on(text.as_bytes(), &spec(Moves::Eight)).unwrap_err().to_string();
        assert_eq!(fault("x,y\n0,0\n1,4\n"), "place 1 (1, 4) lies beside the map");
        assert_eq!(fault("[[0, 0, 4], [1, 1, 4]]"), "place 0 has a level");
        assert_eq!(fault("{\"path\": []}"), "the path has no place");
    }
}
