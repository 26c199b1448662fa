//! The rigid pose mode: virtual sites move so that the picture distorts as little as possible.
//!
//! First the cell graph [bends](bending) as rigidly as possible, using only the sites. From there, the picture itself
//! is [relaxed](relaxation): its [distortion] is measured at the nodes of a [quadrature], first coarse and then fine,
//! and minimised over everything that the handles leave free. So the user need not set rotations, the picture bends
//! like a limb, and it seldom folds. A point cloud has no picture between its sites, so it keeps the result of the
//! graph.
//!
//! Every pose starts from the harmonic pose, so it depends only on the handles, not on the drag. Two iterations from
//! the last frame's pose would take six tenths of the time, but depend on the drag. A twisted cross would end six
//! pixels away, and a spiral that is unrolled in 60 frames would keep windings, at 400 times the energy. Only clips
//! continue poses, and only where poses jump: see [`Playback`](crate::clip::Playback).
//!
//! Cost: one to four milliseconds for a pose of 150 virtual sites.
//!
//! Limits: both energies have several local minima, and the descent from the harmonic pose leads to one of them. If two
//! of them are equally near, a drag jumps from one to the other. If handles are moved past one another, the descent
//! ends earlier, with folds. Between nodes, close to handles, single triangles may fold; a denser mesh of sites would
//! prevent that. The quadrature depends on the samples. So poses differ by some thousandths of the picture's size with
//! the number of samples, and by up to two hundredths if the picture is rotated.

mod bending;
mod distortion;
mod jacobians;
mod quadrature;
mod relaxation;
mod stiffness;

use std::sync::OnceLock;

use glam::DVec2;

use self::{
    bending::bend,
    relaxation::{Relaxation, areas_around},
};
use super::{Motion, numeric::Laplacian};

pub(crate) use self::{
    quadrature::{Node, Quadrature},
    relaxation::Freedom,
    stiffness::{StiffnessField, StiffnessMask},
};

/// The descent of the graph ends with an iteration that moves no site by more than this fraction of the scene's extent:
/// a tenth of a pixel. With a pixel, the relaxation would be hardly worse, but would jump whenever a drag changes the
/// number of iterations.
const BENDING_TOLERANCE: f64 = 1e-4;
/// The same if no relaxation follows: a ten-thousandth of a pixel.
const GRAPH_TOLERANCE: f64 = 1e-7;
/// The same for the relaxation: a hundredth of a pixel.
const RELAXATION_TOLERANCE: f64 = 1e-5;

/// The links between sites, and the picture between them.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Rigid {
    links: Vec<(u32, u32, f64)>,
    freedom: Vec<Freedom>,
    quadrature: Option<Quadrature>,
    stiffness: StiffnessField,
    /// Computed for the first pose: several times the size of the links, and as quick to compute as to read.
    #[cfg_attr(feature = "poser-bytes", serde(skip))]
    laplacian: OnceLock<Laplacian>,
    /// Likewise.
    #[cfg_attr(feature = "poser-bytes", serde(skip))]
    relaxation: OnceLock<Relaxation>,
    /// Likewise, if parts of the picture are stiff.
    #[cfg_attr(feature = "poser-bytes", serde(skip))]
    stiff_links: OnceLock<Vec<(u32, u32, f64)>>,
}

/// The parts of the rigid mode besides the sites.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RigidParts {
    /// Pairs of sites, the lesser first, with their weights.
    pub(crate) links: Vec<(u32, u32, f64)>,
    /// Nodes of the coarse level alone, of both levels, and of the fine level alone.
    pub(crate) nodes: [Vec<Node>; 3],
    pub(crate) stiffness: StiffnessField,
}

impl Rigid {
    pub(super) fn new(
        freedom: Vec<Freedom>,
        links: impl Iterator<Item = (usize, usize, f64)>,
        quadrature: Option<Quadrature>,
        stiffness: StiffnessField,
    ) -> Self {
        let links = links.map(|(i, j, weight)| (i as u32, j as u32, weight)).collect();
        Self {
            links,
            freedom,
            quadrature,
            stiffness,
            stiff_links: OnceLock::new(),
            laplacian: OnceLock::new(),
            relaxation: OnceLock::new(),
        }
    }

    /// `None` without a picture between the sites.
    pub(super) fn parts(&self) -> Option<RigidParts> {
        let nodes = self.quadrature.as_ref()?.nodes();
        Some(RigidParts { links: self.links.clone(), nodes, stiffness: self.stiffness.clone() })
    }

    pub(super) fn from_parts(freedom: Vec<Freedom>, parts: &RigidParts) -> Self {
        let links = parts.links.iter().map(|&(i, j, weight)| (i as usize, j as usize, weight));
        Self::new(freedom, links, Some(Quadrature::from_nodes(&parts.nodes)), parts.stiffness.clone())
    }

