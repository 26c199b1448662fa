//! The part of a picture that a fill works on: the hole with its surroundings, shrunk to a bounded size.
//!
//! Cost: linear in the pixels of the part.

use super::level::{Level, Texel};
use crate::domain::Mask;
use crate::picture::Picture;

/// Maximum number of texels to work on. Matching them takes most of the time of a fill.
const MOST_TEXELS: u64 = 250_000;
/// Surroundings on each side, as a fraction of the longer side of the hole, and a minimum in pixels.
const SURROUNDINGS: f64 = 0.75;
const LEAST_SURROUNDINGS: u32 = 48;
/// Number of texels to each side over which the texture is averaged.
const TEXTURE_RADIUS: usize = 4;
/// Weight of texture relative to colours. The mean of gradients is small, because few gradients are strong.
const TEXTURE_WEIGHT: i32 = 4;

/// A box of a picture, and the pixels per texel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Region {
    pub(super) left: u32,
    pub(super) top: u32,
    pub(super) right: u32,
    pub(super) bottom: u32,
    /// Side of a texel in pixels.
    pub(super) step: u32,
}

impl Region {
    pub(super) fn new(mask: &Mask, (width, height): (u32, u32)) -> Self {
        let longer = f64::from(mask.width.max(mask.height));
        let around = ((SURROUNDINGS * longer) as u32).max(LEAST_SURROUNDINGS);
        let [left, top] = mask.origin.map(|from| from.saturating_sub(around));
        let right = (mask.origin[0] + mask.width + around).min(width);
        let bottom = (mask.origin[1] + mask.height + around).min(height);
        let texels = |step: u32| u64::from((right - left).div_ceil(step)) * u64::from((bottom - top).div_ceil(step));
        let step = (1..).find(|&step| texels(step) <= MOST_TEXELS).expect("a large step leaves few texels");
        Self { left, top, right, bottom, step }
    }

    /// Width and height in texels.
    pub(super) fn size(&self) -> [usize; 2] {
        [self.right - self.left, self.bottom - self.top].map(|side| side.div_ceil(self.step) as usize)
    }

    /// The texels of this part: each is the mean of its pixels. It belongs to the hole if any of them does.
    pub(super) fn level(&self, picture: &Picture<'_>, mask: &Mask) -> Level {
        let [width, height] = self.size();
        let mut texels = Vec::with_capacity(width * height);
        let mut hole = Vec::with_capacity(width * height);
        for (row, column) in (0..height as u32).flat_map(|row| (0..width as u32).map(move |column| (row, column))) {
            let (x, y) = (self.left + column * self.step, self.top + row * self.step);
            let (mut sum, mut count, mut is_hole) = ([0_u32; 4], 0, false);
            for y in y..self.bottom.min(y + self.step) {
                for x in x..self.right.min(x + self.step) {
                    is_hole |= mask.has(x, y);
                    sum.iter_mut()
                        .zip(premultiplied(picture.pixel(x as usize, y as usize)))
                        .for_each(|(sum, part)| *sum += part);
                    count += 255;
                }
            }
            let [r, g, b, a] = sum.map(|sum| ((sum + count / 2) / count) as i16);
            texels.push([r, g, b, a, 0, 0, 0, 0]);
            hole.push(is_hole);
        }
        add_texture(&mut texels, &hole, [width, height]);
        // The hole itself counts for nothing.
        texels.iter_mut().zip(&hole).filter(|(_, hole)| **hole).for_each(|(texel, _)| *texel = Texel::default());
        Level::new(width, height, texels, hole)
    }
}

/// Premultiplied colour and opacity, each times 255.
fn premultiplied([r, g, b, a]: [u8; 4]) -> [u32; 4] {
    [r, g, b, 255].map(|part| u32::from(part) * u32::from(a))
}

/// Sets the texture of texels near known ones: the mean of the absolute gradients.
fn add_texture(texels: &mut [Texel], hole: &[bool], [width, height]: [usize; 2]) {
    let light = |at: usize| {
        let [r, g, b, ..] = texels[at].map(i32::from);
        (2 * r + 5 * g + b) / 8
    };
    // Per texel: the sums of gradients along x and y, and the numbers of both.
    let mut sums = vec![[0_i32; 4]; texels.len()];
    for at in (0..texels.len()).filter(|&at| !hole[at]) {
        let beside = [(at % width + 1 < width).then_some(at + 1), (at / width + 1 < height).then_some(at + width)];
        for (axis, beside) in beside.into_iter().enumerate() {
            if let Some(beside) = beside.filter(|&beside| !hole[beside]) {
                sums[at][axis] = (light(at) - light(beside)).abs();
                sums[at][axis + 2] = 1;
            }
        }
    }
    let sums = box_sums(&box_sums(&sums, [width, height], 1), [height, width], width);
    for (texel, [along, down, columns, rows]) in texels.iter_mut().zip(sums) {
        let mean = |sum: i32, count: i32| (TEXTURE_WEIGHT * sum / count.max(1)).min(255) as i16;
        (texel[4], texel[5]) = (mean(along, columns), mean(down, rows));
    }
}

/// Sums over neighbours in lines of `length` texels that are `stride` apart. `others` is the number of lines.
fn box_sums(values: &[[i32; 4]], [length, others]: [usize; 2], stride: usize) -> Vec<[i32; 4]> {
    let mut sums = vec![[0; 4]; values.len()];
    for line in 0..others {
        let first = if stride == 1 { line * length } else { line };
        let mut sum = [0; 4];
        let mut add = |at: usize, sign: i32| {
            sum.iter_mut().zip(values[first + at * stride]).for_each(|(sum, part)| *sum += sign * part);
            sum
        };
        for at in 0..length.min(TEXTURE_RADIUS) {
            add(at, 1);
        }
        for at in 0..length {
            let mut now = [0; 4];
            if at + TEXTURE_RADIUS < length {
                now = add(at + TEXTURE_RADIUS, 1);
            }
            if at > TEXTURE_RADIUS {
                now = add(at - TEXTURE_RADIUS - 1, -1);
            } else if at + TEXTURE_RADIUS >= length {
                now = add(0, 0);
            }
            sums[first + at * stride] = now;
        }
    }
    sums
}
