//! The motions of all sites from the posed handles, once per frame.

use std::{borrow::Cow, collections::HashMap, sync::Arc};

use glam::{DMat2, DVec2};

use super::{
    DisplacementField, HarmonicFields, Motion, Quadrature, SolvedHandle,
    automatic::Automatic,
    rigid::{Freedom, Rigid, StiffnessField, Target},
    unwrap::unwrap_angles,
};
use crate::{
    bone::{BoneMotion, Skeleton},
    error::Error,
    project::{Handle, PoseMode, Rotation, Shape, ShapeKind, check_handles},
    site::{Site, SiteGraph, SiteKind},
    weight::SparseWeights,
};

/// Poses a solved scene. It contains the sites and their dependencies, but no picture and no samples. Its
/// [bytes](Self::to_bytes) can be sent to a thread or process without a solution.
///
/// ```
/// # use c2warp::{Picture, project::{Handle, Project}, solve};
/// use c2warp::{pose::Poser, project::Blend};
///
/// # let (mut project, rgba) = (Project::for_picture(40, 30), vec![255; 40 * 30 * 4]);
/// # project.handles = vec![Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
/// # let solution = solve(&project, &Picture::new(40, 30, &rgba)?)?;
/// let poser = Poser::from_bytes(&solution.poser().to_bytes())?;
/// // A drag: one pose after another of the same solution.
/// for y in [14.0, 13.0, 12.0] {
///     project.handles[1].shape.posed_mut()[0].y = y;
///     let pose = poser.pose(&project.handles, Blend::Linear)?;
///     assert_eq!(solution.map(&pose, [35.0, 15.0].into()).unwrap().posed, [35.0, y].into());
/// }
/// # Ok::<(), c2warp::Error>(())
/// ```
///
/// Cost of a pose: a visit of every harmonic weight, and of every pair of handles with an edge if rotations are
/// automatic. Microseconds for tens of handles, a few milliseconds for 1,000. The rigid mode adds some four
/// milliseconds to a frame of a drag with 150 virtual sites, and 10 to 20 times as much to a pose without a frame
/// before.
#[derive(Debug, Clone)]
pub struct Poser {
    pub(super) rest: Arc<[DVec2]>,
    pub(super) kinds: Vec<SiteKind>,
    pub(super) skeleton: Skeleton,
    pub(super) solved: Vec<SolvedHandle>,
    /// ϖ: for each site its real sites and their weights.
    pub(super) harmonic: Vec<Vec<(u32, f64)>>,
    pub(super) automatic: Automatic,
    /// `None` in the harmonic mode.
    pub(super) rigid: Option<Rigid>,
    /// Width and height of the picture.
    pub(super) picture: DVec2,
    /// `None` if nothing is displaced.
    pub(super) displacement: Option<Arc<DisplacementField>>,
}

/// The parts of a solution that form a [`Poser`].
pub(crate) struct PoserInput<'a> {
    pub(crate) sites: &'a [Site],
    pub(crate) graph: &'a SiteGraph,
    pub(crate) harmonic: &'a HarmonicFields,
    pub(crate) skeleton: Skeleton,
    pub(crate) handles: Vec<SolvedHandle>,
    pub(crate) mode: PoseMode,
    /// Where the rigid mode measures distortion; absent for a point cloud.
    pub(crate) quadrature: Option<Quadrature>,
    pub(crate) stiffness: StiffnessField,
    pub(crate) picture: DVec2,
    pub(crate) displacement: Option<Arc<DisplacementField>>,
}

impl Poser {
    pub(crate) fn new(input: PoserInput<'_>) -> Self {
        let PoserInput { sites, graph, harmonic, skeleton, handles: solved, mode, quadrature, stiffness, .. } = input;
        let freedom = sites.iter().map(|site| freedom(site.kind, &skeleton)).collect();
        let rigid = match mode {
            PoseMode::Harmonic => None,
            PoseMode::Rigid => Some(Rigid::new(freedom, graph.iter(), quadrature, stiffness)),
        };
        Self {
            rest: sites.iter().map(|site| site.rest).collect(),
            kinds: sites.iter().map(|site| site.kind).collect(),
            skeleton,
            solved,
            harmonic: harmonic.rows.clone(),
            automatic: Automatic::new(sites, graph, harmonic),
            rigid,
            picture: input.picture,
            displacement: input.displacement,
        }
    }

