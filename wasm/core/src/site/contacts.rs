//! Contacts: where the cells of two handles meet with nothing virtual between them.
//!
//! There the picture has to go from one motion to another within the reach of both, by the basis function's slope alone. A site
//! halfway shares the way out, and its motion is free. Algorithm 1 looks at the farthest point of a cell, which is on its open side: a
//! narrow gap between two bars would be the last to be divided.
//!
//! Each is found between two scouts, and where it is does not depend on them: on the border itself.
//!
//! Cost: a look at every scout's neighbours where real sites are new, afterwards at the contacts that are left and the sites that are new.

use glam::DVec2;

use super::{
    Site,
    regions::{FarPoint, Regions},
    virtual_sites::TIE,
};
use crate::distance::Foot;

/// Steps onto the border, as Newton's method does them. Between two points the first ends there.
const STEPS: usize = 3;
/// Directions that differ by a smaller square lead along the border, not to it.
const ALONG: f64 = 1e-3;

/// All contacts, as far as they are not known to be closed.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    list: Vec<FarPoint>,
    /// So many real sites they were looked for among.
    real_sites: usize,
    /// So many sites are known to be no nearer than those that meet there.
    sites: usize,
}

impl Contacts {
    /// The widest that are still open, more than one where there is a tie; empty where there is none.
    pub(super) fn widest(&mut self, regions: &Regions) -> Vec<FarPoint> {
        let real_sites = regions.sites.iter().filter(|site| site.origin.is_real()).count();
        if self.real_sites != real_sites {
            *self = Self { list: regions.contacts().collect(), real_sites, sites: regions.sites.len() };
        }
        let new = &regions.sites[self.sites..];
        let closes = |site: &Site, contact: &FarPoint| {
            site.rest.distance(contact.at) < contact.distance
                && site.field.distance(contact.place, contact.at) < contact.distance
        };
        self.list.retain(|contact| !new.iter().any(|site| closes(site, contact)));
        self.sites = regions.sites.len();
        let widest = self.list.iter().map(|contact| contact.distance).fold(0.0, f64::max);
        self.list.iter().filter(|contact| contact.distance >= (1.0 - TIE) * widest).copied().collect()
    }
}

impl Regions<'_> {
    fn contacts(&self) -> impl Iterator<Item = FarPoint> + '_ {
        (0..self.scouts.len()).flat_map(move |a| {
            let forward = self.scouts.graph.of(a).iter().map(|&b| b as usize).filter(move |&b| a < b);
            forward.filter_map(move |b| self.contact([a, b]))
        })
    }

    /// Where the cells meet that two scouts are in, if those are of two handles.
    fn contact(&self, edge: [usize; 2]) -> Option<FarPoint> {
        let sites = edge.map(|scout| self.cells.nearest[scout] as usize);
        let [Some(s), Some(t)] = sites.map(|site| self.sites.get(site)) else { return None };
        let are_real = s.origin.is_real() && t.origin.is_real();
        if sites[0] == sites[1] || !are_real || !self.is_obstacle(sites[1], s.island, self.body(s.origin)) {
            return None;
        }
        let [a, b] = edge.map(|scout| self.scouts.mesh.vertices[scout]);
        // By how much the other site is farther: both nearly linear along the edge.
        let off_a = t.field.distance(self.scouts.places[edge[0]], a) - self.cells.distance[edge[0]];
        let off_b = s.field.distance(self.scouts.places[edge[1]], b) - self.cells.distance[edge[1]];
        let share = off_a / (off_a + off_b);
        self.on_border(a.lerp(b, if share.is_finite() { share } else { 0.5 }), s, t)
    }

    /// The point near another that is as far from one site as from the other, if there is nothing virtual nearer.
    fn on_border(&self, mut p: DVec2, s: &Site, t: &Site) -> Option<FarPoint> {
        let mut place = self.navigation.place(p)?;
        for _ in 0..STEPS {
            let (to_s, to_t) = (s.field.foot(place, p)?, t.field.foot(place, p)?);
            let apart = direction(to_s, p) - direction(to_t, p);
            if apart.length_squared() < ALONG {
                break;
            }
            p -= (to_s.distance - to_t.distance) * apart / apart.length_squared();
            place = self.navigation.place(p)?;
        }
        let (distance, site) = self.nearest(place, p)?;
        site.origin.is_real().then_some(FarPoint { at: p, place, distance })
    }
}

/// Where paths from a site come from.
fn direction(foot: Foot, p: DVec2) -> DVec2 {
    (p - foot.pseudo_source).normalize_or_zero()
}
