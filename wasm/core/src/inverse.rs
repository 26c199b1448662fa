//! From the posed picture back to rest: which place of the picture is drawn at points.
//!
//! Within a triangle the map of the mesh is affine, so its inverse is exact; triangles are taken from the first drawn to the last, which
//! leaves what is seen where the picture lies over itself. `web/src/geometry/locate.ts` does the same in the page.
//!
//! Cost: linear in the triangles, and for each in the points as high up as it, which are sorted by that.

use glam::DVec2;

/// The places at rest that are drawn at points, of vertices at rest and posed and the triangles over them in the order in which they are
/// drawn; `None` where nothing is.
pub(crate) fn rests_of(rest: &[DVec2], posed: &[DVec2], drawn: &[[u32; 3]], points: &[DVec2]) -> Vec<Option<DVec2>> {
    let mut found = vec![None; points.len()];
    let mut by_height: Vec<_> = points.iter().copied().enumerate().filter(|(_, p)| p.is_finite()).collect();
    by_height.sort_unstable_by(|(_, p), (_, q)| p.y.total_cmp(&q.y));
    for triangle in drawn {
        let [a, b, c] = triangle.map(|vertex| posed[vertex as usize]);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let first = by_height.partition_point(|(_, p)| p.y < low.y);
        let beside = by_height[first..].iter().take_while(|(_, p)| p.y <= high.y);
        for &(point, p) in beside.filter(|(_, p)| low.x <= p.x && p.x <= high.x) {
            if let Some([u, v, w]) = shares([a, b, c], p) {
                let [a, b, c] = triangle.map(|vertex| rest[vertex as usize]);
                found[point] = Some(u * a + v * b + w * c);
            }
        }
    }
    found
}

/// Barycentric coordinates in a triangle of either orientation; `None` outside of it, and where it has no area.
fn shares([a, b, c]: [DVec2; 3], p: DVec2) -> Option<[f64; 3]> {
    let area = (b - a).perp_dot(c - a);
    let (u, v) = ((b - p).perp_dot(c - p) / area, (c - p).perp_dot(a - p) / area);
    let shares = [u, v, 1.0 - u - v];
    // NaN, of no area, is not above anything.
    shares.iter().all(|&share| share >= 0.0).then_some(shares)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_drawn_triangle_is_the_one_that_is_seen() {
        let rest = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [10.0, 0.0], [14.0, 0.0], [10.0, 4.0]].map(DVec2::from);
        // The second lies over the first, turned over.
        let posed = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [0.0, 0.0], [0.0, 4.0], [4.0, 0.0]].map(DVec2::from);
        let (under, over) = ([0, 1, 2], [3, 4, 5]);
        let points = [[2.0, 1.0], [3.0, 3.0], [f64::NAN, 1.0], [1.0, 2.0]].map(DVec2::from);
        let at = |drawn: &[[u32; 3]]| rests_of(&rest, &posed, drawn, &points);
        let [lower, upper, turned, other] =
            [[2.0, 1.0], [1.0, 2.0], [11.0, 2.0], [12.0, 1.0]].map(|p| Some(DVec2::from(p)));
        assert_eq!(at(&[under, over]), [turned, None, None, other]);
        assert_eq!(at(&[over, under]), [lower, None, None, upper]);
        assert_eq!(at(&[[0, 0, 1], [0, 1, 1]]), [None; 4]);
    }
}
