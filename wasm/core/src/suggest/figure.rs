//! Tells the head, arms, legs and tail of a figure by shape and position, and names handles after them.
//!
//! A head is a wide end beyond a neck. If it is above the trunk, limbs that hang side by side are legs; the others are
//! arms. If it is beside the trunk, as in an animal from the side or from above, all limbs are legs. A single limb far
//! from the head is a tail. Without a head, limbs are legs if all of them hang, as in an octopus. Else they are named
//! parts.
//!
//! Left and right are those of the picture.

use glam::DVec2;

use super::SuggestedRole;
use crate::rank::{ascending, descending, sort_by_rank};

/// An arm, leg or tail is at least this long, as a share of its width.
const SLENDER: f64 = 0.6;
/// The outer quarter of an arm or leg is at least this wide, as a share of its width. Fins and spikes are pointed.
const BLUNT: f64 = 0.35;
/// A limb hangs if it goes down this many times farther than aside.
const STEEP: f64 = 1.2;
/// A head is at least this wide, as a share of the trunk.
const HEAD: f64 = 0.5;
/// Other round ends are smaller than this share of a head.
const ALONE: f64 = 0.8;
/// A head is above the trunk if it is this many times farther up than aside.
const ABOVE: f64 = 0.8;
/// Least width of a leg, as a fraction of the widest one: a tail beside legs is thinner.
const LEG: f64 = 0.6;
/// A person has as many arms and legs.
const ARMS_AND_LEGS: usize = 4;
/// The minimum number of legs of a figure without a head.
const LEGS_ALONE: usize = 3;
/// A joint that is wider than this share of the trunk belongs to the body.
const BODY: f64 = 0.85;
/// A joint of the body is beside its middle if it is farther than this share of its half width.
const BESIDE: f64 = 0.6;
/// Of an odd number of arms or legs, those nearer to their middle than this share of their width have no side.
const IN_LINE: f64 = 0.1;
/// Other limbs have a side if they are farther from the middle of the picture than this share of its size.
const OUTER: f64 = 0.14;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Head,
    Arm,
    Leg,
    Tail,
    Other,
}

/// A limb as it stands out of the trunk.
#[derive(Debug)]
pub(super) struct LimbShape {
    /// The middle line from the tip to the trunk.
    pub(super) line: Vec<DVec2>,
    /// The handle at the end.
    pub(super) end: DVec2,
    pub(super) length: f64,
    /// The mean widths of the outer half and quarter.
    pub(super) width: f64,
    pub(super) outer_width: f64,
    /// The radius of its head, or 0.
    pub(super) head: f64,
}

/// A trunk with limbs.
#[derive(Debug)]
pub(super) struct Figure {
    trunk: DVec2,
    /// The distance from the middle of the trunk to the outline.
    half_width: f64,
    limbs: Vec<LimbShape>,
    /// The bounding box of the picture's shape.
    bounds: (DVec2, DVec2),
    parts: Vec<Part>,
    /// The names of the limbs: `left-arm`.
    names: Vec<String>,
}

impl LimbShape {
    fn base(&self) -> DVec2 {
        self.line[self.line.len() - 1]
    }

    fn is_slender(&self) -> bool {
        self.length >= SLENDER * self.width && self.outer_width >= BLUNT * self.width
    }

    fn hangs(&self) -> bool {
        let way = self.end - self.base();
        way.y >= STEEP * way.x.abs()
    }
}

impl Figure {
    pub(super) fn new(trunk: DVec2, half_width: f64, limbs: Vec<LimbShape>, bounds: (DVec2, DVec2)) -> Self {
        let mut figure = Self { trunk, half_width, limbs, bounds, parts: Vec::new(), names: Vec::new() };
        figure.parts = figure.parts();
        figure.names = figure.limb_names();
        figure
    }

