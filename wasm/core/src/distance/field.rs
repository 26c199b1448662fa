//! The distance from one source to any point, in closed form.
//!
//! Cost of a query: a binary search for the triangle, and its windows up to the first one that begins beyond the result.

use std::ops::Range;

use glam::DVec2;

use super::{NavTriangle, Navigation};
use crate::segment::segment_distance;

/// Points this far outside a window, in pixels, still count as inside. Windows meet along rays; a point on such a ray must
/// lie in one of them despite rounding. A path that cuts a corner by this much is shorter by at most as much.
pub(crate) const WINDOW_SLACK: f64 = 1e-9;

/// Paths whose lengths differ by no more, in pixels, are tied: above rounding, as [`WINDOW_SLACK`] is.
const DISTANCE_TIE_PX: f64 = 1e-9;

/// The part of one triangle that a pseudo-source sees: a cone of directions (Mitchell et al.'s interval of optimality).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Window {
    /// The pseudo-source.
    pub(crate) source: DVec2,
    /// Distance from the field's source to the pseudo-source.
    pub(crate) offset: f64,
    /// Unit direction of the cone's first ray; the cone turns positively from it to `last`, by at most π.
    pub(crate) first: DVec2,
    /// Unit direction of the cone's last ray.
    pub(crate) last: DVec2,
    /// Least distance of any point in the window; the windows of a triangle are sorted by it.
    pub(crate) nearest: f64,
}

impl Window {
    fn sees(&self, p: DVec2) -> bool {
        let to = p - self.source;
        self.first.perp_dot(to) >= -WINDOW_SLACK && to.perp_dot(self.last) >= -WINDOW_SLACK
    }

    /// Whether the window may contain a point of a box nearer than `radius`.
    pub(crate) fn may_reach(&self, low: DVec2, high: DVec2, radius: f64) -> bool {
        let (to_low, to_high) = (low - self.source, high - self.source);
        // The corners of the box farthest to the left of the first ray, and to the right of the last.
        let left = |ray: DVec2| {
            DVec2::new(
                if ray.y > 0.0 { to_low.x } else { to_high.x }, //
                if ray.x > 0.0 { to_high.y } else { to_low.y },
            )
        };
        let nearest = DVec2::ZERO.clamp(to_low, to_high).length();
        self.first.perp_dot(left(self.first)) >= -WINDOW_SLACK
            && left(-self.last).perp_dot(self.last) >= -WINDOW_SLACK
            && self.offset + nearest < radius + WINDOW_SLACK
    }

    /// The part of a segment inside the cone.
    fn seen_part(&self, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
        let (to_a, to_b) = (a - self.source, b - self.source);
        let sides = [
            (self.first.perp_dot(to_a), self.first.perp_dot(to_b)),
            (to_a.perp_dot(self.last), to_b.perp_dot(self.last)),
        ];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (at_a, at_b) in sides.map(|(at_a, at_b)| (at_a + WINDOW_SLACK, at_b + WINDOW_SLACK)) {
            if at_a < 0.0 && at_b < 0.0 {
                return None;
            }
            if at_a < 0.0 {
                from = from.max(at_a / (at_a - at_b));
            } else if at_b < 0.0 {
                to = to.min(at_a / (at_a - at_b));
            }
        }
        (from <= to).then(|| (a.lerp(b, from), a.lerp(b, to)))
    }
}

/// How the shortest path reaches a point: its length, and the vertex it bends at last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PathEnd {
    /// Length of the path: the intrinsic distance, in pixels.
    pub(crate) distance: f64,
    /// The last vertex of the path: the source, or a corner of the outline.
    pub(crate) pseudo_source: DVec2,
    /// Intrinsic distance from the source to the pseudo-source.
    pub(crate) offset: f64,
}

impl PathEnd {
    /// The gradient of the distance at `p`, the point that this path leads to, from the windows of its triangle. Where several
    /// paths are equally short, the mean of their gradients; 0 at the source, and at a corner that no other pseudo-source
    /// sees.
    pub(crate) fn gradient_in(&self, windows: &[Window], p: DVec2) -> DVec2 {
        let (mut sum, mut count) = (DVec2::ZERO, 0.0);
        for window in windows.iter().take_while(|window| window.nearest <= self.distance + DISTANCE_TIE_PX) {
            let to = p - window.source;
            let length = to.length();
            // A path to a corner ends there: the corner's own windows hold the paths beyond.
            if window.offset + length <= self.distance + DISTANCE_TIE_PX && length > DISTANCE_TIE_PX && window.sees(p) {
                sum += to / length;
                count += 1.0;
            }
        }
        if count > 0.0 { sum / count } else { DVec2::ZERO }
    }
}

/// Exact intrinsic distances from one source, up to a bound. Computed by [`Propagation::field`](super::Propagation::field).
///
/// 64 bytes a window; one window for each pseudo-source and triangle of the outline in which it may be the nearest.
#[derive(Debug, Clone)]
pub(crate) struct DistanceField {
    pub(crate) source: DVec2,
    pub(crate) bound: f64,
    /// Triangles reached, ascending, each with the index of its first window.
    pub(crate) triangles: Vec<(u32, u32)>,
    pub(crate) windows: Vec<Window>,
}

impl DistanceField {
    /// Distances up to this bound are exact; greater ones are reported as infinite.
    pub(crate) fn bound(&self) -> f64 {
        self.bound
    }

    /// The intrinsic distance to a point, infinite beyond the bound and where no path leads.
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

