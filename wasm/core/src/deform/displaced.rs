//! The picture after a brush has displaced it, before the handles pose it.
//!
//! The displaced vertices are cached, so dragging handles evaluates no spline.
//!
//! Cost: sixteen control points for each vertex once, then a blend of the present pose and the search for crossing
//! parts.

use std::{borrow::Cow, cell::OnceCell, sync::Arc};

use glam::DVec2;

use super::{
    drawing_order::depths,
    posed_picture::{PosedPicture, Present},
};
use crate::{error::Error, pose::DisplacementField, project::Displacement};

impl PosedPicture {
    /// Displaces the picture, or resets the displacement. The present pose and later ones equal those of a solution
    /// with this displacement.
    ///
    /// # Errors
    /// [`Error::Project`] for sides out of range, or a wrong number of values. The picture then does not change.
    pub fn set_displacement(&mut self, displacement: Option<&Displacement>) -> Result<(), Error> {
        displacement.map_or(Ok(()), Displacement::check)?;
        let picture = self.poser.picture();
        let field = displacement.and_then(|displacement| DisplacementField::new(displacement, picture));
        if field.as_ref() != self.poser.displacement().map(|field| &**field) {
            self.poser.set_displacement(field.map(Arc::new));
            self.displace();
        }
        Ok(())
    }

    /// The vertices before the handles pose them: p + d(p).
    #[must_use]
    pub fn displaced_vertices(&self) -> &[DVec2] {
        self.displaced.as_ref().unwrap_or(&self.mesh.vertices)
    }

    /// Any points of the picture before the handles pose them, such as the vertices of a feather.
    #[must_use]
    pub fn displaced_points<'a>(&self, points: &'a [DVec2]) -> Cow<'a, [DVec2]> {
        self.poser.displaced(points)
    }

    /// Displaces the vertices as the poser does, and poses them as before.
    pub(super) fn displace(&mut self) {
        let is_displaced = self.poser.displacement().is_some();
        self.displaced = is_displaced.then(|| self.poser.displaced(&self.mesh.vertices).into_owned());
        let pose = self.present.take().and_then(|present| present.pose);
        let posed = match &pose {
            Some(pose) => self.blend_vertices(pose),
            None => self.displaced_vertices().to_vec(),
        };
        let depths = pose.as_ref().map_or_else(|| vec![0.0; self.poser.sites()], |pose| depths(pose.motions()));
        self.reorder(depths, &posed);
        self.present = (pose.is_some() || is_displaced).then(|| Present { pose, posed, creases: OnceCell::new() });
    }
}
