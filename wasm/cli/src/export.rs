//! `c2warp export`: the picture as a rig for a game engine, with bones, weights and baked clips.

use std::io;
use std::path::PathBuf;

use c2warp_export::{EngineRig, Errors, ExportError, Format, KEY_TOLERANCE_PX, Options, texture};
use serde_json::{Value, json};

use crate::error::CliError;
use crate::output::{self, Output};
use crate::png_file::encode_png;
use crate::progress;
use crate::project::{InputFiles, LoadedProject};

/// Writes the picture and its clips as a rig for a game engine, and prints how far the rig differs from the project
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: a rig for Spine with 40 bones, as cat.spine.json, cat.atlas and cat.png\n  \
                        c2warp export cat.c2warp.json -o rigs/cat.spine.json --bones 40")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// The output: OUT.spine.json (Spine), OUT_ske.json (DragonBones), OUT.glb (glTF) or OUT.tscn (Godot). An atlas and
    /// the picture are written beside it, except for glTF
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// The maximum number of bones besides the root: at least one for each handle, at most 255
    #[arg(long, value_name = "N", default_value_t = Options::default().bones as f64, allow_negative_numbers = true)]
    bones: f64,
    /// The maximum number of bones that move a vertex. Godot and most engines support 4
    #[arg(long, value_name = "N", default_value_t = Options::default().influences as f64, allow_negative_numbers = true)]
    influences: f64,
    /// The maximum number of vertices
    #[arg(long, value_name = "N", default_value_t = Options::default().vertices as f64, allow_negative_numbers = true)]
    vertices: f64,
    /// Print the differences as one JSON object instead of a table
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    // Reject invalid options and outputs before solving.
    let path = &arguments.output;
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let (format, stem) = Format::of_file(name).ok_or_else(|| CliError::RigType { path: path.clone() })?;
    let options = Options {
        bones: whole("--bones", arguments.bones)?,
        influences: whole("--influences", arguments.influences)?,
        vertices: whole("--vertices", arguments.vertices)?,
    };
    options.check(format).map_err(|reason| CliError::Export(Box::new(reason)))?;
    let loaded = LoadedProject::open(&arguments.files)?;
    let refused =
        |reason: ExportError| CliError::NotExported { path: loaded.path().to_owned(), reason: Box::new(reason) };
    options.check_handles(&loaded.project).map_err(refused)?;
    let picture = loaded.picture()?;
    let beside = |ending: &str| path.with_file_name(format!("{stem}{ending}"));
    let endings = [format.ending()].into_iter().chain(format.other_endings().iter().copied());
    let outputs = endings.map(|ending| Output::open(&beside(ending))).collect::<Result<Vec<_>, _>>()?;
    // The project's own picture is used as it is.
    let picture_path = format.picture_ending().map(beside).filter(|path| !loaded.is_picture(path));
    let picture_output = picture_path.map(|path| Output::open(&path)).transpose()?;

    let solution = loaded.solve()?;
    progress::show("fitting bones and weights");
    let rig = EngineRig::new(stem, &loaded.project, &solution, &picture, options).map_err(refused)?;
    let profile = loaded.picture_file().profile.as_deref();
    let size = [picture.width(), picture.height()];
    let png = encode_png(size, &texture(&picture), profile)
        .map_err(|reason| CliError::write(path)(io::Error::other(reason)))?;
    let files = rig.files(format, &png).map_err(refused)?;
    for (output, file) in outputs.into_iter().zip(files) {
        output.write(|writer| writer.write_all(&file.bytes))?;
    }
    if let Some(output) = picture_output {
        output.write(|writer| writer.write_all(&png))?;
    }
    let report = if arguments.json { format!("{:#}\n", report(&rig)) } else { table(&rig) };
    output::print(report.as_bytes())
}

fn whole(option: &'static str, number: f64) -> Result<usize, CliError> {
    if number.fract() == 0.0 && number >= 0.0 {
        // Huge numbers are cut to the greatest one, which is refused later.
        Ok(number as usize)
    } else {
        Err(CliError::Whole { option, found: number })
    }
}

/// The loss of a rig as JSON.
fn report(rig: &EngineRig) -> Value {
    let ((bones, sites), (vertices, triangles), loss) = (rig.bones(), rig.size(), rig.loss());
    let errors = |Errors { largest, percentile_99, mean }: &Errors| json!({ "largest": largest, "percentile_99": percentile_99, "mean": mean });
    let clips: Vec<Value> =
        loss.clips.iter().map(|(name, of_clip)| json!({ "name": name, "vertices": errors(of_clip) })).collect();
    json!({
        "bones": bones,
        "sites": sites,
        "influences": rig.influences(),
        "vertices": vertices,
        "triangles": triangles,
        "outline_px": rig.outline_tolerance(),
        "keys_px": KEY_TOLERANCE_PX,
        "errors_px": {
            "pose": errors(&loss.pose),
            "random_poses": errors(&loss.random),
            "clips": clips,
            "bones_by_hand": errors(&loss.unfitted),
            "between_vertices": errors(&loss.between),
        },
    })
}

/// The loss of a rig as a table.
fn table(rig: &EngineRig) -> String {
    let ((bones, sites), (vertices, triangles), loss) = (rig.bones(), rig.size(), rig.loss());
    let line = |name: &str, Errors { largest, percentile_99, mean }: &Errors| {
        format!("{name:<34}{largest:>9.3}{percentile_99:>9.3}{mean:>9.3}\n")
    };
    let mut text = [
        format!("bones        {bones} of {sites} sites\n"),
        format!("influences   {}\n", rig.influences()),
        format!("vertices     {vertices}, in {triangles} triangles\n"),
        format!("outline      within {:.1} px\n", rig.outline_tolerance()),
    ]
    .concat();
    if !loss.clips.is_empty() {
        text += &format!("keys         within {KEY_TOLERANCE_PX} px more, at 60 frames a second\n");
    }
    text += &format!("{:<34}{:>9}{:>9}{:>9}\n", "error in pixels", "largest", "99 %", "mean");
    text += &line("vertices, project's pose", &loss.pose);
    text += &line("vertices, 20 random poses", &loss.random);
    for (name, errors) in &loss.clips {
        text += &line(&format!("vertices, clip {name:?}"), errors);
    }
    text += &line("bones by hand, 20 random poses", &loss.unfitted);
    text + &line("between vertices", &loss.between)
}
