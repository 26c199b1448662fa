//! The navigation mesh: a triangulation of the domain's outline, without other vertices. Distances are computed on it.
//!
//! Cost: O(n log n) for n corners. Locating a point tests a few triangles.

use glam::DVec2;

use super::window::WINDOW_SLACK;
use crate::{
    domain::{Domain, corners_between},
    rows::Rows,
    segment::nearest_on_segment,
    triangulation::{Locator, NONE, Triangulation, signed_depth},
};

/// Index of a triangle of the navigation mesh.
///
/// Locating a point takes half the time of a distance query, so samples store their triangles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NavTriangle(pub(crate) u32);

/// Corners that turn by less than this (sine of the angle) are straight: no path becomes shorter by bending there.
const STRAIGHT_SINE: f64 = 1e-12;

/// A point up to this far outside its triangle, in pixels, is not moved into it, because windows have the same
/// tolerance.
const OUTSIDE_SLACK: f64 = WINDOW_SLACK / 2.0;
/// A point up to this far from a corner, in pixels, is replaced by the corner. Otherwise rounding would determine which
/// edge at the corner it lies on.
const ON_CORNER: f64 = 1e-8;

/// The navigation mesh: the constrained Delaunay triangulation of a domain's outline, with the triangles around each
/// corner.
///
/// It serves [distances](Self::distances_from) from one source after another.
#[derive(Debug, Clone)]
pub struct Navigation {
    pub(crate) mesh: Triangulation,
    /// Island of each triangle.
    pub(crate) island: Vec<u32>,
    pub(crate) corners: Vec<Corner>,
    /// Triangles around each corner in positive order, from its wall `next` to its wall `prev`. Each has the index of
    /// the corner in it.
    fans: Rows<(u32, u8)>,
    locator: Locator,
}

/// A vertex of the outline.
///
/// The domain fills the angle from the direction `next`, turning positively, to the direction `prev`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    pub(crate) next: DVec2,
    pub(crate) prev: DVec2,
    /// Whether the angle inside the domain exceeds π. Paths may bend at such a corner.
    pub(crate) reflex: bool,
}

impl Navigation {
    /// Triangulates a domain's outline. Cost: O(n log n) for n corners.
    #[must_use]
    pub fn new(domain: &Domain) -> Self {
        let (mut vertices, mut segments, mut corners) = (Vec::new(), Vec::new(), Vec::new());
        for ring in domain.rings() {
            let (start, n) = (vertices.len(), ring.len());
            for (i, [prev, at, next]) in corners_between(ring).enumerate() {
                let (prev, next) = ((prev - at).normalize(), (next - at).normalize());
                corners.push(Corner { next, prev, reflex: next.perp_dot(prev) < -STRAIGHT_SINE });
                segments.push([start + i, start + (i + 1) % n]);
            }
            vertices.extend_from_slice(ring);
        }
        let mesh = Triangulation::constrained_delaunay(vertices, segments);
        let fans = fans(&mesh);
        let island = islands(&mesh);
        let locator = Locator::new(&mesh);
        Self { mesh, island, corners, fans, locator }
    }

    /// The triangle of a point, or `None` outside the domain. Up to a millionth of a pixel outside the outline counts
    /// as rounding.
    pub(crate) fn triangle_at(&self, p: DVec2) -> Option<NavTriangle> {
        self.locator.locate(&self.mesh, p).map(|t| NavTriangle(t as u32))
    }

    /// The triangle of a point from the caller, and the point inside it; `None` outside the domain.
    ///
    /// A point outside by no more than [`triangle_at`](Self::triangle_at) allows is moved onto the outline.
    pub(crate) fn locate(&self, p: DVec2) -> Option<(NavTriangle, DVec2)> {
        self.triangle_at(p).map(|triangle| (triangle, self.clamped_to(triangle, p)))
    }

