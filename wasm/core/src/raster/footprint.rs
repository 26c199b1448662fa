//! What of the picture a pixel of the result shows.

use glam::DMat2;

use super::kernel::WIDEST;

/// The level of detail to read, and the widths of the filter there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Footprint {
    /// 0 is full size, every further level half the size.
    pub(super) level: u32,
    /// Along x and y in texels of that level, 1 to [`WIDEST`].
    pub(super) widths: [f32; 2],
}

impl Footprint {
    /// Of the map from places of the result to places in the picture.
    ///
    /// Along each axis a pixel is as wide as the ellipse that the map makes of a circle of its size. A turn leaves it 1.
    pub(super) fn new(inverse: DMat2) -> Self {
        // Rounded, so that a rounding error does not make a picture that is turned, or at rest, less sharp.
        let spans = [inverse.row(0), inverse.row(1)].map(|row| (row.length() * 256.0).round().max(256.0) / 256.0);
        let (least, greatest) = (spans[0].min(spans[1]), spans[0].max(spans[1]));
        // Reductions are boxes: read no less than two texels wide, so that they cost no sharpness.
        let by_least = ((least / 2.0) as u32).max(1).ilog2();
        // Where a pixel is long and narrow, as the filter reaches no further.
        let by_greatest = libm::ceil(libm::log2(greatest / WIDEST)).clamp(0.0, 31.0) as u32;
        let level = by_least.max(by_greatest);
        Self { level, widths: spans.map(|span| (span / f64::from(1_u32 << level)).clamp(1.0, WIDEST) as f32) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(x: f64, y: f64, angle: f64) -> Footprint {
        Footprint::new(DMat2::from_diagonal((x, y).into()) * DMat2::from_angle(angle))
    }

    #[test]
    fn a_turn_and_an_enlargement_leave_it_one_texel() {
        for angle in [0.0, 0.3, 1.0, 2.5] {
            for scale in [0.1, 0.9, 1.0] {
                assert_eq!(of(scale, scale, angle), Footprint { level: 0, widths: [1.0; 2] });
            }
        }
    }

    #[test]
    fn a_squeeze_widens_it_in_its_direction_alone() {
        assert_eq!(of(5.0, 1.0, 0.7), Footprint { level: 0, widths: [5.0, 1.0] });
        assert_eq!(of(1.0, 16.0, 0.0), Footprint { level: 1, widths: [1.0, 8.0] });
    }

    #[test]
    fn reductions_are_read_two_texels_wide_or_wider() {
        assert_eq!(of(3.5, 3.5, 0.0), Footprint { level: 0, widths: [3.5; 2] });
        assert_eq!(of(4.0, 4.0, 0.0), Footprint { level: 1, widths: [2.0; 2] });
    }
}
