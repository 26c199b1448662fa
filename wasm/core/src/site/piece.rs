//! Branch and bound for the farthest points of cells: scout triangles, subdivided in four, each with the sites that may be
//! nearest in it and an upper bound of the distance.
//!
//! A piece lists every site that may be the nearest somewhere in it, for all cells alike, and is updated when sites are
//! inserted. So a subdivision made for one cell serves its neighbours and the next round: thousands of sites among a thousand
//! scouts cost hardly more each than a few do.

use glam::{DVec2, DVec3};

use super::{
    Site,
    farthest::{Cone, Cones, ascend},
    regions::{FarPoint, Regions},
    virtual_sites::TIE,
};
use crate::{
    distance::{DistanceField, PathEnd, Place},
    triangulation::NONE,
};

/// Maxima are searched by ascent in pieces whose edges are no longer than this share of the distance: there cones are nearly
/// planes, and a second maximum is rare.
const FLAT: f64 = 0.5;
/// With more sites than this in a piece, subdividing it costs less than an ascent in it.
const MAX_SITES_TO_ASCEND: usize = 16;
/// Pieces with edges below this share of the distance are not subdivided. A maximum missed in one of them is farther by no
/// more than this share.
const MIN_EDGE_SHARE: f64 = 1.0 / 64.0;
/// The parts of a piece, by the indices of its corners (0 to 2) and of the midpoints of its edges (3 to 5). The last has all
/// midpoints.
const PARTS: [[usize; 3]; 4] = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]];

/// The paths from a site to the corners of a piece.
type PathEnds = [Option<PathEnd>; 3];

/// A piece of the domain, and bounds of the distances in it.
pub(super) struct Piece {
    corners: [DVec2; 3],
    places: [Place; 3],
    /// Every site that may be the nearest somewhere in the piece, ascending.
    sites: Vec<u32>,
    /// Paths from these sites, in the same order. Empty where there are parts, which have better ones.
    paths: Vec<PathEnds>,
    /// Distance of each corner to its nearest site.
    nearest: [f64; 3],
    /// Number of its edges on the outline; for a part, an upper bound.
    walls: usize,
    /// Upper bound for the number of cones and walls that bound a cell in the piece, its own cone included.
    limits: usize,
    longest: f64,
    /// Upper bound for the distance of the piece's points to their nearest site.
    pub(super) upper_bound: f64,
    /// Index of the first of its four parts; the others follow.
    parts: Option<u32>,
}

/// The opened triangles of the scouts' mesh, and their parts.
#[derive(Default)]
pub(super) struct Pieces {
    pieces: Vec<Piece>,
    /// The piece of each triangle; [`NONE`] where it is not opened.
    roots: Vec<u32>,
    /// The opened triangles.
    opened: Vec<u32>,
}

impl Pieces {
    pub(super) fn new(triangles: usize) -> Self {
        Self { roots: vec![NONE; triangles], ..Self::default() }
    }

    pub(super) fn piece(&self, at: u32) -> &Piece {
        &self.pieces[at as usize]
    }

    /// The piece of a triangle, if opened.
    pub(super) fn known(&self, triangle: u32) -> Option<&Piece> {
        let root = self.roots[triangle as usize];
        (root != NONE).then(|| self.piece(root))
    }

    /// The index of a triangle's piece; opens the triangle if necessary.
    pub(super) fn root(&mut self, regions: &Regions, triangle: u32) -> u32 {
        if self.roots[triangle as usize] == NONE {
            self.roots[triangle as usize] = self.pieces.len() as u32;
            self.opened.push(triangle);
            self.pieces.push(Piece::of_scouts(regions, triangle));
        }
        self.roots[triangle as usize]
    }

