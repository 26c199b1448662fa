//! Options for resampling a picture through a warp.

use super::extent::Extent;

/// How a warped picture is resampled. The defaults keep the picture's size and rectangle, and use smooth filtering.
///
/// ```
/// use c2warp::{Canvas, Filter, ResampleOptions};
///
/// let sprite = ResampleOptions { scale: 4.0, filter: Filter::Nearest, ..ResampleOptions::default() };
/// assert_eq!(sprite.canvas, Canvas::Picture);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResampleOptions {
    /// Pixels of the result per pixel of the picture.
    pub scale: f64,
    /// The rectangle of the result.
    pub canvas: Canvas,
    /// The reconstruction filter.
    pub filter: Filter,
    /// Whether parts cast a thin dark edge on the parts that they cross: see
    /// [`Project::edges`](crate::project::Project::edges). [`Filter::Nearest`] draws no edges, and neither does
    /// [`raster::warp`](crate::raster::warp), which has no information about parts.
    pub edges: bool,
}

/// The rectangle that a warped picture occupies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Canvas {
    /// The picture's own rectangle. Parts bent beyond it are cut off.
    #[default]
    Picture,
    /// The picture's own rectangle, grown on every side to contain everything that is drawn.
    Grown,
    /// The smallest rectangle that contains everything that is drawn: its border rows and columns are not empty.
    Covered,
    /// A given rectangle, such as one for all frames of a film. Parts beyond it are cut off.
    Fixed(Extent),
}

/// How colours between pixels are reconstructed, and whether edges are smooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Filter {
    /// A cubic, widened where the picture shrinks. Edges are antialiased.
    #[default]
    Cubic,
    /// The nearest pixel, for pixel art. Each pixel of the result is one pixel of the picture, or empty.
    ///
    /// No colours are mixed: a translucent pixel replaces the pixel below it.
    Nearest,
}

impl Default for ResampleOptions {
    fn default() -> Self {
        Self { scale: 1.0, canvas: Canvas::default(), filter: Filter::default(), edges: false }
    }
}
