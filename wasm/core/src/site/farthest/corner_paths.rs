//! The shortest paths from a site to the three corners of a piece, and what they tell of the distances between these.

use glam::DVec2;

use crate::{
    distance::{DistanceField, NavTriangle, PathEnd},
    min_max::fast_min,
};

/// The paths to the corners; `None` where none leads, or only one beyond the field's bound.
#[derive(Debug, Clone, Copy)]
pub(super) struct CornerPaths(pub(super) [Option<PathEnd>; 3]);

impl CornerPaths {
    pub(super) fn new(field: &DistanceField, corners: &[DVec2; 3], nav_triangles: &[NavTriangle; 3]) -> Self {
        let mut field = field.cached_lookup();
        Self([0, 1, 2].map(|k| field.path_end(nav_triangles[k], corners[k])))
    }

    /// Those to the corners of a part: 0 to 2 are the corners of the whole, 3 to 5 those of the triangle between their midpoints.
    pub(super) fn of_part(outer: &Self, inner: &Self, part: [usize; 3]) -> Self {
        Self(part.map(|at| [outer, inner][at / 3].0[at % 3]))
    }

    /// The distance of a corner, infinite where there is no path.
    pub(super) fn distance(&self, corner: usize) -> f64 {
        self.0[corner].map_or(f64::INFINITY, |path| path.distance)
    }

    /// The pseudo-source of all paths, if it is the same: distances between the corners are then those of one cone.
    pub(super) fn pseudo_source(&self) -> Option<DVec2> {
        let [a, b, c] = self.sources();
        if a == b && b == c { a } else { None }
    }

    /// Whether the paths to each corner have the same pseudo-source as another site's.
    pub(super) fn have_sources_of(&self, other: &Self) -> bool {
        self.sources() == other.sources()
    }

    /// The pseudo-source of the path to each corner.
    fn sources(&self) -> [Option<DVec2>; 3] {
        self.0.map(|path| path.map(|path| path.pseudo_source))
    }

    /// The minimum of the known distances and these.
    pub(super) fn nearer(&self, known: &[f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| fast_min(known[k], self.distance(k)))
    }

    /// Whether the site may be the nearest somewhere between corners with these distances to their nearest sites and edges no
    /// longer than `longest`: distances are 1-Lipschitz.
    pub(super) fn may_enter(&self, nearest: &[f64; 3], longest: f64) -> bool {
        (0..3).all(|k| self.distance(k) <= nearest[k] + 2.0 * longest)
    }
}

/// For each triple of pseudo-sources on the outline, the site nearest to it. A site that is farther from all three is nowhere
/// the nearest.
pub(super) fn nearest_by_sources(all: &[CornerPaths]) -> Vec<CornerPaths> {
    let length = |paths: &CornerPaths| paths.0.iter().flatten().map(|path| path.offset).sum::<f64>();
    let mut nearest: Vec<CornerPaths> = Vec::new();
    for paths in all.iter().filter(|paths| paths.0.iter().all(|path| path.is_some_and(|path| path.offset > 0.0))) {
        match nearest.iter_mut().find(|leader| leader.have_sources_of(paths)) {
            Some(leader) if length(paths) < length(leader) => *leader = *paths,
            Some(_) => {}
            None => nearest.push(*paths),
        }
    }
    nearest
}
