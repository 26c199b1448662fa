//! Descent to a minimum: L-BFGS (Nocedal 1980), preconditioned by an approximate inverse of the Hessian.
//!
//! For as-rigid-as-possible deformation, that inverse is the Laplacian's. A step with only this inverse is one
//! iteration of the local/global method (Sorkine and Alexa 2007). Without history, that method converges slowly along
//! directions in which rotations yield. The last few steps contain that information (Liu, Bouaziz and Kavan 2017): the
//! energy of a bent strip converges in a quarter of the iterations, and that of an unrolled spiral in a tenth.
//!
//! Once a direction is set, the energy is known along the whole line with its derivatives, so the line search is
//! cheap: Halley's method takes one or two samples. Every step is checked, so the energy never rises.

use std::collections::VecDeque;

use glam::DVec2;

use super::Jet;

/// Number of stored steps. With 5, a spiral takes a quarter more iterations; 20 do not save iterations, but make them
/// longer.
const MEMORY: usize = 8;
/// Sufficient decrease (first Wolfe condition): the least decrease of a step, as a fraction of the decrease that the
/// initial slope predicts.
const SUFFICIENT_DECREASE: f64 = 1e-4;
/// Relative rounding error of an energy: for smaller decreases, the slopes decide (Hager and Zhang 2005).
const ENERGY_ROUNDING: f64 = 1e-13;
/// Samples along a line before the search returns the best one.
const MAX_SAMPLES: usize = 12;
/// In a bracket, samples keep at least this fraction of its width from both ends.
const BRACKET_MARGIN: f64 = 0.01;
/// If the curvature suggests no length in a bracket, the search tries this fraction of its width.
const BRACKET_STEP: f64 = 0.1;

/// Growth of the length if the curvature suggests none, and the greatest growth otherwise.
const MAX_GROWTH: f64 = 3.0;

/// The energy to minimise, with its current point.
pub(crate) trait Objective {
    /// Writes the gradient at the current point.
    fn gradient(&mut self, gradient: &mut [DVec2]);
    /// Sets the direction of the line through the current point, after its gradient was requested. Returns the energy
    /// there.
    fn set_direction(&mut self, direction: &[DVec2]) -> Jet;
    /// The energy on that line, at the current point plus `length` times the direction.
    fn along_line(&mut self, length: f64) -> Jet;
    /// Moves the current point there. Nearly always, this is where the energy was last evaluated.
    fn advance(&mut self, length: f64);
}

/// When the descent and its line searches end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    pub(crate) max_iterations: usize,
    /// The descent ends with an iteration whose direction moves every position by at most this,
    pub(crate) tolerance: f64,
    /// or that lowers the energy by at most this fraction.
    pub(crate) gain: f64,
    /// Curvature condition (strong Wolfe): a line search ends where the slope is this fraction of the initial one.
    pub(crate) curvature_condition: f64,
}

/// A correction pair of L-BFGS: a step s, and the change y of the gradient along it.
struct Correction {
    step: Vec<DVec2>,
    change: Vec<DVec2>,
    /// 1 / s·y.
    reciprocal: f64,
}

/// Minimises an energy of `places` unknowns. `solve` applies the approximate inverse of the Hessian.
pub(crate) fn descend(objective: &mut impl Objective, places: usize, solve: impl Fn(&mut [DVec2]), limits: Limits) {
    let mut direction = vec![DVec2::ZERO; places];
    let (mut gradient, mut next_gradient) = (direction.clone(), direction.clone());
    let mut corrections = VecDeque::with_capacity(MEMORY);
    objective.gradient(&mut gradient);
    for iteration in 1..=limits.max_iterations {
        search_direction(&corrections, &solve, &gradient, &mut direction);
        let start = objective.set_direction(&direction);
        let Some((length, end)) = line_search(objective, start, limits.curvature_condition) else { return };
        objective.advance(length);
        let farthest = direction.iter().map(|by| by.length_squared()).fold(0.0, f64::max).sqrt();
        if iteration == limits.max_iterations || farthest <= limits.tolerance || start.value - end <= limits.gain * end
        {
            return;
        }
        objective.gradient(&mut next_gradient);
        let reused = if corrections.len() < MEMORY { None } else { corrections.pop_front() };
        let mut correction = reused.unwrap_or_else(Correction::new);
        correction.set(length, &direction, &gradient, &next_gradient);
        if correction.reciprocal > 0.0 {
            corrections.push_back(correction);
        }
        std::mem::swap(&mut gradient, &mut next_gradient);
    }
}

