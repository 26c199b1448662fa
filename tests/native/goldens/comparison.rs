//! Comparison of pictures with a tolerance.

use image::{Rgba, RgbaImage};

/// Tolerance per byte. Generated and warped colours are each rounded once, and some pictures use the platform's sine.
const ROUNDING: u8 = 2;
/// The fraction of pixels that may differ by more.
///
/// A rounding error can move an edge across one of the 4 × 4 coverage samples, or a triangle across a pixel's centre.
/// That changes the pixel by 1/16 of the contrast or more, and happens to a few pixels. Moving a handle by half a pixel
/// changes at least five times as many pixels, as a test ensures.
const MAX_FRACTION: f64 = 0.002;

/// The difference of two pictures.
#[derive(Debug)]
pub(crate) struct Comparison {
    /// The fraction of pixels that differ by more than rounding.
    pub(crate) fraction: f64,
    /// The largest difference of a byte.
    pub(crate) largest: u8,
    /// The differences, amplified eight times, on black.
    pub(crate) picture: RgbaImage,
}

impl Comparison {
    /// Compares two pictures. Pictures of different sizes differ everywhere.
    pub(crate) fn of(expected: &RgbaImage, actual: &RgbaImage) -> Self {
        let mut picture = RgbaImage::from_pixel(actual.width(), actual.height(), Rgba([0, 0, 0, 255]));
        if expected.dimensions() != actual.dimensions() {
            return Self { fraction: 1.0, largest: u8::MAX, picture };
        }
        let (mut count, mut largest) = (0, 0);
        for ((a, b), to) in expected.pixels().zip(actual.pixels()).zip(picture.pixels_mut()) {
            let difference: [u8; 4] = std::array::from_fn(|k| a.0[k].abs_diff(b.0[k]));
            let most = difference.into_iter().max().expect("a pixel has four channels");
            count += usize::from(most > ROUNDING);
            largest = largest.max(most);
            // A difference in opacity shows in all channels.
            to.0 =
                std::array::from_fn(|k| if k < 3 { difference[k].max(difference[3]).saturating_mul(8) } else { 255 });
        }
        Self { fraction: f64::from(count as u32) / f64::from(actual.width() * actual.height()), largest, picture }
    }

    /// Returns whether the pictures are equal within the tolerance.
    pub(crate) fn is_close(&self) -> bool {
        self.fraction <= MAX_FRACTION
    }
}
