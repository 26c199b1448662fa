//! Facets that fade out: the soft rim of a mesh.
//!
//! A facet has a level at each corner: 1 and more is opaque, 0 and less is transparent. Where a rim has not moved, it
//! would show the picture over itself. It is left out there, so that translucent pixels do not become more opaque.
//! `web/src/render/picture.frag.glsl` draws the same.

use std::ops::Range;

use glam::{DMat2, DVec2};

use super::MeshLayer;
use super::facet::Facet;

/// A rim that has moved less than this is left out, in pixels of the picture.
const STILL_PX: f64 = 1.0 / 256.0;
/// A rim that has moved this far is drawn in full.
const MOVED_PX: f64 = 1.0 / 16.0;

/// The facets of a drawing that fade out.
#[derive(Debug, Default)]
pub(super) struct Fades {
    first: u32,
    fades: Vec<Fade>,
    /// Pixels of the picture per pixel of the result.
    step: f64,
}

impl Fades {
    /// The facets of a mesh whose vertices have levels. In the drawing, they start at number `first`.
    pub(super) fn new(layer: &MeshLayer<'_>, levels: &[f64], scale: f64, first: usize) -> (Self, Vec<Facet>) {
        let faded = |triangle: &[u32; 3]| {
            let corners = triangle.map(|vertex| vertex as usize);
            let posed = corners.map(|i| layer.posed[i] * scale);
            let facet = Facet::new(corners.map(|i| layer.rest[i]), posed)?;
            Some((Fade::new(posed, corners.map(|i| levels[i])), facet))
        };
        let (fades, facets) = layer.triangles.iter().filter_map(faded).unzip();
        (Self { first: first as u32, fades, step: 1.0 / scale }, facets)
    }

    /// Numbers of the facets that fade out.
    pub(super) fn facets(&self) -> Range<u32> {
        self.first..self.first + self.fades.len() as u32
    }

    /// The fading of a facet, if it fades.
    pub(super) fn of(&self, facet: u32) -> Option<(&Fade, f64)> {
        let fade = self.fades.get(facet.checked_sub(self.first)? as usize)?;
        Some((fade, self.step))
    }
}

/// The levels of a facet: linear between its corners.
#[derive(Debug)]
pub(super) struct Fade {
    gradient: DVec2,
    origin: f64,
    range: [f64; 2],
}

impl Fade {
    fn new([a, b, c]: [DVec2; 3], [own, second, third]: [f64; 3]) -> Self {
        let edges = DMat2::from_cols(b - a, c - a).transpose();
        let gradient = edges.inverse() * DVec2::new(second - own, third - own);
        Self {
            gradient,
            origin: own - gradient.dot(a),
            range: [own.min(second).min(third), own.max(second).max(third)].map(|level| level.clamp(0.0, 1.0)),
        }
    }

    /// The opacity at `p`, relative to the picture's rectangle, where the picture at rest is `moved` pixels away.
    pub(super) fn opacity(&self, p: DVec2, moved: DVec2) -> f32 {
        // The centre of a pixel can lie outside the triangle.
        let level = (self.gradient.dot(p) + self.origin).clamp(self.range[0], self.range[1]);
        let shown = ((moved.length() - STILL_PX) / (MOVED_PX - STILL_PX)).clamp(0.0, 1.0);
        (level * level * (3.0 - 2.0 * level) * shown) as f32
    }
}
