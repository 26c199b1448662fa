//! A solved picture in the page: mesh, weights and poser, and all queries about a pose.
//!
//! During a drag, only numbers and typed arrays are exchanged with the page. Poses have the layout of `handle_poses`.
//! Points are returned as `[rest x, rest y, posed x, posed y, rotation in degrees, scale]`.

use c2warp::{
    BorderPiece, Error, deform,
    deform::{
        Bounds, Correspondence, FoldLimit, GroupMember, GroupTransform, GroupWay, HandleWay, Lead, PictureMesh, Turn,
    },
    pose::Poser,
    project::{Blend, Displacement, Project, ShapeSample, handles_from_json},
    weight::SparseWeights,
};
use glam::DVec2;
use wasm_bindgen::prelude::*;

use crate::{
    error::to_js,
    handle_poses::{read, write},
};

#[wasm_bindgen]
extern "C" {
    /// The arrays of a solution, as [`Solution`](crate::Solution) returned them.
    #[derive(Debug)]
    pub type PictureArrays;

    #[wasm_bindgen(method, getter)]
    fn positions(this: &PictureArrays) -> Vec<f32>;
    #[wasm_bindgen(method, getter)]
    fn triangles(this: &PictureArrays) -> Vec<u32>;
    #[wasm_bindgen(method, getter, js_name = backgroundPositions)]
    fn background_positions(this: &PictureArrays) -> Vec<f32>;
    #[wasm_bindgen(method, getter)]
    fn offsets(this: &PictureArrays) -> Vec<u32>;
    #[wasm_bindgen(method, getter)]
    fn sites(this: &PictureArrays) -> Vec<u32>;
    #[wasm_bindgen(method, getter)]
    fn weights(this: &PictureArrays) -> Vec<f32>;
    #[wasm_bindgen(method, getter)]
    fn poser(this: &PictureArrays) -> Vec<u8>;
}

/// A picture of one solution, and its present pose. The present pose remains if a new pose cannot be computed.
#[wasm_bindgen]
#[derive(Debug)]
pub struct PosedPicture(deform::PosedPicture);

#[wasm_bindgen]
impl PosedPicture {
    /// Takes the arrays of a solution, the number of its samples, and the solved handles as JSON.
    ///
    /// # Errors
    /// For arrays that do not belong to one solution.
    #[wasm_bindgen(constructor)]
    pub fn new(arrays: &PictureArrays, samples: usize, handles_json: &str) -> Result<Self, JsValue> {
        Self::try_new(arrays, samples, handles_json).map_err(|error| to_js(&error))
    }

    /// Poses the picture. Returns the motions of all sites.
    ///
    /// Sites × 12: a, b, c, d, rest x, rest y, posed x, posed y, depth, angle, cosine and sine of half the angle. The
    /// motion is T(p) = posed + [a c; b d] (p − rest).
    ///
    /// # Errors
    /// For poses that do not match the solved handles, or cannot be computed.
    pub fn set_pose(&mut self, poses: &[f64], rigid: bool) -> Result<Vec<f32>, JsValue> {
        let pose = self.0.set_pose(&read(poses)?, blend(rigid)).map_err(|error| to_js(&error))?;
        Ok(pose.packed())
    }

    /// Poses the picture as the next frame of a drag, from the present pose. Returns the motions, as
    /// [`set_pose`](Self::set_pose).
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn follow_pose(&mut self, poses: &[f64], rigid: bool) -> Result<Vec<f32>, JsValue> {
        let pose = self.0.follow_pose(&read(poses)?, blend(rigid)).map_err(|error| to_js(&error))?;
        Ok(pose.packed())
    }

    /// The pose in which the present one comes to rest. Returns the motions, as [`set_pose`](Self::set_pose).
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn settle_pose(&mut self, poses: &[f64], rigid: bool) -> Result<Vec<f32>, JsValue> {
        let pose = self.0.settle_pose(&read(poses)?, blend(rigid)).map_err(|error| to_js(&error))?;
        Ok(pose.packed())
    }

    /// The present pose in full precision, for [`show_motions`](Self::show_motions); `undefined` at rest.
    pub fn motion_numbers(&self) -> Option<Vec<f64>> {
        self.0.motion_numbers()
    }

