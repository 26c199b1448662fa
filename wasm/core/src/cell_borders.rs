//! The borders between the cells 𝒱(h_i) (section III-B), to be drawn over a picture at rest or posed.
//!
//! In each triangle between samples of different cells the border is a straight piece, or three pieces if three cells
//! meet. An end has the same distance to both sites, found by bisection of an edge to a sixty-fourth. Sites of one
//! handle, for example along a bar, share one cell. So do those of a held outline.
//!
//! Cost: a few distances to two sites for each edge between cells; two milliseconds for 100 sites and 10,000 samples.
//! Limits: cells without samples, and parts of cells between two samples of another cell, are missed.

use std::collections::HashMap;

use glam::DVec2;

use crate::{
    distance::Navigation,
    render_mesh::RenderMesh,
    site::{Site, SiteField, SiteKind},
};

/// Number of bisections of an edge.
const HALVINGS: u32 = 6;

/// A straight piece of a border, within one triangle of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct BorderPiece {
    /// The vertices of the triangle.
    pub corners: [u32; 3],
    /// Both ends in barycentric coordinates. They hold at rest and, as triangles are drawn flat, in any pose.
    pub ends: [[f64; 3]; 2],
}

impl BorderPiece {
    /// A piece between two ends in barycentric coordinates.
    #[must_use]
    pub fn new(corners: [u32; 3], ends: [[f64; 3]; 2]) -> Self {
        Self { corners, ends }
    }
}

/// The borders in a mesh whose first vertices are samples, each with its nearest site.
pub(crate) fn cell_borders(
    mesh: &RenderMesh,
    nearest: &[u32],
    sites: &[Site],
    fields: &[SiteField],
    navigation: &Navigation,
) -> Vec<BorderPiece> {
    let site = |vertex: u32| sites.get(nearest[vertex as usize] as usize);
    let divided = |a: u32, b: u32| {
        nearest[a as usize] != nearest[b as usize]
            && matches!((site(a), site(b)), (Some(one), Some(other)) if !have_one_cell(one, other))
    };
    let mut found = HashMap::new();
    let mut crossing = |a: u32, b: u32| {
        let (from, to) = (a.min(b), a.max(b));
        let fraction = *found.entry((from, to)).or_insert_with(|| {
            let [start, end] = [from, to].map(|vertex| mesh.vertices[vertex as usize]);
            let [one, other] = [from, to].map(|vertex| &fields[nearest[vertex as usize] as usize]);
            equidistant(navigation, [one, other], start, end)
        });
        if a == from { fraction } else { 1.0 - fraction }
    };
    let mut pieces = Vec::new();
    let between = |corners: &&[u32; 3]| corners.iter().all(|&vertex| (vertex as usize) < nearest.len());
    for &corners in mesh.triangles.iter().filter(between) {
        let mut ends: Vec<[f64; 3]> = Vec::with_capacity(3);
        for k in 0..3 {
            let next = (k + 1) % 3;
            if divided(corners[k], corners[next]) {
                let fraction = crossing(corners[k], corners[next]);
                let mut end = [0.0; 3];
                (end[k], end[next]) = (1.0 - fraction, fraction);
                ends.push(end);
            }
        }
        match ends[..] {
            [one, other] => pieces.push(BorderPiece { corners, ends: [one, other] }),
            [a, b, c] => {
                let middle = [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0);
                pieces.extend([a, b, c].map(|end| BorderPiece { corners, ends: [end, middle] }));
            }
            _ => {}
        }
    }
    pieces
}

/// Whether two sites belong to the same handle, or to the held outline.
fn have_one_cell(one: &Site, other: &Site) -> bool {
    match one.kind.handle() {
        Some(handle) => other.kind.handle() == Some(handle),
        None => one.kind == SiteKind::Boundary && other.kind == SiteKind::Boundary,
    }
}