    /// The name of a handle with its distance to the outline. `None` if only its position in the picture tells
    /// anything.
    pub(super) fn name(&self, at: DVec2, role: SuggestedRole, radius: f64) -> Option<String> {
        let distance = |limb: usize| {
            let line = self.limbs[limb].line.iter();
            line.map(|p| p.distance_squared(at)).fold(f64::INFINITY, f64::min)
        };
        let nearest = (0..self.limbs.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        let is_known = self.parts.iter().any(|&part| part != Part::Other);
        let name = match (role, nearest) {
            (SuggestedRole::Middle, _) => if is_known { "body" } else { "middle" }.to_owned(),
            (SuggestedRole::End, Some(limb)) if self.parts[limb] == Part::Head => "head".to_owned(),
            // One limb of a pair may have the ends of both.
            (SuggestedRole::End, Some(limb)) if self.parts[limb] == Part::Other => self.region(at) + "-end",
            (SuggestedRole::End, Some(limb)) => self.names[limb].clone() + "-end",
            (SuggestedRole::Joint, Some(limb)) if !is_known || radius < BODY * self.half_width => {
                match self.parts[limb] {
                    Part::Head => "neck".to_owned(),
                    _ => self.names[limb].clone() + "-joint",
                }
            }
            _ if is_known => {
                let (way, least) = (at - self.trunk, BESIDE * self.half_width);
                named(height(way.y, least), side(way.x, least), "body")
            }
            _ => return None,
        };
        Some(name)
    }

    /// The part that each limb is.
    fn parts(&self) -> Vec<Part> {
        let mut parts = vec![Part::Other; self.limbs.len()];
        let is_slender = |limb: usize| self.limbs[limb].is_slender();
        let Some(head) = self.head() else {
            let is_leg = |limb: &LimbShape| limb.end.y > self.trunk.y && limb.end.y > limb.base().y;
            if parts.len() >= LEGS_ALONE && self.limbs.iter().all(is_leg) {
                (0..parts.len()).filter(|&limb| is_slender(limb)).for_each(|limb| parts[limb] = Part::Leg);
            }
            return parts;
        };
        parts[head] = Part::Head;
        let from_head = |p: DVec2| p.distance(self.limbs[head].end);
        let hangs = |limb: usize| limb != head && is_slender(limb) && self.limbs[limb].hangs();
        let width = |limb: usize| if hangs(limb) { self.limbs[limb].width } else { 0.0 };
        let widest = (0..parts.len()).map(width).fold(0.0, f64::max);
        let is_leg = |limb: usize| hangs(limb) && width(limb) >= LEG * widest;
        let mut legs = (0..parts.len()).filter(|&limb| is_leg(limb)).count();
        if legs < 2 {
            legs = 0;
        }
        let mut others: Vec<usize> = Vec::new();
        for (limb, part) in parts.iter_mut().enumerate() {
            if legs > 0 && is_leg(limb) {
                *part = Part::Leg;
            } else if limb != head && is_slender(limb) {
                others.push(limb);
            }
        }
        sort_by_rank(&mut others, |&limb| [ascending(from_head(self.limbs[limb].base())), 0]);
        let is_tail = |limb: usize| {
            let has_head = self.limbs[limb].head >= HEAD * self.half_width;
            !has_head && from_head(self.limbs[limb].base()) > from_head(self.trunk)
        };
        if let Some(&last) = others.last().filter(|&&last| (legs + others.len()) % 2 == 1 && is_tail(last)) {
            parts[last] = Part::Tail;
            others.pop();
        }
        let way = self.limbs[head].end - self.trunk;
        let is_upright = -way.y >= ABOVE * way.x.abs() && legs + others.len() <= ARMS_AND_LEGS;
        let arms = match others.len() {
            _ if !is_upright => 0,
            ARMS_AND_LEGS => 2,
            all => all,
        };
        for (at, &limb) in others.iter().enumerate() {
            parts[limb] = if at < arms { Part::Arm } else { Part::Leg };
        }
        parts
    }

    /// The limb with the head: not below the trunk, and much larger than all others.
    fn head(&self) -> Option<usize> {
        let is_up = |limb: &LimbShape| limb.end.y - self.trunk.y < ABOVE * (limb.end.x - self.trunk.x).abs();
        let is_head = |limb: usize| self.limbs[limb].head >= HEAD * self.half_width && is_up(&self.limbs[limb]);
        let heads = || (0..self.limbs.len()).filter(|&limb| is_head(limb));
        let largest = heads().map(|limb| self.limbs[limb].head).fold(0.0, f64::max);
        let is_large = |&limb: &usize| self.limbs[limb].head >= ALONE * largest;
        let mut large = heads().filter(is_large);
        large.next().filter(|_| large.next().is_none())
    }

    /// The name of a limb at a point in the picture, if nothing tells what it is.
    #[inline(never)]
    fn region(&self, at: DVec2) -> String {
        let (low, high) = self.bounds;
        let way = (at - low.midpoint(high)) / (high - low).max(DVec2::splat(1e-9));
        named(height(way.y, OUTER), side(way.x, OUTER), "part")
    }

    /// The names of the limbs: part and side. Several limbs of a side have numbers from the outside in.
    fn limb_names(&self) -> Vec<String> {
        let name = |limb: usize| match self.parts[limb] {
            Part::Tail => "tail".to_owned(),
            _ => self.region(self.limbs[limb].end),
        };
        let mut names: Vec<String> = (0..self.limbs.len()).map(name).collect();
        for (part, word) in [(Part::Arm, "arm"), (Part::Leg, "leg")] {
            let of_part = || (0..self.limbs.len()).filter(|&limb| self.parts[limb] == part);
            let xs = || of_part().map(|limb| self.limbs[limb].end.x);
            let (left, right) = (xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max));
            // A single limb has a side of the trunk, and others have a side of each other.
            let (middle, least) = match of_part().count() {
                1 => (self.trunk.x, self.half_width),
                count => (left.midpoint(right), IN_LINE * (right - left) * (count % 2) as f64),
            };
            let way = |limb: usize| self.limbs[limb].end - DVec2::new(middle, self.trunk.y);
            let rank = |limb: usize| [descending(way(limb).x.abs()), ascending(way(limb).y)];
            for limb in of_part() {
                let (of_side, own_height) = (side(way(limb).x, least), height(way(limb).y, 0.0));
                let same = || of_part().filter(|&other| side(way(other).x, least) == of_side);
                let is_pair = same().count() == 2 && same().any(|other| height(way(other).y, 0.0) != own_height);
                names[limb] = named(if is_pair { own_height } else { "" }, of_side, word);
                let before = same().filter(|&other| rank(other) < rank(limb)).count();
                if before > 0 && !is_pair {
                    names[limb] += &format!("-{}", before + 1);
                }
            }
        }
        names
    }
}

#[inline(never)]
fn named(height: &str, side: &str, part: &str) -> String {
    [height, side, part].concat()
}

/// The side of a middle, beyond a distance.
fn side(x: f64, least: f64) -> &'static str {
    match x {
        x if x < -least => "left-",
        x if x > least => "right-",
        _ => "",
    }
}

/// The height beside a middle, beyond a distance.
fn height(y: f64, least: f64) -> &'static str {
    match y {
        y if y < -least => "upper-",
        y if y > least => "lower-",
        _ => "",
    }
}
