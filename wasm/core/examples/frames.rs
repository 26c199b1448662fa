//! Draws the frames of a clip as PNGs, 12 per second:
//!
//! ```sh
//! cargo run --release -p c2warp --example frames -- gingerbread.c2warp.json wave frames
//! ```

mod opened;

use std::env;
use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

use c2warp::clip::{FrameTimes, Playback};
use c2warp::{Picture, ResampleOptions, solve};

const RATE: f64 = 12.0;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = env::args().skip(1).collect();
    match &*given {
        [project, clip, folder] => {
            let count = draw_frames(project.as_ref(), clip, folder.as_ref(), 1.0)?;
            Ok(writeln!(io::stdout(), "{count} frames in {folder}")?)
        }
        _ => Err("expected: PROJECT CLIP FOLDER".into()),
    }
}

/// Draws all frames at a fraction of the size, and returns their number.
fn draw_frames(project: &Path, clip: &str, folder: &Path, scale: f64) -> Result<usize, Box<dyn Error>> {
    let (project, picture) = opened::open(project)?;
    let clip = project.clips.iter().find(|one| one.name == clip).ok_or("unknown clip")?;
    let picture = Picture::new(picture.width(), picture.height(), &picture)?;
    let solution = solve(&project, &picture)?;
    // Frames depend only on the time: the playback has no jumps, and they can be drawn in any order.
    let mut playback = Playback::new(solution.poser().clone(), clip.clone(), project.handles.clone());
    let times = FrameTimes::new(clip, RATE, None)?;
    fs::create_dir_all(folder)?;
    for (frame, &time) in times.seconds().iter().enumerate() {
        let pose = playback.pose(time, project.pose.blend)?;
        let options = ResampleOptions { scale, ..ResampleOptions::default() };
        let drawn = solution.warped(&picture, &pose, options)?;
        opened::save(drawn.rgba, drawn.width, drawn.height, &folder.join(format!("{frame:03}.png")))?;
    }
    Ok(times.seconds().len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frames_of_a_clip_are_drawn_and_differ() -> Result<(), Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let count = draw_frames(&opened::sample("gingerbread.c2warp.json"), "wave", folder.path(), 0.1)?;
        assert_eq!((count, fs::read_dir(folder.path())?.count()), (26, 26));
        let frame = |number: u32| image::open(folder.path().join(format!("{number:03}.png")));
        let (first, later) = (frame(0)?.into_rgba8(), frame(8)?.into_rgba8());
        assert_eq!(first.dimensions(), (102, 128));
        assert_ne!(first, later);
        Ok(())
    }
}
