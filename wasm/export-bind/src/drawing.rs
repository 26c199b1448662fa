//! A drawing with bent paths: the file of `c2warp warp -o bent.svg`.

use c2warp_vector::{BentOptions, Drawing};
use js_sys::Error as JsError;
use wasm_bindgen::prelude::*;

use crate::solved::{SolvedProject, refused};

/// A bent drawing.
#[wasm_bindgen]
#[derive(Debug)]
pub struct BentDrawing {
    svg: String,
    remarks: Vec<String>,
}

#[wasm_bindgen]
impl BentDrawing {
    /// The SVG file.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn svg(&self) -> String {
        self.svg.clone()
    }

    /// Descriptions of parts that are left out or do not bend.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        self.remarks.clone()
    }
}

#[wasm_bindgen]
impl SolvedProject {
    /// Bends a drawing over the whole picture, in the project's pose, or at a time of a named clip. `grow`: the frame
    /// of the drawing grows to contain everything that is bent beyond it.
    ///
    /// # Errors
    /// For an unknown clip, and for a drawing that cannot be read.
    pub fn bent(&self, svg: &str, grow: bool, clip: Option<String>, seconds: f64) -> Result<BentDrawing, JsError> {
        let drawing = Drawing::read(svg).map_err(refused)?;
        let pose = self.pose(clip, seconds)?;
        let options = BentOptions { grow, ..BentOptions::default() };
        let bent = drawing.bent(&self.solution.continued(&pose), self.size.into(), options).map_err(refused)?;
        Ok(BentDrawing { svg: bent.svg, remarks: drawing.remarks().iter().map(ToString::to_string).collect() })
    }
}
