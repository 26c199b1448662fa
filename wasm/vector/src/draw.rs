//! The pixels of a drawing, by resvg.

use resvg::tiny_skia::{Pixmap, PremultipliedColorU8, Transform};

use crate::{drawing::Drawing, error::VectorError};

impl Drawing {
    /// Draws this at a size in pixels: straight RGBA, rows from top to bottom.
    ///
    /// # Errors
    /// Those of [`cost`](Self::cost), before a pixel is drawn.
    pub fn pixels(&self, width: u32, height: u32) -> Result<Vec<u8>, VectorError> {
        self.cost(width, height)?;
        let [own_width, own_height] = self.size();
        let scale = [f64::from(width) / own_width, f64::from(height) / own_height].map(|scale| scale as f32);
        let mut canvas = Pixmap::new(width, height).ok_or(VectorError::TooMuchMemory { cause: "svg" })?;
        resvg::render(&self.tree, Transform::from_scale(scale[0], scale[1]), &mut canvas.as_mut());
        let straight = canvas.pixels().iter().map(PremultipliedColorU8::demultiply);
        Ok(straight.flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()]).collect())
    }
}
