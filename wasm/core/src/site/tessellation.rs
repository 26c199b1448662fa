//! Sites along bones and along a held outline (section V-D; locally adapted, which the paper's conclusion leaves to future
//! work).
//!
//! The paper divides all bars into pieces as long as the least distance between any two handles. Here the gap between sites
//! depends on their own reach, so that a close pair costs sites in its surroundings only: where a gap is larger than a share
//! of the reach of the sites at its ends, a site enters at its midpoint. Supports then overlap so far that the weight of a
//! bar is constant along it within a few per cent. Gaps are checked again whenever Algorithm 1 has inserted sites.
//!
//! A virtual site must keep clear of the whole bone, not of its sites alone. One that would be much nearer to the bone than
//! to any site is not inserted: the bone gets a site there instead, as Ruppert's Delaunay refinement (1995) splits a segment
//! that a new vertex encroaches on. Without this, ever smaller cells would crowd before the gaps.
//!
//! Sites of a bone keep half a gap from its ends, and so a whole gap across a joint. A site at the joint itself would belong
//! to one bone, and the other would get none.

use glam::DVec2;

use super::{
    PointSite, SiteKind,
    regions::{FarPoint, Regions},
    virtual_sites::TIE,
};
use crate::{
    distance::{Navigation, Place},
    domain::Domain,
    error::Error,
    limits::MAX_SITES,
    segment::nearest_on_segment,
};

/// Greatest gap over the reach of the sites at its ends.
const MAX_GAP: f64 = 0.5;
/// Corners of a held outline at which the cosine of the turning angle is below this get a site each: more than 20°.
const SHARP_COSINE: f64 = 0.94;

/// A site closer to another than this, in pixels, is requested only because of rounding, and insertion would not end.
const MIN_SPACING_PX: f64 = 1e-9;
/// Least distance of a virtual site from a bone or held outline, over its distance from the nearest site.
const LINE_CLEARANCE: f64 = 0.9;
/// A site on a bone serves for a wanted place within this share of the distance.
const NEAR_ENOUGH: f64 = 0.05;

/// A line with sites on it.
pub(super) struct Chain {
    kind: SiteKind,
    corners: Vec<DVec2>,
    /// Arc length at each corner, and at the end.
    lengths: Vec<f64>,
    closed: bool,
    /// Arc length and index of each site, ascending.
    sites: Vec<(f64, usize)>,
}

impl Chain {
    fn new(kind: SiteKind, corners: Vec<DVec2>, closed: bool) -> Self {
        let n = corners.len();
        let edges = if closed { n } else { n - 1 };
        let mut lengths = vec![0.0];
        for i in 0..edges {
            lengths.push(lengths[i] + corners[i].distance(corners[(i + 1) % n]));
        }
        Self { kind, corners, lengths, closed, sites: Vec::new() }
    }

    fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    fn at(&self, length: f64) -> DVec2 {
        let edge = self.lengths[1..self.lengths.len() - 1].partition_point(|&end| end <= length);
        let (from, to) = (self.corners[edge], self.corners[(edge + 1) % self.corners.len()]);
        from.lerp(to, (length - self.lengths[edge]) / (self.lengths[edge + 1] - self.lengths[edge]))
    }

    /// Arc lengths of the first sites.
    fn start(&self) -> Vec<f64> {
        if !self.closed {
            return vec![self.length() / 2.0];
        }
        let n = self.corners.len();
        let is_sharp = |i: usize| {
            let [before, at, after] = [i + n - 1, i, i + 1].map(|at| self.corners[at % n]);
            (at - before).normalize().dot((after - at).normalize()) < SHARP_COSINE
        };
        let sharp: Vec<f64> = (0..n).filter(|&i| is_sharp(i)).map(|i| self.lengths[i]).collect();
        if sharp.is_empty() { self.lengths[..n].to_vec() } else { sharp }
    }

    /// The arc length nearest to `length` that is clear of both ends, by a third of what is free there.
    fn clear_of_ends(&self, length: f64) -> f64 {
        if self.closed {
            return length;
        }
        let free = [self.sites[0].0, self.length() - self.sites[self.sites.len() - 1].0];
        length.clamp(free[0] / 3.0, self.length() - free[1] / 3.0)
    }

