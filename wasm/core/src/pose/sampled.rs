//! The shape in which a drag has left the picture: samples of a pose, and a pose from samples.
//!
//! In the rigid mode, the same handles allow several poses at rest. Samples tell which of them it is. They are only
//! the start of the way to a pose at rest. So a project opens as it was even after its sites have changed, and
//! nonsense in a file ends in the pose from rest.
//!
//! Each sample belongs to the site nearest to it. The other sites start with harmonic averages of the samples' maps,
//! over the links between sites. So limbs that are close but not connected do not mix.
//!
//! Cost: a pose from samples takes about twice as long as a pose from rest.

use std::f64::consts::TAU;

use glam::{DMat2, DVec2};

use super::{
    Motion, Poser,
    motion::polar,
    numeric::Laplacian,
    rigid::{Rigid, Target},
};
use crate::{
    error::Error,
    project::{Handle, ShapeSample},
    site::SiteKind,
};

/// Most samples of a pose. In a picture of 1,000 px, this many take less than 4 kB of a project file. With 48, more
/// sharply bent figures lose their shape at another density.
const MOST: usize = 56;
/// The first of them are spread evenly; others are added in batches where they are missed most.
const SPREAD: usize = 28;
const BATCH: usize = 4;
/// Steps per pixel at rest, per posed pixel, and per unit of the linear part.
const STEPS: [f64; 3] = [10.0, 100.0, 1000.0];

impl Poser {
    /// The motions of all sites for these handles. The optimisation starts from samples of an earlier pose. In the
    /// harmonic mode, the result is that of [`motions`](Self::motions).
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub(crate) fn motions_from(&self, shape: &[ShapeSample], handles: &[Handle]) -> Result<Vec<Motion>, Error> {
        if shape.is_empty() {
            return self.motions(handles);
        }
        let target = self.target(handles)?;
        Ok(self.rigid(target, |rigid, target| {
            rigid.rest_near(&self.rest, target, |from_rest| self.start(rigid, shape, target, from_rest))
        }))
    }

    /// The motions at the samples of a shape, and averages between them. Sites without a path to a sample have the
    /// motions from rest.
    fn start(
        &self,
        rigid: &Rigid,
        shape: &[ShapeSample],
        target: &Target,
        from_rest: &[Motion],
    ) -> Option<Vec<Motion>> {
        let maps = self.averaged(rigid, &self.samples_of_sites(rigid, shape));
        let motion = |(site, map): (usize, Option<ShapeSample>)| {
            let Some(map) = map else { return from_rest[site] };
            let (angle, strain) = polar(map.linear);
            // It makes as many whole turns as the target.
            let turns = TAU * libm::round((target.motions[site].angle - angle) / TAU);
            Motion { angle: angle + turns, strain, translation: map.posed - map.rest, ..from_rest[site] }
        };
        let motions: Vec<Motion> = maps.into_iter().enumerate().map(motion).collect();
        motions.iter().all(Motion::is_in_bounds).then_some(motions)
    }

    /// The maps at all sites: those of samples, and harmonic averages of them. `None` without a path to a sample.
    fn averaged(&self, rigid: &Rigid, known: &[Option<ShapeSample>]) -> Vec<Option<ShapeSample>> {
        let is_known: Vec<bool> = known.iter().map(Option::is_some).collect();
        let Laplacian { free, boundary, inverse } = Laplacian::new(&is_known, rigid.links());
        let (mut linear, mut origins) = (vec![DMat2::ZERO; free.len()], vec![DVec2::ZERO; free.len()]);
        let mut shares = vec![0.0; free.len()];
        for &(site, row, weight) in &boundary {
            let (Some(sample), row) = (&known[site as usize], row as usize) else { continue };
            linear[row] += weight * sample.linear;
            origins[row] += weight * sample.place(DVec2::ZERO);
            shares[row] += weight;
        }
        inverse.solve(&mut linear);
        inverse.solve(&mut origins);
        inverse.solve(&mut shares);
        let at = |(&rest, sample): (&DVec2, &Option<ShapeSample>)| {
            sample.as_ref().map(|sample| ShapeSample::new(rest, sample.place(rest), sample.linear))
        };
        let mut maps: Vec<Option<ShapeSample>> = self.rest.iter().zip(known).map(at).collect();
        for (row, &site) in free.iter().enumerate().filter(|&(row, _)| shares[row] > 0.5) {
            let (rest, scale) = (self.rest[site as usize], shares[row].recip());
            let linear = linear[row] * scale;
            maps[site as usize] = Some(ShapeSample::new(rest, origins[row] * scale + linear * rest, linear));
        }
        maps
    }

