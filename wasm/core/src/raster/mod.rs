//! The software rasteriser that warps a picture at full quality, for export and as the reference for GPU rendering.
//!
//! It draws every triangle of the mesh from its rest position to its posed position, later triangles over earlier ones.
//! Coverage follows multisampling hardware: 4×4 samples per pixel, shaded once per pixel and triangle at the pixel's
//! centre. The top-left rule in fixed-point arithmetic draws each sample between neighbours exactly once, so an opaque
//! picture has no seams.
//!
//! A cubic filter reads the premultiplied picture. It is sharper than the bilinear filter of hardware. Where the
//! picture shrinks, the filter widens along x and y to the footprint of a pixel. Colours are bytes without gamma
//! correction, as in a browser's canvas. [`Filter::Nearest`](options::Filter::Nearest) turns filtering and
//! multisampling off, for pixel art.
//!
//! The result has the same bits on every machine. The code uses integers, f64 and f32 addition, multiplication,
//! division and square roots, and the logarithm of `libm`.
//!
//! Cost: linear in the pixels drawn. 12 megapixels take between one and two seconds. [`Drawing`] draws them in bands of
//! rows. Besides the result, memory holds about 110 bytes per triangle and a band of 16 rows. If any part shrinks to a
//! quarter, mip levels take 8 bytes for a third of the picture's pixels.
//!
//! Limits:
//! - The filter is aligned with x and y. A picture that shrinks along a diagonal is also blurred across it.
//! - The cubic overshoots hard edges by up to 7 % of the step.
//! - Triangles with a corner more than a million pixels outside are not drawn.
//! - Fully transparent pixels become transparent black, regardless of their colour.

mod band;
mod covered;
mod drawing;
mod edges;
pub(crate) mod extent;
mod facet;
mod fade;
mod footprint;
mod frame;
mod kernel;
mod layers;
pub(crate) mod options;
mod solution;
pub(crate) mod sources;
#[cfg(test)]
mod tests;
mod texture;
pub(crate) mod warped;

pub use self::drawing::Drawing;

use glam::DVec2;

use self::facet::Facet;
use self::options::ResampleOptions;
use self::warped::Warped;
use crate::{
    error::Error,
    limits::{MAX_PIXELS, MAX_SIDE},
    picture::Picture,
};

/// Rows per band: enough to amortise the setup of triangles, few enough for the cache.
const BAND_ROWS: usize = 16;

/// Returns the size in pixels of a picture warped at `scale`: `round(width × scale)` by `round(height × scale)`.
///
/// # Errors
/// [`Error::Scale`] if `scale` is not a positive number, or if the result would be empty or larger than a picture may
/// be.
pub fn warped_size(width: u32, height: u32, scale: f64) -> Result<(u32, u32), Error> {
    size(width, height, scale).ok_or(Error::Scale { scale, width, height })
}

fn size(width: u32, height: u32, scale: f64) -> Option<(u32, u32)> {
    let side = |length: u32| {
        let side = (f64::from(length) * scale).round();
        // NaN is not in the range.
        (1.0..=f64::from(MAX_SIDE)).contains(&side).then_some(side as u32)
    };
    let (width, height) = (side(width)?, side(height)?);
    (u64::from(width) * u64::from(height) <= MAX_PIXELS).then_some((width, height))
}

/// Warps a picture by a mesh.
///
/// `rest` and `posed` hold the position of each vertex in image pixels. `triangles` index them, in either orientation,
/// and are drawn in order.
///
/// ```
/// use c2warp::{Canvas, ResampleOptions, Picture, glam::DVec2, raster::warp};
///
/// let rgba: Vec<u8> = (0..16 * 8).flat_map(|i| [i, 2 * i, 0, 255]).collect();
/// let picture = Picture::new(16, 8, &rgba)?;
/// let rest = [(0.0, 0.0), (16.0, 0.0), (16.0, 8.0), (0.0, 8.0)].map(DVec2::from);
/// let moved = rest.map(|corner| corner + DVec2::new(4.0, 0.0));
/// let grown = ResampleOptions { canvas: Canvas::Grown, ..ResampleOptions::default() };
/// let warped = warp(&picture, &rest, &moved, &[[0, 1, 2], [0, 2, 3]], grown)?;
/// assert_eq!((warped.width, warped.height, warped.origin), (20, 8, [0, 0]));
/// assert_eq!(warped.rgba[4 * 4..20 * 4], rgba[..16 * 4]);
/// # Ok::<(), c2warp::Error>(())
/// ```
///
/// The result has the size [`warped_size`] on the picture's own canvas. It is transparent outside the triangles. A mesh
/// at rest with scale 1 returns the picture's bytes. All canvases give the same bytes where they overlap.
///
/// # Errors
/// Those of [`Drawing::new`].
///
/// # Panics
/// If `rest` and `posed` differ in length, or a triangle refers to a vertex that does not exist.
pub fn warp(
    picture: &Picture<'_>,
    rest: &[DVec2],
    posed: &[DVec2],
    triangles: &[[u32; 3]],
    options: ResampleOptions,
) -> Result<Warped, Error> {
    Ok(Drawing::new(picture, rest, posed, triangles, options)?.warped(picture))
}

/// A mesh that a drawing shows, over those before it.
pub(crate) struct MeshLayer<'a> {
    pub(crate) rest: &'a [DVec2],
    pub(crate) posed: &'a [DVec2],
    pub(crate) triangles: &'a [[u32; 3]],
    /// The levels of the vertices of a mesh that [fades out](fade).
    pub(crate) levels: Option<&'a [f64]>,
}

/// Returns an error if a corner is too far out to be rasterised.
fn check_range(posed: &[DVec2], triangles: &[[u32; 3]], scale: f64) -> Result<(), Error> {
    let corners = || triangles.iter().flatten().map(|&vertex| posed[vertex as usize] * scale);
    if corners().all(facet::is_in_range) {
        return Ok(());
    }
    let (low, high) = corners().fold((DVec2::ZERO, DVec2::ZERO), |(low, high), p| (low.min(p), high.max(p)));
    let [width, height] = (high - low).to_array().map(|side| side.ceil() as u64);
    Err(Error::Canvas { width, height })
}

/// Returns the facets that touch each band of rows, in drawing order.
fn facets_by_band(facets: &[Facet], height: usize) -> Vec<Vec<u32>> {
    let mut bins = vec![Vec::new(); height.div_ceil(BAND_ROWS)];
    for (index, facet) in (0..).zip(facets) {
        let rows = facet.rows(height);
        if !rows.is_empty() {
            for bin in &mut bins[rows.start / BAND_ROWS..=(rows.end - 1) / BAND_ROWS] {
                bin.push(index);
            }
        }
    }
    bins
}
