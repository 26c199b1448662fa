//! The pictures that a drawing reads: the picture of its mesh, and a static one behind it.

use glam::DVec2;

use super::facet::{Facet, mesh_facets};
use super::options::Filter;
use super::texture::{MipLevel, Texture, mip_levels};
use crate::picture::Picture;

/// A picture behind a mesh.
#[derive(Debug)]
pub(super) struct Behind {
    rgba: Vec<u8>,
    mip_levels: Vec<MipLevel>,
    /// Number of its facets, which are the first of the drawing.
    pub(super) facets: u32,
}

impl Behind {
    /// The pixels of a picture of the same size as another one, and the facets that draw it completely.
    pub(super) fn new(beside: &Picture<'_>, rgba: Vec<u8>, filter: Filter, scale: f64) -> (Self, Vec<Facet>) {
        let size = DVec2::new(beside.width().into(), beside.height().into());
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| corner * size);
        let facets = mesh_facets(&corners, &corners, &[[0, 1, 2], [0, 2, 3]], scale);
        let mut behind = Self { rgba, mip_levels: Vec::new(), facets: facets.len() as u32 };
        behind.mip_levels = mip_levels(behind.picture(beside), filter, &facets);
        (behind, facets)
    }

    fn picture<'a>(&'a self, beside: &Picture<'_>) -> Picture<'a> {
        Picture::new(beside.width(), beside.height(), &self.rgba).expect("a fill has the size of its picture")
    }
}

/// The texture of each facet.
pub(super) struct Textures<'a> {
    front: Texture<'a>,
    behind: Option<(u32, Texture<'a>)>,
}

impl<'a> Textures<'a> {
    pub(super) fn new(front: Texture<'a>, behind: Option<&'a Behind>, picture: &Picture<'_>, filter: Filter) -> Self {
        let texture = |behind: &'a Behind| Texture::new(behind.picture(picture), filter, &behind.mip_levels);
        Self { front, behind: behind.map(|behind| (behind.facets, texture(behind))) }
    }

    /// The texture of a facet by its index.
    pub(super) fn of(&self, facet: u32) -> &Texture<'a> {
        match &self.behind {
            Some((facets, texture)) if facet < *facets => texture,
            _ => &self.front,
        }
    }
}
