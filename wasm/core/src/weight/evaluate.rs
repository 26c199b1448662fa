//! Weights at any point by eq. 2 itself, without interpolation.
//!
//! Cost: for each support that reaches the point's triangle, the windows of its field there. If bones share a body,
//! O(n log n) in these supports.
//!
//! Limits: where two paths to a site are equally short, weights have a crease, and the gradient is the mean. With
//! penumbrae, no support reaches such points.

use std::{collections::HashSet, ops::Range};

use glam::DVec2;

use super::{
    Basis, Influence,
    bodies::BodyWeights,
    precedence::{kept, kept_slope},
    sweep::{ReachingSite, SampleWeights, sweep},
};
use crate::{
    bone::Skeleton,
    distance::{NavTriangle, Navigation, Penumbrae},
    error::Error,
    rank::sort_by_rank,
    rows::Rows,
    sample::Samples,
    site::{Site, SiteField},
    triangulation::NONE,
};

/// The weight functions of all sites.
#[derive(Debug, Clone)]
pub(crate) struct WeightFunctions {
    basis: Basis,
    bodies: BodyWeights,
    /// Sites: the support of each.
    supports: Vec<SupportDisc>,
    /// Sites: the distance field of each.
    fields: Vec<SiteField>,
    /// Sites: the penumbrae of each; empty if distances are exact.
    penumbrae: Vec<Penumbrae>,
    /// Triangles of the navigation mesh × the supports that reach into each, ascending by site.
    reaching: Rows<Reaching>,
}

/// A geodesic disc: the support of a site.
#[derive(Debug, Clone)]
struct SupportDisc {
    centre: DVec2,
    radius: f64,
    /// See [`Site::precedence_radius`].
    precedence: f64,
}

/// A support that reaches into a triangle.
#[derive(Debug, Clone, Default)]
struct Reaching {
    site: u32,
    /// The windows of the site's field in the triangle.
    windows: Range<u32>,
    /// The site's penumbrae in the triangle.
    penumbrae: Range<u32>,
}

impl WeightFunctions {
    /// Prepares the weight functions of sites whose support radii are set. Each field must reach as far as its site's
    /// support. Without penumbrae, distances are exact.
    pub(crate) fn new(
        navigation: &Navigation,
        sites: &[Site],
        (fields, penumbrae): (Vec<SiteField>, Vec<Penumbrae>),
        skeleton: &Skeleton,
        basis: Basis,
    ) -> Self {
        let reaching = || {
            (0..).zip(sites.iter().zip(&fields)).flat_map(|(number, (site, field))| {
                let triangles = field.distances.windows_within(site.support_radius);
                let blended = penumbrae.get(number as usize);
                triangles.map(move |(triangle, windows)| {
                    let penumbrae = blended.map_or(0..0, |blended| blended.range_in(NavTriangle(triangle)));
                    (triangle as usize, Reaching { site: number, windows, penumbrae })
                })
            })
        };
        let reaching = Rows::from_pairs(navigation.mesh.triangles.len(), reaching);
        let disc = |site: &Site| SupportDisc {
            centre: site.rest,
            radius: site.support_radius,
            precedence: site.precedence_radius,
        };
        let supports = sites.iter().map(disc).collect();
        Self { basis, bodies: BodyWeights::new(sites, skeleton), supports, fields, penumbrae, reaching }
    }

    /// φ.
    pub(crate) fn basis(&self) -> &Basis {
        &self.basis
    }

    /// The islands with sites, ascending.
    pub(crate) fn islands(&self) -> Vec<usize> {
        let mut islands: Vec<usize> = self.fields.iter().map(|field| field.island).collect();
        sort_by_rank(&mut islands, |&island| [island as i64, 0]);
        islands.dedup();
        islands
    }

    /// Sites: the distance field of each.
    pub(crate) fn fields(&self) -> &[SiteField] {
        &self.fields
    }

