//! Where the farthest points of a cell are: from the scouts that may be next to one to the point itself.

use glam::DVec2;

use super::{
    Site,
    farthest::{Cone, Wall, climb, climb_along},
    regions::{Far, FarPoint, NEAR_TOP, Regions, Summit},
    virtual_sites::TIE,
};
use crate::triangulation::NONE;

/// Two farthest points nearer than this share of the spacing of scouts are one.
const SAME_POINT: f64 = 1e-3;

/// A cell of fewer scouts may have its farthest points where none of them leads: then all around it are asked, too.
const FEW: usize = 12;
/// A scout this many edges from a farthest point leads to the same, if no other cells meet around it.
const SAME_SUMMIT: f64 = 1.5;
/// Cells meet where their sites are equally far within this share: wider than what a climb leaves.
const MEETING: f64 = 1e-6;
/// How often a climb is taken up again where it ended.
const RESTARTS: usize = 8;

impl Regions<'_> {
    /// Finds the farthest points of a site's cell. There is at least one.
    pub(crate) fn find_farthest(&mut self, site: usize) {
        let mut summits = std::mem::take(&mut self.summits[site]);
        let radius = self.sampled_radius(site);
        let mut tops: Vec<usize> = self.cells.of(site).filter(|&at| self.is_top(site, at, radius)).collect();
        if self.cells.of(site).take(FEW).count() < FEW {
            // A cell between the scouts, or too narrow for many.
            tops = self.scouts_around(site);
        }
        tops.sort_by(|&a, &b| self.cells.distance[b].total_cmp(&self.cells.distance[a]).then(a.cmp(&b)));
        for at in tops {
            let radius = summits.iter().map(|summit| summit.point.distance).fold(radius, f64::max);
            if self.cells.distance[at] + NEAR_TOP * self.scouts.reach[at] < radius {
                continue;
            }
            let around = self.scouts.graph.of(at);
            let under = |summit: &Summit| {
                summit.point.at.distance(self.scouts.mesh.vertices[at]) < SAME_SUMMIT * self.scouts.reach[at]
                    && around.iter().all(|&n| summit.meeting.contains(&self.cells.nearest[n as usize]))
            };
            if summits.iter().any(under) {
                continue;
            }
            let same = SAME_POINT * self.scouts.reach[at];
            for point in self.summits_near(site, at) {
                if summits.iter().all(|known| known.point.at.distance(point.at) > same) {
                    summits.push(Summit { point, meeting: self.meeting_at(&point) });
                }
            }
        }
        let greatest = summits.iter().map(|summit| summit.point.distance).fold(0.0, f64::max);
        let points = summits.iter().map(|summit| summit.point);
        let mut points: Vec<FarPoint> = points.filter(|point| point.distance >= greatest * (1.0 - TIE)).collect();
        if points.is_empty() {
            points.push(self.farthest_sample(site));
        }
        self.far[site] = Far::Known(points);
        self.summits[site] = summits;
    }

    /// The scouts of a cell, and those that are their neighbours.
    fn scouts_around(&self, site: usize) -> Vec<usize> {
        let own = self.cells.of(site).chain(self.scouts.around(self.sites[site].rest).map(|at| at as usize));
        let around = own.flat_map(|at| self.scouts.graph.of(at).iter().map(|&n| n as usize).chain([at]));
        let mut all: Vec<usize> = around.collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The farthest scout of a cell, or where there is none, the site itself.
    fn farthest_sample(&self, site: usize) -> FarPoint {
        let Site { rest, place, .. } = self.sites[site];
        let sample = self.cells.farthest_sample(site);
        sample.map_or(FarPoint { at: rest, place, distance: 0.0 }, |at| self.far_point(at))
    }

    /// A scout and its distance to the nearest site.
    fn far_point(&self, scout: usize) -> FarPoint {
        let (at, place) = (self.scouts.mesh.vertices[scout], self.scouts.places[scout]);
        FarPoint { at, place, distance: self.cells.distance[scout] }
    }

    /// The sites whose cells meet at a point.
    fn meeting_at(&self, point: &FarPoint) -> Vec<u32> {
        let near = point.distance * (1.0 + MEETING);
        let sites = self.sites.iter().enumerate();
        let meeting = sites.filter(|(_, site)| {
            site.rest.distance(point.at) <= near && site.field.distance(point.place, point.at) <= near
        });
        meeting.map(|(site, _)| site as u32).collect()
    }

    /// Whether a scout may be next to a farthest point: it is nearly as far as any of the cell, and either no neighbour in the
    /// cell is farther, or cells meet there, or a cell meets the outline.
    fn is_top(&self, site: usize, at: usize, radius: f64) -> bool {
        let (cells, around) = (&self.cells, self.scouts.graph.of(at));
        let d = cells.distance[at];
        if d + NEAR_TOP * self.scouts.reach[at] < radius {
            return false;
        }
        let higher = |&n: &u32| cells.nearest[n as usize] == site as u32 && cells.distance[n as usize] > d;
        let mut others = around.iter().map(|&n| cells.nearest[n as usize]).filter(|&cell| cell != site as u32);
        let first = others.next();
        let on_outline = self.along[at][0] != NONE;
        let is_corner = first.is_some() && (on_outline || others.any(|cell| Some(cell) != first));
        is_corner || !around.iter().any(higher)
    }

    /// The farthest point of a site's cell near one of its scouts, and others as far.
    fn summits_near(&self, site: usize, at: usize) -> Vec<FarPoint> {
        let scouts = self.scouts;
        let sample = (self.cells.nearest[at] == site as u32).then(|| self.far_point(at));
        let around = self.surroundings(site, at);
        if let Some(sample) = sample {
            match (around.own.len() + around.others.len(), around.walls.is_empty()) {
                // A cone is convex: alone, it is farthest at a corner of a triangle, which is a scout.
                (1, _) => return vec![sample],
                // Along the line on which two cones meet both rise to one side or the other, up to a third or the outline.
                (2, true) => return Vec::new(),
                _ => {}
            }
        }
        let mut summits = self.higher(site, at, scouts.mesh.vertices[at], sample, &around);
        // In the tip of a narrow cell the way may lead out of what was known around its beginning.
        for _ in 0..RESTARTS {
            let Some(&summit) = summits.first() else { break };
            if summit.at.distance(sample.map_or(DVec2::NAN, |sample| sample.at)) < scouts.reach[at] {
                break;
            }
            let near = scouts.around(summit.at);
            let distance = |v: &u32| scouts.mesh.vertices[*v as usize].distance_squared(summit.at);
            let near = near.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let near = near.expect("a triangle has corners") as usize;
            let around = self.surroundings(site, near);
            let next = self.higher(site, near, summit.at, Some(summit), &around);
            if next.first().is_none_or(|next| next.distance <= summit.distance * (1.0 + TIE)) {
                break;
            }
            summits = next;
        }
        summits
    }

    /// The farthest points of a site's cell that are found from a place near scout `at`, in its surroundings: all as far, and
    /// no nearer than `known`.
    fn higher(
        &self,
        site: usize,
        at: usize,
        from: DVec2,
        known: Option<FarPoint>,
        surroundings: &Surroundings,
    ) -> Vec<FarPoint> {
        let scouts = self.scouts;
        let Surroundings { own, others, walls } = surroundings;
        let all: Vec<Cone> = own.iter().chain(others).copied().collect();
        // A corner that paths bend at has no tangent to climb by: then from beside it.
        let around = scouts.graph.of(at);
        let beside = around.iter().map(|&n| scouts.mesh.vertices[n as usize]).sum::<DVec2>() / around.len() as f64;
        let from = if all.iter().any(|cone| cone.apex == from) { from.midpoint(beside) } else { from };
        let reach = 2.0 * scouts.reach[at];
        // A cone of the site itself ends another where paths on both sides of a hole are as long, but not where it is merely
        // out of sight: so once with the others of the site, and once without.
        let limits: &[&[Cone]] = if own.len() > 1 { &[others, &all] } else { &[others] };
        let tops = limits.iter().flat_map(|&limits| {
            own.iter().flat_map(|cone| {
                let along = walls.iter().map(|&(a, b)| climb_along(cone, limits, a, b));
                let free = climb(cone, limits, &[], from, reach);
                let inside = self.navigation.place(free.0).is_some();
                let (top, other) = if inside { free } else { climb(cone, limits, walls, from, reach) };
                along.chain([top]).chain(other)
            })
        });
        let in_cell = |p: DVec2| {
            let place = self.navigation.place(p)?;
            let own = self.sites[site].field.distance(place, p);
            let distance = self.nearest_distance(place, p, own);
            let of_site = own <= distance * (1.0 + TIE);
            (of_site && distance.is_finite()).then_some(FarPoint { at: p, place, distance })
        };
        let mut found: Vec<FarPoint> = known.into_iter().chain(tops.filter_map(in_cell)).collect();
        let greatest = found.iter().map(|point| point.distance).fold(0.0, f64::max);
        found.retain(|point| point.distance >= greatest * (1.0 - TIE));
        found
    }

    /// The cones that are least at the scouts around one, and the pieces of the outline there.
    fn surroundings(&self, site: usize, at: usize) -> Surroundings {
        let scouts = self.scouts;
        let mut ring = vec![at as u32];
        for _ in 0..2 {
            for i in 0..ring.len() {
                for n in scouts.graph.of(ring[i] as usize) {
                    if !ring.contains(n) {
                        ring.push(*n);
                    }
                }
            }
        }
        let mut found = Surroundings { own: Vec::new(), others: Vec::new(), walls: Vec::new() };
        for &v in &ring {
            let (v, p) = (v as usize, scouts.mesh.vertices[v as usize]);
            let nearest = self.cells.nearest[v];
            let foot = self.sites[nearest as usize].field.foot(scouts.places[v], p);
            let [prev, next] = self.along[v];
            let mut cones = [foot.map(|foot| Cone { apex: foot.pseudo_source, offset: foot.offset }), None];
            if next != NONE {
                let [prev, next] = [prev, next].map(|n| scouts.mesh.vertices[n as usize]);
                found.walls.push((p, next));
                // Beyond a reflex corner paths bend at it, though no scout may lie where they do.
                if (p - prev).perp_dot(next - p) < 0.0 {
                    cones[1] = Some(Cone { apex: p, offset: self.cells.distance[v] });
                }
            }
            for cone in cones.into_iter().flatten().filter(|cone| cone.offset.is_finite()) {
                let cones = if nearest == site as u32 { &mut found.own } else { &mut found.others };
                if !cones.contains(&cone) {
                    cones.push(cone);
                }
            }
        }
        found
    }
}

/// What is known around a scout of a cell.
struct Surroundings {
    /// Cones of the cell's site.
    own: Vec<Cone>,
    /// Cones of its neighbours.
    others: Vec<Cone>,
    walls: Vec<Wall>,
}
