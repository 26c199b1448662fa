//! How the parts of a drawing follow the warp.

use kurbo::Affine;

/// How an element follows the warp.
#[derive(Debug, Clone, Copy)]
pub(super) enum Follow {
    /// It does not follow.
    Stay,
    /// It bends; holds the map from the element's units to image pixels.
    Bend(Affine),
    /// It follows an affine map in the units of the painted element.
    Move(Affine),
}

impl Follow {
    /// For the children of an element with a transform.
    pub(super) fn within(self, transform: Affine) -> Self {
        if let Self::Bend(to_pixels) = self { Self::Bend(to_pixels * transform) } else { Self::Stay }
    }

    /// Bending, unless the units are degenerate.
    pub(super) fn to_pixels(self) -> Option<Affine> {
        match self {
            Self::Bend(to_pixels) => {
                let det = to_pixels.determinant();
                (det.is_finite() && det.abs() > 1e-12).then_some(to_pixels)
            }
            _ => None,
        }
    }
}
