//! `c2warp map`: the posed places of points, and the determinant of the Jacobian there; or the way back.

use std::path::PathBuf;

use c2warp::Solution;
use c2warp::pose::Pose;
use glam::DVec2;

use crate::error::CliError;
use crate::number::text;
use crate::output::Table;
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
    /// The way back: the points are of the warped picture, and x,y,rest_x,rest_y is written: which place of the picture is drawn
    /// there; cells are empty where none is
    #[arg(long)]
    inverse: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let points = points::read(&arguments.at)?;
    let scene = Scene::open(&arguments.files)?;
    let output = scene.output(&arguments.output)?;
    let solution = scene.solve()?;
    let pose = scene.pose(&solution)?;
    output.finish_table(|table| match arguments.inverse {
        false => write_posed(table, &solution, &pose, &points),
        true => write_rests(table, &solution, &pose, &points),
    })
}

fn write_posed(table: &mut Table<'_>, solution: &Solution, pose: &Pose, points: &[DVec2]) -> csv::Result<()> {
    table.write_record(["x", "y", "posed_x", "posed_y", "det"])?;
    for &place in points {
        let mapped = solution.map(pose, place);
        let cells = mapped.map(|at| [at.posed.x, at.posed.y, at.det].map(text)).unwrap_or_default();
        table.write_record([text(place.x), text(place.y)].iter().chain(&cells))?;
    }
    Ok(())
}

fn write_rests(table: &mut Table<'_>, solution: &Solution, pose: &Pose, points: &[DVec2]) -> csv::Result<()> {
    table.write_record(["x", "y", "rest_x", "rest_y"])?;
    for (place, rest) in points.iter().zip(solution.rests_of(pose, points)) {
        let cells = rest.map(|rest| [rest.x, rest.y].map(text)).unwrap_or_default();
        table.write_record([text(place.x), text(place.y)].iter().chain(&cells))?;
    }
    Ok(())
}
