//! A project with all of its positions mapped.

use glam::{DAffine2, DVec2};

use super::Project;
use super::clip::{Clip, Key, Track};
use super::domain::{DomainSpec, MOST_FEATHER_PX};
use super::handle::Handle;
use super::image::ImageRef;
use super::shape::Shape;

impl Project {
    /// The same project for another picture, with all positions in pixels mapped, at rest and posed. The file name of
    /// the picture is left empty.
    ///
    /// Everything else is relative: turns, scales, depths, times, the number of samples and the settings of weights.
    pub(crate) fn mapped(&self, map: &DAffine2, (width, height): (u32, u32)) -> Self {
        let mut project = self.clone();
        // Every field is named, so that a new one cannot be forgotten.
        let Self {
            image,
            domain,
            handles,
            clips,
            stiffness,
            displacement,
            shape,
            format: _,
            fill: _,
            samples: _,
            weighting: _,
            pose: _,
            fix_boundary: _,
            edges: _,
            loose_parts: _,
        } = &mut project;
        let at = |p: &mut DVec2| *p = map.transform_point2(*p);
        let size = |(width, height): (u32, u32)| DVec2::new(width.into(), height.into());
        let sizes = [image.size(), (width, height)].map(size);
        *stiffness = stiffness.as_ref().and_then(|mask| mask.mapped(map, sizes[0], sizes[1]));
        *displacement = displacement.as_ref().and_then(|field| field.mapped(map, sizes[0], sizes[1]));
        *image = ImageRef::new("", width, height);
        if let Some(DomainSpec::Polygon { rings, feather }) = domain {
            rings.iter_mut().flatten().for_each(at);
            *feather = (*feather * map.matrix2.determinant().abs().sqrt()).min(MOST_FEATHER_PX);
        }
        shape.iter_mut().for_each(|sample| *sample = sample.mapped(map));
        handles.iter_mut().for_each(|handle| handle.shape.each_position(at));
        clips.iter_mut().for_each(|clip| clip.each_posed(|_| true, at));
        project
    }

    /// Moves a handle at rest, posed, and in all clips.
    pub(crate) fn move_handle(&mut self, index: usize, by: DVec2) {
        let Handle { id, shape, .. } = &mut self.handles[index];
        shape.each_position(|p| *p += by);
        self.clips.iter_mut().for_each(|clip| clip.each_posed(|handle| handle == id, |p| *p += by));
    }
}

impl Shape {
    fn each_position(&mut self, change: impl FnMut(&mut DVec2)) {
        match self {
            Self::Point { rest, posed } => [rest, posed].into_iter().for_each(change),
            Self::Bar { rest, posed } | Self::Polygon { rest, posed } => rest.iter_mut().chain(posed).for_each(change),
        }
    }
}

impl Clip {
    /// Changes the posed positions in the tracks of some handles.
    fn each_posed(&mut self, of: impl Fn(&String) -> bool, change: impl FnMut(&mut DVec2)) {
        let tracks = self.tracks.iter_mut().filter(|Track { handle, .. }| of(handle));
        let keys = tracks.flat_map(|Track { keys, .. }| keys);
        keys.filter_map(|Key { posed, .. }| posed.as_mut()).flatten().for_each(change);
    }
}
