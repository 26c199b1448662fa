//! A narrow skirt around an alpha outline, so that soft edges of the picture are drawn.
//!
//! The outline runs where alpha crosses the threshold. Pixels that fade out beyond it also belong to the picture. Each
//! outline sample gets an offset vertex outside, with the same weights. Offset vertices stay on their half of a gap, so
//! that no part draws the fringe of another.
//!
//! Cost: O(n log n) for n samples on the outline. Known limits: a softer edge ends at [`WIDTH`], and in a narrow gap
//! at the middle of the gap. A [fringe](super::fringe) draws the remaining visible content.

use std::ops::Range;

use glam::DVec2;

use crate::domain::corners_between;

/// Width of the skirt, in pixels. An antialiased edge fades within one pixel, a softly drawn edge within three.
pub(super) const WIDTH: f64 = 3.0;
/// Maximum distance of a corner's offset vertex, as a multiple of the width.
const MAX_MITRE: f64 = 2.0;

/// Vertices around the outline that move with its samples, and the triangles between both.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Skirt {
    /// Rest positions of these vertices.
    pub(crate) vertices: Vec<DVec2>,
    /// The outline sample that each of them moves with.
    pub(crate) owners: Vec<u32>,
    /// Triangles × 3 vertex indices, at least one of them of the skirt: those from the mesh's vertex count on.
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Skirt {
    /// The skirt of samples, clamped to a picture of `size`. `outline` lists the samples of each ring.
    pub(crate) fn new(samples: &[DVec2], outline: &[Vec<u32>], size: DVec2) -> Self {
        let mut segments = Segments::new(samples, outline);
        let mut skirt = Self::default();
        for ring in outline {
            let n = ring.len();
            let base = (samples.len() + skirt.vertices.len()) as u32;
            for around in corners_between(ring) {
                let [prev, at, next] = around.map(|v| samples[v as usize]);
                let out = mitre(prev, at, next);
                let reach = segments.free_radius(at, around, out.normalize()).min(WIDTH * out.length());
                skirt.vertices.push((at + out.normalize() * reach).clamp(DVec2::ZERO, size));
                skirt.owners.push(around[1]);
            }
            for i in 0..n {
                let j = (i + 1) % n;
                let (a, b) = (base + i as u32, base + j as u32);
                skirt.triangles.extend([[ring[i], a, b], [ring[i], b, ring[j]]]);
            }
        }
        skirt
    }

    /// The rest position of a sample or of a vertex of the skirt.
    pub(super) fn place(&self, samples: &[DVec2], vertex: u32) -> DVec2 {
        let vertex = vertex as usize;
        samples.get(vertex).copied().unwrap_or_else(|| self.vertices[vertex - samples.len()])
    }

    /// The same skirt after the number of samples has grown from `before` to `now`, without new samples on the outline.
    pub(crate) fn renumbered(&self, before: usize, now: usize) -> Self {
        let number = |v: u32| if (v as usize) < before { v } else { v + (now - before) as u32 };
        Self { triangles: self.triangles.iter().map(|t| t.map(number)).collect(), ..self.clone() }
    }
}

/// The offset of an outline corner that moves both its edges outwards by 1. Its length is at most [`MAX_MITRE`].
fn mitre(prev: DVec2, at: DVec2, next: DVec2) -> DVec2 {
    // The domain lies on the side of `perp`.
    let out = |a: DVec2, b: DVec2| -(b - a).normalize().perp();
    let (before, after) = (out(prev, at), out(at, next));
    let middle = (before + after).try_normalize().unwrap_or(before);
    middle * (1.0 / middle.dot(after)).clamp(1.0, MAX_MITRE)
}

/// Segments of the outline in a grid of square cells.
struct Segments<'a> {
    samples: &'a [DVec2],
    /// Row and column of each cell that the box of a segment touches, ascending, with the segment.
    cells: Vec<([i32; 2], [u32; 2])>,
    /// The last cell that was searched, with the ranges of cells around it. Samples along an outline share them.
    near: (Option<[i32; 2]>, [Range<usize>; 3]),
}

/// Side of a grid cell: the widest gap that matters.
const CELL_PX: f64 = 2.0 * MAX_MITRE * WIDTH;

