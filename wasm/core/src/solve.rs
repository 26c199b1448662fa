//! Solves a project in one call: on a picture, a domain, a mesh or a point cloud.

use std::sync::Arc;

use glam::DVec2;

use crate::{
    distance::{Navigation, Propagation},
    domain::Domain,
    error::Error,
    input_mesh::InputMesh,
    picture::Picture,
    pipeline,
    prepared_domain::PreparedDomain,
    project::Project,
    sample::SamplingCache,
    solution::Solution,
    solve_input::{SolveInput, check_picture},
    solver::Solver,
};

/// Solves a project in one call.
///
/// # Errors
/// The errors of [`Solver::begin`] and [`Solver::advance`].
pub fn solve(project: &Project, picture: &Picture<'_>) -> Result<Solution, Error> {
    let mut solver = Solver::new();
    solver.begin(project, picture)?;
    while solver.advance()?.is_some() {}
    #[cfg(feature = "raster")]
    while solver.advance_fill(picture)?.is_some() {}
    Ok(solver.into_solution().expect("every stage has run"))
}

/// Solves a project in one call in a domain from the caller, without a picture.
///
/// The project's picture and domain are ignored. The solution can draw any picture that the caller places over the
/// domain.
///
/// ```
/// use c2warp::{domain::Domain, glam::DVec2, project::{Handle, Project}, solve_domain};
///
/// let ring = [(-1.0, -1.0), (3.0, -1.0), (3.0, 1.0), (1.0, 1.0), (1.0, 3.0), (-1.0, 3.0)];
/// let domain = Domain::from_rings(&[ring.map(|corner| 100.0 * DVec2::from(corner)).to_vec()])?;
/// // Of any size, as the picture is ignored.
/// let mut project = Project::for_picture(1, 1);
/// project.handles = vec![Handle::point("right", [200.0, 0.0]), Handle::point("down", [0.0, 200.0])];
/// let solution = solve_domain(&project, &domain)?;
/// // The sites that move a point, with weights and their gradients.
/// let influences = solution.influences_at([50.0, 50.0].into()).unwrap();
/// let (sum, slope) = influences.iter().fold((0.0, DVec2::ZERO), |(w, g), one| (w + one.weight, g + one.gradient));
/// assert!((sum - 1.0).abs() < 1e-12 && slope.length() < 1e-12);
/// # Ok::<(), c2warp::Error>(())
/// ```
///
/// # Errors
/// The errors of [`Solver::begin`] and [`Solver::advance`] that concern handles and settings.
pub fn solve_domain(project: &Project, domain: &Domain) -> Result<Solution, Error> {
    let (input, prepared) = (SolveInput::new(project)?, Arc::new(PreparedDomain::without_picture(domain.clone())));
    let located = input.locate(&prepared)?;
    let (mut sampling, mut propagation) = (SamplingCache::default(), Propagation::default());
    let (samples, coarse) = pipeline::sample(&mut sampling, &prepared, &located, &input);
    let partition = pipeline::partition(&mut propagation, &prepared, &coarse, &located, &input)?;
    pipeline::compute_weights(&mut propagation, prepared, &input, located, samples, partition)
}

/// Solves a project in one call on a mesh from the caller. Its vertices are the samples, and the only vertices of the
/// solution's mesh, in the caller's order. Handles need not lie on vertices.
///
/// The project's picture and domain are ignored. Its number of samples is the upper limit of the coarse samples, over
/// which cells are stored.
///
/// # Errors
/// The errors of [`Solver::begin`] and [`Solver::advance`] that concern handles and settings.
pub fn solve_mesh(project: &Project, mesh: &InputMesh) -> Result<Solution, Error> {
    let (input, prepared) = (SolveInput::new(project)?, Arc::clone(&mesh.prepared));
    let located = input.locate(&prepared)?;
    let coarse = pipeline::sample_coarsely(&prepared, &located, &input);
    let mut propagation = Propagation::default();
    let partition = pipeline::partition(&mut propagation, &prepared, &coarse, &located, &input)?;
    pipeline::compute_weights(&mut propagation, prepared, &input, located, mesh.samples(), partition)
}

/// Intrinsic distances in a project's domain from one point to others, in pixels; `None` if no path connects them.
///
/// Handles are ignored. Without a picture, or for several sources, use [`Navigation`].
///
/// # Errors
/// - [`Error::PictureMismatch`].
/// - The errors of [`Domain::new`](crate::domain::Domain::new).
/// - [`Error::PointOutside`] if the first point lies outside the domain.
pub fn distances(
    project: &Project,
    picture: &Picture<'_>,
    from: DVec2,
    at: &[DVec2],
) -> Result<Vec<Option<f64>>, Error> {
    check_picture(project.image.size(), picture)?;
    let navigation = Navigation::new(&Domain::bounded(project.domain.as_ref(), picture, project.fix_boundary)?);
    let distances = navigation.distances_from(from)?;
    Ok(at.iter().map(|&p| distances.to(p)).collect())
}

#[cfg(test)]
mod tests {
    use crate::{
        Error, InputMesh, Picture, Report, Solution, Solver, Warped, cloud, deform, distance, domain, pose, project,
        weight,
    };

    #[test]
    fn public_types_cross_threads() {
        fn check<T: Send + Sync + std::fmt::Debug>() {}
        fn check_clone<T: Clone>() {}
        check::<(Error, InputMesh, Picture<'_>, Solution, Solver, Warped, Report)>();
        check::<(cloud::PointCloud, cloud::CloudSolution, domain::Domain, project::Project)>();
        check::<(distance::Navigation, distance::Distances<'_>, pose::Poser, deform::Pose, weight::SparseWeights)>();
        check_clone::<(Solution, cloud::CloudSolution, distance::Navigation, distance::Distances<'_>, deform::Pose)>();
    }
}
