//! A solved project as an engine's rig: vertices that few bones move linearly.
//!
//! Engines blend affine maps of bones linearly, as eq. 1 blends those of sites. So the linear blend is exact if all
//! sites are bones and all weights are kept. Otherwise the rig is fitted to poses:
//!
//! 1. Sites are merged until few enough remain, but at least one for each handle: see `bones`.
//! 2. Weights are fitted to the exact positions of the vertices in all poses: see `weights`.
//! 3. The motions of the bones are fitted to the same positions: see `motions`. Both are repeated.
//!
//! The poses are the project's, some of each clip, and random ones. The loss is measured in other random poses. The
//! motions of the bones are then fitted again in each frame of each clip.
//!
//! Cost: seconds for 300 vertices and 100 bones.
//!
//! Known limits: the rigid blend is not linear, so its rigs are never exact. All bones are children of the root.

use std::collections::BTreeSet;

use glam::{DAffine2, DVec2};

use c2warp::{
    Picture, Solution, SpriteMesh,
    clip::Playback,
    deform::Pose,
    project::{Blend, Clip, Looping, Project},
    site::{Site, SiteKind},
    weight::SparseWeights,
};

use crate::{
    bones::{ChosenSites, chosen_sites},
    chart::{Chart, Numbers},
    error::ExportError,
    keys::{Keys, keys},
    loss::{Errors, Loss, Places},
    motions::{MotionFit, blended},
    names::Names,
    options::Options,
    poses::random_handles,
    weights::WeightFit,
};

/// Number of random poses that a rig is fitted to, and the first seed of those in which it is measured.
const FITTED_POSES: u64 = 40;
const MEASURED_POSES: u64 = 20;
const MEASURED_SEED: u64 = 1000;
/// Number of times of a clip at which a rig is fitted and measured.
const TIMES: u32 = 12;
/// How often weights and motions are fitted alternately.
const ROUNDS: usize = 4;
/// The completed fractions of the work once poses are computed, and once bones are fitted.
const POSED: f64 = 0.15;
const FITTED: f64 = 0.6;
/// Frame rate at which clips are baked.
pub const FRAMES_PER_SECOND: u32 = 60;
/// The longest clip: all frames of all bones are in memory while keys are chosen.
const MOST_SECONDS: f64 = 120.0;

/// A bone, a child of the root.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bone {
    pub(crate) name: String,
    /// Its position at rest. Its rotation at rest is 0.
    pub(crate) rest: DVec2,
    /// Whether it is a bone of a handle.
    pub(crate) is_handle: bool,
}

/// A picture with bones, for the writers of all formats.
#[derive(Debug, Clone, PartialEq)]
pub struct EngineRig {
    pub(crate) name: String,
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// The vertices at rest, where the texture is sampled.
    pub(crate) vertices: Vec<DVec2>,
    /// The vertices before bones move them: displaced as the project says.
    pub(crate) displaced: Vec<DVec2>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) hull: usize,
    /// The root comes first, fixed at the picture's top left corner.
    pub(crate) bones: Vec<Bone>,
    /// Vertices × bones.
    pub(crate) weights: SparseWeights,
    /// The maps of the bones in the project's pose.
    pose: Vec<DAffine2>,
    clips: Vec<BakedClip>,
    loss: Loss,
    sites: usize,
    outline: f64,
}

#[derive(Debug, Clone, PartialEq)]
struct BakedClip {
    name: String,
    duration: f64,
    looping: Looping,
    /// Frames × bones.
    frames: Vec<Vec<DAffine2>>,
}

/// The keys of a clip in a format's numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Timeline {
    pub(crate) name: String,
    pub(crate) looping: Looping,
    pub(crate) duration: f64,
    /// Duration of a frame in seconds.
    pub(crate) frame: f64,
    pub(crate) last_frame: u32,
    /// Bones with their keys. At least one of them has a key at the last frame, where Spine and glTF end a clip.
    pub(crate) tracks: Vec<(usize, Keys)>,
}

impl EngineRig {
    /// Builds the rig of a project, with a name, from its solution and picture.
    ///
    /// # Errors
    /// An [`ExportError`] for too many handles, an outline with too many corners, a long clip, or a pose that cannot be
    /// computed.
    pub fn new(
        name: &str,
        project: &Project,
        solution: &Solution,
        picture: &Picture,
        options: Options,
    ) -> Result<Self, ExportError> {
        Self::new_with_progress(name, project, solution, picture, options, &mut |_| {})
    }

