//! A part of a triangle of coarse samples, with the sites that may be nearest in it and an upper bound of the distance.

use glam::{DVec2, DVec3};

use super::{
    super::{Regions, Site, TIE},
    FarPoint,
    ascent::{Cone, Cones, ascend},
    corner_paths::{CornerPaths, nearest_by_sources},
};
use crate::{
    distance::{DistanceField, NavTriangle},
    min_max::{fast_max, fast_min},
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
pub(super) const PARTS: [[usize; 3]; 4] = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]];

/// A piece of the domain, and bounds of the distances in it.
pub(super) struct Piece {
    corners: [DVec2; 3],
    nav_triangles: [NavTriangle; 3],
    /// Every site that may be the nearest somewhere in the piece, ascending.
    pub(super) sites: Vec<u32>,
    /// Paths from these sites, in the same order. Empty where there are parts, which have better ones.
    pub(super) paths: Vec<CornerPaths>,
    /// Distance of each corner to its nearest site.
    pub(super) nearest: [f64; 3],
    /// Number of its edges on the outline; for a part, an upper bound.
    walls: usize,
    /// Upper bound for the number of cones and walls that bound a cell in the piece, its own cone included.
    limits: usize,
    pub(super) longest: f64,
    /// Upper bound for the distance of the piece's points to their nearest site.
    pub(super) upper_bound: f64,
    /// Index of the first of its four parts; the others follow.
    pub(super) parts: Option<u32>,
}

impl Piece {
    /// The piece of a triangle of coarse samples.
    pub(super) fn of_coarse(regions: &Regions, triangle: u32) -> Self {
        let (coarse, cells) = (regions.coarse, &regions.cells);
        let vertices = coarse.mesh.triangles[triangle as usize].map(|v| v as usize);
        let (corners, nav_triangles) =
            (vertices.map(|v| coarse.mesh.vertices[v]), vertices.map(|v| coarse.nav_triangles[v]));
        // A site that is the nearest somewhere in the triangle is no farther than this from its corners.
        let limits = vertices.map(|v| cells.distance[v] + 2.0 * coarse.reach[v]);
        let is_near = |site: &Site| (0..3).all(|k| site.rest.distance_squared(corners[k]) <= limits[k] * limits[k]);
        let near = (0..).zip(&regions.sites).filter(|(_, site)| is_near(site));
        let paths = near.map(|(at, site)| (at, CornerPaths::new(&site.field, &corners, &nav_triangles)));
        let walls = coarse.mesh.neighbours[triangle as usize].iter().filter(|&&n| n == NONE).count();
        Self::new(corners, nav_triangles, paths.unzip(), walls)
    }

    /// A piece in which only `sites` can be the nearest.
    fn new(
        corners: [DVec2; 3],
        nav_triangles: [NavTriangle; 3],
        (sites, paths): (Vec<u32>, Vec<CornerPaths>),
        walls: usize,
    ) -> Self {
        let longest = lengths(&corners).into_iter().fold(0.0, f64::max);
        let (nearest, limits, upper_bound) = ([f64::INFINITY; 3], 0, f64::INFINITY);
        let mut piece =
            Self { corners, nav_triangles, sites, paths, nearest, walls, limits, longest, upper_bound, parts: None };
        piece.update_bounds();
        piece
    }

    /// Whether a site may be the nearest somewhere in the piece.
    pub(super) fn has(&self, site: usize) -> bool {
        self.sites.binary_search(&(site as u32)).is_ok()
    }

    /// Inserts a site with a greater index than all known ones. Returns whether it may be the nearest somewhere.
    pub(super) fn enter(&mut self, site: u32, paths: CornerPaths) -> bool {
        if !paths.may_enter(&self.nearest, self.longest) {
            return false;
        }
        self.sites.push(site);
        self.paths.push(paths);
        self.update_bounds();
        self.sites.last() == Some(&site)
    }

    /// The paths from a site to the corners.
    pub(super) fn path_ends(&self, field: &DistanceField) -> CornerPaths {
        CornerPaths::new(field, &self.corners, &self.nav_triangles)
    }

