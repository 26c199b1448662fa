//! A triangle of the coarse mesh or a part of one, with the sites that may be nearest in it and bounds of their
//! distances.
//!
//! Cost of an update: a pass over these sites. Limits: the bounds assume exact distances at the corners.

use glam::{DVec2, DVec3};

use super::{
    super::{Site, TIE, voronoi::Voronoi},
    bounds::{clipped, cone_sag, lipschitz_bound},
    corner_paths::{CornerPaths, Detours, Leaders},
};
use crate::{
    distance::{DistanceField, NavTriangle},
    min_max::{fast_max, fast_min},
    triangulation::NONE,
};

/// Maxima are searched by ascent in pieces whose edges are no longer than this share of the distance. In such pieces,
/// cones are nearly planes, and a second maximum is rare.
const FLAT: f64 = 0.5;
/// With more sites than this in a piece, subdividing it costs less than an ascent in it.
const MAX_SITES_TO_ASCEND: usize = 16;
/// Pieces with edges below this share of the distance are not subdivided. A missed maximum is farther by at most this
/// share.
const MIN_EDGE_SHARE: f64 = 1.0 / 64.0;
/// The parts of a piece, by the indices of its corners (0 to 2) and of the midpoints of its edges (3 to 5). The last
/// part has all midpoints.
pub(super) const PARTS: [[usize; 3]; 4] = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]];

/// A triangular piece of the domain, and bounds of the distances in it.
pub(super) struct Piece {
    pub(super) corners: [DVec2; 3],
    /// The triangle of the navigation mesh that contains each corner.
    pub(super) nav_triangles: [NavTriangle; 3],
    /// Every site that may be the nearest somewhere in the piece, ascending.
    pub(super) sites: Vec<u32>,
    /// The paths from each of these sites. Empty if the piece has parts, whose paths are better.
    pub(super) paths: Vec<CornerPaths>,
    /// Distance of each corner to its nearest site.
    pub(super) nearest: [f64; 3],
    /// Number of its edges on the outline; for a part, an upper bound.
    walls: usize,
    /// Upper bound for the number of cones and walls that bound a cell in the piece, its own cone included.
    pub(super) limits: usize,
    /// Length of its longest edge.
    pub(super) longest: f64,
    pub(super) detours: Detours,
    /// Upper bound for the distance of the piece's points to their nearest site.
    pub(super) upper_bound: f64,
    /// Index of the first of its four parts; the others follow it.
    pub(super) parts: Option<u32>,
    /// The number of path queries that found its sites.
    pub(super) steps: u64,
}

/// The number of path queries to find which of a number of sites may be the nearest.
pub(super) fn steps_of_update(sites: usize) -> u64 {
    2 * sites as u64
}

/// The cost of computing the paths of a number of sites, by three queries of a field each.
fn steps_of_queries(sites: usize) -> u64 {
    60 * sites as u64
}

impl Piece {
    /// The piece of a triangle of the coarse mesh.
    pub(super) fn of_triangle(voronoi: &Voronoi, triangle: u32) -> Self {
        let (coarse, cells) = (voronoi.coarse, &voronoi.cells);
        let vertices = coarse.mesh.triangles[triangle as usize].map(|v| v as usize);
        let (corners, nav_triangles) =
            (vertices.map(|v| coarse.mesh.vertices[v]), vertices.map(|v| coarse.nav_triangles[v]));
        // A site that is the nearest somewhere in the triangle is no farther than this from its corners.
        let limits = vertices.map(|v| cells.distance[v] + 2.0 * coarse.reach[v]);
        let is_near = |site: &Site| (0..3).all(|k| site.rest.distance_squared(corners[k]) <= limits[k] * limits[k]);
        let near = (0..).zip(voronoi.sites.iter().zip(&voronoi.fields)).filter(|(_, (site, _))| is_near(site));
        let paths = near.map(|(at, (_, field))| (at, CornerPaths::new(&field.distances, &corners, &nav_triangles)));
        let walls = coarse.mesh.neighbours[triangle as usize].iter().filter(|&&n| n == NONE).count();
        let (sites, paths): (Vec<u32>, Vec<CornerPaths>) = paths.unzip();
        let of_queries = steps_of_queries(sites.len());
        let mut piece = Self::new(corners, nav_triangles, (sites, paths), walls);
        piece.steps += of_queries;
        piece
    }

