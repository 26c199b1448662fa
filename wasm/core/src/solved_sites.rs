//! The solved sites of a domain or a point cloud: how they move, and their cells. Shared by `solution` and `cloud`.

use crate::{
    deform::Pose,
    error::Error,
    pose::{HarmonicFields, Poser},
    project::Project,
    site::{Site, SiteGraph},
    triangulation::NONE,
};

/// Sites with their cell graph, harmonic fields and poser.
#[derive(Debug, Clone)]
pub(crate) struct SolvedSites {
    pub(crate) sites: Vec<Site>,
    pub(crate) graph: SiteGraph,
    pub(crate) harmonic: HarmonicFields,
    pub(crate) poser: Poser,
    /// For each sample, its nearest site; [`NONE`] on an island without sites.
    pub(crate) nearest: Vec<u32>,
}

impl SolvedSites {
    /// The nearest site of a sample; `None` on an island without sites.
    ///
    /// # Panics
    /// If `sample` is out of bounds.
    pub(crate) fn nearest_site(&self, sample: usize) -> Option<usize> {
        let site = self.nearest[sample];
        (site != NONE).then_some(site as usize)
    }

    /// The pose of a project's handles, in its shape.
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub(crate) fn pose(&self, project: &Project) -> Result<Pose, Error> {
        self.poser.pose_from(&project.shape, &project.handles, project.pose.blend)
    }

    /// # Errors
    /// [`Error::PoseOfAnotherSolution`] if the pose comes from another solution's poser.
    pub(crate) fn check_pose(&self, pose: &Pose) -> Result<(), Error> {
        if self.poser.has_made(pose) { Ok(()) } else { Err(Error::PoseOfAnotherSolution) }
    }

    /// # Panics
    /// If the pose comes from another solution's poser.
    pub(crate) fn expect_own(&self, pose: &Pose) {
        assert!(self.poser.has_made(pose), "{}", Error::PoseOfAnotherSolution);
    }
}
