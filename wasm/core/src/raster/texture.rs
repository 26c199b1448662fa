//! The picture as a texture, sampled by a cubic filter as wide as the pixel's footprint, or by the nearest texel.
//!
//! Colours are premultiplied by their opacity, on a scale from 0 to 255² = 65,025. On this scale the product of two
//! bytes is exact, so a sample at the centre of a texel returns its bytes.

use glam::{DVec2, Vec4};

use super::facet::Facet;
use super::footprint::Footprint;
use super::kernel::{Taps, nearest};
use super::options::Filter;
use crate::picture::Picture;

/// Full opacity.
pub(super) const OPAQUE: f32 = 65_025.0;

/// A picture and its mip levels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Texture<'a> {
    picture: Picture<'a>,
    filter: Filter,
    mip_levels: &'a [MipLevel],
}

/// A picture at half the size, a quarter of the size, and so on.
#[derive(Debug)]
pub(super) struct MipLevel {
    width: usize,
    height: usize,
    texels: Vec<[u16; 4]>,
}

/// Creates the mip levels of a picture that `facets` read.
pub(super) fn mip_levels(picture: Picture<'_>, filter: Filter, facets: &[Facet]) -> Vec<MipLevel> {
    let level = |facet: &Facet| match filter {
        Filter::Cubic => facet.footprint().level,
        Filter::Nearest => 0,
    };
    let coarsest = facets.iter().map(level).max().unwrap_or(0);
    let last = picture.width().max(picture.height()).ilog2();
    let mut levels = Vec::new();
    for level in 0..last.min(coarsest) as usize {
        let next = Texture::new(picture, filter, &levels).halved(level);
        levels.push(next);
    }
    levels
}

impl<'a> Texture<'a> {
    pub(super) fn new(picture: Picture<'a>, filter: Filter, mip_levels: &'a [MipLevel]) -> Self {
        Self { picture, filter, mip_levels }
    }

    pub(super) fn filter(&self) -> Filter {
        self.filter
    }

    /// Returns the filtered colour at `p`, in pixels of the picture. Beyond the border it is the colour of the border.
    pub(super) fn sample(&self, p: DVec2, footprint: Footprint) -> Vec4 {
        match self.filter {
            Filter::Cubic => self.filtered(p, footprint),
            Filter::Nearest => {
                let (width, height) = self.size(0);
                self.texel(0, nearest(p.x, width), nearest(p.y, height))
            }
        }
    }

    fn filtered(&self, p: DVec2, footprint: Footprint) -> Vec4 {
        let level = (footprint.level as usize).min(self.mip_levels.len());
        let (width, height) = self.size(level);
        let scaled = |position: f64, whole: u32, length: usize| position * (length as f64 / f64::from(whole));
        let p = DVec2::new(scaled(p.x, self.picture.width(), width), scaled(p.y, self.picture.height(), height));
        // Most pixels of most pictures.
        if level == 0
            && footprint.widths == [1.0; 2]
            && let (Some(x), Some(y)) = (Taps::unit(p.x, width), Taps::unit(p.y, height))
        {
            return clamp_overshoot(unit_sum(self.picture.rgba().as_chunks().0, width, x, y));
        }
        let x = Taps::new(p.x, width, footprint.widths[0]);
        let y = Taps::new(p.y, height, footprint.widths[1]);
        if let ([_], [_]) = (x.weights(), y.weights()) {
            return self.texel(level, x.first, y.first);
        }
        let sum = match level {
            0 => sum(self.picture.rgba().as_chunks().0, width, &x, &y, premultiplied),
            _ => sum(&self.mip_levels[level - 1].texels, width, &x, &y, |texel| texel),
        };
        clamp_overshoot(sum)
    }

    fn size(&self, level: usize) -> (usize, usize) {
        match level {
            0 => (self.picture.width() as usize, self.picture.height() as usize),
            _ => (self.mip_levels[level - 1].width, self.mip_levels[level - 1].height),
        }
    }

    fn texel(&self, level: usize, x: usize, y: usize) -> Vec4 {
        if level == 0 {
            premultiplied(value(self.picture.pixel(x, y)))
        } else {
            let mip_level = &self.mip_levels[level - 1];
            value(mip_level.texels[y * mip_level.width + x])
        }
    }

