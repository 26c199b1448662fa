//! Insertion of a vertex into a constrained Delaunay triangulation (Lawson 1977).
//!
//! The triangle around the vertex is split. Then edges are flipped until the circumcircle of each triangle is empty
//! again. The predicates are exact (Shewchuk 1997), so flipping terminates. Edges with a triangle on only one side
//! bound the region and are never flipped.
//!
//! Cost: the walk from a nearby triangle, and about six flips. If the walk ends at the border of the region, a few more
//! triangles, or all triangles if a detour is long.

use glam::DVec2;
use robust::{Coord, incircle, orient2d};

use super::{
    locate::{OUTLINE_TOLERANCE, signed_depth, signed_distance},
    mesh::{NONE, Triangulation},
};

/// Number of triangles that are searched where a walk ends at the border of the region, before searching all.
const AROUND: usize = 100;

/// The result of an insertion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Inserted {
    /// An existing vertex coincides with the point.
    Known(u32),
    /// A new vertex inside the region.
    Within(u32),
    /// A new vertex on a boundary edge, which it splits.
    OnBoundary {
        /// The new vertex.
        vertex: u32,
        /// The ends of the edge.
        between: [u32; 2],
    },
}

impl Inserted {
    pub(crate) fn vertex(self) -> u32 {
        match self {
            Self::Known(vertex) | Self::Within(vertex) | Self::OnBoundary { vertex, .. } => vertex,
        }
    }
}

impl Triangulation {
    /// Inserts a vertex at a point of the region, within [`OUTLINE_TOLERANCE`]. A vertex that close to a boundary
    /// edge is placed on it.
    ///
    /// `near` is a triangle near the point.
    pub(crate) fn insert(&mut self, near: usize, p: DVec2) -> Inserted {
        let t = self.triangle_at(near, p);
        let corners = self.triangles[t];
        let distance = |v: &u32| self.vertices[*v as usize].distance(p);
        let nearest = corners.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let nearest = nearest.expect("a triangle has corners");
        if distance(&nearest) <= OUTLINE_TOLERANCE {
            return Inserted::Known(nearest);
        }
        for k in 0..3 {
            let [a, b] = [corners[k], corners[(k + 1) % 3]].map(|v| self.vertices[v as usize]);
            let along = b - a;
            if self.neighbours[t][k] == NONE && along.perp_dot(p - a) <= OUTLINE_TOLERANCE * along.length() {
                let at = a + along * ((p - a).dot(along) / along.length_squared());
                let between = [corners[k], corners[(k + 1) % 3]];
                return Inserted::OnBoundary { vertex: self.split_edge(t, k, at), between };
            }
        }
        let sides = [0, 1, 2].map(|k| self.side(corners[k], corners[(k + 1) % 3], p));
        match (sides.iter().position(|&side| side == 0.0), sides.iter().any(|&side| side < 0.0)) {
            // Rounding puts the point outside the region, at a corner.
            (_, true) => Inserted::Known(nearest),
            (Some(k), _) => Inserted::Within(self.split_edge(t, k, p)),
            (None, _) => Inserted::Within(self.split_triangle(t, p)),
        }
    }

    /// The triangle that contains a point, or the nearest triangle if the point is outside the region.
    ///
    /// `near` is a triangle near the point.
    pub(crate) fn triangle_at(&self, near: usize, p: DVec2) -> usize {
        let depths = || (0..self.triangles.len()).map(|t| (signed_distance(self.corners(t), p), t));
        let deepest = || depths().reduce(|best, at| if at.0 > best.0 { at } else { best }).map(|(_, t)| t);
        self.walk(near, p).or_else(|| self.triangle_around(near, p)).or_else(deepest).unwrap_or(near)
    }

    /// The triangle that clearly contains a point, if it is one of the [`AROUND`] triangles next to `near`.
    fn triangle_around(&self, near: usize, p: DVec2) -> Option<usize> {
        let mut known = vec![near as u32];
        let mut at = 0;
        while let Some(&t) = known.get(at) {
            if signed_depth(self.corners(t as usize), p) > OUTLINE_TOLERANCE {
                return Some(t as usize);
            }
            for beside in self.neighbours[t as usize] {
                if known.len() < AROUND && beside != NONE && !known.contains(&beside) {
                    known.push(beside);
                }
            }
            at += 1;
        }
        None
    }

