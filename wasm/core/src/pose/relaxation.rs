//! Motions that distort the picture itself as little as they can.
//!
//! The sites alone do not show what a blend does between them. But the blended map is linear in the places and linear parts of the sites
//! (eq. 1), and so is its derivative J at a place of the [quadrature](super::Quadrature), as in fast automatic skinning (Jacobson,
//! Baran, Kavan, Popović and Sorkine 2012). Minimised is Σ area · [`distortion`](super::distortion)(J S⁻¹), S the stretch
//! that is expected there, over all that the handles leave free: see [`Freedom`].
//!
//! [`descent`](super::descent) does it, on the factorised matrix of Σ area |J|². It begins where the cell graph alone settles: see
//! [`rigid`](super::rigid). Cost: see [`WORK`].

use std::{collections::BTreeMap, f64::consts::TAU};

use glam::{DMat2, DVec2};
use serde::{Deserialize, Serialize};

use super::{Motion, Quadrature, cholesky::Cholesky, descent::descend, distortion::Distortion, motion::polar};

/// Softness of the first turns: so soft that what has turned over at the start comes back in them.
const SOFT: f64 = 0.5;
/// How many these are. Without them close handles and bars stay folded for ten turns; with more, handles that fold a thin strip
/// find another way to fold it.
const SOFT_TURNS: usize = 2;
/// Softness of those that follow. With twice as much, folds cost too little; with a quarter of it, descents get stuck.
const HARD: f64 = 0.2;
/// How much a motion is held to where it began, as a share of the area around its site: it decides where the quadrature does
/// not. With less, bars that turn against each other may fold what is between them; with five times as much, all bends stiffly.
const HOLD: f64 = 0.2;
/// Least share of a cell for [`HOLD`]: what next to nothing depends on stays with its surroundings.
const LEAST: f64 = 1e-3;
/// Multiplications of all turns together, about: 100 sites take eight turns in 0.4 ms, 200 sites five in 0.6.
const WORK: usize = 2_500_000;
/// Turns at most: two thirds of poses have settled in five.
const TURNS: usize = 8;
/// Turns at least: the soft ones, and two to come to rest.
const LEAST_TURNS: usize = 4;

/// What of a site's motion the handles leave free.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) enum Freedom {
    /// All, of a virtual site.
    Whole,
    /// The linear part, of a point, unless its rotation is set.
    Linear,
    /// How the linear part takes the normal of this direction, of a bar: on the bar itself it makes no difference.
    Across(DVec2),
    /// Nothing: a polygon keeps its inside, and a held outline stays.
    None,
}

/// Place of a site, and the columns of its linear part times the [unit](Relaxation::unit).
type Parts = [DVec2; 3];

/// The blended map's distortion as a function of what is free.
#[derive(Debug, Clone)]
pub(super) struct Relaxation {
    freedom: Vec<Freedom>,
    /// The first unknown of each site.
    first: Vec<u32>,
    nodes: Vec<Node>,
    terms: Vec<Term>,
    /// Length that linear parts are counted in: then they are places, too.
    unit: f64,
    /// How much each unknown is held.
    hold: Vec<f64>,
    inverse: Cholesky,
    turns: usize,
}

#[derive(Debug, Clone)]
struct Node {
    area: f64,
    /// Where its terms end; they begin where those of the node before end.
    end: u32,
    /// How many of its terms are of sites that have no freedom: they come first.
    fixed: u32,
}

/// A site at a node. Lengths but the gradient's in units.
#[derive(Debug, Clone)]
struct Term {
    site: u32,
    /// From the site to the node.
    offset: DVec2,
    weight: f64,
    gradient: DVec2,
}

/// What a node sees in one pose.
#[derive(Debug, Clone, Copy)]
struct View {
    /// What sites without freedom make of the derivative.
    fixed: DMat2,
    /// What undoes the stretch that is expected.
    unstretch: DMat2,
    /// The derivative, and then its gradient.
    derivative: DMat2,
}

