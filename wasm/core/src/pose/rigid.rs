//! The rigid pose mode: virtual sites move so that the picture distorts as little as it can.
//!
//! First the cell graph bends: as-rigid-as-possible (Sorkine and Alexa 2007) on the sites alone. The motions minimise
//! Σ w_ij |(p_i − p_j) − s_i R_i (h_i − h_j)|² over the links, each from both its ends. The scales s_i are those that handles
//! ask for, harmonic between them. Real sites stay where the handles are, with their rotation where the person set one. The
//! rotations that fit given places best have a closed form, so the energy is one of the places alone; it is lowered by
//! [`descent`](super::descent) on the factorised Laplacian.
//!
//! From there the picture itself is [relaxed](super::relaxation): it needs no rotations from the person, bends as a limb bends, and
//! folds only where it must. Points of a cloud are all there is between its sites, so a cloud keeps what its graph says.
//!
//! All begins at the harmonic pose, so a pose depends on nothing but the handles: not on the way they were dragged there.

use std::sync::OnceLock;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::{
    Motion, Quadrature,
    descent::{Landscape, Limits, View, descend},
    laplacian::Laplacian,
    motion::turn,
    relaxation::{Freedom, Relaxation},
};

/// A turn that moves no site by more than this share of the scene's extent is the last of the graph's: a tenth of a pixel. What
/// is relaxed from a pixel away is hardly worse, but jumps when a drag makes the graph take one turn more or less.
const BENT: f64 = 1e-4;
/// The same where nothing is relaxed: a ten-thousandth of a pixel.
const SETTLED: f64 = 1e-7;
/// The same of relaxing: a hundredth of a pixel.
const RELAXED: f64 = 1e-5;
/// Turns of the graph at most: twice as many as 200 sites of an unrolled spiral take.
const TURNS: usize = 120;

/// A step ends where the energy falls by no more than this share of what it fell by at its start: nearly always where the Laplacian says.
const LEVEL: f64 = 0.9;

/// How sites hang together, and the picture between them.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Rigid {
    links: Vec<(u32, u32, f64)>,
    freedom: Vec<Freedom>,
    quadrature: Option<Quadrature>,
    /// Made when the first pose asks for it: it is several times the size of the links, and as quickly made as read.
    #[serde(skip)]
    laplacian: OnceLock<Laplacian>,
    /// Likewise.
    #[serde(skip)]
    relaxation: OnceLock<Relaxation>,
}

/// A link of one pose.
struct Edge {
    sites: [usize; 2],
    weight: f64,
    /// The edge at rest, as large as either site asks, times the weight.
    rest: [DVec2; 2],
}

impl Rigid {
    pub(super) fn new(
        freedom: Vec<Freedom>,
        links: impl Iterator<Item = (usize, usize, f64)>,
        quadrature: Option<Quadrature>,
    ) -> Self {
        let links = links.map(|(i, j, weight)| (i as u32, j as u32, weight)).collect();
        Self { links, freedom, quadrature, laplacian: OnceLock::new(), relaxation: OnceLock::new() }
    }

    /// Whether it is made for so many sites: to be asked of what came from elsewhere.
    pub(super) fn is_whole(&self, sites: usize) -> bool {
        let known = |&(i, j, weight): &(u32, u32, f64)| i < j && (j as usize) < sites && (0.0..=1.0).contains(&weight);
        self.freedom.len() == sites
            && self.links.iter().all(known)
            && self.quadrature.as_ref().is_none_or(|quadrature| quadrature.is_whole(sites))
    }