    /// Like [`new`](Self::new), with progress: `on_progress` receives the completed fraction, from 0 to 1.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub fn new_with_progress(
        name: &str,
        project: &Project,
        solution: &Solution,
        picture: &Picture,
        options: Options,
        on_progress: &mut dyn FnMut(f64),
    ) -> Result<Self, ExportError> {
        options.check_handles(project)?;
        let mesh = SpriteMesh::new(solution, picture, options.vertices)?;
        let blend = project.pose.blend;
        let pose = solution.pose(project)?;
        let mut clips =
            project.clips.iter().map(|clip| Moments::new(clip, project, solution)).collect::<Result<Vec<_>, _>>()?;
        let mut poses = vec![pose.clone()];
        for clip in &mut clips {
            poses.extend(clip.some(blend)?);
        }
        let drawn = mesh.drawn_triangles(&poses);
        // Random handles may have no pose, such as bars that a rigid mode cannot follow.
        let random = |seed| solution.poser().pose(&random_handles(project, seed), blend).ok();
        poses.extend((1..=FITTED_POSES).filter_map(random));
        on_progress(POSED);
        let mut fitted = |part: f64| on_progress(POSED + (FITTED - POSED) * part);
        let skeleton = Skeleton::new(project, solution, &mesh, options, &poses, &mut fitted);

        let measured: Vec<Pose> = (MEASURED_SEED..MEASURED_SEED + MEASURED_POSES).filter_map(random).collect();
        let mut of_clips = Vec::new();
        for clip in &mut clips {
            of_clips.push((clip.clip.name.clone(), skeleton.errors(&mesh, &clip.some(blend)?, Skeleton::maps)));
        }
        let samples = &solution.vertices()[..solution.samples()];
        let places = Places::new(samples, mesh.vertices(), mesh.triangles());
        let between = [&pose].into_iter().chain(&measured).flat_map(|pose| {
            let exact = solution.posed_vertices(pose);
            places.distances(&mesh.posed_vertices(pose), &exact).collect::<Vec<f64>>()
        });
        let loss = Loss {
            pose: skeleton.errors(&mesh, std::slice::from_ref(&pose), Skeleton::maps),
            random: skeleton.errors(&mesh, &measured, Skeleton::maps),
            unfitted: skeleton.errors(&mesh, &measured, |skeleton, _, pose| skeleton.site_maps(pose)),
            clips: of_clips,
            between: Errors::of(between.collect()),
        };
        let mut names = Names::default();
        let all: f64 = project.clips.iter().map(|clip| clip.duration).sum();
        let mut baked = 0.0;
        let clips = clips.iter_mut().map(|clip| {
            let Clip { name, duration, looping, .. } = clip.clip;
            on_progress(FITTED + (1.0 - FITTED) * baked / all);
            baked += duration;
            let poses = clip.all(blend)?;
            let frames = poses.iter().map(|pose| skeleton.maps(&mesh, pose)).collect();
            Ok(BakedClip { name: names.unique(name), duration: *duration, looping: *looping, frames })
        });
        let clips = clips.collect::<Result<Vec<_>, ExportError>>()?;
        Ok(Self {
            name: name.to_owned(),
            width: picture.width(),
            height: picture.height(),
            vertices: mesh.vertices().to_vec(),
            displaced: mesh.displaced_vertices().to_vec(),
            triangles: drawn,
            hull: mesh.hull().len(),
            pose: skeleton.maps(&mesh, &pose),
            bones: skeleton.bones,
            weights: skeleton.weights,
            clips,
            loss,
            sites: solution.sites().len(),
            outline: mesh.tolerance(),
        })
    }

    /// The loss of the rig.
    #[must_use]
    pub fn loss(&self) -> &Loss {
        &self.loss
    }

    /// The number of bones besides the root, and of the sites that they represent.
    #[must_use]
    pub fn bones(&self) -> (usize, usize) {
        (self.bones.len() - 1, self.sites)
    }

    /// The numbers of vertices and triangles.
    #[must_use]
    pub fn size(&self) -> (usize, usize) {
        (self.vertices.len(), self.triangles.len())
    }

    /// The maximum number of bones that move a vertex.
    #[must_use]
    pub fn influences(&self) -> usize {
        self.weights.offsets().windows(2).map(|row| row[1] - row[0]).max().unwrap_or(0) as usize
    }

    /// The maximum distance between the outline and that of the visible pixels, in pixels.
    #[must_use]
    pub fn outline_tolerance(&self) -> f64 {
        self.outline
    }

    /// The numbers of all bones in the project's pose.
    pub(crate) fn setup(&self, chart: Chart) -> Vec<Numbers> {
        let numbers = |(bone, map): (&Bone, &DAffine2)| chart.numbers(&seen_from(bone.rest, map), None);
        self.bones.iter().zip(&self.pose).map(numbers).collect()
    }

    /// The keys of all clips.
    pub(crate) fn timelines(&self, chart: Chart) -> Vec<Timeline> {
        let setup = self.setup(chart);
        let boxes = self.boxes();
        let timeline = |clip: &BakedClip| {
            let last_frame = clip.frames.len() as u32 - 1;
            let of_bone = |bone: usize| {
                let frames = clip.frames.iter().map(|maps| seen_from(self.bones[bone].rest, &maps[bone]));
                (bone, keys(chart, &frames.collect::<Vec<_>>(), &boxes[bone], &setup[bone]))
            };
            // The root stays, so it has keys only if it is the only bone.
            let animated = if self.bones.len() == 1 { 0..1 } else { 1..self.bones.len() };
            let mut tracks: Vec<(usize, Keys)> = animated.map(of_bone).collect();
            if tracks.iter().all(|(_, keys)| keys.frames.len() == 1) {
                let (_, keys) = &mut tracks[0];
                keys.frames.push(last_frame);
                keys.numbers.push(keys.numbers[0]);
            }
            Timeline {
                name: clip.name.clone(),
                looping: clip.looping,
                duration: clip.duration,
                frame: clip.duration / f64::from(last_frame),
                last_frame,
                tracks,
            }
        };
        self.clips.iter().map(timeline).collect()
    }

    /// The corners of the boxes around the vertices of each bone, from the bone at rest.
    fn boxes(&self) -> Vec<[DVec2; 4]> {
        let mut boxes = vec![[DVec2::INFINITY, DVec2::NEG_INFINITY]; self.bones.len()];
        for (vertex, p) in self.displaced.iter().enumerate() {
            for (bone, _) in self.weights.row(vertex) {
                let q = *p - self.bones[bone].rest;
                boxes[bone] = [boxes[bone][0].min(q), boxes[bone][1].max(q)];
            }
        }
        // A bone without vertices has no box.
        let corners = |[low, high]: [DVec2; 2]| {
            if low.x > high.x { [DVec2::ZERO; 4] } else { [low, low.with_x(high.x), high, low.with_y(high.y)] }
        };
        boxes.into_iter().map(corners).collect()
    }
}

