//! Why a rig was not read or not baked.

use crate::error::Error;

/// A part of the file of a rig.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum RigPart {
    /// The table of sections.
    Table,
    /// Sizes and settings.
    Head,
    /// The picture.
    Picture,
    /// Vertices, triangles and the rest positions of sites.
    Mesh,
    /// Weights of the vertices.
    Weights,
    /// Displacements of the vertices.
    Displacements,
    /// Handles and their shares in the motions of sites.
    Shares,
    /// Handles and their solver.
    Posing,
    /// A clip.
    Clip,
}

impl RigPart {
    fn words(self) -> &'static str {
        match self {
            Self::Table => "the table of sections",
            Self::Head => "the head",
            Self::Picture => "the picture",
            Self::Mesh => "the mesh",
            Self::Weights => "the weights",
            Self::Displacements => "the displacement",
            Self::Shares => "the shares",
            Self::Posing => "the poses",
            Self::Clip => "a clip",
        }
    }
}

/// Why bytes are not a valid rig.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RigError {
    /// The bytes lack the signature of a rig.
    #[error("this is not a rig: the file has no rig signature")]
    NotARig,
    /// A later version of the format.
    #[error("this rig has version {found} of the format, but version 1 or 2 is expected")]
    Version {
        /// The version of the file.
        found: u32,
    },
    /// The file is truncated, or data follows its end.
    #[error("this rig has {found} bytes, but it should have {expected}")]
    Length {
        /// Number of bytes according to the header.
        expected: u32,
        /// Number of bytes in the file.
        found: usize,
    },
    /// The checksum does not match.
    #[error("this rig is damaged: its checksum does not match")]
    Checksum,
    /// The bytes of a part contradict the format.
    #[error("this rig is damaged: {} {reason}", part.words())]
    Part {
        /// The part.
        part: RigPart,
        /// The fault, as the predicate of a sentence.
        reason: &'static str,
    },
}

/// Why a solution was not baked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BakeError {
    /// A pose cannot be computed.
    #[error("{} at {seconds} s: {reason}", named(clip))]
    Pose {
        /// The clip's name. It is empty for the pose of the handles themselves.
        clip: String,
        /// The time in the clip.
        seconds: f64,
        /// Why.
        reason: Error,
    },
    /// A clip has too many frames.
    #[error("clip {clip:?} lasts {seconds} s: a clip of a rig can last up to {most} s")]
    ClipTooLong {
        /// The clip's name.
        clip: String,
        /// Its duration.
        seconds: f64,
        /// The longest duration.
        most: f64,
    },
    /// The clips have too many frames in total.
    #[error("the clips have {frames} frames of {sites} sites: a rig can hold {most} motions in all its clips")]
    TooManyMotions {
        /// Frames of all clips.
        frames: usize,
        /// Sites, each of which has a motion in every frame.
        sites: usize,
        /// The greatest product of frames and sites.
        most: usize,
    },
    /// Numbers are so large that vertices would be misplaced.
    #[error("{}: handles move too far for a rig", named(clip))]
    TooFar {
        /// The clip's name. It is empty for the pose of the handles themselves.
        clip: String,
    },
    /// The file would exceed 4 GB, or its deflated sections 512 MiB.
    #[error("the rig would be too large for its format: use a smaller picture or shorter clips")]
    TooLarge,
}

fn named(clip: &str) -> String {
    if clip.is_empty() { "the pose".to_owned() } else { format!("clip {clip:?}") }
}
