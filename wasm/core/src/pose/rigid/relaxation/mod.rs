//! Relaxation: motions that distort the picture itself as little as they can.
//!
//! The sites alone do not show how a blend deforms the picture between them. But the blended map is linear in the
//! places and linear parts of the sites (eq. 1), and so is its Jacobian J at a node of the
//! [quadrature](super::Quadrature), as in fast automatic skinning (Jacobson, Baran, Kavan, Popović and Sorkine 2012).
//! Minimised is Σ area · [`distortion`](super::distortion)(J / s), where s is the scale requested at the node, over
//! everything that the handles leave free: see [`Freedom`].
//!
//! A [descent](descend) minimises it, preconditioned by the factorised matrix of Σ area |J|². Along a line J is
//! linear in the length, so det J and |J|² are polynomials in it, and a line search does not visit the sites: see
//! `relaxing`. The initial motions are those of the cell graph alone: see [`bending`](super::bending). Cost: some 0.1
//! ms an iteration for 200 sites.

mod nodes;
mod relaxing;
mod unknowns;

use std::{collections::BTreeMap, f64::consts::TAU};

use glam::{DMat2, DVec2};

use self::{
    nodes::Nodes,
    relaxing::Relaxing,
    unknowns::{Parts, Unknowns},
};
use super::{
    super::{
        Motion,
        motion::polar,
        numeric::{Cholesky, Limits, descend},
    },
    quadrature::{Node, Quadrature},
    stiffness::StiffnessField,
};

pub(crate) use self::unknowns::Freedom;

/// Regularisation ε of the first iterations: large, so that inverted parts recover in them.
const FIRST_REGULARISATION: f64 = 0.5;
/// Number of these iterations. Without them a twisted cross of 200 sites keeps twice as many folds, and bars beside a
/// held outline keep some.
const FIRST_ITERATIONS: usize = 2;
/// Regularisation ε of the iterations that follow. With half of it descents get stuck; with twice as much folds cost
/// too little.
const REGULARISATION: f64 = 0.2;
/// Stiffness of the spring that anchors a motion at its initial value, as a fraction of the area around its site: it
/// decides where the quadrature does not. A fifth of it distorts more of the picture between bars that turn against
/// each other. Five times as much bends everything stiffly.
const ANCHOR_STIFFNESS: f64 = 0.1;
/// Least area for [`ANCHOR_STIFFNESS`], as a fraction of the mean cell: a site of little influence stays with its
/// surroundings. With a hundredth of it, a site between two bars may go anywhere, and folds the picture between the
/// nodes of the quadrature.
const LEAST: f64 = 0.2;
/// The descent ends with an iteration that lowers the energy by no more than this fraction: most poses take about
/// five. With ten times as much, drags jump by some pixels.
const GAIN: f64 = 2e-3;
/// Line searches end where the slope is this fraction of the initial one: the first low point of a line is far from
/// its minimum. With twice as much, a twisted cross jumps by five times as much as its handles move; the samples of a
/// line hardly cost more, as each is much closer than the last.
const CURVATURE_CONDITION: f64 = 0.015;
/// Iterations at most. With six, a twisted cross of 200 sites stays folded in places. With 40, folds between handles
/// that were moved past one another at random drop to a half or a fifth. That takes twice as long, and drags jump
/// half as often again.
const MAX_ITERATIONS: usize = 8;
/// The same if some of the picture is stiffer than the rest: its turns converge slowly. With eight, the picture around
/// it folds.
const STIFF_ITERATIONS: usize = 30;
/// A picture is as stiff everywhere if no factor is farther from 1: above rounding.
const EVEN: f64 = 1e-9;

/// Iterations at most from the minimum of a pose nearby, and the fraction as [`GAIN`]. Where that minimum vanishes, the
/// picture then takes some frames to the next one, instead of a jump.
const NEARBY_ITERATIONS: usize = 12;
const NEARBY_GAIN: f64 = 1e-3;

