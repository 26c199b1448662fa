//! The errors of the command.

use std::io;
use std::path::PathBuf;

use c2warp::project::ProjectError;
use c2warp_export::ExportError;
use image::{ImageError, ImageFormat};

/// The reason for which a command failed. Most messages begin with the file concerned.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    #[error("{}: cannot read this file: {reason}", path.display())]
    Read { path: PathBuf, reason: io::Error },
    #[error("{}: cannot write this file: {reason}", path.display())]
    Write { path: PathBuf, reason: io::Error },
    #[error("{}: this is the project file: choose another output file", path.display())]
    OverProject { path: PathBuf },
    #[error(
        "{}: the extension means {format:?}, but the output is {written:?}: use .{}",
        path.display(),
        written.extensions_str()[0]
    )]
    OutputType { path: PathBuf, format: ImageFormat, written: ImageFormat },
    #[error("{}: the extension means {format:?}, but the output is a rig: use .c2rig", path.display())]
    OutputNoRig { path: PathBuf, format: ImageFormat },
    #[error("{}: the picture is written to this file: choose another file for the map", path.display())]
    SameOutput { path: PathBuf },
    #[error("cannot write to standard output: {0}")]
    Print(io::Error),
    #[error("{}: this is not a project: the file is not UTF-8 text", path.display())]
    ProjectEncoding { path: PathBuf },
    #[error("{}: this PNG carries no project: export one from the editor, or pass a project file", path.display())]
    NoProject { path: PathBuf },
    #[error("{}: there is no clip {name:?}: {}", path.display(), listed(names))]
    NoClip { path: PathBuf, name: String, names: Vec<String> },
    #[error("{}: --clip names the clip to draw: {}", path.display(), listed(names))]
    ClipNeeded { path: PathBuf, names: Vec<String> },
    #[error("--fps: viewers show at most {most} frames of a GIF in a second")]
    GifRate { most: f64 },
    #[error("{option}: {reason}")]
    Film { option: &'static str, reason: c2warp::Error },
    #[error("{}: a film ends with .gif, .png or .webp, and single frames are named like frame-%04d.png", path.display())]
    FilmType { path: PathBuf },
    #[error("{}: a sheet is a PNG: use .png", path.display())]
    SheetType { path: PathBuf },
    #[error("{}: the film is written to this file: choose another file for the sheet", path.display())]
    SheetOverFilm { path: PathBuf },
    #[error("{}: image.src: the data: URL is damaged", path.display())]
    PictureUrl { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    Project { path: PathBuf, reason: ProjectError },
    #[error("{}: image.src is empty: name a picture there, or pass one with --image", path.display())]
    NoPicture { path: PathBuf },
    #[error("{}: this is not a picture: the file is empty", path.display())]
    PictureEmpty { path: PathBuf },
    #[error("{}: this is not a PNG, JPEG or WebP picture", path.display())]
    PictureUnknown { path: PathBuf },
    #[error("{}: this is {name}: save it as PNG, JPEG or WebP", path.display())]
    PictureType { path: PathBuf, name: &'static str },
    #[error("{}: the picture is damaged or truncated: {reason}", path.display())]
    PictureDamaged { path: PathBuf, reason: ImageError },
    #[error("{}: {reason}", path.display())]
    Refused { path: PathBuf, reason: c2warp::Error },
    #[error("{}: {reason}", path.display())]
    NotBaked { path: PathBuf, reason: c2warp::rig::BakeError },
    #[error("{}: a rig ends with .spine.json, _ske.json, .glb or .tscn", path.display())]
    RigType { path: PathBuf },
    #[error("{option}: expected a whole number, found {found}")]
    Whole { option: &'static str, found: f64 },
    #[error("{0}")]
    Export(Box<ExportError>),
    #[error("{}: {reason}", path.display())]
    NotExported { path: PathBuf, reason: Box<ExportError> },
    #[error("{}: the first line must be x,y", path.display())]
    PointsHeader { path: PathBuf },
    #[error("{}: line {line}: expected two finite numbers x,y, found {found:?}", path.display())]
    Point { path: PathBuf, line: u64, found: String },
    #[error("{}: this is not a list of points: the file is not UTF-8 text", path.display())]
    PointsText { path: PathBuf },
    #[error("--scale: {0}")]
    Scale(c2warp::Error),
}

/// The clips of a project in words.
fn listed(names: &[String]) -> String {
    if names.is_empty() { "it has none".to_owned() } else { format!("it has {names:?}") }
}

/// Conversions for `map_err`.
impl CliError {
    pub(crate) fn read(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        |reason| Self::Read { path, reason }
    }

    pub(crate) fn write(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        |reason| Self::Write { path, reason }
    }

    /// A film whose frames have no times.
    pub(crate) fn film(reason: c2warp::Error) -> Self {
        let option = if matches!(reason, c2warp::Error::FrameRange { .. }) { "--range" } else { "--fps" };
        Self::Film { option, reason }
    }

    pub(crate) fn refused(path: impl Into<PathBuf>) -> impl FnOnce(c2warp::Error) -> Self {
        let path = path.into();
        |reason| Self::Refused { path, reason }
    }
}
