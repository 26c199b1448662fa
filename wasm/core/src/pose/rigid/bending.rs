//! Deforms the cell graph as rigidly as possible (Sorkine and Alexa 2007), using only the sites.
//!
//! The motions minimise Σ w_ij |(p_i − p_j) − s_i R_i (h_i − h_j)|² over the links, each counted from both ends. The
//! scales s_i are those that handles request, harmonic in between. Real sites follow their handles, and keep a rotation
//! that the user set. For given positions, the best rotations have a closed form, so the energy depends only on the
//! positions; a [descent](descend) on the factorised Laplacian minimises it.

use glam::DVec2;

use super::super::{
    Motion,
    motion::turn,
    numeric::{Jet, Laplacian, Limits, Objective, descend},
};

/// Maximum number of iterations of the graph: twice as many as an unrolled spiral of 200 sites needs.
const MAX_ITERATIONS: usize = 120;

/// Line searches end where the slope is this fraction of the initial slope: nearly always at the step that the
/// Laplacian suggests.
const CURVATURE_CONDITION: f64 = 0.9;

/// Deforms the graph until no site moves by more than `tolerance`. `is_free` states for each site whether its rotation
/// is free. `scales` are the requested scales at the sites.
pub(super) fn bend(
    laplacian: &Laplacian,
    links: impl Iterator<Item = (usize, usize, f64)>,
    rest: &[DVec2],
    motions: &mut [Motion],
    is_free: &[bool],
    scales: &[f64],
    tolerance: f64,
) {
    let free = &laplacian.free;
    if free.is_empty() {
        return;
    }
    let mut bending = Bending::new(free, links, rest, motions, is_free, scales);
    let solve = |values: &mut [DVec2]| laplacian.inverse.solve(values);
    let limits =
        Limits { max_iterations: MAX_ITERATIONS, tolerance, gain: 0.0, curvature_condition: CURVATURE_CONDITION };
    descend(&mut bending, free.len(), solve, limits);
    for (site, motion) in motions.iter_mut().enumerate() {
        motion.translation = bending.posed[site] - rest[site];
        if is_free[site] {
            motion.angle = libm::atan2(bending.rotations[site].y, bending.rotations[site].x);
        }
    }
}

/// A link of one pose.
struct Edge {
    sites: [usize; 2],
    weight: f64,
    /// The edge at rest, scaled as either end requests, times the weight.
    rest: [DVec2; 2],
}

/// A pose of the cell graph under descent.
struct Bending<'a> {
    edges: Vec<Edge>,
    /// Sites that move: the unknowns.
    free: &'a [u32],
    posed: Vec<DVec2>,
    /// Derivative of the positions along the direction.
    direction: Vec<DVec2>,
    /// Cosine and sine of each site's rotation.
    rotations: Vec<DVec2>,
    /// Torque on each site as a complex number, Σ (rest edge)* · (posed edge), and its derivative along the direction.
    torques: Vec<[DVec2; 2]>,
    /// Σ w |p_i − p_j|² along the direction: coefficients of a polynomial in the length.
    lengths: [f64; 3],
    forces: Vec<DVec2>,
    is_free: &'a [bool],
}

impl<'a> Bending<'a> {
    /// Begins at the positions of motions, with the rotations that fit these best.
    fn new(
        free: &'a [u32],
        links: impl Iterator<Item = (usize, usize, f64)>,
        rest: &[DVec2],
        motions: &[Motion],
        is_free: &'a [bool],
        scales: &[f64],
    ) -> Self {
        let edge = |(i, j, weight): (usize, usize, f64)| {
            let at_rest = rest[j] - rest[i];
            Edge { sites: [i, j], weight, rest: [i, j].map(|site| weight * scales[site] * at_rest) }
        };
        let mut bending = Self {
            edges: links.map(edge).collect(),
            free,
            posed: rest.iter().zip(motions).map(|(&h, motion)| h + motion.translation).collect(),
            direction: vec![DVec2::ZERO; rest.len()],
            rotations: motions.iter().map(|motion| turn(motion.angle)).collect(),
            torques: vec![[DVec2::ZERO; 2]; rest.len()],
            lengths: [0.0; 3],
            forces: vec![DVec2::ZERO; rest.len()],
            is_free,
        };
        bending.set_direction(&vec![DVec2::ZERO; free.len()]);
        bending.advance(0.0);
        bending
    }
}

