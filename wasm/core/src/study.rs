//! A solution explained: outline, cells with their radii, falloff, and the rounds of Algorithm 1. For figures.
//!
//! Follows figures 2 and 3. Cost: a visit of every pair of sites, and the lookup of two paths for each site.

use glam::DVec2;

use crate::{
    project::Weighting,
    site::{Round, allowed_score},
    solution::Solution,
    weight::support_radii,
};

/// Number of segments in the curve of the falloff.
const FALLOFF_PIECES: u32 = 64;
/// Relative tolerance for a site at the separation. Rounding errors are far smaller.
const AT_SEPARATION: f64 = 1e-9;

/// A solution, explained. Points are in image pixels at rest, lengths in pixels.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Study {
    /// The rings of the domain.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<Vec<(f64, f64)>>"))]
    pub outline: Vec<Vec<DVec2>>,
    /// The sites in the order of insertion.
    pub sites: Vec<SiteStudy>,
    /// φ at even steps from 0 to 1.
    pub falloff: Vec<f64>,
    /// The rounds of Algorithm 1; empty without sites.
    pub rounds: Vec<Round>,
    /// The score at or below which Algorithm 1 ends.
    pub allowed_score: f64,
}

/// A site with its cell and its support.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SiteStudy {
    /// h_i: the rest position.
    #[cfg_attr(feature = "schema", schemars(with = "(f64, f64)"))]
    pub rest: DVec2,
    /// Index of the handle in the project; −1 for a virtual site, −2 for one of a held boundary.
    pub handle: i32,
    /// r_d: distance of the farthest point of the cell.
    pub cell_radius: f64,
    /// r_h: distance of the nearest other site. Null if the island has no other.
    pub separation: Option<f64>,
    /// r_i: distance at which φ reaches zero. Null if the support has no end.
    pub support_radius: Option<f64>,
    /// r_i for α = 0 and for α = 1; empty if the support has no end.
    pub support_range: Vec<f64>,
    /// The shortest path to the farthest point of the cell.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<(f64, f64)>"))]
    pub to_farthest: Vec<DVec2>,
    /// The shortest path to the nearest other site; empty if a bar or a held boundary is nearer.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<(f64, f64)>"))]
    pub to_nearest: Vec<DVec2>,
}

impl Solution {
    /// Explains the solution.
    #[must_use]
    pub fn study(&self) -> Study {
        let basis = self.functions.basis();
        let at = |piece: u32| basis.value(f64::from(piece) / f64::from(FALLOFF_PIECES));
        let range = [0.0, 1.0].map(|shape_factor| {
            let weighting = Weighting { shape_factor, ..self.weighting.clone() };
            support_radii(&weighting, self.sites())
        });
        Study {
            outline: self.domain().rings().to_vec(),
            sites: (0..self.sites().len()).map(|site| self.site_study(site, &range)).collect(),
            falloff: (0..=FALLOFF_PIECES).map(at).collect(),
            rounds: self.rounds.iter().filter(|round| round.score.is_finite()).cloned().collect(),
            allowed_score: allowed_score(),
        }
    }

    fn site_study(&self, site: usize, range: &[Vec<f64>; 2]) -> SiteStudy {
        let of_site = &self.sites()[site];
        let support_range = range.iter().map(|radii| radii[site]).filter(|radius| radius.is_finite()).collect();
        SiteStudy {
            rest: of_site.rest,
            handle: of_site.kind.handle_code(),
            cell_radius: of_site.cell_radius,
            separation: Some(of_site.separation).filter(|separation| separation.is_finite()),
            support_radius: Some(of_site.support_radius).filter(|radius| radius.is_finite()),
            support_range,
            to_farthest: self.path_within_field(site, of_site.farthest).unwrap_or_default(),
            to_nearest: self.path_to_nearest(site).unwrap_or_default(),
        }
    }

    /// The path to the site at the distance of the separation.
    fn path_to_nearest(&self, site: usize) -> Option<Vec<DVec2>> {
        let (sites, fields) = (self.sites(), self.functions.fields());
        let limit = sites[site].separation * (1.0 + AT_SEPARATION);
        let is_nearest = |&other: &usize| {
            let at = sites[other].rest;
            let distance = |other: usize| fields[site].distance(fields[other].triangle, at);
            let is_apart = |d: f64| (d - sites[site].separation).abs() <= limit - sites[site].separation;
            other != site && sites[site].rest.distance(at) <= limit && is_apart(distance(other))
        };
        let other = (0..sites.len()).find(is_nearest)?;
        self.path_within_field(site, sites[other].rest)
    }

