//! A triangle set up for rasterisation: the samples that it covers, and the map back to the picture.

use std::ops::Range;

use glam::{DMat2, DVec2};

use super::footprint::Footprint;
use super::options::Filter;

/// Coverage samples along the side of a pixel.
pub(super) const GRID: usize = 4;
/// The covered samples of a pixel, one bit per sample.
pub(super) type Mask = u16;

/// Corners are rounded to 1/256 px, as on graphics hardware. This makes coverage exact in integers.
const SUBPIXELS: f64 = 256.0;
/// Distance between samples in subpixels. The first sample lies half of this inside the pixel.
const SAMPLE_STEP: i64 = 64;
/// Smallest area of the picture per pixel of the result, in pixels. Smaller values are rounding errors around zero.
const MIN_SOURCE_AREA: f64 = 1e-9;
/// Largest coordinate of a corner. It keeps every product below 2⁶⁰.
const MAX_COORDINATE_PX: f64 = 1_048_576.0;

/// Returns whether `p` is close enough to be rasterised. NaN is not.
pub(super) fn is_in_range(p: DVec2) -> bool {
    p.abs().max_element() <= MAX_COORDINATE_PX
}

/// Returns the facets of a mesh, relative to the picture's rectangle. Triangles that cover nothing are omitted.
///
/// # Panics
/// If `rest` and `posed` differ in length, or a triangle refers to a vertex that does not exist.
pub(super) fn mesh_facets(rest: &[DVec2], posed: &[DVec2], triangles: &[[u32; 3]], scale: f64) -> Vec<Facet> {
    assert_eq!(rest.len(), posed.len(), "each vertex has a rest position and a posed position");
    let facet = |triangle: &[u32; 3]| {
        let corners = triangle.map(|vertex| vertex as usize);
        Facet::new(corners.map(|i| rest[i]), corners.map(|i| posed[i] * scale))
    };
    triangles.iter().filter_map(facet).collect()
}

/// A triangle in pixels of the result.
///
/// Its corners are relative to the picture's rectangle until [`move_by`](Facet::move_by) makes them relative to the
/// frame.
#[derive(Debug, Clone)]
pub(super) struct Facet {
    /// Corners in subpixels, with positive orientation.
    corners: [[i64; 2]; 3],
    /// Linear part of the map from the result, relative to the picture's rectangle, to the picture.
    inverse: DMat2,
    origin: DVec2,
    footprint: Footprint,
}

impl Facet {
    /// Returns `None` if the triangle has no area or a corner out of range.
    pub(super) fn new(rest: [DVec2; 3], posed: [DVec2; 3]) -> Option<Self> {
        if !posed.into_iter().all(is_in_range) {
            return None;
        }
        let mut corners = posed.map(|p| (p * SUBPIXELS).round().to_array().map(|x| x as i64));
        let [[ax, ay], [bx, by], [cx, cy]] = corners;
        match (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) {
            0 => return None,
            area if area < 0 => corners.swap(1, 2),
            _ => {}
        }
        let edges = |[a, b, c]: [DVec2; 3]| DMat2::from_cols(b - a, c - a);
        let inverse = edges(rest) * edges(posed).inverse();
        inverse.is_finite().then(|| Self {
            corners,
            inverse,
            origin: rest[0] - inverse * posed[0],
            footprint: Footprint::new(inverse),
        })
    }

    /// Returns the area of the picture that one pixel shows.
    pub(super) fn footprint(&self) -> Footprint {
        self.footprint
    }

    /// Returns the bounding box in whole pixels: its lower and its upper corner.
    pub(super) fn bounds(&self) -> ([i64; 2], [i64; 2]) {
        let [a, b, c] = self.corners;
        let side = SUBPIXELS as i64;
        (
            [0, 1].map(|axis| a[axis].min(b[axis]).min(c[axis]).div_euclid(side)),
            [0, 1].map(|axis| (a[axis].max(b[axis]).max(c[axis]) + side - 1).div_euclid(side)),
        )
    }

    /// Makes the corners relative to a frame in which the picture's upper left corner is at `origin`.
    pub(super) fn move_by(&mut self, origin: [i64; 2]) {
        for corner in &mut self.corners {
            corner[0] += origin[0] * SUBPIXELS as i64;
            corner[1] += origin[1] * SUBPIXELS as i64;
        }
    }

    /// Returns the point of the picture that is drawn at `p`, relative to the picture's rectangle in the result.
    pub(super) fn source(&self, p: DVec2) -> DVec2 {
        self.inverse * p + self.origin
    }

    /// Returns the Jacobian determinant of the map from the picture to the result.
    ///
    /// It is negative if the triangle is flipped. It is 0 if a line of the picture fills an area, as at its border.
    pub(super) fn det(&self) -> f64 {
        let source_area = self.inverse.determinant();
        if source_area.abs() < MIN_SOURCE_AREA { 0.0 } else { 1.0 / source_area }
    }

