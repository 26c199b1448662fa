//! Reads attributes as usvg writes them, and writes changed ones.

use kurbo::{Affine, Point, Rect};
use usvg::roxmltree::Node;

use crate::xml::number;

pub(super) const XLINK: &str = "http://www.w3.org/1999/xlink";

/// The attributes x, y, width and height; missing ones are taken from another rectangle. `None` if the area is 0.
pub(super) fn rectangle(node: Node<'_, '_>, or: Rect) -> Option<Rect> {
    let length = |name: &str| node.attribute(name).and_then(|text| text.parse::<f64>().ok());
    let origin = Point::new(length("x").unwrap_or(or.x0), length("y").unwrap_or(or.y0));
    let size = (length("width").unwrap_or(or.width()), length("height").unwrap_or(or.height()));
    Some(Rect::from_origin_size(origin, size)).filter(|frame| frame.is_finite() && frame.area() > 0.0)
}

pub(super) fn rectangle_attributes(frame: Rect) -> Vec<(&'static str, String)> {
    let values = [("x", frame.x0), ("y", frame.y0), ("width", frame.width()), ("height", frame.height())];
    values.map(|(name, value)| (name, number(value, 6))).into()
}

/// The transform in an attribute, as usvg writes it.
pub(super) fn transform(node: Node<'_, '_>, name: &str) -> Affine {
    let text = node.attribute(name).and_then(|text| text.strip_prefix("matrix(")?.strip_suffix(')'));
    text.and_then(|text| <[f64; 6]>::try_from(numbers(text)).ok()).map_or(Affine::IDENTITY, Affine::new)
}

pub(super) fn numbers(text: &str) -> Vec<f64> {
    text.split([' ', ',']).filter_map(|number| number.parse().ok()).collect()
}

pub(super) fn matrix(affine: Affine) -> String {
    let coefficients = affine.as_coeffs();
    format!("matrix({})", coefficients.map(|value| number(value, 8)).join(" "))
}

pub(super) fn stroke_width(node: Node<'_, '_>) -> f64 {
    node.attribute("stroke-width").and_then(|width| width.parse().ok()).unwrap_or(1.0)
}

pub(super) fn qualified(namespace: Option<&str>, name: &str) -> String {
    if namespace == Some(XLINK) { format!("xlink:{name}") } else { name.to_owned() }
}