    /// Whether data read from bytes is consistent for this number of sites.
    pub(super) fn is_whole(&self, sites: usize) -> bool {
        let known = |&(i, j, weight): &(u32, u32, f64)| i < j && (j as usize) < sites && (0.0..=1.0).contains(&weight);
        self.freedom.len() == sites
            && self.links.iter().all(known)
            && self.quadrature.as_ref().is_none_or(|quadrature| quadrature.is_whole(sites))
            && self.stiffness.is_whole()
    }

    /// Changes the stiffness of the picture. Results of the first pose are recomputed.
    pub(super) fn set_stiffness(&mut self, stiffness: StiffnessField) {
        self.stiffness = stiffness;
        self.stiff_links = OnceLock::new();
        (self.laplacian, self.relaxation) = (OnceLock::new(), OnceLock::new());
    }

    /// The links, with their weights.
    pub(super) fn links(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone {
        self.links.iter().map(|&(i, j, weight)| (i as usize, j as usize, weight))
    }

    /// Replaces harmonic motions by rigid ones. `is_free` states for each site whether its rotation is free. `scales`
    /// are the requested scales at the sites.
    pub(super) fn minimize(&self, rest: &[DVec2], motions: &mut [Motion], is_free: &[bool], scales: &[f64]) {
        if rest.is_empty() {
            return;
        }
        let extent = extent(rest);
        let relaxation = self.relaxation(rest);
        let tolerance = if relaxation.is_some() { BENDING_TOLERANCE } else { GRAPH_TOLERANCE };
        self.bend(rest, motions, is_free, scales, tolerance * extent);
        if let Some(relaxation) = relaxation {
            relaxation.minimize(motions, is_free, scales, RELAXATION_TOLERANCE * extent);
        }
    }

    /// Lowers the distortion of motions, taken from a pose with nearby handles, to the nearest minimum.
    ///
    /// The graph does not bend again: its minima differ from those of the picture, and jump where these do not.
    pub(super) fn minimize_nearby(&self, rest: &[DVec2], motions: &mut [Motion], is_free: &[bool], scales: &[f64]) {
        if rest.is_empty() {
            return;
        }
        let extent = extent(rest);
        match self.relaxation(rest) {
            Some(relaxation) => relaxation.minimize_nearby(motions, is_free, scales, RELAXATION_TOLERANCE * extent),
            None => self.bend(rest, motions, is_free, scales, GRAPH_TOLERANCE * extent),
        }
    }

    /// Refines motions that [`minimize`](Self::minimize) or [`minimize_nearby`](Self::minimize_nearby) found.
    pub(super) fn refine(&self, rest: &[DVec2], motions: &mut [Motion], is_free: &[bool], scales: &[f64]) {
        if let Some(relaxation) = self.relaxation(rest).filter(|_| !rest.is_empty()) {
            relaxation.refine(motions, is_free, scales, RELAXATION_TOLERANCE * extent(rest));
        }
    }

    fn relaxation(&self, rest: &[DVec2]) -> Option<&Relaxation> {
        let quadrature = self.quadrature.as_ref()?;
        Some(self.relaxation.get_or_init(|| Relaxation::new(quadrature, &self.stiffness, rest, &self.freedom)))
    }

    /// The links of the graph. Stiff parts of the picture increase their weight: by the geometric mean of two factors,
    /// each the mean over the picture that a site moves.
    fn stiff_links(&self) -> &[(u32, u32, f64)] {
        let Some(quadrature) = self.quadrature.as_ref().filter(|_| !self.stiffness.is_soft()) else {
            return &self.links;
        };
        self.stiff_links.get_or_init(|| {
            let sites = self.freedom.len();
            let mut nodes: Vec<_> = quadrature.coarse().collect();
            let around = areas_around(&nodes, sites);
            let factors = self.stiffness.factors(&nodes);
            nodes.iter_mut().zip(factors).for_each(|(node, factor)| node.area *= factor);
            let stiff = areas_around(&nodes, sites);
            let factor = |site: usize| if around[site] > 0.0 { stiff[site] / around[site] } else { 1.0 };
            let stiff_link =
                |&(i, j, weight): &(u32, u32, f64)| (i, j, weight * (factor(i as usize) * factor(j as usize)).sqrt());
            self.links.iter().map(stiff_link).collect()
        })
    }

    fn bend(&self, rest: &[DVec2], motions: &mut [Motion], is_free: &[bool], scales: &[f64], tolerance: f64) {
        let is_real = || self.freedom.iter().map(|freedom| *freedom != Freedom::Whole).collect::<Vec<_>>();
        let links = || self.stiff_links().iter().map(|&(i, j, weight)| (i as usize, j as usize, weight));
        let laplacian = self.laplacian.get_or_init(|| Laplacian::new(&is_real(), links()));
        bend(laplacian, links(), rest, motions, is_free, scales, tolerance);
    }
}

/// The distance between corners of the box around all sites.
pub(super) fn extent(rest: &[DVec2]) -> f64 {
    let box_of = rest.iter().fold(None, |bounds: Option<(DVec2, DVec2)>, &h| {
        Some(bounds.map_or((h, h), |(low, high)| (low.min(h), high.max(h))))
    });
    box_of.map_or(0.0, |(low, high)| (high - low).length())
}
