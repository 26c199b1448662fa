//! A solved picture without its solution: the mesh, the weights and the poser, and all queries about a pose.
//!
//! A page needs only this while handles are dragged; the solution itself remains in the thread that solves. Vertices
//! and weights may be rounded to 32 bits, as they are for a graphics card.
//!
//! Cost: a pose includes [`Poser::pose`], blending all vertices and finding the parts that cross.

use std::{borrow::Cow, cell::OnceCell};

use glam::DVec2;

use super::{
    Bounds, Correspondence, Crease, FoldLimit, GroupWay, HandlePose, HandleWay, Pose,
    borders::posed_borders,
    course::posed_lines,
    coverage::coverage,
    creases::creases,
    crossings::{Adjacency, Crossing, PosedMesh},
    drawing_order::{DepthOrder, DrawnPose, depths},
    fold_guard::fold_limit,
    folds::FoldingMesh,
    hidden::hidden,
    inverse::rest_points,
    layer::Layers,
    lead::{Lead, lead},
    locate::{locate, triangle_at},
    outline::posed_outline,
    placement::placement,
    reach::{MOVES, STEP, reach},
    triangle::{corners, interpolate},
    way::Way,
};
use crate::{
    cell_borders::BorderPiece,
    error::Error,
    pose::{Motion, Poser, StiffnessField},
    project::{Blend, Handle, Project, ShapeSample, check_shape},
    weight::SparseWeights,
};

/// The mesh of a [`Solution`](crate::Solution), as a page receives it.
#[derive(Debug, Clone)]
pub struct PictureMesh {
    /// Vertices at rest, in image pixels: the samples, then those of the skirt.
    pub vertices: Vec<DVec2>,
    /// Triangles × 3 vertices, in drawing order while no handle has a depth.
    pub triangles: Vec<[u32; 3]>,
    /// Number of samples: the first vertices.
    pub samples: usize,
    /// Vertices × sites.
    pub weights: SparseWeights,
    /// Vertices of the static background.
    pub background: Vec<DVec2>,
}

/// A solved picture and its present pose. At first it is at rest.
#[derive(Debug)]
pub struct PosedPicture {
    pub(super) mesh: PictureMesh,
    pub(super) poser: Poser,
    /// The solved handles.
    pub(super) handles: Vec<Handle>,
    /// The shape in which a drag has left the picture.
    shape: Vec<ShapeSample>,
    folding: FoldingMesh,
    adjacency: Adjacency,
    background: Option<Bounds>,
    /// The vertices before the handles pose them, if a brush has displaced some.
    pub(super) displaced: Option<Vec<DVec2>>,
    /// `None` at rest.
    pub(super) present: Option<Present>,
    order: Order,
}

/// The present pose and its vertices, and its creases once requested.
#[derive(Debug)]
pub(super) struct Present {
    /// `None` if only the displacement moves the picture.
    pub(super) pose: Option<Pose>,
    pub(super) posed: Vec<DVec2>,
    pub(super) creases: OnceCell<Vec<Crease>>,
}

/// The drawing order of the present pose.
#[derive(Debug, Default)]
struct Order {
    /// The order of the present depths.
    by_depth: Option<(Vec<f64>, DepthOrder)>,
    /// `None` while the mesh order applies.
    triangles: Option<Vec<[u32; 3]>>,
    crossings: Vec<Crossing>,
    crossed: Option<Bounds>,
    version: u32,
}

impl PosedPicture {
    /// The picture of a mesh, the poser of its solution, and the handles that were solved.
    ///
    /// # Errors
    /// [`Error::PoserBytes`] if these do not belong to one solution.
    pub fn new(mesh: PictureMesh, mut poser: Poser, handles: Vec<Handle>) -> Result<Self, Error> {
        let vertices = mesh.vertices.len();
        let is_whole = mesh.weights.len() == vertices
            && mesh.samples <= vertices
            && mesh.triangles.iter().flatten().all(|&vertex| (vertex as usize) < vertices)
            && mesh.weights.sites().iter().all(|&site| (site as usize) < poser.sites());
        if !is_whole {
            return Err(Error::PoserBytes);
        }
        poser.set_mesh(&mesh.vertices[..mesh.samples], &mesh.triangles, &mesh.weights);
        let folding = FoldingMesh::new(&mesh.vertices, &mesh.triangles, mesh.samples);
        let background = Bounds::new(&mesh.background);
        let adjacency = Adjacency::new(&mesh.triangles);
        let order = Order::default();
        let mut picture = Self {
            mesh,
            poser,
            handles,
            shape: Vec::new(),
            folding,
            adjacency,
            background,
            displaced: None,
            present: None,
            order,
        };
        if picture.poser.displacement().is_some() {
            picture.displace();
        }
        Ok(picture)
    }

