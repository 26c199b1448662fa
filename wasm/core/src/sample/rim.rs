//! A narrow skirt around an alpha outline, so that the soft edge of the picture is drawn with it.
//!
//! The outline runs where alpha passes the threshold; the pixels that fade out beyond it belong to the picture too. Each
//! outline sample gets a twin outside that moves with the sample's weights. Twins stay clear of the middle of a gap, so
//! that no part draws the fringe of another.

use glam::DVec2;

use crate::{segment::segment_distance, triangulation::Triangulation};

/// How far the rim reaches out, in pixels: an antialiased edge fades within one, a softly drawn one within three.
const WIDTH: f64 = 3.0;
/// Greatest length of a corner's twin over the width.
const MITRE: f64 = 2.0;

/// The skirt: twins of outline samples, and the triangles between.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rim {
    /// Places of the twins.
    pub vertices: Vec<DVec2>,
    /// The outline sample that each twin belongs to.
    pub owners: Vec<u32>,
    /// Triangles; vertex numbers from the mesh's count on are twins.
    pub triangles: Vec<[u32; 3]>,
}

impl Rim {
    /// The rim of a mesh whose `outline` is given as rings of its vertices, kept within a picture of `size`.
    pub(crate) fn new(mesh: &Triangulation, outline: &[Vec<u32>], size: DVec2) -> Self {
        let pieces = Pieces::new(mesh, outline);
        let mut rim = Self::default();
        for ring in outline {
            let n = ring.len();
            let base = (mesh.vertices.len() + rim.vertices.len()) as u32;
            for i in 0..n {
                let around = [ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]];
                let [prev, at, next] = around.map(|v| mesh.vertices[v as usize]);
                let out = mitre(prev, at, next);
                let reach = (pieces.gap(at, around, out) / 2.0).min(WIDTH);
                rim.vertices.push((at + out * reach).clamp(DVec2::ZERO, size));
                rim.owners.push(ring[i]);
            }
            for i in 0..n {
                let j = (i + 1) % n;
                let (a, b) = (base + i as u32, base + j as u32);
                rim.triangles.extend([[ring[i], a, b], [ring[i], b, ring[j]]]);
            }
        }
        rim
    }

    /// The same rim of a mesh that has more vertices by now, none of them on the outline.
    pub(crate) fn renumbered(&self, before: usize, now: usize) -> Self {
        let number = |v: u32| if (v as usize) < before { v } else { v + (now - before) as u32 };
        Self { triangles: self.triangles.iter().map(|t| t.map(number)).collect(), ..self.clone() }
    }
}

/// Outward from a corner of the outline, as long as makes both neighbouring edges move out by one.
fn mitre(prev: DVec2, at: DVec2, next: DVec2) -> DVec2 {
    // The domain lies on the side of `perp`.
    let out = |a: DVec2, b: DVec2| -(b - a).normalize().perp();
    let (before, after) = (out(prev, at), out(at, next));
    let middle = (before + after).try_normalize().unwrap_or(before);
    middle * (1.0 / middle.dot(after)).clamp(1.0, MITRE)
}

/// Pieces of the outline in square cells as wide as twins may look for a gap.
struct Pieces<'a> {
    mesh: &'a Triangulation,
    /// Row and column of each cell that a piece touches, ascending, with the piece.
    cells: Vec<([i32; 2], [u32; 2])>,
}

const CELL: f64 = 2.0 * MITRE * WIDTH;

impl<'a> Pieces<'a> {
    fn new(mesh: &'a Triangulation, outline: &[Vec<u32>]) -> Self {
        let mut cells = Vec::new();
        for ring in outline {
            for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let (p, q) = (mesh.vertices[a as usize], mesh.vertices[b as usize]);
                let (low, high) = (p.min(q) / CELL, p.max(q) / CELL);
                for y in low.y.floor() as i32..=high.y.floor() as i32 {
                    for x in low.x.floor() as i32..=high.x.floor() as i32 {
                        cells.push(([y, x], [a, b]));
                    }
                }
            }
        }
        cells.sort_unstable();
        Self { mesh, cells }
    }

    /// Distance from a sample to the nearest piece of the outline that lies outward of it.
    fn gap(&self, at: DVec2, [prev, own, next]: [u32; 3], out: DVec2) -> f64 {
        let cell = (at / CELL).floor();
        let (x, y) = (cell.x as i32, cell.y as i32);
        let before = |cell: [i32; 2]| self.cells.partition_point(|&(known, _)| known < cell);
        let rows = (y - 1..=y + 1).map(|y| &self.cells[before([y, x - 1])..before([y, x + 2])]);
        let gaps = rows.flatten().filter_map(|&(_, [a, b])| {
            let beside = [a, b].iter().any(|v| [prev, own, next].contains(v));
            let [p, q] = [a, b].map(|v| self.mesh.vertices[v as usize]);
            let outward = (p - at).dot(out) > 0.0 || (q - at).dot(out) > 0.0;
            (!beside && outward).then(|| segment_distance(at, p, q))
        });
        gaps.fold(f64::INFINITY, f64::min)
    }
}
