//! `c2warp animate`: a clip as a film, as single frames, or as a sprite sheet.

mod drawing;
mod sequence;

use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use c2warp::clip::FrameTimes;
use c2warp::project::Clip;
use c2warp::{Extent, Filter, ResampleOptions, Warped, raster};
use c2warp_film::{Apng, Encoder, Film, Gif, GifColours, MOST_GIF_RATE, Plays, Sheet, WebP};

use self::drawing::Drawing;
use self::sequence::Sequence;
use crate::error::CliError;
use crate::output::{self, Output};
use crate::png_file::encode_png;
use crate::project::{InputFiles, LoadedProject};

/// Draws a clip at full quality as a film, as single frames or as a sprite sheet
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: an animated WebP of one clip, at half the size\n  \
                        c2warp animate cat.c2warp.json --clip wave --fps 12 --scale 0.5 -o wave.webp")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The output: OUT.gif, OUT.png (an animated PNG), OUT.webp (lossless), or single frames frame-%04d.png
    #[arg(short, long, value_name = "OUT", required_unless_present = "sheet")]
    output: Option<PathBuf>,
    /// The clip to draw. A project with one clip needs no name
    #[arg(long, value_name = "NAME")]
    clip: Option<String>,
    /// Frames a second
    #[arg(long, value_name = "F", default_value_t = 30.0, allow_negative_numbers = true)]
    fps: f64,
    /// Draw a part of the clip, in seconds, such as 0.5..1.2
    #[arg(long, value_name = "FROM..TO", allow_hyphen_values = true, value_parser = range)]
    range: Option<Range<f64>>,
    /// Pixels of the result per pixel of the picture
    #[arg(long, value_name = "S", default_value_t = 1.0, allow_negative_numbers = true)]
    scale: f64,
    /// Grow all frames to hold everything that any of them bends beyond the picture's rectangle. Prints X,Y: the
    /// position of the picture's upper left corner in the frames
    #[arg(long)]
    grow: bool,
    /// Also or only write a sprite sheet, with a JSON file beside it in TexturePacker's hash form
    #[arg(long, value_name = "OUT.png")]
    sheet: Option<PathBuf>,
    /// Blend the soft edges of a GIF with this colour, such as #ffffff: the background of the page that shows it
    #[arg(long, value_name = "COLOUR", value_parser = colour)]
    matte: Option<[u8; 3]>,
    /// Draw pixel art: take the nearest pixel of the picture, mix no colours and smooth no edges
    #[arg(long)]
    pixelated: bool,
}

/// Reads a colour like `#ffcc00`.
fn colour(text: &str) -> Result<[u8; 3], String> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let number = u32::from_str_radix(digits, 16).ok().filter(|_| digits.len() == 6 && digits.is_ascii());
    let [_, r, g, b] = number.ok_or("expected a colour like #ffcc00")?.to_be_bytes();
    Ok([r, g, b])
}

/// Reads two times like `0.5..1.2`.
fn range(text: &str) -> Result<Range<f64>, String> {
    let time = |text: &str| text.parse().ok().filter(|time: &f64| time.is_finite());
    let times = text.split_once("..").and_then(|(from, to)| Some(time(from)?..time(to)?));
    times.ok_or_else(|| "expected two times in seconds like 0.5..1.2".to_owned())
}

/// The outputs, checked before the work starts.
enum Target {
    Film(Container, Output),
    Frames(Vec<Output>),
    Sheet { output: Output, json: Output, image: String },
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Container {
    Gif,
    Apng,
    WebP,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let loaded = LoadedProject::open(&arguments.files)?;
    let clip = clip(&loaded, arguments.clip.as_deref())?;
    let times = FrameTimes::new(clip, arguments.fps, arguments.range.clone()).map_err(CliError::film)?;
    let picture = loaded.picture()?;
    // Reject invalid options and outputs before solving.
    let scale = arguments.scale;
    let (width, height) = raster::warped_size(picture.width(), picture.height(), scale).map_err(CliError::Scale)?;
    let mut film = Film {
        width,
        height,
        frames: times.count(),
        rate: arguments.fps,
        plays: if times.repeats() { Plays::Endlessly } else { Plays::Once },
        profile: loaded.profile().map(<[u8]>::to_vec),
    };
    let targets = targets(arguments, &film)?;

    let solution = loaded.solve_filled()?;
    let options = ResampleOptions {
        scale,
        filter: if arguments.pixelated { Filter::Nearest } else { Filter::Cubic },
        edges: loaded.project.edges,
        ..ResampleOptions::default()
    };
    let mut drawing = Drawing::new(&loaded, &solution, clip, times.seconds(), options)?;
    let grown = arguments.grow.then(|| drawing.grow()).transpose()?;
    if let Some(Extent { width, height, .. }) = grown {
        (film.width, film.height) = (width, height);
    }
    targets.into_iter().try_for_each(|target| match target {
        Target::Film(container, output) => write_film(&mut drawing, container, &film, arguments.matte, output),
        Target::Frames(frames) => write_frames(&mut drawing, frames, loaded.profile()),
        Target::Sheet { output, json, image } => {
            let mut text = String::new();
            write(&mut drawing, output, |writer| {
                let sheet = Sheet::new(film.clone(), writer)?;
                text = sheet.json(&image, &clip.name);
                Ok(Box::new(sheet))
            })?;
            json.write(|writer| writer.write_all(text.as_bytes()))
        }
    })?;
    match grown {
        Some(Extent { origin: [left, top], .. }) => output::print(format!("{left},{top}\n").as_bytes()),
        None => Ok(()),
    }
}

/// The clip with a name, or the only one.
fn clip<'a>(loaded: &'a LoadedProject, name: Option<&str>) -> Result<&'a Clip, CliError> {
    match (name, loaded.project.clips.as_slice()) {
        (Some(name), _) => loaded.clip(name),
        (None, [only]) => Ok(only),
        (None, clips) => {
            let names = clips.iter().map(|clip| clip.name.clone()).collect();
            Err(CliError::ClipNeeded { path: loaded.path().to_owned(), names })
        }
    }
}

