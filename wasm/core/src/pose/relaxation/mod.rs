//! Relaxation: motions that distort the picture itself as little as they can.
//!
//! The sites alone do not show how a blend deforms the picture between them. But the blended map is linear in the places and
//! linear parts of the sites (eq. 1), and so is its Jacobian J at a node of the [quadrature](super::Quadrature), as in fast
//! automatic skinning (Jacobson, Baran, Kavan, Popović and Sorkine 2012). Minimised is Σ area ·
//! [`distortion`](super::distortion)(J / s), where s is the scale requested at the node, over everything that the handles
//! leave free: see [`Freedom`].
//!
//! [`descent`](super::descent) minimises it, preconditioned by the factorised matrix of Σ area |J|². Along a line J is linear
//! in the length, so det J and |J|² are polynomials in it, and a line search does not visit the sites: see `relaxing`. The
//! initial motions are those of the cell graph alone: see [`rigid`](super::rigid). Cost: some 0.15 ms an iteration for 200
//! sites.

mod relaxing;

use std::{collections::BTreeMap, f64::consts::TAU};

use glam::{DMat2, DVec2};
use serde::{Deserialize, Serialize};

use self::relaxing::Relaxing;
use super::{
    Motion, Quadrature,
    cholesky::Cholesky,
    descent::{Limits, descend},
    motion::polar,
};

/// Regularisation δ of the first iterations: large, so that what is inverted at the start recovers in them.
const FIRST_REGULARISATION: f64 = 0.5;
/// Number of these iterations. Without them a twisted cross of 200 sites keeps twice as many folds, and bars beside a held
/// outline keep some.
const FIRST_ITERATIONS: usize = 2;
/// Regularisation δ of the iterations that follow. With half of it descents get stuck; with twice as much folds cost too
/// little.
const REGULARISATION: f64 = 0.2;
/// Stiffness of the spring that holds a motion to its initial value, as a share of the area around its site: it decides where
/// the quadrature does not. With a fifth of it, bars that turn against each other distort more of what is between them; with
/// five times as much, everything bends stiffly.
const HOLD: f64 = 0.1;
/// Least area for [`HOLD`], as a share of the mean cell: a site of little influence stays with its surroundings. With a
/// hundredth of it, a site between two bars may go anywhere, and folds what is between the nodes of the quadrature.
const LEAST: f64 = 0.2;
/// The descent ends with an iteration that lowers the energy by no more than this share: most poses take about five. With ten
/// times as much, drags jump by some pixels.
const GAIN: f64 = 2e-3;
/// Line searches end where the slope is this share of the initial one: the first low point of a line is far from its minimum.
/// With twice as much, a twisted cross jumps by five times as much as its handles move; the samples of a line hardly cost
/// more, as each is much closer than the last.
const CURVATURE_CONDITION: f64 = 0.015;
/// Iterations at most. With six, a twisted cross of 200 sites stays folded in places.
const MAX_ITERATIONS: usize = 8;

/// The part of a site's motion that the handles leave free.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) enum Freedom {
    /// All of it: a virtual site.
    Whole,
    /// The linear part: a point, unless its rotation is set.
    Linear,
    /// The image of the normal of this direction under the linear part: a bar. It makes no difference on the bar itself.
    Across(DVec2),
    /// Nothing: a polygon keeps its inside, and a held outline stays in place.
    None,
}

/// Posed place of a site, and the columns of its linear part; lengths in [units](Relaxation::unit).
type Parts = [DVec2; 3];

/// The blended map's distortion as a function of the unknowns. Lengths are in [units](Relaxation::unit).
#[derive(Debug, Clone)]
pub(super) struct Relaxation {
    freedom: Vec<Freedom>,
    /// The first unknown of each site.
    first: Vec<u32>,
    /// Rest place of each site.
    rest: Vec<DVec2>,
    nodes: Vec<Node>,
    terms: Vec<Term>,
    /// Unit of length, in pixels: the square root of the mean cell's area.
    unit: f64,
    /// Stiffness of the spring that holds each unknown.
    hold: Vec<f64>,
    inverse: Cholesky,
}