    /// The triangle that contains a point, found from triangle to triangle. `None` if the walk gets stuck, because the
    /// region need not be convex.
    pub(crate) fn walk(&self, near: usize, p: DVec2) -> Option<usize> {
        let mut t = near;
        // In a Delaunay triangulation the walk visits no triangle twice.
        for _ in 0..self.triangles.len() {
            let ([a, b, c], neighbours) = (self.triangles[t], self.neighbours[t]);
            let beyond = [(a, b), (b, c), (c, a)].map(|(from, to)| self.side(from, to, p) < 0.0);
            if !beyond.contains(&true) {
                return Some(t);
            }
            let Some(k) = (0..3).find(|&k| beyond[k] && neighbours[k] != NONE) else {
                return (signed_distance(self.corners(t), p) >= -OUTLINE_TOLERANCE).then_some(t);
            };
            t = neighbours[k] as usize;
        }
        None
    }

    /// Positive for a point on the inner side of the edge between two vertices.
    fn side(&self, a: u32, b: u32, p: DVec2) -> f64 {
        orient2d(self.coordinates(a), self.coordinates(b), Coord { x: p.x, y: p.y })
    }

    fn coordinates(&self, v: u32) -> Coord<f64> {
        let DVec2 { x, y } = self.vertices[v as usize];
        Coord { x, y }
    }

    fn split_triangle(&mut self, t: usize, p: DVec2) -> u32 {
        let [[a, b, c], [ab, bc, ca]] = [self.triangles[t], self.neighbours[t]];
        let v = self.push_vertex(p);
        let (t, t1, t2) = (t as u32, self.triangles.len() as u32, self.triangles.len() as u32 + 1);
        self.set(t, [a, b, v], [ab, t1, t2]);
        self.set(t1, [b, c, v], [bc, t2, t]);
        self.set(t2, [c, a, v], [ca, t, t1]);
        self.replace_neighbour(bc, t, t1);
        self.replace_neighbour(ca, t, t2);
        self.restore_delaunay(vec![t, t1, t2]);
        v
    }

    /// Splits edge `k` of a triangle, and with it the triangles on both sides.
    fn split_edge(&mut self, t: usize, k: usize, p: DVec2) -> u32 {
        let [a, b, c] = [k, k + 1, k + 2].map(|k| self.triangles[t][k % 3]);
        let [u, bc, ca] = [k, k + 1, k + 2].map(|k| self.neighbours[t][k % 3]);
        let v = self.push_vertex(p);
        let (t, t1, u1) = (t as u32, self.triangles.len() as u32, self.triangles.len() as u32 + 1);
        self.replace_neighbour(ca, t, t1);
        if u == NONE {
            self.set(t, [b, c, v], [bc, t1, NONE]);
            self.set(t1, [c, a, v], [ca, NONE, t]);
            self.restore_delaunay(vec![t, t1]);
            return v;
        }
        let l = self.edge_towards(u, t);
        let d = self.triangles[u as usize][(l + 2) % 3];
        let [ad, db] = [l + 1, l + 2].map(|l| self.neighbours[u as usize][l % 3]);
        self.set(t, [b, c, v], [bc, t1, u1]);
        self.set(t1, [c, a, v], [ca, u, t]);
        self.set(u, [a, d, v], [ad, u1, t1]);
        self.set(u1, [d, b, v], [db, t, u]);
        self.replace_neighbour(db, u, u1);
        self.restore_delaunay(vec![t, t1, u, u1]);
        v
    }

    /// Flips edges until all circumcircles are empty.
    ///
    /// Triangles on the stack have the new vertex as their last corner. Their first edge may need a flip.
    fn restore_delaunay(&mut self, mut stack: Vec<u32>) {
        while let Some(t) = stack.pop() {
            let ([a, b, v], [u, bv, va]) = (self.triangles[t as usize], self.neighbours[t as usize]);
            if u == NONE {
                continue;
            }
            let l = self.edge_towards(u, t);
            let d = self.triangles[u as usize][(l + 2) % 3];
            let [pa, pb, pv, pd] = [a, b, v, d].map(|v| self.coordinates(v));
            // Rounding may put a vertex on the outline slightly outside. No flip may invert a triangle.
            let convex = orient2d(pa, pd, pv) > 0.0 && orient2d(pd, pb, pv) > 0.0;
            if incircle(pa, pb, pv, pd) <= 0.0 || !convex {
                continue;
            }
            let [ad, db] = [l + 1, l + 2].map(|l| self.neighbours[u as usize][l % 3]);
            self.set(t, [a, d, v], [ad, u, va]);
            self.set(u, [d, b, v], [db, bv, t]);
            self.replace_neighbour(ad, u, t);
            self.replace_neighbour(bv, t, u);
            stack.extend([t, u]);
        }
    }

    fn push_vertex(&mut self, p: DVec2) -> u32 {
        self.vertices.push(p);
        self.vertices.len() as u32 - 1
    }

