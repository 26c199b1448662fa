//! Chooses handles by importance, each with room around it.

use glam::DVec2;

use super::{
    SuggestedRole,
    cells::{Cells, FAR},
    figure::Figure,
    joints::MeasuredLimb,
    skeleton::Skeleton,
    taken::taken_cells,
};
use crate::{
    domain::Domain,
    project::Handle,
    rank::{descending, sort_by_rank},
};

const FEWEST: usize = 5;
const MOST: usize = 14;
/// Smaller parts, as a share of the largest, have no handle of their own.
const LEAST_PART: f64 = 0.02;
/// Room around the ends of limbs and around joints, as shares of the longest way in a part.
const END_ROOM: f64 = 0.13;
const JOINT_ROOM: f64 = 0.13;
/// Ways longer than this share of the longest one get a joint.
const LONG_WAY: f64 = 0.17;
/// A domain is symmetric if it contains the mirror image of this share of its cells. Then handles come in pairs.
const SYMMETRIC: f64 = 0.94;
/// Pairs are farther apart than this share of the room around joints. Nearer pairs are merged into one handle on the
/// axis.
const PAIR_ROOM: f64 = 0.7;
/// In wide parts, pairs are this many times farther apart.
const WIDE_PAIR: u32 = 2;
/// Positions in wide parts that are farther than this share from all handles get one.
const WIDE: f64 = 0.26;
/// A part with this share of all cells is a figure, and smaller parts lie beside it.
const FIGURE: f64 = 0.6;
/// Room around all handles, as a share of their mean distance in a square.
const ROOM: f64 = 0.3;
/// Handles are at least this far apart, in pixels.
const LEAST_ROOM_PX: f64 = 1.5;
/// Number of points of a cell that are tried, on each side of its centre.
const PROBES: i32 = 4;
/// Greatest ratio of a handle's distance to other handles and to the outline, in a wide part.
const FROM_OUTLINE: u32 = 3;

/// A handle, before it has an id.
#[derive(Debug)]
pub(super) struct Place {
    pub(super) at: DVec2,
    pub(super) role: SuggestedRole,
    /// Its part of a figure. `None` if it is named after its position.
    pub(super) name: Option<String>,
}

/// The handles, the most important first. Existing handles also have room around them.
pub(super) fn places(domain: &Domain, count: Option<usize>, there: &[Handle]) -> Vec<Place> {
    let cells = Cells::new(domain);
    let clearance = cells.clearance();
    let most = count.unwrap_or(MOST);
    let mut parts = cells.parts();
    let least = parts.first().map_or(0.0, |part| part.len() as f64 * LEAST_PART);
    parts.retain(|part| part.len() as f64 >= least);
    parts.truncate(most);
    let skeletons: Vec<Skeleton> = parts.iter().map(|part| Skeleton::new(&cells, &clearance, part)).collect();
    let measured = |skeleton| MeasuredLimb::of(skeleton, &cells, &clearance);
    let limbs: Vec<MeasuredLimb<'_>> = skeletons.iter().flat_map(measured).collect();
    let longest = f64::from(skeletons.iter().map(|skeleton| skeleton.diameter).max().unwrap_or_default());
    let taken = taken_cells(&cells, there);
    let nearest = cells.distances(taken.iter().map(|&cell| (cell, 0)), FAR - 16);
    let widest = clearance.iter().copied().filter(|&clearance| clearance != FAR).max().unwrap_or_default();
    let from_circles = cells.distances(taken.iter().map(|&cell| (cell, widest - clearance[cell])), FAR - 16);
    let symmetric = cells.symmetry() >= SYMMETRIC;
    let pair_room = (longest * JOINT_ROOM * PAIR_ROOM) as u32;
    let mut placing = Placing {
        cells: &cells,
        clearance: &clearance,
        widest,
        symmetric,
        pair_room,
        most,
        nearest,
        from_circles,
        chosen: Vec::new(),
    };
    for skeleton in &skeletons {
        // The first handle of a part needs no room.
        let room = if there.is_empty() { 0 } else { (f64::from(skeleton.diameter) * JOINT_ROOM) as u32 };
        placing.choose(skeleton.root, SuggestedRole::Middle, room);
    }
    let limbs = placing.choose_ends(limbs);
    placing.choose_joints(&limbs);
    let lines: Vec<usize> = limbs.iter().flat_map(MeasuredLimb::line).copied().collect();
    placing.fill(&lines, SuggestedRole::Joint, most, (longest * LONG_WAY) as u32, u32::MAX);
    let all = parts.concat();
    if count.is_none() {
        placing.fill(&all, SuggestedRole::Spread, most, (longest * WIDE) as u32, FROM_OUTLINE);
    }
    let wanted = count.unwrap_or(FEWEST).saturating_sub(there.len());
    placing.fill(&lines, SuggestedRole::Joint, wanted, (longest * JOINT_ROOM) as u32, u32::MAX);
    let area = all.len() as f64 * cells.side * cells.side;
    let room = cells.units((area / wanted.max(1) as f64).sqrt() * ROOM);
    placing.fill(&all, SuggestedRole::Spread, wanted, room, FROM_OUTLINE);
    let figure = parts.first().filter(|part| part.len() as f64 >= FIGURE * all.len() as f64).map(|part| {
        let of_part = limbs.iter().filter(|limb| part.binary_search(&limb.tip()).is_ok());
        let (root, shapes) = (skeletons[0].root, of_part.map(MeasuredLimb::shape).collect());
        (part, Figure::new(cells.centre(root), cells.px(clearance[root]), shapes, domain.bounds()))
    });
    let place = |&(cell, role): &(usize, SuggestedRole)| {
        let of_cell = figure.as_ref().filter(|(part, _)| part.binary_search(&cell).is_ok());
        let name = of_cell.and_then(|(_, of)| of.name(cells.centre(cell), role, cells.px(clearance[cell])));
        Place { at: position(&cells, domain, cell, clearance[cell]), role, name }
    };
    placing.chosen.iter().map(place).collect()
}

