//! Finds weights of few bones that move each vertex like its many sites, over a set of poses.
//!
//! Each vertex has its own least squares problem. Its weights are not negative and sum to 1, and their blend is nearest
//! to the exact positions in all poses. Weights are dropped one by one, always the least important one, and the others
//! are fitted again.
//!
//! Cost: for each vertex the distances of all bones in all poses, and a few hundred systems of up to 16 weights.

use glam::{DAffine2, DVec2};

use c2warp::weight::SparseWeights;

/// Candidate bones of a vertex: those with its greatest weights so far, and those that move most like it.
const HEAVIEST: usize = 10;
const NEAREST: usize = 6;
/// Pull towards the weights so far, relative to the mean square of the distances. It only matters where poses do not
/// determine the weights.
const PULL: f64 = 1e-6;
/// The same in square pixels for each pose, where all distances vanish.
const LEAST_PULL: f64 = 1e-9;

/// Vertices, their exact positions in some poses, and the maps of the bones in these.
pub(crate) struct WeightFit<'a> {
    pub(crate) vertices: &'a [DVec2],
    /// Poses × vertices.
    pub(crate) targets: &'a [Vec<DVec2>],
    /// Poses × bones.
    pub(crate) maps: &'a [Vec<DAffine2>],
}

impl WeightFit<'_> {
    /// Reduces weights to at most `influences` bones per vertex.
    pub(crate) fn fitted(&self, weights: &SparseWeights, influences: usize) -> SparseWeights {
        let (mut offsets, mut bones, mut shares) = (vec![0], Vec::new(), Vec::new());
        for vertex in 0..self.vertices.len() {
            for (bone, weight) in self.row(vertex, &weights.row(vertex).collect::<Vec<_>>(), influences) {
                bones.push(bone as u32);
                shares.push(weight);
            }
            offsets.push(bones.len() as u32);
        }
        SparseWeights::from_parts(offsets, bones, shares).expect("rows of all vertices")
    }

    fn row(&self, vertex: usize, before: &[(usize, f64)], influences: usize) -> Vec<(usize, f64)> {
        let candidates = self.candidates(vertex, before);
        let p = self.vertices[vertex];
        // Candidates × poses: how far each is from the exact position.
        let apart = |&bone: &usize| -> Vec<DVec2> {
            let poses = self.maps.iter().zip(self.targets);
            poses.map(|(maps, targets)| maps[bone].transform_point2(p) - targets[vertex]).collect()
        };
        let apart: Vec<Vec<DVec2>> = candidates.iter().map(apart).collect();
        let n = candidates.len();
        let mut gram = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..=i {
                let dot: f64 = apart[i].iter().zip(&apart[j]).map(|(a, b)| a.dot(*b)).sum();
                (gram[i * n + j], gram[j * n + i]) = (dot, dot);
            }
        }
        let trace: f64 = (0..n).map(|i| gram[i * n + i]).sum();
        let pull = PULL * trace / n as f64 + LEAST_PULL * self.targets.len() as f64;
        (0..n).for_each(|i| gram[i * n + i] += pull);
        let weight = |bone: usize| before.iter().find(|one| one.0 == bone).map_or(0.0, |one| one.1);
        let linear: Vec<f64> = candidates.iter().map(|&bone| pull * weight(bone)).collect();
        let problem = Simplex { size: n, gram, linear };
        let mut best = problem.minimum((0..n).collect());
        while best.set.len() > influences {
            let without = |&out: &usize| problem.minimum(best.set.iter().copied().filter(|&i| i != out).collect());
            let least = |a: Minimum, b: Minimum| if b.cost < a.cost { b } else { a };
            best = best.set.iter().map(without).reduce(least).expect("a set of several");
        }
        let mut row: Vec<(usize, f64)> = best.set.iter().map(|&i| candidates[i]).zip(best.weights).collect();
        row.sort_unstable_by_key(|one| one.0);
        row
    }

    fn candidates(&self, vertex: usize, before: &[(usize, f64)]) -> Vec<usize> {
        let mut heaviest = before.to_vec();
        heaviest.sort_by(|a, b| b.1.total_cmp(&a.1));
        let mut candidates: Vec<usize> = heaviest.into_iter().take(HEAVIEST).map(|(bone, _)| bone).collect();
        let p = self.vertices[vertex];
        let squared = |bone: usize| -> f64 {
            let poses = self.maps.iter().zip(self.targets);
            poses.map(|(maps, targets)| maps[bone].transform_point2(p).distance_squared(targets[vertex])).sum()
        };
        let bones = self.maps.first().map_or(0, Vec::len);
        let mut nearest: Vec<(f64, usize)> = (0..bones).map(|bone| (squared(bone), bone)).collect();
        nearest.sort_by(|a, b| a.0.total_cmp(&b.0));
        let others = nearest.into_iter().map(|(_, bone)| bone).take(NEAREST);
        for bone in others {
            if !candidates.contains(&bone) {
                candidates.push(bone);
            }
        }
        candidates
    }
}

