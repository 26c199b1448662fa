//! `c2warp-quality FOLDER [NAME]`: compares the methods on the standard poses, or on those whose name contains NAME; writes a
//! sheet for each to the folder and prints the tables.

use std::{
    error::Error,
    fs,
    io::{self, Write},
    path::Path,
    process::ExitCode,
};

use c2warp_quality::{methods::Compared, poses::standard_poses, sheet::sheet, tables::tables};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        [folder] if !folder.starts_with('-') => compare(Path::new(folder), ""),
        [folder, name] if !folder.starts_with('-') => compare(Path::new(folder), name),
        _ => Err("usage: c2warp-quality FOLDER [NAME]".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("c2warp-quality: {error}");
            ExitCode::FAILURE
        }
    }
}

fn compare(folder: &Path, name: &str) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let (mut all, mut unsolved) = (Vec::new(), Vec::new());
    for pose in standard_poses()?.into_iter().filter(|pose| pose.name.contains(name)) {
        let name = pose.name;
        eprintln!("  {name}");
        match Compared::of(pose) {
            Ok(compared) => {
                sheet(&compared).save(folder.join(name.replace(' ', "-")).with_extension("png"))?;
                all.push(compared);
            }
            Err(reason) => unsolved.push((name, reason.to_string())),
        }
    }
    let text = tables(&all, &unsolved);
    fs::write(folder.join("tables.md"), &text)?;
    Ok(io::stdout().write_all(text.as_bytes())?)
}
