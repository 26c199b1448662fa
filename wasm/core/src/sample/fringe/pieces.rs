//! The triangles of a fringe, cut where they extend across a gap.

use std::collections::{HashMap, HashSet};

use glam::DVec2;

use super::{super::skirt::Skirt, NARROW, parts::Parts, rounded};

/// A corner of the fringe: a position, and the sample that it moves with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Corner {
    place: u32,
    owner: u32,
}

#[derive(Default)]
pub(super) struct Pieces {
    /// The vertices of the samples on the outline. Their positions come first, then those of the skirt in the same
    /// order.
    pub(super) samples: Vec<u32>,
    /// Number of vertices of the mesh.
    pub(super) base: u32,
    /// Tolerance for a detour, in pixels.
    pub(super) slack: f64,
    pub(super) parts: Parts,
    pub(super) places: Vec<DVec2>,
    /// The nearest sample of each position.
    pub(super) owners: Vec<u32>,
    /// The position of the cut between two positions.
    pub(super) cuts: HashMap<[u32; 2], u32>,
    /// Edges without room for a corner: they are next to the mesh or skirt, or another corner is close.
    pub(super) uncut: HashSet<[u32; 2]>,
    pub(super) known: HashMap<Corner, u32>,
    pub(super) skirt: Skirt,
}

impl Pieces {
    /// Records the edges of a triangle that have no room for a corner.
    pub(super) fn note_uncut(&mut self, triangle: [u32; 3], is_border: [bool; 3]) {
        let is_narrow = self.narrow_edges(triangle);
        for k in (0..3).filter(|&k| is_border[k] || is_narrow[k]) {
            self.uncut.insert(edge(triangle[k], triangle[(k + 1) % 3]));
        }
    }

    /// Whether the corner opposite to each edge is close to it.
    fn narrow_edges(&self, triangle: [u32; 3]) -> [bool; 3] {
        let [a, b, c] = triangle.map(|place| rounded(self.places[place as usize]));
        let area = (b - a).perp_dot(c - a);
        [a.distance(b), b.distance(c), c.distance(a)].map(|length| area < NARROW * length)
    }

    /// Adds a triangle between positions, cut where it extends across a gap.
    pub(super) fn add(&mut self, triangle: [u32; 3]) {
        let is_torn = [0, 1, 2].map(|k| self.is_torn(triangle[k], triangle[(k + 1) % 3]));
        let from = |first: Option<usize>| [0, 1, 2].map(|k| self.own(triangle[(first.unwrap_or(0) + k) % 3]));
        match is_torn.iter().filter(|&&torn| torn).count() {
            0 => self.add_whole(from(None)),
            1 => {
                let [u, v, w] = from(is_torn.iter().position(|&torn| torn));
                let [before, after] = [self.cut(u, v), self.cut(v, u)];
                self.push([u, before, w]);
                self.push([after, v, w]);
            }
            2 => {
                // u is alone on its side of the gap.
                let [v, w, u] = from(is_torn.iter().position(|&torn| !torn));
                let [right, left] = [self.cut(u, v), self.cut(u, w)];
                self.push([u, right, left]);
                let [right, left] = [self.cut(v, u), self.cut(w, u)];
                // The other diagonal would lie on an edge.
                let is_split_at_v = if left.place == u.place { right.place == u.place } else { right.place != v.place };
                self.push(if is_split_at_v { [v, w, left] } else { [v, w, right] });
                self.push(if is_split_at_v { [v, left, right] } else { [w, left, right] });
            }
            _ => {
                let corners = from(None);
                let place = self.middle(corners);
                for k in 0..3 {
                    let [u, v, w] = [k, k + 1, k + 2].map(|k| corners[k % 3]);
                    let middle = Corner { place, owner: u.owner };
                    let [right, left] = [self.cut(u, v), self.cut(u, w)];
                    self.push([u, right, middle]);
                    self.push([u, middle, left]);
                }
            }
        }
    }

