//! Contacts: where the cells of two handles meet with nothing virtual between them.
//!
//! There the picture has to go from one motion to another within the reach of both, by the basis function's slope alone. A site
//! halfway shares the way out, and its motion is free. Algorithm 1 looks at the farthest point of a cell, which is on its open side: a
//! narrow gap between two bars would be the last to be divided.
//!
//! Each is found between two coarse samples and lies on the border itself. Where along the border, they decide: it is where the edge between
//! them leads across it. So these sites change where the lattice of coarse samples does: where the picture is turned, or its outline has one more
//! corner.
//!
//! Cost: each time that real sites are new, a look at every triangle of coarse samples, and for each coarse sample on the border of a cell at the real sites
//! that are about as near as its own; for each pair of them that two handles meet between, at all sites. Afterwards a look at the contacts
//! that are left and the sites that are new.

use std::collections::HashMap;

use glam::DVec2;

use super::{Regions, Site, TIE, farthest::FarPoint};
use crate::{grid::Grid, limits::MIN_SEPARATION};

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
        let real_sites = regions.sites.iter().filter(|site| site.kind.is_real()).count();
        if self.real_sites != real_sites {
            *self = Self { list: regions.contacts(), real_sites, sites: regions.sites.len() };
        }
        let new = &regions.sites[self.sites..];
        let closes = |site: &Site, contact: &FarPoint| {
            site.rest.distance(contact.at) < contact.distance
                && site.field.distance(contact.triangle, contact.at) < contact.distance
        };
        self.list.retain(|contact| !new.iter().any(|site| closes(site, contact)));
        self.sites = regions.sites.len();
        let widest = self.list.iter().map(|contact| contact.distance).fold(0.0, f64::max);
        self.list.iter().filter(|contact| contact.distance >= (1.0 - TIE) * widest).copied().collect()
    }
}