    /// The indices of a piece's parts; subdivides it if necessary. Empty where they would be too small to matter.
    pub(super) fn parts(&mut self, regions: &Regions, at: u32) -> std::ops::Range<u32> {
        let piece = self.piece(at);
        let first = match piece.parts {
            Some(first) => first,
            None => {
                let Some(parts) = piece.divided(regions) else { return 0..0 };
                let (first, piece) = (self.pieces.len() as u32, &mut self.pieces[at as usize]);
                piece.sites.retain(|&site| parts.iter().any(|part| part.has(site as usize)));
                (piece.parts, piece.paths) = (Some(first), Vec::new());
                self.pieces.extend(parts);
                first
            }
        };
        first..first + PARTS.len() as u32
    }

    /// Inserts the last site. Its cell has points only in triangles whose scouts were visited for it.
    pub(super) fn insert(&mut self, regions: &Regions) {
        let Some((site, Site { field, .. })) = (0..).zip(&regions.sites).last() else { return };
        for at in 0..self.opened.len() {
            let triangle = self.opened[at] as usize;
            if regions.cells.saw(regions.scouts.mesh.triangles[triangle]) {
                let root = self.roots[triangle];
                let paths = self.piece(root).path_ends(field);
                self.enter(root, site, field, paths);
            }
        }
    }

    /// Inserts a site into a piece and its parts. Returns whether it may be the nearest somewhere there.
    fn enter(&mut self, at: u32, site: u32, field: &DistanceField, paths: PathEnds) -> bool {
        let piece = &mut self.pieces[at as usize];
        let Some(first) = piece.parts else { return piece.enter(site, paths) };
        if !may_enter(&paths, &piece.nearest, piece.longest) {
            return false;
        }
        piece.nearest = nearer(&piece.nearest, &paths);
        let middles = self.piece(first + PARTS.len() as u32 - 1).path_ends(field);
        let of_part = |part: [usize; 3]| part.map(|at| [paths, middles][at / 3][at % 3]);
        let entered = (first..).zip(PARTS).filter(|&(at, part)| self.enter(at, site, field, of_part(part))).count();
        if entered > 0 {
            self.pieces[at as usize].sites.push(site);
        }
        entered > 0
    }
}

impl Piece {
    /// The piece of a triangle of scouts.
    fn of_scouts(regions: &Regions, triangle: u32) -> Self {
        let (scouts, cells) = (regions.scouts, &regions.cells);
        let vertices = scouts.mesh.triangles[triangle as usize].map(|v| v as usize);
        let (corners, places) = (vertices.map(|v| scouts.mesh.vertices[v]), vertices.map(|v| scouts.places[v]));
        // A site that is the nearest somewhere in the triangle is no farther than this from its corners.
        let limits = vertices.map(|v| cells.distance[v] + 2.0 * scouts.reach[v]);
        let is_near = |site: &Site| (0..3).all(|k| site.rest.distance_squared(corners[k]) <= limits[k] * limits[k]);
        let near = (0..).zip(&regions.sites).filter(|(_, site)| is_near(site));
        let paths = near.map(|(at, site)| (at, path_ends(&site.field, &corners, &places)));
        let walls = scouts.mesh.neighbours[triangle as usize].iter().filter(|&&n| n == NONE).count();
        Self::new(corners, places, paths.unzip(), walls)
    }

    /// A piece in which only `sites` can be the nearest.
    fn new(corners: [DVec2; 3], places: [Place; 3], (sites, paths): (Vec<u32>, Vec<PathEnds>), walls: usize) -> Self {
        let longest = lengths(&corners).into_iter().fold(0.0, f64::max);
        let (nearest, limits, upper_bound) = ([f64::INFINITY; 3], 0, f64::INFINITY);
        let mut piece =
            Self { corners, places, sites, paths, nearest, walls, limits, longest, upper_bound, parts: None };
        piece.update_bounds();
        piece
    }

    /// Whether a site may be the nearest somewhere in the piece.
    pub(super) fn has(&self, site: usize) -> bool {
        self.sites.binary_search(&(site as u32)).is_ok()
    }

    /// Inserts a site with a greater index than all known ones. Returns whether it may be the nearest somewhere.
    fn enter(&mut self, site: u32, paths: PathEnds) -> bool {
        if !may_enter(&paths, &self.nearest, self.longest) {
            return false;
        }
        self.sites.push(site);
        self.paths.push(paths);
        self.update_bounds();
        self.sites.last() == Some(&site)
    }

