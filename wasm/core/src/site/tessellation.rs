//! Sites along bones and along a held outline (paper, section V-D, and its conclusion's wish for a local strategy).
//!
//! The paper divides all bars into pieces as long as the least distance between any two handles. Here sites are as far apart as
//! their own reach allows, so that one close pair somewhere costs sites there alone: where a gap is larger than a share of the
//! reach of the sites at its ends, a site enters in its middle. Supports then overlap by so much that a bar weighs the same
//! all along, within a few per cent. It goes on while Algorithm 1 inserts sites around.
//!
//! A virtual site must keep clear of the whole of a bone, not of its sites alone. One that would be much nearer to the bone than
//! to any site is not inserted: the bone gets a site there instead, as in Ruppert's Delaunay refinement (1995) a segment is
//! split that a new vertex encroaches on. Without this, ever smaller sites would crowd before the gaps.
//!
//! Sites of a bone stand clear of its ends by half a gap, and so the same distance apart across a joint. At the joint itself one
//! would be of one bone, and the other would get none.

use glam::DVec2;

use super::{
    MAX_SITES, Origin,
    regions::{FarPoint, Regions},
    virtual_sites::TIE,
};
use crate::{
    distance::{Navigation, Place},
    domain::Domain,
    error::Error,
    segment::nearest_on_segment,
};

/// Greatest gap over the reach of the sites at its ends.
const GAP: f64 = 0.5;
/// Corners of a held outline that turn by more than this (cosine) get a site each: 20°.
const TURN: f64 = 0.94;