impl Timeline {
    /// The clip forwards and backwards, for formats that cannot play backwards.
    pub(crate) fn there_and_back(mut self) -> Self {
        if self.looping != Looping::Alternate {
            return self;
        }
        let last = self.last_frame;
        for (_, keys) in self.tracks.iter_mut().filter(|(_, keys)| keys.frames.len() > 1) {
            let back = (0..keys.frames.len() - 1).rev();
            let (frames, numbers): (Vec<u32>, Vec<Numbers>) =
                back.map(|key| (2 * last - keys.frames[key], keys.numbers[key])).unzip();
            keys.frames.extend(frames);
            keys.numbers.extend(numbers);
        }
        (self.duration, self.last_frame, self.looping) = (2.0 * self.duration, 2 * last, Looping::Repeat);
        self
    }
}

/// Converts a map to the pose of a bone, relative to its position at rest.
fn seen_from(rest: DVec2, map: &DAffine2) -> DAffine2 {
    DAffine2 { matrix2: map.matrix2, translation: map.transform_point2(rest) }
}

/// The poses along a clip.
struct Moments<'a> {
    clip: &'a Clip,
    playback: Playback,
}

impl<'a> Moments<'a> {
    fn new(clip: &'a Clip, project: &Project, solution: &Solution) -> Result<Self, ExportError> {
        if clip.duration > MOST_SECONDS {
            let Clip { name, duration, .. } = clip;
            return Err(ExportError::ClipTooLong { clip: name.clone(), seconds: *duration, most: MOST_SECONDS });
        }
        let playback = Playback::new(solution.poser().clone(), clip.clone(), project.handles.clone());
        Ok(Self { clip, playback })
    }

    fn at(&mut self, count: u32, blend: Blend) -> Result<Vec<Pose>, ExportError> {
        let pose = |k: u32| {
            let seconds = self.clip.duration * f64::from(k) / f64::from(count);
            let refused = |reason| ExportError::ClipPose { clip: self.clip.name.clone(), seconds, reason };
            self.playback.pose(seconds, blend).map_err(refused)
        };
        (0..=count).map(pose).collect()
    }