    /// The paths from a site to the corners.
    fn path_ends(&self, field: &DistanceField) -> PathEnds {
        path_ends(field, &self.corners, &self.places)
    }

    /// Drops the sites that are nowhere the nearest, and computes the upper bound from the others.
    fn update_bounds(&mut self) {
        let Self { corners, longest, .. } = *self;
        let nearest = self.paths.iter().fold([f64::INFINITY; 3], |known, paths| nearer(&known, paths));
        // For each corner the nearest site with a single cone.
        let rivals = [0, 1, 2].map(|k| {
            let cones =
                self.paths.iter().filter(|paths| may_enter(paths, &nearest, longest) && pseudo_source(paths).is_some());
            cones.reduce(|best, paths| if distance(paths, k) < distance(best, k) { paths } else { best }).copied()
        });
        let leaders = nearest_by_sources(&self.paths);
        let is_kept = |paths: &PathEnds| {
            if !may_enter(paths, &nearest, longest) {
                return false;
            }
            let of_another = |rival: &PathEnds, sag: f64| (0..3).all(|k| distance(rival, k) + sag < distance(paths, k));
            // Between the corners a cone sags by no more than this; that of another site does not rise above its plane.
            let sag = pseudo_source(paths).map_or(f64::INFINITY, |source| self.cone_sag(source));
            let is_behind = |leader: &PathEnds| {
                have_same_sources(leader, paths) && of_another(leader, 2.0 * TIE * distance(paths, 0))
            };
            !rivals.iter().flatten().any(|rival| of_another(rival, sag)) && !leaders.iter().any(is_behind)
        };
        let kept: Vec<bool> = self.paths.iter().map(is_kept).collect();
        keep(&mut self.sites, &kept);
        keep(&mut self.paths, &kept);
        let cones = self.paths.iter().filter(|paths| pseudo_source(paths).is_some());
        self.limits = self.walls + 2 * self.paths.len() - cones.clone().count();
        self.nearest = nearest;
        let lengths = lengths(&corners);
        let from_corner = (0..3).map(|k| nearest[k] + lengths[k].max(lengths[(k + 2) % 3]));
        // A cone is convex, so it is greatest at a corner.
        let at_corner = cones.map(|paths| (0..3).map(|k| distance(paths, k)).fold(0.0, f64::max));
        self.upper_bound = from_corner.chain(at_corner).fold(f64::INFINITY, f64::min);
    }

    fn is_divisible(&self) -> bool {
        self.longest >= MIN_EDGE_SHARE * self.upper_bound
    }

    /// The four parts; `None` where they would be too small to matter.
    fn divided(&self, regions: &Regions) -> Option<[Self; 4]> {
        if !self.is_divisible() {
            return None;
        }
        let [a, b, c] = self.corners;
        let middles = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        let places = middles.map(|p| regions.navigation.place(p));
        let [Some(ab), Some(bc), Some(ca)] = places else { return None };
        let (corners, places) = ([self.corners, middles], [self.places, [ab, bc, ca]]);
        let paths_of = |(&site, &of_corners): (&u32, &PathEnds)| {
            [of_corners, path_ends(&regions.sites[site as usize].field, &middles, &places[1])]
        };
        let paths: Vec<[PathEnds; 2]> = self.sites.iter().zip(&self.paths).map(paths_of).collect();
        Some(PARTS.map(|part| {
            let of_part = |paths: &[PathEnds; 2]| part.map(|k| paths[k / 3][k % 3]);
            let (corners, places) = (part.map(|k| corners[k / 3][k % 3]), part.map(|k| places[k / 3][k % 3]));
            Self::new(corners, places, (self.sites.clone(), paths.iter().map(of_part).collect()), self.walls)
        }))
    }

