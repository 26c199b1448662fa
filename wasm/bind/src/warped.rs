//! A warped picture for JavaScript.

use wasm_bindgen::prelude::*;

/// Straight RGBA, rows from top to bottom.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Warped {
    /// Width in pixels.
    #[wasm_bindgen(readonly)]
    pub width: u32,
    /// Height in pixels.
    #[wasm_bindgen(readonly)]
    pub height: u32,
    rgba: Vec<u8>,
}

#[wasm_bindgen]
impl Warped {
    /// Its bytes; it is freed.
    #[must_use]
    #[wasm_bindgen(js_name = intoBytes)]
    pub fn into_bytes(self) -> Vec<u8> {
        self.rgba
    }
}

impl From<c2warp::Warped> for Warped {
    fn from(c2warp::Warped { width, height, rgba, .. }: c2warp::Warped) -> Self {
        Self { width, height, rgba }
    }
}
