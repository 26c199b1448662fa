//! Poses the handles of a rig with the solver.

use super::{
    bytes::Reader,
    error::{RigError, RigPart},
    posing::Posing,
};
use crate::{
    deform::HandlePose,
    error::Error,
    pose::{Motion, Poser},
    project::Handle,
};

/// Poses the handles of a rig that needs a solver: in the rigid mode, or with automatic rotations.
///
/// Cost: the first pose factorises matrices, about 50 milliseconds for 150 sites. Later poses take one to four
/// milliseconds.
#[derive(Debug, Clone)]
pub struct RigPoser {
    poser: Poser,
    handles: Vec<Handle>,
}

impl RigPoser {
    pub(super) fn new(posing: &Posing) -> Self {
        Self { poser: posing.poser(), handles: posing.sources.handles.clone() }
    }

    /// Reads the unpacked section `POSR` of a rig: see `web/docs/rig-format.md`. Its handles are numbered from 0.
    ///
    /// # Errors
    /// A [`RigError`] for a section of a later format, or a damaged section.
    pub fn from_section(section: &[u8]) -> Result<Self, RigError> {
        let mut from = Reader::new(RigPart::Posing, section);
        let posing = Posing::read(&mut from, None, None)?.ok_or_else(|| from.wrong("have an unknown format"))?;
        from.end()?;
        Ok(Self::new(&posing))
    }

    /// The handles, posed as in the project.
    #[must_use]
    pub fn handles(&self) -> &[Handle] {
        &self.handles
    }

    /// The motions of all sites with the handles posed, one pose for each in their order.
    ///
    /// # Errors
    /// [`Error::PoseMismatch`] for a wrong number of handles or corners, and the errors of [`Poser::pose`].
    pub fn motions(&self, poses: &[HandlePose]) -> Result<Vec<Motion>, Error> {
        let mismatch = Error::PoseMismatch { expected: self.handles.len(), found: poses.len() };
        let mut handles = self.handles.clone();
        let fits =
            handles.len() == poses.len() && handles.iter_mut().zip(poses).all(|(handle, pose)| pose.write_to(handle));
        if !fits {
            return Err(mismatch);
        }
        self.poser.motions(&handles)
    }
}
