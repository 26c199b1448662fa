//! The time and memory that drawing pixels takes, known before a pixel is drawn.
//!
//! Follows resvg 0.49. Each isolated group, mask and clip path has a layer. Each part of a filter has a picture that
//! stays until the filter ends. A pattern is drawn for each path. Places are ignored: a shape outside of the picture
//! costs as much as one inside.
//!
//! Times are nanoseconds on one core of 2024, measured for each kind of work. Cost: one walk through the tree.

use usvg::{
    Group, Image, ImageKind, Node, Opacity, Paint, Path, Transform,
    filter::{Filter, Kind},
    tiny_skia_path::PathSegment,
};

use crate::{burden::Burden, drawing::Drawing, error::VectorError};

/// Longest time to draw, in estimated nanoseconds.
const MAX_TIME: f64 = 2e10;
/// Most bytes of layers at a time, besides the picture.
const MAX_BYTES: f64 = 1.5e9;
/// Greatest deviation of a blur in pixels. Nothing is left to see of a picture that is blurred so far.
const MAX_DEVIATION: f64 = 1e5;

/// Below this deviation in pixels, resvg blurs exactly.
const LEAST_BOX: f64 = 2.0;

/// A browser draws a drawing below these bounds in a tenth of a second. Uses take it longest.
const LIGHT_TIME: f64 = 3e8;
const LIGHT_ELEMENTS: u64 = 5_000;
const LIGHT_COPIES: u64 = 200;

/// The cost of drawing pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Nanoseconds.
    pub time: f64,
    /// Most bytes at a time.
    pub bytes: f64,
    burden: Burden,
}

impl Cost {
    /// Whether a browser draws it at once.
    #[must_use]
    pub fn is_light(&self) -> bool {
        let Burden { elements, copies, .. } = self.burden;
        self.time <= LIGHT_TIME && elements <= LIGHT_ELEMENTS && copies <= LIGHT_COPIES
    }
}

impl Drawing {
    /// The cost of drawing this at a size in pixels.
    ///
    /// # Errors
    /// [`VectorError::TooSlow`] and [`VectorError::TooMuchMemory`].
    pub fn cost(&self, width: u32, height: u32) -> Result<Cost, VectorError> {
        let [own_width, own_height] = self.size();
        let scale = [f64::from(width) / own_width, f64::from(height) / own_height].map(|scale| scale as f32);
        let canvas = Surface::canvas(f64::from(width), f64::from(height));
        let mut tally = Tally::default();
        tally.group_content(self.tree.root(), canvas, Transform::from_scale(scale[0], scale[1]));
        let cause = |of: fn(&Share) -> f64| {
            let most = tally.shares.iter().max_by(|one, other| of(&one.1).total_cmp(&of(&other.1)));
            most.map_or("svg", |(cause, _)| cause)
        };
        // Sums that are no numbers are refused as well.
        if !(tally.time <= MAX_TIME) {
            return Err(VectorError::TooSlow { cause: cause(|share| share.time) });
        }
        if !(tally.most_bytes <= MAX_BYTES) {
            return Err(VectorError::TooMuchMemory { cause: cause(|share| share.bytes) });
        }
        Ok(Cost { time: tally.time, bytes: tally.most_bytes, burden: self.burden })
    }
}

/// The size of a layer or canvas in pixels.
#[derive(Debug, Clone, Copy)]
struct Surface {
    width: f64,
    height: f64,
    /// The largest layer on it.
    most: [f64; 2],
}

impl Surface {
    fn area(self) -> f64 {
        self.width * self.height
    }

    /// resvg bounds layers by five times the canvas each way.
    fn canvas(width: f64, height: f64) -> Self {
        Self { width, height, most: [5.0 * width, 5.0 * height] }
    }

    /// The part that a box covers at most.
    fn part(self, frame: Option<[f32; 2]>) -> Self {
        let [width, height] = frame.map_or([0.0; 2], |frame| frame.map(f64::from));
        Self { width: width.ceil().min(self.width), height: height.ceil().min(self.height), ..self }
    }

    /// A layer for a box.
    fn layer(self, frame: Option<[f32; 2]>) -> Self {
        let [width, height] = self.most;
        Self { width, height, ..self }.part(frame.map(|frame| frame.map(|side| side + LAYER_RIM)))
    }
}

/// Pixels by which a layer is larger than its box.
const LAYER_RIM: f32 = 4.0;

