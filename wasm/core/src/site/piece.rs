//! Pieces of the domain in which farthest points are sought: triangles of the scouts' mesh, and their parts.
//!
//! A piece knows every site that may be the nearest somewhere in it, for all cells alike, and learns of new ones. So what one cell
//! had to be divided for is there for its neighbours, and in the next round: thousands of sites among a thousand scouts cost
//! hardly more each than a few do.

use glam::{DVec2, DVec3};

use super::{
    Site,
    farthest::{Cone, Cones, climb},
    regions::{FarPoint, Regions},
    virtual_sites::TIE,
};
use crate::{
    distance::{DistanceField, Foot, Place},
    triangulation::NONE,
};

/// Distances are climbed in pieces whose edges are no longer than this share of the distance: there cones are nearly planes, and
/// hardly two summits in one piece.
const FLAT: f64 = 0.5;
/// Where more sites than that may be the nearest, to divide a piece costs less than to climb in it.
const MANY: usize = 16;
/// Pieces with edges below this share of the distance are not divided any more. What one of them could hide is farther by no more.
const LEAST: f64 = 1.0 / 64.0;
/// The parts of a piece, by the numbers of its corners and, after them, of the middles of its edges. The last has all middles.
const PARTS: [[usize; 3]; 4] = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]];

/// The last pieces of the paths from a site to the corners of a piece.
type Feet = [Option<Foot>; 3];

/// A piece of the domain, and what is known of distances in it.
pub(super) struct Piece {
    corners: [DVec2; 3],
    places: [Place; 3],
    /// Every site that may be the nearest somewhere in the piece, ascending.
    sites: Vec<u32>,
    /// Those of these sites, in their order. None where there are parts: they know better.
    feet: Vec<Feet>,
    /// Distance of each corner to its nearest site.
    nearest: [f64; 3],
    /// How many of its edges are pieces of the outline; of a part, perhaps fewer.
    walls: usize,
    /// How many cones and walls may bound a cell in the piece, its own cone counted.
    limits: usize,
    longest: f64,
    /// No point of the piece is farther from its nearest site than this.
    pub(super) above: f64,
    /// The first of its four parts; they follow one another.
    parts: Option<u32>,
}

/// The triangles of the scouts' mesh that were looked into, and their parts.
#[derive(Default)]
pub(super) struct Pieces {
    pieces: Vec<Piece>,
    /// The piece that each triangle is; [`NONE`] where none has looked.
    roots: Vec<u32>,
    /// The triangles that are pieces.
    opened: Vec<u32>,
}

impl Pieces {
    pub(super) fn new(triangles: usize) -> Self {
        Self { roots: vec![NONE; triangles], ..Self::default() }
    }

    pub(super) fn piece(&self, at: u32) -> &Piece {
        &self.pieces[at as usize]
    }

    /// The piece that a triangle is, where one has looked into it.
    pub(super) fn known(&self, triangle: u32) -> Option<&Piece> {
        let root = self.roots[triangle as usize];
        (root != NONE).then(|| self.piece(root))
    }

    /// The number of the piece that a triangle is.
    pub(super) fn root(&mut self, regions: &Regions, triangle: u32) -> u32 {
        if self.roots[triangle as usize] == NONE {
            self.roots[triangle as usize] = self.pieces.len() as u32;
            self.opened.push(triangle);
            self.pieces.push(Piece::of_scouts(regions, triangle));
        }
        self.roots[triangle as usize]
    }

    /// The numbers of a piece's parts; none where they would be too small to matter.
    pub(super) fn parts(&mut self, regions: &Regions, at: u32) -> std::ops::Range<u32> {
        let piece = self.piece(at);
        let first = match piece.parts {
            Some(first) => first,
            None => {
                let Some(parts) = piece.divided(regions) else { return 0..0 };
                let (first, piece) = (self.pieces.len() as u32, &mut self.pieces[at as usize]);
                piece.sites.retain(|&site| parts.iter().any(|part| part.has(site as usize)));
                (piece.parts, piece.feet) = (Some(first), Vec::new());
                self.pieces.extend(parts);
                first
            }
        };
        first..first + PARTS.len() as u32
    }

