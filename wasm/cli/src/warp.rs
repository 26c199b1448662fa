//! `c2warp warp`: the warped picture as a PNG, at full quality, and the map by which it is bent.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use c2warp::{Canvas, Filter, ResampleOptions, Warped, raster};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError, ImageFormat, ImageResult};

use crate::error::CliError;
use crate::output::{self, Output};
use crate::scene::{Files, Scene};
use crate::stmap;

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
    /// corner lies in it: X,Y in pixels; on standard error if the picture or its map goes to standard output
    #[arg(long)]
    grow: bool,
    /// Draw pixel art: each pixel of the result is one of the picture, or none; no colour is mixed, no edge is smooth
    #[arg(long)]
    pixelated: bool,
    /// Also write the map of the warp for compositors: an OpenEXR picture as large as the result. Red and green are where each pixel comes
    /// from, u and v from 0 to 1, v upwards; blue is how areas grow; alpha is how much of the pixel is covered
    #[arg(long, value_name = "OUT.exr")]
    stmap: Option<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let scene = Scene::open(&arguments.files)?;
    let picture = scene.picture()?;
    // A solve takes time that a scale which is none is not worth.
    raster::warped_size(picture.width(), picture.height(), arguments.scale).map_err(CliError::Scale)?;
    let path = &arguments.output;
    check_name(path, ImageFormat::Png)?;
    let output = scene.output(path)?;
    let stmap = arguments.stmap.as_deref().map(|path| stmap_output(&scene, path, &output)).transpose()?;

    let solution = scene.solve()?;
    let pose = scene.pose(&solution)?;
    let options = ResampleOptions {
        scale: arguments.scale,
        canvas: if arguments.grow { Canvas::Grown } else { Canvas::Picture },
        filter: if arguments.pixelated { Filter::Nearest } else { Filter::Cubic },
    };
    let warped = solution.warped(&picture, &pose, options).map_err(|reason| scene.refused(reason))?;
    output.finish(|writer| writer.write_all(&png(&warped, scene.profile()).map_err(io::Error::other)?))?;
    if let Some(stmap) = stmap {
        let sources = solution.sources(&picture, &pose, options, &warped).map_err(|reason| scene.refused(reason))?;
        let file = stmap::exr(&picture, &warped, &sources);
        stmap.finish(|writer| writer.write_all(&file.map_err(io::Error::other)?))?;
    }
    if arguments.grow {
        let [left, top] = warped.origin;
        let origin = format!("{left},{top}\n");
        let taken =
            [Some(path), arguments.stmap.as_ref()].into_iter().flatten().any(|path| output::is_standard_output(path));
        let printed =
            if taken { io::stderr().write_all(origin.as_bytes()) } else { io::stdout().write_all(origin.as_bytes()) };
        printed.map_err(CliError::Print)?;
    }
    Ok(())
}

/// Where the map goes: not where the picture does.
fn stmap_output(scene: &Scene, path: &Path, picture: &Output) -> Result<Output, CliError> {
    check_name(path, ImageFormat::OpenExr)?;
    let output = scene.output(path)?;
    if output.is_same(picture) {
        return Err(CliError::SameOutput { path: path.to_owned() });
    }
    Ok(output)
}

/// Refuses a name that is that of another type.
fn check_name(path: &Path, written: ImageFormat) -> Result<(), CliError> {
    match ImageFormat::from_path(path) {
        Ok(format) if format != written => Err(CliError::OutputType { path: path.to_owned(), format, written }),
        _ => Ok(()),
    }
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