    /// Upper bound for the distance of a site to the points of its cell in the piece; `None` where the cell does not enter
    /// the piece.
    ///
    /// Between the corners a cone lies slightly below the plane through its values there: the cell lies in the part of the
    /// piece where that plane, less the sag, is no higher than those of other sites.
    pub(super) fn upper_bound_of(&self, site: usize) -> Option<f64> {
        let own = self.sites.iter().zip(&self.paths).find_map(|(&at, paths)| (at == site as u32).then_some(paths))?;
        let Some(source) = pseudo_source(own) else { return Some(self.upper_bound) };
        let sag = self.cone_sag(source);
        let mut rest: Vec<DVec3> = DVec3::AXES.to_vec();
        for other in self.paths.iter().filter(|paths| pseudo_source(paths).is_some()) {
            let higher = DVec3::from([0, 1, 2].map(|k| distance(own, k) - distance(other, k)));
            rest = clipped(&rest, |p| sag - higher.dot(p));
        }
        let plane = DVec3::from([0, 1, 2].map(|k| distance(own, k)));
        rest.into_iter().map(|p| plane.dot(p)).reduce(f64::max).map(|upper_bound| upper_bound.min(self.upper_bound))
    }

    /// Greatest depth of the cone of a pseudo-source below the plane through its values at the corners.
    fn cone_sag(&self, source: DVec2) -> f64 {
        cone_sag(self.longest, self.corners.iter().map(|corner| corner.distance(source)).fold(f64::INFINITY, f64::min))
    }

    /// Whether it is small enough for an ascent.
    pub(super) fn is_flat(&self) -> bool {
        self.parts.is_none()
            && self.longest <= FLAT * self.upper_bound
            && (self.sites.len() <= MAX_SITES_TO_ASCEND || !self.is_divisible())
    }

    /// Local maxima of the distance in a site's cell, in a flat piece: the greatest, and others if they may be as far as
    /// `known`. Empty where none is found.
    pub(super) fn maxima(&self, regions: &Regions, site: usize, known: f64) -> Vec<FarPoint> {
        let ascend_from = |from: DVec2| {
            let limit = self.upper_bound + self.longest;
            let maxima = ascend(&self.corners, from, |p, cones| self.cones(regions, site, p, limit, cones));
            maxima.into_iter().filter_map(|p| self.in_cell(regions, site, p))
        };
        let mut maxima: Vec<FarPoint> = ascend_from(self.corners.iter().sum::<DVec2>() / 3.0).collect();
        let Some(maximum) = maxima.first() else { return maxima };
        // Three cones meet once. With more, a narrow cell may have another maximum beside the first, farther by no more than
        // the sag.
        if self.limits > 3 && maximum.distance + cone_sag(self.longest, maximum.distance) >= known {
            for from in self.corners {
                maxima.extend(ascend_from(from));
            }
        }
        maxima
    }

