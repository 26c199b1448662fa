//! Creases: the areas that a pose visibly flips.
//!
//! A crease is made of folded triangles that share vertices. Creases smaller than [`VISIBLE_AREA`] are left out: they
//! are invisible, and the picture around them looks smooth.
//!
//! Cost: n log n for n folded triangles.

use glam::DVec2;

use super::{
    bounds::Bounds,
    triangle::{corners, doubled_area},
};
use crate::{
    disjoint_sets::DisjointSets,
    rank::{descending, sort_by_rank},
};

/// The least area of a crease in square image pixels: two by two pixels.
const VISIBLE_AREA: f64 = 4.0;

/// An area in which the posed picture is flipped.
#[derive(Debug, Clone, PartialEq)]
pub struct Crease {
    /// The box around it, in image pixels.
    pub bounds: Bounds,
    /// The flipped area, in square image pixels.
    pub area: f64,
    /// Its triangles.
    pub triangles: Vec<[u32; 3]>,
}

/// The visible creases formed by folded triangles, largest first.
pub(super) fn creases(posed: &[DVec2], folded: &[[u32; 3]]) -> Vec<Crease> {
    let mut creases: Vec<Crease> = connected(folded)
        .into_iter()
        .filter_map(|triangles| {
            let area = triangles.iter().map(|&triangle| doubled_area(corners(posed, triangle)).abs() / 2.0).sum();
            let vertices: Vec<DVec2> = triangles.iter().flat_map(|&triangle| corners(posed, triangle)).collect();
            Bounds::new(&vertices).map(|bounds| Crease { bounds, area, triangles })
        })
        .filter(|crease| crease.area >= VISIBLE_AREA)
        .collect();
    sort_by_rank(&mut creases, |crease| [descending(crease.area), 0]);
    creases
}

/// Groups triangles that share vertices, in the order of their least vertices.
fn connected(triangles: &[[u32; 3]]) -> Vec<Vec<[u32; 3]>> {
    let mut vertices: Vec<u32> = triangles.iter().flatten().copied().collect();
    sort_by_rank(&mut vertices, |&vertex| [vertex.into(), 0]);
    vertices.dedup();
    let local = |vertex: u32| vertices.partition_point(|&other| other < vertex);
    let mut sets = DisjointSets::new(vertices.len());
    for triangle in triangles {
        let [a, b, c] = triangle.map(local);
        sets.join(a, b);
        sets.join(a, c);
    }
    let mut rooted: Vec<(usize, [u32; 3])> =
        triangles.iter().map(|&triangle| (sets.root(local(triangle[0])), triangle)).collect();
    sort_by_rank(&mut rooted, |&(root, _)| [root as i64, 0]);
    let groups = rooted.chunk_by(|(a, _), (b, _)| a == b);
    groups.map(|group| group.iter().map(|&(_, triangle)| triangle).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Squares with their lower left corners at these places, of two triangles each.
    fn squares(places: &[(DVec2, f64)]) -> (Vec<DVec2>, Vec<[u32; 3]>) {
        let corners = |&(at, side): &(DVec2, f64)| [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|p| at + side * p);
        let triangles = (0..places.len() as u32).flat_map(|k| [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|v| 4 * k + v)));
        (places.iter().flat_map(corners).collect(), triangles.collect())
    }

    #[test]
    fn triangles_that_share_vertices_are_one_crease() {
        let (posed, triangles) = squares(&[(DVec2::ZERO, 3.0), (DVec2::new(10.0, 5.0), 4.0)]);
        let found = creases(&posed, &triangles);
        let places: Vec<_> = found.iter().map(|crease| (crease.area, crease.bounds.min, crease.bounds.max)).collect();
        assert_eq!(
            places,
            [(16.0, DVec2::new(10.0, 5.0), DVec2::new(14.0, 9.0)), (9.0, DVec2::ZERO, DVec2::splat(3.0)),]
        );
        assert_eq!(found[1].triangles, triangles[..2]);
    }

    #[test]
    fn creases_smaller_than_two_pixels_each_way_are_left_out() {
        let (posed, triangles) = squares(&[(DVec2::ZERO, 1.9), (DVec2::splat(9.0), 2.0)]);
        assert_eq!(creases(&posed, &triangles).len(), 1);
        assert_eq!(creases(&posed, &triangles[..2]), []);
    }

    #[test]
    fn a_long_strip_is_one_crease_in_any_order_of_its_triangles() {
        let posed: Vec<DVec2> = (0..40).map(|k| DVec2::new(f64::from(k / 2), f64::from(k % 2))).collect();
        let mut strip: Vec<[u32; 3]> = (0..38).map(|k| [k, k + 1, k + 2]).collect();
        for _ in 0..38 {
            strip.rotate_left(7);
            strip.swap(3, 30);
            assert_eq!(creases(&posed, &strip).len(), 1);
        }
    }
}
