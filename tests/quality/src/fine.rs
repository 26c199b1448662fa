//! The one mesh that all methods of a pose are compared on: the samples of a solve, without the rim around them.

use c2warp::Solution;
use glam::DVec2;

/// A triangle mesh over the domain; all triangles wind the same way.
#[derive(Debug, Clone)]
pub struct Fine {
    /// Rest places.
    pub vertices: Vec<DVec2>,
    /// Vertex numbers, counted so that [`DVec2::perp_dot`] of the edges is positive.
    pub triangles: Vec<[u32; 3]>,
    /// Area of each triangle.
    pub areas: Vec<f64>,
}

impl Fine {
    /// The mesh over the samples of a solution.
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

    /// The corners of a triangle in places of the vertices.
    #[must_use]
    pub fn corners(&self, triangle: usize, places: &[DVec2]) -> [DVec2; 3] {
        self.triangles[triangle].map(|v| places[v as usize])
    }

    /// Inner edges: the triangles on both sides and the two vertices.
    #[must_use]
    pub fn inner_edges(&self) -> Vec<([u32; 2], [usize; 2])> {
        self.edges().into_iter().filter_map(|(edge, sides)| Some((edge, sides.try_into().ok()?))).collect()
    }

    /// Whether each vertex is on the outline.
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

    /// Where a point goes when the map is linear in each triangle; `None` outside the mesh.
    #[must_use]
    pub fn interpolated(&self, posed: &[DVec2], p: DVec2) -> Option<DVec2> {
        // On the outline a point may lie outside by rounding: the triangle that it lies least outside of.
        let inside = |t: usize| {
            let [a, b, c] = self.corners(t, &self.vertices);
            let twice = 2.0 * self.areas[t];
            [(c - b).perp_dot(p - b), (a - c).perp_dot(p - c), (b - a).perp_dot(p - a)].map(|area| area / twice)
        };
        let least = |shares: [f64; 3]| shares.into_iter().fold(f64::INFINITY, f64::min);
        let best = (0..self.triangles.len()).max_by(|&s, &t| least(inside(s)).total_cmp(&least(inside(t))))?;
        let shares = inside(best);
        let at = self.corners(best, posed);
        (least(shares) > -1e-6).then(|| at[0] * shares[0] + at[1] * shares[1] + at[2] * shares[2])
    }
}
