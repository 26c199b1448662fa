//! Cuts lines into pieces where they turn and meet.
//!
//! Cost: O(n²) in the segments of all lines.

use glam::DVec2;

use super::{Anchor, Polyline};
use crate::{
    error::Error,
    limits::{MAX_SITES, MIN_SEPARATION},
    segment::{nearest_on_segment, segment_distance},
};

/// Two segments that touch at places this far apart, in pixels, run along each other.
const OVERLAP: f64 = 10.0 * MIN_SEPARATION;

/// A piece of a line between two joints.
pub(super) struct Piece {
    pub(super) handle: u32,
    pub(super) segment: u32,
    /// The shares of the segment at which it begins and ends, 0 to 1.
    pub(super) shares: [f64; 2],
    pub(super) joints: [u32; 2],
}

impl Piece {
    /// The ends of a piece of `line`.
    pub(super) fn ends(&self, line: &Polyline) -> [DVec2; 2] {
        let (a, b) = line.segment(self.segment as usize);
        self.shares.map(|share| a.lerp(b, share))
    }
}

/// All pieces, and what each joint is made of.
pub(super) struct Cuts {
    pub(super) pieces: Vec<Piece>,
    pub(super) joints: Vec<Vec<Anchor>>,
}

/// A segment of a line with the places where it is cut.
struct Segment<'a> {
    line: &'a Polyline,
    number: usize,
    a: DVec2,
    b: DVec2,
    /// Shares of the segment, each with the node there.
    stops: Vec<(f64, usize)>,
}

impl Cuts {
    /// # Errors
    /// [`Error::BarTooShort`], [`Error::BarsOverlap`]; [`Error::TooManySites`] for more pieces than there may be sites.
    pub(super) fn new(lines: &[&Polyline]) -> Result<Self, Error> {
        let mut nodes = Nodes::default();
        let mut segments = Vec::new();
        for line in lines {
            segments.extend(Segment::all_of(line, &mut nodes)?);
        }
        stop_where_they_meet(&mut segments, &mut nodes)?;
        let joints = nodes.joints();
        let pieces = segments.into_iter().flat_map(|segment| segment.pieces(&nodes)).collect();
        Ok(Self { pieces, joints })
    }
}

impl<'a> Segment<'a> {
    /// The segments of a line, each with a node at its ends.
    ///
    /// # Errors
    /// [`Error::BarTooShort`].
    fn all_of(line: &'a Polyline, nodes: &mut Nodes) -> Result<Vec<Self>, Error> {
        let first = nodes.anchors.len();
        for corner in 0..line.corners.len() {
            // The last corner of an open line is the end of the last segment.
            let (segment, share) = if corner < line.segments() { (corner, 0.0) } else { (line.segments() - 1, 1.0) };
            nodes.add(Anchor { handle: line.handle, segment: segment as u32, share });
        }
        let segment = |number: usize| {
            let (a, b) = line.segment(number);
            if a.distance(b) < MIN_SEPARATION {
                return Err(Error::BarTooShort { id: line.id.clone(), corner: number });
            }
            let end = first + (number + 1) % line.corners.len();
            Ok(Self { line, number, a, b, stops: vec![(0.0, first + number), (1.0, end)] })
        };
        (0..line.segments()).map(segment).collect()
    }

