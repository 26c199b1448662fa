//! The projects of `scenes/` with their pictures.

use std::{fs, path::Path};

use c2warp::{
    Picture,
    project::{DomainSpec, Project, Shape},
};
use glam::DVec2;
use image::RgbaImage;

use crate::pictures;

/// A project and its picture.
#[derive(Debug, Clone)]
pub struct Scene {
    /// The project.
    pub project: Project,
    /// Its picture.
    pub picture: RgbaImage,
}

impl Scene {
    /// Reads the scene `scenes/NAME.c2warp.json`.
    ///
    /// # Panics
    /// If the scene does not exist or is invalid.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self::enlarged(name, 1)
    }

    /// Reads a scene and enlarges it `times` times. The picture is drawn at that size.
    ///
    /// # Panics
    /// As [`Scene::named`].
    #[must_use]
    pub fn enlarged(name: &str, times: u32) -> Self {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("c2warp.json");
        let text = fs::read_to_string(&file).unwrap_or_else(|reason| panic!("{}: {reason}", file.display()));
        let mut project = Project::from_json(&text).unwrap_or_else(|reason| panic!("{}: {reason}", file.display()));
        let picture = pictures::enlarged(&project.image.src, times);
        (project.image.width, project.image.height) = picture.dimensions();
        let enlarge = |p: &mut DVec2| *p *= f64::from(times);
        for handle in &mut project.handles {
            match &mut handle.shape {
                Shape::Point { rest, posed } => [rest, posed].into_iter().for_each(enlarge),
                Shape::Bar { rest, posed } | Shape::Polygon { rest, posed } => {
                    rest.iter_mut().chain(posed).for_each(enlarge);
                }
            }
        }
        if let Some(DomainSpec::Polygon { rings, feather }) = &mut project.domain {
            rings.iter_mut().flatten().for_each(enlarge);
            *feather *= f64::from(times);
        }
        Self { project, picture }
    }

    /// Returns the picture for the solver.
    ///
    /// # Panics
    /// If the picture is too small or too large. No scene has such a picture.
    #[must_use]
    pub fn solver_picture(&self) -> Picture<'_> {
        let (width, height) = self.picture.dimensions();
        Picture::new(width, height, self.picture.as_raw()).expect("a picture of fair size")
    }
}
