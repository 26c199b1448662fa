//! The two inpainting methods of OpenCV, by its package for Python.

use std::{error::Error, path::Path, process::Command};

use image::{Luma, RgbaImage};

/// The script that calls OpenCV.
const SCRIPT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/photographs/inpaint.py");

/// Fills a hole by the methods of Telea, and of Navier and Stokes.
pub(super) fn filled(
    python: &Path,
    folder: &Path,
    name: &str,
    truth: &RgbaImage,
    hole: &[bool],
) -> Result<[RgbaImage; 2], Box<dyn Error>> {
    let file = |part: &str| folder.join(format!("fill-{name}-{part}.png"));
    truth.save(file("truth"))?;
    let mask = image::GrayImage::from_fn(truth.width(), truth.height(), |x, y| {
        Luma([if hole[(y * truth.width() + x) as usize] { 255 } else { 0 }])
    });
    mask.save(file("hole"))?;
    let files = ["truth", "hole", "telea", "navier-stokes"].map(file);
    let done = Command::new(python).arg(SCRIPT).args(&files).output()?;
    if !done.status.success() {
        return Err(format!("OpenCV failed: {}", String::from_utf8_lossy(&done.stderr)).into());
    }
    let [_, _, telea, navier_stokes] = files;
    Ok([image::open(telea)?.into_rgba8(), image::open(navier_stokes)?.into_rgba8()])
}
