//! Parts of the picture without a handle: they follow the nearest part with a handle.
//!
//! Each loose part, an island of the domain, takes the weights of one point: the nearest sample of an island with
//! sites. The whole part then moves like this point, and keeps its shape as far as the motion of that point allows.
//!
//! Cost: O(n log n) for n samples.

use glam::DVec2;

use crate::{
    distance::{NavTriangle, Navigation},
    point_tree::Tree,
    sample::Samples,
};

/// The samples that loose islands follow.
#[derive(Debug, Clone, Default)]
pub(crate) struct Loose {
    /// For each island, the sample that it follows, if any, with its position.
    leaders: Vec<Option<Leader>>,
}

#[derive(Debug, Clone, Copy)]
struct Leader {
    sample: u32,
    triangle: NavTriangle,
    rest: DVec2,
}

impl Loose {
    /// Finds the leader of each island that is not in `with_sites`.
    pub(crate) fn new(navigation: &Navigation, samples: &Samples, with_sites: &[usize]) -> Self {
        let islands = navigation.island.iter().max().map_or(0, |&last| last as usize + 1);
        let mut is_led = vec![false; islands];
        with_sites.iter().for_each(|&island| is_led[island] = true);
        let island = |sample: usize| navigation.island_of(samples.nav_triangles[sample]);
        let (leading, loose): (Vec<usize>, Vec<usize>) = (0..samples.len()).partition(|&at| is_led[island(at)]);
        let points: Vec<DVec2> = leading.iter().map(|&sample| samples.mesh.vertices[sample]).collect();
        let tree = Tree::new(&points);
        let mut nearest: Vec<(f64, u32)> = vec![(f64::INFINITY, u32::MAX); islands];
        for sample in loose {
            let found = tree.nearest(&points, samples.mesh.vertices[sample], 1);
            if let Some(&found) = found.first()
                && found < nearest[island(sample)]
            {
                nearest[island(sample)] = found;
            }
        }
        let leader = |(distance, at): (f64, u32)| {
            distance.is_finite().then(|| {
                let sample = leading[at as usize];
                let (triangle, rest) = (samples.nav_triangles[sample], samples.mesh.vertices[sample]);
                Leader { sample: sample as u32, triangle, rest }
            })
        };
        Self { leaders: nearest.into_iter().map(leader).collect() }
    }

    /// For each sample, the sample whose weights it takes: itself, unless its island is loose.
    pub(crate) fn owners(&self, navigation: &Navigation, samples: &Samples) -> Vec<u32> {
        let leader = |at: usize| self.leaders.get(navigation.island_of(samples.nav_triangles[at])).copied().flatten();
        (0..samples.len()).map(|at| leader(at).map_or(at as u32, |leader| leader.sample)).collect()
    }

    /// The position whose weights an island takes; `None` if it has its own weights.
    pub(crate) fn leader(&self, island: usize) -> Option<(NavTriangle, DVec2)> {
        self.leaders.get(island).copied().flatten().map(|leader| (leader.triangle, leader.rest))
    }
}
