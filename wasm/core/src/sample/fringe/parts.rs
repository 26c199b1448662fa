//! The parts of an outline that move in the same way.

use glam::DVec2;

use crate::triangulation::Triangulation;

/// Two samples lie on one part of the outline if the ratio of the way along it to their distance is at most this.
const DETOUR: f64 = 3.0;

/// The outline, in the order of its samples.
#[derive(Default)]
pub(in crate::sample) struct Parts {
    pub(in crate::sample) points: Vec<DVec2>,
    /// A vector that leads out of the domain at each sample.
    out: Vec<DVec2>,
    /// The ring of each sample, and the length of the way to it from the ring's first sample.
    at: Vec<(u32, f64)>,
    /// The first sample of each ring, and its length.
    rings: Vec<(usize, f64)>,
}

impl Parts {
    pub(in crate::sample) fn new(mesh: &Triangulation, outline: &[Vec<u32>]) -> Self {
        let mut parts = Self { points: Vec::new(), out: Vec::new(), at: Vec::new(), rings: Vec::new() };
        for (number, ring) in (0..).zip(outline) {
            let first = parts.points.len();
            let mut length = 0.0;
            for i in 0..ring.len() {
                let around = [i + ring.len() - 1, i, i + 1].map(|k| mesh.vertices[ring[k % ring.len()] as usize]);
                let [before, p, after] = around;
                parts.points.push(p);
                parts.out.push(outwards(before, p) + outwards(p, after));
                parts.at.push((number, length));
                length += p.distance(after);
            }
            parts.rings.push((first, length));
        }
        parts
    }

    /// The segments between consecutive samples.
    pub(in crate::sample) fn segments(&self) -> Vec<[usize; 2]> {
        let ends = self.rings.iter().skip(1).map(|&(first, _)| first).chain([self.points.len()]);
        let ring = |(&(first, _), end): (&(usize, f64), usize)| {
            (first..end).map(move |i| [i, if i + 1 == end { first } else { i + 1 }])
        };
        self.rings.iter().zip(ends).flat_map(ring).collect()
    }

    /// Whether two samples move in the same way: the way between them along the outline is hardly longer than their
    /// distance, up to a few pixels, or they lie back to back, like both sides of a hair.
    pub(in crate::sample) fn are_one(&self, a: u32, b: u32, slack: f64) -> bool {
        let [a, b] = [a, b].map(|sample| sample as usize);
        let ((ring, from), (other, to)) = (self.at[a], self.at[b]);
        if ring != other {
            return false;
        }
        let between = self.points[b] - self.points[a];
        let way = (from - to).abs();
        way.min(self.rings[ring as usize].1 - way) <= DETOUR * between.length() + slack
            || self.out[a].dot(between) <= 0.0 && self.out[b].dot(between) >= 0.0
    }
}

/// The unit vector out of the domain on an edge of the outline. The domain lies on the side of `perp`.
fn outwards(a: DVec2, b: DVec2) -> DVec2 {
    -(b - a).normalize_or_zero().perp()
}
