//! Simplification of the outline that preserves its topology.
//!
//! A point is dropped if the chord that replaces it stays within [`TOLERANCE`] of every original point, and if the triangle
//! that the outline sweeps contains no other point of any ring. The second condition makes every step a deformation without
//! contact, so rings stay simple and disjoint: gaps are not bridged, thin parts not cut.
//!
//! Of two points with the same cost, the one nearer to the centre of its ring's box goes first; points at the same distance
//! go in one round. So a symmetric outline stays symmetric, wherever a ring begins and in either orientation.
//!
//! Cost: usually O(n log n) for n contour points, with a grid over the points: each step visits the original points under its
//! chord (only the ends of exactly straight runs) and the cells that its triangle touches. A contour that is nowhere exactly
//! straight, yet within the tolerance of a chord over thousands of points, costs that many visits for each of them.

use std::collections::BinaryHeap;

use glam::DVec2;
use robust::{Coord, orient2d};

use super::Ring;
use crate::{min_entry::MinEntry, segment::segment_distance};

/// Greatest distance of an original point from the simplified outline, in pixels. Below the half pixel that is visible on an
/// edge; a disc of radius 100 px keeps some 56 corners.
const TOLERANCE: f64 = 0.35;

/// Costs are rounded to this many pixels, above rounding errors and far below the tolerance: so they are the same in a mirror
/// image.
const GRAIN: f64 = 1.0 / (1_u64 << 30) as f64;

/// Simplifies rings, which must be simple and disjoint, and stay so.
pub(super) fn simplified(rings: &[Ring]) -> Vec<Ring> {
    let mut chains = Chains::new(rings);
    let mut queue: BinaryHeap<Candidate> = (0..chains.points.len()).filter_map(|at| chains.candidate(at)).collect();
    let mut rounds = 0;
    while let Some(first) = queue.pop() {
        let is_tied = |other: &Candidate| other.key == first.key && other.item.0 == first.item.0;
        let mut round = vec![first];
        while queue.peek().is_some_and(is_tied) {
            round.extend(queue.pop());
        }
        rounds += 1;
        round.retain(|candidate| chains.is_current(candidate));
        for &Candidate { item: (_, at, stamp), .. } in &round {
            chains.tied[at] = (rounds, stamp);
        }
        let mut around = Vec::new();
        for candidate in &round {
            if chains.is_current(candidate) {
                around.extend(chains.drop_with_neighbour(candidate, rounds));
            }
        }
        queue.extend(around.into_iter().flatten().filter_map(|at| chains.candidate(at)));
    }
    chains.rings(rings)
}

/// A point that may be dropped, keyed by its cost; then its remoteness, its index among all points, and its stamp.
type Candidate = MinEntry<(Remoteness, usize, u32)>;

/// Squared distance from the centre of the ring's box, as bits, which are ordered as the numbers are.
type Remoteness = u64;

/// All rings as doubly linked chains over the original points.
struct Chains {
    points: Vec<DVec2>,
    /// The first point and the length of each point's ring.
    ring: Vec<(usize, usize)>,
    prev: Vec<usize>,
    next: Vec<usize>,
    alive: Vec<bool>,
    /// Number of changes around each point, to recognise outdated candidates.
    stamp: Vec<u32>,
    /// The last round of each point, and its stamp then.
    tied: Vec<(u32, u32)>,
    left: Vec<usize>,
    remoteness: Vec<Remoteness>,
    /// Number of original points from each point to the end of the exactly straight run that begins there: 1 or more.
    straight: Vec<usize>,
    grid: PointGrid,
}

