//! `c2warp weights`: the sites that move a point, with their weights.

use std::path::PathBuf;

use crate::error::CliError;
use crate::number::text;
use crate::points;
use crate::scene::{Files, Scene};

/// Writes the weights at any points: point,site,kind,handle,site_x,site_y,weight
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: Files,
    /// The points, under a header x,y
    #[arg(long, value_name = "POINTS.csv")]
    at: PathBuf,
    /// Where to write, - is standard output: a row for every weight that is not zero, points and sites counted from 0
    #[arg(short, long, value_name = "OUT.csv")]
    output: PathBuf,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let points = points::read(&arguments.at)?;
    let scene = Scene::open(&arguments.files)?;
    let output = scene.output(&arguments.output)?;
    let solution = scene.solve()?;
    output.finish_table(|table| {
        table.write_record(["point", "site", "kind", "handle", "site_x", "site_y", "weight"])?;
        for (point, &place) in points.iter().enumerate() {
            for (index, weight) in solution.weights_at(place).unwrap_or_default().into_iter().filter(|&(_, w)| w > 0.0)
            {
                let site = &solution.sites()[index];
                let kind = if site.kind.is_real() { "real" } else { "virtual" };
                // Sites of a held boundary are real, but belong to no handle.
                let handle = site.kind.handle().map_or("", |handle| scene.project.handles[handle].id.as_str());
                table.write_record([
                    &point.to_string(),
                    &index.to_string(),
                    kind,
                    handle,
                    &text(site.rest.x),
                    &text(site.rest.y),
                    &text(weight),
                ])?;
            }
        }
        Ok(())
    })
}
