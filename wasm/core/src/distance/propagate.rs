//! Computes the windows of a distance field: continuous Dijkstra over the navigation mesh.
//!
//! Windows and corners are processed in the order of their minimum distance. A window crosses its triangle, assigns a
//! distance to the opposite corner, and continues through the far edges that it sees. A reflex corner becomes a
//! pseudo-source for directions that are only visible from paths around it.
//!
//! A window is dropped if a path through a known corner is shorter over its whole width. All windows that remain are
//! true paths, and every shortest path is among them.
//!
//! Cost: about ten windows for each corner of the outline within the bound, some 50 ns each.

use std::collections::BinaryHeap;

use glam::DVec2;

use super::{
    cone::{Cone, EPSILON, ON_EDGE, is_on_edge, ray_on_edge},
    field::DistanceField,
    navigation::{NavTriangle, Navigation},
    window::Window,
};
use crate::{
    min_entry::MinEntry,
    rank::{ascending, sort_by_rank},
    segment::segment_distance,
    triangulation::NONE,
};

/// Working memory for distance fields, to be reused.
#[derive(Debug, Default)]
pub(crate) struct Propagation {
    /// The shortest known path to each corner of the outline.
    corners: Vec<CornerPath>,
    /// Corners with a known path.
    touched: Vec<u32>,
    queue: BinaryHeap<Event>,
    pending: Vec<Crossing>,
    /// All windows so far, each with its triangle.
    found: Vec<(u32, Window)>,
    /// The triangle of each window found, and the index of the window.
    order: Vec<(u32, u32)>,
    /// The corners at which paths of the last field bend, in the order of their distance.
    bends: Vec<Bend>,
    /// Number of windows and corners of all fields so far.
    steps: u64,
}

/// A corner at which shortest paths bend, and the side that is only visible from paths around it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bend {
    pub(super) corner: u32,
    /// The pseudo-source before the corner.
    pub(super) before: DVec2,
    /// Length of the path to `before`.
    pub(super) offset: f64,
    /// Whether the shadow lies on the positive side of the ray from `before` through the corner.
    pub(super) is_shadow_positive: bool,
}

/// A path to a corner of the outline.
#[derive(Debug, Clone, Copy)]
struct CornerPath {
    /// Infinite if no path is known.
    distance: f64,
    /// The pseudo-source before the corner.
    pseudo_source: DVec2,
}

impl CornerPath {
    const UNKNOWN: Self = Self { distance: f64::INFINITY, pseudo_source: DVec2::ZERO };
}

/// A window about to enter a triangle through the edge from corner `edge` to the next one.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    triangle: u32,
    edge: u8,
    window: Window,
}

/// An event, keyed by its distance: the index of a crossing, or [`CORNER_BIT`] plus the index of a corner.
type Event = MinEntry<u32>;

const CORNER_BIT: u32 = 1 << 31;

impl Propagation {
    /// Returns exact distances from `source`, a point of `triangle`, up to `bound` pixels. With an infinite bound, it
    /// has all of them.
    pub(crate) fn field(
        &mut self,
        navigation: &Navigation,
        triangle: NavTriangle,
        source: DVec2,
        bound: f64,
    ) -> DistanceField {
        let source = navigation.clamped_to(triangle, source);
        self.reset(navigation.mesh.vertices.len());
        Wavefront { memory: self, navigation, bound }.propagate(triangle, source);
        self.collect(source, bound)
    }

    fn reset(&mut self, corners: usize) {
        if self.corners.len() == corners {
            for corner in self.touched.drain(..) {
                self.corners[corner as usize].distance = f64::INFINITY;
            }
        } else {
            self.corners.clear();
            self.corners.resize(corners, CornerPath::UNKNOWN);
            self.touched.clear();
        }
        self.pending.clear();
        self.found.clear();
        self.bends.clear();
    }

    /// The number of steps of all fields so far: windows carried through a triangle, and corners.
    pub(crate) fn steps(&self) -> u64 {
        self.steps
    }

    /// The corners at which paths of the last field bend.
    pub(super) fn bends(&self) -> &[Bend] {
        &self.bends
    }

