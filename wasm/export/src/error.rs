//! Why a rig was not exported.

use c2warp::TooFewVertices;

use crate::options::{LEAST_VERTICES, MOST_BONES, MOST_INFLUENCES, MOST_VERTICES};

/// Why a rig was not exported.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The number of bones is 0, or exceeds the limit of the formats.
    #[error("--bones: expected a number from 1 to {MOST_BONES}, found {found}: engines store bone numbers in 8 bits")]
    Bones {
        /// The requested number.
        found: usize,
    },
    /// More handles than bones.
    #[error("this project has {found} handles: --bones must be at least {found}")]
    Handles {
        /// The number of handles.
        found: usize,
    },
    /// More handles than formats hold bones.
    #[error("this project has {found} handles: an engine's rig has up to {MOST_BONES} bones, one for each handle")]
    HandlesOfFormats {
        /// The number of handles.
        found: usize,
    },
    /// The number of influences is 0 or too large.
    #[error("--influences: expected a number from 1 to {MOST_INFLUENCES}, found {found}")]
    Influences {
        /// The requested number.
        found: usize,
    },
    /// The number of influences exceeds the limit of the format.
    #[error("--influences: {format} blends at most {most} bones per vertex, found {found}")]
    InfluencesOfFormat {
        /// The name of the format.
        format: &'static str,
        /// The limit of the format.
        most: usize,
        /// The requested number.
        found: usize,
    },
    /// The number of vertices is too small for any mesh, or exceeds the limit of the formats.
    #[error("--vertices: expected a number from {LEAST_VERTICES} to {MOST_VERTICES}, found {found}")]
    Vertices {
        /// The requested number.
        found: usize,
    },
    /// The number of vertices is too small for the outline of this picture.
    #[error("--vertices: {0}")]
    Outline(#[from] TooFewVertices),
    /// A pose of the project cannot be computed.
    #[error("{0}")]
    Pose(#[from] c2warp::Error),
    /// A pose of a clip cannot be computed.
    #[error("clip {clip:?} at {seconds} s: {reason}")]
    ClipPose {
        /// The name of the clip.
        clip: String,
        /// The time.
        seconds: f64,
        /// The reason.
        reason: c2warp::Error,
    },
    /// A clip is too long.
    #[error("clip {clip:?} lasts {seconds} s: a clip of an engine's rig can last up to {most} s")]
    ClipTooLong {
        /// The name of the clip.
        clip: String,
        /// Its duration.
        seconds: f64,
        /// The longest duration.
        most: f64,
    },
}
