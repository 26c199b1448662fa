//! Smooth colours for a hole without patches: means of the known colours around, from coarse to fine (pull-push,
//! Gortler et al. 1996).
//!
//! Cost: linear in the texels.

use glam::Vec4;

/// The colours of all texels, in rows of `width`. `None` is unknown. At least one is known.
pub(super) fn spread(known: &[Option<Vec4>], width: usize) -> Vec<Vec4> {
    if known.iter().all(Option::is_some) {
        return known.iter().flatten().copied().collect();
    }
    let height = known.len() / width;
    let (columns, rows) = (width.div_ceil(2), height.div_ceil(2));
    let mut coarse = Vec::with_capacity(columns * rows);
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let (mut sum, mut count) = (Vec4::ZERO, 0.0);
        for y in 2 * row..height.min(2 * row + 2) {
            for texel in known[y * width..][2 * column..width.min(2 * column + 2)].iter().flatten() {
                sum += *texel;
                count += 1.0;
            }
        }
        coarse.push((count > 0.0).then(|| sum * (1.0 / count)));
    }
    let coarse = spread(&coarse, columns);
    let texel = |(at, known): (usize, &Option<Vec4>)| {
        known.unwrap_or_else(|| coarse[at / width / 2 * columns + at % width / 2])
    };
    known.iter().enumerate().map(texel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_colours_stay_and_spread() {
        let known: Vec<_> = (0..7 * 5).map(|at| (at % 7 == 0).then_some(Vec4::splat(255.0))).collect();
        assert!(spread(&known, 7).iter().all(|texel| *texel == Vec4::splat(255.0)));
        let two = [Some(Vec4::ZERO), None, None, Some(Vec4::ONE)];
        assert_eq!(spread(&two, 4), [Vec4::ZERO, Vec4::ZERO, Vec4::ONE, Vec4::ONE]);
    }
}