    /// Takes in the site that was added last. Its cell lies among the scouts that were seen for it.
    pub(super) fn insert(&mut self, regions: &Regions) {
        let Some((site, Site { field, .. })) = (0..).zip(&regions.sites).last() else { return };
        for at in 0..self.opened.len() {
            let triangle = self.opened[at] as usize;
            if regions.cells.saw(regions.scouts.mesh.triangles[triangle]) {
                let root = self.roots[triangle];
                let feet = self.piece(root).feet(field);
                self.enter(root, site, field, feet);
            }
        }
    }

    /// Takes in a site where it may be the nearest somewhere in a piece; whether it may.
    fn enter(&mut self, at: u32, site: u32, field: &DistanceField, feet: Feet) -> bool {
        let piece = &mut self.pieces[at as usize];
        let Some(first) = piece.parts else { return piece.enter(site, feet) };
        if !may_enter(&feet, &piece.nearest, piece.longest) {
            return false;
        }
        piece.nearest = nearer(&piece.nearest, &feet);
        let middles = self.piece(first + PARTS.len() as u32 - 1).feet(field);
        let of_part = |part: [usize; 3]| part.map(|at| [feet, middles][at / 3][at % 3]);
        let entered = (first..).zip(PARTS).filter(|&(at, part)| self.enter(at, site, field, of_part(part))).count();
        if entered > 0 {
            self.pieces[at as usize].sites.push(site);
        }
        entered > 0
    }
}

impl Piece {
    /// A triangle of scouts.
    fn of_scouts(regions: &Regions, triangle: u32) -> Self {
        let (scouts, cells) = (regions.scouts, &regions.cells);
        let vertices = scouts.mesh.triangles[triangle as usize].map(|v| v as usize);
        let (corners, places) = (vertices.map(|v| scouts.mesh.vertices[v]), vertices.map(|v| scouts.places[v]));
        // A site that is the nearest somewhere in the triangle is not farther than this from its corners.
        let limits = vertices.map(|v| cells.distance[v] + 2.0 * scouts.reach[v]);
        let is_near = |site: &Site| (0..3).all(|k| site.rest.distance_squared(corners[k]) <= limits[k] * limits[k]);
        let near = (0..).zip(&regions.sites).filter(|(_, site)| is_near(site));
        let feet = near.map(|(at, site)| (at, feet(&site.field, &corners, &places)));
        let walls = scouts.mesh.neighbours[triangle as usize].iter().filter(|&&n| n == NONE).count();
        Self::new(corners, places, feet.unzip(), walls)
    }

    /// A piece in which no site but those of `sites` is the nearest.
    fn new(corners: [DVec2; 3], places: [Place; 3], (sites, feet): (Vec<u32>, Vec<Feet>), walls: usize) -> Self {
        let longest = lengths(&corners).into_iter().fold(0.0, f64::max);
        let (nearest, limits, above) = ([f64::INFINITY; 3], 0, f64::INFINITY);
        let mut piece = Self { corners, places, sites, feet, nearest, walls, limits, longest, above, parts: None };
        piece.settle();
        piece
    }

    /// Whether a site may be the nearest somewhere in the piece.
    pub(super) fn has(&self, site: usize) -> bool {
        self.sites.binary_search(&(site as u32)).is_ok()
    }

    /// Takes in a site that comes after all that it knows, if it may be the nearest somewhere. Whether it may.
    fn enter(&mut self, site: u32, feet: Feet) -> bool {
        if !may_enter(&feet, &self.nearest, self.longest) {
            return false;
        }
        self.sites.push(site);
        self.feet.push(feet);
        self.settle();
        self.sites.last() == Some(&site)
    }

    /// How the corners are reached from a site.
    fn feet(&self, field: &DistanceField) -> Feet {
        feet(field, &self.corners, &self.places)
    }

