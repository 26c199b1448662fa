//! A band of rows of the result during rasterisation.
//!
//! A pixel has one colour, or one per coverage sample if triangles meet in it.

use std::ops::Range;

use glam::{DVec2, Vec4};

use super::facet::{Facet, GRID, Mask};
use super::fade::Fade;
use super::options::Filter;
use super::texture::{OPAQUE, Texture};

const SAMPLES: usize = GRID * GRID;

/// Rows of pixels, premultiplied as in [`Texture`].
pub(super) struct Band {
    width: usize,
    rows: Range<usize>,
    /// The picture's upper left corner in the result.
    origin: DVec2,
    /// Colour of each pixel whose samples are all equal.
    pixels: Vec<Vec4>,
    /// Index in `splits` plus 1 for a pixel whose samples differ, otherwise 0.
    split: Vec<u32>,
    splits: Vec<[Vec4; SAMPLES]>,
}

impl Band {
    pub(super) fn new(width: usize, height: usize, origin: [i64; 2]) -> Self {
        Self {
            width,
            rows: 0..height,
            origin: DVec2::from(origin.map(|side| side as f64)),
            pixels: vec![Vec4::ZERO; width * height],
            split: vec![0; width * height],
            splits: Vec::new(),
        }
    }

    /// Clears the band and moves it to another row of the result.
    pub(super) fn clear(&mut self, first_row: usize) {
        self.rows = first_row..first_row + self.rows.len();
        self.pixels.fill(Vec4::ZERO);
        self.split.fill(0);
        self.splits.clear();
    }

    /// Draws a facet over the current colours. It may fade out; the number is the pixels of the picture per pixel of
    /// the result.
    pub(super) fn draw(&mut self, facet: &Facet, texture: &Texture<'_>, fade: Option<(&Fade, f64)>) {
        let (rows, width) = (facet.rows(self.rows.end), self.width);
        let rows = rows.start.max(self.rows.start)..rows.end;
        facet.for_each_covered(rows, width, texture.filter(), |x, row, mask| {
            let centre = DVec2::new(x as f64 + 0.5, row as f64 + 0.5);
            let source = facet.source(centre - self.origin);
            let mut colour = texture.sample(source, facet.footprint());
            if let Some((fade, step)) = fade {
                let place = centre - self.origin;
                colour *= fade.opacity(place, place * step - source);
            }
            let pixel = (row - self.rows.start) * width + x;
            match texture.filter() {
                Filter::Cubic => self.blend(pixel, mask, colour),
                Filter::Nearest => self.replace(pixel, colour),
            }
        });
    }

    /// Replaces the colour of a pixel, so that no colours are mixed.
    fn replace(&mut self, pixel: usize, colour: Vec4) {
        if colour.w != 0.0 {
            self.pixels[pixel] = colour;
        }
    }

    /// Blends a colour over the samples of a pixel given by `mask`.
    fn blend(&mut self, pixel: usize, mask: Mask, colour: Vec4) {
        if colour.w == 0.0 {
            return;
        }
        match (self.split[pixel], mask) {
            (0, Mask::MAX) => self.pixels[pixel] = over(colour, self.pixels[pixel]),
            (0, _) => {
                let mut samples = [self.pixels[pixel]; SAMPLES];
                blend_samples(&mut samples, mask, colour);
                self.splits.push(samples);
                self.split[pixel] = self.splits.len() as u32;
            }
            (split, _) => blend_samples(&mut self.splits[split as usize - 1], mask, colour),
        }
    }

    /// Writes the rows as straight RGBA, as many as fit into `rgba`.
    pub(super) fn resolve(&self, rgba: &mut [u8]) {
        for (pixel, bytes) in rgba.chunks_exact_mut(4).enumerate() {
            bytes.copy_from_slice(&straight(self.colour(pixel)));
        }
    }

    /// Returns whether a pixel of the result is not empty.
    pub(super) fn has_opacity(&self, x: usize, row: usize) -> bool {
        straight(self.colour((row - self.rows.start) * self.width + x))[3] != 0
    }

    fn colour(&self, pixel: usize) -> Vec4 {
        match self.split[pixel] {
            0 => self.pixels[pixel],
            split => self.splits[split as usize - 1].iter().sum::<Vec4>() / SAMPLES as f32,
        }
    }
}

fn blend_samples(samples: &mut [Vec4; SAMPLES], mask: Mask, colour: Vec4) {
    for (i, sample) in samples.iter_mut().enumerate() {
        if mask >> i & 1 == 1 {
            *sample = over(colour, *sample);
        }
    }
}

/// The `over` operator of Porter and Duff (1984).
fn over(upper: Vec4, lower: Vec4) -> Vec4 {
    if upper.w >= OPAQUE { upper } else { upper + lower * (1.0 - upper.w / OPAQUE) }
}

/// Returns straight RGBA bytes. A colour whose opacity rounds to 0 becomes transparent black.
fn straight(colour: Vec4) -> [u8; 4] {
    let opacity = colour.w / 255.0;
    let opacity_byte = (opacity + 0.5) as u8;
    if opacity_byte == 0 {
        return [0; 4];
    }
    let [r, g, b] = (colour.truncate() / opacity + 0.5).to_array().map(|channel| channel as u8);
    [r, g, b, opacity_byte]
}