    /// Sets a triangle. A new one must have the next index.
    fn set(&mut self, t: u32, corners: [u32; 3], neighbours: [u32; 3]) {
        if t as usize == self.triangles.len() {
            self.triangles.push(corners);
            self.neighbours.push(neighbours);
        } else {
            (self.triangles[t as usize], self.neighbours[t as usize]) = (corners, neighbours);
        }
    }

    /// Replaces a neighbour of triangle `t` by another. Does nothing if `t` is [`NONE`].
    fn replace_neighbour(&mut self, t: u32, from: u32, to: u32) {
        if t != NONE {
            let k = self.edge_towards(t, from);
            self.neighbours[t as usize][k] = to;
        }
    }

    fn edge_towards(&self, t: u32, neighbour: u32) -> usize {
        let known = self.neighbours[t as usize].iter().position(|&n| n == neighbour);
        known.expect("neighbours know each other")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of 10 px with a square hole of 2 px in its middle.
    fn ring() -> Triangulation {
        let ring = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from);
        let vertices: Vec<DVec2> = ring(0.0, 10.0).into_iter().chain(ring(4.0, 6.0)).collect();
        let segments = (0..8).map(|i| [i, i / 4 * 4 + (i + 1) % 4]).collect();
        Triangulation::constrained_delaunay(vertices, segments)
    }

    fn check(mesh: &Triangulation, area: f64) {
        let mut sum = 0.0;
        for t in 0..mesh.triangles.len() {
            let [a, b, c] = mesh.corners(t);
            assert!((b - a).perp_dot(c - a) > 0.0);
            sum += (b - a).perp_dot(c - a) / 2.0;
            for k in 0..3 {
                let n = mesh.neighbours[t][k];
                if n == NONE {
                    continue;
                }
                let l = mesh.edge_towards(n, t as u32);
                let other = mesh.triangles[n as usize];
                assert_eq!([other[(l + 1) % 3], other[l]], [mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]]);
                let [a, b, c] = mesh.triangles[t].map(|v| mesh.coordinates(v));
                assert!(incircle(a, b, c, mesh.coordinates(other[(l + 2) % 3])) <= 0.0, "triangles {t} and {n}");
            }
        }
        assert!((sum - area).abs() < 1e-9, "{sum}");
    }

    #[test]
    fn stays_delaunay_after_every_insertion() {
        let mut mesh = ring();
        // A lattice has cocircular vertices, and vertices on edges.
        for i in 0..121 {
            let p = DVec2::new(f64::from(i % 11), f64::from(i / 11));
            if p.distance(DVec2::splat(5.0)) < 0.5 {
                continue;
            }
            mesh.insert(0, p);
            check(&mesh, 96.0);
        }
        assert_eq!(mesh.vertices.len(), 120);
    }

    #[test]
    fn walks_around_a_hole_end_in_the_triangle_that_contains_the_point() {
        let mut mesh = ring();
        let steps = || (0..400).map(|i| DVec2::new(f64::from(i % 20), f64::from(i / 20)) * 0.5 + 0.13);
        let is_inside = |p: &DVec2| (*p - 5.0).abs().max_element() > 1.01;
        steps().filter(is_inside).for_each(|p| _ = mesh.insert(0, p));
        let mut stuck = 0;
        for p in steps().map(|p| p + DVec2::new(0.11, 0.07)).filter(is_inside) {
            let deepest = (0..mesh.triangles.len()).find(|&t| signed_depth(mesh.corners(t), p) > 0.0);
            for near in (0..mesh.triangles.len()).step_by(7) {
                stuck += usize::from(mesh.walk(near, p).is_none());
                assert_eq!(Some(mesh.triangle_at(near, p)), deepest, "{p} from triangle {near}");
            }
        }
        assert!(stuck > 1000, "{stuck}");
    }

    #[test]
    fn vertex_on_the_boundary_splits_its_edge() {
        let mut mesh = ring();
        let inserted = mesh.insert(3, DVec2::new(3.0, -5e-7));
        let Inserted::OnBoundary { vertex, mut between } = inserted else { panic!("{inserted:?}") };
        between.sort_unstable();
        assert_eq!((vertex, between), (8, [0, 1]));
        check(&mesh, 96.0);
        assert_eq!(mesh.insert(0, DVec2::new(3.0, 5e-7)), Inserted::Known(8));
    }

    #[test]
    fn close_vertices_stay_distinct() {
        let mut mesh = ring();
        for i in 0..40 {
            let turn = f64::from(i);
            mesh.insert(1, DVec2::new(2.0 + 1e-5 * turn, 2.0 + 1e-7 * turn * turn));
        }
        assert_eq!(mesh.vertices.len(), 48);
        check(&mesh, 96.0);
    }
}
