//! Samples along bones: a bar that stays straight is drawn straight.
//!
//! Cost: the samples of the bones, each a look at the grid cells around it.

use glam::DVec2;

use super::lattice::LATTICE_CLEARANCE;
use crate::{domain::Domain, grid::Grid, triangulation::OUTLINE_TOLERANCE};

/// Spacing along a bone, over that of the lattice: less than twice the distance that other samples keep from the bone, so
/// that the circle over two neighbours is empty and the edge between them belongs to the Delaunay mesh.
const BONE_SPACING: f64 = 1.9 * LATTICE_CLEARANCE;
/// Least distance of a bone's samples from earlier ones, over the spacing.
const MIN_DISTANCE: f64 = 0.3;

/// Adds samples evenly along each bone, both ends included. Returns those on the outline between its vertices: they must
/// split its edges.
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
            // A bone shorter than the spacing keeps its first end alone.
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
    fn samples_of_bones_are_apart_and_none_is_missing() {
        let ring = [(0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0)].map(DVec2::from).to_vec();
        let domain = Domain::from_polygon(&[ring], 100, 80).expect("a rectangle");
        let spacing = 2.0;
        let outline = OutlineSamples::new(&domain, spacing).vertices;
        // Close together, across one another, short, along the outline and up to it.
        let mut bones: Vec<[DVec2; 2]> = (0..60)
            .map(|i| f64::from(i) * 0.7)
            .map(|y| [DVec2::new(10.0, 20.0 + y), DVec2::new(90.0, 20.0 + 0.9 * y)])
            .collect();
        bones.extend([[(30.0, 5.0), (40.0, 78.0)], [(50.0, 9.0), (50.1, 9.2)]].map(|ends| ends.map(DVec2::from)));
        bones.extend([[(20.0, 0.0), (60.0, 0.0)], [(70.0, 40.0), (100.0, 40.5)]].map(|ends| ends.map(DVec2::from)));
        let mut found = outline.clone();
        let on_outline = add_bones(&mut found, &bones, spacing, &domain);
        // The same by comparing each with all.
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
