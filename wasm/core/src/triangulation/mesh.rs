//! A triangle mesh as flat arrays.

use glam::DVec2;

/// "No triangle" in [`Triangulation::neighbours`].
pub(crate) const NONE: u32 = u32::MAX;

/// Four points count as cocircular if opposite angles add up to π within this sine. This exceeds rounding errors.
const COCIRCULAR_SINE: f64 = 1e-9;

/// A triangle mesh. Every triangle has positive signed area (`perp_dot`).
#[derive(Debug, Clone, Default)]
pub(crate) struct Triangulation {
    /// Positions of the vertices.
    pub(crate) vertices: Vec<DVec2>,
    /// Triangles × 3 vertex indices.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Triangles × 3: the triangle across the edge from corner k to corner k + 1, or [`NONE`].
    pub(crate) neighbours: Vec<[u32; 3]>,
}

impl Triangulation {
    /// A copy with capacity for additional vertices and their triangles.
    pub(crate) fn with_capacity_for(&self, vertices: usize) -> Self {
        fn extended<T: Copy>(list: &[T], more: usize) -> Vec<T> {
            let mut copy = Vec::with_capacity(list.len() + more);
            copy.extend_from_slice(list);
            copy
        }
        Self {
            vertices: extended(&self.vertices, vertices),
            triangles: extended(&self.triangles, 2 * vertices),
            neighbours: extended(&self.neighbours, 2 * vertices),
        }
    }

    /// Calls `visit` with the edges of each polygon of the mesh, in positive order, if one of its triangles
    /// `is_wanted`.
    ///
    /// Nearly every polygon is a triangle. More than three vertices may lie on one empty circle, for example on both
    /// sides of an axis of symmetry. Their triangulation is arbitrary, so they form one polygon.
    pub(crate) fn visit_polygons(&self, is_wanted: impl Fn([u32; 3]) -> bool, mut visit: impl FnMut(&[[u32; 2]])) {
        let mut is_visited = vec![false; self.triangles.len()];
        let (mut open, mut edges) = (Vec::new(), Vec::new());
        for (first, &corners) in self.triangles.iter().enumerate() {
            if is_visited[first] || !is_wanted(corners) {
                continue;
            }
            is_visited[first] = true;
            open.push(first);
            while let Some(t) = open.pop() {
                let [a, b, c] = self.triangles[t];
                for ([a, b, c], beyond) in [[a, b, c], [b, c, a], [c, a, b]].into_iter().zip(self.neighbours[t]) {
                    let opposite =
                        self.triangles.get(beyond as usize).and_then(|v| v.iter().find(|&&d| d != a && d != b));
                    if !opposite.is_some_and(|&d| self.are_cocircular([a, b, c, d])) {
                        edges.push([a, b]);
                    } else if !std::mem::replace(&mut is_visited[beyond as usize], true) {
                        open.push(beyond as usize);
                    }
                }
            }
            visit(&edges);
            edges.clear();
        }
    }

    /// Whether the four corners of two adjacent triangles lie on one circle, within rounding.
    fn are_cocircular(&self, corners: [u32; 4]) -> bool {
        let [a, b, c, d] = corners.map(|v| self.vertices[v as usize]);
        let [ca, cb, da, db] = [a - c, b - c, a - d, b - d];
        // The sine of the sum of two opposite angles, times the lengths of the sides.
        let sine = ca.perp_dot(cb) * da.dot(db) - ca.dot(cb) * da.perp_dot(db);
        let sides = ca.length_squared() * cb.length_squared() * da.length_squared() * db.length_squared();
        sine * sine <= COCIRCULAR_SINE * COCIRCULAR_SINE * sides
    }

    /// The positions of a triangle's corners.
    pub(crate) fn corners(&self, triangle: usize) -> [DVec2; 3] {
        self.triangles[triangle].map(|v| self.vertices[v as usize])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cocircular_corners_form_one_polygon() {
        let corner = |i: u32| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(i) / 6.0);
            DVec2::new(3.0 + 20.0 * cos, 7.0 + 20.0 * sin)
        };
        let vertices: Vec<DVec2> = (0..6).map(corner).chain([DVec2::new(60.0, 7.0)]).collect();
        // Around the hexagon, through a vertex beside it.
        let segments = vec![[1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 1]];
        let mesh = Triangulation::constrained_delaunay(vertices, segments);
        let mut polygons = Vec::new();
        mesh.visit_polygons(|_| true, |edges| polygons.push(edges.to_vec()));
        polygons.sort_by_key(Vec::len);
        let lengths: Vec<usize> = polygons.iter().map(Vec::len).collect();
        assert_eq!(lengths, [3, 3, 6], "{polygons:?}");
        let mut starts: Vec<u32> = polygons[2].iter().map(|[a, _]| *a).collect();
        starts.sort_unstable();
        assert_eq!(starts, [0, 1, 2, 3, 4, 5]);
    }
}
