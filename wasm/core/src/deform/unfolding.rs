//! Unfolding: the handles that force folds, and the nearest pose without folds.
//!
//! The nearest pose is the farthest one without folds on a way to the present pose. The way begins at the first of
//! these poses without folds: the handles that force folds at their last pose without folds, at rest, or following the
//! others. Then come all handles at their last pose without folds, or at rest.
//!
//! Cost: at most about 30 poses with a pass over all triangles each, independent of the number of handles.

use glam::DVec2;

use super::{
    creases::Crease,
    fold_guard::fold_limit,
    forcing::forcing,
    free_pose::free_pose,
    handle_pose::HandlePose,
    posed_picture::PosedPicture,
    way::{HandleWay, Turn, Way},
};
use crate::{
    bone::best_rotation,
    error::Error,
    project::{Blend, Handle, Rotation},
    rank::sort_by_rank,
};

/// The nearest pose without visible creases.
#[derive(Debug, Clone, PartialEq)]
pub struct Unfolded {
    /// The poses of all handles.
    pub poses: Vec<HandlePose>,
    /// The fraction of the way to the given pose: 1 is the given pose itself.
    pub fraction: f64,
    /// The handles that may have moved, ascending.
    pub moved: Vec<usize>,
}

impl PosedPicture {
    /// The handles that force the visible creases of a pose, from the one that forces most of their area. Empty if
    /// there are no creases. `poses` are those of the solved handles, in order; additional ones are ignored.
    ///
    /// # Errors
    /// Those of [`set_pose`](Self::set_pose).
    pub fn forcing_handles(&self, poses: &[HandlePose], blend: Blend) -> Result<Vec<usize>, Error> {
        let handles = self.posed_handles(poses)?;
        let creases = self.creases_of(&self.blended(&handles, blend)?);
        Ok(self.forcing(&handles, &creases, blend))
    }

    fn forcing(&self, handles: &[Handle], creases: &[Crease], blend: Blend) -> Vec<usize> {
        let influences: Vec<Vec<f64>> = creases.iter().map(|crease| self.influences(crease)).collect();
        forcing(creases, &influences, |handle| {
            let mut released = handles.to_vec();
            free_pose(handles, handle, |_| true)?.write_to(&mut released[handle]);
            self.blended(&released, blend).ok()
        })
    }

    /// For each handle, the sum of its weights at the corners of a crease, including those of virtual sites.
    fn influences(&self, crease: &Crease) -> Vec<f64> {
        let (kinds, passed) = (self.poser.kinds(), self.poser.harmonic());
        let mut of_sites = vec![0.0; kinds.len()];
        for &vertex in crease.triangles.iter().flatten() {
            for (site, weight) in self.mesh.weights.row(vertex as usize) {
                of_sites[site] += weight;
            }
        }
        let mut influences = vec![0.0; self.handles.len()];
        for (site, weight) in of_sites.into_iter().enumerate().filter(|&(_, weight)| weight > 0.0) {
            if let Some(handle) = kinds[site].handle() {
                influences[handle] += weight;
            } else {
                for &(real, share) in &passed[site] {
                    if let Some(handle) = kinds[real as usize].handle() {
                        influences[handle] += weight * share;
                    }
                }
            }
        }
        influences
    }

    fn blended(&self, handles: &[Handle], blend: Blend) -> Result<Vec<DVec2>, Error> {
        Ok(self.blend_vertices(&self.poser.pose(handles, blend)?))
    }

