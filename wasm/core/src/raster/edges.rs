//! A thin dark edge where one part of a warped picture lies in front of another, so that parts of the same colour can
//! be distinguished.
//!
//! The edge lies only on the part behind. It is darkest at the border, and ends [`RADIUS`] away from it. Only colours
//! change, not opacity.
//!
//! For each pixel, the point of the picture drawn there is recorded, and the point below it if that belongs to another
//! part. A pixel lies behind a nearby pixel if its own part continues there, below the drawn part. The darkness is the
//! fraction of a disc around the pixel that lies in front. That fraction also determines how much of a pixel on the
//! border lies behind. A hidden border casts no edge. `web/src/render/edges.frag.glsl` draws the same.
//!
//! Cost: linear in the pixels of the rectangle around all crossings, about 100 ns each. Memory holds a copy of the
//! facets there, and the points of [`LAYER_ROWS`] rows.
//!
//! Limits: a third part below two others is not recorded.

use std::f32::consts::FRAC_PI_2;
use std::ops::Range;

use glam::{DVec2, Vec2};

use super::facet::Facet;
use super::frame::{Area, Frame};
use crate::{deform::Bounds, picture::Picture};

/// Radius of the disc as a fraction of the picture's diagonal.
const RADIUS: f64 = 0.004;
/// Least radius, in pixels of the picture.
const LEAST_RADIUS_PX: f64 = 2.0;
/// Number of sample points of the disc. They lie on a spiral that covers it evenly (Vogel 1979).
const PLACES: usize = 32;
/// Turn from one sample point to the next: the golden angle, in radians.
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;
/// Darkness of a pixel whose whole disc lies in front.
const DARKNESS: f32 = 0.9;
/// Points of the picture farther apart than this belong to different parts, in radii. Up to twice this distance, the
/// edge fades: it ends softly where one part grows out of another.
const APART: f32 = 4.0;
/// Points of the same part differ by at most this, relative to their distance on the screen.
const STRETCH: f32 = 3.0;
/// Number of rows that are darkened together.
const LAYER_ROWS: usize = 128;

/// The points of the picture at a pixel; NaN if it has fewer.
#[derive(Clone, Copy)]
struct Layers {
    top: Vec2,
    /// The point of another part, below.
    below: Vec2,
}

const NOTHING: Layers = Layers { top: Vec2::NAN, below: Vec2::NAN };

/// A sample point of the disc.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// Offset from the centre pixel to the pixel of this sample point, in an array of the grid's rows.
    step: isize,
    /// Points of the same part are at most this far apart, in pixels of the picture.
    within: f32,
}

/// The edges of one drawing.
#[derive(Debug)]
pub(super) struct Edges {
    /// The pixels around all crossings, in the frame of the drawing.
    area: Area,
    /// The area with a margin as wide as the disc.
    grid: Frame,
    margin: usize,
    /// In drawing order, relative to the grid.
    facets: Vec<Facet>,
    disc: [Place; PLACES],
    /// In pixels of the result.
    radius: f32,
    /// Points of the picture farther apart than this belong to different parts.
    apart: f32,
    /// Width of the frame.
    width: usize,
}

impl Edges {
    /// Returns `None` if the frame shows no crossing. `facets` are relative to the frame, and `around` bounds all
    /// crossings, in pixels of the picture.
    pub(super) fn new(
        picture: &Picture<'_>,
        frame: Frame,
        facets: &[Facet],
        scale: f64,
        around: Bounds,
    ) -> Option<Self> {
        let diagonal = libm::hypot(picture.width().into(), picture.height().into());
        let radius = (RADIUS * diagonal).max(LEAST_RADIUS_PX);
        let pixels = |axis: usize| -> Range<usize> {
            let pixel = |place: f64| (place as i64 + frame.origin[axis]).clamp(0, frame.size[axis] as i64) as usize;
            let [from, to] = [around.min.to_array()[axis] - radius, around.max.to_array()[axis] + radius];
            pixel((from * scale).floor())..pixel((to * scale).ceil())
        };
        let area = Area { columns: pixels(0), rows: pixels(1) };
        if area.is_empty() {
            return None;
        }
        let margin = (radius * scale).ceil() as usize + 1;
        let Frame { origin, size: [columns, rows] } = frame.of_area(&area);
        let grid =
            Frame { origin: origin.map(|side| side + margin as i64), size: [columns + 2 * margin, rows + 2 * margin] };
        let to_grid = [0, 1].map(|axis| grid.origin[axis] - frame.origin[axis]);
        let in_grid = |facet: &Facet| {
            let mut moved = facet.clone();
            moved.move_by(to_grid);
            (!moved.columns(grid.size[0]).is_empty() && !moved.rows(grid.size[1]).is_empty()).then_some(moved)
        };
        Some(Self {
            facets: facets.iter().filter_map(in_grid).collect(),
            disc: disc(radius, scale, grid.size[0]),
            radius: (radius * scale) as f32,
            apart: APART * radius as f32,
            width: frame.size[0],
            area,
            grid,
            margin,
        })
    }

