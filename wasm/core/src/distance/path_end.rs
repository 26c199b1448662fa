//! The end of a shortest path: its length, and its last bend.

use glam::DVec2;

use super::window::Window;

/// Paths tie if their lengths differ by no more than this, in pixels. It exceeds rounding errors, like the slack of
/// windows.
const DISTANCE_TIE_PX: f64 = 1e-9;

/// How the shortest path reaches a point.
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
    /// The straight path to `p` from the pseudo-source of a window.
    pub(super) fn through(window: &Window, p: DVec2) -> Self {
        let distance = window.offset + window.source.distance(p);
        Self { distance, pseudo_source: window.source, offset: window.offset }
    }

    /// The gradient of the distance at `p`, the end of this path, from the windows of its triangle.
    ///
    /// If several paths are equally short, this is the mean of their gradients. It is 0 at the source, and at a
    /// corner that no other pseudo-source sees.
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
