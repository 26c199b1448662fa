//! The mesh that is drawn: no triangle of it may turn over, and no vertex may move too far.
//!
//! Between the nodes of the quadrature a triangle can fold unnoticed. So every step looks at all triangles, and the few
//! that are flattened take part in the energy.

use glam::DVec2;

use super::{super::numeric::first_root, energy::FLAT, freedom::Parts};
use crate::weight::SparseWeights;

/// Greatest coordinate of a picture with its surroundings, in pixels.
const MOST: f64 = 131_072.0;

/// The triangles that move, in units of the [model](super::model::Model).
#[derive(Debug, Clone)]
pub(crate) struct Sheet {
    triangles: Vec<[u32; 3]>,
    vertices: Vec<DVec2>,
    /// End of each vertex in `reaches`.
    ends: Vec<u32>,
    reaches: Vec<Reach>,
    /// Twice the area of each triangle at rest, with the sign of its orientation.
    rest: Vec<f64>,
}

/// A site that moves a vertex.
#[derive(Debug, Clone, Copy)]
struct Reach {
    site: u32,
    weight: f64,
    /// Place of the vertex minus that of the site.
    from: DVec2,
}

/// The influence of a site on a triangle.
pub(super) struct TriangleTerm {
    pub(super) site: u32,
    pub(super) weight: f64,
    /// Factors of the site's parts in the Jacobian.
    pub(super) parts: [DVec2; 3],
}

impl Sheet {
    /// Numbers are rounded to f32, as the page has them: so poses have the same bits everywhere. Meshes that lie beyond
    /// any picture keep their places.
    pub(super) fn new(
        vertices: &[DVec2],
        triangles: &[[u32; 3]],
        weights: &SparseWeights,
        sites: &[DVec2],
        unit: f64,
    ) -> Self {
        let is_page = vertices.iter().all(|vertex| vertex.abs().max_element() <= MOST);
        let place = |&vertex: &DVec2| if is_page { vertex.as_vec2().as_dvec2() / unit } else { vertex / unit };
        let vertices: Vec<DVec2> = vertices.iter().map(place).collect();
        let (mut ends, mut reaches) = (Vec::with_capacity(vertices.len()), Vec::new());
        for (at, &vertex) in vertices.iter().enumerate() {
            reaches.extend(weights.row(at).map(|(site, weight)| Reach {
                site: site as u32,
                weight: f64::from(weight as f32),
                from: vertex - sites[site] / unit,
            }));
            ends.push(reaches.len() as u32);
        }
        let mut sheet = Self { triangles: Vec::new(), vertices, ends, reaches, rest: Vec::new() };
        let moves = |&vertex: &u32| (vertex as usize) < sheet.vertices.len() && !sheet.row(vertex).is_empty();
        let moving: Vec<[u32; 3]> = triangles.iter().filter(|triangle| triangle.iter().all(moves)).copied().collect();
        let area = |&triangle: &[u32; 3]| doubled_area(corners(triangle, &sheet.vertices));
        (sheet.rest, sheet.triangles) =
            moving.iter().map(|triangle| (area(triangle), *triangle)).filter(|(area, _)| *area != 0.0).unzip();
        sheet
    }

    /// The sites that move a vertex.
    fn row(&self, vertex: u32) -> &[Reach] {
        let start = if vertex == 0 { 0 } else { self.ends[vertex as usize - 1] };
        &self.reaches[start as usize..self.ends[vertex as usize] as usize]
    }

    /// Pairs of sites that reach the same triangle.
    pub(super) fn pairs(&self, mut visit: impl FnMut(u32, u32)) {
        let mut sites = Vec::new();
        for &triangle in &self.triangles {
            sites.clear();
            for reach in triangle.into_iter().flat_map(|vertex| self.row(vertex)) {
                if !sites.contains(&reach.site) {
                    sites.push(reach.site);
                }
            }
            for (at, &a) in sites.iter().enumerate() {
                sites[..at].iter().for_each(|&b| visit(a, b));
            }
        }
    }

    /// The places of all vertices, or their changes if `parts` are changes.
    pub(super) fn places(&self, parts: &[Parts]) -> Vec<DVec2> {
        let mut start = 0;
        let place = |&end: &u32| {
            let row = &self.reaches[start..end as usize];
            start = end as usize;
            row.iter().fold(DVec2::ZERO, |sum, &Reach { site, weight, from }| {
                let [place, x, y] = parts[site as usize];
                sum + weight * (place + from.x * x + from.y * y)
            })
        };
        self.ends.iter().map(place).collect()
    }

    /// The triangles that are flattened or folded.
    pub(super) fn flattened(&self, places: &[DVec2]) -> Vec<u32> {
        let is_flat = |&t: &u32| {
            let area = doubled_area(corners(self.triangles[t as usize], places)) / self.rest[t as usize];
            area < FLAT || area.is_nan()
        };
        (0..self.triangles.len() as u32).filter(is_flat).collect()
    }

    /// The longest step up to `most` that takes at most a share of the area of each triangle whose area is over `from`
    /// times that at rest.
    pub(super) fn longest(&self, places: &[DVec2], by: &[DVec2], from: f64, taken: f64, mut most: f64) -> f64 {
        for (&triangle, rest) in self.triangles.iter().zip(&self.rest) {
            let ([a, b, c], [da, db, dc]) = (corners(triangle, places), corners(triangle, by));
            let ((u, v), (du, dv)) = ((b - a, c - a), (db - da, dc - da));
            let sign = rest.signum();
            let area = sign * u.perp_dot(v);
            if area > from * rest.abs() {
                let first = sign * (u.perp_dot(dv) + du.perp_dot(v));
                most = first_root(taken * area, first, sign * du.perp_dot(dv), most);
            }
        }
        most
    }

    /// The area of a triangle at rest. `terms` becomes the sites that reach it, with its Jacobian by finite elements.
    pub(super) fn terms(&self, triangle: u32, terms: &mut Vec<TriangleTerm>) -> f64 {
        terms.clear();
        let (triangle, rest) = (self.triangles[triangle as usize], self.rest[triangle as usize]);
        let p = corners(triangle, &self.vertices);
        for (k, vertex) in triangle.into_iter().enumerate() {
            // The gradient of the corner's barycentric coordinate.
            let gradient = (p[(k + 2) % 3] - p[(k + 1) % 3]).perp() / rest;
            for &Reach { site, weight, from } in self.row(vertex) {
                let by = weight * gradient;
                let more = [by, from.x * by, from.y * by];
                match terms.iter_mut().find(|known| known.site == site) {
                    Some(known) => {
                        known.weight += weight / 3.0;
                        (0..3).for_each(|k| known.parts[k] += more[k]);
                    }
                    None => terms.push(TriangleTerm { site, weight: weight / 3.0, parts: more }),
                }
            }
        }
        rest.abs() / 2.0
    }
}

fn corners(triangle: [u32; 3], places: &[DVec2]) -> [DVec2; 3] {
    triangle.map(|vertex| places[vertex as usize])
}

fn doubled_area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - a)
}
