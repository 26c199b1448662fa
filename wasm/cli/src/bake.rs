//! `c2warp bake`: a rig with the picture and the project's clips, in one file for web pages.

use std::path::{Path, PathBuf};

use c2warp::rig::{Posable, Rig, RigPicture};
use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use crate::error::CliError;
use crate::output::Output;
use crate::picture::PictureFile;
use crate::progress;
use crate::project::{InputFiles, LoadedProject};

/// Writes the picture and its clips as a rig, one small file that <c2-warp-player> plays in a web page
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: a rig for <c2-warp-player src=\"cat.c2rig\">\n  \
                        c2warp bake cat.c2warp.json -o cat.c2rig")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The output file, or - for standard output
    #[arg(short, long, value_name = "OUT.c2rig")]
    output: PathBuf,
    /// Let readers pose the handles in the rigid mode, too. The file grows by about 100 kB
    #[arg(long)]
    posable: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let loaded = LoadedProject::open(&arguments.files)?;
    let picture = loaded.picture()?;
    let (width, height) = (picture.width(), picture.height());
    check_is_no_picture(&arguments.output)?;
    let output = Output::open(&arguments.output)?;
    let solution = loaded.solve()?;
    let picture = RigPicture { width, height, file: smaller(loaded.picture_file()) };
    let posable = if arguments.posable { Posable::Always } else { Posable::WithoutSolver };
    let mut on_progress = |part: f64| progress::show(&format!("baking {:.0} %", 100.0 * part));
    let rig = Rig::bake_with_progress(&loaded.project, &solution, picture, posable, &mut on_progress)
        .map_err(|reason| loaded.not_baked(reason))?;
    let file = rig.to_bytes().map_err(|reason| loaded.not_baked(reason))?;
    output.write(|writer| writer.write_all(&file))
}

fn check_is_no_picture(path: &Path) -> Result<(), CliError> {
    match ImageFormat::from_path(path) {
        Ok(format) => Err(CliError::OutputNoRig { path: path.to_owned(), format }),
        Err(_) => Ok(()),
    }
}

/// Returns the file, or the same pixels as WebP if that is smaller.
fn smaller(picture: &PictureFile) -> Vec<u8> {
    let PictureFile { pixels, profile, format, bytes, .. } = picture;
    if *format != ImageFormat::Png || profile.is_some() {
        return bytes.clone();
    }
    let mut webp = Vec::new();
    let encoder = WebPEncoder::new_lossless(&mut webp);
    let encoded = encoder.write_image(pixels, pixels.width(), pixels.height(), ExtendedColorType::Rgba8);
    if encoded.is_ok() && webp.len() < bytes.len() { webp } else { bytes.clone() }
}
