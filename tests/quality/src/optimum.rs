//! The optimum: the least symmetric Dirichlet energy of the piecewise linear map, with the vertices on handles pinned.
//!
//! It is found by Newton's method with the Hessian of each triangle projected to be positive (Teran et al. 2005), by
//! the eigensystem of Smith, de Goes and Kim (2019). No step turns a triangle over (Smith and Schaefer 2015). There may
//! be several minima, so it starts from several poses, and the lowest minimum counts.

use faer::{
    Mat, Side,
    prelude::{Reborrow, ReborrowMut, Solve},
    sparse::{SparseColMat, Triplet, linalg::solvers::Llt},
};
use glam::{DMat2, DVec2};

use crate::comparison_mesh::ComparisonMesh;

/// Iterations of one descent at most.
const MAX_ITERATIONS: usize = 400;
/// A descent ends with a decrease by less than this fraction of the energy.
const TOLERANCE: f64 = 1e-7;
/// Iterations after each step on the way from rest.
const STEP_ITERATIONS: usize = 4;
/// Steps from rest to the pose, if no triangle gets in the way.
const STEPS: f64 = 12.0;
/// Steps from rest at most.
const MAX_STEPS: usize = 120;
/// The fraction of the way to the first collapsed triangle that a step takes at most.
const SAFE: f64 = 0.8;
/// Sufficient decrease (Armijo).
const DECREASE: f64 = 1e-4;
/// Halvings of a step at most.
const MAX_HALVINGS: usize = 40;

/// A mesh with pinned vertices.
#[derive(Debug)]
pub struct Optimizer<'a> {
    mesh: &'a ComparisonMesh,
    pins: &'a [Option<DVec2>],
    /// The first row of each free vertex.
    row: Vec<Option<usize>>,
    rows: usize,
    /// For each triangle, the gradients of the barycentric coordinates of its corners.
    gradients: Vec<[DVec2; 3]>,
}

/// A minimum of the energy.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// Posed positions of the vertices.
    pub posed: Vec<DVec2>,
    /// Σ area · (|J|² + |J⁻¹|² − 4).
    pub energy: f64,
}

impl<'a> Optimizer<'a> {
    /// Pins the vertices that have a target.
    #[must_use]
    pub fn new(mesh: &'a ComparisonMesh, pins: &'a [Option<DVec2>]) -> Self {
        let mut rows = 0;
        let row = |pin: &Option<DVec2>| {
            pin.is_none().then(|| {
                rows += 2;
                rows - 2
            })
        };
        let row = pins.iter().map(row).collect();
        let gradients = (0..mesh.triangles.len())
            .map(|t| {
                let p = mesh.corners(t, &mesh.vertices);
                [0, 1, 2].map(|k| (p[(k + 2) % 3] - p[(k + 1) % 3]).perp() / (2.0 * mesh.areas[t]))
            })
            .collect();
        Self { mesh, pins, row, rows, gradients }
    }

    /// The lowest minimum from these starts and from a path that moves the pins from rest in steps. Starts with a
    /// triangle that is turned over are left out. `None` if nothing is left: the pins may force a fold.
    #[must_use]
    pub fn lowest(&self, starts: &[&[DVec2]]) -> Option<Minimum> {
        let given = starts.iter().filter_map(|start| {
            let pinned: Vec<DVec2> = start.iter().zip(self.pins).map(|(&p, pin)| pin.unwrap_or(p)).collect();
            self.minimize(pinned)
        });
        given.chain(self.from_rest()).min_by(|a, b| a.energy.total_cmp(&b.energy))
    }

    /// The minimum near a start; `None` if the start has a triangle that is turned over.
    #[must_use]
    pub fn minimize(&self, mut posed: Vec<DVec2>) -> Option<Minimum> {
        let energy = self.descend(&mut posed, MAX_ITERATIONS)?;
        Some(Minimum { posed, energy })
    }

