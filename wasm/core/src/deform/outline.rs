//! The outline of the part that bends, in a pose.
//!
//! Cost: a visit of every triangle.

use std::collections::HashSet;

use glam::DVec2;

/// Both posed ends of each edge that belongs to one triangle over the first `samples` vertices only.
pub(super) fn posed_outline<'a>(
    triangles: &[[u32; 3]],
    samples: usize,
    posed: &'a [DVec2],
) -> impl Iterator<Item = [DVec2; 2]> + use<'a> {
    let mut open: HashSet<[u32; 2]> = HashSet::new();
    let mut order = Vec::new();
    for &[a, b, c] in triangles.iter().filter(|triangle| triangle.iter().all(|&v| (v as usize) < samples)) {
        for edge in [[a, b], [b, c], [c, a]] {
            // The other triangle has the edge in the other direction.
            if !open.remove(&[edge[1], edge[0]]) {
                open.insert(edge);
                order.push(edge);
            }
        }
    }
    order.into_iter().filter(move |edge| open.contains(edge)).map(|edge| edge.map(|v| posed[v as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_one_triangle_are_the_outline() {
        // A square of two triangles, and a skirt of one more.
        let posed = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [8.0, 2.0]].map(DVec2::from);
        let triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 2]];
        let outline: Vec<[DVec2; 2]> = posed_outline(&triangles, 4, &posed).collect();
        assert_eq!(outline, [[0, 1], [1, 2], [2, 3], [3, 0]].map(|edge: [usize; 2]| edge.map(|v| posed[v])));
    }
}