impl Chains {
    fn new(rings: &[Ring]) -> Self {
        let points: Vec<DVec2> = rings.iter().flatten().copied().collect();
        let (mut ring, mut prev, mut next, mut remoteness) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut straight = Vec::with_capacity(points.len());
        let mut start = 0;
        for points in rings {
            let n = points.len();
            ring.extend((0..n).map(|_| (start, n)));
            prev.extend((0..n).map(|i| start + (i + n - 1) % n));
            next.extend((0..n).map(|i| start + (i + 1) % n));
            let middle = middle(points);
            remoteness.extend(points.iter().map(|p| p.distance_squared(middle).to_bits()));
            straight.extend(straight_runs(points));
            start += n;
        }
        let n = points.len();
        let grid = PointGrid::new(&points);
        // Indexed by a ring's first point.
        let mut left = vec![0; n];
        for &(start, len) in &ring {
            left[start] = len;
        }
        let (alive, stamp, tied) = (vec![true; n], vec![0; n], vec![(0, 0); n]);
        Self { points, ring, prev, next, alive, stamp, tied, left, remoteness, straight, grid }
    }

    /// The candidate for dropping a point, if it is still there and the cost is within the tolerance.
    fn candidate(&self, at: usize) -> Option<Candidate> {
        let cost = if self.alive[at] { self.cost(self.prev[at], self.next[at], 1) } else { None };
        cost.map(|key| MinEntry { key, item: (self.remoteness[at], at, self.stamp[at]) })
    }

    /// Whether nothing around the point has changed since.
    fn is_current(&self, &MinEntry { item: (_, at, stamp), .. }: &Candidate) -> bool {
        self.alive[at] && self.stamp[at] == stamp
    }

    /// Drops a point if nothing is in the way, together with a tied neighbour, as on both sides of an axis: they go or stay
    /// together, and more than two in a row stay. Returns the points on both sides of those dropped.
    fn drop_with_neighbour(&mut self, candidate: &Candidate, round: u32) -> Option<[usize; 2]> {
        let (_, at, _) = candidate.item;
        let is_tied = |other: usize| self.alive[other] && self.tied[other] == (round, self.stamp[other]);
        let mut dropped = vec![at];
        let (mut from, mut to) = (self.prev[at], self.next[at]);
        while dropped.len() < 3 && is_tied(from) {
            dropped.insert(0, from);
            from = self.prev[from];
        }
        while dropped.len() < 3 && is_tied(to) {
            dropped.push(to);
            to = self.next[to];
        }
        if dropped.len() > 2 {
            return None;
        }
        self.cost(from, to, dropped.len())?;
        let is_clear = dropped.iter().zip(dropped.iter().skip(1).chain([&to])).all(|(&at, &next)| {
            let triangle = [from, at, next].map(|i| self.points[i]);
            let counts = |other: usize| self.alive[other] && other != from && other != to && !dropped.contains(&other);
            // On a straight run the outline does not move.
            is_straight(triangle) || !self.grid.any_in_triangle(triangle, counts, &self.points)
        });
        if !is_clear {
            return None;
        }
        for at in dropped {
            self.remove(at);
        }
        Some([from, to])
    }

    /// The cost of a chord in place of all points between two, `dropped` of which are left, if it is within the tolerance and
    /// at least three points of the ring remain.
    fn cost(&self, from: usize, to: usize, dropped: usize) -> Option<f64> {
        let (start, len) = self.ring[from];
        if self.left[start] < 3 + dropped {
            return None;
        }
        let (a, b) = (self.points[from], self.points[to]);
        let mut cost = 0.0_f64;
        let last = (to + len - from) % len - 1;
        let mut steps = 1;
        while steps <= last {
            let i = start + (from - start + steps) % len;
            cost = cost.max((segment_distance(self.points[i], a, b) / GRAIN).round() * GRAIN);
            if cost > TOLERANCE {
                return None;
            }
            // No point of a straight run is farther from the chord than both its ends.
            steps = if steps < last { (steps + self.straight[i]).min(last) } else { steps + 1 };
        }
        Some(cost)
    }

    fn remove(&mut self, at: usize) {
        let (prev, next) = (self.prev[at], self.next[at]);
        self.next[prev] = next;
        self.prev[next] = prev;
        self.alive[at] = false;
        self.left[self.ring[at].0] -= 1;
        self.stamp[prev] += 1;
        self.stamp[next] += 1;
    }