    /// Shows a pose by the numbers of [`motion_numbers`](Self::motion_numbers). Returns the motions, as
    /// [`set_pose`](Self::set_pose).
    ///
    /// # Errors
    /// For numbers of another solution. The present pose then remains.
    pub fn show_motions(&mut self, numbers: &[f64], rigid: bool) -> Result<Vec<f32>, JsValue> {
        let pose = self.0.show_motions(numbers, blend(rigid)).map_err(|error| to_js(&error))?;
        Ok(pose.packed())
    }

    /// Sets the shape in which a drag has left the picture: samples × 8, as in a project. Only later poses change.
    ///
    /// # Errors
    /// For an invalid shape. The picture then does not change.
    pub fn set_shape(&mut self, samples: &[f64]) -> Result<(), JsValue> {
        let samples = samples.as_chunks::<8>().0.iter().copied().map(ShapeSample::from_numbers);
        self.0.set_shape(samples.collect()).map_err(|error| to_js(&error))
    }

    /// The shape of the present pose: samples × 8. It is empty if no vertex is farther than `within` pixels from its
    /// place in the pose without a shape. The present pose must be that of `poses`.
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn shape(&self, poses: &[f64], rigid: bool, within: f64) -> Result<Vec<f64>, JsValue> {
        let shape = self.0.shape(&read(poses)?, blend(rigid), within).map_err(|error| to_js(&error))?;
        Ok(shape.iter().flat_map(ShapeSample::numbers).collect())
    }

    /// Vertices × 2: the posed mesh.
    pub fn posed_positions(&self) -> Vec<f32> {
        flat(self.0.posed_vertices().iter().copied())
    }

    /// A number that changes with every change of [`triangles`](Self::triangles).
    #[wasm_bindgen(getter)]
    pub fn order_version(&self) -> u32 {
        self.0.order_version()
    }

    /// Triangles × 3 in drawing order.
    pub fn triangles(&self) -> Vec<u32> {
        self.0.drawn_triangles().concat()
    }

    /// The posed position of a rest point, as six numbers; `undefined` outside the mesh.
    pub fn map(&self, x: f64, y: f64) -> Option<Vec<f64>> {
        self.0.map(DVec2::new(x, y)).map(numbers)
    }

    /// Points × 2: the posed positions of rest points, or a pair of NaN outside the mesh.
    pub fn map_points(&self, points: &[f64]) -> Vec<f64> {
        flat_or_nan(self.0.map_points(&pairs(points)))
    }

    /// Points × 2: the rest points that are drawn at given points, or a pair of NaN beside the picture.
    pub fn locate_points(&self, points: &[f64]) -> Vec<f64> {
        flat_or_nan(self.0.locate_points(&pairs(points)))
    }

    /// The posed course of lines at rest, as points no farther apart than `step` at rest. In both arrays, a pair of NaN
    /// separates lines.
    pub fn posed_lines(&self, lines: &[f64], step: f64) -> Vec<f32> {
        let places: Vec<DVec2> = lines.as_chunks::<2>().0.iter().copied().map(DVec2::from_array).collect();
        let lines: Vec<Vec<DVec2>> = places.split(|place| place.is_nan()).map(<[DVec2]>::to_vec).collect();
        flat(self.0.posed_lines(&lines, step).join(&DVec2::NAN).into_iter())
    }

    /// The rest point that is drawn at a point, as six numbers; `undefined` beside the picture.
    pub fn locate(&self, x: f64, y: f64) -> Option<Vec<f64>> {
        self.0.locate(DVec2::new(x, y)).map(numbers)
    }

    /// The rest points under the corners of a drawing, corners × 2, all on the layer of the first: six numbers each.
    /// Beside the picture, its nearest part is continued. `undefined` without triangles.
    pub fn layer_under(&self, corners: &[f64]) -> Option<Vec<f64>> {
        Some(self.0.layer_under(&pairs(corners))?.into_iter().flat_map(numbers).collect())
    }

    /// The nearest position for a handle, at most `within` away, as six numbers. Without one, `undefined`.
    pub fn placement(&self, x: f64, y: f64, within: f64) -> Option<Vec<f64>> {
        self.0.placement(DVec2::new(x, y), within).map(numbers)
    }

