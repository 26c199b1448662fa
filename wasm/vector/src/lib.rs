//! Drawings bent by a solution: SVG in, SVG out.
//!
//! - `drawing`: an SVG as usvg understands it: shapes are paths, styles are attributes, references are resolved.
//! - `style`: style sheets as attributes. `burden`: the elements that usvg makes, counted before. `cost`: the time and
//!   memory that drawing pixels takes, known before. `draw`: the pixels, by resvg.
//! - `plain`: a drawing that was read.
//! - `course`: the bent course of one segment, sampled as finely as it bends.
//! - `fit`: few Béziers along a course.
//! - `outline`: a path, segment by segment. `warp`: the map of the picture in the units of the drawing.
//! - `rewrite`: the drawing again, with bent paths. `spread`: the affine map that gradients, patterns and pictures
//!   follow.
//!
//! Guaranteed: a bent path is at most [`TOLERANCE`] pixels from the map of the path, besides 0.002 by the rounding
//! of numbers. The order of drawing stays.
//!
//! Cost: some evaluations of the map for every eight pixels of a path.

#[cfg(feature = "read")]
mod burden;
#[cfg(feature = "read")]
mod cost;
mod course;
#[cfg(feature = "draw")]
mod draw;
#[cfg(feature = "read")]
mod drawing;
mod error;
mod fit;
mod outline;
mod plain;
#[cfg(feature = "read")]
mod remark;
mod rewrite;
mod spread;
#[cfg(feature = "read")]
mod style;
mod warp;
mod xml;

#[cfg(feature = "read")]
pub use drawing::{Drawing, MAX_BYTES};
pub use error::VectorError;
pub use fit::TOLERANCE;
pub use plain::PlainDrawing;
#[cfg(feature = "read")]
pub use remark::Remark;
pub use rewrite::{Bent, BentOptions};
#[cfg(feature = "text")]
pub use usvg::fontdb;
