//! A drawing again, with bent paths.
//!
//! Groups keep their transforms: a path is bent in image pixels, and written in its own units again. A definition is
//! written once for each place that it is bent for. A clip path or mask bends as the paths do. Gradients and
//! patterns follow the affine map that is closest to the warp over the path. Rectangles of masks and filters grow to
//! hold the bent ones.

use std::collections::{HashMap, HashSet};

use c2warp::ContinuedMap;
use kurbo::{Affine, BezPath, Point, Rect, Shape};
use usvg::roxmltree::{Document, Node};

use crate::{
    drawing::Drawing,
    error::VectorError,
    outline::{self, digits, path_text},
    spread::{affine_of, growth},
    warp::Warp,
    xml::{Xml, number},
};

/// Most segments of all paths.
const MAX_NODES: usize = 300_000;
const SVG: &str = "http://www.w3.org/2000/svg";
const XLINK: &str = "http://www.w3.org/1999/xlink";
/// Points along each side of a rectangle, and of a picture, that the warp is looked up at.
const SIDE_POINTS: u32 = 8;

/// How a bent drawing is framed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentOptions {
    /// Size of the file's picture for each unit of the drawing's own size.
    pub scale: f64,
    /// Grow the frame to hold all paths.
    pub grow: bool,
}

impl Default for BentOptions {
    fn default() -> Self {
        Self { scale: 1.0, grow: false }
    }
}

/// A bent drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Bent {
    /// The SVG file.
    pub svg: String,
    /// Nodes of the paths that bent, before and after.
    pub nodes: [usize; 2],
    /// The upper left corner of the frame in the units of the drawing's own size: (0, 0) unless it grew.
    pub origin: [f64; 2],
}

impl Drawing {
    /// Bends the drawing. It lies over the whole picture of the solution, whose size is given in pixels.
    ///
    /// # Errors
    /// [`VectorError::TooManyNodes`].
    pub fn bent(&self, map: &ContinuedMap<'_>, picture: (u32, u32), options: BentOptions) -> Result<Bent, VectorError> {
        let [width, height] = self.size();
        let to_pixels = Affine::scale_non_uniform(f64::from(picture.0) / width, f64::from(picture.1) / height);
        let document = Document::parse(&self.text).map_err(|reason| VectorError::Xml(reason.to_string()))?;
        let by_id: HashMap<&str, Node<'_, '_>> =
            document.descendants().filter_map(|node| Some((node.attribute("id")?, node))).collect();
        let taken = by_id.keys().map(|&id| id.to_owned()).collect();
        let warp = Warp { map };
        let mut rewriter = Rewriter {
            by_id,
            taken,
            made: HashMap::new(),
            defs: String::new(),
            warp,
            nodes: [0; 2],
            drawn: None,
            is_defining: false,
        };
        let mut body = Xml::default();
        for child in document.root_element().children().filter(Node::is_element) {
            if child.tag_name().name() != "defs" {
                rewriter.element(&mut body, child, Follow::Bend(to_pixels), None)?;
            }
        }
        let mut frame = Rect::new(0.0, 0.0, width, height);
        if let Some(drawn) = rewriter.drawn.filter(|_| options.grow) {
            frame = frame.union(to_pixels.inverse().transform_rect_bbox(drawn.expand()));
        }
        let mut xml = Xml::default();
        xml.open("svg");
        xml.attribute("xmlns", SVG);
        xml.attribute("xmlns:xlink", XLINK);
        let text = |value: f64| number(value, 4);
        xml.attribute("width", text(frame.width() * options.scale));
        xml.attribute("height", text(frame.height() * options.scale));
        let view = [frame.x0, frame.y0, frame.width(), frame.height()].map(text);
        xml.attribute("viewBox", view.join(" "));
        if !rewriter.defs.is_empty() {
            xml.open("defs");
            xml.append(&rewriter.defs);
            xml.close("defs");
        }
        xml.append(&body.into_text());
        xml.close("svg");
        let svg = xml.into_text().trim_start().to_owned() + "\n";
        Ok(Bent { svg, nodes: rewriter.nodes, origin: [frame.x0, frame.y0] })
    }
}

/// How an element follows the warp.
#[derive(Debug, Clone, Copy)]
enum Follow {
    /// Not at all.
    Stay,
    /// By bending; with the map from the element's units to image pixels.
    Bend(Affine),
    /// By an affine map in the units of the element that is painted.
    Move(Affine),
}

