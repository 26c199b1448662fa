//! How a picture is warped, and where the result is written.

use std::io::{self, Write};
use std::path::Path;

use c2warp::{Canvas, Filter, ResampleOptions, Solution, raster};
use image::ImageFormat;

use super::encode_png;
use crate::error::CliError;
use crate::output::Output;
use crate::project::LoadedProject;
use crate::stmap;

/// How each picture is warped.
#[derive(Debug, clap::Args)]
pub(super) struct Order {
    /// Pixels of the result per pixel of the picture
    #[arg(long, value_name = "S", default_value_t = 1.0, allow_negative_numbers = true)]
    scale: f64,
    /// Grow the result to hold everything that is bent beyond the picture's rectangle. Prints X,Y: the position of the
    /// picture's upper left corner in the result. Prints it to standard error if standard output takes a file
    #[arg(long)]
    pub(super) grow: bool,
    #[command(flatten)]
    moment: Moment,
    /// Draw pixel art: take the nearest pixel of the picture, mix no colours and smooth no edges
    #[arg(long)]
    pixelated: bool,
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

/// The outputs for one picture, checked before the work starts.
pub(super) struct Targets {
    picture: Output,
    stmap: Option<Output>,
}

impl Targets {
    pub(super) fn open(loaded: &LoadedProject, picture: &Path, stmap: Option<&Path>) -> Result<Self, CliError> {
        check_extension(picture, ImageFormat::Png)?;
        let output = loaded.output(picture)?;
        let stmap = stmap.map(|path| {
            check_extension(path, ImageFormat::OpenExr)?;
            let stmap = loaded.output(path)?;
            // The map must differ from the picture.
            if stmap.is_same(&output) {
                return Err(CliError::SameOutput { path: path.to_owned() });
            }
            Ok(stmap)
        });
        Ok(Self { picture: output, stmap: stmap.transpose()? })
    }
}

impl Order {
    /// Checks the options for a picture, before the solve takes time.
    pub(super) fn check(&self, loaded: &LoadedProject) -> Result<(), CliError> {
        if let Some(clip) = &self.moment.clip {
            loaded.clip(clip)?;
        }
        let picture = loaded.picture()?;
        raster::warped_size(picture.width(), picture.height(), self.scale).map_err(CliError::Scale)?;
        Ok(())
    }

    /// Draws a solved picture and writes it. Returns the position of its upper left corner in the result, in pixels.
    pub(super) fn draw(
        &self,
        loaded: &LoadedProject,
        solution: &Solution,
        targets: Targets,
    ) -> Result<[i32; 2], CliError> {
        let picture = loaded.picture()?;
        let pose = match (&self.moment.clip, self.moment.at) {
            (Some(clip), Some(time)) => loaded.pose_at(solution, loaded.clip(clip)?, time)?,
            _ => loaded.pose(solution)?,
        };
        let options = ResampleOptions {
            scale: self.scale,
            canvas: if self.grow { Canvas::Grown } else { Canvas::Picture },
            filter: if self.pixelated { Filter::Nearest } else { Filter::Cubic },
            edges: loaded.project.edges,
        };
        let warped = solution.warped(&picture, &pose, options).map_err(|reason| loaded.refused(reason))?;
        let png = |writer: &mut dyn Write| {
            writer.write_all(&encode_png(&warped, loaded.profile()).map_err(io::Error::other)?)
        };
        targets.picture.write(png)?;
        if let Some(stmap) = targets.stmap {
            let sources = solution.sources(&picture, &pose, options, &warped);
            let sources = sources.map_err(|reason| loaded.refused(reason))?;
            let file = stmap::encode_exr(&picture, &warped, &sources);
            stmap.write(|writer| writer.write_all(&file.map_err(io::Error::other)?))?;
        }
        Ok(warped.origin)
    }
}

/// Returns an error if the extension belongs to another type than `written`.
fn check_extension(path: &Path, written: ImageFormat) -> Result<(), CliError> {
    match ImageFormat::from_path(path) {
        Ok(format) if format != written => Err(CliError::OutputType { path: path.to_owned(), format, written }),
        _ => Ok(()),
    }
}
