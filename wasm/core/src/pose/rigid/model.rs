//! The picture as an elastic sheet: its energy as a function of the motions of all sites, and Newton's equations.
//!
//! The energy is the symmetric Dirichlet energy of the blended map (eq. 1) at the nodes of the quadrature. Where nodes
//! do not decide, motions of linked sites are kept alike: a small quadratic energy says how far two linked sites are
//! from having one affine map.
//!
//! Lengths are in units of the mean cell's width, so that places and linear parts are numbers of one size.

use std::{collections::BTreeSet, sync::Arc};

use glam::{DMat2, DVec2};

use super::{
    super::numeric::{Blocks, Pattern},
    freedom::{Freedom, Parts, Request},
    points::{Layout, Points},
    quadrature::Node,
    sheet::Sheet,
};
use crate::weight::Influence;

/// Strength of the energy of links and sites, beside that of the picture between them, if it is known.
const STRENGTH: f64 = 1e-3;
/// Least area of a site for damping, as a fraction of the mean cell.
const LEAST: f64 = 0.2;

/// Two sites with touching cells.
#[derive(Debug, Clone)]
struct Link {
    sites: [u32; 2],
    weight: f64,
    by: DVec2,
}

/// The corners of the box around all sites.
pub(super) fn bounds(rest: &[DVec2]) -> [DVec2; 2] {
    let first = rest.first().copied().unwrap_or_default();
    rest.iter().fold([first; 2], |[low, high], &at| [low.min(at), high.max(at)])
}

/// What does not change with a pose.
#[derive(Debug, Clone)]
pub(super) struct Model {
    freedom: Vec<Freedom>,
    /// The group of each site's unknowns.
    group: Vec<Option<u32>>,
    rest: Vec<DVec2>,
    /// Unit of length in pixels.
    unit: f64,
    pattern: Pattern,
    nodes: Points,
    /// The mesh that is drawn, if it is known.
    sheet: Option<Arc<Sheet>>,
    links: Vec<Link>,
    /// The second derivatives of the energy between linked sites.
    of_links: Blocks,
    /// The area around each site, in units.
    around: Vec<f64>,
    /// Strength of the energy of links.
    strength: f64,
}

/// What a model consists of. Lengths are in pixels.
pub(super) struct Scene<'a> {
    pub(super) rest: &'a [DVec2],
    pub(super) freedom: &'a [Freedom],
    /// Pairs of sites, with weights.
    pub(super) links: &'a [(u32, u32, f64)],
    /// Nodes of the picture between the sites. A point cloud has none.
    pub(super) nodes: Vec<Node>,
    /// The factor of stiffness at each node.
    pub(super) stiffness: Vec<f64>,
    pub(super) sheet: Option<Arc<Sheet>>,
    pub(super) unit: f64,
}

impl Model {
    pub(super) fn new(scene: Scene<'_>) -> Self {
        let Scene { freedom, nodes: all, stiffness, sheet, unit, .. } = scene;
        // Rounded weights do not sum to exactly 1. Coordinates relative to the picture's centre keep the error small.
        let [low, high] = bounds(scene.rest);
        let middle = low.midpoint(high);
        let rest: Vec<DVec2> = scene.rest.iter().map(|&rest| (rest - middle) / unit).collect();
        let mut widths = Vec::new();
        let mut group_of = |freedom: &Freedom| {
            let count = freedom.factors().count();
            (count > 0).then(|| {
                widths.push(2 * count);
                widths.len() as u32 - 1
            })
        };
        let group: Vec<Option<u32>> = freedom.iter().map(&mut group_of).collect();
        let link =
            |&(i, j, weight): &(u32, u32, f64)| Link { sites: [i, j], weight, by: rest[j as usize] - rest[i as usize] };
        let links: Vec<Link> = scene.links.iter().map(link).collect();
        let mut pairs: BTreeSet<(u32, u32)> = BTreeSet::new();
        let mut add_pair = |a: u32, b: u32| {
            if let (Some(a), Some(b)) = (group[a as usize], group[b as usize]) {
                pairs.insert((a.min(b), a.max(b)));
            }
        };
        for node in &all {
            for (at, one) in node.influences.iter().enumerate() {
                node.influences[..at].iter().for_each(|other| add_pair(one.site as u32, other.site as u32));
            }
        }
        links.iter().for_each(|link| add_pair(link.sites[0], link.sites[1]));
        if let Some(sheet) = &sheet {
            sheet.pairs(add_pair);
        }
        let pattern = Pattern::new(&widths, pairs.into_iter());
        let mut around = vec![LEAST; rest.len()];
        let mut nodes = Points::default();
        let layout = Layout { freedom, group: &group, pattern: &pattern };
        for (node, factor) in all.iter().zip(stiffness) {
            let term = |one: &Influence| {
                let (weight, gradient, from) =
                    (one.weight, unit * one.gradient, (node.at - middle) / unit - rest[one.site]);
                let place = [weight, weight * from.x, weight * from.y];
                let of_x = from.x * gradient + DVec2::new(weight, 0.0);
                let of_y = from.y * gradient + DVec2::new(0.0, weight);
                (one.site as u32, place, [gradient, of_x, of_y])
            };
            node.influences.iter().for_each(|one| around[one.site] += one.weight * node.area / (unit * unit));
            nodes.add(&layout, factor * node.area / (unit * unit), node.influences.iter().map(term));
        }
        // A motion has no form for a site that is turned over.
        let strength = if all.is_empty() { 1.0 } else { STRENGTH };
        for (site, &around) in around.iter().enumerate().filter(|&(site, _)| group[site].is_some()) {
            let own = (site as u32, [1.0, 0.0, 0.0], [DVec2::ZERO, DVec2::X, DVec2::Y]);
            nodes.add(&layout, strength * around, std::iter::once(own));
        }
        let mut of_links = pattern.zeros();
        add_links(&links, strength, &Layout { freedom, group: &group, pattern: &pattern }, of_links.values_mut());
        Self { freedom: freedom.to_vec(), group, rest, unit, pattern, nodes, sheet, links, of_links, around, strength }
    }

