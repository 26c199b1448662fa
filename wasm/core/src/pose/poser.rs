//! Motions of all sites from the handles: what is computed anew in every frame of a drag.

use std::{borrow::Cow, collections::HashMap, sync::Arc};

use glam::{DMat2, DVec2};

use super::{
    HarmonicFields, Motion, Pose, Quadrature, Solved,
    automatic::Automatic,
    rigid::{Freedom, Rigid},
    unwrap::unwrap_angles,
};
use crate::{
    bone::{BoneMotion, Skeleton},
    error::Error,
    project::{Blend, Form, Handle, PoseMode, Rotation, Shape, check_handles},
    site::{Site, SiteGraph, SiteKind},
};

/// Poses a solved scene. It knows the sites and how they depend on one another, no picture and no samples, and as bytes it goes to
/// where no solution is, such as another thread of a page.
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
/// Cost of a pose: a look at every share of a handle in a virtual site, and at every pair of handles that has an edge where
/// rotations are automatic. Microseconds for tens of handles, some milliseconds for 1,000. In the rigid mode some hundreds of microseconds
/// more for 100 virtual sites, some ten milliseconds for 500 handles; and the first pose of a poser takes 10 to 20 times as long, in which it
/// factorises its matrices.
#[derive(Debug, Clone)]
pub struct Poser {
    rest: Arc<[DVec2]>,
    kinds: Vec<SiteKind>,
    skeleton: Skeleton,
    /// What each handle was solved as.
    solved: Vec<Solved>,
    /// ϖ: for each site its real sites and their shares.
    shares: Vec<Vec<(u32, f64)>>,
    automatic: Automatic,
    /// In the rigid mode.
    rigid: Option<Rigid>,
}

impl Poser {
    pub(crate) fn new(
        sites: &[Site],
        graph: &SiteGraph,
        harmonic: &HarmonicFields,
        skeleton: Skeleton,
        solved: Vec<Solved>,
        mode: PoseMode,
        quadrature: Option<Quadrature>,
    ) -> Self {
        let freedom = |site: &Site| match site.kind {
            SiteKind::Virtual => Freedom::Whole,
            SiteKind::Point { .. } => Freedom::Linear,
            SiteKind::Bone { bone, .. } if !skeleton.bones[bone as usize].of_loop => {
                let [a, b] = skeleton.bones[bone as usize].rest;
                Freedom::Across((b - a).normalize())
            }
            SiteKind::Bone { .. } | SiteKind::Boundary => Freedom::None,
        };
        let freedom = sites.iter().map(freedom).collect();
        let rigid = match mode {
            PoseMode::Harmonic => None,
            PoseMode::Rigid => Some(Rigid::new(freedom, graph.iter(), quadrature)),
        };
        Self {
            rest: sites.iter().map(|site| site.rest).collect(),
            kinds: sites.iter().map(|site| site.kind).collect(),
            skeleton,
            solved,
            shares: harmonic.rows.clone(),
            automatic: Automatic::new(sites, graph, harmonic),
            rigid,
        }
    }

