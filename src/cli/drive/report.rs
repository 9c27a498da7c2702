//! A drive in words.

use crate::cli::plan::effort_text;
use crate::cli::text::{self, count, grouped, row};
use crate::drive::{Did, Drive, DriveStep, End, Stuck, TooMuch};
use crate::exact::Reference;
use crate::scenario::Scenario;

pub fn text(scenario: &Scenario, name: &str, seed: u32, drive: &Drive, steps: &[DriveStep]) -> String {
    let (grid, spec) = (&scenario.grid, &scenario.spec);
    let on = if spec.name.is_empty() { String::new() } else { format!(" on {}", spec.name) };
    let mut out = format!("A drive by {name}{on} ({} × {})\n\n", grid.width(), grid.height());
    row(&mut out, "from, to", format!("{} → {}", text::cell(spec.start), text::cell(spec.goals[0].at)));
    row(&mut out, "what moves", what_moves(scenario));
    row(&mut out, "end", end(drive.end, steps));
    row(&mut out, "length", format!("{:.4} cells = {:.4} m", drive.length, drive.length * spec.resolution));
    if let Some(cost) = drive.cost {
        row(
            &mut out,
            "cost",
            format!("{cost:.4} cells: every move counts its length times the factors of its cells as they were then"),
        );
    }
    let (moves, waits) = (count(drive.moves.into(), "move", "moves"), count(drive.waits.into(), "wait", "waits"));
    row(&mut out, "steps", format!("{moves}, {waits}"));
    row(&mut out, "turns", drive.turns);
    row(&mut out, if drive.end == Some(End::Arrived) { "arrival time" } else { "time" }, text::seconds(drive.travel_time));
    row(&mut out, "in advance", in_advance(drive));
    row(&mut out, "planned again", count(drive.replans.into(), "time", "times"));
    row(&mut out, "effort", effort_text(&drive.effort));
    row(&mut out, "way", way(steps));
    row(&mut out, "seed", seed);
    row(&mut out, "digest", &drive.digest);
    out
}

fn what_moves(scenario: &Scenario) -> String {
    let Some(moving) = &scenario.spec.drive else { return "nothing".into() };
    let (walls, tracks) = (moving.changes.len() as u64, moving.tracks.len() as u64);
    let sight = moving.sight.map_or_else(String::new, |sight| format!("; it sees {sight} cells far"));
    let walls = count(walls, "change of walls", "changes of walls");
    format!("{walls}, {}{sight}", count(tracks, "obstacle", "obstacles"))
}

fn end(end: Option<End>, steps: &[DriveStep]) -> String {
    let at = steps.last().map_or_else(String::new, |last| format!(" at {} after {}", text::cell(last.at), last.step));
    match end {
        None => "on its way".into(),
        Some(End::Arrived) => "arrived".into(),
        Some(End::Stuck(why)) => format!(
            "gave up{at} steps: {}",
            match why {
                Stuck::NoPath => "no path leads to the goal, as far as it knows",
                Stuck::NotFound => "the planner found no path in its iterations",
                Stuck::NoRoom => "it touches a wall that was not there before",
                Stuck::GoalTaken => "something stands on the goal, as far as it knows",
                Stuck::Held => "the next cell stayed taken",
                Stuck::TooLong => "it may drive no longer",
            }
        ),
    }
}

/// What somebody would have driven who knew everything in advance.
fn in_advance(drive: &Drive) -> String {
    let times = if drive.cost.is_some() { "costs {} times as much" } else { "is {} times as long" };
    match (drive.clairvoyant, drive.ratio) {
        (Reference::Proven { value }, Some(ratio)) => {
            format!("{value:.4} cells at best; this drive {}", times.replace("{}", &format!("{ratio:.4}")))
        }
        (Reference::Proven { value } | Reference::Unproven { value }, _) => format!("{value:.4} cells at best"),
        (Reference::NoPath, _) => "no drive arrives".into(),
        (Reference::Unknown, _) => drive.too_much.map_or_else(|| "unknown".into(), unknown),
    }
}

/// Why that is not known.
fn unknown(why: TooMuch) -> String {
    let [cells, steps, most] = match why {
        TooMuch::States { cells, steps, most } | TooMuch::Kept { cells, steps, most } | TooMuch::Felt { cells, steps, most } => {
            [cells, steps, most]
        }
        TooMuch::Period { most } => [0, 0, most],
    }
    .map(|number| grouped(number.into()));
    match why {
        TooMuch::States { .. } => {
            format!("unknown: more than {most} states to search, of {cells} cells that can be reached × {steps} steps so far")
        }
        TooMuch::Kept { .. } => format!("unknown: {cells} cells that can be reached × {steps} steps so far, more than {most}"),
        TooMuch::Felt { .. } => {
            format!("unknown: the robot's room to work out on {cells} cells × {steps} steps so far, more than {most}")
        }
        TooMuch::Period { .. } => format!("unknown: what moves repeats itself only after more than {most} steps"),
    }
}

/// Its cells; `·` for a wait.
fn way(steps: &[DriveStep]) -> String {
    let mut out = String::new();
    for step in steps {
        match step.did {
            Did::Start => out += &text::cell(step.at),
            Did::Move => out += &format!(" {}", text::cell(step.at)),
            Did::Wait => out += " ·",
        }
    }
    out
}