    /// Adds a triangle of one part. If all its corners are samples, it gets a corner in its middle, because it would
    /// count as a part of the mesh otherwise.
    fn add_whole(&mut self, corners @ [u, v, w]: [Corner; 3]) {
        if corners.iter().any(|corner| corner.place as usize >= self.samples.len()) {
            return self.push(corners);
        }
        // In a narrow triangle the middle is u, moved with another sample.
        let middle = Corner { place: self.middle(corners), owner: v.owner };
        [[u, v], [v, w], [w, u]].into_iter().for_each(|[from, to]| self.push([from, to, middle]));
    }

    fn own(&self, place: u32) -> Corner {
        Corner { place, owner: self.owners[place as usize] }
    }

    fn is_torn(&self, a: u32, b: u32) -> bool {
        !self.parts.are_one(self.owners[a as usize], self.owners[b as usize], self.slack)
    }

    /// The cut between two corners, on the side of the first.
    fn cut(&mut self, from: Corner, to: Corner) -> Corner {
        let ends = edge(from.place, to.place);
        let place = if let Some(&known) = self.cuts.get(&ends) {
            known
        } else {
            let new = self.new_cut(ends);
            self.cuts.insert(ends, new);
            new
        };
        Corner { place, owner: from.owner }
    }

    /// The position between two others that is equally far from their owners.
    fn new_cut(&mut self, ends: [u32; 2]) -> u32 {
        let [a, b] = ends.map(|place| self.places[place as usize]);
        let [own, other] = ends.map(|place| self.parts.points[self.owners[place as usize] as usize]);
        let nearer = |p: DVec2| p.distance_squared(other) - p.distance_squared(own);
        let (from, to) = (nearer(a), nearer(b));
        let fraction = if from > to { (from / (from - to)).clamp(0.0, 1.0) } else { 0.5 };
        let least = if self.uncut.contains(&ends) { 0.5 } else { NARROW / a.distance(b) };
        if fraction < least {
            return ends[0];
        }
        if 1.0 - fraction <= least {
            return ends[1];
        }
        self.new_place(a + fraction * (b - a))
    }

    /// A new position in the middle of a triangle, or one of its corners if it is narrow.
    fn middle(&mut self, corners: [Corner; 3]) -> u32 {
        if self.narrow_edges(corners.map(|corner| corner.place)).contains(&true) {
            return corners[0].place;
        }
        let [a, b, c] = corners.map(|corner| self.places[corner.place as usize]);
        self.new_place((a + b + c) / 3.0)
    }

    fn new_place(&mut self, p: DVec2) -> u32 {
        self.places.push(rounded(p));
        self.places.len() as u32 - 1
    }

    fn push(&mut self, triangle: [Corner; 3]) {
        let [a, b, c] = triangle.map(|corner| corner.place);
        let [p, q, r] = [a, b, c].map(|place| rounded(self.places[place as usize]));
        // A piece that turns over when it is rounded would be drawn twice.
        if a != b && b != c && c != a && (q - p).perp_dot(r - p) > 0.0 {
            let vertices = triangle.map(|corner| self.vertex(corner));
            self.skirt.triangles.push(vertices);
        }
    }

    /// The vertex of a corner. Samples and their vertices of the skirt already have one.
    fn vertex(&mut self, corner: Corner) -> u32 {
        let Self { samples, base, places, known, skirt, .. } = self;
        let count = samples.len() as u32;
        if corner.place == corner.owner {
            return samples[corner.owner as usize];
        }
        if corner.place == corner.owner + count {
            return *base + corner.owner;
        }
        *known.entry(corner).or_insert_with(|| {
            skirt.vertices.push(places[corner.place as usize]);
            skirt.owners.push(samples[corner.owner as usize]);
            *base + skirt.vertices.len() as u32 - 1
        })
    }
}

/// The key of an edge between two positions.
fn edge(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
