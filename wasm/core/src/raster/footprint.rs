//! The area of the picture that a pixel of the result shows.

use glam::DMat2;

use super::kernel::MAX_WIDTH;

/// The mip level to read, and the widths of the filter there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Footprint {
    /// 0 is full size. Each further level has half the size.
    pub(super) level: u32,
    /// Widths along x and y in texels of that level, 1 to [`MAX_WIDTH`].
    pub(super) widths: [f32; 2],
}

impl Footprint {
    /// Returns the footprint for the linear part of the map from the result to the picture.
    ///
    /// The map turns a pixel's circle into an ellipse. Its bounding box gives the widths. A rotation leaves them at 1.
    pub(super) fn new(inverse: DMat2) -> Self {
        // Rounding errors must not blur a picture that is at rest or rotated.
        let spans = [inverse.row(0), inverse.row(1)].map(|row| (row.length() * 256.0).round().max(256.0) / 256.0);
        let (least, greatest) = (spans[0].min(spans[1]), spans[0].max(spans[1]));
        // Mip levels are box-filtered. Reading them at least two texels wide hides the box's blur.
        let by_least = ((least / 2.0) as u32).max(1).ilog2();
        // A long, narrow footprint must still fit the widest filter.
        let by_greatest = libm::ceil(libm::log2(greatest / MAX_WIDTH)).clamp(0.0, 31.0) as u32;
        let level = by_least.max(by_greatest);
        Self { level, widths: spans.map(|span| (span / f64::from(1_u32 << level)).clamp(1.0, MAX_WIDTH) as f32) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn footprint(x: f64, y: f64, angle: f64) -> Footprint {
        Footprint::new(DMat2::from_diagonal((x, y).into()) * DMat2::from_angle(angle))
    }

    #[test]
    fn rotation_and_enlargement_keep_one_texel() {
        for angle in [0.0, 0.3, 1.0, 2.5] {
            for scale in [0.1, 0.9, 1.0] {
                assert_eq!(footprint(scale, scale, angle), Footprint { level: 0, widths: [1.0; 2] });
            }
        }
    }

    #[test]
    fn squeeze_widens_the_footprint_along_its_direction_only() {
        assert_eq!(footprint(5.0, 1.0, 0.7), Footprint { level: 0, widths: [5.0, 1.0] });
        assert_eq!(footprint(1.0, 16.0, 0.0), Footprint { level: 1, widths: [1.0, 8.0] });
    }

    #[test]
    fn mip_levels_are_read_at_least_two_texels_wide() {
        assert_eq!(footprint(3.5, 3.5, 0.0), Footprint { level: 0, widths: [3.5; 2] });
        assert_eq!(footprint(4.0, 4.0, 0.0), Footprint { level: 1, widths: [2.0; 2] });
    }
}