impl Freedom {
    /// Parts that are unknown, each as the factors of its value in the three parts of the site.
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
        let (mut nodes, mut terms, mut around) = (Vec::new(), Vec::new(), vec![0.0; rest.len()]);
        for (at, area, mut influences) in all {
            influences.sort_by_key(|one| freedom[one.site] != Freedom::None);
            let fixed = influences.iter().filter(|one| freedom[one.site] == Freedom::None).count();
            influences.iter().for_each(|one| around[one.site] += one.weight * area);
            if fixed < influences.len() {
                terms.extend(influences.iter().map(|one| Term {
                    site: one.site as u32,
                    offset: (at - rest[one.site]) / unit,
                    weight: one.weight / unit,
                    gradient: one.gradient,
                }));
                nodes.push(Node { area, end: terms.len() as u32, fixed: fixed as u32 });
            }
        }
        let (mut first, mut hold, mut groups) = (Vec::new(), Vec::new(), Vec::new());
        for (freedom, around) in freedom.iter().zip(around) {
            let from = hold.len() as u32;
            first.push(from);
            // A place one cell away is as bad as a linear part off by one.
            hold.extend(freedom.factors().map(|_| HOLD * f64::max(around, LEAST * mean) / mean));
            if hold.len() as u32 > from {
                groups.push((from..hold.len() as u32).collect());
            }
        }
        let mut lower: BTreeMap<(u32, u32), f64> = hold.iter().zip(0..).map(|(&hold, at)| ((at, at), hold)).collect();
        let mut start = 0;
        let mut columns: Vec<(u32, DVec2)> = Vec::new();
        for node in &nodes {
            columns.clear();
            for term in &terms[start + node.fixed as usize..node.end as usize] {
                let site = term.site as usize;
                let of_parts = term.of_parts();
                let value = |factors: [f64; 3]| -> DVec2 { (0..3).map(|k| of_parts[k] * factors[k]).sum() };
                columns.extend((first[site]..).zip(freedom[site].factors().map(value)));
            }
            for &(i, by_i) in &columns {
                for &(j, by_j) in columns.iter().filter(|(j, _)| *j <= i) {
                    *lower.entry((i, j)).or_default() += node.area * by_i.dot(by_j);
                }
            }
            start = node.end as usize;
        }
        let inverse = Cholesky::new(&groups, &lower);
        let work = 24 * terms.len() + 40 * nodes.len() + 4 * inverse.len();
        let turns = (WORK / work.max(1)).clamp(LEAST_TURNS, TURNS);
        Self { freedom: freedom.to_vec(), first, nodes, terms, unit, hold, inverse, turns }
    }

    /// Lowers the distortion of motions. `is_free` tells of each site whether its rotation is to be found, `stretch` what stretch it expects;
    /// a turn that moves no site by more than `settled` is the last.
    pub(super) fn settle(
        &self,
        rest: &[DVec2],
        motions: &mut [Motion],
        is_free: &[bool],
        stretch: &[DMat2],
        settled: f64,
    ) {
        if self.hold.is_empty() {
            return;
        }
        let mut parts: Vec<Parts> = Vec::with_capacity(rest.len());
        for (motion, &rest) in motions.iter().zip(rest) {
            let linear = motion.linear();
            parts.push([rest + motion.translation, self.unit * linear.x_axis, self.unit * linear.y_axis]);
        }
        let begin = parts.clone();
        let mut views = self.views(&parts, stretch);
        // Unknowns are counted from where they begin.
        let mut unknown = vec![DVec2::ZERO; self.hold.len()];
        let keep = |values: &mut [DVec2]| self.keep(is_free, values);
        let solve = |values: &mut [DVec2]| {
            self.inverse.solve(values);
            keep(values);
        };
        let mut forces = vec![[DVec2::ZERO; 3]; rest.len()];
        for (softness, turns) in [(SOFT, SOFT_TURNS), (HARD, self.turns - SOFT_TURNS)] {
            let distortion = Distortion::new(softness);
            descend(&mut unknown, solve, settled, turns, |unknown, gradient| {
                self.spread(unknown, &begin, &mut parts);
                let mut energy = self.energy(&distortion, &parts, &mut views, &mut forces);
                self.gather(&forces, gradient);
                for ((gradient, &hold), &unknown) in gradient.iter_mut().zip(&self.hold).zip(unknown) {
                    energy += hold / 2.0 * unknown.length_squared();
                    *gradient += hold * unknown;
                }
                keep(gradient);
                energy
            });
        }
        self.spread(&unknown, &begin, &mut parts);
        for (site, motion) in motions.iter_mut().enumerate() {
            let [place, x, y] = parts[site];
            let map = DMat2::from_cols(x, y) * (1.0 / self.unit);
            match self.freedom[site] {
                Freedom::Whole => {
                    motion.translation = place - rest[site];
                    (motion.angle, motion.strain) = polar(map);
                }
                Freedom::Linear if is_free[site] => (motion.angle, motion.strain) = polar(map),
                Freedom::Across(_) => bend_bone(motion, map),
                Freedom::Linear | Freedom::None => {}
            }
        }
    }

    /// What is free of each site, and its first unknown.
    fn unknowns(&self) -> impl Iterator<Item = (Freedom, usize)> {
        self.freedom.iter().zip(&self.first).map(|(&freedom, &first)| (freedom, first as usize))
    }

    /// Sets to 0 what belongs to points whose rotation is set.
    fn keep(&self, is_free: &[bool], values: &mut [DVec2]) {
        for ((freedom, first), &is_free) in self.unknowns().zip(is_free) {
            if freedom == Freedom::Linear && !is_free {
                values[first..first + 2].fill(DVec2::ZERO);
            }
        }
    }

    /// The parts of all sites when the unknowns have these values.
    fn spread(&self, unknown: &[DVec2], begin: &[Parts], parts: &mut [Parts]) {
        for (((freedom, first), begin), parts) in self.unknowns().zip(begin).zip(parts) {
            let by = &unknown[first..];
            match freedom {
                Freedom::Whole => *parts = [begin[0] + by[0], begin[1] + by[1], begin[2] + by[2]],
                Freedom::Linear => (parts[1], parts[2]) = (begin[1] + by[0], begin[2] + by[1]),
                Freedom::Across(along) => {
                    (parts[1], parts[2]) = (begin[1] - along.y * by[0], begin[2] + along.x * by[0]);
                }
                Freedom::None => {}
            }
        }
    }

    /// The gradient by unknowns from that by parts.
    fn gather(&self, forces: &[Parts], gradient: &mut [DVec2]) {
        for ((freedom, first), forces) in self.unknowns().zip(forces) {
            let to = &mut gradient[first..];
            match freedom {
                Freedom::Whole => to[..3].copy_from_slice(forces),
                Freedom::Linear => to[..2].copy_from_slice(&forces[1..]),
                Freedom::Across(along) => to[0] = along.x * forces[2] - along.y * forces[1],
                Freedom::None => {}
            }
        }
    }

    /// What nodes see of what does not change while the distortion falls.
    fn views(&self, parts: &[Parts], stretch: &[DMat2]) -> Vec<View> {
        let mut start = 0;
        let view = |node: &Node| {
            let terms = &self.terms[start..node.end as usize];
            start = node.end as usize;
            let expected = |sum, term: &Term| sum + stretch[term.site as usize] * (self.unit * term.weight);
            let fixed = |sum, term: &Term| sum + term.derivative(&parts[term.site as usize]);
            View {
                fixed: terms[..node.fixed as usize].iter().fold(DMat2::ZERO, fixed),
                unstretch: terms.iter().fold(DMat2::ZERO, expected).inverse(),
                derivative: DMat2::ZERO,
            }
        };
        self.nodes.iter().map(view).collect()
    }

    /// The energy, and its gradient by the parts of all sites.
    fn energy(&self, distortion: &Distortion, parts: &[Parts], views: &mut [View], forces: &mut [Parts]) -> f64 {
        let mut start = 0;
        for (node, view) in self.nodes.iter().zip(&mut *views) {
            let terms = &self.terms[start + node.fixed as usize..node.end as usize];
            start = node.end as usize;
            let add = |sum, term: &Term| sum + term.derivative(&parts[term.site as usize]);
            view.derivative = terms.iter().fold(view.fixed, add);
        }
        // By itself, as it is slow by latency: nodes do not wait for one another.
        let mut energy = 0.0;
        for (node, view) in self.nodes.iter().zip(&mut *views) {
            let (height, gradient) = distortion.of(view.derivative * view.unstretch);
            energy += node.area * height;
            view.derivative = gradient * view.unstretch.transpose() * node.area;
        }
        forces.fill([DVec2::ZERO; 3]);
        start = 0;
        for (node, view) in self.nodes.iter().zip(&*views) {
            let terms = &self.terms[start + node.fixed as usize..node.end as usize];
            start = node.end as usize;
            for term in terms {
                term.pull(view.derivative, &mut forces[term.site as usize]);
            }
        }
        energy
    }
}

