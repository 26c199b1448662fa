//! What the rigid mode promises beside the dense reference, the distances beside the geodesic, and weights of themselves, and whether
//! they keep it.

use crate::{
    distances::{Distances, greatest},
    maxima::{SceneMaxima, Weighting},
    methods::{Compared, EDITOR, Method},
};

/// A promise about one pose, the distances in one domain, or the weights of one scene.
#[derive(Debug, Clone)]
pub struct Bar {
    /// The pose, the domain or the scene.
    pub of: &'static str,
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

/// The bars of distances: one for each domain, whatever the number of samples.
#[must_use]
pub fn distance_bars(all: &[Distances]) -> Vec<Bar> {
    let of = |same: &[Distances]| {
        let figure = greatest(same.iter().map(|distances| distances.solver.greatest));
        Bar { of: same[0].domain, what: "greatest error of a distance", figure, limit: 1e-6 }
    };
    all.chunk_by(|a, b| a.domain == b.domain).map(of).collect()
}

/// The bars of weights: no second maximum, by the paper's supports.
#[must_use]
pub fn maxima_bars(all: &[SceneMaxima]) -> Vec<Bar> {
    let of = |SceneMaxima { scene, maxima, .. }: &SceneMaxima| {
        let bar = |what, rises: &[f64]| Bar { of: scene, what, figure: rises.len() as f64, limit: 0.0 };
        [
            bar("second maxima of single sites' weights", &maxima.of_sites),
            bar("second maxima of handles' fields", &maxima.of_handles),
        ]
    };
    all.iter().filter(|of_scene| of_scene.weighting == Weighting::Paper).flat_map(of).collect()
}

/// The bars of a pose, for `rigid 100`: the rigid mode as the editor asks for it.
#[must_use]
pub fn bars(compared: &Compared) -> Vec<Bar> {
    let (Some(rigid), Some(dense)) = (compared.by(EDITOR), compared.by(Method::Dense)) else { return Vec::new() };
    let bar = |what, figure, limit| Bar { of: compared.pose.name, what, figure, limit };
    // A pin may turn the triangles next to it over, at any size of the mesh: folds of the reference count away from pins.
    let folds = if compared.folds_away_from_handles(dense) == 0 { 0.0 } else { f64::INFINITY };
    vec![
        bar("rigid 100: mean energy ÷ dense's", rigid.distortion.energy / dense.distortion.energy, 1.25),
        bar("rigid 100: time of a frame ÷ dense's", rigid.frame_ms / dense.frame_ms, 0.02),
        bar("rigid 100: folds, where dense has none", rigid.distortion.folds as f64, folds),
        bar("rigid 100: farthest off a handle, px", rigid.off_handles, 1e-6),
    ]
}