/// Nanoseconds for a pixel.
mod per_pixel {
    pub(super) const OPAQUE: f64 = 0.5;
    pub(super) const COLOR: f64 = 4.0;
    pub(super) const GRADIENT: f64 = 12.0;
    pub(super) const PATTERN: f64 = 15.0;
    pub(super) const PICTURE: f64 = 60.0;
    /// A layer: made, and drawn onto the one below.
    pub(super) const LAYER: f64 = 12.0;
    /// A mask or clip path: made and applied.
    pub(super) const MASK: f64 = 12.0;
    pub(super) const DECODED: f64 = 20.0;
}

/// Nanoseconds for a segment of a path, for one of a stroke, and for a dash.
const SEGMENT: f64 = 150.0;
const STROKED_SEGMENT: f64 = 1_500.0;
const DASH: f64 = 1_000.0;
/// Nanoseconds for each row of pixels that a segment crosses.
const ROW: f64 = 40.0;
/// Nanoseconds for a node of the tree.
const NODE: f64 = 500.0;
/// More dashes are not drawn.
const MAX_DASHES: f64 = 1e6;
/// Bytes of a pixel, and of a dash.
const PIXEL_BYTES: f64 = 4.0;
const DASH_BYTES: f64 = 200.0;

/// The part of elements of one name.
#[derive(Debug, Clone, Copy, Default)]
struct Share {
    time: f64,
    bytes: f64,
}

#[derive(Debug, Default)]
struct Tally {
    time: f64,
    bytes: f64,
    most_bytes: f64,
    shares: Vec<(&'static str, Share)>,
}

impl Tally {
    fn spend(&mut self, cause: &'static str, time: f64) {
        self.time += time;
        self.share(cause).time += time;
    }

    fn hold(&mut self, cause: &'static str, bytes: f64) {
        self.bytes += bytes;
        self.most_bytes = self.most_bytes.max(self.bytes);
        self.share(cause).bytes += bytes;
    }

    fn share(&mut self, cause: &'static str) -> &mut Share {
        let at = self.shares.iter().position(|(known, _)| *known == cause).unwrap_or_else(|| {
            self.shares.push((cause, Share::default()));
            self.shares.len() - 1
        });
        &mut self.shares[at].1
    }

    fn group_content(&mut self, group: &Group, surface: Surface, transform: Transform) {
        for node in group.children() {
            // The rest changes nothing.
            if self.time > MAX_TIME {
                return;
            }
            self.time += NODE;
            match node {
                Node::Group(group) => self.group(group, surface, transform),
                Node::Path(path) if path.is_visible() => self.path(path, surface, transform),
                Node::Image(image) if image.is_visible() => self.image(image, surface, transform),
                Node::Text(text) => self.group(text.flattened(), surface, transform),
                _ => {}
            }
        }
    }

    fn group(&mut self, group: &Group, surface: Surface, transform: Transform) {
        let transform = transform.pre_concat(group.transform());
        if !group.should_isolate() {
            return self.group_content(group, surface, transform);
        }
        let frame = group.layer_bounding_box().transform(transform).map(|frame| [frame.width(), frame.height()]);
        let layer = surface.layer(frame);
        let bytes = layer.area() * PIXEL_BYTES;
        self.hold("g", bytes);
        self.spend("g", layer.area() * per_pixel::LAYER);
        self.group_content(group, layer, transform);
        for filter in group.filters() {
            self.filter(filter, layer, transform);
        }
        let mut clip_path = group.clip_path();
        while let Some(clip) = clip_path {
            self.masked("clipPath", clip.root(), layer, transform.pre_concat(clip.transform()));
            clip_path = clip.clip_path();
        }
        let mut mask = group.mask();
        while let Some(one) = mask {
            self.masked("mask", one.root(), layer, transform);
            mask = one.mask();
        }
        self.bytes -= bytes;
    }

    /// A mask is as large as its layer. Masks of masks are there at once.
    fn masked(&mut self, cause: &'static str, root: &Group, layer: Surface, transform: Transform) {
        let bytes = layer.area() * (PIXEL_BYTES + 1.0);
        self.hold(cause, bytes);
        self.spend(cause, layer.area() * per_pixel::MASK);
        self.group_content(root, layer, transform);
        self.bytes -= bytes;
    }

