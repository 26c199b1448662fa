//! The settings of weights, poses and loose parts as JSON.

use super::cursor::Cursor;
use crate::project::{
    Blend, Continuity, Filling, LooseParts, PoseMode, PoseSpec, ProjectError, Support, Weighting,
    pose::MAX_DENSITY,
    weighting::{LEAST_DEGREE, MOST_DEGREE},
};

impl Weighting {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let weighting = value.object()?;
        weighting.allow_only(&["shape_factor", "degree", "filling", "support", "continuity"])?;
        let default = Self::default();
        Ok(Self {
            shape_factor: weighting.value_or("shape_factor", default.shape_factor, |value| value.number())?,
            degree: weighting
                .value_or("degree", default.degree, |value| value.whole_number(&(LEAST_DEGREE..=MOST_DEGREE)))?,
            filling: weighting.value_or("filling", default.filling, |value| {
                value.one_of(&[("line", Filling::Line), ("half", Filling::Half)])
            })?,
            support: weighting.value_or("support", default.support, |value| {
                value.one_of(&[("paper", Support::Paper), ("smooth", Support::Smooth)])
            })?,
            continuity: weighting.value_or("continuity", default.continuity, |value| {
                value.one_of(&[("exact", Continuity::Exact), ("c2", Continuity::C2)])
            })?,
        })
    }
}

impl PoseSpec {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let pose = value.object()?;
        pose.allow_only(&["mode", "blend", "density"])?;
        let default = Self::default();
        Ok(Self {
            mode: pose.value_or("mode", default.mode, |value| {
                value.one_of(&[("harmonic", PoseMode::Harmonic), ("rigid", PoseMode::Rigid)])
            })?,
            blend: pose.value_or("blend", default.blend, |value| {
                value.one_of(&[("linear", Blend::Linear), ("rigid", Blend::Rigid)])
            })?,
            density: pose.value_or("density", default.density, |value| value.whole_number(&(0..=MAX_DENSITY)))?,
        })
    }
}

impl LooseParts {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        value.one_of(&[("stay", Self::Stay), ("follow", Self::Follow)])
    }
}
