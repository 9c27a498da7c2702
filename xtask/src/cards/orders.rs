//! The fire-fighting paper's figure 5: what the single ways weigh in the two orders of its fires, by straight lines, as a drawing.

use std::fmt::Write;
use std::fs;

use anyhow::{Context, Result};
use serde_json::Value;

use crate::tools::root;

const MAP: &str = "experiments/maps/fire-20x20.json";
const DRAWING: &str = "docs/papers/fire-figure-5.svg";

/// A fire: where it is, its name, and b = 1 / (strength · danger · area).
struct Fire {
    at: [f64; 2],
    name: String,
    b: f64,
}

/// Draws it anew.
pub fn draw() -> Result<()> {
    let map: Value = serde_json::from_str(&fs::read_to_string(root().join(MAP))?)?;
    let start = point(&map["start"]).with_context(|| format!("{MAP} has no start"))?;
    let fires = map["goals"].as_array().into_iter().flatten().map(fire).collect::<Option<Vec<_>>>();
    let fires = fires.with_context(|| format!("{MAP} has no fires"))?;
    let shortest = best_order(&fires, |order| ways(start, &fires, order).iter().map(|way| way.0).sum());
    let lightest = best_order(&fires, |order| ways(start, &fires, order).iter().map(|way| way.1).sum());
    let curves = [("shortest order", shortest), ("order of least weight", lightest)].map(|(what, order)| {
        let names = order.iter().map(|&i| fires[i].name.as_str()).collect::<Vec<_>>().join("-");
        (format!("{what}, O-{names}"), ways(start, &fires, &order).iter().map(|way| way.1).collect())
    });
    fs::write(root().join(DRAWING), svg(&curves))?;
    Ok(())
}

fn point(value: &Value) -> Option<[f64; 2]> {
    Some([value.get(0)?.as_f64()?, value.get(1)?.as_f64()?])
}

fn fire(goal: &Value) -> Option<Fire> {
    let number = |key: &str| goal[key].as_f64();
    let b = 1.0 / (number("strength")? * number("danger")? * number("area")?);
    Some(Fire { at: point(&goal["at"])?, name: goal["name"].as_str()?.into(), b })
}

/// Length and weight of the ways of an order.
fn ways(start: [f64; 2], fires: &[Fire], order: &[usize]) -> Vec<(f64, f64)> {
    let places = std::iter::once(start).chain(order.iter().map(|&i| fires[i].at));
    let length = |([x, y], fire): ([f64; 2], &Fire)| (fire.at[0] - x).hypot(fire.at[1] - y);
    places
        .zip(order.iter().map(|&i| &fires[i]))
        .map(|(from, fire)| (length((from, fire)), length((from, fire)) * fire.b))
        .collect()
}

/// The order of the least sum, of all that there are.
fn best_order(fires: &[Fire], sum: impl Fn(&[usize]) -> f64) -> Vec<usize> {
    let mut best: Option<(f64, Vec<usize>)> = None;
    each_order((0..fires.len()).collect(), 0, &mut |order| {
        let found = sum(order);
        if best.as_ref().is_none_or(|(least, _)| found < *least) {
            best = Some((found, order.to_vec()));
        }
    });
    best.map_or_else(Vec::new, |(_, order)| order)
}

fn each_order(mut order: Vec<usize>, from: usize, with: &mut impl FnMut(&[usize])) {
    if from == order.len() {
        return with(&order);
    }
    for i in from..order.len() {
        order.swap(from, i);
        each_order(order.clone(), from + 1, with);
        order.swap(from, i);
    }
}

/// Two curves over the number of the way, in the colours of Okabe and Ito, on a ground that shows in dark and in light.
fn svg(curves: &[(String, Vec<f64>); 2]) -> String {
    const STYLES: [(&str, &str); 2] = [("#d55e00", "6 4"), ("#0072b2", "none")];
    let top = curves.iter().flat_map(|(_, weights)| weights).fold(0.0, |a: f64, b| a.max(*b)).ceil();
    let (x, y) = (|way: usize| 60 + 120 * way, |weight: f64| 260.0 - 220.0 * weight / top);
    let mut out = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"480\" height=\"340\" viewBox=\"0 0 480 340\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <title>Weights of the single ways in both orders of the fires</title>\n<rect width=\"480\" height=\"340\" fill=\"#ffffff\"/>\n",
    );
    for tick in (0..=top as u32).step_by(5) {
        let at = y(tick.into());
        let _ = writeln!(
            out,
            "<path d=\"M60 {at:.1}H440\" stroke=\"#dddddd\"/><text x=\"50\" y=\"{:.1}\" text-anchor=\"end\">{tick}</text>",
            at + 4.0
        );
    }
    for way in 0..curves[0].1.len() {
        let _ = writeln!(out, "<text x=\"{}\" y=\"280\" text-anchor=\"middle\">way {}</text>", x(way), way + 1);
    }
    for (place, ((name, weights), (colour, dashes))) in curves.iter().zip(STYLES).enumerate() {
        let points = weights.iter().enumerate().map(|(way, weight)| format!("{},{:.1}", x(way), y(*weight)));
        let points = points.collect::<Vec<_>>().join(" ");
        let _ = writeln!(
            out,
            "<polyline points=\"{points}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\" stroke-dasharray=\"{dashes}\"/>"
        );
        for (way, weight) in weights.iter().enumerate() {
            let _ = writeln!(
                out,
                "<circle cx=\"{}\" cy=\"{:.1}\" r=\"4\" fill=\"{colour}\"><title>{weight:.2}</title></circle>",
                x(way),
                y(*weight)
            );
        }
        let at = 305 + 20 * place;
        let _ = writeln!(
            out,
            "<path d=\"M60 {}h30\" stroke=\"{colour}\" stroke-width=\"2\" stroke-dasharray=\"{dashes}\"/><text x=\"100\" y=\"{at}\">{name}</text>",
            at - 4
        );
    }
    out + "<text x=\"60\" y=\"24\">weight R of a way, by straight lines</text>\n</svg>\n"
}
