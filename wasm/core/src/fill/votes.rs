//! The texels of the hole from the matches of all patches over them (Wexler et al. 2007, section 3).
//!
//! Cost: a visit of every patch over each texel of the hole.

use super::level::{Level, NONE, RADIUS, SIDE, Texel};
use super::matches::Matches;

/// Least spread of costs, which avoids division by zero for equal costs: the square of one step in each texel of a
/// patch.
const LEAST_SPREAD: u32 = (SIDE * SIDE) as u32;

/// The weight of patches decreases by this factor with each step from the rim, so that the picture grows inwards from
/// it (Wexler et al. 2007, section 3.2).
const FADING: f32 = 0.8;

/// One patch over a texel: its cost, the texel that its match has there, and the centre of the patch.
type Vote = (u32, u32, u32);

/// Sets each of `texels` to the mean of the votes by patches over it, weighted by the quality of their matches.
pub(super) fn vote(level: &mut Level, matches: &Matches, texels: &[u32]) {
    let mut votes = Vec::with_capacity(SIDE * SIDE);
    let mut costs = Vec::with_capacity(SIDE * SIDE);
    let mut voted = Vec::with_capacity(texels.len());
    for &at in texels {
        votes_for(level, matches, at, &mut votes);
        voted.push(mean(level, &votes, &mut costs).unwrap_or(level.texels[at as usize]));
    }
    texels.iter().zip(voted).for_each(|(&at, texel)| level.texels[at as usize] = texel);
}

/// Sets each texel of the hole from its best patch, and `from` to the source.
pub(super) fn choose(level: &mut Level, matches: &Matches, from: &mut [u32]) {
    let mut votes = Vec::with_capacity(SIDE * SIDE);
    for &at in &level.unknown {
        votes_for(level, matches, at, &mut votes);
        if let Some(&(_, source, _)) = votes.iter().min() {
            from[at as usize] = source;
            level.texels[at as usize] = level.texels[source as usize];
        }
    }
}

fn votes_for(level: &Level, matches: &Matches, at: u32, votes: &mut Vec<Vote>) {
    let (x, y) = (at as usize % level.width, at as usize / level.width);
    votes.clear();
    for row in y.saturating_sub(RADIUS)..level.height.min(y + RADIUS + 1) {
        for column in x.saturating_sub(RADIUS)..level.width.min(x + RADIUS + 1) {
            let centre = row * level.width + column;
            let slot = level.slots[centre];
            if slot != NONE && matches.costs[slot as usize] != u32::MAX {
                let from = matches.sources[slot as usize] as usize + at as usize - centre;
                votes.push((matches.costs[slot as usize], from as u32, centre as u32));
            }
        }
    }
}

/// The mean of votes, weighted by exp(−cost / 2σ²). σ² is the third quartile of the costs (Newson et al. 2014).
fn mean(level: &Level, votes: &[Vote], costs: &mut Vec<u32>) -> Option<Texel> {
    if votes.is_empty() {
        return None;
    }
    costs.clear();
    costs.extend(votes.iter().map(|(cost, ..)| cost));
    let quartile = 3 * (costs.len() - 1) / 4;
    let (_, &mut spread, _) = costs.select_nth_unstable(quartile);
    let spread = 2.0 * spread.max(LEAST_SPREAD) as f32;
    let (mut sum, mut total) = ([0.0_f32; 8], 0.0_f32);
    let least = votes.iter().map(|&(.., centre)| level.depths[centre as usize]).min().unwrap_or(0);
    for &(cost, from, centre) in votes {
        let deeper = f32::from(level.depths[centre as usize] - least);
        let weight = libm::expf(-(cost as f32) / spread + deeper * libm::logf(FADING));
        let texel = level.texels[from as usize];
        sum.iter_mut().zip(texel).for_each(|(sum, part)| *sum += weight * f32::from(part));
        total += weight;
    }
    // Costs far above the quartile may all have the weight 0, but the least one has not.
    Some(sum.map(|sum| (sum / total + 0.5) as i16))
}
