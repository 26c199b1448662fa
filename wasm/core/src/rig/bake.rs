//! Baking: from a solution to a rig with steps as coarse as the accuracy allows.

use std::sync::Arc;

use glam::DVec2;

use super::{
    Rig, RigPicture,
    clip::{MotionBits, RigClip},
    error::BakeError,
    mesh::{Mesh, Weights},
    order::{Order, Orders},
    progress::Progress,
    sequence::{Comparison, MotionSequence},
    shares::{ExactShares, Shares},
    skin::{Skin, greatest_distance},
};
use crate::{
    error::Error,
    pose::Motion,
    project::{Blend, Handle, Project},
    solution::Solution,
    weight::SparseWeights,
};

/// Vertices are at most so far from their places, in pixels.
pub(super) const TOLERANCE: f64 = 0.1;
/// The part of it for the steps of rest places, then for places and weights together, then for motions as well.
/// Straight lines between frames take the rest.
const PLACE_TOLERANCE: f64 = 0.02;
const MESH_TOLERANCE: f64 = 0.03;
const MOTION_TOLERANCE: f64 = 0.05;
/// The part of it for places, weights and shares together, in poses of the handles.
const SHARE_TOLERANCE: f64 = 0.05;

/// Angles and strains act at a distance: their steps are so many bits finer than those of translations.
const FINER: u8 = 6;

/// Everything that a rig draws: the static background, then the mesh of the solution.
struct Drawn {
    /// The vertices at rest. Those of the skin are displaced.
    at_rest: Vec<DVec2>,
    skin: Skin,
    triangles: Vec<[u32; 3]>,
    /// Triangles of the static background.
    behind: u32,
}

pub(super) fn bake(
    project: &Project,
    solution: &Solution,
    picture: RigPicture,
    tell: &mut dyn FnMut(f64),
) -> Result<Rig, BakeError> {
    let progress = &mut Progress::new(MotionSequence::count_frames(project, solution)?, tell);
    let blend = project.pose.blend;
    let sequences = MotionSequence::all(project, solution, progress)?;
    let posable = Posable::of(project, solution)?;
    let is_still = project.handles.is_empty() && solution.poser().displacement().is_none();
    let drawn = if is_still { whole(&picture) } else { drawn(solution) };
    let (mesh, weights) = rounded_mesh(&drawn, &sequences, posable.as_ref(), blend)?;
    let stored = mesh.skin(&weights);
    let clip = |sequence: &MotionSequence| {
        let orders = if is_still { Order::of_mesh() } else { orders(solution, &drawn, sequence, blend, progress) };
        rounded_clip([&drawn.skin, &stored], sequence, blend, orders, progress)
    };
    let clips = sequences.iter().map(clip).collect::<Result<_, _>>()?;
    let shares = posable.map(|posable| posable.rounded([&drawn.skin, &stored], blend)).transpose()?;
    // Shares name the handles in the order in which they were solved.
    let handles = solution.poser().as_solved(&project.handles).map_err(not_posed)?;
    let handles = handles.iter().map(|handle| handle.id.clone()).collect();
    Ok(Rig { picture, blend, edges: project.edges, handles, shares, clips, mesh, weights })
}

fn not_posed(reason: Error) -> BakeError {
    BakeError::Pose { clip: String::new(), seconds: 0.0, reason }
}

/// Shares with some poses of the handles, and the exact motions in these.
struct Posable {
    shares: ExactShares,
    probes: Vec<(Vec<Handle>, Vec<Motion>)>,
}

impl Posable {
    /// `None` where poses need a solver.
    fn of(project: &Project, solution: &Solution) -> Result<Option<Self>, BakeError> {
        let poser = solution.poser();
        let handles = poser.as_solved(&project.handles).map_err(not_posed)?;
        let Some(shares) = ExactShares::of(poser, &handles) else { return Ok(None) };
        let reach = f64::from(project.image.width.max(project.image.height)) / 2.0;
        let exact = |handles: Vec<Handle>| poser.motions(&handles).map(|motions| (handles, motions));
        let probes = shares.probes(reach).into_iter().map(exact).collect::<Result<_, _>>().map_err(not_posed)?;
        Ok(Some(Self { shares, probes }))
    }

    fn rounded(&self, [exact, stored]: [&Skin; 2], blend: Blend) -> Result<Shares, BakeError> {
        let places: Vec<_> = self.probes.iter().map(|(_, motions)| exact.posed(motions, blend)).collect();
        let is_close = |shares: &Shares| {
            self.probes.iter().zip(&places).all(|((handles, _), places)| {
                let motions = shares.motions(&stored.rest, handles);
                greatest_distance(places, &stored.posed(&motions, blend)) <= SHARE_TOLERANCE
            })
        };
        let found = (10..=24).map(|bits| self.shares.rounded(bits)).find(is_close);
        found.ok_or(BakeError::TooFar { clip: String::new() })
    }
}

/// The picture as it is, for a project without handles.
fn whole(picture: &RigPicture) -> Drawn {
    let size = DVec2::new(f64::from(picture.width), f64::from(picture.height));
    let mut weights = SparseWeights::with_capacity(4);
    (0..4).for_each(|_| weights.push_row(std::iter::empty()));
    let vertices = vec![DVec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)];
    let skin = Skin { vertices: vertices.clone(), weights, rest: Arc::from([]) };
    Drawn { at_rest: vertices, skin, triangles: vec![[0, 1, 2], [0, 2, 3]], behind: 0 }
}

/// The vertices are numbered by their first use.
fn drawn(solution: &Solution) -> Drawn {
    let background = solution.static_background();
    let (around, vertices) = (background.vertices(), solution.vertices());
    let moved = solution.triangles().iter().map(|corners| corners.map(|corner| corner + around.len() as u32));
    let mut triangles: Vec<[u32; 3]> = background.triangles().iter().copied().chain(moved).collect();
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
    Drawn { at_rest: in_order(vertices), skin, triangles, behind: background.triangles().len() as u32 }
}

/// The mesh and its weights with the coarsest steps that keep vertices in place. They are tried in some frames of all
/// sequences, and in some poses of the handles.
fn rounded_mesh(
    drawn: &Drawn,
    sequences: &[MotionSequence],
    posable: Option<&Posable>,
    blend: Blend,
) -> Result<(Mesh, Weights), BakeError> {
    let probes = || posable.iter().flat_map(|posable| posable.probes.iter().map(|(_, motions)| motions));
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
