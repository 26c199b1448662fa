//! The options of a drawn pose, shared by `warp` and `maps`.

use std::io::{self, Write};
use std::path::Path;

use c2warp::deform::Pose;
use c2warp::{Canvas, Filter, ResampleOptions, Solution, raster};

use crate::error::CliError;
use crate::files;
use crate::progress;
use crate::project::LoadedProject;

/// A pose, and the rectangle and scale in which it is drawn.
#[derive(Debug, clap::Args)]
pub(crate) struct PosedDrawing {
    /// Pixels of the result per pixel of the picture
    #[arg(long, value_name = "S", default_value_t = 1.0, allow_negative_numbers = true)]
    pub(crate) scale: f64,
    /// Grow the result to hold everything that is bent beyond the picture's rectangle. Prints X,Y: the position of the
    /// picture's upper left corner in the result. Prints it to standard error if standard output takes a file
    #[arg(long)]
    pub(crate) grow: bool,
    #[command(flatten)]
    moment: Moment,
    /// Draw pixel art: take the nearest pixel of the picture, mix no colours and smooth no edges
    #[arg(long)]
    pub(crate) pixelated: bool,
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

impl PosedDrawing {
    /// Rejects unknown clips and invalid scales before solving.
    pub(crate) fn check(&self, loaded: &LoadedProject) -> Result<(), CliError> {
        if let Some(clip) = &self.moment.clip {
            loaded.clip(clip)?;
        }
        let picture = loaded.picture()?;
        raster::warped_size(picture.width(), picture.height(), self.scale).map_err(CliError::Scale)?;
        Ok(())
    }

    /// Poses the handles as the project or its clip does.
    pub(crate) fn pose(&self, loaded: &LoadedProject, solution: &Solution) -> Result<Pose, CliError> {
        match (&self.moment.clip, self.moment.at) {
            (Some(clip), Some(time)) => loaded.pose_at(solution, loaded.clip(clip)?, time),
            _ => loaded.pose(solution),
        }
    }

    pub(crate) fn options(&self, loaded: &LoadedProject) -> ResampleOptions {
        ResampleOptions {
            scale: self.scale,
            canvas: if self.grow { Canvas::Grown } else { Canvas::Picture },
            filter: if self.pixelated { Filter::Nearest } else { Filter::Cubic },
            edges: loaded.project.edges,
        }
    }

    /// Prints the position of the picture in a result that may grow. `written` are the paths of all outputs.
    pub(crate) fn print_origin<'a>(
        &self,
        [left, top]: [f64; 2],
        mut written: impl Iterator<Item = &'a Path>,
    ) -> Result<(), CliError> {
        if !self.grow {
            return Ok(());
        }
        let origin = format!("{left},{top}\n");
        progress::clear();
        let printed = if written.any(files::is_standard_output) {
            io::stderr().write_all(origin.as_bytes())
        } else {
            io::stdout().write_all(origin.as_bytes())
        };
        printed.map_err(CliError::Print)
    }
}
