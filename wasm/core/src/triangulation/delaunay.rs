//! Constrained Delaunay triangulation, by spade. No other file uses spade.
//!
//! Cost: O(n log n) for n vertices. Known limit: if segments cross, O(n) for each triangle.

use std::collections::HashSet;

use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _, mitigate_underflow};

use super::mesh::{NONE, Triangulation};

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

impl Triangulation {
    /// The constrained Delaunay triangulation of the region inside closed chains of `segments`, by the even-odd rule.
    ///
    /// Vertices must be finite, and keep their indices. They should be distinct, and segments should not cross. If
    /// vertices coincide, only the first is used, and edges are missing where segments cross.
    pub(crate) fn constrained_delaunay(vertices: Vec<DVec2>, segments: Vec<[usize; 2]>) -> Self {
        Self::from_faces(vertices, segments, Some(true))
    }

    /// The constrained Delaunay triangulation of the vertices' convex hull without that region.
    pub(crate) fn constrained_delaunay_outside(vertices: Vec<DVec2>, segments: Vec<[usize; 2]>) -> Self {
        Self::from_faces(vertices, segments, Some(false))
    }

    /// The constrained Delaunay triangulation of the vertices' convex hull. Segments may lie on each other.
    pub(crate) fn constrained_delaunay_hull(vertices: Vec<DVec2>, segments: Vec<[usize; 2]>) -> Self {
        Self::from_faces(vertices, segments, None)
    }

    /// Triangulates the faces inside the segments if `inside`, those outside if not, and all faces by default.
    fn from_faces(vertices: Vec<DVec2>, mut segments: Vec<[usize; 2]>, inside: Option<bool>) -> Self {
        let points: Vec<_> = vertices.iter().map(|p| mitigate_underflow(Point2::new(p.x, p.y))).collect();
        segments.retain(|&[a, b]| points[a] != points[b]);
        let ends: Vec<[Point2<f64>; 2]> = segments.iter().map(|ends| ends.map(|end| points[end])).collect();
        let mut crossings = 0;
        let cdt = Cdt::try_bulk_load_cdt(points, segments, |_| crossings += 1)
            .expect("vertices of a checked domain are finite and far from the limits of f64");
        // Spade drops vertices that coincide with earlier ones, and renumbers the later ones.
        let known = (cdt.num_vertices() < vertices.len()).then(|| distinct_vertices(&vertices));
        let index = |vertex: usize| known.as_ref().map_or(vertex as u32, |known| known[vertex]);
        let kept: Vec<_> = match inside {
            Some(inside) => {
                let is_inside =
                    if crossings == 0 { inside_by_parity(&cdt) } else { inside_by_ray_casting(&cdt, &ends) };
                cdt.inner_faces().filter(|face| is_inside[face.fix().index()] == inside).collect()
            }
            None => cdt.inner_faces().collect(),
        };
        let mut number = vec![NONE; cdt.num_all_faces()];
        for (face, at) in kept.iter().zip(0..) {
            number[face.fix().index()] = at;
        }
        let corners = kept.iter().map(|face| face.vertices().map(|vertex| index(vertex.fix().index()))).collect();
        let across = kept.iter().map(|face| face.adjacent_edges().map(|edge| number[edge.rev().face().fix().index()]));
        Self { vertices, triangles: corners, neighbours: across.collect() }
    }
}

/// Returns for each face whether it lies inside the constraints. Face 0 is the outer one.
fn inside_by_parity(cdt: &Cdt) -> Vec<bool> {
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

/// The indices of the vertices that do not coincide with earlier ones.
fn distinct_vertices(vertices: &[DVec2]) -> Vec<u32> {
    let mut seen = HashSet::with_capacity(vertices.len());
    let spot = |p: &DVec2| {
        let Point2 { x, y } = mitigate_underflow(Point2::new(p.x, p.y));
        // 0 and −0 coincide.
        [x + 0.0, y + 0.0].map(f64::to_bits)
    };
    (0..).zip(vertices).filter(|(_, p)| seen.insert(spot(p))).map(|(at, _)| at).collect()
}

/// Returns for each face whether its centre lies inside the segments. Face 0 is the outer one.
///
/// Crossing segments are not all edges of the triangulation, so parity does not carry from face to face.
///
/// Cost: a test of each segment for each face.
fn inside_by_ray_casting(cdt: &Cdt, segments: &[[Point2<f64>; 2]]) -> Vec<bool> {
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
    use super::super::NONE;
    use super::*;

    /// The triangulation of closed chains through the vertices, and its area. `chains` are the lengths of the chains.
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
    fn coinciding_vertices_keep_the_indices_of_others() {
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
    fn crossing_segments_do_not_panic() {
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
    fn square_with_hole_has_the_area_between() {
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
        let outside = Triangulation::constrained_delaunay_outside(
            mesh.vertices.clone(),
            (4..8).map(|i| [i, 4 + (i + 1) % 4]).collect(),
        );
        let area: f64 = (0..outside.triangles.len())
            .map(|t| {
                let [a, b, c] = outside.corners(t);
                (b - a).perp_dot(c - a) / 2.0
            })
            .sum();
        assert!((area - 96.0).abs() < 1e-12);
        for (t, neighbours) in mesh.neighbours.iter().enumerate() {
            for &n in neighbours.iter().filter(|&&n| n != NONE) {
                assert!(mesh.neighbours[n as usize].contains(&(t as u32)));
            }
        }
    }
}
