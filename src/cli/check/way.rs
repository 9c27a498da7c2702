//! A path whose places are no centres of cells, as robots are sent them: measured as it is, not as the staircase of its cells.

use serde::Serialize;

use super::Args;
use super::price::Price;
use crate::cli::text::{self, TextOrJson, row};
use crate::cli::{Outcome, driving};
use crate::findings::WayFindings;
use crate::formats::Imported;
use crate::map::Point;
use crate::metrics::Place;

/// What is wrong with a way, and what it costs.
#[derive(Serialize)]
struct Checked {
    #[serde(flatten)]
    findings: WayFindings,
    #[serde(skip_serializing_if = "Option::is_none")]
    price: Option<Price>,
}

/// What is printed of a way with places between the centres of cells; none of any other, and on a terrain, where its cells count.
pub(super) fn check(args: &Args, map: &Imported, places: &[Place]) -> Option<Outcome> {
    let nearest = |&[x, y]: &Place| Point::new(libm::round(x).max(0.0) as u32, libm::round(y).max(0.0) as u32);
    let cells: Vec<Point> = places.iter().map(nearest).collect();
    let findings = WayFindings::of(&map.grid, &map.spec, !map.ends_were_chosen(), places, &cells)?;
    let price = Price::of_way(map, places, &cells, &findings, args.judged());
    let (fine, checked) = (findings.ok, Checked { findings, price });
    let text = match args.format {
        TextOrJson::Text => whole_text(&checked, map, places.len()),
        TextOrJson::Json => text::json(&checked, 2),
    };
    Some(Outcome { text, fine })
}

fn whole_text(Checked { findings, price }: &Checked, map: &Imported, places: usize) -> String {
    let (spec, count) = (&map.spec, text::count(places as u64, "place", "places"));
    let mut out = format!("{count} on {}, between the centres of cells: measured as they are\n\n", spec.name);
    row(&mut out, "verdict", if findings.ok { "a valid way" } else { "not a valid way" });
    for end in &findings.wrong_ends {
        row(&mut out, "ends", end);
    }
    let narrow = spec.robot.map(|_| ("too narrow", &findings.narrow));
    for (label, cells) in [("collisions", &findings.collisions)].into_iter().chain(narrow) {
        let told = |first: &Point| format!("comes into {}, first {}", cells_in_words(cells.len()), text::cell(*first));
        row(&mut out, label, cells.first().map_or("none".into(), told));
    }
    let (metrics, scale) = (&findings.metrics, spec.scale());
    row(&mut out, "length", text::length(metrics.length, scale));
    row(&mut out, "turning", driving::turning(metrics.turning));
    row(&mut out, "clearance", text::clearance(metrics.min_clearance, metrics.mean_clearance, scale));
    row(&mut out, "driving time", format!("{} (it turns on its way)", text::seconds(metrics.travel_time)));
    if let Some(price) = price {
        price.text(&mut out);
    }
    out
}

fn cells_in_words(count: usize) -> String {
    text::count(count as u64, "cell", "cells")
}
