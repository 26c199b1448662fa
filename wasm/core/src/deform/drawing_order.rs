//! The drawing order of triangles where a posed picture covers itself: from the farthest to the nearest.
//!
//! The depth of handles spreads as motions do: by harmonic weights to the virtual sites (eq. 4), by weights to the
//! vertices (eq. 1). The depth of a triangle is the mean of its corners' depths. Nearer triangles are drawn later;
//! equally deep ones keep the order of the mesh.
//!
//! With only this order, triangles of one limb would show through another limb of similar depth. So each
//! [crossing](super::crossings) is ordered as a whole: the part with the greater mean depth lies in front. At equal
//! depths, the part with more triangles that are drawn later lies in front. All pairs of triangles in crossings are
//! then sorted topologically.
//!
//! A depth buffer keeps only one triangle per pixel, but soft edges need all of them.
//!
//! Cost: linear in the stored weights, a sort of the triangles, and the search for crossings.
//!
//! Limits: triangles are not split where they intersect. A cycle of parts, each in front of the next, has no valid
//! order: one of them shows through. Depths are rounded to [`DEPTH_STEPS`] depth steps, so that rounding does not
//! matter if many triangles are equally deep.

use std::borrow::Cow;

use glam::DVec2;

use super::{
    Bounds,
    crossings::{Adjacency, Crossing, PosedMesh},
};
use crate::{pose::Motion, rows::Rows, weight::SparseWeights};

/// Depth steps from the farthest site to the nearest. The number is even, so that no boundary between steps lies half
/// way.
const DEPTH_STEPS: f64 = 1024.0;
/// Depths that differ by less than this fraction of the greatest are equal: rounding of 32 bits.
const SAME_DEPTH: f64 = 1e-6;

/// The depth of each site.
pub(crate) fn depths(motions: &[Motion]) -> Vec<f64> {
    motions.iter().map(|motion| motion.depth).collect()
}

/// The drawing order of a pose.
#[derive(Debug)]
pub(crate) struct DrawnPose<'a> {
    /// The triangles in drawing order.
    pub(crate) triangles: Cow<'a, [[u32; 3]]>,
    pub(crate) crossings: Vec<Crossing>,
    /// The box around all crossings, in posed pixels.
    pub(crate) crossed: Option<Bounds>,
}

/// The triangles by the depths of a pose.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DepthOrder {
    /// The triangles by depth, as indices; `None` where all are equally deep.
    sorted: Option<ByDepth>,
}

#[derive(Debug, Clone, PartialEq)]
struct ByDepth {
    triangles: Vec<u32>,
    /// From 0 to `range`.
    vertex_depths: Vec<f64>,
    range: f64,
}

