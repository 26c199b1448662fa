//! The displacement of the picture at rest, applied before it is posed: p + d(p).
//!
//! Cost: sixteen control points for each point.

use glam::{DMat2, DVec2};

use crate::project::{Displacement, Project, Spline};

/// A displacement over a picture of a given size in pixels. It is not 0 everywhere.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct DisplacementField {
    size: DVec2,
    width: u32,
    height: u32,
    values: Vec<i16>,
}

impl DisplacementField {
    /// The displacement of a project; `None` if nothing is displaced.
    pub(crate) fn of(project: &Project) -> Option<Self> {
        Self::new(project.displacement.as_ref()?, picture_size(project))
    }

    /// `None` if nothing is displaced.
    pub(crate) fn new(displacement: &Displacement, size: DVec2) -> Option<Self> {
        let &Displacement { width, height, ref values, .. } = displacement;
        (!displacement.is_zero()).then(|| Self { size, width, height, values: values.clone() })
    }

    /// Whether data read from bytes is consistent.
    pub(super) fn is_whole(&self) -> bool {
        let Self { size, width, height, values } = self;
        let is_checked = || Displacement::new(*width, *height, values.clone()).check().is_ok();
        size.is_finite() && size.min_element() > 0.0 && is_checked()
    }

    /// The displaced position.
    pub(crate) fn place(&self, p: DVec2) -> DVec2 {
        p + self.spline().at(p)
    }

    /// The displaced position and its Jacobian, I + ∇d.
    pub(crate) fn place_with_slopes(&self, p: DVec2) -> (DVec2, DMat2) {
        let (by, slopes) = self.spline().with_slopes(p);
        (p + by, DMat2::IDENTITY + slopes)
    }

    fn spline(&self) -> Spline<'_> {
        Spline { size: self.size, sides: [self.width, self.height], values: &self.values }
    }
}

/// The size of a project's picture, in pixels.
pub(crate) fn picture_size(project: &Project) -> DVec2 {
    let (width, height) = project.image.size();
    DVec2::new(width.into(), height.into())
}
