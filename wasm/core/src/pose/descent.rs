//! Descent to a minimum: L-BFGS (Nocedal 1980) on top of an approximate inverse of the second derivative.
//!
//! For as-rigid-as-possible that inverse is the Laplacian's. A step by it alone is a turn of the local/global iteration
//! (Sorkine and Alexa 2007), which forgets everything and so crawls along the directions in which rotations give way. The
//! last few steps tell how they do (Liu, Bouaziz and Kavan 2017): the energy of a bent strip settles in a quarter of the
//! turns, that of an unrolled spiral in a tenth. Every step is checked: the energy never rises.

use std::collections::VecDeque;

use glam::DVec2;

/// Steps that are remembered. With 5 a spiral takes a quarter more turns, with 20 no fewer, but longer ones.
const MEMORY: usize = 8;
/// Share of the decrease foreseen by the slope that a step must bring.
const DECREASE: f64 = 1e-4;
/// Relative rounding of an energy: where it drowns the decrease, the slopes decide (Hager and Zhang 2005).
const ROUNDING: f64 = 1e-13;
/// Shortenings of a step before the descent ends where it is.
const SHORTENINGS: usize = 12;

/// A step that was made, and how the gradient changed.
struct Step {
    by: Vec<DVec2>,
    change: Vec<DVec2>,
    /// Reciprocal of their product.
    curvature: f64,
}

/// Lowers an energy until a step moves no place by more than `settled`, or for so many turns.
///
/// `solve` takes a gradient to about the step that brings it to 0. `energy` tells the energy at given places and writes its gradient.
pub(super) fn descend(
    places: &mut Vec<DVec2>,
    solve: impl Fn(&mut [DVec2]),
    settled: f64,
    turns: usize,
    mut energy: impl FnMut(&[DVec2], &mut [DVec2]) -> f64,
) {
    let blank = vec![DVec2::ZERO; places.len()];
    let (mut gradient, mut next, mut next_gradient, mut by) = (blank.clone(), blank.clone(), blank.clone(), blank);
    let mut steps = VecDeque::with_capacity(MEMORY);
    let mut height = energy(places, &mut gradient);
    for _ in 0..turns {
        direction(&steps, &solve, &gradient, &mut by);
        let slope = dot(&by, &gradient);
        let farthest = by.iter().map(|by| by.length_squared()).fold(0.0, f64::max).sqrt();
        let mut length = 1.0;
        let mut shortenings = 0;
        let next_height = loop {
            for (next, (&place, &by)) in next.iter_mut().zip(places.iter().zip(&by)) {
                *next = place + length * by;
            }
            let next_height = energy(&next, &mut next_gradient);
            let falls = next_height <= height + DECREASE * length * slope;
            let is_level = (next_height - height).abs() <= ROUNDING * height.abs();
            if falls || is_level && dot(&by, &next_gradient) <= -slope {
                break next_height;
            }
            if shortenings == SHORTENINGS {
                return;
            }
            shortenings += 1;
            // To the lowest point of the parabola through both heights with this slope.
            let lowest = -slope * length * length / (2.0 * (next_height - height - slope * length));
            length = if lowest > 0.1 * length { lowest.min(0.5 * length) } else { 0.1 * length };
        };
        let mut step = if steps.len() < MEMORY { Step::new() } else { steps.pop_front().unwrap_or_else(Step::new) };
        step.set(length, &by, &gradient, &next_gradient);
        if step.curvature > 0.0 {
            steps.push_back(step);
        }
        std::mem::swap(places, &mut next);
        std::mem::swap(&mut gradient, &mut next_gradient);
        height = next_height;
        if farthest <= settled {
            return;
        }
    }
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