    /// The weights at a point and their gradients, ascending by site. Empty if no support reaches it.
    ///
    /// Weights sum to 1 within rounding, and none is negative. Where two paths to a site are equally short, as behind a
    /// hole, weights have a crease and several gradients: returns their mean.
    pub(crate) fn at(&self, triangle: NavTriangle, p: DVec2) -> Vec<Influence> {
        let mut influences: Vec<Influence> = Vec::new();
        let mut preceding: Vec<(usize, f64, DVec2)> = Vec::new();
        for Reaching { site, windows, penumbrae } in self.reaching_in(triangle) {
            let site = *site as usize;
            let (&SupportDisc { centre, radius, precedence }, field) =
                (&self.supports[site], &self.fields[site].distances);
            if centre.distance_squared(p) >= radius * radius {
                continue;
            }
            let windows = field.windows(windows.clone());
            let Some(path) = field.path_end_in(windows, p).filter(|path| path.distance < radius) else { continue };
            let (mut distance, mut direction) = (path.distance, path.gradient_in(windows, p));
            if !penumbrae.is_empty() {
                let (longer, turned) = self.penumbrae[site].lengthening_and_gradient(penumbrae.clone(), p);
                (distance, direction) = (distance + longer, direction + turned);
                if distance >= radius {
                    continue;
                }
            }
            let t = distance / radius;
            let (phi, slope) = (self.basis.value(t), self.basis.derivative(t) / radius);
            influences.push(Influence { site, weight: phi, gradient: slope * direction });
            if distance < precedence {
                let slope = kept_slope(&self.basis, distance, precedence);
                preceding.push((site, kept(&self.basis, distance, precedence), slope * direction));
            }
        }
        for (site, kept, slope) in preceding {
            for other in influences.iter_mut().filter(|other| other.site != site) {
                other.gradient = kept * other.gradient + other.weight * slope;
                other.weight *= kept;
            }
        }
        let (mut sum, mut sum_gradient) = (0.0, DVec2::ZERO);
        for influence in &influences {
            sum += influence.weight;
            sum_gradient += influence.gradient;
        }
        self.bodies.redistribute(p, &mut influences, &mut Vec::new());
        for influence in &mut influences {
            influence.weight /= sum;
            influence.gradient = (influence.gradient - influence.weight * sum_gradient) / sum;
        }
        influences
    }

    /// Like [`at`](Self::at), with gradients from central differences over `step`. On a crease they are the mean of
    /// both sides.
    pub(crate) fn across(
        &self,
        navigation: &Navigation,
        (triangle, p): (NavTriangle, DVec2),
        step: f64,
    ) -> Vec<Influence> {
        let mut here = self.at(triangle, p);
        // Beside a sharp corner, locating a point may move it by more than a step.
        let at = |q: DVec2| navigation.locate(q).map_or((p, here.clone()), |(triangle, q)| (q, self.at(triangle, q)));
        let [left, right, above, below] = [-DVec2::X, DVec2::X, -DVec2::Y, DVec2::Y].map(|axis| at(p + step * axis));
        let slope = |(from, before): &(DVec2, Vec<Influence>), (to, after): &(DVec2, Vec<Influence>), site: usize| {
            let weight = |list: &[Influence]| list.iter().find(|one| one.site == site).map_or(0.0, |one| one.weight);
            let apart = from.distance(*to);
            if apart > 0.0 { (weight(after) - weight(before)) / apart } else { 0.0 }
        };
        for one in &mut here {
            one.gradient = DVec2::new(slope(&left, &right, one.site), slope(&above, &below, one.site));
        }
        here
    }

    /// The weights of all samples.
    ///
    /// Cost: see [`sweep`]. A visit of every site for each sample that no support covers, which should not occur.
    ///
    /// # Errors
    /// [`Error::TooMuchMemory`] if there are more than [`MAX_WEIGHTS`](crate::limits::MAX_WEIGHTS).
    pub(crate) fn of_samples(&self, navigation: &Navigation, samples: &Samples) -> Result<SampleWeights, Error> {
        let mut swept = sweep(samples, &self.basis, |triangle| {
            self.reaching_in(triangle).iter().map(|Reaching { site, windows, penumbrae }| ReachingSite {
                site: *site,
                support_radius: self.supports[*site as usize].radius,
                precedence_radius: self.supports[*site as usize].precedence,
                windows: self.fields[*site as usize].distances.windows(windows.clone()),
                penumbrae: (!penumbrae.is_empty()).then(|| (&self.penumbrae[*site as usize], penumbrae.clone())),
            })
        })?;
        self.bodies.redistribute_rows(&samples.mesh.vertices, &mut swept.weights);
        let islands: HashSet<usize> = self.fields.iter().map(|field| field.island).collect();
        for sample in (0..samples.len()).filter(|&sample| swept.phi_sums[sample] == 0.0) {
            let (triangle, p) = (samples.nav_triangles[sample], samples.mesh.vertices[sample]);
            if islands.contains(&navigation.island_of(triangle)) {
                // Fields reach over their cells.
                let distances = (0..).zip(&self.fields).map(|(number, field)| (field.distance(triangle, p), number));
                let nearest =
                    distances.fold((f64::INFINITY, NONE), |least, one| if one.0 < least.0 { one } else { least });
                swept.nearest[sample] = nearest.1;
            }
        }
        Ok(swept)
    }