    fn path(&mut self, path: &Path, surface: Surface, transform: Transform) {
        let (across, down) = transform.get_scale();
        let scale = f64::from(across.max(down));
        let outline = Outline::of(path, scale, surface);
        let frame = path.data().bounds().transform(transform).map(|frame| [frame.width(), frame.height()]);
        if let Some(fill) = path.fill() {
            let part = surface.part(frame);
            self.spend("path", outline.segments * SEGMENT + outline.rows * ROW);
            self.paint(fill.paint(), fill.opacity(), part.area(), surface, transform);
        }
        if let Some(stroke) = path.stroke() {
            let period: f64 = stroke.dasharray().map_or(0.0, |dashes| dashes.iter().map(|&dash| f64::from(dash)).sum());
            let length = outline.length / scale;
            let in_period = stroke.dasharray().map_or(0.0, |dashes| dashes.len() as f64 / 2.0);
            let dashes = if period > 0.0 { length / period * in_period } else { 0.0 };
            let dashes = if dashes > MAX_DASHES { 0.0 } else { dashes };
            self.spend("path", outline.segments * STROKED_SEGMENT + 2.0 * outline.rows * ROW + dashes * DASH);
            self.hold("path", dashes * DASH_BYTES);
            let width = f64::from(stroke.width().get()) * scale;
            let part = surface.part(frame.map(|frame| frame.map(|side| side + 2.0 * width as f32)));
            self.paint(stroke.paint(), stroke.opacity(), part.area().min(outline.length * width), surface, transform);
            self.bytes -= dashes * DASH_BYTES;
        }
    }

    fn paint(&mut self, paint: &Paint, opacity: Opacity, area: f64, surface: Surface, transform: Transform) {
        match paint {
            Paint::Color(_) if opacity == Opacity::ONE => self.spend("path", area * per_pixel::OPAQUE),
            Paint::Color(_) => self.spend("path", area * per_pixel::COLOR),
            Paint::LinearGradient(_) => self.spend("linearGradient", area * per_pixel::GRADIENT),
            Paint::RadialGradient(_) => self.spend("radialGradient", area * per_pixel::GRADIENT),
            Paint::Pattern(pattern) => {
                self.spend("pattern", area * per_pixel::PATTERN);
                let (across, down) = transform.pre_concat(pattern.transform()).get_scale();
                let rect = pattern.rect();
                // A tile has its full size, however small a part is seen.
                let tile = Surface {
                    width: f64::from((rect.width() * across).round()),
                    height: f64::from((rect.height() * down).round()),
                    ..surface
                };
                let bytes = tile.area() * PIXEL_BYTES;
                self.hold("pattern", bytes);
                self.spend("pattern", tile.area() * per_pixel::OPAQUE);
                self.group_content(pattern.root(), tile, Transform::from_scale(across, down));
                self.bytes -= bytes;
            }
        }
    }

    fn image(&mut self, image: &Image, surface: Surface, transform: Transform) {
        let bytes = match image.kind() {
            ImageKind::SVG(tree) => {
                let bytes = surface.area() * PIXEL_BYTES;
                self.hold("image", bytes);
                self.spend("image", surface.area() * per_pixel::LAYER);
                let canvas = Surface::canvas(surface.width, surface.height);
                self.group_content(tree.root(), canvas, transform);
                bytes
            }
            _ => {
                let size = [image.size().width(), image.size().height()];
                let pixels = f64::from(size[0]) * f64::from(size[1]);
                // Decoders hold a copy.
                let bytes = 2.0 * pixels * PIXEL_BYTES;
                self.hold("image", bytes);
                let (across, down) = transform.get_scale();
                let part = surface.part(Some([size[0] * across, size[1] * down]));
                self.spend("image", pixels * per_pixel::DECODED + part.area() * per_pixel::PICTURE);
                bytes
            }
        };
        self.bytes -= bytes;
    }

