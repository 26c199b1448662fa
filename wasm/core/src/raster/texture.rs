//! The picture as a texture, read at any place by a cubic as wide as a pixel is there, or by its nearest texel.
//!
//! Colours are premultiplied by their opacity on a scale from 0 to 255² = 65,025, on which the product of two bytes is exact:
//! a read at the centre of a texel returns its bytes.

use glam::{DVec2, Vec4};

use super::facet::Facet;
use super::footprint::Footprint;
use super::kernel::{Taps, nearest};
use super::options::Filter;
use crate::picture::Picture;

/// Full opacity.
pub(super) const OPAQUE: f32 = 65_025.0;

/// A picture and its reductions.
#[derive(Debug)]
pub(super) struct Texture<'a> {
    picture: Picture<'a>,
    filter: Filter,
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
    /// Prepares the levels of detail that facets read.
    pub(super) fn for_facets(picture: Picture<'a>, filter: Filter, facets: &[Facet]) -> Self {
        let level = |facet: &Facet| match filter {
            Filter::Cubic => facet.footprint().level,
            Filter::Nearest => 0,
        };
        Self::new(picture, filter, facets.iter().map(level).max().unwrap_or(0))
    }

    /// Prepares levels of detail up to `greatest`.
    fn new(picture: Picture<'a>, filter: Filter, greatest: u32) -> Self {
        let mut texture = Self { picture, filter, reductions: Vec::new() };
        let last = picture.width().max(picture.height()).ilog2();
        for level in 0..last.min(greatest) as usize {
            let next = texture.halved(level);
            texture.reductions.push(next);
        }
        texture
    }

    pub(super) fn filter(&self) -> Filter {
        self.filter
    }

    /// The colour around a place, in pixels of the picture; beyond the border, that of the border.
    pub(super) fn sample(&self, place: DVec2, footprint: Footprint) -> Vec4 {
        match self.filter {
            Filter::Cubic => self.filtered(place, footprint),
            Filter::Nearest => {
                let (width, height) = self.size(0);
                self.texel(0, nearest(place.x, width), nearest(place.y, height))
            }
        }
    }

    fn filtered(&self, place: DVec2, footprint: Footprint) -> Vec4 {
        let level = (footprint.level as usize).min(self.reductions.len());
        let (width, height) = self.size(level);
        let taps = |place: f64, whole: u32, length: usize, width: f32| {
            Taps::new(place * (length as f64 / f64::from(whole)), length, width)
        };
        let x = taps(place.x, self.picture.width(), width, footprint.widths[0]);
        let y = taps(place.y, self.picture.height(), height, footprint.widths[1]);
        if let ([_], [_]) = (x.shares(), y.shares()) {
            return self.texel(level, x.first, y.first);
        }
        let sum = match level {
            0 => sum(self.picture.rgba().as_chunks().0, width, &x, &y, premultiplied),
            _ => sum(&self.reductions[level - 1].texels, width, &x, &y, |texel| texel),
        };
        colour(sum)
    }

    fn size(&self, level: usize) -> (usize, usize) {
        match level {
            0 => (self.picture.width() as usize, self.picture.height() as usize),
            _ => (self.reductions[level - 1].width, self.reductions[level - 1].height),
        }
    }

    fn texel(&self, level: usize, x: usize, y: usize) -> Vec4 {
        if level == 0 {
            premultiplied(value(self.picture.rgba().as_chunks().0[y * self.picture.width() as usize + x]))
        } else {
            let reduction = &self.reductions[level - 1];
            value(reduction.texels[y * reduction.width + x])
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

fn value<T: Into<f32>>(texel: [T; 4]) -> Vec4 {
    Vec4::from_array(texel.map(Into::into))
}

fn premultiplied(straight: Vec4) -> Vec4 {
    straight.with_w(255.0) * straight.w
}

/// The sum of texels by their shares, in rows of `width` texels.
fn sum<T: Copy + Into<f32>>(
    texels: &[[T; 4]],
    width: usize,
    x: &Taps,
    y: &Taps,
    premultiplied: impl Fn(Vec4) -> Vec4,
) -> Vec4 {
    let mut sum = Vec4::ZERO;
    let (quads, others) = x.shares().as_chunks::<4>();
    for (row, &down) in (y.first..).zip(y.shares()) {
        let row = &texels[row * width + x.first..][..x.shares().len()];
        let (texel_quads, other_texels) = row.as_chunks::<4>();
        let mut across = Vec4::ZERO;
        for (texels, shares) in texel_quads.iter().zip(quads) {
            // Four at a time are converted at once.
            let flat = texels.as_flattened();
            let values: [f32; 16] = std::array::from_fn(|i| flat[i].into());
            for (value, &share) in values.as_chunks().0.iter().zip(shares) {
                across += premultiplied(Vec4::from_array(*value)) * share;
            }
        }
        for (&texel, &share) in other_texels.iter().zip(others) {
            across += premultiplied(value(texel)) * share;
        }
        sum += across * down;
    }
    sum
}

/// The colour that a sum is meant as. The cubic overshoots at edges: no colour is more than its opacity, and an opacity beyond
/// the greatest makes it no brighter.
fn colour(sum: Vec4) -> Vec4 {
    let opacity = sum.w.max(0.0);
    let colour = sum.clamp(Vec4::ZERO, Vec4::splat(opacity));
    if opacity > OPAQUE { (colour * (OPAQUE / opacity)).with_w(OPAQUE) } else { colour }
}