    /// The point of a triangle nearest to `p`, or the corner next to it. This is usually `p` itself.
    pub(crate) fn clamped_to(&self, triangle: NavTriangle, p: DVec2) -> DVec2 {
        let corners = self.mesh.corners(triangle.0 as usize);
        let edges = (0..3).map(|k| (corners[k], corners[(k + 1) % 3]));
        let beyond = edges.filter(|&(a, b)| (b - a).perp_dot(p - a) < 0.0);
        let nearer = |one: DVec2, other: DVec2| if other.distance(p) < one.distance(p) { other } else { one };
        let on_edge = beyond.map(|(a, b)| nearest_on_segment(p, a, b)).reduce(nearer);
        let inside = on_edge.filter(|on_edge| on_edge.distance(p) > OUTSIDE_SLACK).unwrap_or(p);
        corners.into_iter().find(|p| p.distance_squared(inside) <= ON_CORNER * ON_CORNER).unwrap_or(inside)
    }

    /// Whether a point of a triangle lies on its border, within rounding. It may then lie in another triangle, too.
    pub(crate) fn is_on_edge(&self, triangle: NavTriangle, p: DVec2) -> bool {
        signed_depth(self.mesh.corners(triangle.0 as usize), p) <= OUTSIDE_SLACK
    }

    /// The triangles that meet at a corner of the outline.
    pub(crate) fn around(&self, corner: DVec2) -> impl Iterator<Item = NavTriangle> + '_ {
        let is_corner = move |&v: &u32| self.mesh.vertices[v as usize] == corner;
        let of_triangle = self.triangle_at(corner).map(|triangle| self.mesh.triangles[triangle.0 as usize]);
        let known = of_triangle.into_iter().flatten().find(is_corner);
        known.into_iter().flat_map(|v| self.fan(v as usize)).map(|&(t, _)| NavTriangle(t))
    }

    /// All triangles with their corners.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = (NavTriangle, [DVec2; 3])> + '_ {
        (0..self.mesh.triangles.len()).map(|t| (NavTriangle(t as u32), self.mesh.corners(t)))
    }

    /// Index of the island of a triangle: the connected part of the domain that contains it.
    pub(crate) fn island_of(&self, triangle: NavTriangle) -> usize {
        self.island[triangle.0 as usize] as usize
    }

    /// Corners of the outline at which shortest paths may bend.
    pub(crate) fn reflex_corners(&self) -> impl Iterator<Item = DVec2> + '_ {
        let corners = self.corners.iter().zip(&self.mesh.vertices);
        corners.filter(|(corner, _)| corner.reflex).map(|(_, &p)| p)
    }

    /// Triangles around a corner, each with the index of the corner in it.
    pub(crate) fn fan(&self, corner: usize) -> &[(u32, u8)] {
        self.fans.row(corner)
    }
}

fn fans(mesh: &Triangulation) -> Rows<(u32, u8)> {
    // The triangle on the edge from the corner to its next one along the outline.
    let mut first = vec![(NONE, 0_u8); mesh.vertices.len()];
    for (t, (corners, neighbours)) in mesh.triangles.iter().zip(&mesh.neighbours).enumerate() {
        for k in 0..3 {
            if neighbours[k] == NONE {
                first[corners[k] as usize] = (t as u32, k as u8);
            }
        }
    }
    let around = |corner: usize| {
        let next = move |&(t, k): &(u32, u8)| {
            let neighbour = mesh.neighbours[t as usize][usize::from(k + 2) % 3];
            (neighbour != NONE).then(|| {
                let at = mesh.triangles[neighbour as usize].iter().position(|&v| v as usize == corner);
                (neighbour, at.expect("neighbours around a corner share it") as u8)
            })
        };
        let fan = std::iter::successors(Some(first[corner]).filter(|&(t, _)| t != NONE), next);
        fan.map(move |at| (corner, at))
    };
    Rows::from_pairs(first.len(), || (0..first.len()).flat_map(around))
}

fn islands(mesh: &Triangulation) -> Vec<u32> {
    let mut island = vec![NONE; mesh.triangles.len()];
    let mut count = 0;
    for seed in 0..island.len() {
        if island[seed] != NONE {
            continue;
        }
        let mut stack = vec![seed as u32];
        while let Some(t) = stack.pop() {
            if island[t as usize] == NONE {
                island[t as usize] = count;
                stack.extend(mesh.neighbours[t as usize].iter().filter(|&&n| n != NONE));
            }
        }
        count += 1;
    }
    island
}