    /// The node at a place on the segment: an existing one nearby, or a new one.
    fn stop(&mut self, p: DVec2, nodes: &mut Nodes) -> usize {
        let along = self.b - self.a;
        let share = ((p - self.a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let near = MIN_SEPARATION / along.length();
        if let Some(&(_, node)) = self.stops.iter().find(|(known, _)| (known - share).abs() < near) {
            return node;
        }
        let node = nodes.add(Anchor { handle: self.line.handle, segment: self.number as u32, share });
        self.stops.push((share, node));
        node
    }

    /// The pieces between its stops.
    fn pieces(mut self, nodes: &Nodes) -> Vec<Piece> {
        self.stops.sort_by(|(s, _), (t, _)| s.total_cmp(t));
        let between = |pair: &[(f64, usize)]| Piece {
            handle: self.line.handle,
            segment: self.number as u32,
            shares: [pair[0].0, pair[1].0],
            joints: [nodes.joint[pair[0].1], nodes.joint[pair[1].1]],
        };
        self.stops.windows(2).map(between).collect()
    }
}

/// Stops segments where they meet, and joins their nodes there.
///
/// # Errors
/// [`Error::BarsOverlap`]; [`Error::TooManySites`] for more pieces than there may be sites.
fn stop_where_they_meet(segments: &mut [Segment], nodes: &mut Nodes) -> Result<(), Error> {
    let mut pieces = segments.len();
    for i in 0..segments.len() {
        for j in i + 1..segments.len() {
            let (before, after) = segments.split_at_mut(j);
            let (s, t) = (&mut before[i], &mut after[0]);
            match meeting(s, t) {
                Meeting::Apart => {}
                Meeting::At(p) => {
                    let before = s.stops.len() + t.stops.len();
                    let (on_s, on_t) = (s.stop(p, nodes), t.stop(p, nodes));
                    nodes.join(on_s, on_t);
                    pieces += s.stops.len() + t.stops.len() - before;
                    if pieces > MAX_SITES {
                        return Err(Error::TooManySites);
                    }
                }
                Meeting::Along => {
                    let [mut first, mut second] = [&s.line.id, &t.line.id].map(Clone::clone);
                    if t.line.handle < s.line.handle {
                        std::mem::swap(&mut first, &mut second);
                    }
                    return Err(Error::BarsOverlap { first, second });
                }
            }
        }
    }
    Ok(())
}

enum Meeting {
    Apart,
    At(DVec2),
    Along,
}

/// How two segments come within [`MIN_SEPARATION`] of each other.
fn meeting(s: &Segment, t: &Segment) -> Meeting {
    let ((a, b), (c, d)) = ((s.a, s.b), (t.a, t.b));
    let slack = DVec2::splat(MIN_SEPARATION);
    if (a.max(b) + slack).cmplt(c.min(d)).any() || (c.max(d) + slack).cmplt(a.min(b)).any() {
        return Meeting::Apart;
    }
    let touching = |end: DVec2, from: DVec2, to: DVec2| segment_distance(end, from, to) < MIN_SEPARATION;
    let of_s = [a, b].into_iter().filter(|&end| touching(end, c, d));
    let of_t = [c, d].into_iter().filter(|&end| touching(end, a, b)).map(|end| nearest_on_segment(end, a, b));
    let mut touches: Vec<DVec2> = of_s.chain(of_t).collect();
    let (ab, cd) = (b - a, d - c);
    let crosses = ab.perp_dot(c - a) * ab.perp_dot(d - a) < 0.0 && cd.perp_dot(a - c) * cd.perp_dot(b - c) < 0.0;
    if crosses && touches.is_empty() {
        touches.push(a + ab * (cd.perp_dot(a - c) / ab.perp_dot(cd)));
    }
    let Some(&first) = touches.first() else { return Meeting::Apart };
    if touches.iter().any(|touch| touch.distance(first) > OVERLAP) { Meeting::Along } else { Meeting::At(first) }
}

/// Places on lines, merged into joints (union-find).
#[derive(Default)]
struct Nodes {
    anchors: Vec<Anchor>,
    /// A node of the same joint, nearer to its root.
    parent: Vec<usize>,
    joint: Vec<u32>,
}

impl Nodes {
    fn add(&mut self, anchor: Anchor) -> usize {
        self.anchors.push(anchor);
        self.parent.push(self.parent.len());
        self.parent.len() - 1
    }

    fn root(&self, mut node: usize) -> usize {
        while self.parent[node] != node {
            node = self.parent[node];
        }
        node
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }

    /// Numbers the joints and lists the anchors of each.
    fn joints(&mut self) -> Vec<Vec<Anchor>> {
        let mut number = vec![u32::MAX; self.anchors.len()];
        let mut joints: Vec<Vec<Anchor>> = Vec::new();
        for node in 0..self.anchors.len() {
            let root = self.root(node);
            if number[root] == u32::MAX {
                number[root] = joints.len() as u32;
                joints.push(Vec::new());
            }
            joints[number[root] as usize].push(self.anchors[node]);
        }
        self.joint = (0..self.anchors.len()).map(|node| number[self.root(node)]).collect();
        joints
    }
}
