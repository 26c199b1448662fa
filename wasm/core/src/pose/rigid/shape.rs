//! Newton steps from one shape of the sheet to the next.
//!
//! The first steps of a frame move the handles. Their moves are part of the linearised equations, so the picture
//! follows. Damping is increased until nothing moves much farther than the handles. Later steps relax the picture.
//! Steps are shortened so that no triangle loses more than [`TAKEN`] of its area. A handle that does not arrive in a
//! few steps is moved alone. This can fold its surroundings.
//!
//! During a fold, triangles below half of their area have an energy that stays finite for negative areas, so that they
//! can unfold. The others keep the barrier. Without it, spikes could grow far from the handle.
//!
//! [`Shape::settle`] uses exact second derivatives if the matrix is positive definite, so its last steps converge
//! quadratically. Otherwise, and in frames of a drag, they are projected.

use glam::{DMat2, DVec2};

use super::{
    super::{
        motion::turn,
        numeric::{Blocks, first_root},
    },
    energy::{FLAT, Law},
    freedom::{Freedom, Parts, Request},
    model::Model,
    points::{Deformed, Points},
    sheet::Sheet,
};
use crate::bone::best_rotation;

/// The largest fraction of the area of a triangle or node that a step may remove.
const TAKEN: f64 = 0.8;
/// Areas below this fraction of the area at rest count as folded. Otherwise, a bar that is shrunk to a point has so
/// much energy that the whole picture expands.
const COLLAPSED: f64 = 1e-3;
/// Bounds of the regularisation ε for triangles that may fold. Between them, ε is half of the most negative area ratio.
const FOLDED: [f64; 2] = [0.15, 1.0];
/// The largest move in a frame, as a multiple of that of the handles and the vertices that they move directly.
const CAP: f64 = 2.8;
/// The largest move in a frame, as a multiple of that by the rigid motion that best fits the handles. Two close handles
/// can turn the whole picture, so this limit can exceed [`CAP`].
const RIGID_CAP: f64 = 1.2;
/// Damping of every step. With a single handle, the rotation is undetermined. Without damping, rounding would choose
/// it.
const DAMPING: f64 = 1e-8;
/// Damping values, tried in order until no part moves too far with the handles.
const DAMPINGS: [f64; 4] = [DAMPING, 1e-2, 0.3, 10.0];
/// Steps to move the handles before they are moved alone.
const CARRIES: usize = 2;
/// Relaxation steps after that, with the same Cholesky factor.
const CORRECTIONS: usize = 2;
/// Sufficient decrease (Armijo).
const DECREASE: f64 = 1e-4;
const HALVINGS: usize = 12;
/// A shape rests once a step moves nothing farther than this, in units.
const REST: f64 = 1e-4;
/// Most steps until it rests. Few shapes need over ten, but those that unfold may need sixty.
const MOST_STEPS: usize = 80;

/// The sheet in one shape.
pub(super) struct Shape<'a> {
    model: &'a Model,
    request: Request<'a>,
    parts: Vec<Parts>,
    nodes: Vec<Deformed>,
    /// The places of all vertices, or of all nodes without a mesh.
    places: Vec<DVec2>,
    /// The places when the frame began.
    before: Vec<DVec2>,
    /// How far each place may move in this frame.
    caps: Vec<f64>,
    /// Triangles that have lost half of their area, or folded.
    points: Points,
    watched: Vec<Deformed>,
    /// Triangles and nodes above this fraction of their area may not fold in a step.
    guarded_from: f64,
    matrix: Blocks,
}

/// A step of all sites.
struct Direction {
    /// Change of each site's parts.
    parts: Vec<Parts>,
    /// The change of J at each node.
    jacobians: Vec<DMat2>,
    /// The change of each vertex, or of each node without a mesh.
    places: Vec<DVec2>,
}

impl<'a> Shape<'a> {
    pub(super) fn new(model: &'a Model, request: Request<'a>, parts: Vec<Parts>) -> Self {
        let places = model.places(&parts);
        let mut shape = Self {
            model,
            request,
            nodes: Vec::new(),
            before: places.clone(),
            caps: Vec::new(),
            places,
            points: Points::new(Law::Flatness),
            watched: Vec::new(),
            guarded_from: 0.0,
            matrix: model.zeros(),
            parts,
        };
        shape.watch();
        shape
    }

