//! `c2warp-quality FOLDER [NAME]`: prints tables and writes a sheet of pictures per pose to the folder.
//!
//! It compares distances with geodesics, counts secondary maxima of weights, and measures jumps of their derivatives.
//! It draws suggested handles, drags handles of samples, and compares methods on the standard poses. With NAME, it runs
//! only the parts and poses whose name contains NAME.
//!
//! `c2warp-quality --fill FOLDER PYTHON PICTURES` fills photographs, beside OpenCV's methods. PYTHON is a Python with
//! OpenCV. It also writes blind sheets, and their key to `blind-key.txt`.
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
    continuity::continuity,
    distances::distances,
    drags::drags,
    fills::{Filled, Others, fills, fills_of},
    maxima::maxima,
    methods::{Comparison, EDITOR, METHODS, METHODS_BESIDE_OPTIMUM, Method, OTHER_SAMPLES},
    poses::{PosedScene, standard_poses},
    random_poses::poses_beside_optimum,
    sheet::{Row, sheet},
    suggestions::suggestions,
    tables::{Measured, fill_table, tables},
};

/// Names of the parts besides poses.
const DISTANCES: &str = "distances";
const MAXIMA: &str = "maxima";
const CONTINUITY: &str = "continuity";
const SUGGEST: &str = "suggest";
const FILL: &str = "fill";
const DRAGS: &str = "drags";

/// The pose of the overview.
const WAVING: &str = "2 waving";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["--overview", file] => overview(Path::new(file)),
        ["--fill", folder, python, ref pictures @ ..] => fill_pictures(Path::new(folder), Path::new(python), pictures),
        [folder] if !folder.starts_with('-') => compare(Path::new(folder), ""),
        [folder, name] if !folder.starts_with('-') => compare(Path::new(folder), name),
        _ => Err("usage: c2warp-quality FOLDER [NAME], --fill FOLDER PYTHON PICTURES, or --overview FILE".into()),
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
    Ok(sheet(&Comparison::of(waving, &METHODS, &[])?, &methods, &[Row::Grid, Row::Picture]).save(file)?)
}

fn fill_pictures(folder: &Path, python: &Path, pictures: &[&str]) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let filled = fills_of(pictures, Others::OpenCv { python, folder })?;
    save_fills(folder, &filled)?;
    let mut key = String::new();
    for filled in &filled {
        filled.blind_sheet().save(folder.join(format!("blind-{}.png", filled.name)))?;
        key += &filled.blind_key();
    }
    fs::write(folder.join("blind-key.txt"), key)?;
    Ok(io::stdout().write_all(fill_table(&filled).as_bytes())?)
}

fn save_fills(folder: &Path, filled: &[Filled]) -> Result<(), Box<dyn Error>> {
    for filled in filled {
        filled.sheet().save(folder.join(format!("fill-{}.png", filled.name)))?;
    }
    Ok(())
}

fn compare(folder: &Path, name: &str) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let runs = |part: &str| {
        let runs = part.contains(name);
        if runs {
            eprintln!("  {part}");
        }
        runs
    };
    let mut measured = Measured::default();
    if runs(DISTANCES) {
        measured.distances = distances();
    }
    if runs(MAXIMA) {
        measured.maxima = maxima()?;
    }
    if runs(CONTINUITY) {
        measured.continuity = continuity()?;
    }
    if runs(SUGGEST) {
        measured.suggested = suggestions()?;
        for suggested in &measured.suggested {
            let file = format!("suggest-{}.png", suggested.name.replace(' ', "-"));
            suggested.sheet().save(folder.join(file))?;
        }
    }
    if runs(FILL) {
        measured.filled = fills()?;
        save_fills(folder, &measured.filled)?;
    }
    if runs(DRAGS) {
        measured.drags = drags()?;
    }
    let mut comparisons = Comparisons { folder, name, done: Vec::new(), failed: Vec::new() };
    comparisons.run(standard_poses()?, &METHODS, &OTHER_SAMPLES)?;
    comparisons.run(poses_beside_optimum()?, &METHODS_BESIDE_OPTIMUM, &[])?;
    (measured.comparisons, measured.failed) = (comparisons.done, comparisons.failed);
    let text = tables(&measured);
    fs::write(folder.join("tables.md"), &text)?;
    Ok(io::stdout().write_all(text.as_bytes())?)
}

/// The comparisons of poses, and where their sheets go.
struct Comparisons<'a> {
    folder: &'a Path,
    /// Poses without it in their name are left out.
    name: &'a str,
    done: Vec<Comparison>,
    failed: Vec<(String, String)>,
}

impl Comparisons<'_> {
    fn run(
        &mut self,
        scenes: Vec<PosedScene>,
        methods: &[Method],
        other_samples: &[u32],
    ) -> Result<(), Box<dyn Error>> {
        for scene in scenes.into_iter().filter(|scene| scene.name.contains(self.name)) {
            let name = scene.name.clone();
            eprintln!("  {name}");
            match Comparison::of(scene, methods, other_samples) {
                Ok(comparison) => {
                    sheet(&comparison, methods, &Row::ALL)
                        .save(self.folder.join(name.replace(' ', "-")).with_extension("png"))?;
                    self.done.push(comparison);
                }
                Err(reason) => self.failed.push((name, reason.to_string())),
            }
        }
        Ok(())
    }
}
