//! Writes the elements of a drawing again.

use std::collections::{HashMap, HashSet};

use kurbo::{Affine, BezPath, Point, Rect, Shape};
use usvg::roxmltree::{Document, Node};

use super::{
    attributes::{matrix, numbers, qualified, rectangle, rectangle_attributes, stroke_width, transform},
    follow::Follow,
};
use crate::{
    error::VectorError,
    outline::{self, digits, path_text},
    spread::{affine_of, growth},
    warp::Warp,
    xml::{Xml, number},
};

/// Maximum number of segments of all paths.
const MAX_NODES: usize = 300_000;
/// Number of points along each side of a rectangle, and of a picture, at which the warp is evaluated.
const SIDE_POINTS: u32 = 8;

pub(super) struct Rewriter<'a, 'input> {
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    taken: HashSet<String>,
    /// Names of written definitions, by original name and how they follow the warp.
    made: HashMap<String, String>,
    pub(super) defs: String,
    warp: Warp<'a>,
    pub(super) nodes: [usize; 2],
    /// The box around bent paths with their strokes, in image pixels.
    pub(super) drawn: Option<Rect>,
    is_defining: bool,
}

impl<'a, 'input> Rewriter<'a, 'input> {
    pub(super) fn new(document: &'a Document<'input>, warp: Warp<'a>) -> Self {
        let by_id: HashMap<&str, Node<'_, '_>> =
            document.descendants().filter_map(|node| Some((node.attribute("id")?, node))).collect();
        let taken = by_id.keys().map(|&id| id.to_owned()).collect();
        Self {
            by_id,
            taken,
            made: HashMap::new(),
            defs: String::new(),
            warp,
            nodes: [0; 2],
            drawn: None,
            is_defining: false,
        }
    }

    pub(super) fn element(
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

    /// Writes an attribute, with the new names of its definitions.
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

    /// The name of a definition that follows in this way. Writes the definition on first use.
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
