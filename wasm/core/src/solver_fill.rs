//! The fill behind the domain of a solver's project, in steps beside the solve.

use std::sync::Arc;

use crate::{error::Error, fill_key::FillKey, picture::Picture, project::Project, solver::Solver};

/// The fill of the picture behind the domain.
impl Solver {
    /// Asks for the fill of a project, and drops one that another domain or seed had. [`begin`](Self::begin) does so
    /// as well.
    pub fn begin_fill(&mut self, project: &Project) {
        self.fill.ask(FillKey::of(project));
    }

    /// Runs the next step of the fill behind the last project's domain. Returns the part that is done, from 0 to 1;
    /// `None` if nothing is left to do, or the project has no fill. Solutions of the project then draw it.
    ///
    /// A fill depends on the picture, the domain and the seed alone. It goes on where it was while other handles are
    /// solved.
    ///
    /// # Errors
    /// - [`Error::PictureMismatch`];
    /// - [`Error::NothingToFillFrom`];
    /// - those of [`Domain::new`](crate::domain::Domain::new).
    pub fn advance_fill(&mut self, picture: &Picture<'_>) -> Result<Option<f64>, Error> {
        let progress = self.fill.advance(picture)?;
        if progress.is_none()
            && let Some(finished) = &mut self.finished
        {
            let fill = self.fill.behind(&finished.key);
            if finished.solution.fill != fill {
                Arc::make_mut(&mut finished.solution).fill = fill;
            }
        }
        Ok(progress)
    }
}
