//! Handles for tests.

use c2warp::project::{Handle, Rotation, Shape};
use glam::DVec2;

/// Returns a point handle with a rotation in degrees. Its id is `h` and the number `id`.
pub(crate) fn point_handle(id: usize, rest: DVec2, posed: DVec2, degrees: f64) -> Handle {
    Handle::point(format!("h{id}"), rest).posed_at([posed]).turned(degrees)
}

/// Returns a handle whose rotation is left to the solver.
pub(crate) fn line(id: &str, shape: Shape) -> Handle {
    Handle::new(id, shape).turned(Rotation::Auto)
}

/// Returns a bar whose rotation is left to the solver.
pub(crate) fn bar(id: &str, rest: &[(f64, f64)], posed: &[(f64, f64)]) -> Handle {
    line(id, Shape::Bar { rest: points(rest), posed: points(posed) })
}

/// Returns a polygon whose rotation is left to the solver.
pub(crate) fn polygon(id: &str, rest: &[(f64, f64)], posed: &[(f64, f64)]) -> Handle {
    line(id, Shape::Polygon { rest: points(rest), posed: points(posed) })
}

/// Converts pairs to points.
pub(crate) fn points(corners: &[(f64, f64)]) -> Vec<DVec2> {
    corners.iter().map(|&corner| corner.into()).collect()
}
