//! `c2warp warp`: the warped picture as a PNG, at full quality.

use std::io::{self, Write};
use std::path::PathBuf;

use c2warp::{Canvas, Warped, raster};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError, ImageFormat, ImageResult};

use crate::error::CliError;
use crate::output;
use crate::scene::{Files, Scene};

/// Warps the picture at full quality
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Where to write the result; - is standard output
    #[arg(short, long, value_name = "OUT.png")]
    output: PathBuf,
    /// Pixels of the result per pixel of the picture
    #[arg(long, value_name = "S", default_value_t = 1.0, allow_negative_numbers = true)]
    scale: f64,
    /// Grow the result to hold what is bent beyond the picture's own rectangle, and print where that rectangle's upper left
    /// corner lies in it: X,Y in pixels; on standard error if the picture goes to standard output
    #[arg(long)]
    grow: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let scene = Scene::open(&arguments.files)?;
    let picture = scene.picture()?;
    // A solve takes time that a scale which is none is not worth.
    raster::warped_size(picture.width(), picture.height(), arguments.scale).map_err(CliError::Scale)?;
    let path = &arguments.output;
    if let Some(format) = ImageFormat::from_path(path).ok().filter(|&format| format != ImageFormat::Png) {
        return Err(CliError::OutputType { path: path.clone(), format });
    }
    let output = scene.output(path)?;

    let solution = scene.solve()?;
    let pose = scene.pose(&solution)?;
    let canvas = if arguments.grow { Canvas::Grown } else { Canvas::Picture };
    let warped = solution.warped(&picture, &pose, arguments.scale, canvas).map_err(|reason| scene.refused(reason))?;
    output.finish(|writer| writer.write_all(&png(&warped, scene.profile()).map_err(io::Error::other)?))?;
    if arguments.grow {
        let [left, top] = warped.origin;
        let origin = format!("{left},{top}\n");
        let printed = if output::is_standard_output(path) {
            io::stderr().write_all(origin.as_bytes())
        } else {
            io::stdout().write_all(origin.as_bytes())
        };
        printed.map_err(CliError::Print)?;
    }
    Ok(())
}

fn png(warped: &Warped, profile: Option<&[u8]>) -> ImageResult<Vec<u8>> {
    let mut png = Vec::new();
    // A quarter more bytes than with the default, in a third of its time.
    let mut encoder = PngEncoder::new_with_quality(&mut png, CompressionType::Fast, FilterType::Adaptive);
    if let Some(profile) = profile {
        encoder.set_icc_profile(profile.to_owned()).map_err(ImageError::Unsupported)?;
    }
    encoder.write_image(&warped.rgba, warped.width, warped.height, ExtendedColorType::Rgba8)?;
    Ok(png)
}