impl Follow {
    /// For the children of an element with a transform.
    fn within(self, transform: Affine) -> Self {
        if let Self::Bend(to_pixels) = self { Self::Bend(to_pixels * transform) } else { Self::Stay }
    }

    /// Bending where the units are not squeezed into a line.
    fn to_pixels(self) -> Option<Affine> {
        match self {
            Self::Bend(to_pixels) => {
                let det = to_pixels.determinant();
                (det.is_finite() && det.abs() > 1e-12).then_some(to_pixels)
            }
            _ => None,
        }
    }
}

struct Rewriter<'a, 'input> {
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    taken: HashSet<String>,
    /// Names of written definitions, by name and the way that they follow.
    made: HashMap<String, String>,
    defs: String,
    warp: Warp<'a>,
    nodes: [usize; 2],
    /// The box around bent paths with their strokes, in image pixels.
    drawn: Option<Rect>,
    is_defining: bool,
}

impl<'a, 'input> Rewriter<'a, 'input> {
    fn element(
        &mut self,
        xml: &mut Xml,
        node: Node<'a, 'input>,
        follow: Follow,
        name: Option<&str>,
    ) -> Result<(), VectorError> {
        let tag = node.tag_name().name();
        let follow = follow.within(transform(node, "transform"));
        if tag == "path" {
            return self.path(xml, node, follow, name);
        }
        xml.open(tag);
        let framed = if tag.starts_with("fe") { self.filter_part(node, follow) } else { Vec::new() };
        let moved = if tag == "image" { self.picture_transform(node, follow) } else { None };
        for attribute in node.attributes() {
            let key = qualified(attribute.namespace(), attribute.name());
            let is_replaced = moved.is_some() && key == "transform";
            if !is_replaced && framed.iter().all(|(name, _)| *name != key) {
                self.attribute(xml, &key, attribute.value(), follow, name)?;
            }
        }
        for (key, value) in framed {
            xml.attribute(key, value);
        }
        if let Some(moved) = moved {
            xml.attribute("transform", moved);
        }
        self.children(xml, node, follow)?;
        xml.close(tag);
        Ok(())
    }

    fn children(&mut self, xml: &mut Xml, node: Node<'a, 'input>, follow: Follow) -> Result<(), VectorError> {
        node.children().filter(Node::is_element).try_for_each(|child| self.element(xml, child, follow, None))
    }

    /// Writes an attribute, with new names of its definitions.
    fn attribute(
        &mut self,
        xml: &mut Xml,
        key: &str,
        value: &str,
        follow: Follow,
        name: Option<&str>,
    ) -> Result<(), VectorError> {
        if key == "id" {
            xml.attribute(key, name.unwrap_or(value));
            return Ok(());
        }
        if key == "xlink:href" && value.starts_with('#') {
            let target = self.referred(&value[1..], follow)?;
            xml.attribute(key, format_args!("#{target}"));
            return Ok(());
        }
        let mut text = String::new();
        let mut parts = value.split("url(#");
        text.push_str(parts.next().unwrap_or_default());
        for part in parts {
            let (id, rest) = part.split_once(')').unwrap_or((part, ""));
            let target = self.referred(id, follow)?;
            text.push_str(&format!("url(#{target}){rest}"));
        }
        xml.attribute(key, text);
        Ok(())
    }