impl Term {
    /// What the site makes of the derivative: T(p) ∇wᵀ + w T′.
    fn derivative(&self, &[place, x, y]: &Parts) -> DMat2 {
        let moved = place + self.offset.x * x + self.offset.y * y;
        DMat2::from_cols(self.gradient.x * moved + self.weight * x, self.gradient.y * moved + self.weight * y)
    }

    /// Adds to the gradient by the site's parts when that by the derivative is `gradient`.
    fn pull(&self, gradient: DMat2, forces: &mut Parts) {
        let pull = gradient * self.gradient;
        forces[0] += pull;
        forces[1] += self.offset.x * pull + self.weight * gradient.x_axis;
        forces[2] += self.offset.y * pull + self.weight * gradient.y_axis;
    }

    /// What each part makes of the derivative's first and second column.
    fn of_parts(&self) -> [DVec2; 3] {
        let Self { offset, weight, gradient, .. } = *self;
        [gradient, offset.x * gradient + DVec2::new(weight, 0.0), offset.y * gradient + DVec2::new(0.0, weight)]
    }
}

/// Gives the motion of a bone another map that does the same along the bone; one that no motion is, close to turning over, is left out.
fn bend_bone(motion: &mut Motion, map: DMat2) {
    let (angle, strain) = polar(map);
    let turns = libm::round((motion.angle - angle) / TAU);
    let found = Motion { angle: angle + TAU * turns, strain, ..*motion };
    if found.linear().abs_diff_eq(map, ROUNDING * (map.x_axis.length() + map.y_axis.length())) {
        *motion = found;
    }
}

/// What a map may change by when it is written as a motion, relatively: above rounding, and too little to see on a bar.
const ROUNDING: f64 = 1e-12;