    /// For each site, the nearest of the samples that belong to it. A held outline does not move.
    fn samples_of_sites(&self, rigid: &Rigid, shape: &[ShapeSample]) -> Vec<Option<ShapeSample>> {
        let held = |(kind, &rest): (&SiteKind, &DVec2)| {
            (*kind == SiteKind::Boundary).then(|| ShapeSample::new(rest, rest, DMat2::IDENTITY))
        };
        let mut known: Vec<Option<ShapeSample>> = self.kinds.iter().zip(self.rest.iter()).map(held).collect();
        // Nodes are denser than sites. Beside a gap, the nearest node lies on the right side, unlike the nearest site.
        let sites = self.rest.iter().copied().enumerate().map(|(site, rest)| (rest, site));
        let places: Vec<(DVec2, usize)> = sites.chain(rigid.places()).collect();
        for sample in shape {
            let apart = |&(place, _): &(DVec2, usize)| place.distance_squared(sample.rest);
            let nearest = places.iter().min_by(|one, other| apart(one).total_cmp(&apart(other)));
            let Some(&(_, site)) = nearest.filter(|&&(_, site)| self.kinds[site] != SiteKind::Boundary) else {
                continue;
            };
            let from = |other: &ShapeSample| other.rest.distance_squared(self.rest[site]);
            if known[site].as_ref().is_none_or(|other| from(sample) < from(other)) {
                known[site] = Some(*sample);
            }
        }
        known
    }

    /// Rounded samples of the motions. Sites of handles come first. Others are spread over the picture, and then added
    /// where interpolation is worst. `None` in the harmonic mode.
    pub(crate) fn samples_of(&self, motions: &[Motion]) -> Option<Vec<ShapeSample>> {
        let rigid = self.rigid.as_ref()?;
        let exact = |site: usize| {
            let (motion, rest) = (&motions[site], self.rest[site]);
            ShapeSample::new(rest, rest + motion.translation, motion.linear())
        };
        let mut sites = self.spread_sites();
        while sites.len() < MOST {
            let mut known: Vec<Option<ShapeSample>> =
                (0..motions.len()).map(|site| (self.kinds[site] == SiteKind::Boundary).then(|| exact(site))).collect();
            sites.iter().for_each(|&site| known[site] = Some(exact(site)));
            let errors = self.errors(rigid, &self.averaged(rigid, &known), exact);
            let mut worst: Vec<usize> = (0..errors.len()).filter(|&site| known[site].is_none()).collect();
            worst.sort_by(|&one, &other| errors[other].total_cmp(&errors[one]));
            if worst.is_empty() {
                break;
            }
            sites.extend(worst.into_iter().take(BATCH.min(MOST - sites.len())));
        }
        Some(sites.into_iter().map(|site| rounded(&exact(site))).collect())
    }

    /// The error of each site's map, in pixels: at the site, plus the largest at a linked site.
    fn errors(&self, rigid: &Rigid, maps: &[Option<ShapeSample>], exact: impl Fn(usize) -> ShapeSample) -> Vec<f64> {
        let mut errors = vec![0.0_f64; maps.len()];
        for (i, j, _) in rigid.links() {
            for (site, other) in [(i, j), (j, i)] {
                let error = maps[site].map_or(f64::INFINITY, |map| {
                    let place = self.rest[other];
                    map.place(place).distance(exact(site).place(place)) + map.posed.distance(exact(site).posed)
                });
                errors[site] = errors[site].max(error);
            }
        }
        errors
    }

    /// Sites far apart: first those of handles, then virtual ones.
    fn spread_sites(&self) -> Vec<usize> {
        let mut distances = vec![f64::INFINITY; self.rest.len()];
        let mut spread = Vec::new();
        for is_real in [true, false] {
            let of_kind = |kind: &SiteKind| kind.is_real() == is_real && *kind != SiteKind::Boundary;
            let mut left: Vec<usize> = (0..self.rest.len()).filter(|&site| of_kind(&self.kinds[site])).collect();
            while spread.len() < SPREAD && !left.is_empty() {
                let farthest = (1..left.len())
                    .fold(0, |best, k| if distances[left[k]] > distances[left[best]] { k } else { best });
                let site = left.remove(farthest);
                spread.push(site);
                for (distance, at) in distances.iter_mut().zip(self.rest.iter()) {
                    *distance = distance.min(at.distance_squared(self.rest[site]));
                }
            }
        }
        spread
    }
}

