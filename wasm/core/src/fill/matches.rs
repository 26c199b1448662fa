//! PatchMatch: finds a similar patch of the known picture for each patch over the hole (Barnes et al. 2009).
//!
//! Good matches spread from patch to patch, and random ones are tried around each. Costs are integer sums of squares,
//! so the order of additions does not change a bit.
//!
//! Cost: for each patch over the hole, each pass compares about log₂(side of the picture) patches.

use super::level::{Level, NONE, RADIUS, SIDE, Texel};
use super::random::Random;

/// Additional cost of a match at the reach, compared with one in place: a difference of 8 steps in every texel. Distant
/// objects then do not match the surroundings, even if they fit by chance.
const FAR: u64 = 128 * (SIDE * SIDE) as u64;

/// The best known match of each patch over the hole.
#[derive(Debug, Clone)]
pub(super) struct Matches {
    /// For each target, the centre of the similar patch.
    pub(super) sources: Vec<u32>,
    /// For each target, the sum of squared differences.
    pub(super) costs: Vec<u32>,
}

impl Matches {
    /// Random patches.
    pub(super) fn random(level: &Level, random: &mut Random) -> Self {
        let any = |_| level.sources[random.below(level.sources.len() as u32) as usize];
        let sources = (0..level.targets.len()).map(any).collect();
        Self { sources, costs: vec![u32::MAX; level.targets.len()] }
    }

    /// The same matches at twice the size.
    pub(super) fn doubled(&self, from: &Level, to: &Level, random: &mut Random) -> Self {
        let mut sources = Vec::with_capacity(to.targets.len());
        for &target in &to.targets {
            let (x, y) = (target as usize % to.width, target as usize / to.width);
            let near = |place: usize, side: usize| (place / 2).clamp(RADIUS, side - 1 - RADIUS);
            let at = near(y, from.height) * from.width + near(x, from.width);
            let slot = from.slots[at];
            let doubled = (slot != NONE).then(|| {
                let source = self.sources[slot as usize] as usize;
                let double = |place: usize, side: usize, odd: usize| (2 * place + odd).clamp(RADIUS, side - 1 - RADIUS);
                let column = double(source % from.width, to.width, x % 2);
                (double(source / from.width, to.height, y % 2) * to.width + column) as u32
            });
            let is_source = |&source: &u32| to.is_source[source as usize];
            let any = |random: &mut Random| to.sources[random.below(to.sources.len() as u32) as usize];
            sources.push(doubled.filter(is_source).unwrap_or_else(|| any(random)));
        }
        Self { costs: vec![u32::MAX; sources.len()], sources }
    }

    /// One pass: measures the matches again, and searches for better ones. `forwards` visits the first target first.
    pub(super) fn improve(&mut self, level: &Level, forwards: bool, random: &mut Random) {
        let costs = |target: u32, source: u32, most: u32| cost(level, target, source, most);
        self.improve_by(level, forwards, random, |_| true, costs);
    }

    /// The same for `wanted` targets, comparing only their texels before a layer of the hole.
    pub(super) fn improve_known(
        &mut self,
        level: &Level,
        layer: usize,
        forwards: bool,
        random: &mut Random,
        wanted: impl Fn(u32) -> bool,
    ) {
        let costs = |target: u32, source: u32, _: u32| known_cost(level, layer, target, source);
        self.improve_by(level, forwards, random, wanted, costs);
    }

    fn improve_by(
        &mut self,
        level: &Level,
        forwards: bool,
        random: &mut Random,
        wanted: impl Fn(u32) -> bool,
        cost: impl Fn(u32, u32, u32) -> u32,
    ) {
        let count = level.targets.len();
        let (width, height) = (level.width as i32, level.height as i32);
        let step = if forwards { -1 } else { 1 };
        for turn in 0..count {
            let slot = if forwards { turn } else { count - 1 - turn };
            let target = level.targets[slot];
            if !wanted(target) {
                continue;
            }
            let mut best = self.sources[slot];
            let mut least = cost(target, best, u32::MAX);
            // The neighbours that this pass has visited.
            for away in [step, step * width] {
                let beside = level.slots[target.wrapping_add_signed(away) as usize];
                if beside == NONE {
                    continue;
                }
                let source = self.sources[beside as usize].wrapping_add_signed(-away);
                if level.is_source.get(source as usize) == Some(&true) && source != best {
                    let cost = cost(target, source, least);
                    if cost < least {
                        (best, least) = (source, cost);
                    }
                }
            }
            let mut radius = width.max(height);
            while radius >= 1 {
                let (x, y) = (best as i32 % width, best as i32 / width);
                let column = (x + random.around(radius)).clamp(0, width - 1);
                let row = (y + random.around(radius)).clamp(0, height - 1);
                let source = (row * width + column) as u32;
                if level.is_source[source as usize] {
                    let cost = cost(target, source, least);
                    if cost < least {
                        (best, least) = (source, cost);
                    }
                }
                radius /= 2;
            }
            (self.sources[slot], self.costs[slot]) = (best, least);
        }
    }
}

/// The sum of squared differences of two patches. Stops early above `most`.
fn cost(level: &Level, target: u32, source: u32, most: u32) -> u32 {
    let first = |centre: u32| centre as usize - RADIUS * level.width - RADIUS;
    let (mut a, mut b) = (first(target), first(source));
    let mut sum = distance_cost(level, target, source);
    for _ in 0..SIDE {
        let row = |at: usize| -> &[Texel; SIDE] { level.texels[at..].first_chunk().expect("patches lie inside") };
        sum += row_cost(row(a), row(b));
        if sum >= most {
            return sum;
        }
        a += level.width;
        b += level.width;
    }
    sum
}

/// The cost of the distance of a match. The reach is the width of the hole at its deepest place.
fn distance_cost(level: &Level, target: u32, source: u32) -> u32 {
    let apart = |a: usize, b: usize| (a.abs_diff(b) as u64).pow(2);
    let (a, b, width) = (target as usize, source as usize, level.width);
    let squared = apart(a % width, b % width) + apart(a / width, b / width);
    let reach = (2 * level.depth + SIDE) as u64;
    (squared * FAR / (reach * reach)).min(16 * FAR) as u32
}

fn row_cost(a: &[Texel; SIDE], b: &[Texel; SIDE]) -> u32 {
    let mut sum = 0_i32;
    for (a, b) in a.as_flattened().iter().zip(b.as_flattened()) {
        let apart = i32::from(a - b);
        sum += apart * apart;
    }
    sum as u32
}

/// The mean squared difference of the target's texels before a layer, times the number of texels.
fn known_cost(level: &Level, layer: usize, target: u32, source: u32) -> u32 {
    let (mut sum, mut count) = (0_u64, 0_u64);
    for row in 0..SIDE {
        let at = |centre: u32| centre as usize + row * level.width - RADIUS * level.width - RADIUS;
        for column in 0..SIDE {
            if usize::from(level.depths[at(target) + column]) < layer {
                let [a, b] = [target, source].map(|centre| level.texels[at(centre) + column]);
                sum += a.iter().zip(b).map(|(a, b)| i64::from(a - b).pow(2) as u64).sum::<u64>();
                count += 1;
            }
        }
    }
    let far = distance_cost(level, target, source);
    (sum * (SIDE * SIDE) as u64).checked_div(count).map_or(u32::MAX - 1, |mean| mean as u32 + far)
}
