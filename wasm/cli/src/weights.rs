//! `c2warp weights`: the sites that influence points, with their weights.

use std::path::PathBuf;

use crate::error::CliError;
use crate::number::decimal;
use crate::points;
use crate::project::{InputFiles, LoadedProject};

/// Writes the weights at points, as rows point,site,kind,handle,site_x,site_y,weight
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The points: CSV with a header x,y
    #[arg(long, value_name = "POINTS.csv")]
    at: PathBuf,
    /// The output file, or - for standard output. It has one row per weight above 0. Points and sites count from 0
    #[arg(short, long, value_name = "OUT.csv")]
    output: PathBuf,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let points = points::read(&arguments.at)?;
    let loaded = LoadedProject::open(&arguments.files)?;
    let output = loaded.output(&arguments.output)?;
    let solution = loaded.solve()?;
    output.write_table(|table| {
        table.write_record(["point", "site", "kind", "handle", "site_x", "site_y", "weight"])?;
        for (point, &p) in points.iter().enumerate() {
            for (index, weight) in solution.weights_at(p).unwrap_or_default().into_iter().filter(|&(_, w)| w > 0.0) {
                let site = &solution.sites()[index];
                let kind = if site.kind.is_real() { "real" } else { "virtual" };
                // The sites of a held boundary are real, but belong to no handle.
                let handle = site.kind.handle().map_or("", |handle| loaded.project.handles[handle].id.as_str());
                table.write_record([
                    &point.to_string(),
                    &index.to_string(),
                    kind,
                    handle,
                    &decimal(site.rest.x),
                    &decimal(site.rest.y),
                    &decimal(weight),
                ])?;
            }
        }
        Ok(())
    })
}
