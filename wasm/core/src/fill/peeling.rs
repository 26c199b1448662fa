//! The first fill of a hole, from its rim inwards.
//!
//! Cost: each layer improves the matches of the patches near it. In a deep hole, these are a small fraction.

use super::level::{Level, RADIUS};
use super::matches::Matches;
use super::random::Random;
use super::votes::vote;

/// Passes over the patches for each layer.
const PASSES: u32 = 6;
/// Up to this depth, each layer improves all matches. Deeper holes would take minutes.
const SHALLOW: usize = 10;

/// For each layer, the number of comparisons of patches, up to a factor.
pub(super) fn work(level: &Level) -> Vec<u64> {
    let mut at_depth = vec![0_u64; level.depth + 1];
    level.targets.iter().for_each(|&target| at_depth[usize::from(level.depths[target as usize])] += 1);
    let near = |layer: usize| layer.saturating_sub(reach(level))..(layer + reach(level) + 1).min(at_depth.len());
    (1..=level.depth).map(|layer| u64::from(PASSES) * at_depth[near(layer)].iter().sum::<u64>()).collect()
}

/// Fills a layer, counted from 1, once those before it are filled.
pub(super) fn peel(level: &mut Level, matches: &mut Matches, layer: usize, random: &mut Random) {
    for pass in 0..PASSES {
        let is_near = |target| depth(level, target).abs_diff(layer) <= reach(level);
        matches.improve_known(level, layer, pass % 2 == 0, random, is_near);
    }
    let texels: Vec<u32> = level.unknown.iter().copied().filter(|&at| depth(level, at) == layer).collect();
    vote(level, matches, &texels);
}

fn depth(level: &Level, at: u32) -> usize {
    level.depths[at as usize].into()
}

/// Patches within this many layers of a layer are improved for it. This includes all patches that overlap the layer.
fn reach(level: &Level) -> usize {
    (SHALLOW * SHALLOW / level.depth).clamp(2 * RADIUS, SHALLOW)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Grey, with a hole that leaves a frame of 12 texels.
    fn deep() -> Level {
        let (width, height) = (120, 100);
        let is_hole = |x: usize, y: usize| (12..width - 12).contains(&x) && (12..height - 12).contains(&y);
        let hole: Vec<bool> = (0..height).flat_map(|y| (0..width).map(move |x| is_hole(x, y))).collect();
        let texels = hole.iter().map(|&hole| if hole { [0; 8] } else { [90, 90, 90, 255, 0, 0, 0, 0] }).collect();
        Level::new(width, height, texels, hole)
    }

    #[test]
    fn deep_hole_is_filled_while_each_layer_checks_few_patches() {
        let mut level = deep();
        let work = work(&level);
        assert_eq!(work.len(), level.depth);
        let all = u64::from(PASSES) * level.targets.len() as u64;
        // Not once for each layer.
        assert!(level.depth > 30 && work.iter().sum::<u64>() <= 9 * all);
        let mut random = Random::new(1);
        let mut matches = Matches::random(&level, &mut random);
        for layer in 1..=level.depth {
            peel(&mut level, &mut matches, layer, &mut random);
        }
        assert!(level.unknown.iter().all(|&at| level.texels[at as usize][..4] == [90, 90, 90, 255]));
    }
}
