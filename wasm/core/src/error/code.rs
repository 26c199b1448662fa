//! Codes of errors, and the handles that errors name.

use super::Error;

impl Error {
    /// All codes that [`code`](Self::code) returns.
    pub const CODES: [&'static str; 31] = [
        "project",
        "picture",
        "picture-mismatch",
        "scale",
        "canvas",
        "nothing-drawn",
        "nothing-opaque",
        "nothing-to-fill-from",
        "no-outline",
        "domain",
        "handle-outside",
        "handle-far-outside",
        "handles-too-close",
        "bar-too-short",
        "bars-overlap",
        "on-held-boundary",
        "too-many-handles",
        "handles-crowded",
        "outline-too-long",
        "too-many-corners",
        "too-many-sites",
        "too-much-memory",
        "too-much-work",
        "held-too-fine",
        "unsupported",
        "pose",
        "film",
        "point-outside",
        "mesh",
        "cloud",
        "poser",
    ];

    /// A stable name for programs, in kebab case.
    ///
    /// | code | refused input |
    /// |---|---|
    /// | `project` | a project that breaks the format: [`ProjectError`](crate::project::ProjectError) has the key |
    /// | `picture` | a picture of an unsupported size, or with the wrong number of bytes |
    /// | `picture-mismatch` | a picture of another size than the project's |
    /// | `scale` | a scale with no pixel in the result, or too many |
    /// | `canvas` | a warped picture that is too large to be drawn as a whole |
    /// | `nothing-drawn` | a covered part without a pixel |
    /// | `nothing-opaque` | a picture without an opaque region of sufficient size |
    /// | `nothing-to-fill-from` | a domain that covers the whole picture, with a fill behind it |
    /// | `no-outline` | a picture without transparency, to be fitted by its outline |
    /// | `domain` | invalid rings, or rings with too many corners |
    /// | `handle-outside` | a handle outside the domain |
    /// | `handle-far-outside` | a handle far outside the outline of the picture that a project is fitted to |
    /// | `handles-too-close` | two handles that coincide |
    /// | `bar-too-short` | two corners of a bar or polygon that coincide |
    /// | `bars-overlap` | bars or polygons that run along each other |
    /// | `on-held-boundary` | a handle on a fixed boundary |
    /// | `too-many-handles` | more handles than supported |
    /// | `handles-crowded` | more handles close to another than supported |
    /// | `outline-too-long` | an outline with too many slits and spikes |
    /// | `too-many-corners` | more corners of bars and polygons than supported |
    /// | `too-many-sites` | a scene that needs more sites than supported |
    /// | `too-much-memory` | a scene that is too large for the memory of a browser |
    /// | `too-much-work` | a scene that takes more steps than supported |
    /// | `held-too-fine` | a fixed boundary with too many sharp corners |
    /// | `unsupported` | a setting or handle that point clouds do not support |
    /// | `pose` | a pose with other handles, with too large numbers, or from another solution |
    /// | `film` | an unsupported frame rate, part of a clip, or number of frames |
    /// | `point-outside` | a point outside the domain |
    /// | `mesh` | an invalid mesh |
    /// | `cloud` | an invalid point cloud |
    /// | `poser` | bytes that do not hold a poser |
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Project(_) => "project",
            Self::PictureSide { .. } | Self::PictureArea { .. } | Self::PictureBytes { .. } => "picture",
            Self::Scale { .. } => "scale",
            Self::Canvas { .. } => "canvas",
            Self::NothingDrawn => "nothing-drawn",
            Self::PictureMismatch { .. } => "picture-mismatch",
            Self::NothingOpaque { .. } | Self::OnlySpecks { .. } => "nothing-opaque",
            Self::NothingToFillFrom => "nothing-to-fill-from",
            Self::NoOutline => "no-outline",
            Self::RingOutsidePicture { .. }
            | Self::RingPoint { .. }
            | Self::RingDuplicate { .. }
            | Self::RingFlat { .. }
            | Self::RingsCross { .. }
            | Self::RingsTooFine { .. } => "domain",
            Self::HandleOutside { .. } => "handle-outside",
            Self::HandleFarOutside { .. } => "handle-far-outside",
            Self::HandlesTooClose { .. } => "handles-too-close",
            Self::BarTooShort { .. } => "bar-too-short",
            Self::BarsOverlap { .. } => "bars-overlap",
            Self::OnHeldBoundary { .. } => "on-held-boundary",
            Self::TooManyHandles { .. } => "too-many-handles",
            Self::HandlesCrowded { .. } => "handles-crowded",
            Self::OutlineTooLong { .. } => "outline-too-long",
            Self::TooManyCorners { .. } => "too-many-corners",
            Self::Unsupported { .. } => "unsupported",
            Self::PoseMismatch { .. }
            | Self::PoseMissing { .. }
            | Self::PoseOfAnotherSolution
            | Self::PoseShape { .. }
            | Self::PoseNotFinite { .. } => "pose",
            Self::FrameRate { .. } | Self::FrameRange { .. } | Self::TooManyFrames { .. } => "film",
            Self::PointOutside { .. } => "point-outside",
            Self::TooManySites => "too-many-sites",
            Self::TooMuchMemory => "too-much-memory",
            Self::TooMuchWork => "too-much-work",
            Self::HeldTooFine { .. } => "held-too-fine",
            Self::MeshTriangle { .. }
            | Self::MeshTooFine { .. }
            | Self::MeshEmpty
            | Self::MeshVertex { .. }
            | Self::MeshVertexLoose { .. }
            | Self::MeshTriangleFlat { .. }
            | Self::MeshEdge { .. }
            | Self::MeshPinched { .. }
            | Self::MeshCrosses { .. }
            | Self::MeshCovered { .. } => "mesh",
            Self::CloudNeighbours { .. } | Self::CloudPoint { .. } | Self::CloudDuplicate { .. } => "cloud",
            Self::PoserBytes => "poser",
        }
    }

    /// The ids of the handles in the message, in order of mention.
    #[must_use]
    pub fn handles(&self) -> Vec<&str> {
        match self {
            Self::HandleOutside { id, .. }
            | Self::HandleFarOutside { id, .. }
            | Self::BarTooShort { id, .. }
            | Self::OnHeldBoundary { id }
            | Self::TooManyHandles { id, .. }
            | Self::HandlesCrowded { id, .. }
            | Self::TooManyCorners { id, .. }
            | Self::PoseMissing { id }
            | Self::PoseShape { id, .. }
            | Self::PoseNotFinite { id } => vec![id],
            Self::HandlesTooClose { first, second, .. } | Self::BarsOverlap { first, second } => {
                if first == second {
                    vec![first]
                } else {
                    vec![first, second]
                }
            }
            _ => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::Error;

    #[test]
    fn table_of_codes_is_complete() {
        let this = include_str!("code.rs");
        let (_, code) = this.split_once("pub fn code").unwrap();
        let (code, _) = code.split_once("#[cfg(test)]").unwrap();
        let codes: BTreeSet<&str> = code.split('"').skip(1).step_by(2).collect();
        let rows = this.lines().filter_map(|line| line.trim().strip_prefix("/// | `")?.split('`').next());
        let listed: BTreeSet<&str> = rows.collect();
        assert_eq!(codes, listed);
        assert_eq!(codes, Error::CODES.into_iter().collect());
        assert!(codes.contains("pose"));
    }
}
