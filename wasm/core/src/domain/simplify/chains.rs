//! Rings as doubly linked chains, from which points are dropped.

use glam::DVec2;
use robust::{Coord, orient2d};

use super::point_grid::PointGrid;
use crate::{domain::ring::Ring, min_entry::MinEntry, segment::segment_distance};

/// Costs are rounded to multiples of this many pixels, above rounding errors and far below the tolerance. Costs are
/// then the same in a mirror image.
const COST_STEP: f64 = 1.0 / (1_u64 << 30) as f64;

/// A point that may be dropped, keyed by its cost. The item has its remoteness, its index among all points, and its
/// stamp.
pub(super) type Candidate = MinEntry<(Remoteness, usize, u32)>;

/// Squared distance from the centre of the ring's box, as bits. The bits of positive numbers have the same order as the
/// numbers.
pub(super) type Remoteness = u64;

/// All rings as doubly linked chains over the original points.
pub(super) struct Chains {
    points: Vec<DVec2>,
    /// The first point and the length of each point's ring.
    ring: Vec<(usize, usize)>,
    prev: Vec<usize>,
    next: Vec<usize>,
    alive: Vec<bool>,
    /// Number of changes around each point. A candidate with an older stamp is outdated.
    stamp: Vec<u32>,
    /// The last round in which each point was a candidate, and its stamp in that round.
    tied: Vec<(u32, u32)>,
    /// Number of points that remain of each ring, indexed by the ring's first point.
    remaining: Vec<usize>,
    remoteness: Vec<Remoteness>,
    /// Maximum distance of an original point from the outline, in pixels.
    tolerance: f64,
    /// Number of original points from each point to the end of the exactly straight run that begins there: 1 or more.
    straight: Vec<usize>,
    grid: PointGrid,
}

impl Chains {
    pub(super) fn new(rings: &[Ring], tolerance: f64) -> Self {
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
        let mut remaining = vec![0; n];
        for &(start, len) in &ring {
            remaining[start] = len;
        }
        let (alive, stamp, tied) = (vec![true; n], vec![0; n], vec![(0, 0); n]);
        Self { points, ring, prev, next, alive, stamp, tied, remaining, remoteness, tolerance, straight, grid }
    }

    /// Number of original points.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// The candidate for dropping a point. Returns `None` if it was dropped already, or if the cost exceeds the
    /// tolerance.
    pub(super) fn candidate(&self, at: usize) -> Option<Candidate> {
        let cost = if self.alive[at] { self.cost(self.prev[at], self.next[at], 1) } else { None };
        cost.map(|key| MinEntry { key, item: (self.remoteness[at], at, self.stamp[at]) })
    }

    /// Whether the surroundings of the point have not changed since the candidate was created.
    pub(super) fn is_current(&self, &MinEntry { item: (_, at, stamp), .. }: &Candidate) -> bool {
        self.alive[at] && self.stamp[at] == stamp
    }

    /// Marks a candidate as one of a round. Neighbours in one round are dropped together.
    pub(super) fn mark(&mut self, &MinEntry { item: (_, at, stamp), .. }: &Candidate, round: u32) {
        self.tied[at] = (round, stamp);
    }

    /// Drops a point if no other point is in the way, together with a neighbour of the same round.
    ///
    /// Such neighbours lie on both sides of an axis of symmetry. They are dropped or kept together, and more than two
    /// in a row are kept. Returns the points on both sides of the dropped ones.
    pub(super) fn drop_with_neighbour(&mut self, candidate: &Candidate, round: u32) -> Option<[usize; 2]> {
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
            let is_other =
                |other: usize| self.alive[other] && other != from && other != to && !dropped.contains(&other);
            // Dropping a point of a straight run does not move the outline.
            is_straight(triangle) || !self.grid.any_in_triangle(triangle, is_other, &self.points)
        });
        if !is_clear {
            return None;
        }
        for at in dropped {
            self.remove(at);
        }
        Some([from, to])
    }

    /// The cost of replacing all points between two points by a chord. `dropped` of them still exist.
    ///
    /// Returns `None` beyond the tolerance, or if fewer than three points of the ring would remain.
    fn cost(&self, from: usize, to: usize, dropped: usize) -> Option<f64> {
        let (start, len) = self.ring[from];
        if self.remaining[start] < 3 + dropped {
            return None;
        }
        let (a, b) = (self.points[from], self.points[to]);
        let mut cost = 0.0_f64;
        let last = (to + len - from) % len - 1;
        let mut steps = 1;
        while steps <= last {
            let i = start + (from - start + steps) % len;
            cost = cost.max((segment_distance(self.points[i], a, b) / COST_STEP).round() * COST_STEP);
            if cost > self.tolerance {
                return None;
            }
            // No point of a straight run is farther from the chord than both its ends, so skip to its end.
            steps = if steps < last { (steps + self.straight[i]).min(last) } else { steps + 1 };
        }
        Some(cost)
    }

    fn remove(&mut self, at: usize) {
        let (prev, next) = (self.prev[at], self.next[at]);
        self.next[prev] = next;
        self.prev[next] = prev;
        self.alive[at] = false;
        self.remaining[self.ring[at].0] -= 1;
        self.stamp[prev] += 1;
        self.stamp[next] += 1;
    }

    /// The remaining points of each ring.
    pub(super) fn rings(&self, originals: &[Ring]) -> Vec<Ring> {
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

/// Returns for each point of a ring the number of points to the end of the exactly straight run that begins there.
fn straight_runs(ring: &[DVec2]) -> Vec<usize> {
    let n = ring.len();
    let mut runs = vec![1; n];
    // Go around twice, as a run at the last points may continue at the first ones.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_runs_do_not_depend_on_the_first_point() {
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
        }
        assert_eq!(straight_runs(&[DVec2::ZERO, DVec2::X, 3.0 * DVec2::X]), [2, 1, 1]);
    }
}
