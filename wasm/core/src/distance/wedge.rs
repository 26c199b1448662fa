//! The wedge beside a ray at which paths begin to bend: the triangles that its corner sees there.
//!
//! Another corner that hides a part of the wedge narrows it, so that the corner sees all the rest.
//!
//! Cost: the triangles of the wedge.

use glam::DVec2;

use super::{
    cone::{Cone, EPSILON, ray_on_edge},
    navigation::{Corner, Navigation},
    propagate::Bend,
};
use crate::{segment::segment_distance, triangulation::NONE};

/// Rays at an angle below this count as one, in radians. Paths that graze several corners in a line follow one ray.
pub(super) const ALIGNED: f64 = 1e-9;

/// Finds the triangles that a corner sees in a wedge.
pub(super) struct Wedge<'a> {
    navigation: &'a Navigation,
    /// Triangles, each with the part of the wedge that sees it.
    seen: Vec<(u32, Cone)>,
    /// Edges through which light leaves a triangle: the triangle, the edge, and the directions.
    pending: Vec<(u32, usize, Cone)>,
}

impl<'a> Wedge<'a> {
    pub(super) fn new(navigation: &'a Navigation) -> Self {
        Self { navigation, seen: Vec::new(), pending: Vec::new() }
    }

    /// Spreads light from a corner into the wedge between `ahead` and `widest`, up to paths of length `reach`. Returns
    /// `widest`, turned towards `ahead` so far that no other corner hides a part of the wedge.
    pub(super) fn spread(&mut self, bend: &Bend, (ahead, lit, widest): (DVec2, DVec2, DVec2), reach: f64) -> DVec2 {
        let mesh = &self.navigation.mesh;
        let source = mesh.vertices[bend.corner as usize];
        let mut narrowed = widest;
        self.seen.clear();
        for &(t, k) in self.navigation.fan(bend.corner as usize) {
            let facing = usize::from(k + 1) % 3;
            let ends = [facing, (facing + 1) % 3].map(|at| mesh.triangles[t as usize][at]);
            let [a, b] = ends.map(|v| (mesh.vertices[v as usize] - source).normalize());
            for end in ends {
                self.narrow(bend, (ahead, lit), end, reach, &mut narrowed);
            }
            if let Some(cone) = common(Cone { first: a, last: b }, wedge_of(ahead, lit, narrowed)) {
                self.seen.push((t, cone));
                self.pending.push((t, facing, cone));
            }
        }
        while let Some((from, k, cone)) = self.pending.pop() {
            let triangle = mesh.neighbours[from as usize][k];
            let Some(cone) = common(cone, wedge_of(ahead, lit, narrowed)).filter(|_| triangle != NONE) else {
                continue;
            };
            let ends = [mesh.triangles[from as usize][k], mesh.triangles[from as usize][(k + 1) % 3]];
            let [a, b] = ends.map(|v| mesh.vertices[v as usize]);
            let (x, y) = (ray_on_edge(source, cone.first, a, b), ray_on_edge(source, cone.last, a, b));
            if bend.offset + segment_distance(bend.before, x, y) > reach {
                continue;
            }
            self.seen.push((triangle, cone));
            let edge = mesh.neighbours[triangle as usize].iter().position(|&n| n == from);
            let edge = edge.expect("neighbours know each other");
            let (right, left) = ((edge + 1) % 3, (edge + 2) % 3);
            let opposite = mesh.triangles[triangle as usize][left];
            let direction = (mesh.vertices[opposite as usize] - source).normalize();
            let (after_first, before_last) = (cone.first.perp_dot(direction), direction.perp_dot(cone.last));
            if after_first > EPSILON && before_last > EPSILON {
                self.narrow(bend, (ahead, lit), opposite, reach, &mut narrowed);
                self.pending.push((triangle, right, Cone { last: direction, ..cone }));
                self.pending.push((triangle, left, Cone { first: direction, ..cone }));
            } else if after_first > EPSILON {
                self.pending.push((triangle, right, cone));
            } else {
                self.pending.push((triangle, left, cone));
            }
        }
        narrowed
    }

    /// Turns `narrowed` towards a vertex that hides a part of the wedge.
    fn narrow(&self, bend: &Bend, (ahead, lit): (DVec2, DVec2), vertex: u32, reach: f64, narrowed: &mut DVec2) {
        let Corner { next, prev, reflex } = self.navigation.corners[vertex as usize];
        let [from, at] = [bend.corner, vertex].map(|v| self.navigation.mesh.vertices[v as usize]);
        let direction = (at - from).normalize();
        let (sine, cosine) = (direction.dot(lit), direction.dot(ahead));
        let is_within = cosine > 0.0 && sine > ALIGNED && narrowed.dot(lit) > sine;
        // Light passes a corner on one side if both of its walls lie on the other.
        let hides = direction.perp_dot(next) * direction.perp_dot(prev) >= -EPSILON;
        if reflex && is_within && hides && bend.offset + at.distance(bend.before) <= reach {
            *narrowed = direction;
        }
    }

    /// The triangles of which the narrowed wedge sees more than a ray.
    pub(super) fn triangles(&self, ahead: DVec2, lit: DVec2, narrowed: DVec2) -> impl Iterator<Item = u32> + '_ {
        let wedge = wedge_of(ahead, lit, narrowed);
        self.seen.iter().filter(move |(_, cone)| common(*cone, wedge).is_some()).map(|&(triangle, _)| triangle)
    }
}

/// The directions between the ray ahead and another ray on the lit side.
fn wedge_of(ahead: DVec2, lit: DVec2, other: DVec2) -> Cone {
    if ahead.perp_dot(lit) > 0.0 { Cone { first: ahead, last: other } } else { Cone { first: other, last: ahead } }
}

/// The directions in a cone narrower than π and in a wedge narrower than π / 2; `None` if these are at most a ray.
fn common(cone: Cone, wedge: Cone) -> Option<Cone> {
    let first = if cone.contains(wedge.first) { wedge.first } else { cone.first };
    let last = if cone.contains(wedge.last) { wedge.last } else { cone.last };
    let is_common = wedge.contains(first) && wedge.contains(last) && first.perp_dot(last) > EPSILON;
    is_common.then_some(Cone { first, last })
}
