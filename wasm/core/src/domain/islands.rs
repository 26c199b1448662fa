//! Classification of rings as islands, holes and specks.
//!
//! Cost: O(rings × corners) for the nesting of a project's rings, O(corners) for specks.

use glam::DVec2;

use super::ring::{Ring, contains, signed_area};

/// Regions smaller than this, in square pixels, are specks: a few pixels, too small for a handle.
const SPECK_AREA: f64 = 4.0;
/// In large pictures specks may be larger: this fraction of the picture's area (a 10 × 10 px spot in 10 megapixels).
const SPECK_FRACTION: f64 = 1e-5;

/// In pictures up to this area, in square pixels, no island is a speck, because every pixel of a sprite is intentional.
///
/// Even if every second pixel is an island of four corners, the total is below
/// [`MAX_CORNERS`](crate::limits::MAX_CORNERS).
const SPRITE_AREA: f64 = 128.0 * 128.0;

/// Rings without specks, and the number of specks dropped.
pub(super) struct FilteredRings {
    pub(super) rings: Vec<Ring>,
    pub(super) specks: usize,
    /// Area of the islands among them, in square pixels.
    pub(super) speck_area: f64,
}

/// Drops small islands, with the holes in them, and small holes.
///
/// Outer contours must have positive area, holes negative. `picture_area` is in square pixels.
pub(super) fn without_specks(contours: impl Iterator<Item = Ring>, picture_area: f64) -> FilteredRings {
    let least_hole = SPECK_AREA.max(SPECK_FRACTION * picture_area);
    let least_island = if picture_area <= SPRITE_AREA { 0.0 } else { least_hole };
    let (mut specks, mut speck_area) = (0, 0.0);
    let is_kept = |ring: &Ring| {
        // A hole is larger than a speck only if the island around it is, so no hole remains without its island.
        let area = signed_area(ring);
        let is_kept = if area > 0.0 { area >= least_island } else { -area >= least_hole };
        if !is_kept {
            specks += 1;
            speck_area += area.max(0.0);
        }
        is_kept
    };
    let rings = contours.filter(is_kept).collect();
    FilteredRings { rings, specks, speck_area }
}

/// The same rings, with positive area for outer rings and negative area for holes. A ring at an odd depth of nesting
/// is a hole.
pub(super) fn oriented(rings: &[Ring]) -> Vec<Ring> {
    let depth = |at: usize, p: DVec2| {
        rings.iter().enumerate().filter(|&(other, ring)| other != at && contains(ring, p)).count()
    };
    let orient = |(at, ring): (usize, &Ring)| {
        let outer = depth(at, ring[0]).is_multiple_of(2);
        let mut ring = ring.clone();
        if (signed_area(&ring) > 0.0) != outer {
            ring.reverse();
        }
        ring
    };
    rings.iter().enumerate().map(orient).collect()
}