    fn path(
        &mut self,
        xml: &mut Xml,
        node: Node<'a, 'input>,
        follow: Follow,
        name: Option<&str>,
    ) -> Result<(), VectorError> {
        let data = node.attribute("d").unwrap_or_default();
        let path = BezPath::from_svg(data).unwrap_or_default();
        self.nodes[0] += path.elements().len();
        if self.nodes[0] > MAX_NODES {
            return Err(VectorError::TooManyNodes { most: MAX_NODES });
        }
        let bent = follow.to_pixels().and_then(|to_pixels| {
            let bent = outline::bent(&(to_pixels * &path), &self.warp)?;
            Some((to_pixels, bent))
        });
        xml.open("path");
        let Some((to_pixels, bent)) = bent else {
            self.nodes[1] += path.elements().len();
            if let Some(to_pixels) = follow.to_pixels() {
                self.note_drawn(node, to_pixels, &(to_pixels * &path), 1.0);
            }
            for attribute in node.attributes() {
                let key = qualified(attribute.namespace(), attribute.name());
                let stays = matches!(&*key, "fill" | "stroke");
                self.attribute(xml, &key, attribute.value(), if stays { Follow::Stay } else { follow }, name)?;
            }
            xml.close("path");
            return Ok(());
        };
        self.nodes[1] += bent.path.elements().len();
        let has_stroke = node.attribute("stroke").is_some_and(|stroke| stroke != "none");
        let growth = if has_stroke { growth(&bent.places, &self.warp) } else { 1.0 };
        self.note_drawn(node, to_pixels, &bent.path, growth);
        let digits = digits(to_pixels);
        for attribute in node.attributes() {
            let key = qualified(attribute.namespace(), attribute.name());
            let value = attribute.value();
            match &*key {
                "d" | "stroke-width" => {}
                "fill" | "stroke" if value.contains("url(") => {
                    let affine = affine_of(&bent.places, &self.warp);
                    let local = to_pixels.inverse() * affine * to_pixels;
                    self.attribute(xml, &key, value, Follow::Move(local), name)?;
                }
                "stroke-dasharray" | "stroke-dashoffset" => {
                    let grown = numbers(value).into_iter().map(|length| number(length * growth, digits + 1));
                    xml.attribute(&key, grown.collect::<Vec<_>>().join(" "));
                }
                _ => self.attribute(xml, &key, value, follow, name)?,
            }
        }
        if has_stroke {
            xml.attribute("stroke-width", number(stroke_width(node) * growth, digits + 1));
        }
        xml.attribute("d", path_text(&(to_pixels.inverse() * &bent.path), digits));
        xml.close("path");
        Ok(())
    }

    fn note_drawn(&mut self, node: Node<'_, '_>, to_pixels: Affine, path: &BezPath, growth: f64) {
        if self.is_defining {
            return;
        }
        let has_stroke = node.attribute("stroke").is_some_and(|stroke| stroke != "none");
        let width = if has_stroke { stroke_width(node) * growth * to_pixels.determinant().abs().sqrt() } else { 0.0 };
        let drawn = path.bounding_box().inflate(width / 2.0, width / 2.0);
        self.drawn = Some(self.drawn.map_or(drawn, |known| known.union(drawn)));
    }

    /// The name of a definition that follows in this way. Writes the definition the first time.
    fn referred(&mut self, id: &str, follow: Follow) -> Result<String, VectorError> {
        let Some(&node) = self.by_id.get(id) else { return Ok(id.to_owned()) };
        let key = format!("{id} {follow:?}");
        if let Some(name) = self.made.get(&key) {
            return Ok(name.clone());
        }
        let is_first = self.made.insert(id.to_owned(), String::new()).is_none();
        let name = if is_first { id.to_owned() } else { self.new_name(id) };
        self.made.insert(key, name.clone());
        let mut xml = Xml::default();
        let was_defining = std::mem::replace(&mut self.is_defining, true);
        self.definition(&mut xml, node, follow, &name)?;
        self.is_defining = was_defining;
        self.defs.push_str(&xml.into_text());
        Ok(name)
    }

    fn new_name(&mut self, id: &str) -> String {
        let free = (2..).map(|count| format!("{id}-{count}")).find(|name| !self.taken.contains(name));
        let name = free.expect("the counter does not end");
        self.taken.insert(name.clone());
        name
    }

    fn definition(
        &mut self,
        xml: &mut Xml,
        node: Node<'a, 'input>,
        follow: Follow,
        name: &str,
    ) -> Result<(), VectorError> {
        let tag = node.tag_name().name();
        let (moving, content) = match tag {
            "linearGradient" | "radialGradient" => (Some("gradientTransform"), Follow::Stay),
            "pattern" => (Some("patternTransform"), Follow::Stay),
            "clipPath" => (None, follow.within(transform(node, "transform"))),
            "mask" | "filter" => (None, follow),
            _ => return self.element(xml, node, follow, Some(name)),
        };
        let frame = match (tag, follow.to_pixels()) {
            ("mask" | "filter", Some(to_pixels)) => {
                rectangle(node, Rect::ZERO).map(|frame| self.frame(frame, to_pixels))
            }
            _ => None,
        };
        let framed = frame.map_or_else(Vec::new, rectangle_attributes);
        xml.open(tag);
        for attribute in node.attributes() {
            let key = qualified(attribute.namespace(), attribute.name());
            if Some(&*key) != moving && !framed.iter().any(|(name, _)| *name == key) {
                self.attribute(xml, &key, attribute.value(), follow, Some(name))?;
            }
        }
        for (key, value) in framed {
            xml.attribute(key, value);
        }
        if let Some(key) = moving {
            let own = transform(node, key);
            let is_in_user_space =
                node.attribute("gradientUnits").or(node.attribute("patternUnits")) == Some("userSpaceOnUse");
            let moved = if let (Follow::Move(by), true) = (follow, is_in_user_space) { by * own } else { own };
            if moved != Affine::IDENTITY {
                xml.attribute(key, matrix(moved));
            }
        }
        self.children(xml, node, content)?;
        xml.close(tag);
        Ok(())
    }

