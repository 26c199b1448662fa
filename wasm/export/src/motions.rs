//! Motions of bones that move the vertices as close to their exact positions as fixed weights allow.
//!
//! With fixed weights, the positions are linear in the maps of the bones. So each pose is a least squares problem, and
//! all poses share one matrix. A slight pull towards the site's own motion determines bones with few vertices. Bones of
//! handles are held: they move exactly with the handles.
//!
//! Cost: one factorisation with three unknowns per bone, and a substitution for each pose.

use glam::{DAffine2, DMat2, DVec2};

use c2warp::weight::SparseWeights;

use crate::cholesky::Cholesky;

/// The pull towards the site's motion, relative to the mass of the vertices that the bone moves.
const PULL: f64 = 1e-3;
/// The pull for a bone that moves no vertex.
const LEAST_PULL: f64 = 1e-9;
/// The pull at the place of a held bone: far above the number of vertices, which have a pull of 1 at most.
const HOLD: f64 = 1e9;
/// Unknowns of a bone for each axis: two of the linear part, and a translation.
const UNKNOWNS: usize = 3;

/// The least squares problem of all poses.
#[derive(Debug)]
pub(crate) struct MotionFit {
    rest: Vec<DVec2>,
    /// For each vertex, its bones with the three factors of their unknowns.
    rows: Vec<Vec<(usize, [f64; UNKNOWNS])>>,
    factor: Cholesky,
}

impl MotionFit {
    /// Prepares the problem for bones at given rest positions. The first bone does not move. Held ones move with their
    /// sites.
    pub(crate) fn new(vertices: &[DVec2], weights: &SparseWeights, rest: &[DVec2], held: &[bool]) -> Self {
        let size = UNKNOWNS * rest.len().saturating_sub(1);
        let mut matrix = vec![0.0; size * size];
        let mut mass = vec![0.0; rest.len()];
        let mut spread = vec![0.0; rest.len()];
        let rows: Vec<Vec<(usize, [f64; UNKNOWNS])>> = vertices
            .iter()
            .enumerate()
            .map(|(vertex, &p)| {
                let moving = weights.row(vertex).filter(|&(bone, _)| bone > 0);
                let factors = |(bone, w): (usize, f64)| {
                    let q: DVec2 = p - rest[bone];
                    mass[bone] += w * w;
                    spread[bone] += w * w * q.length_squared() / 2.0;
                    (bone, [w * q.x, w * q.y, w])
                };
                moving.map(factors).collect()
            })
            .collect();
        for row in &rows {
            for (bone, a) in row {
                for (other, b) in row {
                    for (i, a) in a.iter().enumerate() {
                        for (j, b) in b.iter().enumerate() {
                            matrix[(UNKNOWNS * (bone - 1) + i) * size + UNKNOWNS * (other - 1) + j] += a * b;
                        }
                    }
                }
            }
        }
        for bone in 1..rest.len() {
            for (i, pull) in [spread[bone], spread[bone], mass[bone]].into_iter().enumerate() {
                let at = UNKNOWNS * (bone - 1) + i;
                matrix[at * size + at] += PULL * pull + LEAST_PULL;
            }
            if held[bone] {
                let at = UNKNOWNS * bone - 1;
                matrix[at * size + at] += HOLD;
            }
        }
        Self { rest: rest.to_vec(), rows, factor: Cholesky::new(size, &matrix) }
    }

    /// The maps of all bones in a pose, from those of their sites and the exact positions of the vertices.
    pub(crate) fn fitted(
        &self,
        sites: &[DAffine2],
        vertices: &[DVec2],
        weights: &SparseWeights,
        targets: &[DVec2],
    ) -> Vec<DAffine2> {
        let mut unknowns = [vec![0.0; self.size()], vec![0.0; self.size()]];
        for (vertex, row) in self.rows.iter().enumerate() {
            let off = targets[vertex] - blended(sites, vertices[vertex], weights.row(vertex));
            for (bone, factors) in row {
                for (i, factor) in factors.iter().enumerate() {
                    let at = UNKNOWNS * (bone - 1) + i;
                    unknowns[0][at] += factor * off.x;
                    unknowns[1][at] += factor * off.y;
                }
            }
        }
        unknowns.iter_mut().for_each(|x| self.factor.solve(x));
        let fitted = |(bone, site): (usize, &DAffine2)| {
            let Some(at) = bone.checked_sub(1).map(|bone| UNKNOWNS * bone) else { return *site };
            let pair = |i: usize| DVec2::new(unknowns[0][at + i], unknowns[1][at + i]);
            let linear = DMat2::from_cols(pair(0), pair(1));
            DAffine2 {
                matrix2: site.matrix2 + linear,
                translation: site.translation + pair(2) - linear * self.rest[bone],
            }
        };
        sites.iter().enumerate().map(fitted).collect()
    }

    fn size(&self) -> usize {
        UNKNOWNS * self.rest.len().saturating_sub(1)
    }
}

/// The position of a vertex by linear blend skinning.
pub(crate) fn blended(maps: &[DAffine2], p: DVec2, weights: impl Iterator<Item = (usize, f64)>) -> DVec2 {
    weights.map(|(bone, weight)| weight * maps[bone].transform_point2(p)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bone_motions_move_vertices_to_their_positions() {
        let vertices = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(DVec2::from);
        let weights = SparseWeights::from_parts((0..=4).collect(), vec![1; 4], vec![1.0; 4]).unwrap();
        let rest = [DVec2::ZERO, DVec2::new(5.0, 5.0)];
        let truth =
            DAffine2 { matrix2: DMat2::from_cols_array(&[1.2, 0.3, -0.1, 0.9]), translation: DVec2::new(3.0, -2.0) };
        let targets = vertices.map(|p| truth.transform_point2(p));
        let fit = MotionFit::new(&vertices, &weights, &rest, &[false; 2]);
        let found = fit.fitted(&[DAffine2::IDENTITY; 2], &vertices, &weights, &targets);
        assert_eq!(found[0], DAffine2::IDENTITY);
        for (p, target) in vertices.iter().zip(targets) {
            assert!(found[1].transform_point2(*p).distance(target) < 0.02);
        }
    }

    #[test]
    fn the_place_of_a_held_bone_goes_with_its_site() {
        let vertices = [(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)].map(DVec2::from);
        let weights = SparseWeights::from_parts((0..=3).collect(), vec![1; 3], vec![1.0; 3]).unwrap();
        let rest = [DVec2::ZERO, DVec2::new(2.0, 1.0)];
        let targets = vertices.map(|p| DMat2::from_angle(0.4) * p + DVec2::new(20.0, 0.0));
        let site = DAffine2::from_translation(DVec2::new(18.0, 3.0));
        let placed = |held: bool| {
            let fit = MotionFit::new(&vertices, &weights, &rest, &[false, held]);
            let found = fit.fitted(&[DAffine2::IDENTITY, site], &vertices, &weights, &targets)[1];
            found.transform_point2(rest[1]).distance(site.transform_point2(rest[1]))
        };
        assert!(placed(true) < 1e-6 && placed(false) > 1.0, "{} and {}", placed(true), placed(false));
    }
}
