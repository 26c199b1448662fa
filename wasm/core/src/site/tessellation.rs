//! Sites along bones and along a held outline (paper, section V-D, and its conclusion's wish for a local strategy).
//!
//! The paper divides all bars into pieces as long as the least distance between any two handles. Here sites are as far apart as
//! their own reach allows, so that one close pair somewhere costs sites there alone: where a gap is larger than a share of the
//! reach of the sites at its ends, a site enters in its middle. Supports then overlap by so much that a bar weighs the same
//! all along, within a few per cent. It goes on while Algorithm 1 inserts sites around.
//!
//! Sites of a bone stand clear of its ends by half a gap, and so the same distance apart across a joint.

use glam::DVec2;

use super::{MAX_SITES, Origin, regions::Regions};
use crate::{distance::Place, domain::Ring, error::Error};

/// Greatest gap over the reach of the sites at its ends.
const GAP: f64 = 0.5;
/// Corners of a held outline that turn by more than this (cosine) get a site each: 20°.
const TURN: f64 = 0.94;

/// A line with sites on it.
pub(super) struct Chain {
    origin: Origin,
    corners: Vec<DVec2>,
    /// Length of the line before each corner, and at last all of it.
    lengths: Vec<f64>,
    closed: bool,
    /// Sites and the length of the line before each, ascending.
    sites: Vec<(f64, usize)>,
}

impl Chain {
    fn new(origin: Origin, corners: Vec<DVec2>, closed: bool) -> Self {
        let n = corners.len();
        let edges = if closed { n } else { n - 1 };
        let mut lengths = vec![0.0];
        for i in 0..edges {
            lengths.push(lengths[i] + corners[i].distance(corners[(i + 1) % n]));
        }
        Self { origin, corners, lengths, closed, sites: Vec::new() }
    }

    fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    fn at(&self, length: f64) -> DVec2 {
        let edge = self.lengths[1..self.lengths.len() - 1].partition_point(|&end| end <= length);
        let (from, to) = (self.corners[edge], self.corners[(edge + 1) % self.corners.len()]);
        from.lerp(to, (length - self.lengths[edge]) / (self.lengths[edge + 1] - self.lengths[edge]))
    }

    /// Where the first sites are.
    fn start(&self) -> Vec<f64> {
        if !self.closed {
            return vec![self.length() / 2.0];
        }
        let n = self.corners.len();
        let turns = |i: usize| {
            let [before, at, after] = [i + n - 1, i, i + 1].map(|at| self.corners[at % n]);
            (at - before).normalize().dot((after - at).normalize()) < TURN
        };
        let sharp: Vec<f64> = (0..n).filter(|&i| turns(i)).map(|i| self.lengths[i]).collect();
        if sharp.is_empty() { self.lengths[..n].to_vec() } else { sharp }
    }

    /// Where gaps are too large for the reach of the sites at their ends.
    fn wanted(&self, reach: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut wanted = Vec::new();
        let limit = |i: usize, j: usize| GAP * reach(self.sites[i].1).min(reach(self.sites[j].1));
        let last = self.sites.len() - 1;
        for i in 0..last {
            let (from, to) = (self.sites[i].0, self.sites[i + 1].0);
            if to - from > limit(i, i + 1) {
                wanted.push(f64::midpoint(from, to));
            }
        }
        let (first, end) = (self.sites[0].0, self.length() - self.sites[last].0);
        if self.closed {
            if end + first > limit(0, last) {
                let middle = self.sites[last].0 + (end + first) / 2.0;
                wanted.push(if middle < self.length() { middle } else { middle - self.length() });
            }
        } else {
            if 2.0 * first > limit(0, 0) {
                wanted.push(first / 3.0);
            }
            if 2.0 * end > limit(last, last) {
                wanted.push(self.length() - end / 3.0);
            }
        }
        wanted
    }
}

impl Regions<'_> {
    /// Gives the bones, and the outline where it is held, their first sites: where, what for, and of which chain.
    pub(super) fn chains(&self, rings: &[Ring]) -> Vec<Chain> {
        let bones = self.obstacles.skeleton.bones.iter().enumerate();
        let bones = bones.map(|(at, bone)| {
            let origin = Origin::Bone { handle: bone.handle, bone: at as u32 };
            Chain::new(origin, bone.rest.to_vec(), false)
        });
        let rings = rings.iter().map(|ring| Chain::new(Origin::Boundary, ring.clone(), true));
        bones.chain(rings).collect()
    }

    /// Inserts the real sites: point handles, and the first of all chains, from top to bottom.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(crate) fn insert_real_sites(&mut self, points: &[(DVec2, Place, u32)]) -> Result<(), Error> {
        let mut chains = self.chains(self.obstacles.held);
        let of_points = points.iter().map(|&(rest, place, handle)| (rest, place, Origin::Point { handle }, None));
        let mut sites: Vec<(DVec2, Place, Origin, Option<(usize, f64)>)> = of_points.collect();
        for (at, chain) in chains.iter().enumerate() {
            for length in chain.start() {
                let rest = chain.at(length);
                let place = self.navigation.place(rest).expect("lines lie in the domain");
                sites.push((rest, place, chain.origin, Some((at, length))));
            }
        }
        self.insert_from_top(sites, &mut chains)?;
        self.chains = chains;
        self.tessellate().map(|_| ())
    }

    /// Closes gaps between the sites of chains. Tells whether there were any.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(super) fn tessellate(&mut self) -> Result<bool, Error> {
        let mut chains = std::mem::take(&mut self.chains);
        let mut closed = false;
        loop {
            let mut wanted = Vec::new();
            for (at, chain) in chains.iter().enumerate() {
                for length in chain.wanted(|site| self.sites[site].reach_limit()) {
                    let rest = chain.at(length);
                    let place = self.navigation.place(rest).expect("lines lie in the domain");
                    wanted.push((rest, place, chain.origin, Some((at, length))));
                }
            }
            if wanted.is_empty() {
                break;
            }
            closed = true;
            self.insert_from_top(wanted, &mut chains)?;
        }
        self.chains = chains;
        Ok(closed)
    }

    fn insert_from_top(
        &mut self,
        mut sites: Vec<(DVec2, Place, Origin, Option<(usize, f64)>)>,
        chains: &mut [Chain],
    ) -> Result<(), Error> {
        sites.sort_by(|(a, ..), (b, ..)| a.y.total_cmp(&b.y).then(a.x.total_cmp(&b.x)));
        for (rest, place, origin, chain) in sites {
            if self.sites.len() >= MAX_SITES {
                return Err(Error::TooManySites);
            }
            if let Some((chain, length)) = chain {
                let sites = &mut chains[chain].sites;
                let at = sites.partition_point(|&(known, _)| known < length);
                sites.insert(at, (length, self.sites.len()));
            }
            self.insert(rest, place, origin);
        }
        Ok(())
    }
}