/// A sample with fewer digits.
fn rounded(sample: &ShapeSample) -> ShapeSample {
    let [at_rest, posed, linear] = STEPS;
    let rounded = |number: f64, steps: f64| libm::round(number * steps) / steps;
    let rest = sample.rest.map(|number| rounded(number, at_rest));
    let columns = sample.linear.to_cols_array().map(|number| rounded(number, linear));
    ShapeSample::new(rest, sample.place(rest).map(|number| rounded(number, posed)), DMat2::from_cols_array(&columns))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Picture, Solution,
        project::{DomainSpec, PoseMode, Project, Rotation},
        solve,
    };

    /// The gap between the legs.
    const GAP: [f64; 2] = [99.0, 101.0];

    /// Two legs side by side that are connected at the hip, or an island for each.
    fn legs(are_connected: bool) -> (Project, Solution) {
        let [left, right] = GAP;
        let places = |places: &[[f64; 2]]| places.iter().copied().map(DVec2::from).collect::<Vec<_>>();
        let rings = if are_connected {
            let outline = [[50.0, 10.0], [150.0, 10.0], [150.0, 190.0], [right, 190.0], [right, 50.0], [left, 50.0]];
            vec![places(&[&outline[..], &[[left, 190.0], [50.0, 190.0]]].concat())]
        } else {
            let leg = |[left, right]: [f64; 2]| places(&[[left, 10.0], [right, 10.0], [right, 190.0], [left, 190.0]]);
            vec![leg([50.0, left]), leg([right, 150.0])]
        };
        let handles = [("left", 75.0), ("right", 125.0)];
        let handles = handles.map(|(id, x)| Handle::point(id, [x, 180.0]).turned(Rotation::Auto));
        let mut project = Project::for_picture(200, 200).with_handles(handles);
        project.domain = Some(DomainSpec::Polygon { rings, feather: 0.0 });
        (project.pose.mode, project.pose.density, project.samples) = (PoseMode::Rigid, 60, 2000);
        let solution = solve(&project, &Picture::new(200, 200, &[255; 160_000]).unwrap()).unwrap();
        (project, solution)
    }

    fn moved(rest: [f64; 2], by: [f64; 2]) -> ShapeSample {
        ShapeSample::new(rest, DVec2::from(rest) + DVec2::from(by), DMat2::IDENTITY)
    }

    fn start(poser: &Poser, shape: &[ShapeSample], handles: &[Handle]) -> Vec<Motion> {
        let (target, from_rest) = (poser.target(handles).unwrap(), poser.motions(handles).unwrap());
        poser.start(poser.rigid.as_ref().unwrap(), shape, &target, &from_rest).unwrap()
    }

    #[test]
    fn samples_beside_a_gap_belong_to_their_own_leg() {
        let (_, solution) = legs(true);
        let poser = solution.poser();
        for y in (60..190).map(f64::from) {
            for (x, is_left) in [(GAP[0] - 0.1, true), (GAP[1] + 0.1, false)] {
                let known = poser.samples_of_sites(poser.rigid.as_ref().unwrap(), &[moved([x, y], [0.0, 0.0])]);
                let site = known.iter().position(Option::is_some).unwrap();
                assert_eq!(poser.rest[site].x < 100.0, is_left, "{x}, {y}: {}", poser.rest[site]);
            }
        }
    }

    #[test]
    fn legs_side_by_side_do_not_mix() {
        let (project, solution) = legs(true);
        let shape = [moved([75.0, 180.0], [-40.0, 0.0]), moved([125.0, 180.0], [0.0, 0.0])];
        let motions = start(solution.poser(), &shape, &project.handles);
        for (rest, motion) in solution.poser().rest.iter().zip(motions).filter(|(rest, _)| rest.y > 60.0) {
            let expected = if rest.x < 100.0 { -40.0..-20.0 } else { -20.0..1e-9 };
            assert!(expected.contains(&motion.translation.x), "{rest}: {motion:?}");
        }
    }

    #[test]
    fn islands_without_a_sample_start_from_rest() {
        let (project, solution) = legs(false);
        let motions = start(solution.poser(), &[moved([75.0, 180.0], [-40.0, 5.0])], &project.handles);
        for (rest, motion) in solution.poser().rest.iter().zip(motions) {
            let expected = if rest.x < 100.0 { DVec2::new(-40.0, 5.0) } else { DVec2::ZERO };
            assert!(motion.translation.distance(expected) < 1e-9, "{rest}: {motion:?}");
        }
    }

    #[test]
    fn samples_are_those_of_handles_and_others_far_apart() {
        let (mut project, solution) = legs(true);
        project.handles[0] = project.handles[0].clone().posed_at([[60.0, 170.0]]);
        let pose = solution.pose(&project).unwrap();
        let samples = solution.poser().samples_of(pose.motions()).unwrap();
        assert_eq!(samples.len(), MOST);
        assert_eq!(samples[0].posed, [60.0, 170.0].into());
        assert_eq!(samples[1].rest, [125.0, 180.0].into());
        assert!(samples[2].rest.y < 60.0, "{}", samples[2].rest);
    }
}
