//! `c2warp warp`: the warped picture as a PNG at full quality, and its ST map.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use c2warp::{Canvas, Filter, ResampleOptions, Warped, raster};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError, ImageFormat, ImageResult};

use crate::error::CliError;
use crate::output::{self, Output};
use crate::project::{InputFiles, LoadedProject};
use crate::stmap;

/// Warps the picture at full quality and writes a PNG
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The output file, or - for standard output
    #[arg(short, long, value_name = "OUT.png")]
    output: PathBuf,
    /// Pixels of the result per pixel of the picture
    #[arg(long, value_name = "S", default_value_t = 1.0, allow_negative_numbers = true)]
    scale: f64,
    /// Grow the result to hold everything that is bent beyond the picture's rectangle. Prints X,Y: the position of the
    /// picture's upper left corner in the result. Prints it to standard error if standard output takes a file
    #[arg(long)]
    grow: bool,
    #[command(flatten)]
    moment: Moment,
    /// Draw pixel art: take the nearest pixel of the picture, mix no colours and smooth no edges
    #[arg(long)]
    pixelated: bool,
    /// Also write an ST map for compositors: an OpenEXR picture of the size of the result. Red and green hold the
    /// source u,v of each pixel, from 0 to 1 with v upwards. Blue is the Jacobian determinant. Alpha is the coverage
    #[arg(long, value_name = "OUT.exr")]
    stmap: Option<PathBuf>,
}

/// A time in a clip.
#[derive(Debug, clap::Args)]
struct Moment {
    /// Pose the handles as this clip of the project does
    #[arg(long, value_name = "NAME", requires = "at")]
    clip: Option<String>,
    /// The time in the clip, in seconds
    #[arg(long, value_name = "SECONDS", requires = "clip", allow_negative_numbers = true, value_parser = finite)]
    at: Option<f64>,
}

fn finite(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| "expected a finite number".to_owned())
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let loaded = LoadedProject::open(&arguments.files)?;
    let moment = match (&arguments.moment.clip, arguments.moment.at) {
        (Some(clip), Some(time)) => Some((loaded.clip(clip)?, time)),
        _ => None,
    };
    let picture = loaded.picture()?;
    // Reject invalid scales before solving.
    raster::warped_size(picture.width(), picture.height(), arguments.scale).map_err(CliError::Scale)?;
    let path = &arguments.output;
    check_extension(path, ImageFormat::Png)?;
    let output = loaded.output(path)?;
    let stmap = arguments.stmap.as_deref().map(|path| stmap_output(&loaded, path, &output)).transpose()?;

    let solution = loaded.solve()?;
    let pose = match moment {
        Some((clip, time)) => loaded.pose_at(&solution, clip, time)?,
        None => loaded.pose(&solution)?,
    };
    let options = ResampleOptions {
        scale: arguments.scale,
        canvas: if arguments.grow { Canvas::Grown } else { Canvas::Picture },
        filter: if arguments.pixelated { Filter::Nearest } else { Filter::Cubic },
        edges: loaded.project.edges,
    };
    let warped = solution.warped(&picture, &pose, options).map_err(|reason| loaded.refused(reason))?;
    output.write(|writer| writer.write_all(&encode_png(&warped, loaded.profile()).map_err(io::Error::other)?))?;
    if let Some(stmap) = stmap {
        let sources = solution.sources(&picture, &pose, options, &warped).map_err(|reason| loaded.refused(reason))?;
        let file = stmap::encode_exr(&picture, &warped, &sources);
        stmap.write(|writer| writer.write_all(&file.map_err(io::Error::other)?))?;
    }
    if arguments.grow {
        let [left, top] = warped.origin;
        let origin = format!("{left},{top}\n");
        let stdout_is_taken =
            [Some(path), arguments.stmap.as_ref()].into_iter().flatten().any(|path| output::is_standard_output(path));
        let printed = if stdout_is_taken {
            io::stderr().write_all(origin.as_bytes())
        } else {
            io::stdout().write_all(origin.as_bytes())
        };
        printed.map_err(CliError::Print)?;
    }
    Ok(())
}

/// Prepares the output of the ST map. It must differ from the output of the picture.
fn stmap_output(loaded: &LoadedProject, path: &Path, picture: &Output) -> Result<Output, CliError> {
    check_extension(path, ImageFormat::OpenExr)?;
    let output = loaded.output(path)?;
    if output.is_same(picture) {
        return Err(CliError::SameOutput { path: path.to_owned() });
    }
    Ok(output)
}

/// Returns an error if the extension belongs to another type than `written`.
fn check_extension(path: &Path, written: ImageFormat) -> Result<(), CliError> {
    match ImageFormat::from_path(path) {
        Ok(format) if format != written => Err(CliError::OutputType { path: path.to_owned(), format, written }),
        _ => Ok(()),
    }
}

pub(crate) fn encode_png(warped: &Warped, profile: Option<&[u8]>) -> ImageResult<Vec<u8>> {
    let mut png = Vec::new();
    // A third of the time of the default, for a quarter more bytes.
    let mut encoder = PngEncoder::new_with_quality(&mut png, CompressionType::Fast, FilterType::Adaptive);
    if let Some(profile) = profile {
        encoder.set_icc_profile(profile.to_owned()).map_err(ImageError::Unsupported)?;
    }
    encoder.write_image(&warped.rgba, warped.width, warped.height, ExtendedColorType::Rgba8)?;
    Ok(png)
}
