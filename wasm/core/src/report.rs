//! The figures of a solve, for `c2warp inspect --json` and for tests.

use crate::{bone::OutsidePart, domain::OutlineDetail, stage::StageTimes};

/// The figures of `c2warp inspect --json`, without the times.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Report {
    /// Samples of the domain.
    pub samples: usize,
    /// Connected parts of the domain.
    pub islands: usize,
    /// Holes of the domain.
    pub holes: usize,
    /// Islands without a handle.
    pub loose_islands: usize,
    /// Opaque regions too small to keep.
    pub specks: usize,
    /// How closely the outline follows the picture.
    pub outline: OutlineDetail,
    /// Maximum width of a gap that the domain includes, in pixels.
    pub bridged_gap: f64,
    /// Corners of the outline at which shortest paths may bend.
    pub reflex_corners: usize,
    /// Point handles.
    pub point_handles: usize,
    /// Bar handles.
    pub bar_handles: usize,
    /// Polygon handles.
    pub polygon_handles: usize,
    /// Parts of bars and polygons outside the domain.
    pub outside: Vec<OutsidePart>,
    /// Sites of handles, and of a held boundary.
    pub real_sites: usize,
    /// Sites that Algorithm 1 inserted.
    pub virtual_sites: usize,
    /// The score δ / r_d of the worst cell before each round of Algorithm 1 (figure 3, right). Here δ is r_d minus the
    /// greatest allowed radius of the cell, instead of r_d − r_h.
    pub scores: Vec<f64>,
    /// Mean number of supports that contain a sample.
    pub cover_mean: f64,
    /// Maximum number of supports that contain a sample.
    pub cover_max: usize,
    /// Least Σφ over the samples of islands with handles.
    pub min_phi_sum: f64,
    /// Flipped triangles of the posed mesh.
    pub folded_triangles: usize,
    /// A hash of the samples' weights. It changes if any bit of them changes.
    pub weights_hash: String,
}

/// The object of `c2warp inspect --json`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Inspection {
    /// The figures of the solve.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub report: Report,
    /// The time of each stage.
    pub ms: StageTimes,
}

/// An FNV-1a hash over 64-bit words.
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
