//! How far the picture jumps while handles are dragged.

use c2warp::{Error, Picture, project::Project, solve};
use glam::DVec2;

/// The number of frames of a drag.
const FRAMES: u32 = 200;

/// Returns the largest move of a sample between two frames, over the largest move of a handle. All handles are dragged
/// along straight lines from rest to their pose, in 200 frames.
///
/// # Errors
/// If the project cannot be solved.
pub fn largest_move(project: &Project, picture: &Picture<'_>) -> Result<f64, Error> {
    let solution = solve(project, picture)?;
    let frame = |number: u32| -> Result<(Vec<DVec2>, Vec<DVec2>), Error> {
        let mut handles = project.handles.clone();
        let mut places = Vec::new();
        for handle in &mut handles {
            let rest = handle.shape.rest().to_vec();
            for (posed, rest) in handle.shape.posed_mut().iter_mut().zip(rest) {
                *posed = rest.lerp(*posed, f64::from(number) / f64::from(FRAMES));
                places.push(*posed);
            }
        }
        let pose = solution.poser().pose(&handles, project.pose.blend)?;
        Ok((solution.posed_vertices(&pose)[..solution.samples()].to_vec(), places))
    };
    let mut largest = 0.0_f64;
    let mut before = frame(0)?;
    for number in 1..=FRAMES {
        let after = frame(number)?;
        largest = largest.max(farthest(&before.0, &after.0) / farthest(&before.1, &after.1));
        before = after;
    }
    Ok(largest)
}

fn farthest(before: &[DVec2], after: &[DVec2]) -> f64 {
    before.iter().zip(after).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use c2warp::project::Handle;

    use super::*;

    #[test]
    fn single_handle_moves_everything() {
        let mut project =
            Project::for_picture(40, 30).with_handles([Handle::point("a", [20.0, 15.0]).posed_at([[30.0, 9.0]])]);
        project.samples = 200;
        let rgba = vec![255; 40 * 30 * 4];
        let found = largest_move(&project, &Picture::new(40, 30, &rgba).unwrap()).unwrap();
        assert!((found - 1.0).abs() < 1e-9, "{found}");
    }
}
