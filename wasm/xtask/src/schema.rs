//! `xtask schema`: the types and constants that the solver shares with other code.
//!
//! Writes a JSON schema of the project file for editors and validators, and TypeScript for the page. The page shares
//! the project, the report of a solve, its stages, codes of errors, limits and settings. The files are committed, so
//! the page type-checks without Rust. `--check` fails if they are out of date.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use c2warp::{
    Error, Inspection, Lens, Stage, Study, limits,
    project::{Handle, ImageRef, Project},
};
use c2warp_maps::HEAT_RAMP;
use schemars::{JsonSchema, generate::SchemaSettings};
use serde_json::Value;

use crate::typescript::{self, HEADER, Unknown};

/// Why the files were not written, or are out of date.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SchemaError {
    #[error("could not write {path}: {reason}")]
    Write { path: PathBuf, reason: io::Error },
    #[error("{path} is out of date: run `cargo run -p xtask -- schema` and commit the files that it writes")]
    OutOfDate { path: PathBuf },
    #[error(transparent)]
    TypeScript(#[from] Unknown),
}

/// Writes all files, or only compares them.
pub(crate) fn write(root: &Path, check: bool) -> Result<(), SchemaError> {
    // For reading: a file may leave out many keys.
    let project = SchemaSettings::draft2020_12().for_deserialize().into_generator().into_root_schema_for::<Project>();
    let json = serde_json::to_string_pretty(&project).expect("a schema is JSON already") + "\n";
    let files = [
        ("web/src/document/generated/project.schema.json", json),
        ("web/src/document/generated/project.ts", typescript::declarations(project.as_value())?),
        ("web/src/document/generated/settings.ts", settings(project.as_value())),
        ("web/src/document/generated/error_code.ts", error_codes()),
        ("web/src/compute/generated/report.ts", report()?),
        ("web/src/document/generated/study.ts", typescript::declarations(&output_schema::<Study>())?),
        ("web/src/document/generated/lens.ts", typescript::declarations(&output_schema::<Lens>())?),
        ("web/src/io/generated/limits.ts", picture_limits()),
        ("web/src/geometry/generated/heat_ramp.ts", heat_ramp()),
    ];
    for (path, text) in files {
        let path = Path::new(path);
        if check {
            check_file(root, path, &text)?;
        } else {
            write_file(&root.join(path), &text)?;
        }
    }
    Ok(())
}

fn check_file(root: &Path, path: &Path, text: &str) -> Result<(), SchemaError> {
    // A checkout on Windows may have other line ends.
    let found = fs::read_to_string(root.join(path)).ok().map(|found| found.replace("\r\n", "\n"));
    if found.as_deref() == Some(text) { Ok(()) } else { Err(SchemaError::OutOfDate { path: path.into() }) }
}

fn write_file(path: &Path, text: &str) -> Result<(), SchemaError> {
    let folder = path.parent().expect("every file is in a folder");
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(path, text))
        .map_err(|reason| SchemaError::Write { path: path.into(), reason })
}

/// The report of a solve, and its stages.
fn report() -> Result<String, Unknown> {
    let mut text = typescript::declarations(&output_schema::<Inspection>())?;
    typescript::declare(&mut text, "Stage", &output_schema::<Stage>())?;
    Ok(text)
}

fn error_codes() -> String {
    let codes: Vec<String> = Error::CODES.into_iter().map(|code| format!("  | '{code}'")).collect();
    format!(
        "{HEADER}\n/** The code of an input that the solver refuses. */\nexport type ErrorCode =\n{};\n",
        codes.join("\n")
    )
}

fn output_schema<T: JsonSchema>() -> Value {
    SchemaSettings::draft2020_12().for_serialize().into_generator().into_root_schema_for::<T>().into()
}

fn picture_limits() -> String {
    let constants = [
        ("Least width and height of a picture, in pixels.", "MIN_SIDE", u64::from(limits::MIN_SIDE)),
        ("Greatest width and height of a picture, in pixels.", "MAX_SIDE", u64::from(limits::MAX_SIDE)),
        ("Greatest number of pixels of a picture.", "MAX_PIXELS", limits::MAX_PIXELS),
        ("Greatest length of a project file, in bytes.", "MAX_PROJECT_BYTES", limits::MAX_PROJECT_BYTES as u64),
    ];
    constants.into_iter().fold(HEADER.to_owned(), |text, (comment, name, value)| {
        text + &format!("\n/** {comment} */\nexport const {name} = {value};\n")
    })
}