    fn rings(&self, originals: &[Ring]) -> Vec<Ring> {
        let mut start = 0;
        let mut rings = Vec::with_capacity(originals.len());
        for original in originals {
            let range = start..start + original.len();
            rings.push(range.filter(|&i| self.alive[i]).map(|i| self.points[i]).collect());
            start += original.len();
        }
        rings
    }
}

/// For each point of a ring the number of points to the end of the exactly straight run that begins there.
fn straight_runs(ring: &[DVec2]) -> Vec<usize> {
    let n = ring.len();
    let mut runs = vec![1; n];
    // Twice around, as the run at the last points may continue at the first.
    for i in (0..2 * n).rev() {
        let [a, b, c] = [i, i + 1, i + 2].map(|i| i % n);
        runs[a] = if is_straight([a, b, c].map(|i| ring[i])) { (runs[b] + 1).min(n) } else { 1 };
    }
    runs
}

/// Whether three points lie on a straight line in this order, without rounding.
fn is_straight([a, b, c]: [DVec2; 3]) -> bool {
    let [p, q, r] = [a, b, c].map(|DVec2 { x, y }| Coord { x, y });
    (b - a).dot(c - b) > 0.0 && orient2d(p, q, r) == 0.0
}

/// The centre of the box around a ring.
fn middle(ring: &[DVec2]) -> DVec2 {
    let (low, high) =
        ring.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    low.midpoint(high)
}

/// Points in square cells, each a linked list.
struct PointGrid {
    low: DVec2,
    columns: usize,
    head: Vec<u32>,
    next: Vec<u32>,
}

const CELL_PX: f64 = 4.0;
/// Tolerance of the triangle test: in pixels around the triangle's box, and in square pixels for twice the area over each
/// edge. Far above rounding, far below the tolerance of the outline.
const TOUCHING: f64 = 1e-6;
const END: u32 = u32::MAX;

impl PointGrid {
    fn new(points: &[DVec2]) -> Self {
        let low = points.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
        let high = points.iter().fold(DVec2::NEG_INFINITY, |high, &p| high.max(p));
        let cells = ((high - low) / CELL_PX).floor() + 1.0;
        let columns = cells.x as usize;
        let mut grid =
            Self { low, columns, head: vec![END; columns * cells.y as usize], next: vec![END; points.len()] };
        for (i, &p) in points.iter().enumerate() {
            let (x, y) = grid.cell(p);
            let cell = y * grid.columns + x;
            grid.next[i] = grid.head[cell];
            grid.head[cell] = i as u32;
        }
        grid
    }

    fn cell(&self, p: DVec2) -> (usize, usize) {
        let cell = (p - self.low) / CELL_PX;
        (cell.x as usize, cell.y as usize)
    }

    /// Whether a point accepted by `counts` lies in a closed triangle. Row by row, as such triangles are long and thin.
    fn any_in_triangle(&self, triangle: [DVec2; 3], counts: impl Fn(usize) -> bool, points: &[DVec2]) -> bool {
        let [a, b, c] = triangle;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let ((_, first), (_, last)) = (self.cell(low), self.cell(high));
        (first..=last).any(|row| {
            let top = self.low.y + row as f64 * CELL_PX;
            let Some((left, right)) = extent(triangle, top, top + CELL_PX) else { return false };
            let column = |x: f64| self.cell(DVec2::new(x, top)).0.min(self.columns - 1);
            (column(left)..=column(right)).any(|column| {
                let mut i = self.head[row * self.columns + column];
                while i != END {
                    if counts(i as usize) && in_triangle(points[i as usize], triangle) {
                        return true;
                    }
                    i = self.next[i as usize];
                }
                false
            })
        })
    }
}

