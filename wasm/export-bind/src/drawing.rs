//! A drawing with bent paths: the file of `c2warp warp -o bent.svg`.

use c2warp_vector::{BentOptions, PlainDrawing};
use js_sys::Error as JsError;
use wasm_bindgen::prelude::*;

use crate::solved::{SolvedProject, refused};

#[wasm_bindgen]
impl SolvedProject {
    /// Bends a drawing over the whole of the picture, by the project's pose or by its clip with a name at a time in
    /// seconds. The drawing is plain SVG, as its reader writes it, of this width and height. `grow`: the frame of the
    /// drawing holds all that is bent beyond it.
    ///
    /// # Errors
    /// For an unknown clip, and for a drawing with too many nodes.
    pub fn bent(
        &self,
        plain: String,
        width: f64,
        height: f64,
        grow: bool,
        clip: Option<String>,
        seconds: f64,
    ) -> Result<String, JsError> {
        let drawing = PlainDrawing::new(plain, [width, height]);
        let pose = self.pose(clip, seconds)?;
        let options = BentOptions { grow, ..BentOptions::default() };
        let bent = drawing.bent(&self.solution.continued(&pose), self.size.into(), options).map_err(refused)?;
        Ok(bent.svg)
    }
}
