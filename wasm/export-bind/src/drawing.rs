//! A drawing with bent paths, the file of `c2warp warp -o bent.svg`, and a drawing as pixels.

use c2warp_vector::{BentOptions, Drawing, Remark};
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
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

/// A drawing as pixels.
#[wasm_bindgen]
#[derive(Debug)]
pub struct DrawnPicture {
    png: Option<Vec<u8>>,
    lacks_texts: bool,
}

#[wasm_bindgen]
impl DrawnPicture {
    /// The PNG file. `None` if a browser draws the drawing quickly.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn png(&self) -> Option<Vec<u8>> {
        self.png.clone()
    }

    /// Whether text of the drawing is missing from the PNG file.
    #[wasm_bindgen(getter, js_name = lacksTexts)]
    #[must_use]
    pub fn lacks_texts(&self) -> bool {
        self.lacks_texts
    }
}

/// Draws a drawing at a size in pixels, unless a browser draws it quickly.
///
/// # Errors
/// For a drawing that cannot be read, or takes too long to draw.
#[wasm_bindgen(js_name = drawnPicture)]
pub fn drawn_picture(svg: &str, width: u32, height: u32) -> Result<DrawnPicture, JsError> {
    let drawing = Drawing::read(svg).map_err(refused)?;
    if drawing.cost(width, height).map_err(refused)?.is_light() {
        return Ok(DrawnPicture { png: None, lacks_texts: false });
    }
    let rgba = drawing.pixels(width, height).map_err(refused)?;
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(&rgba, width, height, ExtendedColorType::Rgba8).map_err(refused)?;
    let lacks_texts = drawing.remarks().iter().any(|remark| matches!(remark, Remark::Text(_) | Remark::More));
    Ok(DrawnPicture { png: Some(png), lacks_texts })
}
