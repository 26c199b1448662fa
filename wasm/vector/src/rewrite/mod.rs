//! Writes a drawing with bent paths.
//!
//! Groups keep their transforms: a path is bent in image pixels, and converted back to its own units. A definition is
//! written once for each way in which it is bent. A clip path or mask bends like the paths. Gradients and patterns
//! follow the affine map closest to the warp over the path. Rectangles of masks and filters grow to contain the bent
//! rectangles.
//!
//! - `rewriter`: rewrites element by element. `follow`: how elements follow the warp. `attributes`: their values.

mod attributes;
mod follow;
mod rewriter;

use c2warp::ContinuedMap;
use kurbo::{Affine, Rect};
use usvg::roxmltree::{Document, Node};

use self::{attributes::XLINK, follow::Follow, rewriter::Rewriter};
use crate::{
    drawing::Drawing,
    error::VectorError,
    warp::Warp,
    xml::{Xml, number},
};

const SVG: &str = "http://www.w3.org/2000/svg";

/// How a bent drawing is framed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentOptions {
    /// Size of the output relative to the drawing's own size.
    pub scale: f64,
    /// Grow the frame to contain all paths.
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
    /// Number of nodes of the bent paths, before and after.
    pub nodes: [usize; 2],
    /// The upper left corner of the frame in the units of the drawing's own size: (0, 0) unless it grew.
    pub origin: [f64; 2],
}

impl Drawing {
    /// Bends the drawing. The drawing covers the solution's whole picture, whose size is given in pixels.
    ///
    /// # Errors
    /// [`VectorError::TooManyNodes`].
    pub fn bent(&self, map: &ContinuedMap<'_>, picture: (u32, u32), options: BentOptions) -> Result<Bent, VectorError> {
        let [width, height] = self.size();
        let to_pixels = Affine::scale_non_uniform(f64::from(picture.0) / width, f64::from(picture.1) / height);
        let document = Document::parse(&self.text).map_err(|reason| VectorError::Xml(reason.to_string()))?;
        let mut rewriter = Rewriter::new(&document, Warp { map });
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