struct Placing<'a> {
    cells: &'a Cells,
    clearance: &'a [u32],
    /// The greatest clearance.
    widest: u32,
    /// Whether handles come in pairs, on both sides of the vertical axis.
    symmetric: bool,
    /// The minimum distance of a pair.
    pair_room: u32,
    most: usize,
    /// For each cell, the way to the nearest chosen one.
    nearest: Vec<u32>,
    /// The same to the largest circle in the outline around a handle, plus the greatest clearance.
    from_circles: Vec<u32>,
    chosen: Vec<(usize, SuggestedRole)>,
}

impl Placing<'_> {
    /// Chooses a cell if another handle is wanted and it has room. In a symmetric domain, its mirror image is also
    /// chosen, or both are merged into one cell on the axis.
    fn choose(&mut self, cell: usize, role: SuggestedRole, room: u32) {
        let room = room.max(self.cells.units(LEAST_ROOM_PX));
        let apart = match role {
            SuggestedRole::Spread => self.pair_room * WIDE_PAIR,
            SuggestedRole::Joint => self.pair_room.max(2 * self.clearance[cell]),
            _ => self.pair_room,
        };
        let has_room = |cell: usize| self.nearest[cell] > room && self.is_apart(cell, role);
        if self.chosen.len() >= self.most || !has_room(cell) {
            return;
        }
        // Among many handles, the cell on the axis may have less room.
        let is_as_good = |one: usize| has_room(one) && self.nearest[one] >= self.nearest[cell] / 2;
        let [cell, twin] = Some(self.pair(cell, apart)).filter(|&[one, _]| is_as_good(one)).unwrap_or([cell; 2]);
        let is_pair = twin != cell && self.chosen.len() + 2 <= self.most && has_room(twin);
        if role == SuggestedRole::Joint && twin != cell && !is_pair {
            return;
        }
        for chosen in [cell].into_iter().chain(is_pair.then_some(twin)) {
            self.chosen.push((chosen, role));
            self.cells.shorten(&mut self.nearest, [(chosen, 0)], FAR - 16);
            let from = self.widest - self.clearance[chosen];
            self.cells.shorten(&mut self.from_circles, [(chosen, from)], FAR - 16);
        }
    }

    /// Whether a joint is at least a limb's width from the other handles: the largest circles in the outline around
    /// them do not overlap.
    fn is_apart(&self, cell: usize, role: SuggestedRole) -> bool {
        role != SuggestedRole::Joint || self.from_circles[cell] >= self.widest + self.clearance[cell]
    }

    /// A cell with its mirror image, which is the same if they are nearer than `least`.
    fn pair(&self, cell: usize, least: u32) -> [usize; 2] {
        let twin = self.cells.mirrored(cell);
        if !self.symmetric || !self.cells.is_inside(twin) {
            return [cell; 2];
        }
        let apart = self.cells.units(self.cells.centre(cell).distance(self.cells.centre(twin)));
        let middle = self.cells.on_axis(cell);
        if apart <= least && self.cells.is_inside(middle) {
            return [middle; 2];
        }
        [cell, twin]
    }

    /// Chooses ends, those of the longest limbs first. Returns the limbs except those on a head, which have no handles
    /// of their own.
    fn choose_ends<'b>(&mut self, mut limbs: Vec<MeasuredLimb<'b>>) -> Vec<MeasuredLimb<'b>> {
        sort_by_rank(&mut limbs, |limb| [-i64::from(limb.length()), 0]);
        let mut heads: Vec<Vec<u32>> = Vec::new();
        limbs.retain(|limb| {
            if heads.iter().any(|around| around[limb.tip()] != FAR) {
                return false;
            }
            let own = limb.end();
            let middle = self.cells.on_axis(own);
            let is_middle = self.symmetric && limb.is_on_axis() && self.cells.is_inside(middle);
            let end = if is_middle { middle } else { own };
            self.choose(end, SuggestedRole::End, limb.share(END_ROOM));
            if limb.has_head() {
                heads.push(limb.around_head(end));
            }
            true
        });
        limbs
    }

    /// Chooses necks and bends, the strongest first, and then the middles of long straight pieces.
    fn choose_joints(&mut self, limbs: &[MeasuredLimb<'_>]) {
        let joints_of = |limb: &MeasuredLimb<'_>| limb.joints().into_iter().chain(limb.neck());
        let mut joints: Vec<(f64, usize)> = limbs.iter().flat_map(joints_of).collect();
        sort_by_rank(&mut joints, |&(strength, _)| [descending(strength), 0]);
        joints.into_iter().for_each(|(_, joint)| self.choose(joint, SuggestedRole::Joint, 0));
    }

    /// Repeatedly chooses the cell with the greatest score, up to a number of handles. The score is the distance to the
    /// nearest handle, but at most a multiple of the distance to the outline. Cells with scores below `least` have no
    /// room.
    fn fill(&mut self, of: &[usize], role: SuggestedRole, wanted: usize, least: u32, from_outline: u32) {
        while self.chosen.len() < wanted {
            let score = |cell: usize| self.nearest[cell].min(self.clearance[cell].saturating_mul(from_outline));
            let free = of.iter().copied().filter(|&cell| self.is_apart(cell, role));
            let Some(best) = free.max_by_key(|&cell| (score(cell), std::cmp::Reverse(cell))) else {
                return;
            };
            let before = self.chosen.len();
            if score(best) >= least {
                self.choose(best, role, 0);
            }
            if self.chosen.len() == before {
                return;
            }
        }
    }
}

