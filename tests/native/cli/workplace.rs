//! A folder of its own for every test, with a scene in it.

use std::fs;
use std::path::{Path, PathBuf};

use image::RgbaImage;
use serde_json::Value;
use tempfile::TempDir;

use c2warp_tests::pictures;

/// The name of the project file in every workplace.
pub(crate) const PROJECT: &str = "scene.c2warp.json";

pub(crate) struct Workplace {
    folder: TempDir,
    project: Value,
}

impl Workplace {
    /// A copy of `scenes/NAME.c2warp.json` with its picture beside it.
    pub(crate) fn with(scene: &str) -> Self {
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
        let text = fs::read_to_string(scenes.join(scene).with_extension("c2warp.json")).unwrap();
        let workplace = Self { folder: TempDir::new().unwrap(), project: serde_json::from_str(&text).unwrap() };
        let source = workplace.project["image"]["src"].as_str().unwrap();
        pictures::drawn(source).save(workplace.file(source)).unwrap();
        workplace.write(PROJECT, text);
        workplace
    }

    /// The same with another project: `change` edits what was read.
    pub(crate) fn changed(mut self, change: impl FnOnce(&mut Value)) -> Self {
        change(&mut self.project);
        self.write(PROJECT, self.project.to_string());
        self
    }

    /// The same with all handles back where they rest.
    pub(crate) fn at_rest(self) -> Self {
        self.changed(|project| {
            for handle in project["handles"].as_array_mut().unwrap() {
                handle["posed"] = handle["rest"].clone();
                handle["rotation"] = 0.into();
                handle["scale"] = 1.into();
            }
        })
    }

    pub(crate) fn folder(&self) -> &Path {
        self.folder.path()
    }

    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    pub(crate) fn write(&self, name: &str, contents: impl AsRef<[u8]>) {
        fs::write(self.file(name), contents).unwrap();
    }

    pub(crate) fn picture(&self, name: &str) -> RgbaImage {
        image::open(self.file(name)).unwrap().into_rgba8()
    }

    /// The names of all files, sorted.
    pub(crate) fn listing(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder()).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}
