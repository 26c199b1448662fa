//! Contacts: points where the cells of two handles meet and no virtual site is nearer.
//!
//! There, the picture changes from one motion to another within the supports of both, determined only by the slope of
//! φ. A site halfway takes a share of that change, and its motion is free. Algorithm 1 inserts at the farthest point of
//! a cell, which is on its open side. So it would divide a narrow gap between two bars last.
//!
//! Each contact is found between two coarse samples, and lies exactly on the border of the cells.
//!
//! Cost: whenever real sites are new, a visit of every coarse sample for each of them, and of every triangle of the
//! coarse mesh. For each sample near a new site and on the border of a cell, a visit of the real sites about as near as
//! its own. For each pair of such samples of two handles, a visit of all sites. Later rounds visit the remaining
//! contacts and the new sites.
//!
//! Limits: the coarse samples determine where along the border a contact lies: where the edge between two of them
//! crosses it. So these sites depend on the lattice, for example if the picture is rotated or its outline gets another
//! corner.

use std::collections::HashMap;

use glam::DVec2;

use super::{Site, SiteField, SiteInserter, TIE, farthest::FarPoint, obstacles::Obstacles, room, voronoi::Voronoi};
use crate::{grid::Grid, limits::MIN_SEPARATION, rank::sort_by_rank};

/// Steps of Newton's method to the border. Between two points, the first step reaches it.
const STEPS: usize = 3;
/// If the squared difference of two gradients is smaller, a step leads along the border, not to it.
const ALONG: f64 = 1e-3;

/// All contacts that are not known to be closed.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    /// Pairs with contacts, ascending by their samples.
    borders: Vec<Border>,
    /// The real sites when the borders were found.
    grid: Option<Grid<usize>>,
    /// Number of sites when the borders were found.
    found_at: usize,
    /// The number of leading sites that do not close any contact.
    sites: usize,
}

/// Two neighbouring coarse samples in different cells, and the open contacts between them.
#[derive(Debug)]
struct Border {
    samples: [u32; 2],
    contacts: Vec<FarPoint>,
    /// Whether a site has closed a contact since.
    has_closed: bool,
}

impl Contacts {
    /// The open contacts whose sites are farthest apart, with all ties. Empty if all are closed.
    pub(super) fn widest(&mut self, inserter: &SiteInserter) -> Vec<FarPoint> {
        let voronoi = &inserter.voronoi;
        self.close(voronoi);
        if voronoi.sites[self.found_at..].iter().any(|site| site.kind.is_real()) {
            self.find(voronoi, inserter.obstacles);
        }
        let open = || self.borders.iter().flat_map(|border| &border.contacts);
        let widest = open().map(|contact| contact.distance).fold(0.0, f64::max);
        open().filter(|contact| contact.distance >= (1.0 - TIE) * widest).copied().collect()
    }

    /// Drops the contacts that new sites close.
    fn close(&mut self, voronoi: &Voronoi) {
        let new = || voronoi.sites[self.sites..].iter().zip(&voronoi.fields[self.sites..]);
        let closes = |(site, field): (&Site, &SiteField), contact: &FarPoint| {
            site.rest.distance(contact.at) < contact.distance
                && field.distance(contact.triangle, contact.at) < contact.distance
        };
        for Border { contacts, has_closed, .. } in &mut self.borders {
            let known = contacts.len();
            contacts.retain(|contact| !new().any(|site| closes(site, contact)));
            *has_closed |= contacts.len() < known;
        }
        self.sites = voronoi.sites.len();
    }

