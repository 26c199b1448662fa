//! A temporary folder with a scene, one per test.

use std::fs;
use std::path::{Path, PathBuf};

use c2warp::project::Displacement;
use image::RgbaImage;
use serde_json::Value;
use tempfile::TempDir;

use c2warp_tests::pictures;

/// Name of the project file in each folder.
pub(crate) const PROJECT: &str = "scene.c2warp.json";

/// A temporary folder with a project and its picture.
pub(crate) struct SceneFolder {
    folder: TempDir,
    project: Value,
}

impl SceneFolder {
    /// Copies `scenes/SCENE.c2warp.json` and draws its picture.
    pub(crate) fn new(scene: &str) -> Self {
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
        let text = fs::read_to_string(scenes.join(scene).with_extension("c2warp.json")).unwrap();
        let folder = Self { folder: TempDir::new().unwrap(), project: serde_json::from_str(&text).unwrap() };
        let source = folder.project["image"]["src"].as_str().unwrap();
        pictures::drawn(source).save(folder.file(source)).unwrap();
        folder.write(PROJECT, text);
        folder
    }

    /// Edits the project file by `change`.
    pub(crate) fn edited(mut self, change: impl FnOnce(&mut Value)) -> Self {
        change(&mut self.project);
        self.write(PROJECT, self.project.to_string());
        self
    }

    /// Moves all handles to their rest positions.
    pub(crate) fn at_rest(self) -> Self {
        self.edited(|project| {
            for handle in project["handles"].as_array_mut().unwrap() {
                handle["posed"] = handle["rest"].clone();
                handle["rotation"] = 0.into();
                handle["scale"] = 1.into();
            }
        })
    }

    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, contents: impl AsRef<[u8]>) {
        fs::write(self.file(name), contents).unwrap();
    }

    pub(crate) fn picture(&self, name: &str) -> RgbaImage {
        image::open(self.file(name)).unwrap().into_rgba8()
    }

    /// Returns the names of all files, sorted.
    pub(crate) fn file_names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path()).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

/// The displacement of a picture of 96 px in width: everything moves by 24 px to the right.
pub(crate) fn all_by_24_px() -> Value {
    let displacement = Displacement::new(4, 4, [64, 0].repeat(16));
    serde_json::to_value(displacement).unwrap()
}
