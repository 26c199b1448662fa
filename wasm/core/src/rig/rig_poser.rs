//! Poses the handles of a rig with the solver.

use glam::DVec2;

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
    weight::SparseWeights,
};

/// Poses the handles of a rig that needs a solver: in the rigid mode, or with automatic rotations.
///
/// Cost: some 4 milliseconds for a frame of a drag with 150 sites, and 10 to 20 times as much without a frame before.
#[derive(Debug, Clone)]
pub struct RigPoser {
    poser: Poser,
    posing: Posing,
}

impl RigPoser {
    pub(super) fn new(posing: Posing) -> Self {
        Self { poser: posing.poser(), posing }
    }

    /// Reads the unpacked section `POSR` of a rig: see `web/docs/rig-format.md`. Its handles are numbered from 0. The
    /// rigid mode also needs [the mesh](Self::set_mesh).
    ///
    /// # Errors
    /// A [`RigError`] for a section of a later format, or a damaged section.
    pub fn from_section(section: &[u8]) -> Result<Self, RigError> {
        let mut from = Reader::new(RigPart::Posing, section);
        let posing = Posing::read(&mut from, None, None)?.ok_or_else(|| from.wrong("have an unknown format"))?;
        from.end()?;
        Ok(Self::new(posing))
    }

    /// Adds the mesh of the rig: vertices at rest in pixels, triangles, and vertices × sites. The rigid mode then sees
    /// folds of single triangles, as the project's own poser does.
    ///
    /// # Errors
    /// A [`RigError`] for numbers of vertices or sites that the rig lacks, and for numbers that are not finite.
    pub fn set_mesh(
        &mut self,
        vertices: &[DVec2],
        triangles: &[[u32; 3]],
        weights: &SparseWeights,
    ) -> Result<(), RigError> {
        let is_whole = weights.len() == vertices.len()
            && triangles.iter().flatten().all(|&vertex| (vertex as usize) < vertices.len())
            && weights.sites().iter().all(|&site| (site as usize) < self.poser.sites());
        let is_finite = vertices.iter().all(|vertex| vertex.is_finite())
            && weights.weights().iter().all(|weight| weight.is_finite());
        let wrong = |reason| Err(RigError::Part { part: RigPart::Mesh, reason });
        if !is_whole {
            return wrong("refers to an unknown vertex or site");
        }
        if !is_finite {
            return wrong("contains a number that is not finite");
        }
        self.poser.set_mesh(vertices, &self.posing.between(triangles), weights);
        Ok(())
    }

    /// The handles, posed as in the project.
    #[must_use]
    pub fn handles(&self) -> &[Handle] {
        &self.posing.sources.handles
    }

    /// The motions of all sites with the handles posed, one pose for each in their order: see [`Poser::pose`].
    ///
    /// # Errors
    /// [`Error::PoseMismatch`] for a wrong number of handles or corners, and the errors of [`Poser::pose`].
    pub fn motions(&self, poses: &[HandlePose]) -> Result<Vec<Motion>, Error> {
        self.poser.motions(&self.posed(poses)?)
    }

    /// The motions of the next frame of a drag, from those of the frame before: see [`Poser::follow`].
    ///
    /// # Errors
    /// Those of [`motions`](Self::motions), and [`Error::PoseOfAnotherSolution`].
    pub fn followed(&self, before: &[Motion], poses: &[HandlePose]) -> Result<Vec<Motion>, Error> {
        self.check_own(before)?;
        self.poser.followed(before, &self.posed(poses)?)
    }

    /// The motions in which a drag comes to rest, from those of its last frame: see [`Poser::settle`].
    ///
    /// # Errors
    /// Those of [`followed`](Self::followed).
    pub fn settled(&self, before: &[Motion], poses: &[HandlePose]) -> Result<Vec<Motion>, Error> {
        self.check_own(before)?;
        self.poser.settled(before, &self.posed(poses)?)
    }

    fn check_own(&self, motions: &[Motion]) -> Result<(), Error> {
        let is_own = motions.len() == self.poser.sites() && motions.iter().all(Motion::is_in_bounds);
        if is_own { Ok(()) } else { Err(Error::PoseOfAnotherSolution) }
    }

    fn posed(&self, poses: &[HandlePose]) -> Result<Vec<Handle>, Error> {
        let mut handles = self.handles().to_vec();
        let mismatch = Error::PoseMismatch { expected: handles.len(), found: poses.len() };
        let fits =
            handles.len() == poses.len() && handles.iter_mut().zip(poses).all(|(handle, pose)| pose.write_to(handle));
        if fits { Ok(handles) } else { Err(mismatch) }
    }
}
