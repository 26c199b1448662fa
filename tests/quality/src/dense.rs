//! The reference: as-rigid-as-possible over the whole mesh.
//!
//! Minimises Σ area · |J − R|² over the triangles, R a rotation for each (Liu et al. 2008, after Sorkine and Alexa 2007: with
//! one rotation a triangle in place of one a vertex the energy is that of the piecewise linear map itself). Two steps take
//! turns: rotations in closed form, places by a factored Laplacian with cotangent weights. Vertices on handles are pinned.
//!
//! A limit: a pinned vertex is a singular constraint. The finer the mesh, the less it costs to leave everything but the pin
//! where it was, and the more of the energy sits in the triangles around the pin. So it is a reference for one mesh, on which
//! everything is compared. And there may be several minima: it ends in one near its start.

use faer::{
    Mat, Side,
    prelude::{Reborrow, ReborrowMut, Solve},
    sparse::{SparseColMat, Triplet, linalg::solvers::Llt},
};
use glam::DVec2;

use crate::{fine::Fine, targets::Targets};

/// A turn that lowers the energy by less than this share of it is the last.
const SETTLED: f64 = 1e-9;
/// Turns at most.
const TURNS: usize = 20_000;

/// A mesh with its pins, ready for any pose of them.
#[derive(Debug)]
pub struct Dense<'a> {
    fine: &'a Fine,
    /// Row of each free vertex.
    row: Vec<Option<u32>>,
    free: Vec<u32>,
    /// Half the cotangent of the angle at each corner of each triangle.
    cotangents: Vec<[f64; 3]>,
    factors: Option<Llt<usize, f64>>,
}

/// Where the reference took the vertices.
#[derive(Debug, Clone)]
pub struct Settled {
    /// Posed places.
    pub posed: Vec<DVec2>,
    /// Turns it took.
    pub turns: usize,
    /// Σ area · |J − R|².
    pub energy: f64,
    /// The energy after each turn.
    pub descent: Vec<f64>,
}

impl<'a> Dense<'a> {
    /// Pins the vertices that handles demand.
    #[must_use]
    pub fn new(fine: &'a Fine, pins: &[Option<DVec2>]) -> Self {
        let free: Vec<u32> = (0..fine.vertices.len() as u32).filter(|&v| pins[v as usize].is_none()).collect();
        let mut row = vec![None; fine.vertices.len()];
        free.iter().zip(0..).for_each(|(&v, at)| row[v as usize] = Some(at));
        let cotangents: Vec<[f64; 3]> = (0..fine.triangles.len())
            .map(|t| {
                let p = fine.corners(t, &fine.vertices);
                [0, 1, 2].map(|k| {
                    let (to, from) = (p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
                    to.dot(from) / to.perp_dot(from) / 2.0
                })
            })
            .collect();
        let mut dense = Self { fine, row, free, cotangents, factors: None };
        dense.factors = dense.factored();
        dense
    }

    fn factored(&self) -> Option<Llt<usize, f64>> {
        let mut entries = Vec::new();
        for (i, j, weight, _) in self.edges() {
            let (i, j) = (self.row[i], self.row[j]);
            for (here, there) in [(i, j), (j, i)] {
                if let Some(here) = here {
                    entries.push(Triplet::new(here as usize, here as usize, weight));
                    if let Some(there) = there {
                        entries.push(Triplet::new(here as usize, there as usize, -weight));
                    }
                }
            }
        }
        let matrix = SparseColMat::try_new_from_triplets(self.free.len(), self.free.len(), &entries).ok()?;
        matrix.rb().sp_cholesky(Side::Lower).ok()
    }

    /// Half-edges: two vertices, the weight, the triangle.
    pub(crate) fn edges(&self) -> impl Iterator<Item = (usize, usize, f64, usize)> + '_ {
        self.fine.triangles.iter().zip(&self.cotangents).enumerate().flat_map(|(t, (corners, weights))| {
            (0..3).map(move |k| (corners[(k + 1) % 3] as usize, corners[(k + 2) % 3] as usize, weights[k], t))
        })
    }

    /// The start: displacements that are harmonic over the mesh.
    #[must_use]
    pub fn harmonic(&self, pins: &[Option<DVec2>]) -> Vec<DVec2> {
        let mut posed: Vec<DVec2> = self.fine.vertices.iter().zip(pins).map(|(&p, pin)| pin.unwrap_or(p)).collect();
        self.place(&mut posed, &vec![DVec2::X; self.fine.triangles.len()]);
        posed
    }

    /// Takes turns from a start until the energy has settled.
    #[must_use]
    pub fn settled(&self, start: &[DVec2]) -> Settled {
        let mut posed = start.to_vec();
        let mut rotations = vec![DVec2::X; self.fine.triangles.len()];
        let mut energy = self.rotate(&posed, &mut rotations);
        let mut descent = Vec::new();
        while descent.len() < TURNS {
            self.place(&mut posed, &rotations);
            let lower = self.rotate(&posed, &mut rotations);
            descent.push(lower);
            let gain = energy - lower;
            energy = lower;
            if gain <= SETTLED * energy {
                break;
            }
        }
        Settled { posed, turns: descent.len(), energy, descent }
    }

    /// The rotation of every triangle that fits the places best. Returns the energy that is left.
    pub(crate) fn rotate(&self, posed: &[DVec2], rotations: &mut [DVec2]) -> f64 {
        let mut energy = 0.0;
        for (t, rotation) in rotations.iter_mut().enumerate() {
            let (before, after) = (self.fine.corners(t, &self.fine.vertices), self.fine.corners(t, posed));
            let (mut turn, mut squares) = (DVec2::ZERO, 0.0);
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let (before, after, weight) = (before[j] - before[i], after[j] - after[i], self.cotangents[t][k]);
                turn += weight * DVec2::new(before.dot(after), before.perp_dot(after));
                squares += weight * (before.length_squared() + after.length_squared());
            }
            // What has shrunk to nothing keeps its rotation.
            *rotation = turn.try_normalize().unwrap_or(*rotation);
            energy += squares - 2.0 * turn.dot(*rotation);
        }
        energy
    }

    /// The places of the free vertices that fit the rotations best.
    fn place(&self, posed: &mut [DVec2], rotations: &[DVec2]) {
        let Some(factors) = &self.factors else { return };
        let mut right = Mat::<f64>::zeros(self.free.len(), 2);
        for (i, j, weight, t) in self.edges() {
            let pull = weight * rotations[t].rotate(self.fine.vertices[i] - self.fine.vertices[j]);
            for (here, there, pull) in [(i, j, pull), (j, i, -pull)] {
                if let Some(row) = self.row[here] {
                    let pinned = if self.row[there].is_none() { weight * posed[there] } else { DVec2::ZERO };
                    right[(row as usize, 0)] += pull.x + pinned.x;
                    right[(row as usize, 1)] += pull.y + pinned.y;
                }
            }
        }
        factors.solve_in_place(right.rb_mut());
        for (&v, row) in self.free.iter().zip(0..) {
            posed[v as usize] = DVec2::new(right[(row, 0)], right[(row, 1)]);
        }
    }
}

/// Where each vertex is pinned, if it is.
#[must_use]
pub fn pins(fine: &Fine, targets: &Targets) -> Vec<Option<DVec2>> {
    let on_outline = fine.on_outline();
    fine.vertices.iter().zip(on_outline).map(|(&p, on)| targets.demanded(p, on)).collect()
}
