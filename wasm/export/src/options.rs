//! Size limits of a rig.

use c2warp::project::Project;

use crate::{error::ExportError, format::Format};

/// Maximum number of bones besides the root: engines such as Bevy store bone numbers in 8 bits.
pub const MOST_BONES: usize = 255;
/// Maximum number of bones per vertex.
pub(crate) const MOST_INFLUENCES: usize = 32;
/// Minimum number of vertices, for one triangle.
pub(crate) const LEAST_VERTICES: usize = 3;
/// Maximum number of vertices: formats and engines store vertex numbers in 16 bits.
pub(crate) const MOST_VERTICES: usize = 65_535;

/// Size limits of a rig.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Maximum number of bones besides the root.
    pub bones: usize,
    /// Maximum number of bones that move a vertex.
    pub influences: usize,
    /// Maximum number of vertices.
    pub vertices: usize,
}

impl Default for Options {
    /// With 64 bones, 99 % of the vertices of the samples are at most 0.75 px off in random poses.
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
