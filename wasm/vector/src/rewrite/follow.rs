//! How the parts of a drawing follow the warp.

use kurbo::Affine;

/// How an element follows the warp.
#[derive(Debug, Clone, Copy)]
pub(super) enum Follow {
    /// Not at all.
    Stay,
    /// By bending; with the map from the element's units to image pixels.
    Bend(Affine),
    /// By an affine map in the units of the element that is painted.
    Move(Affine),
}

impl Follow {
    /// For the children of an element with a transform.
    pub(super) fn within(self, transform: Affine) -> Self {
        if let Self::Bend(to_pixels) = self { Self::Bend(to_pixels * transform) } else { Self::Stay }
    }

    /// Bending where the units are not squeezed into a line.
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
