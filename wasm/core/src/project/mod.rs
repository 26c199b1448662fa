//! The project file, `*.c2warp.json`: a picture, the part of it to warp, the handles, and clips that move them.
//!
//! This is the only definition of the format. The JSON schema and the TypeScript types are generated from these types.
//!
//! Reading is strict. Unknown and duplicate keys, wrong types, values out of range and later versions of the format are
//! rejected with the path of the offending key. Writing writes every key: the file then states all settings.
//!
//! [`Project::check`] enforces the rules of the format, for projects from files and from code. The solver checks rules
//! that depend on the picture: for example, that handles lie in the domain.
//!
//! ```
//! use c2warp::project::{Handle, Project};
//!
//! let project = Project::from_json(r#"{
//!     "format": "c2warp/1",
//!     "image": { "src": "cat.png", "width": 640, "height": 480 },
//!     "handles": [{ "id": "tail", "kind": "point", "rest": [520, 300], "posed": [560, 260], "rotation": -20 }]
//! }"#)?;
//! let tail = Handle::point("tail", [520.0, 300.0]).posed_at([[560.0, 260.0]]).turned(-20.0);
//! assert_eq!(project.handles, [tail]);
//! // A key that is left out has its default, and is written.
//! assert_eq!((project.samples, project.fix_boundary), (10_000, false));
//! assert_eq!(Project::from_json(&project.to_json())?, project);
//! // An error names the offending key.
//! let error = Project::for_picture(640, 480).with_handles([Handle::point("", [0.0, 0.0])]).check().unwrap_err();
//! assert_eq!(error.to_string(), "handles[0].id: expected a name, found an empty string");
//! # Ok::<(), c2warp::project::ProjectError>(())
//! ```

mod clip;
mod displacement;
mod domain;
mod error;
mod fill;
mod format;
mod handle;
mod image;
#[cfg(feature = "serde")]
mod json;
mod loose_parts;
mod mapped;
mod path;
#[cfg(feature = "serde")]
mod points;
mod pose;
mod rotation;
#[cfg(feature = "schema")]
mod schema;
mod shape;
mod shape_kind;
mod shape_sample;
mod spline;
mod stiffness;
#[cfg(test)]
mod tests;
mod validate;
mod weighting;

use std::ops::RangeInclusive;

pub use self::clip::{Clip, Ease, Key, Looping, Track};
pub use self::displacement::Displacement;
pub use self::domain::DomainSpec;
pub use self::error::ProjectError;
pub use self::fill::{FillMethod, FillSpec};
pub use self::format::Format;
pub use self::handle::Handle;
pub use self::image::ImageRef;
#[cfg(feature = "serde")]
pub use self::json::{clip_from_json, handles_from_json};
pub use self::loose_parts::LooseParts;
pub use self::pose::{Blend, PoseMode, PoseSpec};
pub use self::rotation::Rotation;
pub use self::shape::Shape;
pub use self::shape_kind::ShapeKind;
pub use self::shape_sample::ShapeSample;
pub(crate) use self::shape_sample::check as check_shape;
pub(crate) use self::spline::Spline;
pub use self::stiffness::Stiffness;
pub(crate) use self::stiffness::bilinear;
pub use self::weighting::{Continuity, Filling, Support, Weighting};

use self::path::Path;

/// With fewer samples, cells would be poorly resolved.
const LEAST_SAMPLES: u32 = 100;
/// With more samples, mesh and weights exceed the memory of a browser tab.
const MOST_SAMPLES: u32 = 2_000_000;
const SAMPLES: RangeInclusive<u32> = LEAST_SAMPLES..=MOST_SAMPLES;

