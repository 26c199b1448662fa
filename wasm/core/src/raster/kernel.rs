//! The reconstruction filter: Keys' cubic with a = −1/2 (Keys 1981), also known as Catmull-Rom.
//!
//! It interpolates the texels and reproduces linear gradients. Where the picture shrinks, the filter widens by the same
//! factor, so fine detail does not alias.

/// Radius of the cubic in texels, at width 1.
const RADIUS: f64 = 2.0;
/// The largest width.
pub(super) const MAX_WIDTH: f64 = 8.0;
const MAX_TAPS: usize = 2 * (RADIUS * MAX_WIDTH) as usize + 2;

/// Positions are rounded to 1/256 texel, as on graphics hardware. This also absorbs rounding errors at texel centres.
const FRACTIONS: f64 = 256.0;

/// Returns the texel that contains `position`, in texels from the border of a row of `length` texels.
pub(super) fn nearest(position: f64, length: usize) -> usize {
    let steps = (position.clamp(0.0, length as f64) * FRACTIONS + 0.5) as usize;
    (steps / FRACTIONS as usize).min(length - 1)
}

/// Returns the texel whose centre is at `position` or before it, and the [`FRACTIONS`] of a texel between them.
fn texel_and_fraction(position: f64, length: usize) -> (usize, usize) {
    let steps = ((position.clamp(0.5, length as f64 - 0.5) - 0.5) * FRACTIONS + 0.5) as usize;
    (steps / FRACTIONS as usize, steps % FRACTIONS as usize)
}

/// Consecutive texels of a row or column, with their weights.
pub(super) struct Taps {
    pub(super) first: usize,
    count: usize,
    weights: [f32; MAX_TAPS],
}

impl Taps {
    /// Returns the taps around `position`, in texels from the border of a row of `length` texels.
    ///
    /// `width` is between 1 and [`MAX_WIDTH`]. Texels beyond the border repeat the border texel.
    pub(super) fn new(position: f64, length: usize, width: f32) -> Self {
        let (texel, fraction) = texel_and_fraction(position, length);
        if width == 1.0 {
            return match fraction {
                0 => Self { first: texel, count: 1, weights: [1.0; MAX_TAPS] },
                _ => Self::clamped(length, texel as isize - 1, &UNIT_WEIGHTS[fraction]),
            };
        }
        let radius = (RADIUS as f32 * width) as usize + 1;
        let mut weights = [0.0; MAX_TAPS];
        let weights = &mut weights[..2 * radius];
        let (per_texel, fraction) = (1.0 / width, fraction as f32 / FRACTIONS as f32);
        let mut sum = 0.0;
        for (i, weight) in weights.iter_mut().enumerate() {
            *weight = cubic((i as f32 - (radius - 1) as f32 - fraction).abs() * per_texel);
            sum += *weight;
        }
        let scale = 1.0 / sum;
        weights.iter_mut().for_each(|weight| *weight *= scale);
        Self::clamped(length, texel as isize - (radius - 1) as isize, weights)
    }

    /// Returns the first of four texels around `position` and their weights, at width 1.
    ///
    /// `None` at the centre of a texel and at the border, where fewer texels contribute: see [`new`](Self::new).
    pub(super) fn unit(position: f64, length: usize) -> Option<(usize, &'static [f32; 4])> {
        let (texel, fraction) = texel_and_fraction(position, length);
        let first = texel.checked_sub(1)?;
        (fraction != 0 && first + 4 <= length).then(|| (first, &UNIT_WEIGHTS[fraction]))
    }

    /// Adds the weights of texels beyond the border to the border texel.
    fn clamped(length: usize, first: isize, weights: &[f32]) -> Self {
        let mut taps = Self { first: 0, count: weights.len(), weights: [0.0; MAX_TAPS] };
        if first >= 0 && first as usize + weights.len() <= length {
            taps.first = first as usize;
            taps.weights[..weights.len()].copy_from_slice(weights);
            return taps;
        }
        let texel = |i: usize| first.saturating_add_unsigned(i).clamp(0, length as isize - 1) as usize;
        taps.first = texel(0);
        taps.count = texel(weights.len() - 1) - taps.first + 1;
        for (i, weight) in weights.iter().enumerate() {
            taps.weights[texel(i) - taps.first] += weight;
        }
        taps
    }

    pub(super) fn weights(&self) -> &[f32] {
        &self.weights[..self.count]
    }
}

/// The weights of the four texels around each fraction between two texels, at width 1.
const UNIT_WEIGHTS: [[f32; 4]; FRACTIONS as usize] = {
    let mut weights = [[0.0; 4]; FRACTIONS as usize];
    let mut i = 0;
    while i < weights.len() {
        let t = i as f32 / FRACTIONS as f32;
        weights[i] = [cubic(1.0 + t), cubic(t), cubic(1.0 - t), cubic(2.0 - t)];
        i += 1;
    }
    weights
};

/// Keys' cubic at distance `t`.
const fn cubic(t: f32) -> f32 {
    let near = (1.5 * t - 2.5) * t * t + 1.0;
    let far = ((2.5 - 0.5 * t) * t - 4.0) * t + 2.0;
    if t < 1.0 {
        near
    } else if t < 2.0 {
        far
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_sum_to_one_and_keep_the_centroid() {
        for width in [1.0, 1.004, 1.5, 2.7, 8.0] {
            for position in [30.5, 31.0, 31.12, 31.499, 40.9] {
                let taps = Taps::new(position, 80, width);
                let sum: f32 = taps.weights().iter().sum();
                let centre: f32 = (taps.first..).zip(taps.weights()).map(|(i, weight)| (i as f32 + 0.5) * weight).sum();
                assert!((sum - 1.0).abs() < 1e-5, "{width} at {position}: {sum}");
                // Fractional widths are not exact. Whole widths are, apart from the rounding of positions.
                assert!(
                    (f64::from(centre) - position).abs() < if width == 1.0 { 0.003 } else { 0.03 },
                    "{width} at {position}: {centre}"
                );
            }
        }
    }

    #[test]
    fn texels_beyond_the_border_repeat_the_border() {
        for width in [1.0, 1.3, 8.0] {
            for (position, length) in [(-5.0, 3), (0.7, 3), (2.9, 3), (1e9, 3), (0.2, 1)] {
                let taps = Taps::new(position, length, width);
                assert!(taps.first + taps.weights().len() <= length);
                assert!((taps.weights().iter().sum::<f32>() - 1.0).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn position_between_two_texels_belongs_to_the_second() {
        let found = [-3.0, 0.2, 1.0, 3.0 - 1e-9, 3.0 + 1e-9, 4.99, 7.0].map(|position| nearest(position, 5));
        assert_eq!(found, [0, 0, 1, 3, 3, 4, 4]);
    }

    #[test]
    fn texel_centre_reads_that_texel_alone() {
        let taps = Taps::new(7.5, 20, 1.0);
        assert_eq!((taps.first, taps.weights()), (7, &[1.0][..]));
    }
}
