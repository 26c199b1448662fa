//! `c2warp-quality FOLDER [NAME]`: compares distances with the geodesic, counts second maxima of weights, and compares the methods on the
//! standard poses, or what of this has a name that contains NAME; writes a sheet for each pose to the folder and prints the tables.
//! `c2warp-quality --overview FILE` draws one pose by the editor's mode and by those that it is compared with.

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
    methods::{Compared, EDITOR, METHODS, Method},
    poses::standard_poses,
    sheet::{Row, sheet},
    tables::tables,
};

/// The names of what is of no pose.
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
    Ok(sheet(&Compared::of(waving)?, &methods, &[Row::Grid, Row::Picture]).save(file)?)
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
    let (mut all, mut unsolved) = (Vec::new(), Vec::new());
    for pose in standard_poses()?.into_iter().filter(|pose| pose.name.contains(name)) {
        let name = pose.name;
        eprintln!("  {name}");
        match Compared::of(pose) {
            Ok(compared) => {
                sheet(&compared, &METHODS, &Row::ALL)
                    .save(folder.join(name.replace(' ', "-")).with_extension("png"))?;
                all.push(compared);
            }
            Err(reason) => unsolved.push((name, reason.to_string())),
        }
    }
    let text = tables(&measured, &counted, &all, &unsolved);
    fs::write(folder.join("tables.md"), &text)?;
    Ok(io::stdout().write_all(text.as_bytes())?)
}
