//! Contacts: where the cells of two handles meet with nothing virtual between them.
//!
//! There the picture has to go from one motion to another within the reach of both, by the basis function's slope alone. A site
//! halfway shares the way out, and its motion is free. Algorithm 1 looks at the farthest point of a cell, which is on its open side: a
//! narrow gap between two bars would be the last to be divided.
//!
//! Cost: a look at every scout's neighbours where real sites are new, afterwards at the contacts that are left.

use super::{
    Origin,
    regions::{FarPoint, Regions},
    virtual_sites::TIE,
};

/// A place on the border of the cells of two real sites, which are not of one body.
#[derive(Debug, Clone, Copy)]
struct Contact {
    /// Two scouts that are neighbours, and the sites they are nearest to.
    edge: [u32; 2],
    sites: [u32; 2],
    /// Where the border crosses the edge.
    point: FarPoint,
}

/// All contacts, as far as they are not known to be closed.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    list: Vec<Contact>,
    /// So many real sites they were looked for among.
    real_sites: usize,
}

impl Contacts {
    /// The widest that are still open, more than one where there is a tie; empty where there is none.
    pub(super) fn widest(&mut self, regions: &Regions) -> Vec<FarPoint> {
        let real_sites = regions.sites.iter().filter(|site| site.origin.is_real()).count();
        if self.real_sites != real_sites {
            *self = Self { list: regions.contacts().collect(), real_sites };
        }
        self.list.retain(|contact| contact.edge.map(|scout| regions.cells.nearest[scout as usize]) == contact.sites);
        let widest = self.list.iter().map(|contact| contact.point.distance).fold(0.0, f64::max);
        let tied = self.list.iter().filter(|contact| contact.point.distance >= (1.0 - TIE) * widest);
        tied.map(|contact| contact.point).collect()
    }
}

impl Regions<'_> {
    fn contacts(&self) -> impl Iterator<Item = Contact> + '_ {
        (0..self.scouts.len() as u32).flat_map(move |a| {
            let forward = self.scouts.graph.of(a as usize).iter().filter(move |&&b| a < b);
            forward.filter_map(move |&b| self.contact([a, b]))
        })
    }

    fn contact(&self, edge: [u32; 2]) -> Option<Contact> {
        let sites = edge.map(|scout| self.cells.nearest[scout as usize]);
        let of_edge = sites.map(|site| self.sites.get(site as usize));
        let [Some(s), Some(t)] = of_edge else { return None };
        let are_apart =
            s.origin.is_real() && t.origin.is_real() && sites[0] != sites[1] && !self.are_one_body(s.origin, t.origin);
        if !are_apart {
            return None;
        }
        let [a, b] = edge.map(|scout| self.scouts.mesh.vertices[scout as usize]);
        let [place_a, place_b] = edge.map(|scout| self.scouts.places[scout as usize]);
        // By how much the other site is farther: both nearly linear along the edge.
        let off_a = t.field.distance(place_a, a) - self.cells.distance[edge[0] as usize];
        let off_b = s.field.distance(place_b, b) - self.cells.distance[edge[1] as usize];
        let share = off_a / (off_a + off_b);
        let at = a.lerp(b, if share.is_finite() { share } else { 0.5 });
        let place = self.navigation.place(at)?;
        Some(Contact {
            edge,
            sites,
            point: FarPoint { at, place, distance: self.nearest_distance(place, at, f64::INFINITY) },
        })
    }

    fn are_one_body(&self, a: Origin, b: Origin) -> bool {
        self.body(a).is_some() && self.body(a) == self.body(b)
    }
}