    /// The number of sites.
    #[must_use]
    pub fn sites(&self) -> usize {
        self.rest.len()
    }

    /// The kinds of the sites.
    pub(crate) fn kinds(&self) -> &[SiteKind] {
        &self.kinds
    }

    /// The bones of bars and polygons.
    pub(crate) fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// ϖ: for each site its real sites and their weights.
    pub(crate) fn harmonic(&self) -> &[Vec<(u32, f64)>] {
        &self.harmonic
    }

    /// The rest positions of the sites.
    pub(crate) fn rest(&self) -> &Arc<[DVec2]> {
        &self.rest
    }

    /// The motions of all sites, with the handles posed as given, in any order. They do not depend on earlier poses.
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub(crate) fn motions(&self, handles: &[Handle]) -> Result<Vec<Motion>, Error> {
        let target = self.target(handles)?;
        Ok(self.rigid(target, |rigid, target| rigid.pose_from_rest(&self.rest, target)))
    }

    /// The motions of the next frame of a drag, from those of the frame before. In the harmonic mode, same as
    /// [`motions`](Self::motions).
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub(crate) fn followed(&self, motions: &[Motion], handles: &[Handle]) -> Result<Vec<Motion>, Error> {
        let target = self.target(handles)?;
        Ok(self.rigid(target, |rigid, target| rigid.follow(&self.rest, motions, target)))
    }

    /// The motions of a drag that has ended, once the picture rests. In the harmonic mode, same as
    /// [`motions`](Self::motions).
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub(crate) fn settled(&self, motions: &[Motion], handles: &[Handle]) -> Result<Vec<Motion>, Error> {
        let target = self.target(handles)?;
        Ok(self.rigid(target, |rigid, target| rigid.settle(&self.rest, motions, target)))
    }

    /// The depth of each site with the handles posed as given.
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub(crate) fn depths(&self, handles: &[Handle]) -> Result<Vec<f64>, Error> {
        Ok(self.target(handles)?.motions.iter().map(|motion| motion.depth).collect())
    }

    /// The motions of the rigid mode; in the harmonic mode, those of the target.
    pub(super) fn rigid(&self, target: Target, pose: impl FnOnce(&Rigid, &Target) -> Vec<Motion>) -> Vec<Motion> {
        let Some(rigid) = self.rigid.as_ref().filter(|_| !self.rest.is_empty()) else { return target.motions };
        let mut motions = pose(rigid, &target);
        let mut angles: Vec<f64> = motions.iter().map(|motion| motion.angle).collect();
        unwrap_angles(&mut angles, &target.is_free, rigid.links().map(|(i, j, _)| (i, j)));
        motions.iter_mut().zip(angles).for_each(|(motion, angle)| motion.angle = angle);
        motions
    }

    /// What the handles request: the harmonic pose.
    pub(super) fn target(&self, given: &[Handle]) -> Result<Target, Error> {
        let handles = &*self.as_solved(given)?;
        for (handle, &SolvedHandle { shape: solved, .. }) in handles.iter().zip(&self.solved) {
            if let Some(posed) = ShapeKind::of(&handle.shape).into_iter().find(|&kind| kind != solved) {
                return Err(Error::PoseShape { id: handle.id.clone(), solved, posed });
            }
        }
        check_handles(given)?;
        if !self.skeleton.fits(handles) {
            // Bytes can hold a skeleton that does not fit the handles.
            return Err(Error::PoserBytes);
        }
        let mut motions = self.real_motions(handles);
        for (kind, motion) in self.kinds.iter().zip(&motions) {
            if let Some(handle) = kind.handle().filter(|_| !motion.is_in_bounds()) {
                return Err(Error::PoseNotFinite { id: handles[handle].id.clone() });
            }
        }
        self.automatic.turn(&self.rest, &self.kinds, handles, &mut motions);
        self.blend_virtual(&mut motions);
        Ok(Target { motions, is_free: self.are_free(handles), scales: self.scales(handles) })
    }

