//! Projects that are used with other pictures than their own.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use c2warp::fit::{Fitted, Fitter};
use c2warp::{DisplayName, Picture};

use crate::error::{self, CliError};
use crate::picture::PictureFile;
use crate::project::{LoadedProject, ProjectFile};

/// How a project is fitted to another picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Fit {
    /// Stretch the rectangle of the project's picture to that of the other picture
    Box,
    /// Align the outline of the project's picture with that of the other picture
    Alpha,
}

/// A project for pictures other than its own.
pub(crate) struct FittingProject {
    file: ProjectFile,
    fit: Option<Fit>,
    fitter: Fitter,
    /// Errors about a fitted project name its picture, because the project itself is valid.
    names_picture: bool,
}

impl FittingProject {
    /// Without a fit, pictures of other proportions are rejected. For outlines, the project's own picture is read.
    pub(crate) fn new(file: ProjectFile, fit: Option<Fit>, names_picture: bool) -> Result<Self, CliError> {
        let project = file.project.clone();
        let fitter = match fit {
            Some(Fit::Alpha) => {
                let (image, path) = file.own_picture()?;
                Fitter::by_alpha(project, &image.picture(&path)?).map_err(CliError::refused(path))?
            }
            Some(Fit::Box) | None => Fitter::by_box(project),
        };
        Ok(Self { file, fit, fitter, names_picture })
    }

    pub(crate) fn file(&self) -> &ProjectFile {
        &self.file
    }

    /// The project with a picture. Reports on standard error which handles were moved into its outline.
    pub(crate) fn with_picture(&self, image: Arc<PictureFile>, path: PathBuf) -> Result<LoadedProject, CliError> {
        let picture = image.picture(&path)?;
        let own = self.file.size();
        if self.fit.is_none() && own == picture.size() {
            return Ok(self.file.with_picture(image, path, self.names_picture));
        }
        if self.fit.is_none() && !are_proportional(own, &picture) {
            let found = picture.size();
            return Err(CliError::Proportions { path, project: own, found });
        }
        let Fitted { project, moved, .. } = self.fitter.fit(&picture).map_err(CliError::refused(&path))?;
        if let Some(farthest) = moved.iter().map(|handle| handle.distance).reduce(f64::max) {
            let names: Vec<_> = moved.iter().map(|handle| format!("“{}”", DisplayName(&handle.id))).collect();
            let names = names.join(", ");
            error::print(format_args!(
                "{}: moved into the outline, by up to {farthest:.1} px: {names}",
                path.display()
            ));
        }
        let file = ProjectFile { project, ..self.file.clone() };
        Ok(file.with_picture(image, path, true))
    }
}

/// Whether a picture has the proportions of a size, apart from rounding one side to whole pixels.
fn are_proportional((width, height): (u32, u32), picture: &Picture<'_>) -> bool {
    let [width, height, other_width, other_height] = [width, height, picture.width(), picture.height()].map(f64::from);
    (other_width * height / width - other_height).abs() < 1.0
        || (other_height * width / height - other_width).abs() < 1.0
}

/// The name of a file without its extensions, for the name of its result.
pub(crate) fn stem(path: &Path) -> PathBuf {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let stem = name.strip_suffix(".c2warp.json").map(PathBuf::from);
    stem.unwrap_or_else(|| path.file_stem().map(PathBuf::from).unwrap_or_default())
}
