//! The rigid pose mode: the picture is an elastic sheet that handles move.
//!
//! The [energy] of the sheet is the symmetric Dirichlet energy of the blended map (eq. 1), at the nodes of a
//! [quadrature] and at the few triangles of the [drawn mesh](sheet) that are flattened. All motions that the handles do
//! not prescribe are unknowns. Users need not set rotations, and limbs bend smoothly. A point cloud has no picture
//! between its sites; the sites themselves then take part in the energy.
//!
//! The energy has several minima. A minimum can vanish while a handle moves, as a buckled sheet snaps. A pose that
//! depends on the handles alone would jump. So a drag [follows](Rigid::follow) the previous frame, and nothing moves
//! much farther than the handles. Without a previous frame, handles move [from rest](Rigid::pose_from_rest) to their
//! targets in straight lines.
//!
//! Cost: some 4 ms for a frame with 150 virtual sites, and 10 to 20 times as much from rest.
//!
//! Limits: handles that pass one another can fold the picture for some frames. Poses depend on the number of samples,
//! by a few thousandths of the picture's size.

mod energy;
mod freedom;
mod model;
mod points;
mod quadrature;
mod shape;
mod sheet;
mod stiffness;

use std::{
    f64::consts::{FRAC_PI_2, TAU},
    sync::{Arc, Mutex, OnceLock, PoisonError},
};

use glam::{DMat2, DVec2};

use self::{
    freedom::{Parts, Request},
    model::{Model, Scene, bounds},
    shape::Shape,
    sheet::Sheet,
};
use super::{
    Motion,
    motion::{polar, turn},
};
use crate::{bone::best_rotation, weight::SparseWeights};

pub(crate) use self::{
    freedom::Freedom,
    quadrature::{Node, Quadrature},
    stiffness::{StiffnessField, StiffnessMask},
};

/// After a drag, the nearest minimum applies if its energy is at most this many times that of the pose from rest.
const KEPT: f64 = 1.1;
/// The number of frames from rest, and the maximum number in one call of [`Rigid::follow`].
const WAY: u32 = 10;
/// The harmonic pose is tried too if a site with a free rotation turns by more than this, in radians.
const FAR: f64 = FRAC_PI_2;
/// The harmonic pose must unfold in as many steps. In 20 ends of drags, those that took longer had more energy.
const UNFOLDING_STEPS: usize = 10;
/// Longer moves are divided into frames. A fraction of the diagonal of the sites' bounding box.
const LEAP: f64 = 0.05;

/// The solver of the rigid mode: the cell graph, the quadrature, the stiffness and the drawn mesh.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Rigid {
    links: Vec<(u32, u32, f64)>,
    freedom: Vec<Freedom>,
    quadrature: Option<Quadrature>,
    stiffness: StiffnessField,
    /// The drawn mesh. It is not serialised, because a page has it anyway.
    #[cfg_attr(feature = "poser-bytes", serde(skip))]
    sheet: Option<Arc<Sheet>>,
    /// Computed for the first pose.
    #[cfg_attr(feature = "poser-bytes", serde(skip))]
    model: OnceLock<Model>,
    #[cfg_attr(feature = "poser-bytes", serde(skip))]
    last: Last,
}

/// The last pose from rest: the end of a drag needs the same one several times. Copies begin without it.
#[derive(Debug, Default)]
struct Last(Mutex<Option<(Target, Vec<Motion>)>>);

impl Clone for Last {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// The data of the rigid mode that a rig stores, besides the sites.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RigidParts {
    /// Pairs of sites, the lesser first, with their weights.
    pub(crate) links: Vec<(u32, u32, f64)>,
    pub(crate) nodes: Vec<Node>,
    pub(crate) stiffness: StiffnessField,
}

/// What the handles request of a pose.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Target {
    /// The motions of all sites. Virtual sites have the harmonic blend, a start for the optimisation.
    pub(super) motions: Vec<Motion>,
    /// Whether the rotation of each site is free.
    pub(super) is_free: Vec<bool>,
    /// The scale at each site.
    pub(super) scales: Vec<f64>,
}

