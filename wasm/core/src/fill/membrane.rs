//! Hides the seams of copied texels, by the Poisson equation of seamless cloning (Pérez et al. 2003).
//!
//! Copied texels keep the steps to their neighbours, and all of them get a smooth correction that meets the known
//! texels at the rim. A large step at a seam is an edge of the picture: it is kept, because its colours would bleed
//! otherwise. Without copied texels, the correction is the colour itself, which spreads into the hole from its rim.
//!
//! Cost: a fixed number of sweeps of successive over-relaxation over the texels of the hole.

use glam::Vec4;

use super::level::{Level, NONE};
use super::spread::spread;

/// Over-relaxation: optimal for holes about 60 texels wide. Other holes converge more slowly.
const RELAXATION: f32 = 1.9;
/// A step of this size at a seam has half the weight.
const STEP: f32 = 12.0;
/// Pulls corrections towards 0, so that they fade within about ten texels.
const FADING: f32 = 0.005;

/// A texel of the hole: its neighbours, their weights, and the weighted sum of the steps from them.
#[derive(Debug, Clone, Copy)]
struct Equation {
    neighbours: [u32; 4],
    weights: [f32; 4],
    steps: Vec4,
    /// The inverse of the sum of all weights.
    scale: f32,
}

/// The corrections of a level.
#[derive(Debug, Clone)]
pub(super) struct Membrane {
    /// For each texel, the change of the copied colour, or the colour itself if the texel was not copied.
    corrections: Vec<Vec4>,
    /// One equation for each texel of the hole, in the order of `level.unknown`.
    equations: Vec<Equation>,
}

impl Membrane {
    /// The equations of a level whose texels are copied `from` other texels; [`NONE`] if not copied.
    pub(super) fn new(level: &Level, from: &[u32]) -> Self {
        let seams = Seams { level, from };
        let equations = level.unknown.iter().map(|&at| seams.equation(at as usize)).collect();
        let mut corrections = vec![Vec4::ZERO; level.hole.len()];
        if from.iter().all(|&from| from == NONE) {
            let known: Vec<_> =
                (0..level.hole.len()).map(|at| (!level.hole[at]).then(|| colour(level.texels[at]))).collect();
            let spread = spread(&known, level.width);
            level.unknown.iter().for_each(|&at| corrections[at as usize] = spread[at as usize]);
        }
        Self { corrections, equations }
    }

    /// Runs sweeps over the texels of the hole.
    pub(super) fn relax(&mut self, level: &Level, sweeps: usize) {
        for _ in 0..sweeps {
            for (&at, equation) in level.unknown.iter().zip(&self.equations) {
                let beside = equation.neighbours.iter().zip(equation.weights);
                let sum =
                    beside.fold(equation.steps, |sum, (&at, weight)| sum + self.corrections[at as usize] * weight);
                let correction = &mut self.corrections[at as usize];
                *correction += (sum * equation.scale - *correction) * RELAXATION;
            }
        }
    }

    pub(super) fn corrections(&self) -> &[Vec4] {
        &self.corrections
    }
}

/// The sources of a hole.
struct Seams<'a> {
    level: &'a Level,
    /// For each texel, its source, or [`NONE`].
    from: &'a [u32],
}

impl Seams<'_> {
    fn equation(&self, at: usize) -> Equation {
        let is_copied = self.from[at] != NONE;
        let mut equation = Equation { neighbours: [at as u32; 4], weights: [0.0; 4], steps: Vec4::ZERO, scale: 0.0 };
        let mut total = if is_copied { FADING } else { 0.0 };
        for (index, beside) in self.level.neighbours(at).enumerate() {
            let step = self.step(at, beside);
            let weight = if is_copied { 1.0 / (1.0 + step.length_squared() / (STEP * STEP)) } else { 1.0 };
            equation.neighbours[index] = beside as u32;
            equation.weights[index] = weight;
            equation.steps += step * weight;
            total += weight;
        }
        equation.scale = if total > 0.0 { 1.0 / total } else { 0.0 };
        equation
    }

    /// The change of a texel's copy that makes it continuous with its neighbour.
    fn step(&self, at: usize, beside: usize) -> Vec4 {
        if self.from[at] == NONE {
            return self.copied(beside);
        }
        // Beside the copy of each of both lies a copy of the other one.
        let own = self.beside_copy(at, beside).map(|there| self.copied(beside) - there);
        let other = self.beside_copy(beside, at).map(|there| there - self.copied(at));
        match (own, other) {
            (Some(own), Some(other)) => (own + other) * 0.5,
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => self.copied(beside) - self.copied(at),
        }
    }

    /// The known texel with the same offset from the source of `at` as `beside` from `at`.
    fn beside_copy(&self, at: usize, beside: usize) -> Option<Vec4> {
        if self.from[at] == NONE {
            return None;
        }
        let there = (self.from[at] as usize + beside).checked_sub(at)?;
        (self.level.hole.get(there) == Some(&false)).then(|| colour(self.level.texels[there]))
    }

    /// The copied colour of a texel, or its own colour outside the hole.
    fn copied(&self, at: usize) -> Vec4 {
        match (self.level.hole[at], self.from[at]) {
            (false, _) => colour(self.level.texels[at]),
            (true, NONE) => Vec4::ZERO,
            (true, from) => colour(self.level.texels[from as usize]),
        }
    }
}

fn colour([r, g, b, a, ..]: [i16; 8]) -> Vec4 {
    Vec4::from_array([r, g, b, a].map(f32::from))
}
