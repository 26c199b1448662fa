//! What a solve did, in numbers.

use serde::Serialize;

use crate::solver::Stage;

/// The figures of `c2warp inspect --json`, but for the times.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Report {
    /// Samples of the domain.
    pub samples: usize,
    /// Connected parts of the domain.
    pub islands: usize,
    /// Holes of the domain.
    pub holes: usize,
    /// Regions that were too small to keep.
    pub specks: usize,
    /// Corners of the outline at which shortest paths may bend.
    pub reflex_corners: usize,
    /// Point handles.
    pub point_handles: usize,
    /// Bar handles.
    pub bar_handles: usize,
    /// Polygon handles.
    pub polygon_handles: usize,
    /// Parts of bars and polygons outside the domain.
    pub outside: Vec<Outside>,
    /// Sites of handles, and of a held boundary.
    pub real_sites: usize,
    /// Sites that Algorithm 1 added.
    pub virtual_sites: usize,
    /// The score δ / r_d of the worst cell before each round of Algorithm 1 (figure 3, right), with δ = r_d −
    /// `Site::reach_limit` in place of r_d − r_h.
    pub scores: Vec<f64>,
    /// Mean number of supports over a sample.
    pub cover_mean: f64,
    /// Greatest number of supports over a sample.
    pub cover_max: usize,
    /// Least Σφ over the samples of islands with handles.
    pub min_phi_sum: f64,
    /// Triangles of the posed mesh that turned over.
    pub folded_triangles: usize,
    /// A fingerprint of the samples' weights: equal exactly where every bit is.
    pub weights_hash: String,
}

/// A part of a bar or polygon that lies outside the domain, or on its held boundary: it moves nothing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outside {
    /// Id of the handle.
    pub handle: String,
    /// Where the part begins, at rest.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
}

/// Milliseconds spent in each stage, and on a pose. The core has no clock: whoever runs the stages measures them.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct StageTimes {
    /// The outline.
    pub domain: f64,
    /// Samples and mesh.
    pub sampling: f64,
    /// All of distances, cells and virtual sites.
    pub regions: f64,
    /// Supports, weights and harmonic fields.
    pub weights: f64,
    /// Motions of the sites.
    pub pose: f64,
}

impl StageTimes {
    /// Adds to the time of a stage.
    pub fn add(&mut self, stage: Stage, ms: f64) {
        let time = match stage {
            Stage::Domain => &mut self.domain,
            Stage::Sampling => &mut self.sampling,
            Stage::Regions => &mut self.regions,
            Stage::Weights => &mut self.weights,
        };
        *time += ms;
    }
}

/// The object of `c2warp inspect --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Inspection {
    /// What the solve did.
    #[serde(flatten)]
    pub report: Report,
    /// How long it took.
    pub ms: StageTimes,
}

/// FNV-1a over 64-bit words.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fingerprint(u64);

impl Fingerprint {
    pub(crate) fn of(words: impl Iterator<Item = u64>) -> Self {
        Self(words.fold(0xcbf2_9ce4_8422_2325, |hash, word| (hash ^ word).wrapping_mul(0x0100_0000_01b3)))
    }
}

impl std::fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}
