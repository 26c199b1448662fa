//! The inverse of the drawn mesh at many points: which point of the picture is drawn at each.
//!
//! Within a triangle the map of the mesh is affine, so its inverse is exact. Triangles are visited in drawing order,
//! and the last one around a point covers the others. [`locate`](super::locate) does the same for single points.
//!
//! Cost: linear in the triangles, and for each in the points within its range of y, found by binary search.

use glam::DVec2;

use super::triangle::{barycentric, corners, interpolate};
use crate::rank::{ascending, sort_by_rank};

/// The rest point that is drawn at each of `points`; `None` if nothing is drawn there. `drawn` is in drawing order.
pub(crate) fn rest_points(rest: &[DVec2], posed: &[DVec2], drawn: &[[u32; 3]], points: &[DVec2]) -> Vec<Option<DVec2>> {
    let mut found = vec![None; points.len()];
    let mut by_height: Vec<_> = points.iter().copied().enumerate().filter(|(_, p)| p.is_finite()).collect();
    sort_by_rank(&mut by_height, |&(_, p)| [ascending(p.y), 0]);
    for &triangle in drawn {
        let here = corners(posed, triangle);
        let [a, b, c] = here;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let first = by_height.partition_point(|(_, p)| p.y < low.y);
        let beside = by_height[first..].iter().take_while(|(_, p)| p.y <= high.y);
        for &(point, p) in beside.filter(|(_, p)| low.x <= p.x && p.x <= high.x) {
            if let Some(coordinates) = barycentric(here, p) {
                found[point] = Some(interpolate(corners(rest, triangle), coordinates));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn last_drawn_triangle_covers_the_others() {
        let rest = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [10.0, 0.0], [14.0, 0.0], [10.0, 4.0]].map(DVec2::from);
        // The second lies over the first, turned over.
        let posed = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [0.0, 0.0], [0.0, 4.0], [4.0, 0.0]].map(DVec2::from);
        let (under, over) = ([0, 1, 2], [3, 4, 5]);
        let points = [[2.0, 1.0], [3.0, 3.0], [f64::NAN, 1.0], [1.0, 2.0]].map(DVec2::from);
        let at = |drawn: &[[u32; 3]]| rest_points(&rest, &posed, drawn, &points);
        let [lower, upper, turned, other] =
            [[2.0, 1.0], [1.0, 2.0], [11.0, 2.0], [12.0, 1.0]].map(|p| Some(DVec2::from(p)));
        assert_eq!(at(&[under, over]), [turned, None, None, other]);
        assert_eq!(at(&[over, under]), [lower, None, None, upper]);
        assert_eq!(at(&[[0, 0, 1], [0, 1, 1]]), [None; 4]);
    }
}
