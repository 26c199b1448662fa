//! Descent to a minimum: L-BFGS (Nocedal 1980) on top of an approximate inverse of the second derivative.
//!
//! For as-rigid-as-possible that inverse is the Laplacian's. A step by it alone is a turn of the local/global iteration
//! (Sorkine and Alexa 2007), which forgets everything and so crawls along the directions in which rotations give way. The
//! last few steps tell how they do (Liu, Bouaziz and Kavan 2017): the energy of a bent strip settles in a quarter of the
//! turns, that of an unrolled spiral in a tenth.
//!
//! What is lowered here is known along a whole line once it is known in which direction the line goes, so looking for the place to
//! stop costs little. Every step is checked: the energy never rises.

use std::collections::VecDeque;

use glam::DVec2;

/// Steps that are remembered. With 5 a spiral takes a quarter more turns, with 20 no fewer, but longer ones.
const MEMORY: usize = 8;
/// Share of the decrease foreseen by the slope that a step must bring.
const DECREASE: f64 = 1e-4;
/// Relative rounding of an energy: where it drowns the decrease, the slopes decide (Hager and Zhang 2005).
const ROUNDING: f64 = 1e-13;
/// Looks along a line before the descent takes the best that it saw.
const LOOKS: usize = 12;
/// Between two lengths no look is closer to either than this share of what is between them.
const MARGIN: f64 = 0.1;

/// How much farther to look where nothing says how far, and at most.
const FARTHER: f64 = 3.0;

/// What is lowered, seen from a place.
pub(super) trait Landscape {
    /// Turns to a direction.
    fn face(&mut self, by: &[DVec2]);
    /// What is seen in that direction at a length of it.
    fn look(&self, length: f64) -> View;
    /// Goes there.
    fn go(&mut self, length: f64);
    /// Writes down the gradient there.
    fn gradient(&mut self, gradient: &mut [DVec2]);
}

/// Energy, and its first two derivatives by the length.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    pub(super) height: f64,
    pub(super) slope: f64,
    pub(super) curvature: f64,
}

impl View {
    /// What c₀ + c₁ t + c₂ t² is at t.
    pub(super) fn of_polynomial([c0, c1, c2]: [f64; 3], t: f64) -> Self {
        Self { height: (c2 * t + c1) * t + c0, slope: 2.0 * c2 * t + c1, curvature: 2.0 * c2 }
    }
}

/// How far to go down.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Turns at most.
    pub(super) turns: usize,
    /// A turn whose direction moves no place by more than this is the last.
    pub(super) settled: f64,
    /// So is one that lowers the energy by no more than this share of it.
    pub(super) gain: f64,
    /// A step ends where the slope is this share of what it was at its start.
    pub(super) level: f64,
}

/// A step that was made, and how the gradient changed.
struct Step {
    by: Vec<DVec2>,
    change: Vec<DVec2>,
    /// Reciprocal of their product.
    curvature: f64,
}

/// Lowers an energy of so many places. `solve` takes a gradient to about the step that brings it to 0.
pub(super) fn descend(landscape: &mut impl Landscape, places: usize, solve: impl Fn(&mut [DVec2]), limits: Limits) {
    let mut by = vec![DVec2::ZERO; places];
    let (mut gradient, mut next_gradient) = (by.clone(), by.clone());
    let mut steps = VecDeque::with_capacity(MEMORY);
    landscape.gradient(&mut gradient);
    for turn in 1..=limits.turns {
        direction(&steps, &solve, &gradient, &mut by);
        landscape.face(&by);
        let Some((length, [before, after])) = search(landscape, limits.level) else { return };
        landscape.go(length);
        let farthest = by.iter().map(|by| by.length_squared()).fold(0.0, f64::max).sqrt();
        if turn == limits.turns || farthest <= limits.settled || before - after <= limits.gain * after {
            return;
        }
        landscape.gradient(&mut next_gradient);
        let mut step = if steps.len() < MEMORY { Step::new() } else { steps.pop_front().unwrap_or_else(Step::new) };
        step.set(length, &by, &gradient, &next_gradient);
        if step.curvature > 0.0 {
            steps.push_back(step);
        }
        std::mem::swap(&mut gradient, &mut next_gradient);
    }
}

/// A length at which the energy has fallen and is level, with the energies before and there; the best seen where none is, if any is lower.
fn search(landscape: &impl Landscape, level: f64) -> Option<(f64, [f64; 2])> {
    let start = landscape.look(0.0);
    let (mut low, mut high) = ((0.0, start), f64::INFINITY);
    let mut length = next(low, high).unwrap_or(1.0);
    for _ in 0..LOOKS {
        let view = landscape.look(length);
        let is_as_high = (view.height - start.height).abs() <= ROUNDING * start.height.abs();
        let falls = view.height <= start.height + DECREASE * length * start.slope
            || is_as_high && view.slope.abs() <= start.slope.abs();
        if falls && view.slope.abs() <= level * start.slope.abs() {
            return Some((length, [start.height, view.height]));
        }
        if falls && view.slope < 0.0 {
            low = (length, view);
        } else {
            high = length;
        }
        let newton = next((length, view), high).filter(|&next| next > low.0);
        let width = high - low.0;
        length = match newton {
            Some(next) if width.is_finite() => next.clamp(low.0 + MARGIN * width, high - MARGIN * width),
            Some(next) => next.min(FARTHER * length),
            None if width.is_finite() => low.0 + MARGIN * width,
            None => FARTHER * length,
        };
    }
    (low.0 > 0.0).then_some((low.0, [start.height, low.1.height]))
}