/// A quarter of the energy at the best rotations, up to a constant. The Laplacian is its Hessian as long as no rotation
/// changes.
impl Objective for Bending<'_> {
    fn set_direction(&mut self, direction: &[DVec2]) -> Jet {
        for (&site, &by) in self.free.iter().zip(direction) {
            self.direction[site as usize] = by;
        }
        self.torques.fill([DVec2::ZERO; 2]);
        self.lengths = [0.0; 3];
        for &Edge { sites: [i, j], weight, rest } in &self.edges {
            let (after, by) = (self.posed[j] - self.posed[i], self.direction[j] - self.direction[i]);
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
        self.along_line(0.0)
    }

    fn along_line(&mut self, length: f64) -> Jet {
        let mut sample = Jet::of_polynomial(self.lengths, length);
        for ((&[torque, change], &turn), &is_free) in self.torques.iter().zip(&self.rotations).zip(self.is_free) {
            let torque = torque + length * change;
            let strength = torque.length();
            if is_free && strength > 0.0 {
                // As in the other branch, at the best rotation: torque / strength.
                let inverse = 1.0 / strength;
                let (along, across) = (inverse * torque.dot(change), inverse * torque.perp_dot(change));
                let second = inverse * across * across;
                sample.value -= strength;
                sample.first -= along;
                sample.second -= second;
                sample.third += 3.0 * inverse * along * second;
            } else {
                sample.value -= turn.dot(torque);
                sample.first -= turn.dot(change);
            }
        }
        sample.map(|value| value / 2.0)
    }

    fn advance(&mut self, length: f64) {
        for (posed, by) in self.posed.iter_mut().zip(&self.direction) {
            *posed += length * by;
        }
        for ((turn, &[torque, change]), &is_free) in self.rotations.iter_mut().zip(&self.torques).zip(self.is_free) {
            *turn = turned(*turn, torque + length * change, is_free);
        }
    }

    fn gradient(&mut self, gradient: &mut [DVec2]) {
        self.forces.fill(DVec2::ZERO);
        for &Edge { sites: [i, j], weight, rest } in &self.edges {
            let turned = (self.rotations[i].rotate(rest[0]) + self.rotations[j].rotate(rest[1])) / 2.0;
            let force = weight * (self.posed[j] - self.posed[i]) - turned;
            self.forces[i] -= force;
            self.forces[j] += force;
        }
        for (&site, gradient) in self.free.iter().zip(gradient) {
            *gradient = self.forces[site as usize];
        }
    }
}

/// The best rotation. A site without links, or with links of zero length, keeps its own rotation.
fn turned(turn: DVec2, torque: DVec2, is_free: bool) -> DVec2 {
    if is_free { torque.try_normalize().unwrap_or(turn) } else { turn }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energy_along_a_line_matches_its_derivatives() {
        let rest = [(0.0, 0.0), (10.0, 1.0), (12.0, 9.0), (-1.0, 11.0)].map(DVec2::from);
        let motion = |k: usize| Motion::similarity(0.0, 1.0, DVec2::new(k as f64, 3.0 - k as f64), 0.0);
        let motions: Vec<Motion> = (0..4).map(motion).collect();
        let links = [(0, 1, 1.0), (1, 2, 0.7), (2, 3, 0.5), (0, 2, 0.2), (1, 3, 0.4)].into_iter();
        // One rotation is set, one site does not move.
        let (is_free, scales) = ([true, true, true, false], [1.0, 1.2, 1.0, 0.8]);
        let mut bending = Bending::new(&[0, 1, 3], links, &rest, &motions, &is_free, &scales);
        bending.set_direction(&[(2.0, -1.0), (-3.0, 5.0), (1.0, 4.0)].map(DVec2::from));
        for length in [0.0, 0.6, -1.5] {
            Jet::assert_slopes(|length| bending.along_line(length), length, 1e-6);
        }
    }
}
