//! The distance of each pixel from the nearest opaque one (Felzenszwalb, Huttenlocher 2012), to bridge gaps.
//!
//! Cost: linear in the cells, with four bytes of memory for each.

use glam::DVec2;

use super::{contour::Field, ring::Ring};
use crate::picture::Picture;

/// A picture with more cells than this is divided into larger ones.
const MAX_CELLS: u64 = 1 << 24;
/// Distances are capped at this, in cells.
const FAR: f32 = 1e9;

/// Distances in a grid of square cells.
pub(super) struct Nearness {
    /// Side of a cell in pixels.
    cell: u32,
    columns: u32,
    rows: u32,
    /// Distance of each cell's centre from the nearest centre of an opaque cell, in cells.
    distance: Vec<f32>,
    picture: DVec2,
}

/// The cells within a distance of opaque ones: positive inside.
pub(super) struct Within<'a> {
    nearness: &'a Nearness,
    distance: f64,
}

impl Nearness {
    /// Distances from the pixels with at least this alpha. A cell is opaque if one of its pixels is.
    pub(super) fn new(picture: &Picture, threshold: f64) -> Self {
        let (width, height) = picture.size();
        let mut cell = 1;
        while u64::from(width.div_ceil(cell)) * u64::from(height.div_ceil(cell)) > MAX_CELLS {
            cell += 1;
        }
        let (columns, rows) = (width.div_ceil(cell), height.div_ceil(cell));
        let mut squared = vec![FAR; columns as usize * rows as usize];
        for (at, pixel) in picture.rgba().chunks_exact(4).enumerate() {
            if f64::from(pixel[3]) / 255.0 >= threshold {
                let (x, y) = (at as u32 % width / cell, at as u32 / width / cell);
                squared[(y * columns + x) as usize] = 0.0;
            }
        }
        let mut line = Vec::new();
        let mut envelope = Envelope::default();
        for x in 0..columns as usize {
            line.clear();
            line.extend(squared.iter().skip(x).step_by(columns as usize));
            envelope.spread(&line, squared.iter_mut().skip(x).step_by(columns as usize));
        }
        for row in squared.chunks_exact_mut(columns as usize) {
            line.clear();
            line.extend_from_slice(row);
            envelope.spread(&line, row.iter_mut());
        }
        squared.iter_mut().for_each(|distance| *distance = distance.sqrt());
        let picture = DVec2::new(f64::from(width), f64::from(height));
        Self { cell, columns, rows, distance: squared, picture }
    }

    /// The region within a distance of opaque pixels.
    ///
    /// # Panics
    /// If the distance is not positive.
    pub(super) fn within(&self, px: f64) -> Within<'_> {
        assert!(px > 0.0);
        // A pixel may lie this far from the centre of its cell.
        let slack = f64::from(self.cell - 1) * std::f64::consts::FRAC_1_SQRT_2;
        Within { nearness: self, distance: (px + slack) / f64::from(self.cell) }
    }

    /// A ring of cells in image pixels.
    pub(super) fn in_pixels(&self, ring: Ring) -> Ring {
        ring.into_iter().map(|p| (p * f64::from(self.cell)).min(self.picture)).collect()
    }
}

impl Field for Within<'_> {
    const BEYOND: f64 = -1.0;

    fn size(&self) -> (u32, u32) {
        (self.nearness.columns, self.nearness.rows)
    }

    fn at(&self, x: u32, y: u32) -> f64 {
        let distance = self.nearness.distance[(y * self.nearness.columns + x) as usize];
        // The steps of squared whole numbers are far larger.
        ((self.distance - f64::from(distance)) * 65_536.0).round() / 65_536.0
    }
}

/// The lower envelope of parabolas over a line.
#[derive(Default)]
struct Envelope {
    /// The parabolas, by their lowest points, each with the position from which it is the lowest.
    parabolas: Vec<(usize, f64)>,
}

impl Envelope {
    /// The least of `height[i] + (at − i)²` over all i, at each position of a line.
    fn spread<'a>(&mut self, height: &[f32], out: impl Iterator<Item = &'a mut f32>) {
        self.parabolas.clear();
        let lifted = |i: usize| f64::from(height[i]) + (i * i) as f64;
        for i in (0..height.len()).filter(|&i| height[i] < FAR) {
            let mut from = f64::NEG_INFINITY;
            while let Some(&(last, since)) = self.parabolas.last() {
                from = (lifted(i) - lifted(last)) / (2 * (i - last)) as f64;
                if from > since {
                    break;
                }
                self.parabolas.pop();
                from = f64::NEG_INFINITY;
            }
            self.parabolas.push((i, from));
        }
        let mut current = 0;
        for (at, out) in out.enumerate() {
            while self.parabolas.get(current + 1).is_some_and(|&(_, from)| from < at as f64) {
                current += 1;
            }
            *out = self.parabolas.get(current).map_or(FAR, |&(i, _)| {
                let away = at.abs_diff(i);
                height[i] + (away * away) as f32
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_to_the_nearest_opaque_pixel() {
        let (width, height) = (23_u32, 17_u32);
        let opaque = [(3, 4), (20, 2), (11, 16), (4, 4)];
        let mut rgba = vec![0; (width * height * 4) as usize];
        for (x, y) in opaque {
            rgba[((y * width + x) * 4 + 3) as usize] = 200;
        }
        let nearness = Nearness::new(&Picture::new(width, height, &rgba).unwrap(), 0.5);
        for y in 0..height {
            for x in 0..width {
                let squared = |(a, b): (u32, u32)| a.abs_diff(x).pow(2) + b.abs_diff(y).pow(2);
                let least = opaque.into_iter().map(squared).min().unwrap();
                assert_eq!(nearness.distance[(y * width + x) as usize], (least as f32).sqrt(), "{x}, {y}");
            }
        }
        assert!(Nearness::new(&Picture::new(width, height, &rgba).unwrap(), 0.9).distance.iter().all(|&d| d > 1e4));
    }
}