    pub(super) fn into_parts(self) -> Vec<Parts> {
        self.parts
    }

    /// Whether any triangle or node is folded or has collapsed.
    pub(super) fn is_folded(&self) -> bool {
        self.guarded_from > 0.0
    }

    /// The energy; infinite if anything is folded.
    pub(super) fn energy(&self) -> f64 {
        if self.is_folded() { f64::INFINITY } else { self.energy_of(&self.nodes, &self.watched, &self.parts) }
    }

    fn energy_of(&self, nodes: &[Deformed], watched: &[Deformed], parts: &[Parts]) -> f64 {
        self.model.nodes().energy(nodes, &self.request)
            + self.points.energy(watched, &self.request)
            + self.model.link_energy(parts)
    }

    /// Finds the flattened triangles, and sets which triangles and nodes may fold.
    fn watch(&mut self) {
        if let Some(sheet) = self.model.sheet() {
            self.model.points_of(&sheet.flattened(&self.places), &mut self.points);
        }
        let (nodes, watched) = (self.model.nodes().jacobians(&self.parts), self.points.jacobians(&self.parts));
        let dets = nodes.iter().chain(&watched).map(DMat2::determinant);
        let least = dets.fold(f64::INFINITY, f64::min);
        self.guarded_from = if least > COLLAPSED { 0.0 } else { FLAT };
        let folded = (-least / 2.0).clamp(FOLDED[0], FOLDED[1]);
        let deformed = |jacobian: DMat2| {
            let may_fold = jacobian.determinant() <= self.guarded_from;
            Deformed { jacobian, epsilon: if may_fold { folded } else { 0.0 } }
        };
        self.watched = watched.into_iter().map(deformed).collect();
        self.nodes = nodes.into_iter().map(deformed).collect();
    }

    /// One frame of a drag: the handles move to a target, and nothing moves much farther than they do.
    pub(super) fn follow(&mut self, target: &[Parts]) {
        self.begin_frame(target);
        if !self.carry(target) {
            self.force(target);
        }
        for _ in 0..CORRECTIONS {
            let forces = self.forces();
            self.descend(&forces, true);
        }
        self.watch();
    }

    /// Moves the picture as a whole, by the rigid motion nearest to that of the handles. Finds how far each place may
    /// move in this frame.
    fn begin_frame(&mut self, target: &[Parts]) {
        self.before.clone_from(&self.places);
        let most = CAP * self.way_to(target);
        let handles = || self.model.freedom().iter().enumerate().filter(|(_, freedom)| **freedom != Freedom::Whole);
        let places = |of: &[Parts]| handles().map(|(site, _)| of[site][0]).collect::<Vec<DVec2>>();
        let (from, to) = (places(&self.parts), places(target));
        let mean = |places: &[DVec2]| places.iter().sum::<DVec2>() / places.len().max(1) as f64;
        let (centre, moved) = (mean(&from), mean(&to));
        // Close handles that pass each other rotate quickly. The picture turns less.
        let rest: Vec<DVec2> = handles().map(|(site, _)| self.model.rest()[site]).collect();
        let spread = |places: &[DVec2], mean: DVec2| places.iter().map(|at| at.distance_squared(mean)).sum::<f64>();
        let (now, at_rest) = (spread(&from, centre), spread(&rest, mean(&rest)));
        let trust = if at_rest > now { now / at_rest } else { 1.0 };
        let turn = turn(trust * best_rotation(&from, &to));
        let place = |at: DVec2| moved + turn.rotate(at - centre);
        let linear = DMat2::from_cols(turn, turn.perp());
        self.parts.iter_mut().for_each(|[at, x, y]| [*at, *x, *y] = [place(*at), turn.rotate(*x), turn.rotate(*y)]);
        self.places.iter_mut().for_each(|at| *at = place(*at));
        self.nodes.iter_mut().chain(&mut self.watched).for_each(|at| at.jacobian = linear * at.jacobian);
        let ways = self.places.iter().zip(&self.before);
        self.caps = ways.map(|(at, before)| most.max(RIGID_CAP * at.distance(*before))).collect();
    }

    /// Moves the handles to their target. Returns whether they have arrived.
    fn carry(&mut self, target: &[Parts]) -> bool {
        for _ in 0..CARRIES {
            let direction = self.carrying(&self.driven(target));
            let length = self.longest(&direction);
            self.advance(&direction, length);
            if length == 1.0 {
                return true;
            }
            self.watch();
        }
        false
    }

