//! The borders between cells as typed arrays.

use c2warp::BorderPiece;
use wasm_bindgen::prelude::*;

/// Straight pieces of borders, each within one triangle of the solution's mesh. Every getter copies.
#[wasm_bindgen]
#[derive(Debug)]
pub struct CellBorders {
    corners: Vec<u32>,
    shares: Vec<f32>,
}

#[wasm_bindgen]
impl CellBorders {
    /// Pieces × 3 vertices of the mesh.
    #[wasm_bindgen(getter)]
    pub fn corners(&self) -> Vec<u32> {
        self.corners.clone()
    }

    /// Pieces × 2 ends × 3 shares of the vertices, which sum to 1.
    #[wasm_bindgen(getter)]
    pub fn shares(&self) -> Vec<f32> {
        self.shares.clone()
    }
}

impl From<Vec<BorderPiece>> for CellBorders {
    fn from(pieces: Vec<BorderPiece>) -> Self {
        let shares = pieces.iter().flat_map(|piece| piece.ends).flatten();
        Self {
            corners: pieces.iter().flat_map(|piece| piece.corners).collect(),
            shares: shares.map(|share| share as f32).collect(),
        }
    }
}
