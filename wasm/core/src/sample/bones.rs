//! Samples along bones, so that a straight bar is drawn straight.
//!
//! Cost: for each sample of a bone, the grid cells around it.

use glam::DVec2;

use super::lattice::LATTICE_CLEARANCE;
use crate::{domain::Domain, grid::Grid, triangulation::OUTLINE_TOLERANCE};

/// Spacing along a bone, as a multiple of the lattice spacing.
///
/// It is less than twice the distance that other samples keep from the bone. The circle over two neighbours is then
/// empty, so the edge between them belongs to the Delaunay mesh.
const BONE_SPACING: f64 = 1.9 * LATTICE_CLEARANCE;
/// Minimum distance of a bone's samples from earlier ones, as a multiple of the lattice spacing.
const MIN_DISTANCE: f64 = 0.3;

/// Adds evenly spaced samples along each bone, including both ends.
///
/// Returns those on the outline between its vertices: they must split its edges.
pub(super) fn add_bones(vertices: &mut Vec<DVec2>, bones: &[[DVec2; 2]], spacing: f64, domain: &Domain) -> Vec<DVec2> {
    let mut on_outline: Vec<DVec2> = Vec::new();
    if bones.is_empty() {
        return on_outline;
    }
    let outline = Grid::of_points(spacing, vertices);
    let mut known = Grid::of_points(MIN_DISTANCE * spacing, vertices);
    for &[a, b] in bones {
        let pieces = (a.distance(b) / (BONE_SPACING * spacing)).ceil().max(1.0);
        let along = (0..=pieces as u32).map(|i| a.lerp(b, f64::from(i) / pieces));
        for p in along {
            // A bone shorter than the spacing keeps its first end only.
            if known.around(p, MIN_DISTANCE * spacing).any(|q| q.distance(p) < MIN_DISTANCE * spacing) {
                continue;
            }
            known.insert(p, p);
            // A point on the outline lies between two samples of it.
            let may_be_on_it = outline.around(p, spacing).next().is_some();
            let is_on_it = may_be_on_it && domain.distance_to_outline(p) <= OUTLINE_TOLERANCE;
            if is_on_it { &mut on_outline } else { &mut *vertices }.push(p);
        }
    }
    on_outline
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::outline::OutlineSamples;

    #[test]
    fn samples_along_bones_are_complete_and_keep_their_distance() {
        let ring = [(0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0)].map(DVec2::from).to_vec();
        let domain = Domain::from_polygon(&[ring], 100, 80).expect("a rectangle");
        let spacing = 2.0;
        let outline = OutlineSamples::new(&domain, spacing).vertices;
        // Bones close together, across one another, short ones, and ones along the outline and up to it.
        let mut bones: Vec<[DVec2; 2]> = (0..60)
            .map(|i| f64::from(i) * 0.7)
            .map(|y| [DVec2::new(10.0, 20.0 + y), DVec2::new(90.0, 20.0 + 0.9 * y)])
            .collect();
        bones.extend([[(30.0, 5.0), (40.0, 78.0)], [(50.0, 9.0), (50.1, 9.2)]].map(|ends| ends.map(DVec2::from)));
        bones.extend([[(20.0, 0.0), (60.0, 0.0)], [(70.0, 40.0), (100.0, 40.5)]].map(|ends| ends.map(DVec2::from)));
        let mut found = outline.clone();
        let on_outline = add_bones(&mut found, &bones, spacing, &domain);
        // The same by comparing each sample with all others.
        let (mut inner, mut outer) = (outline, Vec::new());
        for [a, b] in bones {
            let pieces = (a.distance(b) / (BONE_SPACING * spacing)).ceil().max(1.0);
            for p in (0..=pieces as u32).map(|i| a.lerp(b, f64::from(i) / pieces)) {
                if inner.iter().chain(&outer).all(|q: &DVec2| q.distance(p) >= MIN_DISTANCE * spacing) {
                    let is_within = domain.distance_to_outline(p) > OUTLINE_TOLERANCE;
                    if is_within { &mut inner } else { &mut outer }.push(p);
                }
            }
        }
        assert!(outer.len() > 5 && inner.len() > 1000, "{} and {}", outer.len(), inner.len());
        assert_eq!((found, on_outline), (inner, outer));
    }
}
