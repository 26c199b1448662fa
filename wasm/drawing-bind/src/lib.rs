//! Drawings for JavaScript: a module of its own, which a page loads when somebody opens a drawing.
//!
//! It lives in a worker that ends with the drawing. So a cancel needs no pause in it.

use c2warp_vector::{Drawing, VectorError};
use js_sys::Error as JsError;
use wasm_bindgen::prelude::*;

/// A drawing that was read.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ReadDrawing {
    drawing: Drawing,
}

/// An error whose name is that of the reason. Its cause is the element or the number that the words name.
fn refused(reason: &VectorError) -> JsError {
    let name = match reason {
        VectorError::TooLarge { .. } => "TooLarge",
        VectorError::TooManyElements { .. } => "TooManyElements",
        VectorError::TooManyAttributes { .. } => "TooManyAttributes",
        VectorError::TooManyCopies => "TooManyCopies",
        VectorError::TooManyStyles => "TooManyStyles",
        VectorError::TooDeep { .. } => "TooDeep",
        VectorError::TooSlow { .. } => "TooSlow",
        VectorError::TooMuchMemory { .. } => "TooMuchMemory",
        VectorError::NoSize => "NoSize",
        _ => "Damaged",
    };
    let cause: JsValue = match reason {
        VectorError::TooManyElements { most } => (*most).into(),
        VectorError::TooManyAttributes { most } | VectorError::TooDeep { most } => (*most as u32).into(),
        VectorError::TooSlow { cause } | VectorError::TooMuchMemory { cause } => (*cause).into(),
        _ => JsValue::UNDEFINED,
    };
    let error = JsError::new(&reason.to_string());
    error.set_name(name);
    error.set_cause(&cause);
    error
}

#[wasm_bindgen]
impl ReadDrawing {
    /// Reads an SVG file. Its texts are left out.
    ///
    /// # Errors
    /// For files that are no drawings, and for drawings that are too large.
    #[wasm_bindgen(constructor)]
    pub fn new(svg: &str) -> Result<Self, JsError> {
        let drawing = Drawing::read(svg).map_err(|reason| refused(&reason))?;
        Ok(Self { drawing })
    }

    /// Whether a browser draws this at once at a size in pixels.
    ///
    /// # Errors
    /// For drawings that take too long to draw.
    #[wasm_bindgen(js_name = isLight)]
    pub fn is_light(&self, width: u32, height: u32) -> Result<bool, JsError> {
        let cost = self.drawing.cost(width, height).map_err(|reason| refused(&reason))?;
        Ok(cost.is_light())
    }

    /// Draws this at a size in pixels: straight RGBA, rows from top to bottom.
    ///
    /// # Errors
    /// For drawings that take too long to draw.
    pub fn pixels(&self, width: u32, height: u32) -> Result<Vec<u8>, JsError> {
        self.drawing.pixels(width, height).map_err(|reason| refused(&reason))
    }

    /// The drawing as SVG with shapes as paths.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn plain(&self) -> String {
        self.drawing.plain_svg().to_owned()
    }

    /// Its width and height in its own units.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn size(&self) -> Vec<f64> {
        self.drawing.size().into()
    }

    /// Whether it has texts, which are left out.
    #[wasm_bindgen(getter, js_name = hasTexts)]
    #[must_use]
    pub fn has_texts(&self) -> bool {
        self.drawing.has_texts()
    }

    /// Parts that are left out or do not bend, in words.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        self.drawing.remarks().iter().map(ToString::to_string).collect()
    }
}
