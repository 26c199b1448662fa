//! How the picture behind a part that moves away is filled.

use std::ops::RangeInclusive;

use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::Cursor;
use super::error::ProjectError;

const SEEDS: RangeInclusive<u32> = 0..=u32::MAX;

/// How the picture behind a domain of rings is filled, where the part that bends moves away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[schemars(rename = "Fill", deny_unknown_fields)]
#[non_exhaustive]
pub struct FillSpec {
    /// Where the colours come from.
    #[schemars(default)]
    pub method: FillMethod,
    /// Chooses one of many results, each as good as another. The same seed always gives the same pixels.
    #[schemars(default)]
    pub seed: u32,
}

/// Where the colours of a fill come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum FillMethod {
    /// From patches of the picture around that look alike.
    #[default]
    Patches,
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
