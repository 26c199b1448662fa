//! `c2warp warp`: the warped picture as a PNG at full quality, and its ST map, or a bent drawing as SVG. Many pictures
//! or projects are warped in parallel.

mod bent;
mod many;
mod parts;
mod targets;

use std::num::NonZero;
use std::path::{Path, PathBuf, is_separator};

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
    #[arg(required_unless_present = "images", value_name = "PROJECTS")]
    inputs: Vec<PathBuf>,
    /// Use this picture instead of the project's image.src. If it has another size, the project is scaled. Each of
    /// several pictures, such as *.png, or of those in a folder, has its own result
    #[arg(long = "image", value_name = "FILES|FOLDER", group = "others", num_args = 1..)]
    images: Vec<PathBuf>,
    /// The project, if pictures come first: c2warp warp cat.svg --project cat.c2warp.json -o bent.svg
    #[arg(long, value_name = "PROJECT", group = "others")]
    project: Option<PathBuf>,
    /// Fit the project to pictures of other proportions, or with their outline in another place
    #[arg(long, requires = "others")]
    fit: Option<Fit>,
    /// The output file, or - for a PNG on standard output. OUT.svg bends the paths of a drawing. For several inputs, a
    /// folder: its PNGs are named after the pictures, or after the projects if there are several. An existing folder,
    /// or a name that ends with /, also works for one input
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
    /// Takes the projects back that `--image` took for pictures, as in `--image *.png cat.c2warp.json`.
    fn divide_images(&mut self) {
        if self.inputs.is_empty() {
            let images = std::mem::take(&mut self.images).into_iter();
            (self.inputs, self.images) = images.partition(|path| is_json(path));
        }
        if self.inputs.is_empty() {
            let reason = "the project stands before --image: c2warp warp PROJECT --image FILES -o FOLDER\n";
            crate::definition().error(clap::error::ErrorKind::MissingRequiredArgument, reason).exit();
        }
    }

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

fn is_json(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"))
}

/// Whether a path is that of a folder, or is written as one.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.to_string_lossy().ends_with(is_separator)
}

pub(crate) fn run(mut arguments: Arguments) -> Result<(), CliError> {
    arguments.divide_images();
    let arguments = &arguments;
    let (projects, images) = (arguments.projects(), arguments.images());
    let has_folder = images.iter().any(|path| path.is_dir()) || is_folder(&arguments.output);
    if projects.len() > 1 || images.len() > 1 || has_folder {
        return many::run(arguments);
    }
    let loaded = LoadedProject::read(&projects[0], images.first().map(PathBuf::as_path), arguments.fit)?;
    arguments.drawing.check(&loaded)?;
    if bent::is_svg(&arguments.output) {
        return bent::run(arguments, &loaded);
    }
    let targets = Targets::open(&arguments.output, arguments.stmap.as_deref())?;
    let solution = loaded.solve_filled()?;
    let threads = arguments.threads();
    let extent = targets.write(&loaded, &solution, &arguments.drawing, threads)?;
    let written = [Some(&arguments.output), arguments.stmap.as_ref()];
    let origin = extent.origin.map(f64::from);
    arguments.drawing.print_origin(origin, written.into_iter().flatten().map(PathBuf::as_path))
}
