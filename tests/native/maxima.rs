//! Second maxima of weights, counted on the mesh: a weight should fall from its handle on (section VI, figure 9).
//!
//! Eq. 2 does not promise it. In a dead end that two supports reach, the one that ends farther in grows from its entrance on, to 1 where
//! it is alone; with more supports what is left of one may grow again next to what is left of another.

use std::collections::BTreeSet;

use c2warp::Solution;

/// Second maxima that rise less above the pass are not counted: ridges that run askew to the lattice are cut into beads by it.
const NOISE: f64 = 0.01;

/// How high the second maxima of a solution's weights rise above the pass to a higher one. Each field is one at the samples.
#[derive(Debug, Clone)]
pub struct Maxima {
    /// Number of sites, and so of weights w_i (eq. 2).
    pub sites: usize,
    /// Of the weights of single sites.
    pub of_sites: Vec<f64>,
    /// Of the fields by which handles move the picture: the weights of all sites by the handle's shares of them (eq. 4).
    pub of_handles: Vec<f64>,
}

impl Maxima {
    /// Counts those of a solution.
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
                for (real, share) in solution.harmonic_weights(site) {
                    if let Some(handle) = handle(real) {
                        of_handles[handle][sample] += weight * share;
                    }
                }
            }
        }
        let neighbours = neighbours(solution);
        let second = |fields: &[Vec<f64>]| {
            let rises = fields.iter().flat_map(|field| rises(&neighbours, field));
            rises.filter(|&rise| rise > NOISE).collect()
        };
        Self { sites: sites.len(), of_sites: second(&of_sites), of_handles: second(&of_handles) }
    }
}

/// The samples next to each.
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

/// How high each maximum of a field rises above the pass to a higher one, the highest of an island left out: the lifetimes of the
/// components of the field's superlevel sets.
fn rises(neighbours: &[BTreeSet<u32>], field: &[f64]) -> Vec<f64> {
    const NOT_YET: usize = usize::MAX;
    let mut order: Vec<usize> = (0..field.len()).filter(|&v| field[v] > 0.0).collect();
    order.sort_by(|&a, &b| field[b].total_cmp(&field[a]).then(a.cmp(&b)));
    let mut parent = vec![NOT_YET; field.len()];
    let mut rises = Vec::new();
    for v in order {
        parent[v] = v;
        for &n in &neighbours[v] {
            if parent[n as usize] == NOT_YET {
                continue;
            }
            let (a, b) = (top(&mut parent, v), top(&mut parent, n as usize));
            // The component whose top is lower ends here.
            let (lower, higher) = if (field[a], b) < (field[b], a) { (a, b) } else { (b, a) };
            if lower != higher {
                if lower != v {
                    rises.push(field[lower] - field[v]);
                }
                parent[lower] = higher;
            }
        }
    }
    rises
}

/// The maximum of the component that a vertex belongs to.
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
    fn a_second_maximum_rises_from_the_pass_to_the_first() {
        let row = |field: &[f64]| {
            let next = |v: u32| BTreeSet::from_iter([v.checked_sub(1), Some(v + 1)].into_iter().flatten());
            let mut neighbours: Vec<BTreeSet<u32>> = (0..field.len() as u32).map(next).collect();
            neighbours.last_mut().map(|last| last.remove(&(field.len() as u32)));
            rises(&neighbours, field)
        };
        assert_eq!(row(&[0.25, 1.0, 0.5, 0.5, 0.0]), Vec::<f64>::new());
        assert_eq!(row(&[0.25, 1.0, 0.25, 0.75, 0.5]), [0.5]);
        assert_eq!(row(&[0.5, 0.25, 1.0, 0.0, 0.75]), [0.25]);
    }
}