    /// A piece in which only `sites` can be the nearest.
    fn new(
        corners: [DVec2; 3],
        nav_triangles: [NavTriangle; 3],
        (sites, paths): (Vec<u32>, Vec<CornerPaths>),
        walls: usize,
    ) -> Self {
        let lengths = edge_lengths(&corners);
        let (longest, detours) = (lengths.into_iter().fold(0.0, f64::max), Detours::new(lengths));
        let (nearest, limits, upper_bound) = ([f64::INFINITY; 3], 0, f64::INFINITY);
        let (parts, steps) = (None, steps_of_update(sites.len()));
        let mut piece = Self {
            corners,
            nav_triangles,
            sites,
            paths,
            nearest,
            walls,
            limits,
            longest,
            detours,
            upper_bound,
            parts,
            steps,
        };
        piece.update_bounds();
        // Of hundreds of sites nearby, few are left.
        piece.sites.shrink_to_fit();
        piece.paths.shrink_to_fit();
        piece
    }

    /// Whether a site may be the nearest somewhere in the piece.
    pub(super) fn has(&self, site: usize) -> bool {
        self.sites.binary_search(&(site as u32)).is_ok()
    }

    /// Inserts a site with a greater index than all known ones. Returns whether it may be the nearest somewhere.
    pub(super) fn insert(&mut self, site: u32, paths: CornerPaths) -> bool {
        if !paths.may_enter(&self.nearest, &self.detours) {
            return false;
        }
        self.sites.push(site);
        self.paths.push(paths);
        self.update_bounds();
        self.sites.last() == Some(&site)
    }

    /// The paths from a site to the corners.
    pub(super) fn corner_paths(&self, field: &DistanceField) -> CornerPaths {
        CornerPaths::new(field, &self.corners, &self.nav_triangles)
    }

    /// Drops the sites that are nowhere the nearest, and computes the upper bound from the others.
    fn update_bounds(&mut self) {
        let Self { corners, longest, detours, .. } = *self;
        let nearest = self.paths.iter().fold([f64::INFINITY; 3], |known, paths| paths.nearer(&known));
        // For each corner the nearest site with a single cone.
        let rivals = [0, 1, 2].map(|k| {
            let cones = self
                .paths
                .iter()
                .filter(|paths| paths.may_enter(&nearest, &detours) && paths.pseudo_source().is_some());
            cones.reduce(|best, paths| if paths.distance(k) < best.distance(k) { paths } else { best }).copied()
        });
        let leaders = Leaders::of(&self.paths);
        let is_kept = |paths: &CornerPaths| {
            if !paths.may_enter(&nearest, &detours) {
                return false;
            }
            let is_nearer =
                |rival: &CornerPaths, margin: f64| (0..3).all(|k| rival.distance(k) + margin < paths.distance(k));
            // Between the corners a cone sags by no more than this. A rival's cone does not rise above its plane.
            let sag = paths.pseudo_source().map_or(f64::INFINITY, |source| self.cone_sag(source));
            let leader = leaders.of_same_sources(paths);
            !rivals.iter().flatten().any(|rival| is_nearer(rival, sag))
                && !leader.is_some_and(|leader| is_nearer(leader, 2.0 * TIE * paths.distance(0)))
        };
        let kept: Vec<bool> = self.paths.iter().map(is_kept).collect();
        retain(&mut self.sites, &kept);
        retain(&mut self.paths, &kept);
        let cones = self.paths.iter().filter(|paths| paths.pseudo_source().is_some());
        self.limits = self.walls + 2 * self.paths.len() - cones.clone().count();
        self.nearest = nearest;
        let lengths = edge_lengths(&corners);
        let from_corner = (0..3).map(|k| nearest[k] + fast_max(lengths[k], lengths[(k + 2) % 3]));
        // A cone is convex, so it is greatest at a corner.
        let at_corner = cones.map(|paths| (0..3).map(|k| paths.distance(k)).fold(0.0, fast_max));
        let lipschitz = lipschitz_bound(&nearest, longest);
        self.upper_bound = from_corner.chain(at_corner).fold(lipschitz, fast_min);
    }

    fn is_divisible(&self) -> bool {
        self.longest >= MIN_EDGE_SHARE * self.upper_bound
    }

