//! Motions that distort the picture itself as little as they can.
//!
//! The sites alone do not show what a blend does between them. But the blended map is linear in the places and linear parts of the sites
//! (eq. 1), and so is its derivative J at a place of the [quadrature](super::Quadrature), as in fast automatic skinning (Jacobson,
//! Baran, Kavan, Popović and Sorkine 2012). Minimised is Σ area · [`distortion`](super::distortion)(J ÷ s), s the scale
//! that is asked for there, over all that the handles leave free: see [`Freedom`].
//!
//! [`descent`](super::descent) does it, on the factorised matrix of Σ area |J|². Along a line J is linear in the length, so det J
//! and |J|² are polynomials of it, and the lowest place is found without going through sites again: see `relaxing`. It begins
//! where the cell graph alone settles: see [`rigid`](super::rigid). Cost: some 0.15 ms a turn for 200 sites.

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

/// Softness of the first turns: so soft that what has turned over at the start comes back in them.
const SOFT: f64 = 0.5;
/// How many these are. Without them a twisted cross of 200 sites keeps twice as many folds, and bars beside a held outline some.
const SOFT_TURNS: usize = 2;
/// Softness of those that follow. With half of it descents get stuck, with twice as much folds cost too little.
const HARD: f64 = 0.2;
/// How much a motion is held to where it began, as a share of the area around its site: it decides where the quadrature does
/// not. With a fifth of it, bars that turn against each other distort more of what is between them; with five times as much, all
/// bends stiffly.
const HOLD: f64 = 0.1;
/// Least share of a cell for [`HOLD`]: what little depends on stays with its surroundings. With a hundredth of it, a site between two bars
/// may go anywhere, and folds what is between the places of the quadrature.
const LEAST: f64 = 0.2;
/// A turn that lowers the energy by no more than this share of it is the last: most poses take some five. With ten times as much,
/// drags jump by some pixels.
const GAIN: f64 = 2e-3;
/// A step ends where the energy falls by no more than this share of what it fell by at its start: the first low place along a line
/// is far from its lowest. With twice as much, a cross that is twisted jumps by five times as much as its handles move; looks
/// hardly cost more, as each comes much closer than the last.
const LEVEL: f64 = 0.015;
/// Turns at most. With six, a twisted cross of 200 sites stays folded in places.
const TURNS: usize = 8;

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

/// Place of a site, and the columns of its linear part, in units.
type Parts = [DVec2; 3];

/// The blended map's distortion as a function of what is free. Lengths are in [units](Relaxation::unit).
#[derive(Debug, Clone)]
pub(super) struct Relaxation {
    freedom: Vec<Freedom>,
    /// The first unknown of each site.
    first: Vec<u32>,
    /// Of each site.
    rest: Vec<DVec2>,
    nodes: Vec<Node>,
    terms: Vec<Term>,
    /// The root of the mean cell's area, in pixels.
    unit: f64,
    /// How much each unknown is held.
    hold: Vec<f64>,
    inverse: Cholesky,
}

#[derive(Debug, Clone)]
struct Node {
    at: DVec2,
    area: f64,
    /// Where its terms end; they begin where those of the node before end.
    end: u32,
    /// How many of its terms are of sites that have no freedom: they come first.
    fixed: u32,
}

/// A site at a node.
#[derive(Debug, Clone)]
struct Term {
    site: u32,
    weight: f64,
    gradient: DVec2,
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
            // A place one cell away is as bad as a linear part off by one.
            hold.extend(freedom.factors().map(|_| HOLD * f64::max(around, LEAST * mean)));
            if hold.len() as u32 > from {
                groups.push((from..hold.len() as u32).collect());
            }
        }
        let mut lower: BTreeMap<(u32, u32), f64> = hold.iter().zip(0..).map(|(&hold, at)| ((at, at), hold)).collect();
        let mut columns: Vec<(u32, DVec2)> = Vec::new();
        for (node, terms) in seen(&nodes, &terms) {
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

    /// Lowers the distortion of motions. `is_free` tells of each site whether its rotation is to be found, `scales` how large things are to
    /// be around it; a turn that moves no site by more than `settled` pixels is the last.
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
        for (softness, turns) in [(SOFT, SOFT_TURNS), (HARD, TURNS - SOFT_TURNS)] {
            relaxing.soften(softness);
            let limits = Limits { turns, settled: settled / self.unit, gain: GAIN, level: LEVEL };
            descend(&mut relaxing, self.hold.len(), solve, limits);
        }
        // Handles may be posed beyond all measure: what the graph makes of that is left as it is.
        if !relaxing.unknown().iter().all(|by| by.is_finite()) {
            return;
        }
        self.spread(relaxing.unknown(), |site, by| {
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

    /// Tells what the unknowns make of each site's parts.
    fn spread(&self, unknown: &[DVec2], mut tell: impl FnMut(usize, Parts)) {
        for (site, (freedom, first)) in self.unknowns().enumerate() {
            let by = &unknown[first..];
            match freedom {
                Freedom::Whole => tell(site, [by[0], by[1], by[2]]),
                Freedom::Linear => tell(site, [DVec2::ZERO, by[0], by[1]]),
                Freedom::Across(along) => tell(site, [DVec2::ZERO, -along.y * by[0], along.x * by[0]]),
                Freedom::None => {}
            }
        }
    }

    /// The gradient by unknowns from that by parts.
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
fn seen<'a>(nodes: &'a [Node], terms: &'a [Term]) -> impl Iterator<Item = (&'a Node, &'a [Term])> {
    let mut start = 0;
    nodes.iter().map(move |node| {
        let terms = &terms[start..node.end as usize];
        start = node.end as usize;
        (node, terms)
    })
}

impl Term {
    /// What each part makes of the derivative's first and second column, this far from the site.
    fn of_parts(&self, offset: DVec2) -> [DVec2; 3] {
        let Self { weight, gradient, .. } = *self;
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