    /// The box around all areas where the present pose draws one part of the picture over another.
    pub fn crossed(&self) -> Option<Vec<f64>> {
        self.0.crossed().map(edges)
    }

    /// The depth of the parts that the `selected` handles move, relative to the parts that they cross in the present
    /// pose. The present pose must be that of `poses`. −1 is behind one of the parts, 0 level with one of them, 1 in
    /// front of all.
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn lead(&self, poses: &[f64], selected: &[u32]) -> Result<i32, JsValue> {
        let selected: Vec<usize> = selected.iter().map(|&index| index as usize).collect();
        let lead = self.0.lead(&read(poses)?, &selected).map_err(|error| to_js(&error))?;
        Ok(match lead {
            Lead::Behind => -1,
            Lead::Level => 0,
            Lead::Front => 1,
        })
    }

    /// Takes rest points × 2. Returns 1 for each point that the present pose covers with another part of the picture,
    /// else 0.
    pub fn hidden(&self, rest: &[f64]) -> Vec<u8> {
        self.0.hidden(&pairs(rest)).into_iter().map(u8::from).collect()
    }

    /// Whether a rest point bends.
    pub fn bends(&self, x: f64, y: f64) -> bool {
        self.0.bends(DVec2::new(x, y))
    }

    /// The visible creases of the present pose × 5, from the largest: least x and y, greatest x and y, area.
    pub fn creases(&self) -> Vec<f64> {
        self.0.creases().iter().flat_map(|crease| edges(crease.bounds).into_iter().chain([crease.area])).collect()
    }

    /// Triangles × 3: those of the visible creases.
    pub fn creased_triangles(&self) -> Vec<u32> {
        self.0.creases().iter().flat_map(|crease| &crease.triangles).flatten().copied().collect()
    }

    /// The number of triangles in the visible creases of a pose; infinite for a pose that cannot be computed.
    ///
    /// # Errors
    /// For a malformed array.
    pub fn fold_count_of(&self, poses: &[f64], rigid: bool) -> Result<f64, JsValue> {
        let count = self.0.fold_count_of(&read(poses)?, blend(rigid));
        Ok(count.map_or(f64::INFINITY, |count| count as f64))
    }

    /// The farthest pose on the way between two poses that has at most `allowed` triangles in visible creases: the
    /// fraction of the way, then the poses. `turns` has for each handle its turn at the start and at the end, and 1 if
    /// its rotation is a number, else 0.
    ///
    /// # Errors
    /// For a malformed array.
    pub fn fold_limit(
        &self,
        from: &[f64],
        to: &[f64],
        turns: &[f64],
        rigid: bool,
        allowed: f64,
    ) -> Result<Vec<f64>, JsValue> {
        let turn = |&[from, to, is_given]: &[f64; 3]| Turn { from, to, is_given: is_given != 0.0 };
        let turns = turns.as_chunks::<3>().0.iter().map(turn).collect();
        let way = HandleWay { from: read(from)?, to: read(to)?, turns };
        Ok(limit_numbers(&self.0.fold_limit(&way, blend(rigid), allowed as usize)))
    }

    /// Like [`fold_limit`](Self::fold_limit), for the handles with these indices. They turn and scale together.
    ///
    /// `origins` has their poses before that, `rotations` their rotations then. `group` has the pivot's x and y,
    /// turn and scale at the start, turn and scale at the end, and the least and greatest scale.
    ///
    /// # Errors
    /// For a malformed array.
    #[allow(clippy::too_many_arguments, reason = "wasm-bindgen has no structs of typed arrays")]
    pub fn group_fold_limit(
        &self,
        to: &[f64],
        members: &[u32],
        origins: &[f64],
        rotations: &[f64],
        group: &[f64],
        rigid: bool,
        allowed: f64,
    ) -> Result<Vec<f64>, JsValue> {
        let &[x, y, start_turn, start_scale, end_turn, end_scale, least, most] = group else {
            return Err(crate::error::with_code("a group has eight numbers", "engine"));
        };
        let members = members.iter().zip(read(origins)?).zip(rotations);
        let member = |((&index, origin), &rotation)| GroupMember { index: index as usize, origin, rotation };
        let way = GroupWay {
            to: read(to)?,
            members: members.map(member).collect(),
            pivot: DVec2::new(x, y),
            transforms: [
                GroupTransform { turn: start_turn, scale: start_scale },
                GroupTransform { turn: end_turn, scale: end_scale },
            ],
            scales: [least, most],
        };
        Ok(limit_numbers(&self.0.group_fold_limit(&way, blend(rigid), allowed as usize)))
    }

