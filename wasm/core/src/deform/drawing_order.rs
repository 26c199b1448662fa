//! The drawing order of triangles where a posed picture covers itself: from the farthest to the nearest.
//!
//! The depth of handles spreads as motions do: by harmonic weights to the virtual sites (eq. 4), by weights to the
//! vertices (eq. 1). A triangle has the mean of its corners' depths. Nearer triangles are drawn later; equally deep
//! ones keep the order of the mesh. A depth buffer keeps one triangle of a pixel, but soft edges need all of them.
//!
//! Cost: linear in the stored weights, and a sort of the triangles. The order depends on depths alone, not on where
//! handles are posed.
//!
//! Limits: triangles are not split where they intersect. Depths are rounded to [`DEPTH_STEPS`] depth steps, so that
//! rounding decides nothing where many triangles are equally deep.

use std::borrow::Cow;

use crate::{pose::Motion, weight::SparseWeights};

/// Depth steps from the farthest site to the nearest. Even, so that no boundary between steps lies half way.
const DEPTH_STEPS: f64 = 1024.0;
/// Depths that differ by less than this fraction of the greatest are equal: rounding of 32 bits.
const SAME_DEPTH: f64 = 1e-6;

/// The depth of each site.
pub(crate) fn depths(motions: &[Motion]) -> Vec<f64> {
    motions.iter().map(|motion| motion.depth).collect()
}

/// The triangles in drawing order, for the `depths` of the sites. A vertex without weights has depth 0.
pub(crate) fn drawing_order<'a>(
    triangles: &'a [[u32; 3]],
    weights: &SparseWeights,
    depths: &[f64],
) -> Cow<'a, [[u32; 3]]> {
    let vertices = || 0..weights.len();
    let has_still_vertex = vertices().any(|vertex| weights.row(vertex).next().is_none());
    let all = || depths.iter().copied().chain(has_still_vertex.then_some(0.0));
    let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), d| (low.min(d), high.max(d)));
    let range = high - low;
    // Without any sites the range is below 0.
    if range <= SAME_DEPTH * low.abs().max(high.abs()) {
        return Cow::Borrowed(triangles);
    }
    let depth = |vertex: usize| {
        let add =
            |sum: Option<f64>, (site, weight): (usize, f64)| Some(sum.unwrap_or(0.0) + weight * (depths[site] - low));
        weights.row(vertex).fold(None, add).unwrap_or(-low)
    };
    let vertex_depths: Vec<f64> = vertices().map(depth).collect();
    let step = |corners: &[u32; 3]| {
        let sum: f64 = corners.iter().map(|&vertex| vertex_depths[vertex as usize]).sum();
        // Weights that are rounded may sum to a little more than 1.
        (sum / (3.0 * range) * DEPTH_STEPS).round().min(DEPTH_STEPS) as usize
    };
    Cow::Owned(sorted(triangles, step))
}

/// The triangles sorted by step, from 0 to [`DEPTH_STEPS`]. Equal steps keep their order. A counting sort: linear.
fn sorted(triangles: &[[u32; 3]], step: impl Fn(&[u32; 3]) -> usize) -> Vec<[u32; 3]> {
    let steps: Vec<usize> = triangles.iter().map(step).collect();
    let mut next = [0; DEPTH_STEPS as usize + 2];
    for &step in &steps {
        next[step + 1] += 1;
    }
    for step in 1..next.len() {
        next[step] += next[step - 1];
    }
    let mut sorted = triangles.to_vec();
    for (triangle, step) in triangles.iter().zip(steps) {
        sorted[next[step]] = *triangle;
        next[step] += 1;
    }
    sorted
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles of one site each, and one that nothing moves.
    const TRIANGLES: [[u32; 3]; 3] = [[0, 1, 2], [3, 4, 5], [6, 7, 8]];

    fn first_corners(depths: [f64; 2]) -> Vec<u32> {
        let mut weights = SparseWeights::with_capacity(9);
        for vertex in 0..9 {
            weights.push_row((vertex < 6).then_some((vertex / 3, 1.0)).into_iter());
        }
        drawing_order(&TRIANGLES, &weights, &depths).iter().map(|corners| corners[0]).collect()
    }

    #[test]
    fn nearer_triangles_are_drawn_later_and_still_ones_have_depth_0() {
        assert_eq!(first_corners([1.0, -1.0]), [3, 6, 0]);
        assert_eq!(first_corners([-2.0, -1.0]), [0, 3, 6]);
        assert_eq!(first_corners([3.0, 2.0]), [6, 3, 0]);
    }

    #[test]
    fn equal_depths_keep_the_order_of_the_mesh() {
        assert_eq!(first_corners([0.0, 0.0]), [0, 3, 6]);
        assert_eq!(first_corners([5.0, 5.0]), [6, 0, 3]);
        assert_eq!(first_corners([1e-9, 1e-9 * (1.0 + 1e-7)]), [6, 0, 3]);
    }
}
