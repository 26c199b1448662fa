//! `c2warp map`: the posed positions of points with the Jacobian determinant there, or the inverse map. Shapes and
//! landmarks in JSON keep their format.

use std::path::PathBuf;

use c2warp::Solution;
use c2warp::deform::Pose;
use c2warp_maps::decimal;
use glam::DVec2;

use crate::error::CliError;
use crate::input;
use crate::output::{Output, Table};
use crate::points;
use crate::project::{InputFiles, LoadedProject};
use crate::shapes::Shapes;

/// Writes the posed positions of points, as rows x,y,posed_x,posed_y,det, or in the JSON format of the input
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: the positions that the points of a table move to\n  \
                        c2warp map cat.c2warp.json --at points.csv -o moved.csv")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The points: CSV with a header x,y, GeoJSON, or landmarks in JSON
    #[arg(long, value_name = "POINTS.csv|SHAPES.json")]
    at: PathBuf,
    /// The output file, or - for standard output. det is the Jacobian determinant. Cells are empty outside the domain
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Invert the map: the points lie in the warped picture. The rows are x,y,rest_x,rest_y with the point of the
    /// picture drawn there. Cells are empty where nothing is drawn
    #[arg(long)]
    inverse: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let path = &arguments.at;
    let bytes = input::read(path).map_err(CliError::read(path))?;
    if Shapes::is_json(&bytes) {
        return map_shapes(arguments, Shapes::parse(&bytes, path)?);
    }
    let points = points::parse_csv(&bytes, path)?;
    let loaded = LoadedProject::open(&arguments.files)?;
    let output = Output::open(&arguments.output)?;
    let solution = loaded.solve()?;
    let pose = loaded.pose(&solution)?;
    output.write_table(|table| match arguments.inverse {
        false => write_posed(table, &solution, &pose, &points),
        true => write_rest_positions(table, &solution, &pose, &points),
    })
}

/// Maps the points of a JSON file. Points around the domain move with its outline.
fn map_shapes(arguments: &Arguments, shapes: Shapes) -> Result<(), CliError> {
    let refused = |reason| CliError::Shapes { path: arguments.at.clone(), reason };
    let points = shapes.points().map_err(refused)?;
    let loaded = LoadedProject::open(&arguments.files)?;
    let output = Output::open(&arguments.output)?;
    let solution = loaded.solve()?;
    let pose = loaded.pose(&solution)?;
    let places = if arguments.inverse {
        solution.rest_points(&pose, &points)
    } else {
        let map = solution.continued(&pose);
        points.iter().map(|&p| Some(map.place(p))).collect()
    };
    let file = shapes.placed(places).map_err(refused)?;
    output.write(|writer| writeln!(writer, "{file}"))
}

fn write_posed(table: &mut Table<'_>, solution: &Solution, pose: &Pose, points: &[DVec2]) -> csv::Result<()> {
    table.write_record(["x", "y", "posed_x", "posed_y", "det"])?;
    for &p in points {
        let mapped = solution.map(pose, p);
        let cells = mapped.map(|at| [at.posed.x, at.posed.y, at.det].map(decimal)).unwrap_or_default();
        table.write_record([decimal(p.x), decimal(p.y)].iter().chain(&cells))?;
    }
    Ok(())
}

fn write_rest_positions(table: &mut Table<'_>, solution: &Solution, pose: &Pose, points: &[DVec2]) -> csv::Result<()> {
    table.write_record(["x", "y", "rest_x", "rest_y"])?;
    for (p, rest) in points.iter().zip(solution.rest_points(pose, points)) {
        let cells = rest.map(|rest| [rest.x, rest.y].map(decimal)).unwrap_or_default();
        table.write_record([decimal(p.x), decimal(p.y)].iter().chain(&cells))?;
    }
    Ok(())
}
