//! Baking: from a solution to a rig with steps as coarse as the accuracy allows.

use std::{ops::RangeInclusive, sync::Arc};

use glam::DVec2;

use super::{
    Posable, Rig, RigPicture,
    clip::{MotionBits, RigClip},
    error::BakeError,
    mesh::{Mesh, Weights},
    order::{Order, Orders},
    posing::{Posing, PosingBits},
    probes::{drags, scattered},
    progress::Progress,
    sequence::{Comparison, MotionSequence},
    shares::{ExactShares, Shares},
    skin::{Skin, greatest_distance},
};
use crate::{
    error::Error,
    pose::{Motion, Poser},
    project::{Blend, Handle, Project},
    solution::Solution,
    weight::SparseWeights,
};

/// Maximum distance of a vertex from its exact position, in pixels.
pub(super) const TOLERANCE: f64 = 0.1;
/// Fractions of this error: for the steps of rest positions, then for positions and weights together, then for motions
/// as well. The rest is for linear interpolation between frames.
const PLACE_TOLERANCE: f64 = 0.02;
const MESH_TOLERANCE: f64 = 0.03;
const MOTION_TOLERANCE: f64 = 0.05;
/// The fraction for positions, weights and shares together, in poses of the handles.
const SHARE_TOLERANCE: f64 = 0.05;
/// How far handles are moved in these poses, as a fraction of the longest side: if motions are sums, and if the solver
/// computes them.
const SHARE_REACH: f64 = 0.5;
const DRAG_REACH: f64 = 0.25;
/// Bits of weights at the nodes of the rigid mode. With 14, all drags of the samples without jumps are accurate.
const FINENESS: RangeInclusive<u8> = 10..=14;

/// The effect of angles and strains grows with distance, so their steps are this many bits finer than those of
/// translations.
const FINER: u8 = 6;

/// All content that a rig draws: the static background, then the mesh of the solution.
struct Drawn {
    /// The vertices at rest. The vertices of the skin are displaced.
    at_rest: Vec<DVec2>,
    skin: Skin,
    triangles: Vec<[u32; 3]>,
    /// Triangles of the static background.
    behind: u32,
    /// Lengths of runs of triangles: alternately beyond the samples, and between them.
    runs: Vec<u32>,
}

pub(super) fn bake(
    project: &Project,
    solution: &Solution,
    picture: RigPicture,
    posable: Posable,
    on_progress: &mut dyn FnMut(f64),
) -> Result<Rig, BakeError> {
    let progress = &mut Progress::new(MotionSequence::count_frames(project, solution)?, on_progress);
    let blend = project.pose.blend;
    let sequences = MotionSequence::all(project, solution, progress)?;
    let poses = Poses::of(project, solution, posable)?;
    let is_still = project.handles.is_empty() && solution.poser().displacement().is_none();
    let drawn = if is_still { whole(&picture) } else { drawn(solution) };
    let (mesh, weights) = rounded_mesh(&drawn, &sequences, poses.as_ref(), blend)?;
    let stored = mesh.skin(&weights);
    let clip = |sequence: &MotionSequence| {
        let orders = if is_still { Order::of_mesh() } else { orders(solution, &drawn, sequence, blend, progress) };
        rounded_clip([&drawn.skin, &stored], sequence, blend, orders, progress)
    };
    let clips = sequences.iter().map(clip).collect::<Result<_, _>>()?;
    let rounded = poses.map(|poses| poses.rounded(&drawn, &mesh, &stored, blend)).transpose()?;
    let (shares, posing) = rounded.unwrap_or_default();
    // Shares name the handles in the order in which they were solved.
    let handles = solution.poser().as_solved(&project.handles).map_err(not_posed)?;
    let handles = handles.iter().map(|handle| handle.id.clone()).collect();
    Ok(Rig { picture, blend, edges: project.edges, handles, shares, posing, clips, mesh, weights })
}

fn not_posed(reason: Error) -> BakeError {
    BakeError::Pose { clip: String::new(), seconds: 0.0, reason }
}

/// Data for posing the handles, with test poses and their exact motions.
struct Poses<'a> {
    kind: PosesKind<'a>,
    probes: Vec<(Vec<Handle>, Vec<Motion>)>,
}

enum PosesKind<'a> {
    Shares(ExactShares),
    /// The longest side of the picture determines the steps of gradients.
    Solver {
        poser: &'a Poser,
        handles: Vec<Handle>,
        side: u32,
    },
}

