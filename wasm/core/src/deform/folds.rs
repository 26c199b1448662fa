//! Folds: the triangles that a pose flips.
//!
//! Triangles of the skirt do not count: these slivers flip wherever the outline bends.
//!
//! Cost: linear in the triangles; 20,000 take a fraction of a millisecond.

use glam::DVec2;

use super::triangle::{corners, doubled_area};

/// The triangles that can fold, with their corners ordered for a positive area at rest.
#[derive(Debug, Clone)]
pub(crate) struct FoldingMesh(Vec<[u32; 3]>);

impl FoldingMesh {
    /// The triangles of a mesh whose first `samples` vertices lie in the domain. Degenerate triangles are left out.
    pub(crate) fn new(rest: &[DVec2], triangles: &[[u32; 3]], samples: usize) -> Self {
        let inner = triangles.iter().filter(|triangle| triangle.iter().all(|&vertex| (vertex as usize) < samples));
        let oriented = |&[a, b, c]: &[u32; 3]| match doubled_area(corners(rest, [a, b, c])) {
            area if area > 0.0 => Some([a, b, c]),
            area if area < 0.0 => Some([a, c, b]),
            _ => None,
        };
        Self(inner.filter_map(oriented).collect())
    }

    /// The flipped triangles.
    pub(crate) fn folded<'a>(&'a self, posed: &'a [DVec2]) -> impl Iterator<Item = [u32; 3]> + 'a {
        self.0.iter().copied().filter(|&triangle| doubled_area(corners(posed, triangle)) < 0.0)
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.0[..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    const TRIANGLES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

    /// The corner at (1, 0) is pulled across the diagonal.
    fn pulled() -> [DVec2; 4] {
        [DVec2::ZERO, DVec2::new(0.2, 0.8), DVec2::ONE, DVec2::Y]
    }

    fn count(triangles: &[[u32; 3]], samples: usize, posed: [DVec2; 4]) -> usize {
        FoldingMesh::new(&SQUARE, triangles, samples).folded(&posed).count()
    }

    #[test]
    fn rest_and_rotations_do_not_fold() {
        assert_eq!(count(&TRIANGLES, 4, SQUARE), 0);
        assert_eq!(count(&TRIANGLES, 4, SQUARE.map(|p| -p)), 0);
    }

    #[test]
    fn triangles_that_turn_over_fold_in_either_orientation() {
        assert_eq!(count(&TRIANGLES, 4, pulled()), 1);
        let mesh = FoldingMesh::new(&SQUARE, &TRIANGLES, 4);
        assert_eq!(mesh.folded(&pulled()).collect::<Vec<_>>(), [[0, 1, 2]]);
        let mirrored = [[2, 1, 0], [0, 2, 3]];
        assert_eq!(count(&mirrored, 4, pulled()), 1);
        assert_eq!(count(&mirrored, 4, SQUARE), 0);
    }

    #[test]
    fn folds_of_the_rim_do_not_count() {
        assert_eq!(count(&TRIANGLES, 1, pulled()), 0);
        let turned_over = SQUARE.map(|p| DVec2::new(p.y, p.x));
        assert_eq!(count(&TRIANGLES, 4, turned_over), 2);
    }
}
