//! The fold guard: the farthest pose on a way that folds no more triangles than allowed.
//!
//! Cost: one pose and one pass over all triangles for each of [`STEPS`], and for the end of the way.

use super::{handle_pose::HandlePose, way::Way};

/// Bisections: the result is within 2⁻⁸ of the way.
const STEPS: i32 = 8;

/// The allowed part of a way.
#[derive(Debug, Clone, PartialEq)]
pub struct FoldLimit {
    /// The fraction of the way: 1 if the whole way is allowed.
    pub fraction: f64,
    /// The poses of all handles at that fraction.
    pub poses: Vec<HandlePose>,
}

/// The farthest poses on a way whose start is allowed.
pub(super) fn fold_limit(way: &dyn Way, is_allowed: &mut dyn FnMut(&[HandlePose]) -> bool) -> FoldLimit {
    if is_allowed(way.end()) {
        return FoldLimit { fraction: 1.0, poses: way.end().to_vec() };
    }
    let mut limit = FoldLimit { fraction: 0.0, poses: way.at(0.0) };
    for step in 1..=STEPS {
        let fraction = limit.fraction + 0.5_f64.powi(step);
        let poses = way.at(fraction);
        if is_allowed(&poses) {
            limit = FoldLimit { fraction, poses };
        }
    }
    limit
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        deform::way::{GroupMember, GroupTransform, GroupWay, HandleWay, Turn},
        project::Rotation,
    };

    fn point(x: f64, y: f64) -> HandlePose {
        HandlePose { posed: vec![[x, y].into()], rotation: Rotation::Degrees(0.0), scale: 1.0, depth: 0.0 }
    }

    fn straight(from: HandlePose, to: HandlePose) -> HandleWay {
        HandleWay { from: vec![from], to: vec![to], turns: vec![Turn { from: 0.0, to: 0.0, is_given: true }] }
    }

    fn x(poses: &[HandlePose]) -> f64 {
        poses[0].posed[0].x
    }

    #[test]
    fn a_handle_goes_up_to_the_limit() {
        let limit = fold_limit(&straight(point(0.0, 0.0), point(16.0, 0.0)), &mut |poses| x(poses) <= 10.0);
        assert!(x(&limit.poses) > 9.9 && x(&limit.poses) <= 10.0, "{limit:?}");
    }

    #[test]
    fn an_allowed_end_is_returned_as_given() {
        let end = point(1.0 / 3.0, 0.0);
        let limit = fold_limit(&straight(point(0.0, 0.0), end.clone()), &mut |_| true);
        assert_eq!(limit, FoldLimit { fraction: 1.0, poses: vec![end] });
    }

    #[test]
    fn a_handle_at_the_limit_stays() {
        let limit = fold_limit(&straight(point(10.0, 0.0), point(10.5, 0.0)), &mut |poses| x(poses) <= 10.0);
        assert_eq!(limit.poses, [point(10.0, 0.0)]);
    }

    #[test]
    fn a_group_stops_together() {
        let origins = [point(0.0, -8.0), point(0.0, 8.0)];
        let member =
            |(index, origin): (usize, &HandlePose)| GroupMember { index, origin: origin.clone(), rotation: 0.0 };
        let way = GroupWay {
            to: origins.to_vec(),
            members: origins.iter().enumerate().map(member).collect(),
            pivot: [0.0, 0.0].into(),
            transforms: [GroupTransform { turn: 0.0, scale: 1.0 }, GroupTransform { turn: 85.0, scale: 1.0 }],
            scales: [0.01, 100.0],
        };
        // The first moves right: it is stopped at 60°. The end is refused although its poses are those of the start.
        let mut is_end = true;
        let most = 8.0 * libm::sin(60_f64.to_radians());
        let limit = fold_limit(&way, &mut |poses| !std::mem::take(&mut is_end) && x(poses) <= most);
        let rotations = limit.poses.iter().map(|pose| match pose.rotation {
            Rotation::Degrees(degrees) => degrees,
            Rotation::Auto => f64::NAN,
        });
        assert!(rotations.into_iter().all(|degrees| (degrees - 60.0).abs() < 0.5), "{limit:?}");
    }
}