/// Line search for the strong Wolfe conditions from the start of a line. Returns the step length and the energy
/// there, or the best decrease found.
fn line_search(objective: &mut impl Objective, start: Jet, curvature_condition: f64) -> Option<(f64, f64)> {
    let (mut low, mut high) = ((0.0, start), f64::INFINITY);
    let mut length = start.to_minimum().unwrap_or(1.0);
    for _ in 0..MAX_SAMPLES {
        let sample = objective.along_line(length);
        let is_as_high = (sample.value - start.value).abs() <= ENERGY_ROUNDING * start.value.abs();
        let falls = sample.value <= start.value + SUFFICIENT_DECREASE * length * start.first
            || is_as_high && sample.first.abs() <= start.first.abs();
        if falls && sample.first.abs() <= curvature_condition * start.first.abs() {
            return Some((length, sample.value));
        }
        if falls && sample.first < 0.0 {
            low = (length, sample);
        } else {
            high = length;
        }
        let next = sample.to_minimum().map(|by| length + by).filter(|next| (low.0..high).contains(next));
        let width = high - low.0;
        length = match next {
            Some(next) if width.is_finite() => {
                next.clamp(low.0 + BRACKET_MARGIN * width, high - BRACKET_MARGIN * width)
            }
            Some(next) => next.min(MAX_GROWTH * length),
            None if width.is_finite() => low.0 + BRACKET_STEP * width,
            None => MAX_GROWTH * length,
        };
    }
    (low.0 > 0.0).then_some((low.0, low.1.value))
}

impl Jet {
    /// The length to the zero of a hyperbola that fits the slope and its derivatives (Halley's method); `None` if the
    /// slope falls.
    fn to_minimum(self) -> Option<f64> {
        let newton = -self.first / self.second;
        // A slope that flattens out soon has no zero by this measure.
        let bend = (1.0 + newton * self.third / (2.0 * self.second)).max(1.0 / MAX_GROWTH);
        (self.second > 0.0).then_some(newton / bend)
    }
}

impl Correction {
    fn new() -> Self {
        Self { step: Vec::new(), change: Vec::new(), reciprocal: 0.0 }
    }

    /// The reciprocal remains 0 if the slope did not rise along the step: such a pair has no information about the
    /// curvature.
    fn set(&mut self, length: f64, direction: &[DVec2], gradient: &[DVec2], next_gradient: &[DVec2]) {
        self.step.clear();
        self.step.extend(direction.iter().map(|&by| length * by));
        self.change.clear();
        self.change.extend(next_gradient.iter().zip(gradient).map(|(&next, &before)| next - before));
        let product = dot(&self.step, &self.change);
        self.reciprocal = if product > 0.0 { 1.0 / product } else { 0.0 };
    }
}

/// The two loops of L-BFGS.
fn search_direction(
    corrections: &VecDeque<Correction>,
    solve: impl Fn(&mut [DVec2]),
    gradient: &[DVec2],
    direction: &mut [DVec2],
) {
    for (by, &gradient) in direction.iter_mut().zip(gradient) {
        *by = -gradient;
    }
    let mut factors = [0.0; MEMORY];
    for (correction, factor) in corrections.iter().zip(&mut factors).rev() {
        *factor = correction.reciprocal * dot(&correction.step, direction);
        add(direction, -*factor, &correction.change);
    }
    solve(direction);
    for (correction, factor) in corrections.iter().zip(&factors) {
        add(direction, factor - correction.reciprocal * dot(&correction.change, direction), &correction.step);
    }
}

fn add(sum: &mut [DVec2], factor: f64, terms: &[DVec2]) {
    for (sum, &term) in sum.iter_mut().zip(terms) {
        *sum += factor * term;
    }
}

