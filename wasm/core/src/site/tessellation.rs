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

use super::{PointSite, Regions, SiteKind, TIE, chain::Chain, farthest::FarPoint};
use crate::{
    distance::{NavTriangle, Navigation},
    domain::Domain,
    error::Error,
    limits::MAX_SITES,
};

/// A site closer to another than this, in pixels, is requested only because of rounding, and insertion would not end.
const MIN_SPACING_PX: f64 = 1e-9;
/// Least distance of a virtual site from a bone or held outline, over its distance from the nearest site.
const LINE_CLEARANCE: f64 = 0.9;
/// A site on a bone serves for a wanted place within this share of the distance.
const NEAR_ENOUGH: f64 = 0.05;

/// A site about to be inserted.
struct NewSite {
    rest: DVec2,
    triangle: NavTriangle,
    kind: SiteKind,
    /// The chain that the site belongs to, and its arc length there.
    on_chain: Option<(usize, f64)>,
}

impl NewSite {
    fn of_chain(navigation: &Navigation, (at, chain): (usize, &Chain), length: f64) -> Self {
        let (triangle, rest) = navigation.locate(chain.at(length)).expect("lines lie in the domain");
        Self { rest, triangle, kind: chain.kind, on_chain: Some((at, length)) }
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
        let of_points = points.iter().map(|&PointSite { rest, triangle, handle }| {
            let kind = SiteKind::Point { handle };
            NewSite { rest, triangle, kind, on_chain: None }
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
                sites.push(NewSite {
                    rest: point.at,
                    triangle: point.triangle,
                    kind: SiteKind::Virtual,
                    on_chain: None,
                });
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
        let is_in_nook = self.is_in_nook(point.at, point.triangle, point.distance);
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
        let field = self.field(point.at, point.triangle, clear);
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
        for NewSite { rest, triangle, kind, on_chain } in sites {
            if let Some((chain, length)) = on_chain {
                let sites = &mut self.chains[chain].sites;
                let at = sites.partition_point(|&(known, _)| known < length);
                sites.insert(at, (length, self.sites.len()));
            }
            self.insert(rest, triangle, kind);
        }
        Ok(())
    }
}