impl Rigid {
    pub(super) fn new(
        freedom: Vec<Freedom>,
        links: impl Iterator<Item = (usize, usize, f64)>,
        quadrature: Option<Quadrature>,
        stiffness: StiffnessField,
    ) -> Self {
        let links = links.map(|(i, j, weight)| (i as u32, j as u32, weight)).collect();
        Self { links, freedom, quadrature, stiffness, sheet: None, model: OnceLock::new(), last: Last::default() }
    }

    /// `None` without a picture between the sites.
    pub(super) fn parts(&self) -> Option<RigidParts> {
        let nodes = self.quadrature.as_ref()?.nodes().collect();
        Some(RigidParts { links: self.links.clone(), nodes, stiffness: self.stiffness.clone() })
    }

    pub(super) fn from_parts(freedom: Vec<Freedom>, parts: &RigidParts) -> Self {
        let links = parts.links.iter().map(|&(i, j, weight)| (i as usize, j as usize, weight));
        Self::new(freedom, links, Some(Quadrature::from_nodes(&parts.nodes)), parts.stiffness.clone())
    }

    /// Whether data read from bytes is consistent for this number of sites.
    pub(super) fn is_whole(&self, sites: usize) -> bool {
        let known = |&(i, j, weight): &(u32, u32, f64)| i < j && (j as usize) < sites && (0.0..=1.0).contains(&weight);
        self.freedom.len() == sites
            && self.links.iter().all(known)
            && self.quadrature.as_ref().is_none_or(|quadrature| quadrature.is_whole(sites))
            && self.stiffness.is_whole()
    }

    /// Changes the stiffness of the picture.
    pub(super) fn set_stiffness(&mut self, stiffness: StiffnessField) {
        self.stiffness = stiffness;
        self.reset();
    }

    /// Adds the mesh that is drawn.
    pub(super) fn set_mesh(
        &mut self,
        rest: &[DVec2],
        vertices: &[DVec2],
        triangles: &[[u32; 3]],
        weights: &SparseWeights,
    ) {
        self.sheet = Some(Arc::new(Sheet::new(vertices, triangles, weights, rest, self.unit(rest))));
        self.reset();
    }

    /// Forgets what was computed for another energy.
    fn reset(&mut self) {
        (self.model, self.last) = (OnceLock::new(), Last::default());
    }

