//! The cost of groups, paths and pictures.

use usvg::{Group, Image, ImageKind, Node, Opacity, Paint, Path, Transform, tiny_skia_path::PathSegment};

use super::{MAX_TIME, NODE, PIXEL_BYTES, Surface, Tally};

/// Nanoseconds per pixel.
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
/// Strokes with more dashes are drawn without.
const MAX_DASHES: f64 = 1e6;
/// Bytes of a dash.
const DASH_BYTES: f64 = 200.0;

impl Tally {
    pub(super) fn group_content(&mut self, group: &Group, surface: Surface, transform: Transform) {
        for node in group.children() {
            // The drawing is already rejected.
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

    /// A mask is as large as its layer. Masks of masks exist at the same time.
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
                // A tile has its full size, even if only a part of it is visible.
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
