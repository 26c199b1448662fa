//! `c2warp inspect`: a report of the solution, with the time of each stage.

use std::time::Instant;

use c2warp::{Inspection, Solver, StageTimes};
use serde_json::Value;

use crate::error::CliError;
use crate::output;
use crate::project::{InputFiles, LoadedProject};

/// Reports the solution of a project and the time of each stage
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: the report for another program\n  \
                        c2warp inspect cat.c2warp.json --json")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// Print one JSON object instead of a table
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let loaded = LoadedProject::open(&arguments.files)?;
    let inspection = inspect(&loaded)?;
    let json = serde_json::to_value(&inspection).expect("a map of numbers is valid JSON");
    let text = if arguments.json { format!("{json:#}\n") } else { lines("", &json) };
    output::print(text.as_bytes())
}

fn inspect(loaded: &LoadedProject) -> Result<Inspection, CliError> {
    let refused = |reason| loaded.refused(reason);
    let mut ms = StageTimes::default();
    let mut solver = Solver::new();
    let mut start = Instant::now();
    solver.begin(&loaded.project, &loaded.picture()?).map_err(refused)?;
    while let Some(stage) = solver.advance().map_err(refused)? {
        ms.add(stage, lap_ms(&mut start));
    }
    let solution = solver.solution().expect("every stage has run");
    start = Instant::now();
    let pose = loaded.pose(solution)?;
    ms.pose = lap_ms(&mut start);
    Ok(Inspection { report: solution.report(&pose), ms })
}

/// Returns one line per value: its key with spaces, then the value.
fn lines(name: &str, value: &Value) -> String {
    if let Value::Object(entries) = value {
        return entries.iter().map(|(key, value)| lines(format!("{name} {key}").trim(), value)).collect();
    }
    format!("{:<20} {:>12}\n", name.replace('_', " "), cell(value))
}

fn cell(value: &Value) -> String {
    match value {
        Value::Number(number) if number.is_f64() => format!("{:.3}", number.as_f64().unwrap_or(f64::NAN)),
        Value::Array(values) if values.is_empty() => "none".into(),
        Value::Array(values) => values.iter().map(cell).collect::<Vec<_>>().join(" "),
        Value::Object(entries) => {
            entries.iter().map(|(key, value)| format!("{key} {}", cell(value))).collect::<Vec<_>>().join(" ")
        }
        Value::String(text) => text.clone(),
        value => value.to_string(),
    }
}

/// Returns the milliseconds since `start`, and restarts.
fn lap_ms(start: &mut Instant) -> f64 {
    let now = Instant::now();
    let ms = (now - *start).as_secs_f64() * 1e3;
    *start = now;
    ms
}
