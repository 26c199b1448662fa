//! The rig of a game engine, with its picture.

use std::fmt;

use c2warp::{Picture, project::Project};
use c2warp_export::{EngineRig, Errors, ExportError, Format, Options, texture};
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use js_sys::{Error as JsError, Function};
use wasm_bindgen::prelude::*;

use crate::solution::solution;

/// The completed fraction of the work once the project is solved.
const SOLVED: f64 = 0.2;

/// A file format of an engine.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy)]
pub enum EngineFormat {
    /// Spine JSON 4.2 with an atlas.
    Spine,
    /// DragonBones JSON 5.5 with a texture file.
    DragonBones,
    /// glTF 2.0 binary.
    Gltf,
    /// A scene of Godot 4.
    Godot,
}

/// A format, and the limits of the rig.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy)]
pub struct EngineOptions {
    format: Format,
    options: Options,
}

/// The files of a rig, and its loss.
#[wasm_bindgen]
#[derive(Debug)]
pub struct EngineFiles {
    /// The names and bytes of the files.
    files: Vec<(String, Vec<u8>)>,
    rig: EngineRig,
}

#[wasm_bindgen]
impl EngineOptions {
    /// The maximum number of bones besides the root, of bones that move a vertex, and of vertices.
    #[wasm_bindgen(constructor)]
    pub fn new(format: EngineFormat, bones: usize, influences: usize, vertices: usize) -> Self {
        let format = match format {
            EngineFormat::Spine => Format::Spine,
            EngineFormat::DragonBones => Format::DragonBones,
            EngineFormat::Gltf => Format::Gltf,
            EngineFormat::Godot => Format::Godot,
        };
        Self { format, options: Options { bones, influences, vertices } }
    }
}

#[wasm_bindgen]
impl EngineFiles {
    /// The names of the files, the main one first.
    #[wasm_bindgen(getter)]
    pub fn names(&self) -> Vec<String> {
        self.files.iter().map(|(name, _)| name.clone()).collect()
    }

    /// The bytes of a file.
    pub fn bytes(&self, file: usize) -> Vec<u8> {
        self.files.get(file).map(|(_, bytes)| bytes.clone()).unwrap_or_default()
    }

    /// The numbers of bones besides the root, of sites that they represent, and of vertices.
    #[wasm_bindgen(getter)]
    pub fn sizes(&self) -> Vec<u32> {
        let ((bones, sites), (vertices, _)) = (self.rig.bones(), self.rig.size());
        [bones, sites, vertices].map(|count| count as u32).to_vec()
    }

    /// The largest error and the 99th percentile, in pixels: of vertices in the project's pose, in random poses, and in
    /// each clip, and finally of the picture between vertices.
    #[wasm_bindgen(getter)]
    pub fn errors(&self) -> Vec<f64> {
        let loss = self.rig.loss();
        let clips = loss.clips.iter().map(|(_, errors)| errors);
        let all = [&loss.pose, &loss.random].into_iter().chain(clips).chain([&loss.between]);
        all.flat_map(|&Errors { largest, percentile_99, .. }| [largest, percentile_99]).collect()
    }
}

/// Solves a project, and builds its rig for an engine. `stem` is the stem of the file names.
///
/// `rgba` is straight, rows from top to bottom. `on_progress` receives the completed fraction, from 0 to 1.
///
/// # Errors
/// For a project that cannot be solved with this picture, and for unsuitable options.
#[wasm_bindgen]
pub fn engine_rig(
    project_json: &str,
    width: u32,
    height: u32,
    rgba: &[u8],
    stem: &str,
    EngineOptions { format, options }: EngineOptions,
    on_progress: &Function,
) -> Result<EngineFiles, JsError> {
    let refused = |reason: &dyn fmt::Display| JsError::new(&reason.to_string());
    let not_exported = |reason: ExportError| match reason {
        // Here no option has dashes.
        ExportError::Outline(reason) => refused(&reason),
        reason => refused(&reason),
    };
    let on_progress = |part: f64| {
        // Nothing can be done about a listener that fails.
        let _ = on_progress.call1(&JsValue::NULL, &part.into());
    };
    options.check(format).map_err(not_exported)?;
    let project = Project::from_json(project_json).map_err(|reason| refused(&reason))?;
    let picture = Picture::new(width, height, rgba).map_err(|reason| refused(&reason))?;
    let solution = solution(&project, &picture).map_err(|reason| refused(&reason))?;
    let mut on_rest = |part: f64| on_progress(SOLVED + (1.0 - SOLVED) * part);
    on_rest(0.0);
    let rig = EngineRig::new_with_progress(stem, &project, &solution, &picture, options, &mut on_rest);
    let rig = rig.map_err(not_exported)?;
    let mut png = Vec::new();
    let encoder = PngEncoder::new(&mut png);
    let encoded = encoder.write_image(&texture(&picture), width, height, ExtendedColorType::Rgba8);
    encoded.map_err(|reason| refused(&reason))?;
    let named = |ending: &str| format!("{stem}{ending}");
    let rig_files = rig.files(format, &png).map_err(not_exported)?;
    let mut files: Vec<_> = rig_files.into_iter().map(|file| (named(file.ending), file.bytes)).collect();
    files.extend(format.picture_ending().map(|ending| (named(ending), png)));
    Ok(EngineFiles { files, rig })
}
