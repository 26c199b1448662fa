//! A pose on the way to its least distortion, seen along lines.

use glam::{DMat2, DVec2};

use super::{
    super::{
        descent::{Landscape, View},
        distortion::{Distortion, gradient, square},
    },
    Node, Parts, Relaxation, SOFT, Term, seen,
};

/// A pose on the way to its least distortion.
pub(super) struct Relaxing<'a> {
    relaxation: &'a Relaxation,
    distortion: Distortion,
    is_free: &'a [bool],
    /// Counted from where they begin.
    unknown: Vec<DVec2>,
    by: Vec<DVec2>,
    /// What the direction, or the gradient, is for the parts of each site, whose places are of the map at the origin.
    parts: Vec<Parts>,
    sights: Vec<Sight>,
    lines: Vec<Lines>,
    slopes: Vec<Slopes>,
    /// What holds the unknowns, along the direction: a polynomial of the length.
    held: [f64; 3],
}

/// What a node sees.
#[derive(Debug, Clone, Copy)]
struct Sight {
    /// Reciprocal of the scale that is asked for.
    unscale: f64,
    /// The derivative J times it.
    derivative: DMat2,
    /// How that changes along the direction.
    along: DMat2,
}

/// What some nodes see along the direction: coefficients of polynomials of the length, of which the first are where the pose is.
/// Processors work on more than one number at a time.
#[derive(Debug, Clone, Copy)]
struct Lines {
    area: [f64; LANES],
    det: [[f64; LANES]; 3],
    /// |J|².
    square: [[f64; LANES]; 3],
}

/// Derivatives of the energy of some nodes.
#[derive(Debug, Clone, Copy)]
struct Slopes {
    by_det: [f64; LANES],
    by_square: [f64; LANES],
}

const LANES: usize = 4;

/// Lines of no node: their J is 1, and they weigh nothing.
const NO_LINES: Lines = Lines {
    area: [0.0; LANES],
    det: [[1.0; LANES], [0.0; LANES], [0.0; LANES]],
    square: [[2.0; LANES], [0.0; LANES], [0.0; LANES]],
};

impl<'a> Relaxing<'a> {
    /// Where the parts of all sites are these, whose places are where the sites go; `scales` are what the sites ask for.
    pub(super) fn new(relaxation: &'a Relaxation, parts: &[Parts], is_free: &'a [bool], scales: &[f64]) -> Self {
        let parts: Vec<Parts> =
            parts.iter().zip(&relaxation.rest).map(|(&parts, &rest)| at_origin(parts, rest)).collect();
        let is_scaled = scales.iter().any(|&scale| scale != 1.0);
        let sight = |(node, terms): (&Node, &[Term])| {
            let scale = |term: &Term| term.weight * scales[term.site as usize];
            let unscale = if is_scaled { 1.0 / terms.iter().map(scale).sum::<f64>() } else { 1.0 };
            Sight { unscale, derivative: unscale * derivative(node, terms, &parts), along: DMat2::ZERO }
        };
        let unknowns = relaxation.hold.len();
        let count = relaxation.nodes.len().div_ceil(LANES);
        let mut lines = vec![NO_LINES; count];
        for (at, node) in relaxation.nodes.iter().enumerate() {
            lines[at / LANES].area[at % LANES] = node.area;
        }
        let mut relaxing = Self {
            relaxation,
            distortion: Distortion::new(SOFT),
            is_free,
            unknown: vec![DVec2::ZERO; unknowns],
            by: vec![DVec2::ZERO; unknowns],
            sights: seen(&relaxation.nodes, &relaxation.terms).map(sight).collect(),
            lines,
            slopes: vec![Slopes { by_det: [0.0; LANES], by_square: [0.0; LANES] }; count],
            parts,
            held: [0.0; 3],
        };
        relaxing.stand();
        relaxing
    }

    /// Sets how soft the distortion is.
    pub(super) fn soften(&mut self, softness: f64) {
        self.distortion = Distortion::new(softness);
    }

    /// Puts down what nodes see where the pose is.
    fn stand(&mut self) {
        for (at, sight) in self.sights.iter().enumerate() {
            let (lines, lane) = (&mut self.lines[at / LANES], at % LANES);
            (lines.det[0][lane], lines.square[0][lane]) = (sight.derivative.determinant(), square(sight.derivative));
        }
    }

    /// The unknowns, counted from where they began.
    pub(super) fn unknown(&self) -> &[DVec2] {
        &self.unknown
    }
}

