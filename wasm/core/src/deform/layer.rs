//! The points of the picture under the corners of a drawing, all on one layer.
//!
//! Where parts of the picture cover each other, later corners belong to the same part as the first one. Another part
//! may be drawn over it there.
//!
//! A straight line is followed through the triangles of the posed mesh from each corner to the next. If the line leaves
//! the part before the corner, there are two cases. A part that begins after the first one has ended belongs to the
//! same layer, like a second leg beyond a gap. A part that begins before covers the first one, which is then continued
//! beyond its border.
//!
//! Cost: linear in the triangles for each corner.

use glam::DVec2;

use super::{
    crossings::{Adjacency, NONE, PosedMesh},
    locate::{Correspondence, locate_near, similar},
    triangle::{barycentric, corners, doubled_area, interpolate},
};
use crate::rank::sort_by_rank;

/// A posed picture whose first `samples` vertices bend, and its triangles in drawing order.
#[derive(Clone, Copy)]
pub(super) struct Layers<'a> {
    pub(super) mesh: PosedMesh<'a>,
    pub(super) adjacency: &'a Adjacency,
    pub(super) samples: usize,
    pub(super) drawn: &'a [[u32; 3]],
}

/// A position in a triangle of the posed mesh.
#[derive(Clone, Copy)]
struct Spot {
    triangle: u32,
    posed: DVec2,
}

/// The end of a straight line through the posed mesh.
struct Walk {
    at: Spot,
    /// The fraction of the line: 1 at its end.
    fraction: f64,
}

