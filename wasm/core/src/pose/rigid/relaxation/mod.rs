//! Relaxation: finds motions that distort the picture itself as little as possible.
//!
//! The sites do not fully determine how a blend deforms the picture between them. But the blended map is linear in the
//! positions and linear parts of the sites (eq. 1), and so is its Jacobian J at a node of the
//! [quadrature](super::Quadrature), as in fast automatic skinning (Jacobson, Baran, Kavan, Popović and Sorkine 2012).
//! Minimised is Σ area · [`distortion`](super::distortion)(J / s), where s is the scale requested at the node, over
//! everything that the handles leave free: see [`Freedom`].
//!
//! A [descent](descend) minimises it, preconditioned by the factorised matrix of Σ area |J|². Along a line, J is linear
//! in the length, so det J and |J|² are polynomials in it, and a line search does not visit the sites: see `relaxing`.
//! The initial motions are those of the bent cell graph: see [`bending`](super::bending).
//!
//! The coarse nodes lead to the right minimum, with a large regularisation that undoes folds. The fine nodes refine it,
//! with a small regularisation. With more coarse nodes the result folds; with more fine nodes it takes longer. Cost:
//! about 0.1 ms per iteration for 200 sites.

mod nodes;
mod relaxing;
mod unknowns;

use std::{collections::BTreeMap, f64::consts::TAU, iter::zip, ops::Range};

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
use crate::rows::Rows;

pub(crate) use self::unknowns::Freedom;

/// Regularisation ε of the first iterations: large, so that inverted parts recover in them.
const FIRST_REGULARISATION: f64 = 0.5;
/// Number of these iterations. Without them, a twisted cross of 200 sites keeps twice as many folds, and bars beside a
/// held outline keep some.
const FIRST_ITERATIONS: usize = 2;
/// Regularisation ε of the iterations that follow. With half of it, descents get stuck; with twice as much, folds cost
/// too little.
const REGULARISATION: f64 = 0.2;
/// Regularisation ε at the fine nodes: smaller, because no coarse node is inverted by then. With a third of it,
/// rounding grows to pixels in twenty iterations.
const FINE_REGULARISATION: f64 = 0.15;
/// Stiffness of the springs that anchor motions at their initial values, as a fraction of the area around the site.
/// They determine the modes that the quadrature does not. A fifth of this stiffness distorts more of the picture
/// between bars that turn against each other. Five times this stiffness bends everything stiffly.
const ANCHOR_STIFFNESS: f64 = 0.1;
/// The same for the fine nodes, which determine more. With three times as much, poses distort by 1 % more.
const FINE_ANCHOR_STIFFNESS: f64 = 0.03;
/// Least area for [`ANCHOR_STIFFNESS`], as a fraction of the mean cell: a site of little influence moves with its
/// surroundings. With a hundredth of it, a site between two bars may move anywhere, and fold the picture between the
/// nodes of the quadrature.
const LEAST: f64 = 0.2;
/// The descent ends with an iteration that lowers the energy by at most this fraction: most poses take about five
/// iterations. With ten times as much, drags jump by several pixels.
const GAIN: f64 = 2e-3;
/// Line searches end where the slope is this fraction of the initial slope: the first low point of a line is far from
/// its minimum. With twice as much, a twisted cross jumps by five times as much as its handles move; the samples of a
/// line hardly cost more, as each is much closer than the last.
const CURVATURE_CONDITION: f64 = 0.015;
/// Maximum number of iterations at the coarse nodes. With six, a twisted cross of 200 sites remains folded in places.
/// With 40, folds between handles that were moved past one another at random drop to a half or a fifth. But poses take
/// twice as long, and drags jump half as often again.
const COARSE_ITERATIONS: usize = 8;
/// The same for pictures with stiffer parts, whose turns converge slowly. With eight, the picture around them folds.
const STIFF_ITERATIONS: usize = 30;
/// A picture is equally stiff everywhere if no factor differs more from 1. This is above rounding errors.
const EVEN: f64 = 1e-9;
/// Fixed number of iterations at the fine nodes: a varying number would make drags jump. With twelve, rounding grows to
/// pixels.
const FINE_ITERATIONS: usize = 5;
/// A pose is fully refined if det J is at least this at every coarse node, and not refined if the picture is inverted
/// at one.
const REFINED: f64 = 0.2;
/// Maximum number of iterations from the minimum of a nearby pose, and the corresponding [`GAIN`]. If that minimum
/// vanishes, the picture moves to the next one over several frames instead of jumping.
const NEARBY_ITERATIONS: usize = 12;
const NEARBY_GAIN: f64 = 1e-3;

