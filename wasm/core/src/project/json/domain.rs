//! The domain and its fill as JSON.

use std::ops::RangeInclusive;

use glam::DVec2;

use super::cursor::Cursor;
use crate::project::{DomainSpec, FillMethod, FillSpec, ProjectError};

const SEEDS: RangeInclusive<u32> = 0..=u32::MAX;

impl DomainSpec {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        #[derive(Clone, Copy)]
        enum Kind {
            Image,
            Alpha,
            Polygon,
        }
        let domain = value.object()?;
        let kind = domain.required("kind")?.one_of(&[
            ("image", Kind::Image),
            ("alpha", Kind::Alpha),
            ("polygon", Kind::Polygon),
        ])?;
        match kind {
            Kind::Image => {
                domain.allow_only(&["kind"])?;
                Ok(Self::Image)
            }
            Kind::Alpha => {
                domain.allow_only(&["kind", "threshold"])?;
                Ok(Self::Alpha { threshold: domain.value_or("threshold", Self::THRESHOLD, |value| value.number())? })
            }
            Kind::Polygon => {
                domain.allow_only(&["kind", "rings", "feather"])?;
                Ok(Self::Polygon {
                    rings: domain.required("rings").and_then(rings)?,
                    feather: domain.value_or("feather", 0.0, |value| value.number())?,
                })
            }
        }
    }
}

impl FillSpec {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let fill = value.object()?;
        fill.allow_only(&["method", "seed"])?;
        let method = |value: Cursor<'_>| value.one_of(&[("patches", FillMethod::Patches)]);
        Ok(Self {
            method: fill.value_or("method", FillMethod::default(), method)?,
            seed: fill.value_or("seed", 0, |value| value.whole_number(&SEEDS))?,
        })
    }
}

fn rings(value: Cursor<'_>) -> Result<Vec<Vec<DVec2>>, ProjectError> {
    value.list("a list of rings", |ring| ring.points())
}
