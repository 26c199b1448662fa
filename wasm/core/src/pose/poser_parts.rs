//! The parts of a poser, for the file of a rig.

use glam::DVec2;

use super::{Poser, RigidParts, SolvedHandle, automatic::Automatic, poser::freedom, rigid::Rigid};
use crate::{
    bone::Skeleton,
    project::{Handle, ShapeKind},
    site::SiteKind,
};

/// The parts of a poser besides handles and bones.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PoserParts {
    /// Positions and kinds of the sites.
    pub(crate) rest: Vec<DVec2>,
    pub(crate) kinds: Vec<SiteKind>,
    /// ϖ: for each virtual site, real sites and their weights. Sites that do not move may be missing.
    pub(crate) harmonic: Vec<Vec<(u32, f64)>>,
    /// Pairs of real sites with weights, for automatic rotations.
    pub(crate) pseudo_edges: Vec<(u32, u32, f64)>,
    /// Pairs of handles.
    pub(crate) adjacent: Vec<[u32; 2]>,
    /// `None` in the harmonic mode.
    pub(crate) rigid: Option<RigidParts>,
}

impl Poser {
    /// `None` for the rigid mode without a picture between the sites.
    pub(crate) fn parts(&self) -> Option<PoserParts> {
        let rigid = match &self.rigid {
            Some(rigid) => Some(rigid.parts()?),
            None => None,
        };
        let Automatic { edges, adjacent } = &self.automatic;
        let of_virtual = self.harmonic.iter().zip(&self.kinds).filter(|(_, kind)| !kind.is_real());
        Some(PoserParts {
            rest: self.rest.to_vec(),
            kinds: self.kinds.clone(),
            harmonic: of_virtual.map(|(row, _)| row.clone()).collect(),
            pseudo_edges: edges.clone(),
            adjacent: adjacent.clone(),
            rigid,
        })
    }

    /// A poser without a picture, which computes motions. `None` if the parts are not consistent.
    pub(crate) fn from_parts(parts: &PoserParts, skeleton: &Skeleton, handles: &[Handle]) -> Option<Self> {
        let mut rows = parts.harmonic.iter();
        let row = |(site, kind): (u32, &SiteKind)| match kind.is_real() {
            true => Some(vec![(site, 1.0)]),
            false => rows.next().cloned(),
        };
        let harmonic = (0..).zip(&parts.kinds).map(row).collect::<Option<Vec<_>>>()?;
        let has_bone = |kind: &SiteKind| match *kind {
            SiteKind::Bone { bone, .. } => (bone as usize) < skeleton.bones.len(),
            _ => true,
        };
        if !parts.kinds.iter().all(has_bone) {
            return None;
        }
        let freedom = parts.kinds.iter().map(|&kind| freedom(kind, skeleton)).collect();
        let solved = |handle: &Handle| {
            let [shape, _] = ShapeKind::of(&handle.shape);
            SolvedHandle { id: handle.id.clone(), shape }
        };
        let poser = Self {
            rest: parts.rest.clone().into(),
            kinds: parts.kinds.clone(),
            skeleton: skeleton.clone(),
            solved: handles.iter().map(solved).collect(),
            harmonic,
            automatic: Automatic { edges: parts.pseudo_edges.clone(), adjacent: parts.adjacent.clone() },
            rigid: parts.rigid.as_ref().map(|parts| Rigid::from_parts(freedom, parts)),
            picture: DVec2::ZERO,
            displacement: None,
        };
        poser.is_whole().then_some(poser)
    }
}