/// Minimise uᵀ G u − 2 lᵀ u for weights u ≥ 0 that sum to 1.
struct Simplex {
    size: usize,
    gram: Vec<f64>,
    linear: Vec<f64>,
}

struct Minimum {
    set: Vec<usize>,
    weights: Vec<f64>,
    cost: f64,
}

impl Simplex {
    /// The minimum over a set of weights. Weights that would become negative leave the set, the most negative first.
    fn minimum(&self, mut set: Vec<usize>) -> Minimum {
        loop {
            let weights = self.stationary(&set);
            let lowest = weights.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
            match lowest {
                Some((at, &weight)) if weight <= 0.0 && set.len() > 1 => {
                    set.remove(at);
                }
                _ => {
                    let cost = self.cost(&set, &weights);
                    return Minimum { set, weights, cost };
                }
            }
        }
    }

    fn cost(&self, set: &[usize], weights: &[f64]) -> f64 {
        let row = |i: usize| -> f64 { set.iter().zip(weights).map(|(&j, w)| self.gram[i * self.size + j] * w).sum() };
        set.iter().zip(weights).map(|(&i, w)| w * (row(i) - 2.0 * self.linear[i])).sum()
    }

    /// The weights of a set that sum to 1, of any sign: G u = l + μ 1, by Gaussian elimination with two right sides.
    fn stationary(&self, set: &[usize]) -> Vec<f64> {
        let n = set.len();
        let mut rows: Vec<Vec<f64>> = set
            .iter()
            .map(|&i| {
                let row = set.iter().map(|&j| self.gram[i * self.size + j]);
                row.chain([self.linear[i], 1.0]).collect()
            })
            .collect();
        for column in 0..n {
            // The matrix is positive definite, so every pivot is positive.
            let (done, rest) = rows.split_at_mut(column + 1);
            let pivot = &done[column];
            for row in rest {
                let factor = row[column] / pivot[column];
                row.iter_mut().zip(pivot).skip(column).for_each(|(a, b)| *a -= factor * b);
            }
        }
        let mut solved = vec![[0.0; 2]; n];
        for i in (0..n).rev() {
            for k in 0..2 {
                let known: f64 = (i + 1..n).map(|j| rows[i][j] * solved[j][k]).sum();
                solved[i][k] = (rows[i][n + k] - known) / rows[i][i];
            }
        }
        let [plain, shift] = [0, 1].map(|k| solved.iter().map(|pair| pair[k]).sum::<f64>());
        let mu = (1.0 - plain) / shift;
        solved.iter().map(|[plain, shift]| plain + mu * shift).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shift(x: f64, y: f64) -> DAffine2 {
        DAffine2::from_translation(DVec2::new(x, y))
    }

    #[test]
    fn true_weights_are_found_and_never_negative() {
        let maps = vec![
            vec![shift(9.0, 0.0), shift(0.0, 6.0), shift(-3.0, 1.0)],
            vec![shift(0.0, 2.0), shift(7.0, 7.0), shift(1.0, 0.0)],
        ];
        let vertices = [DVec2::new(4.0, 4.0)];
        let blend = |maps: &Vec<DAffine2>| {
            vec![0.25 * maps[0].transform_point2(vertices[0]) + 0.75 * maps[1].transform_point2(vertices[0])]
        };
        let targets: Vec<Vec<DVec2>> = maps.iter().map(blend).collect();
        let fit = WeightFit { vertices: &vertices, targets: &targets, maps: &maps };
        let third = SparseWeights::from_parts(vec![0, 3], vec![0, 1, 2], vec![1.0 / 3.0; 3]).unwrap();
        let found: Vec<(usize, f64)> = fit.fitted(&third, 2).row(0).collect();
        assert_eq!(found.iter().map(|one| one.0).collect::<Vec<_>>(), [0, 1]);
        assert!((found[0].1 - 0.25).abs() < 1e-5 && (found[1].1 - 0.75).abs() < 1e-5, "{found:?}");
        let one: Vec<(usize, f64)> = fit.fitted(&third, 1).row(0).collect();
        assert_eq!(one, [(1, 1.0)]);
    }

    #[test]
    fn identical_bones_keep_their_shares() {
        let maps = vec![vec![shift(1.0, 1.0); 3]];
        let fit = WeightFit { vertices: &[DVec2::ZERO], targets: &[vec![DVec2::ONE]], maps: &maps };
        let before = SparseWeights::from_parts(vec![0, 2], vec![0, 2], vec![0.4, 0.6]).unwrap();
        let found: Vec<(usize, f64)> = fit.fitted(&before, 4).row(0).collect();
        assert!((found.iter().map(|one| one.1).sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(found.iter().all(|one| one.1 > 0.0 || one.0 == 1), "{found:?}");
    }
}
