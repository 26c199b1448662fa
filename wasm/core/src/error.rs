//! Everything that can be refused, in one enum: what was wrong, where, and what to do about it.

use crate::{
    display_number::DisplayNumber,
    limits,
    project::{ProjectError, ShapeKind},
};

/// Why a picture, a domain, a project or a handle was refused.
///
/// [`Error::code`] is stable and meant for programs; the `Display` text is one sentence meant for a person.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// What was read is not a project, or what was made is none that can be solved or posed: see [`Project::check`](crate::project::Project::check).
    #[error(transparent)]
    Project(#[from] ProjectError),
    /// A picture whose sides are outside what can be warped.
    #[error(
        "the picture is {width}×{height} px; each side must be from {min} to {max} px: scale it first",
        min = limits::MIN_SIDE,
        max = limits::MAX_SIDE
    )]
    PictureSide {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// A picture with more pixels than can be warped.
    #[error(
        "the picture is {width}×{height} px, more than {max} megapixels: scale it down first",
        max = limits::MAX_PIXELS / 1_000_000
    )]
    PictureArea {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The pixels handed over do not fill the picture.
    #[error("a picture of {width}×{height} px needs {expected} bytes of RGBA, not {found}")]
    PictureBytes {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// `width × height × 4`.
        expected: usize,
        /// Bytes received.
        found: usize,
    },
    /// A scale at which the picture would have no pixel, or too many.
    #[error(
        "a picture of {width}×{height} px cannot be warped at a scale of {scale:?}: the result must have 1 to {side} px a side and at most {area} megapixels",
        side = limits::MAX_SIDE,
        area = limits::MAX_PIXELS / 1_000_000
    )]
    Scale {
        /// Pixels of the result for a pixel of the picture.
        scale: f64,
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// A warped picture that reaches too far for all of it to be shown.
    #[error(
        "all of the warped picture would take {width}×{height} px: the result may have {side} px a side and {area} megapixels at most",
        side = limits::MAX_SIDE,
        area = limits::MAX_PIXELS / 1_000_000
    )]
    Canvas {
        /// Width in pixels.
        width: u64,
        /// Height in pixels.
        height: u64,
    },
    /// The project was made for a picture of another size.
    #[error("the project is for a picture of {project_width}×{project_height} px, but this one is {width}×{height} px")]
    PictureMismatch {
        /// Width that the project names.
        project_width: u32,
        /// Height that the project names.
        project_height: u32,
        /// Width of the picture.
        width: u32,
        /// Height of the picture.
        height: u32,
    },
    /// No pixel reaches the threshold.
    #[error(
        "no pixel of the picture is opaque at the threshold {}: lower domain.threshold or warp the whole image",
        DisplayNumber(*threshold)
    )]
    NothingOpaque {
        /// The alpha threshold, in (0, 1].
        threshold: f64,
    },
    /// Only specks reach the threshold.
    #[error(
        "only {specks} specks of the picture are opaque at the threshold {}: lower domain.threshold or warp the whole image",
        DisplayNumber(*threshold)
    )]
    OnlySpecks {
        /// The alpha threshold, in (0, 1].
        threshold: f64,
        /// How many regions were too small to keep.
        specks: usize,
    },
    /// A point of a ring outside the picture.
    #[error("domain.rings[{ring}][{point}] = ({}, {}) lies outside the picture of {width}×{height} px", DisplayNumber(*.x), DisplayNumber(*.y))]
    RingOutsidePicture {
        /// Index of the ring.
        ring: usize,
        /// Index of the point.
        point: usize,
        /// The point.
        x: f64,
        /// The point.
        y: f64,
        /// Width of the picture.
        width: u32,
        /// Height of the picture.
        height: u32,
    },
    /// A point of a ring that is too far out to compute with.
    #[error("domain.rings[{ring}][{point}] is not a point with coordinates from −{max} to {max}",
        max = limits::MAX_COORDINATE)]
    RingPoint {
        /// Index of the ring.
        ring: usize,
        /// Index of the point.
        point: usize,
    },
    /// Two points of the rings coincide.
    #[error("domain.rings[{ring}][{point}] stands on the same spot as domain.rings[{other_ring}][{other_point}]")]
    RingDuplicate {
        /// Index of the ring.
        ring: usize,
        /// Index of the point.
        point: usize,
        /// Index of the other point's ring.
        other_ring: usize,
        /// Index of the other point.
        other_point: usize,
    },
    /// A ring that encloses nothing.
    #[error("domain.rings[{ring}] encloses no area")]
    RingFlat {
        /// Index of the ring.
        ring: usize,
    },
    /// Two edges of the rings cross or touch.
    #[error("domain.rings[{ring}] at point {point} crosses domain.rings[{other_ring}] at point {other_point}")]
    RingsCross {
        /// Index of the ring.
        ring: usize,
        /// Index of the edge's first point.
        point: usize,
        /// Index of the other edge's ring.
        other_ring: usize,
        /// Index of the other edge's first point.
        other_point: usize,
    },
    /// An opaque part with more corners than can be solved in reasonable time.
    #[error(
        "the outline has {corners} corners or more, of which there may be {max}: raise domain.threshold or smooth the picture's alpha",
        max = limits::MAX_CORNERS
    )]
    OutlineTooFine {
        /// Number of corners after simplification, or the least that there must be.
        corners: usize,
    },
    /// Rings with more corners than can be solved in reasonable time.
    #[error("domain.rings have {corners} points, of which there may be {max}: draw the rings with fewer",
        max = limits::MAX_CORNERS)]
    RingsTooFine {
        /// Number of points of all rings.
        corners: usize,
    },
    /// A handle outside the domain.
    #[error("handle “{id}” at ({}, {}) lies outside the domain: place it on the picture's opaque part", DisplayNumber(*.x), DisplayNumber(*.y))]
    HandleOutside {
        /// Id of the handle.
        id: String,
        /// Its rest place.
        x: f64,
        /// Its rest place.
        y: f64,
    },
    /// Two handles that no weight could tell apart.
    #[error("handles “{first}” and “{second}” are less than {min} px apart: move or delete one of them",
        min = limits::MIN_SEPARATION)]
    HandlesTooClose {
        /// Id of one handle.
        first: String,
        /// Id of the other.
        second: String,
        /// Their straight distance in pixels.
        distance: f64,
    },
    /// Two corners of a bar or polygon on one spot.
    #[error("handle “{id}” has no length between its corners {corner} and the next: move or delete one of them")]
    BarTooShort {
        /// Id of the handle.
        id: String,
        /// Index of the corner.
        corner: usize,
    },
    /// Two bars that run along each other.
    #[error(
        "handles “{first}” and “{second}” run along each other; bars may cross and touch, but not lie on one another"
    )]
    BarsOverlap {
        /// Id of one handle.
        first: String,
        /// Id of the other; the same where a handle lies on itself.
        second: String,
    },
    /// A handle where nothing may move.
    #[error("handle “{id}” stands on the boundary, which is held: move it at least {min} px inside, or set fix_boundary to false",
        min = limits::HELD_CLEARANCE)]
    OnHeldBoundary {
        /// Id of the handle.
        id: String,
    },
    /// More handles than can be solved.
    #[error("{count} handles are too many: at most {max} can be solved, and handle “{id}” is the first beyond",
        max = limits::MAX_HANDLES)]
    TooManyHandles {
        /// Number of handles.
        count: usize,
        /// Id of the first handle beyond the limit.
        id: String,
    },
    /// Bars and polygons with more straight pieces than can be solved.
    #[error(
        "the bars and polygons have {segments} straight pieces, of which there may be {max}: draw handle “{id}”, of {corners} corners, with fewer",
        max = limits::MAX_SITES
    )]
    TooManyCorners {
        /// Id of the handle that has most of them.
        id: String,
        /// Number of its corners.
        corners: usize,
        /// Number of the straight pieces of all handles.
        segments: usize,
    },
    /// A kind of handle, or a setting, that this version does not solve.
    #[error("{path}: {feature} cannot be solved by this version")]
    Unsupported {
        /// Path of the key in the project.
        path: String,
        /// What is asked for.
        feature: String,
    },
    /// More handles are passed to a pose, or fewer, than were solved.
    #[error("the pose names {found} handles, but {expected} were solved")]
    PoseMismatch {
        /// Handles solved.
        expected: usize,
        /// Handles posed.
        found: usize,
    },
    /// A handle that was solved is not among those that are passed to a pose.
    #[error("the pose does not name handle “{id}”, which was solved")]
    PoseMissing {
        /// Id of the handle.
        id: String,
    },
    /// A pose and a solution that have nothing to do with one another.
    #[error("the pose is of another solution: make it by the poser of this one")]
    PoseOfAnother,
    /// A handle passed to a pose is not what was solved.
    #[error("handle “{id}” is posed as {posed}, but was solved as {solved}")]
    PoseShape {
        /// Id of the handle as posed.
        id: String,
        /// What was solved.
        solved: ShapeKind,
        /// What is posed.
        posed: ShapeKind,
    },
    /// A pose whose numbers overflow.
    #[error("handle “{id}” is posed beyond what can be computed")]
    PoseNotFinite {
        /// Id of the handle.
        id: String,
    },
    /// A point that should lie in the domain.
    #[error("the point ({}, {}) lies outside the domain", DisplayNumber(*.x), DisplayNumber(*.y))]
    PointOutside {
        /// The point.
        x: f64,
        /// The point.
        y: f64,
    },
    /// More sites are needed than there may be: for handles close to one another or to a held boundary, for bars and polygons, or as
    /// asked for by the density.
    #[error(
        "the scene needs more than {max} sites: move close handles apart, use fewer or shorter bars and polygons, or lower pose.density",
        max = limits::MAX_SITES
    )]
    TooManySites,
    /// A triangle mesh that is no mesh.
    #[error("triangle {triangle} of the mesh is not a triangle of its {vertices} vertices")]
    MeshTriangle {
        /// Index of the triangle.
        triangle: usize,
        /// Number of vertices.
        vertices: usize,
    },
    /// A mesh whose boundary turns more often than can be solved in reasonable time.
    #[error("the boundary of the mesh has {corners} corners, of which there may be {max}: use a mesh with a simpler one",
        max = limits::MAX_CORNERS)]
    MeshTooFine {
        /// Number of vertices at which the boundary turns.
        corners: usize,
    },
    /// A triangle mesh without triangles.
    #[error("the mesh has no triangle")]
    MeshEmpty,
    /// A vertex of a mesh that is not a finite number, or too far out to compute with.
    #[error("vertex {vertex} of the mesh is not a point with coordinates from −{max} to {max}",
        max = limits::MAX_COORDINATE)]
    MeshVertex {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A vertex that is a corner of no triangle.
    #[error("vertex {vertex} of the mesh belongs to no triangle: leave it out")]
    MeshVertexLoose {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A triangle without area.
    #[error("triangle {triangle} of the mesh has no area")]
    MeshTriangleFlat {
        /// Index of the triangle.
        triangle: usize,
    },
    /// Two triangles on one side of an edge: they overlap, or more than two share the edge.
    #[error(
        "triangles {other} and {triangle} of the mesh lie on the same side of the edge between vertices {from} and {to}"
    )]
    MeshEdge {
        /// Index of the triangle.
        triangle: usize,
        /// Index of the other triangle.
        other: usize,
        /// Index of one end of the edge.
        from: usize,
        /// Index of the other end.
        to: usize,
    },
    /// A vertex at which the mesh hangs together by this vertex alone.
    #[error(
        "the outline of the mesh passes vertex {vertex} more than once: give each part a vertex of its own, apart from the others"
    )]
    MeshPinched {
        /// Index of the vertex.
        vertex: usize,
    },
    /// The mesh lies over itself.
    #[error("the outline of the mesh at vertex {vertex} crosses or touches itself at vertex {other}")]
    MeshCrosses {
        /// Index of the vertex, on the outline: of the first end of an edge, or of a point.
        vertex: usize,
        /// Index of the vertex where the other edge, or the same point, is.
        other: usize,
    },
    /// A part of the mesh lies over another.
    #[error("the part of the mesh that vertex {vertex} bounds lies over another")]
    MeshCovered {
        /// Index of a vertex of its outline.
        vertex: usize,
    },
    /// A cloud with too few points for the neighbours that each is to have, or none to be had.
    #[error("{neighbours} neighbours for each of {points} points: there must be at least 1, and fewer than points")]
    CloudNeighbours {
        /// Number of points.
        points: usize,
        /// Neighbours asked for.
        neighbours: usize,
    },
    /// A point of a cloud that is not a finite number, or too far out to compute with.
    #[error("point {point} of the cloud is not a point with coordinates from −{max} to {max}",
        max = limits::MAX_COORDINATE)]
    CloudPoint {
        /// Index of the point.
        point: usize,
    },
    /// Two points of a cloud coincide.
    #[error("point {point} of the cloud stands on the same spot as point {other}")]
    CloudDuplicate {
        /// Index of the point.
        point: usize,
        /// Index of the other.
        other: usize,
    },
    /// Data handed to a poser that no solution wrote.
    #[error("these bytes are not a poser of this version")]
    PoserBytes,
}