/// The position of a cell, in whole pixels if the domain has room for it.
fn position(cells: &Cells, domain: &Domain, cell: usize, clearance: u32) -> DVec2 {
    let centre = cells.centre(cell);
    if cells.px(clearance) > cells.side + 1.0 {
        return centre.round();
    }
    // A cell of a line may have its centre beside it: take the point that is farthest from the outline.
    let offset = |at: i32| f64::from(at) / f64::from(PROBES) * cells.side;
    let probes = (-PROBES..=PROBES).flat_map(|y| (-PROBES..=PROBES).map(move |x| DVec2::new(offset(x), offset(y))));
    let inside = probes.map(|offset| centre + offset).filter(|&p| is_inside(domain, p));
    let deep =
        inside.map(|p| (domain.distance_to_outline(p), p)).reduce(|best, one| if one.0 > best.0 { one } else { best });
    deep.map_or_else(|| nearest_corner(domain, centre), |(_, p)| p)
}

/// Whether a point is in a domain, by the even-odd rule.
fn is_inside(domain: &Domain, p: DVec2) -> bool {
    let crosses = |(a, b): &(DVec2, DVec2)| {
        (a.y <= p.y) != (b.y <= p.y) && a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) <= p.x
    };
    domain.edges().filter(crosses).count() % 2 == 1
}

/// The corner of the outline nearest to a point.
fn nearest_corner(domain: &Domain, p: DVec2) -> DVec2 {
    let corners = domain.rings().iter().flatten().copied();
    let nearer = |one: DVec2, other: DVec2| if other.distance(p) < one.distance(p) { other } else { one };
    corners.reduce(nearer).unwrap_or(p)
}
