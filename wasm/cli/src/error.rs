//! The errors of the command.

use std::io;
use std::path::PathBuf;

use c2warp::project::ProjectError;
use image::{ImageError, ImageFormat};

/// Why there is no output, in one sentence that begins with the file concerned.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    #[error("{}: cannot be read: {reason}", path.display())]
    Read { path: PathBuf, reason: io::Error },
    #[error("{}: cannot be written: {reason}", path.display())]
    Write { path: PathBuf, reason: io::Error },
    #[error("{}: is the project, which would be lost: write to another file", path.display())]
    OverProject { path: PathBuf },
    #[error(
        "{}: is the name of a picture of type {format:?}, but what is written is of type {written:?}: end it with .{}",
        path.display(),
        written.extensions_str()[0]
    )]
    OutputType { path: PathBuf, format: ImageFormat, written: ImageFormat },
    #[error("{}: is where the picture goes: write the map to another file", path.display())]
    SameOutput { path: PathBuf },
    #[error("the output cannot be written: {0}")]
    Print(io::Error),
    #[error("{}: is not a project: it is not UTF-8 text", path.display())]
    ProjectEncoding { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    Project { path: PathBuf, reason: ProjectError },
    #[error("{}: names no picture in image.src: name one there or give one by --image", path.display())]
    NoPicture { path: PathBuf },
    #[error("{}: is empty, not a picture", path.display())]
    PictureEmpty { path: PathBuf },
    #[error("{}: is not a picture that can be read: PNG, JPEG and WebP can", path.display())]
    PictureUnknown { path: PathBuf },
    #[error("{}: is a picture of type {format:?}, which cannot be read: PNG, JPEG and WebP can", path.display())]
    PictureType { path: PathBuf, format: ImageFormat },
    #[error("{}: is damaged or cut short: {reason}", path.display())]
    PictureDamaged { path: PathBuf, reason: ImageError },
    #[error("{}: {reason}", path.display())]
    Refused { path: PathBuf, reason: c2warp::Error },
    #[error("{}: the first line must be x,y", path.display())]
    PointsHeader { path: PathBuf },
    #[error("{}: line {line}: expected two finite numbers x,y, found {found:?}", path.display())]
    Point { path: PathBuf, line: u64, found: String },
    #[error("{}: is not a list of points: it is not UTF-8 text", path.display())]
    PointsText { path: PathBuf },
    #[error("--scale: {0}")]
    Scale(c2warp::Error),
}

impl CliError {
    pub(crate) fn read(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        |reason| Self::Read { path, reason }
    }

    pub(crate) fn write(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        |reason| Self::Write { path, reason }
    }

    pub(crate) fn refused(path: impl Into<PathBuf>) -> impl FnOnce(c2warp::Error) -> Self {
        let path = path.into();
        |reason| Self::Refused { path, reason }
    }
}
