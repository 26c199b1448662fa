//! 𝒱(h_i): which coarse samples are nearer to a site than to any other (section III-B).
//!
//! Cells are updated as sites are inserted: a new site takes over the coarse samples around it that are nearer to it, and no others
//! are visited. Cost of an insertion: its cell, a margin of one coarse sample around it, and the cells that lose coarse samples to it.

use glam::DVec2;

use super::visit_stamps::VisitStamps;
use crate::{distance::PathEnd, sample::CoarseSamples, triangulation::NONE};

/// The cells of all sites, over the coarse samples.
#[derive(Debug, Clone)]
pub(crate) struct Cells {
    /// The nearest site of each coarse sample; [`NONE`] on an island without sites.
    pub(crate) nearest: Vec<u32>,
    /// The distance of each coarse sample to that site.
    pub(crate) distance: Vec<f64>,
    /// The last vertex at which the path from that site bends.
    pub(crate) pseudo_source: Vec<DVec2>,
    /// The coarse samples of each cell as linked lists: the first coarse sample of each site, and the next coarse sample of each coarse sample.
    first: Vec<u32>,
    next: Vec<u32>,
    /// The farthest coarse sample of each cell, or [`NONE`].
    farthest: Vec<u32>,
    /// The coarse samples that the last insertion visited.
    seen: VisitStamps,
    stack: Vec<u32>,
}

impl Cells {
    pub(crate) fn new(coarse: usize) -> Self {
        Self {
            nearest: vec![NONE; coarse],
            distance: vec![f64::INFINITY; coarse],
            pseudo_source: vec![DVec2::ZERO; coarse],
            first: Vec::new(),
            next: vec![NONE; coarse],
            farthest: Vec::new(),
            seen: VisitStamps::new(coarse),
            stack: Vec::new(),
        }
    }

    /// Inserts a site at `rest`: its cell consists of the coarse samples nearer to it than to all sites before. `start` are the coarse samples
    /// around the site, `path_end` gives the path from the site to a coarse sample.
    pub(crate) fn insert(
        &mut self,
        coarse: &CoarseSamples,
        (rest, start): (DVec2, [u32; 3]),
        mut path_end: impl FnMut(usize) -> Option<PathEnd>,
    ) {
        let site = self.first.len() as u32;
        self.first.push(NONE);
        self.farthest.push(NONE);
        self.seen.clear();
        let mut losers: Vec<u32> = Vec::new();
        self.stack.extend(start);
        let (mut first, mut farthest, mut radius) = (NONE, NONE, -1.0);
        while let Some(sample) = self.stack.pop() {
            let at = sample as usize;
            if !self.seen.mark(sample) {
                continue;
            }
            // The path to a coarse sample of the cell crosses triangles whose corners are at most an edge away from the path.
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
                if loser != NONE && !losers.contains(&loser) {
                    losers.push(loser);
                }
                (self.nearest[at], self.distance[at], self.pseudo_source[at]) = (site, d, pseudo_source);
                if d > radius {
                    (farthest, radius) = (sample, d);
                }
            }
        }
        for &loser in &losers {
            first = self.release(loser, site, first);
        }
        if losers.is_empty() && farthest != NONE {
            // The first site of an island: there is no list to take coarse samples from.
            first = self.collect(site);
        }
        (self.first[site as usize], self.farthest[site as usize]) = (first, farthest);
    }

    /// Moves the coarse samples that `site` took from `loser` to the list that begins with `first`. Returns the new first.
    fn release(&mut self, loser: u32, site: u32, mut first: u32) -> u32 {
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

    fn collect(&mut self, site: u32) -> u32 {
        let mut first = NONE;
        for at in (0..self.nearest.len()).filter(|&at| self.nearest[at] == site) {
            self.next[at] = first;
            first = at as u32;
        }
        first
    }

    /// Whether the last insertion visited all three coarse samples. The new cell has no point in any other triangle.
    pub(crate) fn saw(&self, coarse: [u32; 3]) -> bool {
        coarse.iter().all(|&at| self.seen.has(at))
    }

    /// The coarse samples of a site's cell.
    pub(crate) fn of(&self, site: usize) -> impl Iterator<Item = usize> + '_ {
        let some = |sample: u32| (sample != NONE).then_some(sample as usize);
        std::iter::successors(some(self.first[site]), move |&at| some(self.next[at]))
    }

    /// The farthest coarse sample of a cell; `None` for a cell that contains no coarse sample.
    pub(crate) fn farthest_sample(&self, site: usize) -> Option<usize> {
        (self.farthest[site] != NONE).then_some(self.farthest[site] as usize)
    }
}
