//! The objective of a relaxation: a pose, and its distortion along a line.
//!
//! Cost: O(terms) for a direction and for a gradient; O(nodes) for a sample of the line.

use glam::{DMat2, DVec2};
use wide::f64x4;

use super::{
    super::{
        super::numeric::{Jet, Objective},
        distortion::{Distortion, gradient},
        jacobians::Jacobians,
    },
    Level, Parts, Relaxation,
    nodes::{Node, Term},
};

/// A pose under relaxation.
pub(super) struct Relaxing<'a> {
    relaxation: &'a Relaxation,
    level: &'a Level,
    distortion: Distortion,
    is_free: &'a [bool],
    /// The unknowns, relative to their initial values.
    unknown: Vec<DVec2>,
    direction: Vec<DVec2>,
    /// Scratch: the direction, or the gradient, in terms of the parts of each site, with positions relative to the
    /// origin.
    parts: Vec<Parts>,
    maps: Vec<Maps>,
    lines: Vec<Lines>,
    /// Length along the line at which the factors of `lines` are evaluated.
    sampled: f64,
    /// Energy of the springs that anchor the unknowns, along the direction: coefficients of a polynomial in the length.
    anchored: [f64; 3],
}

/// The map at several nodes.
#[derive(Debug, Clone, Copy)]
struct Maps {
    /// Reciprocal of the scale requested there.
    unscale: f64x4,
    /// The Jacobian J, divided by the scale.
    derivative: Jacobians,
    /// Its derivative along the direction.
    along: Jacobians,
}

/// det J and |J|² of several nodes along the direction: coefficients of polynomials in the length, whose constant terms
/// belong to the current pose.
#[derive(Debug, Clone, Copy, Default)]
struct Lines {
    area: f64x4,
    det: [f64x4; 3],
    /// |J|².
    square: [f64x4; 3],
    /// The factor of |J|² in the energy.
    factor: Jet<f64x4>,
}

const LANES: usize = Jacobians::LANES;

impl<'a> Relaxing<'a> {
    /// Begins at the given parts of all sites, whose positions are the sites' posed positions. `scales` are the
    /// requested scales at the sites, and `regularisation` is ε of the distortion.
    pub(super) fn new(
        relaxation: &'a Relaxation,
        level: &'a Level,
        parts: &[Parts],
        is_free: &'a [bool],
        scales: &[f64],
        regularisation: f64,
    ) -> Self {
        let parts: Vec<Parts> =
            parts.iter().zip(&relaxation.rest).map(|(&parts, &rest)| at_origin(parts, rest)).collect();
        let is_scaled = scales.iter().any(|&scale| scale != 1.0);
        let scale_at = |terms: &[Term]| match is_scaled {
            true => terms.iter().map(|term| term.weight * scales[term.site as usize]).sum(),
            false => 1.0,
        };
        let mut nodes = level.nodes.iter();
        let groups = nodes.len().div_ceil(LANES);
        let (mut maps, mut lines) = (Vec::with_capacity(groups), Vec::with_capacity(groups));
        while nodes.len() > 0 {
            // Lanes without a node have no area.
            let (mut area, mut scale, mut derivatives) = ([0.0; LANES], [1.0; LANES], [DMat2::IDENTITY; LANES]);
            for (lane, (node, terms)) in nodes.by_ref().take(LANES).enumerate() {
                (area[lane], scale[lane]) = (node.area, scale_at(terms));
                derivatives[lane] = derivative(node, terms, &parts);
            }
            let unscale = 1.0 / f64x4::new(scale);
            let derivative = unscale * Jacobians::new(derivatives);
            maps.push(Maps { unscale, derivative, along: Jacobians::default() });
            lines.push(Lines::new(area.into(), &derivative));
        }
        let unknowns = relaxation.unknowns.len();
        let mut relaxing = Self {
            relaxation,
            level,
            distortion: Distortion::new(regularisation),
            is_free,
            unknown: vec![DVec2::ZERO; unknowns],
            direction: vec![DVec2::ZERO; unknowns],
            parts,
            maps,
            lines,
            sampled: 0.0,
            anchored: [0.0; 3],
        };
        relaxing.evaluate(0.0);
        relaxing
    }

    /// The least det J of all nodes.
    pub(super) fn least_determinant(&self) -> f64 {
        self.lines.iter().flat_map(|lines| lines.det[0].to_array()).fold(f64::INFINITY, f64::min)
    }

    /// Sets ε of the distortion.
    pub(super) fn set_regularisation(&mut self, regularisation: f64) {
        self.distortion = Distortion::new(regularisation);
        self.evaluate(0.0);
    }

    /// Sets the factors of all lines to those at a point.
    fn evaluate(&mut self, length: f64) {
        self.lines.iter_mut().for_each(|lines| lines.evaluate(&self.distortion, length));
        self.sampled = length;
    }

    /// The unknowns, relative to their initial values.
    pub(super) fn unknown(&self) -> &[DVec2] {
        &self.unknown
    }

    /// The energy at a point of the line, from that of the nodes.
    fn with_springs(&self, of_nodes: Jet<f64x4>, length: f64) -> Jet {
        Jet::of_polynomial(self.anchored, length) + of_nodes.map(|lanes| lanes.to_array().into_iter().sum())
    }
}

