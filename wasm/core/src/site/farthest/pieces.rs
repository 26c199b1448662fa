//! The opened triangles of the coarse samples' mesh, subdivided in four and in four again where a search needs it.
//!
//! Each piece lists every site that may be the nearest somewhere in it, for all cells alike, and is updated when sites are
//! inserted. So a subdivision made for one cell serves its neighbours and the next round: thousands of sites among a thousand
//! coarse samples cost hardly more each than a few do.

use super::{
    super::{Regions, Site},
    corner_paths::CornerPaths,
    piece::{PARTS, Piece},
};
use crate::{distance::DistanceField, triangulation::NONE};

/// The opened triangles of the coarse samples' mesh, and their parts.
#[derive(Default)]
pub(crate) struct Pieces {
    pieces: Vec<Piece>,
    /// The piece of each triangle; [`NONE`] where it is not opened.
    roots: Vec<u32>,
    /// The opened triangles.
    opened: Vec<u32>,
}

impl Pieces {
    pub(crate) fn new(triangles: usize) -> Self {
        Self { roots: vec![NONE; triangles], ..Self::default() }
    }

    pub(super) fn piece(&self, at: u32) -> &Piece {
        &self.pieces[at as usize]
    }

    /// The piece of a triangle, if opened.
    pub(super) fn known(&self, triangle: u32) -> Option<&Piece> {
        let root = self.roots[triangle as usize];
        (root != NONE).then(|| self.piece(root))
    }

    /// The index of a triangle's piece; opens the triangle if necessary.
    pub(super) fn root(&mut self, regions: &Regions, triangle: u32) -> u32 {
        if self.roots[triangle as usize] == NONE {
            self.roots[triangle as usize] = self.pieces.len() as u32;
            self.opened.push(triangle);
            self.pieces.push(Piece::of_coarse(regions, triangle));
        }
        self.roots[triangle as usize]
    }

    /// The indices of a piece's parts; subdivides it if necessary. Empty where they would be too small to matter.
    pub(super) fn parts(&mut self, regions: &Regions, at: u32) -> std::ops::Range<u32> {
        let piece = self.piece(at);
        let first = match piece.parts {
            Some(first) => first,
            None => {
                let Some(parts) = piece.divided(regions) else { return 0..0 };
                let (first, piece) = (self.pieces.len() as u32, &mut self.pieces[at as usize]);
                piece.sites.retain(|&site| parts.iter().any(|part| part.has(site as usize)));
                (piece.parts, piece.paths) = (Some(first), Vec::new());
                self.pieces.extend(parts);
                first
            }
        };
        first..first + PARTS.len() as u32
    }

    /// Inserts the last site. Its cell has points only in triangles whose coarse samples were visited for it.
    pub(crate) fn insert(&mut self, regions: &Regions) {
        let Some((site, Site { field, .. })) = (0..).zip(&regions.sites).last() else { return };
        for at in 0..self.opened.len() {
            let triangle = self.opened[at] as usize;
            if regions.cells.saw(regions.coarse.mesh.triangles[triangle]) {
                let root = self.roots[triangle];
                let paths = self.piece(root).path_ends(field);
                self.enter(root, site, field, paths);
            }
        }
    }

    /// Inserts a site into a piece and its parts. Returns whether it may be the nearest somewhere there.
    fn enter(&mut self, at: u32, site: u32, field: &DistanceField, paths: CornerPaths) -> bool {
        let piece = &mut self.pieces[at as usize];
        let Some(first) = piece.parts else { return piece.enter(site, paths) };
        if !paths.may_enter(&piece.nearest, piece.longest) {
            return false;
        }
        piece.nearest = paths.nearer(&piece.nearest);
        let middles = self.piece(first + PARTS.len() as u32 - 1).path_ends(field);
        let of_part = |part| CornerPaths::of_part(&paths, &middles, part);
        let entered = (first..).zip(PARTS).filter(|&(at, part)| self.enter(at, site, field, of_part(part))).count();
        if entered > 0 {
            self.pieces[at as usize].sites.push(site);
        }
        entered > 0
    }
}
