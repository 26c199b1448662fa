//! Test poses of handles for choosing the steps of a rig.

use glam::DVec2;

use crate::project::{Handle, Rotation, Shape};

const PROBES: usize = 6;

/// All handles at once, `reach` pixels away, turned and scaled. Motions that are sums never jump.
pub(super) fn scattered(handles: &[Handle], reach: f64) -> Vec<Vec<Handle>> {
    let probe = |probe: usize| {
        let pose = |(at, handle): (usize, &Handle)| {
            let mut posed = handle.clone();
            for (corner, place) in posed.shape.posed_mut().iter_mut().enumerate() {
                // Directions that differ between handles, corners and probes, without a pattern.
                let direction = 2.4 * (at + 3 * corner + 7 * probe) as f64;
                *place = handle.shape.rest()[corner] + reach * towards(direction);
            }
            let is_point = matches!(posed.shape, Shape::Point { .. });
            let quarter = if (at + probe) % 2 == 1 { 90.0 } else { -90.0 };
            posed.rotation = Rotation::Degrees(if is_point { quarter } else { 0.0 });
            posed.scale = if (at / 2 + probe) % 2 == 1 { 2.0 } else { 0.5 };
            posed
        };
        handles.iter().enumerate().map(pose).collect()
    };
    (0..PROBES).map(probe).collect()
}

/// The pose of the project, and poses that move one handle each by `reach` pixels.
pub(super) fn drags(handles: &[Handle], reach: f64) -> Vec<Vec<Handle>> {
    let drag = |probe: usize| {
        let mut posed = handles.to_vec();
        let by = reach * towards(2.4 * probe as f64);
        posed[probe % handles.len()].shape.posed_mut().iter_mut().for_each(|place| *place += by);
        posed
    };
    std::iter::once(handles.to_vec()).chain((0..PROBES).map(drag)).collect()
}

fn towards(direction: f64) -> DVec2 {
    DVec2::new(libm::cos(direction), libm::sin(direction))
}
