//! The shortest paths from a site to the three corners of a piece, and the bounds that follow from them.
//!
//! Cost: three queries of the site's field.

use std::collections::HashMap;

use glam::DVec2;

use super::super::TIE;
use crate::{
    distance::{DistanceField, NavTriangle, PathEnd},
    min_max::{fast_max, fast_min},
};

/// The path to each corner; `None` without a path within the field's bound.
#[derive(Debug, Clone, Copy)]
pub(super) struct CornerPaths(pub(super) [Option<PathEnd>; 3]);

impl CornerPaths {
    pub(super) fn new(field: &DistanceField, corners: &[DVec2; 3], nav_triangles: &[NavTriangle; 3]) -> Self {
        let mut field = field.cached_lookup();
        Self([0, 1, 2].map(|k| field.path_end(nav_triangles[k], corners[k])))
    }

    /// The paths to the corners of a part. Indices 0 to 2 are corners of the whole, with paths `outer`. Indices 3 to 5
    /// are the midpoints of its edges, with paths `inner`.
    pub(super) fn of_part(outer: &Self, inner: &Self, part: [usize; 3]) -> Self {
        Self(part.map(|at| [outer, inner][at / 3].0[at % 3]))
    }

    /// The distance of a corner, infinite without a path.
    pub(super) fn distance(&self, corner: usize) -> f64 {
        self.0[corner].map_or(f64::INFINITY, |path| path.distance)
    }

    /// The common pseudo-source of all paths; `None` if they differ. With a common pseudo-source, distances in the
    /// piece form one cone.
    pub(super) fn pseudo_source(&self) -> Option<DVec2> {
        let [a, b, c] = self.0.map(|path| path.map(|path| path.pseudo_source));
        if a == b && b == c { a } else { None }
    }

    /// The minimum of the known distances and these.
    pub(super) fn nearer(&self, known: &[f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| fast_min(known[k], self.distance(k)))
    }

    /// Whether the site may be the nearest somewhere in the piece, as distances are 1-Lipschitz. `nearest` are the
    /// distances of the corners to their nearest sites, and `detours` those of the piece.
    pub(super) fn may_enter(&self, nearest: &[f64; 3], detours: &Detours) -> bool {
        (0..3).all(|i| (0..3).all(|j| self.distance(i) <= nearest[j] + detours.0[i][j]))
    }
}

/// For each two corners, the length of the longest way from one to the other by a point of the piece, in two straight
/// lines.
///
/// In a sliver, the way from end to end is hardly longer than its edge. So a site behind one end is compared with the
/// sites at the other end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Detours([[f64; 3]; 3]);

impl Detours {
    /// `lengths` are the lengths of the edges from each corner to the next.
    pub(super) fn new(lengths: [f64; 3]) -> Self {
        // The sum of two distances is convex, so it is greatest at a corner: at the third one.
        let perimeter: f64 = lengths.iter().sum();
        let way = |i: usize, j: usize| match (j + 3 - i) % 3 {
            0 => 2.0 * fast_max(lengths[i], lengths[(i + 2) % 3]),
            1 => perimeter - lengths[i],
            _ => perimeter - lengths[j],
        };
        Self([0, 1, 2].map(|i| [0, 1, 2].map(|j| way(i, j) * (1.0 + TIE))))
    }
}

/// The nearest site for each triple of pseudo-sources on the outline. Any other site behind the same three is farther
/// everywhere in the piece.
#[derive(Debug, Default)]
pub(super) struct Leaders(HashMap<[[u64; 2]; 3], CornerPaths>);

impl Leaders {
    pub(super) fn of(all: &[CornerPaths]) -> Self {
        let length = |paths: &CornerPaths| paths.0.iter().flatten().map(|path| path.offset).sum::<f64>();
        let mut leaders = Self::default();
        for paths in all.iter().filter(|paths| paths.0.iter().all(|path| path.is_some_and(|path| path.offset > 0.0))) {
            let Some(key) = key(paths) else { continue };
            let leader = leaders.0.entry(key).or_insert(*paths);
            if length(paths) < length(leader) {
                *leader = *paths;
            }
        }
        leaders
    }

    /// The site with the pseudo-sources of the given paths, which may be its own.
    pub(super) fn of_same_sources(&self, paths: &CornerPaths) -> Option<&CornerPaths> {
        if self.0.is_empty() { None } else { key(paths).and_then(|key| self.0.get(&key)) }
    }
}

/// The bits of all pseudo-sources; `None` if a corner has no path.
fn key(paths: &CornerPaths) -> Option<[[u64; 2]; 3]> {
    let [Some(a), Some(b), Some(c)] = paths.0 else { return None };
    // The sum makes both zeros one.
    Some([a, b, c].map(|path| path.pseudo_source.to_array().map(|x| (x + 0.0).to_bits())))
}