impl Layers<'_> {
    /// The points of the picture under the corners; `None` without triangles.
    pub(super) fn under(&self, places: &[DVec2]) -> Option<Vec<Correspondence>> {
        let mut last: Option<Spot> = None;
        let located = |&place: &DVec2| {
            let from = last;
            let Some(from) = from else {
                last = self.spots(place).first().copied();
                return match last {
                    Some(spot) => Some(self.correspondence(spot)),
                    None => locate_near(self.mesh.rest, self.mesh.posed, self.drawn, place),
                };
            };
            let walk = self.walk(from, place);
            let beyond_gap = || {
                let begins_later = |spot: &Spot| self.walk(*spot, from.posed).fraction + walk.fraction <= 1.0;
                self.spots(place).into_iter().find(begins_later)
            };
            let arrived = (walk.fraction == 1.0).then_some(walk.at);
            if let Some(spot) = arrived.or_else(beyond_gap) {
                last = Some(spot);
                return Some(self.correspondence(spot));
            }
            last = Some(walk.at);
            Some(similar(self.correspondence(walk.at), place))
        };
        places.iter().map(located).collect()
    }

    /// The bending triangles around a point, last drawn first.
    fn spots(&self, posed: DVec2) -> Vec<Spot> {
        let around = |&(_, &triangle): &(usize, &[u32; 3])| {
            self.bends(triangle) && barycentric(corners(self.mesh.posed, triangle), posed).is_some()
        };
        let mut found: Vec<_> = self.mesh.triangles.iter().enumerate().filter(around).collect();
        if found.len() > 1 {
            let rank = |&(_, triangle): &(usize, &[u32; 3])| {
                self.drawn.iter().rposition(|other| other == triangle).map_or(-1, |at| at as i64)
            };
            let mut ranked: Vec<_> = found.into_iter().map(|triangle| (rank(&triangle), triangle)).collect();
            sort_by_rank(&mut ranked, |&(rank, _)| [-rank, 0]);
            found = ranked.into_iter().map(|(_, triangle)| triangle).collect();
        }
        found.into_iter().map(|(t, _)| Spot { triangle: t as u32, posed }).collect()
    }

    fn bends(&self, triangle: [u32; 3]) -> bool {
        triangle.iter().all(|&vertex| (vertex as usize) < self.samples)
    }

    fn correspondence(&self, Spot { triangle, posed }: Spot) -> Correspondence {
        let triangle = self.mesh.triangles[triangle as usize];
        let both = [self.mesh.rest, self.mesh.posed].map(|points| corners(points, triangle));
        // Rounding can put the place a little outside.
        let area = doubled_area(both[1]);
        let [a, b, c] = both[1];
        let (u, v) = ((b - posed).perp_dot(c - posed) / area, (c - posed).perp_dot(a - posed) / area);
        Correspondence::new(interpolate(both[0], [u, v, 1.0 - u - v]), posed, both)
    }

    /// Follows a straight line from triangle to triangle, until the border or a fold ends it.
    fn walk(&self, from: Spot, to: DVec2) -> Walk {
        let along = to - from.posed;
        let at = |triangle: u32, fraction: f64| {
            let posed = if fraction == 1.0 { to } else { from.posed + fraction * along };
            Walk { at: Spot { triangle, posed }, fraction }
        };
        let side = self.side(from.triangle);
        let (mut t, mut before, mut fraction) = (from.triangle, NONE, 0.0_f64);
        // Each step leaves a triangle for good, except where rounding leads around a vertex.
        for _ in 0..self.mesh.triangles.len() {
            let triangle = corners(self.mesh.posed, self.mesh.triangles[t as usize]);
            if barycentric(triangle, to).is_some() {
                return at(t, 1.0);
            }
            let turn = doubled_area(triangle).signum();
            let neighbours = self.adjacency.neighbours(t);
            let exit = |k: usize| {
                let (from_corner, to_corner) = (triangle[k], triangle[(k + 1) % 3]);
                let inwards = turn * (to_corner - from_corner).perp();
                let speed = inwards.dot(along);
                let leaves = speed < 0.0 && (neighbours[k] != before || before == NONE);
                leaves.then(|| (inwards.dot(from_corner - from.posed) / speed, neighbours[k]))
            };
            let Some((leaving, next)) = (0..3).filter_map(exit).min_by(|(a, _), (b, _)| a.total_cmp(b)) else {
                break;
            };
            fraction = leaving.clamp(fraction, 1.0 - f64::EPSILON);
            let goes_on = next != NONE && self.bends(self.mesh.triangles[next as usize]) && self.side(next) == side;
            if !goes_on {
                break;
            }
            (before, t) = (t, next);
        }
        at(t, fraction)
    }

    /// 1 or −1: whether a triangle has the same orientation at rest and posed.
    fn side(&self, t: u32) -> f64 {
        let area = |points| doubled_area(corners(points, self.mesh.triangles[t as usize]));
        (area(self.mesh.rest) * area(self.mesh.posed)).signum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A strip of squares from left to right, two triangles each.
    fn strip(squares: u32) -> (Vec<DVec2>, Vec<[u32; 3]>) {
        let points = (0..=squares).flat_map(|k| [[f64::from(k), 0.0], [f64::from(k), 1.0]].map(DVec2::from)).collect();
        let triangles = (0..squares).flat_map(|k| [0, 1].map(|odd| [0, 1, 2].map(|v| 2 * k + v + odd))).collect();
        (points, triangles)
    }

    fn under(rest: &[DVec2], posed: &[DVec2], triangles: &[[u32; 3]], places: &[[f64; 2]]) -> Vec<DVec2> {
        let mesh = PosedMesh { rest, posed, triangles };
        let adjacency = Adjacency::new(triangles);
        let layers = Layers { mesh, adjacency: &adjacency, samples: rest.len(), drawn: triangles };
        let places: Vec<DVec2> = places.iter().copied().map(DVec2::from).collect();
        layers.under(&places).expect("triangles").into_iter().map(|found| found.rest).collect()
    }

    fn assert_near(found: &[DVec2], expected: &[[f64; 2]]) {
        let near = found.iter().zip(expected).all(|(p, q)| p.distance(DVec2::from(*q)) < 1e-9);
        assert!(near && found.len() == expected.len(), "{found:?}");
    }

    /// Two strips, the second of which lies over the end of the first: from x = 2 to 4 of four squares.
    fn covered() -> (Vec<DVec2>, Vec<DVec2>, Vec<[u32; 3]>) {
        let ((points, triangles), count) = (strip(4), 10);
        let rest = points.iter().copied().chain(points.iter().map(|p| *p + DVec2::new(0.0, 50.0))).collect();
        let posed = points.iter().copied().chain(points.iter().map(|p| *p + DVec2::new(2.0, 0.0))).collect();
        let second = triangles.iter().map(|triangle| triangle.map(|vertex| vertex + count));
        (rest, posed, triangles.iter().copied().chain(second).collect())
    }

    #[test]
    fn later_corners_belong_to_the_part_of_the_first() {
        let (rest, posed, triangles) = covered();
        assert_near(
            &under(&rest, &posed, &triangles, &[[0.5, 0.5], [3.25, 0.5], [1.0, 0.75]]),
            &[[0.5, 0.5], [3.25, 0.5], [1.0, 0.75]],
        );
        assert_near(&under(&rest, &posed, &triangles, &[[3.25, 0.5], [5.0, 0.25]]), &[[1.25, 50.5], [3.0, 50.25]]);
    }

    #[test]
    fn part_of_the_first_corner_is_continued_below_another_part() {
        let (rest, posed, triangles) = covered();
        assert_near(&under(&rest, &posed, &triangles, &[[0.5, 0.5], [5.0, 0.5]]), &[[0.5, 0.5], [5.0, 0.5]]);
    }

    #[test]
    fn a_part_beyond_a_gap_belongs_to_the_same_layer() {
        let (points, mut triangles) = strip(5);
        // A gap from x = 2 to 3.
        triangles.retain(|triangle| triangle.iter().any(|&v| points[v as usize].x < 2.0 || points[v as usize].x > 3.0));
        let posed: Vec<DVec2> = points.iter().map(|p| if p.x > 2.5 { *p + DVec2::Y * 0.2 } else { *p }).collect();
        assert_near(&under(&points, &posed, &triangles, &[[0.5, 0.5], [4.5, 0.7]]), &[[0.5, 0.5], [4.5, 0.5]]);
    }

    #[test]
    fn without_triangles_there_is_no_layer() {
        let mesh = PosedMesh { rest: &[], posed: &[], triangles: &[] };
        let layers = Layers { mesh, adjacency: &Adjacency::new(&[]), samples: 0, drawn: &[] };
        assert!(layers.under(&[DVec2::ZERO]).is_none());
    }
}