/// Where the parabola through a view is lowest, if it is before the end.
fn next((at, view): (f64, View), end: f64) -> Option<f64> {
    let next = at - view.slope / view.curvature;
    (view.curvature > 0.0 && next < end).then_some(next)
}

impl Step {
    fn new() -> Self {
        Self { by: Vec::new(), change: Vec::new(), curvature: 0.0 }
    }

    /// Curvature stays 0 where the gradient did not rise along the step, which then teaches nothing.
    fn set(&mut self, length: f64, by: &[DVec2], gradient: &[DVec2], next_gradient: &[DVec2]) {
        self.by.clear();
        self.by.extend(by.iter().map(|&by| length * by));
        self.change.clear();
        self.change.extend(next_gradient.iter().zip(gradient).map(|(&next, &before)| next - before));
        let product = dot(&self.by, &self.change);
        self.curvature = if product > 0.0 { 1.0 / product } else { 0.0 };
    }
}

/// The step that the gradient and the steps before suggest: the two loops of L-BFGS.
fn direction(steps: &VecDeque<Step>, solve: impl Fn(&mut [DVec2]), gradient: &[DVec2], by: &mut [DVec2]) {
    for (by, &gradient) in by.iter_mut().zip(gradient) {
        *by = -gradient;
    }
    let mut shares = [0.0; MEMORY];
    for (step, share) in steps.iter().zip(&mut shares).rev() {
        *share = step.curvature * dot(&step.by, by);
        add(by, -*share, &step.change);
    }
    solve(by);
    for (step, share) in steps.iter().zip(&shares) {
        add(by, share - step.curvature * dot(&step.change, by), &step.by);
    }
}

fn add(sum: &mut [DVec2], factor: f64, terms: &[DVec2]) {
    for (sum, &term) in sum.iter_mut().zip(terms) {
        *sum += factor * term;
    }
}

/// In two chains, which a processor can work on at once.
fn dot(a: &[DVec2], b: &[DVec2]) -> f64 {
    let sum = a.iter().zip(b).fold(DVec2::ZERO, |sum, (&a, &b)| sum + a * b);
    sum.x + sum.y
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Σ (x² − 1)² / 4 + y² over some places: two valleys each, and a ridge between them.
    struct Valleys {
        at: Vec<DVec2>,
        by: Vec<DVec2>,
        heights: Vec<f64>,
    }

    impl Valleys {
        fn new(at: &[DVec2]) -> Self {
            let mut valleys = Self { at: at.to_vec(), by: vec![DVec2::ZERO; at.len()], heights: Vec::new() };
            valleys.heights.push(valleys.look(0.0).height);
            valleys
        }
    }

    impl Landscape for Valleys {
        fn face(&mut self, by: &[DVec2]) {
            self.by = by.to_vec();
        }

        fn look(&self, length: f64) -> View {
            let mut view = View { height: 0.0, slope: 0.0, curvature: 0.0 };
            for (at, by) in self.at.iter().zip(&self.by) {
                let p = at + length * by;
                view.height += (p.x * p.x - 1.0).powi(2) / 4.0 + p.y * p.y;
                view.slope += (p.x * p.x - 1.0) * p.x * by.x + 2.0 * p.y * by.y;
                view.curvature += (3.0 * p.x * p.x - 1.0) * by.x * by.x + 2.0 * by.y * by.y;
            }
            view
        }

        fn go(&mut self, length: f64) {
            self.heights.push(self.look(length).height);
            for (at, by) in self.at.iter_mut().zip(&self.by) {
                *at += length * by;
            }
        }

        fn gradient(&mut self, gradient: &mut [DVec2]) {
            for (at, gradient) in self.at.iter().zip(gradient) {
                *gradient = DVec2::new((at.x * at.x - 1.0) * at.x, 2.0 * at.y);
            }
        }
    }

    const LIMITS: Limits = Limits { turns: 40, settled: 1e-9, gain: 0.0, level: 0.1 };
    const START: [DVec2; 3] = [DVec2::new(0.02, 3.0), DVec2::new(-5.0, 0.1), DVec2::new(0.5, -40.0)];

    #[test]
    fn it_ends_in_valleys_however_wrong_the_first_steps_are() {
        for scale in [1e-3, 1.0, 100.0] {
            let mut valleys = Valleys::new(&START);
            descend(&mut valleys, START.len(), |values| values.iter_mut().for_each(|value| *value *= scale), LIMITS);
            for at in &valleys.at {
                assert!((at.x.abs() - 1.0).abs() < 1e-6 && at.y.abs() < 1e-6, "{at} by steps of {scale}");
            }
        }
    }

    #[test]
    fn the_energy_never_rises() {
        for scale in [0.1, 30.0] {
            let mut valleys = Valleys::new(&START);
            descend(&mut valleys, START.len(), |values| values.iter_mut().for_each(|value| *value *= scale), LIMITS);
            assert!(valleys.heights.windows(2).all(|pair| pair[1] <= pair[0]), "{:?}", valleys.heights);
        }
    }

    #[test]
    fn a_small_gain_ends_it() {
        let turns = |gain| {
            let mut valleys = Valleys::new(&START);
            descend(&mut valleys, START.len(), |_| {}, Limits { gain, ..LIMITS });
            valleys.heights.len()
        };
        assert!(turns(10.0) < turns(0.0));
    }

    #[test]
    fn uphill_it_stays() {
        let mut valleys = Valleys::new(&START);
        descend(&mut valleys, START.len(), |values| values.iter_mut().for_each(|value| *value = -*value), LIMITS);
        assert_eq!(valleys.at, START);
    }
}
