//! The errors of the command.

use std::fmt::Display;
use std::io::{self, Write};
use std::path::PathBuf;
use std::{panic, process};

use c2warp::DisplayName;
use c2warp::project::ProjectError;
use c2warp_export::ExportError;
use c2warp_maps::WeightsError;
use c2warp_vector::VectorError;
use image::{ImageError, ImageFormat};

use crate::progress;

/// Why a command failed. Most messages begin with the file concerned.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    #[error("{}: cannot read this file: {reason}", path.display())]
    Read { path: PathBuf, reason: io::Error },
    #[error("{}: cannot write this file: {reason}", path.display())]
    Write { path: PathBuf, reason: io::Error },
    #[error("{}: this is the input {}: choose another output", path.display(), input.display())]
    OverInput { path: PathBuf, input: PathBuf },
    #[error("{}: this is also the output {}: choose another one", path.display(), other.display())]
    OverOutput { path: PathBuf, other: PathBuf },
    #[error("{}: its result has the same name as that of {}: rename one of them", path.display(), other.display())]
    SameResult { path: PathBuf, other: PathBuf },
    #[error("{}: this folder has no files", path.display())]
    NoFiles { path: PathBuf },
    #[error("pass one project with many pictures, or one picture with many projects")]
    ManyOfBoth,
    #[error(
        "{}: this picture of {}×{} px has other proportions than the project's {}×{} px: add --fit box to stretch the \
         project, or --fit alpha to align it with the outline",
        path.display(), found.0, found.1, project.0, project.1
    )]
    Proportions { path: PathBuf, project: (u32, u32), found: (u32, u32) },
    /// The reasons have been printed to standard error.
    #[error("some inputs failed")]
    Reported,
    #[error(
        "{}: the extension means {format:?}, but the output is {written:?}: use .{}",
        path.display(),
        written.extensions_str()[0]
    )]
    OutputType { path: PathBuf, format: ImageFormat, written: ImageFormat },
    #[error("{}: the extension means {format:?}, but the output is a rig: use .c2rig", path.display())]
    OutputNoRig { path: PathBuf, format: ImageFormat },
    #[error("{}: the name of a map must end with .exr or .png", path.display())]
    MapType { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    Weights { path: PathBuf, reason: WeightsError },
    #[error("{}: a heat map shows one handle: name it with --handle", path.display())]
    HeatHandle { path: PathBuf },
    #[error("{}: a heat map shows the whole picture: leave out --at and --every, or write .csv or .npy", path.display())]
    HeatPoints { path: PathBuf },
    #[error("{}: a table needs points: pass --at or --every", path.display())]
    PointsNeeded { path: PathBuf },
    #[error("--every: expected a whole number of at least 1, found {found}")]
    Every { found: f64 },
    #[error("cannot write to standard output: {0}")]
    Print(io::Error),
    #[error("{}: this is not a project: the file is not UTF-8 text", path.display())]
    ProjectEncoding { path: PathBuf },
    #[error("{}: this PNG contains no project: export one from the editor, or pass a project file", path.display())]
    NoProject { path: PathBuf },
    #[error(
        "{}: this project has more than {} MB: keep its picture in a file of its own",
        path.display(),
        most / 1_000_000
    )]
    ProjectSize { path: PathBuf, most: usize },
    #[error("{}: there is no clip {name:?}: {}", path.display(), listed(names))]
    NoClip { path: PathBuf, name: String, names: Vec<String> },
    #[error("{}: name the clip to draw with --clip: {}", path.display(), listed(names))]
    ClipNeeded { path: PathBuf, names: Vec<String> },
    #[error("--fps: viewers show a GIF at no more than {most} frames per second")]
    GifRate { most: f64 },
    #[error("{option}: {reason}")]
    Film { option: &'static str, reason: c2warp::Error },
    #[error(
        "{}: the name of a film must end with .gif, .png or .webp, and that of single frames with %04d.png",
        path.display()
    )]
    FilmType { path: PathBuf },
    #[error("{}: a sprite sheet must be a PNG: use .png", path.display())]
    SheetType { path: PathBuf },
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
    #[error("{}: only a drawing can be written as SVG, but the picture consists of pixels: use .png", path.display())]
    NoDrawing { path: PathBuf },
    #[error("{option}: an SVG drawing has no pixels: use .png")]
    OfPixels { option: &'static str },
    #[error("{}: {reason}", path.display())]
    Refused { path: PathBuf, reason: c2warp::Error },
    #[error("{}: {reason}", path.display())]
    NotBaked { path: PathBuf, reason: c2warp::rig::BakeError },
    #[error("{}: the name of a rig must end with .spine.json, _ske.json, .glb or .tscn", path.display())]
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
    #[error("{}: expected GeoJSON, {{\"points\": …}}, or a labelme or COCO file", path.display())]
    ShapesForm { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    Shapes { path: PathBuf, reason: String },
    #[error("unknown command {name:?}: the commands are {}", names.join(", "))]
    NoCommand { name: String, names: Vec<String> },
    #[error("{}: this file already exists: choose another output with -o, or replace it with --force", path.display())]
    Exists { path: PathBuf },
    #[error("{}: {errors} {}", path.display(), if *errors == 1 { "error" } else { "errors" })]
    Faulty { path: PathBuf, errors: usize },
    #[error("--scale: {0}")]
    Scale(c2warp::Error),
}

/// Lists the clips of a project for a message.
fn listed(names: &[String]) -> String {
    if names.is_empty() { "the project has no clips".to_owned() } else { format!("the clips are {names:?}") }
}

/// Prints a message as one line on standard error.
pub(crate) fn print(message: impl Display) {
    let line = format!("c2warp: {}\n", one_line(&message.to_string()));
    progress::clear();
    // If standard error is closed, nobody reads it. Lines of threads do not mix.
    let _ = io::stderr().write_all(line.as_bytes());
}

/// Lets a panic, which is an error of the program, end it with one line and exit status 1.
pub(crate) fn print_panics() {
    panic::set_hook(Box::new(|panic| {
        print(format_args!("this is an error of c2warp itself, please report it with the input: {panic}"));
        process::exit(1);
    }));
}

/// Returns the message on one line. Characters that are not drawn are escaped: they could affect the terminal.
pub(crate) fn one_line(message: &str) -> String {
    let words: Vec<_> = message.split_whitespace().map(|word| DisplayName(word).to_string()).collect();
    words.join(" ")
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

    /// Returns an error about the frame rate or range of a film.
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
        let message = "handle \"\u{1b}[31mred\n x\0\": \u{202e}enog";
        assert_eq!(one_line(message), r#"handle "\u{1b}[31mred x\u{0}": \u{202e}enog"#);
    }
}
