//! Solves a project for exports. Exports do not need the fill of the background, so it is not computed.

use c2warp::{Error, Picture, Solution, Solver, project::Project};

/// The solution of a project.
///
/// # Errors
/// The errors of [`Solver::begin`] and [`Solver::advance`].
pub(crate) fn solution(project: &Project, picture: &Picture<'_>) -> Result<Solution, Error> {
    let mut solver = Solver::new();
    solver.begin(project, picture)?;
    while solver.advance()?.is_some() {}
    Ok(solver.into_solution().expect("every stage has run"))
}