    /// How the shortest path reaches a point, if the distance is within the bound.
    pub(crate) fn path_end(&self, triangle: NavTriangle, p: DVec2) -> Option<PathEnd> {
        self.path_end_in(self.windows_in(triangle), p)
    }

    /// The distance to a point and its gradient, if the distance is within the bound.
    pub(crate) fn slope(&self, triangle: NavTriangle, p: DVec2) -> Option<(f64, DVec2)> {
        let windows = self.windows_in(triangle);
        self.path_end_in(windows, p).map(|path| (path.distance, path.gradient_in(windows, p)))
    }

    /// [`path_end`](Self::path_end) for a point whose `windows` are known.
    pub(crate) fn path_end_in(&self, windows: &[Window], p: DVec2) -> Option<PathEnd> {
        let mut best: Option<PathEnd> = None;
        for window in windows {
            let least = best.map_or(f64::INFINITY, |path| path.distance);
            if window.nearest >= least {
                break;
            }
            let distance = window.offset + window.source.distance(p);
            if distance < least && window.sees(p) {
                best = Some(PathEnd { distance, pseudo_source: window.source, offset: window.offset });
            }
        }
        best.filter(|path| path.distance <= self.bound)
    }

    /// For queries at points of which consecutive ones are often in the same triangle.
    pub(crate) fn cached_lookup(&self) -> CachedLookup<'_> {
        CachedLookup { field: self, last: None }
    }

    /// The ends of all known paths to a point: the shortest one, and others that are shortest nearby.
    pub(crate) fn path_ends(&self, triangle: NavTriangle, p: DVec2) -> impl Iterator<Item = PathEnd> + '_ {
        let seeing = self.windows_in(triangle).iter().filter(move |window| window.sees(p));
        seeing.map(move |window| PathEnd {
            distance: window.offset + window.source.distance(p),
            pseudo_source: window.source,
            offset: window.offset,
        })
    }

    /// The point halfway along the shortest path to a point, if the distance is within the bound.
    pub(crate) fn halfway(&self, navigation: &Navigation, triangle: NavTriangle, p: DVec2) -> Option<DVec2> {
        let mut path = self.path_end(triangle, p)?;
        let (half, mut end) = (path.distance / 2.0, p);
        while path.offset > half {
            end = path.pseudo_source;
            // A corner lies in its own windows, too.
            let before = navigation.around(end).flat_map(|triangle| self.path_ends(triangle, end));
            let before = before.filter(|path| path.pseudo_source != end);
            path = before.reduce(|best, path| if path.distance < best.distance { path } else { best })?;
        }
        Some(path.pseudo_source.lerp(end, (half - path.offset) / (path.distance - path.offset)))
    }

    /// The least distance to a point of the segment from `a` to `b`, which lies in one triangle; infinite beyond the bound and
    /// where no path leads.
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

    /// Triangles with a point nearer than `radius`, ascending, and the range of windows of each; possibly a few triangles
    /// more.
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
    fn range_at(&self, at: usize) -> Range<u32> {
        let end = self.triangles.get(at + 1).map_or(self.windows.len() as u32, |&(_, start)| start);
        self.triangles[at].1..end
    }
}

/// Queries of a field that look up the windows of a triangle once for consecutive points.
pub(crate) struct CachedLookup<'a> {
    field: &'a DistanceField,
    /// The last triangle and its windows.
    last: Option<(NavTriangle, &'a [Window])>,
}

impl CachedLookup<'_> {
    /// As [`DistanceField::path_end`].
    pub(crate) fn path_end(&mut self, triangle: NavTriangle, p: DVec2) -> Option<PathEnd> {
        let windows = match self.last {
            Some((known, windows)) if known == triangle => windows,
            _ => self.field.windows_in(triangle),
        };
        self.last = Some((triangle, windows));
        self.field.path_end_in(windows, p)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_with_a_point_that_is_seen_within_the_radius_may_be_reached_and_a_box_beside_the_cone_not() {
        let (low, high) = (DVec2::new(3.0, -2.0), DVec2::new(5.0, 1.0));
        let ray = |degrees: i32| {
            let (sin, cos) = libm::sincos(f64::from(degrees).to_radians());
            DVec2::new(cos, sin)
        };
        let points: Vec<DVec2> =
            (0..=20).flat_map(|i| (0..=20).map(move |j| (f64::from(i), f64::from(j)))).map(DVec2::from).collect();
        let (mut reached, mut passed) = (0, 0);
        for (from, width) in (0..360).step_by(15).flat_map(|from| [1, 20, 90, 180].map(|width| (from, width))) {
            for source in [DVec2::ZERO, DVec2::new(4.0, 0.0), DVec2::new(9.0, -7.0)] {
                let window = Window { source, offset: 2.0, first: ray(from), last: ray(from + width), nearest: 2.0 };
                for radius in [4.0, 6.0, 20.0] {
                    let at = |&share: &DVec2| low + share / 20.0 * (high - low);
                    let is_reached = |p: DVec2| window.sees(p) && window.offset + source.distance(p) < radius;
                    let may_reach = window.may_reach(low, high, radius);
                    assert!(may_reach || !points.iter().map(at).any(is_reached), "{source} {from} {width} {radius}");
                    *if may_reach { &mut reached } else { &mut passed } += 1;
                }
            }
        }
        assert!(reached > 100 && passed > 400, "{reached} and {passed}");
    }
}