impl Error {
    /// A stable name for programs, in kebab case.
    ///
    /// | code | what was refused |
    /// |---|---|
    /// | `project` | a project that is none: [`ProjectError`] tells the key |
    /// | `picture` | a picture of a size that cannot be warped, or not of as many bytes |
    /// | `picture-mismatch` | a picture of another size than the project's |
    /// | `scale` | a scale at which no picture comes out, or one too large |
    /// | `canvas` | a warped picture that reaches too far for all of it to be shown |
    /// | `nothing-opaque` | a picture without anything opaque that is large enough |
    /// | `domain` | rings that are none, or an outline with too many corners |
    /// | `handle-outside` | a handle outside the domain |
    /// | `handles-too-close` | two handles on one spot |
    /// | `bar-too-short` | two corners of a handle on one spot |
    /// | `bars-overlap` | bars or polygons that run along one another |
    /// | `on-held-boundary` | a handle where nothing may move |
    /// | `too-many-handles` | more handles than can be solved |
    /// | `too-many-corners` | more corners of bars and polygons than can be solved |
    /// | `too-many-sites` | a scene that needs more sites than there may be |
    /// | `unsupported` | what a point cloud cannot have |
    /// | `pose` | handles that are not those that were solved, a pose beyond what can be computed, or one of another solution |
    /// | `point-outside` | a point outside the domain |
    /// | `mesh` | a mesh that is none |
    /// | `cloud` | a point cloud that is none |
    /// | `poser` | bytes that are no poser |
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Project(_) => "project",
            Self::PictureSide { .. } | Self::PictureArea { .. } | Self::PictureBytes { .. } => "picture",
            Self::Scale { .. } => "scale",
            Self::Canvas { .. } => "canvas",
            Self::PictureMismatch { .. } => "picture-mismatch",
            Self::NothingOpaque { .. } | Self::OnlySpecks { .. } => "nothing-opaque",
            Self::RingOutsidePicture { .. }
            | Self::RingPoint { .. }
            | Self::RingDuplicate { .. }
            | Self::RingFlat { .. }
            | Self::RingsCross { .. }
            | Self::OutlineTooFine { .. }
            | Self::RingsTooFine { .. } => "domain",
            Self::HandleOutside { .. } => "handle-outside",
            Self::HandlesTooClose { .. } => "handles-too-close",
            Self::BarTooShort { .. } => "bar-too-short",
            Self::BarsOverlap { .. } => "bars-overlap",
            Self::OnHeldBoundary { .. } => "on-held-boundary",
            Self::TooManyHandles { .. } => "too-many-handles",
            Self::TooManyCorners { .. } => "too-many-corners",
            Self::Unsupported { .. } => "unsupported",
            Self::PoseMismatch { .. }
            | Self::PoseMissing { .. }
            | Self::PoseOfAnother
            | Self::PoseShape { .. }
            | Self::PoseNotFinite { .. } => "pose",
            Self::PointOutside { .. } => "point-outside",
            Self::TooManySites => "too-many-sites",
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

    /// Ids of the handles that the text names, in its order.
    #[must_use]
    pub fn handles(&self) -> Vec<&str> {
        match self {
            Self::HandleOutside { id, .. }
            | Self::BarTooShort { id, .. }
            | Self::OnHeldBoundary { id }
            | Self::TooManyHandles { id, .. }
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

    #[test]
    fn the_table_of_codes_has_every_code_and_no_other() {
        let this = include_str!("error.rs");
        let (_, code) = this.split_once("pub fn code").unwrap();
        let (code, _) = code.split_once("#[cfg(test)]").unwrap();
        let codes: BTreeSet<&str> = code.split('"').skip(1).step_by(2).collect();
        let rows = this.lines().filter_map(|line| line.trim().strip_prefix("/// | `")?.split('`').next());
        let listed: BTreeSet<&str> = rows.collect();
        assert_eq!(codes, listed);
        assert!(codes.contains("pose"));
    }
}