    /// The shortest path from a site to a point, if its field reaches that far.
    fn path_within_field(&self, site: usize, p: DVec2) -> Option<Vec<DVec2>> {
        let (triangle, p) = self.navigation().locate(p)?;
        self.functions.fields()[site].distances.path(self.navigation(), triangle, p)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Picture, project::Project, solve};

    fn length(path: &[DVec2]) -> f64 {
        path.windows(2).map(|ends| ends[0].distance(ends[1])).sum()
    }

    /// An angle with a handle in each limb.
    fn angle(shape_factor: f64) -> Solution {
        let json = format!(
            r#"{{
            "format": "c2warp/1", "image": {{ "src": "", "width": 400, "height": 400 }}, "samples": 2000,
            "domain": {{ "kind": "polygon",
                "rings": [[[0, 0], [400, 0], [400, 400], [200, 400], [200, 200], [0, 200]]] }},
            "weighting": {{ "shape_factor": {shape_factor} }},
            "handles": [
                {{ "id": "a", "kind": "point", "rest": [60, 150] }}, {{ "id": "b", "kind": "point", "rest": [90, 150] }}
            ]
        }}"#
        );
        solve(&Project::from_json(&json).unwrap(), &Picture::new(400, 400, &[255; 640_000]).unwrap()).unwrap()
    }

    #[test]
    fn paths_are_as_long_as_the_radii_of_the_cells() {
        let study = angle(1.0).study();
        assert!(study.sites.len() > 2 && study.outline.len() == 1);
        for site in &study.sites {
            assert!((length(&site.to_farthest) - site.cell_radius).abs() < 1e-9 * site.cell_radius);
            assert!((length(&site.to_nearest) - site.separation.unwrap()).abs() < 1e-6);
            assert!(site.to_farthest[0] == site.rest && site.to_nearest[0] == site.rest);
        }
    }

    #[test]
    fn supports_lie_in_their_range_and_end_it_at_the_extreme_shape_factors() {
        for (shape_factor, end) in [(0.0, Some(0)), (0.3, None), (1.0, Some(1))] {
            for site in angle(shape_factor).study().sites {
                let (radius, range) = (site.support_radius.unwrap(), &site.support_range);
                let rounding = 1e-12 * radius;
                assert!(range[0] <= radius + rounding && radius <= range[1] + rounding);
                assert!(end.is_none_or(|end: usize| (range[end] - radius).abs() <= rounding));
            }
        }
    }

    #[test]
    fn falloff_falls_from_one_to_zero() {
        let Study { falloff, .. } = angle(1.0).study();
        assert_eq!((falloff[0], falloff[FALLOFF_PIECES as usize]), (1.0, 0.0));
        assert!(falloff.is_sorted_by(|a, b| a > b));
    }

    #[test]
    fn rounds_divide_cells_that_are_too_large_until_none_is() {
        let solution = angle(1.0);
        let Study { rounds, sites, allowed_score, .. } = solution.study();
        let (last, before) = rounds.split_last().unwrap();
        assert!(last.points.is_empty() && last.score <= allowed_score && last.sites == sites.len());
        assert!(before.len() > 2 && before.iter().all(|round| !round.points.is_empty()));
        for pair in rounds.windows(2) {
            let inserted = &sites[pair[0].sites..pair[1].sites];
            assert_eq!(inserted.len(), pair[0].points.len());
            for point in &pair[0].points {
                assert!(inserted.iter().any(|site| site.rest == point.at) && point.owner < pair[0].sites);
                assert!((length(&point.path) - point.distance).abs() < 1e-6 && point.path.last() == Some(&point.at));
                // The farthest point of the worst cell: its distance and limit make the score.
                let score = 1.0 - point.limit / point.distance;
                assert!((score - pair[0].score).abs() < 1e-6, "{score} {pair:?}");
            }
        }
    }
}
