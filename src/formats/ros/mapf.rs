//! Instances of multi-agent path finding, as libMultiRobotPlanning has them: obstacles, and agents with a start and a goal. The first agent's
//! question is taken; the map is drawn with y downwards.

use super::yaml::{self, Value};
use crate::error::{FormatError, Notice};
use crate::map::{Grid, Point, check_size};

/// An instance as read.
pub(in crate::formats) struct Instance {
    pub grid: Grid,
    pub start: Option<Point>,
    pub goal: Option<Point>,
    pub notices: Vec<Notice>,
}

/// Reads an instance.
///
/// # Errors
/// [`FormatError`] with the line of broken YAML, or the field at fault.
pub(in crate::formats) fn read(text: &str) -> Result<Instance, FormatError> {
    let document = yaml::read(text)?;
    let size = document.get(&["map", "dimensions"]).and_then(Value::numbers);
    let Some(&[width, height]) = size else {
        return Err(FormatError::field("dimensions", "no two numbers", "[columns, rows]"));
    };
    let whole = |n: f64| if n.fract() == 0.0 && (0.0..1e6).contains(&n) { n as u64 } else { 0 };
    check_size(whole(width), whole(height))?;
    let mut grid = Grid::open(width as u32, height as u32)?;
    let obstacles = document.get(&["map", "obstacles"]).map_or(Some(&[][..]), Value::list);
    let obstacles = obstacles.ok_or_else(|| FormatError::field("obstacles", "no list of pairs", "[[x, y], …]"))?;
    for value in obstacles {
        let at = place(&grid, value, "obstacles")?;
        let cell = grid.cell(at);
        grid.set_blocked(cell, true);
    }
    let agents = document.get(&["agents"]).or(document.get(&["robots"])).and_then(Value::list).unwrap_or(&[]);
    let (start, goal) = match agents.first() {
        Some(agent @ Value::Numbers(_)) => (Some(place(&grid, agent, "robots")?), None),
        Some(agent) => {
            let end = |key: &str| agent.get(&[key]).map(|value| place(&grid, value, "agents")).transpose();
            let goals = agent.get(&["potentialGoals"]).and_then(Value::list).and_then(<[_]>::first);
            let goal = end("goal")?;
            (end("start")?, if goal.is_some() { goal } else { goals.map(|g| place(&grid, g, "agents")).transpose()? })
        }
        None => (None, None),
    };
    let count = agents.len();
    let message = match count {
        0 => "an instance of multi-agent path finding without agents: its map alone was read".to_owned(),
        _ => format!(
            "an instance of multi-agent path finding: of {count} agents the first one's question is asked; y runs downwards here"
        ),
    };
    let notices = vec![Notice::new("mapf", message).with("count", count)];
    Ok(Instance { grid, start, goal, notices })
}

/// A cell of the map.
fn place(grid: &Grid, value: &Value, field: &'static str) -> Result<Point, FormatError> {
    let wrong = || FormatError::field(field, "a place is no cell of the map", "[column, row] within the dimensions");
    let &[x, y] = value.numbers().ok_or_else(wrong)? else { return Err(wrong()) };
    let inside = |n: f64, side: u32| n.fract() == 0.0 && n >= 0.0 && n < f64::from(side);
    let fits = inside(x, grid.width()) && inside(y, grid.height());
    if fits { Ok(Point::new(x as u32, y as u32)) } else { Err(wrong()) }
}
