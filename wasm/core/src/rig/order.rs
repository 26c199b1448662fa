//! The drawing order of triangles along a clip.
//!
//! Only triangles that cover each other in the pose need an order. So one order is kept as long as it suits
//! the pairs of each frame. If it does not, it is sorted anew for the pairs of all its frames, while that is possible.

use glam::DVec2;

use super::{
    bytes::{Reader, Writer},
    error::RigError,
};
use crate::{
    deform::{Adjacency, DepthOrder, PosedMesh, depths, ranks, satisfies, topological},
    pose::Motion,
    solution::Solution,
};

/// The drawing order from a frame on.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Order {
    pub(super) frame: u32,
    /// Whether parts cover each other in any of its frames.
    pub(super) crosses: bool,
    /// Indices of triangles; empty for the order of the mesh.
    pub(super) triangles: Vec<u32>,
}

impl Order {
    /// That of the mesh, for a whole clip.
    pub(super) fn of_mesh() -> Vec<Self> {
        vec![Self { frame: 0, crosses: false, triangles: Vec::new() }]
    }

    pub(super) fn write(&self, to: &mut Writer) {
        to.byte(u8::from(self.crosses) | u8::from(!self.triangles.is_empty()) << 1);
        let mut next = 0_i32;
        for &t in &self.triangles {
            to.signed(t as i32 - next);
            next = t as i32 + 1;
        }
    }

    pub(super) fn read(from: &mut Reader<'_>, frame: u32, count: usize) -> Result<Self, RigError> {
        let flags = from.byte()?;
        from.expect(flags < 4, "has an unknown kind of drawing order")?;
        let mut order = Self { frame, crosses: flags & 1 != 0, triangles: Vec::new() };
        if flags & 2 == 0 {
            return Ok(order);
        }
        from.expect(from.has(Some(count)) && count > 0, "ends too early")?;
        let mut is_drawn = vec![false; count];
        let mut next = 0_i32;
        for _ in 0..count {
            let t = next.wrapping_add(from.signed()?);
            let drawn = usize::try_from(t).ok().and_then(|t| is_drawn.get_mut(t));
            let is_new = drawn.is_some_and(|drawn| !std::mem::replace(drawn, true));
            from.expect(is_new, "has a drawing order that is no order of the triangles")?;
            order.triangles.push(t as u32);
            next = t + 1;
        }
        Ok(order)
    }
}

/// The orders of frames, made frame by frame.
pub(super) struct Orders<'a> {
    solution: &'a Solution,
    adjacency: Adjacency,
    /// Triangles that are drawn before those of the solution.
    behind: u32,
    runs: Vec<Run>,
}

/// Frames with one order.
struct Run {
    frame: u32,
    /// The triangles of the solution by depth in the first frame.
    base: Vec<u32>,
    /// The triangle in front, and the one behind it, in all frames.
    pairs: Vec<[u32; 2]>,
    order: Vec<u32>,
    /// The place of each triangle in the order.
    ranks: Vec<u32>,
}

impl Run {
    fn new(frame: u32, base: Vec<u32>, pairs: Vec<[u32; 2]>) -> Self {
        let order = topological(&base, &pairs);
        Self { frame, ranks: ranks(&order), base, pairs, order }
    }

    fn crosses(&self) -> bool {
        !self.pairs.is_empty()
    }

    /// Adds the pairs of another frame, if one order satisfies them all.
    fn join(&mut self, pairs: &[[u32; 2]]) -> bool {
        let mut all = [&self.pairs, pairs].concat();
        all.sort_unstable();
        all.dedup();
        if !satisfies(&self.ranks, pairs) {
            let order = topological(&self.base, &all);
            let ranks = ranks(&order);
            if !satisfies(&ranks, &all) {
                return false;
            }
            (self.order, self.ranks) = (order, ranks);
        }
        self.pairs = all;
        true
    }
}

impl<'a> Orders<'a> {
    pub(super) fn new(solution: &'a Solution, behind: u32) -> Self {
        Self { solution, adjacency: Adjacency::new(solution.triangles()), behind, runs: Vec::new() }
    }

    /// Adds the next frame.
    pub(super) fn push(&mut self, frame: u32, motions: &[Motion], posed: &[DVec2]) {
        let (rest, triangles) = (self.solution.vertices(), self.solution.triangles());
        let by_depth = DepthOrder::new(triangles, self.solution.weights(), &depths(motions));
        let base = by_depth.order(triangles.len());
        let crossings = self.adjacency.crossings(PosedMesh { rest, posed, triangles });
        let pairs = by_depth.pairs(triangles, &crossings);
        let goes_on = self.runs.last_mut().is_some_and(|run| run.join(&pairs));
        if !goes_on {
            self.runs.push(Run::new(frame, base, pairs));
        }
    }

    pub(super) fn finish(self) -> Vec<Order> {
        let behind = self.behind;
        let of = |run: Run| {
            let is_of_mesh = run.order.is_sorted();
            let all = (0..behind).chain(run.order.iter().map(|t| t + behind));
            let triangles = if is_of_mesh { Vec::new() } else { all.collect() };
            Order { frame: run.frame, crosses: run.crosses(), triangles }
        };
        self.runs.into_iter().map(of).collect()
    }
}
