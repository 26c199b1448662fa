//! What is too small, too large, too many or too close: beyond these limits come errors that name them.

/// Least number of pixels on a side: smaller pictures have nothing to bend.
pub const MIN_SIDE: u32 = 2;
/// Greatest number of pixels on a side: the texture limit of most graphics hardware.
pub const MAX_SIDE: u32 = 16_384;
/// Greatest number of pixels: 400 MB of RGBA, which a browser tab can hold twice.
pub const MAX_PIXELS: u64 = 100_000_000;

/// Greatest coordinate, in pixels and either direction, of a mesh, a point cloud or rings without a picture: its rounding is four
/// digits below the tolerance of the outline.
pub const MAX_COORDINATE: f64 = 1e6;

/// Greatest number of corners of an outline. Each corner can bend shortest paths, so this bounds the cost of a distance
/// field.
pub const MAX_CORNERS: usize = 20_000;

/// Sites closer than this, in pixels, coincide.
pub const MIN_SEPARATION: f64 = 0.01;
/// Greatest number of handles in one solve.
pub const MAX_HANDLES: usize = 1000;
/// Greatest number of sites, real and virtual, in one solve.
pub const MAX_SITES: usize = 8192;

/// A held boundary keeps bones this far away, in pixels: on it nothing can both move and stay.
pub(crate) const HELD_CLEARANCE: f64 = 1.0;
