//! A project file with the picture beside it, and a picture as a file.

use std::error::Error;
use std::fs;
use std::path::Path;

use c2warp::project::Project;
use image::RgbaImage;

/// Reads a project, and the picture that it names.
pub(crate) fn open(path: &Path) -> Result<(Project, RgbaImage), Box<dyn Error>> {
    let project = Project::from_json(&fs::read_to_string(path)?)?;
    let picture = image::open(path.with_file_name(&project.image.src))?.into_rgba8();
    Ok((project, picture))
}

/// Saves straight RGBA as a PNG.
#[allow(dead_code, reason = "two of the examples draw no picture")]
pub(crate) fn save(rgba: Vec<u8>, width: u32, height: u32, path: &Path) -> Result<(), Box<dyn Error>> {
    let picture = RgbaImage::from_raw(width, height, rgba).ok_or("the picture has too few bytes")?;
    Ok(picture.save(path)?)
}

/// A sample of the editor.
#[cfg(test)]
pub(crate) fn sample(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/public/samples").join(name)
}
