//! Simplified outlines for meshes of few vertices: of the domain itself, or around all visible pixels of a picture.
//!
//! Visible pixels extend beyond an outline at half their alpha. So the outline around them keeps a distance that the
//! simplification may use, plus one pixel for the filters of graphics cards.
//!
//! Cost: linear in the pixels once, and for each outline. Known limit: parts closer than twice that distance merge.

use super::{
    Domain, Ring,
    contour::contours,
    islands::{FilteredRings, without_specks},
    nearness::Nearness,
    simplify::simplified,
};
use crate::picture::Picture;

/// Pixels with less alpha than this are invisible: five levels of 255.
const LEAST_ALPHA: f64 = 0.02;
/// Half a pixel to the edge of a pixel, and half a pixel for a filter.
const CLEARANCE_PX: f64 = 1.0;

/// The visible pixels of a picture.
pub(crate) struct VisiblePixels {
    nearness: Nearness,
    area: f64,
}

impl VisiblePixels {
    pub(crate) fn new(picture: &Picture) -> Self {
        let area = f64::from(picture.width()) * f64::from(picture.height());
        Self { nearness: Nearness::new(picture, LEAST_ALPHA), area }
    }

    /// The region around all visible pixels except specks, with as few corners as `tolerance`, in pixels, allows.
    /// `None` if no pixel is visible.
    pub(crate) fn region(&self, tolerance: f64) -> Option<Domain> {
        let within = self.nearness.within(tolerance + CLEARANCE_PX);
        let around = contours(&within, 0.0).map(|ring| self.nearness.in_pixels(ring));
        let FilteredRings { rings, .. } = without_specks(around, self.area);
        region(&rings, tolerance)
    }
}

impl Domain {
    /// The same domain with as few corners as `tolerance`, in pixels, allows.
    pub(crate) fn simplified(&self, tolerance: f64) -> Option<Self> {
        region(self.rings(), tolerance)
    }
}

fn region(rings: &[Ring], tolerance: f64) -> Option<Domain> {
    let rings = simplified(rings, tolerance);
    (!rings.is_empty()).then(|| Domain::from_checked(rings, 0))
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::super::contains;
    use super::*;

    #[test]
    fn visible_pixels_lie_inside_with_room_for_a_filter() {
        let is_visible = |x: i32, y: i32| (x - 40).pow(2) + (y - 30).pow(2) < 400;
        let rgba: Vec<u8> =
            (0..80 * 60).flat_map(|i| [0, 0, 0, if is_visible(i % 80, i / 80) { 9 } else { 0 }]).collect();
        let pixels = VisiblePixels::new(&Picture::new(80, 60, &rgba).unwrap());
        for tolerance in [0.5, 2.0, 5.0] {
            let region = pixels.region(tolerance).unwrap();
            let [ring] = region.rings() else { panic!("one ring") };
            for at in (0..80 * 60).filter(|&i| is_visible(i % 80, i / 80)) {
                let corner = DVec2::new(f64::from(at % 80), f64::from(at / 80));
                let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
                assert!(corners.iter().all(|&offset| contains(ring, corner + offset)), "{corner} by {tolerance} px");
            }
        }
        assert!(pixels.region(5.0).unwrap().rings()[0].len() < pixels.region(0.5).unwrap().rings()[0].len());
    }

    #[test]
    fn a_picture_without_visible_pixels_has_no_region() {
        assert_eq!(VisiblePixels::new(&Picture::new(8, 8, &[4; 256]).unwrap()).region(1.0), None);
    }
}
