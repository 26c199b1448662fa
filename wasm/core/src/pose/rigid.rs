//! The rigid pose mode: virtual sites move so that the cell graph bends as rigidly as it can.
//!
//! As-rigid-as-possible (Sorkine and Alexa 2007) on the sites alone: the motions minimise
//! Σ w_ij |(p_i − p_j) − s_i R_i (h_i − h_j)|² over the links, each from both its ends. Real sites stay where the handles are,
//! with their rotation where the person set one. It needs no rotations from the person, and bends a limb as a limb bends.
//!
//! Two steps take turns: the rotations that fit the places best, in closed form; the places that fit the rotations best, by the
//! Laplacian. They begin at the harmonic pose, so a pose depends on nothing but the handles. Cost: 200 sites take some ten
//! microseconds a turn.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::{Motion, laplacian::Laplacian};

/// Turns at most. Bending a strip by three pins takes some sixty to settle within [`SETTLED`].
const TURNS: usize = 120;
/// A turn that moves no site by more than this share of the scene's extent is the last: a thousandth of a pixel.
const SETTLED: f64 = 1e-6;

/// Residual of the places in one turn: finer than [`SETTLED`], which the turns have to reach in the end.
const PRECISION: f64 = 1e-9;

/// The links between sites, and the matrix of their global step.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Rigid {
    links: Vec<(u32, u32, f64)>,
    laplacian: Laplacian,
}

impl Rigid {
    pub(super) fn new(is_real: &[bool], links: impl Iterator<Item = (usize, usize, f64)> + Clone) -> Self {
        let laplacian = Laplacian::new(is_real, links.clone());
        Self { links: links.map(|(i, j, weight)| (i as u32, j as u32, weight)).collect(), laplacian }
    }

    /// Whether every index is one of so many sites: to be asked of what came from elsewhere.
    pub(super) fn is_whole(&self, sites: usize) -> bool {
        let known = |site: u32| (site as usize) < sites;
        self.links.iter().all(|&(i, j, _)| known(i) && known(j)) && self.laplacian.is_whole(sites)
    }

    /// Takes the harmonic motions to rigid ones. `is_free` tells of each site whether its rotation is to be found.
    pub(super) fn settle(&self, rest: &[DVec2], motions: &mut [Motion], is_free: &[bool]) {
        let free = &self.laplacian.free;
        if free.is_empty() {
            return;
        }
        let mut posed: Vec<DVec2> = rest.iter().zip(&*motions).map(|(&h, motion)| h + motion.translation).collect();
        let scale: Vec<f64> = motions.iter().map(|motion| libm::exp(motion.strain.mean())).collect();
        let turn = |(motion, &scale): (&Motion, &f64)| {
            let (sin, cos) = libm::sincos(motion.angle);
            scale * DVec2::new(cos, sin)
        };
        let mut linear: Vec<DVec2> = motions.iter().zip(&scale).map(turn).collect();
        let (low, high) = rest.iter().fold((rest[0], rest[0]), |(low, high), &h| (low.min(h), high.max(h)));
        let settled = SETTLED * (high - low).length();
        for _ in 0..TURNS {
            self.fit_rotations(rest, &posed, &scale, &mut linear, is_free);
            if self.fit_places(rest, &linear, &mut posed) <= settled {
                break;
            }
        }
        self.fit_rotations(rest, &posed, &scale, &mut linear, is_free);
        for (site, motion) in motions.iter_mut().enumerate() {
            motion.translation = posed[site] - rest[site];
            if is_free[site] {
                motion.angle = libm::atan2(linear[site].y, linear[site].x);
            }
        }
    }

    /// The rotation at each free site that takes its links at rest nearest to where they are. A site without links, or whose
    /// links have shrunk to nothing, keeps its own.
    fn fit_rotations(&self, rest: &[DVec2], posed: &[DVec2], scale: &[f64], linear: &mut [DVec2], is_free: &[bool]) {
        let mut turns = vec![DVec2::ZERO; rest.len()];
        for &(i, j, weight) in &self.links {
            let (i, j) = (i as usize, j as usize);
            let (before, after) = (rest[j] - rest[i], posed[j] - posed[i]);
            // The same from both ends: both edges change their sign.
            let turn = weight * DVec2::new(before.dot(after), before.perp_dot(after));
            turns[i] += turn;
            turns[j] += turn;
        }
        for (site, turn) in turns.into_iter().enumerate().filter(|&(site, _)| is_free[site]) {
            if let Some(rotation) = turn.try_normalize() {
                linear[site] = scale[site] * rotation;
            }
        }
    }

    /// The places of the virtual sites that fit all rotations best. Tells how far any of them moved.
    fn fit_places(&self, rest: &[DVec2], linear: &[DVec2], posed: &mut [DVec2]) -> f64 {
        let mut pull = vec![DVec2::ZERO; rest.len()];
        for &(i, j, weight) in &self.links {
            let (i, j) = (i as usize, j as usize);
            let edge = weight * ((linear[i] + linear[j]) / 2.0).rotate(rest[i] - rest[j]);
            pull[i] += edge;
            pull[j] -= edge;
        }
        let laplacian = &self.laplacian;
        let mut right: Vec<DVec2> = laplacian.free.iter().map(|&site| pull[site as usize]).collect();
        for &(real, row, weight) in &laplacian.boundary {
            right[row as usize] += weight * posed[real as usize];
        }
        let solved = |axis: fn(&DVec2) -> f64| {
            let right: Vec<f64> = right.iter().map(axis).collect();
            let mut x: Vec<f64> = laplacian.free.iter().map(|&site| axis(&posed[site as usize])).collect();
            laplacian.solve(&right, &mut x, PRECISION);
            x
        };
        let (x, y) = (solved(|p| p.x), solved(|p| p.y));
        let mut moved = 0.0_f64;
        for (&site, (x, y)) in laplacian.free.iter().zip(x.into_iter().zip(y)) {
            let place = DVec2::new(x, y);
            moved = moved.max(place.distance(posed[site as usize]));
            posed[site as usize] = place;
        }
        moved
    }
}