/// The blended map's distortion as a function of the unknowns. Lengths are in [units](Relaxation::unit).
#[derive(Debug, Clone)]
pub(super) struct Relaxation {
    unknowns: Unknowns,
    /// Rest place of each site.
    rest: Vec<DVec2>,
    nodes: Nodes,
    /// Unit of length, in pixels: the square root of the mean cell's area.
    unit: f64,
    /// Stiffness of the spring that anchors each unknown.
    anchor_stiffness: Vec<f64>,
    inverse: Cholesky,
    max_iterations: usize,
}

impl Relaxation {
    pub(super) fn new(quadrature: &Quadrature, stiff: &StiffnessField, rest: &[DVec2], freedom: &[Freedom]) -> Self {
        let all: Vec<Node> = quadrature.nodes().collect();
        let mean = (all.iter().map(|node| node.area).sum::<f64>() / rest.len() as f64).max(f64::MIN_POSITIVE);
        let unit = mean.sqrt();
        let rest: Vec<DVec2> = rest.iter().map(|&rest| rest / unit).collect();
        let unknowns = Unknowns::new(freedom);
        // A place that is off by one cell counts as much as a linear part that is off by one.
        let stiffness = |(around, freedom): (f64, &Freedom)| {
            freedom.factors().map(move |_| ANCHOR_STIFFNESS * f64::max(around, LEAST * mean))
        };
        let anchor_stiffness: Vec<f64> =
            areas_around(&all, rest.len()).into_iter().zip(freedom).flat_map(stiffness).collect();
        let factors = stiff.factors(&all);
        let nodes = Nodes::new(all, &factors, freedom, unit);
        let inverse = Cholesky::new(&unknowns.groups(), &preconditioner(&nodes, &unknowns, &rest, &anchor_stiffness));
        let is_even = factors.iter().all(|factor| (factor - 1.0).abs() < EVEN);
        let max_iterations = if is_even { MAX_ITERATIONS } else { STIFF_ITERATIONS };
        Self { unknowns, rest, nodes, unit, anchor_stiffness, inverse, max_iterations }
    }

    /// Lowers the distortion of motions. `is_free` says for each site whether its rotation is free, `scales` are those
    /// requested at the sites; the descent ends with an iteration that moves no site by more than `tolerance` pixels.
    ///
    /// First with a large regularisation, then with the final one.
    pub(super) fn minimize(&self, motions: &mut [Motion], is_free: &[bool], scales: &[f64], tolerance: f64) {
        self.relax(motions, is_free, scales, FIRST_REGULARISATION, |relaxing, descend| {
            descend(relaxing, self.limits(FIRST_ITERATIONS, GAIN, tolerance));
            relaxing.set_regularisation(REGULARISATION);
            descend(relaxing, self.limits(self.max_iterations - FIRST_ITERATIONS, GAIN, tolerance));
        });
    }

    /// Like [`minimize`](Self::minimize), from motions near a minimum to that minimum.
    pub(super) fn minimize_nearby(&self, motions: &mut [Motion], is_free: &[bool], scales: &[f64], tolerance: f64) {
        self.relax(motions, is_free, scales, REGULARISATION, |relaxing, descend| {
            descend(relaxing, self.limits(NEARBY_ITERATIONS, NEARBY_GAIN, tolerance));
        });
    }

    fn limits(&self, max_iterations: usize, gain: f64, tolerance: f64) -> Limits {
        let tolerance = tolerance / self.unit;
        Limits { max_iterations, tolerance, gain, curvature_condition: CURVATURE_CONDITION }
    }

