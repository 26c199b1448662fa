//! The drawing order of triangles along a clip.
//!
//! Only triangles that cover each other in the pose need an order. So one order is kept while it is valid for the pairs
//! of each frame. Otherwise it is sorted again for the pairs of all its frames, if possible.

use std::sync::Arc;

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

/// A drawing order and its first frame.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Order {
    pub(super) frame: u32,
    /// Whether parts cover each other in its frames.
    pub(super) crosses: bool,
    /// Indices of triangles; empty for the order of the mesh.
    pub(super) triangles: Arc<[u32]>,
}

/// Bits of the flags.
const CROSSES: u8 = 1;
/// Its own order follows.
const OWN: u8 = 2;
/// It has the previous order.
const SAME: u8 = 4;

impl Order {
    /// The order of the mesh, for a whole clip.
    pub(super) fn of_mesh() -> Vec<Self> {
        vec![Self { frame: 0, crosses: false, triangles: Arc::default() }]
    }

    pub(super) fn write(&self, before: Option<&Self>, to: &mut Writer) {
        let is_same = before.is_some_and(|before| before.triangles == self.triangles);
        let kind = if self.triangles.is_empty() {
            0
        } else if is_same {
            SAME
        } else {
            OWN
        };
        to.byte(if self.crosses { CROSSES } else { 0 } | kind);
        if kind != OWN {
            return;
        }
        let mut next = 0_i32;
        for &t in &*self.triangles {
            to.signed(t as i32 - next);
            next = t as i32 + 1;
        }
    }

    /// Reads the order of a number of triangles.
    pub(super) fn read(
        from: &mut Reader<'_>,
        frame: u32,
        before: Option<&Self>,
        count: usize,
    ) -> Result<Self, RigError> {
        let flags = from.byte()?;
        let crosses = flags & CROSSES != 0;
        match (flags & !CROSSES, before) {
            (0, _) => return Ok(Self { frame, crosses, triangles: Arc::default() }),
            (OWN, _) => {}
            (SAME, Some(before)) => return Ok(Self { frame, crosses, triangles: Arc::clone(&before.triangles) }),
            _ => return Err(from.wrong("has an unknown kind of drawing order")),
        }
        from.expect(from.has(Some(count)) && count > 0, "ends too early")?;
        let mut is_drawn = vec![false; count];
        let mut triangles = Vec::with_capacity(count);
        let mut next = 0_i32;
        for _ in 0..count {
            let t = next.wrapping_add(from.signed()?);
            let drawn = usize::try_from(t).ok().and_then(|t| is_drawn.get_mut(t));
            let is_new = drawn.is_some_and(|drawn| !std::mem::replace(drawn, true));
            from.expect(is_new, "has a drawing order that does not list each triangle once")?;
            triangles.push(t as u32);
            next = t + 1;
        }
        Ok(Self { frame, crosses, triangles: triangles.into() })
    }
}

/// Builds the orders frame by frame.
pub(super) struct Orders<'a> {
    solution: &'a Solution,
    adjacency: Adjacency,
    /// Triangles that are drawn before those of the solution.
    behind: u32,
    runs: Vec<Run>,
}

/// Frames with one order.
struct Run {
    /// Frames at which parts begin or cease to cross, including the first frame of the run.
    changes: Vec<(u32, bool)>,
    /// The triangles of the solution by depth in the first frame.
    base: Vec<u32>,
    /// The triangle in front, and the one behind it, in all frames.
    pairs: Vec<[u32; 2]>,
    order: Vec<u32>,
    /// The position of each triangle in the order.
    ranks: Vec<u32>,
}

impl Run {
    fn new(frame: u32, base: Vec<u32>, pairs: Vec<[u32; 2]>) -> Self {
        let order = topological(&base, &pairs);
        Self { changes: vec![(frame, !pairs.is_empty())], ranks: ranks(&order), base, pairs, order }
    }

    /// Adds the pairs of another frame, if one order satisfies them all.
    fn join(&mut self, frame: u32, pairs: &[[u32; 2]]) -> bool {
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
        let crosses = !pairs.is_empty();
        if self.changes.last().is_some_and(|&(_, before)| before != crosses) {
            self.changes.push((frame, crosses));
        }
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
        let goes_on = self.runs.last_mut().is_some_and(|run| run.join(frame, &pairs));
        if !goes_on {
            self.runs.push(Run::new(frame, base, pairs));
        }
    }

    pub(super) fn finish(self) -> Vec<Order> {
        let behind = self.behind;
        let of = |run: Run| {
            let is_of_mesh = run.order.is_sorted();
            let all = (0..behind).chain(run.order.iter().map(|t| t + behind));
            let triangles: Arc<[u32]> = if is_of_mesh { Arc::default() } else { all.collect() };
            let changes = run.changes.into_iter();
            changes.map(move |(frame, crosses)| Order { frame, crosses, triangles: Arc::clone(&triangles) })
        };
        self.runs.into_iter().flat_map(of).collect()
    }
}
