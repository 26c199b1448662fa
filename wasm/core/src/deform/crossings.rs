//! Crossings: the regions in which one part of a posed picture covers another.
//!
//! Two triangles cover each other if they overlap in the pose but not at rest. A crossing is a connected set of such
//! pairs: steps across an edge of either triangle lead from one pair to all others. The first triangles of all pairs
//! belong to one part, the second ones to the other. So a whole crossing can be ordered at once.
//!
//! Every crossing contains a triangle on the border of the mesh, from which the search starts. Parts that only cover
//! each other at a fold inside the picture are not found.
//!
//! Cost: a grid over all triangles, and a few tests for each triangle on the border and for each pair of a crossing.

use glam::DVec2;

use super::triangle::{Corners, corners};
use crate::{
    rank::{Rank, sort_ranks},
    rows::Rows,
};

/// Marks a missing neighbour of a triangle.
pub(super) const NONE: u32 = u32::MAX;

/// The neighbours of the triangles of a mesh.
#[derive(Debug, Clone)]
pub(crate) struct Adjacency {
    /// Triangles × 3: the triangles beyond each edge.
    neighbours: Vec<[u32; 3]>,
    /// Triangles with an edge on the border.
    border: Vec<u32>,
}

/// One region in which a part of the picture covers another.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Crossing {
    /// Pairs of overlapping triangles, one from each part.
    pub(crate) pairs: Vec<[u32; 2]>,
    /// Whether the parts swap sides within the region, as in a crumpled picture. No order holds for the whole region.
    pub(crate) is_tangled: bool,
}

/// The mesh at rest and in a pose.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PosedMesh<'a> {
    pub(crate) rest: &'a [DVec2],
    pub(crate) posed: &'a [DVec2],
    pub(crate) triangles: &'a [[u32; 3]],
}

impl Adjacency {
    pub(crate) fn new(triangles: &[[u32; 3]]) -> Self {
        let edges = |(t, &[a, b, c]): (usize, &[u32; 3])| {
            [[a, b], [b, c], [c, a]].into_iter().enumerate().map(move |(k, [from, to])| {
                let ends = i64::from(from.min(to)) << 32 | i64::from(from.max(to));
                ([ends, t as i64], k as u32)
            })
        };
        let mut all: Vec<(Rank, u32)> = triangles.iter().enumerate().flat_map(edges).collect();
        sort_ranks(&mut all);
        let mut neighbours = vec![[NONE; 3]; triangles.len()];
        for pair in all.windows(2) {
            let [([ends, t], k), ([other_ends, u], l)] = [pair[0], pair[1]];
            if ends == other_ends {
                neighbours[t as usize][k as usize] = u as u32;
                neighbours[u as usize][l as usize] = t as u32;
            }
        }
        let has_border = |&t: &u32| neighbours[t as usize].contains(&NONE);
        let border = (0..triangles.len() as u32).filter(has_border).collect();
        Self { neighbours, border }
    }

    /// The crossings of a pose, in an order that depends only on the mesh.
    pub(crate) fn crossings(&self, mesh: PosedMesh<'_>) -> Vec<Crossing> {
        let grid = Grid::new(mesh);
        let mut search = Search { adjacency: self, mesh, known: Vec::new(), found: Vec::new() };
        for &t in &self.border {
            for u in grid.near(corners(mesh.posed, mesh.triangles[t as usize])) {
                search.explore(t, u);
            }
        }
        search.found
    }

    /// The triangles beyond the edges from each corner to the next, [`NONE`] beyond the border.
    pub(super) fn neighbours(&self, t: u32) -> [u32; 3] {
        self.neighbours[t as usize]
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.neighbours[..]) + size_of_val(&self.border[..])
    }
}

/// A pair that a search has found, stored at its lesser triangle.
#[derive(Debug, Clone, Copy)]
struct Known {
    greater: u32,
    crossing: u32,
    /// Whether the greater triangle comes first in the pair.
    is_swapped: bool,
}

struct Search<'a> {
    adjacency: &'a Adjacency,
    mesh: PosedMesh<'a>,
    /// One row for each triangle. Empty until the first pair is found.
    known: Vec<Vec<Known>>,
    found: Vec<Crossing>,
}