    /// Finds all contacts between the sites inserted so far. Contacts far from new sites are already known.
    fn find(&mut self, voronoi: &Voronoi, obstacles: &Obstacles) {
        let is_near_new = samples_near(voronoi, &voronoi.sites[self.found_at..]);
        self.borders.retain(|border| !border.samples.iter().any(|&at| is_near_new[at as usize]));
        let (closed, known): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.borders).into_iter().partition(|border| border.has_closed);
        let mut open = pairs_on_borders(voronoi, &is_near_new);
        open.extend(closed.iter().map(|border| border.samples));
        sort_by_rank(&mut open, |&pair| pair.map(i64::from));
        // Most pairs are found from both sides.
        open.dedup();
        let nearest = self.nearest_real_sites(voronoi, open.as_flattened());
        let mut known = known.into_iter().peekable();
        for samples in open {
            while let Some(border) = known.next_if(|border| border.samples < samples) {
                self.borders.push(border);
            }
            let contacts = contacts(voronoi, obstacles, &nearest, samples);
            if !contacts.is_empty() {
                self.borders.push(Border { samples, contacts, has_closed: false });
            }
        }
        self.borders.extend(known);
        self.found_at = voronoi.sites.len();
    }

    /// The nearest real sites of given coarse samples, ascending. A sample on a border has several, for example on an
    /// axis of symmetry.
    fn nearest_real_sites(&mut self, voronoi: &Voronoi, samples: &[u32]) -> HashMap<u32, Vec<usize>> {
        let (coarse, cells) = (voronoi.coarse, &voronoi.cells);
        let grid = self.grid.get_or_insert_with(|| {
            // The average radius of a query, so that a query touches a few cells of the grid.
            let distances = samples.iter().map(|&sample| cells.distance[sample as usize]);
            let average = (!samples.is_empty()).then(|| distances.sum::<f64>() / samples.len() as f64);
            Grid::new(average.unwrap_or(coarse.longest_edge).max(MIN_SEPARATION), [])
        });
        for (at, site) in voronoi.sites.iter().enumerate().skip(self.found_at).filter(|(_, site)| site.kind.is_real()) {
            grid.insert(site.rest, at);
        }
        let nearest = |sample: usize| {
            let (triangle, p) = (coarse.nav_triangles[sample], coarse.mesh.vertices[sample]);
            let within = cells.distance[sample] * (1.0 + TIE);
            let is_near = |&site: &usize| {
                voronoi.sites[site].rest.distance(p) <= within && voronoi.distance(site, triangle, p) <= within
            };
            let mut near: Vec<usize> = grid.around(p, within).filter(is_near).collect();
            sort_by_rank(&mut near, |&site| [site as i64, 0]);
            near
        };
        let mut known = HashMap::new();
        for &sample in samples {
            known.entry(sample).or_insert_with(|| nearest(sample as usize));
        }
        known
    }
}

/// For each coarse sample, whether one of the given sites is at least about as near as its own site.
fn samples_near(voronoi: &Voronoi, sites: &[Site]) -> Vec<bool> {
    let samples = voronoi.coarse.mesh.vertices.iter().zip(&voronoi.cells.distance);
    let is_near = |(&p, &distance): (&DVec2, &f64)| {
        let within = distance * (1.0 + TIE);
        sites.iter().any(|site| site.rest.distance_squared(p) <= within * within)
    };
    samples.map(is_near).collect()
}

/// The pairs of neighbouring coarse samples in different cells, at least one of them chosen.
fn pairs_on_borders(voronoi: &Voronoi, is_chosen: &[bool]) -> Vec<[u32; 2]> {
    let cells = &voronoi.cells;
    let mut pairs: Vec<[u32; 2]> = Vec::new();
    let are_apart = |[a, b]: [u32; 2]| cells.nearest[a as usize] != cells.nearest[b as usize];
    let is_chosen = |sample: u32| is_chosen[sample as usize];
    let is_pair = |&[a, b]: &[u32; 2]| a < b && (is_chosen(a) || is_chosen(b)) && are_apart([a, b]);
    let add_pairs = |edges: &[[u32; 2]]| {
        let ends = |&[a, _]: &[u32; 2]| edges.iter().map(move |&[b, _]| [a, b]);
        pairs.extend(edges.iter().flat_map(ends).filter(is_pair));
    };
    let is_wanted = |corners: [u32; 3]| corners.into_iter().any(is_chosen);
    voronoi.coarse.mesh.visit_polygons(is_wanted, add_pairs);
    pairs
}

/// The contacts between two coarse samples, with the nearest real sites of each.
fn contacts(
    voronoi: &Voronoi,
    obstacles: &Obstacles,
    nearest: &HashMap<u32, Vec<usize>>,
    samples: [u32; 2],
) -> Vec<FarPoint> {
    let [of_a, of_b] = samples.map(|sample| &nearest[&sample][..]);
    let of_both = of_a.iter().flat_map(|&s| of_b.iter().map(move |&t| [s, t]));
    let apart = of_both.filter(|&[s, t]| {
        let body = obstacles.body(voronoi.sites[s].kind);
        s != t && room::limits(voronoi, obstacles, t, voronoi.fields[s].island, body)
    });
    let point = |sites| {
        let start = border_estimate(voronoi, samples.map(|sample| sample as usize), sites);
        point_on_border(voronoi, start, sites)
    };
    apart.filter_map(point).collect()
}

/// Approximately the point where the border of two sites crosses the edge between two coarse samples, one in each cell.
fn border_estimate(voronoi: &Voronoi, samples: [usize; 2], [s, t]: [usize; 2]) -> DVec2 {
    let (coarse, cells) = (voronoi.coarse, &voronoi.cells);
    let [a, b] = samples.map(|sample| coarse.mesh.vertices[sample]);
    // How much farther the other site is; nearly linear along the edge.
    let off_a = voronoi.distance(t, coarse.nav_triangles[samples[0]], a) - cells.distance[samples[0]];
    let off_b = voronoi.distance(s, coarse.nav_triangles[samples[1]], b) - cells.distance[samples[1]];
    let fraction = off_a / (off_a + off_b);
    a.lerp(b, if fraction.is_finite() { fraction } else { 0.5 })
}