impl Landscape for Relaxing<'_> {
    fn face(&mut self, by: &[DVec2]) {
        let relaxation = self.relaxation;
        self.by.copy_from_slice(by);
        relaxation.spread(by, |site, [place, x, y]| {
            self.parts[site] = at_origin([place, x, y], relaxation.rest[site]);
        });
        for (at, ((node, terms), sight)) in seen(&relaxation.nodes, &relaxation.terms).zip(&mut self.sights).enumerate()
        {
            let along = sight.unscale * derivative(node, &terms[node.fixed as usize..], &self.parts);
            sight.along = along;
            let (x, y) = (sight.derivative.x_axis, sight.derivative.y_axis);
            let mixed = x.perp_dot(along.y_axis) + along.x_axis.perp_dot(y);
            let product = x.dot(along.x_axis) + y.dot(along.y_axis);
            let (lines, lane) = (&mut self.lines[at / LANES], at % LANES);
            (lines.det[1][lane], lines.det[2][lane]) = (mixed, along.determinant());
            (lines.square[1][lane], lines.square[2][lane]) = (2.0 * product, square(along));
        }
        self.held = [0.0; 3];
        for ((&hold, unknown), by) in relaxation.hold.iter().zip(&self.unknown).zip(by) {
            self.held[0] += hold / 2.0 * unknown.length_squared();
            self.held[1] += hold * unknown.dot(*by);
            self.held[2] += hold / 2.0 * by.length_squared();
        }
    }

    fn look(&self, length: f64) -> View {
        let (mut heights, mut slopes, mut curvatures) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for lines in &self.lines {
            for lane in 0..LANES {
                let of = |c: &[[f64; LANES]; 3]| View::of_polynomial([c[0][lane], c[1][lane], c[2][lane]], length);
                let (det, square) = (of(&lines.det), of(&lines.square));
                let seen = self.distortion.of(det.height, square.height);
                heights[lane] += lines.area[lane] * seen.energy;
                slopes[lane] += lines.area[lane] * (seen.by_det * det.slope + seen.by_square * square.slope);
                curvatures[lane] += lines.area[lane]
                    * ((seen.by_det_twice * det.slope + 2.0 * seen.by_both * square.slope) * det.slope
                        + seen.by_det * det.curvature
                        + seen.by_square * square.curvature);
            }
        }
        let held = View::of_polynomial(self.held, length);
        View {
            height: held.height + heights.iter().sum::<f64>(),
            slope: held.slope + slopes.iter().sum::<f64>(),
            curvature: held.curvature + curvatures.iter().sum::<f64>(),
        }
    }

    fn go(&mut self, length: f64) {
        for (unknown, by) in self.unknown.iter_mut().zip(&self.by) {
            *unknown += length * by;
        }
        for sight in &mut self.sights {
            sight.derivative += length * sight.along;
        }
        self.stand();
    }

    fn gradient(&mut self, forces: &mut [DVec2]) {
        let relaxation = self.relaxation;
        for (lines, slopes) in self.lines.iter().zip(&mut self.slopes) {
            for lane in 0..LANES {
                let seen = self.distortion.of(lines.det[0][lane], lines.square[0][lane]);
                slopes.by_det[lane] = lines.area[lane] * seen.by_det;
                slopes.by_square[lane] = lines.area[lane] * seen.by_square;
            }
        }
        self.parts.fill([DVec2::ZERO; 3]);
        let nodes = seen(&relaxation.nodes, &relaxation.terms).zip(&self.sights);
        for (at, ((node, terms), sight)) in nodes.enumerate() {
            let (slopes, lane) = (&self.slopes[at / LANES], at % LANES);
            let pull = gradient(sight.derivative, slopes.by_det[lane], slopes.by_square[lane]);
            let pull = sight.unscale * pull;
            for term in &terms[node.fixed as usize..] {
                term.pull(node.at, pull, &mut self.parts[term.site as usize]);
            }
        }
        let force = |site: usize| {
            let ([place, x, y], rest) = (self.parts[site], relaxation.rest[site]);
            [place, x - rest.x * place, y - rest.y * place]
        };
        relaxation.gather(force, forces);
        for ((force, &hold), &unknown) in forces.iter_mut().zip(&relaxation.hold).zip(&self.unknown) {
            *force += hold * unknown;
        }
        relaxation.keep(self.is_free, forces);
    }
}

/// Parts with the place of the map at the origin, from those with the place of their site.
fn at_origin([place, x, y]: Parts, rest: DVec2) -> Parts {
    [place - rest.x * x - rest.y * y, x, y]
}

/// What sites make of a node's derivative, their places of the map at the origin: Σ T(p) ∇wᵀ + w T′.
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
    /// Adds to the gradient by the site's parts when that by the derivative is `gradient`.
    fn pull(&self, at: DVec2, gradient: DMat2, forces: &mut Parts) {
        let pull = self.gradient.x * gradient.x_axis + self.gradient.y * gradient.y_axis;
        forces[0] += pull;
        forces[1] += at.x * pull + self.weight * gradient.x_axis;
        forces[2] += at.y * pull + self.weight * gradient.y_axis;
    }
}
