//! The warp on the CPU at full quality: for export, and as the reference for GPU rendering.
//!
//! Every triangle of the mesh is drawn from its rest place to its posed place, later ones over earlier ones. Coverage is that of
//! graphics hardware with multisampling: 4×4 samples a pixel, shaded once per pixel and triangle at the pixel's centre, by the
//! top-left rule in fixed-point arithmetic, so that no sample between neighbours is missed or drawn twice, and an opaque picture
//! has no seams. The picture is read premultiplied by a cubic, which keeps it sharper than the bilinear filter of hardware; where
//! it shrinks, by one as wide as a pixel is there, along x and y. Colours are bytes without gamma correction, as in a browser's
//! canvas. Pixel art is drawn without any of that, by [`Filter::Nearest`](options::Filter::Nearest).
//!
//! Only integers and f64 or f32 addition, multiplication, division and square roots are used (and `libm`'s logarithm): the
//! result has the same bits on every machine.
//!
//! Cost: linear in the pixels drawn; 12 megapixels take between one and two seconds. Besides the result, memory for a third of
//! the picture's pixels at 8 bytes (only where something shrinks to a quarter), some 110 bytes a triangle, and a band of 16 rows.
//!
//! Limits: the filter lies along x and y, so what shrinks along a diagonal only is blurred across it, too; at hard edges the cubic
//! overshoots by up to 7 % of the step; triangles with a corner more than a million pixels out are not drawn; pixels without
//! opacity become transparent black, whatever their colour.

mod band;
mod facet;
mod footprint;
mod frame;
mod kernel;
pub(crate) mod options;
pub(crate) mod sources;
#[cfg(test)]
mod tests;
mod texture;
pub(crate) mod warped;

pub use self::sources::sources;

use glam::DVec2;

use self::band::Band;
use self::facet::{Facet, mesh_facets};
use self::frame::Frame;
use self::options::{Canvas, ResampleOptions};
use self::texture::Texture;
use self::warped::Warped;
use crate::{
    error::Error,
    limits::{MAX_PIXELS, MAX_SIDE},
    picture::Picture,
};

/// Rows in a band: enough to set up triangles rarely, few enough for the cache.
const BAND_ROWS: usize = 16;

/// The size in pixels of a picture warped at a scale: `round(width × scale)` by `round(height × scale)`.
///
/// # Errors
/// [`Error::Scale`] if the scale is not a positive number, or the result would have no pixel or more than a picture may have.
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

/// Draws a mesh from its rest places in the picture to its posed places.
///
/// `rest` and `posed` are the mesh's vertices in image pixels, in the same number; `triangles` index them and are drawn in
/// order, in either orientation.
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
/// The result has the size [`warped_size`], or more where the canvas grows, and is transparent where there is no triangle. A
/// mesh at rest with scale 1 returns the picture's bytes. On either canvas the bytes within the picture's own rectangle are the
/// same.
///
/// # Errors
/// [`Error::Scale`] as [`warped_size`]; [`Error::Canvas`] where it would grow beyond what a picture may have.
///
/// # Panics
/// If `rest` and `posed` differ in length, or a triangle refers to a vertex that does not exist.
pub fn warp(
    picture: &Picture<'_>,
    rest: &[DVec2],
    posed: &[DVec2],
    triangles: &[[u32; 3]],
    ResampleOptions { scale, canvas, filter }: ResampleOptions,
) -> Result<Warped, Error> {
    let picture_size = warped_size(picture.width(), picture.height(), scale)?;
    if canvas == Canvas::Grown {
        check_reach(posed, triangles, scale)?;
    }
    let mut facets = mesh_facets(rest, posed, triangles, scale);
    let frame = match canvas {
        Canvas::Picture => Frame::of_picture(picture_size),
        Canvas::Grown => Frame::of_picture(picture_size).around(&facets)?,
    };
    facets.iter_mut().for_each(|facet| facet.move_by(frame.origin));
    let [width, height] = frame.size;
    let texture = Texture::for_facets(*picture, filter, &facets);
    let bins = facets_by_band(&facets, height);

    let mut rgba = vec![0; width * height * 4];
    let mut band = Band::new(width, BAND_ROWS, frame.origin);
    for (rows, (index, bin)) in rgba.chunks_mut(width * BAND_ROWS * 4).zip(bins.iter().enumerate()) {
        if bin.is_empty() {
            continue;
        }
        band.clear(index * BAND_ROWS);
        for &facet in bin {
            band.draw(&facets[facet as usize], &texture);
        }
        band.resolve(rows);
    }
    let origin = frame.origin.map(|side| side as u32);
    let warped = Warped { width: width as u32, height: height as u32, origin, rgba };
    Ok(warped.trimmed(picture_size))
}

/// Refuses a mesh of which a part is too far out to be drawn.
fn check_reach(posed: &[DVec2], triangles: &[[u32; 3]], scale: f64) -> Result<(), Error> {
    let corners = || triangles.iter().flatten().map(|&vertex| posed[vertex as usize] * scale);
    if corners().all(facet::is_in_range) {
        return Ok(());
    }
    let (low, high) = corners().fold((DVec2::ZERO, DVec2::ZERO), |(low, high), p| (low.min(p), high.max(p)));
    let [width, height] = (high - low).to_array().map(|side| side.ceil() as u64);
    Err(Error::Canvas { width, height })
}

/// The facets that touch each band of rows, in drawing order.
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