/// The fraction of a segment at which two sites are equally distant, if one is nearer to its start and the other to its
/// end.
fn equidistant(navigation: &Navigation, [one, other]: [&SiteField; 2], start: DVec2, end: DVec2) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        let p = start.lerp(end, middle);
        // A segment along the outline may leave the domain by rounding.
        let Some((triangle, p)) = navigation.locate(p) else { break };
        match one.distance(triangle, p) < other.distance(triangle, p) {
            true => low = middle,
            false => high = middle,
        }
    }
    f64::midpoint(low, high)
}

#[cfg(test)]
mod tests {
    use crate::{
        Solution,
        domain::Domain,
        project::{Handle, Project},
        solve_domain,
    };

    use super::*;

    const SIDE: f64 = 100.0;

    fn square(handles: impl IntoIterator<Item = Handle>) -> Solution {
        let ring = [(0.0, 0.0), (SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE)].map(DVec2::from).to_vec();
        let mut project = Project::for_picture(1, 1).with_handles(handles);
        project.samples = 900;
        solve_domain(&project, &Domain::from_rings(&[ring]).unwrap()).unwrap()
    }

    fn ends(solution: &Solution) -> Vec<[DVec2; 2]> {
        let at = |corners: [u32; 3], coordinates: [f64; 3]| -> DVec2 {
            (0..3).map(|k| coordinates[k] * solution.vertices()[corners[k] as usize]).sum()
        };
        let pieces = solution.cell_borders();
        pieces.into_iter().map(|piece| piece.ends.map(|coordinates| at(piece.corners, coordinates))).collect()
    }

    /// The distances from a place to all sites, ascending; the square is convex.
    fn far(solution: &Solution, p: DVec2) -> Vec<f64> {
        let mut far: Vec<f64> = solution.sites().iter().map(|site| site.rest.distance(p)).collect();
        far.sort_by(f64::total_cmp);
        far
    }

    #[test]
    fn every_end_is_as_far_from_its_two_nearest_sites() {
        let places = [(20.0, 25.0), (80.0, 25.0), (50.0, 80.0), (40.0, 30.0)];
        let solution = square(places.iter().enumerate().map(|(id, &p)| Handle::point(id.to_string(), p)));
        let ends = ends(&solution);
        let mut meeting = 0;
        for p in ends.iter().flatten() {
            let far = far(&solution, *p);
            // Half an edge. Where three cells meet, the middle is a mean of three places on edges, and the tip of a
            // third cell may cross an edge between the others.
            assert!(far[1] - far[0] < 1.75, "{p}: {far:?}");
            meeting += usize::from(far[2] - far[0] < 1.0);
        }
        assert!(meeting > 3, "{meeting}");
    }

    #[test]
    fn points_of_different_cells_are_separated_by_a_border() {
        let solution = square([Handle::point("left", [30.0, 40.0]), Handle::point("right", [70.0, 40.0])]);
        let line: f64 = ends(&solution)
            .iter()
            .map(|[a, b]| if a.x.min(b.x) > 49.5 && a.x.max(b.x) < 50.5 { a.distance(*b) } else { 0.0 })
            .sum();
        let same = (0..1_000).map(|i| DVec2::new(50.0, f64::from(i) / 10.0)).filter(|&p| {
            let far = far(&solution, p);
            far[1] - far[0] < 1e-9
        });
        let length = same.count() as f64 / 10.0;
        assert!(length > 20.0 && (line - length).abs() < 2.0, "{line} of {length}");
    }

    #[test]
    fn no_border_crosses_a_bar() {
        let bar = [[20.0, 30.0], [80.0, 30.0]];
        let solution = square([Handle::bar("bar", bar), Handle::point("point", [50.0, 70.0])]);
        assert!(solution.sites().iter().filter(|site| site.kind.is_real()).count() > 2);
        let ends = ends(&solution);
        let [start, end] = bar.map(DVec2::from);
        let near = |p: &DVec2| p.distance(p.clamp(start, end)) < 2.0;
        assert!(!ends.is_empty() && !ends.iter().flatten().any(near));
    }
}