#[derive(Debug, Clone)]
struct Node {
    at: DVec2,
    area: f64,
    /// End of its terms; they begin at the end of the previous node's.
    end: u32,
    /// Number of its terms that belong to sites without freedom; these come first.
    fixed: u32,
}

/// The influence of a site at a node.
#[derive(Debug, Clone)]
struct Term {
    site: u32,
    weight: f64,
    gradient: DVec2,
}

impl Freedom {
    /// The unknowns of a site, each as the factors of its value in the three parts.
    fn factors(self) -> impl Iterator<Item = [f64; 3]> {
        let all = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let (list, from, to) = match self {
            Self::Whole => (all, 0, 3),
            Self::Linear => (all, 1, 3),
            Self::Across(along) => ([[0.0, -along.y, along.x]; 3], 0, 1),
            Self::None => (all, 0, 0),
        };
        list.into_iter().take(to).skip(from)
    }
}

impl Relaxation {
    pub(super) fn new(quadrature: &Quadrature, rest: &[DVec2], freedom: &[Freedom]) -> Self {
        let all: Vec<_> = quadrature.nodes().collect();
        let mean = (all.iter().map(|(_, area, _)| area).sum::<f64>() / rest.len() as f64).max(f64::MIN_POSITIVE);
        let unit = mean.sqrt();
        let rest: Vec<DVec2> = rest.iter().map(|&rest| rest / unit).collect();
        let (mut nodes, mut terms, mut around) = (Vec::new(), Vec::new(), vec![0.0; rest.len()]);
        for (at, area, mut influences) in all {
            influences.sort_by_key(|one| freedom[one.site] != Freedom::None);
            let fixed = influences.iter().filter(|one| freedom[one.site] == Freedom::None).count();
            influences.iter().for_each(|one| around[one.site] += one.weight * area);
            if fixed < influences.len() {
                terms.extend(influences.iter().map(|one| Term {
                    site: one.site as u32,
                    weight: one.weight,
                    gradient: unit * one.gradient,
                }));
                nodes.push(Node { at: at / unit, area, end: terms.len() as u32, fixed: fixed as u32 });
            }
        }
        let (mut first, mut hold, mut groups) = (Vec::new(), Vec::new(), Vec::new());
        for (freedom, around) in freedom.iter().zip(around) {
            let from = hold.len() as u32;
            first.push(from);
            // A place that is off by one cell counts as much as a linear part that is off by one.
            hold.extend(freedom.factors().map(|_| HOLD * f64::max(around, LEAST * mean)));
            if hold.len() as u32 > from {
                groups.push((from..hold.len() as u32).collect());
            }
        }
        let mut lower: BTreeMap<(u32, u32), f64> = hold.iter().zip(0..).map(|(&hold, at)| ((at, at), hold)).collect();
        let mut columns: Vec<(u32, DVec2)> = Vec::new();
        for (node, terms) in with_terms(&nodes, &terms) {
            columns.clear();
            for term in &terms[node.fixed as usize..] {
                let site = term.site as usize;
                let of_parts = term.of_parts(node.at - rest[site]);
                let value = |factors: [f64; 3]| -> DVec2 { (0..3).map(|k| of_parts[k] * factors[k]).sum() };
                columns.extend((first[site]..).zip(freedom[site].factors().map(value)));
            }
            for &(i, by_i) in &columns {
                for &(j, by_j) in columns.iter().filter(|(j, _)| *j <= i) {
                    *lower.entry((i, j)).or_default() += node.area * by_i.dot(by_j);
                }
            }
        }
        let inverse = Cholesky::new(&groups, &lower);
        Self { freedom: freedom.to_vec(), first, rest, nodes, terms, unit, hold, inverse }
    }

