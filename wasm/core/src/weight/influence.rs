//! The influence of one site at a point (eq. 2).

use glam::DVec2;

/// A site's weight at a point, and the gradient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Influence {
    /// The site's index.
    pub site: usize,
    /// w_i at the point.
    pub weight: f64,
    /// ∇w_i, per pixel.
    pub gradient: DVec2,
}
