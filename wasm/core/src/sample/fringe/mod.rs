//! A mesh around a [skirt](super::skirt), for visible content that the skirt does not draw: glows, smoke, thin hair,
//! specks, and the ends of notches.
//!
//! Overlapping pieces of the skirt are left out. Mesh, skirt and fringe then tile the picture at rest, so nothing
//! visible is missing or drawn twice. Each vertex moves with the nearest sample of the outline, its owner.
//!
//! A gap between two parts of the outline must open when the parts separate. So triangles that extend across a gap are
//! cut along its middle, equally far from both parts. The pieces have separate vertices there.
//!
//! Cost: O(n log n) for n samples on the outline and nodes between them, and a visit of the pixels in the bounding box
//! of each triangle.

mod nodes;
pub(super) mod parts;
mod pieces;

use glam::DVec2;

pub(super) use self::nodes::spacing;
use self::{nodes::Lattice, parts::Parts, pieces::Pieces};
use super::{skirt::Skirt, tiles::Tiles};
use crate::{
    opacity::Opacity,
    point_tree::Tree,
    triangulation::{NONE, Triangulation},
};

/// Minimum distance of nodes from the outline and the border of the picture, as a multiple of the spacing. Closer ones
/// make slivers.
const CLEARANCE: f64 = 0.4;
/// Tolerance for a longer way along one part of the outline, relative to the spacing of nodes. Without it, the choice
/// would be arbitrary along some gaps.
pub(super) const DETOUR_SLACK: f64 = 4.0;
/// Minimum width of pieces of triangles, in pixels. Narrower pieces would flip when corners are rounded.
const NARROW: f64 = 1.0 / 32.0;
/// The rasteriser rounds corners to a multiple of this, in pixels.
const CORNER_STEP: f64 = 1.0 / 256.0;

impl Skirt {
    /// This skirt of a mesh with a fringe, whose nodes are `spacing` apart. `outline` lists the samples of each ring.
    pub(super) fn with_fringe(
        &self,
        mesh: &Triangulation,
        outline: &[Vec<u32>],
        opacity: &Opacity,
        spacing: f64,
    ) -> Self {
        let parts = Parts::new(mesh, outline);
        // All of them, in the order of drawing.
        let corners = |triangle: &[u32; 3]| triangle.map(|v| rounded(self.place(&mesh.vertices, v)));
        let all = mesh.triangles.iter().chain(&self.triangles).map(corners).collect();
        let (tiles, first) = (Tiles::new(all, opacity.size()), mesh.triangles.len());
        let vertices = |t: usize| mesh.triangles.get(t).unwrap_or_else(|| &self.triangles[t - first]);
        // Without a common vertex, two triangles that touch may overlap once a pose has rounded them.
        let gap = |t: usize, other: usize| {
            if vertices(t).iter().any(|v| vertices(other).contains(v)) { 0.0 } else { NARROW }
        };
        // A piece of two triangles lies beside each segment of the outline.
        let is_sound = |t: usize| !tiles.is_unsound(t, |other| gap(t, other));
        let is_kept: Vec<bool> =
            (0..parts.points.len()).map(|piece| [0, 1].iter().all(|k| is_sound(first + 2 * piece + k))).collect();
        let is_covered = |p: DVec2| tiles.cover(p, |t| t < first || is_kept[(t - first) / 2]);
        let kept = |piece: &usize| is_kept[*piece];
        let segments = parts.segments();
        let count = parts.points.len();
        let mut constraints = segments.clone();
        for [a, b] in (0..count).filter(kept).map(|piece| segments[piece]) {
            constraints.extend([[a, count + a], [count + a, count + b], [count + b, b]]);
        }
        let tree = Tree::new(&parts.points);
        let nearest = |p: DVec2| tree.nearest(&parts.points, p, 1).first().map_or(0, |&(_, at)| at);
        let mut places = [&parts.points[..], &self.vertices].concat();
        let mut owners: Vec<u32> = (0..count as u32).chain(0..count as u32).collect();
        // The outer corners of pieces that are left out coincide with their samples.
        let mut is_used = vec![false; count];
        (0..count).filter(kept).for_each(|piece| segments[piece].iter().for_each(|&end| is_used[end] = true));
        (0..count).filter(|&at| !is_used[at]).for_each(|at| places[count + at] = places[at]);
        let low = parts.points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = parts.points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let lattice = Lattice::new(opacity, (low + high) / 2.0, spacing);
        let slack = DETOUR_SLACK * spacing;
        for p in lattice.border_nodes() {
            places.push(p);
            owners.push(nearest(p));
        }
        for p in lattice.inner_nodes().map(rounded).filter(|&p| !is_covered(p)) {
            let owner = nearest(p);
            if p.distance(parts.points[owner as usize]) >= CLEARANCE * spacing {
                places.push(p);
                owners.push(owner);
            }
        }
        let drawn = places.iter().copied().map(rounded).collect();
        let around = Triangulation::constrained_delaunay_hull(drawn, constraints);
        let pieces = self.triangles.iter().enumerate().filter(|(t, _)| is_kept[t / 2]);
        let skirt = Self { triangles: pieces.map(|(_, triangle)| *triangle).collect(), ..self.clone() };
        let mut fringe = Pieces {
            samples: outline.concat(),
            base: mesh.vertices.len() as u32,
            slack,
            parts,
            places,
            owners,
            skirt,
            ..Pieces::default()
        };
        let corners = |triangle: [u32; 3]| triangle.map(|v| around.vertices[v as usize]);
        let is_covered: Vec<bool> =
            around.triangles.iter().map(|&t| is_covered(corners(t).iter().sum::<DVec2>() / 3.0)).collect();
        let is_free = |&t: &usize| !is_covered[t] && opacity.any_in_triangle(corners(around.triangles[t]));
        let free: Vec<usize> = (0..around.triangles.len()).filter(is_free).collect();
        for &t in &free {
            let is_border = around.neighbours[t].map(|beside| beside != NONE && is_covered[beside as usize]);
            fringe.note_uncut(around.triangles[t], is_border);
        }
        free.iter().for_each(|&t| fringe.add(around.triangles[t]));
        fringe.skirt
    }
}

/// The position at which the rasteriser draws a corner.
fn rounded(p: DVec2) -> DVec2 {
    (p / CORNER_STEP).round() * CORNER_STEP
}