impl DepthOrder {
    /// For the `depths` of the sites. A vertex without weights has depth 0.
    pub(crate) fn new(triangles: &[[u32; 3]], weights: &SparseWeights, depths: &[f64]) -> Self {
        let vertices = || 0..weights.len();
        let has_still_vertex = vertices().any(|vertex| weights.row(vertex).next().is_none());
        let all = || depths.iter().copied().chain(has_still_vertex.then_some(0.0));
        let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), d| (low.min(d), high.max(d)));
        let range = high - low;
        // Without any sites the range is below 0.
        if range <= SAME_DEPTH * low.abs().max(high.abs()) {
            return Self { sorted: None };
        }
        let depth = |vertex: usize| {
            let add = |sum: Option<f64>, (site, weight): (usize, f64)| {
                Some(sum.unwrap_or(0.0) + weight * (depths[site] - low))
            };
            weights.row(vertex).fold(None, add).unwrap_or(-low)
        };
        let vertex_depths: Vec<f64> = vertices().map(depth).collect();
        let step = |corners: &[u32; 3]| {
            let sum = sum_of(&vertex_depths, *corners);
            // Weights that are rounded may sum to a little more than 1.
            (sum / (3.0 * range) * DEPTH_STEPS).round().min(DEPTH_STEPS) as usize
        };
        let triangles = sorted(triangles, step);
        Self { sorted: Some(ByDepth { triangles, vertex_depths, range }) }
    }

    /// The triangles of a pose in drawing order.
    pub(crate) fn drawn<'a>(&self, mesh: PosedMesh<'a>, adjacency: &Adjacency) -> DrawnPose<'a> {
        let PosedMesh { triangles, posed, .. } = mesh;
        let by_depth = self.sorted.as_ref().map(|sorted| &sorted.triangles[..]);
        let crossings = adjacency.crossings(mesh);
        let ordered = (!crossings.is_empty()).then(|| self.with_whole_parts(triangles, &crossings)).flatten();
        let drawn = match ordered.as_deref().or(by_depth) {
            Some(order) => Cow::Owned(order.iter().map(|&t| triangles[t as usize]).collect()),
            None => Cow::Borrowed(triangles),
        };
        let corners =
            crossings.iter().flat_map(|crossing| &crossing.pairs).flatten().flat_map(|&t| triangles[t as usize]);
        let crossed: Vec<DVec2> = corners.map(|vertex| posed[vertex as usize]).collect();
        DrawnPose { triangles: drawn, crossed: Bounds::new(&crossed), crossings }
    }

    /// The triangles with each crossing ordered as a whole; `None` if the order by depth already does this.
    fn with_whole_parts(&self, triangles: &[[u32; 3]], crossings: &[Crossing]) -> Option<Vec<u32>> {
        let order = self.order(triangles.len());
        let ranks = ranks(&order);
        let pairs = self.pairs_by(triangles, crossings, &ranks);
        if satisfies(&ranks, &pairs) {
            return None;
        }
        Some(topological(&order, &pairs))
    }

    /// The triangles by depth, as indices.
    pub(crate) fn order(&self, triangles: usize) -> Vec<u32> {
        self.sorted.as_ref().map_or_else(|| (0..triangles as u32).collect(), |sorted| sorted.triangles.clone())
    }

    /// All pairs of triangles in crossings: the one in front, and the one behind it.
    pub(crate) fn pairs(&self, triangles: &[[u32; 3]], crossings: &[Crossing]) -> Vec<[u32; 2]> {
        self.pairs_by(triangles, crossings, &ranks(&self.order(triangles.len())))
    }

    fn pairs_by(&self, triangles: &[[u32; 3]], crossings: &[Crossing], ranks: &[u32]) -> Vec<[u32; 2]> {
        let is_drawn_later = |a: u32, b: u32| ranks[a as usize] > ranks[b as usize];
        let over = |crossing: &Crossing| {
            let first = (!crossing.is_tangled).then(|| self.first_is_in_front(triangles, crossing, &is_drawn_later));
            move |&[a, b]: &[u32; 2]| if first.unwrap_or_else(|| is_drawn_later(a, b)) { [a, b] } else { [b, a] }
        };
        crossings.iter().flat_map(|crossing| crossing.pairs.iter().map(over(crossing))).collect()
    }

    /// Whether the first part of a crossing lies in front.
    fn first_is_in_front(
        &self,
        triangles: &[[u32; 3]],
        crossing: &Crossing,
        is_drawn_later: &impl Fn(u32, u32) -> bool,
    ) -> bool {
        if let Some(ByDepth { vertex_depths, range, .. }) = &self.sorted {
            let depth = |t: u32| sum_of(vertex_depths, triangles[t as usize]);
            let sum: f64 = crossing.pairs.iter().map(|&[a, b]| depth(a) - depth(b)).sum();
            if sum.abs() > SAME_DEPTH * range * crossing.pairs.len() as f64 {
                return sum > 0.0;
            }
        }
        let later = crossing.pairs.iter().filter(|&&[a, b]| is_drawn_later(a, b)).count();
        2 * later >= crossing.pairs.len()
    }
}

fn sum_of(vertex_depths: &[f64], corners: [u32; 3]) -> f64 {
    corners.iter().map(|&vertex| vertex_depths[vertex as usize]).sum()
}

