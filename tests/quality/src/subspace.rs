//! What motions of the sites could do at best: the reference's energy, minimised over the motions that are blended.
//!
//! Every place is linear in the motions of the sites, so the reference's second step becomes a small dense system: its Galerkin
//! projection on the weights (as Jacobson et al. 2012 do for skinning). The first step stays that of the whole mesh. What is left
//! between this and the reference is owed to weights and blend; what is left between the rigid mode and this, to the energy on the
//! cell graph.
//!
//! In complex numbers: z = Σ w_i (c_i + m_i d_i + k_i d̄_i), d_i = (p − h_i) ÷ radius of the cell; k = 0 for similarities.

use c2warp::{
    Solution,
    pose::Pose,
    project::{Project, Rotation},
    site::Origin,
};
use faer::{Mat, Side, c64, prelude::Solve};
use glam::DVec2;

use crate::{dense::Dense, fine::Fine};

/// A place, or an edge, as a sum over parts of motions: their numbers and factors.
type Sum = Vec<(usize, c64)>;

/// A turn that lowers the energy by less than this share of it is the last.
const SETTLED: f64 = 1e-7;
/// Turns at most.
const TURNS: usize = 3_000;
/// Added to the matrix, as a share of its diagonal: motions that no vertex tells apart.
const RIDGE: f64 = 1e-9;

/// The lowest energy from where a pose of the solver is, over all motions of its sites.
///
/// Point handles keep their place, and their rotation where the person set one; bars, polygons and held outlines their motion. `affine`: motions may stretch and shear. The solution must be on the
/// mesh `fine`. `None` where the system cannot be factored.
#[must_use]
pub fn best(
    dense: &Dense<'_>,
    fine: &Fine,
    solution: &Solution,
    pose: &Pose,
    project: &Project,
    affine: bool,
) -> Option<Vec<DVec2>> {
    let complex = |p: DVec2| c64::new(p.x, p.y);
    let per_site = 3;
    let count = solution.sites.len() * per_site;
    // Motions that are given.
    let mut given: Vec<Option<c64>> = vec![None; count];
    for (at, site) in solution.sites.iter().enumerate() {
        let turns = match site.origin {
            Origin::Virtual => true,
            Origin::Point { handle } => project.handles[handle as usize].rotation == Rotation::Auto,
            Origin::Bone { .. } | Origin::Boundary => false,
        };
        if !affine {
            given[at * per_site + 2] = Some(c64::ZERO);
        }
        let moved = |offset: DVec2| pose.moved(at, site.rest + offset);
        if site.origin.is_real() {
            given[at * per_site] = Some(complex(moved(DVec2::ZERO)));
        }
        if !turns {
            let [x, y] = [DVec2::X, DVec2::Y].map(|axis| complex(moved(axis) - moved(DVec2::ZERO)));
            given[at * per_site + 1] = Some((x - c64::I * y) / 2.0 * site.cell_radius);
            given[at * per_site + 2] = Some((x + c64::I * y) / 2.0 * site.cell_radius);
        }
    }
    let free: Vec<usize> = (0..count).filter(|&at| given[at].is_none()).collect();
    let mut row = vec![usize::MAX; count];
    free.iter().enumerate().for_each(|(to, &at)| row[at] = to);

    // Each vertex as a sum over the motions.
    let shares = |v: usize| -> Sum {
        let p = fine.vertices[v];
        let of_site = |(at, weight): (usize, f64)| {
            let site = &solution.sites[at];
            let d = complex((p - site.rest) / site.cell_radius);
            [c64::ONE, d, d.conj()]
                .into_iter()
                .take(per_site)
                .enumerate()
                .map(move |(k, by)| (at * per_site + k, by * weight))
        };
        solution.weights.row(v).flat_map(of_site).collect()
    };
    let vertices: Vec<Sum> = (0..fine.vertices.len()).map(shares).collect();
    let edges: Vec<(f64, usize, c64, Sum)> = dense
        .edges()
        .map(|(i, j, weight, t)| {
            let mut sum = vertices[i].clone();
            sum.extend(vertices[j].iter().map(|&(at, by)| (at, -by)));
            sum.sort_by_key(|entry| entry.0);
            sum.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 += next.1;
                }
                same
            });
            (weight, t, complex(fine.vertices[i] - fine.vertices[j]), sum)
        })
        .collect();
    let mut matrix = Mat::<c64>::zeros(free.len(), free.len());
    let mut constant = vec![c64::ZERO; free.len()];
    for (weight, _, _, sum) in &edges {
        for &(a, by_a) in sum.iter().filter(|(a, _)| given[*a].is_none()) {
            for &(b, by_b) in sum {
                let entry = by_a.conj() * by_b * *weight;
                match given[b] {
                    None => matrix[(row[a], row[b])] += entry,
                    Some(value) => constant[row[a]] -= entry * value,
                }
            }
        }
    }
    for at in 0..free.len() {
        let ridge = matrix[(at, at)].re * RIDGE + f64::MIN_POSITIVE;
        matrix[(at, at)] += c64::new(ridge, 0.0);
    }
    let factors = matrix.llt(Side::Lower).ok()?;

    let mut posed = solution.posed_vertices(pose)[..fine.vertices.len()].to_vec();
    let mut rotations = vec![DVec2::X; fine.triangles.len()];
    let mut energy = dense.rotate(&posed, &mut rotations);
    for _ in 0..TURNS {
        let mut right = Mat::<c64>::zeros(free.len(), 1);
        for (at, &value) in constant.iter().enumerate() {
            right[(at, 0)] = value;
        }
        for (weight, t, edge, sum) in &edges {
            let pull = complex(rotations[*t]) * edge * *weight;
            for &(at, by) in sum.iter().filter(|(at, _)| given[*at].is_none()) {
                right[(row[at], 0)] += by.conj() * pull;
            }
        }
        let found = factors.solve(&right);
        let motion = |at: usize| given[at].unwrap_or_else(|| found[(row[at], 0)]);
        for (to, shares) in posed.iter_mut().zip(&vertices) {
            let z: c64 = shares.iter().fold(c64::ZERO, |z, &(at, by)| z + by * motion(at));
            *to = DVec2::new(z.re, z.im);
        }
        let lower = dense.rotate(&posed, &mut rotations);
        let gain = energy - lower;
        energy = lower;
        if gain <= SETTLED * energy {
            break;
        }
    }
    Some(posed)
}
