//! Warps a picture by the handles of its project, with one handle moved further:
//!
//! ```sh
//! cargo run --release -p c2warp --example warp -- cat.c2warp.json warped.png head 40 -60
//! ```

mod opened;

use std::env;
use std::error::Error;
use std::path::Path;

use c2warp::{Picture, ResampleOptions, solve};

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = env::args().skip(1).collect();
    match &*given {
        [project, output, handle, x, y] => warp(project.as_ref(), output.as_ref(), handle, [x.parse()?, y.parse()?]),
        _ => Err("expected: PROJECT OUTPUT HANDLE X Y".into()),
    }
}

/// Moves a handle by some pixels, and saves the warped picture.
fn warp(project: &Path, output: &Path, handle: &str, by: [f64; 2]) -> Result<(), Box<dyn Error>> {
    let (mut project, picture) = opened::open(project)?;
    let named = |id: &str| format!("there is no handle {id}");
    let moved = project.handles.iter_mut().find(|one| one.id == handle).ok_or_else(|| named(handle))?;
    for corner in moved.shape.posed_mut() {
        *corner += glam::DVec2::from(by);
    }
    let picture = Picture::new(picture.width(), picture.height(), &picture)?;
    // A solution depends on where handles rest: it serves all their poses.
    let solution = solve(&project, &picture)?;
    let pose = solution.pose(&project)?;
    let warped = solution.warped(&picture, &pose, ResampleOptions::default())?;
    opened::save(warped.rgba, warped.width, warped.height, output)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hand_moves_and_the_foot_stays() -> Result<(), Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let output = folder.path().join("warped.png");
        warp(&opened::sample("gingerbread.c2warp.json"), &output, "right-hand", [0.0, -150.0])?;
        let warped = image::open(output)?.into_rgba8();
        let original = image::open(opened::sample("gingerbread.png"))?.into_rgba8();
        assert_eq!(warped.dimensions(), original.dimensions());
        assert_eq!((original.get_pixel(900, 366)[3], warped.get_pixel(900, 366)[3]), (0, 255));
        let apart = |k: usize| original.get_pixel(312, 1126)[k].abs_diff(warped.get_pixel(312, 1126)[k]);
        assert!((0..4).all(|k| apart(k) < 3));
        assert!(warp(&opened::sample("gingerbread.c2warp.json"), folder.path(), "wing", [0.0; 2]).is_err());
        Ok(())
    }
}
