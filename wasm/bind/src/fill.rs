//! The filled picture behind a mesh as typed arrays.

use wasm_bindgen::prelude::*;

/// A box of the picture whose hole is filled. Its getter of pixels copies: call it once, then free the fill.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Fill(c2warp::fill::Fill);

#[wasm_bindgen]
impl Fill {
    /// The box in the picture, in pixels: left, top, width and height.
    #[must_use]
    #[wasm_bindgen(getter, js_name = "box")]
    pub fn place(&self) -> Vec<u32> {
        let [left, top] = self.0.origin();
        vec![left, top, self.0.width(), self.0.height()]
    }

    /// Its pixels: straight RGBA.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn rgba(&self) -> Vec<u8> {
        self.0.rgba().to_vec()
    }
}

impl From<&c2warp::fill::Fill> for Fill {
    fn from(fill: &c2warp::fill::Fill) -> Self {
        Self(fill.clone())
    }
}