    /// Drops the sites that are the nearest nowhere in the piece, and learns from the others how far its points may be.
    fn settle(&mut self) {
        let Self { corners, longest, .. } = *self;
        let nearest = self.feet.iter().fold([f64::INFINITY; 3], |known, feet| nearer(&known, feet));
        // The nearest of each corner, if its cone is known.
        let rivals = [0, 1, 2].map(|k| {
            let cones = self.feet.iter().filter(|feet| may_enter(feet, &nearest, longest) && apex(feet).is_some());
            cones.reduce(|best, feet| if distance(feet, k) < distance(best, k) { feet } else { best }).copied()
        });
        let leaders = leaders(&self.feet);
        let is_kept = |feet: &Feet| {
            if !may_enter(feet, &nearest, longest) {
                return false;
            }
            let of_another = |rival: &Feet, bend: f64| (0..3).all(|k| distance(rival, k) + bend < distance(feet, k));
            // Between the corners a cone sags by so much at most; that of another site does not rise.
            let bend = apex(feet).map_or(f64::INFINITY, |apex| self.bend(apex));
            let is_behind =
                |leader: &Feet| is_same_way(leader, feet) && of_another(leader, 2.0 * TIE * distance(feet, 0));
            !rivals.iter().flatten().any(|rival| of_another(rival, bend)) && !leaders.iter().any(is_behind)
        };
        let kept: Vec<bool> = self.feet.iter().map(is_kept).collect();
        keep(&mut self.sites, &kept);
        keep(&mut self.feet, &kept);
        let cones = self.feet.iter().filter(|feet| apex(feet).is_some());
        self.limits = self.walls + 2 * self.feet.len() - cones.clone().count();
        self.nearest = nearest;
        let lengths = lengths(&corners);
        let from_corner = (0..3).map(|k| nearest[k] + lengths[k].max(lengths[(k + 2) % 3]));
        // A cone is convex: farthest in a corner.
        let at_corner = cones.map(|feet| (0..3).map(|k| distance(feet, k)).fold(0.0, f64::max));
        self.above = from_corner.chain(at_corner).fold(f64::INFINITY, f64::min);
    }

    fn is_divisible(&self) -> bool {
        self.longest >= LEAST * self.above
    }

    /// Its four parts; none where it is too small to matter.
    fn divided(&self, regions: &Regions) -> Option<[Self; 4]> {
        if !self.is_divisible() {
            return None;
        }
        let [a, b, c] = self.corners;
        let middles = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        let places = middles.map(|p| regions.navigation.place(p));
        let [Some(ab), Some(bc), Some(ca)] = places else { return None };
        let (corners, places) = ([self.corners, middles], [self.places, [ab, bc, ca]]);
        let feet_of = |(&site, &of_corners): (&u32, &Feet)| {
            [of_corners, feet(&regions.sites[site as usize].field, &middles, &places[1])]
        };
        let feet: Vec<[Feet; 2]> = self.sites.iter().zip(&self.feet).map(feet_of).collect();
        Some(PARTS.map(|part| {
            let of_part = |feet: &[Feet; 2]| part.map(|k| feet[k / 3][k % 3]);
            let (corners, places) = (part.map(|k| corners[k / 3][k % 3]), part.map(|k| places[k / 3][k % 3]));
            Self::new(corners, places, (self.sites.clone(), feet.iter().map(of_part).collect()), self.walls)
        }))
    }

    /// No point of a site's cell in the piece is farther from it than this; none where the cell does not enter it.
    ///
    /// Between corners a cone lies below the plane through them, by little: what is left of the piece where that plane is no higher
    /// than those of other sites is all that the cell can have of it.
    pub(super) fn above_of(&self, site: usize) -> Option<f64> {
        let own = self.sites.iter().zip(&self.feet).find_map(|(&at, feet)| (at == site as u32).then_some(feet))?;
        let Some(source) = apex(own) else { return Some(self.above) };
        let bend = self.bend(source);
        let mut rest: Vec<DVec3> = DVec3::AXES.to_vec();
        for other in self.feet.iter().filter(|feet| apex(feet).is_some()) {
            let higher = DVec3::from([0, 1, 2].map(|k| distance(own, k) - distance(other, k)));
            rest = clipped(&rest, |p| bend - higher.dot(p));
        }
        let plane = DVec3::from([0, 1, 2].map(|k| distance(own, k)));
        rest.into_iter().map(|p| plane.dot(p)).reduce(f64::max).map(|above| above.min(self.above))
    }

    /// How far the cone of a pseudo-source may lie below the plane through its values at the corners.
    fn bend(&self, source: DVec2) -> f64 {
        bend(self.longest, self.corners.iter().map(|corner| corner.distance(source)).fold(f64::INFINITY, f64::min))
    }

    /// Whether it is small enough to be climbed in, and not divided.
    pub(super) fn is_flat(&self) -> bool {
        self.parts.is_none() && self.longest <= FLAT * self.above && (self.sites.len() <= MANY || !self.is_divisible())
    }

