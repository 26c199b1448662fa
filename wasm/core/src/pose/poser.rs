//! Motions of all sites from the handles: what is computed anew in every frame of a drag.

use std::sync::Arc;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::{HarmonicFields, Motion, Pose, rigid::Rigid};
use crate::{
    error::Error,
    project::{Handle, PoseMode, Rotation, Shape},
    site::{Site, SiteGraph},
};

/// Poses a solved scene. It knows the sites and how they depend on one another, no picture and no samples.
///
/// Cost of a pose: microseconds in the harmonic mode, some hundreds of them in the rigid one.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Poser {
    rest: Arc<[DVec2]>,
    /// Handle of each real site.
    handle: Vec<Option<u32>>,
    handles: usize,
    /// ϖ: for each site its real sites and their shares.
    shares: Vec<Vec<(u32, f64)>>,
    /// Pairs of real sites that are neighbours, and how strongly: the edges that turn automatic rotations.
    edges: Vec<(u32, u32, f64)>,
    /// In the rigid mode.
    rigid: Option<Rigid>,
}

impl Poser {
    pub(crate) fn new(
        sites: &[Site],
        graph: &SiteGraph,
        harmonic: &HarmonicFields,
        handles: usize,
        mode: PoseMode,
    ) -> Self {
        let edges = effective_links(sites, graph, harmonic);
        let is_real = sites.iter().map(|site| site.handle.is_some()).collect();
        let rigid = match mode {
            PoseMode::Harmonic => None,
            PoseMode::Rigid => Some(Rigid::new(is_real, graph.iter())),
        };
        Self {
            rest: sites.iter().map(|site| site.rest).collect(),
            handle: sites.iter().map(|site| site.handle.map(|handle| handle as u32)).collect(),
            handles,
            shares: harmonic.rows.clone(),
            edges,
            rigid,
        }
    }

    /// The motions of all sites when the handles are posed as given; their rest places play no part.
    ///
    /// # Errors
    /// [`Error::PoseMismatch`] for another number of handles than was solved; [`Error::PoseNotFinite`].
    pub fn pose(&self, handles: &[Handle]) -> Result<Pose, Error> {
        if handles.len() != self.handles {
            return Err(Error::PoseMismatch { expected: self.handles, found: handles.len() });
        }
        let mut motions = vec![Motion::default(); self.rest.len()];
        for (site, handle) in self.handle.iter().enumerate() {
            let Some(handle) = handle.map(|at| &handles[at as usize]) else { continue };
            let motion = self.motion(site, handle, handles);
            if !motion.is_in_bounds() {
                return Err(Error::PoseNotFinite { id: handle.id.clone() });
            }
            motions[site] = motion;
        }
        for site in (0..motions.len()).filter(|&site| self.handle[site].is_none()) {
            let shares = self.shares[site].iter();
            motions[site] = Motion::blended(shares.map(|&(real, share)| (motions[real as usize], share)));
        }
        if let Some(rigid) = &self.rigid {
            let is_free = |site: &Option<u32>| site.is_none_or(|at| handles[at as usize].rotation == Rotation::Auto);
            let is_free: Vec<bool> = self.handle.iter().map(is_free).collect();
            rigid.settle(&self.rest, &mut motions, &is_free);
        }
        Ok(Pose::new(Arc::clone(&self.rest), motions))
    }

    fn motion(&self, site: usize, handle: &Handle, handles: &[Handle]) -> Motion {
        let angle = match handle.rotation {
            Rotation::Degrees(degrees) => degrees.to_radians(),
            Rotation::Auto => self.turn_of_edges(site, handles),
        };
        let translation = posed_place(handle) - self.rest[site];
        Motion::similarity(angle, handle.scale, translation, handle.depth)
    }

    /// The rotation that best takes the edges to neighbouring handles from rest to pose.
    fn turn_of_edges(&self, site: usize, handles: &[Handle]) -> f64 {
        let posed = |real: usize| {
            let handle = self.handle[real].expect("edges join real sites") as usize;
            posed_place(&handles[handle])
        };
        let (mut cos, mut sin) = (0.0, 0.0);
        for &(i, j, weight) in &self.edges {
            let (i, j) = (i as usize, j as usize);
            let other = if i == site { j } else { i };
            if i != site && j != site {
                continue;
            }
            let (before, after) = (self.rest[other] - self.rest[site], posed(other) - posed(site));
            let weight = weight / before.length_squared();
            cos += weight * before.dot(after);
            sin += weight * before.perp_dot(after);
        }
        libm::atan2(sin, cos)
    }

    /// The poser as bytes, to be made again elsewhere by [`Poser::from_bytes`] of the same version.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        postcard::to_allocvec(self).expect("plain data can be written to memory")
    }

    /// # Errors
    /// [`Error::PoserBytes`] for anything but the result of [`Poser::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let poser: Self = postcard::from_bytes(bytes).map_err(|_| Error::PoserBytes)?;
        let sites = poser.rest.len();
        let real = |site: u32| poser.handle.get(site as usize).is_some_and(Option::is_some);
        let whole = poser.handle.len() == sites
            && poser.shares.len() == sites
            && poser.shares.iter().flatten().all(|&(site, _)| real(site))
            && poser.edges.iter().all(|&(i, j, _)| real(i) && real(j))
            && poser.rigid.as_ref().is_none_or(|rigid| rigid.is_whole(sites))
            && poser.handle.iter().flatten().all(|&handle| (handle as usize) < poser.handles);
        if whole { Ok(poser) } else { Err(Error::PoserBytes) }
    }
}

fn posed_place(handle: &Handle) -> DVec2 {
    match &handle.shape {
        Shape::Point { posed, .. } => *posed,
        Shape::Bar { posed, .. } | Shape::Polygon { posed, .. } => posed[0],
    }
}

/// The cell graph seen from its real sites alone: a link's weight is what flows between two handles, directly and by way of
/// virtual sites (the Schur complement of the Laplacian).
fn effective_links(sites: &[Site], graph: &SiteGraph, harmonic: &HarmonicFields) -> Vec<(u32, u32, f64)> {
    let mut flow = std::collections::BTreeMap::<(u32, u32), f64>::new();
    for (i, j, weight) in graph.iter() {
        for (real, other) in [(i, j), (j, i)] {
            // Links between two real sites count from both ends, as flows by way of virtual sites do.
            if sites[real].handle.is_some() {
                for &(to, share) in harmonic.rows[other].iter().filter(|&&(to, _)| to as usize != real) {
                    let pair = ((real as u32).min(to), (real as u32).max(to));
                    *flow.entry(pair).or_default() += weight * share;
                }
            }
        }
    }
    flow.into_iter().map(|((i, j), weight)| (i, j, weight)).collect()
}
