//! A domain with its navigation mesh. It does not depend on handles, so a solver keeps it for the next solve.

use glam::DVec2;

use crate::{
    distance::Navigation,
    domain::{Domain, Mask},
    error::Error,
    fill_key::FillKey,
    opacity::Opacity,
    picture::Picture,
    project::{DomainSpec, Project},
};

/// A domain, prepared for a solve.
#[derive(Debug)]
pub(crate) struct PreparedDomain {
    pub(crate) domain: Domain,
    pub(crate) navigation: Navigation,
    /// Width and height of the picture, or `None` without a picture.
    pub(crate) picture: Option<(u32, u32)>,
    /// The opacity of the picture, if it continues beyond the outline and needs a skirt. Over a filled background, only
    /// the opacity of filled pixels, which the skirt covers at rest.
    pub(crate) around: Option<Opacity>,
    /// Size of the picture, if it continues beyond the outline as a static background.
    pub(crate) background_size: Option<DVec2>,
    /// Width of the feather in pixels. 0 for a held boundary, because nothing moves beyond it.
    pub(crate) feather: f64,
}

impl PreparedDomain {
    /// Finds the domain of a project in a picture and triangulates it. If its boundary is held, it has fewer corners.
    ///
    /// # Errors
    /// The errors of [`Domain::new`].
    pub(crate) fn new(project: &Project, picture: &Picture) -> Result<Self, Error> {
        let spec = project.domain.as_ref();
        let domain = Domain::bounded(spec, picture, project.fix_boundary)?;
        let navigation = Navigation::new(&domain);
        let has_skirt = match spec {
            Some(DomainSpec::Alpha { .. }) => true,
            Some(_) => false,
            None => picture.has_transparency(),
        };
        let has_background = matches!(spec, Some(DomainSpec::Polygon { .. }));
        let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
        let around = if FillKey::of(project).is_some() {
            Some(Mask::new(domain.rings(), picture.size()).opacity(picture.size()))
        } else {
            has_skirt.then(|| Opacity::new(picture))
        };
        let background_size = has_background.then_some(size);
        let feather = match spec {
            Some(DomainSpec::Polygon { feather, .. }) if !project.fix_boundary => *feather,
            _ => 0.0,
        };
        Ok(Self { domain, navigation, picture: Some(picture.size()), around, background_size, feather })
    }

    /// A domain without a picture, with nothing drawn beyond its outline.
    pub(crate) fn without_picture(domain: Domain) -> Self {
        let navigation = Navigation::new(&domain);
        Self { domain, navigation, picture: None, around: None, background_size: None, feather: 0.0 }
    }
}

/// Everything that a prepared domain depends on, except the picture's pixels.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DomainKey {
    domain: Option<DomainSpec>,
    picture: (u32, u32),
    held: bool,
    filled: bool,
}

impl DomainKey {
    /// The domain with a fill behind it, and the size of its picture.
    pub(crate) fn filled(&self) -> Option<(&DomainSpec, (u32, u32))> {
        Some((self.domain.as_ref().filter(|_| self.filled)?, self.picture))
    }

    pub(crate) fn of(project: &Project) -> Self {
        Self {
            domain: project.domain.clone(),
            picture: project.image.size(),
            held: project.fix_boundary,
            filled: FillKey::of(project).is_some(),
        }
    }
}
