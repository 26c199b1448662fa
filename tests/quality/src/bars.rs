//! What the rigid mode promises beside the dense reference, and whether it keeps it.

use crate::methods::{Compared, EDITOR, Method};

/// A promise about one pose.
#[derive(Debug, Clone)]
pub struct Bar {
    /// The pose.
    pub pose: &'static str,
    /// What is promised.
    pub what: &'static str,
    /// The figure and what it may be at most.
    pub figure: f64,
    /// The greatest it may be.
    pub limit: f64,
}

impl Bar {
    /// `met` where the promise is kept, else `short`.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        if self.figure <= self.limit { "met" } else { "short" }
    }
}

/// The bars of a pose, for the rigid mode as the editor asks for it.
#[must_use]
pub fn bars(compared: &Compared) -> Vec<Bar> {
    let (Some(rigid), Some(dense)) = (compared.by(EDITOR), compared.by(Method::Dense)) else { return Vec::new() };
    let bar = |what, figure, limit| Bar { pose: compared.pose.name, what, figure, limit };
    // A pin may turn the triangles next to it over, at any size of the mesh: folds of the reference count away from pins.
    let folds = if compared.folds_away_from_handles(dense) == 0 { 0.0 } else { f64::INFINITY };
    vec![
        bar("mean energy ÷ dense's", rigid.distortion.energy / dense.distortion.energy, 1.25),
        bar("time of a frame ÷ dense's", rigid.frame_ms / dense.frame_ms, 0.02),
        bar("folds, where dense has none", rigid.distortion.folds as f64, folds),
        bar("farthest off a handle, px", rigid.off_handles, 1e-6),
    ]
}