    /// The links, with their weights.
    pub(super) fn links(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone {
        self.links.iter().map(|&(i, j, weight)| (i as usize, j as usize, weight))
    }

    /// The pose of a target, computed from rest.
    ///
    /// A straight path can twist the sheet if a site turns far. The harmonic pose is then tried too, and the lower
    /// energy counts.
    pub(super) fn pose_from_rest(&self, rest: &[DVec2], target: &Target) -> Vec<Motion> {
        // No lock is held while a pose is computed.
        let last = || self.last.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, motions)) = last().as_ref().filter(|(known, _)| known == target) {
            return motions.clone();
        }
        let motions = self.computed_from_rest(rest, target);
        *last() = Some((target.clone(), motions.clone()));
        motions
    }

    fn computed_from_rest(&self, rest: &[DVec2], target: &Target) -> Vec<Motion> {
        let model = self.model(rest);
        let start = self.moved_as_a_whole(rest, target);
        let mut shape = Shape::new(model, target.request(), parts_of(model, &start));
        for motions in target.way_from(&start, WAY) {
            shape.follow(&parts_of(model, &motions));
        }
        shape.settle();
        if target.turns(&start) > FAR {
            let mut other = Shape::new(model, target.request(), parts_of(model, &target.motions));
            other.settle_in(UNFOLDING_STEPS);
            if !other.is_folded() {
                other.settle();
                if other.energy() < shape.energy() {
                    shape = other;
                }
            }
        }
        motions_of(model, target, &shape.into_parts())
    }

    /// Moves the handles from rest to their targets in `WAY / 2` frames. Returns `None` if anything folds.
    fn unfolded<'a>(&'a self, rest: &[DVec2], target: &'a Target) -> Option<Shape<'a>> {
        let model = self.model(rest);
        let start = self.moved_as_a_whole(rest, target);
        let mut shape = Shape::new(model, target.request(), parts_of(model, &start));
        let mut frames = target.way_from(&start, WAY / 2);
        let is_free = frames.all(|motions| {
            shape.follow(&parts_of(model, &motions));
            !shape.is_folded()
        });
        is_free.then_some(shape)
    }

    /// The rigid motion that brings the handles nearest to a target.
    fn moved_as_a_whole(&self, rest: &[DVec2], target: &Target) -> Vec<Motion> {
        let handles = || (0..rest.len()).filter(|&site| self.freedom[site] != Freedom::Whole);
        let from: Vec<DVec2> = handles().map(|site| rest[site]).collect();
        let to: Vec<DVec2> = handles().map(|site| rest[site] + target.motions[site].translation).collect();
        if from.is_empty() {
            return vec![Motion::default(); rest.len()];
        }
        let mean = |places: &[DVec2]| places.iter().sum::<DVec2>() / places.len() as f64;
        let angle = best_rotation(&from, &to);
        let (centre, moved, turn) = (mean(&from), mean(&to), turn(angle));
        let motion = |(&rest, to): (&DVec2, &Motion)| {
            // The start makes as many whole turns as the target.
            let turns = TAU * libm::round((to.angle - angle) / TAU);
            Motion::similarity(angle + turns, 1.0, moved + turn.rotate(rest - centre) - rest, to.depth)
        };
        rest.iter().zip(&target.motions).map(motion).collect()
    }

    /// The next frame of a drag. `motions` are those of the previous frame. Long moves are divided.
    ///
    /// A folded sheet may stay folded. So it moves towards the pose from rest if the path there has no fold.
    pub(super) fn follow(&self, rest: &[DVec2], motions: &[Motion], target: &Target) -> Vec<Motion> {
        let model = self.model(rest);
        let mut shape = Shape::new(model, target.request(), parts_of(model, motions));
        let unfolded = || self.unfolded(rest, target);
        if let Some(unfolded) = shape.is_folded().then(unfolded).flatten() {
            shape.approach(&parts_of(model, &target.motions), &unfolded.into_parts());
        } else {
            self.carry(rest, &mut shape, motions, target);
        }
        motions_of(model, target, &shape.into_parts())
    }

    /// Moves the handles of a shape to a target, in up to [`WAY`] frames.
    fn carry(&self, rest: &[DVec2], shape: &mut Shape<'_>, motions: &[Motion], target: &Target) {
        let model = self.model(rest);
        let way = model.unit() * shape.way_to(&parts_of(model, &target.motions));
        let frames = (way / (LEAP * extent(rest))).ceil().clamp(1.0, f64::from(WAY));
        for motions in target.way_from(motions, frames as u32) {
            shape.follow(&parts_of(model, &motions));
        }
    }

    /// The pose after a drag: the nearest minimum, or the pose from rest if its energy is much lower.
    pub(super) fn settle(&self, rest: &[DVec2], motions: &[Motion], target: &Target) -> Vec<Motion> {
        let model = self.model(rest);
        let shape = Shape::new(model, target.request(), parts_of(model, motions));
        self.settled(rest, shape, self.pose_from_rest(rest, target), target)
    }

    /// The minimum near the motions that `start` returns, after the handles have moved to the target. `start` receives
    /// the pose from rest. That pose applies if its energy is much lower, or if `start` returns `None`.
    pub(super) fn rest_near(
        &self,
        rest: &[DVec2],
        target: &Target,
        start: impl FnOnce(&[Motion]) -> Option<Vec<Motion>>,
    ) -> Vec<Motion> {
        let (model, from_rest) = (self.model(rest), self.pose_from_rest(rest, target));
        let Some(motions) = start(&from_rest) else { return from_rest };
        let mut shape = Shape::new(model, target.request(), parts_of(model, &motions));
        self.carry(rest, &mut shape, &motions, target);
        self.settled(rest, shape, from_rest, target)
    }

    fn settled(&self, rest: &[DVec2], mut shape: Shape<'_>, from_rest: Vec<Motion>, target: &Target) -> Vec<Motion> {
        let model = self.model(rest);
        shape.settle();
        let near = motions_of(model, target, &shape.into_parts());
        let energy = |motions: &[Motion]| Shape::new(model, target.request(), parts_of(model, motions)).energy();
        // The energy can be NaN for a start from a file. The comparison is then false, and the pose from rest applies.
        if energy(&near) <= KEPT * energy(&from_rest) { near } else { from_rest }
    }

    /// The quadrature nodes, each with the site of greatest weight.
    pub(super) fn places(&self) -> impl Iterator<Item = (DVec2, usize)> {
        let nodes = self.quadrature.iter().flat_map(Quadrature::nodes);
        nodes.filter_map(|Node { at, influences, .. }| {
            let most = influences.iter().max_by(|one, other| one.weight.total_cmp(&other.weight));
            Some((at, most?.site))
        })
    }

    fn model(&self, rest: &[DVec2]) -> &Model {
        self.model.get_or_init(|| {
            let nodes: Vec<Node> = self.quadrature.iter().flat_map(Quadrature::nodes).collect();
            Model::new(Scene {
                rest,
                freedom: &self.freedom,
                links: &self.links,
                stiffness: self.stiffness.factors(&nodes),
                nodes,
                sheet: self.sheet.clone(),
                unit: self.unit(rest),
            })
        })
    }

    /// The unit of length: the mean width of a cell.
    fn unit(&self, rest: &[DVec2]) -> f64 {
        let area: f64 = self.quadrature.iter().flat_map(Quadrature::nodes).map(|node| node.area).sum();
        let width = (area / rest.len().max(1) as f64).sqrt();
        if width > 0.0 { width } else { extent(rest).max(1.0) / (rest.len().max(1) as f64).sqrt() }
    }
}

