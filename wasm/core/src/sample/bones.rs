//! Samples along bones: a bar that stays straight is drawn straight.

use glam::DVec2;

use super::lattice::CLEARANCE;
use crate::{domain::Domain, locate::ON_OUTLINE};

/// Samples along a bone are nearer to one another than those beside it to the bone: the circle over two of them is then empty,
/// and the edge between them is one of the Delaunay mesh.
const ALONG: f64 = 1.9 * CLEARANCE;
/// Samples of a bone keep this share of the spacing away from others, which are there already.
const APART: f64 = 0.3;

/// Adds samples evenly along each bone, both ends included. Returns those that lie on the outline, between its vertices: they are to divide
/// its edges.
pub(super) fn add_bones(vertices: &mut Vec<DVec2>, bones: &[[DVec2; 2]], spacing: f64, domain: &Domain) -> Vec<DVec2> {
    let mut on_outline: Vec<DVec2> = Vec::new();
    for &[a, b] in bones {
        let pieces = (a.distance(b) / (ALONG * spacing)).ceil().max(1.0);
        let along = (0..=pieces as u32).map(|i| a.lerp(b, f64::from(i) / pieces));
        let first = vertices.len();
        for p in along {
            let (others, own) = vertices.split_at(first);
            let is_near = |q: &DVec2| q.distance(p) < APART * spacing;
            // A bone shorter than the spacing keeps its first end alone.
            if !others.iter().chain(own).chain(&on_outline).any(is_near) {
                let is_within = domain.distance_to_outline(p) > ON_OUTLINE;
                if is_within { &mut *vertices } else { &mut on_outline }.push(p);
            }
        }
    }
    on_outline
}