    /// The mesh that is drawn, if it is known.
    pub(super) fn sheet(&self) -> Option<&Sheet> {
        self.sheet.as_deref()
    }

    /// The nodes.
    pub(super) fn nodes(&self) -> &Points {
        &self.nodes
    }

    /// Sets the points to triangles of the mesh.
    pub(super) fn points_of(&self, triangles: &[u32], points: &mut Points) {
        points.clear();
        let Some(sheet) = &self.sheet else { return };
        let layout = Layout { freedom: &self.freedom, group: &self.group, pattern: &self.pattern };
        let mut terms = Vec::new();
        for &triangle in triangles {
            let area = sheet.terms(triangle, &mut terms);
            points.add(&layout, area, terms.iter().map(|term| (term.site, [term.weight, 0.0, 0.0], term.parts)));
        }
    }

    /// Unit of length in pixels.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    /// Rest place of each site, from the middle of the picture, in units.
    pub(super) fn rest(&self) -> &[DVec2] {
        &self.rest
    }

    pub(super) fn freedom(&self) -> &[Freedom] {
        &self.freedom
    }

    pub(super) fn zeros(&self) -> Blocks {
        self.pattern.zeros()
    }

    /// The positions of all vertices, or of all nodes without a mesh. Changes of parts give changes of positions.
    pub(super) fn places(&self, parts: &[Parts]) -> Vec<DVec2> {
        self.sheet.as_ref().map_or_else(|| self.nodes.places(parts), |sheet| sheet.places(parts))
    }

    /// The energy between linked sites.
    pub(super) fn link_energy(&self, parts: &[Parts]) -> f64 {
        let of_links: f64 = self.links.iter().map(|link| link.weight * link.energy(parts)).sum();
        self.strength / 2.0 * of_links
    }

    /// The unknowns of a site as factors in its parts, unless they are set.
    fn factors(&self, site: usize, request: &Request<'_>) -> impl Iterator<Item = [f64; 3]> + use<> {
        let freedom = self.freedom[site];
        let is_set = freedom == Freedom::Linear && !request.is_free[site];
        freedom.factors().take(if is_set { 0 } else { 3 })
    }

    pub(super) fn add_link_forces(&self, parts: &[Parts], request: &Request<'_>, forces: &mut [f64]) {
        for link in &self.links {
            for (factors, residual) in link.residuals(parts) {
                for (&site, of_parts) in link.sites.iter().zip(factors) {
                    let Some(group) = self.group[site as usize] else { continue };
                    let first = self.pattern.first(group as usize);
                    for (k, unknown) in self.factors(site as usize, request).enumerate() {
                        let factor: f64 = (0..3).map(|p| unknown[p] * of_parts[p]).sum();
                        let force = -self.strength * link.weight * factor * residual;
                        forces[first + 2 * k] += force.x;
                        forces[first + 2 * k + 1] += force.y;
                    }
                }
            }
        }
    }

    /// Sets the matrix to the second derivatives of the energy between linked sites.
    pub(super) fn begin(&self, matrix: &mut Blocks) {
        matrix.clone_from(&self.of_links);
    }

    /// Decouples the unknowns that are set.
    pub(super) fn finish(&self, matrix: &mut Blocks, request: &Request<'_>) {
        let is_set = |site: usize| self.freedom[site] == Freedom::Linear && !request.is_free[site];
        for group in (0..self.group.len()).filter(|&site| is_set(site)).filter_map(|site| self.group[site]) {
            matrix.set_apart(&self.pattern, group);
        }
    }