    /// Returns the singular values of the map from the picture to the result, the greater one first.
    ///
    /// The second one is negative if the triangle is flipped. Both are 0 if [`det`](Self::det) is.
    pub(super) fn stretch(&self) -> [f64; 2] {
        let [[a, b], [c, d]] = self.inverse.to_cols_array_2d();
        if self.det() == 0.0 {
            return [0.0; 2];
        }
        // Of the inverse map: the greater singular value, and the product of both.
        let greatest = (DVec2::new(a + d, b - c).length() + DVec2::new(a - d, b + c).length()) / 2.0;
        let product = self.inverse.determinant();
        [greatest / product.abs(), product.signum() / greatest]
    }

    /// Returns the rows of pixels that the triangle may touch.
    pub(super) fn rows(&self, height: usize) -> Range<usize> {
        self.touched(1, height)
    }

    /// Returns the columns of pixels that the triangle may touch.
    pub(super) fn columns(&self, width: usize) -> Range<usize> {
        self.touched(0, width)
    }

    fn touched(&self, axis: usize, length: usize) -> Range<usize> {
        let side = SUBPIXELS as i64;
        let [a, b, c] = self.corners.map(|corner| corner[axis]);
        let pixel = |place: i64| place.div_euclid(side).clamp(0, length as i64) as usize;
        pixel(a.min(b).min(c))..pixel(a.max(b).max(c) + side - 1)
    }

    /// Calls `visit` with the column, row and covered samples of each pixel in `rows` that the triangle covers in part.
    ///
    /// For [`Filter::Nearest`] a pixel is covered as a whole if the triangle covers its centre.
    #[inline]
    pub(super) fn for_each_covered(
        &self,
        rows: Range<usize>,
        width: usize,
        filter: Filter,
        mut visit: impl FnMut(usize, usize, Mask),
    ) {
        for row in rows {
            if filter == Filter::Nearest {
                self.covered_centres(row, width).for_each(|x| visit(x, row, Mask::MAX));
                continue;
            }
            let spans: [Range<usize>; GRID] =
                std::array::from_fn(|i| self.span(SAMPLE_STEP, row * GRID + i, width * GRID));
            let covered = spans.iter().filter(|span| !span.is_empty());
            let Some((start, end)) =
                covered.map(|span| (span.start, span.end)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
            else {
                continue;
            };
            let full = spans.iter().fold(start..end, |full, span| full.start.max(span.start)..full.end.min(span.end));
            let full = full.start.div_ceil(GRID)..full.end / GRID;
            for x in start / GRID..end.div_ceil(GRID) {
                let mask = if full.contains(&x) { Mask::MAX } else { mask(&spans, x) };
                if mask != 0 {
                    visit(x, row, mask);
                }
            }
        }
    }

    /// Returns the pixels of a row whose centres the triangle covers.
    pub(super) fn covered_centres(&self, row: usize, width: usize) -> Range<usize> {
        self.span(SUBPIXELS as i64, row, width)
    }

    /// Returns the covered samples of one row of `count` samples, counted from the left edge of the result.
    ///
    /// Samples are `step` subpixels apart. The first one lies half a step from the edge. The top-left rule applies: if
    /// two triangles share an edge, exactly one of them covers a sample on it.
    fn span(&self, step: i64, sample_row: usize, count: usize) -> Range<usize> {
        let y = sample_row as i64 * step + step / 2;
        let (mut start, mut end) = (0, count as i64);
        for i in 0..3 {
            let [ax, ay] = self.corners[i];
            let [bx, by] = self.corners[(i + 1) % 3];
            let (dx, dy) = (bx - ax, by - ay);
            // Edge function at the row's first sample: positive inside. It changes by `-dy` per subpixel.
            let edge = dx * (y - ay) - dy * (step / 2 - ax);
            let least = i64::from(!(dy < 0 || (dy == 0 && dx > 0)));
            let step = step * dy.abs();
            match dy {
                0 if edge < least => return 0..0,
                0 => {}
                ..0 => start = start.max(-(edge - least).div_euclid(step)),
                1.. => end = end.min((edge - least).div_euclid(step) + 1),
            }
        }
        if start < end { start as usize..end as usize } else { 0..0 }
    }
}

/// Returns the samples of pixel `x` inside the spans of its sample rows.
fn mask(spans: &[Range<usize>; GRID], x: usize) -> Mask {
    let mut mask = 0;
    for (row, span) in spans.iter().enumerate() {
        let within = |sample: usize| sample.clamp(x * GRID, (x + 1) * GRID) - x * GRID;
        let bits = (1 << within(span.end)) - (1 << within(span.start));
        mask |= bits << (row * GRID);
    }
    mask
}
