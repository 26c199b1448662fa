//! The fill that a solver has, makes, or is asked for.

use std::sync::Arc;

use crate::{
    domain::{Domain, Mask},
    error::Error,
    fill::{Fill, Filler},
    fill_key::FillKey,
    picture::Picture,
    project::{DomainSpec, Project},
    solve_input::check_picture,
    solver::{FinishedSolve, Solver},
};

/// The last fill that was asked for. It stays while none is wanted, so that switching it off and on costs nothing.
#[derive(Debug, Default)]
pub(crate) struct KeptFill {
    key: Option<FillKey>,
    wanted: bool,
    state: State,
}

#[derive(Debug, Default)]
enum State {
    #[default]
    Asked,
    Running(Box<Filler>),
    Done(Arc<Fill>),
}

impl KeptFill {
    /// Asks for a fill. The same one as before goes on.
    pub(crate) fn ask(&mut self, key: Option<FillKey>) {
        self.wanted = key.is_some();
        if self.wanted && self.key != key {
            (self.key, self.state) = (key, State::Asked);
        }
    }

    /// Runs the next step. Returns the part that is done; `None` if there is nothing to do.
    fn advance(&mut self, picture: &Picture<'_>) -> Result<Option<f64>, Error> {
        let Some(key) = self.key.as_ref().filter(|_| self.wanted) else { return Ok(None) };
        check_picture(key.picture, picture)?;
        match &mut self.state {
            State::Asked => {
                let domain = Domain::new(Some(&key.domain), picture)?;
                let filler = Filler::new(picture, Mask::new(domain.rings(), key.picture), &key.spec)?;
                self.state = State::Running(Box::new(filler));
                Ok(Some(0.0))
            }
            State::Running(filler) => {
                let fill = filler.advance(picture);
                let progress = filler.progress();
                if let Some(fill) = fill {
                    self.state = State::Done(Arc::new(fill));
                }
                Ok(Some(progress))
            }
            State::Done(_) => Ok(None),
        }
    }

    /// The fill behind a domain in a picture of a size, if it is done.
    fn finished_for(&self, domain: &DomainSpec, picture: (u32, u32)) -> Option<Arc<Fill>> {
        let rings = domain.clone().feathered(0.0);
        let is_behind = self.key.as_ref().is_some_and(|key| key.domain == rings && key.picture == picture);
        match &self.state {
            State::Done(fill) if is_behind => Some(Arc::clone(fill)),
            _ => None,
        }
    }
}

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
            finished.show(&self.fill);
        }
        Ok(progress)
    }
}

impl FinishedSolve {
    /// The same solve with the fill behind its domain, or none if there is none yet.
    pub(crate) fn with_fill(mut self, kept: &KeptFill) -> Self {
        self.show(kept);
        self
    }

    fn show(&mut self, kept: &KeptFill) {
        let fill = self.key.filled().and_then(|(domain, picture)| kept.finished_for(domain, picture));
        if self.solution.fill != fill {
            Arc::make_mut(&mut self.solution).fill = fill;
        }
    }
}