impl<'a> Poses<'a> {
    /// `None` for a rig without posable handles.
    fn of(project: &Project, solution: &'a Solution, posable: Posable) -> Result<Option<Self>, BakeError> {
        let poser = solution.poser();
        let handles = poser.as_solved(&project.handles).map_err(not_posed)?;
        let side = project.image.width.max(project.image.height);
        let reach = f64::from(side);
        let (kind, probes) = match (ExactShares::of(poser, &handles), posable) {
            (Some(shares), _) => {
                let probes = scattered(shares.handles(), SHARE_REACH * reach);
                (PosesKind::Shares(shares), probes)
            }
            (None, Posable::Always) if !handles.is_empty() => {
                let handles = handles.into_owned();
                let probes = drags(&handles, DRAG_REACH * reach);
                (PosesKind::Solver { poser, handles, side }, probes)
            }
            (None, _) => return Ok(None),
        };
        let exact = |handles: Vec<Handle>| poser.motions(&handles).map(|motions| (handles, motions));
        let probes = probes.into_iter().map(exact).collect::<Result<_, _>>().map_err(not_posed)?;
        Ok(Some(Self { kind, probes }))
    }

    fn rounded(
        &self,
        drawn: &Drawn,
        mesh: &Mesh,
        stored: &Skin,
        blend: Blend,
    ) -> Result<(Option<Shares>, Option<Posing>), BakeError> {
        let skins = [&drawn.skin, stored];
        let too_far = || BakeError::TooFar { clip: String::new() };
        match &self.kind {
            PosesKind::Shares(shares) => {
                let error = |shares: &Shares| {
                    self.error(skins, blend, SHARE_TOLERANCE, |handles| shares.motions(&skins[1].rest, handles))
                };
                let found = (10..=24).map(|bits| shares.rounded(bits)).find(|shares| error(shares) <= SHARE_TOLERANCE);
                Ok((Some(found.ok_or_else(too_far)?), None))
            }
            PosesKind::Solver { poser, handles, side } => {
                let rounded =
                    |fineness: u8| Posing::of(poser, handles, PosingBits::of(fineness, *side), drawn.runs.clone());
                let is_close = |posing: &Posing| {
                    let mut poser = posing.poser();
                    poser.set_mesh(&mesh.at_rest(), &posing.between(&mesh.triangles), &stored.weights);
                    let motions = |handles: &[Handle]| poser.motions(handles).expect("handles with a pose");
                    self.error(skins, blend, SHARE_TOLERANCE, motions) <= SHARE_TOLERANCE
                };
                // Where a pose jumps no steps are fine enough.
                let found = FINENESS.filter_map(rounded).find(is_close).or_else(|| rounded(*FINENESS.end()));
                Ok((None, Some(found.ok_or_else(too_far)?)))
            }
        }
    }

    /// The maximum distance of a vertex from its exact position in any probe. Stops at the first probe above `most`.
    fn error(
        &self,
        [exact, stored]: [&Skin; 2],
        blend: Blend,
        most: f64,
        motions: impl Fn(&[Handle]) -> Vec<Motion>,
    ) -> f64 {
        let mut greatest = 0.0_f64;
        for (handles, exact_motions) in &self.probes {
            let [found, wanted] = [stored.posed(&motions(handles), blend), exact.posed(exact_motions, blend)];
            greatest = greatest.max(greatest_distance(&wanted, &found));
            if greatest > most {
                break;
            }
        }
        greatest
    }
}

/// The picture at rest, for a project without handles.
fn whole(picture: &RigPicture) -> Drawn {
    let size = DVec2::new(f64::from(picture.width), f64::from(picture.height));
    let mut weights = SparseWeights::with_capacity(4);
    (0..4).for_each(|_| weights.push_row(std::iter::empty()));
    let vertices = vec![DVec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)];
    let skin = Skin { vertices: vertices.clone(), weights, rest: Arc::from([]) };
    Drawn { at_rest: vertices, skin, triangles: vec![[0, 1, 2], [0, 2, 3]], behind: 0, runs: vec![2] }
}

/// The vertices are numbered by their first use.
fn drawn(solution: &Solution) -> Drawn {
    let background = solution.static_background();
    let (around, vertices) = (background.vertices(), solution.vertices());
    let moved = solution.triangles().iter().map(|corners| corners.map(|corner| corner + around.len() as u32));
    let mut triangles: Vec<[u32; 3]> = background.triangles().iter().copied().chain(moved).collect();
    let samples = around.len()..around.len() + solution.samples();
    let is_between = |triangle: &[u32; 3]| triangle.iter().all(|&corner| samples.contains(&(corner as usize)));
    let mut runs = vec![0];
    for triangle in &triangles {
        if is_between(triangle) != (runs.len() % 2 == 0) {
            runs.push(0);
        }
        *runs.last_mut().expect("the first run") += 1;
    }
    let mut numbers = vec![None; around.len() + vertices.len()];
    let mut order: Vec<usize> = Vec::new();
    for corner in triangles.iter_mut().flatten() {
        let old = *corner as usize;
        *corner = *numbers[old].get_or_insert_with(|| {
            order.push(old);
            order.len() as u32 - 1
        });
    }
    let mut weights = SparseWeights::with_capacity(order.len());
    for &old in &order {
        let row = old.checked_sub(around.len()).map(|vertex| solution.weights().row(vertex));
        weights.push_row(row.into_iter().flatten());
    }
    let in_order = |vertices: &[DVec2]| {
        let place = |&old: &usize| if old < around.len() { around[old] } else { vertices[old - around.len()] };
        order.iter().map(place).collect::<Vec<DVec2>>()
    };
    let rest = Arc::clone(solution.poser().rest());
    let skin = Skin { vertices: in_order(&solution.displaced_vertices()), weights, rest };
    Drawn { at_rest: in_order(vertices), skin, triangles, behind: background.triangles().len() as u32, runs }
}