    /// Poses at evenly spaced times.
    fn some(&mut self, blend: Blend) -> Result<Vec<Pose>, ExportError> {
        let mut poses = self.at(TIMES, blend)?;
        poses.pop();
        Ok(poses)
    }

    /// Poses at all frames, including both ends.
    fn all(&mut self, blend: Blend) -> Result<Vec<Pose>, ExportError> {
        let frames = (self.clip.duration * f64::from(FRAMES_PER_SECOND)).round().max(1.0) as u32;
        self.at(frames, blend)
    }
}

/// The bones with the weights of a mesh.
struct Skeleton {
    bones: Vec<Bone>,
    /// The site of each bone but the root.
    sites: Vec<usize>,
    weights: SparseWeights,
    /// `None` if the sites move the vertices exactly.
    fit: Option<MotionFit>,
}

impl Skeleton {
    fn new(
        project: &Project,
        solution: &Solution,
        mesh: &SpriteMesh,
        options: Options,
        poses: &[Pose],
        on_progress: &mut dyn FnMut(f64),
    ) -> Self {
        let all = solution.sites().len();
        let site_maps: Vec<Vec<DAffine2>> =
            poses.iter().map(|pose| (0..all).map(|site| map_of(pose, site)).collect()).collect();
        let links = solution.links().map(|(a, b, _)| (a, b));
        let owners = owners(solution, options.bones);
        let ChosenSites { kept, leader } =
            chosen_sites(&site_maps, mesh.displaced_vertices(), mesh.weights(), links, &owners, options.bones);
        let weights = of_bones(mesh.weights(), &kept, &leader);
        let most = weights.offsets().windows(2).map(|row| row[1] - row[0]).max().unwrap_or(0) as usize;
        let is_exact = project.pose.blend == Blend::Linear && kept.len() == all && most <= options.influences;
        let mut skeleton = Self { bones: named(project, solution, &kept), sites: kept, weights, fit: None };
        if !is_exact {
            let targets: Vec<Vec<DVec2>> = poses.iter().map(|pose| mesh.posed_vertices(pose)).collect();
            for round in 0..ROUNDS {
                on_progress(round as f64 / ROUNDS as f64);
                let maps: Vec<Vec<DAffine2>> = poses.iter().map(|pose| skeleton.maps(mesh, pose)).collect();
                let fit = WeightFit { vertices: mesh.displaced_vertices(), targets: &targets, maps: &maps };
                skeleton.weights = fit.fitted(&skeleton.weights, options.influences);
                skeleton.refit(mesh);
            }
        }
        skeleton.drop_unused(mesh);
        skeleton
    }

    fn refit(&mut self, mesh: &SpriteMesh) {
        let rest: Vec<DVec2> = self.bones.iter().map(|bone| bone.rest).collect();
        let held: Vec<bool> = self.bones.iter().map(|bone| bone.is_handle).collect();
        self.fit = Some(MotionFit::new(mesh.displaced_vertices(), &self.weights, &rest, &held));
    }

    /// Drops the bones that move no vertex, besides those of handles.
    fn drop_unused(&mut self, mesh: &SpriteMesh) {
        let is_handle = |bone: &Bone| bone.is_handle.then_some(0);
        let mut number: Vec<Option<u32>> = self.bones.iter().map(is_handle).collect();
        for &bone in self.weights.sites() {
            number[bone as usize] = Some(0);
        }
        number[0] = Some(0);
        (0..).zip(number.iter_mut().flatten()).for_each(|(count, number)| *number = count);
        let is_used = |bone: usize| number[bone].is_some();
        let mut at = 0..;
        self.bones.retain(|_| at.next().is_some_and(is_used));
        let mut at = 1..;
        self.sites.retain(|_| at.next().is_some_and(is_used));
        let (offsets, bones, shares) = self.weights.clone().into_parts();
        let bones = bones.into_iter().filter_map(|bone| number[bone as usize]).collect();
        self.weights = SparseWeights::from_parts(offsets, bones, shares).expect("the same rows");
        if self.fit.is_some() {
            self.refit(mesh);
        }
    }

    /// The maps of the sites that the bones represent.
    fn site_maps(&self, pose: &Pose) -> Vec<DAffine2> {
        let moving = self.sites.iter().map(|&site| map_of(pose, site));
        [DAffine2::IDENTITY].into_iter().chain(moving).collect()
    }