    /// Lowers the distortion of motions. `is_free` says for each site whether its rotation is free, `scales` are those
    /// requested at the sites; the descent ends with an iteration that moves no site by more than `settled` pixels.
    pub(super) fn settle(&self, motions: &mut [Motion], is_free: &[bool], scales: &[f64], settled: f64) {
        if self.hold.is_empty() {
            return;
        }
        let mut parts: Vec<Parts> = Vec::with_capacity(motions.len());
        for (motion, &rest) in motions.iter().zip(&self.rest) {
            let linear = motion.linear();
            parts.push([rest + motion.translation / self.unit, linear.x_axis, linear.y_axis]);
        }
        let mut relaxing = Relaxing::new(self, &parts, is_free, scales);
        let solve = |values: &mut [DVec2]| {
            self.inverse.solve(values);
            self.keep(is_free, values);
        };
        for (regularisation, max_iterations) in
            [(FIRST_REGULARISATION, FIRST_ITERATIONS), (REGULARISATION, MAX_ITERATIONS - FIRST_ITERATIONS)]
        {
            relaxing.set_regularisation(regularisation);
            let limits = Limits {
                max_iterations,
                settled: settled / self.unit,
                gain: GAIN,
                curvature_condition: CURVATURE_CONDITION,
            };
            descend(&mut relaxing, self.hold.len(), solve, limits);
        }
        // Handles may be posed so far out that numbers overflow: the result of the graph is kept then.
        if !relaxing.unknown().iter().all(|by| by.is_finite()) {
            return;
        }
        self.expand(relaxing.unknown(), |site, by| {
            for (part, by) in parts[site].iter_mut().zip(by) {
                *part += by;
            }
        });
        for (site, motion) in motions.iter_mut().enumerate() {
            let [place, x, y] = parts[site];
            let map = DMat2::from_cols(x, y);
            match self.freedom[site] {
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

    /// The freedom of each site, and its first unknown.
    fn unknowns(&self) -> impl Iterator<Item = (Freedom, usize)> {
        self.freedom.iter().zip(&self.first).map(|(&freedom, &first)| (freedom, first as usize))
    }

    /// Sets the unknowns of points whose rotation is set to 0.
    fn keep(&self, is_free: &[bool], values: &mut [DVec2]) {
        for ((freedom, first), &is_free) in self.unknowns().zip(is_free) {
            if freedom == Freedom::Linear && !is_free {
                values[first..first + 2].fill(DVec2::ZERO);
            }
        }
    }

    /// Calls `visit` with the parts of each free site that the unknowns stand for.
    fn expand(&self, unknown: &[DVec2], mut visit: impl FnMut(usize, Parts)) {
        for (site, (freedom, first)) in self.unknowns().enumerate() {
            let by = &unknown[first..];
            match freedom {
                Freedom::Whole => visit(site, [by[0], by[1], by[2]]),
                Freedom::Linear => visit(site, [DVec2::ZERO, by[0], by[1]]),
                Freedom::Across(along) => visit(site, [DVec2::ZERO, -along.y * by[0], along.x * by[0]]),
                Freedom::None => {}
            }
        }
    }

    /// The gradient with respect to the unknowns, from that with respect to the parts.
    fn gather(&self, forces: impl Fn(usize) -> Parts, gradient: &mut [DVec2]) {
        for (site, (freedom, first)) in self.unknowns().enumerate() {
            let to = &mut gradient[first..];
            match freedom {
                Freedom::Whole => to[..3].copy_from_slice(&forces(site)),
                Freedom::Linear => to[..2].copy_from_slice(&forces(site)[1..]),
                Freedom::Across(along) => {
                    let [_, x, y] = forces(site);
                    to[0] = along.x * y - along.y * x;
                }
                Freedom::None => {}
            }
        }
    }
}

/// Each node with its terms.
fn with_terms<'a>(nodes: &'a [Node], terms: &'a [Term]) -> impl Iterator<Item = (&'a Node, &'a [Term])> {
    let mut start = 0;
    nodes.iter().map(move |node| {
        let terms = &terms[start..node.end as usize];
        start = node.end as usize;
        (node, terms)
    })
}

impl Term {
    /// Derivatives of the Jacobian's columns with respect to each part, at an offset from the site.
    fn of_parts(&self, offset: DVec2) -> [DVec2; 3] {
        let Self { weight, gradient, .. } = *self;
        [gradient, offset.x * gradient + DVec2::new(weight, 0.0), offset.y * gradient + DVec2::new(0.0, weight)]
    }
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