    /// The minimum at the end of a path from rest.
    #[must_use]
    pub fn from_rest(&self) -> Option<Minimum> {
        let mut posed = self.mesh.vertices.clone();
        let mut left = 1.0;
        for _ in 0..MAX_STEPS {
            let wanted = f64::min(left, 1.0 / STEPS);
            let by: Vec<Option<DVec2>> =
                self.pins.iter().zip(&posed).map(|(pin, &p)| pin.map(|pin| wanted / left * (pin - p))).collect();
            let direction = self.newton_step(&posed, Some(&by))?;
            let most = self.longest_step(&posed, &direction);
            let share = if most > 1.0 / SAFE { 1.0 } else { SAFE * most };
            for (p, by) in posed.iter_mut().zip(&direction) {
                *p += share * by;
            }
            left -= share * wanted;
            if left < 1e-9 {
                for (p, pin) in posed.iter_mut().zip(self.pins) {
                    *p = pin.unwrap_or(*p);
                }
                return self.minimize(posed);
            }
            self.descend(&mut posed, STEP_ITERATIONS)?;
        }
        None
    }

    fn descend(&self, posed: &mut [DVec2], iterations: usize) -> Option<f64> {
        let mut energy = self.energy(posed)?;
        for _ in 0..iterations {
            let Some(direction) = self.newton_step(posed, None) else { break };
            let slope: f64 = self.force(posed).iter().zip(&direction).map(|(f, d)| -f.dot(*d)).sum();
            let mut length = f64::min(1.0, 0.95 * self.longest_step(posed, &direction));
            let mut found = None;
            for _ in 0..MAX_HALVINGS {
                let next: Vec<DVec2> = posed.iter().zip(&direction).map(|(p, d)| *p + length * d).collect();
                match self.energy(&next) {
                    Some(lower) if lower <= energy + DECREASE * length * slope => {
                        found = Some((next, lower));
                        break;
                    }
                    _ => length /= 2.0,
                }
            }
            let Some((next, lower)) = found else { break };
            let gain = energy - lower;
            posed.copy_from_slice(&next);
            energy = lower;
            if gain <= TOLERANCE * energy {
                break;
            }
        }
        Some(energy)
    }

    /// The energy; `None` if a triangle is turned over.
    fn energy(&self, posed: &[DVec2]) -> Option<f64> {
        let mut sum = 0.0;
        for t in 0..self.gradients.len() {
            let j = self.jacobian(t, posed);
            let det = j.determinant();
            if det.is_nan() || det <= 0.0 {
                return None;
            }
            let square = j.x_axis.length_squared() + j.y_axis.length_squared();
            sum += self.mesh.areas[t] * (square * (1.0 + 1.0 / (det * det)) - 4.0);
        }
        Some(sum)
    }

    fn jacobian(&self, t: usize, posed: &[DVec2]) -> DMat2 {
        let corners = self.mesh.corners(t, posed);
        let outer = |p: DVec2, g: DVec2| DMat2::from_cols(g.x * p, g.y * p);
        let [a, b, c] = [0, 1, 2].map(|k| outer(corners[k], self.gradients[t][k]));
        a + b + c
    }

    /// Minus the gradient.
    fn force(&self, posed: &[DVec2]) -> Vec<DVec2> {
        let mut force = vec![DVec2::ZERO; posed.len()];
        for t in 0..self.gradients.len() {
            let stress = Local::of(self.jacobian(t, posed)).stress();
            for (k, &v) in self.mesh.triangles[t].iter().enumerate() {
                force[v as usize] -= self.mesh.areas[t] * (stress * self.gradients[t][k]);
            }
        }
        force
    }

