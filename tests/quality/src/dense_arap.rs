//! The reference method: as-rigid-as-possible over the whole mesh.
//!
//! It minimises Σ area · |J − R|² over the triangles, with one rotation R per triangle (Liu et al. 2008, after Sorkine
//! and Alexa 2007). Unlike one rotation per vertex, this is the energy of the piecewise linear map itself. Two steps
//! alternate: rotations in closed form, and positions by a factored Laplacian with cotangent weights. Vertices on
//! handles are pinned.
//!
//! Limits:
//! - A pinned vertex is a singular constraint. On a finer mesh it costs less to move the pin alone, and the energy
//!   concentrates around it. So the reference is valid only on the common mesh.
//! - There may be several minima. The method finds one near its start.

use faer::{
    Mat, Side,
    prelude::{Reborrow, ReborrowMut, Solve},
    sparse::{SparseColMat, Triplet, linalg::solvers::Llt},
};
use glam::DVec2;

use crate::{comparison_mesh::ComparisonMesh, constraints::Constraints};

/// The iteration stops if the energy decreases by less than this fraction.
const TOLERANCE: f64 = 1e-9;
/// The largest number of iterations.
const MAX_ITERATIONS: usize = 20_000;

/// A mesh with pinned vertices and a factored Laplacian.
#[derive(Debug)]
pub struct DenseArap<'a> {
    mesh: &'a ComparisonMesh,
    /// The row of each free vertex.
    row: Vec<Option<u32>>,
    free: Vec<u32>,
    /// Half the cotangent of the angle at each corner of each triangle.
    cotangents: Vec<[f64; 3]>,
    factors: Option<Llt<usize, f64>>,
}

/// A minimum of the energy.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// Posed positions of the vertices.
    pub posed: Vec<DVec2>,
    /// The number of iterations.
    pub iterations: usize,
    /// Σ area · |J − R|².
    pub energy: f64,
    /// The energy after each iteration.
    pub descent: Vec<f64>,
}

impl<'a> DenseArap<'a> {
    /// Pins the vertices that have a target.
    #[must_use]
    pub fn new(mesh: &'a ComparisonMesh, pins: &[Option<DVec2>]) -> Self {
        let free: Vec<u32> = (0..mesh.vertices.len() as u32).filter(|&v| pins[v as usize].is_none()).collect();
        let mut row = vec![None; mesh.vertices.len()];
        free.iter().zip(0..).for_each(|(&v, at)| row[v as usize] = Some(at));
        let cotangents: Vec<[f64; 3]> = (0..mesh.triangles.len())
            .map(|t| {
                let p = mesh.corners(t, &mesh.vertices);
                [0, 1, 2].map(|k| {
                    let (to, from) = (p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
                    to.dot(from) / to.perp_dot(from) / 2.0
                })
            })
            .collect();
        let mut dense = Self { mesh, row, free, cotangents, factors: None };
        dense.factors = dense.factorize();
        dense
    }

    fn factorize(&self) -> Option<Llt<usize, f64>> {
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

    /// Returns the half-edges: two vertices, the weight and the triangle.
    pub(crate) fn edges(&self) -> impl Iterator<Item = (usize, usize, f64, usize)> + '_ {
        self.mesh.triangles.iter().zip(&self.cotangents).enumerate().flat_map(|(t, (corners, weights))| {
            (0..3).map(move |k| (corners[(k + 1) % 3] as usize, corners[(k + 2) % 3] as usize, weights[k], t))
        })
    }

    /// Returns the start of the iteration: displacements that are harmonic over the mesh.
    #[must_use]
    pub fn harmonic(&self, pins: &[Option<DVec2>]) -> Vec<DVec2> {
        let mut posed: Vec<DVec2> = self.mesh.vertices.iter().zip(pins).map(|(&p, pin)| pin.unwrap_or(p)).collect();
        self.solve_positions(&mut posed, &vec![DVec2::X; self.mesh.triangles.len()]);
        posed
    }

    /// Iterates from `start` until the energy stops decreasing.
    #[must_use]
    pub fn minimize(&self, start: &[DVec2]) -> Minimum {
        let mut posed = start.to_vec();
        let mut rotations = vec![DVec2::X; self.mesh.triangles.len()];
        let mut energy = self.fit_rotations(&posed, &mut rotations);
        let mut descent = Vec::new();
        while descent.len() < MAX_ITERATIONS {
            self.solve_positions(&mut posed, &rotations);
            let lower = self.fit_rotations(&posed, &mut rotations);
            descent.push(lower);
            let gain = energy - lower;
            energy = lower;
            if gain <= TOLERANCE * energy {
                break;
            }
        }
        Minimum { posed, iterations: descent.len(), energy, descent }
    }

    /// Fits the rotation of each triangle to the positions, and returns the energy.
    pub(crate) fn fit_rotations(&self, posed: &[DVec2], rotations: &mut [DVec2]) -> f64 {
        let mut energy = 0.0;
        for (t, rotation) in rotations.iter_mut().enumerate() {
            let (before, after) = (self.mesh.corners(t, &self.mesh.vertices), self.mesh.corners(t, posed));
            let (mut turn, mut squares) = (DVec2::ZERO, 0.0);
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let (before, after, weight) = (before[j] - before[i], after[j] - after[i], self.cotangents[t][k]);
                turn += weight * DVec2::new(before.dot(after), before.perp_dot(after));
                squares += weight * (before.length_squared() + after.length_squared());
            }
            // A triangle that has collapsed keeps its rotation.
            *rotation = turn.try_normalize().unwrap_or(*rotation);
            energy += squares - 2.0 * turn.dot(*rotation);
        }
        energy
    }

    /// Solves for the positions of the free vertices that fit the rotations best.
    fn solve_positions(&self, posed: &mut [DVec2], rotations: &[DVec2]) {
        let Some(factors) = &self.factors else { return };
        let mut right = Mat::<f64>::zeros(self.free.len(), 2);
        for (i, j, weight, t) in self.edges() {
            let gradient = weight * rotations[t].rotate(self.mesh.vertices[i] - self.mesh.vertices[j]);
            for (here, there, gradient) in [(i, j, gradient), (j, i, -gradient)] {
                if let Some(row) = self.row[here] {
                    let pinned = if self.row[there].is_none() { weight * posed[there] } else { DVec2::ZERO };
                    right[(row as usize, 0)] += gradient.x + pinned.x;
                    right[(row as usize, 1)] += gradient.y + pinned.y;
                }
            }
        }
        factors.solve_in_place(right.rb_mut());
        for (&v, row) in self.free.iter().zip(0..) {
            posed[v as usize] = DVec2::new(right[(row, 0)], right[(row, 1)]);
        }
    }
}

/// Returns the target of each pinned vertex.
#[must_use]
pub fn pins(mesh: &ComparisonMesh, constraints: &Constraints) -> Vec<Option<DVec2>> {
    let on_outline = mesh.on_outline();
    mesh.vertices.iter().zip(on_outline).map(|(&p, on)| constraints.target(p, on)).collect()
}
