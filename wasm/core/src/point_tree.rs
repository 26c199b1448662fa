//! The points nearest to a position (section V-B): a k-d tree in one array. The middle of each range is the root of its
//! subtree.
//!
//! Cost: O(n log n) to build, about O(log n) for a query of a few points.

use glam::DVec2;

/// A permutation of the points into a tree, split by x and y alternately.
#[derive(Debug, Clone)]
pub(crate) struct Tree {
    order: Vec<u32>,
}

impl Tree {
    pub(crate) fn new(points: &[DVec2]) -> Self {
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        arrange(points, &mut order, 0);
        Self { order }
    }

    /// The `count` points nearest to a position, ascending by squared distance, then by index.
    pub(crate) fn nearest(&self, points: &[DVec2], p: DVec2, count: usize) -> Vec<(f64, u32)> {
        let mut found = Vec::with_capacity(count + 1);
        search(points, &self.order, 0, (p, count), &mut found);
        found
    }
}

fn arrange(points: &[DVec2], order: &mut [u32], axis: usize) {
    if order.len() < 2 {
        return;
    }
    let coordinate = |point: u32| points[point as usize][axis];
    let middle = order.len() / 2;
    let (low, _, high) =
        order.select_nth_unstable_by(middle, |&a, &b| coordinate(a).total_cmp(&coordinate(b)).then(a.cmp(&b)));
    arrange(points, low, 1 - axis);
    arrange(points, high, 1 - axis);
}

fn search(points: &[DVec2], order: &[u32], axis: usize, (p, count): (DVec2, usize), found: &mut Vec<(f64, u32)>) {
    let middle = order.len() / 2;
    let Some(&root) = order.get(middle) else { return };
    let candidate = (p.distance_squared(points[root as usize]), root);
    let rank = found.partition_point(|known| *known < candidate);
    if rank < count {
        found.insert(rank, candidate);
        found.truncate(count);
    }
    let beyond = p[axis] - points[root as usize][axis];
    let (low, high) = (&order[..middle], &order[middle + 1..]);
    let (near, far) = if beyond < 0.0 { (low, high) } else { (high, low) };
    search(points, near, 1 - axis, (p, count), found);
    if found.len() < count || found.last().is_some_and(|&(square, _)| beyond * beyond <= square) {
        search(points, far, 1 - axis, (p, count), found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_same_points_as_brute_force() {
        let at = |i: usize| DVec2::new((0.754_877 * i as f64).fract(), (0.569_840 * i as f64).fract() * 0.1);
        // Some points lie on one line, and some coincide.
        let points: Vec<DVec2> = (0..200).map(|i| if i % 3 == 0 { at(i / 6) * DVec2::X } else { at(i) }).collect();
        let tree = Tree::new(&points);
        for p in (0..50).map(|i| at(i * 7) * 1.2) {
            let mut all: Vec<(f64, u32)> =
                points.iter().enumerate().map(|(i, q)| (p.distance_squared(*q), i as u32)).collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            assert_eq!(tree.nearest(&points, p, 9), all[..9]);
        }
    }
}
