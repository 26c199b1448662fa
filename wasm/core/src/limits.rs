//! Limits of sizes, counts and distances. An input beyond a limit is rejected with an error that names the limit.

/// Minimum width and height of a picture, in pixels. A smaller picture has nothing to bend.
pub const MIN_SIDE: u32 = 2;
/// Maximum width and height of a picture, in pixels: the texture limit of most graphics hardware.
pub const MAX_SIDE: u32 = 16_384;
/// Maximum number of pixels of a picture: 400 MB of RGBA. A browser tab can hold that twice.
pub const MAX_PIXELS: u64 = 100_000_000;

/// Greatest length of a project file, in bytes. A picture that it holds is most of it.
pub const MAX_PROJECT_BYTES: usize = 100_000_000;
/// Greatest length of the name of a handle or a clip, in characters.
pub const MAX_NAME: usize = 200;

/// Greatest absolute coordinate of a mesh, a point cloud, or rings without a picture, in pixels.
///
/// Its rounding error is four digits below the tolerance of the outline.
pub const MAX_COORDINATE: f64 = 1e6;

/// Maximum number of corners of an outline. Paths bend at corners, so this bounds the cost of a distance field.
pub const MAX_CORNERS: usize = 20_000;

/// Maximum number of sharp corners of a held boundary. Each corner needs a site, and sites around it.
pub const MAX_HELD_CORNERS: usize = 1000;
/// Maximum number of corners of an outline from a picture's alpha, if it is held. A solve then takes half a second.
pub(crate) const MAX_HELD_OUTLINE: usize = 250;
/// Maximum memory of distance fields in one solve, in bytes.
///
/// C² weights around a thousand small holes use nearly all of it, and take nearly five seconds in a browser.
pub(crate) const MAX_FIELD_BYTES: usize = 9 << 25;
/// Maximum memory of the search for farthest points, in bytes.
pub(crate) const MAX_PIECE_BYTES: usize = 3 << 27;
/// Maximum number of weights of all samples: 400 MB.
pub(crate) const MAX_WEIGHTS: usize = 1 << 25;
/// Maximum number of steps of Algorithm 1: carrying a window through a triangle, or checking a path.
///
/// Each takes about 10 to 50 ns. A line of 300 handles needs three fifths of them.
pub const MAX_STEPS: u64 = 100_000_000;
/// Greatest absolute number of a pose: a coordinate in pixels, a scale, or a depth.
pub(crate) const MAX_POSED: f64 = 1e12;

/// Maximum frame rate of a film, in frames per second.
pub const MAX_FRAME_RATE: f64 = 240.0;
/// Maximum number of frames of a film: ten minutes at 60 frames per second.
pub const MAX_FRAMES: u32 = 36_000;

/// Sites closer than this, in pixels, coincide.
pub const MIN_SEPARATION: f64 = 0.01;
/// Maximum number of handles in one solve.
pub const MAX_HANDLES: usize = 1000;
/// Limits for point handles that are close to another one: the maximum number of such handles, and the distance that
/// counts as close, relative to the diagonal of the domain. Their cells are strips, and each pair of strips is
/// compared.
pub const MAX_CLOSE_HANDLES: [(f64, usize); 2] = [(1.0 / 500.0, 200), (1.0 / 5000.0, 50)];
/// Maximum length of an outline, over its diagonal. In a longer outline, most of the domain consists of slits and
/// spikes, each of which needs its own sites.
pub const MAX_OUTLINE_LENGTH: f64 = 200.0;
/// Maximum number of sites, real and virtual, in one solve. A held outline with the maximum number of corners needs
/// nearly all of them.
pub const MAX_SITES: usize = 5000;

/// Distance that bones keep from a fixed boundary, in pixels. A point on the boundary cannot both move and be fixed.
pub(crate) const HELD_CLEARANCE: f64 = 1.0;
