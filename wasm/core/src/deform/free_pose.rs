//! The pose of a handle if it followed the others.
//!
//! The handle takes the rigid motion that best fits the others, with near handles weighted most. These are moving least
//! squares (Schaefer, McPhail, Warren, "Image deformation using moving least squares", 2006). A common motion of all
//! handles moves the free pose in the same way. The order of handles does not matter, except for rounding.
//!
//! Cost: linear in the corners of all handles.

use glam::DVec2;

use super::handle_pose::HandlePose;
use crate::project::{Handle, Rotation};

/// Squared distances are at least this, in square pixels.
const LEAST_SQUARE: f64 = 1e-6;

/// The pose of the handle `of` that follows those of the handles `by`. `None` if there are none.
pub(super) fn free_pose(handles: &[Handle], of: usize, by: impl Fn(usize) -> bool) -> Option<HandlePose> {
    let handle = &handles[of];
    let rest = centre(handle.shape.rest());
    let others = || handles.iter().enumerate().filter(|&(k, _)| k != of && by(k)).map(|(_, other)| other);
    let corners: Vec<Moved> = others().flat_map(|other| moved(other, rest)).collect();
    if corners.is_empty() {
        return None;
    }
    let motion = RigidMotion::fitting(&corners);
    let turns = || others().filter(|other| matches!(other.rotation, Rotation::Degrees(_)) && is_point(other));
    let rotation = match handle.rotation {
        Rotation::Auto => Rotation::Auto,
        // The motion of their positions does not reveal manual turns of other handles.
        Rotation::Degrees(_) if turns().next().is_some() => {
            Rotation::Degrees(mean(turns().map(|other| (nearness(other, rest), degrees(other)))))
        }
        Rotation::Degrees(_) => Rotation::Degrees(motion.degrees()),
    };
    Some(HandlePose {
        posed: handle.shape.rest().iter().map(|&corner| motion.of(corner)).collect(),
        rotation,
        scale: mean(others().map(|other| (nearness(other, rest), other.scale))),
        depth: handle.depth,
    })
}

/// A corner at rest and posed, and its weight.
struct Moved {
    rest: DVec2,
    posed: DVec2,
    weight: f64,
}

fn moved(handle: &Handle, near: DVec2) -> impl Iterator<Item = Moved> + '_ {
    let corners = handle.shape.rest().iter().zip(handle.shape.posed());
    corners.map(move |(&rest, &posed)| Moved { rest, posed, weight: weight(rest, near) })
}

/// The inverse fourth power of the distance, so the nearest handles dominate.
fn weight(p: DVec2, near: DVec2) -> f64 {
    p.distance_squared(near).max(LEAST_SQUARE).powi(-2)
}

fn nearness(handle: &Handle, near: DVec2) -> f64 {
    handle.shape.rest().iter().map(|&corner| weight(corner, near)).fold(0.0, f64::max)
}

fn is_point(handle: &Handle) -> bool {
    handle.shape.rest().len() == 1
}

fn degrees(handle: &Handle) -> f64 {
    if let Rotation::Degrees(degrees) = handle.rotation { degrees } else { 0.0 }
}

/// The mean of values, each with its weight.
fn mean(values: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (sum, total) = values.fold((0.0, 0.0), |(sum, total), (weight, value)| (sum + weight * value, total + weight));
    sum / total
}

fn centre(corners: &[DVec2]) -> DVec2 {
    corners.iter().sum::<DVec2>() / corners.len().max(1) as f64
}

struct RigidMotion {
    rest: DVec2,
    posed: DVec2,
    /// Cosine and sine of the turn.
    turn: DVec2,
}

impl RigidMotion {
    /// The motion with the least sum of weighted squares.
    fn fitting(corners: &[Moved]) -> Self {
        let total: f64 = corners.iter().map(|corner| corner.weight).sum();
        let rest = corners.iter().map(|corner| corner.weight * corner.rest).sum::<DVec2>() / total;
        let posed = corners.iter().map(|corner| corner.weight * corner.posed).sum::<DVec2>() / total;
        let turn = corners.iter().map(|corner| {
            let (before, after) = (corner.rest - rest, corner.posed - posed);
            corner.weight * DVec2::new(before.dot(after), before.perp_dot(after))
        });
        Self { rest, posed, turn: turn.sum::<DVec2>().try_normalize().unwrap_or(DVec2::X) }
    }

    fn of(&self, p: DVec2) -> DVec2 {
        self.posed + self.turn.rotate(p - self.rest)
    }

    fn degrees(&self) -> f64 {
        libm::atan2(self.turn.y, self.turn.x).to_degrees()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(rest: [f64; 2], posed: [f64; 2]) -> Handle {
        Handle::point(format!("{rest:?}"), rest).posed_at([posed])
    }

    fn free(handles: &[Handle], of: usize) -> HandlePose {
        free_pose(handles, of, |_| true).unwrap()
    }

    #[test]
    fn single_handle_has_no_free_pose() {
        assert_eq!(free_pose(&[at([1.0, 2.0], [3.0, 4.0])], 0, |_| true), None);
        let two = [at([1.0, 2.0], [3.0, 4.0]), at([5.0, 5.0], [5.0, 6.0])];
        assert_eq!(free_pose(&two, 0, |_| false), None);
    }

    #[test]
    fn a_handle_follows_a_motion_of_all_others() {
        // A quarter turn about (10, 0), and 5 to the right.
        let turned = |[x, y]: [f64; 2]| [15.0 - y, x - 10.0];
        let rest = [[0.0, 0.0], [20.0, 4.0], [7.0, 30.0], [12.0, 9.0]];
        let mut handles: Vec<Handle> = rest.iter().map(|&p| at(p, turned(p))).collect();
        handles[3] = Handle::bar("bar", [rest[3], [14.0, 12.0]]).posed_at([[0.0, 0.0], [90.0, 1.0]]);
        let pose = free(&handles, 3);
        let expected = [turned(rest[3]), turned([14.0, 12.0])].map(DVec2::from);
        for (posed, expected) in pose.posed.iter().zip(expected) {
            assert!(posed.distance(expected) < 1e-9, "{pose:?}");
        }
    }

    #[test]
    fn a_handle_follows_the_nearest_most() {
        let handles = [at([0.0, 0.0], [0.0, 0.0]), at([10.0, 0.0], [16.0, 0.0]), at([100.0, 0.0], [101.0, 0.0])];
        let [posed] = free(&handles, 0).posed[..] else { panic!("a point has a corner") };
        assert!(posed.distance(DVec2::new(6.0, 0.0)) < 1.0, "{posed}");
    }

    #[test]
    fn turned_handle_follows_the_turn_of_other_handles() {
        let turned = |handle: Handle, degrees: f64| handle.turned(degrees);
        let handles = [
            turned(at([0.0, 0.0], [0.0, 0.0]), 170.0),
            turned(at([10.0, 0.0], [10.0, 0.0]), 30.0),
            at([0.0, 9.0], [0.0, 9.0]).turned(Rotation::Auto),
        ];
        assert_eq!(free(&handles, 0).rotation, Rotation::Degrees(30.0));
        assert_eq!(free(&handles, 2).rotation, Rotation::Auto);
    }
}
