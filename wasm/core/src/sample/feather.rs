//! The feather of a domain of rings: a soft rim along which a moved part fades out.
//!
//! A [fringe](super::fringe) around the outline tiles the rim. Each vertex moves with a sample of the outline, and has
//! a level: 1 on the outline, 0 where the rim ends, and linear in the distance between. A gap between two parts of the
//! outline is cut along its middle, and the rims of both end there. Near a border of the picture, they end at the
//! border, so that no cut is visible.
//!
//! Over a fill, the part moves with an opaque [skirt](super::skirt), and the rim begins at the end of the skirt.
//!
//! Cost: that of a fringe, and a search of the nearest samples of the outline for each vertex. Known limits: rims are
//! drawn before the whole mesh. So a part has no soft rim over other parts of its own selection.

use std::collections::HashMap;

use glam::DVec2;

use super::{
    fringe::{DETOUR_SLACK, parts::Parts, spacing},
    skirt::{Skirt, WIDTH},
};
use crate::{
    domain::Mask, point_tree::Tree, prepared_domain::PreparedDomain, segment::nearest_on_segment,
    triangulation::Triangulation,
};

/// Nodes across the width of the rim.
const NODES_ACROSS: f64 = 3.0;
/// Number of samples that are first searched for the outline.
const NEAREST: usize = 8;
/// An outline this close to a border of the picture, in pixels, counts as lying on it, because a rim has no room.
const ON_BORDER_PX: f64 = 1.0;
/// Greatest absolute level. Levels are this steep in gaps of a pixel.
const MOST_LEVEL: f64 = 64.0;

/// A mesh around the samples of a domain, and its opacity. Empty without a feather.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Feather {
    vertices: Vec<DVec2>,
    owners: Vec<u32>,
    levels: Vec<f64>,
    triangles: Vec<[u32; 3]>,
}

impl Feather {
    /// The feather of samples and their outline, with the width of a prepared domain.
    pub(super) fn new(mesh: &Triangulation, outline: &[Vec<u32>], prepared: &PreparedDomain) -> Self {
        let (width, Some(size)) = (prepared.feather, prepared.background_size) else { return Self::default() };
        if width == 0.0 {
            return Self::default();
        }
        let start = if prepared.around.is_some() { WIDTH } else { 0.0 };
        let (rings, whole) = (prepared.domain.rings(), size.as_uvec2());
        let near = Mask::with_band(rings, (whole.x, whole.y), start + width).opacity((whole.x, whole.y));
        let length: f64 = prepared.domain.edges().map(|(a, b)| a.distance(b)).sum();
        let spacing = spacing(length * width).max(width / NODES_ACROSS);
        let skirt = Skirt::new(&mesh.vertices, outline, size).with_fringe(mesh, outline, &near, spacing);
        let around = Surroundings::new(mesh, outline, size, DETOUR_SLACK * spacing);
        let mut numbers = HashMap::new();
        let mut feather = Self::default();
        for triangle in &skirt.triangles {
            let corners = triangle.map(|vertex| {
                *numbers.entry(vertex).or_insert_with(|| {
                    let owner = match (vertex as usize).checked_sub(mesh.vertices.len()) {
                        Some(beyond) => skirt.owners[beyond],
                        None => vertex,
                    };
                    let place = skirt.place(&mesh.vertices, vertex);
                    feather.vertices.push(place);
                    feather.owners.push(owner);
                    feather.levels.push(around.level(place, owner, start, width));
                    feather.vertices.len() as u32 - 1
                })
            });
            if corners.iter().any(|&corner| feather.levels[corner as usize] > 0.0) {
                feather.triangles.push(corners);
            }
        }
        feather
    }

    /// Vertices at rest, in image pixels.
    #[must_use]
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// For each vertex, the sample of the mesh that it moves with, and whose weights it has.
    #[must_use]
    pub fn owners(&self) -> &[u32] {
        &self.owners
    }