/// The blended map's distortion as a function of the unknowns. Lengths are in [units](Relaxation::unit).
#[derive(Debug, Clone)]
pub(super) struct Relaxation {
    unknowns: Unknowns,
    /// Rest place of each site.
    rest: Vec<DVec2>,
    coarse: Level,
    fine: Level,
    /// Unit of length, in pixels: the square root of the mean cell's area.
    unit: f64,
    /// The factorisation for the coarse level. That of the fine level would take as many iterations.
    inverse: Cholesky,
    /// Whether parts of the picture are stiffer than the rest.
    is_uneven: bool,
}

/// The minimised energy: the distortion at nodes, and the energy of springs.
#[derive(Debug, Clone)]
struct Level {
    nodes: Nodes,
    /// Stiffness of the spring that anchors each unknown.
    anchor_stiffness: Vec<f64>,
}

impl Relaxation {
    pub(super) fn new(quadrature: &Quadrature, stiff: &StiffnessField, rest: &[DVec2], freedom: &[Freedom]) -> Self {
        let coarse: Vec<Node> = quadrature.coarse().collect();
        let mean = (coarse.iter().map(|node| node.area).sum::<f64>() / rest.len() as f64).max(f64::MIN_POSITIVE);
        let unit = mean.sqrt();
        let rest: Vec<DVec2> = rest.iter().map(|&rest| rest / unit).collect();
        let unknowns = Unknowns::new(freedom);
        let around = areas_around(&coarse, rest.len());
        let level = |nodes: Vec<Node>, stiffness: f64| {
            // A place that is off by one cell counts as much as a linear part that is off by one.
            let stiffness = |(&around, freedom): (&f64, &Freedom)| {
                freedom.factors().map(move |_| stiffness * f64::max(around, LEAST * mean))
            };
            let anchor_stiffness = around.iter().zip(freedom).flat_map(stiffness).collect();
            let factors = stiff.factors(&nodes);
            Level { nodes: Nodes::new(nodes, &factors, freedom, unit), anchor_stiffness }
        };
        let is_uneven = stiff.factors(&coarse).iter().any(|factor| (factor - 1.0).abs() >= EVEN);
        let coarse = level(coarse, ANCHOR_STIFFNESS);
        let fine = level(quadrature.fine().collect(), FINE_ANCHOR_STIFFNESS);
        let inverse = Cholesky::new(&unknowns.groups(), &preconditioner(&coarse, &unknowns, &rest));
        Self { unknowns, rest, coarse, fine, unit, inverse, is_uneven }
    }

    /// Lowers the distortion of motions at the coarse nodes. `is_free` states for each site whether its rotation is
    /// free. `scales` are the requested scales at the sites. A descent ends with an iteration that moves no site by
    /// more than `tolerance` pixels.
    pub(super) fn minimize(&self, motions: &mut [Motion], is_free: &[bool], scales: &[f64], tolerance: f64) {
        let iterations = if self.is_uneven { STIFF_ITERATIONS } else { COARSE_ITERATIONS };
        self.relax(motions, is_free, scales, FIRST_REGULARISATION, |relaxing, descend| {
            descend(relaxing, self.limits(FIRST_ITERATIONS, GAIN, tolerance));
            relaxing.set_regularisation(REGULARISATION);
            descend(relaxing, self.limits(iterations - FIRST_ITERATIONS, GAIN, tolerance));
        });
    }

    /// Like [`minimize`](Self::minimize), from motions near a minimum to that minimum.
    pub(super) fn minimize_nearby(&self, motions: &mut [Motion], is_free: &[bool], scales: &[f64], tolerance: f64) {
        self.relax(motions, is_free, scales, REGULARISATION, |relaxing, descend| {
            descend(relaxing, self.limits(NEARBY_ITERATIONS, NEARBY_GAIN, tolerance));
        });
    }

    /// Lowers the distortion of a coarse minimum at the fine nodes, by less if the picture is close to inverted.
    pub(super) fn refine(&self, motions: &mut [Motion], is_free: &[bool], scales: &[f64], tolerance: f64) {
        let coarse = self.parts(motions);
        let least = Relaxing::new(self, &self.coarse, &coarse, is_free, scales, REGULARISATION).least_determinant();
        let share = smooth_step(least / REFINED);
        if share == 0.0 {
            return;
        }
        let iterations = if self.is_uneven { STIFF_ITERATIONS } else { FINE_ITERATIONS };
        let limits = self.limits(iterations, 0.0, tolerance);
        let fine = self.relaxed(&self.fine, &coarse, is_free, scales, FINE_REGULARISATION, |relaxing, descend| {
            descend(relaxing, limits);
        });
        let Some(fine) = fine else { return };
        let between = |(coarse, fine): (&Parts, &Parts)| std::array::from_fn(|k| coarse[k].lerp(fine[k], share));
        let parts: Vec<Parts> = zip(&coarse, &fine).map(between).collect();
        self.set_motions(motions, &parts, is_free);
    }

    fn limits(&self, max_iterations: usize, gain: f64, tolerance: f64) -> Limits {
        let tolerance = tolerance / self.unit;
        Limits { max_iterations, tolerance, gain, curvature_condition: CURVATURE_CONDITION }
    }