/// The mesh and its weights with the coarsest steps that keep vertices in place. Steps are tested in some frames of all
/// sequences, and in some poses of the handles.
fn rounded_mesh(
    drawn: &Drawn,
    sequences: &[MotionSequence],
    poses: Option<&Poses<'_>>,
    blend: Blend,
) -> Result<(Mesh, Weights), BakeError> {
    let probes = || poses.iter().flat_map(|poses| poses.probes.iter().map(|(_, motions)| motions));
    let is_close = |skin: &Skin, tolerance: f64| {
        sequences.iter().flat_map(MotionSequence::sampled).chain(probes()).all(|motions| {
            greatest_distance(&drawn.skin.posed(motions, blend), &skin.posed(motions, blend)) <= tolerance
        })
    };
    let mesh =
        (6..=16).filter_map(|bits| Mesh::rounded(&drawn.at_rest, &drawn.skin, &drawn.triangles, bits)).find(|mesh| {
            let places = mesh.places();
            is_close(&Skin { weights: drawn.skin.weights.clone(), ..places }, PLACE_TOLERANCE)
        });
    let too_far = || BakeError::TooFar { clip: sequences[0].name.clone() };
    let mesh = mesh.ok_or_else(too_far)?;
    let weights = (8..=22).map(|bits| Weights::rounded(&drawn.skin.weights, bits));
    let weights = { weights }.find(|weights| is_close(&mesh.skin(weights), MESH_TOLERANCE)).ok_or_else(too_far)?;
    Ok((mesh, weights))
}

fn rounded_clip(
    [exact, stored]: [&Skin; 2],
    sequence: &MotionSequence,
    blend: Blend,
    orders: Vec<Order>,
    progress: &mut Progress<'_>,
) -> Result<RigClip, BakeError> {
    let comparison = |place: u8| {
        let bits = MotionBits { angle: place + FINER, strain: place + FINER, place };
        let rounded = |motions: &Vec<_>| motions.iter().map(|motion| bits.rounded(motion)).collect::<Option<_>>();
        let rounded: Vec<Vec<_>> = sequence.frames.iter().map(rounded).collect::<Option<_>>()?;
        let comparison = Comparison { exact, stored, blend, sequence, bits, rounded };
        let frames = sequence.frames.len();
        let step = frames.div_ceil(sequence.sampled().count());
        let is_close = |frame| comparison.error([frame; 2], frame) <= MOTION_TOLERANCE;
        (0..frames as u32).step_by(step).all(is_close).then_some(comparison)
    };
    let mut keyed = |place: u8| {
        let comparison = comparison(place)?;
        Some((comparison.keys(TOLERANCE, progress)?, comparison))
    };
    let found = (3..=18).find_map(&mut keyed);
    let (keys, Comparison { bits, rounded, .. }) =
        found.ok_or_else(|| BakeError::TooFar { clip: sequence.name.clone() })?;
    let motions = keys.iter().flat_map(|&key| rounded[key as usize].iter().copied()).collect();
    Ok(RigClip {
        name: sequence.name.clone(),
        duration: sequence.duration,
        looping: sequence.looping,
        last_frame: sequence.frames.len() as u32 - 1,
        bits,
        keys,
        motions,
        orders,
    })
}

fn orders(
    solution: &Solution,
    drawn: &Drawn,
    sequence: &MotionSequence,
    blend: Blend,
    progress: &mut Progress<'_>,
) -> Vec<Order> {
    let skin = Skin {
        vertices: solution.displaced_vertices().into_owned(),
        weights: solution.weights().clone(),
        rest: Arc::clone(&drawn.skin.rest),
    };
    let mut orders = Orders::new(solution, drawn.behind);
    for (frame, motions) in sequence.frames.iter().enumerate() {
        progress.add(1);
        orders.push(frame as u32, motions, &skin.posed(motions, blend));
    }
    orders.finish()
}
