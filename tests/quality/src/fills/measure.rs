//! How far a fill is from the truth.

use image::RgbaImage;

/// Errors of a fill.
#[derive(Debug, Clone, Copy)]
pub struct Measured {
    /// Mean difference of colours in the hole, in levels.
    pub colour: f64,
    /// Mean difference of gradients in the hole, in levels per pixel.
    pub gradient: f64,
    /// The mean length of gradients, divided by that of the truth. 1 has as much texture, 0 none.
    pub texture: f64,
}

impl Measured {
    pub(super) fn new(truth: &RgbaImage, filled: &RgbaImage, hole: &[bool]) -> Self {
        let width = truth.width();
        let value = |picture: &RgbaImage, x: u32, y: u32, part: usize| f64::from(picture.get_pixel(x, y).0[part]);
        let (mut colour, mut gradient, mut lengths, mut count) = (0.0, 0.0, [0.0; 2], 0.0);
        for at in (0..hole.len() as u32).filter(|&at| hole[at as usize]) {
            let (x, y) = (at % width, at / width);
            if x + 1 == width || y + 1 == truth.height() {
                continue;
            }
            for part in 0..3 {
                let slopes = [truth, filled].map(|picture| {
                    let here = value(picture, x, y, part);
                    [value(picture, x + 1, y, part) - here, value(picture, x, y + 1, part) - here]
                });
                colour += (value(truth, x, y, part) - value(filled, x, y, part)).abs();
                gradient += (slopes[0][0] - slopes[1][0]).hypot(slopes[0][1] - slopes[1][1]);
                lengths.iter_mut().zip(slopes).for_each(|(sum, [dx, dy])| *sum += dx.hypot(dy));
                count += 1.0;
            }
        }
        Self { colour: colour / count, gradient: gradient / count, texture: lengths[1] / lengths[0] }
    }
}