    /// Sorts the windows by triangle, and within each by minimum distance.
    fn collect(&mut self, source: DVec2, bound: f64) -> DistanceField {
        // Sort the indices first: a window is long to move, and most triangles have one or two.
        self.order.clear();
        self.order.extend(self.found.iter().zip(0..).map(|(&(t, _), at)| (t, at)));
        self.order.sort_unstable();
        let mut triangles: Vec<(u32, u32)> = Vec::new();
        let mut windows: Vec<Window> = Vec::with_capacity(self.found.len());
        for of_triangle in self.order.chunk_by(|(t, _), (u, _)| t == u) {
            let start = windows.len();
            triangles.push((of_triangle[0].0, start as u32));
            windows.extend(of_triangle.iter().map(|&(_, at)| self.found[at as usize].1));
            sort_by_rank(&mut windows[start..], |window| [ascending(window.nearest), 0]);
        }
        DistanceField { source, bound, triangles, windows }
    }
}

/// The propagation of one field.
struct Wavefront<'a> {
    memory: &'a mut Propagation,
    navigation: &'a Navigation,
    bound: f64,
}

impl Wavefront<'_> {
    fn propagate(&mut self, triangle: NavTriangle, source: DVec2) {
        self.start(triangle, source);
        while let Some(MinEntry { key: distance, item: event }) = self.memory.queue.pop() {
            self.memory.steps += 1;
            if event < CORNER_BIT {
                self.cross(self.memory.pending[event as usize]);
            } else {
                let corner = (event - CORNER_BIT) as usize;
                // A shorter path may have been found since.
                if distance <= self.memory.corners[corner].distance {
                    self.bend(corner);
                }
            }
        }
    }

    /// Opens windows over the triangle of the source and out of it. Does the same for triangles across an edge or
    /// corner that the source lies on.
    fn start(&mut self, triangle: NavTriangle, source: DVec2) {
        let mesh = &self.navigation.mesh;
        let mut around = vec![triangle.0];
        let mut next = 0;
        while let Some(&t) = around.get(next) {
            next += 1;
            let corners = mesh.corners(t as usize);
            // A half plane through the source contains a triangle that the source lies in or on.
            for half in [DVec2::X, DVec2::NEG_X] {
                let window = Window { source, offset: 0.0, first: half, last: -half, nearest: 0.0 };
                self.memory.found.push((t, window));
            }
            for k in 0..3 {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                self.reach(mesh.triangles[t as usize][k], source.distance(a), source);
                let neighbour = mesh.neighbours[t as usize][k];
                if neighbour == NONE {
                    continue;
                }
                if is_on_edge(source, a, b) {
                    if !around.contains(&neighbour) {
                        around.push(neighbour);
                    }
                } else {
                    let (first, last) = ((a - source).normalize(), (b - source).normalize());
                    let window = Window { source, offset: 0.0, first, last, nearest: 0.0 };
                    self.enter(t, k, window);
                }
            }
        }
    }

    /// Updates the path to a corner if this one is shorter.
    fn reach(&mut self, corner: u32, distance: f64, pseudo_source: DVec2) {
        let known = &mut self.memory.corners[corner as usize];
        if distance < known.distance && distance <= self.bound {
            if known.distance == f64::INFINITY {
                self.memory.touched.push(corner);
            }
            *known = CornerPath { distance, pseudo_source };
            self.memory.queue.push(MinEntry { key: distance, item: CORNER_BIT + corner });
        }
    }

    /// Sends a window out of triangle `from` through its edge `k`. Drops it if a path through a corner is shorter over
    /// its whole width.
    ///
    /// The window's cone must not extend beyond the edge.
    fn enter(&mut self, from: u32, k: usize, window: Window) {
        let mesh = &self.navigation.mesh;
        let triangle = mesh.neighbours[from as usize][k];
        // A cone without width. The dot product excludes cones of almost π: their sine is small, too.
        let empty = window.first.perp_dot(window.last) <= EPSILON && window.first.dot(window.last) > 0.0;
        if triangle == NONE || empty {
            return;
        }
        let ends = [mesh.triangles[from as usize][k], mesh.triangles[from as usize][(k + 1) % 3]];
        let [a, b] = ends.map(|v| mesh.vertices[v as usize]);
        let (x, y) = (ray_on_edge(window.source, window.first, a, b), ray_on_edge(window.source, window.last, a, b));
        let reached = |p: DVec2| window.offset + window.source.distance(p);
        let [to_a, to_b] = ends.map(|v| self.memory.corners[v as usize].distance);
        if to_a + a.distance(y) + EPSILON < reached(y) || to_b + b.distance(x) + EPSILON < reached(x) {
            return;
        }
        let nearest = window.offset + segment_distance(window.source, x, y);
        if nearest > self.bound {
            return;
        }
        let edge = mesh.neighbours[triangle as usize].iter().position(|&n| n == from);
        let edge = edge.expect("neighbours know each other") as u8;
        let event = self.memory.pending.len() as u32;
        self.memory.pending.push(Crossing { triangle, edge, window: Window { nearest, ..window } });
        self.memory.queue.push(MinEntry { key: nearest, item: event });
    }

    /// Processes a window that crosses its triangle.
    fn cross(&mut self, Crossing { triangle, edge, window }: Crossing) {
        self.memory.found.push((triangle, window));
        let mesh = &self.navigation.mesh;
        let ahead = usize::from(edge + 2) % 3;
        let corner = mesh.triangles[triangle as usize][ahead];
        let to = mesh.vertices[corner as usize] - window.source;
        let distance = to.length();
        let direction = to / distance;
        let (after_first, before_last) = (window.first.perp_dot(direction), direction.perp_dot(window.last));
        if after_first >= -EPSILON && before_last >= -EPSILON {
            self.reach(corner, window.offset + distance, window.source);
        }
        // Seen from the source, the next edge begins on the side of the first ray. The one after it ends on that of
        // the last.
        let (right, left) = (usize::from(edge + 1) % 3, ahead);
        if after_first > 0.0 {
            let last = if before_last > 0.0 { direction } else { window.last };
            self.enter(triangle, right, Window { last, ..window });
        }
        if before_last > 0.0 {
            let first = if after_first > 0.0 { direction } else { window.first };
            self.enter(triangle, left, Window { first, ..window });
        }
    }

    /// Processes a corner with its final distance: opens a cone for the paths that bend there.
    fn bend(&mut self, corner: usize) {
        let walls = self.navigation.corners[corner];
        if !walls.reflex {
            return;
        }
        let source = self.navigation.mesh.vertices[corner];
        let CornerPath { distance, pseudo_source: before } = self.memory.corners[corner];
        // A source on the corner itself sees all around it already.
        let Some(ahead) = (source - before).try_normalize() else { return };
        // A nearby source on a wall may deviate from its line by an angle above rounding.
        let slack = EPSILON.max(ON_EDGE / before.distance(source));
        let sides = (ahead.perp_dot(walls.next), ahead.perp_dot(walls.prev));
        let offset = distance - before.distance(source);
        let bend = Bend { corner: corner as u32, before, offset, is_shadow_positive: true };
        if sides.0 >= -slack && sides.1 >= -slack {
            self.memory.bends.push(bend);
            self.spread(corner, Cone { first: ahead, last: walls.prev });
        }
        if sides.0 <= slack && sides.1 <= slack {
            self.memory.bends.push(Bend { is_shadow_positive: false, ..bend });
            self.spread(corner, Cone { first: walls.next, last: ahead });
        }
    }

    /// Opens a cone at a corner: windows in the triangles around it, and through the edges opposite it.
    fn spread(&mut self, corner: usize, cone: Cone) {
        let mesh = &self.navigation.mesh;
        let (source, offset) = (mesh.vertices[corner], self.memory.corners[corner].distance);
        for &(t, k) in self.navigation.fan(corner) {
            let facing = usize::from(k + 1) % 3;
            let ends = [facing, (facing + 1) % 3].map(|at| mesh.triangles[t as usize][at]);
            let [(to_a, a), (to_b, b)] = ends.map(|v| {
                let to = mesh.vertices[v as usize] - source;
                (to.length(), to.normalize())
            });
            // The triangle's angle at the corner, cut by the cone. Both are less than π.
            let first = if cone.contains(a) { a } else { cone.first };
            let last = if cone.contains(b) { b } else { cone.last };
            let angle = Cone { first: a, last: b };
            if !angle.contains(first) || !angle.contains(last) {
                continue;
            }
            let window = Window { source, offset, first, last, nearest: offset };
            self.memory.found.push((t, window));
            if first == a {
                self.reach(ends[0], offset + to_a, source);
            }
            if last == b {
                self.reach(ends[1], offset + to_b, source);
            }
            self.enter(t, facing, window);
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::domain::Domain;

    fn star(centre: DVec2, radii: &[f64]) -> Vec<DVec2> {
        let turn = std::f64::consts::TAU / radii.len() as f64;
        let ray = |i: usize| {
            let (sin, cos) = libm::sincos(turn * i as f64);
            DVec2::new(cos, sin)
        };
        radii.iter().enumerate().map(|(i, &radius)| centre + radius * ray(i)).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 2_000,
            rng_seed: proptest::test_runner::RngSeed::Fixed(1987),
            failure_persistence: None,
            ..ProptestConfig::default()
        })]

        /// A missing or superfluous window on one side of an edge makes distances jump there. Sources lie on edges or
        /// next to them, near corners or not, by a few pixels or by less than rounding.
        #[test]
        fn distances_are_continuous_across_edges_and_beside_corners(
            outer in proptest::collection::vec(70.0..190.0_f64, 6..30),
            hole in proptest::collection::vec(8.0..65.0_f64, 3..14),
            [triangle, k] in [0..1000_usize, 0..3_usize],
            along in -14.0..2.0_f64,
            across in prop_oneof![Just(None), (-14.0..1.0_f64).prop_map(Some)],
        ) {
            let rings = [star(DVec2::splat(200.0), &outer), star(DVec2::new(195.0, 205.0), &hole)];
            let Ok(domain) = Domain::from_polygon(&rings, 400, 400) else { return Ok(()) };
            let navigation = Navigation::new(&domain);
            let mesh = &navigation.mesh;
            let corners = mesh.corners(triangle % mesh.triangles.len());
            let (corner, other) = (corners[k], corners[(k + 1) % 3]);
            let fraction = (libm::exp10(along) / corner.distance(other)).min(0.5);
            let beside = across.map_or(0.0, libm::exp10) * (other - corner).normalize().perp();
            let source = corner.lerp(other, fraction) + beside;
            let Some(triangle) = navigation.triangle_at(source) else { return Ok(()) };
            let field = Propagation::default().field(&navigation, triangle, source, f64::INFINITY);
            for (t, neighbours) in mesh.neighbours.iter().enumerate() {
                let corners = mesh.corners(t);
                for k in (0..3).filter(|&k| neighbours[k] != NONE) {
                    for fraction in [0.0, 1e-6, 1e-3, 0.2, 0.4, 0.6, 0.8, 1.0] {
                        let p = corners[k].lerp(corners[(k + 1) % 3], fraction);
                        let [here, there] = [t as u32, neighbours[k]].map(|t| field.distance(NavTriangle(t), p));
                        // Both may cut a corner by a billionth of a pixel.
                        prop_assert!((here - there).abs() < 1e-7, "{source} → {p}: {here} and {there}");
                    }
                }
            }
            for (corner, k) in mesh.vertices.iter().flat_map(|&corner| (0..8).map(move |k| (corner, k))) {
                let distance = |p: DVec2| navigation.locate(p).map(|(triangle, p)| field.distance(triangle, p));
                let at_corner = distance(corner).expect("a corner of the domain");
                for away in [1e-12, 1e-10, 3e-9, 1e-7, 9e-7] {
                    let (sin, cos) = libm::sincos(std::f64::consts::FRAC_PI_4 * f64::from(k));
                    let p = corner + away * DVec2::new(cos, sin);
                    if let Some(beside) = distance(p) {
                        prop_assert!((beside - at_corner).abs() < 2e-6, "{source} → {p}: {beside} beside {at_corner}");
                    }
                }
            }
        }
    }
}
