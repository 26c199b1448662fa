//! Requirements on the rigid mode, on distances and on weights, and whether they are met.

use c2warp::project::Blend;
use c2warp_bench::drag::exceeded_by;

use crate::{
    continuity::SceneContinuity,
    distances::{Distances, greatest},
    drags::{Dragged, SampleDrags},
    maxima::{SceneMaxima, Weighting},
    measure::Distortion,
    methods::{Comparison, EDITOR, Method, Outcome},
    suggestions::Suggested,
};

/// How far a vertex may move in a frame, as a multiple of the handle's move.
pub const LARGEST_MOVE: f64 = 3.0;

/// A requirement on one pose, the distances in one domain, or the weights of one scene.
#[derive(Debug, Clone)]
pub struct Requirement {
    /// The pose, the poses, the domain or the scene.
    pub subject: String,
    /// The name of the measured value.
    pub name: &'static str,
    /// The measured value.
    pub value: f64,
    /// The largest allowed value.
    pub limit: f64,
}

impl Requirement {
    /// Returns `met` or `missed`.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        if self.value <= self.limit { "met" } else { "missed" }
    }
}

/// Returns one requirement on distances per domain, over all numbers of samples.
#[must_use]
pub fn distance_requirements(all: &[Distances]) -> Vec<Requirement> {
    let of = |same: &[Distances]| {
        let value = greatest(same.iter().map(|distances| distances.solver.greatest));
        let subject = same[0].domain.to_owned();
        Requirement { subject, name: "largest error of a distance", value, limit: 1e-6 }
    };
    all.chunk_by(|a, b| a.domain == b.domain).map(of).collect()
}

/// Returns the requirement on suggested handles: 5 to 14 of them on each picture, a limb's width apart.
#[must_use]
pub fn suggestion_requirements(all: &[Suggested]) -> Vec<Requirement> {
    let of = |suggested: &Suggested| {
        let count = suggested.handles.len();
        let value = (count.saturating_sub(14) + 5_usize.saturating_sub(count)) as f64;
        let of = |name, value, limit| Requirement { subject: suggested.name.clone(), name, value, limit };
        let width = 1.0 / suggested.least_widths();
        [of("handles fewer than 5 or more than 14", value, 0.0), of("limb's width ÷ least distance", width, 1.05)]
    };
    all.iter().flat_map(of).collect()
}

/// Returns the requirements on weights: no secondary maxima with the paper's supports.
#[must_use]
pub fn maxima_requirements(all: &[SceneMaxima]) -> Vec<Requirement> {
    let of = |SceneMaxima { scene, maxima, .. }: &SceneMaxima| {
        let none = |name, found: &[f64]| Requirement {
            subject: (*scene).to_owned(),
            name,
            value: found.len() as f64,
            limit: 0.0,
        };
        [
            none("secondary maxima of the weights of sites", &maxima.of_sites),
            none("secondary maxima of the fields of handles", &maxima.of_handles),
        ]
    };
    all.iter().filter(|of_scene| of_scene.weighting == Weighting::Paper).flat_map(of).collect()
}

/// Returns the requirements on C² weights: no jumps, and at most twice the time of a solve.
#[must_use]
pub fn continuity_requirements(all: &[SceneContinuity]) -> Vec<Requirement> {
    let of = |pair: &[SceneContinuity]| {
        let [exact, c2] = pair else { return Vec::new() };
        let requirement = |name, value, limit| Requirement { subject: c2.scene.clone(), name, value, limit };
        vec![
            requirement("c2: sites with a cut support", c2.cut_sites as f64, 0.0),
            requirement("c2: jump of second derivatives", c2.shadows[1], 1e-3),
            requirement("c2: time of a solve ÷ that of exact", c2.solve_ms / exact.solve_ms, 2.0),
        ]
    };
    all.chunk_by(|a, b| a.scene == b.scene).flat_map(of).collect()
}

/// The least energy, to two digits.
const LEAST: f64 = 1.005;

