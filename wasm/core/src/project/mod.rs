//! The project file, `*.c2warp.json`: a picture, the part of it that bends, and the handles that bend it.
//!
//! The only definition of the format. The JSON schema and the TypeScript types are generated from the types here; their
//! ranges are enforced by [`Project::check`]. Reading is strict: an unknown key, a key given twice, a value of the wrong type or
//! out of range, and a later version of the format are refused with the path of the offending key. Writing writes every key, so
//! that a file states everything that its picture depends on.
//!
//! A project is checked here as far as possible without the picture, whether it was read or made in code: whether a handle lies
//! in the domain is checked by the solver.
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
//! // What is left out has its default, and is written.
//! assert_eq!((project.samples, project.fix_boundary), (10_000, false));
//! assert_eq!(Project::from_json(&project.to_json())?, project);
//! // What is wrong is told by its key.
//! let error = Project::for_picture(640, 480).with_handles([Handle::point("", [0.0, 0.0])]).check().unwrap_err();
//! assert_eq!(error.to_string(), "handles[0].id: expected a name, found an empty text");
//! # Ok::<(), c2warp::project::ProjectError>(())
//! ```

mod cursor;
mod domain;
mod error;
mod form;
mod handle;
mod image;
mod layout;
mod path;
mod points;
mod pose;
mod rotation;
mod rules;
#[cfg(test)]
mod tests;
mod value;
mod weighting;

use std::ops::RangeInclusive;

use schemars::{JsonSchema, Schema};
use serde::Serialize;

pub use self::domain::DomainSpec;
pub use self::error::ProjectError;
pub use self::form::Form;
pub use self::handle::{Handle, Shape};
pub use self::image::ImageRef;
pub use self::pose::{Blend, PoseMode, PoseSpec};
pub use self::rotation::Rotation;
pub use self::weighting::{Filling, Support, Weighting};

use self::cursor::Cursor;
use self::layout::Layout;
use self::path::Path;
use self::value::Value;

/// With fewer samples cells would be poorly resolved.
const LEAST_SAMPLES: u32 = 100;
/// With more, mesh and weights exceed the memory of a browser tab.
const MOST_SAMPLES: u32 = 2_000_000;
const SAMPLES: RangeInclusive<u32> = LEAST_SAMPLES..=MOST_SAMPLES;

/// A warp: a picture, the part of it that bends, and the handles that bend it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct Project {
    /// The version of the format.
    pub format: Format,
    /// The picture.
    pub image: ImageRef,
    /// The part of the picture that bends; left out: where the picture is opaque if it has transparency, else all of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "DomainSpec", default, transform = left_out)]
    pub domain: Option<DomainSpec>,
    /// How many samples the domain gets, about: from 100 to 2,000,000.
    #[schemars(default = "default_samples", range(min = LEAST_SAMPLES, max = MOST_SAMPLES))]
    pub samples: u32,
    /// How far a handle reaches and how its weight falls off.
    #[schemars(default)]
    pub weighting: Weighting,
    /// How a pose is made from the handles.
    #[schemars(default)]
    pub pose: PoseSpec,
    /// Whether the rim of the picture stays where it is.
    #[schemars(default)]
    pub fix_boundary: bool,
    /// The handles; the order has no meaning.
    pub handles: Vec<Handle>,
}

/// The version of the format.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[non_exhaustive]
pub enum Format {
    /// The first, and so far the only one.
    #[default]
    #[serde(rename = "c2warp/1")]
    V1,
}

/// For a key whose default depends on other keys: removes the default of the schema, which would not be a valid value.
fn left_out(schema: &mut Schema) {
    schema.remove("default");
}

fn default_samples() -> u32 {
    10_000
}

impl Project {
    /// A project without handles for a picture of this size that has no name, with the format's defaults, which are the paper's.
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

