//! A warped picture and its ST map, and where they are written.

use std::io::{self, Write};
use std::num::NonZero;
use std::path::Path;

use c2warp::{Extent, Solution};
use c2warp_maps::{Map, MapFormat, Maps};
use image::ImageFormat;

use super::parts;
use crate::error::CliError;
use crate::output::Output;
use crate::png_file::encode_png;
use crate::posed_drawing::PosedDrawing;
use crate::project::LoadedProject;

/// The outputs for one picture, checked before the work starts.
#[derive(Debug)]
pub(super) struct Targets {
    picture: Output,
    stmap: Option<Output>,
}

impl Targets {
    pub(super) fn open(picture: &Path, stmap: Option<&Path>) -> Result<Self, CliError> {
        check_extension(picture, ImageFormat::Png)?;
        stmap.map_or(Ok(()), |path| check_extension(path, ImageFormat::OpenExr))?;
        Ok(Self { picture: Output::open(picture)?, stmap: stmap.map(Output::open).transpose()? })
    }

    /// Draws a solved picture with up to `threads` threads, and writes it. Returns the rectangle of the result.
    pub(super) fn write(
        self,
        loaded: &LoadedProject,
        solution: &Solution,
        posed: &PosedDrawing,
        threads: NonZero<usize>,
    ) -> Result<Extent, CliError> {
        let picture = loaded.picture()?;
        let pose = posed.pose(loaded, solution)?;
        let drawing = solution.drawing(&picture, &pose, posed.options(loaded));
        let drawing = drawing.map_err(|reason| loaded.refused(reason))?;
        let rgba = parts::rgba(&drawing, &picture, threads);
        let size = [drawing.width(), drawing.height()];
        let png = |writer: &mut dyn Write| {
            writer.write_all(&encode_png(size, &rgba, loaded.profile()).map_err(io::Error::other)?)
        };
        self.picture.write(png)?;
        if let Some(stmap) = self.stmap {
            let name = loaded.picture_name();
            let maps = Maps { solution, pose: &pose, picture, drawing: &drawing, name: &name };
            let file = maps.file(Map::Inverse, MapFormat::Exr, &mut |_| {});
            stmap.write(|writer| writer.write_all(&file.map_err(io::Error::other)?))?;
        }
        Ok(drawing.extent())
    }
}

/// Returns an error if the extension does not match the type `written`.
fn check_extension(path: &Path, written: ImageFormat) -> Result<(), CliError> {
    match ImageFormat::from_path(path) {
        Ok(format) if format != written => Err(CliError::OutputType { path: path.to_owned(), format, written }),
        _ => Ok(()),
    }
}
