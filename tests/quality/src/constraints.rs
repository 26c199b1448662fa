//! Positional constraints: the points that handles move, and their posed positions.

use c2warp::project::{Project, Shape};
use glam::DVec2;

/// A straight segment of a bar or polygon.
#[derive(Debug, Clone, Copy)]
pub struct Segment {
    /// Rest positions of both ends.
    pub rest: [DVec2; 2],
    /// Posed positions of both ends.
    pub posed: [DVec2; 2],
}

/// The constraints of a project.
#[derive(Debug, Clone, Default)]
pub struct Constraints {
    /// Rest and posed positions of point handles.
    pub points: Vec<(DVec2, DVec2)>,
    /// Segments of bars and polygons.
    pub segments: Vec<Segment>,
    /// Whether the outline is held in place.
    pub outline_held: bool,
}

/// Number of intervals between the points that are checked on a segment.
const INTERVALS: usize = 16;

impl Segment {
    /// Returns the parameter of the nearest point of the segment at rest, from 0 to 1, and its distance.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> (f64, f64) {
        let [a, b] = self.rest;
        let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        (t, a.lerp(b, t).distance(p))
    }

    /// Returns the rest and posed positions at parameter `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> (DVec2, DVec2) {
        (self.rest[0].lerp(self.rest[1], t), self.posed[0].lerp(self.posed[1], t))
    }
}

impl Constraints {
    /// Returns the constraints of a project.
    #[must_use]
    pub fn of(project: &Project) -> Self {
        let mut constraints = Self { outline_held: project.fix_boundary, ..Self::default() };
        for handle in &project.handles {
            match &handle.shape {
                Shape::Point { rest, posed } => constraints.points.push((*rest, *posed)),
                Shape::Bar { rest, posed } => constraints.segments.extend(segments(rest, posed, rest.len() - 1)),
                Shape::Polygon { rest, posed } => constraints.segments.extend(segments(rest, posed, rest.len())),
            }
        }
        constraints
    }

    /// Returns the posed position of a vertex if a handle is there within rounding, or if a held outline contains it.
    #[must_use]
    pub fn target(&self, p: DVec2, on_outline: bool) -> Option<DVec2> {
        const ROUNDING: f64 = 1e-6;
        let point = self.points.iter().find(|(rest, _)| rest.distance(p) <= ROUNDING).map(|&(_, posed)| posed);
        let segment = || {
            let near = self.segments.iter().map(|segment| (segment, segment.nearest(p)));
            near.filter(|(_, (_, far))| *far <= ROUNDING).map(|(segment, (t, _))| segment.at(t).1).next()
        };
        point.or_else(segment).or((self.outline_held && on_outline).then_some(p))
    }

    /// Returns point handles and points along bars. Held outlines are checked at the vertices of the mesh instead.
    #[must_use]
    pub fn check_points(&self) -> Vec<(DVec2, DVec2)> {
        let along =
            self.segments.iter().flat_map(|segment| (0..=INTERVALS).map(|i| segment.at(i as f64 / INTERVALS as f64)));
        self.points.iter().copied().chain(along).collect()
    }
}

fn segments<'a>(rest: &'a [DVec2], posed: &'a [DVec2], count: usize) -> impl Iterator<Item = Segment> + 'a {
    let next = |i: usize| (i + 1) % rest.len();
    (0..count).map(move |i| Segment { rest: [rest[i], rest[next(i)]], posed: [posed[i], posed[next(i)]] })
}
