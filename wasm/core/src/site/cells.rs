//! 𝒱(h_i): the coarse samples that are nearer to a site than to any other (section III-B).
//!
//! Inserting a site updates the cells. The new site takes the coarse samples that are nearer to it from other cells.
//!
//! Cost of an insertion: the samples of the new cell, a margin of one sample around it, and the cells that lose
//! samples. Before that, `reach_of` visits the samples that a cell without obstacles would have.

use glam::DVec2;

use super::visit_stamps::VisitStamps;
use crate::{
    distance::PathEnd,
    min_max::{fast_max, fast_min},
    sample::CoarseSamples,
    triangulation::NONE,
};

/// The cells of all sites, over the coarse samples.
#[derive(Debug, Clone)]
pub(crate) struct Cells {
    /// Samples: the nearest site of each; [`NONE`] on an island without sites.
    pub(super) nearest: Vec<u32>,
    /// Samples: the distance of each to that site, in pixels.
    pub(super) distance: Vec<f64>,
    /// Samples: the last vertex at which the path from that site bends.
    pub(super) pseudo_source: Vec<DVec2>,
    /// Sites: the first sample of each cell's linked list, or [`NONE`].
    first: Vec<u32>,
    /// Samples: the next sample of the same cell, or [`NONE`].
    next: Vec<u32>,
    /// Sites: the farthest sample of each cell, or [`NONE`].
    farthest: Vec<u32>,
    /// The samples that the last insertion visited.
    visited: VisitStamps,
    stack: Vec<u32>,
}

impl Cells {
    pub(super) fn new(samples: usize) -> Self {
        Self {
            nearest: vec![NONE; samples],
            distance: vec![f64::INFINITY; samples],
            pseudo_source: vec![DVec2::ZERO; samples],
            first: Vec::new(),
            next: vec![NONE; samples],
            farthest: Vec::new(),
            visited: VisitStamps::new(samples),
            stack: Vec::new(),
        }
    }

    /// An upper bound for the distances from a new site to the corners of all triangles that its cell will enter.
    /// Infinite for the first site of an island.
    ///
    /// `expected` has upper bounds for the distances of the samples after a set of sites, including the new one, has
    /// been inserted.
    pub(super) fn reach_of(
        &mut self,
        coarse: &CoarseSamples,
        (rest, start): (DVec2, [u32; 3]),
        expected: &[f64],
    ) -> f64 {
        self.visited.clear();
        self.stack.extend(start);
        let mut reach = 0.0;
        while let Some(sample) = self.stack.pop() {
            let at = sample as usize;
            if !self.visited.mark(sample) {
                continue;
            }
            let margin = fast_min(self.distance[at], expected[at]) + 2.0 * coarse.reach[at];
            // No path is shorter than the straight line.
            if rest.distance_squared(coarse.mesh.vertices[at]) <= margin * margin {
                reach = fast_max(reach, margin);
                self.stack.extend(coarse.graph.neighbours(at));
            }
        }
        reach
    }

    /// Inserts a site at `rest`. Its cell takes the samples that are nearer to it than to all earlier sites.
    ///
    /// `start` lists the corners of the triangle that contains the site. `path_end` returns the shortest path from the
    /// site to a sample.
    pub(super) fn insert(
        &mut self,
        coarse: &CoarseSamples,
        (rest, start): (DVec2, [u32; 3]),
        mut path_end: impl FnMut(usize) -> Option<PathEnd>,
    ) {
        let site = self.first.len() as u32;
        self.first.push(NONE);
        self.farthest.push(NONE);
        self.visited.clear();
        let mut losers: Vec<u32> = Vec::new();
        self.stack.extend(start);
        let (mut first, mut farthest, mut radius) = (NONE, NONE, -1.0);
        while let Some(sample) = self.stack.pop() {
            let at = sample as usize;
            if !self.visited.mark(sample) {
                continue;
            }
            // The path to a sample of the cell crosses triangles whose corners are at most one edge away from the path.
            let known = self.distance[at];
            let margin = known + 2.0 * coarse.reach[at];
            // No path is shorter than the straight line.
            if rest.distance_squared(coarse.mesh.vertices[at]) > margin * margin {
                continue;
            }
            let Some(PathEnd { distance: d, pseudo_source, .. }) = path_end(at) else { continue };
            if d < margin {
                self.stack.extend(coarse.graph.neighbours(at));
            }
            if d < known {
                let loser = self.nearest[at];
                if loser == NONE {
                    (self.next[at], first) = (first, sample);
                } else if !losers.contains(&loser) {
                    losers.push(loser);
                }
                (self.nearest[at], self.distance[at], self.pseudo_source[at]) = (site, d, pseudo_source);
                if d > radius {
                    (farthest, radius) = (sample, d);
                }
            }
        }
        for &loser in &losers {
            first = self.split_list(loser, site, first);
        }
        (self.first[site as usize], self.farthest[site as usize]) = (first, farthest);
    }

    /// Moves the samples that `site` took from `loser` to the list that begins with `first`. Returns the new first
    /// sample.
    fn split_list(&mut self, loser: u32, site: u32, mut first: u32) -> u32 {
        let (mut kept, mut farthest, mut radius) = (NONE, NONE, -1.0);
        let mut sample = self.first[loser as usize];
        while sample != NONE {
            let at = sample as usize;
            let next = self.next[at];
            let head = if self.nearest[at] == site { &mut first } else { &mut kept };
            self.next[at] = *head;
            *head = sample;
            if self.nearest[at] == loser && self.distance[at] > radius {
                (farthest, radius) = (sample, self.distance[at]);
            }
            sample = next;
        }
        (self.first[loser as usize], self.farthest[loser as usize]) = (kept, farthest);
        first
    }

    /// Whether the last insertion visited all three samples. The new cell only has points in triangles with such
    /// corners.
    pub(super) fn visited_all(&self, samples: [u32; 3]) -> bool {
        samples.iter().all(|&at| self.visited.has(at))
    }

    /// The samples of a site's cell.
    pub(super) fn of(&self, site: usize) -> impl Iterator<Item = usize> + '_ {
        let some = |sample: u32| (sample != NONE).then_some(sample as usize);
        std::iter::successors(some(self.first[site]), move |&at| some(self.next[at]))
    }

    /// The maximum distance of a cell's samples, 0 if the cell has none: a lower bound of the cell radius.
    pub(super) fn sampled_radius(&self, site: usize) -> f64 {
        let farthest = self.farthest[site];
        if farthest == NONE { 0.0 } else { self.distance[farthest as usize] }
    }
}
