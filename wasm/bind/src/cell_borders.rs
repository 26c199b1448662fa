//! The borders between cells as typed arrays.

use c2warp::BorderPiece;
use wasm_bindgen::prelude::*;

/// Straight pieces of borders, each within one triangle of the solution's mesh. Every getter copies.
#[wasm_bindgen]
#[derive(Debug)]
pub struct CellBorders {
    corners: Vec<u32>,
    barycentric: Vec<f32>,
}

#[wasm_bindgen]
impl CellBorders {
    /// Pieces × 3 vertices of the mesh.
    #[wasm_bindgen(getter)]
    pub fn corners(&self) -> Vec<u32> {
        self.corners.clone()
    }

    /// Pieces × 2 ends × 3 barycentric coordinates.
    #[wasm_bindgen(getter)]
    pub fn barycentric(&self) -> Vec<f32> {
        self.barycentric.clone()
    }
}

impl From<Vec<BorderPiece>> for CellBorders {
    fn from(pieces: Vec<BorderPiece>) -> Self {
        let ends = pieces.iter().flat_map(|piece| piece.ends).flatten();
        Self {
            corners: pieces.iter().flat_map(|piece| piece.corners).collect(),
            barycentric: ends.map(|coordinate| coordinate as f32).collect(),
        }
    }
}