    /// Poses the picture as the next frame of a drag: see [`Poser::follow`]. The frame before is the present pose, or
    /// rest.
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn follow_pose(&mut self, poses: &[HandlePose], blend: Blend) -> Result<&Pose, Error> {
        let before = self.present_or_rest(blend);
        let pose = self.poser.follow(&before, &self.posed_handles(poses)?)?;
        self.show(pose)
    }

    /// Lets the present pose come to rest: see [`Poser::settle`].
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn settle_pose(&mut self, poses: &[HandlePose], blend: Blend) -> Result<&Pose, Error> {
        let before = self.present_or_rest(blend);
        let pose = self.poser.settle(&before, &self.posed_handles(poses)?)?;
        self.show(pose)
    }

    /// Sets the shape in which a drag has left the picture. Only later poses change.
    ///
    /// # Errors
    /// [`Error::Project`] for an invalid shape. The picture then does not change.
    pub fn set_shape(&mut self, shape: Vec<ShapeSample>) -> Result<(), Error> {
        check_shape(&shape)?;
        self.shape = shape;
        Ok(())
    }

    /// The shape of the present pose. It is empty if the handles alone determine it: if no vertex is farther than
    /// `within` pixels from its place in the pose without a shape.
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn shape(&self, poses: &[HandlePose], blend: Blend, within: f64) -> Result<Vec<ShapeSample>, Error> {
        let Some(Present { pose: Some(pose), posed, .. }) = &self.present else { return Ok(Vec::new()) };
        let plain = self.blend_vertices(&self.poser.pose(&self.posed_handles(poses)?, blend)?);
        let is_plain = plain.iter().zip(posed).all(|(plain, posed)| plain.distance(*posed) <= within);
        if is_plain { Ok(Vec::new()) } else { self.poser.shape_of(pose) }
    }

    /// The [numbers](Pose::motion_numbers) of the present pose; `None` at rest.
    #[must_use]
    pub fn motion_numbers(&self) -> Option<Vec<f64>> {
        self.present.as_ref()?.pose.as_ref().map(Pose::motion_numbers)
    }

    /// Shows a pose by its [numbers](Pose::motion_numbers).
    ///
    /// # Errors
    /// The errors of [`Poser::pose_of_numbers`].
    pub fn show_motions(&mut self, numbers: &[f64], blend: Blend) -> Result<&Pose, Error> {
        self.show(self.poser.pose_of_numbers(numbers, blend)?)
    }

    fn present_or_rest(&self, blend: Blend) -> Pose {
        let motions = self.present.as_ref().and_then(|present| present.pose.as_ref()).map(Pose::motions);
        let at_rest = || vec![Motion::default(); self.poser.sites()];
        self.poser.pose_of(motions.map_or_else(at_rest, <[Motion]>::to_vec), blend)
    }

    /// Poses the picture. `poses` are those of the solved handles, in order; additional ones are ignored. Returns the
    /// motions.
    ///
    /// # Errors
    /// The errors of [`Poser::pose`], and [`Error::PoseMismatch`] for fewer poses than handles. The present pose then
    /// remains.
    pub fn set_pose(&mut self, poses: &[HandlePose], blend: Blend) -> Result<&Pose, Error> {
        let pose = self.pose(poses, blend)?;
        self.show(pose)
    }

    /// Poses the picture with a pose of its [poser](Self::poser). Returns the motions.
    ///
    /// # Errors
    /// [`Error::PoseOfAnotherSolution`]. The present pose then remains.
    pub fn show(&mut self, pose: Pose) -> Result<&Pose, Error> {
        if !self.poser.has_made(&pose) {
            return Err(Error::PoseOfAnotherSolution);
        }
        let posed = self.blend_vertices(&pose);
        self.reorder(depths(pose.motions()), &posed);
        let present = self.present.insert(Present { pose: None, posed, creases: OnceCell::new() });
        Ok(present.pose.insert(pose))
    }

