//! The outline that a solve is made in: a domain with the triangulation that distances are computed on.
//!
//! It does not depend on handles, so a solver keeps it from one solve to the next.

use glam::DVec2;

use crate::{
    distance::Navigation,
    domain::Domain,
    error::Error,
    picture::Picture,
    project::{DomainSpec, Project},
};

/// A domain with its triangulation.
#[derive(Debug)]
pub(crate) struct PreparedDomain {
    pub(crate) domain: Domain,
    pub(crate) navigation: Navigation,
    /// The picture's size, if there is a picture.
    pub(crate) picture: Option<(u32, u32)>,
    /// The same, if it fades out beyond the outline.
    pub(crate) fading: Option<DVec2>,
    /// The same, if it goes on beyond the outline, and stays there.
    pub(crate) surrounding: Option<DVec2>,
}

impl PreparedDomain {
    /// # Errors
    /// An error of [`Domain::new`].
    pub(crate) fn new(spec: Option<&DomainSpec>, picture: &Picture) -> Result<Self, Error> {
        let domain = Domain::new(spec, picture)?;
        let navigation = Navigation::new(&domain);
        let soft = match spec {
            Some(DomainSpec::Alpha { .. }) => true,
            Some(_) => false,
            None => picture.has_transparency(),
        };
        let drawn = matches!(spec, Some(DomainSpec::Polygon { .. }));
        let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
        let (fading, surrounding) = (soft.then_some(size), drawn.then_some(size));
        Ok(Self { domain, navigation, picture: Some(picture.size()), fading, surrounding })
    }

    /// The outline of a domain with nothing to draw beyond it.
    pub(crate) fn hard(domain: Domain) -> Self {
        let navigation = Navigation::new(&domain);
        Self { domain, navigation, picture: None, fading: None, surrounding: None }
    }
}

/// Everything an outline depends on besides the picture's pixels.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DomainKey {
    domain: Option<DomainSpec>,
    picture: (u32, u32),
}

impl DomainKey {
    pub(crate) fn of(project: &Project) -> Self {
        Self { domain: project.domain.clone(), picture: project.image.size() }
    }
}