    /// The level of each vertex: 1 and more is opaque, 0 and less is transparent. Between vertices levels are linear.
    /// The opacity of a level t is t² (3 − 2 t).
    #[must_use]
    pub fn levels(&self) -> &[f64] {
        &self.levels
    }

    /// Triangles × 3 vertices.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }
}

/// The outline around a rim.
struct Surroundings {
    parts: Parts,
    segments: Vec<[usize; 2]>,
    /// The segment that ends at each sample.
    before: Vec<usize>,
    /// The number of each sample on the outline.
    numbers: HashMap<u32, u32>,
    tree: Tree,
    size: DVec2,
    /// Tolerance for a longer way along the outline.
    slack: f64,
}

impl Surroundings {
    fn new(mesh: &Triangulation, outline: &[Vec<u32>], size: DVec2, slack: f64) -> Self {
        let parts = Parts::new(mesh, outline);
        let segments = parts.segments();
        let mut before = vec![0; segments.len()];
        segments.iter().enumerate().for_each(|(segment, &[_, to])| before[to] = segment);
        let numbers = outline.iter().flatten().copied().zip(0..).collect();
        let tree = Tree::new(&parts.points);
        Self { parts, segments, before, numbers, tree, size, slack }
    }

    /// The level at a point that moves with a sample. The rim begins `start` pixels away from the outline.
    fn level(&self, p: DVec2, owner: u32, start: f64, width: f64) -> f64 {
        let nearest = self.nearest(p, self.samples(p, NEAREST).into_iter());
        let away = p.distance(nearest);
        let reach = start + width;
        let end = reach.min((away + self.across(p, owner, reach)) / 2.0).min(self.border(p, nearest));
        if end <= start { 1.0 } else { ((end - away) / (end - start)).clamp(-MOST_LEVEL, MOST_LEVEL) }
    }

    /// The samples nearest to a point.
    fn samples(&self, p: DVec2, count: usize) -> Vec<u32> {
        self.tree.nearest(&self.parts.points, p, count).into_iter().map(|(_, sample)| sample).collect()
    }

    /// The nearest point on the segments at the given samples; infinitely far without samples.
    fn nearest(&self, p: DVec2, samples: impl Iterator<Item = u32>) -> DVec2 {
        let segments = samples.flat_map(|sample| [sample as usize, self.before[sample as usize]]);
        let places = segments.map(|segment| {
            let [a, b] = self.segments[segment].map(|end| self.parts.points[end]);
            nearest_on_segment(p, a, b)
        });
        let nearer = |a: DVec2, b: DVec2| if b.distance_squared(p) < a.distance_squared(p) { b } else { a };
        places.fold(DVec2::INFINITY, nearer)
    }

    /// The distance from a point to the nearest part of the outline that moves differently from its owner. It is
    /// infinite beyond twice the width of a rim.
    fn across(&self, p: DVec2, owner: u32, reach: f64) -> f64 {
        let (own, all) = (self.numbers[&owner], self.parts.points.len());
        let mut count = 2 * NEAREST;
        loop {
            let near = self.samples(p, count);
            let is_last = count >= all
                || near.last().is_some_and(|&last| self.parts.points[last as usize].distance(p) > 2.0 * reach);
            let others: Vec<u32> =
                near.into_iter().filter(|&sample| !self.parts.are_one(own, sample, self.slack)).collect();
            if is_last || !others.is_empty() {
                return p.distance(self.nearest(p, others.into_iter()));
            }
            count *= 4;
        }
    }

    /// The distance from a point on the outline to the border of the picture, in the direction of another point.
    fn border(&self, p: DVec2, from: DVec2) -> f64 {
        let along = (p - from).normalize_or_zero();
        let room = |axis: usize| {
            let room = if along[axis] > 0.0 { self.size[axis] - from[axis] } else { from[axis] };
            if room < ON_BORDER_PX || along[axis] == 0.0 { f64::INFINITY } else { room / along[axis].abs() }
        };
        room(0).min(room(1))
    }
}