/// The colours of heat maps, in the editor and in the command.
fn heat_ramp() -> String {
    let comment = "The colours of 0, 0.2, … 1: sRGB, 0 to 255, and an opacity, 0 to 1.";
    let lines = HEAT_RAMP.map(|[red, green, blue, alpha]| format!("  [{red}, {green}, {blue}, {alpha}],\n")).concat();
    format!("{HEADER}\n/** {comment} */\nexport const HEAT_RAMP = [\n{lines}] as const;\n")
}

/// The settings of the editor, and the defaults of the format, taken from the paper.
fn settings(schema: &Value) -> String {
    let paper = Project::new(ImageRef::new("", 2, 2)).with_handles([Handle::point("point", [1.0, 1.0])]);
    let editor = paper.clone().with_editor_settings();
    let all = [
        ("The defaults of the format, taken from the paper.", "PAPER_SETTINGS", paper),
        ("The editor's settings for new projects.", "EDITOR_SETTINGS", editor),
    ];
    let names = format!(
        "\n/** The most characters of the name of a handle or a clip. */\nexport const MAX_NAME = {};\n",
        limits::MAX_NAME
    );
    let text = HEADER.to_owned() + &ranges(schema) + &names + &stiffness_cells(schema) + &displacement_points(schema);
    all.into_iter().fold(text, |text, (comment, name, project)| {
        let json: Value = serde_json::from_str(&project.to_json()).expect("a project is JSON");
        let settings = [
            ("samples", &json["samples"]),
            ("shape_factor", &json["weighting"]["shape_factor"]),
            ("degree", &json["weighting"]["degree"]),
            ("filling", &json["weighting"]["filling"]),
            ("support", &json["weighting"]["support"]),
            ("mode", &json["pose"]["mode"]),
            ("blend", &json["pose"]["blend"]),
            ("density", &json["pose"]["density"]),
            ("rotation", &json["handles"][0]["rotation"]),
        ];
        let lines = settings.map(|(key, value)| format!("  {key}: {},\n", literal(value))).concat();
        text + &format!("\n/** {comment} */\nexport const {name} = {{\n{lines}}} as const;\n")
    })
}

/// The least and the largest value of each number.
fn ranges(schema: &Value) -> String {
    let numbers = [
        ("samples", &schema["properties"]["samples"]),
        ("shape_factor", &schema["$defs"]["Weighting"]["properties"]["shape_factor"]),
        ("degree", &schema["$defs"]["Weighting"]["properties"]["degree"]),
        ("density", &schema["$defs"]["Pose"]["properties"]["density"]),
    ];
    let range = |(name, number): (&str, &Value)| {
        format!("  {name}: [{}, {}],\n", literal(&number["minimum"]), literal(&number["maximum"]))
    };
    let lines = numbers.map(range).concat();
    format!("\n/** The least and the largest value of each number. */\nexport const RANGES = {{\n{lines}}} as const;\n")
}

/// The maximum number of cells of a mask along either side.
fn stiffness_cells(schema: &Value) -> String {
    let most = literal(&schema["$defs"]["Stiffness"]["properties"]["width"]["maximum"]);
    format!("\n/** The most cells of a mask of stiffness, each way. */\nexport const STIFFNESS_CELLS = {most};\n")
}

/// The minimum and maximum numbers of control points of a displacement along either side.
fn displacement_points(schema: &Value) -> String {
    let side = &schema["$defs"]["Displacement"]["properties"]["width"];
    let [least, most] = ["minimum", "maximum"].map(|end| literal(&side[end]));
    let comment = "The least and the greatest number of control points of a displacement along each axis.";
    format!("\n/** {comment} */\nexport const DISPLACEMENT_POINTS = [{least}, {most}] as const;\n")
}

/// The TypeScript literal of a text or number.
fn literal(value: &Value) -> String {
    match value {
        Value::String(text) => format!("'{text}'"),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), |number| number.to_string()),
        other => other.to_string(),
    }
}
