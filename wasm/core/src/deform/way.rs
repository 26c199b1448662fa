//! The ways between two poses of the same handles, along which the [fold guard](super::fold_guard) searches.
//!
//! Poses on a way are rounded as the editor stores them. Cost: a few operations for each corner.

use glam::DVec2;

use super::{
    handle_pose::HandlePose,
    rounding::{rounded, rounded_point, rounded_scale},
};
use crate::project::Rotation;

/// Poses from a start, at fraction 0, to an end, at fraction 1.
pub(super) trait Way {
    /// The wanted poses of all handles, as they were given.
    fn end(&self) -> &[HandlePose];
    /// The poses of all handles at a fraction of the way.
    fn at(&self, fraction: f64) -> Vec<HandlePose>;
}

/// Each handle moves on its own: its centre moves straight, and it turns and grows steadily.
#[derive(Debug, Clone)]
pub struct HandleWay {
    /// Poses at the start, in the order of the solved handles, and possibly others.
    pub from: Vec<HandlePose>,
    /// Poses at the end.
    pub to: Vec<HandlePose>,
    /// How far each handle turns.
    pub turns: Vec<Turn>,
}

/// The turn of a handle on its way, in degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// The turn at the start. For an automatic rotation, the computed one.
    pub from: f64,
    /// The turn at the end.
    pub to: f64,
    /// Whether the handle's rotation is a number that receives the turn. Otherwise it does not change.
    pub is_given: bool,
}

impl Way for HandleWay {
    fn end(&self) -> &[HandlePose] {
        &self.to
    }

    fn at(&self, fraction: f64) -> Vec<HandlePose> {
        let handles = self.from.iter().zip(&self.to).zip(&self.turns);
        handles.map(|((from, to), &turn)| between(from, to, turn, fraction)).collect()
    }
}

/// The pose at a fraction of the way. A line turns as a whole, so that it keeps its length.
fn between(from: &HandlePose, to: &HandlePose, turn: Turn, fraction: f64) -> HandlePose {
    // A handle that does not move keeps digits that rounding would drop.
    if from == to {
        return to.clone();
    }
    let angle = turn.from + fraction * (turn.to - turn.from);
    let (start, end) = (centre(&from.posed), centre(&to.posed));
    let middle = start + (end - start) * fraction;
    let corner = |(&before, &after): (&DVec2, &DVec2)| {
        let before = rotated(before - start, angle - turn.from);
        let after = rotated(after - end, angle - turn.to);
        rounded_point(middle + (before + (after - before) * fraction))
    };
    let growth = to.scale - from.scale;
    HandlePose {
        posed: if from.posed.len() == to.posed.len() {
            from.posed.iter().zip(&to.posed).map(corner).collect()
        } else {
            to.posed.clone()
        },
        rotation: if turn.is_given { Rotation::Degrees(rounded(angle)) } else { to.rotation },
        scale: if growth == 0.0 { to.scale } else { rounded_scale(from.scale + fraction * growth) },
        depth: to.depth,
    }
}

/// Some handles that turn and scale together about one centre; the others are at the end of their way.
#[derive(Debug, Clone)]
pub struct GroupWay {
    /// Poses of all handles at the end, in the order of the solved handles, and possibly others.
    pub to: Vec<HandlePose>,
    /// The handles that turn and scale.
    pub members: Vec<GroupMember>,
    /// The fixed point.
    pub pivot: DVec2,
    /// Turn and scale at the start and at the end, relative to the poses of the members.
    pub transforms: [GroupTransform; 2],
    /// Bounds of the scale, which keep the scales of all members in range.
    pub scales: [f64; 2],
}

/// A handle that turns and scales with others.
#[derive(Debug, Clone)]
pub struct GroupMember {
    /// Its index among all handles.
    pub index: usize,
    /// Its pose before anything was turned or scaled.
    pub origin: HandlePose,
    /// Its rotation in that pose, in degrees; for a bar or polygon, the rotation of its corners.
    pub rotation: f64,
}

/// A turn, in degrees, and a scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupTransform {
    /// In degrees.
    pub turn: f64,
    /// Above 0.
    pub scale: f64,
}

impl Way for GroupWay {
    fn end(&self) -> &[HandlePose] {
        &self.to
    }

    fn at(&self, fraction: f64) -> Vec<HandlePose> {
        let [from, to] = self.transforms;
        let turn = from.turn + fraction * (to.turn - from.turn);
        let [least, most] = self.scales;
        let scale = (from.scale + fraction * (to.scale - from.scale)).max(least).min(most);
        let mut poses = self.to.clone();
        for member in &self.members {
            poses[member.index] = member.turned_about(self.pivot, turn, scale);
        }
        poses
    }
}