    /// The links, with their weights.
    pub(super) fn links(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone {
        self.links.iter().map(|&(i, j, weight)| (i as usize, j as usize, weight))
    }

    /// Takes the harmonic motions to rigid ones. `is_free` tells of each site whether its rotation is to be found, `scales` how large
    /// things are to be around it.
    pub(super) fn settle(&self, rest: &[DVec2], motions: &mut [Motion], is_free: &[bool], scales: &[f64]) {
        if rest.is_empty() {
            return;
        }
        let (low, high) = rest.iter().fold((rest[0], rest[0]), |(low, high), &h| (low.min(h), high.max(h)));
        let extent = (high - low).length();
        let relaxation = self
            .quadrature
            .as_ref()
            .map(|quadrature| self.relaxation.get_or_init(|| Relaxation::new(quadrature, rest, &self.freedom)));
        let bent = if relaxation.is_some() { BENT } else { SETTLED };
        self.bend(rest, motions, is_free, scales, bent * extent);
        if let Some(relaxation) = relaxation {
            relaxation.settle(motions, is_free, scales, RELAXED * extent);
        }
    }

    /// Lets the graph bend until no site moves by more than `settled`.
    fn bend(&self, rest: &[DVec2], motions: &mut [Motion], is_free: &[bool], scales: &[f64], settled: f64) {
        let is_real = || self.freedom.iter().map(|freedom| *freedom != Freedom::Whole).collect::<Vec<_>>();
        let laplacian = self.laplacian.get_or_init(|| Laplacian::new(&is_real(), self.links()));
        let free = &laplacian.free;
        if free.is_empty() {
            return;
        }
        let edge = |(i, j, weight): (usize, usize, f64)| {
            let at_rest = rest[j] - rest[i];
            Edge { sites: [i, j], weight, rest: [i, j].map(|site| weight * scales[site] * at_rest) }
        };
        let mut bending = Bending {
            edges: self.links().map(edge).collect(),
            free,
            posed: rest.iter().zip(&*motions).map(|(&h, motion)| h + motion.translation).collect(),
            by: vec![DVec2::ZERO; rest.len()],
            turns: motions.iter().map(|motion| turn(motion.angle)).collect(),
            torques: vec![[DVec2::ZERO; 2]; rest.len()],
            lengths: [0.0; 3],
            forces: vec![DVec2::ZERO; rest.len()],
            is_free,
        };
        // To the rotations that fit the places at the start.
        bending.face(&vec![DVec2::ZERO; free.len()]);
        bending.go(0.0);
        let solve = |values: &mut [DVec2]| laplacian.inverse.solve(values);
        descend(&mut bending, free.len(), solve, Limits { turns: TURNS, settled, gain: 0.0, level: LEVEL });
        for (site, motion) in motions.iter_mut().enumerate() {
            motion.translation = bending.posed[site] - rest[site];
            if is_free[site] {
                motion.angle = libm::atan2(bending.turns[site].y, bending.turns[site].x);
            }
        }
    }
}

/// A pose on the way to its least energy.
struct Bending<'a> {
    edges: Vec<Edge>,
    /// Sites that move.
    free: &'a [u32],
    posed: Vec<DVec2>,
    /// How places change along the direction.
    by: Vec<DVec2>,
    /// Cosine and sine of each site's rotation.
    turns: Vec<DVec2>,
    /// What turns each site, and how that changes along the direction.
    torques: Vec<[DVec2; 2]>,
    /// Σ w |p_i − p_j|² along the direction: a polynomial of the length.
    lengths: [f64; 3],
    forces: Vec<DVec2>,
    is_free: &'a [bool],
}

/// A quarter of the energy with the rotations that fit places best, less a constant. The Laplacian is its second derivative as long as
/// no rotation changes.
impl Landscape for Bending<'_> {
    fn face(&mut self, by: &[DVec2]) {
        for (&site, &by) in self.free.iter().zip(by) {
            self.by[site as usize] = by;
        }
        self.torques.fill([DVec2::ZERO; 2]);
        self.lengths = [0.0; 3];
        for &Edge { sites: [i, j], weight, rest } in &self.edges {
            let (after, by) = (self.posed[j] - self.posed[i], self.by[j] - self.by[i]);
            self.lengths[0] += weight * after.length_squared();
            self.lengths[1] += 2.0 * weight * after.dot(by);
            self.lengths[2] += weight * by.length_squared();
            // The same from both ends: both edges change their sign.
            for (site, before) in [(i, rest[0]), (j, rest[1])] {
                let [torque, change] = &mut self.torques[site];
                *torque += DVec2::new(before.dot(after), before.perp_dot(after));
                *change += DVec2::new(before.dot(by), before.perp_dot(by));
            }
        }
    }

    fn look(&self, length: f64) -> View {
        let mut view = View::of_polynomial(self.lengths, length);
        for ((&[torque, change], &turn), &is_free) in self.torques.iter().zip(&self.turns).zip(self.is_free) {
            let torque = torque + length * change;
            let strength = torque.length();
            if is_free && strength > 0.0 {
                // As below, with the turn that fits best: torque ÷ strength.
                let inverse = 1.0 / strength;
                let across = inverse * torque.perp_dot(change);
                view.height -= strength;
                view.slope -= inverse * torque.dot(change);
                view.curvature -= inverse * across * across;
            } else {
                view.height -= turn.dot(torque);
                view.slope -= turn.dot(change);
            }
        }
        View { height: view.height / 2.0, slope: view.slope / 2.0, curvature: view.curvature / 2.0 }
    }

    fn go(&mut self, length: f64) {
        for (posed, by) in self.posed.iter_mut().zip(&self.by) {
            *posed += length * by;
        }
        for ((turn, &[torque, change]), &is_free) in self.turns.iter_mut().zip(&self.torques).zip(self.is_free) {
            *turn = turned(*turn, torque + length * change, is_free);
        }
    }

    fn gradient(&mut self, gradient: &mut [DVec2]) {
        self.forces.fill(DVec2::ZERO);
        for &Edge { sites: [i, j], weight, rest } in &self.edges {
            let turned = (self.turns[i].rotate(rest[0]) + self.turns[j].rotate(rest[1])) / 2.0;
            let force = weight * (self.posed[j] - self.posed[i]) - turned;
            self.forces[i] -= force;
            self.forces[j] += force;
        }
        for (&site, gradient) in self.free.iter().zip(gradient) {
            *gradient = self.forces[site as usize];
        }
    }
}

/// The rotation that fits best. A site without links, or whose links have shrunk to nothing, keeps its own.
fn turned(turn: DVec2, torque: DVec2, is_free: bool) -> DVec2 {
    if is_free { torque.try_normalize().unwrap_or(turn) } else { turn }
}
