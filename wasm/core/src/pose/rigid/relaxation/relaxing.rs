//! The objective of a relaxation: a pose, and its distortion along a line.
//!
//! Cost: O(terms) for a direction and for a gradient; O(nodes) for a sample of the line.

use glam::{DMat2, DVec2};

use super::{
    super::{
        super::numeric::{LineSample, Objective},
        distortion::{Distortion, gradient, square},
    },
    FIRST_REGULARISATION, Parts, Relaxation,
    nodes::{Node, Term},
};

/// A pose under relaxation.
pub(super) struct Relaxing<'a> {
    relaxation: &'a Relaxation,
    distortion: Distortion,
    is_free: &'a [bool],
    /// The unknowns, relative to their initial values.
    unknown: Vec<DVec2>,
    direction: Vec<DVec2>,
    /// Scratch: the direction, or the gradient, in terms of the parts of each site, whose places are relative to the origin.
    parts: Vec<Parts>,
    states: Vec<NodeState>,
    lines: Vec<Lines>,
    derivatives: Vec<Derivatives>,
    /// Energy of the springs that hold the unknowns, along the direction: coefficients of a polynomial in the length.
    held: [f64; 3],
}

/// The map at a node.
#[derive(Debug, Clone, Copy)]
struct NodeState {
    /// Reciprocal of the scale requested there.
    unscale: f64,
    /// The Jacobian J, divided by the scale.
    derivative: DMat2,
    /// Its derivative along the direction.
    along: DMat2,
}

/// det J and |J|² of [`LANES`] nodes along the direction: coefficients of polynomials in the length, whose constant terms
/// belong to the current pose. Grouped so that a processor works on several numbers at a time.
#[derive(Debug, Clone, Copy)]
struct Lines {
    area: [f64; LANES],
    det: [[f64; LANES]; 3],
    /// |J|².
    square: [[f64; LANES]; 3],
}

/// Derivatives of the energy of [`LANES`] nodes.
#[derive(Debug, Clone, Copy)]
struct Derivatives {
    by_det: [f64; LANES],
    by_square: [f64; LANES],
}

const LANES: usize = 4;

/// Padding: J is the identity, and the area is 0.
const PADDING: Lines = Lines {
    area: [0.0; LANES],
    det: [[1.0; LANES], [0.0; LANES], [0.0; LANES]],
    square: [[2.0; LANES], [0.0; LANES], [0.0; LANES]],
};

impl<'a> Relaxing<'a> {
    /// Begins at the given parts of all sites, whose places are the sites' posed places; `scales` are those requested at the
    /// sites.
    pub(super) fn new(relaxation: &'a Relaxation, parts: &[Parts], is_free: &'a [bool], scales: &[f64]) -> Self {
        let parts: Vec<Parts> =
            parts.iter().zip(&relaxation.rest).map(|(&parts, &rest)| at_origin(parts, rest)).collect();
        let is_scaled = scales.iter().any(|&scale| scale != 1.0);
        let state = |(node, terms): (&Node, &[Term])| {
            let scale = |term: &Term| term.weight * scales[term.site as usize];
            let unscale = if is_scaled { 1.0 / terms.iter().map(scale).sum::<f64>() } else { 1.0 };
            NodeState { unscale, derivative: unscale * derivative(node, terms, &parts), along: DMat2::ZERO }
        };
        let unknowns = relaxation.unknowns.len();
        let count = relaxation.nodes.len().div_ceil(LANES);
        let mut lines = vec![PADDING; count];
        for (at, (node, _)) in relaxation.nodes.iter().enumerate() {
            lines[at / LANES].area[at % LANES] = node.area;
        }
        let mut relaxing = Self {
            relaxation,
            distortion: Distortion::new(FIRST_REGULARISATION),
            is_free,
            unknown: vec![DVec2::ZERO; unknowns],
            direction: vec![DVec2::ZERO; unknowns],
            states: relaxation.nodes.iter().map(state).collect(),
            lines,
            derivatives: vec![Derivatives { by_det: [0.0; LANES], by_square: [0.0; LANES] }; count],
            parts,
            held: [0.0; 3],
        };
        relaxing.reset_lines();
        relaxing
    }

    /// Sets ε of the distortion.
    pub(super) fn set_regularisation(&mut self, regularisation: f64) {
        self.distortion = Distortion::new(regularisation);
    }

    /// Sets the constant terms of the lines to the current pose.
    fn reset_lines(&mut self) {
        for (at, state) in self.states.iter().enumerate() {
            let (lines, lane) = (&mut self.lines[at / LANES], at % LANES);
            (lines.det[0][lane], lines.square[0][lane]) = (state.derivative.determinant(), square(state.derivative));
        }
    }

    /// The unknowns, relative to their initial values.
    pub(super) fn unknown(&self) -> &[DVec2] {
        &self.unknown
    }
}

