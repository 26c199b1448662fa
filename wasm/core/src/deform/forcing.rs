//! The handles that force creases: without them, the picture would not fold there.
//!
//! Candidates are the handles with the greatest influence on the triangles of a crease. Each of them is released
//! separately: it then follows the others, see [`free_pose`](super::free_pose). A handle forces a crease if its release
//! flattens much of the crease. If no single release flattens it, all candidates force it together.
//!
//! Except for rounding, the result does not depend on the order of handles, nor on a common motion of all of them.
//!
//! Cost: a pose for each of at most [`MOST_RELEASED`] handles, and a pass over the triangles of the creases.

use glam::DVec2;

use super::{
    creases::Crease,
    triangle::{corners, doubled_area},
};
use crate::rank::{descending, sort_by_rank};

/// Candidates of a crease.
const CANDIDATES: usize = 6;
/// The least influence of a candidate, as a share of the greatest one.
const LEAST_INFLUENCE: f64 = 0.1;
/// Influences with a smaller relative difference are tied.
const TIE: f64 = 1e-9;
/// Maximum number of released handles, those of the largest creases first.
pub(super) const MOST_RELEASED: usize = 10;
/// A handle relieves a crease if its release unfolds at least this share of the crease's area.
const LEAST_RELIEF: f64 = 0.25;
/// Of the handles that relieve a crease, only those count that achieve this share of the best result.
const NEAR_BEST: f64 = 0.5;

/// The handles that force some creases, from the one that forces most of the area.
///
/// `influences` has for each crease the influence of each handle. `released` poses the vertices without a handle; it
/// returns `None` if that pose does not exist.
pub(super) fn forcing(
    creases: &[Crease],
    influences: &[Vec<f64>],
    mut released: impl FnMut(usize) -> Option<Vec<DVec2>>,
) -> Vec<usize> {
    let all: Vec<Vec<usize>> = influences.iter().map(|influence| candidates(influence)).collect();
    let mut tested: Vec<usize> = Vec::new();
    for &handle in all.iter().flatten() {
        if tested.len() < MOST_RELEASED && !tested.contains(&handle) {
            tested.push(handle);
        }
    }
    let reliefs: Vec<Vec<f64>> = tested
        .iter()
        .map(|&handle| match released(handle) {
            Some(posed) => creases.iter().map(|crease| relief(crease, &posed)).collect(),
            None => vec![0.0; creases.len()],
        })
        .collect();
    let mut shares: Vec<(f64, usize)> = Vec::new();
    for (index, crease) in creases.iter().enumerate() {
        let of_crease: Vec<(f64, usize)> = tested
            .iter()
            .zip(&reliefs)
            .filter(|&(handle, _)| all[index].contains(handle))
            .map(|(&handle, reliefs)| (reliefs[index], handle))
            .collect();
        let best = of_crease.iter().map(|&(relief, _)| relief).fold(0.0, f64::max);
        let least = if best < LEAST_RELIEF { f64::NEG_INFINITY } else { best * NEAR_BEST };
        for (relief, handle) in of_crease.into_iter().filter(|&(relief, _)| relief >= least) {
            let area = relief.max(0.0) * crease.area;
            match shares.iter_mut().find(|(_, known)| *known == handle) {
                Some((sum, _)) => *sum += area,
                None => shares.push((area, handle)),
            }
        }
    }
    sort_by_rank(&mut shares, |&(share, handle)| [descending(share), handle as i64]);
    shares.into_iter().map(|(_, handle)| handle).collect()
}

/// The handles with the greatest influences. Tied handles are candidates together.
fn candidates(influence: &[f64]) -> Vec<usize> {
    let mut handles: Vec<usize> = (0..influence.len()).filter(|&handle| influence[handle] > 0.0).collect();
    sort_by_rank(&mut handles, |&handle| [descending(influence[handle]), handle as i64]);
    let of = |rank: usize| handles.get(rank).map_or(0.0, |&handle| influence[handle]);
    let least = of(CANDIDATES - 1).max(LEAST_INFLUENCE * of(0)) * (1.0 - TIE);
    handles.retain(|&handle| influence[handle] >= least);
    handles
}

/// The share of a crease's area that a pose does not flip.
fn relief(crease: &Crease, posed: &[DVec2]) -> f64 {
    let folded = crease.triangles.iter().map(|&triangle| (-doubled_area(corners(posed, triangle))).max(0.0) / 2.0);
    1.0 - folded.sum::<f64>() / crease.area
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deform::creases::creases;

    #[test]
    fn candidates_are_those_of_great_influence_with_ties() {
        assert_eq!(candidates(&[0.1, 5.0, 0.0, 4.0]), [1, 3]);
        assert_eq!(candidates(&[1.0; 9]), (0..9).collect::<Vec<_>>());
        assert_eq!(candidates(&[9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0]), [0, 1, 2, 3, 4, 5]);
        assert!(candidates(&[0.0]).is_empty());
    }

    /// A triangle with 8 square pixels turned over, and its place without each of two handles.
    fn forced(without: [f64; 2]) -> Vec<usize> {
        let triangle = |width: f64| vec![DVec2::ZERO, DVec2::new(0.0, 4.0), DVec2::new(width, 0.0)];
        let folds = creases(&triangle(4.0), &[[0, 1, 2]]);
        forcing(&folds, &[vec![1.0, 1.0]], |handle| Some(triangle(without[handle])))
    }

    #[test]
    fn handles_that_relieve_a_crease_force_it() {
        assert_eq!(forced([-4.0, 4.0]), [0]);
        assert_eq!(forced([4.0, 0.0]), [1]);
        assert_eq!(forced([0.0, 1.0]), [0, 1]);
        assert_eq!(forced([1.0, 0.0]), [1, 0]);
    }

    #[test]
    fn handles_that_relieve_nothing_alone_force_it_together() {
        assert_eq!(forced([4.0, 4.0]), [0, 1]);
        assert_eq!(forced([3.9, 4.5]), [0, 1]);
    }

    #[test]
    fn invalid_poses_relieve_no_crease() {
        let folds = creases(&[DVec2::ZERO, DVec2::new(0.0, 4.0), DVec2::new(4.0, 0.0)], &[[0, 1, 2]]);
        assert_eq!(forcing(&folds, &[vec![1.0]], |_| None), [0]);
        assert!(forcing(&[], &[], |_| None).is_empty());
    }
}
