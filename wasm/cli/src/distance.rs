//! `c2warp distance`: intrinsic distances from one point to others.

use std::path::PathBuf;

use glam::DVec2;

use crate::error::CliError;
use crate::number::text;
use crate::points;
use crate::scene::{Files, Scene};

/// Writes the intrinsic distance from one point to others: x,y,distance
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: Files,
    /// The point that distances are measured from
    #[arg(long, value_name = "X,Y", value_parser = points::parse, allow_hyphen_values = true)]
    from: DVec2,
    /// The points, under a header x,y
    #[arg(long, value_name = "POINTS.csv")]
    at: PathBuf,
    /// Where to write, - is standard output; distance is empty where no path leads
    #[arg(short, long, value_name = "OUT.csv")]
    output: PathBuf,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let points = points::read(&arguments.at)?;
    let scene = Scene::open(&arguments.files)?;
    let output = scene.output(&arguments.output)?;
    let distances = c2warp::distances(&scene.project, &scene.picture()?, arguments.from, &points)
        .map_err(|reason| scene.refused(reason))?;
    output.finish_table(|table| {
        table.write_record(["x", "y", "distance"])?;
        for (place, distance) in points.iter().zip(distances) {
            table.write_record([text(place.x), text(place.y), distance.map(text).unwrap_or_default()])?;
        }
        Ok(())
    })
}
