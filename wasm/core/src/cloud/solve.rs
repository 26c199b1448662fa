//! Solves a project in one call on a point cloud.

use super::{CloudSolution, PointCloud};
use crate::{
    error::Error,
    project::{Continuity, Project},
    solve_input::SolveInput,
};

/// Solves a project in one call on a point cloud, by the paper's approximations: see [`cloud`](crate::cloud).
///
/// The project's picture, domain and number of samples are ignored.
///
/// # Errors
/// - The errors of [`Solver::begin`](crate::Solver::begin) and [`Solver::advance`](crate::Solver::advance) that concern
///   handles and settings.
/// - [`Error::Unsupported`] for bars, polygons, a fixed boundary, stiffness and displacements.
pub fn solve_cloud(project: &Project, cloud: &PointCloud) -> Result<CloudSolution, Error> {
    let input = SolveInput::new(project)?;
    input.check_points_only()?;
    let handles = input.points_inside(|p| cloud.contains(p))?;
    CloudSolution::new(cloud, &handles, &input)
}

impl SolveInput {
    /// Rejects bars, polygons, a fixed boundary, stiffness and displacements, because point clouds do not support them.
    ///
    /// # Errors
    /// [`Error::Unsupported`].
    fn check_points_only(&self) -> Result<(), Error> {
        if let Some(polyline) = self.polylines.first() {
            let path = format!("handles[{}].kind", polyline.handle);
            return Err(unsupported(path, "a bar or polygon on a point cloud"));
        }
        if self.fix_boundary {
            return Err(unsupported("fix_boundary".into(), "a fixed boundary of a point cloud"));
        }
        if self.weighting.continuity != Continuity::Exact {
            let feature = "a point cloud with two continuous derivatives";
            return Err(unsupported("weighting.continuity".into(), feature));
        }
        if !self.stiffness.is_soft() {
            return Err(unsupported("stiffness".into(), "a stiff area of a point cloud"));
        }
        if self.displacement.is_some() {
            return Err(unsupported("displacement".into(), "a displacement of a point cloud"));
        }
        Ok(())
    }
}

fn unsupported(path: String, feature: &str) -> Error {
    Error::Unsupported { path, feature: feature.into() }
}
