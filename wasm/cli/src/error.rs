//! The errors of the command.

use std::fmt::Display;
use std::io::{self, Write};
use std::path::PathBuf;

use c2warp::project::ProjectError;
use c2warp_export::ExportError;
use c2warp_maps::WeightsError;
use c2warp_vector::VectorError;
use image::{ImageError, ImageFormat};

use crate::progress;

/// The reason for which a command failed. Most messages begin with the file concerned.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    #[error("{}: cannot read this file: {reason}", path.display())]
    Read { path: PathBuf, reason: io::Error },
    #[error("{}: cannot write this file: {reason}", path.display())]
    Write { path: PathBuf, reason: io::Error },
    #[error("{}: this is the picture itself: choose another folder for the results", path.display())]
    OverPicture { path: PathBuf },
    #[error("{}: its result has the same name as that of {}: rename one of them", path.display(), other.display())]
    SameResult { path: PathBuf, other: PathBuf },
    #[error("{}: this folder has no files", path.display())]
    NoFiles { path: PathBuf },
    #[error("give one project for many pictures, or one picture for many projects")]
    ManyOfBoth,
    #[error(
        "{}: this picture has {}×{} px and other proportions than {}×{} px, for which the project is: add --fit box to \
         stretch the project, or --fit alpha to line it up with the outline",
        path.display(), found.0, found.1, project.0, project.1
    )]
    Proportions { path: PathBuf, project: (u32, u32), found: (u32, u32) },
    /// The reasons stand on standard error already.
    #[error("some inputs have no result")]
    Told,
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
    #[error("{}: another map is written to this file: choose another file", path.display())]
    SameMap { path: PathBuf },
    #[error("{}: a map ends with .exr or .png", path.display())]
    MapType { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    Weights { path: PathBuf, reason: WeightsError },
    #[error("{}: a heat map shows one handle: name it with --handle", path.display())]
    HeatHandle { path: PathBuf },
    #[error("{}: a heat map shows the whole picture: leave out --at and --every, or write .csv or .npy", path.display())]
    HeatPoints { path: PathBuf },
    #[error("{}: --at or --every tells the points of a table", path.display())]
    PointsNeeded { path: PathBuf },
    #[error("--every: expected a whole number from 1 on, found {found}")]
    Every { found: f64 },
    #[error("{}: the weights are written to this file: choose another file for the sites", path.display())]
    SitesOverWeights { path: PathBuf },
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
    #[error("{}: this is not a PNG, JPEG, WebP or SVG picture", path.display())]
    PictureUnknown { path: PathBuf },
    #[error("{}: this is {name}: save it as PNG, JPEG or WebP", path.display())]
    PictureType { path: PathBuf, name: &'static str },
    // Some reasons end with a line break.
    #[error("{}: the picture is damaged or truncated: {}", path.display(), reason.to_string().trim_end())]
    PictureDamaged { path: PathBuf, reason: ImageError },
    #[error("{}: {reason}", path.display())]
    Drawing { path: PathBuf, reason: VectorError },
    #[error("{}: this is not a drawing: the file is not {encoding} text", path.display())]
    DrawingText { path: PathBuf, encoding: &'static str },
    #[error("{}: this drawing declares the unknown encoding {label:?}: save it as UTF-8", path.display())]
    DrawingEncoding { path: PathBuf, label: String },
    #[error("{}: the compressed file cannot be unpacked: {reason}", path.display())]
    DrawingPacked { path: PathBuf, reason: io::Error },
    #[error("{}: only a drawing can be written as SVG, and the picture has pixels: use .png", path.display())]
    NoDrawing { path: PathBuf },
    #[error("{option}: a drawing in SVG has no pixels: use .png")]
    OfPixels { option: &'static str },
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
    #[error("{}: this is not JSON: {reason}", path.display())]
    ShapesJson { path: PathBuf, reason: serde_json::Error },
    #[error("{}: expected GeoJSON, {{\"points\": …}}, or a file of labelme or COCO", path.display())]
    ShapesForm { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    Shapes { path: PathBuf, reason: String },
    #[error("there is no command {name:?}: the commands are {}", names.join(", "))]
    NoCommand { name: String, names: Vec<String> },
    #[error("{}: this file exists: choose another output with -o, or replace it with --force", path.display())]
    Exists { path: PathBuf },
    #[error("{}: this is the picture: choose another output file", path.display())]
    NewOverPicture { path: PathBuf },
    #[error("{}: {errors} {}", path.display(), if *errors == 1 { "error" } else { "errors" })]
    Faulty { path: PathBuf, errors: usize },
    #[error("--scale: {0}")]
    Scale(c2warp::Error),
}

/// The clips of a project in words.
fn listed(names: &[String]) -> String {
    if names.is_empty() { "it has none".to_owned() } else { format!("it has {names:?}") }
}

/// Tells people something on standard error, on one line.
pub(crate) fn tell(message: impl Display) {
    let line = format!("c2warp: {}\n", one_line(&message.to_string()));
    progress::clear();
    // If standard error is closed, nobody reads it. Lines of threads do not mix.
    let _ = io::stderr().write_all(line.as_bytes());
}

/// Returns the message on one line, with control characters replaced: they could affect the terminal.
pub(crate) fn one_line(message: &str) -> String {
    let words = message.split_whitespace().map(|word| word.replace(char::is_control, "\u{fffd}"));
    words.collect::<Vec<_>>().join(" ")
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

#[cfg(test)]
mod tests {
    use super::one_line;

    #[test]
    fn messages_are_one_line_without_control_characters() {
        assert_eq!(one_line("handle \"\u{1b}[31mred\n x\0\": gone"), "handle \"\u{fffd}[31mred x\u{fffd}\": gone");
    }
}
