//! A warped picture for JavaScript, drawn in bands of rows.

use std::ops::Range;

use c2warp::Picture;
use wasm_bindgen::prelude::*;

/// The rectangle of a drawing.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy)]
pub enum Canvas {
    /// The picture's own rectangle.
    Picture,
    /// The picture's own rectangle, grown to contain everything that is drawn.
    Grown,
    /// The smallest rectangle that contains everything that is drawn.
    Covered,
}

impl From<Canvas> for c2warp::Canvas {
    fn from(canvas: Canvas) -> Self {
        match canvas {
            Canvas::Picture => Self::Picture,
            Canvas::Grown => Self::Grown,
            Canvas::Covered => Self::Covered,
        }
    }
}

/// A warped picture, ready to be drawn. Bands of rows start at multiples of `bandRows`.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Drawing(c2warp::Drawing);

#[wasm_bindgen]
impl Drawing {
    /// Width in pixels.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.0.width()
    }

    /// Height in pixels.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.0.height()
    }

    /// Position of the picture's upper left corner in the drawing, in pixels: x, y.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn origin(&self) -> Vec<i32> {
        self.0.extent().origin.to_vec()
    }

    /// Bands start at multiples of this number of rows.
    #[must_use]
    #[wasm_bindgen(getter, js_name = bandRows)]
    pub fn band_rows(&self) -> u32 {
        c2warp::Drawing::BAND_ROWS
    }
}

impl Drawing {
    /// Draws rows of the result; `None` if they do not start a band or do not exist.
    pub(crate) fn rows(&self, picture: &Picture<'_>, rows: Range<u32>) -> Option<Vec<u8>> {
        let exist = rows.start.is_multiple_of(c2warp::Drawing::BAND_ROWS)
            && rows.start <= rows.end
            && rows.end <= self.0.height();
        exist.then(|| self.0.rows(picture, rows))
    }
}

impl From<c2warp::Drawing> for Drawing {
    fn from(drawing: c2warp::Drawing) -> Self {
        Self(drawing)
    }
}
