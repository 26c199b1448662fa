//! `c2warp weights`: the weights of sites or of one handle, as a table, an array or a heat map.

use std::io;
use std::path::{Path, PathBuf};

use c2warp_maps::{Places, TableFormat, Weights, heat_map};

use crate::error::CliError;
use crate::output::Output;
use crate::points;
use crate::project::{InputFiles, LoadedProject};

/// The largest array that is written.
const MOST_BYTES: u64 = 4 << 30;

/// Writes the weights of sites, or of a handle: as CSV, as an array for NumPy, or as a heat map over the picture
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: the weights of all sites at every eighth pixel, for NumPy\n  \
                        c2warp weights cat.c2warp.json --every 8 -o weights.npy")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The points: CSV with a header x,y
    #[arg(long, value_name = "POINTS.csv", required_unless_present_any = ["every", "handle"], conflicts_with = "every")]
    at: Option<PathBuf>,
    /// The points: the centres of every N-th pixel in both directions, row by row. 1 takes all pixels
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    every: Option<f64>,
    /// Write the weight of this handle, including the virtual sites that follow it, instead of all sites
    #[arg(long, value_name = "NAME")]
    handle: Option<String>,
    /// The output file, or - for standard output. OUT.csv has a row for each weight above 0:
    /// point,site,kind,handle,site_x,site_y,weight, or point,x,y,handle,weight with --handle. Points and sites are
    /// numbered from 0. OUT.npy has all weights as 64-bit floats, points × sites, with zeros outside the domain.
    /// OUT.png has the picture at rest under the editor's heat map of one handle
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// The format of the output, regardless of its extension
    #[arg(long, value_enum, value_name = "FORMAT")]
    format: Option<Format>,
    /// Also write the sites in the order of the array, as rows site,kind,handle,site_x,site_y
    #[arg(long, value_name = "OUT.csv")]
    sites: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// A row for each weight above 0
    Csv,
    /// An array for NumPy
    Npy,
    /// A heat map
    Png,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let path = &arguments.output;
    let format = arguments.format.unwrap_or_else(|| format(path));
    let every = arguments.every.map(every).transpose()?;
    let has_points = arguments.at.is_some() || every.is_some();
    match (format, &arguments.handle) {
        (Format::Png, None) => return Err(CliError::HeatHandle { path: path.clone() }),
        (Format::Png, _) if has_points => return Err(CliError::HeatPoints { path: path.clone() }),
        (Format::Csv | Format::Npy, _) if !has_points => return Err(CliError::PointsNeeded { path: path.clone() }),
        _ => {}
    }
    let points = arguments.at.as_deref().map(points::read).transpose()?;
    let loaded = LoadedProject::open(&arguments.files)?;
    let picture = loaded.picture()?;
    let refused = |reason| CliError::Weights { path: loaded.path().to_owned(), reason };
    if let Some(name) = &arguments.handle {
        Weights::check_handle(&loaded.project, name).map_err(refused)?;
    }
    let output = Output::open(path)?;
    let sites = arguments.sites.as_deref().map(Output::open).transpose()?;
    let solution = loaded.solve()?;
    let weights = Weights::new(&solution, &loaded.project, arguments.handle.as_deref()).map_err(refused)?;
    let quiet = &mut |_| {};
    let grid = || Places::grid([picture.width(), picture.height()], every.unwrap_or(1));
    let places = points.map_or_else(grid, Places::Points);
    match format {
        Format::Png => {
            let file = heat_map(&solution, &weights, picture, quiet);
            output.write(|writer| writer.write_all(&file.map_err(io::Error::other)?))?;
        }
        Format::Csv => output.write(|writer| weights.write(&places, TableFormat::Csv, writer, quiet))?,
        Format::Npy => {
            weights.check_size(&places, MOST_BYTES).map_err(refused)?;
            output.write(|writer| weights.write(&places, TableFormat::Npy, writer, quiet))?;
        }
    }
    sites.map_or(Ok(()), |sites| sites.write(|writer| weights.write_sites(writer)))
}

/// Chooses the format by the extension. Unknown extensions mean CSV.
fn format(path: &Path) -> Format {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    match extension.to_ascii_lowercase().as_str() {
        "npy" => Format::Npy,
        "png" => Format::Png,
        _ => Format::Csv,
    }
}

fn every(number: f64) -> Result<u32, CliError> {
    if number.fract() == 0.0 && number >= 1.0 {
        // Huge numbers are cut: any of them leaves one pixel.
        Ok(number as u32)
    } else {
        Err(CliError::Every { found: number })
    }
}