    /// The step of the projected Hessian. `moved` says how far pins move, and leaves the forces out.
    fn newton_step(&self, posed: &[DVec2], moved: Option<&[Option<DVec2>]>) -> Option<Vec<DVec2>> {
        let mut entries = Vec::with_capacity(self.gradients.len() * 21);
        let mut right = Mat::<f64>::zeros(self.rows, 1);
        if moved.is_none() {
            for (force, row) in self.force(posed).iter().zip(&self.row) {
                if let Some(row) = *row {
                    right[(row, 0)] = force.x;
                    right[(row + 1, 0)] = force.y;
                }
            }
        }
        for t in 0..self.gradients.len() {
            let corners = self.mesh.triangles[t].map(|v| v as usize);
            let local = Local::of(self.jacobian(t, posed));
            for (value, mode) in local.modes() {
                let columns: [DVec2; 3] = [0, 1, 2].map(|k| mode * self.gradients[t][k]);
                let value = value * self.mesh.areas[t];
                for (k, &v) in corners.iter().enumerate() {
                    let Some(row) = self.row[v] else { continue };
                    for (l, &w) in corners.iter().enumerate() {
                        let block = [columns[k].x, columns[k].y].map(|a| [a * columns[l].x, a * columns[l].y]);
                        match (self.row[w], moved.and_then(|moved| moved[w])) {
                            (Some(column), _) => {
                                for (a, line) in block.iter().enumerate() {
                                    for (b, entry) in line.iter().enumerate() {
                                        if column + b <= row + a {
                                            entries.push(Triplet::new(row + a, column + b, value * entry));
                                        }
                                    }
                                }
                            }
                            (None, Some(by)) => {
                                for (a, line) in block.iter().enumerate() {
                                    right[(row + a, 0)] -= value * (line[0] * by.x + line[1] * by.y);
                                }
                            }
                            (None, None) => {}
                        }
                    }
                }
            }
        }
        let matrix = SparseColMat::try_new_from_triplets(self.rows, self.rows, &entries).ok()?;
        let factors: Llt<usize, f64> = matrix.rb().sp_cholesky(Side::Lower).ok()?;
        factors.solve_in_place(right.rb_mut());
        let step = |(v, row): (usize, &Option<usize>)| match *row {
            Some(row) => DVec2::new(right[(row, 0)], right[(row + 1, 0)]),
            None => moved.and_then(|moved| moved[v]).unwrap_or_default(),
        };
        Some(self.row.iter().enumerate().map(step).collect())
    }

    /// The length along a direction at which the first triangle collapses.
    fn longest_step(&self, posed: &[DVec2], direction: &[DVec2]) -> f64 {
        let mut most = f64::INFINITY;
        for &triangle in &self.mesh.triangles {
            let [a, b, c] = triangle.map(|v| posed[v as usize]);
            let [da, db, dc] = triangle.map(|v| direction[v as usize]);
            let (u, v, du, dv) = (b - a, c - a, db - da, dc - da);
            let (zeroth, first, second) = (u.perp_dot(v), u.perp_dot(dv) + du.perp_dot(v), du.perp_dot(dv));
            most = most.min(first_root(zeroth, first, second));
        }
        most
    }
}

/// The least root above 0 of c + b t + a t², with c > 0.
fn first_root(c: f64, b: f64, a: f64) -> f64 {
    let root = b * b - 4.0 * a * c;
    if root < 0.0 {
        return f64::INFINITY;
    }
    let q = -(b + b.signum() * root.sqrt()) / 2.0;
    [q / a, c / q].into_iter().filter(|t| *t > 0.0).fold(f64::INFINITY, f64::min)
}

/// The energy of one Jacobian: its singular values and vectors.
struct Local {
    most: f64,
    least: f64,
    left: DMat2,
    right: DMat2,
}

impl Local {
    fn of(j: DMat2) -> Self {
        let (a, b, c, d) = (j.x_axis.x, j.y_axis.x, j.x_axis.y, j.y_axis.y);
        let (e, f, g, h) = ((a + d) / 2.0, (a - d) / 2.0, (c + b) / 2.0, (c - b) / 2.0);
        let (q, r) = (e.hypot(h), f.hypot(g));
        let (alpha, beta) = (g.atan2(f), h.atan2(e));
        let left = DMat2::from_angle(f64::midpoint(beta, alpha));
        let right = DMat2::from_angle((alpha - beta) / 2.0);
        Self { most: q + r, least: q - r, left, right }
    }

    fn slopes(&self) -> [f64; 2] {
        [self.most, self.least].map(|s| 2.0 * s - 2.0 / (s * s * s))
    }

    /// The derivative of the energy with respect to J.
    fn stress(&self) -> DMat2 {
        let [x, y] = self.slopes();
        self.left * DMat2::from_diagonal(DVec2::new(x, y)) * self.right.transpose()
    }