    /// Drops the sites that are nowhere the nearest, and computes the upper bound from the others.
    fn update_bounds(&mut self) {
        let Self { corners, longest, .. } = *self;
        let nearest = self.paths.iter().fold([f64::INFINITY; 3], |known, paths| paths.nearer(&known));
        // For each corner the nearest site with a single cone.
        let rivals = [0, 1, 2].map(|k| {
            let cones =
                self.paths.iter().filter(|paths| paths.may_enter(&nearest, longest) && paths.pseudo_source().is_some());
            cones.reduce(|best, paths| if paths.distance(k) < best.distance(k) { paths } else { best }).copied()
        });
        let leaders = nearest_by_sources(&self.paths);
        let is_kept = |paths: &CornerPaths| {
            if !paths.may_enter(&nearest, longest) {
                return false;
            }
            let of_another =
                |rival: &CornerPaths, sag: f64| (0..3).all(|k| rival.distance(k) + sag < paths.distance(k));
            // Between the corners a cone sags by no more than this; that of another site does not rise above its plane.
            let sag = paths.pseudo_source().map_or(f64::INFINITY, |source| self.cone_sag(source));
            let is_behind = |leader: &CornerPaths| {
                leader.have_sources_of(paths) && of_another(leader, 2.0 * TIE * paths.distance(0))
            };
            !rivals.iter().flatten().any(|rival| of_another(rival, sag)) && !leaders.iter().any(is_behind)
        };
        let kept: Vec<bool> = self.paths.iter().map(is_kept).collect();
        keep(&mut self.sites, &kept);
        keep(&mut self.paths, &kept);
        let cones = self.paths.iter().filter(|paths| paths.pseudo_source().is_some());
        self.limits = self.walls + 2 * self.paths.len() - cones.clone().count();
        self.nearest = nearest;
        let lengths = lengths(&corners);
        let from_corner = (0..3).map(|k| nearest[k] + fast_max(lengths[k], lengths[(k + 2) % 3]));
        // A cone is convex, so it is greatest at a corner.
        let at_corner = cones.map(|paths| (0..3).map(|k| paths.distance(k)).fold(0.0, fast_max));
        let lipschitz = lipschitz_bound(&nearest, longest);
        self.upper_bound = from_corner.chain(at_corner).fold(lipschitz, fast_min);
    }

    fn is_divisible(&self) -> bool {
        self.longest >= MIN_EDGE_SHARE * self.upper_bound
    }

    /// The four parts; `None` where they would be too small to matter.
    pub(super) fn divided(&self, regions: &Regions) -> Option<[Self; 4]> {
        if !self.is_divisible() {
            return None;
        }
        let [a, b, c] = self.corners;
        let middles = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        let nav_triangles = middles.map(|p| regions.navigation.triangle_at(p));
        let [Some(ab), Some(bc), Some(ca)] = nav_triangles else { return None };
        let (corners, nav_triangles) = ([self.corners, middles], [self.nav_triangles, [ab, bc, ca]]);
        let paths_of = |(&site, &of_corners): (&u32, &CornerPaths)| {
            [of_corners, CornerPaths::new(&regions.sites[site as usize].field, &middles, &nav_triangles[1])]
        };
        let paths: Vec<[CornerPaths; 2]> = self.sites.iter().zip(&self.paths).map(paths_of).collect();
        Some(PARTS.map(|part| {
            let of_part = |[outer, inner]: &[CornerPaths; 2]| CornerPaths::of_part(outer, inner, part);
            let (corners, nav_triangles) =
                (part.map(|k| corners[k / 3][k % 3]), part.map(|k| nav_triangles[k / 3][k % 3]));
            Self::new(corners, nav_triangles, (self.sites.clone(), paths.iter().map(of_part).collect()), self.walls)
        }))
    }