    /// Darkens the edges in rows of the drawing, from `first` on.
    pub(super) fn darken(&self, picture: &Picture<'_>, rgba: &mut [u8], first: usize) {
        let Area { columns, rows } = &self.area;
        for (index, rgba) in rgba.chunks_mut(LAYER_ROWS * self.width * 4).enumerate() {
            let start = first + index * LAYER_ROWS;
            let rows = rows.start.max(start)..rows.end.min(start + rgba.len() / (self.width * 4));
            if rows.is_empty() {
                continue;
            }
            let from = rows.start - self.area.rows.start;
            let layers = self.layers(picture, from..from + rows.len() + 2 * self.margin);
            for (y, row) in rows.enumerate() {
                let bytes = &mut rgba[((row - start) * self.width + columns.start) * 4..][..columns.len() * 4];
                let left = (y + self.margin) * self.grid.size[0] + self.margin;
                for (x, rgba) in bytes.chunks_exact_mut(4).enumerate() {
                    let darkness = self.darkness(&layers, left + x);
                    if darkness > 0.0 {
                        for channel in &mut rgba[..3] {
                            *channel = (f32::from(*channel) * (1.0 - darkness) + 0.5) as u8;
                        }
                    }
                }
            }
        }
    }

    /// The points of the picture at each pixel of the given rows of the grid, where the picture is more than half
    /// opaque.
    fn layers(&self, picture: &Picture<'_>, rows: Range<usize>) -> Vec<Layers> {
        let width = self.grid.size[0];
        let origin = DVec2::from(self.grid.origin.map(|side| side as f64));
        let most = DVec2::new(f64::from(picture.width() - 1), f64::from(picture.height() - 1));
        let is_opaque = |rest: DVec2| {
            let [x, y] = rest.floor().clamp(DVec2::ZERO, most).to_array().map(|x| x as usize);
            picture.rgba()[(y * picture.width() as usize + x) * 4 + 3] > 127
        };
        let mut layers = vec![NOTHING; width * rows.len()];
        for facet in &self.facets {
            let touched = facet.rows(rows.end);
            for row in touched.start.max(rows.start)..touched.end {
                for x in facet.covered_centres(row, width) {
                    let rest = facet.source(DVec2::new(x as f64 + 0.5, row as f64 + 0.5) - origin);
                    if is_opaque(rest) {
                        let (rest, here) = (rest.as_vec2(), &mut layers[(row - rows.start) * width + x]);
                        if here.top.distance(rest) > self.apart {
                            here.below = here.top;
                        }
                        here.top = rest;
                    }
                }
            }
        }
        layers
    }

    fn darkness(&self, layers: &[Layers], pixel: usize) -> f32 {
        let Layers { top, below } = layers[pixel];
        let darkness = |own: Vec2, is_seen: bool| {
            if own.is_nan() { 0.0 } else { self.darkness_of(own, is_seen, layers, pixel) }
        };
        // A pixel in front shows some of the part behind if the border runs through it.
        darkness(top, true).max(darkness(below, false))
    }

    /// The darkness at a pixel of the part with the point `own` there.
    fn darkness_of(&self, own: Vec2, is_seen: bool, layers: &[Layers], pixel: usize) -> f32 {
        let (mut seen, mut covered, mut distinct) = (0.0, 0.0, 0.0);
        for &Place { step, within } in &self.disc {
            let Layers { top, below } = layers[pixel.wrapping_add_signed(step)];
            // Comparisons with NaN do not hold.
            if top.distance(own) < within {
                seen += 1.0;
            }
            if below.distance(own) < within {
                covered += 1.0;
                distinct += (top.distance(own) / self.apart - 1.0).clamp(0.0, 1.0);
            }
        }
        // The border cuts off a disc at a distance of (π/2) (½ − covered) radii from its middle.
        let half = PLACES as f32 / 2.0;
        let clear = if is_seen { half - covered } else { (half - covered).min(seen - half) };
        let distance = FRAC_PI_2 * clear / PLACES as f32 * self.radius;
        DARKNESS * (distance + 0.5).clamp(0.0, 1.0) * distinct / PLACES as f32
    }
}

