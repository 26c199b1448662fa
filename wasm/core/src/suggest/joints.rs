//! Finds the end, the neck and the bends of a limb.

use super::{
    cells::{Cells, UNITS},
    figure::LimbShape,
    skeleton::{Limb, Skeleton},
};
use crate::rank::{descending, sort_by_rank};

/// A head is a wide part before a neck. Its middle is at most this many times farther from the tip than from the
/// outline. So ears, toes and tongues belong to it.
const HEAD: f64 = 2.6;
/// Maximum width of a limb after a head, as a share of the head.
const AFTER_HEAD: f64 = 0.93;
/// In a round end, cells are about as far from the outline as from the tip.
const ROUND: f64 = 0.85;
/// A line along the axis of symmetry is at most this many cells away from it.
const NEAR_AXIS: usize = 2;
/// The minimum distance of an end handle from the tip, as a share of the limb.
const INSET: f64 = 0.07;
/// A neck is this many times narrower than both of its sides.
const NECK: f64 = 1.35;
/// A bend deviates from the straight line by this share of the line: in its middle, this is a turn of 27°.
const BEND: f64 = 0.12;
/// It deviates by at least this share of the limb's width, because the middle lines of thick limbs are uneven.
const BEND_OF_WIDTH: f64 = 0.2;
/// Bends of a limb are this many times farther apart than they are from the outline.
const BEND_ROOM: f64 = 3.0;
/// How many times a limb is divided at its strongest bend.
const DIVISIONS: usize = 3;
/// A straight limb has a joint in its middle if it is this many times longer than wide, without the end.
const LONG_LIMB: f64 = 0.9;
/// The same for a straight piece at a bend.
const LONG_PIECE: f64 = 3.0;

/// The measurements of a limb.
pub(super) struct MeasuredLimb<'a> {
    cells: &'a Cells,
    clearance: &'a [u32],
    limb: &'a Limb,
    diameter: u32,
    /// Cells of the path: the way from the tip, in units.
    ways: Vec<u32>,
}