    /// The rectangle around a bent rectangle, in its own units.
    fn frame(&self, frame: Rect, to_pixels: Affine) -> Rect {
        let back = to_pixels.inverse();
        let places = grid(frame, SIDE_POINTS).map(|p| back * self.warp.place(to_pixels * p));
        places.map(|p| Rect::from_points(p, p)).reduce(|one, other| one.union(other)).unwrap_or(frame)
    }

    /// The rectangle of a part of a filter.
    fn filter_part(&self, node: Node<'_, '_>, follow: Follow) -> Vec<(&'static str, String)> {
        let whole = node.parent().and_then(|filter| rectangle(filter, Rect::ZERO)).unwrap_or(Rect::ZERO);
        let has_own = ["width", "height"].iter().any(|name| node.attribute(*name).is_some());
        match (follow.to_pixels(), rectangle(node, whole)) {
            (Some(to_pixels), Some(frame)) if has_own => rectangle_attributes(self.frame(frame, to_pixels)),
            _ => Vec::new(),
        }
    }

    /// The transform of a picture that moves as a whole.
    fn picture_transform(&self, node: Node<'_, '_>, follow: Follow) -> Option<String> {
        let to_pixels = follow.to_pixels()?;
        let frame = rectangle(node, Rect::ZERO)?;
        let rest: Vec<Point> = grid(to_pixels.transform_rect_bbox(frame), SIDE_POINTS).collect();
        if !self.warp.moves(&rest) {
            return None;
        }
        let places: Vec<[Point; 2]> = rest.into_iter().map(|p| [p, self.warp.place(p)]).collect();
        let local = to_pixels.inverse() * affine_of(&places, &self.warp) * to_pixels;
        Some(matrix(transform(node, "transform") * local))
    }
}

/// Points of a rectangle in rows, with its corners.
fn grid(frame: Rect, pieces: u32) -> impl Iterator<Item = Point> {
    let at = move |k: u32| f64::from(k) / f64::from(pieces);
    (0..=pieces).flat_map(move |row| {
        (0..=pieces)
            .map(move |column| Point::new(frame.x0 + frame.width() * at(column), frame.y0 + frame.height() * at(row)))
    })
}

/// The attributes x, y, width and height; those left out as in another rectangle. `None` without an area.
fn rectangle(node: Node<'_, '_>, or: Rect) -> Option<Rect> {
    let length = |name: &str| node.attribute(name).and_then(|text| text.parse::<f64>().ok());
    let origin = Point::new(length("x").unwrap_or(or.x0), length("y").unwrap_or(or.y0));
    let size = (length("width").unwrap_or(or.width()), length("height").unwrap_or(or.height()));
    Some(Rect::from_origin_size(origin, size)).filter(|frame| frame.is_finite() && frame.area() > 0.0)
}

fn rectangle_attributes(frame: Rect) -> Vec<(&'static str, String)> {
    let values = [("x", frame.x0), ("y", frame.y0), ("width", frame.width()), ("height", frame.height())];
    values.map(|(name, value)| (name, number(value, 6))).into()
}

/// The transform in an attribute, as usvg writes it.
fn transform(node: Node<'_, '_>, name: &str) -> Affine {
    let text = node.attribute(name).and_then(|text| text.strip_prefix("matrix(")?.strip_suffix(')'));
    text.and_then(|text| <[f64; 6]>::try_from(numbers(text)).ok()).map_or(Affine::IDENTITY, Affine::new)
}

fn numbers(text: &str) -> Vec<f64> {
    text.split([' ', ',']).filter_map(|number| number.parse().ok()).collect()
}

fn matrix(affine: Affine) -> String {
    let coefficients = affine.as_coeffs();
    format!("matrix({})", coefficients.map(|value| number(value, 8)).join(" "))
}

fn stroke_width(node: Node<'_, '_>) -> f64 {
    node.attribute("stroke-width").and_then(|width| width.parse().ok()).unwrap_or(1.0)
}

fn qualified(namespace: Option<&str>, name: &str) -> String {
    if namespace == Some(XLINK) { format!("xlink:{name}") } else { name.to_owned() }
}
