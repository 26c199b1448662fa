//! Drawings bent by a solution: SVG in, SVG out.
//!
//! - `drawing`: an SVG, simplified by usvg: shapes are paths, styles are attributes, references are resolved.
//! - `style`: style sheets as attributes. `burden`: the number of elements that usvg will create. `cost`: the time and
//!   memory that drawing will take. `draw`: the pixels, drawn by resvg.
//! - `course`: the bent course of one segment, sampled according to its curvature.
//! - `fit`: few Béziers along a course.
//! - `outline`: a path, segment by segment. `warp`: the map of the picture in the units of the drawing.
//! - `rewrite`: writes the drawing with bent paths. `spread`: the affine map that gradients, patterns and pictures
//!   follow.
//!
//! Guaranteed: a bent path is at most [`TOLERANCE`] pixels from the map of the path, plus 0.002 for the rounding of
//! numbers. The drawing order is preserved.
//!
//! Cost: a few evaluations of the map for every eight pixels of a path.

mod burden;
mod cost;
mod course;
#[cfg(feature = "draw")]
mod draw;
mod drawing;
mod error;
mod fit;
mod outline;
mod remark;
mod rewrite;
mod spread;
mod style;
mod warp;
mod xml;

pub use drawing::{Drawing, MAX_BYTES};
pub use error::VectorError;
pub use fit::TOLERANCE;
pub use remark::Remark;
pub use rewrite::{Bent, BentOptions};
#[cfg(feature = "text")]
pub use usvg::fontdb;