    /// Points of a site's cell in a flat piece: the farthest, and where that may be as far as `known`, others that may be. Empty
    /// where none is found.
    pub(super) fn tops(&self, regions: &Regions, site: usize, known: f64) -> Vec<FarPoint> {
        let climb_from = |from: DVec2| {
            let limit = self.above + self.longest;
            let tops = climb(&self.corners, from, |p, cones| self.cones(regions, site, p, limit, cones));
            tops.into_iter().filter_map(|p| self.in_cell(regions, site, p))
        };
        let mut tops: Vec<FarPoint> = climb_from(self.corners.iter().sum::<DVec2>() / 3.0).collect();
        let Some(top) = tops.first() else { return tops };
        // Three cones meet once. Where there are more, a narrow cell may have another summit beside the first, farther by no more
        // than cones curve.
        if self.limits > 3 && top.distance + bend(self.longest, top.distance) >= known {
            for from in self.corners {
                tops.extend(climb_from(from));
            }
        }
        tops
    }

    /// The cones that see a point, no higher than a limit.
    fn cones(&self, regions: &Regions, site: usize, p: DVec2, limit: f64, cones: &mut Cones) {
        let Some(place) = self.place(regions, p) else { return };
        for &at in &self.sites {
            let feet = regions.sites[at as usize].field.feet(place, p).filter(|foot| foot.distance <= limit);
            let list = if at == site as u32 { &mut cones.own } else { &mut cones.others };
            let first = list.len();
            for foot in feet {
                let cone = Cone { apex: foot.pseudo_source, offset: foot.offset };
                // Cones of two sites may be the same behind a corner of the outline alone.
                let alike = if cone.offset > 0.0 { &list[..] } else { &list[first..] };
                if !alike.contains(&cone) {
                    list.push(cone);
                }
            }
        }
    }

    /// The place of a point of the piece.
    fn place(&self, regions: &Regions, p: DVec2) -> Option<Place> {
        let [a, b, c] = self.places;
        if a == b && b == c { Some(a) } else { regions.navigation.place(p) }
    }

    fn in_cell(&self, regions: &Regions, site: usize, p: DVec2) -> Option<FarPoint> {
        let place = self.place(regions, p)?;
        let distance = |at: usize| regions.sites[at].field.distance(place, p);
        let least = self.sites.iter().map(|&at| distance(at as usize)).fold(f64::INFINITY, f64::min);
        let of_site = distance(site) <= least * (1.0 + TIE);
        (of_site && least.is_finite()).then_some(FarPoint { at: p, place, distance: least })
    }
}

/// How points are reached from a site.
pub(super) fn feet(field: &DistanceField, points: &[DVec2; 3], places: &[Place; 3]) -> Feet {
    let mut field = field.in_turn();
    [0, 1, 2].map(|k| field.foot(places[k], points[k]))
}

/// Drops what is not to be kept of a list.
fn keep<T>(list: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    list.retain(|_| kept.next().is_some_and(|&is_kept| is_kept));
}

/// Lengths of the edges from each corner to the next.
fn lengths(corners: &[DVec2; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| corners[k].distance(corners[(k + 1) % 3]))
}

fn distance(feet: &Feet, corner: usize) -> f64 {
    feet[corner].map_or(f64::INFINITY, |foot| foot.distance)
}

/// By way of which pseudo-source all corners are reached, if it is the same.
fn apex(feet: &Feet) -> Option<DVec2> {
    let [a, b, c] = sources(feet);
    if a == b && b == c { a } else { None }
}

/// Of the sites that are seen by way of the same corners of the outline, the one that is nearest to these. What is farther from all of
/// them is nowhere the nearest.
fn leaders(all: &[Feet]) -> Vec<Feet> {
    let way = |feet: &Feet| feet.iter().flatten().map(|foot| foot.offset).sum::<f64>();
    let mut leaders: Vec<Feet> = Vec::new();
    for feet in all.iter().filter(|feet| feet.iter().all(|foot| foot.is_some_and(|foot| foot.offset > 0.0))) {
        match leaders.iter_mut().find(|leader| is_same_way(leader, feet)) {
            Some(leader) if way(feet) < way(leader) => *leader = *feet,
            Some(_) => {}
            None => leaders.push(*feet),
        }
    }
    leaders
}

/// Whether each corner of a piece is reached by way of the same pseudo-source.
fn is_same_way(one: &Feet, other: &Feet) -> bool {
    sources(one) == sources(other)
}