/// Returns the sample points of the disc. `radius` is in pixels of the picture, and rows have `width` pixels.
fn disc(radius: f64, scale: f64, width: usize) -> [Place; PLACES] {
    std::array::from_fn(|k| {
        let (sin, cos) = libm::sincos(GOLDEN_ANGLE * k as f64);
        let away = radius * scale * ((k as f64 + 0.5) / PLACES as f64).sqrt();
        let [x, y] = [cos, sin].map(|side| (away * side + 0.5).floor() as isize);
        Place { step: y * width as isize + x, within: STRETCH * (away as f32 + 1.0) / scale as f32 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{
        Drawing,
        options::{Canvas, ResampleOptions},
    };

    const SIZE: [usize; 2] = [400, 100];

    /// A grey picture of 400 by 100 pixels: its right quarter is drawn over `behind` pixels on the left, 50 px from the
    /// left.
    fn crossed(behind: f64, canvas: Canvas, edges: bool, read: impl Fn(&Drawing, &Picture<'_>) -> Vec<u8>) -> Vec<u8> {
        let rgba = [200, 200, 200, 255].repeat(SIZE[0] * SIZE[1]);
        let picture = Picture::new(400, 100, &rgba).unwrap();
        let square = |x: f64, side: f64| [[x, 0.0], [x + side, 0.0], [x + side, 100.0], [x, 100.0]].map(DVec2::from);
        let rest = [square(0.0, behind), square(300.0, 100.0)].concat();
        let posed = [square(0.0, behind), square(50.0, 100.0)].concat();
        let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
        let options = ResampleOptions { canvas, ..ResampleOptions::default() };
        let drawing = Drawing::new(&picture, &rest, &posed, &triangles, options).unwrap();
        let around = Bounds { min: DVec2::new(50.0, 0.0), max: DVec2::new(150.0, 100.0) };
        read(&if edges { drawing.with_edges(&picture, 1.0, around) } else { drawing }, &picture)
    }

    fn whole(drawing: &Drawing, picture: &Picture<'_>) -> Vec<u8> {
        drawing.warped(picture).rgba
    }

    /// The columns of the middle row that edges darken.
    fn darkened(behind: f64) -> Vec<usize> {
        let [plain, edged] = [false, true].map(|edges| crossed(behind, Canvas::Picture, edges, whole));
        assert!(plain.iter().zip(&edged).skip(3).step_by(4).all(|(before, after)| before == after));
        let red = |x: &usize| (50 * SIZE[0] + x) * 4;
        (0..SIZE[0]).filter(|x| edged[red(x)] != plain[red(x)]).collect()
    }

    #[test]
    fn the_edge_lies_on_the_part_behind_alone_and_fades() {
        let edged = crossed(200.0, Canvas::Picture, true, whole);
        let red = |x: usize| edged[(50 * 400 + x) * 4];
        let row: Vec<u8> = (44..54).map(red).collect();
        assert!(row.windows(2).take(5).all(|pair| pair[0] >= pair[1]), "{row:?}");
        assert!(red(49) < 170 && red(150) < 170, "{row:?}");
        // In front, and farther than the radius of 2 px, nothing changes.
        let is_near = |x: &usize| (47..=50).contains(x) || (149..153).contains(x);
        assert!(darkened(200.0).iter().all(is_near), "{row:?}");
    }

    #[test]
    fn a_hidden_border_of_the_part_behind_casts_no_edge() {
        let columns = darkened(100.0);
        assert!(columns.contains(&49) && columns.iter().all(|x| (47..=50).contains(x)), "{columns:?}");
    }

    #[test]
    fn edges_are_the_same_in_bands_and_on_every_canvas() {
        let edged = crossed(200.0, Canvas::Picture, true, whole);
        let bands = crossed(200.0, Canvas::Picture, true, |drawing, picture| {
            [0..16, 16..64, 64..100].map(|rows| drawing.rows(picture, rows)).concat()
        });
        assert!(bands == edged);
        let covered = crossed(200.0, Canvas::Covered, true, whole);
        assert_eq!(covered.len(), 200 * 100 * 4);
        assert!(covered.chunks(200 * 4).zip(edged.chunks(400 * 4)).all(|(part, row)| *part == row[..200 * 4]));
    }
}