/// Uses two independent sums, which a processor can compute in parallel.
fn dot(a: &[DVec2], b: &[DVec2]) -> f64 {
    let sum = a.iter().zip(b).fold(DVec2::ZERO, |sum, (&a, &b)| sum + a * b);
    sum.x + sum.y
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Σ (x² − 1)² / 4 + y² over some places: two minima each, and a ridge between them.
    struct DoubleWell {
        at: Vec<DVec2>,
        direction: Vec<DVec2>,
        energies: Vec<f64>,
    }

    impl DoubleWell {
        fn new(at: &[DVec2]) -> Self {
            let mut well = Self { at: at.to_vec(), direction: vec![DVec2::ZERO; at.len()], energies: Vec::new() };
            let energy = well.along_line(0.0).value;
            well.energies.push(energy);
            well
        }
    }

    impl Objective for DoubleWell {
        fn set_direction(&mut self, direction: &[DVec2]) -> Jet {
            self.direction = direction.to_vec();
            self.along_line(0.0)
        }

        fn along_line(&mut self, length: f64) -> Jet {
            let mut sample = Jet::default();
            for (at, by) in self.at.iter().zip(&self.direction) {
                let p = at + length * by;
                sample.value += (p.x * p.x - 1.0).powi(2) / 4.0 + p.y * p.y;
                sample.first += (p.x * p.x - 1.0) * p.x * by.x + 2.0 * p.y * by.y;
                sample.second += (3.0 * p.x * p.x - 1.0) * by.x * by.x + 2.0 * by.y * by.y;
                sample.third += 6.0 * p.x * by.x * by.x * by.x;
            }
            sample
        }

        fn advance(&mut self, length: f64) {
            let energy = self.along_line(length).value;
            self.energies.push(energy);
            for (at, by) in self.at.iter_mut().zip(&self.direction) {
                *at += length * by;
            }
        }

        fn gradient(&mut self, gradient: &mut [DVec2]) {
            for (at, gradient) in self.at.iter().zip(gradient) {
                *gradient = DVec2::new((at.x * at.x - 1.0) * at.x, 2.0 * at.y);
            }
        }
    }

    const LIMITS: Limits = Limits { max_iterations: 40, tolerance: 1e-9, gain: 0.0, curvature_condition: 0.1 };
    const START: [DVec2; 3] = [DVec2::new(0.02, 3.0), DVec2::new(-5.0, 0.1), DVec2::new(0.5, -40.0)];

    #[test]
    fn descent_reaches_a_minimum_despite_wrong_first_steps() {
        for scale in [1e-3, 1.0, 100.0] {
            let mut well = DoubleWell::new(&START);
            descend(&mut well, START.len(), |values| values.iter_mut().for_each(|value| *value *= scale), LIMITS);
            for at in &well.at {
                assert!((at.x.abs() - 1.0).abs() < 1e-6 && at.y.abs() < 1e-6, "{at} by steps of {scale}");
            }
        }
    }

    #[test]
    fn the_energy_never_rises() {
        for scale in [0.1, 30.0] {
            let mut well = DoubleWell::new(&START);
            descend(&mut well, START.len(), |values| values.iter_mut().for_each(|value| *value *= scale), LIMITS);
            assert!(well.energies.windows(2).all(|pair| pair[1] <= pair[0]), "{:?}", well.energies);
        }
    }

    #[test]
    fn a_slope_that_is_a_hyperbola_is_followed_to_its_zero_at_once() {
        // The slope is 1 − 2 / (1 + t), the start is at 0.
        for at in [0.0, 0.4, 2.5] {
            let t = 1.0 + at;
            let jet = Jet { value: 0.0, first: 1.0 - 2.0 / t, second: 2.0 / (t * t), third: -4.0 / (t * t * t) };
            let found = jet.to_minimum().map(|by| at + by).expect("a rising slope");
            assert!((found - 1.0).abs() < 1e-12, "{found} from {at}");
        }
        let falling = Jet { value: 0.0, first: -1.0, second: -1.0, third: 1.0 };
        assert_eq!(falling.to_minimum(), None);
        // By a hyperbola it would never be 0.
        let flat = Jet { value: 0.0, first: -1.0, second: 1.0, third: -5.0 };
        assert_eq!(flat.to_minimum(), Some(MAX_GROWTH));
    }

    #[test]
    fn descent_ends_after_a_small_gain() {
        let iterations = |gain| {
            let mut well = DoubleWell::new(&START);
            descend(&mut well, START.len(), |_| {}, Limits { gain, ..LIMITS });
            well.energies.len()
        };
        assert!(iterations(10.0) < iterations(0.0));
    }

    #[test]
    fn an_uphill_direction_changes_nothing() {
        let mut well = DoubleWell::new(&START);
        descend(&mut well, START.len(), |values| values.iter_mut().for_each(|value| *value = -*value), LIMITS);
        assert_eq!(well.at, START);
    }
}