/// Returns the requirements on all drags. Only drags that pass no other handle must be steady and free of folds.
#[must_use]
pub fn drag_requirements(all: &[SampleDrags]) -> Vec<Requirement> {
    if all.is_empty() {
        return Vec::new();
    }
    let drags: Vec<&Dragged> = all.iter().flat_map(|sample| &sample.drags).collect();
    let free = |of: fn(&Dragged) -> f64| greatest(drags.iter().filter(|drag| !drag.is_crossing).map(|drag| of(drag)));
    let exact: Vec<f64> = drags.iter().filter_map(|drag| drag.held.exact).collect();
    let folds: usize = drags.iter().filter(|drag| drag.held.exact.is_some()).map(|drag| drag.held.folds).sum();
    let released: Vec<f64> = drags.iter().flat_map(|drag| drag.released).collect();
    let slowest = |of: fn(&SampleDrags) -> f64| greatest(all.iter().map(of));
    let [exact_median, released_median] = [&exact, &released].map(|ratios| exceeded_by(0.5, ratios));
    let worst = |ratios: &[f64]| greatest(ratios.iter().copied());
    let requirement = |name, value, limit| Requirement { subject: "drags of samples".to_owned(), name, value, limit };
    vec![
        requirement("largest move in a frame ÷ that of the handle", free(Dragged::largest_move), LARGEST_MOVE),
        requirement("folded area, %", 100.0 * free(|drag| drag.folded), 0.0),
        requirement("after the return: largest distance from rest, px", free(|drag| drag.from_home), 1e-3),
        requirement("held: median energy ÷ optimum", exact_median, 1.25),
        requirement("held: largest energy ÷ optimum", worst(&exact), 1.8),
        requirement("held: folds where the optimum has none", folds as f64, 0.0),
        requirement("frame of a drag, ms: median, slowest picture", slowest(|sample| sample.times.frame), 8.0),
        requirement("frame of a drag, ms: 99 %, slowest picture", slowest(|sample| sample.times.slow_frame), 14.0),
        requirement("first pose, ms: slowest picture", slowest(|sample| sample.times.first), 80.0),
        requirement("released: median energy ÷ least known", released_median, LEAST),
        requirement("released: largest energy ÷ least known", worst(&released), 1.1),
    ]
}

/// Returns the requirements on a pose by the editor's method.
#[must_use]
pub fn pose_requirements(comparison: &Comparison) -> Vec<Requirement> {
    let (Some(rigid), Some(dense)) = (comparison.outcome_of(EDITOR), comparison.outcome_of(Method::Dense)) else {
        return Vec::new();
    };
    let requirement = |name, value, limit| Requirement { subject: comparison.scene.name.clone(), name, value, limit };
    // A pin may flip the triangles around it, however fine the mesh is. So folds of the reference count only away from
    // pins.
    let folds = if comparison.folds_away_from_handles(dense) == 0 { 0.0 } else { f64::INFINITY };
    vec![
        requirement("editor: mean energy ÷ that of dense", rigid.distortion.energy / dense.distortion.energy, 1.25),
        requirement("editor: frame time ÷ that of dense", rigid.frame_ms / dense.frame_ms, 0.02),
        requirement("editor: folds, if dense has none", rigid.distortion.folds as f64, folds),
        requirement("editor: largest error at a handle, px", rigid.handle_error, 1e-6),
    ]
}

/// Returns the requirements on all poses that are compared with the optimum.
#[must_use]
pub fn optimum_requirements(comparisons: &[&Comparison]) -> Vec<Requirement> {
    let with = |method: Method, ratio: &dyn Fn(&Outcome, &Outcome) -> f64, to: Method| -> Vec<f64> {
        let of = |comparison: &&Comparison| Some(ratio(comparison.outcome_of(method)?, comparison.outcome_of(to)?));
        comparisons.iter().filter_map(of).collect()
    };
    let energy = |a: &Outcome, b: &Outcome| a.distortion.energy / b.distortion.energy;
    let mut energies = with(EDITOR, &energy, Method::Optimum);
    energies.sort_by(f64::total_cmp);
    let Some(&median) = energies.get(energies.len() / 2) else { return Vec::new() };
    let folds: f64 = with(EDITOR, &|editor, _| editor.distortion.folds as f64, Method::Optimum).iter().sum();
    let times = with(EDITOR, &|editor, best| editor.pose_ms.unwrap_or(0.0) / best.frame_ms, Method::Optimum);
    let pose_ms = with(EDITOR, &|editor, _| editor.pose_ms.unwrap_or(0.0), EDITOR);
    let denser = |density| {
        let method = Method::Rigid { density, blend: Blend::Linear };
        greatest(with(method, &energy, EDITOR).into_iter())
    };
    let over_dense =
        |of: fn(&Distortion) -> f64| greatest(comparisons.iter().filter_map(|comparison| comparison.over_dense(of)));
    let requirement =
        |name, value, limit| Requirement { subject: "poses beside the optimum".to_owned(), name, value, limit };
    vec![
        requirement("editor: median energy ÷ optimum", median, 1.25),
        requirement("editor: largest energy ÷ optimum", greatest(energies.iter().copied()), 1.8),
        requirement("editor: folds where the optimum has none", folds, 0.0),
        requirement("editor: largest time of a pose from rest, ms", greatest(pose_ms.into_iter()), 80.0),
        requirement("editor: largest time ÷ that of the optimum", greatest(times.into_iter()), 0.02),
        requirement("rigid 200: largest energy ÷ the editor's", denser(200), 1.02),
        requirement("rigid 400: largest energy ÷ the editor's", denser(400), 1.02),
        requirement("editor: largest turning of the outline ÷ that of dense", over_dense(|d| d.turning), 1.1),
        requirement("editor: largest bending ÷ that of dense", over_dense(|d| d.bending), 1.1),
    ]
}
