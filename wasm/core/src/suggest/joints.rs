//! Finds the end, the neck and the bends of a limb.

use super::{
    cells::{Cells, UNITS},
    skeleton::{Limb, Skeleton},
};

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
/// A bend deviates from the straight line by this share of the part's longest way.
const BEND: f64 = 0.09;
/// How many times a limb is divided at its strongest bend.
const DIVISIONS: usize = 3;

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

    /// The narrowest cell between two wider parts, and its strength, at least 0.
    pub(super) fn neck(&self) -> Option<(f64, usize)> {
        let widths: Vec<u32> = self.limb.path.iter().map(|&cell| self.clearance[cell]).collect();
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
        best.map(|(ratio, at)| ((ratio - 1.0).min(1.0) * 0.15, self.limb.path[at]))
    }

    /// The cells at bends, each with its deviation from the straight line as a share of the part's longest way.
    pub(super) fn bends(&self) -> Vec<(f64, usize)> {
        let mut bends = Vec::new();
        self.divide(self.end_index(), self.limb.path.len() - 1, DIVISIONS, &mut bends);
        bends
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
        let share = departure(far) / self.cells.px(self.diameter.max(1));
        if share >= BEND {
            bends.push((share, self.limb.path[far]));
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