fn targets(arguments: &Arguments, film: &Film) -> Result<Vec<Target>, CliError> {
    let mut targets = Vec::new();
    if let Some(path) = &arguments.output {
        targets.push(match Sequence::named(path) {
            Some(sequence) => {
                let frames = 0..film.frames as usize;
                Target::Frames(frames.map(|frame| Output::open(&sequence.path(frame))).collect::<Result<_, _>>()?)
            }
            None => Target::Film(container(path, film.rate)?, Output::open(path)?),
        });
    }
    if let Some(path) = &arguments.sheet {
        let kind = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
        if kind.as_deref() != Some("png") {
            return Err(CliError::SheetType { path: path.clone() });
        }
        // A sheet that is too large is refused without a place to write it to.
        Sheet::new(film.clone(), io::sink()).map_err(CliError::write(path))?;
        let (output, json) = (Output::open(path)?, Output::open(&path.with_extension("json"))?);
        let image = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        targets.push(Target::Sheet { output, json, image });
    }
    Ok(targets)
}

/// The container format, chosen by the extension of a path.
fn container(path: &Path, rate: f64) -> Result<Container, CliError> {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let name = path.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
    match extension.as_deref() {
        // Single frames of another type.
        _ if name.contains("%d") || name.contains("%0") => Err(CliError::FilmType { path: path.to_owned() }),
        Some("gif") if rate > MOST_GIF_RATE => Err(CliError::GifRate { most: MOST_GIF_RATE }),
        Some("gif") => Ok(Container::Gif),
        Some("png" | "apng") => Ok(Container::Apng),
        Some("webp") => Ok(Container::WebP),
        _ => Err(CliError::FilmType { path: path.to_owned() }),
    }
}

fn write_film(
    drawing: &mut Drawing<'_>,
    container: Container,
    film: &Film,
    matte: Option<[u8; 3]>,
    output: Output,
) -> Result<(), CliError> {
    let film = film.clone();
    match container {
        Container::Gif => {
            let colours = GifColours::new(&drawing.picture_at_rest()?, matte);
            write(drawing, output, |writer| Ok(Box::new(Gif::new(film, colours, writer)?)))
        }
        Container::Apng => write(drawing, output, |writer| Ok(Box::new(Apng::new(film, writer)?))),
        Container::WebP => {
            // Its length stands at its beginning, and an output cannot be sought.
            let mut file = tempfile::tempfile().map_err(CliError::write(std::env::temp_dir()))?;
            let begun = WebP::new(film, BufWriter::new(&file)).map_err(CliError::write(std::env::temp_dir()))?;
            encode(drawing, Box::new(begun)).map_err(|failure| failure.named(&std::env::temp_dir()))?;
            file.seek(SeekFrom::Start(0)).map_err(CliError::write(std::env::temp_dir()))?;
            output.write(|writer| io::copy(&mut file, writer).map(|_| ()))
        }
    }
}

/// Writes all frames with the encoder of an output.
fn write(
    drawing: &mut Drawing<'_>,
    output: Output,
    begin: impl for<'w> FnOnce(&'w mut dyn Write) -> io::Result<Box<dyn Encoder + 'w>>,
) -> Result<(), CliError> {
    let mut refused = None;
    let written = output.write(|writer| {
        encode(drawing, begin(writer)?).map_err(|failure| match failure {
            Failure::Output(reason) => reason,
            Failure::Refused(error) => {
                refused = Some(error);
                io::ErrorKind::Other.into()
            }
        })
    });
    refused.map_or(written, Err)
}

/// Why a film is not complete.
enum Failure {
    Output(io::Error),
    Refused(CliError),
}

impl Failure {
    fn named(self, path: &Path) -> CliError {
        match self {
            Self::Output(reason) => CliError::write(path)(reason),
            Self::Refused(error) => error,
        }
    }
}

fn encode(drawing: &mut Drawing<'_>, mut encoder: Box<dyn Encoder + '_>) -> Result<(), Failure> {
    drawing.draw(|warped| warped.rgba, |_, rgba| encoder.add(&rgba).map_err(Failure::Output), Failure::Refused)?;
    encoder.finish().map_err(Failure::Output)
}

fn write_frames(drawing: &mut Drawing<'_>, frames: Vec<Output>, profile: Option<&[u8]>) -> Result<(), CliError> {
    let mut frames = frames.into_iter();
    drawing.draw(
        |Warped { width, height, rgba, .. }| encode_png([width, height], &rgba, profile).map_err(io::Error::other),
        |_, png| {
            let output = frames.next().expect("every frame has an output");
            output.write(|writer| writer.write_all(&png?))
        },
        |error| error,
    )
}