    /// Whether data read from bytes is consistent.
    pub(super) fn is_whole(&self) -> bool {
        let sites = self.rest.len();
        let real = |site: u32| self.kinds.get(site as usize).is_some_and(|kind| kind.is_real());
        let known = |kind: &SiteKind| match *kind {
            SiteKind::Point { handle } => {
                self.solved.get(handle as usize).is_some_and(|solved| solved.shape == ShapeKind::Point)
            }
            SiteKind::Bone { handle, bone } => {
                (handle as usize) < self.solved.len() && (bone as usize) < self.skeleton.bones.len()
            }
            SiteKind::Boundary | SiteKind::Virtual => true,
        };
        self.kinds.len() == sites
            && self.harmonic.len() == sites
            && self.harmonic.iter().flatten().all(|&(site, _)| real(site))
            && self.automatic.is_whole(real, self.solved.len())
            && self.rigid.as_ref().is_none_or(|rigid| rigid.is_whole(sites))
            && self.displacement.as_ref().is_none_or(|field| field.is_whole())
            && self.skeleton.is_consistent(self.solved.len())
            && self.kinds.iter().all(known)
    }

    /// Whether the rotation of each site is free.
    fn are_free(&self, handles: &[Handle]) -> Vec<bool> {
        let is_free = |kind: &SiteKind| match kind {
            SiteKind::Virtual => true,
            SiteKind::Point { handle } => handles[*handle as usize].rotation == Rotation::Auto,
            SiteKind::Bone { .. } | SiteKind::Boundary => false,
        };
        self.kinds.iter().map(is_free).collect()
    }

    /// Changes the stiffness of the picture: only the energy of the rigid mode is recomputed.
    pub(crate) fn set_stiffness(&mut self, stiffness: StiffnessField) {
        if let Some(rigid) = &mut self.rigid {
            rigid.set_stiffness(stiffness);
        }
    }

    /// Changes the displacement of the picture: only later poses change.
    pub(crate) fn set_displacement(&mut self, displacement: Option<Arc<DisplacementField>>) {
        self.displacement = displacement;
    }

    /// The displacement; `None` if nothing is displaced.
    pub(crate) fn displacement(&self) -> Option<&Arc<DisplacementField>> {
        self.displacement.as_ref()
    }

    /// Width and height of the picture.
    pub(crate) fn picture(&self) -> DVec2 {
        self.picture
    }

