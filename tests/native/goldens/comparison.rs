//! Pictures compared with a tolerance.

use image::{Rgba, RgbaImage};

/// What a byte may differ by: colours of drawn pictures and of warped ones are rounded to bytes, once each, and the formulas of
/// some pictures use the platform's sine.
const ROUNDING: u8 = 2;
/// The share of pixels that may differ by more. Where a rounding error moves an edge across one of a pixel's 4 × 4 coverage samples,
/// or a triangle across a pixel's centre, that one pixel changes by a sixteenth of a contrast or more; that happens to a few pixels in
/// a picture. A handle that goes elsewhere by half a pixel changes five times as many at least, as a test makes sure.
const SHARE: f64 = 0.002;

/// How two pictures differ.
#[derive(Debug)]
pub(crate) struct Comparison {
    /// Share of the pixels that differ by more than rounding.
    pub(crate) share: f64,
    /// The largest difference of a byte.
    pub(crate) largest: u8,
    /// Differences, eight times as strong, on black.
    pub(crate) picture: RgbaImage,
}

impl Comparison {
    /// Compares two pictures; of different sizes they differ everywhere.
    pub(crate) fn of(expected: &RgbaImage, actual: &RgbaImage) -> Self {
        let mut picture = RgbaImage::from_pixel(actual.width(), actual.height(), Rgba([0, 0, 0, 255]));
        if expected.dimensions() != actual.dimensions() {
            return Self { share: 1.0, largest: u8::MAX, picture };
        }
        let (mut count, mut largest) = (0, 0);
        for ((a, b), to) in expected.pixels().zip(actual.pixels()).zip(picture.pixels_mut()) {
            let difference: [u8; 4] = std::array::from_fn(|k| a.0[k].abs_diff(b.0[k]));
            let most = difference.into_iter().max().expect("four of them");
            count += usize::from(most > ROUNDING);
            largest = largest.max(most);
            // A difference of opacity shows in all colours.
            to.0 =
                std::array::from_fn(|k| if k < 3 { difference[k].max(difference[3]).saturating_mul(8) } else { 255 });
        }
        Self { share: f64::from(count as u32) / f64::from(actual.width() * actual.height()), largest, picture }
    }

    pub(crate) fn is_close(&self) -> bool {
        self.share <= SHARE
    }
}