    fn reaching_in(&self, triangle: NavTriangle) -> &[Reaching] {
        self.reaching.row(triangle.0 as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Picture,
        project::{Filling, Project},
        sample::BaseSamples,
        solve,
    };

    #[test]
    fn uncovered_samples_are_reported_and_have_a_nearest_site() {
        let json = r#"{
            "format": "c2warp/1", "image": { "src": "", "width": 100, "height": 100 }, "samples": 500,
            "domain": { "kind": "polygon", "rings": [
                [[5, 5], [45, 5], [45, 95], [5, 95]], [[55, 5], [75, 5], [75, 95], [55, 95]],
                [[80, 5], [95, 5], [95, 95], [80, 95]]
            ] },
            "handles": [
                { "id": "a", "kind": "point", "rest": [20, 50], "posed": [20, 50] },
                { "id": "b", "kind": "point", "rest": [60, 50], "posed": [60, 50] }
            ]
        }"#;
        let project = Project::from_json(json).unwrap();
        let mut solution = solve(&project, &Picture::new(100, 100, &[255; 40_000]).unwrap()).unwrap();
        let pose = solution.poser().pose(&project.handles, project.pose.blend).unwrap();
        assert!(solution.report(&pose).min_phi_sum > 0.0);
        let navigation = &solution.prepared.navigation;
        let mut sites = solution.sites().to_vec();
        sites.iter_mut().filter(|site| site.rest.x > 50.0).for_each(|site| site.support_radius = 0.0);
        let handles: Vec<DVec2> = sites.iter().filter(|site| site.kind.is_real()).map(|site| site.rest).collect();
        let base = BaseSamples::new(&solution.prepared, &[], 500);
        let samples = base.with_sites(&solution.prepared, &handles);
        let fields = solution.functions.fields().to_vec();
        let basis = Basis::new(5, Filling::default());
        let functions = WeightFunctions::new(navigation, &sites, (fields, Vec::new()), &Skeleton::default(), basis);
        let SampleWeights { phi_sums, nearest, .. } = functions.of_samples(navigation, &samples).unwrap();
        for (&p, &nearest) in samples.mesh.vertices.iter().zip(&nearest) {
            let on_island = sites.iter().filter(|site| (site.rest.x > 50.0) == (p.x > 50.0));
            let distances = on_island.map(|site| site.rest.distance(p));
            match sites.get(nearest as usize) {
                Some(site) => {
                    assert!(p.x < 78.0 && site.rest.distance(p) <= distances.fold(f64::INFINITY, f64::min) + 1e-9);
                }
                None => assert!(p.x > 78.0 && nearest == NONE),
            }
        }
        assert_eq!(phi_sums.len(), solution.samples());
        (solution.phi_sums, solution.solved.nearest) = (phi_sums, nearest);
        assert_eq!(solution.report(&pose).min_phi_sum, 0.0);
    }

    /// Where paths begin to bend around a corner, the level lines of the distance change their centre.
    #[test]
    fn behind_a_corner_gradients_are_continuous_and_second_derivatives_jump() {
        let json = r#"{
            "format": "c2warp/1", "image": { "src": "", "width": 400, "height": 400 }, "samples": 500,
            "domain": { "kind": "polygon", "rings": [[[0, 0], [400, 0], [400, 400], [200, 400], [200, 200], [0, 200]]] },
            "handles": [
                { "id": "a", "kind": "point", "rest": [100, 150] }, { "id": "b", "kind": "point", "rest": [350, 50] }
            ]
        }"#;
        let project = Project::from_json(json).unwrap();
        let solution = solve(&project, &Picture::new(400, 400, &[255; 640_000]).unwrap()).unwrap();
        let site = solution.sites().iter().position(|site| site.rest.x == 100.0).unwrap();
        let corner = DVec2::new(200.0, 200.0);
        let along = (corner - solution.sites()[site].rest).normalize();
        let slope = |off: f64, behind: f64| {
            let influences = solution.influences_at(corner + behind * along + off * along.perp()).unwrap();
            influences.iter().find(|one| one.site == site).unwrap().gradient.dot(along.perp())
        };
        let second = |side: f64, behind: f64| (slope(2e-3 * side, behind) - slope(1e-3 * side, behind)) / (1e-3 * side);
        for behind in [40.0, 10.0] {
            assert!((slope(1e-9, behind) - slope(-1e-9, behind)).abs() < 1e-12);
            assert!(second(1.0, behind) < 2.0 * second(-1.0, behind), "{behind} px behind the corner");
        }
        assert!(second(1.0, 10.0) < 1.5 * second(1.0, 40.0));
    }
}
