//! A path, bent segment by segment.

use kurbo::{Affine, BezPath, Line, ParamCurve, ParamCurveArclen, PathEl, PathSeg, Point};

use crate::{course::Course, fit::append_fit, warp::Warp, xml::number};

/// A bent path, in image pixels.
#[derive(Debug)]
pub(crate) struct BentPath {
    pub(crate) path: BezPath,
    /// Points of the path at rest and posed.
    pub(crate) places: Vec<[Point; 2]>,
}

/// Distance of the points that are checked to determine whether a path meets the domain.
const LOOK_STEP: f64 = 4.0;
const MOST_LOOKS: f64 = 256.0;

/// Bends a path in image pixels; `None` if it does not change.
pub(crate) fn bent(path: &BezPath, warp: &Warp<'_>) -> Option<BentPath> {
    if !warp.moves(&looks(path)) {
        return None;
    }
    let place = |p| warp.place(p);
    let (mut out, mut places) = (BezPath::new(), Vec::new());
    let [mut start, mut at] = [Point::ZERO; 2];
    for element in path.elements() {
        let segment = match *element {
            PathEl::MoveTo(p) => {
                start = p;
                out.move_to(place(p));
                None
            }
            PathEl::LineTo(p) => Some(PathSeg::Line(Line::new(at, p))),
            PathEl::QuadTo(a, p) => Some(PathSeg::Quad(kurbo::QuadBez::new(at, a, p))),
            PathEl::CurveTo(a, b, p) => Some(PathSeg::Cubic(kurbo::CubicBez::new(at, a, b, p))),
            PathEl::ClosePath => (at != start).then(|| PathSeg::Line(Line::new(at, start))),
        };
        if let Some(segment) = segment {
            let course = Course::new(segment, &place);
            append_fit(&mut out, &course, matches!(segment, PathSeg::Line(_)));
            places.extend(course.samples.iter().map(|sample| [sample.rest, sample.posed]));
        }
        at = element.end_point().unwrap_or(start);
        if *element == PathEl::ClosePath {
            out.close_path();
        }
    }
    let moves = places.iter().any(|[rest, posed]| rest.distance_squared(*posed) > 1e-12);
    moves.then_some(BentPath { path: out, places })
}

fn looks(path: &BezPath) -> Vec<Point> {
    let of_segment = |segment: PathSeg| {
        let count = (segment.arclen(1.0) / LOOK_STEP).ceil().clamp(1.0, MOST_LOOKS) as usize;
        (0..=count).map(move |k| segment.eval(k as f64 / count as f64))
    };
    path.segments().flat_map(of_segment).collect()
}

/// Number of decimals, so that rounding moves a point by at most a thousandth of a pixel.
pub(crate) fn digits(to_pixels: Affine) -> usize {
    let mut rounding = 0.5 * to_pixels.determinant().abs().sqrt();
    let mut digits = 0;
    while rounding > 1e-3 && digits < 9 {
        (rounding, digits) = (rounding / 10.0, digits + 1);
    }
    digits
}

/// The text of a path's attribute `d`.
pub(crate) fn path_text(path: &BezPath, digits: usize) -> String {
    let mut text = String::new();
    for element in path.elements() {
        let (letter, points) = match *element {
            PathEl::MoveTo(p) => ('M', vec![p]),
            PathEl::LineTo(p) => ('L', vec![p]),
            PathEl::QuadTo(a, p) => ('Q', vec![a, p]),
            PathEl::CurveTo(a, b, p) => ('C', vec![a, b, p]),
            PathEl::ClosePath => ('Z', vec![]),
        };
        text.push(letter);
        let numbers: Vec<String> = points.iter().flat_map(|p| [number(p.x, digits), number(p.y, digits)]).collect();
        text.push_str(&numbers.join(" "));
    }
    text
}
