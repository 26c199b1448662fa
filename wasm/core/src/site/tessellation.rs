//! Sites along bones and along a held outline (section V-D). The spacing is locally adapted, which the paper's
//! conclusion leaves to future work.
//!
//! The paper divides all bars into pieces as long as the minimum distance between any two handles. Here, a gap between
//! sites depends on the reach of the sites at its ends, so a close pair only costs sites near it. If a gap is too large
//! for their reach, a site is inserted at its midpoint. Supports then overlap enough for the weight of a bar to be
//! constant along it within a few per cent. Gaps are checked again after each round of Algorithm 1.
//!
//! A virtual site must keep clear of the whole bone, not only of its sites. If it would be much nearer to the bone than
//! to any site, the bone gets a site instead. In the same way Ruppert's Delaunay refinement (1995) splits a segment
//! that a new vertex encroaches on. Otherwise, ever smaller cells would fill the gaps along the bone.
//!
//! Sites of a bone keep half a gap from its ends, and so a whole gap across a joint. A site at the joint itself would
//! belong to only one bone.
//!
//! Cost: for each round a pass over all chains and their sites.

use glam::DVec2;

use super::{PointSite, SiteInserter, SiteKind, TIE, chain::Chain, farthest::FarPoint, obstacles::Obstacles};
use crate::{
    distance::{NavTriangle, Navigation},
    domain::Domain,
    error::Error,
    limits::MAX_SITES,
    rank::{from_top, sort_by_rank},
};

/// Only rounding errors require a site closer to another than this, in pixels. Insertion would then not terminate.
const MIN_SPACING_PX: f64 = 1e-9;
/// Minimum distance of a virtual site from a bone or held outline, relative to its distance from the nearest site.
const LINE_CLEARANCE: f64 = 0.9;
/// A chain needs no new site if it has one this close to the encroached point, relative to the distance of that point.
const NEAR_ENOUGH: f64 = 0.05;

/// The chains of a scene: its bones and the rings of a held outline.
pub(crate) struct Tessellation {
    chains: Vec<Chain>,
}

/// A site about to be inserted.
struct NewSite {
    rest: DVec2,
    triangle: NavTriangle,
    kind: SiteKind,
    /// The index of the site's chain, and its arc length there.
    on_chain: Option<(usize, f64)>,
}

impl NewSite {
    fn on_chain(navigation: &Navigation, (at, chain): (usize, &Chain), length: f64) -> Self {
        let (triangle, rest) = navigation.locate(chain.at(length)).expect("lines lie in the domain");
        Self { rest, triangle, kind: chain.kind, on_chain: Some((at, length)) }
    }
}

impl Tessellation {
    /// The chains of a scene, without sites.
    pub(crate) fn new(obstacles: &Obstacles) -> Self {
        let bones = obstacles.skeleton().bones.iter().enumerate().map(|(at, bone)| {
            let kind = SiteKind::Bone { handle: bone.handle, bone: at as u32 };
            Chain::new(kind, bone.rest.to_vec(), false)
        });
        let rings = obstacles.held().map_or(&[][..], Domain::rings);
        let outline = rings.iter().map(|ring| Chain::new(SiteKind::Boundary, ring.clone(), true));
        Self { chains: bones.chain(outline).collect() }
    }

    /// Inserts the real sites from top to bottom: those of point handles, and those along the chains.
    ///
    /// # Errors
    /// [`Error::TooManySites`], [`Error::TooMuchMemory`], [`Error::TooMuchWork`].
    pub(crate) fn insert_real_sites(&mut self, inserter: &mut SiteInserter, points: &[PointSite]) -> Result<(), Error> {
        let navigation = inserter.voronoi.navigation;
        let of_points = points.iter().map(|&PointSite { rest, triangle, handle }| {
            let kind = SiteKind::Point { handle };
            NewSite { rest, triangle, kind, on_chain: None }
        });
        let of_chains = self.chains.iter().enumerate().flat_map(|chain| {
            let lengths = chain.1.initial_sites().into_iter();
            lengths.map(move |length| NewSite::on_chain(navigation, chain, length))
        });
        let sites: Vec<NewSite> = of_points.chain(of_chains).collect();
        inserter.expect(sites.iter().map(|site| site.rest));
        self.insert_from_top(inserter, sites)?;
        self.refine(inserter)
    }

