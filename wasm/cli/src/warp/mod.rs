//! `c2warp warp`: the warped picture as a PNG at full quality, and its ST map, or a bent drawing as SVG. Many pictures
//! or projects are warped in parallel.

mod bent;
mod many;
mod parts;
mod targets;

use std::num::NonZero;
use std::path::PathBuf;

use self::targets::Targets;
use crate::error::CliError;
use crate::fitting::Fit;
use crate::posed_drawing::PosedDrawing;
use crate::project::LoadedProject;
use crate::workers;

/// Warps pictures at full quality and writes a PNG for each. Bends a drawing and writes an SVG
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: the picture at twice its size, with room for the parts bent beyond it\n  \
                        c2warp warp cat.c2warp.json -o bent.png --scale 2 --grow")]
pub(crate) struct Arguments {
    /// The project file *.c2warp.json, or a PNG that the editor exported. Use - to read this or any other input from
    /// standard input. Each of several projects has its own result. With --project, these are pictures
    #[arg(required = true, value_name = "PROJECTS")]
    inputs: Vec<PathBuf>,
    /// Use this picture instead of the project's image.src. If it has another size, the project is scaled. Each of
    /// several pictures, or of those in a folder, has its own result
    #[arg(long = "image", value_name = "FILE|FOLDER", group = "others")]
    images: Vec<PathBuf>,
    /// The project, if pictures come first: c2warp warp cat.svg --project cat.c2warp.json -o bent.svg
    #[arg(long, value_name = "PROJECT", group = "others")]
    project: Option<PathBuf>,
    /// Fit the project to pictures of other proportions, or with their outline in another place
    #[arg(long, requires = "others")]
    fit: Option<Fit>,
    /// The output file, or - for a PNG on standard output. OUT.svg bends the paths of a drawing. For several inputs, a
    /// folder: its PNGs are named after the pictures, or after the projects if there are several
    #[arg(short, long, value_name = "OUT.png|OUT.svg|FOLDER")]
    output: PathBuf,
    /// Work on up to N inputs at a time, or with N threads on one input. The default is the number of cores
    #[arg(short, long, value_name = "N")]
    jobs: Option<NonZero<usize>>,
    #[command(flatten)]
    drawing: PosedDrawing,
    /// Also write an ST map for compositors: the OpenEXR picture that `c2warp maps --inverse` writes. Red and green
    /// hold the source u,v of each pixel, from 0 to 1 with v upwards. For several inputs, a folder
    #[arg(long, value_name = "OUT.exr|FOLDER")]
    stmap: Option<PathBuf>,
}

impl Arguments {
    fn projects(&self) -> &[PathBuf] {
        self.project.as_ref().map_or(&self.inputs, std::slice::from_ref)
    }

    fn threads(&self) -> NonZero<usize> {
        self.jobs.unwrap_or_else(workers::cores)
    }

    /// The pictures that replace the project's own, with their folders.
    fn images(&self) -> &[PathBuf] {
        if self.project.is_some() { &self.inputs } else { &self.images }
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let (projects, images) = (arguments.projects(), arguments.images());
    if projects.len() > 1 || images.len() > 1 || images.iter().any(|path| path.is_dir()) {
        return many::run(arguments);
    }
    let loaded = LoadedProject::read(&projects[0], images.first().map(PathBuf::as_path), arguments.fit)?;
    arguments.drawing.check(&loaded)?;
    if bent::is_svg(&arguments.output) {
        return bent::run(arguments, &loaded);
    }
    let targets = Targets::open(&loaded, &arguments.output, arguments.stmap.as_deref())?;
    let solution = loaded.solve_filled()?;
    let threads = arguments.threads();
    let extent = targets.write(&loaded, &solution, &arguments.drawing, threads)?;
    let written = [Some(&arguments.output), arguments.stmap.as_ref()];
    let origin = extent.origin.map(f64::from);
    arguments.drawing.print_origin(origin, written.into_iter().flatten().map(PathBuf::as_path))
}