    /// Relaxes motions at the coarse nodes with `run`, which receives the pose and the descent.
    fn relax(
        &self,
        motions: &mut [Motion],
        is_free: &[bool],
        scales: &[f64],
        regularisation: f64,
        run: impl FnOnce(&mut Relaxing<'_>, &dyn Fn(&mut Relaxing<'_>, Limits)),
    ) {
        if let Some(parts) = self.relaxed(&self.coarse, &self.parts(motions), is_free, scales, regularisation, run) {
            self.set_motions(motions, &parts, is_free);
        }
    }

    /// The parts of motions, relaxed on a level with `run`. `None` if nothing is free, or if handles are posed so far
    /// away that numbers overflow.
    fn relaxed(
        &self,
        level: &Level,
        parts: &[Parts],
        is_free: &[bool],
        scales: &[f64],
        regularisation: f64,
        run: impl FnOnce(&mut Relaxing<'_>, &dyn Fn(&mut Relaxing<'_>, Limits)),
    ) -> Option<Vec<Parts>> {
        if level.anchor_stiffness.is_empty() {
            return None;
        }
        let mut relaxing = Relaxing::new(self, level, parts, is_free, scales, regularisation);
        let solve = |values: &mut [DVec2]| {
            self.inverse.solve(values);
            self.unknowns.keep(is_free, values);
        };
        run(&mut relaxing, &|relaxing, limits| descend(relaxing, self.unknowns.len(), solve, limits));
        if !relaxing.unknown().iter().all(|by| by.is_finite()) {
            return None;
        }
        let mut parts = parts.to_vec();
        self.unknowns.expand(relaxing.unknown(), |site, by| {
            for (part, by) in parts[site].iter_mut().zip(by) {
                *part += by;
            }
        });
        Some(parts)
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

/// A smooth step: 0 below 0, 1 above 1.
fn smooth_step(at: f64) -> f64 {
    let at = at.clamp(0.0, 1.0);
    at * at * (3.0 - 2.0 * at)
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
fn preconditioner(level: &Level, unknowns: &Unknowns, rest: &[DVec2]) -> BTreeMap<(u32, u32), f64> {
    let mut columns: Vec<(u32, DVec2)> = Vec::new();
    // Nodes: the area of each, and its columns.
    let mut of_nodes: Vec<(f64, Range<usize>)> = Vec::new();
    for (node, terms) in level.nodes.iter() {
        let start = columns.len();
        for term in &terms[node.fixed as usize..] {
            let of_parts = term.of_parts(node.at - rest[term.site as usize]);
            let value = |factors: [f64; 3]| -> DVec2 { (0..3).map(|k| of_parts[k] * factors[k]).sum() };
            let (freedom, first) = unknowns.of(term.site);
            columns.extend((first..).zip(freedom.factors().map(value)));
        }
        of_nodes.push((node.area, start..columns.len()));
    }
    let rows = level.anchor_stiffness.len();
    let of_node = |(at, (_, range)): (usize, &(f64, Range<usize>))| {
        columns[range.clone()].iter().map(move |&(row, by)| (row as usize, (at, by)))
    };
    let nodes_of_rows = Rows::from_pairs(rows, || of_nodes.iter().enumerate().flat_map(of_node));
    let mut lower: BTreeMap<(u32, u32), f64> = BTreeMap::new();
    // One row at a time: sites that share many nodes would take a search for each pair at each node.
    let mut sums = vec![None; rows];
    for (i, &stiffness) in (0..).zip(&level.anchor_stiffness) {
        sums[i as usize] = Some(stiffness);
        for &(node, by_i) in nodes_of_rows.row(i as usize) {
            let (area, range) = &of_nodes[node];
            for &(j, by_j) in columns[range.clone()].iter().filter(|(j, _)| *j <= i) {
                *sums[j as usize].get_or_insert(0.0) += area * by_i.dot(by_j);
            }
        }
        // Unlike `collect`, this needs no sort of its own: see `rank`.
        lower.extend(sums[..=i as usize].iter_mut().zip(0..).filter_map(|(sum, j)| Some(((i, j), sum.take()?))));
    }
    lower
}

/// Changes the linear map of a bone's motion without changing its effect along the bone, unless the new map is too
/// close to inversion.
fn bend_bone(motion: &mut Motion, map: DMat2) {
    let (angle, strain) = polar(map);
    let turns = libm::round((motion.angle - angle) / TAU);
    let found = Motion { angle: angle + TAU * turns, strain, ..*motion };
    if found.linear().abs_diff_eq(map, MAP_ROUNDING * (map.x_axis.length() + map.y_axis.length())) {
        *motion = found;
    }
}

/// Greatest relative change of a map by its conversion to a motion: above rounding, and invisible on a bar.
const MAP_ROUNDING: f64 = 1e-12;
