//! Cuts bars and polygons into straight spans, at their corners and where they meet (section V-D).
//!
//! Cost: O(n²) for n segments of all polylines.

use glam::DVec2;

use super::{Anchor, Polyline};
use crate::{
    disjoint_sets::DisjointSets,
    error::Error,
    limits::{MAX_SITES, MIN_SEPARATION},
    rank::{ascending, sort_by_rank},
    segment::{nearest_on_segment, segment_distance},
};

/// Two segments overlap if they touch at points farther apart than this, in pixels.
const OVERLAP: f64 = 10.0 * MIN_SEPARATION;

/// A straight span of a polyline between two joints.
pub(super) struct Span {
    /// Index of the handle in the project.
    pub(super) handle: u32,
    /// Index of the segment that contains it.
    pub(super) segment: u32,
    /// The fractions of the segment at which it begins and ends, 0 to 1.
    pub(super) fractions: [f64; 2],
    /// The joints at its ends.
    pub(super) joints: [u32; 2],
}

impl Span {
    /// The ends of a span of `polyline`.
    pub(super) fn ends(&self, polyline: &Polyline) -> [DVec2; 2] {
        let (a, b) = polyline.segment(self.segment as usize);
        self.fractions.map(|fraction| a.lerp(b, fraction))
    }
}

/// All spans and joints of some polylines.
pub(super) struct Cuts {
    /// Polyline by polyline.
    pub(super) spans: Vec<Span>,
    /// Joints: the anchors that meet in each.
    pub(super) joints: Vec<Vec<Anchor>>,
}

/// A segment of a polyline with the points at which it is cut.
struct Segment<'a> {
    polyline: &'a Polyline,
    number: usize,
    a: DVec2,
    b: DVec2,
    /// Fractions of the segment, each with the node there.
    stops: Vec<(f64, usize)>,
}

impl Cuts {
    /// # Errors
    /// [`Error::BarTooShort`], [`Error::BarsOverlap`]; [`Error::TooManySites`] if there are more spans than the limit
    /// of sites.
    pub(super) fn new(polylines: &[&Polyline]) -> Result<Self, Error> {
        let mut nodes = Nodes::default();
        let mut segments = Vec::new();
        for polyline in polylines {
            segments.extend(Segment::all_of(polyline, &mut nodes)?);
        }
        cut_at_meetings(&mut segments, &mut nodes)?;
        let joints = nodes.joints();
        let spans = segments.into_iter().flat_map(|segment| segment.spans(&nodes)).collect();
        Ok(Self { spans, joints })
    }
}

impl<'a> Segment<'a> {
    /// The segments of a polyline, each with a node at its ends.
    ///
    /// # Errors
    /// [`Error::BarTooShort`].
    fn all_of(polyline: &'a Polyline, nodes: &mut Nodes) -> Result<Vec<Self>, Error> {
        let first = nodes.anchors.len();
        for corner in 0..polyline.corners.len() {
            // The last corner of an open polyline is the end of the last segment.
            let is_start = corner < polyline.segments();
            let (segment, fraction) = if is_start { (corner, 0.0) } else { (polyline.segments() - 1, 1.0) };
            nodes.add(Anchor { handle: polyline.handle, segment: segment as u32, fraction });
        }
        let segment = |number: usize| {
            let (a, b) = polyline.segment(number);
            if a.distance(b) < MIN_SEPARATION {
                return Err(Error::BarTooShort { id: polyline.id.clone(), corner: number });
            }
            let end = first + (number + 1) % polyline.corners.len();
            Ok(Self { polyline, number, a, b, stops: vec![(0.0, first + number), (1.0, end)] })
        };
        (0..polyline.segments()).map(segment).collect()
    }

    /// The node at a point of the segment: an existing one nearby, or a new one.
    fn node_at(&mut self, p: DVec2, nodes: &mut Nodes) -> usize {
        let along = self.b - self.a;
        let fraction = ((p - self.a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let near = MIN_SEPARATION / along.length();
        if let Some(&(_, node)) = self.stops.iter().find(|(known, _)| (known - fraction).abs() < near) {
            return node;
        }
        let node = nodes.add(Anchor { handle: self.polyline.handle, segment: self.number as u32, fraction });
        self.stops.push((fraction, node));
        node
    }

    /// The spans between its stops.
    fn spans(mut self, nodes: &Nodes) -> Vec<Span> {
        sort_by_rank(&mut self.stops, |&(stop, _)| [ascending(stop), 0]);
        let between = |pair: &[(f64, usize)]| Span {
            handle: self.polyline.handle,
            segment: self.number as u32,
            fractions: [pair[0].0, pair[1].0],
            joints: [nodes.joint[pair[0].1], nodes.joint[pair[1].1]],
        };
        self.stops.windows(2).map(between).collect()
    }
}

/// Cuts segments where they meet, and joins their nodes there.
///
/// # Errors
/// [`Error::BarsOverlap`]; [`Error::TooManySites`] if there are more spans than the limit of sites.
fn cut_at_meetings(segments: &mut [Segment], nodes: &mut Nodes) -> Result<(), Error> {
    let mut spans = segments.len();
    for i in 0..segments.len() {
        for j in i + 1..segments.len() {
            let (before, after) = segments.split_at_mut(j);
            let (s, t) = (&mut before[i], &mut after[0]);
            match meeting(s, t) {
                Meeting::Apart => {}
                Meeting::At(p) => {
                    let before = s.stops.len() + t.stops.len();
                    let (on_s, on_t) = (s.node_at(p, nodes), t.node_at(p, nodes));
                    nodes.sets.join(on_s, on_t);
                    spans += s.stops.len() + t.stops.len() - before;
                    if spans > MAX_SITES {
                        return Err(Error::TooManySites);
                    }
                }
                Meeting::Overlapping => {
                    let [mut first, mut second] = [&s.polyline.id, &t.polyline.id].map(Clone::clone);
                    if t.polyline.handle < s.polyline.handle {
                        std::mem::swap(&mut first, &mut second);
                    }
                    return Err(Error::BarsOverlap { first, second });
                }
            }
        }
    }
    Ok(())
}

/// How two segments meet.
enum Meeting {
    Apart,
    At(DVec2),
    Overlapping,
}

/// Finds where two segments come within [`MIN_SEPARATION`] of each other.
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
    if touches.iter().any(|touch| touch.distance(first) > OVERLAP) { Meeting::Overlapping } else { Meeting::At(first) }
}

/// Points on polylines, merged into joints.
#[derive(Default)]
struct Nodes {
    /// Nodes: the point of each.
    anchors: Vec<Anchor>,
    /// Nodes of the same joint.
    sets: DisjointSets,
    /// Nodes: the joint of each, once [`joints`](Self::joints) has numbered them.
    joint: Vec<u32>,
}

impl Nodes {
    fn add(&mut self, anchor: Anchor) -> usize {
        self.anchors.push(anchor);
        self.sets.add()
    }

    /// Numbers the joints and lists the anchors of each.
    fn joints(&mut self) -> Vec<Vec<Anchor>> {
        let mut number = vec![u32::MAX; self.anchors.len()];
        let mut joints: Vec<Vec<Anchor>> = Vec::new();
        for node in 0..self.anchors.len() {
            let root = self.sets.root(node);
            if number[root] == u32::MAX {
                number[root] = joints.len() as u32;
                joints.push(Vec::new());
            }
            joints[number[root] as usize].push(self.anchors[node]);
        }
        self.joint = (0..self.anchors.len()).map(|node| number[self.sets.root(node)]).collect();
        joints
    }
}
