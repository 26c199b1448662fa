//! Local maxima of the distance in a site's cell, within one flat piece.
//!
//! Cost: one ascent, or four if a cell may have several maxima in the piece.

use glam::DVec2;

use super::{
    super::{TIE, voronoi::Voronoi},
    FarPoint,
    ascent::{Cone, Cones, ascend},
    bounds::cone_sag,
    piece::Piece,
};
use crate::distance::NavTriangle;

/// Local maxima in a flat piece: the greatest, and others if they may be as far as `known`. Empty if no ascent
/// converges. Adds the number of visited cones to `steps`.
pub(super) fn maxima(voronoi: &Voronoi, piece: &Piece, site: usize, known: f64, steps: &mut u64) -> Vec<FarPoint> {
    let mut ascend_from = |from: DVec2| {
        let limit = piece.upper_bound + piece.longest;
        let maxima = ascend(&piece.corners, from, |p, cones| {
            list_cones(voronoi, piece, site, (p, limit), cones);
            // Each cone is compared with all before it, and each own cone with all others.
            let (own, all) = (cones.own.len(), cones.own.len() + cones.others.len());
            *steps += (piece.sites.len() + all * all / 16 + own * all) as u64;
        });
        maxima.into_iter().filter_map(|p| point_of_cell(voronoi, piece, site, p))
    };
    let mut maxima: Vec<FarPoint> = ascend_from(piece.corners.iter().sum::<DVec2>() / 3.0).collect();
    let Some(maximum) = maxima.first() else { return maxima };
    // Three cones meet once. With more, a narrow cell may have another maximum beside the first, farther by no more
    // than the sag.
    if piece.limits > 3 && maximum.distance + cone_sag(piece.longest, maximum.distance) >= known {
        for from in piece.corners {
            maxima.extend(ascend_from(from));
        }
    }
    maxima
}

/// Lists the cones at a point that are no higher than `limit`.
fn list_cones(voronoi: &Voronoi, piece: &Piece, site: usize, (p, limit): (DVec2, f64), cones: &mut Cones) {
    let Some(triangle) = triangle_at(voronoi, piece, p) else { return };
    for &at in &piece.sites {
        let field = &voronoi.fields[at as usize].distances;
        let list = if at == site as u32 { &mut cones.own } else { &mut cones.others };
        let first = list.len();
        for path in field.path_ends(triangle, p).filter(|path| path.distance <= limit) {
            let cone = Cone { apex: path.pseudo_source, offset: path.offset };
            // Cones of two sites coincide only behind a common corner of the outline.
            let alike = if cone.offset > 0.0 { &list[..] } else { &list[first..] };
            if !alike.contains(&cone) {
                list.push(cone);
            }
        }
    }
}

/// The triangle of the navigation mesh that contains a point of the piece.
fn triangle_at(voronoi: &Voronoi, piece: &Piece, p: DVec2) -> Option<NavTriangle> {
    let [a, b, c] = piece.nav_triangles;
    if a == b && b == c { Some(a) } else { voronoi.navigation.triangle_at(p) }
}

/// A point of the piece with its distance, if it lies in the site's cell.
fn point_of_cell(voronoi: &Voronoi, piece: &Piece, site: usize, p: DVec2) -> Option<FarPoint> {
    let triangle = triangle_at(voronoi, piece, p)?;
    let distance = |at: usize| voronoi.distance(at, triangle, p);
    let least = piece.sites.iter().map(|&at| distance(at as usize)).fold(f64::INFINITY, f64::min);
    let is_in_cell = distance(site) <= least * (1.0 + TIE);
    (is_in_cell && least.is_finite()).then_some(FarPoint { at: p, triangle, distance: least })
}