    /// The indices of the handles that force the visible creases of a pose, from the one that forces most. Empty for a
    /// pose that cannot be computed.
    ///
    /// # Errors
    /// For a malformed array.
    pub fn forcing_handles(&self, poses: &[f64], rigid: bool) -> Result<Vec<u32>, JsValue> {
        let forcing = self.0.forcing_handles(&read(poses)?, blend(rigid)).unwrap_or_default();
        Ok(forcing.into_iter().map(|handle| handle as u32).collect())
    }

    /// The nearest poses without visible creases; `undefined` if none are found. `last` are earlier poses without
    /// creases.
    ///
    /// # Errors
    /// For a malformed array.
    #[allow(clippy::needless_pass_by_value, reason = "wasm-bindgen takes no optional slices")]
    pub fn unfolded(&self, poses: &[f64], last: Option<Vec<f64>>, rigid: bool) -> Result<Option<Vec<f64>>, JsValue> {
        let last = last.as_deref().map(read).transpose()?;
        let found = self.0.unfolded(&read(poses)?, last.as_deref(), blend(rigid)).ok().flatten();
        Ok(found.map(|found| {
            let mut numbers = Vec::new();
            write(&found.poses, &mut numbers);
            numbers
        }))
    }

    /// Vertices: how far each vertex follows a move of the `selected` handles, given by index; 1 moves as far as they
    /// do.
    ///
    /// # Errors
    /// As for [`set_pose`](Self::set_pose).
    pub fn reach(&self, poses: &[f64], rigid: bool, selected: &[u32], diagonal: f64) -> Result<Vec<f32>, JsValue> {
        let selected: Vec<usize> = selected.iter().map(|&index| index as usize).collect();
        self.0.reach(&read(poses)?, blend(rigid), &selected, diagonal).map_err(|error| to_js(&error))
    }

    /// Sets the stiffness of a project, given as JSON. Later poses equal those of a solution of that project.
    ///
    /// # Errors
    /// Any deviation from the format, with the path of the offending key.
    pub fn set_stiffness(&mut self, project_json: &str) -> Result<(), JsValue> {
        self.0.set_stiffness(&project(project_json)?);
        Ok(())
    }

    /// Vertices: the stiffness of each vertex in a project, from 0 to 1.
    ///
    /// # Errors
    /// As for [`set_stiffness`](Self::set_stiffness).
    pub fn stiffness(&self, project_json: &str) -> Result<Vec<f32>, JsValue> {
        Ok(self.0.stiffness(&project(project_json)?).map(|stiffness| stiffness as f32).collect())
    }

    /// Displaces the picture by a grid of control points: two values each, rows from top to bottom. The present pose
    /// and later ones equal those of a solution with this displacement. An empty grid displaces nothing.
    ///
    /// # Errors
    /// For sides out of range, or a wrong number of values. The picture then does not change.
    pub fn set_displacement(&mut self, width: u32, height: u32, values: &[i16]) -> Result<(), JsValue> {
        let is_none = width == 0 && height == 0 && values.is_empty();
        let displacement = (!is_none).then(|| Displacement::new(width, height, values.to_vec()));
        self.0.set_displacement(displacement.as_ref()).map_err(|error| to_js(&error))
    }

    /// Vertices × 2: the mesh before the handles pose it. It is at rest unless displaced.
    pub fn displaced_positions(&self) -> Vec<f32> {
        flat(self.0.displaced_vertices().iter().copied())
    }

    /// Points × 2: points at rest, such as the vertices of a feather, before the handles pose them.
    pub fn displaced_points(&self, rest: &[f32]) -> Vec<f32> {
        flat(self.0.displaced_points(&points(rest)).iter().copied())
    }

