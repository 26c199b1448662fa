//! What the handles of a project demand: places that have to go to others.

use c2warp::project::{Project, Shape};
use glam::DVec2;

/// A straight piece of a bar or of a polygon's rim, and where it goes.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    /// Both ends at rest.
    pub rest: [DVec2; 2],
    /// Both ends posed.
    pub posed: [DVec2; 2],
}

/// What is demanded.
#[derive(Debug, Clone, Default)]
pub struct Targets {
    /// Point handles: where each rests and where it goes.
    pub points: Vec<(DVec2, DVec2)>,
    /// Pieces of bars and polygons.
    pub pieces: Vec<Piece>,
    /// Whether the outline stays where it is.
    pub outline_held: bool,
}

/// Places that are looked at along a piece.
const ALONG: usize = 16;

impl Piece {
    /// The nearest place on the piece: its share of the way, and how far it is.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> (f64, f64) {
        let [a, b] = self.rest;
        let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        (t, a.lerp(b, t).distance(p))
    }

    /// Where a share of the way rests and where it goes.
    #[must_use]
    pub fn at(&self, t: f64) -> (DVec2, DVec2) {
        (self.rest[0].lerp(self.rest[1], t), self.posed[0].lerp(self.posed[1], t))
    }
}

impl Targets {
    /// What a project demands.
    #[must_use]
    pub fn of(project: &Project) -> Self {
        let mut targets = Self { outline_held: project.fix_boundary, ..Self::default() };
        for handle in &project.handles {
            match &handle.shape {
                Shape::Point { rest, posed } => targets.points.push((*rest, *posed)),
                Shape::Bar { rest, posed } => targets.pieces.extend(pieces(rest, posed, rest.len() - 1)),
                Shape::Polygon { rest, posed } => targets.pieces.extend(pieces(rest, posed, rest.len())),
            }
        }
        targets
    }

    /// Where a vertex has to go, if anything demands it: it stands on a handle within rounding.
    #[must_use]
    pub fn demanded(&self, p: DVec2, on_outline: bool) -> Option<DVec2> {
        const ROUNDING: f64 = 1e-6;
        let point = self.points.iter().find(|(rest, _)| rest.distance(p) <= ROUNDING).map(|&(_, posed)| posed);
        let piece = || {
            let near = self.pieces.iter().map(|piece| (piece, piece.nearest(p)));
            near.filter(|(_, (_, far))| *far <= ROUNDING).map(|(piece, (t, _))| piece.at(t).1).next()
        };
        point.or_else(piece).or((self.outline_held && on_outline).then_some(p))
    }

    /// Places to ask a method for: handles, and places along bars. Held outlines are asked for at the vertices.
    #[must_use]
    pub fn places(&self) -> Vec<(DVec2, DVec2)> {
        let along = self.pieces.iter().flat_map(|piece| (0..=ALONG).map(|i| piece.at(i as f64 / ALONG as f64)));
        self.points.iter().copied().chain(along).collect()
    }
}

fn pieces<'a>(rest: &'a [DVec2], posed: &'a [DVec2], count: usize) -> impl Iterator<Item = Piece> + 'a {
    let next = |i: usize| (i + 1) % rest.len();
    (0..count).map(move |i| Piece { rest: [rest[i], rest[next(i)]], posed: [posed[i], posed[next(i)]] })
}