/// Least and greatest x of a triangle between two heights, if it reaches them.
fn extent(triangle: [DVec2; 3], top: f64, bottom: f64) -> Option<(f64, f64)> {
    let mut extent: Option<(f64, f64)> = None;
    for (a, b) in super::edges(&triangle) {
        let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
        if b.y < top || a.y > bottom {
            continue;
        }
        // The part of the edge between the heights; a level edge lies there completely.
        let at = |y: f64| a.lerp(b, ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0)).x;
        let (p, q) = if a.y == b.y { (a.x, b.x) } else { (at(top), at(bottom)) };
        let (left, right) = extent.unwrap_or((p, p));
        extent = Some((left.min(p).min(q), right.max(p).max(q)));
    }
    extent.map(|(left, right)| (left - TOUCHING, right + TOUCHING))
}

/// Whether a point lies in a triangle or touches it.
fn in_triangle(p: DVec2, triangle: [DVec2; 3]) -> bool {
    let [a, b, c] = triangle;
    let beside = p.cmplt(a.min(b).min(c) - TOUCHING).any() || p.cmpgt(a.max(b).max(c) + TOUCHING).any();
    let sides = [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)];
    !beside && (sides.iter().all(|&s| s >= -TOUCHING) || sides.iter().all(|&s| s <= TOUCHING))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_edge_keeps_its_ends_alone() {
        let mut ring: Ring = (0..200).map(|i| DVec2::new(f64::from(i), f64::from(i) / 2.0)).collect();
        ring.push(DVec2::new(0.0, 100.0));
        assert_eq!(simplified(&[ring])[0].len(), 3);
    }

    #[test]
    fn straight_runs_are_known_by_their_ends_wherever_the_ring_begins() {
        let square = |i: i32| match i.rem_euclid(40) {
            i @ 0..10 => DVec2::new(f64::from(i), 0.0),
            i @ 10..20 => DVec2::new(10.0, f64::from(i - 10)),
            i @ 20..30 => DVec2::new(f64::from(30 - i), 10.0),
            i => DVec2::new(0.0, f64::from(40 - i)),
        };
        for first in [0, 3, 19] {
            let ring: Ring = (first..first + 40).map(square).collect();
            let expected: Vec<usize> = (first..first + 40).map(|i| 10 - i as usize % 10).collect();
            assert_eq!(straight_runs(&ring), expected);
            assert_eq!(simplified(&[ring])[0].len(), 4);
        }
        assert_eq!(straight_runs(&[DVec2::ZERO, DVec2::X, 3.0 * DVec2::X]), [2, 1, 1]);
    }

    #[test]
    fn very_many_equal_rings_and_very_long_edges_take_no_time() {
        // A search for each point among all tied ones, or among all points of an edge for each that is dropped, would take
        // minutes.
        let diamond = |i: i32| -> Ring {
            let middle = DVec2::new(f64::from(i % 100), f64::from(i / 100)) * 20.0;
            let side = |from: DVec2, to: DVec2| (0..6).map(move |k| middle + from.lerp(to, f64::from(k) / 6.0) * 8.0);
            let corners = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y];
            (0..4).flat_map(|k| side(corners[k], corners[(k + 1) % 4])).collect()
        };
        let rings: Vec<Ring> = (0..10_000).map(diamond).collect();
        assert!(simplified(&rings).iter().all(|ring| ring.len() == 4));
        let edge: Ring = (0..60_000).map(|i| DVec2::new(f64::from(i), 0.0)).chain([DVec2::new(0.0, 50.0)]).collect();
        assert_eq!(simplified(&[edge])[0].len(), 3);
    }

    #[test]
    fn two_rings_a_hair_apart_stay_apart() {
        let bump = |y: f64| -> Ring {
            let top = (0..100).map(|i| DVec2::new(f64::from(i), y + 0.3 * f64::from(i % 2)));
            top.chain([DVec2::new(99.0, y + 50.0), DVec2::new(0.0, y + 50.0)]).collect()
        };
        // The lower edge of the first ring is straight; the teeth of the second come within 0.1 px of it.
        let rings = simplified(&[bump(0.0), bump(50.1)]);
        let lowest = rings[0].iter().map(|p| p.y).fold(f64::MIN, f64::max);
        let highest = rings[1].iter().map(|p| p.y).fold(f64::MAX, f64::min);
        assert!(lowest < highest);
        assert!(rings[1].len() < 60);
    }
}
