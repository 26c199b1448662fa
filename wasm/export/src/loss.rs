//! The loss of a rig: distances of its vertices from their exact positions.

use glam::DVec2;

/// Distances in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Errors {
    /// The maximum distance.
    pub largest: f64,
    /// The 99th percentile.
    pub percentile_99: f64,
    /// Their mean.
    pub mean: f64,
}

impl Errors {
    /// Computes both from distances in any order.
    pub(crate) fn of(mut distances: Vec<f64>) -> Self {
        distances.sort_unstable_by(f64::total_cmp);
        let Some(&largest) = distances.last() else { return Self::default() };
        let at = (distances.len() * 99).div_ceil(100) - 1;
        let mean = distances.iter().sum::<f64>() / distances.len() as f64;
        Self { largest, percentile_99: distances[at], mean }
    }
}

/// The loss of a rig.
#[derive(Debug, Clone, PartialEq)]
pub struct Loss {
    /// Vertices in the project's pose.
    pub pose: Errors,
    /// Vertices in 20 random poses.
    pub random: Errors,
    /// Vertices in the random poses, with bones that move like their sites, without a fit to the pose, as an animator
    /// would move them.
    pub unfitted: Errors,
    /// The names of the clips, and vertices at 12 times of each clip.
    pub clips: Vec<(String, Errors)>,
    /// The picture between exact vertices, in the project's pose and in the random ones: flat triangles against the
    /// smooth map.
    pub between: Errors,
}

/// The points within a mesh at which its flat triangles are measured.
pub(crate) struct Places {
    /// The index of the measured point, its triangle, and its barycentric coordinates.
    at: Vec<(usize, [u32; 3], [f64; 3])>,
}

impl Places {
    /// Finds the points that lie in a triangle.
    pub(crate) fn new(points: &[DVec2], vertices: &[DVec2], triangles: &[[u32; 3]]) -> Self {
        let mut by_x: Vec<usize> = (0..points.len()).collect();
        by_x.sort_by(|&a, &b| points[a].x.total_cmp(&points[b].x));
        let mut found: Vec<Option<([u32; 3], [f64; 3])>> = vec![None; points.len()];
        for &triangle in triangles {
            let [a, b, c] = triangle.map(|vertex| vertices[vertex as usize]);
            let area = (b - a).perp_dot(c - a);
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            let first = by_x.partition_point(|&at| points[at].x < low.x);
            for &at in by_x[first..].iter().take_while(|&&at| points[at].x <= high.x) {
                let p = points[at];
                let shares = [(b - p).perp_dot(c - p), (c - p).perp_dot(a - p), (a - p).perp_dot(b - p)];
                if found[at].is_none() && area != 0.0 && shares.iter().all(|share| share / area >= 0.0) {
                    found[at] = Some((triangle, shares.map(|share| share / area)));
                }
            }
        }
        let places = found.into_iter().enumerate();
        Self { at: places.filter_map(|(at, place)| place.map(|(corners, shares)| (at, corners, shares))).collect() }
    }

    /// Distances between the points in flat triangles and their exact positions.
    pub(crate) fn distances(&self, vertices: &[DVec2], exact: &[DVec2]) -> impl Iterator<Item = f64> {
        self.at.iter().map(|(at, corners, shares)| {
            let flat: DVec2 =
                corners.iter().zip(shares).map(|(&vertex, &share)| share * vertices[vertex as usize]).sum();
            flat.distance(exact[*at])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_of_a_hundred_distances_may_exceed_the_percentile() {
        let errors = Errors::of((1..=100).rev().map(f64::from).collect());
        assert_eq!((errors.largest, errors.percentile_99, errors.mean), (100.0, 99.0, 50.5));
        assert_eq!(Errors::of(vec![2.0]).percentile_99, 2.0);
        assert_eq!(Errors::of(Vec::new()), Errors::default());
    }

    #[test]
    fn flat_triangles_are_measured_inside_them_alone() {
        let vertices = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(DVec2::from);
        let points = [(1.0, 1.0), (9.0, 1.0)].map(DVec2::from);
        let places = Places::new(&points, &vertices, &[[0, 1, 2]]);
        let posed = vertices.map(|p| 2.0 * p);
        let distances: Vec<f64> = places.distances(&posed, &points.map(|p| 2.0 * p + DVec2::Y)).collect();
        assert_eq!(distances, [1.0]);
    }
}
