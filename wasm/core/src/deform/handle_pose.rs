//! The pose of one handle, without its name and its rest place.

use glam::DVec2;

use crate::project::{Handle, Rotation};

/// Where a handle is posed: the part of a [`Handle`] that changes during a drag.
#[derive(Debug, Clone, PartialEq)]
pub struct HandlePose {
    /// The posed corners in image pixels: one for a point, more for a bar or polygon.
    pub posed: Vec<DVec2>,
    /// The rotation.
    pub rotation: Rotation,
    /// The scale.
    pub scale: f64,
    /// The depth.
    pub depth: f64,
}

impl HandlePose {
    /// Whether the handle is a bar or polygon.
    pub(super) fn is_line(&self) -> bool {
        self.posed.len() > 1
    }

    /// Writes the pose into a handle. Returns `false`, and changes nothing, if the handle has another number of
    /// corners.
    pub(crate) fn write_to(&self, handle: &mut Handle) -> bool {
        let posed = handle.shape.posed_mut();
        let fits = posed.len() == self.posed.len();
        if fits {
            posed.copy_from_slice(&self.posed);
            (handle.rotation, handle.scale, handle.depth) = (self.rotation, self.scale, self.depth);
        }
        fits
    }
}

impl From<&Handle> for HandlePose {
    fn from(handle: &Handle) -> Self {
        Self {
            posed: handle.shape.posed().to_vec(),
            rotation: handle.rotation,
            scale: handle.scale,
            depth: handle.depth,
        }
    }
}
