//! Geodesic distances in a polygon by the visibility graph of its reflex corners.
//!
//! The code is slow and simple, and shares nothing with the solver.

use glam::DVec2;

/// A polygon with holes and the visibility graph of its reflex corners.
pub struct VisibilityGraph {
    edges: Vec<(DVec2, DVec2)>,
    corners: Vec<DVec2>,
    links: Vec<Vec<(usize, f64)>>,
}

/// A point of the polygon and its visible corners with their distances.
pub struct Viewpoint {
    /// The position in pixels.
    pub at: DVec2,
    corners: Vec<(usize, f64)>,
}

/// Tolerance for points on a line or edge, in pixels.
const TOLERANCE: f64 = 1e-9;

impl VisibilityGraph {
    /// Builds the graph. Outer rings have a positive area, holes a negative one.
    #[must_use]
    pub fn new(rings: &[Vec<DVec2>]) -> Self {
        let (mut edges, mut corners) = (Vec::new(), Vec::new());
        for ring in rings {
            let n = ring.len();
            for i in 0..n {
                let (before, at, after) = (ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
                edges.push((at, after));
                if (at - before).perp_dot(after - at) < 0.0 {
                    corners.push(at);
                }
            }
        }
        let mut graph = Self { edges, corners, links: Vec::new() };
        graph.links = graph.corners.iter().map(|&corner| graph.visible_corners(corner)).collect();
        graph
    }

    /// Returns whether `p` is inside the polygon.
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        let crossings = self
            .edges
            .iter()
            .filter(|(a, b)| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x));
        crossings.count() % 2 == 1
    }

    /// Returns `p` with its visible corners.
    #[must_use]
    pub fn viewpoint(&self, p: DVec2) -> Viewpoint {
        Viewpoint { at: p, corners: self.visible_corners(p) }
    }

    /// Returns the distances from one point to others, in pixels. A distance is infinite if no path exists.
    #[must_use]
    pub fn distances(&self, from: DVec2, to: &[Viewpoint]) -> Vec<f64> {
        let mut distance = vec![f64::INFINITY; self.corners.len()];
        let mut open: Vec<(usize, f64)> = self.visible_corners(from);
        while let Some(least) = (0..open.len()).min_by(|&i, &j| open[i].1.total_cmp(&open[j].1)) {
            let (corner, d) = open.swap_remove(least);
            if d < distance[corner] {
                distance[corner] = d;
                let next = self.links[corner].iter().map(|&(next, length)| (next, d + length));
                open.extend(next.filter(|&(next, d)| d < distance[next]));
            }
        }
        let through = |to: &Viewpoint| {
            let corners = to.corners.iter().map(|&(corner, length)| distance[corner] + length);
            let straight = if self.sees(from, to.at) { from.distance(to.at) } else { f64::INFINITY };
            corners.fold(straight, f64::min)
        };
        to.iter().map(through).collect()
    }

    fn visible_corners(&self, p: DVec2) -> Vec<(usize, f64)> {
        let seen = self.corners.iter().enumerate().filter(|&(_, &corner)| corner != p && self.sees(p, corner));
        seen.map(|(i, &corner)| (i, p.distance(corner))).collect()
    }

    /// Returns whether the segment between two points stays in the closed polygon.
    fn sees(&self, p: DVec2, q: DVec2) -> bool {
        let along = q - p;
        let length = along.length();
        let mut stops = vec![0.0, 1.0];
        for &(a, b) in &self.edges {
            let (side_a, side_b) = (along.perp_dot(a - p) / length, along.perp_dot(b - p) / length);
            let edge = (b - a).normalize();
            let (side_p, side_q) = (edge.perp_dot(p - a), edge.perp_dot(q - a));
            let apart = |s: f64, t: f64| (s > TOLERANCE && t < -TOLERANCE) || (s < -TOLERANCE && t > TOLERANCE);
            if apart(side_a, side_b) && apart(side_p, side_q) {
                return false;
            }
            if side_a.abs() <= TOLERANCE {
                stops.push((a - p).dot(along) / (length * length));
            }
        }
        // The segment may touch corners. Each part between them must be inside or on an edge.
        stops.retain(|t| (0.0..=1.0).contains(t));
        stops.sort_by(f64::total_cmp);
        stops.windows(2).filter(|pair| (pair[1] - pair[0]) * length > 4.0 * TOLERANCE).all(|pair| {
            let middle = p + along * (pair[0] + pair[1]) / 2.0;
            self.contains(middle) || self.is_on_edge(middle)
        })
    }

    fn is_on_edge(&self, p: DVec2) -> bool {
        self.edges.iter().any(|&(a, b)| {
            let along = b - a;
            let t = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            p.distance(a + along * t) <= 2.0 * TOLERANCE
        })
    }
}