/// By way of which pseudo-source each corner of a piece is reached.
fn sources(feet: &Feet) -> [Option<DVec2>; 3] {
    feet.map(|foot| foot.map(|foot| foot.pseudo_source))
}

/// The part of a convex polygon where a linear function is not negative.
fn clipped(polygon: &[DVec3], height: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (&a, &b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (from, to) = (height(a), height(b));
        if from >= 0.0 {
            part.push(a);
        }
        if (from < 0.0) != (to < 0.0) {
            part.push(a.lerp(b, from / (from - to)));
        }
    }
    part
}

/// The less of the distances that are known and those of a site.
fn nearer(known: &[f64; 3], feet: &Feet) -> [f64; 3] {
    [0, 1, 2].map(|k| known[k].min(distance(feet, k)))
}

/// Distances rise by no more than one goes.
fn may_enter(feet: &Feet, nearest: &[f64; 3], longest: f64) -> bool {
    (0..3).all(|k| distance(feet, k) <= nearest[k] + 2.0 * longest)
}

/// How far a cone may lie below the plane through three of its points with edges no longer than `longest`, none of which is nearer to
/// the apex than `distance`.
pub(super) fn bend(longest: f64, distance: f64) -> f64 {
    // Along a level line a cone curves by one over the distance; the circle around a triangle is no wider than edges over √3, or
    // most of it lies outside.
    if distance > longest { longest * longest / (6.0 * (distance - longest)) } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{distance::Navigation, domain::Domain, picture::Picture};

    #[test]
    fn of_sites_behind_the_same_corners_the_nearest_is_kept() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
        let [before, beside] = [(-30.0, 0.0), (-10.0, 1.0)].map(DVec2::from);
        // The corner `beside` is seen from the corner `before`; some sites are this far behind that.
        let feet_by = |sources: [DVec2; 3], behind: f64| -> Feet {
            [0, 1, 2].map(|k| {
                let offset = behind + before.distance(sources[k]);
                let distance = offset + sources[k].distance(corners[k]);
                Some(Foot { distance, pseudo_source: sources[k], offset })
            })
        };
        let (ways, other_ways) = ([before, before, beside], [before, beside, beside]);
        let behind = [7.0, 5.0, 5.0 + 1e-12, 6.0, 5.1].map(|behind| feet_by(ways, behind));
        let feet: Vec<Feet> = behind.into_iter().chain([feet_by(other_ways, 6.0)]).collect();
        let navigation = Navigation::new(&Domain::new(None, &Picture::new(2, 2, &[255; 16]).unwrap()).unwrap());
        let place = navigation.place(DVec2::ONE).unwrap();
        let piece = Piece::new(corners, [place; 3], ((0..).take(feet.len()).collect(), feet), 0);
        // What rounding tells apart is tied.
        assert_eq!(piece.sites, [1, 2, 5]);
    }

    #[test]
    fn no_cone_bends_more_than_the_bound_says() {
        let value = |p: DVec2| p.length();
        // Triangles with edges of 1 at most, the long one along a level line or across, somewhere beyond the distance.
        let shapes = [
            [(0.0, 0.5), (0.0, -0.5), (0.8, 0.0)],
            [(0.0, 0.5), (0.0, -0.5), (-0.1, 0.0)],
            [(0.5, 0.0), (-0.5, 0.0), (0.0, 0.8)],
        ];
        for (distance, shape) in [2.0, 5.0, 40.0].into_iter().flat_map(|d| shapes.map(|shape| (d, shape))) {
            let corners = shape.map(|corner| DVec2::new(distance + 0.5, 0.0) + DVec2::from(corner));
            let nearest = corners.iter().map(|&corner| value(corner)).fold(f64::INFINITY, f64::min);
            for (s, t) in (0..=10).flat_map(|s| (0..=10 - s).map(move |t| (f64::from(s) / 10.0, f64::from(t) / 10.0))) {
                let shares = [s, t, 1.0 - s - t];
                let p = (0..3).map(|k| shares[k] * corners[k]).sum::<DVec2>();
                let plane = (0..3).map(|k| shares[k] * value(corners[k])).sum::<f64>();
                assert!(plane - value(p) <= bend(1.0, nearest), "{} at {p}", plane - value(p));
            }
        }
    }
}