    pub(super) fn unknowns(&self) -> usize {
        self.pattern.unknowns()
    }

    /// Adds `damping`, as a fraction of the energy of the picture around each site, and factorises.
    pub(super) fn factorise(&self, matrix: &mut Blocks, damping: f64) -> bool {
        let mut by_unknown = vec![0.0; self.pattern.unknowns()];
        for (site, group) in self.group.iter().enumerate() {
            if let Some(group) = group {
                let first = self.pattern.first(*group as usize);
                let width = 2 * self.freedom[site].factors().count();
                by_unknown[first..first + width].fill(damping * self.around[site]);
            }
        }
        matrix.add_diagonal(&self.pattern, |unknown| by_unknown[unknown]);
        matrix.factorise(&self.pattern)
    }

    /// The forces times a direction of the unknowns.
    pub(super) fn along(&self, direction: &[Parts], forces: &[f64], request: &Request<'_>) -> f64 {
        let mut sum = 0.0;
        for (site, group) in self.group.iter().enumerate() {
            let Some(group) = group else { continue };
            let first = self.pattern.first(*group as usize);
            let [_, x, y] = direction[site];
            let unknowns = match self.freedom[site] {
                Freedom::Whole => direction[site],
                Freedom::Linear => [x, y, DVec2::ZERO],
                Freedom::Across(along) => [along.x * y - along.y * x, DVec2::ZERO, DVec2::ZERO],
                Freedom::None => continue,
            };
            for (k, _) in self.factors(site, request).enumerate() {
                sum += unknowns[k].dot(DVec2::new(forces[first + 2 * k], forces[first + 2 * k + 1]));
            }
        }
        sum
    }

    /// The change of all parts by the unknowns that solve the equations, besides those that are driven.
    pub(super) fn solve(
        &self,
        factor: &Blocks,
        forces: &[f64],
        driven: Option<&[Parts]>,
        request: &Request<'_>,
    ) -> Vec<Parts> {
        let mut forces = forces.to_vec();
        factor.solve(&self.pattern, &mut forces);
        let mut parts = driven.map_or_else(|| vec![[DVec2::ZERO; 3]; self.rest.len()], <[Parts]>::to_vec);
        for (site, group) in self.group.iter().enumerate() {
            let Some(group) = group else { continue };
            let first = self.pattern.first(*group as usize);
            for (k, factors) in self.factors(site, request).enumerate() {
                let by = DVec2::new(forces[first + 2 * k], forces[first + 2 * k + 1]);
                (0..3).for_each(|p| parts[site][p] += factors[p] * by);
            }
        }
        parts
    }
}

/// Adds the second derivatives of the energy between linked sites.
fn add_links(links: &[Link], strength: f64, layout: &Layout<'_>, values: &mut [f64]) {
    let Layout { freedom, group, pattern } = *layout;
    for link in links {
        let sites = link.sites.map(|site| site as usize);
        for factors in link.factors() {
            for (a, b) in [(0, 0), (1, 0), (1, 1)] {
                let (Some(group_a), Some(group_b)) = (group[sites[a]], group[sites[b]]) else { continue };
                let slot = pattern.slot(group_a, group_b);
                for (k, of_a) in freedom[sites[a]].factors().enumerate() {
                    for (l, of_b) in freedom[sites[b]].factors().enumerate() {
                        let left: f64 = (0..3).map(|p| of_a[p] * factors[a][p]).sum();
                        let right: f64 = (0..3).map(|p| of_b[p] * factors[b][p]).sum();
                        let block = DMat2::from_diagonal(DVec2::splat(strength * link.weight * left * right));
                        slot.add(values, [k, l], block);
                    }
                }
            }
        }
    }
}

impl Link {
    /// The residuals as factors of the parts of both sites: where each map takes the other site, and the difference of
    /// the linear parts over the length of the link.
    fn factors(&self) -> [[[f64; 3]; 2]; 4] {
        let (by, length) = (self.by, self.by.length());
        [
            [[1.0, by.x, by.y], [-1.0, 0.0, 0.0]],
            [[-1.0, 0.0, 0.0], [1.0, -by.x, -by.y]],
            [[0.0, length, 0.0], [0.0, -length, 0.0]],
            [[0.0, 0.0, length], [0.0, 0.0, -length]],
        ]
    }

    fn residuals(&self, parts: &[Parts]) -> impl Iterator<Item = ([[f64; 3]; 2], DVec2)> {
        let ends = self.sites.map(|site| parts[site as usize]);
        self.factors().into_iter().map(move |factors| {
            let of_end = |end: usize| (0..3).map(|p| factors[end][p] * ends[end][p]).sum::<DVec2>();
            (factors, of_end(0) + of_end(1))
        })
    }

    fn energy(&self, parts: &[Parts]) -> f64 {
        self.residuals(parts).map(|(_, residual)| residual.length_squared()).sum()
    }
}
