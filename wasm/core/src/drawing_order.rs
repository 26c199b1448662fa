//! The drawing order of triangles where a posed picture covers itself: from the farthest to the nearest.
//!
//! The depth of handles spreads as motions do: by harmonic shares to the virtual sites (eq. 4), by weights to the vertices
//! (eq. 1); a triangle has the mean of its corners' depths. Nearer triangles are drawn later; equally deep ones keep the
//! order of the mesh. `web/src/geometry/drawing_order.ts` does the same for the graphics card. A depth buffer would not do:
//! it keeps one triangle of a pixel, where soft edges need all of them.
//!
//! Cost: linear in the stored weights, and a sort of the triangles. The order depends on depths alone, not on where handles
//! are posed.
//!
//! Limits: triangles are not split where they intersect. Depths are rounded to [`DEPTH_STEPS`] depth steps, so that rounding
//! decides nothing where many triangles are equally deep.

use std::borrow::Cow;

use crate::{render_mesh::RenderMesh, weight::SparseWeights};

/// Depth steps from the farthest site to the nearest: an even number, so that no boundary between steps lies half way.
const DEPTH_STEPS: f64 = 1024.0;
/// Depths that differ by less than this share of the greatest are equal: rounding of 32 bits.
const SAME_DEPTH: f64 = 1e-6;

/// The mesh's triangles in drawing order, for the `depths` of the sites. A vertex without weights has depth 0.
pub(crate) fn drawn_triangles<'a>(
    mesh: &'a RenderMesh,
    weights: &SparseWeights,
    depths: &[f64],
) -> Cow<'a, [[u32; 3]]> {
    let unmoved = (0..mesh.vertices.len()).any(|vertex| weights.row(vertex).next().is_none());
    let all = || depths.iter().copied().chain(unmoved.then_some(0.0));
    let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), d| (low.min(d), high.max(d)));
    let range = high - low;
    // Without any sites the range is below 0.
    if range <= SAME_DEPTH * low.abs().max(high.abs()) {
        return Cow::Borrowed(&mesh.triangles);
    }
    let depth = |vertex: usize| {
        let deep =
            |sum: Option<f64>, (site, weight): (usize, f64)| Some(sum.unwrap_or(0.0) + weight * (depths[site] - low));
        weights.row(vertex).fold(None, deep).unwrap_or(-low)
    };
    let deep: Vec<f64> = (0..mesh.vertices.len()).map(depth).collect();
    let step = |corners: &[u32; 3]| {
        let sum: f64 = corners.iter().map(|&vertex| deep[vertex as usize]).sum();
        (sum / (3.0 * range) * DEPTH_STEPS).round() as u32
    };
    let mut triangles = mesh.triangles.clone();
    triangles.sort_by_cached_key(step);
    Cow::Owned(triangles)
}
