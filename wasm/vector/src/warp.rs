//! The map of a picture in the units of a drawing.

use c2warp::{ContinuedMap, glam::DVec2};
use kurbo::Point;

/// The map of a pose.
#[derive(Debug)]
pub(crate) struct Warp<'a> {
    pub(crate) map: &'a ContinuedMap<'a>,
}

/// Step of finite differences, in pixels.
const STEP: f64 = 0.5;

impl Warp<'_> {
    /// The posed position of a point in image pixels.
    pub(crate) fn place(&self, p: Point) -> Point {
        let place = self.map.place(DVec2::new(p.x, p.y));
        Point::new(place.x, place.y)
    }

    /// Whether any of these points move. If the picture around the domain does not move, only points in the domain do.
    pub(crate) fn moves(&self, points: &[Point]) -> bool {
        !self.map.background_stays() || points.iter().any(|p| self.map.is_inside(DVec2::new(p.x, p.y)))
    }

    /// The columns of the Jacobian at a point.
    pub(crate) fn slopes(&self, p: Point) -> [kurbo::Vec2; 2] {
        let along = |step: kurbo::Vec2| (self.place(p + step) - self.place(p - step)) / (2.0 * STEP);
        [along((STEP, 0.0).into()), along((0.0, STEP).into())]
    }
}