    fn filter(&mut self, filter: &Filter, layer: Surface, transform: Transform) {
        let frame = filter.rect().transform(transform).map(|frame| [frame.width(), frame.height()]);
        let region = layer.part(frame);
        let (across, down) = transform.get_scale();
        let mut bytes = 0.0;
        for primitive in filter.primitives() {
            if self.time > MAX_TIME {
                return;
            }
            let (name, time) = primitive_time(primitive.kind(), region, [across, down].map(f64::from));
            self.spend(name, NODE + region.area() * (time + COPIED));
            // Each result is there until the filter ends.
            let made = region.area() * PIXEL_BYTES;
            self.hold(name, made);
            bytes += made;
            if let Kind::Image(image) = primitive.kind() {
                let canvas = Surface { most: [region.width, region.height], ..region };
                self.group_content(image.root(), canvas, Transform::from_scale(across, down));
            }
        }
        self.bytes -= bytes;
    }
}

/// Nanoseconds for a pixel of each input of a filter's part: a copy, other colours, and the part that is cut off.
const COPIED: f64 = 12.0;

/// The name of a part of a filter, and its nanoseconds for a pixel.
fn primitive_time(kind: &Kind, region: Surface, scale: [f64; 2]) -> (&'static str, f64) {
    let blur = |deviations: [f32; 2]| {
        let pixels = [0, 1].map(|axis| f64::from(deviations[axis]) * scale[axis]);
        match pixels[0].max(pixels[1]) {
            most if most > MAX_DEVIATION => f64::INFINITY,
            most if most < LEAST_BOX => 1_100.0,
            _ => 170.0,
        }
    };
    match kind {
        Kind::Blend(_) => ("feBlend", 25.0),
        Kind::ColorMatrix(_) => ("feColorMatrix", 25.0),
        Kind::ComponentTransfer(_) => ("feComponentTransfer", 60.0),
        Kind::Composite(_) => ("feComposite", 25.0),
        Kind::ConvolveMatrix(fe) => {
            let matrix = fe.matrix();
            ("feConvolveMatrix", 25.0 + 8.0 * f64::from(matrix.columns()) * f64::from(matrix.rows()))
        }
        Kind::DiffuseLighting(_) => ("feDiffuseLighting", 50.0),
        Kind::DisplacementMap(_) => ("feDisplacementMap", 25.0),
        Kind::DropShadow(fe) => ("feDropShadow", 40.0 + blur([fe.std_dev_x().get(), fe.std_dev_y().get()])),
        Kind::Flood(_) => ("feFlood", 2.0),
        Kind::GaussianBlur(fe) => ("feGaussianBlur", blur([fe.std_dev_x().get(), fe.std_dev_y().get()])),
        Kind::Image(_) => ("feImage", 5.0),
        Kind::Merge(fe) => ("feMerge", 25.0 * fe.inputs().len() as f64),
        Kind::Morphology(fe) => {
            let side = |radius: f32, scale: f64, most: f64| (2.0 * f64::from(radius) * scale + 1.0).min(most);
            let columns = side(fe.radius_x().get(), scale[0], region.width);
            let rows = side(fe.radius_y().get(), scale[1], region.height);
            ("feMorphology", 5.0 + 2.0 * columns * rows)
        }
        Kind::Offset(_) => ("feOffset", 10.0),
        Kind::SpecularLighting(_) => ("feSpecularLighting", 200.0),
        Kind::Tile(_) => ("feTile", 15.0),
        Kind::Turbulence(fe) => ("feTurbulence", 20.0 + 110.0 * f64::from(fe.num_octaves())),
    }
}

/// The segments of a path.
struct Outline {
    segments: f64,
    /// In pixels.
    length: f64,
    /// Rows of pixels that segments cross.
    rows: f64,
}

impl Outline {
    fn of(path: &Path, scale: f64, surface: Surface) -> Self {
        let mut outline = Self { segments: 0.0, length: 0.0, rows: 0.0 };
        let (mut last, mut first) = ([0.0_f64; 2], [0.0_f64; 2]);
        for segment in path.data().segments() {
            let points = match segment {
                PathSegment::MoveTo(p) => {
                    last = [p.x, p.y].map(f64::from);
                    first = last;
                    continue;
                }
                PathSegment::LineTo(p) => vec![[p.x, p.y]],
                PathSegment::QuadTo(p, q) => vec![[p.x, p.y], [q.x, q.y]],
                PathSegment::CubicTo(p, q, r) => vec![[p.x, p.y], [q.x, q.y], [r.x, r.y]],
                PathSegment::Close => vec![first.map(|part| part as f32)],
            };
            outline.segments += 1.0;
            for point in points.into_iter().map(|point| point.map(f64::from)) {
                let [x, y] = [point[0] - last[0], point[1] - last[1]];
                let length = x.hypot(y) * scale;
                outline.length += length;
                outline.rows += length.min(surface.height);
                last = point;
            }
        }
        outline
    }
}
