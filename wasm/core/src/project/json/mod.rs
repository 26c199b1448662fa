//! The project as JSON: read strictly, and written with every key.

mod clip;
mod cursor;
mod domain;
mod grid_values;
mod grids;
mod handle;
mod layout;
mod settings;
mod shape_sample;
mod value;

use serde::Serialize;

pub(super) use self::clip::posed;
pub(super) use self::grids::{bytes_as_base64, numbers_as_base64};

use self::cursor::Cursor;
use self::layout::Layout;
use self::value::Value;
use super::path::Path;
use super::{
    Clip, Displacement, DomainSpec, FillSpec, Format, Handle, ImageRef, LooseParts, PoseSpec, Project, ProjectError,
    SAMPLES, ShapeSample, Stiffness, Weighting, default_samples, handle as handles, image,
};

/// Whether a value is the default, which files leave out.
pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

impl Project {
    /// Reads a project file.
    ///
    /// # Errors
    /// For any deviation from the format, with the path of the offending key.
    pub fn from_json(text: &str) -> Result<Self, ProjectError> {
        let value = Value::parse(text)?;
        let top = Cursor::top(&value);
        let project = top.object()?;
        // Check the version first: a later one may have unknown keys.
        let format = project.required("format").and_then(Format::read)?;
        project.allow_only(&[
            "format",
            "image",
            "domain",
            "fill",
            "samples",
            "weighting",
            "pose",
            "fix_boundary",
            "edges",
            "loose_parts",
            "handles",
            "clips",
            "stiffness",
            "displacement",
            "shape",
        ])?;
        let project = Self {
            format,
            image: project.required("image").and_then(ImageRef::read)?,
            domain: project.optional("domain").map(DomainSpec::read).transpose()?,
            fill: project.optional("fill").map(FillSpec::read).transpose()?,
            samples: project.value_or("samples", default_samples(), |value| value.whole_number(&SAMPLES))?,
            weighting: project.value_or("weighting", Weighting::default(), Weighting::read)?,
            pose: project.value_or("pose", PoseSpec::default(), PoseSpec::read)?,
            fix_boundary: project.value_or("fix_boundary", false, |value| value.bool())?,
            edges: project.value_or("edges", false, |value| value.bool())?,
            loose_parts: project.value_or("loose_parts", LooseParts::default(), LooseParts::read)?,
            handles: project.required("handles").and_then(read_handles)?,
            clips: project.value_or("clips", Vec::new(), |value| value.list("a list of clips", Clip::read))?,
            stiffness: project.optional("stiffness").map(Stiffness::read).transpose()?,
            displacement: project.optional("displacement").map(Displacement::read).transpose()?,
            shape: project.value_or("shape", Vec::new(), |value| value.list("a list of samples", ShapeSample::read))?,
        };
        project.check()?;
        Ok(project)
    }

    /// Writes the project as JSON, with every key that has a value.
    ///
    /// If [`check`](Self::check) accepts the project, reading the text returns an equal one.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut text = Vec::new();
        self.serialize(&mut serde_json::Serializer::with_formatter(&mut text, Layout::default()))
            .expect("a project has text keys only and is written to memory");
        text.push(b'\n');
        String::from_utf8(text).expect("JSON is UTF-8")
    }
}

impl Format {
    fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        match value.string()? {
            "c2warp/1" => Ok(Self::V1),
            _ => value.expected("\"c2warp/1\""),
        }
    }
}

impl ImageRef {
    fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let image = value.object()?;
        image.allow_only(&["src", "width", "height"])?;
        Ok(Self {
            src: image.required("src")?.string()?.to_owned(),
            width: image.required("width")?.whole_number(&image::SIDES)?,
            height: image.required("height")?.whole_number(&image::SIDES)?,
        })
    }
}

/// Reads a list of handles, as under the key `handles` of a project.
///
/// # Errors
/// The errors of [`Project::from_json`], with paths relative to the list: `[2].rest[0]`.
pub fn handles_from_json(text: &str) -> Result<Vec<Handle>, ProjectError> {
    let handles = read_handles(Cursor::top(&Value::parse(text)?))?;
    handles::check(&handles, &Path::Top)?;
    Ok(handles)
}

/// Reads one clip of these handles, as in the list under the key `clips` of a project.
///
/// # Errors
/// The errors of [`Project::from_json`], with paths relative to the clip: `tracks[0].keys[1].time`.
pub fn clip_from_json(text: &str, handles: &[Handle]) -> Result<Clip, ProjectError> {
    let clip = Clip::read(Cursor::top(&Value::parse(text)?))?;
    clip.check(handles, &Path::Top)?;
    Ok(clip)
}

fn read_handles(value: Cursor<'_>) -> Result<Vec<Handle>, ProjectError> {
    value.list("a list of handles", Handle::read)
}
