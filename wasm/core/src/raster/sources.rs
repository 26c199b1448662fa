//! The inverse map of a warped picture, per pixel. Compositing programs use it to bend other pictures in the same way.
//!
//! Each pixel holds the point of the picture at its centre. Where triangles overlap, the last triangle whose picture is
//! more than half opaque there determines the point, so a soft edge does not hide the picture below it. Coverage is
//! that of [`warp`](super::warp) for an opaque picture.
//!
//! Cost: linear in the pixels drawn, with about 30 bytes per pixel of the rows.

use std::ops::Range;

use glam::DVec2;

use super::facet::{Facet, Mask};
use super::texture::{OPAQUE, Texture};

/// The source of one pixel of a warped picture. All fields are 0 if nothing is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Source {
    /// The rest position that the pixel's centre shows, in pixels of the picture, clamped to its border.
    pub rest: [f32; 2],
    /// The Jacobian determinant of the warp there, in pixels of the picture.
    ///
    /// It is negative where the picture is flipped, and 0 where its border is stretched over an area.
    pub det: f32,
    /// The greatest and the least stretch there: the singular values of the Jacobian. Their product is `det`, so the
    /// second one is negative where the picture is flipped.
    pub stretch: [f32; 2],
    /// The fraction of the pixel that triangles cover.
    pub coverage: f32,
}

/// The state of a pixel during rasterisation.
#[derive(Debug, Clone, Copy, Default)]
struct Pixel {
    covered: Mask,
    /// Whether the picture is opaque at the pixel's source.
    is_opaque: bool,
}

/// Rows of a result, and the position of the picture in it.
pub(super) struct SourceRows {
    pub(super) rows: Range<usize>,
    pub(super) width: usize,
    /// The picture's upper left corner in the result.
    pub(super) origin: DVec2,
    /// Pixels of the result per pixel of the picture.
    pub(super) scale: f64,
    /// Width and height of the picture.
    pub(super) picture: DVec2,
}