impl<'a> Segments<'a> {
    fn new(samples: &'a [DVec2], outline: &[Vec<u32>]) -> Self {
        let mut cells = Vec::new();
        for ring in outline {
            for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let (p, q) = (samples[a as usize], samples[b as usize]);
                let (low, high) = (p.min(q) / CELL_PX, p.max(q) / CELL_PX);
                for y in low.y.floor() as i32..=high.y.floor() as i32 {
                    for x in low.x.floor() as i32..=high.x.floor() as i32 {
                        cells.push(([y, x], [a, b]));
                    }
                }
            }
        }
        cells.sort_unstable();
        Self { samples, cells, near: (None, Default::default()) }
    }

    /// Radius of the largest empty circle that touches the outline at a sample, on the side of the unit vector `out`.
    ///
    /// Its centre is at least as far from the rest of the outline as from this sample.
    fn free_radius(&mut self, at: DVec2, [prev, own, next]: [u32; 3], out: DVec2) -> f64 {
        let [x, y] = (at / CELL_PX).floor().to_array().map(|cell| cell as i32);
        if self.near.0 != Some([y, x]) {
            let before = |cell: [i32; 2]| self.cells.partition_point(|&(known, _)| known < cell);
            self.near = (Some([y, x]), [y - 1, y, y + 1].map(|y| before([y, x - 1])..before([y, x + 2])));
        }
        let rows = self.near.1.iter().map(|range| &self.cells[range.clone()]);
        let radii = rows.flatten().filter_map(|&(_, ends)| {
            let beside = ends.iter().any(|v| [prev, own, next].contains(v));
            (!beside).then(|| touching_radius(out, ends.map(|v| self.samples[v as usize] - at)))
        });
        radii.fold(f64::INFINITY, f64::min)
    }
}

/// Radius of the smallest circle through the origin that touches a segment, with its centre in the direction `out`.
///
/// It is infinite if no such circle touches the segment.
fn touching_radius(out: DVec2, ends @ [p, q]: [DVec2; 2]) -> f64 {
    // The circle lies ahead of the origin.
    if ends.iter().all(|end| end.dot(out) <= 0.0) {
        return f64::INFINITY;
    }
    let through = |p: DVec2| {
        let ahead = p.dot(out);
        if ahead > 0.0 { p.length_squared() / (2.0 * ahead) } else { f64::INFINITY }
    };
    let along = (q - p).normalize();
    // The normal that points from the origin to the segment's line.
    let normal = if along.perp_dot(p) < 0.0 { -along.perp() } else { along.perp() };
    let radius = p.dot(normal) / (1.0 + out.dot(normal));
    let touched = radius * (out + normal);
    // For a line behind the origin, rounding may leave any number.
    let is_ahead = (0.0..=CELL_PX).contains(&radius);
    let is_between = is_ahead && (touched - p).dot(along) > 0.0 && (touched - q).dot(along) < 0.0;
    if is_between { radius } else { ends.map(through).into_iter().fold(f64::INFINITY, f64::min) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn radius(out: (f64, f64), p: (f64, f64), q: (f64, f64)) -> f64 {
        touching_radius(DVec2::from(out), [p, q].map(DVec2::from))
    }

    #[test]
    fn circle_touches_a_segment_ahead_beside_or_at_its_end() {
        let up = (0.0, 1.0);
        assert_eq!(radius(up, (-5.0, 4.0), (5.0, 4.0)), 2.0);
        // The other side of a right angle, one pixel away.
        assert!((radius(up, (1.0, -3.0), (1.0, 3.0)) - 1.0).abs() < 1e-15);
        assert_eq!(radius(up, (3.0, 1.0), (3.0, 0.0)), 5.0);
    }

    #[test]
    fn segments_behind_or_on_the_tangent_are_not_touched() {
        let up = (0.0, 1.0);
        assert_eq!(radius(up, (-5.0, -4.0), (5.0, -4.0)), f64::INFINITY);
        let askew = DVec2::from((0.3, -0.7)).normalize();
        let behind = [-5.0, 5.0].map(|along| along * askew.perp() - 4.0 * askew);
        assert_eq!(touching_radius(askew, behind), f64::INFINITY);
        for rounding in [0.0, 1e-16, -1e-16] {
            assert!(radius(up, (0.2, rounding), (0.4, 0.0)) > 1e9, "{rounding}");
            assert!(radius(up, (0.4, 0.0), (0.2, rounding)) > 1e9, "{rounding}");
        }
    }
}
