//! Fits few lines and Béziers to a course.
//!
//! Each Bézier covers the longest part of the remaining course that one Bézier can fit, found by halving the number of
//! samples. The fit is kurbo's, which keeps the directions at both ends and the area below. This module measures its
//! distance.
//!
//! Cost: about ten fits for each Bézier.

use std::ops::Range;

use kurbo::{BezPath, CubicBez, Line, ParamCurve, ParamCurveNearest, Point};

use crate::course::Course;

/// Maximum distance between a bent path and the map of the path, in pixels.
pub const TOLERANCE: f64 = 0.1;
/// Greatest measured distance of a Bézier from its course. The rest of [`TOLERANCE`] is reserved for the spline of the
/// course, for the parts between the measured points, and for rounding in the file.
const FITTED: f64 = 0.09;
/// Maximum distance of a bent line that remains a line.
const STRAIGHT: f64 = 0.02;
/// Number of points of a Bézier at which its distance is measured.
const MEASURED: u32 = 32;

/// Appends the segments along a course. The path already ends at its beginning.
pub(crate) fn append_fit(path: &mut BezPath, course: &Course, is_line: bool) {
    let points = course.points(0..course.samples.len() - 1);
    let (from, to) = (points[0], points[points.len() - 1]);
    let is_point = points.iter().all(|p| p.distance(from) <= STRAIGHT);
    if is_point || is_line && is_straight(&points) {
        path.line_to(to);
        return;
    }
    let mut start = 0;
    while start + 1 < course.samples.len() {
        let (end, CubicBez { p1, p2, p3, .. }) = longest(course, start);
        path.curve_to(p1, p2, p3);
        start = end;
    }
}

/// The Bézier from a sample to the farthest sample that it can reach, and that sample.
fn longest(course: &Course, start: usize) -> (usize, CubicBez) {
    let last = course.samples.len() - 1;
    if let Some(whole) = fitted(course, start..last) {
        return (last, whole);
    }
    let mut reached = (start + 1, course.hermite(start));
    let mut beyond = last;
    while beyond - reached.0 > 1 {
        let middle = usize::midpoint(reached.0, beyond);
        match fitted(course, start..middle) {
            Some(cubic) => reached = (middle, cubic),
            None => beyond = middle,
        }
    }
    reached
}

/// The Bézier between two samples, if it is close enough to the course.
fn fitted(course: &Course, samples: Range<usize>) -> Option<CubicBez> {
    if samples.len() == 1 {
        return Some(course.hermite(samples.start));
    }
    let [from, to] = [samples.start, samples.end].map(|at| course.samples[at].t);
    let (cubic, _) = kurbo::fit_to_cubic(course, from..to, TOLERANCE)?;
    (cubic.is_finite() && is_close(cubic, course, samples)).then_some(cubic)
}

/// Whether points lie on a line in the given order.
fn is_straight(points: &[Point]) -> bool {
    let [from, to] = [points[0], points[points.len() - 1]];
    let line = Line::new(from, to);
    let along = (to - from) / (to - from).hypot2().max(f64::MIN_POSITIVE);
    let mut reached = f64::NEG_INFINITY;
    points.iter().all(|&p| {
        let fraction = (p - from).dot(along);
        let is_onwards = fraction >= reached;
        reached = fraction;
        is_onwards && line.nearest(p, 1e-6).distance_sq <= STRAIGHT * STRAIGHT
    })
}

/// Whether points of a Bézier are close to a part of a course, and points of the course close to the Bézier.
fn is_close(cubic: CubicBez, course: &Course, samples: Range<usize>) -> bool {
    let is_near = |distance_sq: f64| distance_sq <= FITTED * FITTED;
    let points = course.points(samples);
    if !points.iter().all(|p| is_near(cubic.nearest(*p, 1e-3).distance_sq)) {
        return false;
    }
    let lines: Vec<Line> = points.windows(2).map(|pair| Line::new(pair[0], pair[1])).collect();
    let to_course = |p: Point| lines.iter().map(|line| line.nearest(p, 1e-6).distance_sq).fold(f64::INFINITY, f64::min);
    (1..MEASURED).all(|k| is_near(to_course(cubic.eval(f64::from(k) / f64::from(MEASURED)))))
}