    /// The positions of points before the handles pose them: p + d(p).
    pub(crate) fn displaced<'a>(&self, points: &'a [DVec2]) -> Cow<'a, [DVec2]> {
        match &self.displacement {
            Some(field) => points.iter().map(|&p| field.place(p)).collect(),
            None => points.into(),
        }
    }

    /// Whether the rigid mode is used.
    #[cfg(feature = "rig")]
    pub(crate) fn is_rigid(&self) -> bool {
        self.rigid.is_some()
    }

    /// Adds the mesh that is drawn. The rigid mode then sees folds of single triangles.
    pub(crate) fn set_mesh(&mut self, vertices: &[DVec2], triangles: &[[u32; 3]], weights: &SparseWeights) {
        if let Some(rigid) = &mut self.rigid {
            rigid.set_mesh(&self.rest, vertices, triangles, weights);
        }
    }

    /// The handles in the order in which they were solved.
    pub(crate) fn as_solved<'a>(&self, handles: &'a [Handle]) -> Result<Cow<'a, [Handle]>, Error> {
        if handles.len() != self.solved.len() {
            return Err(Error::PoseMismatch { expected: self.solved.len(), found: handles.len() });
        }
        if handles.iter().zip(&self.solved).all(|(handle, solved)| handle.id == solved.id) {
            return Ok(Cow::Borrowed(handles));
        }
        let by_id: HashMap<&str, &Handle> = handles.iter().map(|handle| (handle.id.as_str(), handle)).collect();
        let find = |SolvedHandle { id, .. }: &SolvedHandle| {
            by_id.get(id.as_str()).copied().cloned().ok_or_else(|| Error::PoseMissing { id: id.clone() })
        };
        self.solved.iter().map(find).collect::<Result<_, _>>().map(Cow::Owned)
    }

    /// The motions of the real sites, before automatic rotations. Virtual sites have the identity.
    pub(super) fn real_motions(&self, handles: &[Handle]) -> Vec<Motion> {
        let bones = self.skeleton.motions(handles);
        let motion = |(&rest, kind): (&DVec2, &SiteKind)| match *kind {
            SiteKind::Point { handle } => of_point(rest, &handles[handle as usize]),
            SiteKind::Bone { handle, bone } => of_bone(rest, &bones[bone as usize], handles[handle as usize].depth),
            SiteKind::Boundary | SiteKind::Virtual => Motion::default(),
        };
        self.rest.iter().zip(&self.kinds).map(motion).collect()
    }

    /// Blends the motions of virtual sites from those of real ones, by their harmonic weights (eq. 4).
    fn blend_virtual(&self, motions: &mut [Motion]) {
        // The identity adds nothing. A held outline has it, and usually most handles.
        let passed_on = |motion: &Motion| {
            (*motion != Motion::default()).then(|| {
                let passed_on = motion.passed_on();
                (passed_on, passed_on.linear())
            })
        };
        let passed_on: Vec<Option<(Motion, DMat2)>> = motions.iter().map(passed_on).collect();
        for site in (0..motions.len()).filter(|&site| !self.kinds[site].is_real()) {
            let here = |&(real, weight): &(u32, f64)| {
                let real = real as usize;
                let from = self.rest[site] - self.rest[real];
                passed_on[real].map(|(motion, linear)| (motion.seen_from(from, linear), weight))
            };
            motions[site] = Motion::blended(self.harmonic[site].iter().filter_map(here));
        }
    }

    /// The scales of the handles at each site, spread by harmonic weights. The stretch of a bar along itself is not
    /// spread.
    fn scales(&self, handles: &[Handle]) -> Vec<f64> {
        let logs: Vec<f64> = handles.iter().map(|handle| libm::log(handle.scale)).collect();
        if logs.iter().all(|&log| log == 0.0) {
            return vec![1.0; self.rest.len()];
        }
        let log = |&(real, weight): &(u32, f64)| {
            let handle = self.kinds[real as usize].handle();
            weight * handle.map_or(0.0, |handle| logs[handle])
        };
        self.harmonic.iter().map(|row| libm::exp(row.iter().map(log).sum())).collect()
    }
}

/// The part of a site's motion that the handles leave free.
pub(super) fn freedom(kind: SiteKind, skeleton: &Skeleton) -> Freedom {
    match kind {
        SiteKind::Virtual => Freedom::Whole,
        SiteKind::Point { .. } => Freedom::Linear,
        SiteKind::Bone { bone, .. } if !skeleton.bones[bone as usize].of_loop => {
            let [a, b] = skeleton.bones[bone as usize].rest;
            Freedom::Across((b - a).normalize())
        }
        SiteKind::Bone { .. } | SiteKind::Boundary => Freedom::None,
    }
}

fn of_point(rest: DVec2, handle: &Handle) -> Motion {
    let Shape::Point { posed, .. } = handle.shape else { unreachable!("kinds are checked before") };
    let angle = match handle.rotation {
        Rotation::Degrees(degrees) => degrees.to_radians(),
        Rotation::Auto => 0.0,
    };
    Motion::similarity(angle, handle.scale, posed - rest, handle.depth)
}

/// The motion of a site on a bone.
fn of_bone(rest: DVec2, bone: &BoneMotion, depth: f64) -> Motion {
    let motion = Motion::of_bone(bone.angle, bone.along, bone.stretch, bone.across, DVec2::ZERO, depth);
    Motion { translation: bone.posed + motion.linear() * (rest - bone.rest) - rest, ..motion }
}