impl GroupMember {
    /// The pose turned by degrees and scaled about a pivot. An automatic rotation stays automatic.
    fn turned_about(&self, pivot: DVec2, turn: f64, scale: f64) -> HandlePose {
        let origin = &self.origin;
        let corner = |&corner: &DVec2| rounded_point(pivot + rotated((corner - pivot) * scale, turn));
        let is_automatic = !origin.is_line() && origin.rotation == Rotation::Auto;
        HandlePose {
            posed: origin.posed.iter().map(corner).collect(),
            rotation: if turn == 0.0 || is_automatic {
                origin.rotation
            } else {
                Rotation::Degrees(rounded(self.rotation + turn))
            },
            scale: if scale == 1.0 { origin.scale } else { rounded_scale(origin.scale * scale) },
            depth: origin.depth,
        }
    }
}

fn centre(corners: &[DVec2]) -> DVec2 {
    corners.iter().sum::<DVec2>() * (1.0 / corners.len().max(1) as f64)
}

/// A vector turned by degrees.
fn rotated(v: DVec2, degrees: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(degrees * std::f64::consts::PI / 180.0);
    DVec2::new(cos, sin).rotate(v)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pose(posed: &[[f64; 2]], rotation: impl Into<Rotation>) -> HandlePose {
        let posed = posed.iter().map(|&p| p.into()).collect();
        HandlePose { posed, rotation: rotation.into(), scale: 1.0, depth: 0.0 }
    }

    fn halfway(from: &HandlePose, to: &HandlePose, turn: Turn) -> HandlePose {
        between(from, to, turn, 0.5)
    }

    #[test]
    fn a_bar_turns_as_a_whole_and_keeps_its_length() {
        let turn = Turn { from: 0.0, to: 180.0, is_given: true };
        let half = halfway(&pose(&[[0.0, 0.0], [10.0, 0.0]], 0.0), &pose(&[[10.0, 0.0], [0.0, 0.0]], 180.0), turn);
        assert_eq!(half, pose(&[[5.0, -5.0], [5.0, 5.0]], 90.0));
    }

    #[test]
    fn automatic_point_turns_from_its_computed_rotation() {
        let free = pose(&[[0.0, 0.0]], Rotation::Auto);
        let turn = Turn { from: 20.0, to: 40.0, is_given: true };
        assert_eq!(halfway(&free, &pose(&[[4.0, 0.0]], 40.0), turn), pose(&[[2.0, 0.0]], 30.0));
        let stays = Turn { from: 20.0, to: 20.0, is_given: false };
        let moved = pose(&[[4.0, 0.0]], Rotation::Auto);
        assert_eq!(halfway(&free, &moved, stays).rotation, Rotation::Auto);
    }

    #[test]
    fn a_turn_continues_past_half_a_turn() {
        let turn = Turn { from: 170.0, to: 210.0, is_given: true };
        let way = HandleWay {
            from: vec![pose(&[[0.0, 0.0]], 170.0)],
            to: vec![pose(&[[0.0, 0.0]], 210.0)],
            turns: vec![turn],
        };
        let rotations = [0.25, 0.5, 1.0].map(|fraction| way.at(fraction)[0].rotation);
        assert_eq!(rotations, [180.0, 190.0, 210.0].map(Rotation::Degrees));
    }

    #[test]
    fn a_handle_that_stays_keeps_all_digits() {
        let still = pose(&[[1.0 / 3.0, 0.0]], 0.0);
        assert_eq!(halfway(&still, &still, Turn { from: 0.0, to: 0.0, is_given: true }), still);
    }

    #[test]
    fn a_group_turns_and_scales_about_its_pivot_within_the_range() {
        let member = |index, origin, rotation| GroupMember { index, origin, rotation };
        let bar = pose(&[[-8.0, 0.0], [8.0, 0.0]], 0.0);
        let point = pose(&[[0.0, 9.0]], Rotation::Auto);
        let other = pose(&[[50.0, 50.0]], 0.0);
        let way = GroupWay {
            to: vec![bar.clone(), point.clone(), other.clone()],
            members: vec![member(0, bar, 0.0), member(1, point, 0.0)],
            pivot: DVec2::ZERO,
            transforms: [GroupTransform { turn: 0.0, scale: 1.0 }, GroupTransform { turn: 180.0, scale: 5.0 }],
            scales: [0.01, 2.0],
        };
        let half = way.at(0.5);
        let twice = |pose: HandlePose| HandlePose { scale: 2.0, ..pose };
        assert_eq!(half[0], twice(pose(&[[0.0, -16.0], [0.0, 16.0]], 90.0)));
        assert_eq!(half[1], twice(pose(&[[-18.0, 0.0]], Rotation::Auto)));
        assert_eq!(half[2], other);
    }
}
