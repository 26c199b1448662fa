//! The warped picture of a solution, over its background or its fill.

use glam::DVec2;

use super::{
    Drawing, MeshLayer,
    extent::Extent,
    options::{Filter, ResampleOptions},
    warped::Warped,
};
use crate::{
    deform::{DrawnPose, Pose},
    error::Error,
    fill::Fill,
    picture::Picture,
    solution::Solution,
    solve_input::check_picture,
};

/// The warped picture.
impl Solution {
    /// The fill of the picture behind the mesh; `None` if the project has no fill, or a [`Solver`](crate::Solver) has
    /// not finished it. With a fill, the whole picture is drawn behind the mesh instead of the [static
    /// background](Self::static_background).
    #[must_use]
    pub fn fill(&self) -> Option<&Fill> {
        self.fill.as_deref()
    }

    /// The warped picture: [`warp`](crate::raster::warp) of the [static background](Self::static_background) or the
    /// [filled](Self::fill) picture, the [feather](Self::feather), and the mesh. Without handles and displacement, the
    /// whole picture at rest.
    ///
    /// It has the size that [`warped_size`](crate::raster::warped_size) returns, unless the canvas grows.
    ///
    /// # Errors
    /// - [`Error::Scale`];
    /// - [`Error::Canvas`];
    /// - [`Error::NothingDrawn`];
    /// - [`Error::PictureMismatch`] for a picture of another size than the solved one; a solved mesh accepts any size;
    /// - [`Error::PoseOfAnotherSolution`].
    pub fn warped(&self, picture: &Picture<'_>, pose: &Pose, options: ResampleOptions) -> Result<Warped, Error> {
        Ok(self.drawing(picture, pose, options)?.warped(picture))
    }

    /// The warped picture, ready to be drawn in bands of rows.
    ///
    /// # Errors
    /// The errors of [`warped`](Self::warped).
    pub fn drawing(&self, picture: &Picture<'_>, pose: &Pose, options: ResampleOptions) -> Result<Drawing, Error> {
        if let Some(size) = self.prepared.picture {
            check_picture(size, picture)?;
        }
        self.solved.check_pose(pose)?;
        let is_smooth = options.filter != Filter::Nearest;
        if self.is_at_rest(pose) {
            return Drawing::whole(picture, options);
        }
        let (background, feather, rest) = (&self.background, &self.feather, &self.mesh.vertices);
        let posed = self.posed_vertices(pose);
        let DrawnPose { triangles, crossed, .. } = self.drawn_pose(pose, &posed);
        let layer = |rest, posed, triangles| MeshLayer { rest, posed, triangles, levels: None };
        let mut layers = Vec::new();
        if self.fill.is_none() {
            layers.push(layer(background.vertices(), background.vertices(), background.triangles()));
        }
        let moved = |(&p, &owner): (&DVec2, &u32)| pose.blended(p, self.weights.row(owner as usize));
        let rim: Vec<DVec2> = feather.vertices().iter().zip(feather.owners()).map(moved).collect();
        // Pixel art mixes no colours.
        if is_smooth && !rim.is_empty() {
            let levels = Some(feather.levels());
            layers.push(MeshLayer { levels, ..layer(feather.vertices(), &rim, feather.triangles()) });
        }
        layers.push(layer(rest, &posed, &triangles));
        let behind = self.fill.as_ref().map(|fill| fill.over(picture));
        let drawing = Drawing::over(picture, behind, &layers, options)?;
        Ok(match crossed {
            Some(around) if options.edges && is_smooth => drawing.with_edges(picture, options.scale, around),
            _ => drawing,
        })
    }

    /// The rectangle of the warped picture, found without drawing all its pixels. The [union](Extent::union) of those
    /// of all frames is a [`Canvas::Fixed`](crate::Canvas::Fixed) for a film.
    ///
    /// # Errors
    /// The errors of [`warped`](Self::warped).
    pub fn extent(&self, picture: &Picture<'_>, pose: &Pose, options: ResampleOptions) -> Result<Extent, Error> {
        Ok(self.drawing(picture, pose, ResampleOptions { edges: false, ..options })?.extent())
    }
}
