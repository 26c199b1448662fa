//! The pixels that a fill replaces: those of the domain, and of a narrow band around its outline.
//!
//! Cost: linear in the pixels of the domain's box, and in the length of the outline.

use glam::DVec2;

use super::{Ring, cells_inside, edges};
use crate::opacity::Opacity;

/// Width of the band, in pixels. The antialiased rim along the outline lies in it.
///
/// The skirt of the mesh is 3 px wide and contains the band: pixels of the band are at most √2 times this away, and
/// their corners another 0.7 px. So the part at rest covers everything that is filled.
const BAND: f64 = 1.5;

/// A box of a picture, and the pixels to fill in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Mask {
    /// The upper left corner in the picture.
    pub(crate) origin: [u32; 2],
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// Pixels from left to right, then from top to bottom.
    filled: Vec<bool>,
}

impl Mask {
    /// The pixels of rings by the even-odd rule, in a picture of a given size.
    pub(crate) fn new(rings: &[Ring], size: (u32, u32)) -> Self {
        Self::with_band(rings, size, BAND)
    }

    /// The same with a wider band. Along slanted edges, the band is up to √2 times wider.
    pub(crate) fn with_band(rings: &[Ring], (width, height): (u32, u32), band: f64) -> Self {
        let points = || rings.iter().flatten();
        let low = points().fold(DVec2::INFINITY, |low, p| low.min(*p)) - band - 1.0;
        let high = points().fold(DVec2::NEG_INFINITY, |high, p| high.max(*p)) + band + 1.0;
        let size = DVec2::new(width.into(), height.into());
        let [left, top] = low.floor().clamp(DVec2::ZERO, size).to_array().map(|side| side as u32);
        let [right, bottom] = high.ceil().clamp(DVec2::ZERO, size).to_array().map(|side| side as u32);
        let (width, height) = (right - left, bottom - top);
        let first = DVec2::new(left.into(), top.into()) + 0.5;
        let filled = cells_inside(rings, [width as usize, height as usize], |p| p - first);
        let mut mask = Self { origin: [left, top], width, height, filled };
        for ring in rings {
            edges(ring).for_each(|(a, b)| mask.fill_band(a, b, band));
        }
        mask
    }

    /// Whether a pixel of the picture needs filling.
    pub(crate) fn has(&self, x: u32, y: u32) -> bool {
        let (column, row) = (x.wrapping_sub(self.origin[0]), y.wrapping_sub(self.origin[1]));
        column < self.width && row < self.height && self.filled[row as usize * self.width as usize + column as usize]
    }

    /// The alpha of a picture in which only these pixels are opaque.
    pub(crate) fn opacity(&self, (width, height): (u32, u32)) -> Opacity {
        let is_filled = |at: usize| self.has((at % width as usize) as u32, (at / width as usize) as u32);
        Opacity::of_levels((width, height), |at| if is_filled(at) { u8::MAX } else { 0 })
    }

    /// Fills the pixels whose centres lie close to an edge.
    fn fill_band(&mut self, a: DVec2, b: DVec2, band: f64) {
        let (top, bottom) = if a.y < b.y { (a, b) } else { (b, a) };
        for row in self.rows(top.y - band - 0.5, bottom.y + band - 0.5) {
            let y = f64::from(self.origin[1] + row as u32) + 0.5;
            if y + band < top.y || y - band > bottom.y {
                continue;
            }
            let at = |height: f64| {
                let down = if top.y < bottom.y { (height - top.y) / (bottom.y - top.y) } else { 0.0 };
                top.x + down.clamp(0.0, 1.0) * (bottom.x - top.x)
            };
            let ends = if top.y < bottom.y { [at(y - band), at(y + band)] } else { [top.x, bottom.x] };
            let [from, to] = [ends[0].min(ends[1]) - band, ends[0].max(ends[1]) + band];
            self.fill_row(row, (from - 0.5).ceil(), (to - 0.5).floor());
        }
    }

    /// The rows of the box between two vertical positions in the picture.
    fn rows(&self, from: f64, to: f64) -> std::ops::Range<usize> {
        let row = |place: f64| (place - f64::from(self.origin[1])).clamp(0.0, f64::from(self.height)) as usize;
        row(from.floor())..row(to.ceil() + 1.0)
    }

    fn fill_row(&mut self, row: usize, from: f64, to: f64) {
        let column = |place: f64| (place - f64::from(self.origin[0])).clamp(0.0, f64::from(self.width)) as usize;
        let (from, to) = (column(from), column(to + 1.0));
        if from < to {
            self.filled[row * self.width as usize..][from..to].fill(true);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[[f64; 2]]) -> Ring {
        corners.iter().copied().map(DVec2::from).collect()
    }

    #[test]
    fn mask_holds_the_inside_and_a_band_but_no_hole() {
        let outer = ring(&[[20.0, 20.0], [80.0, 20.0], [80.0, 80.0], [20.0, 80.0]]);
        let hole = ring(&[[40.0, 40.0], [60.0, 40.0], [60.0, 60.0], [40.0, 60.0]]);
        let mask = Mask::new(&[outer, hole], (100, 90));
        let row = |y| (0..100).filter(|&x| mask.has(x, y)).collect::<Vec<u32>>();
        assert_eq!(row(30), (18..82).collect::<Vec<_>>());
        assert_eq!(row(50), (18..42).chain(58..82).collect::<Vec<_>>());
        assert!(row(17).is_empty() && !row(18).is_empty() && !row(81).is_empty() && row(82).is_empty());
    }

    #[test]
    fn band_of_a_slanted_edge_is_narrower_than_the_skirt() {
        let corners = [[10.0, 12.0], [90.0, 47.0], [30.0, 75.0]];
        let triangle = ring(&corners);
        let mask = Mask::new(std::slice::from_ref(&triangle), (100, 90));
        for (x, y) in (0..90).flat_map(|y| (0..100).map(move |x| (x, y))) {
            let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let away = edges(&triangle).map(|(a, b)| crate::segment::segment_distance(centre, a, b));
            let away = away.fold(f64::INFINITY, f64::min);
            let inside = crate::domain::contains(&triangle, centre);
            assert!(mask.has(x, y) || !inside && away > BAND, "{x}, {y}");
            assert!(!mask.has(x, y) || inside || away < BAND * 1.4143, "{x}, {y}");
        }
    }

    #[test]
    fn rings_at_the_border_stay_in_the_picture() {
        let all = Mask::new(&[ring(&[[0.0, 0.0], [9.0, 0.0], [9.0, 7.0], [0.0, 7.0]])], (9, 7));
        assert_eq!((all.origin, all.width, all.height), ([0, 0], 9, 7));
        assert!(all.filled.iter().all(|&filled| filled));
    }
}
