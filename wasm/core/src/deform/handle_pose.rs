//! The pose of one handle, without its name and its rest position.

use glam::DVec2;

use crate::project::{Handle, Rotation};

/// The pose of a handle: the part of a [`Handle`] that changes during a drag.
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

/// Number of values of a handle before its corners.
const HEAD: usize = 4;

impl HandlePose {
    /// Reads poses from a flat array, the format used to pass them to other languages. `None` if the array ends within
    /// a handle.
    ///
    /// Each handle consists of its number n of corners (1 for a point), rotation, scale, depth, and n × 2 coordinates.
    /// The rotation is in degrees, or NaN if automatic.
    #[must_use]
    pub fn from_numbers(mut numbers: &[f64]) -> Option<Vec<Self>> {
        let mut poses = Vec::new();
        while let Some((&[corners, rotation, scale, depth], rest)) = numbers.split_first_chunk::<HEAD>() {
            let (coordinates, rest) = rest.split_at_checked(2_usize.saturating_mul(corners as usize))?;
            let posed = coordinates.as_chunks::<2>().0.iter().copied().map(DVec2::from_array).collect();
            let rotation = if rotation.is_nan() { Rotation::Auto } else { Rotation::Degrees(rotation) };
            poses.push(Self { posed, rotation, scale, depth });
            numbers = rest;
        }
        numbers.is_empty().then_some(poses)
    }

    /// Whether the handle is a bar or polygon.
    pub(super) fn is_line(&self) -> bool {
        self.posed.len() > 1
    }

    /// Writes the pose into a handle. Returns `false`, and changes nothing, if the numbers of corners differ.
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
