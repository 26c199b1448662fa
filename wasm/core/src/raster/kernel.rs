//! The filter by which the picture is read: Keys' cubic with a = −1/2 (Keys 1981, also known as Catmull-Rom), of which the
//! value at a texel is the texel, and lines stay lines. Where the picture shrinks it is as much wider, so that no detail
//! turns into a pattern.

/// How far the cubic reaches, in texels, at width 1.
const REACH: f64 = 2.0;
/// The greatest width.
pub(super) const WIDEST: f64 = 8.0;
const MOST_TAPS: usize = 2 * (REACH * WIDEST) as usize + 2;

/// Places between texels are rounded to 1/256, as on hardware, which also absorbs rounding errors beside a texel's centre.
const FRACTIONS: f64 = 256.0;

/// The texel that a place lies in, in texels from the border of a row of `length` texels.
pub(super) fn nearest(place: f64, length: usize) -> usize {
    let steps = (place.clamp(0.0, length as f64) * FRACTIONS + 0.5) as usize;
    (steps / FRACTIONS as usize).min(length - 1)
}

/// Successive texels of a row or column, and the share of each.
pub(super) struct Taps {
    pub(super) first: usize,
    count: usize,
    shares: [f32; MOST_TAPS],
}

impl Taps {
    /// The texels around a place, in texels from the border of a row of `length` texels, for a filter of a width from 1 to
    /// [`WIDEST`]. Beyond the border all is as at the border.
    pub(super) fn new(place: f64, length: usize, width: f32) -> Self {
        let steps = ((place.clamp(0.5, length as f64 - 0.5) - 0.5) * FRACTIONS + 0.5) as usize;
        let (texel, fraction) = (steps / FRACTIONS as usize, steps % FRACTIONS as usize);
        if width == 1.0 {
            return match fraction {
                0 => Self { first: texel, count: 1, shares: [1.0; MOST_TAPS] },
                _ => Self::within(length, texel as isize - 1, &SHARP[fraction]),
            };
        }
        let reach = (REACH as f32 * width) as usize + 1;
        let mut shares = [0.0; MOST_TAPS];
        let shares = &mut shares[..2 * reach];
        let (per_texel, fraction) = (1.0 / width, fraction as f32 / FRACTIONS as f32);
        let mut sum = 0.0;
        for (i, share) in shares.iter_mut().enumerate() {
            *share = cubic((i as f32 - (reach - 1) as f32 - fraction).abs() * per_texel);
            sum += *share;
        }
        let whole = 1.0 / sum;
        shares.iter_mut().for_each(|share| *share *= whole);
        Self::within(length, texel as isize - (reach - 1) as isize, shares)
    }

    /// What lies beyond the border counts for the texel there.
    fn within(length: usize, first: isize, given: &[f32]) -> Self {
        let mut taps = Self { first: 0, count: given.len(), shares: [0.0; MOST_TAPS] };
        if first >= 0 && first as usize + given.len() <= length {
            taps.first = first as usize;
            taps.shares[..given.len()].copy_from_slice(given);
            return taps;
        }
        let texel = |i: usize| first.saturating_add_unsigned(i).clamp(0, length as isize - 1) as usize;
        taps.first = texel(0);
        taps.count = texel(given.len() - 1) - taps.first + 1;
        for (i, share) in given.iter().enumerate() {
            taps.shares[texel(i) - taps.first] += share;
        }
        taps
    }

    pub(super) fn shares(&self) -> &[f32] {
        &self.shares[..self.count]
    }
}

/// The shares of the four texels around every place between two texels, at width 1.
const SHARP: [[f32; 4]; FRACTIONS as usize] = {
    let mut shares = [[0.0; 4]; FRACTIONS as usize];
    let mut i = 0;
    while i < shares.len() {
        let t = i as f32 / FRACTIONS as f32;
        shares[i] = [cubic(1.0 + t), cubic(t), cubic(1.0 - t), cubic(2.0 - t)];
        i += 1;
    }
    shares
};

/// Keys' cubic at a distance.
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
    fn the_filter_shifts_nothing() {
        for width in [1.0, 1.004, 1.5, 2.7, 8.0] {
            for place in [30.5, 31.0, 31.12, 31.499, 40.9] {
                let taps = Taps::new(place, 80, width);
                let sum: f32 = taps.shares().iter().sum();
                let centre: f32 = (taps.first..).zip(taps.shares()).map(|(i, share)| (i as f32 + 0.5) * share).sum();
                assert!((sum - 1.0).abs() < 1e-5, "{width} at {place}: {sum}");
                // At a width that is no whole number the cubic is not exact; otherwise but for the rounding of places.
                assert!(
                    (f64::from(centre) - place).abs() < if width == 1.0 { 0.003 } else { 0.03 },
                    "{width} at {place}: {centre}"
                );
            }
        }
    }

    #[test]
    fn beyond_the_border_all_is_as_at_the_border() {
        for width in [1.0, 1.3, 8.0] {
            for (place, length) in [(-5.0, 3), (0.7, 3), (2.9, 3), (1e9, 3), (0.2, 1)] {
                let taps = Taps::new(place, length, width);
                assert!(taps.first + taps.shares().len() <= length);
                assert!((taps.shares().iter().sum::<f32>() - 1.0).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn a_place_between_two_texels_lies_in_the_second_but_for_rounding() {
        let found = [-3.0, 0.2, 1.0, 3.0 - 1e-9, 3.0 + 1e-9, 4.99, 7.0].map(|place| nearest(place, 5));
        assert_eq!(found, [0, 0, 1, 3, 3, 4, 4]);
    }

    #[test]
    fn the_middle_of_a_texel_is_the_texel() {
        let taps = Taps::new(7.5, 20, 1.0);
        assert_eq!((taps.first, taps.shares()), (7, &[1.0][..]));
    }
}