    /// Vertices: the number of sites that move each vertex.
    pub fn coverage(&self) -> Vec<u32> {
        self.0.coverage().collect()
    }

    /// The bounding box of the posed picture and its static background, without the skirt: least x and y,
    /// greatest x and y.
    pub fn bounds(&self) -> Option<Vec<f64>> {
        self.0.bounds().map(edges)
    }

    /// The bounding box at rest.
    pub fn rest_bounds(&self) -> Option<Vec<f64>> {
        self.0.rest_bounds().map(edges)
    }

    /// The posed borders between cells, pieces × 2 ends × 2, from the arrays of
    /// [`CellBorders`](crate::CellBorders).
    pub fn borders(&self, corners: &[u32], barycentric: &[f32]) -> Vec<f32> {
        let pieces: Vec<BorderPiece> = corners
            .as_chunks::<3>()
            .0
            .iter()
            .zip(barycentric.as_chunks::<3>().0.as_chunks::<2>().0)
            .map(|(&corners, ends)| BorderPiece::new(corners, ends.map(|end| end.map(f64::from))))
            .collect();
        flat(self.0.borders(&pieces).flatten())
    }

    /// The posed outline of the part that bends: pieces × 2 ends × 2.
    pub fn outline(&self) -> Vec<f32> {
        flat(self.0.outline().flatten())
    }

    /// Bytes of memory for mesh and weights.
    #[wasm_bindgen(getter)]
    pub fn bytes(&self) -> usize {
        self.0.bytes()
    }
}

impl PosedPicture {
    pub(crate) fn poser(&self) -> &Poser {
        self.0.poser()
    }

    pub(crate) fn show(&mut self, pose: deform::Pose) -> Result<Vec<f32>, Error> {
        self.0.show(pose).map(deform::Pose::packed)
    }

    fn try_new(arrays: &PictureArrays, samples: usize, handles_json: &str) -> Result<Self, Error> {
        let weights = arrays.weights().into_iter().map(f64::from).collect();
        let weights = SparseWeights::from_parts(arrays.offsets(), arrays.sites(), weights).ok_or(Error::PoserBytes)?;
        let mesh = PictureMesh {
            vertices: points(&arrays.positions()),
            triangles: arrays.triangles().as_chunks::<3>().0.to_vec(),
            samples,
            weights,
            background: points(&arrays.background_positions()),
        };
        let poser = Poser::from_bytes(&arrays.poser())?;
        deform::PosedPicture::new(mesh, poser, handles_from_json(handles_json)?).map(Self)
    }
}

fn project(json: &str) -> Result<Project, JsValue> {
    Project::from_json(json).map_err(|error| to_js(&Error::from(error)))
}

pub(crate) fn blend(rigid: bool) -> Blend {
    if rigid { Blend::Rigid } else { Blend::Linear }
}

fn points(coordinates: &[f32]) -> Vec<DVec2> {
    let point = |&[x, y]: &[f32; 2]| DVec2::new(x.into(), y.into());
    coordinates.as_chunks::<2>().0.iter().map(point).collect()
}

pub(crate) fn pairs(coordinates: &[f64]) -> Vec<DVec2> {
    coordinates.as_chunks::<2>().0.iter().copied().map(DVec2::from).collect()
}

pub(crate) fn flat(points: impl Iterator<Item = DVec2>) -> Vec<f32> {
    points.flat_map(|p| [p.x as f32, p.y as f32]).collect()
}

fn flat_or_nan(points: Vec<Option<DVec2>>) -> Vec<f64> {
    points.into_iter().flat_map(|p| p.unwrap_or(DVec2::NAN).to_array()).collect()
}

fn numbers(found: Correspondence) -> Vec<f64> {
    vec![found.rest.x, found.rest.y, found.posed.x, found.posed.y, found.rotation, found.scale]
}

fn edges(Bounds { min, max }: Bounds) -> Vec<f64> {
    vec![min.x, min.y, max.x, max.y]
}

fn limit_numbers(limit: &FoldLimit) -> Vec<f64> {
    let mut numbers = vec![limit.fraction];
    write(&limit.poses, &mut numbers);
    numbers
}