    /// Upper bound for the distance of a site to the points of its cell in the piece; `None` where the cell does not enter
    /// the piece.
    ///
    /// Between the corners a cone lies slightly below the plane through its values there: the cell lies in the part of the
    /// piece where that plane, less the sag, is no higher than those of other sites.
    pub(super) fn upper_bound_of(&self, site: usize) -> Option<f64> {
        let own = self.sites.iter().zip(&self.paths).find_map(|(&at, paths)| (at == site as u32).then_some(paths))?;
        let Some(source) = own.pseudo_source() else { return Some(self.upper_bound) };
        let sag = self.cone_sag(source);
        let mut rest: Vec<DVec3> = DVec3::AXES.to_vec();
        for other in self.paths.iter().filter(|paths| paths.pseudo_source().is_some()) {
            let higher = DVec3::from([0, 1, 2].map(|k| own.distance(k) - other.distance(k)));
            rest = clipped(&rest, |p| sag - higher.dot(p));
        }
        let plane = DVec3::from([0, 1, 2].map(|k| own.distance(k)));
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
        let Some(triangle) = self.triangle_at(regions, p) else { return };
        for &at in &self.sites {
            let paths = regions.sites[at as usize].field.path_ends(triangle, p).filter(|path| path.distance <= limit);
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

    /// The triangle of the outline that a point of the piece lies in.
    fn triangle_at(&self, regions: &Regions, p: DVec2) -> Option<NavTriangle> {
        let [a, b, c] = self.nav_triangles;
        if a == b && b == c { Some(a) } else { regions.navigation.triangle_at(p) }
    }

    fn in_cell(&self, regions: &Regions, site: usize, p: DVec2) -> Option<FarPoint> {
        let triangle = self.triangle_at(regions, p)?;
        let distance = |at: usize| regions.sites[at].field.distance(triangle, p);
        let least = self.sites.iter().map(|&at| distance(at as usize)).fold(f64::INFINITY, f64::min);
        let of_site = distance(site) <= least * (1.0 + TIE);
        (of_site && least.is_finite()).then_some(FarPoint { at: p, triangle, distance: least })
    }
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

/// Upper bound of a 1-Lipschitz function in a triangle with edges no longer than `longest`, from its values at the corners.
pub(super) fn lipschitz_bound(values: &[f64; 3], longest: f64) -> f64 {
    // A point's value is at most Σ λᵢ (valueᵢ + distance to cornerᵢ) with its barycentric coordinates λ. There Σ λᵢ distanceᵢ is
    // at most √Σ λᵢ distanceᵢ², by Jensen's inequality, which is at most longest · √Σ λᵢ λⱼ over the pairs. The greatest of
    // these sums for any λ:
    let mean = values.iter().sum::<f64>() / 3.0;
    let spread: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    mean + ((2.0 * spread + longest * longest) / 3.0).sqrt()
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
    use crate::{
        distance::{Navigation, PathEnd},
        domain::Domain,
        picture::Picture,
    };

    #[test]
    fn of_sites_behind_the_same_corners_the_nearest_is_kept() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
        let [before, beside] = [(-30.0, 0.0), (-10.0, 1.0)].map(DVec2::from);
        // The corner `beside` is seen from the corner `before`; sites are at these distances behind it.
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
    #[test]
    fn distances_to_sites_beyond_the_corners_stay_below_their_bound_and_reach_it_midway() {
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.5, 0.75_f64.sqrt())].map(DVec2::from);
        let middle = corners.iter().sum::<DVec2>() / 3.0;
        // The steepest distances: of sites straight beyond the corners. They rise at 1 from each of them towards the others.
        let steps =
            (0..=40).flat_map(|s| (0..=40 - s).map(move |t| [s, t, 40 - s - t].map(|share| f64::from(share) / 40.0)));
        for values in [[0.0; 3], [3.0; 3], [0.0, 0.3, 0.6], [0.0, 0.9, 0.4], [1.0, 0.0, 0.0], [0.0, 1.0, 1.0]] {
            let value = |p: DVec2| (0..3).map(|k| values[k] + corners[k].distance(p)).fold(f64::INFINITY, f64::min);
            let bound = lipschitz_bound(&values, 1.0);
            let greatest =
                steps.clone().map(|shares| value((0..3).map(|k| shares[k] * corners[k]).sum())).fold(0.0, f64::max);
            assert!(greatest <= bound + 1e-12, "{greatest} of {bound} with {values:?}");
        }
        // Rounding of a few operations on numbers around 1.
        assert!((lipschitz_bound(&[3.0; 3], 1.0) - (3.0 + corners[0].distance(middle))).abs() < 1e-12);
    }
}