    /// The motions of all sites when the handles are posed as given, in any order, to be blended in one way or the other; their rest
    /// places play no part, but for the turn of bars and polygons.
    ///
    /// # Errors
    /// [`Error::PoseMismatch`] for more or fewer handles than were solved, [`Error::PoseMissing`] where one of these is not among them,
    /// [`Error::PoseShape`] for one of another kind or with other
    /// corners; [`Error::Project`] for what no handle of a project may be, such as one with a scale of 0; [`Error::PoseNotFinite`] for
    /// numbers that overflow; [`Error::PoserBytes`] where bytes that were read say of bars what no scene says.
    pub fn pose(&self, handles: &[Handle], blend: Blend) -> Result<Pose, Error> {
        let given = handles;
        let handles = &*self.as_solved(given)?;
        for (handle, &Solved { form: solved, .. }) in handles.iter().zip(&self.solved) {
            if let Some(posed) = Form::of(&handle.shape).into_iter().find(|&form| form != solved) {
                return Err(Error::PoseShape { id: handle.id.clone(), solved, posed });
            }
        }
        check_handles(given)?;
        if !self.skeleton.fits(handles) {
            // A skeleton that is made is made of the handles' corners; one that was read need not be.
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
        if let Some(rigid) = &self.rigid {
            let is_free = |kind: &SiteKind| match kind {
                SiteKind::Virtual => true,
                SiteKind::Point { handle } => handles[*handle as usize].rotation == Rotation::Auto,
                SiteKind::Bone { .. } | SiteKind::Boundary => false,
            };
            let is_free: Vec<bool> = self.kinds.iter().map(is_free).collect();
            rigid.settle(&self.rest, &mut motions, &is_free, &self.scales(handles));
            let mut angles: Vec<f64> = motions.iter().map(|motion| motion.angle).collect();
            unwrap_angles(&mut angles, &is_free, rigid.links().map(|(i, j, _)| (i, j)));
            motions.iter_mut().zip(angles).for_each(|(motion, angle)| motion.angle = angle);
        }
        Ok(Pose::new(Arc::clone(&self.rest), motions, blend))
    }

    /// Whether a pose is of what this poses: the same sites.
    pub(crate) fn has_made(&self, pose: &Pose) -> bool {
        // The poser that made it may have been one of the same bytes.
        Arc::ptr_eq(pose.rest(), &self.rest) || *pose.rest() == self.rest
    }

    /// The handles in the order in which they were solved.
    fn as_solved<'a>(&self, handles: &'a [Handle]) -> Result<Cow<'a, [Handle]>, Error> {
        if handles.len() != self.solved.len() {
            return Err(Error::PoseMismatch { expected: self.solved.len(), found: handles.len() });
        }
        if handles.iter().zip(&self.solved).all(|(handle, solved)| handle.id == solved.id) {
            return Ok(Cow::Borrowed(handles));
        }
        let by_id: HashMap<&str, &Handle> = handles.iter().map(|handle| (handle.id.as_str(), handle)).collect();
        let find = |Solved { id, .. }: &Solved| {
            by_id.get(id.as_str()).copied().cloned().ok_or_else(|| Error::PoseMissing { id: id.clone() })
        };
        self.solved.iter().map(find).collect::<Result<_, _>>().map(Cow::Owned)
    }

    /// The motions of the real sites, but for automatic rotations; none of the virtual ones yet.
    pub(super) fn real_motions(&self, handles: &[Handle]) -> Vec<Motion> {
        let bones = self.skeleton.motions(handles);
        let motion = |(&rest, kind): (&DVec2, &SiteKind)| match *kind {
            SiteKind::Point { handle } => of_point(rest, &handles[handle as usize]),
            SiteKind::Bone { handle, bone } => of_bone(rest, &bones[bone as usize], handles[handle as usize].depth),
            SiteKind::Boundary | SiteKind::Virtual => Motion::default(),
        };
        self.rest.iter().zip(&self.kinds).map(motion).collect()
    }

    /// Blends the motions of virtual sites from those of real ones, by their harmonic shares (eq. 4).
    fn blend_virtual(&self, motions: &mut [Motion]) {
        // A motion that is the identity adds nothing: a held outline's, and usually those of most handles.
        let passed_on = |motion: &Motion| {
            (*motion != Motion::default()).then(|| {
                let passed_on = motion.passed_on();
                (passed_on, passed_on.linear())
            })
        };
        let passed_on: Vec<Option<(Motion, DMat2)>> = motions.iter().map(passed_on).collect();
        for site in (0..motions.len()).filter(|&site| !self.kinds[site].is_real()) {
            let here = |&(real, share): &(u32, f64)| {
                let real = real as usize;
                let from = self.rest[site] - self.rest[real];
                passed_on[real].map(|(motion, linear)| (motion.seen_from(from, linear), share))
            };
            motions[site] = Motion::blended(self.shares[site].iter().filter_map(here));
        }
    }

    /// The scales of the handles at each site, spread by their harmonic shares. The stretch of a bar along itself is not passed on.
    fn scales(&self, handles: &[Handle]) -> Vec<f64> {
        let logs: Vec<f64> = handles.iter().map(|handle| libm::log(handle.scale)).collect();
        if logs.iter().all(|&log| log == 0.0) {
            return vec![1.0; self.rest.len()];
        }
        let log = |&(real, share): &(u32, f64)| {
            let handle = self.kinds[real as usize].handle();
            share * handle.map_or(0.0, |handle| logs[handle])
        };
        self.shares.iter().map(|shares| libm::exp(shares.iter().map(log).sum())).collect()
    }

    /// The poser as bytes, to be made again elsewhere by [`Poser::from_bytes`] of the same version.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        // Not by a derived implementation: anybody could then read one past the checks of `from_bytes`.
        let Self { rest, kinds, skeleton, solved, shares, automatic, rigid } = self;
        let all = (rest, kinds, skeleton, solved, shares, automatic, rigid);
        postcard::to_allocvec(&all).expect("plain data can be written to memory")
    }

    /// A poser from its bytes.
    ///
    /// # Errors
    /// [`Error::PoserBytes`] for bytes that make no consistent poser. What is consistent is not known to be the result of
    /// [`Poser::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let (all, rest) = postcard::take_from_bytes(bytes).map_err(|_| Error::PoserBytes)?;
        if !rest.is_empty() {
            return Err(Error::PoserBytes);
        }
        let (rest, kinds, skeleton, solved, shares, automatic, rigid) = all;
        let poser = Self { rest, kinds, skeleton, solved, shares, automatic, rigid };
        let sites = poser.rest.len();
        let real = |site: u32| poser.kinds.get(site as usize).is_some_and(|kind| kind.is_real());
        let known = |kind: &SiteKind| match *kind {
            SiteKind::Point { handle } => {
                poser.solved.get(handle as usize).is_some_and(|solved| solved.form == Form::Point)
            }
            SiteKind::Bone { handle, bone } => {
                (handle as usize) < poser.solved.len() && (bone as usize) < poser.skeleton.bones.len()
            }
            SiteKind::Boundary | SiteKind::Virtual => true,
        };
        let whole = poser.kinds.len() == sites
            && poser.shares.len() == sites
            && poser.shares.iter().flatten().all(|&(site, _)| real(site))
            && poser.automatic.is_whole(real, poser.solved.len())
            && poser.rigid.as_ref().is_none_or(|rigid| rigid.is_whole(sites))
            && poser.skeleton.is_whole(poser.solved.len())
            && poser.kinds.iter().all(known);
        if whole { Ok(poser) } else { Err(Error::PoserBytes) }
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

/// What a bone does at one of its sites.
fn of_bone(rest: DVec2, bone: &BoneMotion, depth: f64) -> Motion {
    let motion = Motion::of_bone(bone.angle, bone.along, bone.stretch, bone.across, DVec2::ZERO, depth);
    Motion { translation: bone.posed + motion.linear() * (rest - bone.rest) - rest, ..motion }
}
