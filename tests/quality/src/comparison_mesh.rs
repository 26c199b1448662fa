//! The mesh on which all methods of a pose are compared: the samples of a solution, without the skirt.

use c2warp::Solution;
use glam::DVec2;

/// A triangle mesh over the domain. All triangles have the same orientation.
#[derive(Debug, Clone)]
pub struct ComparisonMesh {
    /// Rest positions.
    pub vertices: Vec<DVec2>,
    /// Vertex indices, in the order in which [`DVec2::perp_dot`] of the edges is positive.
    pub triangles: Vec<[u32; 3]>,
    /// The area of each triangle.
    pub areas: Vec<f64>,
}

impl ComparisonMesh {
    /// Returns the mesh over the samples of a solution.
    #[must_use]
    pub fn of(solution: &Solution) -> Self {
        let vertices = solution.vertices()[..solution.samples()].to_vec();
        let twice = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|v| vertices[v as usize]);
            (b - a).perp_dot(c - a)
        };
        let inner = solution.triangles().iter().filter(|t| t.iter().all(|&v| (v as usize) < vertices.len()));
        let turned = |&[a, b, c]: &[u32; 3]| if twice([a, b, c]) > 0.0 { [a, b, c] } else { [a, c, b] };
        let triangles: Vec<[u32; 3]> = inner.map(turned).collect();
        let areas = triangles.iter().map(|&t| twice(t) / 2.0).collect();
        Self { vertices, triangles, areas }
    }

    /// Returns the corners of a triangle for these positions of the vertices.
    #[must_use]
    pub fn corners(&self, triangle: usize, positions: &[DVec2]) -> [DVec2; 3] {
        self.triangles[triangle].map(|v| positions[v as usize])
    }

    /// Returns the vertices of each inner edge, and the triangles on its sides.
    #[must_use]
    pub fn inner_edges(&self) -> Vec<([u32; 2], [usize; 2])> {
        self.edges().into_iter().filter_map(|(edge, sides)| Some((edge, sides.try_into().ok()?))).collect()
    }

    /// Returns the edges of the outline, in the direction of their triangles.
    #[must_use]
    pub fn outline(&self) -> Vec<[u32; 2]> {
        let edges = self.edges();
        let of_triangle = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let all = self.triangles.iter().flat_map(of_triangle);
        all.filter(|&[a, b]| edges[&[a.min(b), a.max(b)]].len() == 1).collect()
    }

    /// Returns whether each vertex is on the outline.
    #[must_use]
    pub fn on_outline(&self) -> Vec<bool> {
        let mut on = vec![false; self.vertices.len()];
        for (edge, _) in self.edges().into_iter().filter(|(_, sides)| sides.len() == 1) {
            edge.iter().for_each(|&v| on[v as usize] = true);
        }
        on
    }

    fn edges(&self) -> std::collections::BTreeMap<[u32; 2], Vec<usize>> {
        let mut edges = std::collections::BTreeMap::<_, Vec<usize>>::new();
        for (t, corners) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                edges.entry([a.min(b), a.max(b)]).or_default().push(t);
            }
        }
        edges
    }

    /// Interpolates the posed positions linearly in each triangle. Returns `None` outside the mesh.
    #[must_use]
    pub fn interpolated(&self, posed: &[DVec2], p: DVec2) -> Option<DVec2> {
        // A point on the outline may be outside by rounding. So take the triangle that contains it best.
        let barycentric = |t: usize| {
            let [a, b, c] = self.corners(t, &self.vertices);
            let twice = 2.0 * self.areas[t];
            [(c - b).perp_dot(p - b), (a - c).perp_dot(p - c), (b - a).perp_dot(p - a)].map(|area| area / twice)
        };
        let least = |coordinates: [f64; 3]| coordinates.into_iter().fold(f64::INFINITY, f64::min);
        let best =
            (0..self.triangles.len()).max_by(|&s, &t| least(barycentric(s)).total_cmp(&least(barycentric(t))))?;
        let coordinates = barycentric(best);
        let at = self.corners(best, posed);
        (least(coordinates) > -1e-6).then(|| at[0] * coordinates[0] + at[1] * coordinates[1] + at[2] * coordinates[2])
    }
}
