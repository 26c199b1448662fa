//! The fill behind the domain of a solver's project, computed in steps independently of the solve.

use std::sync::Arc;

use crate::{error::Error, fill_key::FillKey, picture::Picture, project::Project, solver::Solver};

/// The fill of the picture behind the domain.
impl Solver {
    /// Requests the fill of a project, and drops the fill of another domain or seed. [`begin`](Self::begin) does so as
    /// well.
    pub fn begin_fill(&mut self, project: &Project) {
        self.fill.ask(FillKey::of(project));
    }

    /// Runs the next step of the fill behind the last project's domain. Returns the completed fraction, from 0 to 1;
    /// `None` if the fill is finished, or the project has no fill. Solutions of the project then draw the fill.
    ///
    /// A fill depends only on the picture, the domain and the seed. It continues while other handles are solved.
    ///
    /// # Errors
    /// - [`Error::PictureMismatch`];
    /// - [`Error::NothingToFillFrom`];
    /// - the errors of [`Domain::new`](crate::domain::Domain::new).
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