/// The point near `p` at equal distances from two sites; `None` if a virtual site is nearer.
fn point_on_border(voronoi: &Voronoi, mut p: DVec2, sites: [usize; 2]) -> Option<FarPoint> {
    let navigation = voronoi.navigation;
    let [s, t] = sites.map(|site| &voronoi.fields[site].distances);
    let mut triangle = navigation.triangle_at(p)?;
    for _ in 0..STEPS {
        let [(to_s, from_s), (to_t, from_t)] =
            [s.distance_and_gradient(triangle, p)?, t.distance_and_gradient(triangle, p)?];
        let apart = from_s - from_t;
        if apart.length_squared() < ALONG {
            break;
        }
        p -= (to_s - to_t) * apart / apart.length_squared();
        // A step may end outside by as little as rounding. Move the point onto the outline, as no site may be outside.
        (triangle, p) = navigation.locate(p)?;
    }
    let (distance, site) = voronoi.nearest(triangle, p)?;
    site.kind.is_real().then_some(FarPoint { at: p, triangle, distance })
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
        project::{Continuity, Handle, Project},
        sample::{BaseSamples, CoarseSamples},
        site::SiteKind,
        solve,
    };

    #[test]
    fn nearest_real_sites_match_a_brute_force_search() {
        let prepared = PreparedDomain::without_picture(Domain::rectangle(200, 150));
        let navigation = &prepared.navigation;
        let scattered = (0..20)
            .map(f64::from)
            .map(|i| DVec2::new((0.618_033_988_75 * i).fract() * 200.0, (0.754_877_666_25 * i).fract() * 50.0));
        // The first two are mirror images, and there are coarse samples on their axis.
        let points: Vec<DVec2> =
            [(95.0, 100.0), (105.0, 100.0)].map(DVec2::from).into_iter().chain(scattered).collect();
        let base = BaseSamples::new(&prepared, &[], 1500);
        let coarse = CoarseSamples::new(&base, &prepared, &points);
        let skeleton = Skeleton::default();
        let obstacles = Obstacles::new(&skeleton, navigation, None);
        let mut propagation = Propagation::default();
        let mut inserter = SiteInserter::new(navigation, &coarse, &obstacles, &mut propagation, Continuity::Exact);
        let free = [(30.0, 120.0), (170.0, 120.0)].map(|p| (DVec2::from(p), SiteKind::Virtual));
        let point = |(handle, &p): (u32, &DVec2)| (p, SiteKind::Point { handle });
        for (p, kind) in (0..).zip(&points).map(point).chain(free) {
            let (triangle, p) = navigation.locate(p).expect("inside");
            inserter.insert(p, triangle, kind).unwrap();
        }
        let voronoi = &inserter.voronoi;
        let all: Vec<u32> = (0..coarse.len() as u32).collect();
        let nearest = Contacts::default().nearest_real_sites(voronoi, &all);
        let mut found = [0; 3];
        for sample in all {
            let at = sample as usize;
            let within = voronoi.cells.distance[at] * (1.0 + TIE);
            let distance = |site: usize| voronoi.distance(site, coarse.nav_triangles[at], coarse.mesh.vertices[at]);
            let is_near = |&site: &usize| voronoi.sites[site].kind.is_real() && distance(site) <= within;
            let expected: Vec<usize> = (0..voronoi.sites.len()).filter(is_near).collect();
            assert_eq!(nearest[&sample], expected, "sample {sample}");
            found[expected.len().min(2)] += 1;
        }
        assert!(found.iter().all(|&count| count > 3), "{found:?}");
    }

    /// Between the first and the fifth of these handles a step ends 3e-7 px outside.
    #[test]
    fn contacts_lie_in_the_domain() {
        let places = [
            [129.79036821351957, 1.1188086859163615],
            [63.69093185855097, 227.99112546593065],
            [47.52539655893339, 59.87290054662069],
            [85.6608192610345, 182.78501296844055],
            [0.0, 0.0],
            [300.0, 300.0],
        ];
        let handles = places.iter().enumerate().map(|(at, &place)| Handle::point(format!("{at}"), place));
        let mut project = Project::for_picture(300, 300).with_handles(handles).with_editor_settings();
        (project.samples, project.pose.density) = (600, 20);
        let solution = solve(&project, &Picture::new(300, 300, &[255; 360_000]).unwrap()).unwrap();
        for site in solution.sites() {
            let inside = site.rest.clamp(DVec2::ZERO, DVec2::splat(300.0));
            assert!(site.rest.distance(inside) < 1e-9, "{} is outside", site.rest);
        }
    }
}