    /// The same project with the editor's settings for new projects: rigid mode, at least 100 virtual sites, smooth supports, and
    /// automatic rotations for points that have none. What is dragged keeps its shape, and what is far from it stays.
    ///
    /// Handles that are added later keep the rotation that they come with: add them first, or as [`turned`](Handle::turned) by
    /// [`Rotation::Auto`].
    #[must_use]
    pub fn bent_rigidly(mut self) -> Self {
        // As `web/src/document/bending.ts` has them.
        self.weighting.support = Support::Smooth;
        self.pose = PoseSpec { mode: PoseMode::Rigid, density: 100, ..self.pose };
        for handle in &mut self.handles {
            if matches!(handle.shape, Shape::Point { .. }) && handle.rotation == Rotation::default() {
                handle.rotation = Rotation::Auto;
            }
        }
        self
    }

    /// A project without handles and with the format's defaults.
    #[must_use]
    pub fn new(image: ImageRef) -> Self {
        Self {
            format: Format::default(),
            image,
            domain: None,
            samples: default_samples(),
            weighting: Weighting::default(),
            pose: PoseSpec::default(),
            fix_boundary: false,
            handles: Vec::new(),
        }
    }

    /// Reads a project file.
    ///
    /// # Errors
    /// Any deviation from the format, with the path of the offending key.
    pub fn from_json(text: &str) -> Result<Self, ProjectError> {
        let value = Value::parse(text)?;
        let top = Cursor::top(&value);
        let project = top.object()?;
        // Checked first, since a later version may have unknown keys.
        let format = project.required("format").and_then(Format::read)?;
        project.only(&["format", "image", "domain", "samples", "weighting", "pose", "fix_boundary", "handles"])?;
        let project = Self {
            format,
            image: project.required("image").and_then(ImageRef::read)?,
            domain: project.optional("domain").map(DomainSpec::read).transpose()?,
            samples: project.or("samples", default_samples(), |value| value.whole_number(&SAMPLES))?,
            weighting: project.or("weighting", Weighting::default(), Weighting::read)?,
            pose: project.or("pose", PoseSpec::default(), PoseSpec::read)?,
            fix_boundary: project.or("fix_boundary", false, |value| value.bool())?,
            handles: project.required("handles").and_then(handles)?,
        };
        project.check()?;
        Ok(project)
    }

    /// Checks that a file may hold the project: reading calls this, and so does everything that solves a project.
    ///
    /// # Errors
    /// The first number out of range or not finite, line with too few points, or id that is empty or given twice, with the path of
    /// its key.
    pub fn check(&self) -> Result<(), ProjectError> {
        let Self { format: Format::V1, image, domain, samples, weighting, pose, fix_boundary: _, handles } = self;
        image.check(&Path::Top.key("image"))?;
        domain.as_ref().map_or(Ok(()), DomainSpec::check)?;
        rules::whole_number(&Path::Top.key("samples"), *samples, &SAMPLES)?;
        weighting.check(&Path::Top.key("weighting"))?;
        pose.check(&Path::Top.key("pose"))?;
        check_handles(handles)
    }

    /// Writes the project with every key that has a value. Reading the text returns an equal project if [`check`](Self::check)
    /// accepts it, and may refuse it otherwise.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut text = Vec::new();
        self.serialize(&mut serde_json::Serializer::with_formatter(&mut text, Layout::default()))
            .expect("a project has text keys only and is written to memory");
        text.push(b'\n');
        String::from_utf8(text).expect("JSON is UTF-8")
    }
}

/// Reads a list of handles as under `handles` in a project, for a pose that changes nothing else.
///
/// # Errors
/// As [`Project::from_json`], with paths that begin at the list: `[2].rest[0]`.
pub fn handles_from_json(text: &str) -> Result<Vec<Handle>, ProjectError> {
    let handles = handles(Cursor::top(&Value::parse(text)?))?;
    handle::check(&handles, &Path::Top)?;
    Ok(handles)
}

/// Checks the handles of a project.
pub(crate) fn check_handles(handles: &[Handle]) -> Result<(), ProjectError> {
    handle::check(handles, &Path::Top.key("handles"))
}

fn handles(value: Cursor<'_>) -> Result<Vec<Handle>, ProjectError> {
    value.list("a list of handles", Handle::read)
}

impl Format {
    fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        match value.text()? {
            "c2warp/1" => Ok(Self::V1),
            other => value.refuse(format_args!("expected \"c2warp/1\", found {other:?}")),
        }
    }
}