    /// Lists the cones at a point that are no higher than `limit`.
    fn cones(&self, regions: &Regions, site: usize, p: DVec2, limit: f64, cones: &mut Cones) {
        let Some(place) = self.place(regions, p) else { return };
        for &at in &self.sites {
            let paths = regions.sites[at as usize].field.path_ends(place, p).filter(|path| path.distance <= limit);
            let list = if at == site as u32 { &mut cones.own } else { &mut cones.others };
            let first = list.len();
            for path in paths {
                let cone = Cone { apex: path.pseudo_source, offset: path.offset };
                // Cones of two sites coincide only behind a common corner of the outline.
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

/// The paths from a site to three points.
pub(super) fn path_ends(field: &DistanceField, points: &[DVec2; 3], places: &[Place; 3]) -> PathEnds {
    let mut field = field.cached_lookup();
    [0, 1, 2].map(|k| field.path_end(places[k], points[k]))
}

/// Retains the flagged items of a list.
fn keep<T>(list: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    list.retain(|_| kept.next().is_some_and(|&is_kept| is_kept));
}

/// Lengths of the edges from each corner to the next.
fn lengths(corners: &[DVec2; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| corners[k].distance(corners[(k + 1) % 3]))
}

fn distance(paths: &PathEnds, corner: usize) -> f64 {
    paths[corner].map_or(f64::INFINITY, |path| path.distance)
}

/// The pseudo-source of all paths, if it is the same.
fn pseudo_source(paths: &PathEnds) -> Option<DVec2> {
    let [a, b, c] = sources(paths);
    if a == b && b == c { a } else { None }
}

/// For each triple of pseudo-sources on the outline, the site nearest to it. A site that is farther from all three is nowhere
/// the nearest.
fn nearest_by_sources(all: &[PathEnds]) -> Vec<PathEnds> {
    let length = |paths: &PathEnds| paths.iter().flatten().map(|path| path.offset).sum::<f64>();
    let mut nearest: Vec<PathEnds> = Vec::new();
    for paths in all.iter().filter(|paths| paths.iter().all(|path| path.is_some_and(|path| path.offset > 0.0))) {
        match nearest.iter_mut().find(|leader| have_same_sources(leader, paths)) {
            Some(leader) if length(paths) < length(leader) => *leader = *paths,
            Some(_) => {}
            None => nearest.push(*paths),
        }
    }
    nearest
}

/// Whether the paths to each corner have the same pseudo-source.
fn have_same_sources(one: &PathEnds, other: &PathEnds) -> bool {
    sources(one) == sources(other)
}

/// The pseudo-source of the path to each corner.
fn sources(paths: &PathEnds) -> [Option<DVec2>; 3] {
    paths.map(|path| path.map(|path| path.pseudo_source))
}

/// The part of a convex polygon where a linear function is non-negative.
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

/// The minimum of the known distances and those of a site.
fn nearer(known: &[f64; 3], paths: &PathEnds) -> [f64; 3] {
    [0, 1, 2].map(|k| known[k].min(distance(paths, k)))
}

/// Whether a site may be the nearest somewhere: distances are 1-Lipschitz.
fn may_enter(paths: &PathEnds, nearest: &[f64; 3], longest: f64) -> bool {
    (0..3).all(|k| distance(paths, k) <= nearest[k] + 2.0 * longest)
}

/// Greatest depth of a cone below the plane through three of its points with edges no longer than `longest`, none of them
/// nearer to the apex than `distance`.
pub(super) fn cone_sag(longest: f64, distance: f64) -> f64 {
    // Along a level line the curvature of a cone is 1 / distance; the circumcircle of a triangle has no radius above its
    // longest edge / √3, or most of the circle lies outside.
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
        // The corner `beside` is seen from the corner `before`; sites are at these distances behind it.
        let paths_by = |sources: [DVec2; 3], behind: f64| -> PathEnds {
            [0, 1, 2].map(|k| {
                let offset = behind + before.distance(sources[k]);
                let distance = offset + sources[k].distance(corners[k]);
                Some(PathEnd { distance, pseudo_source: sources[k], offset })
            })
        };
        let (ways, other_ways) = ([before, before, beside], [before, beside, beside]);
        let behind = [7.0, 5.0, 5.0 + 1e-12, 6.0, 5.1].map(|behind| paths_by(ways, behind));
        let paths: Vec<PathEnds> = behind.into_iter().chain([paths_by(other_ways, 6.0)]).collect();
        let navigation = Navigation::new(&Domain::new(None, &Picture::new(2, 2, &[255; 16]).unwrap()).unwrap());
        let place = navigation.place(DVec2::ONE).unwrap();
        let piece = Piece::new(corners, [place; 3], ((0..).take(paths.len()).collect(), paths), 0);
        // Differences within rounding are ties.
        assert_eq!(piece.sites, [1, 2, 5]);
    }

    #[test]
    fn no_cone_sags_more_than_its_bound() {
        let value = |p: DVec2| p.length();
        // Triangles with edges of at most 1, the long one along a level line or across it, beyond the distance.
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
                assert!(plane - value(p) <= cone_sag(1.0, nearest), "{} at {p}", plane - value(p));
            }
        }
    }
}
