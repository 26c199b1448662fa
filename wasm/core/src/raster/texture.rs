//! The picture as a texture, read at any place and level of detail: bilinear within a level, linear between levels.
//!
//! Colours are premultiplied by their opacity on a scale from 0 to 255² = 65,025, on which the product of two bytes is exact:
//! a read at the centre of a texel returns its bytes.

use glam::{DVec2, Vec4};

use crate::picture::Picture;

/// Full opacity.
pub(super) const OPAQUE: f32 = 65_025.0;

/// Places between texels are rounded to 1/256, as on hardware, which also absorbs rounding errors beside a texel's centre.
const FRACTIONS: f64 = 256.0;

/// A picture and its reductions.
#[derive(Debug)]
pub(super) struct Texture<'a> {
    picture: Picture<'a>,
    /// Half the size, a quarter of the size, and so on, as far as needed.
    reductions: Vec<Reduction>,
}

#[derive(Debug)]
struct Reduction {
    width: usize,
    height: usize,
    texels: Vec<[u16; 4]>,
}

impl<'a> Texture<'a> {
    /// Prepares levels of detail up to `greatest_lod`.
    pub(super) fn new(picture: Picture<'a>, greatest_lod: f32) -> Self {
        let mut texture = Self { picture, reductions: Vec::new() };
        let last = picture.width().max(picture.height()).ilog2();
        for level in 0..last.min(greatest_lod.ceil() as u32) as usize {
            let next = texture.halved(level);
            texture.reductions.push(next);
        }
        texture
    }

    /// The colour at a place, in pixels of the picture, at a level of detail; beyond the border, that of the border.
    pub(super) fn sample(&self, place: DVec2, lod: f32) -> Vec4 {
        let lod = lod.min(self.reductions.len() as f32);
        let level = lod as usize;
        let between = lod - level as f32;
        let colour = self.bilinear(level, place);
        if between == 0.0 {
            return colour;
        }
        colour + (self.bilinear(level + 1, place) - colour) * between
    }

    fn bilinear(&self, level: usize, place: DVec2) -> Vec4 {
        let (width, height) = self.size(level);
        let (x, right, across) = taps(place.x, self.picture.width() as usize, width);
        let (y, below, down) = taps(place.y, self.picture.height() as usize, height);
        if across == 0.0 && down == 0.0 {
            return self.texel(level, x, y);
        }
        let row = |y| {
            let left = self.texel(level, x, y);
            left + (self.texel(level, right, y) - left) * across
        };
        let upper = row(y);
        upper + (row(below) - upper) * down
    }

    fn size(&self, level: usize) -> (usize, usize) {
        match level {
            0 => (self.picture.width() as usize, self.picture.height() as usize),
            _ => (self.reductions[level - 1].width, self.reductions[level - 1].height),
        }
    }

    fn texel(&self, level: usize, x: usize, y: usize) -> Vec4 {
        if level == 0 {
            let start = (y * self.picture.width() as usize + x) * 4;
            let [r, g, b, a] = [0, 1, 2, 3].map(|channel| f32::from(self.picture.rgba()[start + channel]));
            Vec4::new(r, g, b, 255.0) * a
        } else {
            let reduction = &self.reductions[level - 1];
            Vec4::from_array(reduction.texels[y * reduction.width + x].map(f32::from))
        }
    }

    /// The next level, at half the size; every texel of the level has the same total weight, also where a side is odd.
    fn halved(&self, level: usize) -> Reduction {
        let (from_width, from_height) = self.size(level);
        let (width, height) = ((from_width / 2).max(1), (from_height / 2).max(1));
        let columns: Vec<_> = (0..width).map(|x| Shares::new(x, from_width)).collect();
        let mut texels = Vec::with_capacity(width * height);
        for row in (0..height).map(|y| Shares::new(y, from_height)) {
            for column in &columns {
                let mut sum = Vec4::ZERO;
                for (y, down) in row.iter() {
                    for (x, across) in column.iter() {
                        sum += self.texel(level, x, y) * (down * across);
                    }
                }
                texels.push((sum + 0.5).to_array().map(|channel| channel as u16));
            }
        }
        Reduction { width, height, texels }
    }
}

/// Weights of the two or three texels under a texel of the next level.
struct Shares {
    first: usize,
    count: usize,
    shares: [f32; 3],
}

impl Shares {
    /// For the texel `index` of a row with half of `length` texels.
    fn new(index: usize, length: usize) -> Self {
        let half = length / 2;
        let (count, shares) = match (length, length % 2) {
            (1, _) => (1, [1.0, 0.0, 0.0]),
            (_, 0) => (2, [0.5, 0.5, 0.0]),
            // A texel covers `length / half` texels, slightly more than two.
            _ => (3, [half - index, half, index + 1].map(|part| part as f32 / length as f32)),
        };
        Self { first: 2 * index, count, shares }
    }

    fn iter(&self) -> impl Iterator<Item = (usize, f32)> {
        (self.first..).zip(self.shares).take(self.count)
    }
}

/// The two texels beside a place, and its position from the first to the second (0 to 1), in a row of `length` texels that
/// shows `whole` pixels of the picture.
fn taps(place: f64, whole: usize, length: usize) -> (usize, usize, f32) {
    let length_px = length as f64;
    let centre = (place * (length_px / whole as f64)).clamp(0.5, length_px - 0.5) - 0.5;
    let steps = (centre * FRACTIONS + 0.5) as usize;
    let (first, fraction) = (steps / FRACTIONS as usize, steps % FRACTIONS as usize);
    (first, (first + 1).min(length - 1), fraction as f32 / FRACTIONS as f32)
}