impl Search<'_> {
    /// Finds the crossing that a pair belongs to, if it is a new crossing.
    fn explore(&mut self, t: u32, u: u32) {
        if !self.covers(t, u) || self.known(t, u).is_some() {
            return;
        }
        if self.known.is_empty() {
            self.known = vec![Vec::new(); self.mesh.triangles.len()];
        }
        let mut crossing = Crossing { pairs: Vec::new(), is_tangled: false };
        let mut next = Vec::new();
        self.add([t, u], &mut next);
        while let Some([a, b]) = next.pop() {
            crossing.pairs.push([a, b]);
            let beside_a = self.adjacency.neighbours[a as usize].map(|other| [other, b]);
            let beside_b = self.adjacency.neighbours[b as usize].map(|other| [a, other]);
            for [a, b] in beside_a.into_iter().chain(beside_b) {
                if a == NONE || b == NONE {
                    continue;
                }
                match self.known(a, b) {
                    Some(known) => {
                        let is_here = known.crossing as usize == self.found.len();
                        crossing.is_tangled |= is_here && known.is_swapped != (a > b);
                    }
                    None if self.covers(a, b) => self.add([a, b], &mut next),
                    None => {}
                }
            }
        }
        self.found.push(crossing);
    }

    fn add(&mut self, [a, b]: [u32; 2], next: &mut Vec<[u32; 2]>) {
        let known = Known { greater: a.max(b), crossing: self.found.len() as u32, is_swapped: a > b };
        self.known[a.min(b) as usize].push(known);
        next.push([a, b]);
    }

    fn known(&self, a: u32, b: u32) -> Option<Known> {
        self.known.get(a.min(b) as usize)?.iter().find(|known| known.greater == a.max(b)).copied()
    }

    /// Whether two triangles overlap in the pose but not at rest. Triangles with a common vertex belong to the same
    /// part.
    fn covers(&self, a: u32, b: u32) -> bool {
        let [first, second] = [a, b].map(|t| self.mesh.triangles[t as usize]);
        if first.iter().any(|vertex| second.contains(vertex)) {
            return false;
        }
        let both = |points| [corners(points, first), corners(points, second)];
        overlap(both(self.mesh.posed)) && !overlap(both(self.mesh.rest))
    }
}

/// Whether two triangles have a common area, by the separating axis theorem. Degenerate triangles do not have one.
fn overlap([a, b]: [Corners; 2]) -> bool {
    let ([low_a, high_a], [low_b, high_b]) = (bounds(a), bounds(b));
    if (high_a.cmple(low_b) | high_b.cmple(low_a)).any() {
        return false;
    }
    let separates = |from: DVec2, to: DVec2| {
        let normal = (to - from).perp();
        let range = |triangle: Corners| {
            let [p, q, r] = triangle.map(|corner| normal.dot(corner - from));
            (p.min(q).min(r), p.max(q).max(r))
        };
        let ((least_a, most_a), (least_b, most_b)) = (range(a), range(b));
        // NaN overlaps nothing.
        !(most_a > least_b && most_b > least_a)
    };
    let has_separator = |[p, q, r]: Corners| separates(p, q) || separates(q, r) || separates(r, p);
    !has_separator(a) && !has_separator(b)
}

/// A grid whose cells list the triangles that touch them by their bounding boxes.
struct Grid {
    low: DVec2,
    side: f64,
    columns: usize,
    rows: usize,
    items: Rows<u32>,
}

impl Grid {
    fn new(PosedMesh { posed, triangles, .. }: PosedMesh<'_>) -> Self {
        let boxes = || {
            let boxed = |(t, &triangle): (usize, &[u32; 3])| (t as u32, bounds(corners(posed, triangle)));
            triangles.iter().enumerate().map(boxed).filter(|(_, [low, high])| low.is_finite() && high.is_finite())
        };
        let (mut low, mut high, mut extent) = (DVec2::INFINITY, DVec2::NEG_INFINITY, 0.0);
        for (_, [from, to]) in boxes() {
            (low, high) = (low.min(from), high.max(to));
            extent += (to - from).element_sum();
        }
        if low.x > high.x {
            return Self { low, side: 1.0, columns: 0, rows: 0, items: Rows::from_pairs(0, std::iter::empty) };
        }
        // A triangle touches some four cells in the mean, and there are no more cells than triangles.
        let count = triangles.len() as f64;
        let size = high - low;
        let side = (extent / (2.0 * count)).max((size.x * size.y / count).sqrt()).max(size.max_element() / count);
        let side = if side > 0.0 { side } else { 1.0 };
        let [columns, rows] = (size / side).to_array().map(|cells| cells as usize + 1);
        let grid = Self { low, side, columns, rows, items: Rows::from_pairs(0, std::iter::empty) };
        let cells = || boxes().flat_map(|(t, bounds)| grid.cells(bounds).map(move |cell| (cell, t)));
        let items = Rows::from_pairs(columns * rows, cells);
        Self { items, ..grid }
    }

    fn cells(&self, [low, high]: [DVec2; 2]) -> impl Iterator<Item = usize> + use<> {
        let cell = |at: DVec2| ((at - self.low) / self.side).max(DVec2::ZERO).to_array().map(|x| x as usize);
        let ([left, top], [right, bottom]) = (cell(low), cell(high));
        let (columns, right, rows) = (self.columns, (right + 1).min(self.columns), (bottom + 1).min(self.rows));
        (top..rows).flat_map(move |row| (left..right).map(move |column| row * columns + column))
    }

    /// The triangles in the cells that a triangle touches; some may occur more than once.
    fn near(&self, triangle: Corners) -> impl Iterator<Item = u32> + '_ {
        let bounds = bounds(triangle);
        let is_finite = bounds[0].is_finite() && bounds[1].is_finite();
        let cells = is_finite.then(|| self.cells(bounds)).into_iter().flatten();
        cells.flat_map(|cell| self.items.row(cell)).copied()
    }
}

fn bounds([a, b, c]: Corners) -> [DVec2; 2] {
    // In place of `DVec2::min`, which calls a function in WebAssembly.
    let least = |p: DVec2, q: DVec2| DVec2::select(p.cmplt(q), p, q);
    let most = |p: DVec2, q: DVec2| DVec2::select(p.cmpgt(q), p, q);
    [least(least(a, b), c), most(most(a, b), c)]
}
