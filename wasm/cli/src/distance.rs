//! `c2warp distance`: intrinsic distances from one point to others.

use std::path::PathBuf;

use c2warp_maps::decimal;
use glam::DVec2;

use crate::error::CliError;
use crate::output::Output;
use crate::points;
use crate::project::{InputFiles, LoadedProject};

/// Writes the intrinsic distances from one point to others, as rows x,y,distance
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: distances from one point to others, measured inside the picture\n  \
                        c2warp distance cat.c2warp.json --from 90,120 --at points.csv -o distances.csv")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The start point
    #[arg(long, value_name = "X,Y", value_parser = points::parse, allow_hyphen_values = true)]
    from: DVec2,
    /// The end points: CSV with a header x,y
    #[arg(long, value_name = "POINTS.csv")]
    at: PathBuf,
    /// The output file, or - for standard output. A distance is empty if no path leads to its point
    #[arg(short, long, value_name = "OUT.csv")]
    output: PathBuf,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let points = points::read(&arguments.at)?;
    let loaded = LoadedProject::open(&arguments.files)?;
    let output = Output::open(&arguments.output)?;
    let distances = c2warp::distances(&loaded.project, &loaded.picture()?, arguments.from, &points)
        .map_err(|reason| loaded.refused(reason))?;
    output.write_table(|table| {
        table.write_record(["x", "y", "distance"])?;
        for (p, distance) in points.iter().zip(distances) {
            table.write_record([decimal(p.x), decimal(p.y), distance.map(decimal).unwrap_or_default()])?;
        }
        Ok(())
    })
}
