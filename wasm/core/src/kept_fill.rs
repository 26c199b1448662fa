//! The fill of a solver: finished, in progress, or requested.

use std::sync::Arc;

use crate::{
    domain::{Domain, Mask},
    error::Error,
    fill::{Fill, Filler},
    fill_key::FillKey,
    picture::Picture,
    prepared_domain::DomainKey,
    solve_input::check_picture,
};

/// The last requested fill. It is kept while the fill is off, so that turning it off and on costs nothing.
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
    /// Requests a fill. If the same fill is in progress, it continues.
    pub(crate) fn ask(&mut self, key: Option<FillKey>) {
        self.wanted = key.is_some();
        if self.wanted && self.key != key {
            (self.key, self.state) = (key, State::Asked);
        }
    }

    /// Runs the next step. Returns the completed fraction; `None` if there is nothing to do.
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

    /// The fill behind a domain, if it is finished.
    pub(crate) fn behind(&self, key: &DomainKey) -> Option<Arc<Fill>> {
        let (domain, picture) = key.filled()?;
        let rings = domain.clone().feathered(0.0);
        let is_behind = self.key.as_ref().is_some_and(|key| key.domain == rings && key.picture == picture);
        match &self.state {
            State::Done(fill) if is_behind => Some(Arc::clone(fill)),
            _ => None,
        }
    }
}