    /// The posed vertices of a pose. They use the displacement of the picture, not that of the pose.
    pub(super) fn blend_vertices(&self, pose: &Pose) -> Vec<DVec2> {
        pose.blend_places(self.displaced_vertices(), &self.mesh.weights)
    }

    /// The poser of the solution.
    #[must_use]
    pub fn poser(&self) -> &Poser {
        &self.poser
    }

    /// Draws posed vertices in order, with sites of these depths.
    pub(super) fn reorder(&mut self, depths: Vec<f64>, posed: &[DVec2]) {
        let PictureMesh { vertices: rest, triangles, weights, .. } = &self.mesh;
        let order = &mut self.order;
        let by_depth = match order.by_depth.take() {
            Some((known, by_depth)) if known == depths => by_depth,
            _ => DepthOrder::new(triangles, weights, &depths),
        };
        let mesh = PosedMesh { rest, posed, triangles };
        let DrawnPose { triangles: drawn, crossings, crossed } = by_depth.drawn(mesh, &self.adjacency);
        let drawn = if let Cow::Owned(drawn) = drawn { Some(drawn) } else { None };
        (order.crossings, order.crossed) = (crossings, crossed);
        if drawn != order.triangles {
            order.triangles = drawn;
            order.version += 1;
        }
        order.by_depth = Some((depths, by_depth));
    }

    /// Any pose of the picture.
    fn pose(&self, poses: &[HandlePose], blend: Blend) -> Result<Pose, Error> {
        self.poser.pose_from(&self.shape, &self.posed_handles(poses)?, blend)
    }

    pub(super) fn posed_handles(&self, poses: &[HandlePose]) -> Result<Vec<Handle>, Error> {
        if poses.len() < self.handles.len() {
            return Err(Error::PoseMismatch { expected: self.handles.len(), found: poses.len() });
        }
        let mut handles = self.handles.clone();
        for (handle, pose) in handles.iter_mut().zip(poses) {
            // Another number of corners is another handle: the solved one stays.
            pose.write_to(handle);
        }
        Ok(handles)
    }

