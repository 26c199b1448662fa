//! The middle of a part, and its limbs: a tree of lines along the medial axis.
//!
//! After Sato et al., "TEASAR: tree-structure extraction algorithm for accurate and robust skeletons" (2000): the
//! farthest point from the root that no line covers begins the next line. The line follows a way to the root that keeps
//! away from the outline. It covers everything within a multiple of its distance from the outline. So ears, fingers and
//! a rough outline do not become separate limbs.
//!
//! A long limb pulls the middle of the shape away from the trunk. The centre lines are then traced again, from the wide
//! part where most of them meet.
//!
//! Cost: O(n log n) for the cells of a part, and a search in the covered cells of each limb.

use std::{cmp::Reverse, collections::BinaryHeap};

use super::cells::{Cells, FAR, UNITS};
use crate::rank::sort_by_rank;

/// A line covers this many times its distance from the outline, in tenths.
const COVER_TENTHS: u32 = 12;
/// Limbs shorter than this share of the longest way in the part are bumps of the outline.
const LEAST_LIMB: f64 = 0.06;
/// A hair or whisker has an outer half this many times thinner than the widest point of the part.
const HAIR: u64 = 14;
/// Maximum number of limbs, the longest first, because a rough outline has many ends.
const MOST_LIMBS: usize = 24;
/// Number of ends from which the middle is measured.
const MOST_EXTREMES: usize = 8;
/// How much more a cell near the outline costs than one in the middle of the widest part.
const CENTRING: u64 = 16;
/// Going outwards, a limb begins at the first cell below this width, as a fraction of the part's greatest width.
const WIDE: f64 = 0.6;
/// The minimum number of limbs of a trunk.
const TRUNK_LIMBS: usize = 3;
/// A root in this share of the trunk's radius is in its middle.
const IN_TRUNK: f64 = 0.7;

/// The tree of a part.
pub(super) struct Skeleton {
    /// The cell in the middle of the trunk.
    pub(super) root: usize,
    /// The longest way between two ends, in units.
    pub(super) diameter: u32,
    /// The limbs, starting with the farthest end.
    pub(super) limbs: Vec<Limb>,
}

/// A line from an end to the root.
pub(super) struct Limb {
    /// Cells from the end to the root.
    pub(super) path: Vec<usize>,
    /// Number of leading cells that no previous limb has.
    pub(super) own: usize,
}

impl Skeleton {
    pub(super) fn new(cells: &Cells, clearance: &[u32], part: &[usize]) -> Self {
        let (root, diameter) = middle(cells, clearance, part);
        let skeleton = Self::from_root(cells, clearance, part, root, diameter);
        match skeleton.trunk(cells, clearance) {
            Some(trunk) => Self::from_root(cells, clearance, part, trunk, diameter),
            None => skeleton,
        }
    }

    #[inline(never)]
    fn from_root(cells: &Cells, clearance: &[u32], part: &[usize], root: usize, diameter: u32) -> Self {
        let before = centred_ways(cells, clearance, part, root);
        let from_root = cells.distances([(root, 0)], FAR);
        let least = (f64::from(diameter) * LEAST_LIMB) as u32;
        let radius = |cell: usize| clearance[cell] * COVER_TENTHS / 10 + least;
        let mut is_covered = vec![false; cells.len()];
        let mut is_line = vec![false; cells.len()];
        is_line[root] = true;
        cover(cells, &[root], radius, &mut is_covered);
        let widest = part.iter().map(|&cell| clearance[cell]).max().unwrap_or_default();
        let mut limbs = Vec::new();
        let mut farthest: Vec<usize> = part.to_vec();
        sort_by_rank(&mut farthest, |&cell| [-i64::from(from_root[cell]), 0]);
        for end in farthest {
            if is_covered[end] || limbs.len() == MOST_LIMBS {
                continue;
            }
            let path: Vec<usize> =
                std::iter::successors(Some(end), |&cell| Some(before[cell]).filter(|_| cell != root)).collect();
            let own = path.iter().take_while(|&&cell| !is_line[cell]).count();
            path[..own].iter().for_each(|&cell| is_line[cell] = true);
            cover(cells, &path[..own], radius, &mut is_covered);
            let base = path[own.min(path.len() - 1)];
            let is_out = |&&cell: &&usize| cells.centre(cell).distance(cells.centre(base)) > cells.px(clearance[base]);
            let outer = &path[..path[..own].iter().take_while(is_out).count().div_ceil(2)];
            let width = outer.iter().map(|&cell| u64::from(clearance[cell])).sum::<u64>();
            if width * HAIR >= outer.len() as u64 * u64::from(widest) {
                limbs.push(Limb { path, own });
            }
        }
        Self { root, diameter, limbs }
    }

