//! A triangle mesh as flat arrays, and its constrained Delaunay triangulation. Alone in using spade.
//!
//! Cost: O(n log n) for n vertices. Limits: where segments cross, O(n) for each triangle.

mod insertion;
mod locate;

use std::collections::HashSet;

use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _, mitigate_underflow};

pub(crate) use insertion::Inserted;
pub(crate) use locate::{Locator, OUTLINE_TOLERANCE, signed_depth};

/// "No triangle" in [`Triangulation::neighbours`].
pub(crate) const NONE: u32 = u32::MAX;

/// Four points are on one circle where opposite angles add up to π within this sine: above rounding.
const ON_CIRCLE: f64 = 1e-9;

/// A triangle mesh. Every triangle has positive signed area (`perp_dot`).
#[derive(Debug, Clone, Default)]
pub(crate) struct Triangulation {
    /// Vertex places.
    pub(crate) vertices: Vec<DVec2>,
    /// Triangles × 3 vertex indices.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Triangles × 3: the triangle across the edge from corner k to corner k + 1, or [`NONE`].
    pub(crate) neighbours: Vec<[u32; 3]>,
}

impl Triangulation {
    /// The constrained Delaunay triangulation of the region that closed chains of `segments` bound, by the even-odd rule.
    ///
    /// Vertices keep their indices and must be finite. They should be distinct, and segments should not cross: of coinciding
    /// vertices only the first is used, and edges are missing where segments cross.
    pub(crate) fn constrained_delaunay(vertices: Vec<DVec2>, segments: Vec<[usize; 2]>) -> Self {
        Self::of_faces(vertices, segments, true)
    }

    /// The same of the rest of the vertices' convex hull.
    pub(crate) fn around(vertices: Vec<DVec2>, segments: Vec<[usize; 2]>) -> Self {
        Self::of_faces(vertices, segments, false)
    }

    /// `inside`: the triangles inside of the segments, or those outside.
    fn of_faces(vertices: Vec<DVec2>, mut segments: Vec<[usize; 2]>, inside: bool) -> Self {
        let points: Vec<_> = vertices.iter().map(|p| mitigate_underflow(Point2::new(p.x, p.y))).collect();
        segments.retain(|&[a, b]| points[a] != points[b]);
        let ends: Vec<[Point2<f64>; 2]> = segments.iter().map(|ends| ends.map(|end| points[end])).collect();
        let mut crossings = 0;
        let cdt =
            ConstrainedDelaunayTriangulation::<Point2<f64>>::try_bulk_load_cdt(points, segments, |_| crossings += 1)
                .expect("vertices of a checked domain are finite and far from the limits of f64");
        // Spade drops vertices that coincide with earlier ones, and renumbers the later ones.
        let known = (cdt.num_vertices() < vertices.len()).then(|| distinct_vertices(&vertices));
        let index = |vertex: usize| known.as_ref().map_or(vertex as u32, |known| known[vertex]);
        let is_inside = if crossings == 0 { inside_by_parity(&cdt) } else { inside_by_ray_casting(&cdt, &ends) };
        let kept: Vec<_> = cdt.inner_faces().filter(|face| is_inside[face.fix().index()] == inside).collect();
        let mut number = vec![NONE; cdt.num_all_faces()];
        for (face, at) in kept.iter().zip(0..) {
            number[face.fix().index()] = at;
        }
        let corners = kept.iter().map(|face| face.vertices().map(|vertex| index(vertex.fix().index()))).collect();
        let across = kept.iter().map(|face| face.adjacent_edges().map(|edge| number[edge.rev().face().fix().index()]));
        Self { vertices, triangles: corners, neighbours: across.collect() }
    }

    /// A copy with capacity for more vertices and the triangles that they add.
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

