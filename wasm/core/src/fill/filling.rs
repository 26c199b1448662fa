//! The fill that a solver has, makes, or is asked for.

use std::sync::Arc;

use super::{Fill, Filler, Mask};
use crate::{
    domain::Domain,
    error::Error,
    picture::Picture,
    prepared_domain::DomainKey,
    project::{DomainSpec, FillSpec, Project},
    solve_input::check_picture,
};

/// Everything that a fill depends on, except the pixels of the picture.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FillKey {
    domain: DomainSpec,
    picture: (u32, u32),
    spec: FillSpec,
}

impl FillKey {
    /// `None` for a project without a fill, or with nothing behind its domain.
    pub(crate) fn of(project: &Project) -> Option<Self> {
        let domain = project.domain.as_ref().filter(|domain| matches!(domain, DomainSpec::Polygon { .. }))?;
        Some(Self { domain: domain.clone(), picture: project.image.size(), spec: project.fill? })
    }
}

/// The last fill that was asked for. It stays while none is wanted, so that switching it off and on costs nothing.
#[derive(Debug, Default)]
pub(crate) struct Filling {
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

impl Filling {
    /// Asks for a fill. The same one as before goes on.
    pub(crate) fn ask(&mut self, key: Option<FillKey>) {
        self.wanted = key.is_some();
        if self.wanted && self.key != key {
            (self.key, self.state) = (key, State::Asked);
        }
    }

    /// Runs the next step. Returns the part that is done; `None` if there is nothing to do.
    pub(crate) fn advance(&mut self, picture: &Picture<'_>) -> Result<Option<f64>, Error> {
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

    /// The fill, if it is done and behind this domain.
    pub(crate) fn finished_for(&self, domain: &DomainKey) -> Option<Arc<Fill>> {
        let key = self.key.as_ref()?;
        match &self.state {
            State::Done(fill) if domain.is_of(&key.domain, key.picture) => Some(Arc::clone(fill)),
            _ => None,
        }
    }
}
