//! Samples along bones: a bar that stays straight is drawn straight.

use glam::DVec2;

use super::lattice::CLEARANCE;

/// Samples along a bone are nearer to one another than those beside it to the bone: the circle over two of them is then empty,
/// and the edge between them is one of the Delaunay mesh.
const ALONG: f64 = 1.9 * CLEARANCE;
/// Samples of a bone keep this share of the spacing away from others, which are there already.
const APART: f64 = 0.3;

/// Adds samples evenly along each bone, both ends included.
pub(super) fn add_bones(vertices: &mut Vec<DVec2>, bones: &[[DVec2; 2]], spacing: f64) {
    for &[a, b] in bones {
        let pieces = (a.distance(b) / (ALONG * spacing)).ceil().max(1.0);
        let along = (0..=pieces as u32).map(|i| a.lerp(b, f64::from(i) / pieces));
        let first = vertices.len();
        for p in along {
            let (others, own) = vertices.split_at(first);
            let is_near = |q: &DVec2| q.distance(p) < APART * spacing;
            // A bone shorter than the spacing keeps its first end alone.
            if !others.iter().chain(own).any(is_near) {
                vertices.push(p);
            }
        }
    }
}
