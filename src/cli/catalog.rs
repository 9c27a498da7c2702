//! `catalog`: every planner with its presets, components and parameters.

use std::fmt::Write;

use crate::catalog::{CatalogEntry, catalog};
use crate::params::{ParamKind, ParamSpec};

use super::error::CliError;
use super::{Outcome, text};

/// Lists every planner with its presets, its components and its parameters
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium catalog
  formicarium catalog ant-system
  formicarium catalog --json | jq '.planners[].id'")]
pub struct Args {
    /// Only this planner
    planner: Option<String>,
    /// As JSON: {\"format\": \"formicarium/catalog@1\", \"planners\": […]}
    #[arg(long)]
    pub json: bool,
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let mut all = catalog();
    if let Some(id) = &args.planner {
        crate::catalog::find(id)?;
        all.planners.retain(|p| p.id == *id);
    }
    if args.json {
        return Ok(Outcome::fine(text::json(&all, 4)));
    }
    let tables: Vec<String> = all.planners.iter().map(table).collect();
    Ok(Outcome::fine(tables.join("\n")))
}

fn table(planner: &CatalogEntry) -> String {
    let mut out = format!("{} · {}\n  {}\n  {}\n", planner.id, planner.name, planner.summary, planner.source);
    let rows: Vec<[String; 4]> = planner.params.iter().map(param_row).collect();
    let wide = |column: usize| rows.iter().map(|r| r[column].chars().count()).max().unwrap_or(0);
    let (key, default, range) = (wide(0), wide(1), wide(2));
    for (i, [k, d, r, meaning]) in rows.iter().enumerate() {
        let gap = if i == 0 { "\n" } else { "" };
        let _ = writeln!(out, "{gap}  {k:<key$}  {d:>default$}  {r:<range$}  {meaning}");
    }
    if let Some(reading) = planner.reading {
        let _ = writeln!(out, "\n  without a preset\n    reading: {}", reading.id());
    }
    for preset in &planner.presets {
        let values: Vec<String> = preset.values.iter().map(|(k, v)| format!("{k}={v}")).collect();
        let reading = preset.reading.map_or_else(String::new, |reading| format!("\n    reading: {}", reading.id()));
        let (name, meaning, source) = (&preset.name, &preset.meaning, &preset.source);
        let _ = writeln!(out, "\n  --preset {name}: {meaning} ({source})\n    {}{reading}", values.join(" "));
    }
    for component in &planner.components {
        let values: Vec<String> = component.without.iter().map(|(k, v)| format!("--set {k}={v}")).collect();
        let _ = writeln!(out, "\n  without {}: {}\n    {}", component.id, values.join(" "), component.adds);
    }
    out
}

/// Key, default, range, meaning.
fn param_row(spec: &ParamSpec) -> [String; 4] {
    [spec.key.into(), spec.default.to_string(), range(spec), spec.meaning.into()]
}

/// What a parameter takes, in short.
fn range(spec: &ParamSpec) -> String {
    let unit = if spec.unit.is_empty() { String::new() } else { format!(" {}", spec.unit) };
    match &spec.kind {
        ParamKind::Integer { min, max } => format!("{min} to {max}{unit}"),
        ParamKind::Real { min, max } => format!("{min} to {max}{unit}"),
        ParamKind::Flag => "true | false".into(),
        ParamKind::Choice { options } => options.iter().map(|o| o.id).collect::<Vec<_>>().join(" | "),
    }
}
