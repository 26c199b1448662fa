//! All errors of the crate, in one enum. A message states the problem, its place, and a remedy.

mod code;

use crate::{
    display_name::DisplayName,
    display_number::DisplayNumber,
    limits,
    project::{ProjectError, ShapeKind},
};

/// Why a picture, a domain, a project or a handle was rejected.
///
/// [`Error::code`] is stable and meant for programs. The `Display` text is one sentence for people.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The project breaks the rules of the format. See [`Project::check`](crate::project::Project::check).
    #[error(transparent)]
    Project(#[from] ProjectError),
    /// A side of the picture is too short or too long.
    #[error(
        "the picture is {width}×{height} px, but each side must be from {min} to {max} px: scale it first",
        min = limits::MIN_SIDE,
        max = limits::MAX_SIDE
    )]
    PictureSide {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The picture has too many pixels.
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
    /// The number of bytes does not match the size of the picture.
    #[error("a picture of {width}×{height} px needs {expected} bytes of RGBA, but has {found}")]
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
    /// The result would have no pixel, or too many.
    #[error(
        "a picture of {width}×{height} px cannot be warped at a scale of {scale:?}: each side of the result must have \
         1 to {side} px, and all of it at most {area} megapixels",
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
    /// The warped picture is too large to be drawn as a whole.
    #[error(
        "the whole warped picture would have {width}×{height} px, more than {side} px a side or {area} megapixels: \
         lower the scale, or keep the frame of the original",
        side = limits::MAX_SIDE,
        area = limits::MAX_PIXELS / 1_000_000
    )]
    Canvas {
        /// Width in pixels.
        width: u64,
        /// Height in pixels.
        height: u64,
    },
    /// No pixel of the warped picture has opacity, so its covered part is empty.
    #[error("nothing is drawn: no pixel of the warped picture has opacity")]
    NothingDrawn,
    /// The project is for a picture of another size.
    #[error("the project is for a picture of {project_width}×{project_height} px, but this one is {width}×{height} px")]
    PictureMismatch {
        /// Width in the project.
        project_width: u32,
        /// Height in the project.
        project_height: u32,
        /// Width of the picture.
        width: u32,
        /// Height of the picture.
        height: u32,
    },
    /// A picture without transparency has no outline to align with.
    #[error("the picture has no transparent part, so it has no outline to align with: fit its rectangle instead")]
    NoOutline,
    /// No pixel reaches the threshold.
    #[error(
        "no pixel of the picture is opaque at the threshold {}: lower domain.threshold, or warp the whole image",
        DisplayNumber(*threshold)
    )]
    NothingOpaque {
        /// The alpha threshold, in (0, 1].
        threshold: f64,
    },
    /// The domain covers the whole picture.
    #[error(
        "the domain covers the whole picture and leaves nothing to fill it from: draw smaller domain.rings, or remove \
         fill"
    )]
    NothingToFillFrom,
    /// Only specks reach the threshold.
    #[error(
        "only {specks} specks of the picture are opaque at the threshold {}: lower domain.threshold, or warp the whole image",
        DisplayNumber(*threshold)
    )]
    OnlySpecks {
        /// The alpha threshold, in (0, 1].
        threshold: f64,
        /// Number of regions that were too small to keep.
        specks: usize,
    },
    /// A point of a ring is outside the picture.
    #[error(
        "domain.rings[{ring}][{point}] = ({}, {}) lies outside the picture of {width}×{height} px: move it inside",
        DisplayNumber(*.x),
        DisplayNumber(*.y)
    )]
    RingOutsidePicture {
        /// Index of the ring.
        ring: usize,
        /// Index of the point.
        point: usize,
        /// x of the point, in pixels.
        x: f64,
        /// y of the point, in pixels.
        y: f64,
        /// Width of the picture.
        width: u32,
        /// Height of the picture.
        height: u32,
    },
    /// A coordinate of a ring is too large.
    #[error("domain.rings[{ring}][{point}] must have coordinates from −{max} to {max}",
        max = limits::MAX_COORDINATE)]
    RingPoint {
        /// Index of the ring.
        ring: usize,
        /// Index of the point.
        point: usize,
    },
    /// Two points of the rings coincide.
    #[error(
        "domain.rings[{ring}][{point}] coincides with domain.rings[{other_ring}][{other_point}]: move or remove one of them"
    )]
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
    /// A ring encloses no area.
    #[error("domain.rings[{ring}] encloses no area: remove it, or move its points apart")]
    RingFlat {
        /// Index of the ring.
        ring: usize,
    },
    /// Two edges of the rings cross or touch.
    #[error(
        "the edge after domain.rings[{ring}][{point}] crosses or touches the edge after \
         domain.rings[{other_ring}][{other_point}]: move one of them"
    )]
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
    /// The rings have too many corners to be solved in reasonable time.
    #[error("domain.rings have {corners} points, but at most {max} are supported: draw the rings with fewer points",
        max = limits::MAX_CORNERS)]
    RingsTooFine {
        /// Number of points of all rings.
        corners: usize,
    },
    /// A handle is outside the domain.
    #[error(
        "handle “{id}” at ({}, {}) lies outside the domain: place it on the picture's opaque part",
        DisplayNumber(*.x),
        DisplayNumber(*.y),
        id = DisplayName(.id)
    )]
    HandleOutside {
        /// Id of the handle.
        id: String,
        /// x of the handle at rest, in pixels.
        x: f64,
        /// y of the handle at rest, in pixels.
        y: f64,
    },
    /// A handle lies too far outside the outline of another picture.
    #[error(
        "handle “{id}” would lie {:.0} px outside the outline of this picture, but is moved by at most {:.0} px: fit \
         the project in another way, or move the handle first",
        .distance,
        .most,
        id = DisplayName(.id)
    )]
    HandleFarOutside {
        /// Id of the handle.
        id: String,
        /// Distance of the handle from the domain, in pixels.
        distance: f64,
        /// Maximum distance that a handle is moved, in pixels.
        most: f64,
    },
    /// Two handles coincide.
    #[error("handles “{first}” and “{second}” are less than {min} px apart: move or delete one of them",
        min = limits::MIN_SEPARATION, first = DisplayName(.first), second = DisplayName(.second))]
    HandlesTooClose {
        /// Id of one handle.
        first: String,
        /// Id of the other.
        second: String,
        /// Their straight distance, in pixels.
        distance: f64,
    },
    /// Two corners of a bar or polygon coincide.
    #[error("corner {corner} of handle “{id}” coincides with the next corner: move or delete one of them",
        id = DisplayName(.id))]
    BarTooShort {
        /// Id of the handle.
        id: String,
        /// Index of the corner.
        corner: usize,
    },
    /// Bars or polygons run along each other.
    #[error("{}: bars and polygons may cross and touch, but not overlap", overlap(.first, .second))]
    BarsOverlap {
        /// Id of one handle.
        first: String,
        /// Id of the other: the same if a handle overlaps itself.
        second: String,
    },
    /// A handle is on a fixed boundary.
    #[error(
        "handle “{id}” is on the fixed boundary: move it at least {min} px inside, or set fix_boundary to false",
        min = limits::HELD_CLEARANCE,
        id = DisplayName(.id)
    )]
    OnHeldBoundary {
        /// Id of the handle.
        id: String,
    },
    /// The project has too many handles.
    #[error("the project has {count} handles, but at most {max} are supported: “{id}” is the first one above the limit",
        max = limits::MAX_HANDLES, id = DisplayName(.id))]
    TooManyHandles {
        /// Number of handles.
        count: usize,
        /// Id of the first handle beyond the limit.
        id: String,
    },
    /// Too many point handles are close to another handle.
    #[error(
        "{count} point handles are less than {within:.3} px from another, but at most {max} are supported: move some \
         of them apart, such as “{id}”",
        id = DisplayName(.id)
    )]
    HandlesCrowded {
        /// Number of such handles.
        count: usize,
        /// The distance that counts as close, in pixels.
        within: f64,
        /// Maximum number of such handles.
        max: usize,
        /// Id of the first of them.
        id: String,
    },
    /// An outline is too long for its size.
    #[error(
        "the outline is {length:.0} px long, but at most {max:.0} px are supported for its size: draw it with fewer slits \
         and spikes"
    )]
    OutlineTooLong {
        /// Its length, in pixels.
        length: f64,
        /// Maximum length, in pixels.
        max: f64,
    },
    /// Bars and polygons have too many segments.
    #[error(
        "the bars and polygons have {segments} segments, but at most {max} are supported: handle “{id}” has {corners} \
         corners, draw it with fewer",
        max = limits::MAX_SITES,
        id = DisplayName(.id)
    )]
    TooManyCorners {
        /// Id of the handle with the most corners.
        id: String,
        /// Number of corners of that handle.
        corners: usize,
        /// Number of segments of all handles.
        segments: usize,
    },
    /// A kind of handle, or a setting, is not supported.
    #[error("{path}: {feature} is not supported")]
    Unsupported {
        /// Path of the key in the project.
        path: String,
        /// The requested feature.
        feature: String,
    },
    /// The pose has more or fewer handles than the solution.
    #[error("the pose has {found} handles, but the solution has {expected}: pass every handle of the solution")]
    PoseMismatch {
        /// Number of handles of the solution.
        expected: usize,
        /// Number of handles of the pose.
        found: usize,
    },
    /// The pose lacks a handle of the solution.
    #[error("the pose lacks handle “{id}” of the solution: pass every handle of the solution",
        id = DisplayName(.id))]
    PoseMissing {
        /// Id of the handle.
        id: String,
    },
    /// The pose belongs to another solution.
    #[error("the pose belongs to another solution: use the poser of this solution")]
    PoseOfAnotherSolution,
    /// A posed handle has another kind or number of corners than the solved one.
    #[error("handle “{id}” is posed as {posed}, but was solved as {solved}", id = DisplayName(.id))]
    PoseShape {
        /// Id of the handle.
        id: String,
        /// Kind of the solved handle.
        solved: ShapeKind,
        /// Kind of the posed handle.
        posed: ShapeKind,
    },
    /// Numbers of the pose overflow.
    #[error("the pose of handle “{id}” has numbers that are too large: move it closer, or lower its scale",
        id = DisplayName(.id))]
    PoseNotFinite {
        /// Id of the handle.
        id: String,
    },
    /// The frame rate of a film is zero or too high.
    #[error("expected a frame rate above 0 and up to {max}, found {}", DisplayNumber(*rate),
        max = limits::MAX_FRAME_RATE)]
    FrameRate {
        /// Frames per second.
        rate: f64,
    },
    /// The part of a clip for a film is empty, or extends beyond the clip.
    #[error(
        "clip “{clip}”: expected a range within 0 to {} seconds that ends after it begins, found {}..{}",
        DisplayNumber(*duration),
        DisplayNumber(*from),
        DisplayNumber(*to),
        clip = DisplayName(.clip)
    )]
    FrameRange {
        /// Name of the clip.
        clip: String,
        /// Beginning of the part, in seconds.
        from: f64,
        /// End of the part, in seconds.
        to: f64,
        /// Length of the clip, in seconds.
        duration: f64,
    },
    /// A film has too many frames.
    #[error(
        "a film of clip “{clip}” would have {frames} frames, but at most {max} are supported: lower the frame rate, or \
         show a part of the clip",
        max = limits::MAX_FRAMES,
        clip = DisplayName(.clip)
    )]
    TooManyFrames {
        /// Name of the clip.
        clip: String,
        /// Number of frames.
        frames: f64,
    },
    /// A point is outside the domain.
    #[error("the point ({}, {}) lies outside the domain", DisplayNumber(*.x), DisplayNumber(*.y))]
    PointOutside {
        /// x of the point, in pixels.
        x: f64,
        /// y of the point, in pixels.
        y: f64,
    },
    /// The scene needs too many sites.
    ///
    /// Handles close to one another or to a fixed boundary need many sites, and so do bars, polygons and a high
    /// density.
    #[error(
        "the scene needs more than {max} sites: move close handles apart, use fewer or shorter bars and polygons, or \
         lower pose.density",
        max = limits::MAX_SITES
    )]
    TooManySites,
    /// The distances of all sites need too much memory.
    ///
    /// An outline with many corners needs much memory for each site.
    #[error(
        "the scene is too large for the memory of a browser: use fewer bars, polygons or handles, simplify the \
         outline, or lower pose.density"
    )]
    TooMuchMemory,
    /// Algorithm 1 takes too many steps: hundreds of cells meet in one place, or an outline has parts too narrow for
    /// sites.
    #[error(
        "the scene takes more than {max} steps to solve: use fewer bars, polygons or handles, simplify the outline, or \
         lower pose.density",
        max = limits::MAX_STEPS
    )]
    TooMuchWork,
    /// A fixed boundary has too many sharp corners.
    #[error(
        "the fixed boundary has {corners} sharp corners, but at most {max} are supported: draw it with fewer, or set \
         fix_boundary to false",
        max = limits::MAX_HELD_CORNERS
    )]
    HeldTooFine {
        /// Number of sharp corners.
        corners: usize,
    },
    /// A triangle of a mesh has invalid vertices.
    #[error("triangle {triangle} of the mesh must have three different vertices of the {vertices} in the mesh")]
    MeshTriangle {
        /// Index of the triangle.
        triangle: usize,
        /// Number of vertices.
        vertices: usize,
    },
    /// The boundary of a mesh has too many corners to be solved in reasonable time.
    #[error(
        "the boundary of the mesh has {corners} corners, but at most {max} are supported: use a mesh with a simpler boundary",
        max = limits::MAX_CORNERS)]
    MeshTooFine {
        /// Number of vertices where the boundary turns.
        corners: usize,
    },
    /// A mesh has no triangles.
    #[error("the mesh has no triangles: give at least one")]
    MeshEmpty,
    /// A coordinate of a mesh is not finite, or too large.
    #[error("vertex {vertex} of the mesh must have coordinates from −{max} to {max}",
        max = limits::MAX_COORDINATE)]
    MeshVertex {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A vertex of a mesh belongs to no triangle.
    #[error("vertex {vertex} of the mesh belongs to no triangle: remove it")]
    MeshVertexLoose {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A triangle of a mesh has no area.
    #[error("triangle {triangle} of the mesh has no area: remove it")]
    MeshTriangleFlat {
        /// Index of the triangle.
        triangle: usize,
    },
    /// Two triangles are on the same side of an edge: they overlap, or more than two share the edge.
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
    /// Parts of a mesh share a vertex, but no edge.
    #[error(
        "the outline of the mesh passes vertex {vertex} more than once: give each part its own vertex, apart from the others"
    )]
    MeshPinched {
        /// Index of the vertex.
        vertex: usize,
    },
    /// The outline of a mesh crosses or touches itself.
    #[error("the outline of the mesh at vertex {vertex} crosses or touches itself at vertex {other}")]
    MeshCrosses {
        /// Index of a vertex on the outline: the first end of an edge, or a point.
        vertex: usize,
        /// Index of the vertex of the other edge, or of the same point.
        other: usize,
    },
    /// A part of a mesh overlaps another part.
    #[error("the part of the mesh with vertex {vertex} overlaps another part")]
    MeshCovered {
        /// Index of a vertex on the outline of the part.
        vertex: usize,
    },
    /// The number of neighbours is invalid for the number of points of a cloud.
    #[error(
        "a cloud of {points} points cannot have {neighbours} neighbours per point: use at least 1, and fewer than the \
         number of points"
    )]
    CloudNeighbours {
        /// Number of points.
        points: usize,
        /// Requested number of neighbours.
        neighbours: usize,
    },
    /// A coordinate of a cloud is not finite, or too large.
    #[error("point {point} of the cloud must have coordinates from −{max} to {max}",
        max = limits::MAX_COORDINATE)]
    CloudPoint {
        /// Index of the point.
        point: usize,
    },
    /// Two points of a cloud coincide.
    #[error("point {point} of the cloud coincides with point {other}: remove one of them")]
    CloudDuplicate {
        /// Index of the point.
        point: usize,
        /// Index of the other point.
        other: usize,
    },
    /// Bytes do not hold a poser of this version.
    #[error("the bytes do not hold a poser of this version: write the poser again")]
    PoserBytes,
}

/// Names the handles of an overlap for a message.
fn overlap(first: &str, second: &str) -> String {
    if first == second {
        format!("handle “{}” runs along itself", DisplayName(first))
    } else {
        format!("handles “{}” and “{}” run along each other", DisplayName(first), DisplayName(second))
    }
}