impl<'a> MeasuredLimb<'a> {
    /// The limbs of a part.
    pub(super) fn of(skeleton: &'a Skeleton, cells: &'a Cells, clearance: &'a [u32]) -> Vec<Self> {
        let measured = |limb: &'a Limb| {
            let ways = ways(&limb.path, cells);
            Self { cells, clearance, limb, diameter: skeleton.diameter, ways }
        };
        skeleton.limbs.iter().map(measured).collect()
    }

    /// A share of the part's longest way, in units.
    pub(super) fn share(&self, share: f64) -> u32 {
        (f64::from(self.diameter) * share) as u32
    }

    /// How far the limb protrudes from the rest, in units.
    pub(super) fn length(&self) -> u32 {
        let base = self.limb.own.min(self.ways.len() - 1);
        self.ways[base].saturating_sub(self.clearance[self.limb.path[base]])
    }

    /// The number of protruding cells, from the tip on.
    fn inside(&self) -> usize {
        let own = self.length().max(1);
        self.ways.iter().take_while(|&&way| way <= own).count().max(1)
    }

    /// Index in the path of the handle at the end.
    fn end_index(&self) -> usize {
        let (own, inside) = (self.length().max(1), self.inside());
        let inset = (f64::from(own) * INSET) as u32 + 2 * UNITS;
        let least = self.ways.iter().take(inside).take_while(|&&way| way < inset).count().min(inside - 1);
        self.head(inside).unwrap_or_else(|| self.round_end(inside)).max(least)
    }

    /// Index of the middle of the last head, among a number of cells from the tip on.
    fn head(&self, inside: usize) -> Option<usize> {
        let (mut widest, mut head) = (0, None);
        for at in 0..inside {
            let width = |at: usize| f64::from(self.clearance[self.limb.path[at]]);
            if width(at) > width(widest) {
                widest = at;
            } else if width(at) <= AFTER_HEAD * width(widest) && f64::from(self.ways[widest]) <= HEAD * width(widest) {
                head = Some(widest);
            }
        }
        head
    }

    /// Index of the last cell of a round end.
    fn round_end(&self, inside: usize) -> usize {
        let is_round = |&at: &usize| ROUND * f64::from(self.ways[at]) <= f64::from(self.clearance[self.limb.path[at]]);
        (0..inside).take_while(is_round).last().unwrap_or_default()
    }

    /// The cells from the handle at the end to the root.
    pub(super) fn line(&self) -> &'a [usize] {
        &self.limb.path[self.end_index()..]
    }

    /// The cell of the handle at the end: the middle of a head, or near the tip.
    pub(super) fn end(&self) -> usize {
        let end = self.limb.path[self.end_index()];
        if self.has_head() { self.cells.widest_near(self.clearance, end) } else { end }
    }

    /// The limb as it stands out of the trunk.
    pub(super) fn shape(&self) -> LimbShape {
        let (inside, end) = (self.inside(), self.end());
        LimbShape {
            line: self.limb.path[..inside].iter().map(|&cell| self.cells.centre(cell)).collect(),
            end: self.cells.centre(end),
            length: self.cells.px(self.length()),
            width: self.cells.px(1) * self.width(0, inside / 2),
            outer_width: self.cells.px(1) * self.width(0, inside / 4),
            head: if self.has_head() { self.cells.px(self.clearance[end]) } else { 0.0 },
        }
    }

    /// Whether most of the limb lies on the axis of symmetry: the limb is its own mirror image.
    pub(super) fn is_on_axis(&self) -> bool {
        let own = &self.limb.path[..self.limb.own];
        let is_near = |&&cell: &&usize| self.cells.columns_to_axis(cell) <= NEAR_AXIS;
        2 * own.iter().filter(is_near).count() > own.len()
    }

    /// Whether the end is a head. Shorter limbs on it, such as ears, belong to it.
    pub(super) fn has_head(&self) -> bool {
        self.head(self.inside()).is_some()
    }

    /// The cells that belong to a head, as far from its middle as a tip may be.
    pub(super) fn around_head(&self, head: usize) -> Vec<u32> {
        self.cells.distances([(head, 0)], (HEAD * f64::from(self.clearance[head])) as u32)
    }

    /// The outermost cell.
    pub(super) fn tip(&self) -> usize {
        self.limb.path[0]
    }

    /// The narrowest cell between a head and a wider part, and its strength, at least 0.
    pub(super) fn neck(&self) -> Option<(f64, usize)> {
        let line = &self.limb.path[self.head(self.inside())?..];
        let widths: Vec<u32> = line.iter().map(|&cell| self.clearance[cell]).collect();
        let mut after = widths.clone();
        for at in (0..after.len() - 1).rev() {
            after[at] = after[at].max(after[at + 1]);
        }
        let mut before = 0;
        let mut best: Option<(f64, usize)> = None;
        for (at, &width) in widths.iter().enumerate() {
            before = before.max(width);
            let ratio = f64::from(before.min(after[at])) / f64::from(width.max(1));
            if ratio > best.map_or(NECK, |(best, _)| best) {
                best = Some((ratio, at));
            }
        }
        best.map(|(ratio, at)| ((ratio - 1.0).min(1.0) * 0.15, line[at]))
    }

    /// The cells at bends, each with its deviation from the straight line as a share of the part's longest way. Long
    /// straight pieces have joints in their middle, without a deviation.
    pub(super) fn joints(&self) -> Vec<(f64, usize)> {
        let (from, to) = (self.end_index(), self.inside() - 1);
        let mut joints = self.bends(from, to);
        let long = if joints.is_empty() { LONG_LIMB } else { LONG_PIECE };
        let mut corners: Vec<usize> = joints.iter().map(|joint| joint.1).chain([from, to]).collect();
        sort_by_rank(&mut corners, |&at| [at as i64, 0]);
        let radius = |at: usize| if at == to { 0 } else { self.clearance[self.limb.path[at]] };
        for piece in corners.windows(2) {
            let start = self.ways[piece[0]] + radius(piece[0]);
            let end = self.ways[piece[1]].saturating_sub(radius(piece[1]));
            if f64::from(end.saturating_sub(start)) >= long * self.width(piece[0], piece[1]) {
                joints.push((0.0, self.ways.partition_point(|&way| way < start.midpoint(end))));
            }
        }
        joints.into_iter().map(|(strength, at)| (strength, self.limb.path[at])).collect()
    }

    /// The strongest bends between two indices of the path. They are apart from each other and from the first index.
    fn bends(&self, from: usize, to: usize) -> Vec<(f64, usize)> {
        let mut bends = Vec::new();
        self.divide(from, to, DIVISIONS, &mut bends);
        sort_by_rank(&mut bends, |&(strength, _)| [descending(strength), 0]);
        let mut apart: Vec<(f64, usize)> = Vec::new();
        for bend in bends {
            let is_far = |at: usize| {
                let room = BEND_ROOM * f64::from(self.clearance[self.limb.path[at]]);
                f64::from(self.ways[at].abs_diff(self.ways[bend.1])) >= room
            };
            if is_far(from) && apart.iter().all(|other| is_far(other.1)) {
                apart.push(bend);
            }
        }
        apart
    }

    /// The mean width between two cells of the path, in units.
    #[inline(never)]
    fn width(&self, from: usize, to: usize) -> f64 {
        let line = &self.limb.path[from..=to];
        2.0 * line.iter().map(|&cell| f64::from(self.clearance[cell])).sum::<f64>() / line.len() as f64
    }

    fn divide(&self, from: usize, to: usize, divisions: usize, bends: &mut Vec<(f64, usize)>) {
        if divisions == 0 || to < from + 2 {
            return;
        }
        let point = |at: usize| self.cells.centre(self.limb.path[at]);
        let (a, b) = (point(from), point(to));
        let along = (b - a).normalize_or_zero();
        let departure = |at: usize| {
            let p = point(at) - a;
            // A loop has no chord.
            if along.length_squared() == 0.0 { p.length() } else { along.perp_dot(p).abs() }
        };
        let far = (from + 1..to).max_by(|&one, &other| departure(one).total_cmp(&departure(other)));
        let Some(far) = far else { return };
        let line = self.cells.px(self.ways[to] - self.ways[from]);
        if departure(far) >= (BEND * line).max(BEND_OF_WIDTH * self.cells.px(1) * self.width(from, to)) {
            bends.push((departure(far) / self.cells.px(self.diameter.max(1)), far));
            self.divide(from, far, divisions - 1, bends);
            self.divide(far, to, divisions - 1, bends);
        }
    }
}

/// The way from the first cell of a path to each of its cells.
fn ways(path: &[usize], cells: &Cells) -> Vec<u32> {
    let mut way = 0;
    let steps = path.windows(2).map(|step| {
        let [from, to] = [step[0], step[1]].map(|cell| cells.centre(cell));
        way += if from.x != to.x && from.y != to.y { 7 } else { UNITS };
        way
    });
    [0].into_iter().chain(steps).collect()
}