    /// Eigenvalues of the Hessian, at least 0, with their directions.
    fn modes(&self) -> [(f64, DMat2); 4] {
        let [x, y] = self.slopes();
        let (s, t) = (self.most, self.least);
        let direction = |m: DMat2| self.left * m * self.right.transpose();
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let flip = 2.0 + 2.0 * (s * s + s * t + t * t) / (s * s * s * t * t * t);
        [
            (2.0 + 6.0 / s.powi(4), direction(DMat2::from_diagonal(DVec2::X))),
            (2.0 + 6.0 / t.powi(4), direction(DMat2::from_diagonal(DVec2::Y))),
            (((x + y) / (s + t)).max(0.0), direction(half * DMat2::from_cols(DVec2::Y, DVec2::NEG_X))),
            (flip, direction(half * DMat2::from_cols(DVec2::Y, DVec2::X))),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dense_arap::DenseArap;

    fn energy(j: DMat2) -> f64 {
        let det = j.determinant();
        (j.x_axis.length_squared() + j.y_axis.length_squared()) * (1.0 + 1.0 / (det * det)) - 4.0
    }

    #[test]
    fn stress_and_modes_are_derivatives_of_the_energy() {
        let j = DMat2::from_cols_array(&[1.3, 0.4, -0.2, 0.8]);
        let local = Local::of(j);
        let step = 1e-5;
        for k in 0..4 {
            let mut by = [0.0; 4];
            by[k] = step;
            let by = DMat2::from_cols_array(&by);
            let slope = (energy(j + by) - energy(j - by)) / (2.0 * step);
            assert!((slope - local.stress().to_cols_array()[k]).abs() < 1e-6, "{slope}");
        }
        for (value, mode) in local.modes() {
            let by = step * 10.0 * mode;
            let second = (energy(j + by) + energy(j - by) - 2.0 * energy(j)) / (100.0 * step * step);
            assert!(second < value + 1e-4 && (second - value).abs() < 1e-4 || value == 0.0, "{second} {value}");
        }
    }

    /// A square of 10 by 10 cells.
    fn square() -> ComparisonMesh {
        let at = |i: u32| DVec2::new(f64::from(i % 11), f64::from(i / 11));
        let cell = |i: u32| [[i, i + 1, i + 12], [i, i + 12, i + 11]];
        let triangles: Vec<[u32; 3]> = (0..110).filter(|i| i % 11 != 10).flat_map(cell).collect();
        ComparisonMesh { vertices: (0..121).map(at).collect(), areas: vec![0.5; triangles.len()], triangles }
    }

    #[test]
    fn turned_pins_turn_the_whole_mesh() {
        let mesh = square();
        let (middle, turn) = (DVec2::splat(5.0), DVec2::from_angle(0.8));
        let turned = |p: DVec2| middle + turn.rotate(p - middle);
        let pins: Vec<Option<DVec2>> = (0..121).map(|v| (v % 60 == 0).then(|| turned(mesh.vertices[v]))).collect();
        let found = Optimizer::new(&mesh, &pins).from_rest().expect("nothing folds");
        assert!(found.energy < 1e-6, "{}", found.energy);
        let error = found.posed.iter().zip(&mesh.vertices).map(|(p, &rest)| p.distance(turned(rest)));
        assert!(error.fold(0.0, f64::max) < 1e-3);
    }

    #[test]
    fn the_optimum_is_below_as_rigid_as_possible_and_does_not_fold() {
        let mesh = square();
        let moves = [(0, (0.0, 0.0)), (10, (10.0, 0.0)), (60, (7.5, 5.0)), (120, (10.0, 12.0))];
        let mut pins = vec![None; 121];
        moves.iter().for_each(|&(v, to)| pins[v as usize] = Some(DVec2::from(to)));
        let dense = DenseArap::new(&mesh, &pins);
        let rigid = dense.minimize(&dense.harmonic(&pins)).posed;
        let optimizer = Optimizer::new(&mesh, &pins);
        let lowest = optimizer.lowest(&[&rigid]).expect("nothing has to fold");
        assert!(optimizer.energy(&lowest.posed).is_some_and(|energy| energy == lowest.energy));
        assert!(optimizer.energy(&rigid).is_none_or(|energy| lowest.energy < energy));
    }

    #[test]
    fn pins_that_pass_through_each_other_have_no_optimum() {
        let mesh = square();
        let pins: Vec<Option<DVec2>> = mesh.vertices.iter().map(|p| Some(DVec2::new(-p.x, p.y))).collect();
        assert!(Optimizer::new(&mesh, &pins).lowest(&[]).is_none());
    }

    #[test]
    fn the_first_root_is_found() {
        assert!((first_root(1.0, -3.0, 2.0) - 0.5).abs() < 1e-12);
        assert!((first_root(1.0, 1.0, -2.0) - 1.0).abs() < 1e-12);
        assert_eq!(first_root(1.0, 1.0, 1.0), f64::INFINITY);
    }
}
