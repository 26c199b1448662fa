//! The cost of filters.

use usvg::{
    Transform,
    filter::{Filter, Kind},
};

use super::{MAX_TIME, NODE, PIXEL_BYTES, Surface, Tally};

/// Greatest deviation of a blur in pixels. A picture with a greater blur is invisible.
const MAX_DEVIATION: f64 = 1e5;
/// Greatest offset in pixels. Greater ones overflow in resvg.
const MAX_OFFSET: f64 = 1e6;

/// Below this deviation in pixels, resvg blurs exactly.
const LEAST_BOX: f64 = 2.0;

impl Tally {
    pub(super) fn filter(&mut self, filter: &Filter, layer: Surface, transform: Transform) {
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
            // Each result is kept until the filter ends.
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

/// Nanoseconds per pixel of each input of a primitive: a copy, converted colours, and clipping.
const COPIED: f64 = 12.0;

/// The name of a primitive, and its nanoseconds per pixel.
fn primitive_time(kind: &Kind, region: Surface, scale: [f64; 2]) -> (&'static str, f64) {
    let blur = |deviations: [f32; 2]| {
        let pixels = [0, 1].map(|axis| f64::from(deviations[axis]) * scale[axis]);
        match pixels[0].max(pixels[1]) {
            most if most > MAX_DEVIATION => f64::INFINITY,
            most if most < LEAST_BOX => 1_100.0,
            _ => 170.0,
        }
    };
    let moved = |offset: [f32; 2], time: f64| {
        let pixels = [0, 1].map(|axis| f64::from(offset[axis]).abs() * scale[axis]);
        if pixels[0].max(pixels[1]) > MAX_OFFSET { f64::INFINITY } else { time }
    };
    match kind {
        Kind::Blend(_) => ("feBlend", 25.0),
        Kind::ColorMatrix(_) => ("feColorMatrix", 25.0),
        Kind::ComponentTransfer(_) => ("feComponentTransfer", 60.0),
        Kind::Composite(_) => ("feComposite", 25.0),
        Kind::ConvolveMatrix(fe) => {
            let matrix = fe.matrix();
            // Twice the time of resvg, as browsers take.
            ("feConvolveMatrix", 25.0 + 16.0 * f64::from(matrix.columns()) * f64::from(matrix.rows()))
        }
        Kind::DiffuseLighting(_) => ("feDiffuseLighting", 50.0),
        Kind::DisplacementMap(_) => ("feDisplacementMap", 25.0),
        Kind::DropShadow(fe) => {
            let deviations = [fe.std_dev_x().get(), fe.std_dev_y().get()];
            ("feDropShadow", moved([fe.dx(), fe.dy()], 40.0 + blur(deviations)))
        }
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
        Kind::Offset(fe) => ("feOffset", moved([fe.dx(), fe.dy()], 10.0)),
        Kind::SpecularLighting(_) => ("feSpecularLighting", 200.0),
        Kind::Tile(_) => ("feTile", 15.0),
        Kind::Turbulence(fe) => ("feTurbulence", 20.0 + 110.0 * f64::from(fe.num_octaves())),
    }
}