    /// The maps of the bones in a pose.
    fn maps(&self, mesh: &SpriteMesh, pose: &Pose) -> Vec<DAffine2> {
        let sites = self.site_maps(pose);
        match &self.fit {
            Some(fit) => fit.fitted(&sites, mesh.displaced_vertices(), &self.weights, &mesh.posed_vertices(pose)),
            None => sites,
        }
    }

    /// Distances between the vertices moved by these maps and their exact positions in some poses.
    fn errors(
        &self,
        mesh: &SpriteMesh,
        poses: &[Pose],
        maps: impl Fn(&Self, &SpriteMesh, &Pose) -> Vec<DAffine2>,
    ) -> Errors {
        let of_pose = |pose: &Pose| {
            let (maps, exact) = (maps(self, mesh, pose), mesh.posed_vertices(pose));
            let distance =
                |(vertex, &p): (usize, &DVec2)| blended(&maps, p, self.weights.row(vertex)).distance(exact[vertex]);
            mesh.displaced_vertices().iter().enumerate().map(distance).collect::<Vec<f64>>()
        };
        Errors::of(poses.iter().flat_map(of_pose).collect())
    }
}

/// T_i as an affine map.
fn map_of(pose: &Pose, site: usize) -> DAffine2 {
    let origin = pose.moved(site, DVec2::ZERO);
    let [x, y] = [DVec2::X, DVec2::Y].map(|axis| pose.moved(site, axis) - origin);
    DAffine2 { matrix2: glam::DMat2::from_cols(x, y), translation: origin }
}

/// Converts weights of sites to weights of the bones that represent them. Vertices that do not move belong to the root.
fn of_bones(weights: &SparseWeights, kept: &[usize], leader: &[usize]) -> SparseWeights {
    let (mut offsets, mut bones, mut shares) = (vec![0], Vec::new(), Vec::new());
    for vertex in 0..weights.len() {
        let mut row: Vec<(usize, f64)> = Vec::new();
        for (site, weight) in weights.row(vertex) {
            let bone = 1 + kept.binary_search(&leader[site]).expect("leaders are kept");
            match row.iter_mut().find(|one| one.0 == bone) {
                Some(one) => one.1 += weight,
                None => row.push((bone, weight)),
            }
        }
        if row.is_empty() {
            row.push((0, 1.0));
        }
        row.sort_unstable_by_key(|one| one.0);
        for (bone, weight) in row {
            bones.push(bone as u32);
            shares.push(weight);
        }
        offsets.push(bones.len() as u32);
    }
    SparseWeights::from_parts(offsets, bones, shares).expect("rows of all vertices")
}

/// The handle of each site. Pieces of bars and polygons are told apart if they leave half of the bones for the sites
/// between.
fn owners(solution: &Solution, bones: usize) -> Vec<Option<(u32, u32)>> {
    let owner = |kind: SiteKind| match kind {
        SiteKind::Point { handle } => Some((handle, 0)),
        SiteKind::Bone { handle, bone } => Some((handle, bone)),
        SiteKind::Boundary | SiteKind::Virtual => None,
    };
    let pieces: Vec<Option<(u32, u32)>> = solution.sites().iter().map(|site| owner(site.kind)).collect();
    let are_few = 2 * pieces.iter().flatten().collect::<BTreeSet<_>>().len() <= bones;
    if are_few { pieces } else { pieces.into_iter().map(|piece| piece.map(|(handle, _)| (handle, 0))).collect() }
}

/// The root, and a bone for each site, named after its handle or its number.
fn named(project: &Project, solution: &Solution, sites: &[usize]) -> Vec<Bone> {
    let mut names = Names::default();
    // Handles first, so that no other bone takes their names.
    let mut of_handles: Vec<Option<String>> =
        project.handles.iter().map(|handle| Some(names.unique(&handle.id))).collect();
    let root = Bone { name: names.unique("root"), rest: DVec2::ZERO, is_handle: false };
    let mut name = |site: usize| match solution.sites()[site].kind {
        SiteKind::Point { handle } | SiteKind::Bone { handle, .. } => {
            let at = handle as usize;
            of_handles[at].take().unwrap_or_else(|| names.unique(&project.handles[at].id))
        }
        SiteKind::Boundary => names.unique(&format!("border {site}")),
        SiteKind::Virtual => names.unique(&format!("site {site}")),
    };
    let mut bones = vec![root];
    bones.extend(sites.iter().map(|&site| {
        let Site { rest, kind, .. } = solution.sites()[site];
        Bone { name: name(site), rest, is_handle: kind.handle().is_some() }
    }));
    bones
}