    /// Returns the next mip level, at half the size.
    ///
    /// Every texel of this level has the same total weight, even if a side is odd.
    fn halved(&self, level: usize) -> MipLevel {
        let (from_width, from_height) = self.size(level);
        let (width, height) = ((from_width / 2).max(1), (from_height / 2).max(1));
        let columns: Vec<_> = (0..width).map(|x| BoxWeights::new(x, from_width)).collect();
        let mut texels = Vec::with_capacity(width * height);
        for row in (0..height).map(|y| BoxWeights::new(y, from_height)) {
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
        MipLevel { width, height, texels }
    }
}

/// Weights of the two or three texels below one texel of the next mip level.
struct BoxWeights {
    first: usize,
    count: usize,
    weights: [f32; 3],
}

impl BoxWeights {
    /// Returns the weights below texel `index` of a row with `length / 2` texels.
    fn new(index: usize, length: usize) -> Self {
        let half = length / 2;
        let (count, weights) = match (length, length % 2) {
            (1, _) => (1, [1.0, 0.0, 0.0]),
            (_, 0) => (2, [0.5, 0.5, 0.0]),
            // A texel covers `length / half` texels, slightly more than two.
            _ => (3, [half - index, half, index + 1].map(|part| part as f32 / length as f32)),
        };
        Self { first: 2 * index, count, weights }
    }

    fn iter(&self) -> impl Iterator<Item = (usize, f32)> {
        (self.first..).zip(self.weights).take(self.count)
    }
}

fn value<T: Into<f32>>(texel: [T; 4]) -> Vec4 {
    Vec4::from_array(texel.map(Into::into))
}

fn premultiplied(straight: Vec4) -> Vec4 {
    straight.with_w(255.0) * straight.w
}

/// Returns the weighted sum of the texels under the taps, in rows of `width` texels.
fn sum<T: Copy + Into<f32>>(
    texels: &[[T; 4]],
    width: usize,
    x: &Taps,
    y: &Taps,
    premultiplied: impl Fn(Vec4) -> Vec4,
) -> Vec4 {
    let mut sum = Vec4::ZERO;
    let (quads, others) = x.weights().as_chunks::<4>();
    for (row, &down) in (y.first..).zip(y.weights()) {
        let row = &texels[row * width + x.first..][..x.weights().len()];
        let (texel_quads, other_texels) = row.as_chunks::<4>();
        let mut across = Vec4::ZERO;
        for (texels, weights) in texel_quads.iter().zip(quads) {
            // Four texels at once, so that the compiler vectorises the conversion.
            let flat = texels.as_flattened();
            let values: [f32; 16] = std::array::from_fn(|i| flat[i].into());
            for (value, &weight) in values.as_chunks().0.iter().zip(weights) {
                across += premultiplied(Vec4::from_array(*value)) * weight;
            }
        }
        for (&texel, &weight) in other_texels.iter().zip(others) {
            across += premultiplied(value(texel)) * weight;
        }
        sum += across * down;
    }
    sum
}

/// Like [`sum`], for the taps of [`Taps::unit`] in the picture itself: the same additions in the same order.
fn unit_sum(texels: &[[u8; 4]], width: usize, x: (usize, &[f32; 4]), y: (usize, &[f32; 4])) -> Vec4 {
    let mut sum = Vec4::ZERO;
    for (row, &down) in (y.0..).zip(y.1) {
        let Some(quad) = texels[row * width + x.0..].first_chunk::<4>() else { break };
        let flat = quad.as_flattened();
        let values: [f32; 16] = std::array::from_fn(|i| flat[i].into());
        let mut across = Vec4::ZERO;
        for (value, &weight) in values.as_chunks().0.iter().zip(x.1) {
            across += premultiplied(Vec4::from_array(*value)) * weight;
        }
        sum += across * down;
    }
    sum
}

/// Clamps the overshoot of the cubic at edges to a valid premultiplied colour.
///
/// Each channel is at most the opacity. An opacity above [`OPAQUE`] scales the colour down, so that it does not become
/// brighter.
fn clamp_overshoot(sum: Vec4) -> Vec4 {
    let opacity = sum.w.max(0.0);
    let colour = sum.clamp(Vec4::ZERO, Vec4::splat(opacity));
    if opacity > OPAQUE { (colour * (OPAQUE / opacity)).with_w(OPAQUE) } else { colour }
}
