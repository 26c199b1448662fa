//! Opened triangles of the coarse mesh, recursively subdivided into four parts as far as searches need.
//!
//! Each piece lists every site that may be the nearest somewhere in it, for all cells. Inserting a site updates the
//! pieces. So a subdivision for one cell is reused for its neighbours and in later rounds. With thousands of sites
//! among a thousand coarse samples, the cost per site hardly increases.
//!
//! Cost of an insertion: a visit of every opened triangle, and the update of the pieces that the new cell may enter.

use super::{
    super::voronoi::Voronoi,
    corner_paths::CornerPaths,
    piece::{PARTS, Piece, steps_of_update},
};
use crate::{
    distance::DistanceField,
    limits::{MAX_PIECE_BYTES, MAX_STEPS},
    triangulation::NONE,
};

/// Opened triangles of the coarse mesh, and their parts.
#[derive(Default)]
pub(super) struct Pieces {
    pieces: Vec<Piece>,
    /// For each triangle, the index of its piece; [`NONE`] if it is not opened.
    roots: Vec<u32>,
    /// The opened triangles.
    opened: Vec<u32>,
    /// Number of paths in all pieces.
    paths: usize,
    /// Number of path queries so far.
    steps: u64,
}

impl Pieces {
    pub(super) fn new(triangles: usize) -> Self {
        Self { roots: vec![NONE; triangles], ..Self::default() }
    }

    /// Whether the pieces have reached the limit of memory or steps. They are then not subdivided further.
    pub(super) fn are_full(&self) -> bool {
        self.paths > MAX_PIECE_BYTES / size_of::<CornerPaths>() || self.steps > MAX_STEPS
    }

    /// Number of path queries so far.
    pub(super) fn steps(&self) -> u64 {
        self.steps
    }

    /// Counts further path queries.
    pub(super) fn count(&mut self, steps: u64) {
        self.steps += steps;
    }

    pub(super) fn piece(&self, at: u32) -> &Piece {
        &self.pieces[at as usize]
    }

    /// The piece of a triangle, if it is opened.
    pub(super) fn of_triangle(&self, triangle: u32) -> Option<&Piece> {
        let root = self.roots[triangle as usize];
        (root != NONE).then(|| self.piece(root))
    }

    /// The index of a triangle's piece. Opens the triangle if necessary.
    pub(super) fn open(&mut self, voronoi: &Voronoi, triangle: u32) -> u32 {
        if self.roots[triangle as usize] == NONE {
            self.roots[triangle as usize] = self.pieces.len() as u32;
            self.opened.push(triangle);
            let piece = Piece::of_triangle(voronoi, triangle);
            self.paths += piece.paths.len();
            self.steps += voronoi.sites.len() as u64 + piece.steps;
            self.pieces.push(piece);
        }
        self.roots[triangle as usize]
    }

    /// The indices of a piece's parts. Subdivides it if necessary. Empty if the parts would be too small to matter, or
    /// if the pieces [are full](Self::are_full).
    pub(super) fn subdivide(&mut self, voronoi: &Voronoi, at: u32) -> std::ops::Range<u32> {
        let is_full = self.are_full();
        let piece = self.piece(at);
        let first = match piece.parts {
            Some(first) => first,
            None => {
                if is_full {
                    return 0..0;
                }
                let Some(parts) = piece.divided(voronoi) else { return 0..0 };
                self.steps += parts.iter().map(|part| part.steps).sum::<u64>();
                let (first, piece) = (self.pieces.len() as u32, &mut self.pieces[at as usize]);
                self.paths += parts.iter().map(|part| part.paths.len()).sum::<usize>();
                self.paths -= piece.paths.len();
                piece.sites.retain(|&site| parts.iter().any(|part| part.has(site as usize)));
                (piece.parts, piece.paths) = (Some(first), Vec::new());
                self.pieces.extend(parts);
                first
            }
        };
        first..first + PARTS.len() as u32
    }

    /// Inserts the last site. Its cell has points only in triangles whose corners it visited.
    pub(super) fn insert(&mut self, voronoi: &Voronoi) {
        let Some((site, field)) = (0..).zip(&voronoi.fields).last() else { return };
        for at in 0..self.opened.len() {
            let triangle = self.opened[at] as usize;
            if voronoi.cells.visited_all(voronoi.coarse.mesh.triangles[triangle]) {
                let root = self.roots[triangle];
                let paths = self.piece(root).corner_paths(&field.distances);
                self.insert_into(root, site, &field.distances, paths);
            }
        }
    }

    /// Inserts a site into a piece and its parts. Returns whether it may be the nearest somewhere there.
    fn insert_into(&mut self, at: u32, site: u32, field: &DistanceField, paths: CornerPaths) -> bool {
        let piece = &mut self.pieces[at as usize];
        let Some(first) = piece.parts else {
            let before = piece.paths.len();
            self.steps += steps_of_update(before);
            let is_entered = piece.insert(site, paths);
            self.paths = self.paths + piece.paths.len() - before;
            return is_entered;
        };
        if !paths.may_enter(&piece.nearest, &piece.detours) {
            return false;
        }
        piece.nearest = paths.nearer(&piece.nearest);
        let middles = self.piece(first + PARTS.len() as u32 - 1).corner_paths(field);
        let of_part = |part| CornerPaths::of_part(&paths, &middles, part);
        let parts = (first..).zip(PARTS);
        let entered = parts.filter(|&(at, part)| self.insert_into(at, site, field, of_part(part))).count();
        if entered > 0 {
            self.pieces[at as usize].sites.push(site);
        }
        entered > 0
    }
}
