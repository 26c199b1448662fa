//! The first fill of a hole, from its rim inwards.
//!
//! Cost: each layer improves the matches of the patches near it. In a deep hole these are few of all.

use std::collections::VecDeque;

use super::level::{Level, RADIUS};
use super::matches::Matches;
use super::random::Random;
use super::votes::vote;

/// Passes over the patches for each layer.
const PASSES: u32 = 6;
/// Up to this depth each layer improves all matches. Deeper holes would take minutes.
const SHALLOW: usize = 10;

/// The coarsest level while it is filled.
#[derive(Debug)]
pub(super) struct Peeling {
    /// Those that are left, the next one first.
    layers: VecDeque<Vec<u32>>,
    /// Number of layers that are filled.
    filled: usize,
    known: Vec<bool>,
    matches: Option<Matches>,
}

impl Peeling {
    pub(super) fn new(level: &Level) -> Self {
        let known = level.hole.iter().map(|hole| !hole).collect();
        Self { layers: level.layers().into(), filled: 0, known, matches: None }
    }

    /// Layers: the number of comparisons of patches for each, but for a factor.
    pub(super) fn work(level: &Level) -> Vec<u64> {
        let mut at_depth = vec![0_u64; level.depth + 1];
        level.targets.iter().for_each(|&target| at_depth[usize::from(level.depths[target as usize])] += 1);
        let near = |layer: usize| layer.saturating_sub(reach(level))..(layer + reach(level) + 1).min(at_depth.len());
        (1..=level.depth).map(|layer| u64::from(PASSES) * at_depth[near(layer)].iter().sum::<u64>()).collect()
    }

    /// Fills the next layer. Returns the matches after the last one.
    pub(super) fn advance(&mut self, level: &mut Level, random: &mut Random) -> Option<Matches> {
        let matches = self.matches.get_or_insert_with(|| Matches::random(level, random));
        let layer = self.layers.pop_front()?;
        self.filled += 1;
        for pass in 0..PASSES {
            let is_near = |target| is_near(level, target, self.filled);
            matches.improve_known(level, &self.known, pass % 2 == 0, random, is_near);
        }
        vote(level, matches, &layer);
        layer.iter().for_each(|&at| self.known[at as usize] = true);
        if self.layers.is_empty() { self.matches.take() } else { None }
    }
}

/// Whether a patch is near a layer, counted from 1. All that overlap the layer are.
fn is_near(level: &Level, target: u32, layer: usize) -> bool {
    usize::from(level.depths[target as usize]).abs_diff(layer) <= reach(level)
}

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
    fn layers_of_a_deep_hole_look_at_few_patches_and_fill_all_of_it() {
        let mut level = deep();
        let work = Peeling::work(&level);
        assert_eq!(work.len(), level.depth);
        let all = u64::from(PASSES) * level.targets.len() as u64;
        // Not once for each layer.
        assert!(level.depth > 30 && work.iter().sum::<u64>() <= 9 * all);
        let (mut peeling, mut random) = (Peeling::new(&level), Random::new(1));
        let found: Vec<bool> = work.iter().map(|_| peeling.advance(&mut level, &mut random).is_some()).collect();
        assert_eq!(found.iter().filter(|&&found| found).count(), 1);
        assert_eq!(found.last(), Some(&true));
        assert!(level.unknown.iter().all(|&at| level.texels[at as usize][..4] == [90, 90, 90, 255]));
    }
}