/// The triangles sorted by step, from 0 to [`DEPTH_STEPS`]. Equal steps keep their order. A counting sort: linear.
fn sorted(triangles: &[[u32; 3]], step: impl Fn(&[u32; 3]) -> usize) -> Vec<u32> {
    let steps: Vec<usize> = triangles.iter().map(step).collect();
    let mut next = [0; DEPTH_STEPS as usize + 2];
    for &step in &steps {
        next[step + 1] += 1;
    }
    for step in 1..next.len() {
        next[step] += next[step - 1];
    }
    let mut sorted = vec![0; triangles.len()];
    for (t, step) in (0..).zip(steps) {
        sorted[next[step]] = t;
        next[step] += 1;
    }
    sorted
}

/// The position of each triangle in an order.
pub(crate) fn ranks(order: &[u32]) -> Vec<u32> {
    let mut ranks = vec![0; order.len()];
    for (&t, rank) in order.iter().zip(0..) {
        ranks[t as usize] = rank;
    }
    ranks
}

/// Whether the triangle in front is drawn after the one behind it, for all pairs.
pub(crate) fn satisfies(ranks: &[u32], pairs: &[[u32; 2]]) -> bool {
    pairs.iter().all(|&[front, back]| ranks[front as usize] > ranks[back as usize])
}

/// The triangles in their order, except that each comes after all triangles that lie behind it in a pair. Uses a
/// depth-first search that ignores pairs that close a cycle.
pub(crate) fn topological(order: &[u32], pairs: &[[u32; 2]]) -> Vec<u32> {
    let backs = Rows::from_pairs(order.len(), || pairs.iter().map(|&[front, back]| (front as usize, back)));
    let mut drawn = Vec::with_capacity(order.len());
    let mut is_begun = vec![false; order.len()];
    // Triangles that wait for those behind them, and the next one of these.
    let mut waiting: Vec<(u32, usize)> = Vec::new();
    for &t in order {
        if !is_begun[t as usize] {
            is_begun[t as usize] = true;
            waiting.push((t, 0));
        }
        while let Some((t, next)) = waiting.last_mut() {
            let Some(&back) = backs.row(*t as usize).get(*next) else {
                drawn.push(*t);
                waiting.pop();
                continue;
            };
            *next += 1;
            if !is_begun[back as usize] {
                is_begun[back as usize] = true;
                waiting.push((back, 0));
            }
        }
    }
    drawn
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles of one site each, and one that nothing moves.
    const TRIANGLES: [[u32; 3]; 3] = [[0, 1, 2], [3, 4, 5], [6, 7, 8]];

    fn first_corners(depths: [f64; 2]) -> Vec<u32> {
        let mut weights = SparseWeights::with_capacity(9);
        for vertex in 0..9 {
            weights.push_row((vertex < 6).then_some((vertex / 3, 1.0)).into_iter());
        }
        let points: Vec<DVec2> = (0..9).map(|vertex| DVec2::new(f64::from(vertex), f64::from(vertex % 3))).collect();
        let mesh = PosedMesh { rest: &points, posed: &points, triangles: &TRIANGLES };
        let drawn = DepthOrder::new(&TRIANGLES, &weights, &depths).drawn(mesh, &Adjacency::new(&TRIANGLES));
        drawn.triangles.iter().map(|corners| corners[0]).collect()
    }

    #[test]
    fn nearer_triangles_are_drawn_later_and_still_ones_have_depth_0() {
        assert_eq!(first_corners([1.0, -1.0]), [3, 6, 0]);
        assert_eq!(first_corners([-2.0, -1.0]), [0, 3, 6]);
        assert_eq!(first_corners([3.0, 2.0]), [6, 3, 0]);
    }

    #[test]
    fn equal_depths_keep_the_order_of_the_mesh() {
        assert_eq!(first_corners([0.0, 0.0]), [0, 3, 6]);
        assert_eq!(first_corners([5.0, 5.0]), [6, 0, 3]);
        assert_eq!(first_corners([1e-9, 1e-9 * (1.0 + 1e-7)]), [6, 0, 3]);
    }
}
