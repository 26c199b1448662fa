//! `c2warp maps`: maps of the warp for compositors, and masks.

use std::io;
use std::path::{Path, PathBuf};

use c2warp_maps::{Map, MapFormat, Maps};

use crate::error::CliError;
use crate::files::is_standard_output;
use crate::output::Output;
use crate::posed_drawing::PosedDrawing;
use crate::project::{InputFiles, LoadedProject};

/// Writes maps of the warp for compositors, and masks, each as OpenEXR (.exr, 32-bit floats) or PNG (.png, 16 bits)
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: maps that bend a plate in Nuke like the picture\n  \
                        c2warp maps cat.c2warp.json --inverse cat-inverse.exr --stretch cat-stretch.png")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    #[command(flatten)]
    outputs: Outputs,
    #[command(flatten)]
    drawing: PosedDrawing,
}

#[derive(Debug, clap::Args)]
#[group(required = true, multiple = true)]
struct Outputs {
    /// For each pixel of the warped picture, the position in the picture that it shows. Compositors use this ST map to
    /// bend other pictures. Red is u to the right and green is v upwards, from 0 to 1. Blue is the growth of areas, in
    /// OpenEXR. Alpha is the coverage
    #[arg(long, value_name = "OUT")]
    inverse: Option<PathBuf>,
    /// For each pixel of the picture, its position in the warped picture. Compositors use this ST map to undo the warp
    #[arg(long, value_name = "OUT")]
    forward: Option<PathBuf>,
    /// How areas and lengths grow at each pixel of the warped picture: red is the growth of areas, green and blue are
    /// the greatest and the least growth of lengths
    #[arg(long, value_name = "OUT")]
    stretch: Option<PathBuf>,
    /// The areas that the warp uncovers, in red, and those that it covers, in green
    #[arg(long, value_name = "OUT")]
    disocclusion: Option<PathBuf>,
}

impl Outputs {
    fn paths(&self) -> impl Iterator<Item = (Map, &Path)> {
        let Self { inverse, forward, stretch, disocclusion } = self;
        let all = [
            (Map::Inverse, inverse),
            (Map::Forward, forward),
            (Map::Stretch, stretch),
            (Map::Disocclusion, disocclusion),
        ];
        all.into_iter().filter_map(|(map, path)| Some((map, path.as_deref()?)))
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let paths: Vec<_> = arguments.outputs.paths().collect();
    let formats = paths.iter().map(|&(_, path)| format(path)).collect::<Result<Vec<_>, _>>()?;
    let loaded = LoadedProject::open(&arguments.files)?;
    arguments.drawing.check(&loaded)?;
    let outputs = paths.iter().map(|&(_, path)| Output::open(path)).collect::<Result<Vec<_>, _>>()?;

    let (solution, picture) = (loaded.solve()?, loaded.picture()?);
    let pose = arguments.drawing.pose(&loaded, &solution)?;
    let drawing = solution.drawing(&picture, &pose, arguments.drawing.options(&loaded));
    let drawing = drawing.map_err(|reason| loaded.refused(reason))?;
    let name = loaded.picture_name();
    let maps = Maps { solution: &solution, pose: &pose, picture, drawing: &drawing, name: &name };
    for ((&(map, _), format), output) in paths.iter().zip(formats).zip(outputs) {
        let file = maps.file(map, format, &mut |_| {});
        output.write(|writer| writer.write_all(&file.map_err(io::Error::other)?))?;
    }
    arguments.drawing.print_origin(drawing.extent().origin.map(f64::from), paths.iter().map(|&(_, path)| path))
}

/// The format of an output. Streams use OpenEXR.
fn format(path: &Path) -> Result<MapFormat, CliError> {
    if is_standard_output(path) {
        return Ok(MapFormat::Exr);
    }
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    MapFormat::of_file(name).ok_or_else(|| CliError::MapType { path: path.to_owned() })
}