/// So near to all others, in pixels, no site is asked for but by rounding, and there would be no end of it.
const NOTHING: f64 = 1e-9;
/// A virtual site is at least this share as far from a bone or held outline as from the nearest site.
const CLEAR: f64 = 0.9;
/// A site on a bone this share of the distance away from where one is wanted is good enough.
const THERE: f64 = 0.05;

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

    /// The place nearest to one `length` along the line that is clear of both ends, by a third of what is free there.
    fn clear_of_ends(&self, length: f64) -> f64 {
        if self.closed {
            return length;
        }
        let free = [self.sites[0].0, self.length() - self.sites[self.sites.len() - 1].0];
        length.clamp(free[0] / 3.0, self.length() - free[1] / 3.0)
    }

    /// The places of the line that are nearest to a point: its straight distance, and the lengths of the line before them. Of several as
    /// near, those that are farther than `apart` from one another.
    fn nearest(&self, p: DVec2, apart: f64) -> (f64, Vec<f64>) {
        let n = self.corners.len();
        let feet: Vec<(DVec2, f64)> = (0..self.lengths.len() - 1)
            .map(|edge| {
                let (a, b) = (self.corners[edge], self.corners[(edge + 1) % n]);
                let foot = nearest_on_segment(p, a, b);
                (foot, self.lengths[edge] + foot.distance(a))
            })
            .collect();
        let least = feet.iter().map(|(foot, _)| foot.distance(p)).fold(f64::INFINITY, f64::min);
        let mut kept: Vec<(DVec2, f64)> = Vec::new();
        for (foot, length) in feet {
            let is_new = || kept.iter().all(|(known, _)| known.distance(foot) > apart);
            if foot.distance(p) <= least * (1.0 + TIE) && is_new() {
                kept.push((foot, length));
            }
        }
        (least, kept.into_iter().map(|(_, length)| length).collect())
    }

    fn has_site_near(&self, length: f64, within: f64) -> bool {
        self.sites.iter().any(|&(known, _)| (known - length).abs() < within)
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

/// A site to be inserted.
struct NewSite {
    rest: DVec2,
    place: Place,
    origin: Origin,
    /// The chain that it is of, and the length of the chain before it.
    on_chain: Option<(usize, f64)>,
}

impl NewSite {
    fn of_chain(navigation: &Navigation, (at, chain): (usize, &Chain), length: f64) -> Self {
        let rest = chain.at(length);
        let place = navigation.place(rest).expect("lines lie in the domain");
        Self { rest, place, origin: chain.origin, on_chain: Some((at, length)) }
    }
}

impl Regions<'_> {
    /// Inserts the real sites: point handles (where, and index), and the first ones of bones and of a held outline, from top to
    /// bottom.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(crate) fn insert_real_sites(&mut self, points: &[(DVec2, Place, u32)]) -> Result<(), Error> {
        let navigation = self.navigation;
        let bones = self.obstacles.skeleton.bones.iter().enumerate().map(|(at, bone)| {
            let origin = Origin::Bone { handle: bone.handle, bone: at as u32 };
            Chain::new(origin, bone.rest.to_vec(), false)
        });
        let rings = self.obstacles.held.map_or(&[][..], Domain::rings);
        let outline = rings.iter().map(|ring| Chain::new(Origin::Boundary, ring.clone(), true));
        self.chains = bones.chain(outline).collect();
        let of_points = points.iter().map(|&(rest, place, handle)| {
            let origin = Origin::Point { handle };
            NewSite { rest, place, origin, on_chain: None }
        });
        let of_chains = self.chains.iter().enumerate().flat_map(|chain| {
            let lengths = chain.1.start().into_iter();
            lengths.map(move |length| NewSite::of_chain(navigation, chain, length))
        });
        let sites = of_points.chain(of_chains).collect();
        self.insert_from_top(sites)?;
        self.tessellate()
    }

    /// Closes the gaps between the sites of chains.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(super) fn tessellate(&mut self) -> Result<(), Error> {
        let navigation = self.navigation;
        loop {
            let of_chains = self.chains.iter().enumerate().flat_map(|chain| {
                let lengths = chain.1.wanted(|site| self.sites[site].reach_limit()).into_iter();
                lengths.map(move |length| NewSite::of_chain(navigation, chain, length))
            });
            let sites: Vec<NewSite> = of_chains.collect();
            if sites.is_empty() {
                return Ok(());
            }
            self.insert_from_top(sites)?;
        }
    }

    /// Inserts virtual sites at points, or, where one would be too near to a bone or held outline, a site of that. Tells how many
    /// are virtual.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(super) fn insert_virtual(&mut self, points: &[FarPoint]) -> Result<usize, Error> {
        let (mut sites, mut count) = (Vec::new(), 0);
        for point in points {
            if point.distance < NOTHING {
                return Err(Error::TooManySites);
            }
            let encroached = self.encroached_on(point);
            if encroached.is_empty() {
                count += 1;
                sites.push(NewSite { rest: point.at, place: point.place, origin: Origin::Virtual, on_chain: None });
            }
            for (chain, length) in encroached {
                sites.push(NewSite::of_chain(self.navigation, (chain, &self.chains[chain]), length));
            }
        }
        self.insert_from_top(sites)?;
        Ok(count)
    }

    /// The chain that a virtual site would be too near to, and the length of it before the nearest place that may have a site. Several
    /// where they are as near, of one chain or of many.
    fn encroached_on(&mut self, point: &FarPoint) -> Vec<(usize, f64)> {
        // In a nook the sites of bones are what ends a cell, so they come first.
        let is_in_nook = self.is_in_nook(point.at, point.place, point.distance);
        let (clear, there) = (if is_in_nook { 1.0 } else { CLEAR } * point.distance, THERE * point.distance);
        let mut near: Vec<(usize, f64, f64)> = Vec::new();
        for (at, chain) in self.chains.iter().enumerate() {
            let (distance, lengths) = chain.nearest(point.at, there);
            if distance < clear {
                let lengths = lengths.into_iter().map(|length| chain.clear_of_ends(length));
                near.extend(lengths.filter(|&l| !chain.has_site_near(l, there)).map(|length| (at, length, distance)));
            }
        }
        if near.is_empty() {
            return Vec::new();
        }
        let field = self.field(point.at, point.place, clear);
        for (at, _, distance) in &mut near {
            // Nothing is between a point and the nearest of the outline.
            if let Origin::Bone { bone, .. } = self.chains[*at].origin {
                *distance = self.obstacles.tracks[bone as usize].distance(&field);
            }
        }
        let least = near.iter().fold(clear, |least, &(.., distance)| least.min(distance));
        near.retain(|&(.., distance)| distance < clear && distance <= least * (1.0 + TIE));
        near.into_iter().map(|(at, length, _)| (at, length)).collect()
    }

    fn insert_from_top(&mut self, mut sites: Vec<NewSite>) -> Result<(), Error> {
        if self.sites.len() + sites.len() > MAX_SITES {
            return Err(Error::TooManySites);
        }
        sites.sort_by(|a, b| a.rest.y.total_cmp(&b.rest.y).then(a.rest.x.total_cmp(&b.rest.x)));
        for NewSite { rest, place, origin, on_chain } in sites {
            if let Some((chain, length)) = on_chain {
                let sites = &mut self.chains[chain].sites;
                let at = sites.partition_point(|&(known, _)| known < length);
                sites.insert(at, (length, self.sites.len()));
            }
            self.insert(rest, place, origin);
        }
        Ok(())
    }
}