    /// Calls `visit` with the edges of each polygon of the mesh, in positive order, if one of its triangles `is_wanted`.
    /// Nearly every polygon is a triangle; but where more than three vertices lie on one empty circle, as on both sides of an
    /// axis of symmetry, their triangulation is arbitrary, and they form one polygon.
    pub(crate) fn polygons(&self, is_wanted: impl Fn([u32; 3]) -> bool, mut visit: impl FnMut(&[[u32; 2]])) {
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
                    if !opposite.is_some_and(|&d| self.are_on_circle([a, b, c, d])) {
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
    fn are_on_circle(&self, corners: [u32; 4]) -> bool {
        let [a, b, c, d] = corners.map(|v| self.vertices[v as usize]);
        let [ca, cb, da, db] = [a - c, b - c, a - d, b - d];
        // The sine of the sum of two opposite angles, times the lengths of the sides.
        let sine = ca.perp_dot(cb) * da.dot(db) - ca.dot(cb) * da.perp_dot(db);
        let sides = ca.length_squared() * cb.length_squared() * da.length_squared() * db.length_squared();
        sine * sine <= ON_CIRCLE * ON_CIRCLE * sides
    }

    /// The corners of a triangle.
    pub(crate) fn corners(&self, triangle: usize) -> [DVec2; 3] {
        self.triangles[triangle].map(|v| self.vertices[v as usize])
    }
}

/// For each face (0 being the outer one) whether it lies inside the constraints.
fn inside_by_parity(cdt: &ConstrainedDelaunayTriangulation<Point2<f64>>) -> Vec<bool> {
    let mut parity: Vec<Option<bool>> = vec![None; cdt.num_all_faces()];
    let outer = cdt.outer_face();
    parity[outer.fix().index()] = Some(false);
    // The outer face has no list of its edges: start from those of the hull.
    let mut stack: Vec<_> = cdt.convex_hull().map(|edge| edge.fix()).collect();
    while let Some(edge) = stack.pop() {
        let edge = cdt.directed_edge(edge);
        let from = parity[edge.face().fix().index()].expect("edges are pushed from faces that are known");
        let beyond = edge.rev().face();
        let known = &mut parity[beyond.fix().index()];
        if known.is_none() {
            *known = Some(from != edge.is_constraint_edge());
            let first = edge.rev();
            stack.extend([first.next().fix(), first.prev().fix()]);
        }
    }
    parity.into_iter().map(|parity| parity == Some(true)).collect()
}

/// The vertices that do not coincide with earlier ones.
fn distinct_vertices(vertices: &[DVec2]) -> Vec<u32> {
    let mut seen = HashSet::with_capacity(vertices.len());
    let spot = |p: &DVec2| {
        let Point2 { x, y } = mitigate_underflow(Point2::new(p.x, p.y));
        // 0 and −0 coincide.
        [x + 0.0, y + 0.0].map(f64::to_bits)
    };
    (0..).zip(vertices).filter(|(_, p)| seen.insert(spot(p))).map(|(at, _)| at).collect()
}

/// For each face (0 being the outer one) whether its centre lies inside the segments. Needed where segments cross and so are
/// not all edges: parity cannot be carried from face to face.
///
/// Cost: a look at each segment for each face.
fn inside_by_ray_casting(
    cdt: &ConstrainedDelaunayTriangulation<Point2<f64>>,
    segments: &[[Point2<f64>; 2]],
) -> Vec<bool> {
    let mut inside = vec![false; cdt.num_all_faces()];
    for face in cdt.inner_faces() {
        let p = face.center();
        let beyond = |&&[a, b]: &&[Point2<f64>; 2]| {
            (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
        };
        inside[face.fix().index()] = segments.iter().filter(beyond).count() % 2 == 1;
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The triangulation of chains through the vertices; `chains` are their lengths.
    fn chained(vertices: &[[f64; 2]], chains: &[usize]) -> (Triangulation, f64) {
        let mut segments = Vec::new();
        for &n in chains {
            let start = segments.len();
            segments.extend((0..n).map(|i| [start + i, start + (i + 1) % n]));
        }
        let mesh = Triangulation::constrained_delaunay(vertices.iter().map(|&p| p.into()).collect(), segments);
        let area = |t: usize| {
            let [a, b, c] = mesh.corners(t);
            (b - a).perp_dot(c - a) / 2.0
        };
        let area = (0..mesh.triangles.len()).map(area).sum();
        (mesh, area)
    }

    #[test]
    fn coinciding_vertices_leave_the_others_their_indices() {
        for hair in [0.0, -0.0, 1e-50] {
            let (mesh, area) = chained(&[[3.0, 0.0], [3.0, hair], [10.0, 5.0], [10.0, 5.0], [0.0, 5.0]], &[5]);
            assert_eq!(mesh.vertices.len(), 5);
            assert_eq!(mesh.triangles.len(), 1);
            let mut corners = mesh.triangles[0];
            corners.sort_unstable();
            assert_eq!(corners, [0, 2, 4]);
            assert!((area - 25.0).abs() < 1e-12);
        }
    }

    #[test]
    fn segments_that_cross_are_no_panic() {
        let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        for depth in [1.0, 1e-15] {
            let (mesh, _) = chained(&[&square[..], &[[5.0, depth], [8.0, -9.0], [2.0, -9.0]]].concat(), &[4, 3]);
            assert!(!mesh.triangles.is_empty());
        }
        let (mesh, _) = chained(&[[0.0, 0.0], [10.0, 10.0], [10.0, 0.0], [0.0, 10.0]], &[4]);
        assert!(!mesh.triangles.is_empty());
        let (mesh, _) = chained(&[[0.0, 0.0], [5.0, 5.0], [10.0, 10.0]], &[3]);
        assert!(mesh.triangles.is_empty());
    }

    #[test]
    fn a_square_with_a_hole_has_the_area_between() {
        let ring = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from);
        let vertices: Vec<DVec2> = ring(0.0, 10.0).into_iter().chain(ring(4.0, 6.0)).collect();
        let segments = (0..8).map(|i| [i, i / 4 * 4 + (i + 1) % 4]).collect();
        let mesh = Triangulation::constrained_delaunay(vertices, segments);
        let area = |t: usize| {
            let [a, b, c] = mesh.corners(t);
            (b - a).perp_dot(c - a) / 2.0
        };
        let areas: Vec<f64> = (0..mesh.triangles.len()).map(area).collect();
        assert!(areas.iter().all(|&area| area > 0.0));
        assert!((areas.iter().sum::<f64>() - 96.0).abs() < 1e-12);
        let around = Triangulation::around(mesh.vertices.clone(), (4..8).map(|i| [i, 4 + (i + 1) % 4]).collect());
        let left: f64 = (0..around.triangles.len())
            .map(|t| {
                let [a, b, c] = around.corners(t);
                (b - a).perp_dot(c - a) / 2.0
            })
            .sum();
        assert!((left - 96.0).abs() < 1e-12);
        for (t, neighbours) in mesh.neighbours.iter().enumerate() {
            for &n in neighbours.iter().filter(|&&n| n != NONE) {
                assert!(mesh.neighbours[n as usize].contains(&(t as u32)));
            }
        }
    }

    #[test]
    fn corners_on_one_circle_make_one_polygon_however_they_are_triangulated() {
        let corner = |i: u32| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(i) / 6.0);
            DVec2::new(3.0 + 20.0 * cos, 7.0 + 20.0 * sin)
        };
        let vertices: Vec<DVec2> = (0..6).map(corner).chain([DVec2::new(60.0, 7.0)]).collect();
        // Around the hexagon, through a vertex beside it.
        let segments = vec![[1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 1]];
        let mesh = Triangulation::constrained_delaunay(vertices, segments);
        let mut polygons = Vec::new();
        mesh.polygons(|_| true, |edges| polygons.push(edges.to_vec()));
        polygons.sort_by_key(Vec::len);
        let lengths: Vec<usize> = polygons.iter().map(Vec::len).collect();
        assert_eq!(lengths, [3, 3, 6], "{polygons:?}");
        let mut starts: Vec<u32> = polygons[2].iter().map(|[a, _]| *a).collect();
        starts.sort_unstable();
        assert_eq!(starts, [0, 1, 2, 3, 4, 5]);
    }
}
