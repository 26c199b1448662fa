//! The points of the picture that another part of it hides.
//!
//! Cost: two passes over the triangles, independent of the number of points.

use glam::DVec2;

use super::{Bounds, inverse::rest_points};

/// Points closer than this to each other at rest belong to one part, as a fraction of the picture's diagonal. So small
/// folds hide nothing.
const SAME_PART: f64 = 0.02;

/// For each point at rest, whether another part of the picture is drawn over it. The skirt, which is partly
/// transparent, hides nothing: only triangles of the first `samples` vertices count.
pub(super) fn hidden([rest, posed]: [&[DVec2]; 2], drawn: &[[u32; 3]], samples: usize, points: &[DVec2]) -> Vec<bool> {
    let bends = |triangle: &&[u32; 3]| triangle.iter().all(|&vertex| (vertex as usize) < samples);
    let drawn: Vec<[u32; 3]> = drawn.iter().filter(bends).copied().collect();
    let Some(Bounds { min, max }) = Bounds::new(&rest[..samples]) else { return vec![false; points.len()] };
    let apart = SAME_PART * min.distance(max);
    // Points outside the mesh are NaN, and nothing is found there.
    let places: Vec<DVec2> =
        rest_points(posed, rest, &drawn, points).into_iter().map(|place| place.unwrap_or(DVec2::NAN)).collect();
    let shown = rest_points(rest, posed, &drawn, &places);
    let is_hidden = |(point, shown): (&DVec2, Option<DVec2>)| shown.is_some_and(|shown| shown.distance(*point) > apart);
    points.iter().zip(shown).map(is_hidden).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn point_below_a_later_part_is_hidden() {
        let square = |x: f64| [[x, 0.0], [x + 4.0, 0.0], [x + 4.0, 4.0], [x, 4.0]].map(DVec2::from);
        let rest = [square(0.0), square(20.0)].concat();
        // The second square covers the right half of the first one.
        let posed = [square(0.0), square(2.0)].concat();
        let (first, second) = ([[0, 1, 2], [0, 2, 3]], [[4, 5, 6], [4, 6, 7]]);
        let points = [[1.0, 1.0], [3.0, 1.0], [21.0, 1.0], [23.0, 1.0], [50.0, 1.0]].map(DVec2::from);
        let with = |drawn: &[[u32; 3]]| hidden([&rest, &posed], drawn, 8, &points);
        assert_eq!(with(&[first, second].concat()), [false, true, false, false, false]);
        assert_eq!(with(&[second, first].concat()), [false, false, true, false, false]);
        // The second square is skirt.
        let all = [first, second].concat();
        assert_eq!(hidden([&rest, &posed], &all, 4, &points), [false; 5]);
    }
}
