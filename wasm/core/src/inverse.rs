//! From the posed picture back to rest: which place of the picture is drawn at a point.
//!
//! Within a triangle the map of the mesh is affine, so its inverse is exact; triangles are searched from the last drawn to the first,
//! which finds what is seen where the picture lies over itself. `web/src/geometry/locate.ts` does the same in the page.
//!
//! Cost: linear in the triangles.

use glam::DVec2;

/// The place at rest that is drawn at `p`, of vertices at rest and posed and the triangles over them in the order in which they are
/// drawn; `None` where nothing is.
pub(crate) fn rest_at(rest: &[DVec2], posed: &[DVec2], drawn: &[[u32; 3]], p: DVec2) -> Option<DVec2> {
    drawn.iter().rev().find_map(|triangle| {
        let corners = triangle.map(|vertex| vertex as usize);
        let [u, v, w] = shares(corners.map(|vertex| posed[vertex]), p)?;
        let [a, b, c] = corners.map(|vertex| rest[vertex]);
        Some(u * a + v * b + w * c)
    })
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
        let at = |drawn: &[[u32; 3]]| rest_at(&rest, &posed, drawn, DVec2::new(2.0, 1.0));
        assert_eq!(at(&[under, over]), Some(DVec2::new(11.0, 2.0)));
        assert_eq!(at(&[over, under]), Some(DVec2::new(2.0, 1.0)));
        assert_eq!(rest_at(&rest, &posed, &[under, over], DVec2::new(3.0, 3.0)), None);
        assert_eq!(at(&[[0, 0, 1], [0, 1, 1]]), None);
    }
}