    /// Moves the handles to their target, and nothing else.
    fn force(&mut self, target: &[Parts]) {
        self.advance(&self.direction(self.driven(target)), 1.0);
        self.watch();
        self.assemble(None, true);
        self.model.factorise(&mut self.matrix, DAMPING);
    }

    fn carrying(&mut self, driven: &[Parts]) -> Direction {
        let forces = self.assemble(Some(driven), true);
        let assembled = self.matrix.clone();
        for damping in DAMPINGS {
            self.matrix.clone_from(&assembled);
            self.model.factorise(&mut self.matrix, damping);
            let direction = self.direction(self.model.solve(&self.matrix, &forces, Some(driven), &self.request));
            if self.is_within_caps(&direction) {
                return direction;
            }
        }
        self.direction(driven.to_vec())
    }

    /// Moves the handles to a target, and the other sites towards another shape, as far as the caps allow.
    pub(super) fn approach(&mut self, target: &[Parts], shape: &[Parts]) {
        self.begin_frame(target);
        let driven = self.direction(self.driven(target));
        self.advance(&driven, 1.0);
        let change = |(to, at): (&Parts, &Parts)| std::array::from_fn(|k| to[k] - at[k]);
        let direction = self.direction(shape.iter().zip(&self.parts).map(change).collect());
        self.advance(&direction, self.longest_within_caps(&direction));
    }

    /// Moves until the picture rests. The handles stay.
    pub(super) fn settle(&mut self) {
        self.settle_in(MOST_STEPS);
    }

    /// Moves until the picture rests, or for some steps.
    pub(super) fn settle_in(&mut self, steps: usize) {
        for _ in 0..steps {
            let mut forces = self.assemble(None, false);
            if !self.model.factorise(&mut self.matrix, DAMPING) {
                forces = self.assemble(None, true);
                self.model.factorise(&mut self.matrix, DAMPING);
            }
            let moved = self.descend(&forces, false);
            self.watch();
            if moved < REST {
                return;
            }
        }
    }

    fn direction(&self, parts: Vec<Parts>) -> Direction {
        Direction { jacobians: self.model.nodes().jacobians(&parts), places: self.model.places(&parts), parts }
    }

    /// Sets the matrix to the second derivatives. Returns the forces, linearised after the move of the driven parts.
    fn assemble(&mut self, driven: Option<&[Parts]>, is_projected: bool) -> Vec<f64> {
        let mut forces = vec![0.0; self.model.unknowns()];
        self.model.begin(&mut self.matrix);
        for (points, deformed) in [(self.model.nodes(), &self.nodes), (&self.points, &self.watched)] {
            let values = self.matrix.values_mut();
            points.assemble(values, deformed, driven, &self.request, is_projected, &mut forces);
        }
        match driven {
            Some(driven) => {
                let sum = |(at, by): (&Parts, &Parts)| std::array::from_fn(|k| at[k] + by[k]);
                let moved: Vec<Parts> = self.parts.iter().zip(driven).map(sum).collect();
                self.model.add_link_forces(&moved, &self.request, &mut forces);
            }
            None => self.model.add_link_forces(&self.parts, &self.request, &mut forces),
        }
        self.model.finish(&mut self.matrix, &self.request);
        forces
    }

    fn forces(&self) -> Vec<f64> {
        let mut forces = vec![0.0; self.model.unknowns()];
        self.model.nodes().add_forces(&self.nodes, &self.request, &mut forces);
        self.points.add_forces(&self.watched, &self.request, &mut forces);
        self.model.add_link_forces(&self.parts, &self.request, &mut forces);
        forces
    }

