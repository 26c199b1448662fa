//! The outline of a picture's opaque part, as close as a limit of corners allows.
//!
//! Distances cost time and memory for each corner, and a held boundary much more. An outline with too many corners is
//! first simplified within half a pixel, or within one and a half if it is held. Then it includes ever larger gaps,
//! until few enough corners remain. Gaps are transparent, so this changes no pixel of the picture at rest: parts on
//! both sides of a gap bend together. The last resort is the whole picture.
//!
//! Cost: linear in the pixels, and O(n log n) in the points of the contours, for each of at most eight attempts.

use super::{
    contour::{Field, contours},
    corners,
    islands::{FilteredRings, without_specks},
    nearness::Nearness,
    ring::Ring,
    simplify::simplified,
};
use crate::{
    error::Error,
    limits::{MAX_CORNERS, MAX_HELD_OUTLINE, MAX_OUTLINE_LENGTH},
    picture::Picture,
};

/// How closely the outline of a domain follows the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", schemars(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum OutlineDetail {
    /// To a third of a pixel, or as given.
    Traced,
    /// To half a pixel, or to one and a half if it is held, to reduce the corners.
    Simplified,
    /// Gaps belong to the domain, to reduce the corners.
    Bridged,
    /// The whole picture instead of its opaque part, because the outline would have too many corners.
    Picture,
}

/// How many corners an outline may have, and how far it may be from the contour.
pub(super) struct Bounds {
    most_corners: usize,
    /// Maximum distance of the contour from the simplified outline, in pixels, for each attempt.
    tolerances: &'static [(f64, OutlineDetail)],
}

/// An error of half a pixel is hardly visible on an edge. With the first tolerance, a disc of radius 100 px keeps some
/// 56 corners.
pub(super) const FREE: Bounds = Bounds {
    most_corners: MAX_CORNERS,
    tolerances: &[(0.35, OutlineDetail::Traced), (0.5, OutlineDetail::Simplified)],
};
/// The outline of a held boundary. Each corner needs a site.
///
/// The skirt draws the pixels that the last tolerance leaves out. Where alpha falls by less than a level per pixel, a
/// contour is a staircase of whole pixels: this tolerance turns it back into a curve.
pub(super) const HELD: Bounds = Bounds {
    most_corners: MAX_HELD_OUTLINE,
    tolerances: &[(0.35, OutlineDetail::Traced), (0.5, OutlineDetail::Simplified), (1.5, OutlineDetail::Simplified)],
};
/// Distances of the outline from opaque pixels where it bridges gaps, in pixels, for each attempt.
///
/// Each is three times the previous one, and the number of corners falls about as fast.
const BRIDGES: [f64; 5] = [1.5, 4.0, 12.0, 36.0, 108.0];
/// Tolerance of an outline away from opaque pixels, over its distance from them.
const BRIDGE_TOLERANCE: f64 = 0.25;

/// If only specks are opaque, they count as dust below this fraction of the picture. Above, they are a texture, such as
/// small print.
const TEXTURE: f64 = 1e-3;

/// The rings around the opaque part of a picture.
pub(super) struct Outline {
    /// Empty for the whole picture.
    pub(super) rings: Vec<Ring>,
    pub(super) detail: OutlineDetail,
    /// Widest gap that is bridged, in pixels.
    pub(super) gap: f64,
    pub(super) specks: usize,
}

