//! Why a rig was not made.

use c2warp::TooFewVertices;

use crate::options::{LEAST_VERTICES, MOST_BONES, MOST_INFLUENCES, MOST_VERTICES};

/// Why a rig was not made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// No bones, or more than formats hold.
    #[error("--bones: expected a number from 1 to {MOST_BONES}, found {found}: engines count bones in 8 bits")]
    Bones {
        /// The number asked for.
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
    /// No influences, or too many.
    #[error("--influences: expected a number from 1 to {MOST_INFLUENCES}, found {found}")]
    Influences {
        /// The number asked for.
        found: usize,
    },
    /// More influences than the format holds.
    #[error("--influences: {format} blends at most {most} bones a vertex, found {found}")]
    InfluencesOfFormat {
        /// The name of the format.
        format: &'static str,
        /// The most that it holds.
        most: usize,
        /// The number asked for.
        found: usize,
    },
    /// Too few vertices for any mesh, or more than formats hold.
    #[error("--vertices: expected a number from {LEAST_VERTICES} to {MOST_VERTICES}, found {found}")]
    Vertices {
        /// The number asked for.
        found: usize,
    },
    /// Too few vertices for the outline of this picture.
    #[error("--vertices: {0}")]
    Outline(#[from] TooFewVertices),
    /// A pose of the project cannot be made.
    #[error("{0}")]
    Pose(#[from] c2warp::Error),
    /// A pose of a clip cannot be made.
    #[error("clip {clip:?} at {seconds} s: {reason}")]
    ClipPose {
        /// The name of the clip.
        clip: String,
        /// The time.
        seconds: f64,
        /// The reason.
        reason: c2warp::Error,
    },
    /// Too long a clip.
    #[error("clip {clip:?} lasts {seconds} s: an engine's rig has clips of up to {most} s")]
    ClipTooLong {
        /// The name of the clip.
        clip: String,
        /// Its duration.
        seconds: f64,
        /// The longest duration.
        most: f64,
    },
}
