//! The estimated time and memory for drawing pixels.
//!
//! `walk`: groups, paths and pictures. `filter`: filters.
//!
//! Follows resvg 0.49. Each isolated group, mask and clip path has a layer. Each primitive of a filter has a picture
//! that is kept until the filter ends. A pattern is drawn for each path. Positions are ignored: a shape outside the
//! picture costs as much as one inside.
//!
//! Times are nanoseconds on one core of 2024, measured for each kind of work. Cost: one traversal of the tree.

mod filter;
mod walk;

use usvg::Transform;

use crate::{burden::Burden, drawing::Drawing, error::VectorError};

/// Maximum drawing time in nanoseconds.
const MAX_TIME: f64 = 2e10;
/// Maximum memory of simultaneous layers in bytes, besides the picture.
const MAX_BYTES: f64 = 1.5e9;

/// A browser draws a drawing below these bounds in a tenth of a second. Copies take the longest.
const LIGHT_TIME: f64 = 3e8;
const LIGHT_ELEMENTS: u64 = 5_000;
const LIGHT_COPIES: u64 = 200;

/// The cost of drawing pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Nanoseconds.
    pub time: f64,
    /// Peak memory in bytes.
    pub bytes: f64,
    burden: Burden,
}

impl Cost {
    /// Whether a browser draws the drawing quickly.
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
        if tally.time.is_nan() || tally.time > MAX_TIME {
            return Err(VectorError::TooSlow { cause: cause(|share| share.time) });
        }
        if tally.most_bytes.is_nan() || tally.most_bytes > MAX_BYTES {
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

    /// The largest area of the canvas that a box can cover.
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
/// Nanoseconds for drawing one node of the tree.
const NODE: f64 = 500.0;
/// Bytes of a pixel.
const PIXEL_BYTES: f64 = 4.0;

/// The cost of all elements with one name.
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
}
