//! How large a rig may be.

use c2warp::project::Project;

use crate::{error::ExportError, format::Format};

/// The most bones besides the root: engines such as Bevy count the bones of a skin in 8 bits.
pub const MOST_BONES: usize = 255;
/// The most bones that a vertex may have.
pub(crate) const MOST_INFLUENCES: usize = 32;
/// The fewest vertices that make a triangle.
pub(crate) const LEAST_VERTICES: usize = 3;
/// The most vertices: formats and engines count them in 16 bits.
pub(crate) const MOST_VERTICES: usize = 65_535;

/// How large a rig may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// The most bones besides the root.
    pub bones: usize,
    /// The most bones that move a vertex.
    pub influences: usize,
    /// The most vertices.
    pub vertices: usize,
}

impl Default for Options {
    /// 64 bones lose at most 0.75 px at 99 of 100 vertices of the samples, in random poses.
    fn default() -> Self {
        Self { bones: 64, influences: 4, vertices: 300 }
    }
}

impl Options {
    /// Checks the numbers for a format.
    ///
    /// # Errors
    /// [`ExportError::Bones`], [`ExportError::Influences`], [`ExportError::InfluencesOfFormat`] or
    /// [`ExportError::Vertices`].
    pub fn check(&self, format: Format) -> Result<(), ExportError> {
        let Self { bones, influences, vertices } = *self;
        if !(1..=MOST_BONES).contains(&bones) {
            return Err(ExportError::Bones { found: bones });
        }
        if !(1..=MOST_INFLUENCES).contains(&influences) {
            return Err(ExportError::Influences { found: influences });
        }
        if let Some(most) = format.most_influences().filter(|&most| influences > most) {
            return Err(ExportError::InfluencesOfFormat { format: format.name(), most, found: influences });
        }
        if !(LEAST_VERTICES..=MOST_VERTICES).contains(&vertices) {
            return Err(ExportError::Vertices { found: vertices });
        }
        Ok(())
    }

    /// Checks that each handle of a project can have a bone of its own.
    ///
    /// # Errors
    /// [`ExportError::Handles`] or [`ExportError::HandlesOfFormats`].
    pub fn check_handles(&self, project: &Project) -> Result<(), ExportError> {
        match project.handles.len() {
            found if found > MOST_BONES => Err(ExportError::HandlesOfFormats { found }),
            found if found > self.bones => Err(ExportError::Handles { found }),
            _ => Ok(()),
        }
    }
}