    /// Inserts sites on chains until no gap is too large.
    ///
    /// # Errors
    /// [`Error::TooManySites`], [`Error::TooMuchMemory`], [`Error::TooMuchWork`].
    pub(super) fn refine(&mut self, inserter: &mut SiteInserter) -> Result<(), Error> {
        let navigation = inserter.voronoi.navigation;
        loop {
            let of_chains = self.chains.iter().enumerate().flat_map(|chain| {
                let lengths = chain.1.missing_sites(|site| inserter.sites()[site].reach_limit()).into_iter();
                lengths.map(move |length| NewSite::on_chain(navigation, chain, length))
            });
            let sites: Vec<NewSite> = of_chains.collect();
            if sites.is_empty() {
                return Ok(());
            }
            self.insert_from_top(inserter, sites)?;
        }
    }

    /// Inserts a virtual site at each point, or a site on the chains that it would encroach on. Returns the number of
    /// virtual sites.
    ///
    /// # Errors
    /// [`Error::TooManySites`], [`Error::TooMuchMemory`], [`Error::TooMuchWork`].
    pub(super) fn insert_virtual(&mut self, inserter: &mut SiteInserter, points: &[FarPoint]) -> Result<usize, Error> {
        let (mut sites, mut count) = (Vec::new(), 0);
        for point in points {
            if point.distance < MIN_SPACING_PX {
                return Err(Error::TooManySites);
            }
            let encroached = self.encroached_on(inserter, point);
            if encroached.is_empty() {
                count += 1;
                let (rest, triangle) = (point.at, point.triangle);
                sites.push(NewSite { rest, triangle, kind: SiteKind::Virtual, on_chain: None });
            }
            for (chain, length) in encroached {
                let on_chain = (chain, &self.chains[chain]);
                sites.push(NewSite::on_chain(inserter.voronoi.navigation, on_chain, length));
            }
        }
        self.insert_from_top(inserter, sites)?;
        Ok(count)
    }

    /// The chains that a virtual site would encroach on, each with the arc length of the nearest point that may get a
    /// site. Equally near points are all returned, on one chain or on several.
    fn encroached_on(&self, inserter: &mut SiteInserter, point: &FarPoint) -> Vec<(usize, f64)> {
        // In an acute joint the sites of bones bound the cell, so they come first.
        let is_in_acute_joint = inserter.is_in_acute_joint(point.at, point.triangle, point.distance);
        let clearance = if is_in_acute_joint { 1.0 } else { LINE_CLEARANCE };
        let (clear, apart) = (clearance * point.distance, NEAR_ENOUGH * point.distance);
        let mut near: Vec<(usize, f64, f64)> = Vec::new();
        for (at, chain) in self.chains.iter().enumerate() {
            let (distance, lengths) = chain.nearest(point.at, apart);
            if distance < clear {
                let lengths = lengths.into_iter().map(|length| chain.clear_of_ends(length));
                near.extend(lengths.filter(|&l| !chain.has_site_near(l, apart)).map(|length| (at, length, distance)));
            }
        }
        if near.is_empty() {
            return Vec::new();
        }
        let field = inserter.field(point.at, point.triangle, clear);
        for (at, _, distance) in &mut near {
            // The straight line to the nearest point of the outline is never obstructed.
            if let SiteKind::Bone { bone, .. } = self.chains[*at].kind {
                *distance = inserter.obstacles.distance_to_bone(bone, &field);
            }
        }
        let least = near.iter().fold(clear, |least, &(.., distance)| least.min(distance));
        near.retain(|&(.., distance)| distance < clear && distance <= least * (1.0 + TIE));
        near.into_iter().map(|(at, length, _)| (at, length)).collect()
    }

    fn insert_from_top(&mut self, inserter: &mut SiteInserter, mut sites: Vec<NewSite>) -> Result<(), Error> {
        if inserter.sites().len() + sites.len() > MAX_SITES {
            return Err(Error::TooManySites);
        }
        sort_by_rank(&mut sites, |site| from_top(site.rest));
        for NewSite { rest, triangle, kind, on_chain } in sites {
            if let Some((chain, length)) = on_chain {
                let sites = &mut self.chains[chain].sites;
                let at = sites.partition_point(|&(known, _)| known < length);
                sites.insert(at, (length, inserter.sites().len()));
            }
            inserter.insert(rest, triangle, kind)?;
        }
        Ok(())
    }
}