    /// Relaxes motions by `run`, which gets the pose and the descent.
    fn relax(
        &self,
        motions: &mut [Motion],
        is_free: &[bool],
        scales: &[f64],
        regularisation: f64,
        run: impl FnOnce(&mut Relaxing<'_>, &dyn Fn(&mut Relaxing<'_>, Limits)),
    ) {
        if self.anchor_stiffness.is_empty() {
            return;
        }
        let mut parts = self.parts(motions);
        let mut relaxing = Relaxing::new(self, &parts, is_free, scales, regularisation);
        let solve = |values: &mut [DVec2]| {
            self.inverse.solve(values);
            self.unknowns.keep(is_free, values);
        };
        run(&mut relaxing, &|relaxing, limits| descend(relaxing, self.unknowns.len(), solve, limits));
        // If handles are posed so far out that numbers overflow, keep the initial motions.
        if !relaxing.unknown().iter().all(|by| by.is_finite()) {
            return;
        }
        self.unknowns.expand(relaxing.unknown(), |site, by| {
            for (part, by) in parts[site].iter_mut().zip(by) {
                *part += by;
            }
        });
        self.set_motions(motions, &parts, is_free);
    }

    /// The parts of motions.
    fn parts(&self, motions: &[Motion]) -> Vec<Parts> {
        let of_motion = |(motion, &rest): (&Motion, &DVec2)| {
            let linear = motion.linear();
            [rest + motion.translation / self.unit, linear.x_axis, linear.y_axis]
        };
        motions.iter().zip(&self.rest).map(of_motion).collect()
    }

    /// Sets the free parts of motions.
    fn set_motions(&self, motions: &mut [Motion], parts: &[Parts], is_free: &[bool]) {
        for (site, ((freedom, _), motion)) in self.unknowns.iter().zip(motions).enumerate() {
            let [place, x, y] = parts[site];
            let map = DMat2::from_cols(x, y);
            match freedom {
                Freedom::Whole => {
                    motion.translation = self.unit * (place - self.rest[site]);
                    (motion.angle, motion.strain) = polar(map);
                }
                Freedom::Linear if is_free[site] => (motion.angle, motion.strain) = polar(map),
                Freedom::Across(_) => bend_bone(motion, map),
                Freedom::Linear | Freedom::None => {}
            }
        }
    }
}

/// The area that each site moves, in square pixels: the sum of its weights.
pub(super) fn areas_around(nodes: &[Node], sites: usize) -> Vec<f64> {
    let mut around = vec![0.0; sites];
    for Node { area, influences, .. } in nodes {
        influences.iter().for_each(|one| around[one.site] += one.weight * area);
    }
    around
}

/// The lower entries of the matrix of Σ area |J|² and of the springs.
fn preconditioner(
    nodes: &Nodes,
    unknowns: &Unknowns,
    rest: &[DVec2],
    anchor_stiffness: &[f64],
) -> BTreeMap<(u32, u32), f64> {
    let mut lower: BTreeMap<(u32, u32), f64> =
        anchor_stiffness.iter().zip(0..).map(|(&stiffness, at)| ((at, at), stiffness)).collect();
    let mut columns: Vec<(u32, DVec2)> = Vec::new();
    for (node, terms) in nodes.iter() {
        columns.clear();
        for term in &terms[node.fixed as usize..] {
            let of_parts = term.of_parts(node.at - rest[term.site as usize]);
            let value = |factors: [f64; 3]| -> DVec2 { (0..3).map(|k| of_parts[k] * factors[k]).sum() };
            let (freedom, first) = unknowns.of(term.site);
            columns.extend((first..).zip(freedom.factors().map(value)));
        }
        for &(i, by_i) in &columns {
            for &(j, by_j) in columns.iter().filter(|(j, _)| *j <= i) {
                *lower.entry((i, j)).or_default() += node.area * by_i.dot(by_j);
            }
        }
    }
    lower
}

/// Gives the motion of a bone another linear map with the same effect along the bone, unless that map is too close to
/// inversion to be a motion.
fn bend_bone(motion: &mut Motion, map: DMat2) {
    let (angle, strain) = polar(map);
    let turns = libm::round((motion.angle - angle) / TAU);
    let found = Motion { angle: angle + TAU * turns, strain, ..*motion };
    if found.linear().abs_diff_eq(map, MAP_ROUNDING * (map.x_axis.length() + map.y_axis.length())) {
        *motion = found;
    }
}

/// Greatest relative change of a map that is written as a motion: above rounding, and too little to see on a bar.
const MAP_ROUNDING: f64 = 1e-12;
