//! `c2warp-quality FOLDER [NAME]`: prints tables and writes a sheet of pictures per pose to the folder.
//!
//! It compares distances with geodesics, counts secondary maxima of weights, and compares methods on the standard
//! poses. With NAME, it runs only the parts and poses whose name contains NAME.
//!
//! `c2warp-quality --overview FILE` draws one pose by the editor's method and the methods it is compared with.

use std::{
    error::Error,
    fs,
    io::{self, Write},
    path::Path,
    process::ExitCode,
};

use c2warp_quality::{
    distances::distances,
    maxima::maxima,
    methods::{Comparison, EDITOR, METHODS, Method},
    poses::standard_poses,
    sheet::{Row, sheet},
    tables::tables,
};

/// Names of the parts that do not measure poses.
const DISTANCES: &str = "distances";
const MAXIMA: &str = "maxima";

/// The pose of the overview.
const WAVING: &str = "2 waving";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["--overview", file] => overview(Path::new(file)),
        [folder] if !folder.starts_with('-') => compare(Path::new(folder), ""),
        [folder, name] if !folder.starts_with('-') => compare(Path::new(folder), name),
        _ => Err("usage: c2warp-quality FOLDER [NAME], or c2warp-quality --overview FILE".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("c2warp-quality: {error}");
            ExitCode::FAILURE
        }
    }
}

fn overview(file: &Path) -> Result<(), Box<dyn Error>> {
    let waving = standard_poses()?.into_iter().find(|pose| pose.name == WAVING).ok_or("no such pose")?;
    let methods = [Method::Paper, EDITOR, Method::Dense, Method::LeastSquares];
    Ok(sheet(&Comparison::of(waving)?, &methods, &[Row::Grid, Row::Picture]).save(file)?)
}

fn compare(folder: &Path, name: &str) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let mut measured = Vec::new();
    if DISTANCES.contains(name) {
        eprintln!("  {DISTANCES}");
        measured = distances();
    }
    let mut counted = Vec::new();
    if MAXIMA.contains(name) {
        eprintln!("  {MAXIMA}");
        counted = maxima()?;
    }
    let (mut comparisons, mut failed) = (Vec::new(), Vec::new());
    for pose in standard_poses()?.into_iter().filter(|pose| pose.name.contains(name)) {
        let name = pose.name;
        eprintln!("  {name}");
        match Comparison::of(pose) {
            Ok(comparison) => {
                sheet(&comparison, &METHODS, &Row::ALL)
                    .save(folder.join(name.replace(' ', "-")).with_extension("png"))?;
                comparisons.push(comparison);
            }
            Err(reason) => failed.push((name, reason.to_string())),
        }
    }
    let text = tables(&measured, &counted, &comparisons, &failed);
    fs::write(folder.join("tables.md"), &text)?;
    Ok(io::stdout().write_all(text.as_bytes())?)
}