impl Regions<'_> {
    fn contacts(&self) -> Vec<FarPoint> {
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        let are_apart = |[a, b]: [u32; 2]| self.cells.nearest[a as usize] != self.cells.nearest[b as usize];
        let add_pairs = |edges: &[[u32; 2]]| {
            let ends = |&[a, _]: &[u32; 2]| edges.iter().map(move |&[b, _]| [a, b]);
            pairs.extend(edges.iter().flat_map(ends).filter(|&[a, b]| a < b && are_apart([a, b])));
        };
        self.coarse.mesh.visit_polygons(|[a, b, c]| are_apart([a, b]) || are_apart([b, c]), add_pairs);
        // Most come from both sides.
        pairs.sort_unstable();
        pairs.dedup();
        let nearest = self.nearest_handles(pairs.as_flattened());
        let contacts = |pair: [u32; 2]| self.contacts_between(pair, pair.map(|sample| &nearest[&sample][..]));
        pairs.iter().flat_map(|&pair| contacts(pair)).collect()
    }

    /// Where the cells meet that two coarse samples are in, if those are of two handles.
    fn contacts_between<'a>(
        &'a self,
        coarse: [u32; 2],
        [of_a, of_b]: [&'a [usize]; 2],
    ) -> impl Iterator<Item = FarPoint> + 'a {
        let sites = of_a.iter().flat_map(move |&s| of_b.iter().map(move |&t| [s, t]));
        sites.filter_map(move |[s, t]| {
            let (a, b) = (&self.sites[s], &self.sites[t]);
            let are_apart = s != t && self.is_obstacle(t, a.island, self.body(a.kind));
            let coarse = coarse.map(|sample| sample as usize);
            are_apart.then(|| self.on_border(self.between(coarse, a, b), a, b)).flatten()
        })
    }

    /// For each of some coarse samples, the real sites nearest to it, ascending: several where it is on a border, as on an axis of
    /// symmetry.
    fn nearest_handles(&self, coarse: &[u32]) -> HashMap<u32, Vec<usize>> {
        let distances = coarse.iter().map(|&sample| self.cells.distance[sample as usize]);
        // The average radius of a query, which then touches a few cells of the grid.
        let side = (distances.sum::<f64>() / coarse.len() as f64).max(MIN_SEPARATION);
        let real = self.sites.iter().enumerate().filter(|(_, site)| site.kind.is_real());
        let grid = Grid::new(side, real.map(|(at, site)| (site.rest, at)));
        let nearest = |sample: usize| {
            let (triangle, p) = (self.coarse.nav_triangles[sample], self.coarse.mesh.vertices[sample]);
            let within = self.cells.distance[sample] * (1.0 + TIE);
            let is_near = |site: &Site| site.rest.distance(p) <= within && site.field.distance(triangle, p) <= within;
            let mut near: Vec<usize> = grid.around(p, within).filter(|&at| is_near(&self.sites[at])).collect();
            near.sort_unstable();
            near
        };
        let mut known = HashMap::new();
        for &sample in coarse {
            known.entry(sample).or_insert_with(|| nearest(sample as usize));
        }
        known
    }

    /// About where the border of two sites is between two coarse samples, one in the cell of each.
    fn between(&self, coarse: [usize; 2], s: &Site, t: &Site) -> DVec2 {
        let [a, b] = coarse.map(|sample| self.coarse.mesh.vertices[sample]);
        // By how much the other site is farther: both nearly linear along the edge.
        let off_a = t.field.distance(self.coarse.nav_triangles[coarse[0]], a) - self.cells.distance[coarse[0]];
        let off_b = s.field.distance(self.coarse.nav_triangles[coarse[1]], b) - self.cells.distance[coarse[1]];
        let share = off_a / (off_a + off_b);
        a.lerp(b, if share.is_finite() { share } else { 0.5 })
    }

    /// The point near another that is as far from one site as from the other, if there is nothing virtual nearer.
    fn on_border(&self, mut p: DVec2, s: &Site, t: &Site) -> Option<FarPoint> {
        let mut triangle = self.navigation.triangle_at(p)?;
        for _ in 0..STEPS {
            let [(to_s, from_s), (to_t, from_t)] =
                [s.field.distance_and_gradient(triangle, p)?, t.field.distance_and_gradient(triangle, p)?];
            let apart = from_s - from_t;
            if apart.length_squared() < ALONG {
                break;
            }
            p -= (to_s - to_t) * apart / apart.length_squared();
            // Beside the outline by what counts as rounding, it is moved onto it: no site is outside.
            (triangle, p) = self.navigation.locate(p)?;
        }
        let (distance, site) = self.nearest(triangle, p)?;
        site.kind.is_real().then_some(FarPoint { at: p, triangle, distance })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Picture,
        bone::Skeleton,
        distance::Propagation,
        domain::Domain,
        prepared_domain::PreparedDomain,
        project::{Handle, Project},
        sample::{BaseSamples, CoarseSamples},
        site::{Obstacles, SiteKind},
        solve,
    };

    #[test]
    fn the_nearest_handles_of_samples_are_those_that_a_look_at_all_finds() {
        let prepared = PreparedDomain::without_picture(Domain::rectangle(200, 150));
        let navigation = &prepared.navigation;
        let scattered = (0..20)
            .map(f64::from)
            .map(|i| DVec2::new((0.618_033_988_75 * i).fract() * 200.0, (0.754_877_666_25 * i).fract() * 50.0));
        // Two on both sides of an axis, on which there are coarse samples.
        let points: Vec<DVec2> =
            [(95.0, 100.0), (105.0, 100.0)].map(DVec2::from).into_iter().chain(scattered).collect();
        let base = BaseSamples::new(&prepared, &[], 1500);
        let coarse = CoarseSamples::new(&base, &prepared, &points);
        let skeleton = Skeleton::default();
        let obstacles = Obstacles { skeleton: &skeleton, tracks: Vec::new(), held: None };
        let mut propagation = Propagation::default();
        let mut regions = Regions::new(navigation, &coarse, &obstacles, &mut propagation);
        let free = [(30.0, 120.0), (170.0, 120.0)].map(|p| (DVec2::from(p), SiteKind::Virtual));
        let point = |(handle, &p): (u32, &DVec2)| (p, SiteKind::Point { handle });
        for (p, kind) in (0..).zip(&points).map(point).chain(free) {
            let (triangle, p) = navigation.locate(p).expect("inside");
            regions.insert(p, triangle, kind);
        }
        let all: Vec<u32> = (0..coarse.len() as u32).collect();
        let nearest = regions.nearest_handles(&all);
        let mut found = [0; 3];
        for sample in all {
            let at = sample as usize;
            let within = regions.cells.distance[at] * (1.0 + TIE);
            let is_near =
                |site: &Site| site.field.distance(coarse.nav_triangles[at], coarse.mesh.vertices[at]) <= within;
            let real = |&at: &usize| regions.sites[at].kind.is_real() && is_near(&regions.sites[at]);
            let plain: Vec<usize> = (0..regions.sites.len()).filter(real).collect();
            assert_eq!(nearest[&sample], plain, "sample {sample}");
            found[plain.len().min(2)] += 1;
        }
        assert!(found.iter().all(|&count| count > 3), "{found:?}");
    }

    /// Between the first and the fifth of these handles a step ends 3e-7 px outside.
    #[test]
    fn no_contact_is_outside_of_the_domain() {
        let places = [
            [129.79036821351957, 1.1188086859163615],
            [63.69093185855097, 227.99112546593065],
            [47.52539655893339, 59.87290054662069],
            [85.6608192610345, 182.78501296844055],
            [0.0, 0.0],
            [300.0, 300.0],
        ];
        let handles = places.iter().enumerate().map(|(at, &place)| Handle::point(format!("{at}"), place));
        let mut project = Project::for_picture(300, 300).with_handles(handles).bent_rigidly();
        (project.samples, project.pose.density) = (600, 20);
        let solution = solve(&project, &Picture::new(300, 300, &[255; 360_000]).unwrap()).unwrap();
        for site in solution.sites() {
            let inside = site.rest.clamp(DVec2::ZERO, DVec2::splat(300.0));
            assert!(site.rest.distance(inside) < 1e-9, "{} is outside", site.rest);
        }
    }
}