    /// The nearest pose without visible creases: the given one if it has none; `None` if every way from rest begins
    /// with creases. `last` is an earlier pose without. Both `poses` and `last` may contain additional poses after
    /// those of the solved handles; these do not change.
    ///
    /// # Errors
    /// Those of [`set_pose`](Self::set_pose).
    pub fn unfolded(
        &self,
        poses: &[HandlePose],
        last: Option<&[HandlePose]>,
        blend: Blend,
    ) -> Result<Option<Unfolded>, Error> {
        let handles = self.posed_handles(poses)?;
        let creases = self.creases_of(&self.blended(&handles, blend)?);
        if creases.is_empty() {
            return Ok(Some(Unfolded { poses: poses.to_vec(), fraction: 1.0, moved: Vec::new() }));
        }
        let all: Vec<usize> = (0..handles.len()).collect();
        let forcing = self.forcing(&handles, &creases, blend);
        let before = |k: usize| last.and_then(|last| last.get(k)).cloned();
        let rest = |k: usize| Some(at_rest(&handles[k]));
        let free = |k: usize| free_pose(&handles, k, |other| !forcing.contains(&other));
        let starts: [(&[usize], Start<'_>); 5] =
            [(&forcing, &before), (&forcing, &rest), (&forcing, &free), (&all, &before), (&all, &rest)];
        let mut is_allowed = |poses: &[HandlePose]| self.fold_count_of(poses, blend).is_ok_and(|count| count == 0);
        for (movers, start) in starts {
            let Some(way) = way(&handles, poses, movers, start) else { continue };
            if is_allowed(&way.at(0.0)) {
                let limit = fold_limit(&way, &mut is_allowed);
                let mut moved = movers.to_vec();
                sort_by_rank(&mut moved, |&handle| [handle as i64, 0]);
                return Ok(Some(Unfolded { poses: limit.poses, fraction: limit.fraction, moved }));
            }
        }
        Ok(None)
    }
}

/// The pose in which a handle begins its way, if it has one.
type Start<'a> = &'a dyn Fn(usize) -> Option<HandlePose>;

/// The way of some handles from a start to their present poses. `None` if one of them has no start.
fn way(handles: &[Handle], poses: &[HandlePose], movers: &[usize], start: Start<'_>) -> Option<HandleWay> {
    let mut from = poses.to_vec();
    for &k in movers {
        from[k] = start(k).filter(|start| start.posed.len() == poses[k].posed.len())?;
    }
    let turns = from.iter().zip(poses).enumerate().map(|(k, (from, to))| match handles.get(k) {
        Some(handle) => turn(handle.shape.rest(), from, to),
        None => Turn { from: 0.0, to: 0.0, is_given: false },
    });
    let turns = turns.collect();
    Some(HandleWay { from, to: poses.to_vec(), turns })
}

/// The pose at rest. An automatic rotation stays automatic.
fn at_rest(handle: &Handle) -> HandlePose {
    let rotation = match handle.rotation {
        Rotation::Auto => Rotation::Auto,
        Rotation::Degrees(_) => Rotation::Degrees(0.0),
    };
    HandlePose { posed: handle.shape.rest().to_vec(), rotation, scale: 1.0, depth: handle.depth }
}

/// The turn of a handle between two poses. For a bar or polygon, it follows from the corners, up to whole turns.
fn turn(rest: &[DVec2], from: &HandlePose, to: &HandlePose) -> Turn {
    let given = |pose: &HandlePose| match pose.rotation {
        Rotation::Degrees(degrees) => Some(degrees),
        Rotation::Auto => None,
    };
    let is_given = given(to).is_some();
    if !to.is_line() {
        let end = given(to).or(given(from)).unwrap_or_default();
        return Turn { from: given(from).unwrap_or(end), to: end, is_given };
    }
    let turn_to = |pose: &HandlePose| best_rotation(rest, &pose.posed).to_degrees();
    let end = nearest_turn(turn_to(to), given(to).unwrap_or_default());
    let start = nearest_turn(turn_to(from), given(from).filter(|_| is_given).unwrap_or(end));
    Turn { from: start, to: end, is_given }
}

/// A turn plus the whole turns that bring it nearest to another turn.
fn nearest_turn(turn: f64, near: f64) -> f64 {
    turn + 360.0 * libm::round((near - turn) / 360.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bar(posed: [[f64; 2]; 2], rotation: impl Into<Rotation>) -> HandlePose {
        HandlePose { posed: posed.map(DVec2::from).to_vec(), rotation: rotation.into(), scale: 1.0, depth: 0.0 }
    }

    #[test]
    fn a_bar_takes_the_short_way_unless_it_has_whole_turns() {
        let rest = [[0.0, 0.0], [10.0, 0.0]].map(DVec2::from);
        let leaning = |y: f64, rotation: Rotation| bar([[10.0, 0.0], [0.0, y]], rotation);
        let way = |from: Rotation, to: Rotation| turn(&rest, &leaning(1.0, from), &leaning(-1.0, to));
        let Turn { from, to, is_given } = way(Rotation::Auto, Rotation::Auto);
        assert!((to - from).abs() < 12.0 && !is_given, "{from} to {to}");
        let Turn { from, to, is_given } = way(Rotation::Degrees(170.0), Rotation::Degrees(-170.0));
        assert!((from - to - 348.6).abs() < 0.1 && is_given, "{from} to {to}");
    }

    #[test]
    fn a_handle_at_rest_keeps_its_depth_and_an_automatic_rotation() {
        let posed = Handle::point("a", [1.0, 2.0]).posed_at([[5.0, 5.0]]).scaled(2.0).at_depth(3.0);
        let rest = at_rest(&posed.clone().turned(Rotation::Auto));
        assert_eq!(
            (rest.posed, rest.rotation, rest.scale, rest.depth),
            (vec![[1.0, 2.0].into()], Rotation::Auto, 1.0, 3.0)
        );
        assert_eq!(at_rest(&posed.turned(90.0)).rotation, Rotation::Degrees(0.0));
    }
}
