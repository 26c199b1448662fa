//! The distance from one source to any point, in closed form.
//!
//! Cost of a query: a binary search for the triangle, then its windows in order until one begins beyond the result.

use std::ops::Range;

use glam::DVec2;

use super::{
    navigation::{NavTriangle, Navigation},
    path_end::PathEnd,
    window::Window,
};
use crate::segment::segment_distance;

/// Exact intrinsic distances from one source, up to a bound. [`Propagation::field`](super::Propagation::field)
/// computes it.
///
/// Memory: 64 bytes per window. There is one window for each pair of pseudo-source and triangle in which the
/// pseudo-source may be the nearest.
#[derive(Debug, Clone)]
pub(crate) struct DistanceField {
    pub(crate) source: DVec2,
    pub(crate) bound: f64,
    /// Triangles reached, ascending, each with the index of its first window.
    pub(crate) triangles: Vec<(u32, u32)>,
    pub(crate) windows: Vec<Window>,
}

impl DistanceField {
    /// Distances up to this bound are exact. Greater ones are infinite in this field.
    pub(crate) fn bound(&self) -> f64 {
        self.bound
    }

    /// Memory in bytes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&*self.triangles) + size_of_val(&*self.windows)
    }

    /// The intrinsic distance to a point. It is infinite beyond the bound, and if no path exists.
    #[inline]
    pub(crate) fn distance(&self, triangle: NavTriangle, p: DVec2) -> f64 {
        let mut best = f64::INFINITY;
        for window in self.windows_in(triangle) {
            if window.nearest >= best {
                break;
            }
            let d = window.offset + window.source.distance(p);
            if d < best && window.sees(p) {
                best = d;
            }
        }
        if best <= self.bound { best } else { f64::INFINITY }
    }

    /// The end of the shortest path to a point, or `None` beyond the bound.
    pub(crate) fn path_end(&self, triangle: NavTriangle, p: DVec2) -> Option<PathEnd> {
        self.path_end_in(self.windows_in(triangle), p)
    }

    /// The distance to a point and its gradient, or `None` beyond the bound.
    pub(crate) fn distance_and_gradient(&self, triangle: NavTriangle, p: DVec2) -> Option<(f64, DVec2)> {
        let windows = self.windows_in(triangle);
        self.path_end_in(windows, p).map(|path| (path.distance, path.gradient_in(windows, p)))
    }

    /// Returns [`path_end`](Self::path_end) of a point in the triangle of `windows`.
    pub(crate) fn path_end_in(&self, windows: &[Window], p: DVec2) -> Option<PathEnd> {
        let mut best: Option<PathEnd> = None;
        for window in windows {
            let least = best.map_or(f64::INFINITY, |path| path.distance);
            if window.nearest >= least {
                break;
            }
            let path = PathEnd::through(window, p);
            if path.distance < least && window.sees(p) {
                best = Some(path);
            }
        }
        best.filter(|path| path.distance <= self.bound)
    }

    /// A lookup for points that are often in the same triangle as the previous one.
    pub(crate) fn cached_lookup(&self) -> CachedLookup<'_> {
        CachedLookup { field: self, last: None }
    }

    /// The ends of all known paths to a point: the shortest path, and others that are shortest nearby.
    pub(crate) fn path_ends(&self, triangle: NavTriangle, p: DVec2) -> impl Iterator<Item = PathEnd> + '_ {
        let seeing = self.windows_in(triangle).iter().filter(move |window| window.sees(p));
        seeing.map(move |window| PathEnd::through(window, p))
    }

    /// The point halfway along the shortest path to a point, or `None` beyond the bound.
    pub(crate) fn halfway(&self, navigation: &Navigation, triangle: NavTriangle, p: DVec2) -> Option<DVec2> {
        let mut path = self.path_end(triangle, p)?;
        let (half, mut end) = (path.distance / 2.0, p);
        while path.offset > half {
            end = path.pseudo_source;
            path = self.path_end_at_corner(navigation, end)?;
        }
        Some(path.pseudo_source.lerp(end, (half - path.offset) / (path.distance - path.offset)))
    }

    /// The vertices of the shortest path from the source to a point, including both; `None` beyond the bound.
    pub(crate) fn path(&self, navigation: &Navigation, triangle: NavTriangle, p: DVec2) -> Option<Vec<DVec2>> {
        let mut path = self.path_end(triangle, p)?;
        let mut vertices = vec![p, path.pseudo_source];
        while path.offset > 0.0 {
            path = self.path_end_at_corner(navigation, path.pseudo_source)?;
            vertices.push(path.pseudo_source);
        }
        vertices.reverse();
        Some(vertices)
    }

    /// The end of the shortest path to a corner at which paths bend.
    fn path_end_at_corner(&self, navigation: &Navigation, corner: DVec2) -> Option<PathEnd> {
        // A corner lies in its own windows, too.
        let before = navigation.around(corner).flat_map(|triangle| self.path_ends(triangle, corner));
        let before = before.filter(|path| path.pseudo_source != corner);
        before.reduce(|best, path| if path.distance < best.distance { path } else { best })
    }

    /// The minimum distance to a point of the segment from `a` to `b` in one triangle. It is infinite beyond the bound,
    /// and if no path exists.
    pub(crate) fn distance_to_segment(&self, triangle: NavTriangle, a: DVec2, b: DVec2) -> f64 {
        let mut best = f64::INFINITY;
        for window in self.windows_in(triangle) {
            if window.nearest >= best {
                break;
            }
            if let Some((from, to)) = window.seen_part(a, b) {
                best = best.min(window.offset + segment_distance(window.source, from, to));
            }
        }
        if best <= self.bound { best } else { f64::INFINITY }
    }

    /// Triangles with a point nearer than `radius`, ascending, each with its range of windows. May include a few other
    /// triangles.
    pub(crate) fn windows_within(&self, radius: f64) -> impl Iterator<Item = (u32, Range<u32>)> + '_ {
        let nearest = move |(_, windows): &(u32, Range<u32>)| self.windows[windows.start as usize].nearest < radius;
        (0..self.triangles.len()).map(|at| (self.triangles[at].0, self.range_at(at))).filter(nearest)
    }

    fn windows_in(&self, triangle: NavTriangle) -> &[Window] {
        match self.triangles.binary_search_by_key(&triangle.0, |&(triangle, _)| triangle) {
            Ok(at) => self.windows(self.range_at(at)),
            Err(_) => &[],
        }
    }

    /// The windows of a triangle, from a range of [`windows_within`](Self::windows_within).
    pub(crate) fn windows(&self, range: Range<u32>) -> &[Window] {
        &self.windows[range.start as usize..range.end as usize]
    }

    /// The range of windows of the triangle at an index of `triangles`.
    pub(super) fn range_at(&self, at: usize) -> Range<u32> {
        let end = self.triangles.get(at + 1).map_or(self.windows.len() as u32, |&(_, start)| start);
        self.triangles[at].1..end
    }
}

/// Looks up the windows of a triangle only once for consecutive points in it.
pub(crate) struct CachedLookup<'a> {
    field: &'a DistanceField,
    /// The last triangle and its windows.
    last: Option<(NavTriangle, &'a [Window])>,
}

impl CachedLookup<'_> {
    /// Returns the same as [`DistanceField::path_end`].
    pub(crate) fn path_end(&mut self, triangle: NavTriangle, p: DVec2) -> Option<PathEnd> {
        let windows = match self.last {
            Some((known, windows)) if known == triangle => windows,
            _ => self.field.windows_in(triangle),
        };
        self.last = Some((triangle, windows));
        self.field.path_end_in(windows, p)
    }
}
