//! The filled pixels at full size: each is copied from the source of its texel, with the correction of its texel.
//!
//! Texels with different sources fade into each other over the side of a texel. Where the sources agree, the copies are
//! exact, so that texture keeps its detail.
//!
//! Cost: linear in the pixels of the hole.

use glam::Vec4;

use super::level::{Level, NONE};
use super::region::Region;
use crate::domain::Mask;
use crate::picture::Picture;

/// The sources of the texels of the hole.
pub(super) struct Sources<'a> {
    pub(super) region: Region,
    pub(super) level: &'a Level,
    /// For each texel, its source, or [`NONE`].
    pub(super) from: &'a [u32],
    /// For each texel, the correction of the copy, premultiplied, from 0 to 255.
    pub(super) corrections: &'a [Vec4],
}

impl Sources<'_> {
    /// A pixel of the hole in straight RGBA.
    pub(super) fn pixel(&self, picture: &Picture<'_>, mask: &Mask, x: u32, y: u32) -> [u8; 4] {
        let step = self.region.step;
        let (left, top) = (x - self.region.left, y - self.region.top);
        let own = (top / step) as usize * self.level.width + (left / step) as usize;
        let (mut sum, mut total) = (Vec4::ZERO, 0.0);
        let (columns, rows) = (taps(left, step, self.level.width), taps(top, step, self.level.height));
        for (row, down) in rows {
            for (column, across) in columns {
                let at = row * self.level.width + column;
                let weight = across * down;
                if weight > 0.0
                    && self.level.hole[at]
                    && let Some(colour) = self.copied(picture, mask, [x, y], at, at == own)
                {
                    sum += (colour + self.corrections[at]) * weight;
                    total += weight;
                }
            }
        }
        if total > 0.0 { straight(sum * (1.0 / total)) } else { [0; 4] }
    }

    /// The pixel that a texel of the hole is copied from, premultiplied.
    fn copied(&self, picture: &Picture<'_>, mask: &Mask, [x, y]: [u32; 2], at: usize, is_own: bool) -> Option<Vec4> {
        let (from, width) = (self.from[at], self.level.width);
        if from == NONE {
            return Some(Vec4::ZERO);
        }
        let apart = |from: usize, at: usize| (from as i64 - at as i64) * i64::from(self.region.step);
        let moved = |place: u32, by: i64, end: u32| (i64::from(place) + by).clamp(0, i64::from(end) - 1) as u32;
        let x = moved(x, apart(from as usize % width, at % width), picture.width());
        let y = moved(y, apart(from as usize / width, at / width), picture.height());
        if !is_own && mask.has(x, y) {
            return None;
        }
        let [r, g, b, a] = picture.pixel(x as usize, y as usize).map(f32::from);
        Some(Vec4::new(r, g, b, 255.0) * (a / 255.0))
    }
}

/// The two texels on both sides of a pixel along one axis, and their weights.
fn taps(place: u32, step: u32, length: usize) -> [(usize, f32); 2] {
    // In halves of a pixel, so that all numbers are whole.
    let twice = 2 * i64::from(place) + 1 - i64::from(step);
    let first = twice.div_euclid(2 * i64::from(step));
    let part = twice.rem_euclid(2 * i64::from(step)) as f32 / (2 * step) as f32;
    let texel = |at: i64| at.clamp(0, length as i64 - 1) as usize;
    [(texel(first), 1.0 - part), (texel(first + 1), part)]
}

fn straight(colour: Vec4) -> [u8; 4] {
    let opacity = (colour.w + 0.5).clamp(0.0, 255.0) as u8;
    if opacity == 0 {
        return [0; 4];
    }
    let [r, g, b] = (colour.truncate() * (255.0 / colour.w) + 0.5).to_array().map(|part| part.clamp(0.0, 255.0) as u8);
    [r, g, b, opacity]
}
