//! The triangle of the navigation mesh that contains each node of a lattice.
//!
//! A row of nodes crosses a triangle in one run. Nodes at its ends are located one by one, because they may lie on an
//! edge.
//!
//! Cost: O(n) for n nodes, plus a search of the rows for each navigation triangle, and a step for each row that it
//! crosses.

use glam::DVec2;

use super::nodes::Nodes;
use crate::{
    distance::{NavTriangle, Navigation},
    triangulation::NONE,
};

/// Nodes this close to an edge, in pixels, are located one by one. This is far above rounding errors.
const MARGIN: f64 = 1e-6;

/// The navigation triangle of each node. Numbers without a node have arbitrary values.
///
/// # Panics
/// If a node is outside the domain.
pub(super) fn nav_triangles(nodes: &Nodes, navigation: &Navigation) -> Vec<NavTriangle> {
    let mut found = vec![NavTriangle(NONE); nodes.numbers()];
    for (triangle, corners) in navigation.triangles() {
        let low = corners.iter().fold(f64::INFINITY, |low, p| low.min(p.y));
        let high = corners.iter().fold(f64::NEG_INFINITY, |high, p| high.max(p.y));
        nodes.visit_spans(low, high, |y| span(corners, y), |numbers| found[numbers].fill(triangle));
    }
    for (number, p) in nodes.positions() {
        if found[number].0 == NONE {
            found[number] = navigation.triangle_at(p).expect("nodes lie in the domain");
        }
    }
    found
}

/// The range of x in which a horizontal line lies inside a triangle, clear of its edges.
fn span(corners: [DVec2; 3], y: f64) -> Option<[f64; 2]> {
    let mut span = [f64::NEG_INFINITY, f64::INFINITY];
    for k in 0..3 {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let along = b - a;
        // Depth inside the edge: (along × (p − a)) / |along| ≥ MARGIN.
        let margin = MARGIN * along.length();
        let offset = along.x * (y - a.y) - margin;
        // along.y · (x − a.x) ≤ offset
        if along.y > 0.0 {
            span[1] = span[1].min(a.x + offset / along.y);
        } else if along.y < 0.0 {
            span[0] = span[0].max(a.x + offset / along.y);
        } else if offset < 0.0 {
            return None;
        }
    }
    (span[0] < span[1]).then_some(span)
}