    /// The middle of the wide part where most limbs meet. `None` if the root is there, or if no part has the most.
    fn trunk(&self, cells: &Cells, clearance: &[u32]) -> Option<usize> {
        let all = self.limbs.iter().flat_map(|limb| &limb.path);
        let least = (f64::from(all.map(|&cell| clearance[cell]).max()?) * WIDE) as u32;
        let apart = |one: usize, other: usize| cells.centre(one).distance(cells.centre(other));
        // Each wide part with the number of its limbs.
        let mut trunks: Vec<(usize, usize)> = Vec::new();
        for limb in &self.limbs {
            let wide = limb.path.iter().copied().find(|&cell| clearance[cell] >= least).unwrap_or(self.root);
            let middle = cells.widest_near(clearance, wide);
            let is_same = |&(trunk, _): &(usize, usize)| {
                apart(trunk, middle) <= cells.px(clearance[trunk].max(clearance[middle]))
            };
            match trunks.iter().position(is_same) {
                Some(at) => trunks[at].1 += 1,
                None => trunks.push((middle, 1)),
            }
        }
        let most = trunks.iter().map(|trunk| trunk.1).max().filter(|&most| most >= TRUNK_LIMBS)?;
        let mut trunks = trunks.into_iter().filter(|trunk| trunk.1 == most);
        let (Some((trunk, _)), None) = (trunks.next(), trunks.next()) else { return None };
        (apart(trunk, self.root) > IN_TRUNK * cells.px(clearance[trunk])).then_some(trunk)
    }
}

/// Marks all cells within the radius of any of the given cells.
fn cover(cells: &Cells, line: &[usize], radius: impl Fn(usize) -> u32, is_covered: &mut [bool]) {
    let greatest = line.iter().map(|&cell| radius(cell)).max().unwrap_or_default();
    let sources = line.iter().map(|&cell| (cell, greatest - radius(cell)));
    let distances = cells.distances(sources, greatest);
    is_covered.iter_mut().zip(distances).for_each(|(covered, distance)| *covered |= distance != FAR);
}

/// The cell that is near to all ends and far from the outline, and the longest way between two ends.
fn middle(cells: &Cells, clearance: &[u32], part: &[usize]) -> (usize, u32) {
    let widest = part.iter().map(|&cell| clearance[cell]).max().unwrap_or_default();
    let start = part.iter().filter(|&&cell| clearance[cell] == widest).map(|&cell| (cell, 0));
    let mut nearest = cells.distances(start, FAR);
    let mut greatest = vec![0; cells.len()];
    let mut extremes: Vec<usize> = Vec::new();
    while extremes.len() < MOST_EXTREMES {
        let most = part.iter().map(|&cell| nearest[cell]).max().unwrap_or_default();
        // A round part has two ends, too.
        if most == 0 || most < widest && extremes.len() > 1 {
            break;
        }
        // Equally far ends count alike, so that a symmetric part has its middle on the axis.
        let mut ends: Vec<usize> = part.iter().copied().filter(|&cell| nearest[cell] == most).collect();
        while let Some(&first) = ends.first() {
            let around = cells.distances([(first, 0)], widest.max(4 * UNITS));
            let (near, rest): (Vec<usize>, Vec<usize>) = ends.iter().partition(|&&cell| around[cell] != FAR);
            let end = cells.central(&near);
            let distances = cells.distances([(end, 0)], FAR);
            for &cell in part {
                greatest[cell] = distances[cell].max(greatest[cell]);
                // The start is no end.
                nearest[cell] = if extremes.is_empty() { distances[cell] } else { nearest[cell].min(distances[cell]) };
            }
            extremes.push(end);
            ends = if extremes.len() < MOST_EXTREMES { rest } else { Vec::new() };
        }
    }
    let diameter = extremes.iter().map(|&end| greatest[end]).max().unwrap_or_default();
    let score = |cell: usize| i64::from(greatest[cell]) - 2 * i64::from(clearance[cell]);
    let best = part.iter().map(|&cell| score(cell)).min().unwrap_or_default();
    let ties: Vec<usize> = part.iter().copied().filter(|&cell| score(cell) == best).collect();
    (cells.central(&ties), diameter)
}

/// For each cell of a part, the next cell on the way to the root that keeps away from the outline.
fn centred_ways(cells: &Cells, clearance: &[u32], part: &[usize], root: usize) -> Vec<usize> {
    let widest = u64::from(part.iter().map(|&cell| clearance[cell]).max().unwrap_or(1));
    let weight = |cell: usize| {
        let clearance = u64::from(clearance[cell].max(1));
        1 + CENTRING * widest * widest / (clearance * clearance)
    };
    let mut before = vec![root; cells.len()];
    let mut cost = vec![u64::MAX; cells.len()];
    cost[root] = 0;
    let mut open = BinaryHeap::from([Reverse((0, root))]);
    while let Some(Reverse((known, cell))) = open.pop() {
        if known > cost[cell] {
            continue;
        }
        cells.visit_neighbours(cell, |next, step| {
            let total = known + u64::from(step) * weight(next);
            if total < cost[next] {
                (cost[next], before[next]) = (total, cell);
                open.push(Reverse((total, next)));
            }
        });
    }
    before
}
