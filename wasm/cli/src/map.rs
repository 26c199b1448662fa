//! `c2warp map`: the posed places of points, and the determinant of the Jacobian there.

use std::path::PathBuf;

use crate::error::CliError;
use crate::number::text;
use crate::points;
use crate::scene::{Files, Scene};

/// Writes where any points go: x,y,posed_x,posed_y,det
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: Files,
    /// The points, under a header x,y
    #[arg(long, value_name = "POINTS.csv")]
    at: PathBuf,
    /// Where to write, - is standard output; det is the determinant of the Jacobian, and cells are empty outside the domain
    #[arg(short, long, value_name = "OUT.csv")]
    output: PathBuf,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let points = points::read(&arguments.at)?;
    let scene = Scene::open(&arguments.files)?;
    let output = scene.output(&arguments.output)?;
    let solution = scene.solve()?;
    let pose = scene.pose(&solution)?;
    output.finish_table(|table| {
        table.write_record(["x", "y", "posed_x", "posed_y", "det"])?;
        for &place in &points {
            let cells = solution
                .map(&pose, place)
                .map(|mapped| [mapped.posed.x, mapped.posed.y, mapped.det].map(text))
                .unwrap_or_default();
            table.write_record([text(place.x), text(place.y)].iter().chain(&cells))?;
        }
        Ok(())
    })
}
