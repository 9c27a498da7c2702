//! Arguments and lines about driving.

use crate::metrics::Driving;
use crate::scenario::{SmoothingRule, Vehicle};
use crate::smoothing::Smoothed;

use super::text::{self, grouped, row};

/// Whether the path is to be a curve.
#[derive(clap::Args)]
pub struct DrivingArgs {
    /// The path as a smooth curve as well, no tighter than so much per metre (1 / radius) if that is given [default: as the map says]
    #[arg(long, value_name = "CURVATURE", num_args = 0..=1, require_equals = true, value_parser = curvature)]
    smooth: Option<Option<f64>>,
}

impl DrivingArgs {
    /// Whether a curve is asked for here.
    pub fn asks_for_a_curve(&self) -> bool {
        self.smooth.is_some()
    }

    /// Lets the arguments override a map's vehicle.
    pub fn apply(&self, vehicle: &mut Vehicle) {
        let Some(asked) = self.smooth else { return };
        let own = vehicle.smoothing.unwrap_or_default();
        vehicle.smoothing = Some(asked.map_or(own, |max_curvature| SmoothingRule { max_curvature }));
    }
}

/// Reads a curvature of at least 0.
fn curvature(text: &str) -> Result<f64, String> {
    let curvature = text.trim().parse().ok().filter(|&c: &f64| c.is_finite() && c >= 0.0);
    curvature.ok_or_else(|| format!("`{text}` is no curvature: write a number per metre such as 0.5, or 0 for no bound"))
}

/// The lines about how a path is to drive.
pub fn metrics(out: &mut String, driving: &Driving) {
    row(out, "turning", format!("{}, {}", turning(driving.turning), largest(driving.largest_curvature)));
    row(out, "smoothness", format!("{:.4} per m² (0 = straight)", driving.smoothness));
    row(out, "energy", format!("{:.4}", driving.energy));
}

/// An angle in radians and degrees.
pub fn turning(radians: f64) -> String {
    format!("{radians:.4} rad = {:.0}°", radians.to_degrees())
}

/// The lines about the curve of a path on a map of this scale, if it has one.
pub fn smoothed(out: &mut String, vehicle: &Vehicle, curve: Option<&Smoothed>, scale: Option<f64>) {
    let (Some(curve), Some(rule)) = (curve, vehicle.smoothing) else { return };
    if !curve.is_curve {
        row(out, "smoothed", "no curve is free here: the path stays as it is");
        return;
    }
    let saved = if curve.saved < 0.0 { "more" } else { "less" };
    let (length, points) = (text::length(curve.length, scale), grouped(curve.points.len() as u64));
    row(out, "smoothed", format!("{length}, {:.4} cells {saved} than the path, {points} points", curve.saved.abs()));
    let bound = match rule.max_curvature {
        0.0 => "without a bound".into(),
        bound if curve.meets_bound => format!("within the bound of {bound}"),
        bound => {
            format!("above the bound of {bound}: no wider turn is free; costs near obstacles or a larger radius make room for it")
        }
    };
    row(out, "", format!("{}, {bound}", largest(curve.largest_curvature)));
    if let Some(metrics) = &curve.metrics {
        row(out, "", format!("clearance {}", text::clearance(metrics.min_clearance, metrics.mean_clearance, scale)));
        let cost = metrics.cost.map_or_else(String::new, |cost| format!(", cost {cost:.4} cells"));
        row(out, "", format!("driving time {}{cost}", text::seconds(metrics.travel_time)));
    }
}

fn largest(curvature: Option<f64>) -> String {
    curvature.map_or_else(|| "it turns on the spot".into(), |c| format!("largest curvature {c:.4} per metre"))
}