    /// The straight distance from a point to the line, and the arc lengths of the nearest places. Of tied places, those
    /// farther than `apart` from one another.
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

    /// Arc lengths of new sites: in gaps that are too large for the reach of the sites at their ends.
    fn wanted(&self, reach: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut wanted = Vec::new();
        let limit = |i: usize, j: usize| MAX_GAP * reach(self.sites[i].1).min(reach(self.sites[j].1));
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

/// A site about to be inserted.
struct NewSite {
    rest: DVec2,
    place: Place,
    kind: SiteKind,
    /// The chain that the site belongs to, and its arc length there.
    on_chain: Option<(usize, f64)>,
}

impl NewSite {
    fn of_chain(navigation: &Navigation, (at, chain): (usize, &Chain), length: f64) -> Self {
        let rest = chain.at(length);
        let place = navigation.place(rest).expect("lines lie in the domain");
        Self { rest, place, kind: chain.kind, on_chain: Some((at, length)) }
    }
}

impl Regions<'_> {
    /// Inserts the real sites: those of point handles, and the first sites of bones and of a held outline, from top
    /// to bottom.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(crate) fn insert_real_sites(&mut self, points: &[PointSite]) -> Result<(), Error> {
        let navigation = self.navigation;
        let bones = self.obstacles.skeleton.bones.iter().enumerate().map(|(at, bone)| {
            let kind = SiteKind::Bone { handle: bone.handle, bone: at as u32 };
            Chain::new(kind, bone.rest.to_vec(), false)
        });
        let rings = self.obstacles.held.map_or(&[][..], Domain::rings);
        let outline = rings.iter().map(|ring| Chain::new(SiteKind::Boundary, ring.clone(), true));
        self.chains = bones.chain(outline).collect();
        let of_points = points.iter().map(|&PointSite { rest, place, handle }| {
            let kind = SiteKind::Point { handle };
            NewSite { rest, place, kind, on_chain: None }
        });
        let of_chains = self.chains.iter().enumerate().flat_map(|chain| {
            let lengths = chain.1.start().into_iter();
            lengths.map(move |length| NewSite::of_chain(navigation, chain, length))
        });
        let sites = of_points.chain(of_chains).collect();
        self.insert_from_top(sites)?;
        self.tessellate()
    }

    /// Inserts sites on chains until no gap is too large.
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

    /// Inserts virtual sites at points, or, for a point too near to a bone or held outline, a site on that line. Returns the
    /// number of virtual ones.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(super) fn insert_virtual(&mut self, points: &[FarPoint]) -> Result<usize, Error> {
        let (mut sites, mut count) = (Vec::new(), 0);
        for point in points {
            if point.distance < MIN_SPACING_PX {
                return Err(Error::TooManySites);
            }
            let encroached = self.encroached_on(point);
            if encroached.is_empty() {
                count += 1;
                sites.push(NewSite { rest: point.at, place: point.place, kind: SiteKind::Virtual, on_chain: None });
            }
            for (chain, length) in encroached {
                sites.push(NewSite::of_chain(self.navigation, (chain, &self.chains[chain]), length));
            }
        }
        self.insert_from_top(sites)?;
        Ok(count)
    }

    /// The chains that a virtual site would encroach on, each with the arc length of the nearest place that may have a site.
    /// Several where they are equally near, on one chain or on many.
    fn encroached_on(&mut self, point: &FarPoint) -> Vec<(usize, f64)> {
        // In a nook the sites of bones bound the cell, so they come first.
        let is_in_nook = self.is_in_nook(point.at, point.place, point.distance);
        let (clear, there) =
            (if is_in_nook { 1.0 } else { LINE_CLEARANCE } * point.distance, NEAR_ENOUGH * point.distance);
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
            // The straight line to the nearest point of the outline is not obstructed.
            if let SiteKind::Bone { bone, .. } = self.chains[*at].kind {
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
        for NewSite { rest, place, kind, on_chain } in sites {
            if let Some((chain, length)) = on_chain {
                let sites = &mut self.chains[chain].sites;
                let at = sites.partition_point(|&(known, _)| known < length);
                sites.insert(at, (length, self.sites.len()));
            }
            self.insert(rest, place, kind);
        }
        Ok(())
    }
}