impl Objective for Relaxing<'_> {
    fn set_direction(&mut self, direction: &[DVec2]) {
        let relaxation = self.relaxation;
        self.direction.copy_from_slice(direction);
        relaxation.unknowns.expand(direction, |site, [place, x, y]| {
            self.parts[site] = at_origin([place, x, y], relaxation.rest[site]);
        });
        for (at, ((node, terms), state)) in relaxation.nodes.iter().zip(&mut self.states).enumerate() {
            let along = state.unscale * derivative(node, &terms[node.fixed as usize..], &self.parts);
            state.along = along;
            let (x, y) = (state.derivative.x_axis, state.derivative.y_axis);
            let mixed = x.perp_dot(along.y_axis) + along.x_axis.perp_dot(y);
            let product = x.dot(along.x_axis) + y.dot(along.y_axis);
            let (lines, lane) = (&mut self.lines[at / LANES], at % LANES);
            (lines.det[1][lane], lines.det[2][lane]) = (mixed, along.determinant());
            (lines.square[1][lane], lines.square[2][lane]) = (2.0 * product, square(along));
        }
        self.held = [0.0; 3];
        for ((&hold, unknown), by) in relaxation.hold.iter().zip(&self.unknown).zip(direction) {
            self.held[0] += hold / 2.0 * unknown.length_squared();
            self.held[1] += hold * unknown.dot(*by);
            self.held[2] += hold / 2.0 * by.length_squared();
        }
    }

    fn along_line(&self, length: f64) -> LineSample {
        let (mut values, mut firsts, mut seconds) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for lines in &self.lines {
            for lane in 0..LANES {
                let of =
                    |c: &[[f64; LANES]; 3]| LineSample::of_polynomial([c[0][lane], c[1][lane], c[2][lane]], length);
                let (det, square) = (of(&lines.det), of(&lines.square));
                let at = self.distortion.of(det.value, square.value);
                values[lane] += lines.area[lane] * at.energy;
                firsts[lane] += lines.area[lane] * (at.by_det * det.first + at.by_square * square.first);
                seconds[lane] += lines.area[lane]
                    * ((at.by_det_twice * det.first + 2.0 * at.by_both * square.first) * det.first
                        + at.by_det * det.second
                        + at.by_square * square.second);
            }
        }
        let held = LineSample::of_polynomial(self.held, length);
        LineSample {
            value: held.value + values.iter().sum::<f64>(),
            first: held.first + firsts.iter().sum::<f64>(),
            second: held.second + seconds.iter().sum::<f64>(),
        }
    }

    fn advance(&mut self, length: f64) {
        for (unknown, by) in self.unknown.iter_mut().zip(&self.direction) {
            *unknown += length * by;
        }
        for state in &mut self.states {
            state.derivative += length * state.along;
        }
        self.reset_lines();
    }

    fn gradient(&mut self, forces: &mut [DVec2]) {
        let relaxation = self.relaxation;
        for (lines, derivatives) in self.lines.iter().zip(&mut self.derivatives) {
            for lane in 0..LANES {
                let at = self.distortion.of(lines.det[0][lane], lines.square[0][lane]);
                derivatives.by_det[lane] = lines.area[lane] * at.by_det;
                derivatives.by_square[lane] = lines.area[lane] * at.by_square;
            }
        }
        self.parts.fill([DVec2::ZERO; 3]);
        let nodes = relaxation.nodes.iter().zip(&self.states);
        for (at, ((node, terms), state)) in nodes.enumerate() {
            let (derivatives, lane) = (&self.derivatives[at / LANES], at % LANES);
            let pull = gradient(state.derivative, derivatives.by_det[lane], derivatives.by_square[lane]);
            let pull = state.unscale * pull;
            for term in &terms[node.fixed as usize..] {
                term.pull(node.at, pull, &mut self.parts[term.site as usize]);
            }
        }
        let force = |site: usize| {
            let ([place, x, y], rest) = (self.parts[site], relaxation.rest[site]);
            [place, x - rest.x * place, y - rest.y * place]
        };
        relaxation.unknowns.gather(force, forces);
        for ((force, &hold), &unknown) in forces.iter_mut().zip(&relaxation.hold).zip(&self.unknown) {
            *force += hold * unknown;
        }
        relaxation.unknowns.keep(self.is_free, forces);
    }
}

/// Parts with the image of the origin as place, from those with the image of the site.
fn at_origin([place, x, y]: Parts, rest: DVec2) -> Parts {
    [place - rest.x * x - rest.y * y, x, y]
}

/// The Jacobian at a node, Σ T(p) ∇wᵀ + w T′, from parts relative to the origin.
fn derivative(node: &Node, terms: &[Term], parts: &[Parts]) -> DMat2 {
    let add = |sum: DMat2, &Term { site, weight, gradient }: &Term| {
        let [place, x, y] = parts[site as usize];
        let moved = place + node.at.x * x + node.at.y * y;
        DMat2::from_cols(
            sum.x_axis + (gradient.x * moved + weight * x), //
            sum.y_axis + (gradient.y * moved + weight * y),
        )
    };
    terms.iter().fold(DMat2::ZERO, add)
}

impl Term {
    /// Adds to the gradient with respect to the site's parts, given the gradient with respect to the Jacobian.
    fn pull(&self, at: DVec2, gradient: DMat2, forces: &mut Parts) {
        let pull = self.gradient.x * gradient.x_axis + self.gradient.y * gradient.y_axis;
        forces[0] += pull;
        forces[1] += at.x * pull + self.weight * gradient.x_axis;
        forces[2] += at.y * pull + self.weight * gradient.y_axis;
    }
}
