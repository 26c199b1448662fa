//! How a warped picture is drawn.

use super::canvas::Canvas;

/// How a warped picture is drawn: by default as large as the picture, within its rectangle, smooth.
///
/// ```
/// use c2warp::{Canvas, Drawing, Filter};
///
/// let sprite = Drawing { scale: 4.0, filter: Filter::Nearest, ..Drawing::default() };
/// assert_eq!(sprite.canvas, Canvas::Picture);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drawing {
    /// Pixels of the result for a pixel of the picture.
    pub scale: f64,
    /// How much of it is shown.
    pub canvas: Canvas,
    /// How the picture is read.
    pub filter: Filter,
}

/// How a picture is read between its pixels, and how its edges are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Filter {
    /// By a cubic, as wide as a pixel of the result is in the picture; edges are smooth.
    #[default]
    Cubic,
    /// A pixel of the result is that pixel of the picture which its centre shows, or none: no colour is mixed, as pixel art asks for.
    /// What is translucent takes the place of what it lies over.
    Nearest,
}

impl Default for Drawing {
    fn default() -> Self {
        Self { scale: 1.0, canvas: Canvas::default(), filter: Filter::default() }
    }
}
