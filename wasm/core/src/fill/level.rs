//! One size of the picture to fill: its texels, the hole in it, and the patches to fill it from.
//!
//! Cost: linear in the texels.

/// Patches extend this far from their centre.
pub(super) const RADIUS: usize = 2;
/// Side of a patch.
pub(super) const SIDE: usize = 2 * RADIUS + 1;
/// No patch.
pub(super) const NONE: u32 = u32::MAX;
/// Minimum number of patches for a meaningful choice.
const LEAST_SOURCES: usize = 64;
/// Minimum number of known patches at a coarser level, for each patch to fill.
const LEAST_CHOICE: usize = 2;

/// Premultiplied red, green and blue, the opacity, and the texture along x and y (Newson et al. 2014, section 3.3).
/// The last two are 0: eight numbers fit a register.
pub(super) type Texel = [i16; 8];

/// A picture with a hole.
#[derive(Debug, Clone)]
pub(super) struct Level {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) texels: Vec<Texel>,
    /// For each texel, whether it must be filled.
    pub(super) hole: Vec<bool>,
    /// The texels of the hole.
    pub(super) unknown: Vec<u32>,
    /// The centres of all patches that overlap the hole.
    pub(super) targets: Vec<u32>,
    /// For each texel, its index in `targets`, or [`NONE`].
    pub(super) slots: Vec<u32>,
    /// For each texel, whether it is the centre of a patch without a hole.
    pub(super) is_source: Vec<bool>,
    /// The centres of all patches without a hole.
    pub(super) sources: Vec<u32>,
    /// Maximum distance of a texel of the hole from its rim, in steps along rows and columns.
    pub(super) depth: usize,
    /// For each texel, its distance from the rim, 1 at the rim and 0 outside the hole.
    pub(super) depths: Vec<u16>,
}

impl Level {
    pub(super) fn new(width: usize, height: usize, texels: Vec<Texel>, hole: Vec<bool>) -> Self {
        let mut overlaps = vec![false; hole.len()];
        let unknown: Vec<u32> = (0..hole.len() as u32).filter(|&at| hole[at as usize]).collect();
        let is_inside = |x: usize, y: usize| {
            (RADIUS..width.saturating_sub(RADIUS)).contains(&x) && (RADIUS..height.saturating_sub(RADIUS)).contains(&y)
        };
        // First along rows, then along columns.
        for &at in &unknown {
            let (x, y) = (at as usize % width, at as usize / width);
            overlaps[y * width..][x.saturating_sub(RADIUS)..width.min(x + RADIUS + 1)].fill(true);
        }
        let along = overlaps.clone();
        for at in (0..hole.len()).filter(|&at| along[at]) {
            let (x, y) = (at % width, at / width);
            for row in y.saturating_sub(RADIUS)..height.min(y + RADIUS + 1) {
                overlaps[row * width + x] = true;
            }
        }
        let mut level = Self {
            width,
            height,
            texels,
            unknown,
            targets: Vec::new(),
            slots: vec![NONE; hole.len()],
            is_source: vec![false; hole.len()],
            sources: Vec::new(),
            depth: 0,
            depths: vec![0; hole.len()],
            hole,
        };
        for (depth, layer) in (1..).zip(level.layers()) {
            level.depth = depth;
            layer.iter().for_each(|&at| level.depths[at as usize] = depth.min(u16::MAX.into()) as u16);
        }
        for (at, overlaps) in (0..).zip(overlaps) {
            let (x, y) = (at as usize % width, at as usize / width);
            if !is_inside(x, y) {
                continue;
            }
            if overlaps {
                level.slots[at as usize] = level.targets.len() as u32;
                level.targets.push(at);
            } else {
                level.is_source[at as usize] = true;
                level.sources.push(at);
            }
        }
        level
    }

    /// Whether there are enough patches to fill the hole from.
    pub(super) fn has_sources(&self) -> bool {
        self.sources.len() >= LEAST_SOURCES && !self.targets.is_empty()
    }

    /// Whether there are enough patches to start filling at this level.
    pub(super) fn has_choice(&self) -> bool {
        self.has_sources() && self.sources.len() >= LEAST_CHOICE * self.targets.len()
    }

    /// The same picture at half the size. A texel is part of the hole if any of its four is.
    pub(super) fn halved(&self) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        let mut hole = vec![false; width * height];
        let mut texels = Vec::with_capacity(width * height);
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            let mut sum = [0_i32; 8];
            let mut known = 0;
            for row in 2 * y..self.height.min(2 * y + 2) {
                for at in row * self.width + 2 * x..row * self.width + self.width.min(2 * x + 2) {
                    if self.hole[at] {
                        hole[y * width + x] = true;
                    } else {
                        known += 1;
                        sum.iter_mut().zip(self.texels[at]).for_each(|(sum, part)| *sum += i32::from(part));
                    }
                }
            }
            texels.push(sum.map(|sum| ((sum + known / 2) / known.max(1)) as i16));
        }
        Self::new(width, height, texels, hole)
    }

    /// The texels of the hole in layers, from the rim inwards.
    pub(super) fn layers(&self) -> Vec<Vec<u32>> {
        let mut left = self.hole.clone();
        let mut rest = self.unknown.clone();
        let mut layers = Vec::new();
        while !rest.is_empty() {
            let is_at_rim = |&at: &u32| self.neighbours(at as usize).any(|beside| !left[beside]);
            let (layer, inner): (Vec<u32>, Vec<u32>) = rest.iter().partition(|at| is_at_rim(at));
            if layer.is_empty() {
                layers.push(inner);
                break;
            }
            layer.iter().for_each(|&at| left[at as usize] = false);
            layers.push(layer);
            rest = inner;
        }
        layers
    }

    /// The neighbours of a texel, along rows and columns.
    pub(super) fn neighbours(&self, at: usize) -> impl Iterator<Item = usize> + use<> {
        let (x, y, width, height) = (at % self.width, at / self.width, self.width, self.height);
        let beside = [
            (x > 0).then(|| at - 1),
            (x + 1 < width).then(|| at + 1),
            (y > 0).then(|| at - width),
            (y + 1 < height).then(|| at + width),
        ];
        beside.into_iter().flatten()
    }
}