impl Objective for Relaxing<'_> {
    fn gradient(&mut self, forces: &mut [DVec2]) {
        let (relaxation, level) = (self.relaxation, self.level);
        self.parts.fill([DVec2::ZERO; 3]);
        let mut nodes = level.nodes.iter();
        for (lines, maps) in self.lines.iter().zip(&self.maps) {
            for (gradient, (node, terms)) in lines.gradients(maps).to_array().into_iter().zip(&mut nodes) {
                for term in &terms[node.fixed as usize..] {
                    term.add_gradient(node.at, gradient, &mut self.parts[term.site as usize]);
                }
            }
        }
        let force = |site: usize| {
            let ([place, x, y], rest) = (self.parts[site], relaxation.rest[site]);
            [place, x - rest.x * place, y - rest.y * place]
        };
        relaxation.unknowns.gather(force, forces);
        for ((force, &stiffness), &unknown) in forces.iter_mut().zip(&level.anchor_stiffness).zip(&self.unknown) {
            *force += stiffness * unknown;
        }
        relaxation.unknowns.keep(self.is_free, forces);
    }

    fn set_direction(&mut self, direction: &[DVec2]) -> Jet {
        let (relaxation, level) = (self.relaxation, self.level);
        self.direction.copy_from_slice(direction);
        relaxation.unknowns.expand(direction, |site, [place, x, y]| {
            self.parts[site] = at_origin([place, x, y], relaxation.rest[site]);
        });
        self.anchored = [0.0; 3];
        for ((&stiffness, unknown), by) in level.anchor_stiffness.iter().zip(&self.unknown).zip(direction) {
            self.anchored[0] += stiffness / 2.0 * unknown.length_squared();
            self.anchored[1] += stiffness * unknown.dot(*by);
            self.anchored[2] += stiffness / 2.0 * by.length_squared();
        }
        let mut sum = Jet::default();
        let mut nodes = level.nodes.iter();
        for (lines, maps) in self.lines.iter_mut().zip(&mut self.maps) {
            let mut along = [DMat2::ZERO; LANES];
            for (along, (node, terms)) in along.iter_mut().zip(&mut nodes) {
                *along = derivative(node, &terms[node.fixed as usize..], &self.parts);
            }
            maps.along = maps.unscale * Jacobians::new(along);
            lines.lead(maps);
            sum = sum + lines.sample(&self.distortion, 0.0);
        }
        self.with_springs(sum, 0.0)
    }

    fn along_line(&mut self, length: f64) -> Jet {
        let mut sum = Jet::default();
        for lines in &mut self.lines {
            lines.evaluate(&self.distortion, length);
            sum = sum + lines.sample(&self.distortion, length);
        }
        self.sampled = length;
        self.with_springs(sum, length)
    }

    fn advance(&mut self, length: f64) {
        if self.sampled != length {
            self.evaluate(length);
        }
        for (unknown, by) in self.unknown.iter_mut().zip(&self.direction) {
            *unknown += length * by;
        }
        for (lines, maps) in self.lines.iter_mut().zip(&mut self.maps) {
            maps.derivative = maps.derivative + f64x4::splat(length) * maps.along;
            lines.start(&maps.derivative);
        }
        self.sampled = 0.0;
    }
}

impl Lines {
    fn new(area: f64x4, derivative: &Jacobians) -> Self {
        let mut lines = Self { area, ..Self::default() };
        lines.start(derivative);
        lines
    }

    /// Sets the start of the lines.
    fn start(&mut self, derivative: &Jacobians) {
        (self.det[0], self.square[0]) = (derivative.det(), derivative.square());
    }

    /// Sets the direction of the lines.
    fn lead(&mut self, Maps { derivative, along, .. }: &Maps) {
        (self.det[1], self.det[2]) = (derivative.det_along(along), along.det());
        (self.square[1], self.square[2]) = (2.0 * derivative.dot(along), along.square());
    }

    /// Sets the factors to those at a point of the lines.
    fn evaluate(&mut self, distortion: &Distortion, length: f64) {
        self.factor = distortion.factor(self.at(length).0.value);
    }

    /// The energies, weighted by area, along the lines at that point.
    fn sample(&self, distortion: &Distortion, length: f64) -> Jet<f64x4> {
        let (det, square) = self.at(length);
        let energy = self.factor.of(&det) * square - distortion.least.into();
        energy.map(|value| self.area * value)
    }

    /// det J and |J|² at a point of the lines.
    fn at(&self, length: f64) -> (Jet<f64x4>, Jet<f64x4>) {
        (Jet::of_polynomial(self.det, length.into()), Jet::of_polynomial(self.square, length.into()))
    }

    /// The gradients of the energies, weighted by area, with respect to J at the start of the lines, where the
    /// factors are.
    fn gradients(&self, maps: &Maps) -> Jacobians {
        self.area * maps.unscale * gradient(&maps.derivative, &self.factor, self.square[0])
    }
}

/// Converts parts that store the image of the site to parts that store the image of the origin.
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
    fn add_gradient(&self, at: DVec2, gradient: DMat2, forces: &mut Parts) {
        let at_site = self.gradient.x * gradient.x_axis + self.gradient.y * gradient.y_axis;
        forces[0] += at_site;
        forces[1] += at.x * at_site + self.weight * gradient.x_axis;
        forces[2] += at.y * at_site + self.weight * gradient.y_axis;
    }
}