impl Target {
    fn request(&self) -> Request<'_> {
        let is_scaled = self.scales.iter().any(|&scale| scale != 1.0);
        Request { is_free: &self.is_free, scales: is_scaled.then_some(&self.scales) }
    }

    /// The largest difference of rotation from other motions, in radians, over all sites whose rotation is free.
    fn turns(&self, from: &[Motion]) -> f64 {
        let angles = self.motions.iter().zip(from).zip(&self.is_free).filter(|(_, is_free)| **is_free);
        angles.map(|((to, from), _)| (to.angle - from.angle).abs()).fold(0.0, f64::max)
    }

    /// Interpolates from other motions to these in equal steps.
    fn way_from(&self, start: &[Motion], steps: u32) -> impl Iterator<Item = Vec<Motion>> {
        (1..=steps).map(move |step| {
            let share = f64::from(step) / f64::from(steps);
            let between = |(&from, &to): (&Motion, &Motion)| match step == steps {
                true => to,
                false => Motion::blended([(from, 1.0 - share), (to, share)].into_iter()),
            };
            start.iter().zip(&self.motions).map(between).collect()
        })
    }
}

fn parts_of(model: &Model, motions: &[Motion]) -> Vec<Parts> {
    let parts = |(motion, &rest): (&Motion, &DVec2)| {
        let linear = motion.linear();
        [rest + motion.translation / model.unit(), linear.x_axis, linear.y_axis]
    };
    motions.iter().zip(model.rest()).map(parts).collect()
}

/// Converts parts to motions. Values that the handles prescribe are copied from the target, bit for bit.
fn motions_of(model: &Model, target: &Target, parts: &[Parts]) -> Vec<Motion> {
    let mut motions = target.motions.clone();
    let sites = model.freedom().iter().zip(&target.is_free).zip(model.rest());
    for ((motion, &[place, x, y]), ((freedom, &is_free), &rest)) in motions.iter_mut().zip(parts).zip(sites) {
        if *freedom == Freedom::Whole {
            motion.translation = model.unit() * (place - rest);
        }
        if matches!(freedom, Freedom::Whole | Freedom::Across(_)) || (*freedom == Freedom::Linear && is_free) {
            let of_target = motion.angle;
            (motion.angle, motion.strain) = polar(DMat2::from_cols(x, y));
            if !is_free {
                // A bone's sites turn as often as the bone.
                motion.angle += TAU * libm::round((of_target - motion.angle) / TAU);
            }
        }
    }
    motions
}

/// The diagonal of the sites' bounding box.
fn extent(rest: &[DVec2]) -> f64 {
    let [low, high] = bounds(rest);
    (high - low).length()
}
