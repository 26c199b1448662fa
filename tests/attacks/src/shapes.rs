//! Places and shapes from arbitrary bytes.
//!
//! Most places lie on a coarse grid, so that points coincide and lines run along each other. Others are a small step
//! away from the place before, or have any coordinates.

use arbitrary::{Result, Unstructured};
use c2warp::glam::DVec2;

/// Side of the square of most places, in pixels.
pub(crate) const SIDE: u32 = 64;

/// Returns a place.
pub(crate) fn place(u: &mut Unstructured<'_>, before: DVec2) -> Result<DVec2> {
    Ok(match u.int_in_range(0..=15_u8)? {
        // Half pixels: the centres and corners.
        0..=9 => DVec2::new(on_grid(u)?, on_grid(u)?),
        10 => DVec2::new(before.x, on_grid(u)?),
        11 => DVec2::new(on_grid(u)?, before.y),
        12 | 13 => before + DVec2::new(f64::from(u.arbitrary::<i8>()?), f64::from(u.arbitrary::<i8>()?)) * small(u)?,
        14 => DVec2::new(u.arbitrary::<u32>()?.into(), u.arbitrary::<u32>()?.into()) * (f64::from(SIDE) / u32_range()),
        _ => DVec2::new(u.arbitrary()?, u.arbitrary()?),
    })
}

fn u32_range() -> f64 {
    f64::from(u32::MAX)
}

fn on_grid(u: &mut Unstructured<'_>) -> Result<f64> {
    Ok(f64::from(u.int_in_range(0..=2 * SIDE)?) / 2.0)
}

/// Returns a step between rounding errors and a pixel.
fn small(u: &mut Unstructured<'_>) -> Result<f64> {
    Ok(10.0_f64.powi(-i32::from(u.int_in_range(0..=16_u8)?)))
}

/// Returns a number of places, each beginning at the one before.
pub(crate) fn places(u: &mut Unstructured<'_>, count: std::ops::RangeInclusive<usize>) -> Result<Vec<DVec2>> {
    let count = u.int_in_range(count)?;
    let mut before = DVec2::splat(f64::from(SIDE) / 2.0);
    (0..count)
        .map(|_| {
            before = place(u, before)?;
            Ok(before)
        })
        .collect()
}
