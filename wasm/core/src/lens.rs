//! The lens: everything that determines the posed position of one point. For figures.
//!
//! Follows eq. 2 for the weights, section III-A for the paths, and eq. 4 for the share of virtual sites.
//!
//! Cost: one distance field without a bound, and the paths to the handles in it.

use glam::DVec2;

use crate::{
    distance::DistanceField,
    rank::{descending, sort_by_rank},
    solution::Solution,
};

/// The weights at a point, and the shortest paths to the handles.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Lens {
    /// The point at rest, in image pixels.
    #[cfg_attr(feature = "schema", schemars(with = "(f64, f64)"))]
    pub at: DVec2,
    /// The handles with a path to the point, in the order of the project. A held boundary comes last.
    pub shares: Vec<Share>,
    /// The weights of all virtual sites together.
    pub virtual_weight: f64,
    /// The sites with a weight, the heaviest first.
    pub sites: Vec<LensSite>,
}

/// The share of one handle in the motion of a point.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Share {
    /// Index of the handle in the project; −2 for a held boundary.
    pub handle: i32,
    /// The weights of its own sites together.
    pub weight: f64,
    /// Its share through virtual sites: their weights times the harmonic fields of its sites.
    pub passed_on: f64,
    /// Its site nearest to the point.
    pub site: usize,
    /// Length of the shortest path from that site to the point, in pixels.
    pub distance: f64,
    /// The vertices of that path, from the point to the site.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<(f64, f64)>"))]
    pub path: Vec<DVec2>,
}

/// A site that moves the point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct LensSite {
    /// The index of the site.
    pub site: usize,
    /// w_i at the point.
    pub weight: f64,
    /// Intrinsic distance to the point, in pixels.
    pub distance: f64,
}

impl Solution {
    /// Explains how a point moves; `None` outside the domain. In a loose part, it explains the point that the part
    /// follows.
    #[must_use]
    pub fn lens(&self, p: DVec2) -> Option<Lens> {
        let distances = self.navigation().distances_from(self.leading_point(p)).ok()?;
        let field = distances.field();
        let at = field.source;
        let weights = self.weights_at(at)?;
        let distance = |site: usize| field.distance(self.functions.fields()[site].triangle, self.sites()[site].rest);
        let is_virtual = |site: usize| !self.sites()[site].kind.is_real();
        let site = |&(site, weight): &(usize, f64)| LensSite { site, weight, distance: distance(site) };
        let mut sites: Vec<LensSite> = weights.iter().map(site).collect();
        sort_by_rank(&mut sites, |site| [descending(site.weight), site.site as i64]);
        let virtual_weight = weights.iter().filter(|&&(site, _)| is_virtual(site)).map(|&(_, weight)| weight).sum();
        let nearest = self.nearest_sites(distance).into_iter();
        let mut shares: Vec<Share> = nearest.filter_map(|share| self.with_path(share, field)).collect();
        for &(site, weight) in &weights {
            for (real, part) in self.harmonic_weights(site) {
                let handle = self.sites()[real].kind.handle_code();
                if let Some(share) = shares.iter_mut().find(|share| share.handle == handle) {
                    *(if is_virtual(site) { &mut share.passed_on } else { &mut share.weight }) += weight * part;
                }
            }
        }
        Some(Lens { at, shares, virtual_weight, sites })
    }

    /// The nearest site of each handle, with its distance. Handles without a path are left out.
    fn nearest_sites(&self, distance: impl Fn(usize) -> f64) -> Vec<Share> {
        let mut shares: Vec<Share> = Vec::new();
        for (site, of_site) in self.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
            let (handle, distance) = (of_site.kind.handle_code(), distance(site));
            if distance.is_infinite() {
                continue;
            }
            match shares.iter_mut().find(|share| share.handle == handle) {
                Some(known) if known.distance > distance => (known.site, known.distance) = (site, distance),
                Some(_) => {}
                None => {
                    shares.push(Share { handle, weight: 0.0, passed_on: 0.0, site, distance, path: Vec::new() });
                }
            }
        }
        // As an unsigned number, a held boundary is last.
        sort_by_rank(&mut shares, |share| [i64::from(share.handle as u32), 0]);
        shares
    }

    fn with_path(&self, mut share: Share, field: &DistanceField) -> Option<Share> {
        let triangle = self.functions.fields()[share.site].triangle;
        share.path = field.path(self.navigation(), triangle, self.sites()[share.site].rest)?;
        Some(share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Picture, project::Project, solve};

    /// An angle with a point in one limb and a bar in the other, and an island with a handle of its own.
    fn angle(fix_boundary: bool) -> Solution {
        let json = format!(
            r#"{{
            "format": "c2warp/1", "image": {{ "src": "", "width": 400, "height": 400 }}, "samples": 2000,
            "domain": {{ "kind": "polygon", "rings": [
                [[0, 0], [400, 0], [400, 400], [200, 400], [200, 200], [0, 200]],
                [[10, 250], [150, 250], [150, 390], [10, 390]]
            ] }},
            "fix_boundary": {fix_boundary},
            "handles": [
                {{ "id": "island", "kind": "point", "rest": [80, 320] }},
                {{ "id": "bar", "kind": "bar", "rest": [[250, 350], [350, 350]] }},
                {{ "id": "point", "kind": "point", "rest": [60, 150] }}
            ]
        }}"#
        );
        solve(&Project::from_json(&json).unwrap(), &Picture::new(400, 400, &[255; 640_000]).unwrap()).unwrap()
    }

    #[test]
    fn shares_of_the_handles_of_an_island_sum_to_one() {
        for p in [[150.0, 120.0], [300.0, 220.0], [60.0, 150.0]] {
            let lens = angle(false).lens(p.into()).unwrap();
            assert_eq!(lens.shares.iter().map(|share| share.handle).collect::<Vec<_>>(), [1, 2]);
            let sum: f64 = lens.shares.iter().map(|share| share.weight + share.passed_on).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{sum}");
            let direct: f64 = lens.shares.iter().map(|share| share.weight).sum();
            assert!((direct + lens.virtual_weight - 1.0).abs() < 1e-12);
            assert!(lens.sites.is_sorted_by(|a, b| a.weight >= b.weight));
        }
    }

    #[test]
    fn paths_stay_inside_and_are_as_long_as_the_distances() {
        let solution = angle(false);
        let p = DVec2::new(60.0, 190.0);
        let lens = solution.lens(p).unwrap();
        for share in &lens.shares {
            let length: f64 = share.path.windows(2).map(|ends| ends[0].distance(ends[1])).sum();
            assert!((length - share.distance).abs() < 1e-9 && share.path[0] == p);
            assert_eq!(share.path.last(), Some(&solution.sites()[share.site].rest));
        }
        // Around the corner of the angle.
        assert_eq!(lens.shares[0].path[1], DVec2::new(200.0, 200.0));
        assert_eq!(lens.shares[1].path.len(), 2);
    }

    #[test]
    fn held_boundary_is_last_and_points_outside_have_no_lens() {
        let solution = angle(true);
        let lens = solution.lens(DVec2::new(300.0, 220.0)).unwrap();
        assert_eq!(lens.shares.iter().map(|share| share.handle).collect::<Vec<_>>(), [1, 2, -2]);
        assert!(solution.lens(DVec2::new(100.0, 230.0)).is_none());
    }
}
