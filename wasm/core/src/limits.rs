//! Limits of sizes, counts and distances. An input beyond a limit is refused with an error that names the limit.

/// Least width and height of a picture, in pixels. A smaller picture has nothing to bend.
pub const MIN_SIDE: u32 = 2;
/// Greatest width and height of a picture, in pixels: the texture limit of most graphics hardware.
pub const MAX_SIDE: u32 = 16_384;
/// Greatest number of pixels of a picture: 400 MB of RGBA. A browser tab can hold that twice.
pub const MAX_PIXELS: u64 = 100_000_000;

/// Greatest length of a project file, in bytes. A picture that it holds is most of it.
pub const MAX_PROJECT_BYTES: usize = 100_000_000;
/// Greatest length of the name of a handle or a clip, in characters.
pub const MAX_NAME: usize = 200;

/// Greatest absolute coordinate of a mesh, a point cloud, or rings without a picture, in pixels.
///
/// Its rounding is four digits below the tolerance of the outline.
pub const MAX_COORDINATE: f64 = 1e6;

/// Greatest number of corners of an outline. Paths bend at corners, so this bounds the cost of a distance field.
pub const MAX_CORNERS: usize = 20_000;

/// Greatest number of sharp corners of a held boundary. Each needs a site, and sites around it.
pub const MAX_HELD_CORNERS: usize = 1000;
/// Greatest number of corners of an outline from a picture's alpha, if it is held. A solve then takes half a second.
pub(crate) const MAX_HELD_OUTLINE: usize = 250;
/// Greatest memory of distance fields in one solve, in bytes.
///
/// C² weights around a thousand small holes take nearly all of it, and nearly five seconds in a browser.
pub(crate) const MAX_FIELD_BYTES: usize = 9 << 25;
/// Greatest memory of the search for farthest points, in bytes.
pub(crate) const MAX_PIECE_BYTES: usize = 3 << 27;
/// Greatest number of weights of all samples: 400 MB.
pub(crate) const MAX_WEIGHTS: usize = 1 << 25;
/// Greatest number of steps of Algorithm 1: a window that is carried through a triangle, or a look at a path.
///
/// Each takes some 10 to 50 ns. A line of 300 handles takes three fifths of them.
pub const MAX_STEPS: u64 = 100_000_000;
/// Greatest absolute number of a pose: a coordinate in pixels, a scale, or a depth.
pub(crate) const MAX_POSED: f64 = 1e12;

/// Greatest number of frames in a second of a film.
pub const MAX_FRAME_RATE: f64 = 240.0;
/// Greatest number of frames of a film: ten minutes at 60 a second.
pub const MAX_FRAMES: u32 = 36_000;

/// Sites closer than this, in pixels, coincide.
pub const MIN_SEPARATION: f64 = 0.01;
/// Greatest number of handles in one solve.
pub const MAX_HANDLES: usize = 1000;
/// Greatest number of point handles that stand close to another one, each with the distance that counts as close, over
/// the diagonal of the domain. Their cells are strips, and each pair of strips is compared.
pub const MAX_CLOSE_HANDLES: [(f64, usize); 2] = [(1.0 / 500.0, 200), (1.0 / 5000.0, 50)];
/// Greatest length of an outline, over its diagonal. In a longer one most of the domain lies in slits and spikes, and
/// each needs sites of its own.
pub const MAX_OUTLINE_LENGTH: f64 = 200.0;
/// Greatest number of sites, real and virtual, in one solve. A held outline with as many corners as it may have takes
/// nearly all.
pub const MAX_SITES: usize = 5000;

/// Distance that bones keep from a fixed boundary, in pixels. A point on the boundary cannot both move and stay.
pub(crate) const HELD_CLEARANCE: f64 = 1.0;
