//! Secondary maxima of weights on the mesh. A weight should decrease with the distance from its handle (section VI,
//! figure 9).
//!
//! Eq. 2 does not guarantee this. If two supports reach a dead end, the weight of the deeper one grows from the
//! entrance to 1. With more supports, one weight may grow again where another one ends.

use std::collections::BTreeSet;

use c2warp::Solution;

/// Smallest persistence that counts. The lattice breaks oblique ridges into small maxima below it.
const MIN_PERSISTENCE: f64 = 0.01;

/// The persistence of each secondary maximum of a solution's weights: its height above the pass to a higher maximum.
///
/// Fields are sampled at the samples of the solution.
#[derive(Debug, Clone)]
pub struct SecondaryMaxima {
    /// The number of sites, and so of weights w_i (eq. 2).
    pub sites: usize,
    /// Persistences in the weights of single sites.
    pub of_sites: Vec<f64>,
    /// Persistences in the fields of handles: the sums of all weights times their harmonic weights (eq. 4).
    pub of_handles: Vec<f64>,
}

impl SecondaryMaxima {
    /// Finds the secondary maxima of a solution.
    #[must_use]
    pub fn of(solution: &Solution) -> Self {
        let (samples, sites) = (solution.samples(), solution.sites());
        let handle = |site: usize| sites[site].kind.handle();
        let handles = (0..sites.len()).filter_map(handle).max().map_or(0, |last| last + 1);
        let mut of_sites = vec![vec![0.0; samples]; sites.len()];
        let mut of_handles = vec![vec![0.0; samples]; handles];
        for sample in 0..samples {
            for (site, weight) in solution.weights().row(sample) {
                of_sites[site][sample] = weight;
                for (real, harmonic) in solution.harmonic_weights(site) {
                    if let Some(handle) = handle(real) {
                        of_handles[handle][sample] += weight * harmonic;
                    }
                }
            }
        }
        let neighbours = neighbours(solution);
        let persistences_of = |fields: &[Vec<f64>]| {
            let all = fields.iter().flat_map(|field| persistences(&neighbours, field));
            all.filter(|&persistence| persistence > MIN_PERSISTENCE).collect()
        };
        Self { sites: sites.len(), of_sites: persistences_of(&of_sites), of_handles: persistences_of(&of_handles) }
    }
}

/// Returns the neighbours of each sample in the mesh.
fn neighbours(solution: &Solution) -> Vec<BTreeSet<u32>> {
    let mut neighbours = vec![BTreeSet::new(); solution.samples()];
    let between = |triangle: &&[u32; 3]| triangle.iter().all(|&v| (v as usize) < solution.samples());
    for &[a, b, c] in solution.triangles().iter().filter(between) {
        for [here, next, last] in [[a, b, c], [b, c, a], [c, a, b]] {
            neighbours[here as usize].extend([next, last]);
        }
    }
    neighbours
}

/// Returns the persistence of each maximum of a field, except the highest one of each island.
///
/// It is the lifetime of a component of the field's superlevel sets.
fn persistences(neighbours: &[BTreeSet<u32>], field: &[f64]) -> Vec<f64> {
    const UNVISITED: usize = usize::MAX;
    let mut order: Vec<usize> = (0..field.len()).filter(|&v| field[v] > 0.0).collect();
    order.sort_by(|&a, &b| field[b].total_cmp(&field[a]).then(a.cmp(&b)));
    let mut parent = vec![UNVISITED; field.len()];
    let mut found = Vec::new();
    for v in order {
        parent[v] = v;
        for &n in &neighbours[v] {
            if parent[n as usize] == UNVISITED {
                continue;
            }
            let (a, b) = (top(&mut parent, v), top(&mut parent, n as usize));
            // The component with the lower maximum ends here.
            let (lower, higher) = if (field[a], b) < (field[b], a) { (a, b) } else { (b, a) };
            if lower != higher {
                if lower != v {
                    found.push(field[lower] - field[v]);
                }
                parent[lower] = higher;
            }
        }
    }
    found
}

/// Returns the maximum of the component of `v`.
fn top(parent: &mut [usize], mut v: usize) -> usize {
    while parent[v] != v {
        parent[v] = parent[parent[v]];
        v = parent[v];
    }
    v
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn persistence_is_the_height_above_the_pass() {
        let row = |field: &[f64]| {
            let next = |v: u32| BTreeSet::from_iter([v.checked_sub(1), Some(v + 1)].into_iter().flatten());
            let mut neighbours: Vec<BTreeSet<u32>> = (0..field.len() as u32).map(next).collect();
            neighbours.last_mut().map(|last| last.remove(&(field.len() as u32)));
            persistences(&neighbours, field)
        };
        assert_eq!(row(&[0.25, 1.0, 0.5, 0.5, 0.0]), Vec::<f64>::new());
        assert_eq!(row(&[0.25, 1.0, 0.25, 0.75, 0.5]), [0.5]);
        assert_eq!(row(&[0.5, 0.25, 1.0, 0.0, 0.75]), [0.25]);
    }
}