    /// The numbers of corners of the solved handles.
    pub fn corner_counts(&self) -> impl Iterator<Item = usize> + '_ {
        self.handles.iter().map(|handle| handle.shape.rest().len())
    }

    /// The posed vertices.
    #[must_use]
    pub fn posed_vertices(&self) -> &[DVec2] {
        self.present.as_ref().map_or(&self.mesh.vertices, |present| &present.posed)
    }

    /// The triangles in drawing order.
    #[must_use]
    pub fn drawn_triangles(&self) -> &[[u32; 3]] {
        self.order.triangles.as_deref().unwrap_or(&self.mesh.triangles)
    }

    /// A number that changes with every change of [`drawn_triangles`](Self::drawn_triangles).
    #[must_use]
    pub fn order_version(&self) -> u32 {
        self.order.version
    }

    /// The posed position of a point of the picture; `None` outside the mesh.
    #[must_use]
    pub fn map(&self, rest: DVec2) -> Option<Correspondence> {
        let (triangle, coordinates) = triangle_at(self.drawn_triangles(), &self.mesh.vertices, rest)?;
        let both = [&self.mesh.vertices[..], self.posed_vertices()].map(|points| corners(points, triangle));
        Some(Correspondence::new(rest, interpolate(both[1], coordinates), both))
    }

    /// The posed positions of points of the picture, found by one walk over the mesh. See [`map`](Self::map).
    #[must_use]
    pub fn map_points(&self, rest: &[DVec2]) -> Vec<Option<DVec2>> {
        rest_points(self.posed_vertices(), &self.mesh.vertices, self.drawn_triangles(), rest)
    }

    /// The points of the picture that are drawn at given points, found by one walk over the mesh. See
    /// [`locate`](Self::locate).
    #[must_use]
    pub fn locate_points(&self, posed: &[DVec2]) -> Vec<Option<DVec2>> {
        rest_points(&self.mesh.vertices, self.posed_vertices(), self.drawn_triangles(), posed)
    }

    /// The posed course of lines at rest, at points no farther apart than `step` at rest. Beside the mesh, its nearest
    /// part is continued.
    #[must_use]
    pub fn posed_lines(&self, lines: &[Vec<DVec2>], step: f64) -> Vec<Vec<DVec2>> {
        posed_lines(&self.mesh.vertices, self.posed_vertices(), self.drawn_triangles(), lines, step)
    }

    /// The point of the picture that is drawn at a point; `None` beside the picture.
    #[must_use]
    pub fn locate(&self, posed: DVec2) -> Option<Correspondence> {
        locate(&self.mesh.vertices, self.posed_vertices(), self.drawn_triangles(), posed)
    }

    /// The points of the picture under the corners of a drawing, all on the layer of the first one. Beside the picture,
    /// its nearest part is continued. `None` without triangles.
    #[must_use]
    pub fn layer_under(&self, corners: &[DVec2]) -> Option<Vec<Correspondence>> {
        let PictureMesh { vertices: rest, triangles, samples, .. } = &self.mesh;
        let mesh = PosedMesh { rest, posed: self.posed_vertices(), triangles };
        let drawn = self.drawn_triangles();
        Layers { mesh, adjacency: &self.adjacency, samples: *samples, drawn }.under(corners)
    }

    /// The position for a handle: the given one if it bends, or else the nearest that does, at most `within` pixels
    /// away.
    #[must_use]
    pub fn placement(&self, posed: DVec2, within: f64) -> Option<Correspondence> {
        let both = [&self.mesh.vertices[..], self.posed_vertices()];
        placement(both, self.drawn_triangles(), self.mesh.samples, posed, within)
    }

    /// The box around all areas where the present pose draws one part of the picture over another.
    #[must_use]
    pub fn crossed(&self) -> Option<Bounds> {
        self.order.crossed
    }

    /// The depth of the parts that the `selected` handles move, relative to the parts that they cross in the present
    /// pose.
    ///
    /// # Errors
    /// The errors of [`set_pose`](Self::set_pose).
    ///
    /// # Panics
    /// If a selected index is out of bounds.
    pub fn lead(&self, poses: &[HandlePose], selected: &[usize]) -> Result<Lead, Error> {
        if self.order.crossings.is_empty() {
            return Ok(Lead::Front);
        }
        let mut handles = self.posed_handles(poses)?;
        let by_depth = self.poser.depths(&handles)?;
        for (index, handle) in handles.iter_mut().enumerate() {
            handle.depth = f64::from(u8::from(selected.contains(&index)));
        }
        let shares = self.poser.depths(&handles)?;
        Ok(lead(&self.mesh.triangles, &self.mesh.weights, &self.order.crossings, &by_depth, &shares))
    }

    /// For each point at rest, whether the present pose draws another part of the picture over it.
    #[must_use]
    pub fn hidden(&self, rest: &[DVec2]) -> Vec<bool> {
        hidden([&self.mesh.vertices, self.posed_vertices()], self.drawn_triangles(), self.mesh.samples, rest)
    }

    /// Whether a point at rest bends: whether it belongs to the domain, and not to the skirt around it.
    #[must_use]
    pub fn bends(&self, rest: DVec2) -> bool {
        let both = [&self.mesh.vertices[..], &self.mesh.vertices];
        placement(both, &self.mesh.triangles, self.mesh.samples, rest, 0.0).is_some_and(|place| place.posed == rest)
    }

    /// The visible creases of the present pose, largest first.
    #[must_use]
    pub fn creases(&self) -> &[Crease] {
        // At rest nothing is turned over.
        match &self.present {
            Some(present) => present.creases.get_or_init(|| self.creases_of(&present.posed)),
            None => &[],
        }
    }

    /// The number of triangles in the visible creases of any pose.
    ///
    /// # Errors
    /// The errors of [`set_pose`](Self::set_pose).
    pub fn fold_count_of(&self, poses: &[HandlePose], blend: Blend) -> Result<usize, Error> {
        Ok(self.fold_count(&self.blend_vertices(&self.pose(poses, blend)?)))
    }

    fn fold_count(&self, posed: &[DVec2]) -> usize {
        self.creases_of(posed).iter().map(|crease| crease.triangles.len()).sum()
    }

    pub(super) fn creases_of(&self, posed: &[DVec2]) -> Vec<Crease> {
        creases(posed, &self.folding.folded(posed).collect::<Vec<_>>())
    }

    /// The farthest poses on the way between two poses with at most `allowed` triangles in visible creases. All of them
    /// continue the present pose, which is that of the start. The start counts as allowed; poses that cannot be
    /// computed do not.
    #[must_use]
    pub fn fold_limit(&self, way: &HandleWay, blend: Blend, allowed: usize) -> FoldLimit {
        self.limit(way, blend, allowed)
    }

    /// Like [`fold_limit`](Self::fold_limit), for handles that turn and scale together.
    #[must_use]
    pub fn group_fold_limit(&self, way: &GroupWay, blend: Blend, allowed: usize) -> FoldLimit {
        self.limit(way, blend, allowed)
    }

    fn limit(&self, way: &dyn Way, blend: Blend, allowed: usize) -> FoldLimit {
        let before = self.present_or_rest(blend);
        let count = |poses: &[HandlePose]| {
            let next = self.poser.follow(&before, &self.posed_handles(poses)?)?;
            Ok::<_, Error>(self.fold_count(&self.blend_vertices(&next)))
        };
        fold_limit(way, &mut |poses| count(poses).is_ok_and(|count| count <= allowed))
    }

    /// How far each vertex follows a move of the `selected` handles: 1 moves as far as they do, 0 does not move. The
    /// moves continue the present pose, which is that of `poses`. `diagonal` is the diagonal of the picture, in pixels.
    ///
    /// # Errors
    /// The errors of [`set_pose`](Self::set_pose).
    ///
    /// # Panics
    /// If a selected index is out of bounds.
    pub fn reach(
        &self,
        poses: &[HandlePose],
        blend: Blend,
        selected: &[usize],
        diagonal: f64,
    ) -> Result<Vec<f32>, Error> {
        let (step, before) = (STEP * diagonal, self.present_or_rest(blend));
        let handles = self.posed_handles(poses)?;
        let mut moved = Vec::with_capacity(MOVES.len());
        for by in MOVES {
            let mut handles = handles.clone();
            for &index in selected {
                handles[index].shape.posed_mut().iter_mut().for_each(|corner| *corner += step * by);
            }
            moved.push(self.poser.follow(&before, &handles)?);
        }
        let moved = moved.try_into().expect("one pose for each move");
        Ok(reach(self.displaced_vertices(), &self.mesh.weights, &moved, step))
    }

    /// Sets the stiffness of a project. Later poses equal those of a solution of that project. Cost: the next pose
    /// takes about ten times as long as others.
    pub fn set_stiffness(&mut self, project: &Project) {
        self.poser.set_stiffness(StiffnessField::new(project));
    }

    /// The stiffness of a project at each vertex, from 0 to 1.
    pub fn stiffness(&self, project: &Project) -> impl Iterator<Item = f64> + '_ {
        let field = StiffnessField::new(project);
        self.mesh.vertices.iter().map(move |&at| field.at(at))
    }

    /// The number of sites that move each vertex.
    pub fn coverage(&self) -> impl Iterator<Item = u32> + '_ {
        coverage(&self.mesh.weights)
    }

    /// The bounding box of the posed picture and the static background, without the skirt; `None` without vertices.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let posed = Bounds::new(&self.posed_vertices()[..self.mesh.samples])?;
        Some(self.background.map_or(posed, |background| posed.union(background)))
    }

    /// The bounding box at rest, without the skirt and the static background.
    #[must_use]
    pub fn rest_bounds(&self) -> Option<Bounds> {
        Bounds::new(&self.mesh.vertices[..self.mesh.samples])
    }

    /// Both ends of each piece of the borders between cells, posed.
    pub fn borders<'a>(&'a self, pieces: &'a [BorderPiece]) -> impl Iterator<Item = [DVec2; 2]> + 'a {
        posed_borders(pieces, self.posed_vertices())
    }

    /// Both ends of each piece of the outline of the part that bends, posed.
    pub fn outline(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        posed_outline(&self.mesh.triangles, self.mesh.samples, self.posed_vertices())
    }

    /// Bytes of memory for mesh and weights.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let PictureMesh { vertices, triangles, weights, background, .. } = &self.mesh;
        size_of_val(&vertices[..])
            + size_of_val(&triangles[..])
            + size_of_val(weights.offsets())
            + size_of_val(weights.sites())
            + size_of_val(weights.weights())
            + size_of_val(&background[..])
            + self.displaced.as_deref().map_or(0, size_of_val)
            + self.folding.bytes()
            + self.adjacency.bytes()
    }
}