impl Outline {
    /// The outline of the region where alpha reaches a threshold.
    ///
    /// # Errors
    /// [`Error::NothingOpaque`] or [`Error::OnlySpecks`] if no region is large enough.
    pub(super) fn new(picture: &Picture, threshold: f64, bounds: &Bounds) -> Result<Self, Error> {
        let area = f64::from(picture.width()) * f64::from(picture.height());
        let FilteredRings { rings: traced, specks, speck_area } =
            without_specks(contours(&Alpha(picture), threshold), area);
        if traced.is_empty() && speck_area < TEXTURE * area {
            return Err(match specks {
                0 => Error::NothingOpaque { threshold },
                specks => Error::OnlySpecks { threshold, specks },
            });
        }
        let Bounds { most_corners: most, tolerances } = *bounds;
        // Simplification keeps at least three corners of each ring. Noise has a point on each pixel: with a pixel for
        // each point, its contour is longer than any outline may be.
        let longest = MAX_OUTLINE_LENGTH * libm::hypot(picture.width().into(), picture.height().into());
        let may_fit = |rings: &[Ring]| (1..=most / 3).contains(&rings.len()) && corners(rings) as f64 <= longest;
        for &(tolerance, detail) in tolerances.iter().filter(|_| may_fit(&traced)) {
            let rings = simplified(&traced, tolerance);
            if corners(&rings) <= most {
                return Ok(Self { rings, detail, gap: 0.0, specks });
            }
        }
        drop(traced);
        let nearness = Nearness::new(picture, threshold);
        for away in BRIDGES {
            let within = nearness.within(away);
            let around = contours(&within, 0.0).map(|ring| nearness.in_pixels(ring));
            let FilteredRings { rings, .. } = without_specks(around, area);
            if !may_fit(&rings) {
                continue;
            }
            let rings = simplified(&rings, BRIDGE_TOLERANCE * away);
            if corners(&rings) <= most {
                return Ok(Self { rings, detail: OutlineDetail::Bridged, gap: 2.0 * away, specks });
            }
        }
        Ok(Self { rings: Vec::new(), detail: OutlineDetail::Picture, gap: 0.0, specks })
    }
}

/// The alpha of a picture, from 0 to 1.
struct Alpha<'a>(&'a Picture<'a>);

impl Field for Alpha<'_> {
    const BEYOND: f64 = 0.0;

    fn size(&self) -> (u32, u32) {
        self.0.size()
    }

    fn at(&self, x: u32, y: u32) -> f64 {
        f64::from(self.0.rgba()[(y as usize * self.0.width() as usize + x as usize) * 4 + 3]) / 255.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The outline of a picture of 200 × 200 px that is opaque at some pixels.
    fn outline(most: usize, is_opaque: impl Fn(u32, u32) -> bool) -> Result<Outline, Error> {
        let rgba: Vec<u8> =
            (0..200 * 200).flat_map(|i| [0, 0, 0, if is_opaque(i % 200, i / 200) { 255 } else { 0 }]).collect();
        let bounds = Bounds { most_corners: most, ..FREE };
        Outline::new(&Picture::new(200, 200, &rgba).unwrap(), 0.5, &bounds)
    }

    #[test]
    fn fewer_corners_make_a_coarser_outline() {
        // Squares of 10 px, 4 px apart at first, then 40 px apart.
        let squares = |x: u32, y: u32| x < 100 && x % 14 < 10 && y % 14 < 10 || (160..170).contains(&x) && y % 50 < 10;
        let details = [2000, 150, 50, 12, 3].map(|most| {
            let outline = outline(most, squares).unwrap();
            assert!(corners(&outline.rings) <= most);
            (outline.detail, outline.gap)
        });
        assert_eq!(details[0], (OutlineDetail::Traced, 0.0));
        assert_eq!(details[1], (OutlineDetail::Bridged, 8.0));
        assert_eq!(details[4], (OutlineDetail::Picture, 0.0));
    }

    #[test]
    fn specks_alone_are_bridged_if_they_cover_enough() {
        let error = outline(2000, |x, y| (x, y) == (60, 60)).err();
        assert_eq!(error, Some(Error::OnlySpecks { threshold: 0.5, specks: 1 }));
        let outline = outline(2000, |x, y| x % 6 == 0 && y % 6 == 0).unwrap();
        assert_eq!(outline.detail, OutlineDetail::Bridged);
        assert_eq!(outline.specks, 34 * 34);
    }
}