impl SourceRows {
    /// Adds the sources of the pixels that facets draw with their textures, in drawing order.
    pub(super) fn fill<'a>(&self, facets: impl Iterator<Item = (&'a Facet, &'a Texture<'a>)>, sources: &mut [Source]) {
        let Self { rows, width, origin, scale, picture } = self;
        let width = *width;
        let mut pixels = vec![Pixel::default(); sources.len()];
        for (facet, texture) in facets {
            let det = (facet.det() / (scale * scale)) as f32;
            let stretch = facet.stretch().map(|stretch| (stretch / scale) as f32);
            let touched = facet.rows(rows.end);
            for row in touched.start.max(rows.start)..touched.end {
                let centres = facet.covered_centres(row, width);
                facet.for_each_covered(row..row + 1, width, texture.filter(), |x, _, mask| {
                    let at = (row - rows.start) * width + x;
                    let (pixel, source) = (&mut pixels[at], &mut sources[at]);
                    let centre = DVec2::new(x as f64 + 0.5, row as f64 + 0.5);
                    let rest = facet.source(centre - *origin).clamp(DVec2::ZERO, *picture);
                    let covers_centre = centres.contains(&x);
                    let is_opaque = covers_centre && texture.sample(rest, facet.footprint()).w > OPAQUE / 2.0;
                    if is_opaque || covers_centre && !pixel.is_opaque || pixel.covered == 0 {
                        (source.rest, source.det, source.stretch) = (rest.as_vec2().to_array(), det, stretch);
                    }
                    pixel.is_opaque |= is_opaque;
                    pixel.covered |= mask;
                });
            }
        }
        for (source, pixel) in sources.iter_mut().zip(pixels) {
            source.coverage = pixel.covered.count_ones() as f32 / Mask::BITS as f32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{
        drawing::Drawing,
        options::{Canvas, Filter, ResampleOptions},
        warped::Warped,
    };
    use super::*;
    use crate::picture::Picture;

    const SQUARE: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
    const GROWN: ResampleOptions =
        ResampleOptions { scale: 1.0, canvas: Canvas::Grown, filter: Filter::Cubic, edges: false };

    fn corners(from: [f64; 2], to: [f64; 2]) -> [DVec2; 4] {
        let ([left, top], [right, bottom]) = (from, to);
        [[left, top], [right, top], [right, bottom], [left, bottom]].map(DVec2::from)
    }

    /// Warps a picture of 8 by 4 pixels and returns its sources.
    fn warped_sources(
        rgba: &[u8],
        rest: &[DVec2],
        posed: &[DVec2],
        triangles: &[[u32; 3]],
        options: ResampleOptions,
    ) -> (Warped, Vec<Source>) {
        let picture = Picture::new(8, 4, rgba).unwrap();
        let drawing = Drawing::new(&picture, rest, posed, triangles, options).unwrap();
        let sources = drawing.sources(&picture, 0..drawing.height());
        (drawing.warped(&picture), sources)
    }

    #[test]
    fn sources_follow_scale_and_grown_canvas() {
        let rest = corners([0.0, 0.0], [8.0, 4.0]);
        // Twice as wide, shifted left by half a pixel, at scale 1.5.
        let posed = rest.map(|p| DVec2::new(2.0 * p.x - 0.5, p.y));
        let (warped, sources) =
            warped_sources(&[255; 8 * 4 * 4], &rest, &posed, &SQUARE, ResampleOptions { scale: 1.5, ..GROWN });
        assert_eq!((warped.width, warped.height, warped.origin), (25, 6, [1, 0]));
        for (pixel, source) in sources.iter().enumerate() {
            let at = DVec2::new((pixel % 25) as f64 - 0.5, (pixel / 25) as f64 + 0.5) / 1.5;
            // The mesh does not cover the centres of the outermost pixels, so they show the border.
            let expected = DVec2::new(((at.x + 0.5) / 2.0).clamp(0.0, 8.0), at.y).as_vec2();
            assert!((expected - glam::Vec2::from(source.rest)).length() < 1e-6, "{pixel}: {source:?}");
            assert!((source.det - 2.0).abs() < 1e-6 && source.coverage > 0.0, "{pixel}: {source:?}");
            assert!(source.stretch.iter().zip([2.0, 1.0]).all(|(a, b)| (a - b).abs() < 1e-6), "{source:?}");
        }
        // The mesh covers x from 0.25 to 24.25.
        assert_eq!([sources[0].coverage, sources[1].coverage, sources[24].coverage], [0.75, 1.0, 0.25]);
        // The nearest filter covers whole pixels.
        let options = ResampleOptions { scale: 1.5, filter: Filter::Nearest, ..GROWN };
        let (warped, whole) = warped_sources(&[255; 8 * 4 * 4], &rest, &posed, &SQUARE, options);
        assert_eq!((warped.width, warped.origin), (24, [1, 0]));
        assert!((0..24).all(|x| (whole[x].rest, whole[x].coverage) == (sources[x].rest, 1.0)));
    }

    #[test]
    fn last_opaque_triangle_is_the_source() {
        // The left half lies over the right half. Its first column is transparent, its second column one third opaque.
        let mut rgba = vec![255; 8 * 4 * 4];
        for row in rgba.chunks_exact_mut(8 * 4) {
            (row[3], row[4 + 3]) = (0, 85);
        }
        let rest = [corners([4.0, 0.0], [8.0, 4.0]), corners([0.0, 0.0], [4.0, 4.0])].concat();
        let posed = [corners([4.0, 0.0], [8.0, 4.0]), corners([8.0, 0.0], [4.0, 4.0])].concat();
        let triangles = [SQUARE, SQUARE.map(|triangle| triangle.map(|v| v + 4))].concat();
        let (_, sources) = warped_sources(&rgba, &rest, &posed, &triangles, GROWN);
        let row: Vec<_> = sources[8..16].iter().map(|source| (source.rest[0], source.det, source.coverage)).collect();
        let nothing = (0.0, 0.0, 0.0);
        let (over, under) = (|x| (x, -1.0, 1.0), |x| (x, 1.0, 1.0));
        assert_eq!(row, [nothing, nothing, nothing, nothing, over(3.5), over(2.5), under(6.5), under(7.5)]);
    }
}
