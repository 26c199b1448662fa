//! A bone or a ring of a held outline, as a polyline with sites on it (section V-D).
//!
//! Cost: a pass over the corners, or over the sites, for each call.

use glam::DVec2;

use super::{SiteKind, TIE};
use crate::{domain::corners_between, segment::nearest_on_segment};

/// Greatest gap between two sites, relative to the reach of each.
const MAX_GAP: f64 = 0.5;
/// A corner of a held outline gets a site if the cosine of its turning angle is below this: more than 20°.
const SHARP_COSINE: f64 = 0.94;

/// The corners of a held ring that get a site, by their indices.
pub(crate) fn sharp_corners(ring: &[DVec2]) -> impl Iterator<Item = usize> + '_ {
    let is_sharp =
        |[before, at, after]: [DVec2; 3]| (at - before).normalize().dot((after - at).normalize()) < SHARP_COSINE;
    corners_between(ring).enumerate().filter(move |&(_, corner)| is_sharp(corner)).map(|(at, _)| at)
}

/// A polyline with sites on it. Positions on it are arc lengths from its first corner, in pixels.
pub(super) struct Chain {
    pub(super) kind: SiteKind,
    corners: Vec<DVec2>,
    /// The arc length at each corner, and at the end.
    lengths: Vec<f64>,
    closed: bool,
    /// Arc length and index of each site, ascending.
    pub(super) sites: Vec<(f64, usize)>,
}

impl Chain {
    pub(super) fn new(kind: SiteKind, corners: Vec<DVec2>, closed: bool) -> Self {
        let n = corners.len();
        let edges = if closed { n } else { n - 1 };
        let mut lengths = vec![0.0];
        for i in 0..edges {
            lengths.push(lengths[i] + corners[i].distance(corners[(i + 1) % n]));
        }
        Self { kind, corners, lengths, closed, sites: Vec::new() }
    }

    fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// The point at an arc length.
    pub(super) fn at(&self, length: f64) -> DVec2 {
        let edge = self.lengths[1..self.lengths.len() - 1].partition_point(|&end| end <= length);
        let (from, to) = (self.corners[edge], self.corners[(edge + 1) % self.corners.len()]);
        from.lerp(to, (length - self.lengths[edge]) / (self.lengths[edge + 1] - self.lengths[edge]))
    }

    /// Arc lengths of the first sites: the middle of a bone, or the sharp corners of a ring.
    pub(super) fn initial_sites(&self) -> Vec<f64> {
        if !self.closed {
            return vec![self.length() / 2.0];
        }
        let sharp: Vec<f64> = sharp_corners(&self.corners).map(|i| self.lengths[i]).collect();
        if sharp.is_empty() { self.extremes() } else { sharp }
    }

    /// Arc lengths of the leftmost, rightmost, uppermost and lowest corners. A mirror image has the same ones.
    fn extremes(&self) -> Vec<f64> {
        let [low, high] = [DVec2::min, DVec2::max].map(|of| self.corners.iter().copied().fold(self.corners[0], of));
        let slack = TIE * (high - low).max_element();
        let is_extreme = |p: DVec2| (p - low).min(high - p).min_element() <= slack;
        self.corners.iter().zip(&self.lengths).filter(|(p, _)| is_extreme(**p)).map(|(_, &length)| length).collect()
    }

    /// The arc length nearest to `length` that keeps a third of the first and of the last gap free.
    pub(super) fn clear_of_ends(&self, length: f64) -> f64 {
        if self.closed {
            return length;
        }
        let free = [self.sites[0].0, self.length() - self.sites[self.sites.len() - 1].0];
        length.clamp(free[0] / 3.0, self.length() - free[1] / 3.0)
    }

    /// The straight distance from a point, and the arc lengths of the nearest points of the chain. Tied points at most
    /// `apart` from each other count as one.
    pub(super) fn nearest(&self, p: DVec2, apart: f64) -> (f64, Vec<f64>) {
        let n = self.corners.len();
        let feet: Vec<(DVec2, f64)> = (0..self.lengths.len() - 1)
            .map(|edge| {
                let (a, b) = (self.corners[edge], self.corners[(edge + 1) % n]);
                let foot = nearest_on_segment(p, a, b);
                (foot, self.lengths[edge] + foot.distance(a))
            })
            .collect();
        let least = feet.iter().map(|(foot, _)| foot.distance(p)).fold(f64::INFINITY, f64::min);
        let mut kept: Vec<(DVec2, f64)> = Vec::new();
        for (foot, length) in feet {
            let is_new = || kept.iter().all(|(known, _)| known.distance(foot) > apart);
            if foot.distance(p) <= least * (1.0 + TIE) && is_new() {
                kept.push((foot, length));
            }
        }
        (least, kept.into_iter().map(|(_, length)| length).collect())
    }

    /// Whether a site lies less than `within` away along the chain.
    pub(super) fn has_site_near(&self, length: f64, within: f64) -> bool {
        self.sites.iter().any(|&(known, _)| (known - length).abs() < within)
    }

    /// Arc lengths of new sites, one in each gap that is too large for the sites at its ends. `reach` returns the
    /// greatest support radius of a site.
    pub(super) fn missing_sites(&self, reach: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut missing = Vec::new();
        let limit = |i: usize, j: usize| MAX_GAP * reach(self.sites[i].1).min(reach(self.sites[j].1));
        let last = self.sites.len() - 1;
        for i in 0..last {
            let (from, to) = (self.sites[i].0, self.sites[i + 1].0);
            if to - from > limit(i, i + 1) {
                missing.push(f64::midpoint(from, to));
            }
        }
        let (first, end) = (self.sites[0].0, self.length() - self.sites[last].0);
        if self.closed {
            if end + first > limit(0, last) {
                let middle = self.sites[last].0 + (end + first) / 2.0;
                missing.push(if middle < self.length() { middle } else { middle - self.length() });
            }
        } else {
            if 2.0 * first > limit(0, 0) {
                missing.push(first / 3.0);
            }
            if 2.0 * end > limit(last, last) {
                missing.push(self.length() - end / 3.0);
            }
        }
        missing
    }
}