    /// One line search with the current Cholesky factor. Returns the largest move of a place.
    fn descend(&mut self, forces: &[f64], is_capped: bool) -> f64 {
        let parts = self.model.solve(&self.matrix, forces, None, &self.request);
        let slope = -self.model.along(&parts, forces, &self.request);
        if slope.is_nan() || slope >= 0.0 {
            return 0.0;
        }
        let direction = self.direction(parts);
        let within_caps = if is_capped { self.longest_within_caps(&direction) } else { 1.0 };
        let mut length = self.longest(&direction).min(within_caps);
        let before = self.energy_of(&self.nodes, &self.watched, &self.parts);
        let of_watched = self.points.jacobians(&direction.parts);
        for _ in 0..HALVINGS {
            let along = |(at, &by): (&Deformed, &DMat2)| Deformed { jacobian: at.jacobian + length * by, ..*at };
            let nodes: Vec<Deformed> = self.nodes.iter().zip(&direction.jacobians).map(along).collect();
            let watched: Vec<Deformed> = self.watched.iter().zip(&of_watched).map(along).collect();
            let energy = self.energy_of(&nodes, &watched, &self.moved(&direction, length));
            if energy <= before + DECREASE * length * slope {
                self.advance(&direction, length);
                return length * direction.places.iter().map(|by| by.length()).fold(0.0, f64::max);
            }
            length /= 2.0;
        }
        0.0
    }

    fn moved(&self, direction: &Direction, length: f64) -> Vec<Parts> {
        let along = |(at, by): (&Parts, &Parts)| std::array::from_fn(|k| at[k] + length * by[k]);
        self.parts.iter().zip(&direction.parts).map(along).collect()
    }

    fn advance(&mut self, direction: &Direction, length: f64) {
        self.parts = self.moved(direction, length);
        self.nodes.iter_mut().zip(&direction.jacobians).for_each(|(at, &by)| at.jacobian += length * by);
        self.places.iter_mut().zip(&direction.places).for_each(|(at, &by)| *at += length * by);
        let watched = self.points.jacobians(&self.parts);
        self.watched.iter_mut().zip(watched).for_each(|(at, jacobian)| at.jacobian = jacobian);
    }

    /// The longest step, up to 1, that removes at most [`TAKEN`] of the area of each triangle and node that may not
    /// fold.
    fn longest(&self, direction: &Direction) -> f64 {
        let of_nodes = self.nodes.iter().zip(&direction.jacobians).fold(1.0, |most, (at, by)| {
            let (j, det) = (at.jacobian, at.jacobian.determinant());
            let first = j.x_axis.perp_dot(by.y_axis) + by.x_axis.perp_dot(j.y_axis);
            if det > self.guarded_from { first_root(TAKEN * det, first, by.determinant(), most) } else { most }
        });
        let longest =
            |sheet: &Sheet| sheet.longest(&self.places, &direction.places, self.guarded_from, TAKEN, of_nodes);
        self.model.sheet().map_or(of_nodes, longest)
    }

    fn is_within_caps(&self, direction: &Direction) -> bool {
        self.moves(direction).all(|(moved, by, cap)| (moved + by).length_squared() <= cap * cap)
    }

    /// The longest step, up to 1, that keeps all places within their caps.
    fn longest_within_caps(&self, direction: &Direction) -> f64 {
        self.moves(direction).fold(1.0, |most, (moved, by, cap)| {
            let left = (cap * cap - moved.length_squared()).max(0.0);
            first_root(left, -2.0 * moved.dot(by), -by.length_squared(), most)
        })
    }

    /// How far each place has moved in this frame, its change in a step, and how far it may move.
    fn moves(&self, direction: &Direction) -> impl Iterator<Item = (DVec2, DVec2, f64)> {
        let moved = self.places.iter().zip(&self.before).map(|(&at, &before)| at - before);
        moved.zip(&direction.places).zip(&self.caps).map(|((moved, &by), &cap)| (moved, by, cap))
    }

    /// The part of the change to a target that the handles prescribe.
    fn driven(&self, target: &[Parts]) -> Vec<Parts> {
        let sites = self.model.freedom().iter().zip(self.request.is_free);
        let change = |((at, to), (freedom, &is_free)): ((&Parts, &Parts), (&Freedom, &bool))| {
            freedom.driven(std::array::from_fn(|k| to[k] - at[k]), is_free)
        };
        self.parts.iter().zip(target).zip(sites).map(change).collect()
    }

    /// The largest move of the handles and the places that they move directly.
    pub(super) fn way_to(&self, target: &[Parts]) -> f64 {
        self.length_of(&self.driven(target))
    }

    fn length_of(&self, driven: &[Parts]) -> f64 {
        let of_sites = driven.iter().map(|by| by[0].length());
        let of_places = self.model.places(driven).into_iter().map(DVec2::length);
        of_sites.chain(of_places).fold(0.0, f64::max)
    }
}