    /// The four parts; `None` if they would be too small to matter.
    pub(super) fn divided(&self, voronoi: &Voronoi) -> Option<[Self; 4]> {
        if !self.is_divisible() {
            return None;
        }
        let [a, b, c] = self.corners;
        let middles = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        let nav_triangles = middles.map(|p| voronoi.navigation.triangle_at(p));
        let [Some(ab), Some(bc), Some(ca)] = nav_triangles else { return None };
        let (corners, nav_triangles) = ([self.corners, middles], [self.nav_triangles, [ab, bc, ca]]);
        let paths_of = |(&site, &of_corners): (&u32, &CornerPaths)| {
            let field = &voronoi.fields[site as usize].distances;
            [of_corners, CornerPaths::new(field, &middles, &nav_triangles[1])]
        };
        let paths: Vec<[CornerPaths; 2]> = self.sites.iter().zip(&self.paths).map(paths_of).collect();
        let of_queries = steps_of_queries(paths.len()) / PARTS.len() as u64;
        Some(PARTS.map(|part| {
            let of_part = |[outer, inner]: &[CornerPaths; 2]| CornerPaths::of_part(outer, inner, part);
            let (corners, nav_triangles) =
                (part.map(|k| corners[k / 3][k % 3]), part.map(|k| nav_triangles[k / 3][k % 3]));
            let paths = paths.iter().map(of_part).collect();
            let mut piece = Self::new(corners, nav_triangles, (self.sites.clone(), paths), self.walls);
            piece.steps += of_queries;
            piece
        }))
    }

    /// Upper bound for the distance of a site to the points of its cell in the piece; `None` if the cell does not enter
    /// it.
    ///
    /// Between the corners, a cone lies slightly below the plane through its values there. So the cell lies where that
    /// plane, less the sag, is no higher than the planes of other sites.
    pub(super) fn upper_bound_of(&self, site: usize) -> Option<f64> {
        let own = self.sites.iter().zip(&self.paths).find_map(|(&at, paths)| (at == site as u32).then_some(paths))?;
        let Some(source) = own.pseudo_source() else { return Some(self.upper_bound) };
        let sag = self.cone_sag(source);
        // In barycentric coordinates.
        let mut cell: Vec<DVec3> = DVec3::AXES.to_vec();
        for other in self.paths.iter().filter(|paths| paths.pseudo_source().is_some()) {
            let higher = DVec3::from([0, 1, 2].map(|k| own.distance(k) - other.distance(k)));
            cell = clipped(&cell, |p| sag - higher.dot(p));
        }
        let plane = DVec3::from([0, 1, 2].map(|k| own.distance(k)));
        cell.into_iter().map(|p| plane.dot(p)).reduce(f64::max).map(|upper_bound| upper_bound.min(self.upper_bound))
    }

    /// Greatest depth of the cone of a pseudo-source below the plane through its values at the corners.
    fn cone_sag(&self, source: DVec2) -> f64 {
        cone_sag(self.longest, self.corners.iter().map(|corner| corner.distance(source)).fold(f64::INFINITY, f64::min))
    }

    /// Whether the piece is small enough for an ascent.
    pub(super) fn is_flat(&self) -> bool {
        self.parts.is_none()
            && self.longest <= FLAT * self.upper_bound
            && (self.sites.len() <= MAX_SITES_TO_ASCEND || !self.is_divisible())
    }
}

/// Retains the flagged items of a list.
fn retain<T>(list: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    list.retain(|_| kept.next().is_some_and(|&is_kept| is_kept));
}

/// Lengths of the edges from each corner to the next.
fn edge_lengths(corners: &[DVec2; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| corners[k].distance(corners[(k + 1) % 3]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        distance::{Navigation, PathEnd},
        domain::Domain,
        picture::Picture,
    };

    #[test]
    fn keeps_the_nearest_of_sites_behind_the_same_corners() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
        let [before, beside] = [(-30.0, 0.0), (-10.0, 1.0)].map(DVec2::from);
        // Paths from sites at a distance `behind` the corner `before`. They bend at the given pseudo-sources.
        let paths_by = |sources: [DVec2; 3], behind: f64| -> CornerPaths {
            CornerPaths([0, 1, 2].map(|k| {
                let offset = behind + before.distance(sources[k]);
                let distance = offset + sources[k].distance(corners[k]);
                Some(PathEnd { distance, pseudo_source: sources[k], offset })
            }))
        };
        let (ways, other_ways) = ([before, before, beside], [before, beside, beside]);
        let behind = [7.0, 5.0, 5.0 + 1e-12, 6.0, 5.1].map(|behind| paths_by(ways, behind));
        let paths: Vec<CornerPaths> = behind.into_iter().chain([paths_by(other_ways, 6.0)]).collect();
        let navigation = Navigation::new(&Domain::new(None, &Picture::new(2, 2, &[255; 16]).unwrap()).unwrap());
        let triangle = navigation.triangle_at(DVec2::ONE).unwrap();
        let piece = Piece::new(corners, [triangle; 3], ((0..).take(paths.len()).collect(), paths), 0);
        // Differences within rounding are ties.
        assert_eq!(piece.sites, [1, 2, 5]);
    }
}
