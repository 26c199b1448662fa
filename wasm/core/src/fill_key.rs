//! The key of a fill.

use crate::project::{DomainSpec, FillSpec, Project};

/// Everything that a fill depends on, except the pixels of the picture.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FillKey {
    /// The domain without its feather, which lies in front of the fill.
    pub(crate) domain: DomainSpec,
    pub(crate) picture: (u32, u32),
    pub(crate) spec: FillSpec,
}

impl FillKey {
    /// `None` for a project without a fill, or without a background behind its domain.
    pub(crate) fn of(project: &Project) -> Option<Self> {
        let domain = project.domain.as_ref().filter(|domain| matches!(domain, DomainSpec::Polygon { .. }))?;
        Some(Self { domain: domain.clone().feathered(0.0), picture: project.image.size(), spec: project.fill? })
    }
}