/// A warp: a picture, the part of it to warp, and the handles.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Project {
    /// The version of the format.
    pub format: Format,
    /// The picture.
    pub image: ImageRef,
    /// The part of the picture to warp. The default is the opaque part of a picture with transparency, and all of any
    /// other.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "schema", schemars(with = "DomainSpec", default, transform = self::schema::without_default))]
    pub domain: Option<DomainSpec>,
    /// How the picture behind a domain of rings is filled. Without it, a part that moves away leaves a gap. Other
    /// domains have nothing behind them, and ignore it.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "schema", schemars(with = "FillSpec", default, transform = self::schema::without_default))]
    pub fill: Option<FillSpec>,
    /// Approximate number of samples, from 100 to 2,000,000.
    #[cfg_attr(feature = "schema", schemars(default = "default_samples", range(min = LEAST_SAMPLES, max = MOST_SAMPLES)))]
    pub samples: u32,
    /// Settings of the weights.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub weighting: Weighting,
    /// Settings of the pose.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub pose: PoseSpec,
    /// Whether the boundary of the domain stays in place.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub fix_boundary: bool,
    /// Whether parts of the picture cast a thin dark edge on the parts that they cross.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub edges: bool,
    /// How connected parts of the domain without a handle move.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub loose_parts: LooseParts,
    /// The handles. Their order has no meaning.
    pub handles: Vec<Handle>,
    /// Poses of handles over time.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    #[cfg_attr(feature = "schema", schemars(default))]
    pub clips: Vec<Clip>,
    /// How stiff the picture is, as a grid over it: distortion counts more where it is stiff. It affects only rigid
    /// mode. The default is a picture without stiff places.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "schema", schemars(with = "Stiffness", default, transform = self::schema::without_default))]
    pub stiffness: Option<Stiffness>,
    /// How a brush has moved places of the picture at rest, before the handles pose them: a displacement field. The
    /// default is a picture that no brush has moved.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "schema", schemars(with = "Displacement", default, transform = self::schema::without_default))]
    pub displacement: Option<Displacement>,
    /// The shape in which a drag has left the picture, as up to 64 samples: eight numbers for each. They are x and y at
    /// rest, x and y posed, and the linear part of the map there: its images of (1, 0) and (0, 1). In rigid mode, the
    /// same handles allow several shapes at rest, and the picture takes the one near the samples. The default is the
    /// shape that depends on the handles alone.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<[f64; 8]>", default, length(max = self::shape_sample::MOST_SAMPLES)))]
    pub shape: Vec<ShapeSample>,
}

fn default_samples() -> u32 {
    10_000
}

impl Project {
    /// A project without handles for a picture of a size in pixels, without a file name.
    ///
    /// Settings have the defaults of the format. These are the paper's.
    #[must_use]
    pub fn for_picture(width: u32, height: u32) -> Self {
        Self::new(ImageRef::new("", width, height))
    }

    /// The same project with these handles instead of its own.
    #[must_use]
    pub fn with_handles(mut self, handles: impl IntoIterator<Item = Handle>) -> Self {
        self.handles = handles.into_iter().collect();
        self
    }

    /// The same project with these clips instead of its own.
    #[must_use]
    pub fn with_clips(mut self, clips: impl IntoIterator<Item = Clip>) -> Self {
        self.clips = clips.into_iter().collect();
        self
    }

    /// The same project with the editor's settings for new projects.
    ///
    /// They are rigid mode, at least 150 virtual sites, smooth supports, edges where parts cross, and automatic
    /// rotations for points without rotation. Dragged parts then keep their shape, and distant parts stay.
    ///
    /// Add handles first: later ones keep their own rotation. Or add them as [`turned`](Handle::turned) by
    /// [`Rotation::Auto`].
    #[must_use]
    pub fn with_editor_settings(mut self) -> Self {
        self.weighting.support = Support::Smooth;
        self.pose = PoseSpec { mode: PoseMode::Rigid, density: 150, ..self.pose };
        self.edges = true;
        for handle in &mut self.handles {
            if matches!(handle.shape, Shape::Point { .. }) && handle.rotation == Rotation::default() {
                handle.rotation = Rotation::Auto;
            }
        }
        self
    }

    /// A project without handles, with the defaults of the format.
    #[must_use]
    pub fn new(image: ImageRef) -> Self {
        Self {
            format: Format::default(),
            image,
            domain: None,
            fill: None,
            samples: default_samples(),
            weighting: Weighting::default(),
            pose: PoseSpec::default(),
            fix_boundary: false,
            edges: false,
            loose_parts: LooseParts::default(),
            handles: Vec::new(),
            clips: Vec::new(),
            stiffness: None,
            displacement: None,
            shape: Vec::new(),
        }
    }

    /// Checks the project against the rules of the format. Reading a file and solving a project call it.
    ///
    /// # Errors
    /// For the first number out of range or not finite, bar or polygon with too few points, empty or duplicate id,
    /// track without a handle, mask or displacement whose size and values differ, and shape with too many samples.
    pub fn check(&self) -> Result<(), ProjectError> {
        let Self { format: Format::V1, image, domain, samples, weighting, pose, handles, clips, .. } = self;
        image.check(&Path::Top.key("image"))?;
        domain.as_ref().map_or(Ok(()), DomainSpec::check)?;
        validate::whole_number(&Path::Top.key("samples"), *samples, &SAMPLES)?;
        weighting.check(&Path::Top.key("weighting"))?;
        pose.check(&Path::Top.key("pose"))?;
        check_handles(handles)?;
        clip::check(clips, handles)?;
        self.stiffness.as_ref().map_or(Ok(()), |stiffness| stiffness.check(&Path::Top.key("stiffness")))?;
        self.displacement.as_ref().map_or(Ok(()), Displacement::check)?;
        check_shape(&self.shape)
    }
}

/// Checks the handles of a project.
pub(crate) fn check_handles(handles: &[Handle]) -> Result<(), ProjectError> {
    handle::check(handles, &Path::Top.key("handles"))
}
